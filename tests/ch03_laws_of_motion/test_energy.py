"""The kinetic energy of a particle, exercise 3.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import components, dot
from expect import UNCHANGED, about, blame, expect_close, expect_unchanged, xyz


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 900.0), rng.uniform(0.01, 0.5))), 3)


@pytest.mark.exercise("3.3", asks="the kinetic energy of the particle, m |v|^2 / 2")
def test_kinetic_energy_is_half_of_m_v_squared(rng: Random) -> None:
    mass, x, v = draw_mass(rng), components(rng), components(rng)
    about.call = (
        f"p = Particle(Vector3{x}, Vector3{v}, mass={mass}, damping=0.5); p.kinetic_energy()"
    )
    about.cause = (
        "The kinetic energy is m |v|^2 / 2, where m is the mass and |v| the speed. Check each "
        "factor of your formula against it."
    )
    about.read = "book 3, exercise 3.3"
    p = Particle(Vector3(*x), Vector3(*v), mass=mass, damping=0.5)
    try:
        got, squared = p.kinetic_energy(), dot(v, v)
    except TypeError as error:
        if "for **" in str(error):
            about.cause = (
                "A vector has no power, so ** does not work for it. Use "
                "self.velocity.squared_magnitude() for |v|^2."
            )
        raise
    mistakes = [
        (0.0, "Your result is 0. In Python 1 // 2 is 0, so write 0.5 * m or m / 2 instead."),
        (
            mass * squared // 2.0,
            "You divide with //, which rounds down to a whole number. Use / instead.",
        ),
        (
            0.5 * mass * dot(x, x),
            "You use the position instead of the velocity. The kinetic energy is m |v|^2 / 2.",
        ),
        (0.5 * squared, "You leave out the mass. The kinetic energy is m |v|^2 / 2."),
        (
            0.5 * mass * mass * squared,
            "You square the mass as well. Square only the speed: m |v|^2 / 2.",
        ),
        (
            mass * squared,
            "You return m |v|^2, without the factor 1/2. The kinetic energy is m |v|^2 / 2.",
        ),
        (
            0.5 * mass * math.sqrt(squared),
            "You return m |v| / 2. Square the speed |v|, because the kinetic energy is m |v|^2 / "
            "2.",
        ),
        (
            0.5 / mass * squared,
            "You multiply by the inverse mass instead of the mass. Use self.mass, because the "
            "kinetic energy is m |v|^2 / 2.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, 0.5 * mass * squared)
    expect_unchanged("p.velocity", xyz(p.velocity), v, cause=UNCHANGED)


@pytest.mark.exercise("3.3", asks="the kinetic energy of the particle, m |v|^2 / 2")
def test_a_kilogram_at_2_meters_a_second_has_2_joules() -> None:
    about.call = "p = Particle(velocity=Vector3(0, 0, -2), mass=1.0); p.kinetic_energy()"
    about.cause = (
        "The kinetic energy must be 1 kg * (2 m/s)^2 / 2 = 2 J. It doesn't depend on the direction "
        "of the velocity, so it is never negative."
    )
    about.read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(0, 0, -2), mass=1.0)
    expect_close(p.kinetic_energy(), 2.0)


@pytest.mark.exercise("3.3", asks="so its kinetic energy is 0")
def test_an_immovable_particle_has_no_kinetic_energy(rng: Random) -> None:
    v = components(rng)
    about.cause = (
        "If you multiply by an infinite mass, you get infinity or NaN. Return 0.0 if "
        "has_finite_mass is False, because a particle that cannot move has no kinetic energy."
    )
    about.read = "the docstring of kinetic_energy"
    for velocity in ((0.0, 0.0, 0.0), v):
        about.call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.kinetic_energy()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(p.kinetic_energy(), 0.0)
