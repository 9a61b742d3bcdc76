"""Tell the student's code from ours, and find out which of the two made the current call."""

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
    """For each chapter's folder, list the files that will also exist in the grader.

    These are the files that students hand in, plus the ones that we supply.
    """
    return {chapter.name: [*chapter.handed_in, *chapter.complete] for chapter in chapters}


class StudentsCode:
    """Recognizes whether a file is the student's by the folder that it is in.

    ``graded`` maps each chapter's folder to the files that the grader has too. In a folder that is
    not in ``graded``, every file counts. ``ours`` lists files in these folders that the student did
    not write, such as ch06_springs/cloth.py.
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
        """Switch to the student code of another engine, without lifting any restrictions."""
        self.folders = [folder.resolve() for folder in folders]
        self.graded = graded
        self.ours = ours
        self._known: dict[str, bool | None] = {}

    def is_calling(self) -> bool:
        """Return whether the current call was made by the student's code.

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
        """Return whether a file is the student's, or None if it is part of Python's library."""
        if file.startswith("<"):  # such as <string>, from exec, and <frozen os>
            return False if file.startswith("<frozen importlib") else None
        if is_inside(file, self.folders):
            return short(file) not in self.ours
        library = is_inside(file, LIBRARY) and not any(name in file for name in PACKAGES)
        return None if library else False

    def is_graded(self, package: str, file: str) -> bool:
        """Return whether this file of the chapter ``package`` will also exist in the grader.

        Probes always do.
        """
        return (
            package not in self.graded or file in self.graded[package] or file.endswith("probes.py")
        )
