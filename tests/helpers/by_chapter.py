"""A pytest plugin that runs only the tests about one chapter, as `make test CH=6` does.

A test is about the chapter in its parameters, or else about the latest one that its file, or the
modules of studies/ that it imports, name. Tests of the autograder and of web/ are about none.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from autograder.manifest import ROOT, Chapter

NAME = re.compile(r"\bch(\d\d)_")
TOOLS = (ROOT / "tests/autograder", ROOT / "tests/web")
IMPORT = re.compile(r"^ *from (studies[\w.]*) import (.*)$", re.MULTILINE)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--chapter", type=int, help="run only the tests of this chapter")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    wanted = config.getoption("chapter")
    if wanted is None:
        return
    about = [wanted in chapters_of(item) for item in items]
    config.hook.pytest_deselected(
        items=[i for i, is_it in zip(items, about, strict=True) if not is_it]
    )
    items[:] = [item for item, is_it in zip(items, about, strict=True) if is_it]


def chapters_of(item: pytest.Item) -> set[int]:
    """Return the chapters that a test is about. There is rarely more than one."""
    if any(item.path.is_relative_to(folder) for folder in TOOLS):
        return set()
    parameters = item.callspec.params.values() if hasattr(item, "callspec") else ()
    found = {value.number for value in parameters if isinstance(value, Chapter)}
    for value in parameters:
        if isinstance(value, str | Path):
            found |= named_in(str(value))
    return found or latest(item.path)


@cache
def latest(file: Path) -> set[int]:
    """Return a set with the latest chapter that a file imports or names, or an empty set."""
    if own := NAME.match(file.parent.name):
        return {int(own[1])}
    if file.is_relative_to(ROOT / "tests/project"):
        return set()  # tests that run for every chapter have it as a parameter
    text = file.read_text(encoding="utf-8")
    found = {
        number
        for each in re.findall(r"^(?:from|import) ch\d\d_", text, re.M)
        for number in named_in(each)
    }
    found = found or named_in(text)
    for module, names in () if found else IMPORT.findall(text):
        for name in ("", *re.findall(r"\w+", names)):
            path = ROOT / f"{f'{module}.{name}'.rstrip('.').replace('.', '/')}.py"
            found |= named_in(path.read_text(encoding="utf-8")) if path.is_file() else set()
    return {max(found)} if found else set()


def named_in(text: str) -> set[int]:
    return {int(number) for number in NAME.findall(text)}
