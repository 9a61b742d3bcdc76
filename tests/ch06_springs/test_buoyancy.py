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


@pytest.mark.exercise("B6.4", asks="times the fraction of the body that is under water")
def test_the_lift_grows_with_the_submerged_fraction(rng: Random) -> None:
    about.read = READ
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    density, g = positive_number(rng, 800.0, 1250.0), positive_number(rng, 5.0, 20.0)
    full = density * volume * g
    about.cause = (
        "The lift must point up. Its size is density times volume times g, times the submerged "
        "fraction (y_w + s - y) / (2 s), where y_w is water_height and s is max_depth."
    )
    came = {}
    for share in (0.25, 0.75, 0.5, 0.01):
        y = surface + s - 2.0 * s * share
        about.call = f"p of 3 kg at (3, {y}, 5); b = Buoyancy(max_depth={s}, volume={volume}, "
        about.call += f"water_height={surface}, liquid_density={density}, gravity={g}); "
        about.call += f"{100 * share:g}% of the body is under water; b.update_force(p, 0.5); "
        about.call += "p.force_accumulator, in N"
        p = Particle(Vector3(3.0, y, 5.0), Vector3(2.0, 3.0, 4.0), mass=3.0)
        Buoyancy(s, volume, surface, density, g).update_force(p, 0.5)
        came[share] = about.call, xyz(p.force_accumulator)
        expect_unchanged("p.position", xyz(p.position), (3.0, y, 5.0), cause=UNCHANGED)
    unit, pushed = full / g, s * s  # what / 2 * s makes of a share
    pairs = {  # the lifts at the first two shares
        (
            "There is no lift, perhaps because you used (y - y_w - s) from the book's listing "
            "(E-5). Use (y_w + s - y), where y_w is water_height and s is max_depth."
        ): (0.0, 0.0),
        "Your lift points down, perhaps because you used (y - y_w - s) from the book's listing "
        "(E-5). Use (y_w + s - y), where y_w is water_height and s is max_depth.": (
            -0.25 * full,
            -0.75 * full,
        ),
        "You followed the book's listing, which has three errors (E-5). Use (y_w + s - y) "
        "instead of (y - y_w - s), divide it by (2 * s), and multiply the lift by g.": (
            -0.25 * pushed * unit,
            -0.75 * pushed * unit,
        ),
        "You divide by 2 and then multiply by s, because the book's listing lacks parentheses "
        "(E-5). Divide by (2 * s), where s is max_depth.": (
            min(0.25 * pushed, 1.0) * full,
            min(0.75 * pushed, 1.0) * full,
        ),
        "Your lift leaves out the factor g, as in the book's listing (E-5), so it is a mass in "
        "kg instead of a force. Multiply it by self.gravity.": (
            0.25 * unit,
            0.75 * unit,
        ),
        "You divided the lift by the mass of the particle. Add the force itself, because the "
        "step divides it by the mass later.": (
            0.25 * full / 3.0,
            0.75 * full / 3.0,
        ),
        "You multiplied the lift by the mass of the particle. The lift depends only on the "
        "displaced water, so leave the mass out.": (
            0.75 * full,
            2.25 * full,
        ),
        "You use the mass of the particle in place of the mass of the water. Multiply by "
        "self.liquid_density * self.volume instead.": (0.75 * g, 2.25 * g),
        "You used g = 9.81, but this Buoyancy was created with another gravity. Use "
        "self.gravity.": (
            0.25 * unit * 9.81,
            0.75 * unit * 9.81,
        ),
        "You used the density of water, but this Buoyancy was created with another "
        "liquid_density. Use self.liquid_density.": (
            250.0 * volume * g,
            750.0 * volume * g,
        ),
        "You divided by max_depth, which is only half the height of the body. Divide by the "
        "full height, 2 * max_depth.": (
            0.5 * full,
            full,
        ),
        "You used y_w - y, the depth of the body's center. Add max_depth, because the lowest "
        "point of the body is deeper by this amount.": (0.0, 0.25 * full),
        "You used y_w - y, the depth of the body's center, and divided it by s. When the center is "
        "at the surface, half of the body is under water, so use (y_w + s - y) / (2 * s).": (
            0.0,
            0.5 * full,
        ),
        "Your lift grows as the body rises out of the water. Use (y_w + s - y), where y_w is "
        "water_height and s is max_depth.": (0.75 * full, 0.25 * full),
        "Your lift is half of what it should be. Either you multiply it by the duration, which is "
        "0.5 s here, or you divide by 4 * max_depth.": (0.125 * full, 0.375 * full),
        "You subtract the weight of the particle. Gravity acts separately, so add only the lift.": (
            0.25 * full - 3.0 * g,
            0.75 * full - 3.0 * g,
        ),
        "You subtract the particle's weight. Gravity acts separately, so add only the lift.": (
            0.25 * full - 29.43,
            0.75 * full - 29.43,
        ),
        "Your lift is either the full lift or zero. Multiply the full lift by the submerged "
        "fraction of the body.": (
            0.0,
            full,
        ),
    }
    lifts = [got[1] if isinstance(got, tuple) else got for _, got in came.values()][:2]
    blame(lifts, pairs)
    if s < 10.0 and all(abs(got[1] - full) <= 1e-9 * full for _, got in came.values()):
        # Even if multiplied by s^2, the share 0.01 is less than 1.
        about.cause = "Your lift is the full one, even if only 1% of the body is under water. Use "
        about.cause += "the submerged fraction. Check that you limit it in the right order: "
        about.cause += "min(max(fraction, 0.0), 1.0)."
    for share, (call, got) in came.items():
        about.call = call
        # The depth is the difference of numbers up to 28: some 1e-14 of it is rounding.
        wanted = (0.0, share * full, 0.0)
        expect_close(got, wanted, tolerance=1e-12 * full)


@pytest.mark.exercise("B6.4", asks="limited to the range from 0 to 1")
def test_the_submerged_fraction_is_from_0_to_1(rng: Random) -> None:
    about.read = READ
    s, volume, surface = positive_number(rng), positive_number(rng), number(rng)
    for y, share, cause in (
        (
            surface + 1.5 * s,
            0.0,
            "The body is completely out of the water, so there must be no lift. Use 0 if the "
            "submerged fraction is negative.",
        ),
        (
            surface + 50.0,
            0.0,
            "The body is completely out of the water, so there must be no lift. Use 0 if the "
            "submerged fraction is negative.",
        ),
        (
            surface - 1.5 * s,
            1.0,
            "The whole body is under water, so the submerged fraction is 1, however deep it is. "
            "The lift is then density times volume times g.",
        ),
        (
            surface - 50.0,
            1.0,
            "The whole body is under water, so the submerged fraction is 1, however deep it is. "
            "The lift is then density times volume times g.",
        ),
    ):
        about.cause = cause
        about.call = f"p at (0, {y:.6g}, 0); Buoyancy(max_depth={s}, volume={volume}, "
        about.call += f"water_height={surface}).update_force(p, 0.5)"
        p = Particle(Vector3(0.0, y, 0.0))
        Buoyancy(s, volume, surface).update_force(p, 0.5)
        full = 1000.0 * volume * 9.81
        unlimited = (surface + s - y) / (2.0 * s)
        got = xyz(p.force_accumulator)
        slips = {
            "Your submerged fraction is more than 1 here, although no more than the whole body can "
            "be under water. Use 1 instead.": (0.0, unlimited * full, 0.0),
            "There is no lift, although the whole body is under water. If the fraction would be "
            "more than 1, use 1.": (0.0, 0.0, 0.0),
        }
        if share == 0.0:
            slips = {
                "Your submerged fraction is less than 0 here, although the body is out of the "
                "water, so your lift pulls it down. Use 0 instead.": (0.0, unlimited * full, 0.0),
                "Your lift is the full one, although the body is out of the water. If the fraction "
                "would be less than 0, use 0.": (0.0, full, 0.0),
            }
        blame(got, slips)
        expect_close(got, (0.0, share * full, 0.0), then="; p.force_accumulator, in N")
    about.call = f"p at (0, {surface}, 0); Buoyancy(max_depth={s}, volume={volume}, "
    about.call += f"water_height={surface}).update_force(p, 0.5)"
    about.cause = "Half of the body is under water here, so the lift must be half of the full lift."
    p = Particle(Vector3(0.0, surface, 0.0))
    Buoyancy(s, volume, surface).update_force(p, 0.5)
    wanted = (0.0, 0.5 * 1000.0 * volume * 9.81, 0.0)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11 * wanted[1])


@pytest.mark.exercise("B6.4", asks="equals the weight of the displaced water")
def test_lift_is_the_weight_of_the_water_in_newtons() -> None:
    about(
        "p at (0, 0, 0); Buoyancy(max_depth=0.5, volume=0.001, water_height=0, "
        "gravity=10).update_force(p, 0.5)",
        read=READ,
    )
    about.cause = (
        "The body displaces half a liter of water, which weighs 5 N with g = 10. If your lift is "
        "0.5 N, it lacks the factor g, as in the book's listing (E-5)."
    )
    p = Particle()
    Buoyancy(0.5, 0.001, 0.0, gravity=10.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, 5.0, 0.0), then="; p.force_accumulator, in N")


@pytest.mark.exercise("B6.4", asks="adds to the forces that the particle already has")
def test_buoyancy_adds_to_other_forces_and_reads_its_attributes(rng: Random) -> None:
    about.read = READ
    f = components(rng)
    about.call = f"p at (0, 0, 0); p.add_force(Vector3{f}); b = Buoyancy(max_depth=1, volume=2, "
    about.call += "water_height=0, liquid_density=1000, gravity=10); b.water_height = 9; b.volume "
    about.call += "= 3; b.liquid_density = 500; b.gravity = 2; b.max_depth = 18; "
    about.call += "b.update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = (
        "The check changes the attributes of b after creating it, so read them in every call. Use "
        "add_force, which keeps the forces that are already on p."
    )
    p, b = Particle(mass=4.0), Buoyancy(1.0, 2.0, 0.0, 1000.0, 10.0)
    p.add_force(Vector3(*f))
    b.water_height, b.volume, b.liquid_density, b.gravity, b.max_depth = 9.0, 3.0, 500.0, 2.0, 18.0
    b.update_force(p, 0.5)
    wanted = (f[0], f[1] + 0.75 * 3000.0, f[2])
    got = xyz(p.force_accumulator)
    expect_close(got, wanted)


@pytest.mark.exercise("B6.4", asks="the weight of the water that the body displaces")
def test_a_floating_body_bobs_with_its_period() -> None:
    about.read = READ
    about.call = "a particle of 0.5 kg that floats on Buoyancy(max_depth=0.05, volume=0.001, "
    about.call += "water_height=0, gravity=10) and is pushed down by 1 cm; steps of 1/4000 s; the "
    about.call += "period of its oscillation in s"
    about.cause = (
        "The lift acts like a spring with the stiffness k = rho V g / (2 s), where rho is the "
        "density, V the volume and s is max_depth. The period is 2 pi sqrt(m / k)."
    )
    period = bobbing(0.05, 0.001, 0.5, 10.0, -0.01, 1.0 / 4000.0, 6000)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 4e-6 of it.
    expect_close(period, 0.44428829, tolerance=2e-5)
