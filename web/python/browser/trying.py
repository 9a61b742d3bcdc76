"""Run a line of Python on the student's engine, for the *Try it* box of an exercise.

All earlier lines of the box run again first, so a line always sees the newest code.
"""

from __future__ import annotations

import contextlib
import io
import sys
from pathlib import Path
from typing import Any

from autograder.at_home.restrictions import graded_files
from autograder.checks.printed import LONGEST, CappedText
from autograder.diagnosis.earlier_chapters import with_given
from autograder.diagnosis.explain import explain_hang
from autograder.diagnosis.faults import fault_of
from autograder.manifest import chapters_below, load_chapters
from autograder.student.interpreter import import_engine
from autograder.student.show import show
from lab.broken_off import TIME_LIMIT
from web.python.browser.folder import CHAPTERS, Folder
from web.python.browser.process import SHALLOW, as_a_process, code
from web.python.browser.watchdog import watchdog


def try_line(request: dict[str, Any], folder: Folder) -> dict[str, str]:
    """Return the ``value``, ``printed`` text and ``error`` of the request's ``line``.

    ``where`` is the line of the student's that raised the error. Absent texts are empty.
    """
    chapters = load_chapters()
    (chapter,) = (other for other in chapters if other.name == request["chapter"])
    given = [other for other in chapters if other.number in request["given"]]
    folder.lay(request["files"])
    with with_given(given, [CHAPTERS]) as folders, as_a_process():
        code.change(folders, graded_files(chapters))
        sys.path += map(str, folders)
        sys.setrecursionlimit(SHALLOW)
        watchdog.explain = lambda stack: {"why": str(explain_hang(stack, TIME_LIMIT, folders))}
        watchdog.start(TIME_LIMIT)
        try:
            names: dict[str, Any] = {"show": show}
            with contextlib.redirect_stdout(io.StringIO()) as problems:
                for found in import_engine([*chapters_below(chapter), chapter], folders).values():
                    names |= found
            for line in request["lines"]:
                _run(line, names, folders)
            tried = _run(request["line"], names, folders)
            tried["printed"] = problems.getvalue() * bool(tried["error"]) + tried["printed"]
            return tried
        finally:
            watchdog.stop()


def _run(line: str, names: dict[str, Any], folders: list[Path]) -> dict[str, str]:
    """Run a line of the student's, and return what it shows."""
    printed: list[str] = []
    values: list[str] = []
    shown, sys.displayhook = sys.displayhook, lambda v: values.append("" if v is None else repr(v))
    tried = dict.fromkeys(("value", "printed", "error", "where"), "")
    try:
        with contextlib.redirect_stdout(CappedText(printed.append)):
            exec(compile(f"{line}\n", "<your line>", "single", dont_inherit=True), names)
    except (Exception, SystemExit) as error:
        fault = fault_of(error, [folder.resolve() for folder in folders])
        tried["error"] = fault.first_line
        tried["where"] = str(fault.frames[-1]) if fault.frames else ""
    finally:
        sys.displayhook = shown
    tried["value"] = "\n".join(filter(None, values))[:LONGEST]
    tried["printed"] = "".join(printed).rstrip()
    return tried
