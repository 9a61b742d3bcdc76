"""The acceleration of the last step, build task B5.2."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import components
from expect import UNCHANGED, about, blame, expect_close, expect_unchanged, xyz

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
    about.cause = "Return the acceleration of the last step, which is a + f / m. The damping is "
    about.cause += "not a part of it."
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple(a[i] + f[i] / mass for i in range(3))
    got = xyz(p.last_acceleration)
    slips = {
        "This is only the constant acceleration. The kick must store the forces that it uses in "
        "self._forces[1], because last_acceleration reads them there.": a,
        "This is a + f, so the mass is missing. Divide the force by the mass.": [
            a[i] + f[i] for i in range(3)
        ],
        "This is a + f m. Divide the force by the mass instead of multiplying.": [
            a[i] + f[i] * mass for i in range(3)
        ],
        "This is f / m only. Add the constant acceleration.": [f[i] / mass for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.last_acceleration", tolerance=ROUNDED)
    about.cause = "The added force is for the next step, so it must not change the acceleration of "
    about.cause += "the last one. Store the forces of the last step separately."
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
    about.cause = "When the caller changes the returned vector, the particle must stay the same. "
    about.cause += "Return a new vector on every call."
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then=".x = 99.0", cause=UNCHANGED)
    p.integrate(0.5)
    last = p.last_acceleration
    last.x = 99.0
    wanted = tuple(a[i] + f[i] for i in range(3))
    name = f"{about.call[: about.call.rindex(';')]}; p.integrate(0.5); p.last_acceleration.x = 99.0"
    name += "; p.last_acceleration"
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, call=name, tolerance=ROUNDED)
