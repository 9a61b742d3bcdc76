"""Interactive sessions of Python that the lessons print really run, with these results."""

from __future__ import annotations

import doctest
import re
from typing import Any

import pytest

from autograder.manifest import ROOT

PAGES = [
    path
    for path in sorted((ROOT / "chapters").glob("ch*/*.md"))
    if "```pycon" in path.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("path", PAGES, ids=[f"{path.parent.name}/{path.stem}" for path in PAGES])
def test_a_printed_session_gives_these_results(path: Any) -> None:
    """The sessions of a page share their names, as in one session that a reader keeps open."""
    blocks = re.findall(r"(?ms)^```pycon\n(.+?)^```", path.read_text(encoding="utf-8"))
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, path.name, str(path), 0)
    assert len(test.examples) >= len(blocks)
    said: list[str] = []
    result = doctest.DocTestRunner(verbose=False).run(test, out=said.append)
    assert result.failed == 0, "".join(said)
