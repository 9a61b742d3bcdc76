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


@pytest.mark.exercise("6.2", asks="the lift is F e^(-y / H)")
def test_the_lift_falls_off_with_the_height(rng: Random) -> None:
    about.read = READ
    most, scale, f = positive_number(rng, 5.0, 90.0), positive_number(rng), components(rng)
    for share in (0.3, 1.0, 2.5, 7.0):
        y = share * scale
        about.call = f"p of 7 kg at (3, {y:.6g}, 5); p.add_force(Vector3{f}); balloon = "
        about.call += f"LighterThanAir(max_lift={most}, scale_height={scale}); "
        about.call += "balloon.update_force(p, 0.5); p.force_accumulator, in N"
        about.cause = (
            "The lift must be F e^(-y / H), pointing up, where F is max_lift, H is scale_height "
            "and y is the height. Add it to the forces that are already on p."
        )
        p = Particle(Vector3(3.0, y, 5.0), mass=7.0)
        p.add_force(Vector3(*f))
        LighterThanAir(most, scale).update_force(p, 0.5)
        wanted = (f[0], f[1] + most * math.exp(-share), f[2])
        got = xyz(p.force_accumulator)
        lift = most * math.exp(-share)
        lifts = {
            "Your lift is F H / y, which is infinite at the ground. Use F e^(-y / H), where F "
            "is max_lift and H is scale_height.": most / share,
            "Your lift is F (1 - y / H), a straight line. Use F e^(-y / H), where F is max_lift "
            "and H is scale_height.": most * (1.0 - share),
            "Your lift is F e^-y, where F is max_lift. Divide the height y in the exponent by "
            "scale_height.": most * math.exp(-y),
            "Your lift is F 2^(-y / H), where F is max_lift and H is scale_height. The base must "
            "be e instead of 2, so use math.exp.": most * 0.5**share,
            "Your lift is F / (1 + y / H), which is too large high above the ground. Use F "
            "e^(-y / H), where F is max_lift and H is scale_height.": most / (1.0 + share),
            "Your lift is F e^(y / H), which grows with the height y. The exponent needs a "
            "minus sign.": most * math.exp(share),
            "Your lift points down. Add the force along +Y.": -lift,
            "Your height is the distance from (0, 0, 0). Use the y component of the position.": most
            * math.exp(-math.hypot(3.0, y, 5.0) / scale),
            "Your lift is F e^-y / H, where F is max_lift and H is scale_height. Divide y by H in "
            "the exponent.": most * math.exp(-y) / scale,
            "Your lift is F e^(-H / y), where F is max_lift and H is scale_height. Divide y by H "
            "instead of H by y.": most * math.exp(-1.0 / share),
            "You subtract the weight of the balloon. Gravity acts separately, so add only the "
            "lift.": lift - 7.0 * 9.81,
            "You multiplied the lift by the particle's mass of 7 kg. The lift does not depend "
            "on the mass, so leave it out.": 7.0 * lift,
        }
        slips = {name: (f[0], f[1] + size, f[2]) for name, size in lifts.items()}
        blame(got, slips)
        expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("6.2", asks="Below the ground the lift stays at max_lift")
def test_the_lift_is_finite_at_the_ground_and_below(rng: Random) -> None:
    about.read = READ
    most, scale = positive_number(rng, 5.0, 90.0), positive_number(rng)
    balloon = LighterThanAir(most, scale)
    for y, cause in (
        (0.0, "On the ground, at a height of 0, the lift must be max_lift."),
        (
            -0.5 * scale,
            "Below the ground the lift must stay max_lift. Replace a negative height with 0 in the "
            "formula.",
        ),
        (
            -1e6,
            "Below the ground the lift must be the same as on the ground. Replace a "
            "negative height with 0, because the exponential is too large for a float here.",
        ),
    ):
        about.cause = cause
        about.call = f"p at (0, {y:.6g}, 0); balloon = LighterThanAir(max_lift={most}, "
        about.call += f"scale_height={scale}); balloon.update_force(p, 0.5)"
        p = Particle(Vector3(0.0, y, 0.0))
        balloon.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, (0.0, most, 0.0), then="; p.force_accumulator, in N")
        expect_unchanged("p.position", xyz(p.position), (0.0, y, 0.0), cause=UNCHANGED)
    about.call = f"balloon = LighterThanAir(max_lift={most}, scale_height={scale}); "
    about.call += f"balloon.max_lift = {2 * most:.6g}; balloon.scale_height = {3 * scale:.6g}; p "
    about.call += f"at (0, {3 * scale:.6g}, 0); balloon.update_force(p, 0.5)"
    about.cause = (
        "The check changes max_lift and scale_height after creating the balloon. Read both "
        "attributes in every call."
    )
    balloon.max_lift, balloon.scale_height = 2.0 * most, 3.0 * scale
    p = Particle(Vector3(0.0, 3.0 * scale, 0.0))
    balloon.update_force(p, 0.5)
    wanted = (0.0, 2.0 * most / math.e, 0.0)
    expect_close(xyz(p.force_accumulator), wanted, then="; p.force_accumulator, in N")


@pytest.mark.exercise("6.2", asks="At some height the lift equals the weight")
def test_a_balloon_comes_to_rest_where_its_lift_is_its_weight() -> None:
    about.read = READ
    about.call = "a particle p of 2 kg with damping 0.5 and g = 9.81 m/s^2 that "
    about.call += "LighterThanAir(max_lift=30, scale_height=8) lifts for 60 s in steps of 1/60 s; "
    about.call += "p.position.y, in m"
    about.cause = (
        "The particle must come to rest at the height where the lift F e^(-y / H) equals its "
        "weight m g. Here F is max_lift, H is scale_height and y is the height."
    )
    y = risen(30.0, 8.0, 2.0, 0.5, 9.81, 1.0 / 60.0, 3600)
    wanted = 8.0 * math.log(30.0 / (2.0 * 9.81))
    # By then the swings have died out to e^-20 of some meters.
    expect_close(y, wanted, tolerance=1e-6)
