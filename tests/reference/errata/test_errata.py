"""Errata that can be run: the printed form fails, and the correct form next to it does not.

The name of each test starts with the number of its entry in errata.md, which says how sure it is.
"""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3, make_orthonormal_basis
from ch03_laws_of_motion.damping import damp_per_second
from ch03_laws_of_motion.exercises import speed_ratio
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import SHOT_TYPES, BallisticRange
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass
from ch05_forces.forces import ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle as ForcedParticle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import AnchoredBungee, AnchoredSpring, Buoyancy, FakeStiffSpring

FRAME = 1.0 / 60.0


def force_at(generator: ForceGenerator, x: float, y: float = 0.0) -> Vector3:
    """Return the force on a particle of 1 kg that is at rest at this position."""
    particle = ForcedParticle(Vector3(x, y))
    generator.update_force(particle, FRAME)
    return particle.force_accumulator


def test_e14_the_printed_invert_sets_x_twice() -> None:
    printed = Vector3(1.0, 2.0, 3.0)
    printed.x = -printed.x
    printed.y = -printed.y
    printed.x = -printed.z
    right = Vector3(1.0, 2.0, 3.0)
    right.invert()
    assert tuple(printed) == (-3.0, -2.0, 3.0)
    assert tuple(right) == (-1.0, -2.0, -3.0)


def test_e15_the_printed_part_at_right_angles_needs_a_unit_vector() -> None:
    a, b = Vector3(1.0, 0.0, 0.0), Vector3(4.0, 3.0, 0.0)  # |a| = 1, |b| = 5, a . b = 4
    assert a.cross(b).magnitude() == 3.0
    with pytest.raises(ValueError, match=r"math domain|nonnegative"):
        math.sqrt(1.0 - a.dot(b) ** 2)  # printed for any b
    assert math.sqrt(b.squared_magnitude() - a.dot(b) ** 2) == 3.0
    unit = b.normalized()
    assert math.sqrt(1.0 - a.dot(unit) ** 2) == pytest.approx(a.cross(unit).magnitude(), rel=1e-15)


def test_e46_the_printed_test_for_parallel_vectors_misses_them_by_rounding() -> None:
    a, b = Vector3(0.1, 0.2, 0.3), Vector3(0.7, 1.4, 2.1)
    product = a.cross(b)
    assert product.squared_magnitude() != 0.0  # the printed test accepts them
    assert product.magnitude() == pytest.approx(6.2e-17, abs=5e-19)  # the known digits
    with pytest.raises(ValueError, match="must not be parallel"):
        make_orthonormal_basis(a, b)


def test_e1_the_printed_second_law_makes_the_heavier_particle_the_faster_one() -> None:
    force, speeds, printed = Vector3(6.0, 0.0, 0.0), [], []
    for mass in (2.0, 1.0):
        particle = Particle(acceleration=force / mass, mass=mass)
        particle.integrate(1.0)
        speeds.append(particle.velocity.magnitude())
        printed.append((force * mass).magnitude())  # proportional to force and mass, for 1 s
    assert printed[0] / printed[1] == 2.0
    assert speeds[0] / speeds[1] == 0.5
    assert speed_ratio(2.0, 1.0) == 0.5


def test_e16_the_equation_and_the_listing_reach_two_terminal_speeds() -> None:
    gravity, damping, h = Vector3(0.0, -9.81, 0.0), 0.9, 1.0 / 60.0
    particle, by_equation = Particle(acceleration=gravity, damping=damping), Vector3()
    for _ in range(400 * 60):  # after 400 s, 0.9^400 of the terminal speed is missing
        particle.integrate(h)
        by_equation = damp_per_second(by_equation, gravity, damping, h)
    assert -by_equation.y == pytest.approx(93.191, abs=5e-4)
    assert -particle.velocity.y == pytest.approx(93.027, abs=5e-4)
    exact = 9.81 / -math.log(damping)  # from dv/dt = g - k v = 0
    assert exact == pytest.approx(93.109, abs=5e-4)
    middle = (-by_equation.y - particle.velocity.y) / 2.0
    assert middle == pytest.approx(exact, abs=1e-4)  # to first order, the errors are opposite


def test_e17_the_printed_order_of_updates_is_explicit_euler() -> None:
    stiffness, h, steps = 100.0, 1.0 / 60.0, 600  # a spring with 1 kg, for 10 s
    explicit = Particle(Vector3(1.0, 0.0, 0.0))
    x, v = 1.0, 0.0  # the other order, which the printed name could mean
    for _ in range(steps):
        explicit.acceleration = explicit.position * -stiffness
        explicit.integrate(h)
        v -= stiffness * x * h
        x += v * h

    def energy(x: float, v: float) -> float:
        return 0.5 * v * v + 0.5 * stiffness * x * x

    grown = energy(explicit.position.x, explicit.velocity.x) / energy(1.0, 0.0)
    # Explicit Euler multiplies the energy by 1 + k h^2 / m in every step, with 600 roundings.
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


def test_e19_only_one_of_the_two_ratios_keeps_the_energy() -> None:
    mass, speed, slow = 0.005, 500.0, 25.0
    by_text, by_footnote = slowed_mass(mass, speed / slow), slowed_mass(mass, slow / speed)
    assert muzzle_energy(by_text, slow) == muzzle_energy(mass, speed)
    assert by_text == 2.0
    assert by_footnote == pytest.approx(12.5e-6, rel=1e-15)


def test_e20_a_ring_overwrites_what_still_burns() -> None:
    rules = [FireworkRule(i, 9, 9, (0, 9, 0), (0, 9, 0), 1.0) for i in range(1, 6)]
    ring: list[int] = [0, 0, 0]  # the listing uses the next slot, even if it is in use
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
    assert (frames_past_100, frames) == (61, 122)  # 1.0 s and 2.0 s; damping adds 1 %


def test_e3_the_printed_spring_pulls_what_is_compressed() -> None:
    k, rest, length = 10.0, 2.0, 1.0
    printed = -(abs(length - rest) * k)  # along the offset, toward the other end
    assert printed == -10.0
    assert force_at(AnchoredSpring(Vector3(), k, rest), length).x == 10.0


def test_e4_the_printed_bungee_pushes_what_it_should_pull() -> None:
    k, rest, length = 5.0, 1.0, 1.5
    printed = -(k * (rest - length))
    assert printed == 2.5
    assert force_at(AnchoredBungee(Vector3(), k, rest), length).x == -2.5


def test_e5_the_printed_lift_pulls_a_float_under() -> None:
    density, volume, s, water, y = 1000.0, 0.001, 0.1, 0.0, 0.0  # half submerged
    share = (y - water - s) / (2.0 * s)  # the formula
    listing = density * volume * (y - s - water) / 2.0 * s  # without parentheses and g
    right = force_at(Buoyancy(s, volume, water, density, 10.0), 0.0, y)
    assert share == -0.5
    assert listing == pytest.approx(-0.005, rel=1e-15)  # one rounding
    assert right.y == pytest.approx(5.0, rel=1e-15)


def test_e6_the_printed_force_of_a_faked_spring_lands_nowhere() -> None:
    k, h = 400.0, FRAME
    target = math.cos(20.0 * h)  # from rest at 1 m with 1 kg, where chi is 20
    listing = (target - 1.0) * (1.0 / h * h) - 0.0 * h
    particle, faked = ForcedParticle(Vector3(1.0)), FakeStiffSpring(Vector3(), k, 0.0)
    registry = ForceRegistry()
    registry.add(particle, faked)
    assert listing == pytest.approx(-0.055, abs=5e-4)
    assert force_at(faked, 1.0).x == pytest.approx(-198.155, abs=5e-4)
    semi_implicit_euler([particle], registry.update_forces, h)
    assert particle.position.x == pytest.approx(target, abs=1e-15)  # a rounding or two of 1 m
    # In the second step the particle moves. With v in place of v / h, as in our copy of Eq. 6.5, it
    # overshoots.
    speed = particle.velocity.x
    target, _ = damped_spring_state(target, speed, k, 0.0, 1.0, h)
    undivided = (target - particle.position.x) / h**2 - speed
    missed = particle.position.x + (speed + undivided * h) * h - target
    semi_implicit_euler([particle], registry.update_forces, h)
    assert particle.position.x == pytest.approx(target, abs=1e-15)
    assert missed == pytest.approx(speed * h * (1.0 - h), abs=1e-15)
    assert abs(missed) > 0.05


def test_e23_the_printed_form_has_the_under_damped_spring_alone() -> None:
    with pytest.raises(ValueError, match=r"math domain|nonnegative"):
        0.5 * math.sqrt(4.0 * 1.0 - 10.0**2)  # k 1, d 10
    assert 0.5 * math.sqrt(4.0 * 1.0 - 2.0**2) == 0.0  # k 1, d 2: the listing adds no force
    over, _ = damped_spring_state(1.0, 0.0, 1.0, 10.0, 1.0, 2.0)
    critical, _ = damped_spring_state(1.0, 0.0, 1.0, 2.0, 1.0, 2.0)
    creep, fast = 5.0 - math.sqrt(24.0), 5.0 + math.sqrt(24.0)
    wanted = (fast * math.exp(-2.0 * creep) - creep * math.exp(-2.0 * fast)) / (fast - creep)
    assert over == pytest.approx(wanted, rel=1e-13)  # subtracting the rates loses two digits
    assert critical == pytest.approx(3.0 * math.exp(-2.0), rel=1e-15)
    faked = force_at(FakeStiffSpring(Vector3(), 1.0, 2.0), 1.0)
    # About half of -k x, because the push lasts the whole frame. The difference loses four digits.
    wanted = ((1.0 + FRAME) * math.exp(-FRAME) - 1.0) / FRAME**2
    assert faked.x == pytest.approx(wanted, rel=1e-11)


def test_e21_a_liter_is_lifted_by_newtons_not_kilonewtons() -> None:
    liter = Buoyancy(0.1, 0.001, 0.0, gravity=10.0)
    lifts = [force_at(liter, 0.0, y).y for y in (-1.0, 0.0)]  # fully and half submerged
    assert lifts == [10.0, 5.0]  # 10 kN and 5 kN with the printed form
