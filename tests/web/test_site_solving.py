"""Exercises are written and checked on the pages, and mistakes are told as on the command line."""

from __future__ import annotations

import random
import re
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import ROOT, load_chapters
from autograder.message import laid_out
from copies import copy_tree, reference
from course_site import Served, built_with_solutions, served_site
from site_page import accessible, check, everything_written, rows, stored, turn, visit, write
from typed import typed
from wrong import read_wrong, write_wrong

CHAPTERS = load_chapters()
SEED = 1  # of the wrong submissions that are drawn
LOOP = "def clear(self) -> None:\n        while True:\n            pass\n"


def test_a_mistake_is_told_as_on_the_command_line(
    browser: Any, site: Served, tmp_path: Path
) -> None:
    """The engines of all chapters are compared in test_engines, without a browser."""
    chapter = CHAPTERS[4]
    (wrong,) = random.Random(SEED).sample(read_wrong(chapter), 1)
    engine, file = tmp_path / "engine", f"{wrong.edit.partition('.')[0]}.py"
    copy_tree(ROOT / "solutions", engine)
    write_wrong(chapter, [wrong], engine)
    exercise = next(e for e in chapter.exercises if wrong.edit in e.edit)
    done = typed("autograder", "check", "--exercise", exercise.id, "--engine", engine)
    assert done.returncode == 1, done.stdout + done.stderr
    with everything_written(browser, site.address, tmp_path) as page:
        page.goto(f"{site.address}{chapter.name}.html")
        panel = turn(page, exercise.id)
        write(page, panel, file, (engine / chapter.name / file).read_text(encoding="utf-8"))
        check(panel)
        heading = panel.locator(".failure > :first-child").inner_text()
        assert f"\n{heading}\n{laid_out(rows(panel))}\n" in done.stdout, wrong.mistake


WATCH = """() => {
  let last = performance.now();
  window.longest = 0;
  setInterval(() => {
    const now = performance.now();
    window.longest = Math.max(window.longest, now - last);
    last = now;
  }, 10);
}"""


def test_an_endless_loop_ends_and_the_page_stays_responsive(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    panel = turn(page, "B2.1")
    text = reference("ch02_vectors")["ch02_vectors/vector.py"]
    write(page, panel, "vector.py", text)
    assert check(panel).startswith("All checks of B2.1 pass")
    body = text[text.index("def clear") : text.index("def invert")]
    looping = text.replace(body, f"{LOOP}\n    ")
    page.evaluate(WATCH)
    write(page, panel, "vector.py", looping)
    page.evaluate("window.longest = 0")
    began = time.monotonic()
    panel.get_by_role("button", name="Check", exact=True).click()
    panel.locator(".failure").wait_for()
    # A loop in the page itself would make its longest pause as long as the whole wait.
    assert page.evaluate("window.longest") / 1000.0 < 0.5 * (time.monotonic() - began)
    line = looping[: looping.index("while True")].count("\n") + 1
    where = dict(rows(panel))["where"]
    assert where in {f"ch02_vectors/vector.py, line {line + n}, in clear" for n in (0, 1)}
    panel.get_by_role("button", name="Go to line").click()
    assert panel.locator(".cm-wrong").count() == 1
    write(page, panel, "vector.py", text)
    assert check(panel).startswith("All checks of B2.1 pass")


def test_a_written_answer_is_kept_in_answers_md(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    panel = turn(page, "2.2b")
    assert "Why does the sign" in panel.inner_text()
    panel.get_by_label("Your answer").fill("Both lengths are positive.\n\nSo the cosine decides.")
    assert panel.locator(".state").inner_text() == "answered"
    turn(page, "2.3").get_by_label("Your answer").fill("It is squared_magnitude.")
    page.wait_for_timeout(400)
    page.reload()
    assert turn(page, "2.2b").get_by_label("Your answer").input_value() == (
        "Both lengths are positive.\n\nSo the cosine decides."
    )
    whole = page.locator("[data-whole]")
    whole.scroll_into_view_if_needed()
    check(whole, "Check the whole chapter")
    assert whole.locator("tr", has_text="2.2b").locator(".state").inner_text() == "answered"


def test_hints_come_one_by_one_and_a_reset_can_be_undone(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    panel = turn(page, "B2.2")
    hint = panel.locator(".row").get_by_role("button", name="hint", exact=False)
    for number in range(1, 4):
        hint.click()
        assert panel.locator(".hints li").count() == number
    assert hint.inner_text() == "No more hints"
    check(panel)
    accessible(page)  # with hints, a failure and its buttons
    mine = reference("ch02_vectors")["ch02_vectors/vector.py"]
    write(page, panel, "vector.py", mine)
    panel.get_by_role("button", name="Reset").click()
    page.get_by_role("dialog").get_by_role("button", name="Cancel").click()
    assert stored(page) == mine
    panel.get_by_role("button", name="Reset").click()
    page.get_by_role("dialog").get_by_role("button", name="Reset").click()
    panel.get_by_text("The stub of B2.2 is back.").wait_for()
    assert stored(page).count("Exercise B2.2: Length") == 2
    assert "math.hypot" not in stored(page)
    assert "return Vector3(-self.x" in stored(page)  # the rest is as it was
    panel.get_by_role("button", name="Undo").click()
    panel.get_by_text("Your code is back.").wait_for()
    assert stored(page) == mine


def test_lines_are_tried_with_a_history(browser: Any, site: Served, tmp_path: Path) -> None:
    with everything_written(browser, site.address, tmp_path) as page:
        page.set_viewport_size({"width": 400, "height": 900})
        page.goto(f"{site.address}ch02_vectors.html")
        panel = turn(page, "B2.9")
        panel.get_by_text("Try it", exact=True).click()
        box = panel.get_by_label("A line of Python for B2.9")
        for line in ("v = Vector3(1, 2, 0)", "v.cross(Vector3(0, 1, 0))", "v / 0", "print(v)"):
            box.fill(line)
            box.press("Enter")
            panel.get_by_text(f">>> {line}", exact=True).wait_for()
            page.wait_for_function("(box) => !box.readOnly", arg=box.element_handle())
        shown = panel.locator(".tried").inner_text()
        assert "Vector3(0.0, 0.0, 1.0)" in shown
        assert "ZeroDivisionError" in shown
        assert "ch02_vectors/vector.py, line" in shown
        assert shown.rstrip().endswith("Vector3(1.0, 2.0, 0.0)")
        box.press("ArrowUp")
        box.press("ArrowUp")
        assert box.input_value() == "v / 0"
        accessible(page)


@pytest.fixture(scope="module")
def generous(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """The same pages with the pack of `make site SOLUTIONS=1`."""
    with served_site(built_with_solutions(tmp_path_factory)) as server:
        yield server


def test_a_chapter_is_taken_from_the_reference(browser: Any, generous: Served) -> None:
    with visit(browser, service_workers="block") as context:
        page = context.new_page()
        page.goto(f"{generous.address}ch03_laws_of_motion.html")
        panel = turn(page, "B3.4")
        for path, text in reference("ch03_laws_of_motion").items():
            write(page, panel, path.split("/")[1], text)
        assert not check(panel).startswith("All checks of B3.4 pass")
        panel.get_by_role("link", name="Take earlier chapters from the reference").click()
        whole = page.locator("[data-whole]")
        whole.get_by_label("2", exact=True).check()
        assert re.match(r"All checks of B3\.4 pass.* chapter 2\.", check(panel))
        page.reload()
        whole.scroll_into_view_if_needed()
        assert whole.get_by_label("2", exact=True).is_checked()
        page.goto(f"{generous.address}lab.html?scene=frame-rates")
        page.locator("#add option", has_text="the reference").wait_for(state="attached")
        assert "on the reference's chapters 2" in page.inner_text("#whose")
