"""The last acceleration, drift and kick, and the refused steps, build task B5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import components
from expect import about, blame, expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
# Numbers up to 100, and a handful of roundings of each.
ROUNDED = 1e-12


@pytest.mark.exercise("B5.2", asks="the sum that the last step used")
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
        "Your result is only the constant acceleration, without the forces of the last step. "
        "kick must store them in self._last_force, and last_acceleration must read them there.": a,
        "Your result is a + f, so the mass is missing. Divide the force f by the mass.": [
            a[i] + f[i] for i in range(3)
        ],
        "Your result is a + f m. Divide the force f by the mass m instead of multiplying.": [
            a[i] + f[i] * mass for i in range(3)
        ],
        "Your result is only f / m. Add the constant acceleration a.": [
            f[i] / mass for i in range(3)
        ],
        "You divide the constant acceleration by the mass, too. Divide only the force f, because "
        "the result must be a + f / m.": [(a[i] + f[i]) / mass for i in range(3)],
        "You divide the constant acceleration a by the mass, but not the force f. The result must "
        "be a + f / m.": [a[i] / mass + f[i] for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.last_acceleration", unit="m/s^2", tolerance=ROUNDED)
    about.cause = "last_acceleration has changed p.acceleration, because += works in place. Use +, "
    about.cause += "which creates a new vector."
    then = "; p.last_acceleration"
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then=then)
    about.cause = "last_acceleration contains a force that no step has used yet. Return only the "
    about.cause += "acceleration of the last step."
    p.add_force(Vector3(*g))
    got = xyz(p.last_acceleration)
    expect_close(
        got,
        wanted,
        then=f"; p.add_force(Vector3{g}); p.last_acceleration",
        unit="m/s^2",
        tolerance=ROUNDED,
    )
    about.cause = "clear_forces has changed last_acceleration. Clear only the forces for the next "
    about.cause += "step, not those of the last one."
    p.clear_forces()
    got = xyz(p.last_acceleration)
    expect_close(
        got, wanted, then="; p.clear_forces(); p.last_acceleration", unit="m/s^2", tolerance=ROUNDED
    )
    p.integrate(0.5)
    about.call += "; p.clear_forces(); p.integrate(0.5)"
    got = xyz(p.last_acceleration)
    about.cause = "last_acceleration contains a force of an earlier step. No force acted in the "
    about.cause += "last one, so return the constant acceleration alone."
    expect_close(
        got,
        a,
        then="; p.last_acceleration",
        unit="m/s^2",
        tolerance=ROUNDED,
    )


@pytest.mark.exercise("B5.2", asks="Before the first step f is zero")
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = components(rng), components(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}); p.add_force(Vector3{f}); "
    about.call += "last = p.last_acceleration"
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a))
    p.add_force(Vector3(*f))
    last = p.last_acceleration
    about.cause = "last_acceleration contains a force that no step has used yet. Return only the "
    about.cause += "constant acceleration before the first step."
    expect_close(xyz(last), a, unit="m/s^2")
    last.x = 99.0
    about.cause = "last_acceleration returned a vector that belongs to the particle, so the caller "
    about.cause += "could change it. Return a new vector from every call."
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then="; last.x = 99.0")
    p.integrate(0.5)
    last = p.last_acceleration
    last.x = 99.0
    wanted = tuple(a[i] + f[i] for i in range(3))
    name = f"{about.call[: about.call.rindex(';')]}; p.integrate(0.5); last = "
    name += "p.last_acceleration; last.x = 99.0; p.last_acceleration"
    got = xyz(p.last_acceleration)
    own, about.cause = about.cause, "After the step, last_acceleration must be a + f / m."
    blame(got, [((99.0, *wanted[1:]), own)])
    expect_close(got, wanted, call=name, tolerance=ROUNDED, unit="m/s^2")


@pytest.mark.exercise("B5.2", asks="No force changes the velocity of an immovable particle")
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    h, mass = round(rng.uniform(0.2, 0.8), 3), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, acceleration=Vector3{a}, "
    about.call += f"mass=math.inf); p.add_force(Vector3{f}); p.integrate({h})"
    about(
        cause="Your step changed an immovable particle. Check its inverse mass before you change "
        "the position or the velocity.",
        read="the docstring of kick",
    )
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
    p.add_force(Vector3(*f))
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = "kick does not clear the forces on an immovable particle. Clear them in every "
    about.cause += "step, or they add up until the particle becomes movable."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator", unit="N")
    about.cause = "last_acceleration contains a force on an immovable particle. Multiply the "
    about.cause += "force by the inverse mass, which is 0 here."
    expect_close(xyz(p.last_acceleration), a, then="; p.last_acceleration", unit="m/s^2")
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(h)
    about.call += f"; p.mass = {mass}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity"
    about.cause = "The particle now has a finite mass, so it must move. Only the second force may "
    about.cause += "act on it, because the first step cleared the first force."
    wanted = tuple(v[i] + (a[i] + f[i] / mass) * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="Apply the acceleration, forces and damping")
def test_forces_act_in_kick_and_not_in_drift(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.2, 0.8), 3)
    words = f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, acceleration=Vector3{a}, "
    words += f"mass={mass})"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
    about(f"{words}; p.add_force(Vector3{f}); p.drift({h} / 2)", read="the docstring of kick")
    p.add_force(Vector3(*f))
    p.drift(h / 2.0)
    about.cause = "drift changed the velocity or the forces. Change only the position, because "
    about.cause += "the forces act in kick."
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    got = xyz(p.force_accumulator)
    expect_close(got, f, then="; p.force_accumulator", unit="N")
    about.call += f"; p.kick({h})"
    before = xyz(p.position)
    p.kick(h)
    about.cause = "kick changed the position. Change only the velocity, because drift moves the "
    about.cause += "particle."
    expect_unchanged("p.position", xyz(p.position), before)
    about.cause = "The velocity after kick is wrong. It must be v + (a + f / m) h, where f is the "
    about.cause += "force, m the mass and h the duration."
    total = [a[i] + f[i] / mass for i in range(3)]
    wanted = tuple(v[i] + total[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    about.cause = "The force is still there after kick. It acts only once, so set the sum of the "
    about.cause += "forces to zero."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator", unit="N")
    about.cause = "The drift after the kick changed last_acceleration. Keep the acceleration that "
    about.cause += "the last kick used."
    about.call += f"; p.drift({h} / 2)"
    p.drift(h / 2.0)
    got = xyz(p.last_acceleration)
    expect_close(got, total, then="; p.last_acceleration", unit="m/s^2", tolerance=ROUNDED)
    about.cause = "With a constant force, drift for h / 2, kick for h and drift for h / 2 must "
    about.cause += "give the exact position. Check by how much each of them moves the particle."
    wanted = tuple(x[i] + v[i] * h + total[i] * h * h / 2.0 for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", unit="m", tolerance=ROUNDED)
