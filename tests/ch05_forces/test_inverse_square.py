"""Gravity that decreases with the square of the distance, exercise 5.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import InverseSquareGravity
from ch05_forces.particle import Particle
from ch05_forces.probes import orbit
from draw import Components, components, direction
from expect import about, blame, expect_between, expect_close, expect_error, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 5, exercise 5.4; the docstring of InverseSquareGravity"
# An orbit of the eccentricity 0.6 and the semi-major axis 1 about mu = 1, from its nearest point.
ELLIPSE = ((0.4, 0.0, 0.0), (0.0, 2.0, 0.0))
PERIOD = 2.0 * math.pi


def away_from(center: Components, way: Components, distance: float) -> Vector3:
    return Vector3(*(center[i] + way[i] * distance for i in range(3)))


@pytest.mark.exercise("5.4")
def test_the_force_is_m_mu_over_r_squared_towards_the_center(rng: Random) -> None:
    about.read = READ
    center, way = components(rng), direction(rng)
    mass, mu = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)
    for distance in (0.5, 1.0, 20.0, 4000.0, 1e6):
        about.cause = "The force must have the size m mu / r^2, where r is the distance from the "
        about.cause += "center. It must point from the particle's current position toward the "
        about.cause += "center."
        place = away_from(center, way, distance)
        about.call = f"a particle p of {mass} kg, {distance} m from the center; "
        about.call += f"InverseSquareGravity(center=Vector3{center}, mu={mu}).update_force(p, 0.5)"
        p = Particle(place, Vector3(5, 6, 7), mass=mass)
        InverseSquareGravity(Vector3(*center), mu).update_force(p, 0.5)
        size = mass * mu / distance**2
        wanted = tuple(-size * way[i] for i in range(3))
        got = xyz(p.force_accumulator)
        x, y, z = xyz(place)
        reach = math.hypot(x, y, z)
        slips = {
            "Your force is proportional to 1 / r, but it must be proportional to 1 / r^2, "
            "where r is the distance from the center. Check the power of r, and normalize "
            "the direction.": [part * distance for part in wanted],
            "Your force is proportional to 1 / r^3, but it must be proportional to 1 / r^2, "
            "where r is the distance from the center. Check the power of r.": [
                part / distance for part in wanted
            ],
            "Your force pushes the particle away from the center. Use the vector from the "
            "particle to the center as its direction.": [-part for part in wanted],
            "Your force does not depend on the mass, so it is really an acceleration. Multiply "
            "it by particle.mass.": [part / mass for part in wanted],
            "Your force pulls the particle toward the point (0, 0, 0). Measure both the "
            "direction and the distance from self.center instead.": [
                -mass * mu * part / reach**3 for part in (x, y, z)
            ],
        }
        blame(got, slips)
        # The difference of two positions of 10 m, 0.5 m apart, keeps 14 digits.
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-12 * size)
        about.cause = "update_force has changed the position or the center, perhaps because you "
        about.cause += "used -= or normalize, which work in place. Use - and normalized, which "
        about.cause += "create new vectors."
        expect_unchanged("p.position", xyz(p.position), xyz(place))


@pytest.mark.exercise("5.4")
@pytest.mark.robust
def test_at_the_center_there_is_no_finite_force() -> None:
    about.read = READ
    for x, mu, mass in (
        (0.0, 5.0, 1.0),
        (0.0, 0.0, 1.0),
        (1e-200, 5.0, 1.0),
        (1e-160, 5.0, 2.0),
        (1e-5, 1e300, 1.0),
    ):
        about.call = f"p = Particle(Vector3({x}, 0, 0), {mass=}); p.add_force(Vector3(1, 2, 3)); "
        about.call += f"InverseSquareGravity(center=Vector3(), mu={mu}).update_force(p, 0.5)"
        about.cause = "The particle is so close to the center that the force m mu / r^2 is too "
        about.cause += "large for a float. Raise ArithmeticError."
        if x == 0.0:
            about.cause = "The particle is exactly at the center, so the force has no direction. "
            about.cause += "Raise ArithmeticError."
        p = Particle(Vector3(x, 0, 0), mass=mass)
        p.add_force(Vector3(1, 2, 3))
        expect_error(
            lambda p=p, mu=mu: InverseSquareGravity(Vector3(), mu).update_force(p, 0.5),
            ArithmeticError,
            allowed=lambda: InverseSquareGravity(Vector3(), 5.0).update_force(
                Particle(Vector3(0, 1, 0)), 0.5
            ),
        )
        about.cause = "update_force raised an error, but only after it added a force. Check that "
        about.cause += "the force is finite before you add it."
        got = xyz(p.force_accumulator)
        expect_close(got, (1, 2, 3), then="; p.force_accumulator, in N")


@pytest.mark.exercise("5.4", weight=0.5)
@pytest.mark.robust
def test_a_force_that_is_finite_is_right_at_any_distance() -> None:
    about.read = READ
    about.cause = "The force fits in a float here, but r^2 or r^3 does not. Compute (m / r) (mu / "
    about.cause += "r) instead, and multiply it by a unit vector."
    for y, mu, force in (
        (1e-120, 2.0, -3e240),
        (1e-150, 2e-50, -3e250),
        (1e-9, 2.0, -3e18),
        (1.0, 1e300, -1.5e300),
        (1e200, 2.0, 0.0),
    ):
        about.call = f"p = Particle(Vector3(0, {y}, 0), mass=1.5); "
        about.call += f"InverseSquareGravity(center=Vector3(), mu={mu}).update_force(p, 0.5); "
        about.call += "p.force_accumulator, in N"
        p = Particle(Vector3(0, y, 0), mass=1.5)
        InverseSquareGravity(Vector3(), mu).update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, (0.0, force, 0.0))


@pytest.mark.exercise("5.4")
def test_inverse_square_gravity_leaves_an_immovable_particle_alone() -> None:
    about.read = READ
    about.call = "p = Particle(Vector3(0, 2, 0), mass=math.inf); "
    about.call += "InverseSquareGravity(center=Vector3(), mu=10.0).update_force(p, 0.5); "
    about.call += "p.force_accumulator, in N"
    about.cause = "An immovable particle has infinite mass, so the force would be infinite or "
    about.cause += "NaN. Check has_finite_mass first, and add no force if it is False."
    p = Particle(Vector3(0, 2, 0), mass=math.inf)
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO)
    p.position = Vector3()
    about.cause = "An immovable particle gets no force, not even at the center. Check "
    about.cause += "has_finite_mass before you check the distance."
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    name = about.call.replace("(0, 2, 0)", "()")
    expect_close(xyz(p.force_accumulator), ZERO, call=name)
    about.call = about.call.replace("math.inf", "4.0")
    about.cause = "The mass of this particle is finite, so the force must act on it."
    p = Particle(Vector3(0, 2, 0), mass=4.0)
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), (0, -10.0, 0))


@pytest.mark.exercise("5.4")
def test_inverse_square_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    about.read = READ
    force = components(rng)
    about.call = f"p = Particle(Vector3(2, 0, 0), mass=2.0); p.add_force(Vector3{force}); gravity "
    about.call += "= InverseSquareGravity(center=Vector3(), mu=-6.0); gravity.update_force(p, 0.5)"
    about.cause = "With a negative mu the center pushes the particle away. Use mu with its sign, "
    about.cause += "and add the force to the earlier one with add_force."
    p, gravity = Particle(Vector3(2, 0, 0), mass=2.0), InverseSquareGravity(Vector3(), -6.0)
    p.add_force(Vector3(*force))
    gravity.update_force(p, 0.5)
    wanted = (force[0] + 3.0, force[1], force[2])
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N")
    about.cause = "update_force has changed the center or the position, which it must only read. "
    about.cause += "Compute with new vectors instead."
    expect_unchanged("gravity.center", xyz(gravity.center), ZERO)
    expect_unchanged("p.position", xyz(p.position), (2, 0, 0))
    about.call += "; gravity.center = Vector3(6, 0, 0); gravity.mu = 4.0; p.clear_forces(); "
    about.call += "gravity.update_force(p, 0.5)"
    about.cause = "The check changes gravity.center and gravity.mu between two calls of "
    about.cause += "update_force. Read self.center and self.mu in every call."
    gravity.center, gravity.mu = Vector3(6, 0, 0), 4.0
    p.clear_forces()
    gravity.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.5, 0, 0), then="; p.force_accumulator, in N")


@pytest.mark.exercise("5.4")
def test_kepler_s_ellipse_is_met_the_better_the_shorter_the_frames(rng: Random) -> None:
    about.read = READ
    mass, center = round(rng.uniform(2.0, 9.0), 3), components(rng)
    about.call = "a particle p, 0.4 m from the center and moving at 2 m/s at right angles to it; "
    about.call += "1 s of InverseSquareGravity with mu = 1"
    about.cause = "With a force of m mu / r^2 toward the center, the particle moves on Kepler's "
    about.cause += "ellipse. If another check of this force fails too, fix that one first."
    exact = (-0.62894818, 0.79966473, 0.0)
    ends = [orbit(ELLIPSE, 1.0, mass, 1.0 / n, n, center)[0] for n in (1000, 2000)]
    errors = [math.dist(end, exact) for end in ends]
    # Explicit Euler is off by 7.1 h here, and its next term is 0.3 % of that.
    expect_between(
        errors[0], -0.008, 0.008, then="; error of p.position in m with steps of 1/1000 s"
    )
    about.cause = "With the right force, half the time step gives half the error. Check that the "
    about.cause += "force is m mu / r^2 at every distance r."
    expect_close(
        errors[0] / errors[1],
        2.0,
        then="; error of p.position with steps of 1/1000 s, divided by the error with "
        "steps of 1/2000 s",
        tolerance=0.02,
    )


@pytest.mark.exercise("5.4")
def test_the_orbit_closes() -> None:
    about(
        "a particle, 0.4 m from the center and moving at 2 m/s at right angles to it; ", read=READ
    )
    about.call += "one orbit by InverseSquareGravity with mu = 1, which takes 2 pi s"
    about.cause = "With a force proportional to 1 / r^2 the particle returns to where it started, "
    about.cause += "apart from the error of the steps. Check the power of r in your force."
    counts = (10_000, 20_000)
    ends = [orbit(ELLIPSE, 1.0, 1.0, PERIOD / n, n, ZERO)[0] for n in counts]
    gaps = [math.dist(end, ELLIPSE[0]) for end in ends]
    # 1.973 for explicit Euler: 2, and a term of the order of h.
    expect_close(
        gaps[0] / gaps[1],
        2.0,
        then="; distance between start and end with 10000 steps, divided by that with 20000 steps",
        tolerance=0.05,
    )
    # Richardson's rule removes the error of first order. The rest is of second order, 0.0265 m.
    left = math.dist([2.0 * b - a for a, b in zip(*ends, strict=True)], ELLIPSE[0])
    expect_between(
        left,
        -0.03,
        0.03,
        then="; distance between start and end in m, extrapolated to steps of 0 s",
    )
