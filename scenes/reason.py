"""Explain to students why their code failed in a plot or in a scene of the lab."""

from __future__ import annotations

import traceback
from pathlib import Path

from autograder.at_home.restrictions import LIBRARY
from autograder.commands import LackingError, advice
from autograder.diagnosis.faults import is_inside
from autograder.diagnosis.slips import slip_of
from autograder.manifest import ROOT
from scenes.engine import RejectedFileError


def reason(error: BaseException) -> str:
    """Describe an error in a student's code: its message, line and, if common, its cause."""
    if isinstance(error, NotImplementedError):
        return f"not written yet: {error}"
    if isinstance(error, RejectedFileError | LackingError):
        return str(error)
    if isinstance(error, SyntaxError) and error.filename:
        file, line, words = error.filename, error.lineno, error.msg
    else:
        frames = traceback.extract_tb(error.__traceback__)
        not_theirs = [*LIBRARY, ROOT / "autograder"]  # autograder itself rejects some imports
        written = [frame for frame in frames if not is_inside(frame.filename, not_theirs)]
        last = (written or frames)[-1]
        file, line, words = last.filename, last.lineno, str(error)
    told = f"{type(error).__name__}: {words}"
    likely = slip_of(told) or advice(error)
    where = f"{told} ({shown(Path(file))}, line {line})"
    return f"{where}\nlikely    {likely}" if likely else where


def shown(path: Path) -> Path:
    """Make a path relative to the current folder if it is inside."""
    return path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path
