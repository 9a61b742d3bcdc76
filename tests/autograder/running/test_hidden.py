"""Hidden checks of an instructor: they count, and tell students a rationale alone."""

from __future__ import annotations

import json
from html import unescape
from pathlib import Path

import pytest

from autograder.grader import cohort
from autograder.isolation.sandbox import Level
from autograder.platforms.grade_one import grade_one, main
from graded import message_of
from small import RIGHT, hand_in
from small_class import everything_in, grade, results, scores
from walls import behind_walls

WALLS = Level(**behind_walls().level).is_sandbox
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


def for_students(out: Path) -> str:
    """Return everything that was written except results/, which is the instructor's."""
    return "\n".join(
        path.read_text(encoding="utf-8")
        for path in sorted(out.rglob("*"))
        if path.is_file() and path.parent != out / "results"
    )


def write_hidden(folder: Path, checks: str = HIDDEN, probes: str = HIDDEN_PROBES) -> None:
    """Write an instructor's hidden checks and their probes."""
    (folder / "ch90_small").mkdir(parents=True)
    (folder / "ch90_small/test_more.py").write_text(checks, encoding="utf-8")
    (folder / "ch90_small/hidden_probes.py").write_text(probes, encoding="utf-8")


def test_hidden_checks_count_and_tell_students_a_rationale_alone(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_hidden(tmp_path / "hidden")
    hand_in(submissions, "dee", RIGHT.replace("return 4 * x", "while True: pass"))
    out = tmp_path / "out"
    grade(submissions, out, root, hidden=tmp_path / "hidden", time_limit=0.7)
    # Exercise 90.1 has 2 points for 4 checks now, and bob passes the one of zero.
    assert scores(out) == {"ann": 6.0, "bob": 4.5, "cem": 6.0, "dee": 4.0}
    (result,) = (r for r in results(out)["bob"]["results"] if r["exercise"]["id"] == "90.1")
    told = {c["name"]: message_of(c) for c in result["checks"] if c.get("hidden")}
    assert told == {
        "hidden check 2": "Quadruple must hold for large numbers.",
        "hidden check 3": "Quadruple must hold for large numbers.",
    }
    assert "secret" not in for_students(out)
    assert "1234" not in everything_in(out / "feedback") + everything_in(out / "gradescope")
    assert "secret" not in capsys.readouterr().out, "the public checks that fail come first"


def test_the_instructor_sees_why_a_hidden_check_fails(
    submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_hidden(tmp_path / "hidden")
    hand_in(submissions, "eve", RIGHT.replace("return 4 * x", "return 4 * x if x < 2000 else 0"))
    out = tmp_path / "out"
    grade(submissions, out, root, hidden=tmp_path / "hidden")
    report = results(out)["eve"]
    (failed,) = (c for r in report["results"] for c in r["checks"] if c["status"] == "failed")
    assert message_of(failed) == "Quadruple must hold for large numbers."
    assert failed["secret"]["name"] == "test_secret_plan[5678]"
    assert message_of(failed["secret"]).startswith("secret expectation")
    assert "90.1: secret expectation" in " ".join(capsys.readouterr().out.split())
    pages = for_students(out)
    assert "secret" not in pages
    assert "5678" not in pages
    assert "Quadruple must hold for large numbers." in pages
    # A report that is read again, as make grade does for a class, keeps the secret.
    grade(submissions, out, root, hidden=tmp_path / "hidden")
    assert results(out)["eve"] == report
    assert "secret" not in for_students(out)


def test_gradescope_gets_nothing_of_a_hidden_check_but_its_rationale(
    root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its results are made on its own machine, from a report that contains the secret."""
    write_hidden(root / "hidden")
    hand_in(tmp_path, "submission", RIGHT.replace("return 4 * x", "return 5 * x"))
    settings = {"chapters": [90], "given": [], "points": {"B90.1": 4, "90.1": 2}, "extra": []}
    settings |= {"earlier": {}, "seed": "1", "deadline": None, "unsafe": not WALLS}
    (root / "assignment.json").write_text(json.dumps(settings), encoding="utf-8")
    report = grade_one(tmp_path, root)
    secrets = [c.secret for r in report.results for c in r.checks if c.status == "failed"]
    assert any(secret and "secret expectation" in str(secret.message) for secret in secrets)
    main(tmp_path, root)
    said = capsys.readouterr()
    assert "Quadruple must hold for large numbers." in said.out
    assert "secret" not in said.out + said.err
    assert "1234" not in said.out + said.err


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
        (
            "test_x.py",
            HIDDEN.replace("import pytest\n", "import pytest\nfrom judging import praise\n"),
            "cannot be run: (?s:.*)cannot import name .praise. from",
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
    (root / "tests/shared").mkdir(exist_ok=True)
    (root / "tests/shared/judging.py").touch()
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
    fixture = "\n\n@pytest.fixture(autouse=True)\ndef odd():\n    raise OSError('secret fault')\n"
    write_hidden(tmp_path / "hidden", HIDDEN + fixture)
    monkeypatch.setattr(cohort, "check_hidden", lambda _: None)
    out = tmp_path / "out"
    assert grade(submissions, out, root, hidden=tmp_path / "hidden") == 1
    assert scores(out) == {"ann": None, "bob": None, "cem": None}
    assert "the grader failed on this check" in everything_in(out / "feedback")
    assert "secret" not in for_students(out)
    assert "secret fault" in everything_in(out / "results")


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
    write_hidden(tmp_path / "hidden", probes=HIDDEN_PROBES + '    "secret of a probe"\n')
    hand_in(
        submissions, "eve", SPY if when == "in a function" else f"{SPY}\nprint(found())\n1 / 0\n"
    )
    out = tmp_path / "out"
    grade(submissions, out, root, hidden=tmp_path / "hidden")
    assert scores(out)["ann"] == 6.0  # her hidden checks can use their probes
    pages = unescape(for_students(out))
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
        names = [[c["name"] for c in r["checks"]] for r in one["results"]]
        assert names == [[c["name"] for c in r["checks"]] for r in other["results"]]
        assert sum(name.startswith("hidden check") for of in names for name in of) == 3
