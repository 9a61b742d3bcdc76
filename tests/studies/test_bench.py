"""The bench measures what it says. No test asserts a speed: machines are shared."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from studies import bench


def test_a_ratio_is_of_medians_and_its_spread_of_the_rounds() -> None:
    first = iter([2.0, 4.0, 6.0, 100.0, 4.0])
    ratio, low, high = bench.ratio(lambda: next(first), lambda: 2.0, 5, "made up")
    assert ratio == 2.0  # medians 4 and 2: one slow round does not count
    assert (low, high) == (2.0, 3.0)


def test_a_peer_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench.importlib.util, "find_spec", lambda _: None)
    screen = io.StringIO()
    assert bench.vectors_against_peers(Console(file=screen)) == []
    for peer in ("pyglet", "numpy", "pymunk"):
        assert f"{peer} is not installed: pip install -r studies/peers.txt" in screen.getvalue()


@pytest.mark.parametrize("library", ["ours", "numpy"])
def test_every_statement_of_the_libraries_at_hand_can_be_timed(library: str) -> None:
    statements = bench.STATEMENTS[library]
    for name in bench.OPERATIONS:
        assert bench.timeit.Timer(statements[name], statements["setup"]).timeit(1) > 0.0
