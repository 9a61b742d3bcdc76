"""Hidden checks of an instructor: they count, and tell students a rationale alone."""

from __future__ import annotations

import json
from collections.abc import Callable
from html import unescape
from pathlib import Path

import pytest

from autograder.grader import cohort
from autograder.isolation.sandbox import Level
from autograder.platforms.grade_one import grade_one, main
from graded import message_of
from small import RIGHT, hand_in
from small_class import SmallClass, everything_in
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


HIDDEN_FILES = {"test_more.py": HIDDEN, "hidden_probes.py": HIDDEN_PROBES}


@pytest.fixture
def for_students(small: SmallClass) -> Callable[[], str]:
    """Returns everything that was written except results/, which is the instructor's."""
    return lambda: "\n".join(
        path.read_text(encoding="utf-8")
        for path in sorted(small.out.rglob("*"))
        if path.is_file() and path.parent != small.out / "results"
    )


def hidden(folder: Path, **files: str) -> Path:
    """Write an instructor's hidden checks and their probes, of which some are others."""
    (folder / "ch90_small").mkdir(parents=True)
    for name, text in (HIDDEN_FILES | files).items():
        (folder / "ch90_small" / name).write_text(text, encoding="utf-8")
    return folder


def test_hidden_checks_count_and_tell_students_a_rationale_alone(
    small: SmallClass, for_students: Callable[[], str]
) -> None:
    small.hand_in("dee", RIGHT.replace("return 4 * x", "while True: pass"))
    small.grade(hidden=hidden(small.place / "hidden"), time_limit=0.7)
    # Exercise 90.1 has 2 points for 4 checks now, and bob passes the one of zero.
    assert small.scores() == {"ann": 6.0, "bob": 4.5, "cem": 6.0, "dee": 4.0}
    (result,) = (r for r in small.results()["bob"]["results"] if r["exercise"]["id"] == "90.1")
    told = {c["name"]: message_of(c) for c in result["checks"] if c.get("hidden")}
    assert told == {
        "hidden check 2": "Quadruple must hold for large numbers.",
        "hidden check 3": "Quadruple must hold for large numbers.",
    }
    assert "secret" not in for_students()
    out = small.out
    assert "1234" not in everything_in(out / "feedback") + everything_in(out / "gradescope")
    assert "secret" not in small.printed(), "the public checks that fail come first"


def test_the_instructor_sees_why_a_hidden_check_fails(
    small: SmallClass, for_students: Callable[[], str]
) -> None:
    small.hand_in("eve", RIGHT.replace("return 4 * x", "return 4 * x if x < 2000 else 0"))
    small.grade(hidden=hidden(small.place / "hidden"))
    report = small.results()["eve"]
    (failed,) = (c for r in report["results"] for c in r["checks"] if c["status"] == "failed")
    assert message_of(failed) == "Quadruple must hold for large numbers."
    assert failed["secret"]["name"] == "test_secret_plan[5678]"
    assert message_of(failed["secret"]).startswith("secret expectation")
    assert "90.1: secret expectation" in small.printed()
    pages = for_students()
    assert "secret" not in pages
    assert "5678" not in pages
    assert "Quadruple must hold for large numbers." in pages
    # A report that is read again, as make grade does for a class, keeps the secret.
    small.grade(hidden=small.place / "hidden")
    assert small.results()["eve"] == report
    assert "secret" not in for_students()


def test_gradescope_gets_nothing_of_a_hidden_check_but_its_rationale(
    root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its results are made on its own machine, from a report that contains the secret."""
    hidden(root / "hidden")
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
    ("old", "new", "complaint"),
    [
        ("4 * secret_value", "5", "plan.1234. fails on the reference itself: secret"),
        ('"90.1"', '"90.9"', "cannot be run: .* belongs to an unknown exercise"),
        (
            "import pytest\n",
            "import pytest\nfrom judging import praise\n",
            "cannot be run: (?s:.*)cannot import name .praise. from",
        ),
        (HIDDEN, "", "there is no check in"),
    ],
)
def test_hidden_checks_that_are_wrong_themselves_stop_the_run_before_it_begins(
    small: SmallClass, old: str, new: str, complaint: str
) -> None:
    (small.root / "tests/shared").mkdir()
    (small.root / "tests/shared/judging.py").touch()
    folder = hidden(small.place / "hidden", **{"test_more.py": HIDDEN.replace(old, new)})
    with pytest.raises(ValueError, match=complaint):
        small.grade(hidden=folder)
    assert not (small.out / "results").exists()


def test_a_hidden_check_that_the_grader_fails_on_tells_nothing_either(
    small: SmallClass, for_students: Callable[[], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    fixture = "\n\n@pytest.fixture(autouse=True)\ndef odd():\n    raise OSError('secret fault')\n"
    folder = hidden(small.place / "hidden", **{"test_more.py": HIDDEN + fixture})
    monkeypatch.setattr(cohort, "check_hidden", lambda _: None)
    assert small.grade(hidden=folder) == 1
    assert small.scores() == {"ann": None, "bob": None, "cem": None}
    assert "the grader failed on this check" in everything_in(small.out / "feedback")
    assert "secret" not in for_students()
    assert "secret fault" in everything_in(small.out / "results")


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


@pytest.mark.parametrize("at_import", ["", "\nprint(found())\n1 / 0\n"])
def test_hidden_probes_are_not_where_public_checks_run(
    at_import: str, small: SmallClass, for_students: Callable[[], str]
) -> None:
    """The spy's public checks show what it found, and its hidden checks must not."""
    probes = HIDDEN_PROBES + '    "secret of a probe"\n'
    small.hand_in("eve", SPY + at_import)
    small.grade(hidden=hidden(small.place / "hidden", **{"hidden_probes.py": probes}))
    assert small.scores()["ann"] == 6.0  # her hidden checks can use their probes
    pages = unescape(for_students())
    assert "secret" not in pages
    assert at_import or "found nothing, []" in pages
