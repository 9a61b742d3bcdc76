"""Every page of the site: accessible, complete, within its width, and asking no other host."""

from __future__ import annotations

import io
import lzma
import re
import zipfile
import zlib
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import ROOT, load_chapters
from course_site import BELOW, Served, pack_in
from site_page import accessible, turn, visit
from web.stills import scenes_of_students

CHAPTERS = load_chapters()
PAGES = [
    *("index.html", "lab.html", "glossary.html", "claims.html", "errata.html"),
    "learning_path.html",
    "commands.html",
    *(f"{chapter.name}.html" for chapter in CHAPTERS),
    *(f"{chapter.name}_reference.html" for chapter in CHAPTERS),
]
# The narrow layout shows everything that the wide one does, so one page of each kind is wide, too.
ONE_OF_EACH_KIND = (*PAGES[:6], f"{CHAPTERS[1].name}.html", f"{CHAPTERS[1].name}_reference.html")


class Links(HTMLParser):
    """Collects what a page links to, its anchors, and what its tags lack."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.ids: list[str] = []
        self.described: list[str] = []
        self.sizeless: list[str] = []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = {name: value or "" for name, value in attrs}
        self.targets += [found[name] for name in ("href", "src") if name in found]
        self.ids += [found["id"]] if "id" in found else []
        self.described += found.get("aria-describedby", "").split()
        if tag == "img" and not {"width", "height", "alt"} <= found.keys():
            self.sizeless.append(found["src"])


@pytest.fixture(scope="module")
def parsed(site: Served) -> dict[str, Links]:
    folder = site.folder / BELOW
    return {name: Links(folder / name) for name in PAGES}


def test_these_are_all_pages(site: Served) -> None:
    assert {file.name for file in (site.folder / BELOW).glob("*.html")} == set(PAGES)


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_accessible_and_fits(browser: Any, site: Served, name: str) -> None:
    scheme = "dark" if PAGES.index(name) % 2 else "light"
    # A service worker would keep the whole site for each of these visitors.
    with visit(browser, 360, color_scheme=scheme, service_workers="block") as context:
        page = context.new_page()
        page.goto(site.address + name)
        page.locator("#search-open").wait_for()
        for chapter in CHAPTERS:
            if name == f"{chapter.name}.html":
                turn(page, chapter.exercises[0].id)
        accessible(page)
        if name in ONE_OF_EACH_KIND:
            page.set_viewport_size({"width": 1280, "height": 900})
            accessible(page)


def test_links_lead_somewhere_within_the_site(site: Served, parsed: dict[str, Links]) -> None:
    folder = site.folder / BELOW
    for name, page in parsed.items():
        for target in page.targets:
            if target.startswith("https:"):
                continue
            path, _, anchor = re.sub(r"\?.*", "", target).partition("#")
            assert (folder / (path or name)).is_file(), (name, target)
            if anchor and (path or name).endswith(".html"):
                assert anchor in parsed[path or name].ids, (name, target)
        assert len(page.ids) == len(set(page.ids)), name
        assert set(page.described) <= set(page.ids), name
        assert page.sizeless == []


def test_every_exercise_has_its_panel_and_every_experiment_its_figure(site: Served) -> None:
    scenes = {entry.name for entry in scenes_of_students()}
    for chapter in CHAPTERS:
        text = (site.folder / BELOW / f"{chapter.name}.html").read_text(encoding="utf-8")
        panels = re.findall(r'<section class="turn[^"]*" id="[^"]+" data-exercise="([^"]+)"', text)
        assert sorted(panels) == sorted(exercise.id for exercise in chapter.exercises)
        assert all(f"make check EX={exercise.id}" in text for exercise in chapter.exercises)
        figures = re.findall(r'<figure class="live" data-scene="([^"]+)"', text)
        assert len(figures) >= text.count('class="callout experiment"') >= 3
        assert set(figures) <= scenes
        assert "<math" in text
        assert "$" not in re.sub(r"<(pre|code).*?</\1>|<[^>]*>", "", text, flags=re.S)


TEXT = (".html", ".js", ".css", ".svg")  # what every server sends compressed
SOURCES = ("web/page/**/*.js", "lab/page/*.js")


def test_the_site_is_small(site: Served) -> None:
    """All of it takes at most 20 MB, and what is ours 1.6 MB as it is sent."""
    folder = site.folder / BELOW
    files = {f.relative_to(folder).as_posix(): f for f in folder.rglob("*") if f.is_file()}
    assert sum(file.stat().st_size for file in files.values()) <= 20_000_000
    others = re.compile(r"pyodide/|vendor/|assets/.*\.(js|txt)|course\.xz")
    ours = [file for name, file in files.items() if not others.match(name)]
    ours += [file for pattern in SOURCES for file in ROOT.glob(pattern)]
    sent = sum(
        len(zlib.compress(f.read_bytes())) if f.suffix in TEXT else f.stat().st_size for f in ours
    )
    course = io.BytesIO()
    with pack_in(folder) as pack, zipfile.ZipFile(course, "w") as archive:
        for entry in pack.infolist():
            if re.match(r"course/(?!licenses/)", entry.filename):
                archive.writestr(entry, pack.read(entry))
    assert sent + len(lzma.compress(course.getvalue())) <= 1_600_000


def test_search_finds_a_term_and_an_exercise(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}errata.html")
    page.locator("#search-open").wait_for()
    page.keyboard.press("/")
    page.keyboard.type("angular moment")
    results = page.locator("dialog.search a")
    results.filter(has_text="angular momentum").first.wait_for()
    page.get_by_label("Search the course").fill("B6.7")
    results.filter(has_text="B6.7").first.wait_for()
    accessible(page)
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.wait_for_url("**/ch06_springs.html#ex-B6-7")


def test_a_term_shows_what_it_means_to_pointer_and_keyboard(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    page.locator("#search-open").wait_for()
    term = page.get_by_role("link", name="magnitude", exact=True).first
    tip = page.locator("#tip-magnitude")
    term.focus()
    assert tip.is_visible()
    accessible(page)
    page.keyboard.press("Escape")
    assert tip.is_hidden()
    page.evaluate("document.activeElement.blur()")
    term.hover()
    tip.wait_for()
    tip.hover()  # it stays while the pointer is on it
    page.wait_for_timeout(400)
    assert tip.is_visible()
    page.mouse.move(5, 5)
    tip.wait_for(state="hidden")
    term.click()
    page.wait_for_url("**/glossary.html#magnitude")


def test_the_keyboard_reaches_the_text_and_leaves_an_editor(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == "content"
    panel = page.locator("#ex-B2-1")
    panel.scroll_into_view_if_needed()
    panel.locator(".cm-content").focus()
    page.keyboard.press("Escape")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Check"


def test_a_link_into_a_lesson_stays_where_it_leads(browser: Any, site: Served) -> None:
    """The editors that appear above and below must not move the page."""
    with visit(browser, 360, service_workers="block") as context:
        page = context.new_page()
        page.goto(f"{site.address}ch09_rotations.html")
        page.locator("#search-open").wait_for()
        for anchor in ("ex-B9-9", "your-chapter", "ex-B9-4"):
            page.evaluate("id => (location.hash = id)", anchor)
            page.wait_for_timeout(1000)
            top = page.evaluate(
                "id => document.getElementById(id).getBoundingClientRect().top", anchor
            )
            assert -50 <= top <= (850 if anchor == "your-chapter" else 100), anchor  # the page ends
        assert page.locator("#ex-B9-4 .cm-own").first.is_visible()


def test_without_scripts_a_lesson_has_its_text_its_pictures_and_the_commands(
    browser: Any, site: Served
) -> None:
    page = browser.new_page(java_script_enabled=False)
    page.goto(f"{site.address}ch06_springs.html")
    assert page.get_by_text("make check EX=B6.1", exact=True).is_visible()
    assert page.locator("figure.live img").first.is_visible()
    assert page.locator("summary").filter(has_text="Answer").first.is_visible()
    page.close()


def test_printed_a_lesson_is_its_text(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}ch02_vectors.html")
    page.emulate_media(media="print")
    for hidden in (".top", ".contents", "footer", ".turn-body >> nth=0"):
        assert page.locator(hidden).is_hidden(), hidden
    assert page.locator("#ex-B2-1-title").is_visible()
