"""The *Try it* box of an exercise, used as a visitor uses it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import browser as browsers
import course_site
from course_site import Served
from site_page import accessible, everything_written, turn

browser = pytest.fixture(browsers.browser_alone, scope="module")
site = pytest.fixture(course_site.site, scope="module")


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
