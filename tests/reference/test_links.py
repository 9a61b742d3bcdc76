"""Pendulums on rods against elliptic integrals, and a long chain by a direct solve."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.links import AnchoredRod

GRAVITY = Vector3(0.0, -10.0, 0.0)


def swing(degrees: float, rate: int) -> float:
    """Return the time of a 1 m pendulum from its first to its third passage through the bottom."""
    h, angle = 1.0 / rate, math.radians(degrees)
    speed = math.sqrt(20.0 * (1.0 - math.cos(angle)))
    bob = Particle(Vector3(0.0, -1.0), Vector3(speed), GRAVITY)
    rod, resolver = AnchoredRod(bob, Vector3(), 1.0), ContactResolver()
    crossings, time, before = 0, 0.0, 0.0
    while crossings < 2:
        semi_implicit_euler([bob], lambda _: None, h)
        resolver.resolve_contacts(rod.contacts(), h)
        time, x = time + h, bob.position.x
        if before and (x < 0.0) != (before < 0.0):
            crossings += 1
            late = h * abs(x) / (abs(x) + abs(before))
        before = x
    return time - late


@pytest.mark.parametrize(
    ("degrees", "period", "off"), [(10.0, 1.99070708, 2e-4), (90.0, 2.34523957, 0.02)]
)
def test_a_pendulum_s_period_is_that_of_the_elliptic_integral(
    degrees: float, period: float, off: float
) -> None:
    """The period is 4 sqrt(L / g) K(sin^2(angle / 2)) with L 1 and g 10. The error has order 1."""
    errors = [swing(degrees, rate) - period for rate in (960, 1920, 3840)]
    assert max(map(abs, errors)) < off
    # The impulse along the rod removes a fraction w h of the energy, so it swings less and faster.
    assert all(error < 0.0 for error in errors)
    for coarse, fine in pairwise(errors):
        assert coarse / fine == pytest.approx(2.0, rel=0.15)  # with a part of order 2
    assert 2.0 * errors[2] - errors[1] == pytest.approx(0.0, abs=0.03 * off)


def stretch_of_30(rate: int, time: float) -> float:
    """Return the largest stretch of a chain of 30 rods that is released from horizontal."""
    bodies = [Particle(Vector3(0.1 * (i + 1)), acceleration=GRAVITY) for i in range(30)]
    chain, worst = DirectChain(bodies, Vector3()), 0.0
    for _ in range(round(time * rate)):
        chain.step(1.0 / rate)
        for start, end in pairwise([Vector3(), *(body.position for body in bodies)]):
            worst = max(worst, abs((end - start).magnitude() / 0.1 - 1.0))
    return worst


def test_a_chain_from_horizontal_blows_up_in_long_frames_and_not_in_short_ones() -> None:
    with pytest.raises(ArithmeticError, match="turns too far in one step"):
        stretch_of_30(60, 3.0)
    assert stretch_of_30(240, 1.0) < 1e-2
