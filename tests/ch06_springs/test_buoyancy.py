"""Buoyancy, build task B6.4, and lighter than air, exercise 6.2."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import period_on, places_on
from ch06_springs.springs import Buoyancy, LighterThanAir
from draw import Triple, number, positive_number, vector
from expect import UNCHANGED, expect_close, expect_unchanged, named, xyz

READ = "book 6.2.4 and the docstring of Buoyancy"
E_5 = (
    "perhaps because you used (y - y_w - s) from the book's listing (E-5). Use (y_w + s - y), "
    "where y_w is water_height and s is max_depth."
)
LIGHTER = "exercise 6.2 and the docstring of LighterThanAir"


@pytest.mark.exercise("B6.4", asks="times the fraction of the body that is under water", read=READ)
def test_the_lift_grows_with_the_submerged_fraction(rng: Random) -> None:
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    density, g = positive_number(rng, 800.0, 1250.0), positive_number(rng, 5.0, 20.0)
    full = density * volume * g
    cause = "The lift must point up. Its size is density times volume times g, times the submerged "
    cause += "fraction (y_w + s - y) / (2 s), where y_w is water_height and s is max_depth."

    def lift(share: float) -> Any:
        """Return the lift of a body of which a fraction is under water."""
        y = surface + s - 2.0 * s * share
        with calls(cause):
            p = Particle(Vector3(3.0, y, 5.0), Vector3(2.0, 3.0, 4.0), mass=3.0)
            b = Buoyancy(max_depth=s, volume=volume, water_height=surface,
                         liquid_density=density, gravity=g)  # fmt: skip
            b.update_force(p, 0.5)
            got = p.force_accumulator
        expect_unchanged("p.position", p.position, (3.0, y, 5.0), cause=UNCHANGED)
        return got

    below = "You used y_w - y, the depth of the body's center"
    unit = full / g
    slips: dict[str, Callable[[float], float]] = {  # each with the lift at a fraction u
        f"There is no lift, {E_5}": lambda u: 0.0 * u,
        f"Your lift points down, {E_5}": lambda u: -u * full,
        "You followed the book's listing, which has three errors (E-5).":
            lambda u: -u * s * s * unit,
        "Your lift is the full one, even if only 1% of the body is under water. Use the submerged "
        "fraction. Check that you limit it in the right order: min(max(fraction, 0.0), 1.0).":
            lambda u: max(u, 1.0) * full,
        "You divide by 2 and then multiply by s, because the book's listing lacks parentheses "
        "(E-5). Divide by (2 * s), where s is max_depth.": lambda u: min(u * s * s, 1.0) * full,
        "Your lift leaves out the factor g, as in the book's listing (E-5).": lambda u: u * unit,
        "You divided the lift by the mass of the particle.": lambda u: u * full / 3.0,
        "You multiplied the lift by the mass of the particle.": lambda u: u * full * 3.0,
        "You use the mass of the particle in place of the mass of the water.":
            lambda u: u * 3.0 * g,
        "You used g = 9.81 instead of self.gravity.": lambda u: u * unit * 9.81,
        "You used the density of water, 1000 kg/m^3, instead of self.liquid_density.":
            lambda u: u * 1000.0 * volume * g,
        "You divided by max_depth, which is only half the height of the body.":
            lambda u: min(2.0 * u, 1.0) * full,
        f"{below}. Add max_depth, because the lowest point of the body is deeper by this amount.":
            lambda u: max(u - 0.5, 0.0) * full,
        f"{below}, and divided it by s.": lambda u: max(2.0 * u - 1.0, 0.0) * full,
        "Your lift grows as the body rises out of the water.": lambda u: (1.0 - u) * full,
        "Your lift is half of what it should be. Either you multiply it by the duration, which is "
        "0.5 s here, or you divide by 4 * max_depth.": lambda u: 0.5 * u * full,
        "You subtract the weight of the particle. Gravity acts separately, so add only the lift.":
            lambda u: u * full - 3.0 * g,
        "You subtract the particle's weight. Gravity acts separately, so add only the lift.":
            lambda u: u * full - 29.43,
        "Your lift is either the full lift or zero.": lambda u: full if u > 0.5 else 0.0,
    }  # fmt: skip
    shares = (0.25, 0.75, 0.01)
    lifts = [xyz(lift(share))[1] for share in shares]
    cause = named(lifts, cause, {slip: [f(u) for u in shares] for slip, f in slips.items()})
    for share in (0.25, 0.75, 0.5, 0.01):
        # The depth is the difference of numbers up to 28: some 1e-14 of it is rounding.
        wanted = (0.0, share * full, 0.0)
        expect_close(lift(share), wanted, tolerance=1e-12 * full, unit="N")


@pytest.mark.exercise("B6.4", asks="limited to the range from 0 to 1", read=READ)
def test_the_submerged_fraction_is_from_0_to_1(rng: Random) -> None:
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    full = 1000.0 * volume * 9.81
    out = "The body is completely out of the water, so there must be no lift. Use 0 if the "
    out += "submerged fraction is negative."
    under = "The whole body is under water, so the submerged fraction is 1, however deep it is. "
    under += "The lift is then density times volume times g."
    half = "Half of the body is under water here, so the lift must be half of the full lift."
    for y, share, cause in (
        (surface + 1.5 * s, 0.0, out),
        (surface + 50.0, 0.0, out),
        (surface - 1.5 * s, 1.0, under),
        (surface - 50.0, 1.0, under),
        (surface, 0.5, half),
    ):
        with calls(cause):
            p = Particle(Vector3(0.0, y, 0.0))
            Buoyancy(max_depth=s, volume=volume, water_height=surface).update_force(p, 0.5)
            got = p.force_accumulator
        unlimited = (0.0, (surface + s - y) / (2.0 * s) * full, 0.0)
        limited = {
            out: {
                "Your submerged fraction is less than 0 here, although the body is out of the "
                "water, so your lift pulls it down. Use 0 instead.": unlimited,
                "Your lift is the full one, although the body is out of the water. If the fraction "
                "would be less than 0, use 0.": (0.0, full, 0.0),
            },
            under: {
                "Your submerged fraction is more than 1 here, although no more than the whole body "
                "can be under water. Use 1 instead.": unlimited,
                "There is no lift, although the whole body is under water. If the fraction would "
                "be more than 1, use 1.": (0.0, 0.0, 0.0),
            },
        }
        tolerance = None if share == 1.0 else 1e-11 * share * full
        expect_close(
            got, (0.0, share * full, 0.0), limited.get(cause), tolerance=tolerance, unit="N"
        )


@pytest.mark.exercise("B6.4", asks="equals the weight of the displaced water", read=READ)
def test_lift_is_the_weight_of_the_water_in_newtons() -> None:
    with calls("Half a liter of water weighs 5 N with g = 10. Without g, you get 0.5 N (E-5)."):
        p = Particle()
        b = Buoyancy(max_depth=0.5, volume=0.001, water_height=0.0, gravity=10.0)
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, 5.0, 0.0), unit="N")


@pytest.mark.exercise("B6.4", asks="adds to the forces that the particle already has", read=READ)
def test_buoyancy_adds_to_other_forces_and_reads_its_attributes(rng: Random) -> None:
    f = vector(rng)
    with calls("Read the attributes of b in every call, and add the lift with add_force."):
        p = Particle(mass=4.0)
        b = Buoyancy(max_depth=1.0, volume=2.0, water_height=0.0, gravity=10.0)
        p.add_force(Vector3(*f))
        b.water_height, b.volume, b.liquid_density = 9.0, 3.0, 500.0
        b.gravity, b.max_depth = 2.0, 18.0
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, f + Triple((0.0, 0.75 * 3000.0, 0.0)), unit="N")


@pytest.mark.exercise("B6.4", asks="the weight of the water that the body displaces", read=READ)
def test_a_floating_body_bobs_with_its_period() -> None:
    with calls(
        "With k = rho V g / (2 s), where s is max_depth, the period is 2 pi sqrt(m / k).",
        "a particle of 0.5 kg that floats on Buoyancy(max_depth=0.05, volume=0.001, "
        "water_height=0, gravity=10) and is pushed down by 1 cm; steps of 1/4000 s; the "
        "period of its oscillation",
    ):
        numbers, start = (0.05, 0.001, 0.0, 1000.0, 10.0), (0.0, -0.01, 0.0)
        got = period_on("Buoyancy", numbers, start, 1.0 / 4000.0, 6000, mass=0.5, gravity=10.0)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 4e-6 of it.
    expect_close(got, 0.44428829, tolerance=2e-5, unit="s")


@pytest.mark.exercise("6.2", asks="the lift is F e^(-y / H)", read=LIGHTER)
def test_the_lift_falls_off_with_the_height(rng: Random) -> None:
    most, scale, f = positive_number(rng, 5.0, 90.0), positive_number(rng), vector(rng)
    for share in (0.3, 1.0, 2.5, 7.0):
        y = share * scale
        with calls("The lift is F e^(-y / H) up, with max_lift F, scale_height H and height y."):
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


@pytest.mark.exercise("6.2", asks="Below the ground the lift stays at max_lift", read=LIGHTER)
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
    with calls("Read max_lift and scale_height in every call.", more=True):
        balloon.max_lift, balloon.scale_height = 2.0 * most, 3.0 * scale
        p = Particle(Vector3(0.0, 3.0 * scale, 0.0))
        balloon.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, 2.0 * most / math.e, 0.0), unit="N")


@pytest.mark.exercise("6.2", asks="At some height the lift equals the weight", read=LIGHTER)
def test_a_balloon_comes_to_rest_where_its_lift_is_its_weight() -> None:
    with calls(
        "It must come to rest where the lift F e^(-y / H) equals its weight m g.",
        "a particle p of 2 kg with damping 0.5 and g = 9.81 m/s^2 that LighterThanAir(max_lift=30, "
        "scale_height=8) lifts for 60 s in steps of 1/60 s; p.position.y",
    ):
        places = places_on("LighterThanAir", (30.0, 8.0), (0.0, 0.0, 0.0), 1.0 / 60.0, 3600,
                           mass=2.0, damping=0.5, gravity=9.81)  # fmt: skip
    # By then the swings have died out to e^-20 of some meters.
    wanted = 8.0 * math.log(30.0 / (2.0 * 9.81))
    expect_close(places[-1][1], wanted, tolerance=1e-6, unit="m")
