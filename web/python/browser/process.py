"""Run checks as if in a new process, because a browser cannot start one.

When a process ends, its imported modules, its sys.path and its working folder are discarded. Each
run therefore ends by removing the modules and by restoring sys.path and the working folder.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import sys
from collections.abc import Iterator
from functools import lru_cache
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType
from typing import Any

import pytest

from autograder.at_home.in_process import InProcess, Send, leave_home
from autograder.at_home.restrictions import StudentsCode, restrict
from autograder.checks.arrange import Config
from autograder.checks.check_process import MOST_STDERR, Ending
from autograder.checks.pytest_plugin import Recorder, pytest_arguments
from autograder.manifest import ROOT
from web.python.browser.watchdog import watchdog

OF_A_RUN = re.compile(r"ch\d\d_\w+|tests|conftest")  # packages whose modules one run imports
SHALLOW = 250  # nested operator calls that fit on every browser's stack
code = StudentsCode([], {})  # the code that is checked, and that is restricted


def install_limits() -> None:
    """Restrict what the student's code may import and do. Call this once."""
    restrict(code)


def compile_once() -> None:
    """Cache compiled code, which cuts the time of a short check by a third. Call this once."""
    compiled = lru_cache(maxsize=1000)(compile)

    def source_to_code(_: SourceFileLoader, data: Any, path: str, *_1: Any, **_2: Any) -> CodeType:
        code: CodeType = compiled(data, path, "exec", dont_inherit=True)
        return code

    SourceFileLoader.source_to_code = source_to_code  # type: ignore[assignment, method-assign]


class InBrowser(InProcess):
    """Imports the student's modules in a browser, where no process can be started and killed.

    A watchdog reports code that runs for too long, and the page then ends the web worker.
    """

    forks = False

    def surround(self) -> None:
        """Set up the same environment and limits for the student's code as in the grader."""
        leave_home()
        code.change(self.engine, self.config.graded)

    def after_collection(self) -> None:
        """Do nothing, because a browser cannot fork a process."""

    def start_clock(self) -> None:
        """Start the watchdog, which interrupts the student's code when a check takes too long."""
        watchdog.start(self.config.time_limit)

    def stop_clock(self) -> None:
        watchdog.stop()


class BrowserRecorder(Recorder):
    """Records results, and skips unneeded test files, because they load slowly here."""

    def pytest_ignore_collect(self, collection_path: Path) -> bool | None:
        """Skip a test file that does not cover any of the requested exercises."""
        if not collection_path.name.startswith("test_"):
            return None
        text = collection_path.read_text(encoding="utf-8")
        named = any(f'"{exercise}"' in text for exercise in self.config.exercises)
        return None if named else True


def run_here(config: Config, send: Send, *, shallow: bool) -> Ending:
    """Run the checks of ``config`` in this interpreter, and pass each event to ``send``.

    If ``shallow`` is true, the recursion limit is lower, because some browsers have a small stack.
    """
    said = io.StringIO()
    with as_a_process(), contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
        os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
        engine = InBrowser(config)
        if shallow:
            engine.depth = SHALLOW
        arguments = pytest_arguments(config.tests, config.root, config.seed, config.engine)
        pytest.main(arguments, plugins=[BrowserRecorder(config, send, engine)])
    return Ending(stderr=said.getvalue()[-MOST_STDERR:].strip())


@contextlib.contextmanager
def as_a_process() -> Iterator[None]:
    """Restore the modules, sys.path, the recursion limit and the folder after a with block."""
    path, limit = list(sys.path), sys.getrecursionlimit()
    forget_modules()
    os.chdir(ROOT)
    try:
        yield
    finally:
        forget_modules()
        sys.path[:] = path
        sys.setrecursionlimit(limit)
        os.chdir(ROOT)


def forget_modules() -> None:
    """Remove the student's modules and the checks, so that the next run imports them again."""
    shared = str(ROOT / "tests")
    for name, module in list(sys.modules.items()):
        file = getattr(module, "__file__", None) or ""
        if OF_A_RUN.match(name) or str(file).startswith(shared):
            del sys.modules[name]
    forget_folders()


def forget_folders() -> None:
    """Clear Python's cache of the course's folders, because the page may have changed them."""
    for folder in list(sys.path_importer_cache):
        if not folder.startswith(sys.prefix):
            del sys.path_importer_cache[folder]
