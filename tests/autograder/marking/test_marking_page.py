"""The page for marking in a real browser: keys, saving, and two pages at a time."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import browser as browsers
from autograder.manifest import ROOT
from graded import SHOUT
from served import marking

STUB = (ROOT / "chapters/ch02_vectors/answers.md").read_text(encoding="utf-8")
PLACE = "_Write your answer here._"
STUDENTS = ["ann", "bob", "cem", "dan", "eve"]

browser = pytest.fixture(browsers.browser, scope="module")


@pytest.fixture(scope="module")
def submissions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("class")
    for student in STUDENTS:
        (folder / student / "ch02_vectors").mkdir(parents=True)
        answer = f"The answer of somebody: {SHOUT}" if student != "eve" else PLACE
        text = STUB.replace(PLACE, answer)
        (folder / student / "ch02_vectors/answers.md").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def address(submissions: Path) -> Iterator[str]:
    with marking(submissions, "2") as address:
        yield address


@pytest.fixture(autouse=True)
def folder(submissions: Path) -> Path:
    """The folder of the class, without a mark: the server reads the file whenever it is asked."""
    (submissions / "marks.csv").unlink(missing_ok=True)
    return submissions


class Page:
    def __init__(self, browser: Any, address: str, **options: Any) -> None:
        # Playwright's waiting needs eval, and axe is a script.
        self.tab = browser.new_page(bypass_csp=True, **options)
        self.tab.set_default_timeout(10_000.0)
        self.errors: list[str] = []
        self.hosts: set[str | None] = set()
        self.tab.on("pageerror", lambda error: self.errors.append(str(error)))
        self.tab.on("request", lambda request: self.hosts.add(urlsplit(request.url).hostname))
        self.tab.goto(address)
        self.wait("which", "Answer ")

    def text(self, name: str) -> str:
        return str(self.tab.inner_text(f"#{name}"))

    def wait(self, name: str, words: str) -> None:
        script = "([id, words]) => document.getElementById(id).textContent.includes(words)"
        self.tab.wait_for_function(script, arg=[name, words])

    def press(self, *keys: str) -> None:
        for key in keys:
            self.tab.keyboard.press(key)

    def saves(self, folder: Path, *rows: tuple[str, str, str]) -> None:
        """Wait until marks.csv holds these rows: a page saves while its reader goes on."""
        for _ in range(200):
            if marks_in(folder) == [*rows]:
                return
            self.tab.wait_for_timeout(25)
        assert marks_in(folder) == [*rows]

    def close(self) -> None:
        assert self.errors == []
        assert self.hosts <= {"127.0.0.1", None}
        self.tab.close()


@pytest.fixture
def page(browser: Any, address: str) -> Iterator[Page]:
    page = Page(browser, address)
    yield page
    page.close()


def marks_in(folder: Path) -> list[tuple[str, str, str]]:
    """Return exercise, points and comment of each row."""
    if not (folder / "marks.csv").exists():
        return []
    with (folder / "marks.csv").open(encoding="utf-8", newline="") as file:
        return [(row[1], row[2], row[3]) for row in [*csv.reader(file)][1:]]


def test_the_keyboard_is_enough_and_every_change_is_saved(page: Page, folder: Path) -> None:
    assert page.text("progress") == "0 of 5 marked"
    assert SHOUT in page.text("text"), "what students write is shown as text"
    page.press("1")
    page.wait("status", "Saved: 1 of 1.")
    assert marks_in(folder) == [("2.2b", "1", "")]
    page.press("c")
    page.tab.keyboard.type("Say why, 0 is not enough.\nj")
    page.press("Escape")
    first = ("2.2b", "1", "Say why, 0 is not enough.\nj")
    page.saves(folder, first)
    page.wait("bank", "j")
    page.press("j", "h")
    page.wait("which", "Answer 2 of 5")
    page.wait("status", "Saved: 0.5 of 1.")
    page.press("Shift+Digit1", "Shift+Digit2", "Shift+Digit1")
    page.wait("progress", "2 of 5 marked")
    page.tab.wait_for_function("document.querySelector('#comment').value === 'j'")
    page.press("k")
    page.wait("which", "Answer 1 of 5")
    page.press("n")
    page.wait("which", "Answer 3 of 5")
    assert page.tab.evaluate("document.activeElement.id") == "which"
    page.saves(folder, first, ("2.2b", "0.5", "j"))
    page.press("k", "x")
    page.wait("progress", "1 of 5 marked")
    assert len(marks_in(folder)) == 1
    page.press("0")
    page.wait("status", "Saved: 0 of 1.")
    page.press("n", "1", "n", "1", "n")
    page.wait("which", "Answer 5 of 5")
    assert page.text("text") == "Nothing was written here."
    page.press("0", "n")
    page.wait("title", "2.3 A vector times itself")
    rest = [("2.2b", points, "") for points in ("0", "1", "1", "0")]
    page.saves(folder, first, *rest)
    page.press("?")
    page.tab.wait_for_selector("#keys[open]")
    page.tab.uncheck("#single")
    page.press("Escape", "1")
    page.wait("status", "no mark yet")
    assert len(marks_in(folder)) == 5, "the keys can be turned off"


def test_it_resumes(page: Page, browser: Any, address: str) -> None:
    page.press("1")
    page.wait("status", "Saved")
    other = Page(browser, address)
    assert other.text("which") == "Answer 2 of 5"
    other.close()
    page.tab.reload()
    page.wait("progress", "1 of 5 marked")
    assert page.text("which") == "Answer 1 of 5"
    assert page.tab.is_checked("#points input >> nth=2")


def test_a_mark_that_was_changed_in_the_file_is_not_overwritten(page: Page, folder: Path) -> None:
    def change(before: str, after: str) -> None:
        text = (folder / "marks.csv").read_text(encoding="utf-8")
        (folder / "marks.csv").write_text(text.replace(before, after), encoding="utf-8")

    page.press("1")
    page.wait("status", "Saved")
    change(",1,", ",0,Why?")
    page.tab.check("#points input >> nth=1")
    page.wait("trouble", "This mark has been changed in marks.csv. It gives 0 points. Why?")
    assert marks_in(folder) == [("2.2b", "0", "Why?")]
    page.tab.click("text=Try again")
    page.wait("status", "Saved: 0.5 of 1.")
    change(",0.5,", ",1,")
    page.press("0")
    page.wait("trouble", "It gives 1 points.")
    page.tab.click("text=Keep what is in the file")
    assert page.tab.is_checked("#points input >> nth=2")
    assert marks_in(folder) == [("2.2b", "1", "")]


def test_what_cannot_be_saved_is_said_and_kept(page: Page, folder: Path) -> None:
    page.press("c")
    page.tab.keyboard.type("No points yet.")
    page.press("Escape", "j")
    page.wait("trouble", "Answer 1 of question 2.2b is not saved.")
    assert marks_in(folder) == []
    page.tab.click("text=Go back to it")
    page.wait("which", "Answer 1 of 5")
    assert page.tab.input_value("#comment") == "No points yet."
    (folder / "marks.csv").write_text("oops\n", encoding="utf-8")
    page.press("Escape", "1")
    page.wait("trouble", "got 'oops'")
    (folder / "marks.csv").unlink()
    page.tab.click("text=Try again")
    page.wait("status", "Saved: 1 of 1.")
    assert marks_in(folder) == [("2.2b", "1", "No points yet.")]


def test_it_is_accessible_and_fits(browser: Any, address: str) -> None:
    from axe_playwright_python.sync_playwright import Axe

    for width, scheme in ((360, "light"), (1280, "light"), (360, "dark"), (1280, "dark")):
        size = {"width": width, "height": 900}
        page = Page(browser, address, viewport=size, color_scheme=scheme)
        page.press("1", "c")
        page.tab.keyboard.type("A line of a comment.")
        page.wait("bank", "A line")
        for opened in ("", "?") if width == 360 else ("",):
            page.press("Escape", *opened)
            found = Axe().run(page.tab).response["violations"]
            assert found == [], [(v["id"], v["nodes"][0]["html"]) for v in found]
            assert page.tab.evaluate("document.documentElement.scrollWidth") <= width
        page.close()
