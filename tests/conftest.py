"""What all runs of the checks share: the choice of the engine, and the random numbers."""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import autograder  # noqa: F401 - takes chapters/ from the path

TESTS = Path(__file__).parent


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--engine",
        action="append",
        help="a folder of chapters to check; each one overlays those named after it "
        "(default: solutions, if there is such a folder, over chapters)",
    )
    parser.addoption("--seed", default="1", help="seed of the checks' random numbers")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers",
        "exercise(id, weight=1, asks=words, read=place): the exercise of the manifest that a check "
        "belongs to, the words of the course that demand what it checks, and what to read about it",
    )
    config.addinivalue_line(
        "markers", "robust: the check is about bad arguments, overflow or NaN, not the physics"
    )
    there = [name for name in ("solutions", "chapters") if (TESTS.parent / name).is_dir()]
    folders = config.getoption("engine") or there
    for folder in folders:
        if not (TESTS.parent / folder).is_dir():
            raise pytest.UsageError(f"--engine: there is no folder {folder!r}")
    ours = ("shared", "helpers", "helpers/pages", "helpers/classes", "")
    sys.path[:0] = [str(TESTS / folder) for folder in ours]
    sys.path += [str(TESTS.parent / folder) for folder in folders]  # after Python's own modules


@pytest.fixture
def rng(request: pytest.FixtureRequest) -> random.Random:
    """Return the random numbers of one check, which do not depend on the other checks."""
    return random.Random(f"{request.config.getoption('seed')} {request.node.name}")


@pytest.fixture
def on_chart(request: pytest.FixtureRequest) -> Callable[[float, float], None]:
    """Return a function that puts a point on the chart of the check's exercise.

    It takes the cost, in counted work, and the error. A point is left out if its cost is less than
    1, or if its error is zero or not smaller than the scale of the scene.
    """

    def put(cost: float, error: float) -> None:
        if 1.0 <= cost < 1e9 and 1e-17 < error < 1.0:
            request.node.user_properties.append(("on_chart", (float(cost), float(error))))

    return put
