"""Lighter than air, exercise 6.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import risen
from ch06_springs.springs import LighterThanAir
from draw import components, positive_number
from expect import UNCHANGED, about, blame, expect_close, expect_unchanged, xyz

READ = "exercise 6.2 and the docstring of LighterThanAir"


@pytest.mark.exercise("6.2")
def test_the_lift_falls_off_with_the_height(rng: Random) -> None:
    about.read = READ
    most, scale, f = positive_number(rng, 5.0, 90.0), positive_number(rng), components(rng)
    for share in (0.3, 1.0, 2.5, 7.0):
        y = share * scale
        about.call = f"p at (3, {y}, 5); p.add_force(Vector3{f}); LighterThanAir({most}, "
        about.call += f"{scale}).update_force(p, 0.5); p.force_accumulator"
        about.cause = (
            "Add an upward force of F e^(-y / H) to the forces that are already on the particle. "
            "To check it, try y = H, where the lift is F / e."
        )
        p = Particle(Vector3(3.0, y, 5.0), mass=7.0)
        p.add_force(Vector3(*f))
        LighterThanAir(most, scale).update_force(p, 0.5)
        wanted = (f[0], f[1] + most * math.exp(-share), f[2])
        got = xyz(p.force_accumulator)
        lift = most * math.exp(-share)
        lifts = {
            "Your lift is F H / y, which is infinite at the ground. The lift falls off "
            "exponentially, so use F e^(-y / H).": most / share,
            "Your lift is F (1 - y / H), which decreases linearly and becomes negative above H. "
            "Use F e^(-y / H), which never reaches 0.": most * (1.0 - share),
            "Your lift is F e^-y, as if the scale height were 1 m. Divide the height y by H before "
            "you take the exponential.": most * math.exp(-y),
            "Your lift is F 2^(-y / H), which has dropped to half at the scale height. It should "
            "have dropped to 1 / e, so use math.exp.": most * 0.5**share,
            "Your lift is F / (1 + y / H), which decreases too slowly high above the ground. Use F "
            "e^(-y / H).": most / (1.0 + share),
            "Your lift is F e^(y / H), which grows with height. The exponent needs a minus "
            "sign.": most * math.exp(share),
            "Your lift points down, so the balloon would fall faster. Add the force along "
            "+Y.": -lift,
            "You multiplied the lift by the mass of 7 kg. The lift doesn't depend on the "
            "particle's mass, so leave it out.": 7.0 * lift,
        }
        slips = {name: (f[0], f[1] + size, f[2]) for name, size in lifts.items()}
        blame(got, slips)
        expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("6.2")
def test_the_lift_is_finite_at_the_ground_and_below(rng: Random) -> None:
    about.read = READ
    most, scale = positive_number(rng, 5.0, 90.0), positive_number(rng)
    balloon = LighterThanAir(most, scale)
    for y, cause in (
        (0.0, "On the ground, at y = 0, the lift is at its largest, which is max_lift."),
        (
            -0.5 * scale,
            (
                "Below the ground the lift should stay the same as on the ground, but the formula "
                "makes it grow further. Clamp y to at least 0."
            ),
        ),
        (
            -1e6,
            "Below the ground the lift should stay the same as on the ground, so clamp y to at "
            "least 0. Otherwise e^1000000 overflows.",
        ),
    ):
        about.cause = cause
        about.call = f"p at (0, {y}, 0); LighterThanAir({most}, {scale}).update_force(p, 0.5)"
        p = Particle(Vector3(0.0, y, 0.0))
        balloon.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, (0.0, most, 0.0), then="; p.force_accumulator")
        expect_unchanged("p.position", xyz(p.position), (0.0, y, 0.0), cause=UNCHANGED)
    about.call = f"balloon = LighterThanAir({most}, {scale}); balloon.max_lift = {2 * most}; "
    about.call += f"balloon.scale_height = {3 * scale}; p at (0, {3 * scale}, 0); "
    about.call += "balloon.update_force(p, 0.5)"
    about.cause = (
        "The check changed max_lift and scale_height after it created the balloon. Read both "
        "attributes on every call."
    )
    balloon.max_lift, balloon.scale_height = 2.0 * most, 3.0 * scale
    p = Particle(Vector3(0.0, 3.0 * scale, 0.0))
    balloon.update_force(p, 0.5)
    wanted = (0.0, 2.0 * most / math.e, 0.0)
    expect_close(xyz(p.force_accumulator), wanted, then="; p.force_accumulator")


@pytest.mark.exercise("6.2")
def test_a_balloon_comes_to_rest_where_its_lift_is_its_weight() -> None:
    about.read = READ
    about.call = "p of 2 kg, damping 0.5, g = 9.81; 60 s of LighterThanAir(30, 8).update_force(p, "
    about.call += "h), p.integrate(h) in frames of 1/60 s; p.position.y"
    about.cause = (
        "The particle should rise until the lift F e^(-y / H) equals its weight m g, and come to "
        "rest there, at a height of H ln(F / (m g))."
    )
    y = risen(30.0, 8.0, 2.0, 0.5, 9.81, 1.0 / 60.0, 3600)
    wanted = 8.0 * math.log(30.0 / (2.0 * 9.81))
    # By then the swings have died out to e^-20 of some meters.
    expect_close(y, wanted, tolerance=1e-6)
