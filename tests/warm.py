"""Run checks in copies of one process that has pytest ready: it takes a third off each run."""

from __future__ import annotations

import json
import multiprocessing
import os
import sys
import tempfile
from pathlib import Path

from autograder import runner, verdicts
from autograder.manifest import ROOT, Chapter
from autograder.runner import Verdict, run_checks

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
    wanted = runner.with_needs(chapter, exercises)
    hear = lambda *_: None  # noqa: E731
    ran = runner._Run(chapter, engine, wanted, seed, ROOT, 3.0, 90.0, hear, None, apart=False)
    with tempfile.TemporaryDirectory(prefix="checks-") as folder:
        config, events = Path(folder) / "config.json", Path(folder) / "events.txt"
        config.write_text(ran._config(Path(folder)), encoding="utf-8")
        process = COPIES.Process(target=_judge, args=(str(config), str(events)))
        process.start()
        process.join(PATIENCE)
        process.kill()
        current = None
        told = events.read_text(encoding="utf-8") if events.exists() else ""  # it never began
        for line in told.splitlines():
            current = ran._take(json.loads(line), current)
    if not ran.finished:
        return run_checks(chapter, engine, seed=seed, exercises=exercises)
    return runner._mark_blocked(chapter, ran.ordered_verdicts())


def _judge(config: str, events: str) -> None:
    """Be the process of the checks, with its events in a file."""
    os.environ |= runner._environment()
    os.chdir(ROOT)
    os.dup2(os.open(events, os.O_WRONLY | os.O_CREAT), 1)
    sys.path[:] = [path for path in sys.path if Path(path).parent != ROOT]
    sys.argv = ["verdicts", config]
    os._exit(verdicts.main())
