"""The site and its visitors, for the tests in this folder."""

from __future__ import annotations

import pytest

import browser as browsers
import course_site
import in_node
import site_page

browser = pytest.fixture(browsers.browser_alone, scope="module")
site = pytest.fixture(course_site.site, scope="module")
visitor = pytest.fixture(site_page.visitor)
engines = pytest.fixture(in_node.engines, scope="module")
