"""The last acceleration, drift and kick, and the refused steps, build task B5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import components
from expect import UNCHANGED, about, blame, expect_close, expect_error, expect_unchanged, xyz

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
    about.cause = "last_acceleration must be the acceleration of the last step, a + f / m. The "
    about.cause += "damping plays no part in it."
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple(a[i] + f[i] / mass for i in range(3))
    got = xyz(p.last_acceleration)
    slips = {
        "This is only the constant acceleration. In the kick, store the forces that it uses in "
        "self._forces[1], where last_acceleration reads them.": a,
        "This is a + f, so the mass is missing. Divide the force by the mass.": [
            a[i] + f[i] for i in range(3)
        ],
        (
            "This is a + f m, but a force causes the acceleration f / m. Divide by the mass "
            "instead of multiplying."
        ): [a[i] + f[i] * mass for i in range(3)],
        "This is only f / m. Add the constant acceleration to it.": [f[i] / mass for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.last_acceleration", tolerance=ROUNDED)
    about.cause = "The new force is meant for the next step, so it must not change the "
    about.cause += "acceleration of the last one. Store the forces of the last step separately."
    p.add_force(Vector3(*g))
    got = xyz(p.last_acceleration)
    expect_close(
        got, wanted, then=f"; p.add_force(Vector3{g}); p.last_acceleration", tolerance=ROUNDED
    )
    about.cause = "clear_forces has changed last_acceleration. It must clear only the forces for "
    about.cause += "the next step."
    p.clear_forces()
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, then="; p.clear_forces(); p.last_acceleration", tolerance=ROUNDED)
    about.cause = "No force acted in the last step, so last_acceleration must be the constant "
    about.cause += "acceleration."
    p.integrate(0.5)
    expect_close(
        xyz(p.last_acceleration),
        a,
        then="; p.integrate(0.5); p.last_acceleration",
        tolerance=ROUNDED,
    )


@pytest.mark.exercise("B5.2")
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = components(rng), components(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}); p.add_force(Vector3{f}); "
    about.call += "p.last_acceleration"
    about(
        cause="No step has used the force yet, so last_acceleration must still be the constant "
        "acceleration.",
        read="the docstring of last_acceleration",
    )
    p = Particle(acceleration=Vector3(*a))
    p.add_force(Vector3(*f))
    last = p.last_acceleration
    expect_close(xyz(last), a)
    last.x = 99.0
    about.cause = "Changing the returned vector must not change the particle. Return a new vector "
    about.cause += "from every call."
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then=".x = 99.0", cause=UNCHANGED)
    p.integrate(0.5)
    last = p.last_acceleration
    last.x = 99.0
    wanted = tuple(a[i] + f[i] for i in range(3))
    name = f"{about.call[: about.call.rindex(';')]}; p.integrate(0.5); p.last_acceleration.x = 99.0"
    name += "; p.last_acceleration"
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, call=name, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    h, mass = round(rng.uniform(0.2, 0.8), 3), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass=math.inf); "
    about.call += f"p.add_force(Vector3{f}); p.integrate({h})"
    about(
        cause="An immovable particle must not move. Check the inverse mass before you change the "
        "position or the velocity.",
        read="the docstring of kick",
    )
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
    p.add_force(Vector3(*f))
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = "The forces on the immovable particle were not cleared. Clear them too, or they "
    about.cause += "will pile up until the particle becomes movable."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator")
    about.cause = "Forces don't accelerate an immovable particle, so its last_acceleration must be "
    about.cause += "the constant acceleration alone."
    expect_close(xyz(p.last_acceleration), a, then="; p.last_acceleration")
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(h)
    about.call += f"; p.mass = {mass}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity"
    about.cause = "The particle now has a finite mass, so it must move. Only the new force may act "
    about.cause += "on it, because the earlier one was cleared."
    wanted = tuple(v[i] + (a[i] + f[i] / mass) * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_drift_leaves_the_forces_to_the_kick(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.2, 0.8), 3)
    words = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass={mass})"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
    about(f"{words}; p.add_force(Vector3{f}); p.drift({h} / 2)", read="the docstring of kick")
    p.add_force(Vector3(*f))
    p.drift(h / 2.0)
    about.cause = "drift changed the velocity or the forces. It must change only the position, and "
    about.cause += "leave the forces to the kick."
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    got = xyz(p.force_accumulator)
    expect_close(got, f, then="; p.force_accumulator")
    about.call += f"; p.kick({h})"
    before = xyz(p.position)
    p.kick(h)
    about.cause = "A kick must change only the velocity, and the new velocity is (v + (a + f / m) "
    about.cause += "h) d^h."
    expect_unchanged("p.position", xyz(p.position), before)
    total = [a[i] + f[i] / mass for i in range(3)]
    wanted = tuple(v[i] + total[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
    about.cause = "The forces are still there after the kick. Each force acts only once, so the "
    about.cause += "kick must clear their sum."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator")
    about.cause = "last_acceleration must be the acceleration that the last kick used. A drift "
    about.cause += "after the kick must not change it."
    about.call += f"; p.drift({h} / 2)"
    p.drift(h / 2.0)
    got = xyz(p.last_acceleration)
    expect_close(got, total, then="; p.last_acceleration", tolerance=ROUNDED)
    about.cause = "With a constant force, half a drift, a kick and another half drift must give "
    about.cause += "the exact position."
    wanted = tuple(x[i] + v[i] * h + total[i] * h * h / 2.0 for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_refused_step_keeps_the_forces(duration: float) -> None:
    about.read = "the docstring of kick"
    error = TypeError if isinstance(duration, str) else ValueError
    x, v, a, f = (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0), (1.0, -2.0, 3.0)
    for mass in (2.0, math.inf):
        words = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass={mass})"
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        about.cause = "The duration must be positive and finite. Make sure that integrate checks "
        about.cause += "it."
        about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({duration!r})"
        p.add_force(Vector3(*f))
        expect_error(
            lambda p=p: p.integrate(duration), error, allowed=lambda: Particle().integrate(0.5)
        )
        about.cause = "The duration was rejected, but the particle changed anyway. Check the "
        about.cause += "duration before you change anything."
        expect_unchanged("p.position", xyz(p.position), x)
        expect_unchanged("p.velocity", xyz(p.velocity), v)
        expect_unchanged("p.acceleration", xyz(p.acceleration), a)
        got = xyz(p.force_accumulator)
        expect_close(got, f, then="; p.force_accumulator")
        got = xyz(p.last_acceleration)
        expect_close(got, a, then="; p.last_acceleration")
