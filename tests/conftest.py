"""What every run of the checks shares: which engine is checked, and where the numbers come from."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

TESTS = Path(__file__).parent


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--engine",
        action="append",
        help="a folder of chapters to check; more of them lie below the first "
        "(default: solutions, where there is such a folder, over chapters)",
    )
    parser.addoption("--seed", default="1", help="seed of the numbers that checks draw")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers", "exercise(id, weight=1): the exercise of the manifest that a check belongs to"
    )
    config.addinivalue_line(
        "markers", "robust: the check is about bad arguments, overflow or NaN, and not the physics"
    )
    there = [name for name in ("solutions", "chapters") if (TESTS.parent / name).is_dir()]
    folders = config.getoption("engine") or there
    for folder in folders:
        if not (TESTS.parent / folder).is_dir():
            raise pytest.UsageError(f"--engine: there is no folder {folder!r}")
    sys.path[:0] = [str(TESTS / "shared"), str(TESTS / "helpers"), str(TESTS)]
    sys.path += [str(TESTS.parent / folder) for folder in folders]  # behind Python's own modules


@pytest.fixture
def rng(request: pytest.FixtureRequest) -> random.Random:
    """Random numbers of a check's own: the same whichever other checks run, and in what order."""
    return random.Random(f"{request.config.getoption('seed')} {request.node.name}")


@pytest.fixture
def on_chart(request: pytest.FixtureRequest) -> Callable[[float, float], None]:
    """Put a point on the chart of the check's exercise: its cost, in counted work, and its error.

    A cost is 1 or more, and an error smaller than the scale of the scene: what is off by more, or
    by nothing at all, is left out.
    """

    def put(cost: float, error: float) -> None:
        if 1.0 <= cost < 1e9 and 1e-17 < error < 1.0:
            request.node.user_properties.append(("on_chart", (float(cost), float(error))))

    return put
