"""Gravity toward a point: of constant strength (exercise 5.3), and with 1 / r^2 (exercise 5.4)."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import InverseSquareGravity, PointGravity
from ch05_forces.particle import Particle
from ch05_forces.probes import march
from draw import Triple, unit_vector, vector
from expect import expect_between, expect_close, expect_error, xyz
from unmoved import expect_kept

ZERO = Triple((0.0, 0.0, 0.0))
POINT = "book 5, exercise 5.3; the docstring of PointGravity"
INVERSE = "book 5, exercise 5.4; the docstring of InverseSquareGravity"
SKIP = "Skip only immovable particles, because this particle has a finite mass."
# An orbit of the eccentricity 0.6 and the semi-major axis 1 about mu = 1, from its nearest point.
NEAREST, SPEED = Triple((0.4, 0.0, 0.0)), Triple((0.0, 2.0, 0.0))


def draw_pull(rng: Random) -> tuple[Triple, Triple, float, float]:
    """Return the center, a unit vector away from it, a mass, and the strength of the pull."""
    mass, strength = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)
    return vector(rng), unit_vector(rng), mass, strength


def pull_slips(force: Triple, mass: float, center: Triple, to_origin: Triple) -> dict[str, Triple]:
    """Return what likely mistakes make of the force, if its cause says how to compute it."""
    return {
        "Your force pushes the particle away from the center.": -force,
        "You add an acceleration instead of a force. Multiply it by particle.mass.": force / mass,
        "update_force added nothing. Compute the force, and pass it to particle.add_force.": ZERO,
        "You divide by the mass. Multiply by it instead.": force / mass**2,
        "Your force pulls the particle toward the point (0, 0, 0). Use self.center instead.":
            to_origin,
        "You use the position of the center as the direction. Subtract the particle's position "
        "from it first.": center / abs(center) * abs(force),
        "Your force is half of the right one. Perhaps you multiply it by the duration, which is "
        "0.5 s here. Leave the duration out.": 0.5 * force,
    }  # fmt: skip


@pytest.mark.exercise("5.3", asks="gravity has the same strength at every distance", read=POINT)
def test_the_force_is_equally_strong_at_every_distance(rng: Random) -> None:
    center, way, mass, strength = draw_pull(rng)
    for distance in (0.1, 1.0, 25.0, 4000.0):
        place = center + way * distance
        with calls("The force must be m times the strength, along a unit vector to the center."):
            p = Particle(Vector3(*place), Vector3(5, 6, 7), mass=mass)
            PointGravity(center=Vector3(*center), strength=strength).update_force(p, 0.5)
        force = -mass * strength * way
        slips = {
            "Your force grows, because the vector to the center was not normalized.":
                force * distance,
            "Your force decreases with the distance.": force / distance,
            "Your force decreases with the square of the distance.": force / distance**2,
        }  # fmt: skip
        slips |= pull_slips(force, mass, center, place / abs(place) * -abs(force))
        # The difference of two positions of 10 m, 0.1 m apart, keeps 14 digits; up to 900 N.
        then = "; p.force_accumulator"
        expect_close(p.force_accumulator, force, slips, then=then, unit="N", tolerance=1e-11)
        expect_kept("p.position", xyz(p.position), place)


def expect_full_strength(y: float, cause: str) -> None:
    """Expect the whole force on a particle at this height above the center."""
    with calls(cause):
        p = Particle(Vector3(0, y, 0))
        PointGravity(center=Vector3(), strength=10.0).update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0, -10.0, 0), unit="N")


@pytest.mark.exercise("5.3", asks="so it is zero there", read=POINT)
def test_point_gravity_is_zero_only_at_the_center(rng: Random) -> None:
    center = vector(rng)
    with calls("At the center, you divide by a distance of 0. Add no force exactly there."):
        p = Particle(Vector3(*center))
        PointGravity(center=Vector3(*center), strength=10.0).update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, ZERO, unit="N")
    cause = "The force must have its full strength everywhere except exactly at the center."
    expect_full_strength(1e-9, cause)


@pytest.mark.exercise("5.3", asks="even very close to the center", read=POINT)
@pytest.mark.robust
def test_a_distance_whose_square_rounds_to_zero() -> None:
    cause = "The square of the distance rounds to 0 here. Use magnitude(), which does not."
    expect_full_strength(1e-170, cause)


@pytest.mark.exercise("5.3", asks="Skip an immovable particle", read=POINT)
def test_point_gravity_skips_an_immovable_particle() -> None:
    for mass, force, cause in (
        (math.inf, 0.0, "The force would be infinite. Add it only if has_finite_mass is True."),
        (4.0, -40.0, SKIP),
    ):
        with calls(cause):
            p = Particle(Vector3(0, 2, 0), mass=mass)
            PointGravity(center=Vector3(), strength=10.0).update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (0.0, force, 0.0), unit="N")


def expect_push(
    rng: Random, kind: Any, made: str, *, x: float, push: float, new_x: float, pull: float,
    **strength: float,
) -> None:  # fmt: skip
    """Expect gravity to push if it is negative, and to use a new center and strength.

    ``strength`` is the strength at first, and ``new`` the later one. ``x`` is where the particle
    is, and ``push`` and ``pull`` are the two forces, all along X.
    """
    (name, value), (_, new_value), earlier = *strength.items(), vector(rng)
    with calls(
        f"If {name} is negative, add a force away from the center to the earlier forces.",
        f"p = Particle(Vector3({x}, 0, 0), mass=2.0); p.add_force(Vector3{earlier}); gravity = "
        f"{made}(center=Vector3(), {name}={value}); gravity.update_force(p, 0.5)",
    ):
        p, gravity = Particle(Vector3(x, 0, 0), mass=2.0), kind(Vector3(), value)
        p.add_force(Vector3(*earlier))
        gravity.update_force(p, 0.5)
    along, then = Triple((push, 0.0, 0.0)), "; p.force_accumulator"
    slips = {
        "Your force still pulls the particle toward the center, although "
        f"{name} is negative. Use {name} without changing its sign.": earlier - along
    }
    expect_close(p.force_accumulator, earlier + along, slips, then=then, unit="N")
    expect_kept("gravity.center", xyz(gravity.center), ZERO)
    expect_kept("p.position", xyz(p.position), (x, 0, 0))
    with calls(
        f"Both have changed. Read self.center and self.{name} in every call.",
        f"gravity.center = Vector3({new_x}, 0, 0); gravity.{name} = {new_value}; p.clear_forces(); "
        "gravity.update_force(p, 0.5)",
        more=True,
    ):
        gravity.center = Vector3(new_x, 0, 0)
        setattr(gravity, name, new_value)
        p.clear_forces()
        gravity.update_force(p, 0.5)
    expect_close(p.force_accumulator, (pull, 0, 0), then=then, unit="N")


@pytest.mark.exercise("5.3", asks="or away from it if it is negative", read=POINT)
def test_point_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    numbers = {"strength": -5.0, "new": 1.5, "x": 3.0, "push": 10.0, "new_x": 7.0, "pull": 3.0}
    expect_push(rng, PointGravity, "PointGravity", **numbers)


@pytest.mark.exercise("5.4", asks="Add the force m mu / r^2 toward the center", read=INVERSE)
def test_the_force_is_m_mu_over_r_squared(rng: Random) -> None:
    center, way, mass, mu = draw_pull(rng)
    for distance in (0.3, 1.0, 20.0, 4000.0, 1e6):
        place = center + way * distance
        with calls("The force must be m mu / r^2 toward the center, at a distance of r."):
            p = Particle(Vector3(*place), Vector3(5, 6, 7), mass=mass)
            InverseSquareGravity(center=Vector3(*center), mu=mu).update_force(p, 0.5)
        size = mass * mu / distance**2
        force, later = -size * way, place - center + Triple((2.5, 3.0, 3.5))
        slips = {
            "Your force is proportional to 1 / r instead of 1 / r^2. Either you multiply m mu / "
            "r^2 by the vector to the center without making it a unit vector first, or you divide "
            "by the distance r instead of r^2.": force * distance,
            "Your force is proportional to 1 / r^3. Multiply m mu / r^2 by a unit vector.":
                force / distance,
            "Your force does not depend on the distance r. Python reads a / r * r as (a / r) * r, "
            "so put the product r * r in parentheses, or divide twice.": force * distance**2,
            "Your force grows with r^2. Divide by r^2 instead of multiplying.": force * distance**4,
            "You use the position after the step. Use the current one instead.":
                later / abs(later) ** 3 * (-mass * mu),
        }  # fmt: skip
        slips |= pull_slips(force, mass, center, place / abs(place) ** 3 * (-mass * mu))
        then = "; p.force_accumulator"
        # The difference of two positions of 10 m, 0.3 m apart, keeps 14 digits.
        tolerance = 1e-12 * size
        expect_close(p.force_accumulator, force, slips, then=then, unit="N", tolerance=tolerance)
        expect_kept("p.position", xyz(p.position), place)


@pytest.mark.exercise("5.4", asks="so close to it that the force is not finite", read=INVERSE)
@pytest.mark.robust
def test_a_force_that_is_not_finite_raises_an_error() -> None:
    for x, mu, mass in (
        (0.0, 5.0, 1.0),
        (0.0, 0.0, 1.0),
        (1e-200, 5.0, 1.0),
        (1e-160, 5.0, 2.0),
        (1e-5, 1e300, 1.0),
    ):
        at_center = "At the center, the force has no direction. Raise ArithmeticError."
        near = "The force is too large for a float. Raise ArithmeticError before you add it."
        with calls(near if x else at_center):
            p, gravity = Particle(Vector3(x, 0, 0), mass=mass), InverseSquareGravity(Vector3(), mu)
            p.add_force(Vector3(1, 2, 3))
        good, q = InverseSquareGravity(Vector3(), 5.0), Particle(Vector3(0, 1, 0))
        then = "; gravity.update_force(p, 0.5)"
        expect_error(
            lambda p=p, gravity=gravity: gravity.update_force(p, 0.5),
            ArithmeticError,
            allowed=lambda good=good, q=q: good.update_force(q, 0.5),
            then=then,
        )
        late = "You add a force before you raise the error. Check that it is finite first."
        then += "; p.force_accumulator"
        expect_close(p.force_accumulator, (1, 2, 3), then=then, unit="N", cause=late)


@pytest.mark.exercise("5.4", weight=0.5, asks="it must be correct at any distance", read=INVERSE)
@pytest.mark.robust
def test_a_finite_force_is_correct_at_any_distance() -> None:
    form = "Compute the force as (m / r) (mu / r)."
    small = f"You raise an error, although the force is finite here. {form}"
    large = f"You compute r^2, which is too large for a float at this distance. {form}"
    for y, mu, force in (
        (1e-120, 2.0, -3e240),
        (1e-150, 2e-50, -3e250),
        (1e-9, 2.0, -3e18),
        (1.0, 1e300, -1.5e300),
        (1e200, 2.0, 0.0),
    ):
        with calls(large if y > 1.0 else small):
            p = Particle(Vector3(0, y, 0), mass=1.5)
            InverseSquareGravity(center=Vector3(), mu=mu).update_force(p, 0.5)
            got = p.force_accumulator
        wrong = f"A power of r may not fit in a float. {form}"
        expect_close(got, (0.0, force, 0.0), unit="N", cause=wrong)


@pytest.mark.exercise("5.4", asks="Skip an immovable particle", read=INVERSE)
def test_inverse_square_gravity_skips_an_immovable_particle() -> None:
    for mass, y, force, cause in (
        (math.inf, 2.0, 0.0,
         "The force would be infinite. Return early if has_finite_mass is False."),
        (math.inf, 0.0, 0.0,
         "You check the distance before the mass. Check has_finite_mass first."),
        (4.0, 2.0, -10.0, SKIP),
    ):  # fmt: skip
        with calls(cause):
            p = Particle(Vector3(0, y, 0), mass=mass)
            InverseSquareGravity(center=Vector3(), mu=10.0).update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (0.0, force, 0.0), unit="N")


@pytest.mark.exercise("5.4", asks="or away from it if mu is negative", read=INVERSE)
def test_inverse_square_gravity_may_push_and_its_center_may_move(rng: Random) -> None:
    numbers = {"mu": -6.0, "new": 4.0, "x": 2.0, "push": 3.0, "new_x": 6.0, "pull": 0.5}
    expect_push(rng, InverseSquareGravity, "InverseSquareGravity", **numbers)


@pytest.mark.exercise("5.4", asks="almost no other orbit closes", read=INVERSE)
def test_the_orbit_closes(rng: Random) -> None:
    """Only here the distance changes during the motion, and the orbit must still close."""
    mass, center, ends = round(rng.uniform(2.0, 9.0), 3), vector(rng), []
    for steps in (10_000, 20_000):
        with calls(
            "The orbit must end where it started. The force must be m mu / r^2 at every distance.",
            "a particle p, 0.4 m from the center, moving at 2 m/s at right angles to it; for "
            "6.28319 s: InverseSquareGravity(center, mu=1).update_force(p, h) and p.integrate(h)",
        ):
            p = Particle(Vector3(*(center + NEAREST)), Vector3(*SPEED), mass=mass)
            gravity = InverseSquareGravity(Vector3(*center), 1.0)
            position, _ = march(p, gravity, 2.0 * math.pi / steps, steps)
        ends.append(Triple(position) - center)
    long, short = ends
    # 1.973 for explicit Euler: 2, and a term of the order of h.
    ratio = abs(long - NEAREST) / abs(short - NEAREST)
    gap = "; distance between start and end"
    then = f"{gap} with 10000 steps, divided by that with 20000 steps"
    expect_close(ratio, 2.0, then=then, tolerance=0.05)
    # Richardson's rule removes the error of first order. The rest is of second order, 0.0265 m.
    left = abs(2.0 * short - long - NEAREST)
    expect_between(left, -0.03, 0.03, then=f"{gap} in m, extrapolated to steps of 0 s")
