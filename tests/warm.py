"""Run checks in copies of one process that has pytest ready: it takes a third off each run."""

from __future__ import annotations

import json
import multiprocessing
import os
import sys
import tempfile
from pathlib import Path

from autograder import judge, runner, verdicts
from autograder.events import read_event
from autograder.manifest import Chapter
from autograder.records import to_json
from autograder.runner import Order, Run, run_checks
from autograder.verdict import Verdict, with_needs

PATIENCE = 60.0  # seconds; a check that hangs ends its process after a few
COPIES = multiprocessing.get_context("forkserver")
COPIES.set_forkserver_preload([runner.__name__, verdicts.__name__])


def run_checks_warm(
    chapter: Chapter, engine: list[Path], *, seed: str, exercises: list[str] | None = None
) -> list[Verdict]:
    """Return the verdicts of run_checks, whose first process is a copy of one that waits here.

    Where that does not come to its end, it is all left to run_checks. Checks share that process:
    a copy for each would take several times as long.
    """
    ran = Run(Order(chapter, engine, with_needs(chapter, exercises), seed, apart=False))
    with tempfile.TemporaryDirectory(prefix="checks-") as folder:
        config, events = Path(folder) / "config.json", Path(folder) / "events.txt"
        config.write_text(json.dumps(to_json(ran.config(Path(folder)))), encoding="utf-8")
        process = COPIES.Process(target=_judge, args=(str(config), str(events)))
        process.start()
        process.join(PATIENCE)
        process.kill()
        told = events.read_text(encoding="utf-8") if events.exists() else ""  # it never began
        for line in told.splitlines():
            ran.take(read_event(line))
    if not ran.finished:
        return run_checks(chapter, engine, seed=seed, exercises=exercises)
    return ran.outcome()


def _judge(config: str, events: str) -> None:
    """Be the process of the checks, with its events in a file."""
    os.environ |= judge.environment()
    os.chdir(judge.ROOT)
    os.dup2(os.open(events, os.O_WRONLY | os.O_CREAT), 1)
    sys.path[:] = [path for path in sys.path if Path(path).parent != judge.ROOT]
    sys.argv = ["verdicts", config]
    os._exit(verdicts.main())
