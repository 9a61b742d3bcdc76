"""The last acceleration, drift and kick, and the refused steps, build task B5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import components
from expect import about, blame, expect_close, expect_error, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
# Numbers up to 100, and a handful of roundings of each.
ROUNDED = 1e-12


@pytest.mark.exercise("B5.2")
def test_the_last_acceleration_includes_the_forces_of_the_step(rng: Random) -> None:
    a, f, g, mass = (
        components(rng),
        components(rng),
        components(rng),
        round(rng.uniform(2.0, 9.0), 3),
    )
    about.call = f"p = Particle(acceleration=Vector3{a}, mass={mass}, damping=0.5); "
    about.call += f"p.add_force(Vector3{f}); p.integrate(0.5)"
    about.cause = "last_acceleration must be the acceleration of the last step, a + f / m. Here a "
    about.cause += "is the constant acceleration and f the force, and the damping has no effect."
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple(a[i] + f[i] / mass for i in range(3))
    got = xyz(p.last_acceleration)
    slips = {
        "This is only the constant acceleration. In kick, store the forces that the step uses "
        "in self._forces[1], where last_acceleration reads them.": a,
        "This is a + f, so the mass is missing. Divide the force f by the mass.": [
            a[i] + f[i] for i in range(3)
        ],
        (
            "This is a + f m, but a force f causes the acceleration f / m. Divide by the mass "
            "m instead of multiplying."
        ): [a[i] + f[i] * mass for i in range(3)],
        "This is only f / m. Add the constant acceleration to it.": [f[i] / mass for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.last_acceleration, in m/s^2", tolerance=ROUNDED)
    about.cause = "The force that was added last is meant for the next step, so it must not "
    about.cause += "change the acceleration of the last one. Store the forces of the last step "
    about.cause += "separately."
    p.add_force(Vector3(*g))
    got = xyz(p.last_acceleration)
    expect_close(
        got,
        wanted,
        then=f"; p.add_force(Vector3{g}); p.last_acceleration, in m/s^2",
        tolerance=ROUNDED,
    )
    about.cause = "clear_forces has changed last_acceleration. It must clear only the forces for "
    about.cause += "the next step, not those of the last one."
    p.clear_forces()
    got = xyz(p.last_acceleration)
    expect_close(
        got, wanted, then="; p.clear_forces(); p.last_acceleration, in m/s^2", tolerance=ROUNDED
    )
    about.cause = "No force acted in the last step. last_acceleration must therefore be the "
    about.cause += "constant acceleration alone."
    p.integrate(0.5)
    expect_close(
        xyz(p.last_acceleration),
        a,
        then="; p.integrate(0.5); p.last_acceleration, in m/s^2",
        tolerance=ROUNDED,
    )


@pytest.mark.exercise("B5.2")
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = components(rng), components(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}); p.add_force(Vector3{f}); "
    about.call += "p.last_acceleration"
    about(
        cause="No step has used the force yet. last_acceleration must therefore still be "
        "the constant acceleration.",
        read="the docstring of last_acceleration",
    )
    p = Particle(acceleration=Vector3(*a))
    p.add_force(Vector3(*f))
    last = p.last_acceleration
    expect_close(xyz(last), a)
    last.x = 99.0
    about.cause = "A change of the vector that last_acceleration returned must not change the "
    about.cause += "particle. Return a new vector from every call."
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then=".x = 99.0")
    p.integrate(0.5)
    last = p.last_acceleration
    last.x = 99.0
    wanted = tuple(a[i] + f[i] for i in range(3))
    name = f"{about.call[: about.call.rindex(';')]}; p.integrate(0.5); p.last_acceleration.x = "
    name += "99.0; p.last_acceleration, in m/s^2"
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, call=name, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    h, mass = round(rng.uniform(0.2, 0.8), 3), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, acceleration=Vector3{a}, "
    about.call += f"mass=math.inf); p.add_force(Vector3{f}); p.integrate({h})"
    about(
        cause="An immovable particle must not move. Check the inverse mass before you "
        "change the position or the velocity.",
        read="the docstring of kick",
    )
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
    p.add_force(Vector3(*f))
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = "The forces on the immovable particle were not cleared. Clear them in every "
    about.cause += "step, because otherwise they add up until the particle becomes movable."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator, in N")
    about.cause = "Forces don't accelerate an immovable particle. Its last_acceleration must "
    about.cause += "therefore be the constant acceleration alone."
    expect_close(xyz(p.last_acceleration), a, then="; p.last_acceleration, in m/s^2")
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(h)
    about.call += f"; p.mass = {mass}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity, in "
    about.call += "m/s"
    about.cause = "The particle now has a finite mass, so it must move. Only the second force may "
    about.cause += "act on it, because the step before has cleared the first."
    wanted = tuple(v[i] + (a[i] + f[i] / mass) * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_drift_leaves_the_forces_to_the_kick(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.2, 0.8), 3)
    words = f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, acceleration=Vector3{a}, "
    words += f"mass={mass})"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
    about(f"{words}; p.add_force(Vector3{f}); p.drift({h} / 2)", read="the docstring of kick")
    p.add_force(Vector3(*f))
    p.drift(h / 2.0)
    about.cause = "drift changed the velocity or the forces. It must change only the position, "
    about.cause += "because the forces act in kick."
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    got = xyz(p.force_accumulator)
    expect_close(got, f, then="; p.force_accumulator, in N")
    about.call += f"; p.kick({h})"
    before = xyz(p.position)
    p.kick(h)
    about.cause = "kick must change only the velocity, to (v + (a + f / m) h) d^h. Here f is the "
    about.cause += "force, m the mass, h the duration and d the damping."
    expect_unchanged("p.position", xyz(p.position), before)
    total = [a[i] + f[i] / mass for i in range(3)]
    wanted = tuple(v[i] + total[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity, in m/s", tolerance=ROUNDED)
    about.cause = "The forces are still there after kick. Each force acts only once, so kick must "
    about.cause += "set their sum to zero."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator, in N")
    about.cause = "last_acceleration must be the acceleration that the last kick used. A drift "
    about.cause += "after the kick must not change it."
    about.call += f"; p.drift({h} / 2)"
    p.drift(h / 2.0)
    got = xyz(p.last_acceleration)
    expect_close(got, total, then="; p.last_acceleration, in m/s^2", tolerance=ROUNDED)
    about.cause = "With a constant force, drift for h / 2, kick for h and drift for h / 2 must "
    about.cause += "give the exact position. Check by how much each of them moves the particle."
    wanted = tuple(x[i] + v[i] * h + total[i] * h * h / 2.0 for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position, in m", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_refused_step_keeps_the_forces(duration: float) -> None:
    about.read = "the docstring of kick"
    error = TypeError if isinstance(duration, str) else ValueError
    x, v, a, f = (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0), (1.0, -2.0, 3.0)
    for mass in (2.0, math.inf):
        words = f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, acceleration=Vector3{a}, "
        words += f"mass={mass})"
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        about.cause = "The duration must be positive and finite. Check it in integrate before "
        about.cause += "anything else."
        about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({duration!r})"
        p.add_force(Vector3(*f))
        expect_error(
            lambda p=p: p.integrate(duration), error, allowed=lambda: Particle().integrate(0.5)
        )
        about.cause = "integrate raised an error because of the duration, but it changed the "
        about.cause += "particle anyway. Check the duration before you change anything."
        expect_unchanged("p.position", xyz(p.position), x)
        expect_unchanged("p.velocity", xyz(p.velocity), v)
        expect_unchanged("p.acceleration", xyz(p.acceleration), a)
        got = xyz(p.force_accumulator)
        expect_close(got, f, then="; p.force_accumulator, in N")
        got = xyz(p.last_acceleration)
        expect_close(got, a, then="; p.last_acceleration, in m/s^2")
