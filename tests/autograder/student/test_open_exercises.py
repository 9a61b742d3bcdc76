"""Open exercises are put on a chart: cost in counted work, error against truth, nobody's secret."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.checks.runner import run_checks
from autograder.checks.verdict import Point
from autograder.manifest import ROOT, Chapter, load_chapter, load_chapters
from autograder.reports.chart import draw_chart, front
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.gradescope import gradescope_results
from autograder.reports.report import StudentReport
from autograder.scores import results_of
from graded import CHAPTERS, SHOUT, check, class_of, report_of, with_exercise
from small import MANIFEST, RIGHT, hand_in
from small_class import grade, results
from walls import behind_walls

AXES = ["evaluations", "error of the result"]
SVG = '<svg class="scatter"'
# The second exercise of the invented class is an open one.
OPEN_CHAPTERS = [
    replace(c, exercises=[replace(e, chart=AXES if e.id == "2.2" else []) for e in c.exercises])
    for c in CHAPTERS
]
OPEN = MANIFEST.replace('hints = ["twice"]', f'chart = {AXES}\nhints = ["twice"]')
CHECK = """
import pytest
from ch90_small import small


@pytest.mark.exercise("B90.1")
def test_double(on_chart):
    asked = 0

    def ask():
        nonlocal asked
        asked += 1
        return 3.0

    got = small.double(ask)
    on_chart(asked, abs(got - 6.0) / 6.0)
    assert abs(got - 6.0) < 0.5


@pytest.mark.exercise("90.1")
def test_quadruple():
    assert small.quadruple(3) == 12
"""
HIDDEN = """
import pytest


@pytest.mark.exercise("90.1")
def test_more(on_chart):
    \"\"\"A hidden one.\"\"\"
    on_chart(17.0, 0.125)
"""
ASKS = {
    "ann": "def double(ask):\n    return ask() + ask() + 0.25\n",
    "bob": "def double(ask):\n    return ask() + 2.0\n",
    "cai": "def double(ask):\n    return 6.0 + 0 * ask()\n",  # no error: no place on such axes
    "eve": "def double(ask):\n    ask()\n    return 1e300\n",
    "dan": "def double(ask):\n    raise ValueError('no')\n",
}
REFERENCE = "def double(ask):\n    return 2.125 * ask()\n"
QUADRUPLE = RIGHT[RIGHT.index("def quadruple") :]


@pytest.fixture
def root(root: Path) -> Path:
    for name, text in (
        ("chapters/ch90_small/chapter.toml", OPEN),
        ("solutions/ch90_small/small.py", REFERENCE + QUADRUPLE),
        ("tests/ch90_small/test_small.py", CHECK),
    ):
        (root / name).write_text(text, encoding="utf-8")
    return root


def test_a_class_is_on_the_chart_with_the_reference_and_hidden_checks_put_nobody_there(
    root: Path, tmp_path: Path
) -> None:
    for student, code in ASKS.items():
        hand_in(tmp_path / "class", student, code + QUADRUPLE)
    hidden = tmp_path / "hidden/ch90_small"
    hidden.mkdir(parents=True)
    (hidden / "test_more.py").write_text(HIDDEN, encoding="utf-8")
    out = tmp_path / "out"
    grade(tmp_path / "class", out, root, hidden=tmp_path / "hidden")

    def places(student: str) -> list[Any]:
        return [
            (*(check["on_chart"] for check in one["checks"] if "on_chart" in check), ours)
            for one in results(out)[student]["results"]
            if (ours := one.get("reference"))
        ]

    assert places("ann") == [([2.0, 0.25 / 6.0], [1.0, 0.375 / 6.0])]
    assert places("bob")[0][0] == [1.0, 1.0 / 6.0]
    assert places("cai") == places("dan") == places("eve") == []
    index = (out / "index.html").read_text(encoding="utf-8")
    assert len(dots(index, "link")) == 2
    assert index.count("<bdi>ann</bdi>") == 2, "among all, and beside the chart"
    assert index.count("<bdi>cai</bdi>") == 1
    feedback = (out / "feedback/ann.html").read_text(encoding="utf-8")
    assert "Your work: 2 evaluations, error of the result: 0.042." in feedback
    assert len(dots(feedback, "link")) == len(dots(feedback, "good")) == 1
    assert "bob" not in feedback
    assert SVG not in (out / "feedback/dan.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "chapter", [c for c in load_chapters() if any(e.chart for e in c.exercises)]
)
def test_the_reference_is_on_the_chart_of_every_open_exercise(chapter: Chapter) -> None:
    wanted = [exercise.id for exercise in chapter.exercises if exercise.chart]
    engine = [ROOT / "solutions", ROOT / "chapters"]
    verdicts = run_checks(chapter, engine, seed="1", exercises=wanted)
    placed = {result.exercise.id for result in results_of(chapter, verdicts) if result.on_chart}
    assert placed == set(wanted)


def charted(student: str, own: Point) -> StudentReport:
    exercise = replace(report_of().results[1].exercise, chart=AXES)
    checks = [replace(check("test_it", "passed"), on_chart=own)]
    return with_exercise(report_of(student), 1, exercise=exercise, checks=checks)


def shown(folder: Path, *reports: StudentReport) -> str:
    return write_index(folder, OPEN_CHAPTERS, [*reports], class_of()).read_text(encoding="utf-8")


def test_names_on_a_chart_are_text_and_gradescope_says_the_place_in_words(tmp_path: Path) -> None:
    report, nobody = charted(SHOUT, (100.0, 0.01)), report_of("ada")
    page = shown(tmp_path, report)
    assert "<script>" not in page
    assert page.count("&lt;script&gt;") >= 2
    told = gradescope_results(report)["tests"][1]["output"]
    assert "your work: 100 evaluations, error of the result: 0.01" in told
    assert SVG not in write_feedback(tmp_path, nobody).read_text(encoding="utf-8")
    assert "Speed against accuracy" not in shown(tmp_path, nobody)


def dots(svg: str, shape: str) -> list[tuple[float, float]]:
    """Return the positions of the dots in a chart by their color: link, or good for ours."""
    uses = re.findall(r'<use xlink:href="#\w+" x="([^"]*)" y="([^"]*)" style="([^"]*)"', svg)
    return [(float(x), float(y)) for x, y, style in uses if f"stroke: var(--{shape})" in style]


def test_a_dot_lies_where_its_logarithms_say() -> None:
    svg = draw_chart(AXES, [(100.0, 1e-2), (1000.0, 1e-6)], (300.0, 1e-4), "the chart")
    (first, second), (ours,) = dots(svg, "link"), dots(svg, "good")
    across = (ours[0] - first[0]) / (second[0] - first[0])
    assert across == pytest.approx(0.4771, abs=1e-3)  # the logarithm of 3
    assert ours[1] == pytest.approx((first[1] + second[1]) / 2.0, abs=0.1)
    assert first[1] < second[1], "a smaller error is lower"
    assert 'role="img" aria-label="the chart"' in svg


SIZES = st.floats(1e-20, 1e20)


@given(st.lists(st.tuples(SIZES, SIZES), min_size=1, max_size=12))
def test_the_front_is_what_no_other_beats(points: list[tuple[float, float]]) -> None:
    beaten = [p for p in points if any(q != p and q[0] <= p[0] and q[1] <= p[1] for q in points)]
    assert front(points) == sorted(p for p in {*points} if p not in beaten)


def test_a_step_that_lets_no_frame_pass_earns_nothing(tmp_path: Path) -> None:
    """The loop of frames runs beside the student's code, which may end it before it begins."""
    folder = tmp_path / "ch06_springs"
    folder.mkdir()
    forged = "import builtins\n\nbuiltins.range = lambda *_: []\n\n\ndef my_step(*_):\n    pass\n"
    (folder / "own_step.py").write_text(forged, encoding="utf-8")
    engine = [tmp_path, ROOT / "solutions", ROOT / "chapters"]
    chapter = load_chapter(ROOT / "chapters/ch06_springs")
    verdicts = run_checks(chapter, engine, seed="1", exercises=["G6.3"], sandbox=behind_walls())
    assert [verdict.status for verdict in verdicts] == ["failed"] * 4
    assert all(verdict.on_chart is None for verdict in verdicts)
