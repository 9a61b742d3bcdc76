"""Pendulums on rods against elliptic integrals, and chains by a direct solve."""

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


def no_forces(_: float) -> None:
    """Add no forces. Gravity is each particle's own acceleration."""


def swing(degrees: float, rate: int) -> float:
    """Return the time of a 1 m pendulum from its first to its third passage through the bottom.

    It starts at the bottom with the speed that takes it to this angle.
    """
    h, angle = 1.0 / rate, math.radians(degrees)
    speed = math.sqrt(20.0 * (1.0 - math.cos(angle)))
    bob = Particle(Vector3(0.0, -1.0), Vector3(speed), GRAVITY)
    rod, resolver = AnchoredRod(bob, Vector3(), 1.0), ContactResolver()
    crossings, time, before = 0, 0.0, 0.0
    while crossings < 2:
        semi_implicit_euler([bob], no_forces, h)
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


def let_go(n: int, degrees: float, rate: int, time: float, length: float) -> tuple[Vector3, float]:
    """Return the tip of a released chain after a time, and the largest stretch until then."""
    angle = math.radians(degrees)
    way = Vector3(math.sin(angle), -math.cos(angle)) * length
    bodies = [Particle(way * (i + 1), acceleration=GRAVITY) for i in range(n)]
    chain, worst = DirectChain(bodies, Vector3()), 0.0
    for _ in range(round(time * rate)):
        chain.step(1.0 / rate)
        places = [Vector3(), *(body.position for body in bodies)]
        for start, end in pairwise(places):
            worst = max(worst, abs((end - start).magnitude() / length - 1.0))
    return bodies[-1].position, worst


def test_a_chain_of_thirty_keeps_its_lengths_and_its_tip_is_of_the_second_order() -> None:
    tips = []
    for rate in (240, 480, 960):
        tip, stretch = let_go(30, 30.0, rate, 1.0, 0.1)
        assert stretch <= 1e-6
        tips.append(tip)
    coarse, fine = (tips[0] - tips[1]).magnitude(), (tips[1] - tips[2]).magnitude()
    assert 1e-6 < fine < 1e-3
    assert math.log2(coarse / fine) == pytest.approx(2.0, abs=0.15)  # with a part of the next order


def test_one_rod_is_a_pendulum_of_the_second_order() -> None:
    """After a period from 10 degrees it is back at the start, and 90 degrees give 3 m g below."""
    errors = []
    for steps in (200, 400):
        bob = Particle(Vector3(math.sin(math.pi / 18.0), -math.cos(math.pi / 18.0)))
        bob.acceleration = GRAVITY
        chain, start = DirectChain([bob], Vector3()), bob.position.copy()
        for _ in range(3 * steps // 4):
            chain.step(1.99070708 / steps)
        errors.append(abs(bob.position.x))  # at the bottom after three quarters
        assert start.magnitude() == pytest.approx(bob.position.magnitude(), abs=1e-9)
    assert errors[0] < 1e-4
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)
    bob = Particle(Vector3(1.0), acceleration=GRAVITY, mass=2.0)
    chain, pulls = DirectChain([bob], Vector3()), []
    while bob.position.x > 0.0:
        chain.step(1.0 / 960.0)
        pulls.append(chain.tensions[0])
    # Near the bottom the pull is 1 - (angle)^2 / 2, with angles of 4.5 / 960.
    assert pulls[-1] == pytest.approx(60.0, rel=1e-4)
    assert chain.tensions == pulls[-1:]


def test_a_chain_from_horizontal_blows_up_in_long_frames_and_not_in_short_ones() -> None:
    with pytest.raises(ArithmeticError, match="turns too far in one step"):
        let_go(30, 90.0, 60, 3.0, 0.1)
    _, stretch = let_go(30, 90.0, 240, 1.0, 0.1)
    assert stretch < 1e-2
