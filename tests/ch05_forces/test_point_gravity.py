"""Gravity of constant strength toward a point, exercise 5.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import PointGravity
from ch05_forces.particle import Particle
from draw import Components, components, direction
from expect import about, blame, expect_close, expect_unchanged, scoped, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 5, exercise 5.3; the docstring of PointGravity"
# The difference of two positions of 10 m, 0.1 m apart, keeps 14 digits; the force is up to 900 N.
ROUNDED = 1e-11


def away_from(center: Components, way: Components, distance: float) -> Vector3:
    return Vector3(*(center[i] + way[i] * distance for i in range(3)))


@pytest.mark.exercise("5.3", asks="gravity has the same strength at every distance")
def test_the_force_is_equally_strong_at_every_distance(rng: Random) -> None:
    about.read = READ
    center, way = components(rng), direction(rng)
    mass, strength = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)
    for distance in (0.1, 1.0, 25.0, 4000.0):
        place = away_from(center, way, distance)
        about.cause = "The force is wrong. It must point toward the center, and its size must be m "
        about.cause += "times the strength at every distance."
        about.call = f"a particle p of {mass} kg, {distance:g} m from the center; "
        about.call += f"PointGravity(center=Vector3{center}, strength={strength}).update_force(p, "
        about.call += "0.5)"
        p = Particle(place, Vector3(5, 6, 7), mass=mass)
        PointGravity(Vector3(*center), strength).update_force(p, 0.5)
        wanted = tuple(-mass * strength * way[i] for i in range(3))
        got = xyz(p.force_accumulator)
        reach = math.hypot(*xyz(place))
        slips = {
            "Your force pushes the particle away from the center. Use the vector from the "
            "particle to the center instead.": [-part for part in wanted],
            "Your force grows with the distance, because the vector to the center was not "
            "normalized. Normalize it before you multiply.": [part * distance for part in wanted],
            "You add an acceleration instead of a force. Multiply it by particle.mass.": [
                part / mass for part in wanted
            ],
            "update_force added no force to the particle. Compute the force, and pass it to "
            "particle.add_force.": ZERO,
            "You divide by the mass. The strength is an acceleration, so multiply it by the mass "
            "to get a force.": [part / mass**2 for part in wanted],
            "Your force decreases with the distance. It must be equally strong at every distance, "
            "so multiply a unit vector by m times the strength.": [
                part / distance for part in wanted
            ],
            "Your force decreases with the square of the distance. It must be equally strong at "
            "every distance, so don't divide by the square.": [
                part / distance**2 for part in wanted
            ],
            "Your force pulls the particle toward the point (0, 0, 0). Use self.center instead.": [
                -mass * strength * part / reach for part in xyz(place)
            ],
            "You use the position of the center as the direction. Subtract the particle's position "
            "from it first.": [mass * strength * part / math.hypot(*center) for part in center],
            "Your force is half of the right one. Perhaps you multiply it by the duration, which "
            "is 0.5 s here. Leave the duration out.": [0.5 * part for part in wanted],
        }
        blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=ROUNDED)
        about.cause = "You change the position of the particle, because -= works in place. Use -, "
        about.cause += "which creates a new vector."
        expect_unchanged("p.position", xyz(p.position), xyz(place))


@scoped
def expect_full_strength(y: float, cause: str) -> None:
    """Expect the whole force on a particle at this height above the center."""
    about(cause=cause, read=READ)
    about.call = f"p = Particle(Vector3(0, {y}, 0)); PointGravity(center=Vector3(), "
    about.call += "strength=10.0).update_force(p, 0.5)"
    p = Particle(Vector3(0, y, 0))
    PointGravity(Vector3(), 10.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0, -10.0, 0), then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("5.3", asks="so it is zero there")
def test_point_gravity_is_zero_only_at_the_center(rng: Random) -> None:
    about.read = READ
    center = components(rng)
    about.call = f"p = Particle(Vector3{center}); PointGravity(center=Vector3{center}, "
    about.call += "strength=10.0).update_force(p, 0.5)"
    about.cause = "The particle is exactly at the center, and you divide by its distance, which is "
    about.cause += "0. Add no force there."
    p = Particle(Vector3(*center))
    PointGravity(Vector3(*center), 10.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator", unit="N")
    expect_full_strength(
        1e-9,
        "You add no force very close to the center. The force must have its full strength "
        "everywhere except exactly at the center.",
    )


@pytest.mark.exercise("5.3", asks="even very close to the center")
@pytest.mark.robust
def test_a_distance_whose_square_rounds_to_zero() -> None:
    about.cause = "You use the square of the distance, which rounds to 0 here. Use magnitude(), "
    about.cause += "because the distance itself is not 0."
    expect_full_strength(1e-170, about.cause)


@pytest.mark.exercise("5.3", asks="Skip an immovable particle")
def test_point_gravity_skips_an_immovable_particle() -> None:
    about(
        "p = Particle(Vector3(0, 2, 0), mass=math.inf); PointGravity(center=Vector3(), ", read=READ
    )
    about.call += "strength=10.0).update_force(p, 0.5); p.force_accumulator"
    about.cause = "The force on an immovable particle would be infinite. Add a force only "
    about.cause += "if has_finite_mass is True."
    p = Particle(Vector3(0, 2, 0), mass=math.inf)
    PointGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO, unit="N")
    about.call = about.call.replace("math.inf", "4.0")
    about.cause = "Your force does not act on this particle, although its mass is finite. Skip "
    about.cause += "only immovable particles."
    p = Particle(Vector3(0, 2, 0), mass=4.0)
    PointGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), (0, -40.0, 0), unit="N")


@pytest.mark.exercise("5.3", asks="or away from it if it is negative")
def test_point_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    about.read = READ
    force, center = components(rng), (7.0, 0.0, 0.0)
    about.call = f"p = Particle(Vector3(3, 0, 0), mass=2.0); p.add_force(Vector3{force}); gravity "
    about.call += "= PointGravity(center=Vector3(), strength=-5.0); gravity.update_force(p, 0.5)"
    about.cause = "The force is wrong for a negative strength. It must push the particle away from "
    about.cause += "the center, and it must not replace earlier forces."
    p, gravity = Particle(Vector3(3, 0, 0), mass=2.0), PointGravity(Vector3(), -5.0)
    p.add_force(Vector3(*force))
    gravity.update_force(p, 0.5)
    wanted = (force[0] + 10.0, force[1], force[2])
    got = xyz(p.force_accumulator)
    pulls = "Your force still pulls the particle toward the center, although the strength is "
    pulls += "negative. Use the strength without changing its sign."
    blame(got, {pulls: (force[0] - 10.0, force[1], force[2])})
    expect_close(got, wanted, then="; p.force_accumulator", unit="N")
    about.cause = "You change gravity.center, because -= works in place. Use -, which creates a "
    about.cause += "new vector."
    expect_unchanged("gravity.center", xyz(gravity.center), ZERO)
    about.cause = about.cause.replace("gravity.center", "p.position")
    expect_unchanged("p.position", xyz(p.position), (3, 0, 0))
    about.call += f"; gravity.center = Vector3{center}; gravity.strength = 1.5; p.clear_forces(); "
    about.call += "gravity.update_force(p, 0.5)"
    about.cause = "You use the initial center or strength, but both have changed since then. Read "
    about.cause += "self.center and self.strength in every call."
    gravity.center, gravity.strength = Vector3(*center), 1.5
    p.clear_forces()
    gravity.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (3.0, 0, 0), then="; p.force_accumulator", unit="N")
