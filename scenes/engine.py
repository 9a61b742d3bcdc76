"""Choose the engine, a folder with a package per chapter: a student's work or the reference."""

from __future__ import annotations

import argparse
import atexit
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from importlib.abc import MetaPathFinder
from pathlib import Path
from types import ModuleType

from autograder.accepted_files import rejected_modules
from autograder.at_home.restrictions import StudentsCode, graded_files, restrict
from autograder.commands import find_engine
from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import load_chapters, select_chapters


class RejectedFileError(ImportError):
    """Raised when a scene or a plot imports a file that the grader would reject."""


class RejectedFiles(MetaPathFinder):
    """An import hook that refuses the modules whose files the grader would reject."""

    def __init__(self) -> None:
        self.reasons: dict[str, str] = {}  # keyed by the module's name

    def find_spec(self, name: str, _: Sequence[str] | None, __: ModuleType | None = None) -> None:
        """Raise RejectedFileError with the reason, or let Python search for the module."""
        if name in self.reasons:
            raise RejectedFileError(self.reasons[name], name=name)


rejected = RejectedFiles()
sys.meta_path.insert(0, rejected)
_given = ExitStack()  # temporary folders with given chapters, deleted at exit
atexit.register(_given.close)
_limited: set[tuple[Path, ...]] = set()


def add_engine_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--engine`` and ``--given``, such as "2-4", to a command for students."""
    parser.add_argument("--engine", default="chapters", help="the folder with your work")
    parser.add_argument("--given", default="", help="chapters to take from the reference")


def use_engine(parser: argparse.ArgumentParser, engine: str, given: str = "") -> None:
    """Import the chapters from the folder ``engine``, and those ``given`` from the reference.

    The code is restricted as during grading. A missing folder or chapter is a usage error.
    """
    try:
        chapters = select_chapters(given) if given else []
        folders = _given.enter_context(with_given(chapters, find_engine(engine)))
    except ValueError as error:
        parser.error(str(error))
    sys.path += map(str, folders)  # after Python's own modules, as in grading
    if tuple(folders) not in _limited:
        _limited.add(tuple(folders))
        chapters = load_chapters()
        ours = [f"{chapter.name}/{file}" for chapter in chapters for file in chapter.complete]
        restrict(StudentsCode(folders, graded_files(chapters), ours))
        rejected.reasons = rejected_modules(chapters, folders)
