"""Where the printed book is wrong and the difference can run: the printed form, shown failing.

Each test has the number of the erratum in errata.md in its name.
"""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_second
from ch03_laws_of_motion.exercises import speed_ratio
from ch03_laws_of_motion.particle import Particle


def test_e14_the_printed_invert_sets_x_twice() -> None:
    printed = Vector3(1.0, 2.0, 3.0)
    printed.x = -printed.x
    printed.y = -printed.y
    printed.x = -printed.z
    right = Vector3(1.0, 2.0, 3.0)
    right.invert()
    assert tuple(printed) == (-3.0, -2.0, 3.0)
    assert tuple(right) == (-1.0, -2.0, -3.0)


def test_e15_the_printed_length_of_a_vector_product_wants_unit_vectors() -> None:
    a, b = Vector3(1.0, 0.0, 0.0), Vector3(4.0, 3.0, 0.0)  # |a| = 1, |b| = 5, a . b = 4
    assert a.cross(b).magnitude() == 3.0
    with pytest.raises(ValueError, match=r"math domain|nonnegative"):
        math.sqrt(1.0 - a.dot(b) ** 2)  # printed: right for two unit vectors only
    assert math.sqrt(b.squared_magnitude() - a.dot(b) ** 2) == 3.0  # right for a unit vector a


def test_e15_the_printed_form_holds_for_unit_vectors() -> None:
    a, b = Vector3(1.0, 0.0, 0.0), Vector3(0.8, 0.6, 0.0)
    printed = math.sqrt(1.0 - a.dot(b) ** 2)
    assert printed == pytest.approx(a.cross(b).magnitude(), rel=1e-15)  # one rounding


def test_e1_the_printed_second_law_makes_the_heavier_particle_the_faster_one() -> None:
    force, speeds, printed = Vector3(6.0, 0.0, 0.0), [], []
    for mass in (2.0, 1.0):
        particle = Particle(acceleration=force / mass, mass=mass)
        particle.integrate(1.0)
        speeds.append(particle.velocity.magnitude())
        printed.append((force * mass).magnitude())  # in proportion to force and mass, for 1 s
    assert printed[0] / printed[1] == 2.0
    assert speeds[0] / speeds[1] == 0.5
    assert speed_ratio(2.0, 1.0) == 0.5


def test_e16_the_equation_and_the_listing_reach_two_terminal_speeds() -> None:
    gravity, damping, h = Vector3(0.0, -9.81, 0.0), 0.9, 1.0 / 60.0
    particle, by_equation = Particle(acceleration=gravity, damping=damping), Vector3()
    for _ in range(400 * 60):  # 400 s: what is missing of the terminal speed is 0.9^400 of it
        particle.integrate(h)
        by_equation = damp_per_second(by_equation, gravity, damping, h)
    assert -by_equation.y == pytest.approx(93.191, abs=5e-4)
    assert -particle.velocity.y == pytest.approx(93.027, abs=5e-4)
    exact = 9.81 / -math.log(damping)  # dv/dt = g - k v = 0
    assert exact == pytest.approx(93.109, abs=5e-4)
    middle = (-by_equation.y - particle.velocity.y) / 2.0
    assert middle == pytest.approx(exact, abs=1e-4)  # to first order in h they err alike


def test_e17_the_printed_order_of_updates_is_explicit_euler() -> None:
    stiffness, h, steps = 100.0, 1.0 / 60.0, 600  # a spring, 1 kg, 10 s
    explicit = Particle(Vector3(1.0, 0.0, 0.0))
    x, v = 1.0, 0.0  # the other order, which the printed name could be taken for
    for _ in range(steps):
        explicit.acceleration = explicit.position * -stiffness
        explicit.integrate(h)
        v -= stiffness * x * h
        x += v * h

    def energy(x: float, v: float) -> float:
        return 0.5 * v * v + 0.5 * stiffness * x * x

    grown = energy(explicit.position.x, explicit.velocity.x) / energy(1.0, 0.0)
    # Explicit Euler multiplies the energy by 1 + k h^2 / m in every step; 600 roundings.
    assert grown == pytest.approx((1.0 + stiffness * h * h) ** steps, rel=1e-11)
    assert grown == pytest.approx(1.38e7, rel=2e-3)
    assert energy(x, v) / energy(1.0, 0.0) == pytest.approx(1.06, abs=5e-3)
