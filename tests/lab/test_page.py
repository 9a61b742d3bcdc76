"""Test the lab's page in a real browser: scenes, keyboard, broken code, and requests."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlencode, urlsplit

import pytest

import browser as browsers
from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from lab.catalog import entries
from served import served
from site_page import accessible
from web.stills import scenes_of_students
from wrong import Wrong, write_wrong

# The site plays its scenes with the same page, and tests of it play them.
ON_SITE = {entry.name for entry in scenes_of_students()}
SCENES = [entry.name for entry in entries() if entry.name not in ON_SITE]
PHONE, DESK = {"width": 360, "height": 740}, {"width": 1280, "height": 900}

browser = pytest.fixture(browsers.browser, scope="module")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with served() as address:
        yield address


@pytest.fixture
def page(browser: Any) -> Iterator[Any]:
    """Yield a page that records its errors and every host that it sends requests to."""
    page = browser.new_page(viewport=DESK, bypass_csp=True)  # Playwright's waits need eval
    page.set_default_timeout(10_000.0)  # ms; an answer takes less than a second
    page.errors, page.hosts = [], set()
    page.on("pageerror", lambda error: page.errors.append(str(error)))
    page.on("request", lambda request: page.hosts.add(urlsplit(request.url).hostname))
    yield page
    assert page.errors == []
    assert page.hosts <= {"127.0.0.1", None}  # None: data within the page
    page.close()


def open_scene(page: Any, address: str, scene: str, **values: object) -> None:
    """Open a scene and wait for its first frame."""
    page.goto(f"{address}?{urlencode({'scene': scene, **values})}")
    page.wait_for_function("document.querySelector('#contenders tbody tr')")
    page.wait_for_function("document.querySelector('#clock').textContent !== ''")


def seconds(page: Any) -> float:
    return float(page.inner_text("#clock").removesuffix(" s"))


def play_until(page: Any, time: float) -> None:
    page.click("#play")
    page.wait_for_function(
        f"parseFloat(document.querySelector('#clock').textContent) >= {time}", timeout=60_000
    )
    page.click("#play")


@pytest.mark.parametrize("scene", SCENES)
def test_a_scene_runs_for_two_seconds(page: Any, address: str, scene: str) -> None:
    open_scene(page, address, scene)
    page.select_option("#speed", "2")
    play_until(page, 2.0)
    assert page.is_hidden("#trouble"), page.inner_text("#trouble")
    drawn = "(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some(b => b))"
    assert page.evaluate(f"{drawn}(document.querySelector('#stage canvas'))")
    assert page.inner_text("#say") != ""


def test_the_error_is_that_of_the_method_and_another_contender_is_compared(
    page: Any, address: str
) -> None:
    """Leapfrog's phase error is w h (w h)^2 / 24 per step: 0.0139 in 2 s at 10 rad/s and 60 Hz."""
    open_scene(page, address, "one-spring", stiffness=100, integrator="leapfrog")
    page.select_option("#add", label="integrator: Runge-Kutta 4")
    page.wait_for_function("document.querySelectorAll('#contenders tbody tr').length === 2")
    play_until(page, 2.0)
    first, second = (
        float(row.split("\t")[1].removesuffix(" m"))
        for row in page.inner_text("#contenders tbody").splitlines()
    )
    w, h = 10.0, 1.0 / 60.0
    assert first == pytest.approx(2.0 * w * (w * h) ** 2 / 24.0, rel=0.25)
    assert second < first / 10.0  # order 4 against order 2, with w h = 1/6
    assert page.is_visible("#tradeoff")
    page.check("#split")
    assert page.locator("#stage canvas").count() == 2
    other = page.context.browser.new_page(bypass_csp=True)  # the address restores everything
    other.goto(page.url)
    other.wait_for_function("document.querySelectorAll('#contenders tbody tr').length === 2")
    other.close()


def test_a_reader_predicts_first_and_then_sees(page: Any, address: str) -> None:
    open_scene(page, address, "one-spring", stiffness=100)
    page.check("#predict input >> nth=1")
    page.click("text=This is my answer")
    page.wait_for_selector("#predict [role=status]", timeout=20_000)
    assert page.inner_text("#predict [role=status]").startswith("Not quite: It keeps swinging")
    assert page.inner_text("#play") == "Play"


def test_the_keyboard_is_enough(page: Any, address: str) -> None:
    open_scene(page, address, "one-spring")
    page.keyboard.press(".")
    page.wait_for_function("document.querySelector('#clock').textContent === '0.02 s'")
    page.keyboard.press(" ")
    page.wait_for_function("parseFloat(document.querySelector('#clock').textContent) > 0.3")
    page.keyboard.press(" ")
    page.keyboard.press("r")
    page.wait_for_function("document.querySelector('#clock').textContent === '0.00 s'")
    page.keyboard.press("?")
    assert page.is_visible("#keys")
    page.keyboard.press("Escape")
    reached = set()
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.name || document.activeElement.id"))
    assert {"scenes", "play", "restart", "stiffness", "integrator", "add", "csv"} <= reached
    open_scene(page, address, "platform")
    page.keyboard.press("ArrowRight")  # if a key changes a parameter, its slider moves
    page.wait_for_function("document.querySelector('[name=x]').value === '-0.5'")
    open_scene(page, address, "one-spring")
    page.focus("#parameters input[type=range]")
    page.keyboard.press("ArrowRight")
    assert float(page.input_value("[name=stiffness]")) > 100.0


@pytest.mark.parametrize(("size", "scheme"), [(PHONE, "light"), (DESK, "dark")])
def test_it_is_accessible_and_fits(
    browser: Any, address: str, scheme: str, size: dict[str, int]
) -> None:
    page = browser.new_page(viewport=size, color_scheme=scheme, bypass_csp=True)
    for scene in ("one-spring", "charts"):  # the second scene has the longest option names
        open_scene(page, address, scene)
        play_until(page, 0.5)
        accessible(page)
    page.close()


def test_a_loop_is_ended_and_a_save_starts_again(page: Any, tmp_path: Path) -> None:
    chapter = next(chapter for chapter in load_chapters() if chapter.name == "ch05_forces")
    copy_tree(ROOT / "solutions", tmp_path)
    right = (tmp_path / "ch05_forces/forces.py").read_text(encoding="utf-8")
    wrong = Wrong("forces.ForceRegistry.update_forces", "", "", body="while True:\n    pass")
    write_wrong(chapter, [wrong], tmp_path)
    with served(engine=str(tmp_path)) as address:
        page.goto(f"{address}?scene=one-spring")
        page.wait_for_selector("#contenders tbody tr")
        page.click("#step")
        page.wait_for_selector("#trouble:not([hidden])", timeout=5_000)
        assert "forces.py, line" in page.inner_text("#trouble")
        (tmp_path / "ch05_forces/forces.py").write_text(right, encoding="utf-8")
        page.wait_for_selector("#trouble[hidden]", state="attached", timeout=10_000)
        play_until(page, 0.3)
        assert seconds(page) >= 0.3


# Scripts that replace the library of the charts, or the function that clears a picture.
FAILS = """document.addEventListener("DOMContentLoaded", () => {
  const make = window.uPlot;
  window.uPlot = function (...given) {
    const plot = new make(...given);
    plot.%s = () => { throw Error("no room"); };
    return plot;
  };
});"""
NO_CANVAS = """const clear = CanvasRenderingContext2D.prototype.clearRect;
CanvasRenderingContext2D.prototype.clearRect = function (...box) {
  if (this.canvas.closest("#stage")) throw Error("no canvas");
  clear.apply(this, box);
};"""
RARELY = "requestAnimationFrame = (act) => setTimeout(() => act(performance.now()), 400)"


@pytest.mark.parametrize(
    ("fails", "words"),
    [
        ("setData", "this browser cannot draw them (no room)"),
        ("setSize", "this browser cannot draw them (no room)"),
        ("", "the library that draws them did not load"),
    ],
)
def test_a_scene_runs_if_charts_fail(page: Any, address: str, fails: str, words: str) -> None:
    if fails:
        page.add_init_script(FAILS % fails)
    else:
        page.route("**/uPlot.iife.min.js", lambda route: route.abort())
    open_scene(page, address, "one-spring")
    page.set_viewport_size(PHONE)
    play_until(page, 0.5)
    assert words in page.inner_text("#charts")
    assert page.is_hidden("#trouble")
    with page.expect_download() as download:  # has all values all the same
        page.click("#csv")
    title, *rows = Path(download.value.path()).read_text(encoding="utf-8").splitlines()
    assert title.startswith('"time, s","energy, J (your engine)"')
    assert len(rows) > 10


def test_a_scene_runs_if_its_picture_fails(page: Any, address: str) -> None:
    page.add_init_script(NO_CANVAS)
    open_scene(page, address, "one-spring")
    play_until(page, 0.5)
    assert page.inner_text("#trouble") == "This page could not show everything: no canvas"


def test_a_button_that_cannot_do_its_work_says_so(page: Any, address: str) -> None:
    """Browsers offer the clipboard only to pages with https. The server may have been stopped."""
    page.add_init_script("Object.defineProperty(Navigator.prototype, 'clipboard', {value: void 0})")
    page.route("**/record.gif*", lambda route: route.abort())
    open_scene(page, address, "one-spring")
    page.click("#link")
    page.get_by_text("does not let the page copy the link: http://127.0.0.1").wait_for()
    page.click("#gif")
    page.get_by_text("The animation has failed").wait_for()


def test_only_slow_frames_are_blamed_for_a_slow_scene(page: Any, address: str) -> None:
    """The page requests at most eight frames at once, so every 400 ms they are too few."""
    page.add_init_script(RARELY)
    open_scene(page, address, "one-spring")
    page.click("#play")
    page.wait_for_selector("#pace:not([hidden])")
    assert "the browser is busy" in page.inner_text("#pace")


def test_a_stopped_engine_does_not_slow_down_its_rivals(page: Any, address: str) -> None:
    """At k h^2 / m = 4.03, semi-implicit Euler explodes, and Runge-Kutta 4 is stable up to 8."""
    open_scene(page, address, "one-spring", stiffness=14_500)
    page.select_option("#add", label="integrator: Runge-Kutta 4")
    page.wait_for_function("document.querySelectorAll('#contenders tbody tr').length === 2")
    page.click("#play")
    page.wait_for_selector("#trouble:not([hidden])", timeout=30_000)
    assert "exploded" in page.inner_text("#trouble")
    for _ in range(25):
        words = page.text_content("#pace")
        assert " 0 %" not in words
        assert "one frame takes too long" not in words
        page.wait_for_timeout(100)
