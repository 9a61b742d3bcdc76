"""The class at a glance: discrimination, scores and mistakes."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import stats

import browser as browsers
from autograder.analysis.class_page import write_class_page
from autograder.analysis.common_mistakes import misconceptions, mistakes_of
from autograder.analysis.discrimination import discrimination
from autograder.checks.verdict import Verdict
from autograder.message import Kind, Message
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.report import StudentReport
from graded import CHAPTERS, SHOUT, check, class_of, failed_run, hostile, report_of, with_exercise

browser = pytest.fixture(browsers.browser, scope="module")
LEFT = Message(wanted="1", likely="Remove os._exit.", kind=Kind.LEFT)
SQUARED = "This is the squared length. Take its square root."


@pytest.mark.parametrize("all_or_nothing", [True, False])
def test_discrimination_is_the_correlation_with_the_rest(all_or_nothing: bool) -> None:
    rng = np.random.default_rng(3)
    rest = rng.normal(30.0, 8.0, 24)
    own = rest / 10.0 + rng.normal(0.0, 1.0, 24)
    if all_or_nothing:
        own = np.where(own > np.median(own), 4.0, 0.0)
        wanted = stats.pointbiserialr(own > 0.0, rest).statistic
    else:
        wanted = stats.pearsonr(own, rest).statistic
    found = discrimination(own.tolist(), rest.tolist())
    assert found.value == pytest.approx(wanted, abs=1e-12)
    interval = stats.pearsonr(own, rest).confidence_interval(0.95)
    assert found.interval == pytest.approx([*interval], abs=1e-9)
    assert not found.is_low
    against = discrimination((-own).tolist(), rest.tolist())
    assert against.value == pytest.approx(-wanted, abs=1e-12)
    assert against.is_low


@pytest.mark.parametrize(
    ("own", "rest", "reason"),
    [
        ([0.0, 1.0] * 9 + [1.0], range(19), "19 students, which is fewer than the 20 needed"),
        ([1.0] * 20, range(20), "no students have a different score than most"),
        ([0.0] * 2 + [1.0] * 18, range(20), "2 students have a different score than most"),
        ([0.0, 1.0] * 10, [5.0] * 20, "all students have the same score on the other exercises"),
    ],
)
def test_discrimination_is_refused_with_a_reason(own: Any, rest: Any, reason: str) -> None:
    found = discrimination(own, [*map(float, rest)])
    assert (found.value, found.reason) == (None, reason)
    assert not found.is_low


def wrong(likely: str, read: str = "", **changes: Any) -> Verdict:
    return check("test_angle", "failed", Message(wanted="1", likely=likely, read=read), **changes)


def with_lost(student: str, *lost: Verdict) -> StudentReport:
    return with_exercise(report_of(student), 1, checks=[*lost])


def test_each_student_counts_once_for_each_mistake() -> None:
    reports = [
        with_lost("ann", wrong(SQUARED, "book 2.1.4"), wrong(SQUARED), wrong("Solve 1 x = -2.5.")),
        with_lost("bob", wrong("Solve 7 x = 1e-3."), wrong("Raise TypeError.", robust=True)),
        with_lost("cem", wrong("Solve 7 x = 3."), wrong("Raise TypeError.", robust=True)),
        with_lost("dan", wrong(SQUARED, hidden=True), wrong("")),
        with_lost("eve", replace(wrong(SQUARED), status="blocked")),
        with_lost("fay", check("test_angle", "failed", Message(likely="x", kind=Kind.UNWRITTEN))),
        *(with_lost(name, check("test_it", "failed", LEFT)) for name in "ghij"),
    ]
    found, unexplained = mistakes_of(reports)
    counted = {one.words: len(one.students) for one in found}
    assert [*counted.values()] == [4, 3, 2, 1]
    assert counted["Remove os._exit."] == 4, "a mistake, but not a wrong result"
    assert counted["Raise TypeError."] == 2
    assert counted[SQUARED] == 1
    assert unexplained == 2
    assert [(len(one.students), [*one.exercises]) for one in misconceptions(found)] == [
        (3, ["2.2"])
    ]


def class_of_twenty() -> list[StudentReport]:
    """Ten students earn more than the others in 2.2, and eight of these earn nothing in B2.1."""
    reports = []
    for number in range(20):
        angles, copy = (4.0 if number < 10 else 1.0), (0.0 if 2 <= number < 10 else 2.0)
        lost = [] if number < 10 else [wrong(SQUARED, "book 2.1.4")]
        report = report_of(f"student {number:02}", score_on_given=angles + copy + 5.0)
        report = with_exercise(report, 0, score_on_given=copy)
        checks = [check("test_right_angle", "passed"), *lost]
        report = with_exercise(report, 1, score_on_given=angles, checks=checks)
        reports.append(report)
    return reports


def rows_of(path: Path) -> dict[str, list[str]]:
    """Return the cells of each row of a page as text, keyed by the first one."""
    rows = {}
    for row in re.split(r"<tr[^>]*>", path.read_text(encoding="utf-8"))[1:]:
        cells = re.findall(r"(?s)<t[hd][^>]*>(.*?)</t[hd]>", row)
        texts = [" ".join(re.sub(r"<[^>]*>", " ", cell).split()) for cell in cells]
        rows[texts[0]] = texts[1:]
    return rows


def test_the_page_shows_the_class_without_names(tmp_path: Path) -> None:
    reports = class_of_twenty()
    path = write_class_page(tmp_path, CHAPTERS, reports)
    rows = rows_of(path)
    angles = [4.0] * 10 + [1.0] * 10
    copies = [2.0] * 2 + [0.0] * 8 + [2.0] * 10
    r = np.corrcoef(angles, np.add(copies, 5.0))[0, 1]
    low, high = stats.pearsonr(angles, copies).confidence_interval(0.95)
    shown = f"{r:.2f} ({low:.2f} to {high:.2f}) ▼ low".replace("-", "−")  # noqa: RUF001
    assert rows["2.2 Angles"] == ["", "10", "10", "0", "62 %", shown]
    assert rows["B2.1 Copy"] == ["", "12", "0", "8", "60 %", shown]
    nobody = "none: no students have a different score than most"
    assert rows["B3.1 Mass"] == ["", "20", "0", "0", "100 %", nobody]
    assert rows["2.3 Why"][:5] == ["", "0", "0", "0", "–"]  # noqa: RUF001
    read = "book 2.1.4; lesson of chapter 2, at 2.2"
    assert rows[SQUARED] == ["10", "50 %", "2.2", read]
    assert rows["right angle"] == ["", "20 passed"]
    assert rows["angle"] == ["", "10 failed"]
    assert "student 0" not in path.read_text(encoding="utf-8")
    small = write_class_page(tmp_path, CHAPTERS, reports[:19]).read_text(encoding="utf-8")
    assert "19 students are too few. At least 20 are needed" in small
    assert '<th scope="col">Discrimination' not in small


@pytest.mark.slow
def test_the_pages_are_accessible_and_fit(browser: Any, tmp_path: Path) -> None:
    from axe_playwright_python.sync_playwright import Axe

    everybody = [*class_of_twenty(), failed_run(), report_of()]
    index = write_index(tmp_path, CHAPTERS, everybody, class_of())
    page = write_feedback(tmp_path, report_of())
    narrow, wide = (360, "dark"), (1280, "light")
    for path, size in (
        *((path, size) for path in (page, index) for size in (narrow, wide)),
        (write_class_page(tmp_path, CHAPTERS, [*everybody, hostile()]), narrow),
    ):
        assert SHOUT not in path.read_text(encoding="utf-8")
        viewport = {"width": size[0], "height": 900}
        tab = browser.new_page(viewport=viewport, color_scheme=size[1], bypass_csp=True)
        tab.goto(path.as_uri())
        found = Axe().run(tab).response["violations"]
        assert found == [], [(v["id"], v["nodes"][0]["html"]) for v in found]
        assert tab.evaluate("document.documentElement.scrollWidth") <= size[0]
        tab.close()
