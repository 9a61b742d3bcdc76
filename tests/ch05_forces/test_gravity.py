"""Gravity as a generator, build task B5.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch05_forces.probes import march
from draw import Triple, vector
from expect import expect_close, expect_unchanged, xyz
from unmoved import expect_kept

ZERO = Triple((0.0, 0.0, 0.0))


@pytest.mark.exercise("B5.4", asks="which adds the weight m g", read="book 3.2, Eq. 3.4")
def test_the_weight_is_mass_times_gravity(rng: Random) -> None:
    g, v, a = vector(rng), Triple((5.0, 6.0, 7.0)), Triple((1.0, 2.0, 3.0))
    for mass in (round(rng.uniform(2.0, 90.0), 3), 0.125):
        with calls("The force must be the weight m g. Multiply the whole vector g by the mass."):
            p = Particle(velocity=Vector3(*v), acceleration=Vector3(*a), mass=mass)
            gravity = Gravity(Vector3(*g))
            gravity.update_force(p, 0.5)
            got = p.force_accumulator
        nothing = "update_force added no force to the particle. Compute the weight m g, and pass "
        nothing += "it to particle.add_force."
        for name, now, before in (
            ("acceleration", p.acceleration, a),
            ("velocity", p.velocity, v),
        ):
            if xyz(now) != before:
                nothing = f"You change p.{name} instead of adding a force. Pass the weight m g to "
                nothing += "particle.add_force."
        slips = {
            "You add the acceleration g instead of a force. Multiply it by the mass.": g,
            "You add g / m instead of m g.": g / mass,
            "You add m g times the duration. Leave the duration out.": mass * g * 0.5,
            "Your force points opposite to g. The vector g already points in the direction of the "
            "weight, so don't add a minus sign.": -mass * g,
            "You use only the y component of g.": (0.0, mass * g[1], 0.0),
            "You use p.acceleration, the particle's own constant acceleration. The g of this "
            "generator is self.acceleration.": mass * a,
            "Your force points straight down, but g may point in any direction.":
                (0.0, -mass * abs(g), 0.0),
            nothing: ZERO,
        }  # fmt: skip
        expect_close(got, mass * g, slips, unit="N")
        only = "update_force must only add a force, and change nothing else."
        expect_unchanged("p.acceleration", p.acceleration, a, cause=only)
        expect_unchanged("p.velocity", p.velocity, v, cause=only)
        expect_kept("gravity.acceleration", xyz(gravity.acceleration), g)


@pytest.mark.exercise(
    "B5.4", asks="Add the force to the others on particle", read="the docstring of ForceGenerator"
)
def test_gravity_keeps_earlier_forces(rng: Random) -> None:
    f, g, mass = vector(rng), vector(rng), round(rng.uniform(2.0, 9.0), 3)
    with calls("Add the weight to the earlier forces with add_force, and don't clear them."):
        p, gravity = Particle(mass=mass), Gravity(Vector3(*g))
        p.add_force(Vector3(*f))
        gravity.update_force(p, 0.5)
        gravity.update_force(p, 0.5)
        got = p.force_accumulator
    slips = {"The sum is only the last weight, without the earlier forces.": mass * g}
    # Three roundings of numbers up to 200.
    expect_close(got, f + 2 * mass * g, slips, tolerance=1e-12, unit="N")


@pytest.mark.exercise(
    "B5.4", asks="it uses the new values from its next call on", read="the docstring of Gravity"
)
def test_a_new_gravity_applies_from_the_next_call(rng: Random) -> None:
    first, second = vector(rng), vector(rng)
    with calls("gravity.acceleration was replaced. Read self.acceleration in every call."):
        p, gravity = Particle(mass=2.0), Gravity(Vector3(*first))
        gravity.update_force(p, 0.5)
        p.clear_forces()
        gravity.acceleration = Vector3(*second)
        gravity.update_force(p, 0.5)
        got = p.force_accumulator
    slips = {"You use the initial acceleration of the generator.": 2.0 * first}
    expect_close(got, 2.0 * second, slips, unit="N")
    expect_kept("gravity.acceleration", xyz(gravity.acceleration), second)


@pytest.mark.exercise("B5.4", asks="Skip an immovable particle, whose weight", read="book 5.2.3")
def test_an_immovable_particle_has_no_weight(rng: Random) -> None:
    down = Triple((0.0, -10.0, 0.0))
    skip = "The weight would be infinite. Add it only if has_finite_mass is True."
    for g, mass, weight, cause in (
        (vector(rng), math.inf, ZERO, skip),
        (down, math.inf, ZERO, skip),
        (down, 1e300, (0.0, -1e301, 0.0),
         "You add no force to a particle with a huge but finite mass. Check has_finite_mass "
         "instead of comparing the mass with a limit."),
    ):  # fmt: skip
        with calls(cause):
            p = Particle(mass=mass)
            Gravity(Vector3(*g)).update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, weight, unit="N")


@pytest.mark.exercise("B5.4", asks="has the same effect at no extra cost", read="book 5.3")
def test_gravity_has_the_same_effect_as_a_constant_acceleration(rng: Random) -> None:
    """Only here the weight acts through many steps, beside the same built-in gravity."""
    g, mass, damping = vector(rng), round(rng.uniform(2.0, 90.0), 3), 0.75
    h, steps = 1.0 / 64.0, 192
    with calls(
        "Add exactly the weight m g in every step, as if g were p's own acceleration.",
        f"p = Particle({mass=}, {damping=}); for 3 s, in steps of h = 1/64 s: "
        f"Gravity(Vector3{g}).update_force(p, h) and p.integrate(h)",
    ):
        p = Particle(mass=mass, damping=damping)
        q = Particle(acceleration=Vector3(*g), mass=mass, damping=damping)
        by_force, built_in = march(p, Gravity(Vector3(*g)), h, steps), march(q, None, h, steps)
    # The sum of the geometric series of v' = (v + g h) D, D = d^h.
    kept = damping**h
    gone = (1.0 - kept**steps) / (1.0 - kept)
    way = h * h * kept * (steps - gone) / (1.0 - kept)
    for name, unit, i, factor in (
        ("position", "m", 0, way),
        ("velocity", "m/s", 1, h * kept * gone),
    ):
        for wanted in (g * factor, built_in[i]):
            # 200 roundings of numbers up to 50.
            expect_close(by_force[i], wanted, then=f"; p.{name}", tolerance=1e-11, unit=unit)
