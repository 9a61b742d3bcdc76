"""Find out whether a call comes from the student's code or from ours.

On a student's machine, some imports and operations are blocked for the student's code but allowed
for ours. To tell them apart, this module inspects the functions on the stack.
"""

from __future__ import annotations

import sys
import sysconfig
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from autograder.diagnosis.faults import is_inside, short
from autograder.manifest import Chapter

LIBRARY = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
# The library may also be in a zip file beside that folder, as it is in a browser.
LIBRARY.append(LIBRARY[0].with_name(f"python{''.join(map(str, sys.version_info[:2]))}.zip"))
# These folders may be inside the library's folder, but they hold other packages.
PACKAGES = [folder / name for folder in LIBRARY for name in ("site-packages", "dist-packages")]


def graded_files(chapters: Iterable[Chapter]) -> dict[str, list[str]]:
    """List the files of each chapter that will also be available in the grader.

    These are the files that students hand in and the ones that we supply.
    """
    return {chapter.name: [*chapter.handed_in, *chapter.complete] for chapter in chapters}


class StudentsCode:
    """Recognizes a student's code by the folder that contains it.

    ``graded`` maps each chapter's folder to the files in it that the grader will have too. If a
    folder is not in ``graded``, the grader will have all of its files. ``ours`` lists the files in
    ``folders`` that the student did not write, such as ch06_springs/cloth.py.
    """

    def __init__(
        self,
        folders: Iterable[Path],
        graded: Mapping[str, Collection[str]],
        ours: Collection[str] = (),
    ) -> None:
        self.change(folders, graded, ours)

    def change(
        self,
        folders: Iterable[Path],
        graded: Mapping[str, Collection[str]],
        ours: Collection[str] = (),
    ) -> None:
        """Change which folders contain the student's code.

        In the browser, one process runs the checks many times, but the restrictions on imports and
        operations can be set up only once. This method adapts them to the folders of the next run.
        """
        self.folders = [folder.resolve() for folder in folders]
        self.graded = graded
        self.ours = ours
        self._known: dict[str, bool | None] = {}

    def is_calling(self) -> bool:
        """Return True if the student's code started the current import or operation.

        This is decided by the innermost function on the stack that is not part of Python's library.
        Operations that Python itself performs during an import are never attributed to the student.
        """
        frame = sys._getframe(2)
        while frame is not None:
            file = frame.f_code.co_filename
            if file not in self._known:
                self._known[file] = self._is_students(file)
            if (answer := self._known[file]) is not None:
                return answer
            frame = frame.f_back  # type: ignore[assignment]
        return False

    def _is_students(self, file: str) -> bool | None:
        """Return True if the student wrote the code in a file, and False if someone else did.

        Return None for Python's library and for code run by exec, because the student's code may
        have called either of them. In that case, ``is_calling`` checks the caller instead.
        """
        if file.startswith("<"):  # such as <string>, from exec, and <frozen os>
            return False if file.startswith("<frozen importlib") else None
        if is_inside(file, self.folders):
            return short(file) not in self.ours
        library = is_inside(file, LIBRARY) and not is_inside(file, PACKAGES)
        return None if library else False

    def is_graded(self, package: str, file: str) -> bool:
        """Return True if a file in a chapter's folder will also be available in the grader.

        ``package`` is the name of the folder, such as ch02_vectors. Files that end in probes.py
        always count as graded, because they belong to our checks.
        """
        return (
            package not in self.graded or file in self.graded[package] or file.endswith("probes.py")
        )
