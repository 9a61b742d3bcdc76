"""Buoyancy, build task B6.4."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import bobbing
from ch06_springs.springs import Buoyancy
from draw import components, number, positive_number
from expect import UNCHANGED, about, blame, expect_close, expect_unchanged, xyz

READ = "book 6.2.4 and the docstring of Buoyancy"


@pytest.mark.exercise("B6.4")
def test_the_lift_grows_with_the_share_under_water(rng: Random) -> None:
    about.read = READ
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    density, g = positive_number(rng, 800.0, 1250.0), positive_number(rng, 5.0, 20.0)
    full = density * volume * g
    about.cause = (
        "The lift is the submerged fraction (y_w + s - y) / (2 s) times rho V g, and it points up. "
        "Check your parentheses."
    )
    came = {}
    for share in (0.25, 0.75, 0.5, 0.01):
        y = surface + s - 2.0 * s * share
        about.call = f"p at (3, {y}, 5); Buoyancy({s}, {volume}, {surface}, {density}, "
        about.call += f"{g}).update_force(p, 0.5); p.force_accumulator"
        p = Particle(Vector3(3.0, y, 5.0), Vector3(2.0, 3.0, 4.0), mass=3.0)
        Buoyancy(s, volume, surface, density, g).update_force(p, 0.5)
        came[share] = about.call, xyz(p.force_accumulator)
        expect_unchanged("p.position", xyz(p.position), (3.0, y, 5.0), cause=UNCHANGED)
    unit, pushed = full / g, s * s  # what / 2 * s makes of a share
    pairs = {  # the lifts at the first two shares
        (
            "There is no lift, because the book's (y - y_w - s) has the wrong signs and makes the "
            "submerged fraction negative (E-5). Use (y_w + s - y) instead."
        ): (0.0, 0.0),
        "The force points down, because the book's (y - y_w - s) has the wrong signs (E-5). Use "
        "(y_w + s - y) instead.": (
            -0.25 * full,
            -0.75 * full,
        ),
        "You followed the book's listing, which contains three errors (E-5): it has the wrong "
        "signs, it multiplies by s where it should divide, and it leaves out g.": (
            -0.25 * pushed * unit,
            -0.75 * pushed * unit,
        ),
        "Your code divides by 2 and then multiplies by s, because the book's listing lacks "
        "parentheses (E-5). Divide by (2 * s) instead.": (
            min(0.25 * pushed, 1.0) * full,
            min(0.75 * pushed, 1.0) * full,
        ),
        "The factor g is missing, as it is in the book's listing (E-5), so your result is a mass "
        "in kg rather than a force. Multiply it by self.gravity.": (
            0.25 * unit,
            0.75 * unit,
        ),
        "You divided the lift by the mass. The integrator does that later, so add the force "
        "itself.": (
            0.25 * full / 3.0,
            0.75 * full / 3.0,
        ),
        "You multiplied the lift by the mass of the body. Lift depends only on the displaced "
        "water, so leave the mass out.": (
            0.75 * full,
            2.25 * full,
        ),
        "You used g = 9.81, but this Buoyancy has a different value. Use self.gravity.": (
            0.25 * unit * 9.81,
            0.75 * unit * 9.81,
        ),
        "You used the density of water, but this Buoyancy is for a different liquid. Use "
        "self.liquid_density.": (
            250.0 * volume * g,
            750.0 * volume * g,
        ),
        "You divided by s, but max_depth is only half the height of the body. Divide by the full "
        "height, 2 s.": (
            0.5 * full,
            full,
        ),
        "Your depth is y_w - y, which is how deep the center of the body is. Its lowest point is "
        "max_depth deeper, so add max_depth.": (0.0, 0.25 * full),
        "Your lift is all or nothing. While the body is partly under water, the lift should grow "
        "with the submerged fraction.": (
            0.0,
            full,
        ),
    }
    lifts = [got[1] if isinstance(got, tuple) else got for _, got in came.values()][:2]
    blame(lifts, pairs)
    for share, (call, got) in came.items():
        about.call = call
        # The depth is the difference of numbers up to 28: some 1e-14 of it is rounding.
        wanted = (0.0, share * full, 0.0)
        expect_close(got, wanted, tolerance=1e-12 * full)


@pytest.mark.exercise("B6.4")
def test_out_of_the_water_there_is_no_lift_and_deep_in_it_no_more(rng: Random) -> None:
    about.read = READ
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    for y, share, cause in (
        (
            surface + 1.5 * s,
            0.0,
            "The body is completely out of the water, so there should be no force at all, up or "
            "down. Clamp the submerged fraction so that it never drops below 0.",
        ),
        (
            surface + 50.0,
            0.0,
            "The body is high above the water, so there should be no lift. Clamp the submerged "
            "fraction so that it never drops below 0.",
        ),
        (
            surface - 1.5 * s,
            1.0,
            "The whole body is under water, so the submerged fraction is 1 and the lift is the "
            "full rho V g.",
        ),
        (
            surface - 50.0,
            1.0,
            "The lift never exceeds rho V g, however deep the body is. Clamp the submerged "
            "fraction to at most 1.",
        ),
    ):
        about.cause = cause
        about.call = f"p at (0, {y}, 0); Buoyancy({s}, {volume}, {surface}).update_force(p, 0.5)"
        p = Particle(Vector3(0.0, y, 0.0))
        Buoyancy(s, volume, surface).update_force(p, 0.5)
        wanted = (0.0, share * 1000.0 * volume * 9.81, 0.0)
        expect_close(xyz(p.force_accumulator), wanted, then="; p.force_accumulator")
    about.call = f"p at (0, {surface}, 0); Buoyancy({s}, {volume}, {surface}).update_force(p, 0.5)"
    about.cause = "Half of the body is under water here, so it should get half of the full lift."
    p = Particle(Vector3(0.0, surface, 0.0))
    Buoyancy(s, volume, surface).update_force(p, 0.5)
    wanted = (0.0, 0.5 * 1000.0 * volume * 9.81, 0.0)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11 * wanted[1])


@pytest.mark.exercise("B6.4")
def test_lift_is_the_weight_of_the_water_in_newtons() -> None:
    about("p at (0, 0, 0); Buoyancy(0.5, 0.001, 0, gravity=10).update_force(p, 0.5)", read=READ)
    about.cause = (
        "The body displaces half a liter of water, which weighs 5 N with g = 10, so the lift rho V "
        "g should be 5 N. If you got 0.5, you left out the factor g, as the book's listing does "
        "(E-5)."
    )
    p = Particle()
    Buoyancy(0.5, 0.001, 0.0, gravity=10.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, 5.0, 0.0), then="; p.force_accumulator")


@pytest.mark.exercise("B6.4")
def test_buoyancy_adds_to_other_forces_and_reads_its_attributes(rng: Random) -> None:
    about.read = READ
    f = components(rng)
    about.call = f"p at (0, 0, 0); p.add_force(Vector3{f}); b = Buoyancy(1, 2, 0, 1000, 10); "
    about.call += "b.water_height = 9; b.volume = 3; b.liquid_density = 500; b.gravity = 2; "
    about.call += "b.max_depth = 18; b.update_force(p, 0.5); p.force_accumulator"
    about.cause = (
        "The check has changed the attributes since the last call, so read them on every call. And "
        "use add_force, which keeps the forces that are already on the particle."
    )
    p, b = Particle(mass=4.0), Buoyancy(1.0, 2.0, 0.0, 1000.0, 10.0)
    p.add_force(Vector3(*f))
    b.water_height, b.volume, b.liquid_density, b.gravity, b.max_depth = 9.0, 3.0, 500.0, 2.0, 18.0
    b.update_force(p, 0.5)
    wanted = (f[0], f[1] + 0.75 * 3000.0, f[2])
    got = xyz(p.force_accumulator)
    expect_close(got, wanted)


@pytest.mark.exercise("B6.4")
def test_a_floating_body_bobs_with_its_period() -> None:
    about.read = READ
    about.call = "p of 0.5 kg, g = 10, Buoyancy(0.05, 0.001, 0, gravity=10), pushed 1 cm down; "
    about.call += "frames of 1/4000 s of update_force(p, h), p.integrate(h): the period"
    about.cause = (
        "The lift acts like a spring of stiffness rho V g / (2 s). So w^2 = rho V g / (2 s m), "
        "and the period is 0.44428829 s."
    )
    period = bobbing(0.05, 0.001, 0.5, 10.0, -0.01, 1.0 / 4000.0, 6000)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 4e-6 of it.
    expect_close(period, 0.44428829, tolerance=2e-5)
