"""Hostile submissions get what their honest code is worth, and nothing else comes of them.

All are graded in one run, in a process of its own. HOSTILE_KEEP=folder keeps everything there.
"""

from __future__ import annotations

import contextlib
import csv
import ctypes
import itertools
import json
import os
import re
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from subprocess import TimeoutExpired
from typing import Any

import pytest

from autograder.checks.runner import run_checks
from autograder.manifest import load_chapters

TESTS = Path(__file__).parents[2]
sys.path.append(str(Path(__file__).parent / "hostile"))

from corpus import (  # noqa: E402
    IDLE,
    POINTS,
    RIGHT,
    TOKENS,
    Submission,
    World,
    all_submissions,
    build_world,
    leaks,
    read_results,
    result_of,
    write,
)
from machine import (  # noqa: E402
    Services,
    bearing_the_mark_of,
    descendants,
    process_name,
    snapshot,
)
from odd_files import SUMS  # noqa: E402

from graded import message_of  # noqa: E402

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the walls are those of Linux")

SUBMISSIONS = all_submissions()
SEED = "hostile"
TIME_LIMIT = 1.0  # seconds for a check
RUN_LIMIT = 6.0 * len(SUBMISSIONS)  # seconds, by far more than a run in which nothing hangs
LONGEST_GAP = 30.0  # seconds between two results
LONGEST_MESSAGE = 8000  # characters
GRADE = """
import sys
from pathlib import Path

from autograder.course.model import Work
from autograder.grader import cohort
from autograder.manifest import load_chapters

folder, out, root = map(Path, sys.argv[1:4])
work = Work("", load_chapters(root), seed=sys.argv[4])
limit = float(sys.argv[5])
options = cohort.ClassOptions(jobs=2, root=root, time_limit=limit)
sys.exit(cohort.grade(folder, out, work, options))
"""
# Two names that are cleaned alike, with different work; and what is no submission.
ALIKE = {"alike\tname": RIGHT, "alike\x07name": IDLE, "alike_name": RIGHT}
LINKED = "linked-submission"
PR_SET_CHILD_SUBREAPER = 36


@dataclass(frozen=True)
class Run:
    """A graded class, and what the machine was like before and after."""

    world: World
    code: int | None  # None where it had to be ended
    screen: str
    results: list[dict[str, Any]]
    before: dict[str, str]
    after: dict[str, str]
    survivors: list[str]
    heard: list[bytes]


@pytest.fixture(scope="module")
def run() -> Iterator[Run]:
    """Grade the whole corpus once."""
    kept = os.environ.get("HOSTILE_KEEP")
    # Beside pytest's own temporary folders, which other users cannot enter: whatever user the
    # grader gives its workers, nothing but its walls may stop them.
    base = Path(kept or tempfile.mkdtemp(prefix="corpus-")).resolve()
    base.mkdir(parents=True, exist_ok=True)
    base.chmod(0o755)
    started: set[int] = set()
    libc = ctypes.CDLL(None)
    libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)  # what outlives the grader becomes our child
    name = secrets.token_hex(4)
    world = World(base, run=name)
    world.home.mkdir()
    services = Services(world.home, name)
    world = World(base, services.tcp, services.udp, name)
    try:
        build_world(world, SUBMISSIONS, TESTS)
        for student, work in ALIKE.items():
            write(world.submissions / student / SUMS, work)
        (world.submissions / LINKED).symlink_to(world.root / "solutions")
        before, others = snapshot(world), descendants()
        code = grade(world)
        time.sleep(0.5)  # what is being ended has the time to end
        started = descendants() - others | bearing_the_mark_of(world)
        survivors = [name for pid in started if (name := process_name(pid))]
        screen = (base / "screen.txt").read_text(encoding="utf-8", errors="replace")
        results = read_results(world.out)
        yield Run(world, code, screen, results, before, snapshot(world), survivors, services.heard)
    finally:
        libc.prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0)
        for pid in started:
            with contextlib.suppress(OSError):
                os.kill(pid, signal.SIGKILL)
            with contextlib.suppress(OSError):
                os.waitpid(pid, os.WNOHANG)
        if not kept:
            shutil.rmtree(base, ignore_errors=True)


def grade(world: World) -> int | None:
    environment = os.environ | {
        "HOME": str(world.home),
        "TMPDIR": str(world.temporary),
        "PYTHONPATH": str(TESTS.parent),
        "PYTHONUTF8": "1",
        "HOSTILE_SECRET": TOKENS["the environment"],
        "HOSTILE_RUN": world.run,
    }
    places = [str(path) for path in (world.submissions, world.out, world.root)]
    command = [sys.executable, "-c", GRADE, *places, SEED, str(TIME_LIMIT)]
    with (world.base / "screen.txt").open("wb") as screen, contextlib.suppress(TimeoutExpired):
        return subprocess.run(
            command,
            cwd=TESTS.parent,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=screen,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            timeout=RUN_LIMIT,
            check=False,
        ).returncode
    return None


@pytest.mark.parametrize("submission", SUBMISSIONS, ids=[f"{s.kind}/{s.name}" for s in SUBMISSIONS])
def test_a_submission_gets_what_its_honest_code_is_worth(run: Run, submission: Submission) -> None:
    result = result_of(submission, run.results)
    assert result is not None, f"there is no result; the grader said: {run.screen[-2000:]}"
    if result["status"] == "nothing to grade":  # which is no zero, and has its own reason
        assert (submission.earns, submission.score, result["score"]) == (set(), 0, None)
        assert re.search(submission.says, result["nothing"]), result["nothing"]
        return
    lost = [c for one in result["results"] for c in one["checks"] if c["status"] != "passed"]
    messages = "\n".join(map(message_of, lost))
    assert result["status"] == "graded", messages
    earned = {r["exercise"]["id"] for r in result["results"] if r["status"] == "passed"}
    assert earned == submission.earns, messages
    assert result["score"] == submission.score
    assert result["points"] == sum(POINTS.values())
    assert not lost or re.search(submission.says, messages), messages
    for check in lost:  # each says why, in words
        message = message_of(check)
        assert check["status"] in ("failed", "blocked")
        assert len(re.findall(r"[a-z]{2,}", message)) >= 3, message
        assert "Traceback (most recent call last)" not in message
        assert len(message) <= LONGEST_MESSAGE
        assert all(char.isprintable() or char in "\n\t" for char in message), message


def test_the_run_ends_by_itself_and_misses_nobody(run: Run) -> None:
    assert run.code == 0, run.screen[-4000:]
    assert len(run.results) == len(SUBMISSIONS) + len(ALIKE)
    assert not [one for one in run.results if LINKED in one["student"]], "a link is no submission"
    times = sorted(path.stat().st_mtime for path in (run.world.out / "results").iterdir())
    gaps = [later - earlier for earlier, later in itertools.pairwise(times)]
    assert max(gaps) < LONGEST_GAP


def test_nothing_outlives_the_run_and_nobody_was_talked_to(run: Run) -> None:
    assert run.survivors == []
    assert run.heard == []


def test_nothing_is_written_outside_the_box(run: Run) -> None:
    changed = {
        path: (run.before.get(path, "was not there"), run.after.get(path, "is gone"))
        for path in run.before.keys() | run.after.keys()
        if run.before.get(path) != run.after.get(path)
    }
    assert changed == {}
    expected = {"results", "feedback", "gradescope", "gradebook.csv", "index.html"}
    assert expected <= {path.name for path in run.world.out.iterdir()}
    assert not [*run.world.out.rglob("*hostile*note*")]


def test_no_secret_is_told_and_the_screen_is_safe(run: Run) -> None:
    assert leaks(run.world.out) == []
    for place, token in TOKENS.items():
        assert token not in run.screen, place
    assert not [char for char in run.screen if not char.isprintable() and char not in "\n\r\t"]


def test_names_that_are_cleaned_alike_keep_their_own_results(run: Run) -> None:
    alike = [result for result in run.results if result["student"].startswith("alike")]
    assert len({result["student"] for result in alike}) == len(ALIKE)
    assert sorted(result["score"] for result in alike) == [0, 7, 7]


def test_the_gradebook_has_a_row_for_each_and_no_formula(run: Run) -> None:
    with (run.world.out / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        header, possible, *rows = csv.reader(file)
    assert header[0] == "student"
    assert possible[header.index("score")] == str(sum(POINTS.values()))
    cells = {row[0].removeprefix("'"): row[header.index("score")] for row in rows}
    scores = {name: float(cell) if cell else None for name, cell in cells.items()}
    assert scores == {result["student"]: result["score"] for result in run.results}
    for row in rows:
        assert not row[0].startswith(("=", "+", "-", "@", "\t", "\r")), row
        assert all(char.isprintable() for cell in row for char in cell), row


def test_pages_show_mark_up_as_text(run: Run) -> None:
    pages = [run.world.out / "index.html", *(run.world.out / "feedback").glob("*.html")]
    assert len(pages) == len(run.results) + 1
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert "<script>alert" not in text, page.name
        assert "<img src=x" not in text, page.name
        assert "\x1b" not in text, page.name


def test_files_for_gradescope_are_sound(run: Run) -> None:
    files = [path for path in (run.world.out / "gradescope").rglob("*.json") if path.is_file()]
    assert len(files) >= len(run.results)
    for path in files:
        assert isinstance(json.loads(path.read_text(encoding="utf-8")), dict)


def test_the_solution_passes_beside_its_checks(run: Run) -> None:
    (chapter,) = load_chapters(run.world.root)
    engine = [run.world.root / "solutions", run.world.root / "chapters"]
    verdicts = run_checks(chapter, engine, seed="1", root=run.world.root)
    assert [verdict.status for verdict in verdicts] == ["passed"] * len(POINTS)
