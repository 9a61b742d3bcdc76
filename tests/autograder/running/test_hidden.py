"""Hidden checks of an instructor: they count, and tell a rationale alone."""

from __future__ import annotations

from html import unescape
from pathlib import Path

import pytest

from autograder.grader import cohort
from graded import message_of
from small import RIGHT, hand_in
from small_class import everything_in, grade, results, scores

HIDDEN = '''
import pytest
from ch90_small import small
from ch90_small.hidden_probes import double_twice


@pytest.mark.exercise("90.1")
@pytest.mark.parametrize("secret_value", [1234, 5678])
def test_secret_plan(secret_value):
    """Quadruple must hold for large numbers."""
    print("secret output")
    assert small.quadruple(secret_value) == 4 * secret_value, "secret expectation"


@pytest.mark.exercise("B90.1")
def test_secret_second_plan():
    assert double_twice(77) == 308, "secret expectation"
'''
HIDDEN_PROBES = """
from ch90_small.small import double


def double_twice(x):
    return double(double(x))
"""


def test_hidden_checks_count_and_tell_a_rationale_alone(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    (hidden / "test_more.py").write_text(HIDDEN, encoding="utf-8")
    (hidden / "hidden_probes.py").write_text(HIDDEN_PROBES, encoding="utf-8")
    hand_in(submissions, "dee", RIGHT.replace("return 4 * x", "while True: pass"))
    out = tmp_path / "out"
    grade(submissions, out, root, hidden=tmp_path / "hidden", time_limit=0.7)
    # Exercise 90.1 has 2 points for 4 checks now, and bob passes the one of zero.
    assert scores(out) == {"ann": 6.0, "bob": 4.5, "cem": 6.0, "dee": 4.0}
    (exercise,) = (e for e in results(out)["bob"]["exercises"] if e["id"] == "90.1")
    told = {c["name"]: message_of(c) for c in exercise["checks"] if c["hidden"]}
    assert told == {
        "hidden check 2": "Quadruple must hold for large numbers.",
        "hidden check 3": "Quadruple must hold for large numbers.",
    }
    assert "secret" not in everything_in(out) + capsys.readouterr().out
    assert "1234" not in everything_in(out / "feedback") + everything_in(out / "gradescope")


@pytest.mark.parametrize(
    ("name", "text", "complaint"),
    [
        (
            "test_x.py",
            HIDDEN.replace("4 * secret_value", "5"),
            "plan.1234. fails on the reference itself: secret",
        ),
        (
            "test_x.py",
            HIDDEN.replace('"90.1"', '"90.9"'),
            "cannot be run: .* belongs to an unknown exercise",
        ),
        ("notes.py", "", "there is no check in"),
    ],
)
def test_hidden_checks_that_are_wrong_themselves_stop_the_run_before_it_begins(
    submissions: Path, root: Path, tmp_path: Path, name: str, text: str, complaint: str
) -> None:
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    (hidden / name).write_text(text, encoding="utf-8")
    (hidden / "hidden_probes.py").write_text(HIDDEN_PROBES, encoding="utf-8")
    with pytest.raises(ValueError, match=complaint):
        grade(submissions, tmp_path / "out", root, hidden=tmp_path / "hidden")
    assert not (tmp_path / "out/results").exists()


def test_hidden_probes_do_not_take_the_place_of_public_ones(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    (root / "tests/ch90_small/probes.py").touch()
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    (hidden / "probes.py").touch()
    with pytest.raises(ValueError, match=r"probes\.py has the name of a public file"):
        grade(submissions, tmp_path / "out", root, hidden=tmp_path / "hidden")


def test_a_hidden_check_that_the_grader_fails_on_tells_nothing_either(
    submissions: Path, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    fixture = "\n\n@pytest.fixture(autouse=True)\ndef odd():\n    raise OSError('secret fault')\n"
    (hidden / "test_more.py").write_text(HIDDEN + fixture, encoding="utf-8")
    (hidden / "hidden_probes.py").write_text(HIDDEN_PROBES, encoding="utf-8")
    monkeypatch.setattr(cohort, "check_hidden", lambda _: None)
    out = tmp_path / "out"
    assert grade(submissions, out, root, hidden=tmp_path / "hidden") == 1
    assert scores(out) == {"ann": None, "bob": None, "cem": None}
    assert "the grader failed on this check" in everything_in(out / "feedback")
    assert "secret" not in everything_in(out)


SPY = """
import importlib
import sys


def found():
    try:
        module = importlib.import_module("ch90_small.hidden_probes")
        text = module.double_twice.__code__.co_consts
    except ImportError:
        text = "nothing"
    return f"found {text}, {[name for name in sys.modules if 'hidden' in name]}"


def double(x):
    raise RuntimeError(found())


def quadruple(x):
    print(found())
    return 4 * x + 1
"""


@pytest.mark.parametrize("when", ["in a function", "at import"])
def test_hidden_probes_are_not_where_public_checks_run(
    when: str, submissions: Path, root: Path, tmp_path: Path
) -> None:
    """The spy's public checks show what it found, and its hidden checks must not."""
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    (hidden / "test_more.py").write_text(HIDDEN, encoding="utf-8")
    (hidden / "hidden_probes.py").write_text(
        HIDDEN_PROBES + '    "secret of a probe"\n', encoding="utf-8"
    )
    hand_in(
        submissions, "eve", SPY if when == "in a function" else f"{SPY}\nprint(found())\n1 / 0\n"
    )
    out = tmp_path / "out"
    grade(submissions, out, root, hidden=tmp_path / "hidden")
    assert scores(out)["ann"] == 6.0  # her hidden checks can use their probes
    pages = unescape(everything_in(out))
    assert "secret" not in pages
    if when == "in a function":
        assert "found nothing, []" in pages


def test_a_folder_called_hidden_hides_no_public_check(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    plain, inside = tmp_path / "grades", tmp_path / "hidden/grades"
    checks = tmp_path / "own/ch90_small"
    checks.mkdir(parents=True)
    (checks / "test_more.py").write_text(HIDDEN, encoding="utf-8")
    (checks / "hidden_probes.py").write_text(HIDDEN_PROBES, encoding="utf-8")
    moved = root.rename(root.parent / "hidden")
    for out in (plain, inside):
        out.parent.mkdir(exist_ok=True)
        grade(submissions, out, moved / ".", hidden=tmp_path / "own", seed="1")
    for one, other in zip(results(plain).values(), results(inside).values(), strict=True):
        names = [[c["name"] for c in e["checks"]] for e in one["exercises"]]
        assert names == [[c["name"] for c in e["checks"]] for e in other["exercises"]]
        assert sum(name.startswith("hidden check") for of in names for name in of) == 3
