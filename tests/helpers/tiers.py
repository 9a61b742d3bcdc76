"""A pytest plugin that runs the quick or the slow tests: see tests/tiers.toml and the marker slow.

tests/tiers.toml says which folders and files are quick and which are slow. In a quick file, a test
with the marker `slow` is slow too, unless the option is given that the marker may name with
`but_for`. The longest tests start first, so that no core waits at the end.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

TESTS = Path(__file__).parent.parent
FILE = TESTS / "tiers.toml"
TIERS = tomllib.loads(FILE.read_text(encoding="utf-8"))
# How the path of a test file may begin, with "" if the file is quick, and else with a name for it.
PATHS: dict[str, str] = dict.fromkeys(TIERS["quick"], "") | TIERS["slow"]


def is_slow(file: Path) -> bool:
    """Return whether all tests of a file are slow. It is an error if the list does not have it."""
    path = file.relative_to(TESTS).as_posix()
    fits = [begin for begin in PATHS if path.startswith(begin)]
    if not fits:
        raise pytest.Collector.CollectError(f"no tier: add {path} or its folder to {FILE}")
    return bool(PATHS[max(fits, key=len)])


def place(item: pytest.Item) -> int:
    """Return where the list has a test among the long ones; all others share the last place."""
    name = item.nodeid.removeprefix("tests/")
    fits = (number for number, long in enumerate(TIERS["first"]) if name.startswith(long))
    return next(fits, len(TIERS["first"]))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--tier", choices=["quick", "slow"], required=True)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Read no file that has only slow tests if only quick ones will run."""
    is_left_out = collection_path.match("test_*.py") and is_slow(collection_path)
    return True if is_left_out and config.getoption("tier") == "quick" else None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    chosen, others = [], []
    for item in items:
        marker = item.get_closest_marker("slow")
        unless = marker and marker.kwargs.get("but_for")
        marked = marker and not (unless and config.getoption(unless, None))
        slow = is_slow(item.path) or bool(marked)
        (chosen if slow == (config.getoption("tier") == "slow") else others).append(item)
    config.hook.pytest_deselected(items=others)
    items[:] = sorted(chosen, key=place)


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    if config.getoption("tier") == "quick":
        names = ", ".join(dict.fromkeys(name for name in PATHS.values() if name))
        text = f"Left out: {names}, and tests marked as slow. To run them too: make test-all"
        terminalreporter.write_line(text)
