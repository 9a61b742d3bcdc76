"""A box that rotates freely, against SciPy's solution of Euler's equations."""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from ch02_vectors.vector import Vector3
from ch09_rotations.going_further.free_box import FreeBox
from plots.drawing import slope

SIDES = (0.2, 0.3, 0.1)  # the moments about X, Y and Z have the ratio 10 : 5 : 13
SPEED = 2.0 * math.pi


def thrown(x: float, y: float, z: float) -> FreeBox:
    return FreeBox(1.5, Vector3(*SIDES), Vector3(x, y, z))


def exact(box: FreeBox, duration: float) -> tuple[Any, Any]:
    """Return a new box's own velocity and orientation (r, i, j, k) after a time, by SciPy."""
    inertia = numpy.array([*box.inertia])

    def rates(_: float, state: Any) -> Any:
        w, (r, i, j, k) = state[:3], state[3:]
        turn = numpy.array([[-i, -j, -k], [r, -k, j], [k, r, -i], [-j, i, r]])
        return numpy.concatenate([numpy.cross(inertia * w, w) / inertia, 0.5 * turn @ w])

    start = [*box.own_velocity(), *box.orientation]
    found = solve_ivp(rates, (0.0, duration), start, method="DOP853", rtol=1e-11, atol=1e-13)
    return found.y[:3, -1], found.y[3:, -1]


def test_moments_and_energy_are_those_of_a_cuboid() -> None:
    box = FreeBox(12.0, Vector3(1.0, 2.0, 3.0), Vector3(2.0, 0.0, -1.0))
    assert tuple(box.inertia) == (13.0, 10.0, 5.0)
    assert box.energy() == 0.5 * (13.0 * 4.0 + 5.0 * 1.0)
    assert tuple(box.angular_momentum) == (26.0, 0.0, -5.0)
    assert tuple(box.own_velocity()) == (2.0, 0.0, -1.0)


@pytest.mark.parametrize(
    "velocity",
    [(SPEED, 0.05 * SPEED, 0.0), (1.0, -2.0, 3.0)],
    ids=["turns over", "about all three"],
)
def test_velocity_and_orientation_come_to_scipys_with_the_second_order(
    velocity: tuple[float, float, float],
) -> None:
    wanted, turn = exact(thrown(*velocity), 2.0)
    counts = (240, 480, 960)
    off, turned_off = [], []
    for count in counts:
        box = thrown(*velocity)
        for _ in range(count):
            box.step(2.0 / count)
        off.append(math.dist(box.own_velocity(), wanted))
        turned_off.append(math.dist(box.orientation, turn))
    # The next order is at most a hundredth.
    assert slope(counts, off) == pytest.approx(-2.0, abs=0.02)
    assert slope(counts, turned_off) == pytest.approx(-2.0, abs=0.02)
    # 1.1e-3 rad/s and 9e-5 during a flip, where the motion is fastest.
    assert off[-1] < 1.5e-3
    assert turned_off[-1] < 1.5e-4


@pytest.mark.parametrize("velocity", [(-3.0, 0.0, 0.0), (0.0, 0.0, -3.0), (0.0, 0.0, 0.0)])
def test_a_turn_about_one_axis_alone_is_exact_in_any_step(velocity: tuple[float, ...]) -> None:
    box = thrown(*velocity)
    for step in (0.5, 0.1, 1.4):
        box.step(step)
    wanted = [math.cos(sum(velocity)), *map(math.sin, velocity)]  # of half the angle after 2 s
    # Some 30 roundings of numbers up to 3. The first axis is the middle one.
    assert [*box.orientation] == pytest.approx(wanted, abs=1e-14)
    assert [*box.own_velocity()] == pytest.approx(velocity, abs=1e-14)
