"""The scenes of chapter 8 reject bad arguments with a clear message."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.ball_game import Rules
from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge, Deck
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.cube import Cube
from ch08_mass_aggregate.tilting_platform import balancing_mass
from ch08_mass_aggregate.trebuchet import PIVOT_HEIGHT, START, Design
from ch08_mass_aggregate.wheel import Wheel

BALL = Particle(Vector3())
LOWEST = PIVOT_HEIGHT + 4.0 * math.sin(START)  # m, initial height of the tip of a long arm of 4 m


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: Deck(BALL, 0.0, make_rows()), ValueError, "radius must be positive"),
        (lambda: Deck(BALL, 0.5, []), ValueError, "rows must have at least one row"),
        (lambda: Deck(BALL, 0.5, make_rows(), math.nan), ValueError, "restitution"),
        (lambda: Bridge(0.0), ValueError, "ball_mass must be positive"),
        (lambda: Bridge(5.0, math.inf), ValueError, "x must be finite"),
        (lambda: Blob(0.49), ValueError, "height must be 0.5 or more, got 0.49"),
        (lambda: Blob(math.nan), ValueError, "height must be finite"),
        (lambda: Cube(0.0), ValueError, "height must be positive"),
        (lambda: Cube(rods=[(0, -1)]), IndexError, r"from 0 to 7, got \(0, -1\)"),
        (lambda: Cube(rods=[(8, 0)]), IndexError, r"from 0 to 7, got \(8, 0\)"),
        (lambda: Wheel(driven=-1), ValueError, "driven must be a whole number from 0 to 8, got -1"),
        (lambda: Wheel(driven=9), ValueError, "driven must be a whole number from 0 to 8, got 9"),
        (lambda: Wheel(driven=2.0), ValueError, "driven must be a whole number"),
        (lambda: Wheel(math.inf), ValueError, "force must be finite"),
        (lambda: Rules(0), ValueError, "rows must be 1 or more, got 0"),
        (lambda: Rules(2.5), TypeError, "rows must be a whole number, got 2.5"),  # type: ignore[arg-type]
        (lambda: Rules(6).landed(6), ValueError, "row must be from 0 to 5, got 6"),
        (lambda: Rules(6).landed(0.5), ValueError, "row must be from 0 to 5, got 0.5"),  # type: ignore[arg-type]
        (lambda: balancing_mass([1e308], [-1e10], 1.0), ValueError, "balancing mass"),
        (lambda: balancing_mass([1e-200], [1.0], 1e-200), ValueError, "x must be on the side"),
        (lambda: Design(400.0, 1.0, 4.0, LOWEST, 40.0), ValueError, "sling must not reach"),
    ],
)
def test_it_is_named(make: Callable[[], Any], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        make()


@pytest.mark.parametrize(("pace", "duration"), [(math.nan, 0.1), (1.0, 0.0), (1.0, math.inf)])
def test_a_bridge_that_cannot_make_a_step_stays_as_it_was(pace: float, duration: float) -> None:
    bridge = Bridge()
    bridge.pace = pace
    with pytest.raises(ValueError, match="pace" if math.isnan(pace) else "duration"):
        bridge.step(duration)
    assert bridge.ball.velocity == Vector3()
    assert [particle.position for particle in bridge.world.particles] == [
        particle.position for particle in Bridge().world.particles
    ]
