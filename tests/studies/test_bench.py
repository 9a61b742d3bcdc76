"""The bench measures what it says. No test asserts a speed: machines are shared."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from studies import timing
from studies.benchmarks import particles, vectors
from studies.scenes import PROJECTILE, make_particle


def test_a_ratio_is_of_medians_and_its_spread_of_the_rounds() -> None:
    first = iter([2.0, 4.0, 6.0, 100.0, 4.0])
    ratio, low, high = timing.ratio(lambda: next(first), lambda: 2.0, 5, "made up")
    assert ratio == 2.0  # medians 4 and 2: one slow round does not count
    assert (low, high) == (2.0, 3.0)


def test_a_peer_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(vectors.importlib.util, "find_spec", lambda _: None)
    screen = io.StringIO()
    assert vectors.lines(Console(file=screen)) == []
    for peer in ("pyglet", "numpy", "pymunk"):
        assert f"{peer} is not installed: pip install -r studies/peers.txt" in screen.getvalue()


@pytest.mark.parametrize("library", ["ours", "numpy"])
def test_every_statement_of_the_libraries_at_hand_can_be_timed(library: str) -> None:
    statements = vectors.STATEMENTS[library]
    for name in vectors.OPERATIONS:
        assert vectors.timeit.Timer(statements[name], statements["setup"]).timeit(1) > 0.0


def test_what_is_compared_with_the_step_is_the_same_step() -> None:
    """The operators and the local variables end where Particle.integrate does, to rounding."""
    stepped, by_operators = make_particle(PROJECTILE), make_particle(PROJECTILE)
    particles.steps(stepped, [particles.FRAME] * particles.STEPS)
    particles.operator_steps(by_operators)
    # 10,000 roundings of numbers up to 3000.
    wanted = pytest.approx(tuple(stepped.position), rel=1e-9)
    assert tuple(by_operators.position) == wanted
    assert particles.arithmetic() == wanted
