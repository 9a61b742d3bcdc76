"""Checks run in their own process: what hangs, leaves or cannot be imported costs only itself."""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from autograder.checks import check_process
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import load_chapter
from autograder.message import Kind
from autograder.scores import results_of, total
from small import CHECKS, RIGHT, hand_in, make_root
from walls import behind_walls

Run = Callable[..., dict[str, Verdict]]
SMALL_CHECKS = "tests/ch90_small/test_small.py"


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A repository with one small chapter, in a folder with a difficult name."""
    return make_root(tmp_path / "a [red], é folder")


@pytest.fixture
def run_beside(root: Path) -> Run:
    """Runs the checks on a module with some code, in one process; returns the verdicts by name."""
    chapter = load_chapter(root / "chapters/ch90_small")

    def run(code: str | None, **options: object) -> dict[str, Verdict]:
        shutil.rmtree(root / "engine", ignore_errors=True)
        hand_in(root, "engine", code or "")
        if code is None:
            (root / "engine/ch90_small/small.py").unlink()
        options = {"seed": "1", "limits": Limits(0.7)} | options
        verdicts = run_checks(chapter, [root / "engine"], root=root, **options)  # type: ignore[arg-type]
        return {verdict.name: verdict for verdict in verdicts}

    return run


@pytest.fixture(params=["beside the checks", "in a worker"])
def run(request: pytest.FixtureRequest, run_beside: Run) -> Run:
    """Runs the checks both ways: each test that uses it holds for both."""
    sandbox = behind_walls() if request.param == "in a worker" else None
    return partial(run_beside, sandbox=sandbox)


def says(verdicts: dict[str, Verdict], name: str) -> str:
    return str(verdicts[name].message)


def results(root: Path, verdicts: dict[str, Verdict]) -> list[Any]:
    return results_of(load_chapter(root / "chapters/ch90_small"), verdicts.values())


def statuses(verdicts: dict[str, Verdict]) -> list[str]:
    return [verdict.status for verdict in verdicts.values()]


def test_right_code_passes_and_its_points_follow_the_weights(root: Path, run: Run) -> None:
    verdicts = run(RIGHT)
    assert " ".join(verdicts) == (
        "test_double test_double_of_zero test_quadruple test_quadruple_of_zero"
    )
    assert statuses(verdicts) == ["passed"] * 4
    assert total(results(root, verdicts)) == (6.0, 6)


def test_partial_credit_is_by_weight_and_a_failed_need_blocks(root: Path, run: Run) -> None:
    code = "def double(x):\n    return 0\n\n\ndef quadruple(x):\n    return double(double(x))\n"
    verdicts = run(code)
    assert statuses(verdicts) == ["failed", "passed", "blocked", "passed"]
    assert verdicts["test_quadruple"].message.blocked.startswith(
        "blocked until B90.1 (Double) passes"
    )
    found = results(root, verdicts)
    assert [(r.status, r.score) for r in found] == [("failed", 1.0), ("blocked", 1.0)]


def test_an_endless_loop_says_where(run: Run) -> None:
    verdicts = run(RIGHT.replace("return x + x", "while x:\n        pass\n    return 0"))
    assert "did not finish within 0.7 seconds" in says(verdicts, "test_double")
    # The loop has two lines, and the time may be up on either.
    assert re.search(r"small\.py, line [34], in double", says(verdicts, "test_double"))
    other = says(verdicts, "test_double_of_zero")
    if run.keywords["sandbox"]:  # when it is graded, a loop costs its own check
        assert statuses(verdicts) == ["failed", "passed", "passed", "passed"]
    else:  # at home, the student need not wait for the other checks of the exercise
        assert statuses(verdicts) == ["failed", "failed", "passed", "passed"]
        assert other == "not run: another check of this exercise did not finish"


def test_a_loop_that_uses_up_the_memory_says_where_and_is_run_once_at_home(run: Run) -> None:
    loop = "rows = []\n    while x or True:\n        rows.append([x] * 100)"
    limits = Limits(30.0)
    verdicts = run(RIGHT.replace("return x + x", loop), limits=limits)
    assert "MemoryError" in says(verdicts, "test_double")
    assert re.search(r"small\.py, line [345], in double", says(verdicts, "test_double"))
    assert "Does a loop never end" in says(verdicts, "test_double")
    other = says(verdicts, "test_double_of_zero")
    assert ("not run" in other) is not bool(run.keywords["sandbox"])


@pytest.mark.parametrize(
    ("leave", "words"),
    [
        ("import sys; sys.exit()", "SystemExit"),
        ("import os; os._exit(0)", "ended early"),
        ("raise KeyboardInterrupt", "ended early|KeyboardInterrupt"),
        ("import pytest; pytest.exit('', 0)", "ended early|No module named"),
        ("raise NotImplementedError('Exercise B90.1: Double')", "not written yet"),
    ],
)
def test_leaving_costs_the_check_and_no_other(run: Run, leave: str, words: str) -> None:
    verdicts = run(RIGHT.replace("return x + x", leave))
    assert statuses(verdicts) == ["failed", "failed", "passed", "passed"]
    # What differs: the checks' own process is ended by what a worker only reports.
    assert re.search(words, says(verdicts, "test_double"))


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("def double(x:\n    return x + x\n", "ch90_small/small.py cannot be read"),
        ("import sys\nsys.exit()\n", "ch90_small/small.py cannot be imported: SystemExit"),
        ("import nowhere\n", "No module named 'nowhere'"),
        ("while True:\n    pass\n", "small.py cannot be imported: did not"),
        ("import os\nos._exit(0)\n", "cannot be imported: the process ended early"),
        ("def quadruple(x):\n    return 4 * x\n", "small.py does not define double"),
        (None, "ch90_small/small.py is missing: it was not handed in"),
        ("", "ch90_small/small.py is empty and does not define double"),
        ('text.\n"""\n\ndouble = 2\n', "likely    A quotation mark is missing"),
        ("from math import tan2\n", "cannot import name 'tan2' from 'math'\n"),
        ("double = None\n", "NoneType"),
    ],
)
def test_a_module_that_cannot_be_used_fails_every_check_with_the_reason(
    root: Path, run: Run, code: str | bytes | None, words: str
) -> None:
    verdicts = run(code)
    assert len(verdicts) == 4
    assert statuses(verdicts)[:2] == ["failed", "failed"]
    assert words in says(verdicts, "test_double")
    assert total(results(root, verdicts))[0] in (0.0, 2.0)


def test_a_process_that_talks_nonsense_is_no_crash_of_ours(run_beside: Run) -> None:
    floods = "import os\n    for fd in range(3, 40):\n        try: os.write(fd, b'nonsense\\n')\n"
    floods += "        except OSError: pass\n    return 0"
    with pytest.raises(GraderError, match="sent an unknown event, 'nonsense"):
        run_beside(RIGHT.replace("return x + x", floods))


def test_after_a_silent_process_one_that_leaves_is_told_from_it(
    run_beside: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(check_process, "GRACE", 1.5)  # s; a busy machine starts slowly
    quiet = "import faulthandler, time\n    faulthandler.cancel_dump_traceback_later()\n"
    code = RIGHT.replace("return x + x", f"{quiet}    time.sleep(60)")
    code = code.replace("return 4 * x", "import os; os._exit(1)")
    verdicts = run_beside(code)
    assert statuses(verdicts)[:2] == ["failed", "failed"]
    assert verdicts["test_double"].message.kind is Kind.HUNG
    assert "ended early" in says(verdicts, "test_quadruple")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
def test_a_child_that_a_student_leaves_behind_is_ended_and_not_waited_for(run_beside: Run) -> None:
    start = time.monotonic()
    # os.fork is refused; the C library's is not noticed.
    code = "import ctypes, time\nif ctypes.CDLL(None).fork() == 0:\n    time.sleep(60)\n" + RIGHT
    assert statuses(run_beside(code)) == ["passed"] * 4
    assert time.monotonic() - start < 30.0  # half a second, and much for a busy machine


def test_an_exception_that_hangs_or_fails_when_it_is_shown_costs_its_check(run: Run) -> None:
    for text, words in (
        ("while True: pass", "did not finish"),
        ("raise SystemExit", "cannot be shown"),
    ):
        error = f"class Odd(NotImplementedError):\n    def __str__(self):\n        {text}\n"
        verdicts = run(error + RIGHT.replace("return x + x", "raise Odd"))
        assert statuses(verdicts) == ["failed", "failed", "passed", "passed"]
        assert words in says(verdicts, "test_double")


def test_a_hang_in_the_last_check_costs_that_check_alone(run: Run) -> None:
    code = RIGHT.replace("return 4 * x", "while x == 0: pass\n    return 4 * x")
    assert statuses(run(code)) == ["passed", "passed", "passed", "failed"]


def test_what_builds_on_a_hang_waits_for_it_once(run: Run) -> None:
    code = "def double(x):\n    while True: pass\n\n\ndef quadruple(x):\n    return double(x)\n"
    verdicts = run(code)
    assert statuses(verdicts) == ["failed", "failed", "blocked", "blocked"]
    # Where two checks hung in double, from then on a check has a quarter of the time.
    zero, four = ("0.7 s", "0.175 s") if run.keywords["sandbox"] else ("not run", "0.7 s")
    assert zero in says(verdicts, "test_double_of_zero")
    assert four in says(verdicts, "test_quadruple")
    other = says(verdicts, "test_quadruple_of_zero")
    assert "not run: another check of this exercise did not finish" in other


def test_the_time_for_all_checks_is_limited(run: Run) -> None:
    start = time.monotonic()
    code = RIGHT.replace("return 4 * x", "import time; time.sleep(3)")
    verdicts = run(code, limits=Limits(60.0, 2.0))
    assert time.monotonic() - start < 30.0  # two seconds, and much for a busy machine
    assert statuses(verdicts) == ["passed", "passed", "failed", "failed"]
    assert "time limit of 2 seconds for all checks was used up" in says(verdicts, "test_quadruple")


def test_the_seed_decides_the_numbers(run: Run) -> None:
    code = "def double(x):\n    raise ValueError(x)\n"
    messages = [run(code, seed=seed)["test_double"].message for seed in "112"]
    assert messages[0] == messages[1]
    assert messages[0] != messages[2]


def test_an_edit_within_the_same_second_is_seen(
    root: Path, run_beside: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
    assert run_beside(RIGHT)["test_double"].status == "passed"
    file = root / "engine/ch90_small/small.py"
    saved = file.stat().st_mtime_ns
    file.write_text(RIGHT.replace("x + x", "x - x"), encoding="utf-8")  # of the same length
    os.utime(file, ns=(saved, saved))
    chapter = load_chapter(root / "chapters/ch90_small")
    verdicts = run_checks(chapter, [root / "engine"], seed="1", root=root)
    assert verdicts[0].status == "failed"


def test_options_for_other_runs_of_pytest_do_not_reach_the_checks(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_ADDOPTS", "--no-such-option")
    assert statuses(run(RIGHT)) == ["passed"] * 4


@pytest.mark.parametrize(
    "broken", ["import nowhere\n", CHECKS.replace('("B90.1", weight=3)', "()"), "def f(:\n"]
)
def test_checks_that_cannot_run_are_our_fault_and_no_zero(
    root: Path, run: Run, broken: str
) -> None:
    (root / SMALL_CHECKS).write_text(broken, encoding="utf-8")
    with pytest.raises(GraderError):
        run(RIGHT)


def test_a_fixture_that_fails_is_an_error_and_gives_no_score(root: Path, run: Run) -> None:
    fixture = "\n\n@pytest.fixture\ndef rng():\n    raise OSError('no numbers today')\n"
    (root / SMALL_CHECKS).write_text(CHECKS + fixture, encoding="utf-8")
    verdicts = run(RIGHT)
    assert statuses(verdicts) == ["error", "passed", "passed", "passed"]
    found = results(root, verdicts)
    assert [(result.status, result.score) for result in found] == [("error", None), ("passed", 2)]
