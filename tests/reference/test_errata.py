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
from ch04_particle_engine.ballistics import SHOT_TYPES, BallisticRange
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass


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


def test_e2_the_printed_gravity_bends_the_arc_of_a_slowed_bullet() -> None:
    distance, speed, gravity, factor = 100.0, 500.0, 10.0, 20.0

    def drop(gravity: float, speed: float) -> float:
        return gravity * (distance / speed) ** 2 / 2.0

    real = drop(gravity, speed)
    assert real == pytest.approx(0.2, rel=1e-15)
    assert drop(gravity / factor, speed / factor) == pytest.approx(4.0, rel=1e-15)  # printed
    right = slowed_gravity(gravity, factor)
    assert drop(right, speed / factor) == pytest.approx(real, rel=1e-15)


def test_e18_the_printed_energy_is_twice_the_kinetic_energy() -> None:
    mass, speed = 0.005, 500.0
    bullet = Particle(velocity=Vector3(0.0, 0.0, speed), mass=mass)
    assert mass * speed**2 == 1250.0  # printed
    assert bullet.kinetic_energy() == muzzle_energy(mass, speed) == 625.0


def test_e19_only_one_of_the_two_ratios_keeps_the_energy() -> None:
    mass, speed, slow = 0.005, 500.0, 25.0
    by_text, by_footnote = slowed_mass(mass, speed / slow), slowed_mass(mass, slow / speed)
    assert muzzle_energy(by_text, slow) == muzzle_energy(mass, speed)
    assert by_text == 2.0
    assert by_footnote == pytest.approx(12.5e-6, rel=1e-15)


def test_e20_a_ring_overwrites_what_still_burns() -> None:
    rules = [FireworkRule(i, 9, 9, (0, 9, 0), (0, 9, 0), 1.0) for i in range(1, 6)]
    ring: list[int] = [0, 0, 0]  # the listing: the next slot, whoever has it
    for i in range(5):
        ring[i % 3] = i + 1
    seen = []
    for policy in ("keep_old", "drop_oldest"):
        show = FireworksShow(rules, 3, 1, policy)
        for i in range(5):
            show.launch(i + 1)
        seen.append([firework.type for firework in show.fireworks])
    assert seen == [[1, 2, 3], [3, 4, 5]]
    assert sorted(ring) == seen[1]


def test_e34_the_text_and_the_listing_end_two_ranges() -> None:
    assert SHOT_TYPES["fireball"].velocity == (0.0, 0.0, 10.0)
    at = BallisticRange()
    at.fire("laser")
    frames_past_100 = frames = 0
    laser = at.shots[0].particle
    while at.shots:
        at.update(1.0 / 60.0)
        frames += 1
        if laser.position.z <= 100.0:
            frames_past_100 = frames + 1
    assert (frames_past_100, frames) == (61, 122)  # 1.0 s and 2.0 s, and damping adds 1 %
