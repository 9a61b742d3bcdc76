"""Run a chapter's checks on the reference with some functions changed, in a twentieth of a second.

One process imports the engine, collects the checks and forks a copy for each change, which replaces
the code of functions. As a script, this file is that process, which reads a request per line. If
this cannot be done (new code may use super()), the checks run in the ordinary, slow way.
"""

from __future__ import annotations

import atexit
import json
import os
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Collection
from importlib import import_module
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

import pytest

from autograder.checks.arrange import Config, Request
from autograder.checks.check_process import environment
from autograder.checks.events import Checks, Ended, Event, read_event, write_event
from autograder.checks.forked import CAN_FORK
from autograder.checks.pytest_plugin import Recorder, exercise_of, pytest_arguments, run_all
from autograder.checks.runner import Run, run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, Chapter

_ready: dict[str, Ready] = {}  # keyed by chapter and seed


def ready(chapter: Chapter, seed: str = "1") -> Ready:
    """Return the waiting process of a chapter, with an empty folder. All tests share it."""
    key = f"{chapter.name} {seed}"
    if key not in _ready:
        _ready[key] = Ready(chapter, seed)
    _ready[key].clear()
    return _ready[key]


class Ready:
    """The checks of a chapter. Write changed modules into the folder ``top`` before each run."""

    def __init__(self, chapter: Chapter, seed: str) -> None:
        self.chapter = chapter
        self.seed = seed
        self.kept = tempfile.TemporaryDirectory(prefix="ready-")
        self.folder = Path(self.kept.name)
        self.top = self.folder / "engine"
        (self.top / chapter.name).mkdir(parents=True)
        self.engine = [self.top, ROOT / "solutions", ROOT / "chapters"]
        self.process = self._start() if CAN_FORK else None

    def clear(self) -> None:
        for file in self.top.glob("*/*"):
            file.unlink()

    def run(self, edits: Collection[str], exercises: list[str]) -> list[Verdict]:
        """Return the verdicts on these exercises, if ``edits`` are the functions changed in top."""
        ran = Run(self._request(exercises))
        events = self.folder / "events.txt"
        events.unlink(missing_ok=True)
        request = {"edits": sorted(edits), "exercises": exercises, "events": str(events)}
        if self.process is not None:
            print(json.dumps(request), file=self.process.stdin, flush=True)
            self.process.stdout.readline()
            for line in events.read_text(encoding="utf-8").splitlines() if events.exists() else ():
                ran.take(read_event(line))
        if ran.finished:
            return ran.outcome()
        return run_checks(self.chapter, self.engine, seed=self.seed, exercises=exercises)

    def _request(self, exercises: list[str]) -> Request:
        return Request(self.chapter, self.engine, exercises, self.seed)

    def _start(self) -> subprocess.Popen[str]:
        everything = Run(self._request([exercise.id for exercise in self.chapter.exercises]))
        config = self.folder / "config.pickle"
        config.write_bytes(pickle.dumps(everything.config(self.folder)))
        process = subprocess.Popen(
            [sys.executable, __file__, str(config)],
            cwd=ROOT,
            env=environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )
        atexit.register(process.stdin.close)  # the process ends when its input is closed
        process.stdout.readline()  # it has imported the reference; top may now be filled
        return process


class WaitingRecorder(Recorder):
    """A recorder that waits after the checks are collected, and forks for each request."""

    events: list[Event]

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        (checks,) = (event for event in self.events if isinstance(event, Checks))
        os.write(ANSWERS, b"\n")
        for line in sys.stdin:
            copy = os.fork()
            if not copy:
                try:
                    self._run(session, checks, json.loads(line))
                finally:
                    os._exit(0)
            os.waitpid(copy, 0)
            os.write(ANSWERS, b"\n")
        os._exit(0)

    def _run(self, session: pytest.Session, checks: Checks, request: dict[str, Any]) -> None:
        """Change the functions, run the checks and send the events to the runner, all in a copy."""
        wanted = request["exercises"]
        with Path(request["events"]).open("w", encoding="utf-8", buffering=1) as events:
            self.send = lambda event: events.write(write_event(event))
            for edit in request["edits"]:
                change(self.engine.engine[0] / self.config.chapter, edit)
            self.send(Checks([check for check in checks.checks if check.exercise in wanted]))
            run_all([item for item in session.items if exercise_of(item) in wanted])
            self.send(Ended())


def change(folder: Path, edit: str) -> None:
    """Replace the code of a function in an imported module by the code in a file."""
    module, *names = edit.split(".")
    file = folder / f"{module}.py"
    code = compile(file.read_bytes(), file, "exec", dont_inherit=True)
    setter = names[-1] == "setter"
    names = names[:-1] if setter else names
    new: CodeType = code
    for name in names:  # the last function of a property's name is its setter
        found = [c for c in new.co_consts if isinstance(c, CodeType) and c.co_name == name]
        new = found[-1] if setter else found[0]
    *scope, name = names
    owner: Any = import_module(f"{folder.name}.{module}")
    for each in scope:
        owner = getattr(owner, each)
    old: Any = vars(owner)[name]
    if isinstance(old, property):
        old = old.fset if setter else old.fget
    while not isinstance(old, FunctionType):  # a classmethod, or a decorated function
        old = old.__func__ if hasattr(old, "__func__") else old.__wrapped__
    old.__code__ = new


def main() -> None:
    """Collect the checks of a configuration, and wait for requests."""
    config: Config = pickle.loads(Path(sys.argv[1]).read_bytes())
    events: list[Event] = []
    recorder = WaitingRecorder(config, events.append)
    recorder.events = events
    arguments = pytest_arguments(config.tests, config.root, config.seed, config.engine)
    pytest.main(arguments, plugins=[recorder])


if __name__ == "__main__":
    ANSWERS = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # checks may print, but not here
    main()
