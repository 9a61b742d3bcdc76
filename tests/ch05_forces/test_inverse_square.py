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


@pytest.mark.exercise("5.4", asks="Add the force m mu / r^2 toward the center")
def test_the_force_is_m_mu_over_r_squared(rng: Random) -> None:
    about.read = READ
    center, way = components(rng), direction(rng)
    mass, mu = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)
    for distance in (0.3, 1.0, 20.0, 4000.0, 1e6):
        about.cause = "The force is wrong. It must point toward the center, and its size must be "
        about.cause += "m mu / r^2, where r is the distance from the center."
        place = away_from(center, way, distance)
        about.call = f"a particle p of {mass} kg, {distance:g} m from the center; "
        about.call += f"InverseSquareGravity(center=Vector3{center}, mu={mu}).update_force(p, 0.5)"
        p = Particle(place, Vector3(5, 6, 7), mass=mass)
        InverseSquareGravity(Vector3(*center), mu).update_force(p, 0.5)
        size = mass * mu / distance**2
        wanted = tuple(-size * way[i] for i in range(3))
        got = xyz(p.force_accumulator)
        x, y, z = xyz(place)
        reach = math.hypot(x, y, z)
        moved = [
            part - c + 0.5 * v for part, c, v in zip((x, y, z), center, (5, 6, 7), strict=True)
        ]
        later = math.hypot(*moved)
        slips = {
            "Your force is proportional to 1 / r instead of 1 / r^2. Either you multiply m mu / "
            "r^2 by the vector to the center without making it a unit vector first, or you divide "
            "by the distance r instead of r^2.": [part * distance for part in wanted],
            "Your force is proportional to 1 / r^3 instead of 1 / r^2, where r is the distance. "
            "Multiply m mu / r^2 by a unit vector.": [part / distance for part in wanted],
            "update_force added no force to the particle. Compute the force, and pass it to "
            "particle.add_force.": ZERO,
            "Your force does not depend on the distance r. Python reads a / r * r as (a / r) * r, "
            "so put the product r * r in parentheses, or divide twice.": [
                part * distance**2 for part in wanted
            ],
            "Your force grows with the square of the distance r. Divide by r^2 instead of "
            "multiplying.": [part * distance**4 for part in wanted],
            "You divide by the mass. The factor mu / r^2 is an acceleration, so multiply it by the "
            "mass to get a force.": [part / mass**2 for part in wanted],
            "You compute the force from the position after the step. Use the current position of "
            "the particle instead.": [-mass * mu * part / later**3 for part in moved],
            "Your force pushes the particle away from the center. Use the vector from the "
            "particle to the center instead.": [-part for part in wanted],
            "You add an acceleration instead of a force. Multiply it by particle.mass.": [
                part / mass for part in wanted
            ],
            "You use the position of the center as the direction. Subtract the particle's position "
            "from it first.": [
                mass * mu * part / distance**2 / math.hypot(*center) for part in center
            ],
            "Your force is half of the right one. Perhaps you multiply it by the duration, which "
            "is 0.5 s here. Leave the duration out.": [0.5 * part for part in wanted],
            "Your force pulls the particle toward the point (0, 0, 0). Use self.center instead.": [
                -mass * mu * part / reach**3 for part in (x, y, z)
            ],
        }
        blame(got, slips)
        # The difference of two positions of 10 m, 0.3 m apart, keeps 14 digits.
        expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=1e-12 * size)
        about.cause = "You change the position of the particle, because -= works in place. Use -, "
        about.cause += "which creates a new vector."
        expect_unchanged("p.position", xyz(p.position), xyz(place))


@pytest.mark.exercise("5.4", asks="so close to it that the force is not finite")
@pytest.mark.robust
def test_a_force_that_is_not_finite_raises_an_error() -> None:
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
        about.cause = "The force m mu / r^2 is too large for a float so close to the center. Raise "
        about.cause += "ArithmeticError before you add it."
        if x == 0.0:
            about.cause = "The particle is exactly at the center, where the force has no "
            about.cause += "direction. Raise ArithmeticError."
        p = Particle(Vector3(x, 0, 0), mass=mass)
        p.add_force(Vector3(1, 2, 3))
        expect_error(
            lambda p=p, mu=mu: InverseSquareGravity(Vector3(), mu).update_force(p, 0.5),
            ArithmeticError,
            allowed=lambda: InverseSquareGravity(Vector3(), 5.0).update_force(
                Particle(Vector3(0, 1, 0)), 0.5
            ),
        )
        about.cause = "update_force raised the error only after it had added a force. Check that "
        about.cause += "the force is finite before you add it."
        got = xyz(p.force_accumulator)
        expect_close(got, (1, 2, 3), then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("5.4", weight=0.5, asks="it must be correct at any distance")
@pytest.mark.robust
def test_a_finite_force_is_correct_at_any_distance() -> None:
    about.read = READ
    small = "You raise an error, although the force is finite here. Compute the force as (m / r) "
    small += "(mu / r), and raise the error only if this is not finite."
    wrong = "The force is wrong at this distance. Compute it as (m / r) (mu / r), because a power "
    wrong += "of r may not fit in a float."
    large = "You compute r^2, which is too large for a float at this distance. Compute the force "
    large += "as (m / r) (mu / r) instead of m mu / r^2."
    for y, mu, force in (
        (1e-120, 2.0, -3e240),
        (1e-150, 2e-50, -3e250),
        (1e-9, 2.0, -3e18),
        (1.0, 1e300, -1.5e300),
        (1e200, 2.0, 0.0),
    ):
        about.call = f"p = Particle(Vector3(0, {y}, 0), mass=1.5); "
        about.call += f"InverseSquareGravity(center=Vector3(), mu={mu}).update_force(p, 0.5); "
        about.call += "p.force_accumulator"
        about.cause = large if y > 1.0 else small
        p = Particle(Vector3(0, y, 0), mass=1.5)
        InverseSquareGravity(Vector3(), mu).update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, (0.0, force, 0.0), unit="N", cause=wrong)


@pytest.mark.exercise("5.4", asks="Skip an immovable particle")
def test_inverse_square_gravity_skips_an_immovable_particle() -> None:
    about.read = READ
    about.call = "p = Particle(Vector3(0, 2, 0), mass=math.inf); "
    about.call += "InverseSquareGravity(center=Vector3(), mu=10.0).update_force(p, 0.5); "
    about.call += "p.force_accumulator"
    about.cause = "The force on an immovable particle would be infinite, so don't add it. Return "
    about.cause += "early if has_finite_mass is False."
    p = Particle(Vector3(0, 2, 0), mass=math.inf)
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO, unit="N")
    p.position = Vector3()
    about.cause = "You check the distance before the mass. Check has_finite_mass first, because an "
    about.cause += "immovable particle gets no force even at the center."
    name = about.call
    about.call = name.replace("(0, 2, 0)", "()")
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO, unit="N")
    about.call = name.replace("math.inf", "4.0")
    about.cause = "Your force does not act on this particle, although its mass is finite. Skip "
    about.cause += "only immovable particles."
    p = Particle(Vector3(0, 2, 0), mass=4.0)
    InverseSquareGravity(Vector3(), 10.0).update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), (0, -10.0, 0), unit="N")


@pytest.mark.exercise("5.4", asks="or away from it if mu is negative")
def test_inverse_square_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    about.read = READ
    force = components(rng)
    about.call = f"p = Particle(Vector3(2, 0, 0), mass=2.0); p.add_force(Vector3{force}); gravity "
    about.call += "= InverseSquareGravity(center=Vector3(), mu=-6.0); gravity.update_force(p, 0.5)"
    about.cause = "The force is wrong for a negative mu. It must push the particle away from the "
    about.cause += "center, and it must not replace earlier forces."
    p, gravity = Particle(Vector3(2, 0, 0), mass=2.0), InverseSquareGravity(Vector3(), -6.0)
    p.add_force(Vector3(*force))
    gravity.update_force(p, 0.5)
    wanted = (force[0] + 3.0, force[1], force[2])
    got = xyz(p.force_accumulator)
    pulls = "Your force still pulls the particle toward the center, although mu is negative. Use "
    pulls += "mu without changing its sign."
    blame(got, {pulls: (force[0] - 3.0, force[1], force[2])})
    expect_close(got, wanted, then="; p.force_accumulator", unit="N")
    about.cause = "You change gravity.center, because -= works in place. Use -, which creates a "
    about.cause += "new vector."
    expect_unchanged("gravity.center", xyz(gravity.center), ZERO)
    about.cause = about.cause.replace("gravity.center", "p.position")
    expect_unchanged("p.position", xyz(p.position), (2, 0, 0))
    about.call += "; gravity.center = Vector3(6, 0, 0); gravity.mu = 4.0; p.clear_forces(); "
    about.call += "gravity.update_force(p, 0.5)"
    about.cause = "You use the initial center or mu, but both have changed since then. Read "
    about.cause += "self.center and self.mu in every call."
    gravity.center, gravity.mu = Vector3(6, 0, 0), 4.0
    p.clear_forces()
    gravity.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.5, 0, 0), then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("5.4", asks="Gravity that falls with 1 / r^2, as for orbits")
def test_an_orbit_is_more_accurate_with_shorter_steps(rng: Random) -> None:
    about.read = READ
    mass, center = round(rng.uniform(2.0, 9.0), 3), components(rng)
    about.call = "a particle p, 0.4 m from the center, moving at 2 m/s at right angles to it; for "
    about.call += "1 s: InverseSquareGravity(center, mu=1).update_force(p, h) and p.integrate(h)"
    about.cause = "The particle leaves its exact orbit, so the force is wrong. It must be m mu / "
    about.cause += "r^2 toward the center, where r is the distance."
    exact = (-0.62894818, 0.79966473, 0.0)
    ends = [orbit(ELLIPSE, 1.0, mass, 1.0 / n, n, center)[0] for n in (1000, 2000)]
    errors = [math.dist(end, exact) for end in ends]
    # Explicit Euler is off by 7.1 h here, and its next term is 0.3 % of that.
    expect_between(
        errors[0],
        -0.008,
        0.008,
        then="; distance of p from its exact position, with steps of h = 1/1000 s",
        unit="m",
    )
    about.cause = "Halving the time step doesn't halve the error, so the force is wrong. It must "
    about.cause += "be m mu / r^2 at every distance r."
    expect_close(
        errors[0] / errors[1],
        2.0,
        then="; error of p.position with steps of 1/1000 s, divided by the error with "
        "steps of 1/2000 s",
        tolerance=0.02,
    )


@pytest.mark.exercise("5.4", asks="almost no other orbit closes")
def test_the_orbit_closes() -> None:
    about("a particle p, 0.4 m from the center, moving at 2 m/s at right angles to it; ", read=READ)
    about.call += "for one orbit, 2 pi s: InverseSquareGravity(center, mu=1).update_force(p, h) "
    about.call += "and p.integrate(h)"
    about.cause = "The orbit does not end where it started, so the force is wrong. It must be "
    about.cause += "m mu / r^2 at every distance r."
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
