"""A pytest plugin that calls each check that draws numbers with many seeds, in one run.

The reference must earn every point with every seed. Otherwise a tolerance is wrong.
"""

from __future__ import annotations

import random

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--seeds", type=int, default=1000, help="number of seeds")


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Call a check once per seed. Raise the first failure, with a list of all seeds that fail."""
    fixtures = pyfuncitem.funcargs
    if "rng" not in fixtures:
        return None
    names = pyfuncitem._fixtureinfo.argnames
    first: Exception | None = None
    failed = []
    for seed in range(1, pyfuncitem.config.getoption("seeds") + 1):
        arguments = {name: fixtures[name] for name in names}
        arguments["rng"] = random.Random(f"{seed} {pyfuncitem.name}")
        try:
            pyfuncitem.obj(**arguments)
        except (Exception, pytest.fail.Exception) as error:
            failed.append(seed)
            first = first or error
    if first:
        first.add_note(f"{len(failed)} seeds fail: {failed[:20]}")
        raise first
    return True
