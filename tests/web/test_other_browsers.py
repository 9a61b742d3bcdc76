"""The main path of the site in Firefox and in WebKit. All other tests of pages use Chromium."""

from __future__ import annotations

import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder.manifest import load_chapters
from by_keyboard import Student
from copies import reference
from course_site import Served
from lab.host import Host
from site_page import VECTOR
from webdriver import BROWSERS, Browser
from wrong import read_wrong, write_wrong

CHAPTER = load_chapters()[0]
SOLUTIONS = reference(CHAPTER.name)
SCENE = "spring-bridge"
MINE = f"{SOLUTIONS[VECTOR]}# größer\n"


@pytest.fixture(scope="module", params=BROWSERS)
def browser(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Browser]:
    with BROWSERS[request.param](tmp_path_factory.mktemp("home")) as browser:
        yield browser


@pytest.fixture
def student(browser: Browser, site: Served) -> Iterator[Student]:
    """A new visitor, on whose pages no error may occur."""
    browser.begin()
    student = Student(browser, site)
    yield student
    student.listen()
    assert student.troubles == []


def test_the_start_page_opens_and_is_kept_for_use_offline(student: Student) -> None:
    student.visit("index.html")
    words = student.read("Nothing yet. What you write in the lessons is kept in this browser.")
    for chapter in load_chapters():
        assert chapter.title in words
    student.read("Everything is kept for use without the internet.")


def test_a_wrong_answer_is_explained_and_a_right_one_is_told(
    student: Student, tmp_path: Path
) -> None:
    (wrong,) = (each for each in read_wrong(CHAPTER) if each.mistake == "Forgets the square root.")
    write_wrong(CHAPTER, [wrong], tmp_path)
    student.visit(f"{CHAPTER.name}.html")
    panel = student.turn("B2.2")
    student.write(panel, (tmp_path / VECTOR).read_text(encoding="utf-8"))
    assert student.check(panel).startswith("B2.2: failed")
    assert wrong.says in student.read("likely", f"{panel}.querySelector('.failure')")
    student.write(panel, SOLUTIONS[VECTOR])
    assert student.check(panel).startswith("All checks of B2.2 pass")


def test_the_solutions_of_a_chapter_earn_all_points(student: Student) -> None:
    student.visit(f"{CHAPTER.name}.html")
    files = (("B2.1", "vector.py"), ("B2.11", "exercises.py"), ("B2.12", "calculus.py"))
    for exercise, file in files:
        student.write(student.turn(exercise), SOLUTIONS[f"{CHAPTER.name}/{file}"])
    whole = student.panel("[data-whole]", "button")
    assert student.check(whole, "Check the whole chapter").startswith("All checks pass")
    points = sum(each.points for each in CHAPTER.exercises if each.kind != "written")
    student.read(f"{points} of {points} points earned so far", whole)
    student.visit("index.html")
    student.read(f"{points} of {points} points")


def test_work_leaves_as_a_zip_and_comes_back_from_it(student: Student) -> None:
    student.visit(f"{CHAPTER.name}.html")
    student.write(student.turn("B2.1"), MINE)
    student.visit("index.html")
    student.press("Download my work (.zip)")
    student.read("Your work is downloaded.")
    archive = student.download("my-engine.zip")
    with zipfile.ZipFile(archive) as file:
        assert {*SOLUTIONS} <= {*file.namelist()}
        assert file.read(VECTOR).decode("utf-8") == MINE
    student.visit(f"{CHAPTER.name}.html")
    student.write(student.turn("B2.1"), "# nothing is left\n")
    student.visit("index.html")
    student.upload(archive)
    student.press("Replace them", "document.querySelector('dialog')")
    student.read("1 file taken from my-engine.zip")
    assert student.stored(VECTOR) == MINE


def test_work_is_kept_if_its_page_is_left_while_it_is_saved(student: Student) -> None:
    """It is saved 150 ms after a change. Five pages are left before that, meanwhile and after."""
    for number in range(5):
        student.visit(f"{CHAPTER.name}.html")
        mine = f"{MINE}# {number}\n"
        student.write(student.turn("B2.1"), mine)
        time.sleep(0.06 * number)
        student.visit("index.html")
        student.read("You have changed 1 file in 1 chapter.")
        assert student.stored(VECTOR) == mine


def test_a_scene_runs_and_its_cost_is_plausible(student: Student, tmp_path: Path) -> None:
    """A frame takes 3 to 9 times as long as outside. The limits still find a wrong unit."""
    archive = tmp_path / "everything.zip"
    with zipfile.ZipFile(archive, "w") as file:
        for path, text in reference().items():
            file.writestr(path, text)
    student.visit("index.html")
    student.upload(archive)
    student.read("taken from everything.zip")
    student.visit(f"lab.html?scene={SCENE}")
    cost = "document.querySelector('#contenders tbody tr')?.cells[2]"
    student.see(cost)
    student.press("Play")
    student.see("parseFloat(document.querySelector('#clock').innerText) > 5")
    value, unit = student.text(cost).split()
    assert student.text("document.querySelector('#trouble')") == ""
    shown = float(value) * {"µs": 1.0, "ms": 1000.0}[unit]
    assert 0.5 < shown / outside_a_browser() < 40.0


def outside_a_browser() -> float:
    """Return the time that a frame of the scene takes in this process, in µs."""
    host = Host(str)
    host.receive({"kind": "load", "scene": SCENE, "values": {}, "peer": ""})
    costs = [host.receive({"kind": "run", "frames": 30})[0]["cost"] for _ in range(20)]
    return float(costs[-1])
