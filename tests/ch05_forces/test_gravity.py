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


@pytest.mark.exercise("B5.4", asks="which adds the weight m g")
def test_the_weight_is_mass_times_gravity(rng: Random) -> None:
    g = components(rng)
    about.read = "book 3.2, Eq. 3.4"
    for mass in (round(rng.uniform(2.0, 90.0), 3), 0.125):
        about.call = "p = Particle(velocity=Vector3(5, 6, 7), acceleration=Vector3(1, 2, 3), "
        about.call += f"{mass=}); gravity = Gravity(Vector3{g}); gravity.update_force(p, 0.5)"
        about.cause = "The force is not the weight m g. Multiply all three components of g by the "
        about.cause += "mass, and by nothing else."
        vectors = {"velocity": Vector3(5, 6, 7), "acceleration": Vector3(1, 2, 3)}
        p = Particle(**vectors, mass=mass)
        gravity = Gravity(Vector3(*g))
        gravity.update_force(p, 0.5)
        wanted = tuple(mass * g[i] for i in range(3))
        slips = {
            "You add the acceleration g instead of a force. Multiply it by the mass to get the "
            "weight.": g,
            "You add g / m, but the weight is m g. Multiply by the mass instead of dividing.": [
                g[i] / mass for i in range(3)
            ],
            "You add m g times the duration. Add m g itself, because the step multiplies it by "
            "the duration later.": [mass * g[i] * 0.5 for i in range(3)],
            "Your force points opposite to g. The vector g already points in the direction of "
            "the weight, so don't add a minus sign.": [-mass * g[i] for i in range(3)],
            "You use only the y component of g. Gravity may point in any direction, so multiply "
            "the whole vector g by the mass.": (0.0, mass * g[1], 0.0),
            "You use p.acceleration, the particle's own constant acceleration. The g of this "
            "generator is self.acceleration.": [mass * part for part in (1, 2, 3)],
            "Your force points straight down, but g may point in any direction. Multiply the "
            "vector g by the mass.": (0.0, -mass * math.hypot(*g), 0.0),
            "update_force added no force to the particle. Compute the weight m g, and pass it "
            "to particle.add_force.": ZERO,
        }
        got = xyz(p.force_accumulator)
        blame(got, slips)
        state = {"acceleration": (1, 2, 3), "velocity": (5, 6, 7)}
        for name, before in state.items():
            if got == ZERO and xyz(getattr(p, name)) != before:
                about.cause = f"You change p.{name} instead of adding a force. Pass the weight m g "
                about.cause += "to particle.add_force."
        expect_close(got, wanted, then="; p.force_accumulator", unit="N")
        for name, before in state.items():
            about.cause = f"update_force changed p.{name}. It must only add a force."
            expect_unchanged(f"p.{name}", xyz(getattr(p, name)), before)
        got = xyz(gravity.acceleration)
        about.cause = "You change gravity.acceleration, because *= works in place. Use *, which "
        about.cause += "creates a new vector."
        expect_unchanged("gravity.acceleration", got, g)


@pytest.mark.exercise("B5.4", asks="Add the force to the others on particle")
def test_gravity_keeps_earlier_forces(rng: Random) -> None:
    f, g, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(mass={mass}); p.add_force(Vector3{f}); gravity = "
    about.call += f"Gravity(Vector3{g}); gravity.update_force(p, 0.5) twice; p.force_accumulator"
    about.cause = "The sum must contain the force that was added first, and the weight twice. Add "
    about.cause += "the weight with add_force."
    about.read = "the docstring of ForceGenerator"
    p, gravity = Particle(mass=mass), Gravity(Vector3(*g))
    p.add_force(Vector3(*f))
    gravity.update_force(p, 0.5)
    gravity.update_force(p, 0.5)
    wanted = tuple(f[i] + 2 * mass * g[i] for i in range(3))
    got = xyz(p.force_accumulator)
    cleared = "The sum is only the last weight, without the earlier forces. Add the weight with "
    cleared += "add_force, and don't clear any forces."
    blame(got, {cleared: [mass * g[i] for i in range(3)]})
    # Three roundings of numbers up to 200.
    expect_close(got, wanted, tolerance=1e-12, unit="N")


@pytest.mark.exercise("B5.4", asks="it uses the new values from its next call on")
def test_a_new_gravity_applies_from_the_next_call(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"gravity = Gravity(Vector3{first}); gravity.acceleration = Vector3{second}; "
    about.call += "p = Particle(mass=2.0); gravity.update_force(p, 0.5); p.force_accumulator"
    about(
        cause="The force must be the mass times gravity.acceleration, which was replaced. Read "
        "self.acceleration in every call of update_force.",
        read="the docstring of Gravity",
    )
    p, gravity = Particle(mass=2.0), Gravity(Vector3(*first))
    gravity.acceleration = Vector3(*second)
    gravity.update_force(p, 0.5)
    wanted = tuple(2.0 * second[i] for i in range(3))
    got = xyz(p.force_accumulator)
    old = "You use the initial acceleration of the generator. Read self.acceleration in "
    old += "every call of update_force."
    blame(got, {old: [2.0 * n for n in first]})
    expect_close(got, wanted, unit="N")
    got = xyz(gravity.acceleration)
    about.cause = "You change gravity.acceleration, because *= works in place. Use *, which "
    about.cause += "creates a new vector."
    expect_unchanged("gravity.acceleration", got, second)


@pytest.mark.exercise("B5.4", asks="Skip an immovable particle, whose weight")
def test_an_immovable_particle_has_no_weight(rng: Random) -> None:
    g = components(rng)
    about.read = "book 5.2.3"
    about.cause = "You add a force to an immovable particle, whose weight would be infinite. Add "
    about.cause += "it only if has_finite_mass is True."
    for gravity in (g, (0.0, -10.0, 0.0)):
        about.call = f"p = Particle(mass=math.inf); Gravity(Vector3{gravity}).update_force(p, 0.5)"
        p = Particle(mass=math.inf)
        Gravity(Vector3(*gravity)).update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, ZERO, then="; p.force_accumulator", unit="N")
    about.cause = "You add no force to a particle with a huge but finite mass. Check "
    about.cause += "has_finite_mass instead of comparing the mass with a limit."
    about.call = "p = Particle(mass=1e300); Gravity(Vector3(0, -10, 0)).update_force(p, 0.5)"
    p = Particle(mass=1e300)
    Gravity(Vector3(0, -10, 0)).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -1e301, 0.0), then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("B5.4", asks="has the same effect at no extra cost")
def test_gravity_has_the_same_effect_as_a_constant_acceleration(rng: Random) -> None:
    g, mass, damping = components(rng), round(rng.uniform(2.0, 90.0), 3), 0.75
    h, frames = 1.0 / 64.0, 192
    about.call = f"p = Particle(mass={mass}, damping={damping}); for 3 s, in steps of h = 1/64 s: "
    about.call += f"Gravity(Vector3{g}).update_force(p, h) and p.integrate(h); p.position"
    about.cause = "The particle must move as if g were its own acceleration. Add exactly the "
    about.cause += "weight m g in every step."
    about.read = "book 5.3"
    (by_force, velocity), (built_in, built_in_velocity) = fall(g, mass, damping, h, frames)
    # The sum of the geometric series of v' = (v + g h) D, D = d^h.
    kept = damping**h
    gone = (1.0 - kept**frames) / (1.0 - kept)
    speed = h * kept * gone
    way = h * h * kept * (frames - gone) / (1.0 - kept)
    wanted = tuple(g[i] * way for i in range(3))
    # 200 roundings of numbers up to 50.
    expect_close(by_force, wanted, tolerance=1e-11, unit="m")
    expect_close(by_force, built_in, tolerance=1e-11, unit="m")
    about.call = about.call.replace("p.position", "p.velocity")
    wanted = tuple(g[i] * speed for i in range(3))
    expect_close(velocity, wanted, tolerance=1e-11, unit="m/s")
    expect_close(velocity, built_in_velocity, tolerance=1e-11, unit="m/s")
