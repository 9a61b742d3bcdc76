"""The site and its visitors. Helpers are imported late, when pytest knows their folder."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    from browser import browser_alone

    yield from browser_alone()


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    from course_site import site

    yield from site(tmp_path_factory)


@pytest.fixture
def visitor(browser: Any) -> Iterator[Any]:
    from site_page import visitor

    yield from visitor(browser)


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> Any:
    from in_node import engines

    return engines(tmp_path_factory)
