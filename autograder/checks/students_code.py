"""Tell the student's code from ours, and find out which of the two made the current call.

At home, the autograder blocks some imports and operations for the student's code only.
"""

from __future__ import annotations

import sys
import sysconfig
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from autograder.checks.faults import is_inside, short
from autograder.manifest import Chapter

LIBRARY = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
# The library may also be in a zip file beside that folder, as it is in a browser.
LIBRARY.append(LIBRARY[0].with_name(f"python{''.join(map(str, sys.version_info[:2]))}.zip"))
PACKAGES = ("site-packages", "dist-packages")  # these may be inside the library's folder


def graded_files(chapters: Iterable[Chapter]) -> dict[str, list[str]]:
    """List for each chapter's folder the files that will also exist in the grader.

    These are the files that students hand in, plus the ones that we supply.
    """
    return {chapter.name: [*chapter.handed_in, *chapter.complete] for chapter in chapters}


class StudentsCode:
    """Recognizes whether the code in a file is the student's, by the folder that the file is in.

    ``graded`` maps each chapter's folder to the files that the grader has too. A chapter that is
    not in ``graded`` has no such restriction. ``ours`` lists files in these folders that the
    student did not write, such as ch06_springs/cloth.py.
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
        """Treat the code in other folders as the student's from now on.

        The restrictions on imports and operations stay in force. In a browser, one process runs the
        checks again and again, and there the restrictions can be set up only once.
        """
        self.folders = [folder.resolve() for folder in folders]
        self.graded = graded
        self.ours = ours
        self._known: dict[str, bool | None] = {}

    def is_calling(self) -> bool:
        """Return whether the student's code made the current call, such as a call of open.

        The caller is the first function on the stack that is not part of Python's library. Python's
        own steps during an import do not count as calls by the student.
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
        """Return whether the student wrote a file, or None if it is part of Python's library."""
        if file.startswith("<"):  # such as <string>, from exec, and <frozen os>
            return False if file.startswith("<frozen importlib") else None
        if is_inside(file, self.folders):
            return short(file) not in self.ours
        library = is_inside(file, LIBRARY) and not any(name in file for name in PACKAGES)
        return None if library else False

    def is_graded(self, package: str, file: str) -> bool:
        """Return whether a file in the folder of a chapter will also exist in the grader.

        ``package`` is the name of the folder, such as ch02_vectors. Probes always exist in the
        grader, because they belong to our checks.
        """
        return (
            package not in self.graded or file in self.graded[package] or file.endswith("probes.py")
        )
