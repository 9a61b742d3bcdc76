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


@pytest.mark.exercise("5.3")
def test_the_force_is_m_g_towards_the_center_at_every_distance(rng: Random) -> None:
    about.read = READ
    center, way = components(rng), direction(rng)
    mass, strength = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)
    for distance in (0.1, 1.0, 25.0, 4000.0):
        place = away_from(center, way, distance)
        about.cause = "The force must point toward the center, and its size must be m times the "
        about.cause += "strength at any distance, so normalize the direction."
        about.call = f"a particle p of {mass} kg, {distance} m from the center; "
        about.call += f"PointGravity(center=Vector3{center}, strength={strength}).update_force(p, "
        about.call += "0.5)"
        p = Particle(place, Vector3(5, 6, 7), mass=mass)
        PointGravity(Vector3(*center), strength).update_force(p, 0.5)
        wanted = tuple(-mass * strength * way[i] for i in range(3))
        got = xyz(p.force_accumulator)
        reach = math.hypot(*xyz(place))
        slips = {
            "Your force pushes the particle away from the center. Use the vector from the "
            "particle to the center as its direction.": [-part for part in wanted],
            "Your force grows with the distance, because the vector to the center was not "
            "normalized. Use the unit vector.": [part * distance for part in wanted],
            "Your force does not depend on the mass, so it is really an acceleration. Multiply "
            "it by particle.mass.": [part / mass for part in wanted],
            "Your force is proportional to 1 / r^2, where r is the distance, as in exercise "
            "5.4. In this exercise the force is equally strong at every distance, so don't "
            "divide by r.": [part / distance**2 for part in wanted],
            "Your force pulls the particle toward the point (0, 0, 0). Measure both the "
            "direction and the distance from self.center instead.": [
                -mass * strength * part / reach for part in xyz(place)
            ],
        }
        blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=ROUNDED)
        about.cause = "update_force has changed the position or the center, perhaps because you "
        about.cause += "used -= or normalize, which work in place. Use - and normalized, which "
        about.cause += "create new vectors."
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
    expect_close(got, (0, -10.0, 0), then="; p.force_accumulator, in N")


@pytest.mark.exercise("5.3")
def test_at_the_center_point_gravity_has_no_direction(rng: Random) -> None:
    about.read = READ
    center = components(rng)
    about.call = f"p = Particle(Vector3{center}); PointGravity(center=Vector3{center}, "
    about.call += "strength=10.0).update_force(p, 0.5)"
    about.cause = "The particle is exactly at the center, so the force has no direction. Add no "
    about.cause += "force, and don't divide by the distance of 0."
    p = Particle(Vector3(*center))
    PointGravity(Vector3(*center), 10.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator, in N")
    expect_full_strength(
        1e-9,
        "The particle is very close to the center but not exactly there, so the force must "
        "still have its full strength.",
    )


@pytest.mark.exercise("5.3")
@pytest.mark.robust
def test_a_distance_whose_square_is_zero_has_a_direction() -> None:
    about.cause = "The distance from the center is tiny but not 0. Only its square rounds to 0, "
    about.cause += "so check magnitude() instead of the squared magnitude."
    expect_full_strength(1e-170, about.cause)


@pytest.mark.exercise("5.3")
def test_point_gravity_leaves_an_immovable_particle_alone() -> None:
    about(
        "p = Particle(Vector3(0, 2, 0), mass=math.inf); PointGravity(center=Vector3(), ", read=READ
    )
    about.call += "strength=10.0).update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = "An immovable particle has infinite mass, so the force would be infinite or "
    about.cause += "NaN. Check has_finite_mass first, and add no force if it is False."
    p = Particle(Vector3(0, 2, 0), mass=math.inf)
    PointGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO)
    about.call = about.call.replace("math.inf", "4.0")
    about.cause = "The mass of this particle is finite, so the force must act on it."
    p = Particle(Vector3(0, 2, 0), mass=4.0)
    PointGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), (0, -40.0, 0))


@pytest.mark.exercise("5.3")
def test_point_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    about.read = READ
    force, center = components(rng), (7.0, 0.0, 0.0)
    about.call = f"p = Particle(Vector3(3, 0, 0), mass=2.0); p.add_force(Vector3{force}); gravity "
    about.call += "= PointGravity(center=Vector3(), strength=-5.0); gravity.update_force(p, 0.5)"
    about.cause = "With a negative strength the center pushes the particle away. Use the strength "
    about.cause += "with its sign, and add the force to the earlier one with add_force."
    p, gravity = Particle(Vector3(3, 0, 0), mass=2.0), PointGravity(Vector3(), -5.0)
    p.add_force(Vector3(*force))
    gravity.update_force(p, 0.5)
    wanted = (force[0] + 10.0, force[1], force[2])
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N")
    about.cause = "update_force has changed the center or the position, which it must only read. "
    about.cause += "Compute with new vectors instead."
    expect_unchanged("gravity.center", xyz(gravity.center), ZERO)
    expect_unchanged("p.position", xyz(p.position), (3, 0, 0))
    about.call += f"; gravity.center = Vector3{center}; gravity.strength = 1.5; p.clear_forces(); "
    about.call += "gravity.update_force(p, 0.5)"
    about.cause = "The check changes gravity.center and gravity.strength between two calls of "
    about.cause += "update_force. Read self.center and self.strength in every call."
    gravity.center, gravity.strength = Vector3(*center), 1.5
    p.clear_forces()
    gravity.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (3.0, 0, 0), then="; p.force_accumulator, in N")
