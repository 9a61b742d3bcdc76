"""Gravity as a generator, build task B5.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch05_forces.probes import fall
from draw import components
from expect import about, blame, expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)


@pytest.mark.exercise("B5.4")
def test_the_weight_is_mass_times_gravity(rng: Random) -> None:
    g = components(rng)
    about.read = "book 3.2, Eq. 3.4"
    for mass in (round(rng.uniform(2.0, 90.0), 3), 0.125):
        about.call = "p = Particle(velocity=Vector3(5, 6, 7), acceleration=Vector3(1, 2, 3), "
        about.call += (
            f"{mass=}); Gravity(Vector3{g}).update_force(p, 0.5); p.force_accumulator, in N"
        )
        about.cause = "The force must be the weight m g, with all three components of g. Compute "
        about.cause += "it, and add it with add_force."
        vectors = {"velocity": Vector3(5, 6, 7), "acceleration": Vector3(1, 2, 3)}
        p = Particle(**vectors, mass=mass)
        gravity = Gravity(Vector3(*g))
        gravity.update_force(p, 0.5)
        wanted = tuple(mass * g[i] for i in range(3))
        slips = {
            "You add g, which is an acceleration. Multiply it by the mass to get the weight, "
            "which is a force.": g,
            ("You add g / m, but the weight is m g. Multiply by the mass instead of dividing."): [
                g[i] / mass for i in range(3)
            ],
            "You add m g times the duration. Add m g itself, because the step multiplies it by "
            "the duration later.": [mass * g[i] * 0.5 for i in range(3)],
            "Your force points opposite to g. The vector g already points in the direction of "
            "the weight, so don't add a minus sign.": [-mass * g[i] for i in range(3)],
            "Your force has only a y component, but g may point in any direction. Multiply the "
            "whole vector g by the mass.": (
                0.0,
                mass * g[1],
                0.0,
            ),
            "update_force added no force to the particle. Compute the weight m g, and pass it "
            "to particle.add_force.": ZERO,
        }
        got = xyz(p.force_accumulator)
        blame(got, slips)
        expect_close(got, wanted)
        about.cause = "update_force changed the acceleration or the velocity of the particle. It "
        about.cause += "must only add a force, and then the step changes the velocity."
        got = xyz(p.acceleration)
        expect_unchanged("p.acceleration", got, (1, 2, 3))
        got = xyz(p.velocity)
        expect_unchanged("p.velocity", got, (5, 6, 7))
        got = xyz(gravity.acceleration)
        about.cause = "The vector gravity.acceleration has changed, perhaps because you "
        about.cause += "multiplied it with *=, which works in place. Use *, which creates a new "
        about.cause += "vector."
        expect_unchanged("gravity.acceleration", got, g)


@pytest.mark.exercise("B5.4")
def test_gravity_adds_to_the_other_forces_of_the_frame(rng: Random) -> None:
    f, g, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(mass={mass}); p.add_force(Vector3{f}); gravity = "
    about.call += (
        f"Gravity(Vector3{g}); gravity.update_force(p, 0.5) twice; p.force_accumulator, in N"
    )
    about.cause = "The sum must contain the force that was added first, and the weight twice. Use "
    about.cause += "add_force, which adds the weight to the other forces."
    about.read = "the docstring of ForceGenerator"
    p, gravity = Particle(mass=mass), Gravity(Vector3(*g))
    p.add_force(Vector3(*f))
    gravity.update_force(p, 0.5)
    gravity.update_force(p, 0.5)
    wanted = tuple(f[i] + 2 * mass * g[i] for i in range(3))
    got = xyz(p.force_accumulator)
    # Three roundings of numbers up to 200.
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B5.4")
def test_a_new_gravity_counts_from_the_next_frame_on(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"gravity = Gravity(Vector3{first}); gravity.acceleration = Vector3{second}; "
    about.call += "gravity.update_force(Particle(mass=2.0), 0.5)"
    about(
        cause="The check gives the generator a new acceleration after creating it. Read "
        "self.acceleration in every call of update_force.",
        read="the docstring of Gravity",
    )
    p, gravity = Particle(mass=2.0), Gravity(Vector3(*first))
    gravity.acceleration = Vector3(*second)
    gravity.update_force(p, 0.5)
    wanted = tuple(2.0 * second[i] for i in range(3))
    expect_close(xyz(p.force_accumulator), wanted)
    got = xyz(gravity.acceleration)
    about.cause = "update_force has changed gravity.acceleration. Compute the weight with *, "
    about.cause += "which creates a new vector."
    expect_unchanged("gravity.acceleration", got, second)


@pytest.mark.exercise("B5.4")
def test_an_immovable_particle_has_no_weight(rng: Random) -> None:
    g = components(rng)
    about.read = "book 5.2.3"
    about.cause = "An immovable particle has infinite mass, so its weight would be infinite or "
    about.cause += "NaN. Check has_finite_mass first, and add no force if it is False."
    for gravity in (g, (0.0, -10.0, 0.0)):
        about.call = f"p = Particle(mass=math.inf); Gravity(Vector3{gravity}).update_force(p, 0.5)"
        p = Particle(mass=math.inf)
        Gravity(Vector3(*gravity)).update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, ZERO, then="; p.force_accumulator, in N")
    about.cause = "The mass is huge but finite, so the particle has a weight. Check "
    about.cause += "has_finite_mass instead of comparing the mass with a limit."
    about.call = "p = Particle(mass=1e300); Gravity(Vector3(0, -10, 0)).update_force(p, 0.5)"
    p = Particle(mass=1e300)
    Gravity(Vector3(0, -10, 0)).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -1e301, 0.0), then="; p.force_accumulator, in N")


@pytest.mark.exercise("B5.4")
def test_the_generator_does_what_the_constant_acceleration_does(rng: Random) -> None:
    g, mass, damping = components(rng), round(rng.uniform(2.0, 90.0), 3), 0.75
    h, frames = 1.0 / 64.0, 192
    about.call = f"a particle p of {mass} kg with damping {damping} that falls for 3 s with "
    about.call += f"Gravity(Vector3{g}); p.position, in m"
    about.cause = "A step divides the weight m g by m again. The particle must therefore move "
    about.cause += "exactly as if g were its own acceleration."
    about.read = "book 5.3"
    (by_force, velocity), (built_in, built_in_velocity) = fall(g, mass, damping, h, frames)
    # The sum of the geometric series of v' = (v + g h) D, D = d^h.
    kept = damping**h
    gone = (1.0 - kept**frames) / (1.0 - kept)
    speed = h * kept * gone
    way = h * h * kept * (frames - gone) / (1.0 - kept)
    wanted = tuple(g[i] * way for i in range(3))
    # 200 roundings of numbers up to 50.
    expect_close(by_force, wanted, tolerance=1e-11)
    expect_close(by_force, built_in, tolerance=1e-11)
    name = f"{about.call.partition(';')[0]}; p.velocity, in m/s"
    wanted = tuple(g[i] * speed for i in range(3))
    expect_close(velocity, wanted, call=name, tolerance=1e-11)
    expect_close(velocity, built_in_velocity, call=name, tolerance=1e-11)
