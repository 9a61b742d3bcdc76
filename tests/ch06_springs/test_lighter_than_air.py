"""Lighter than air, exercise 6.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import places_on
from ch06_springs.springs import LighterThanAir
from draw import Triple, positive_number, vector
from expect import UNCHANGED, expect_close, expect_unchanged

READ = "exercise 6.2 and the docstring of LighterThanAir"


@pytest.mark.exercise("6.2", asks="the lift is F e^(-y / H)", read=READ)
def test_the_lift_falls_off_with_the_height(rng: Random) -> None:
    most, scale, f = positive_number(rng, 5.0, 90.0), positive_number(rng), vector(rng)
    for share in (0.3, 1.0, 2.5, 7.0):
        y = share * scale
        with calls(
            "The lift must be F e^(-y / H), pointing up, where F is max_lift, H is scale_height "
            "and y is the height. Add it to the forces that are already on p."
        ):
            p = Particle(Vector3(3.0, y, 5.0), mass=7.0)
            p.add_force(Vector3(*f))
            LighterThanAir(max_lift=most, scale_height=scale).update_force(p, 0.5)
            got = p.force_accumulator
        lift = most * math.exp(-share)
        lifts = {
            "Your lift is F H / y, which is infinite at the ground.": most / share,
            "Your lift is F (1 - y / H), a straight line.": most * (1.0 - share),
            "Your lift is F e^-y, where F is max_lift. Divide the height y in the exponent by "
            "scale_height.": most * math.exp(-y),
            "Your lift is F 2^(-y / H), so the base is 2 instead of e.": most * 0.5**share,
            "Your lift is F / (1 + y / H), which is too large high above the ground.":
                most / (1.0 + share),
            "Your lift is F e^(y / H), which grows with the height y. The exponent needs a "
            "minus sign.": most * math.exp(share),
            "Your lift points down. Add the force along +Y.": -lift,
            "Your height is the distance from (0, 0, 0). Use the y component of the position.":
                most * math.exp(-math.hypot(3.0, y, 5.0) / scale),
            "Your lift is F e^-y / H, so y is not divided by H in the exponent.":
                most * math.exp(-y) / scale,
            "Your lift is F e^(-H / y), so you divide H by y.": most * math.exp(-1.0 / share),
            "You subtract the weight of the balloon. Gravity acts separately, so add only the "
            "lift.": lift - 7.0 * 9.81,
            "You multiplied the lift by the particle's mass of 7 kg. The lift does not depend "
            "on the mass, so leave it out.": 7.0 * lift,
        }  # fmt: skip
        slips = {slip: f + Triple((0.0, size, 0.0)) for slip, size in lifts.items()}
        expect_close(got, f + Triple((0.0, lift, 0.0)), slips, tolerance=1e-12, unit="N")


@pytest.mark.exercise("6.2", asks="Below the ground the lift stays at max_lift", read=READ)
def test_the_lift_is_finite_at_the_ground_and_below(rng: Random) -> None:
    most, scale = positive_number(rng, 5.0, 90.0), positive_number(rng)
    stays = "Below the ground the lift must stay max_lift. Replace a negative height with 0 in the "
    stays += "formula"
    for y, cause in (
        (0.0, "On the ground, at a height of 0, the lift must be max_lift."),
        (-0.5 * scale, f"{stays}."),
        (-1e6, f"{stays}, because the exponential is too large for a float here."),
    ):
        with calls(cause):
            balloon = LighterThanAir(max_lift=most, scale_height=scale)
            p = Particle(Vector3(0.0, y, 0.0))
            balloon.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (0.0, most, 0.0), unit="N")
        expect_unchanged("p.position", p.position, (0.0, y, 0.0), cause=UNCHANGED)
    with calls(
        "The check changes max_lift and scale_height after creating the balloon. Read both "
        "attributes in every call.",
        more=True,
    ):
        balloon.max_lift, balloon.scale_height = 2.0 * most, 3.0 * scale
        p = Particle(Vector3(0.0, 3.0 * scale, 0.0))
        balloon.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, 2.0 * most / math.e, 0.0), unit="N")


@pytest.mark.exercise("6.2", asks="At some height the lift equals the weight", read=READ)
def test_a_balloon_comes_to_rest_where_its_lift_is_its_weight() -> None:
    with calls(
        "The particle must come to rest at the height where the lift F e^(-y / H) equals its "
        "weight m g. Here F is max_lift, H is scale_height and y is the height.",
        "a particle p of 2 kg with damping 0.5 and g = 9.81 m/s^2 that LighterThanAir(max_lift=30, "
        "scale_height=8) lifts for 60 s in steps of 1/60 s; p.position.y",
    ):
        places = places_on("LighterThanAir", (30.0, 8.0), (0.0, 0.0, 0.0), 1.0 / 60.0, 3600,
                           mass=2.0, damping=0.5, gravity=9.81)  # fmt: skip
    # By then the swings have died out to e^-20 of some meters.
    wanted = 8.0 * math.log(30.0 / (2.0 * 9.81))
    expect_close(places[-1][1], wanted, tolerance=1e-6, unit="m")
