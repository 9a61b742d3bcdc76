"""The last acceleration, and drift and kick, build task B5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import vector
from expect import expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
KICK = "the docstring of kick"
LAST = "the docstring of last_acceleration"
# Numbers up to 100, and a handful of roundings of each.
ROUNDED = 1e-12


@pytest.mark.exercise("B5.2", asks="the sum that the last step used", read=LAST)
def test_the_last_acceleration_includes_the_forces_of_the_step(rng: Random) -> None:
    a, f, g, mass = vector(rng), vector(rng), vector(rng), round(rng.uniform(2.0, 9.0), 3)
    with calls(
        "last_acceleration must be the acceleration of the last step, a + f / m. Here a is the "
        "constant acceleration and f the force, and the damping has no effect."
    ):
        p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
        p.add_force(Vector3(*f))
        p.integrate(0.5)
        got = p.last_acceleration
    wanted = a + f / mass
    slips = {
        "Your result is only the constant acceleration, without the forces of the last step. "
        "kick must store them in self._last_force, and last_acceleration must read them there.": a,
        "Your result is a + f, so the mass is missing.": a + f,
        "Your result is a + f m. Divide the force f by the mass m instead.": a + f * mass,
        "Your result is only f / m.": f / mass,
        "You divide the constant acceleration by the mass, too.": (a + f) / mass,
        "You divide the constant acceleration a by the mass, but not the force f.": a / mass + f,
    }
    expect_close(xyz(got), wanted, slips, unit="m/s^2", tolerance=ROUNDED)
    expect_unchanged(
        "p.acceleration", p.acceleration, a,
        cause="last_acceleration has changed p.acceleration, because += works in place. Use +, "
        "which creates a new vector.",
    )  # fmt: skip
    with calls(
        "last_acceleration contains a force that no step has used yet. Return only the "
        "acceleration of the last step.",
        more=True,
    ):
        p.add_force(Vector3(*g))
        got = p.last_acceleration
    expect_close(xyz(got), wanted, unit="m/s^2", tolerance=ROUNDED)
    with calls(
        "clear_forces has changed last_acceleration. Clear only the forces for the next step, not "
        "those of the last one.",
        more=True,
    ):
        p.clear_forces()
        got = p.last_acceleration
    expect_close(xyz(got), wanted, unit="m/s^2", tolerance=ROUNDED)
    with calls(
        "last_acceleration contains a force of an earlier step. No force acted in the last one, so "
        "return the constant acceleration alone.",
        more=True,
    ):
        p.integrate(0.5)
        got = p.last_acceleration
    expect_close(xyz(got), a, unit="m/s^2", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="Before the first step f is zero", read=LAST)
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = vector(rng), vector(rng)
    with calls(
        "last_acceleration contains a force that no step has used yet. Return only the constant "
        "acceleration before the first step."
    ):
        p = Particle(acceleration=Vector3(*a))
        p.add_force(Vector3(*f))
        got = p.last_acceleration
    expect_close(xyz(got), a, unit="m/s^2")
    own = (
        "last_acceleration returned a vector that belongs to the particle, so the caller could "
        "change it. Return a new vector from every call."
    )
    with calls(own, more=True):
        last = p.last_acceleration
        last.x = 99.0
    expect_unchanged("p.acceleration", p.acceleration, a)
    with calls("After the step, last_acceleration must be a + f / m.", more=True):
        p.integrate(0.5)
        last = p.last_acceleration
        last.x = 99.0
        got = p.last_acceleration
    wanted = a + f
    expect_close(xyz(got), wanted, {own: (99.0, *wanted[1:])}, tolerance=ROUNDED, unit="m/s^2")


@pytest.mark.exercise(
    "B5.2", asks="No force changes the velocity of an immovable particle", read=KICK
)
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = vector(rng), vector(rng), vector(rng), vector(rng)
    h, mass = round(rng.uniform(0.2, 0.8), 3), round(rng.uniform(2.0, 9.0), 3)
    with calls(
        "Your step changed an immovable particle. Check its inverse mass before you change the "
        "position or the velocity."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
        p.add_force(Vector3(*f))
        p.integrate(h)
    expect_unchanged("p.position", p.position, x)
    expect_unchanged("p.velocity", p.velocity, v)
    expect_close(
        xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N",
        cause="kick does not clear the forces on an immovable particle. Clear them in every step, "
        "or they add up until the particle becomes movable.",
    )  # fmt: skip
    expect_close(
        xyz(p.last_acceleration), a, then="; p.last_acceleration", unit="m/s^2",
        cause="last_acceleration contains a force on an immovable particle. Multiply the force by "
        "the inverse mass, which is 0 here.",
    )  # fmt: skip
    with calls(
        "The particle now has a finite mass, so it must move. Only the second force may act on it, "
        "because the first step cleared the first force.",
        more=True,
    ):
        p.mass = mass
        p.add_force(Vector3(*f))
        p.integrate(h)
        got = p.velocity
    expect_close(xyz(got), v + (a + f / mass) * h, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="Apply the acceleration, forces and damping", read=KICK)
def test_forces_act_in_kick_and_not_in_drift(rng: Random) -> None:
    x, v, a, f = vector(rng), vector(rng), vector(rng), vector(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.2, 0.8), 3)
    with calls(
        "drift changed the velocity or the forces. Change only the position, because the forces "
        "act in kick."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        p.add_force(Vector3(*f))
        p.drift(h / 2.0)
    expect_unchanged("p.velocity", p.velocity, v)
    expect_close(xyz(p.force_accumulator), f, then="; p.force_accumulator", unit="N")
    before = xyz(p.position)
    with calls(
        "kick changed the position. Change only the velocity, because drift moves the particle.",
        more=True,
    ):
        p.kick(h)
    expect_unchanged("p.position", p.position, before)
    total = a + f / mass
    expect_close(
        xyz(p.velocity), v + total * h, then="; p.velocity", unit="m/s", tolerance=ROUNDED,
        cause="The velocity after kick is wrong. It must be v + (a + f / m) h, where f is the "
        "force, m the mass and h the duration.",
    )  # fmt: skip
    expect_close(
        xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N",
        cause="The force is still there after kick. It acts only once, so set the sum of the "
        "forces to zero.",
    )  # fmt: skip
    with calls(
        "The drift after the kick changed last_acceleration. Keep the acceleration that the last "
        "kick used.",
        more=True,
    ):
        p.drift(h / 2.0)
        got = p.last_acceleration
    expect_close(xyz(got), total, unit="m/s^2", tolerance=ROUNDED)
    expect_close(
        xyz(p.position), x + v * h + total * h * h / 2.0,
        then="; p.position", unit="m", tolerance=ROUNDED,
        cause="With a constant force, drift for h / 2, kick for h and drift for h / 2 must give "
        "the exact position. Check by how much each of them moves the particle.",
    )  # fmt: skip
