"""The site works without the internet, and takes a new version when the reader wants it."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import course_site
from autograder.manifest import ROOT
from course_site import BELOW, Served
from site_page import VECTOR, check, marked, stored, turn, upload, visit

REWRITE = """
const {writeServiceWorker} = await import("./web/builder/offline.mjs");
await writeServiceWorker(process.argv[1]);
"""


def test_everything_works_offline_after_the_first_visit(browser: Any, site: Served) -> None:
    with course_site.served_site(site.folder) as server, visit(browser) as context:
        page = context.new_page()
        page.goto(f"{server.address}index.html")
        page.get_by_text("Everything is kept for use without the internet.").wait_for(
            timeout=60_000
        )
        server.stop()
        page.goto(f"{server.address}ch03_laws_of_motion.html")
        panel = turn(page, "B3.1")
        assert check(panel).startswith("B3.1: ")
        for name in ("glossary.html", "ch09_rotations_reference.html", ""):
            page.goto(server.address + name)
            assert page.locator("h1").is_visible()
        server.start()


def new_version(site: Path, folder: Path) -> Path:
    """Return a copy of a site in a new folder, with another list of mistakes in the book."""
    shutil.copytree(site, folder, copy_function=shutil.copyfile)
    text = (folder / "errata.html").read_text(encoding="utf-8")
    text = text.replace("<h1 ", "<p>The new version.</p><h1 ")
    (folder / "errata.html").write_text(text, encoding="utf-8")
    subprocess.run(
        ["node", "--input-type=module", "-e", REWRITE, str(folder)], cwd=ROOT, check=True
    )
    return folder


UPDATE = "navigator.serviceWorker.ready.then(r => r.update()).then(() => undefined)"
KEPT = """async () => {
  const urls = [];
  for (const name of await caches.keys()) {
    for (const {url} of await (await caches.open(name)).keys()) urls.push(url);
  }
  return urls;
}"""


def test_a_new_version_is_taken_when_wanted_and_another_site_of_the_host_is_left_alone(
    browser: Any, site: Served, tmp_path: Path
) -> None:
    """The other site is in a folder of this one, as when each term gets a folder."""
    folder = tmp_path / "host"
    old = site.folder / BELOW
    outer = folder / "course"
    shutil.copytree(old, outer, copy_function=shutil.copyfile)
    (outer / "spring").symlink_to(old)
    with course_site.served_site(folder) as server, visit(browser) as context:
        page = context.new_page()
        here = server.address.removesuffix(f"{BELOW}/") + "course/"
        addresses = (here, f"{here}spring/")
        for address in addresses:
            page.goto(f"{address}errata.html")
            page.get_by_text("Everything is kept for use").wait_for(timeout=60_000)
        upload(page, addresses[1], {VECTOR: marked("spring")}, tmp_path)
        kept = page.evaluate(KEPT)
        inner = {url for url in kept if url.startswith(addresses[1])}
        (outer / "spring").unlink()
        shutil.rmtree(outer)
        new_version(old, outer)
        (outer / "spring").symlink_to(old)
        for _ in range(2):  # it is still the old one after the page has been opened again
            page.goto(f"{here}errata.html")
            page.evaluate(UPDATE)
            page.get_by_text("A new version of the course is ready.").wait_for()
            assert page.get_by_text("The new version.").count() == 0
        page.get_by_role("button", name="Use it now").click()
        page.get_by_text("The new version.").wait_for()
        now = page.evaluate(KEPT)
        assert {url for url in now if url.startswith(addresses[1])} == inner
        names = [urlsplit(url).path for url in now]
        assert len(names) == len(set(names)), "the old version of a file is dropped"
        server.stop()
        for address, words in zip(addresses, ("The new version.", "mistakes"), strict=True):
            page.goto(f"{address}errata.html")
            page.get_by_text(words).first.wait_for()
            page.goto(f"{address}ch09_rotations.html")
            assert page.locator("h1").is_visible()
        server.start()
        assert stored(page).endswith("# spring\n")
        page.goto(f"{here}index.html")
        assert stored(page) == ""
