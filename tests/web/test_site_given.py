"""Chapters from the reference: only a site that was built with solutions has them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest

import browser as browsers
from copies import reference
from course_site import Served, built_with_solutions, served_site
from site_page import check, turn, visit, write

browser = pytest.fixture(browsers.browser_alone, scope="module")


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
