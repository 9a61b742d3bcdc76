"""Scenes on the pages: figures that come alive in lessons, and the page of the lab."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import load_chapters
from copies import reference
from course_site import Served
from site_page import accessible, everything_written, turn, upload
from web.stills import scenes_of_students
from wrong import Wrong, write_wrong

# One for each chapter. A test in node runs all of them, with the numbers of CPython.
SCENES = [*{entry.chapter: entry.name for entry in scenes_of_students()}.values()]


@pytest.fixture(scope="module")
def player(browser: Any, site: Served, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A page of somebody who has written everything."""
    with everything_written(browser, site.address, tmp_path_factory.mktemp("zip")) as page:
        yield page


def seconds(place: Any) -> float:
    return float(place.locator("[id$=clock]").inner_text().removesuffix(" s"))


def play_until(place: Any, time: float) -> None:
    """Let a lab play, and stop it."""
    place.locator("[id$=play]").click()
    for _ in range(600):
        if seconds(place) >= time or place.locator("[id$=trouble]").is_visible():
            break
        place.page.wait_for_timeout(100)
    place.locator("[id$=play]").click()


def test_scenes_play_in_real_time_or_say_that_they_do_not(player: Any, site: Served) -> None:
    player.goto(f"{site.address}lab.html?scene=one-spring&integrator=leapfrog&stiffness=100")
    player.locator("#contenders tbody tr").wait_for()
    assert player.input_value("[name=integrator]") == "leapfrog"
    offered = player.locator("#add option").all_inner_texts()
    assert "exact" in offered
    assert "pymunk" not in offered
    assert "not available in a browser" in player.inner_text("#absent")
    player.select_option("#add", label="integrator: Runge-Kutta 4")
    player.locator("#contenders tbody tr >> nth=1").wait_for()
    accessible(player)
    player.goto(f"{site.address}lab.html?scene=one-spring")
    slow = []
    for scene in SCENES:
        player.select_option("#scenes", scene)
        player.locator("#contenders tbody tr").wait_for()
        play_until(player.locator("#lab"), 1.2)
        trouble = player.locator("#trouble")
        assert trouble.is_hidden(), trouble.inner_text()
        assert seconds(player.locator("#lab")) >= 1.2
        if player.locator("#pace").is_visible():
            slow.append((scene, player.inner_text("#pace")))
        assert f"scene={scene}" in player.url
    assert all("of the speed" in words for _, words in slow)


def test_a_live_figure_starts_on_a_click_and_one_plays_at_a_time(player: Any, site: Served) -> None:
    player.goto(f"{site.address}ch06_springs.html")
    figures = player.locator("figure.live")
    first, second = figures.nth(0), figures.nth(1)
    assert first.locator("img").count() == 1
    first.get_by_role("button", name="Start").click()
    first.locator(".stage canvas").wait_for()
    assert first.locator("[name=stiffness]").input_value() == "36"  # as the lesson sets it
    accessible(player)
    first.get_by_label("Each swing is wider than the last.").check()
    first.get_by_role("button", name="This is my answer").click()
    first.get_by_text("Right.").wait_for()
    second.get_by_role("button", name="Start").click()
    second.locator(".stage canvas").wait_for()
    assert first.locator("canvas").count() == 0
    assert first.locator("img").is_visible()
    second.get_by_role("button", name="Close").click()
    assert second.locator("img").is_visible()


def test_a_scene_says_which_exercise_it_waits_for(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    figure = page.locator("figure.live").first
    figure.get_by_role("button", name="Start").click()
    link = figure.get_by_role("link", name="This scene runs your own code.")
    link.wait_for()
    assert "Exercise B2." in figure.inner_text()
    link.click()
    page.wait_for_url("**/ch02_vectors.html#ex-B2-*")


def with_forces(body: str, folder: Path) -> dict[str, str]:
    """Return the reference with another body of the method that every frame calls."""
    chapter = next(chapter for chapter in load_chapters() if chapter.number == 5)
    write_wrong(chapter, [Wrong("forces.ForceRegistry.update_forces", "", "", body=body)], folder)
    path = "ch05_forces/forces.py"
    return {**reference(), path: (folder / path).read_text(encoding="utf-8")}


def test_a_scene_that_is_too_slow_says_so(visitor: Any, site: Served, tmp_path: Path) -> None:
    page = visitor.new_page()
    slow = "for _ in range(1_000_000):\n    pass"
    upload(page, site.address, with_forces(slow, tmp_path), tmp_path)
    page.goto(f"{site.address}lab.html?scene=one-spring")
    page.locator("#contenders tbody tr").wait_for()
    page.locator("#play").click()
    page.get_by_text("of the speed that was asked for: one frame takes too long here").wait_for()


LANGUAGE = "Object.defineProperty(Navigator.prototype, 'language', {get: () => 'C'})"


def test_everything_but_the_charts_runs_with_an_unknown_language(
    visitor: Any, site: Served, tmp_path: Path
) -> None:
    """A scene of the lab, a live figure and an editor run all the same."""
    visitor.add_init_script(LANGUAGE)
    page = visitor.new_page()
    upload(page, site.address, reference(), tmp_path)
    page.goto(f"{site.address}lab.html?scene=one-spring")
    page.locator("#contenders tbody tr").wait_for()
    play_until(page.locator("#lab"), 1.2)
    assert seconds(page) >= 1.2
    missing = 'setting, which is "C"'
    assert missing in page.inner_text("#charts")
    assert page.locator("#trouble").is_hidden()
    assert "one frame takes too long" not in page.text_content("#pace")
    page.goto(f"{site.address}ch06_springs.html")
    figure = page.locator("figure.live").first
    figure.get_by_role("button", name="Start").click()
    figure.locator(".stage canvas").wait_for()
    play_until(figure, 0.3)
    assert seconds(figure) >= 0.3
    turn(page, "B6.1")
    ours = [words for words in visitor.troubles if "language" not in words.lower()]
    assert ours == [], "an error that is not uPlot's own"
    visitor.troubles.clear()
