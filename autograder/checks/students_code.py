"""Know the student's code: which files it is in, which of them are graded, and whether it runs."""

from __future__ import annotations

import sys
import sysconfig
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from autograder.checks.faults import is_inside, short
from autograder.manifest import Chapter

LIBRARY = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
# Python may have its library in a zip beside that: in a browser it does.
LIBRARY.append(LIBRARY[0].with_name(f"python{''.join(map(str, sys.version_info[:2]))}.zip"))
PACKAGES = ("site-packages", "dist-packages")  # they may lie inside the library's folder


def graded_files(chapters: Iterable[Chapter]) -> dict[str, list[str]]:
    """Return the files of each chapter's folder that a grader has: handed in, or complete."""
    return {chapter.name: [*chapter.handed_in, *chapter.complete] for chapter in chapters}


class StudentsCode:
    """The code in the folders of an engine.

    ``graded`` lists, for each chapter's folder, the files that a grader has. A folder that is not
    in it is taken whole. The files ``ours``, such as ch06_springs/cloth.py, were not written by
    the student.
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
        """Know the code of another engine from now on; what limits it stays installed."""
        self.folders = [folder.resolve() for folder in folders]
        self.graded = graded
        self.ours = ours
        self._known: dict[str, bool | None] = {}

    def asks(self) -> bool:
        """Say whether the student's code made the call that our caller is to judge.

        The nearest function on the stack that is not of Python's library decides. What Python
        does in order to import a module counts as Python's own act, not as the student's.
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
        """Say whether a file is the student's; None for Python's library."""
        if file.startswith("<"):  # such as <string>, which exec has, and <frozen os>
            return False if file.startswith("<frozen importlib") else None
        if is_inside(file, self.folders):
            return short(file) not in self.ours
        library = is_inside(file, LIBRARY) and not any(name in file for name in PACKAGES)
        return None if library else False

    def is_graded(self, package: str, file: str) -> bool:
        """Say whether a grader has this file of a chapter's folder. Probes come with the checks."""
        return (
            package not in self.graded or file in self.graded[package] or file.endswith("probes.py")
        )
