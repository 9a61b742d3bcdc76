"""The pages: what they say and keep to themselves, sound HTML, and a look with a real browser."""

from __future__ import annotations

import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import pytest

import browser as browsers
from autograder.manifest import ROOT
from autograder.message import Kind, Message
from autograder.reports.feedback import write_feedback, write_index
from autograder.reports.marks import Mark, apply_marks
from autograder.reports.report import StudentReport
from autograder.submissions.class_list import ClassList, Member
from graded import (
    CHAPTERS,
    NASTY,
    SHOUT,
    blocked,
    cause_of,
    check,
    class_of,
    failed_run,
    hostile,
    nothing_done,
    report_of,
    with_exercise,
    with_words,
)

browser = pytest.fixture(browsers.browser, scope="module")
VOID = {"meta", "br", "img", "link", "input", "hr"}
MARKED = apply_marks(report_of("cleo"), {("cleo", "2.3"): Mark(2.5, "Say why.")})
CLASS = [report_of(), MARKED, nothing_done(), failed_run(), hostile(), blocked()]


class Page(HTMLParser):
    """What a page consists of; its elements must be nested and closed as they are opened."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.pieces: list[tuple[str, str]] = []  # the element that a text stands in, and the text
        self.tables: list[list[str]] = []
        self.rows: list[list[str]] = []
        self.feed(text)
        self.close()
        assert self.open == [], "every element is closed"
        self.rows = [[" ".join(cell.split()) for cell in row] for row in self.rows]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert len(dict(attrs)) == len(attrs), "no attribute stands twice"
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)
        if tag == "table":
            self.tables.append([])
        elif self.tables:
            self.tables[-1].append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "style" in self.open:
            return
        self.pieces.append((self.open[-1] if self.open else "", data))
        if "td" in self.open or "th" in self.open:
            self.rows[-1][-1] += data

    @property
    def text(self) -> str:
        return " ".join("".join(data for _, data in self.pieces).split())

    def row(self, start: str) -> list[str]:
        (found,) = [row for row in self.rows if row[0].startswith(start)]
        return found


def student_page(tmp_path: Path, report: StudentReport) -> Page:
    return Page(write_feedback(tmp_path, report).read_text(encoding="utf-8"))


def index_page(tmp_path: Path, *reports: StudentReport) -> Page:
    return Page(write_index(tmp_path, CHAPTERS, reports, class_of()).read_text(encoding="utf-8"))


@pytest.fixture(params=[*range(len(CLASS)), "index", "index of one", "index of errors"], ids=str)
def page(request: pytest.FixtureRequest, tmp_path: Path) -> Page:
    """Each page in turn, hostile ones among them."""
    if isinstance(request.param, int):
        return student_page(tmp_path, CLASS[request.param])
    classes = {"index": CLASS, "index of one": [report_of()], "index of errors": [failed_run()]}
    return index_page(tmp_path, *classes[request.param])


def test_a_page_links_to_places_that_are_there_and_every_table_is_named(page: Page) -> None:
    ids = [attributes["id"] for _, attributes in page.tags if "id" in attributes]
    assert len(ids) == len(set(ids))
    links = {a["href"] or "" for tag, a in page.tags if tag == "a"}
    assert {link.removeprefix("#") for link in links if link.startswith("#")} <= {*ids}
    assert page.tables
    assert all(table[0] == "caption" for table in page.tables)


def test_a_page_loads_nothing_and_runs_nothing(page: Page) -> None:
    tags = {tag for tag, _ in page.tags}
    assert tags.isdisjoint({"script", "img", "link", "iframe", "object", "form", "base", "b"})
    for _, attributes in page.tags:
        assert not any(name.startswith("on") or name == "src" for name in attributes)
        href = attributes.get("href") or "#"
        assert href.startswith(("#", "feedback/", "class.html")), href
    style = (ROOT / "autograder/reports/templates/style.css").read_text(encoding="utf-8")
    assert "url(" not in style
    assert "@import" not in style


def test_hostile_text_is_shown_as_text(tmp_path: Path) -> None:
    page = student_page(tmp_path, hostile())
    assert page.text.count(SHOUT) > 5
    assert "red" in page.text
    assert {c for _, piece in page.pieces for c in piece if ord(c) < 32 or ord(c) == 127} == {"\n"}
    assert not re.search("[\x80-\x9f\ud800-\udfff\u202a-\u202e]", page.text)
    assert len(page.text) < 100_000, "what is too long is cut"


HALF_LOST = [check(f"test_{name}", "failed", "vector.py cannot be read") for name in ("one", "two")]
BUILDS = replace(cause_of(), assignment="", blocks=["2.1", "2.2", "2.3"])
THREE = "B2.0 fails. Fix it first, because 2.1, 2.2 and 2.3 build on it."
UNWRITTEN = Message("not written yet: Angles", kind=Kind.UNWRITTEN)
NOTE = "Notes on what was handed in two folders: the first was taken"
PAGES = {
    "scores and what they mean": (
        report_of(),
        [
            "Feedback for ada",
            "Score 3 of 11 from checks",
            "The other 3 points are given by hand.",
            "Score on given chapters 8 of 11",
            "Mistakes in earlier chapters have cost you 5 points.",
            "3 points wait for a person and are not part of any score: 2.3.",
            "Fix 2.2, Angles first",
            "on given chapters 5",
            "1 of 3 checks pass: right angle.",
            "✗ failed: angle got 1 wanted 2",
            "hidden check Angles turn once round.",
        ],
        ["Notes on what was handed in", "far away", "secret"],
    ),
    "nothing done": (
        nothing_done(),
        ["Score 0 of 11", "no mistake in an earlier chapter has cost you points"],
        [],
    ),
    "an earlier assignment": (
        blocked(),
        [
            "Your exercises B2.0 of lab1 fails. Fix it first, because 2.2 builds on it.",
            "Title of B2.0 ✗ failed from lab1 needed for 2.2 ✗ failed: one B2.0 is wrong",
            "B2.00 Title of B2.00 ⊘ blocked",
        ],
        [],
    ),
    "three that build on it": (
        report_of(causes=[BUILDS], notes=["two folders: the first was taken"]),
        [THREE, NOTE],
        [],
    ),
    "an earlier chapter first": (  # nothing is wrong in the exercise of the earlier assignment
        replace(blocked(), causes=[cause_of("B2.0", "inherited")]),
        ["Nothing is wrong in these exercises. Fix chapter 2"],
        [],
    ),
    "one message for two checks": (
        with_exercise(report_of(), 1, checks=HALF_LOST),
        ["✗ failed: one ; two vector.py cannot be read 2.3"],
        [],
    ),
    "missing code": (
        with_exercise(report_of(), 1, checks=[check("test_angle", "failed", UNWRITTEN)]),
        ["○ not written yet its code is still missing", "○ not written yet: angle"],
        ["✗ failed", "a check found a mistake"],
    ),
    "a mark": (MARKED, ["Say why.", "Every written answer is marked."], []),
    "an error of the grader": (
        failed_run(),
        ["Error of the grader, retry.", "Score none yet, of 11", "the disk is full"],
        [],
    ),
}


@pytest.mark.parametrize(("report", "shown", "absent"), PAGES.values(), ids=PAGES.keys())
def test_a_page_says_what_a_student_has_to_know(
    tmp_path: Path, report: StudentReport, shown: list[str], absent: list[str]
) -> None:
    text = student_page(tmp_path, report).text.replace(";", " ;").replace("  ;", " ;")
    assert [words for words in shown if words not in text] == []
    assert [words for words in absent if words in text] == []


def test_a_student_sees_the_state_of_each_exercise(tmp_path: Path) -> None:
    page = student_page(tmp_path, report_of())
    assert page.row("B2.1")[1:] == ["✓ passed", "physics 2 of 2", "2 of 2"]
    assert page.row("2.2")[1:] == ["✗ failed", "physics 1 of 3", "1 of 4"]
    assert page.row("2.3")[1:] == ["… waiting", "", "none yet, of 3"]
    assert page.row("B3.1")[1:] == ["↑ inherited", "physics 0 of 1", "0 of 5"]
    lines = [piece for element, piece in page.pieces if "wanted" in piece and element == "span"]
    assert lines == ["wanted    2\n"], "lines stay lines, with no style as well"
    assert student_page(tmp_path, MARKED).row("2.3")[1:] == ["✎ marked", "", "2.5 of 3"]
    error = student_page(tmp_path, failed_run())
    assert error.row("B3.1")[1:] == ["! error", "physics 0 of 1", "none yet, of 5"]


def test_the_index_says_which_earlier_exercise_to_fix(tmp_path: Path) -> None:
    page = student_page(tmp_path, blocked())
    assert ("a", {"href": "#exercise-6"}) in page.tags
    assert ("div", {"class": "exercise", "id": "exercise-6"}) in page.tags
    index = index_page(tmp_path, blocked(), report_of())
    assert ["B2.0 Title of B2.0", "lab1", "1 of 2", "2.2"] in index.rows
    assert "B2.00" not in index.text, "it is blocked itself"


def test_every_student_is_linked_to_a_page_that_is_there(tmp_path: Path) -> None:
    students = ["ada", "50% #1?", "../up", "Åsa B", "a&b", "javascript:x", SHOUT, NASTY]
    reports = [report_of(student) for student in students]
    pages = {write_feedback(tmp_path, report) for report in reports}
    index = index_page(tmp_path, *reports)
    links = [a["href"] or "" for tag, a in index.tags if tag == "a"]
    links.remove("class.html")  # which another module writes
    linked = {tmp_path / unquote(urlsplit(link).path) for link in links if not link.startswith("#")}
    assert linked == pages
    assert len(pages) == len(students)
    assert all(page.is_file() and page.parent == tmp_path / "feedback" for page in pages)


def test_the_index_counts_who_passes_of_those_who_could_be_graded(tmp_path: Path) -> None:
    index = index_page(tmp_path, report_of(), MARKED, nothing_done(), failed_run())
    rates = {row[0].split()[0]: row[1:] for row in index.rows if len(row) in (3, 4)}
    assert rates["B2.1"] == ["3 of 4", "75 %", "1.5 of 2"]
    assert rates["2.2"] == ["0 of 4", "0 %", "0.75 of 4"]
    assert rates["2.3"] == ["1 of 4 marked by a person", "2.5 of 3"]
    assert rates["B3.1"] == ["0 of 3", "0 %", "0 of 5"]
    for words in ("Median score 3 of 11", "Seed 7", "Isolation none: an ordinary process"):
        assert words in index.text
    assert "1 of 4 students could not be graded in full" in index.text
    assert index.row("eve")[1:] == ["! error, retry", "–", "–", "–", "3"]  # noqa: RUF001
    assert index.row("eli")[1:] == ["✓ graded", "0", "0", "–", "3"]  # noqa: RUF001
    assert "with extra credit" not in index.text
    index = index_page(tmp_path, replace(report_of(), score=12.0))
    assert "Median score 12 of 11, with extra credit" in index.text, "which the points leave out"


def test_the_index_names_the_most_missed_first_and_the_check_that_is_lost(tmp_path: Path) -> None:
    index = index_page(tmp_path, report_of(), MARKED)
    missed = [row for row in index.rows if len(row) == 3 and row[1] == "0 of 2"]
    assert missed == [["B3.1 Mass", "0 of 2", "mass"], ["2.2 Angles", "0 of 2", "angle"]]
    report = report_of(results=report_of().results[:1])
    assert "everybody passes every exercise that was graded" in index_page(tmp_path, report).text


def test_the_histogram_and_its_table_count_every_score_once(tmp_path: Path) -> None:
    scores = [0.0, 1.09, 1.1, 5.5, 10.9, 11.0]
    reports = [report_of(f"s{score}", score=score) for score in scores]
    index = index_page(tmp_path, *reports, failed_run())
    table = {row[0]: row[1] for row in index.rows if re.fullmatch(r"\d+ to \d+", row[0])}
    assert list(table.values()) == ["2", "1", "0", "0", "0", "1", "0", "0", "0", "2"]
    heights = [float(a["height"] or 0) for t, a in index.tags if t == "rect" and "x" in a]
    assert [height / max(heights) * 2 for height in heights] == [float(n) for n in table.values()]
    (svg,) = [a for tag, a in index.tags if tag == "svg" and a.get("role") == "img"]
    assert svg["aria-labelledby"] == "histogram-title histogram-desc"
    assert "90 to 100 percent: 2" in index.text


@pytest.mark.slow
def test_a_browser_shows_and_prints_the_pages_and_nothing_leaves(
    browser: Any, tmp_path: Path
) -> None:
    place = "http://127.0.0.1:9/a"
    attack = f"<img src='{place}'><script>document.title = 'owned'</script></pre></title>"
    control = tmp_path / "control.html"
    control.write_text(f"<!DOCTYPE html><title>mine</title><p>{attack}", encoding="utf-8")
    report = with_exercise(with_words(hostile(attack), attack), 2, comment=attack)
    student = write_feedback(tmp_path, report)
    index = write_index(tmp_path, CHAPTERS, [report, report_of()], class_of())
    for path, title, loads in (
        (control, "owned", [place]),  # so the attack is a real one
        (student, f"Feedback for {attack}", []),
        (index, "Grades of the class", []),
    ):
        tab = browser.new_page()
        asked: list[str] = []
        tab.on("request", lambda request, asked=asked: asked.append(request.url))
        tab.goto(path.as_uri())
        assert tab.title() == title
        assert tab.pdf().startswith(b"%PDF-")
        assert asked == [path.as_uri(), *loads]
        tab.close()


def test_names_of_a_roster_are_only_text_on_the_pages_of_the_class(tmp_path: Path) -> None:
    """Also the names of those who handed nothing in, or whom nobody knows."""
    absent = [Member(name, name, None, None) for name in (SHOUT, "=1+1", " @x;-y")]
    people = ClassList([*class_of("=2+2").members, *absent], has_roster=True)
    text = write_index(tmp_path, CHAPTERS, [report_of(SHOUT)], people).read_text(encoding="utf-8")
    assert "owned" in text
    assert "<script" not in text
    assert "<b onclick" not in text
