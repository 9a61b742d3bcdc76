"""The two moves that make up a step, build task B3.4: drift and kick."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import vector
from expect import expect_close, expect_unchanged

DRIFT, KICK = "the docstring of drift", "the docstring of kick"
MOVES = "book 2.2.2, Eq. 2.9, and the docstrings of drift and kick"
# The rounding errors of a few operations on numbers up to 40.
ROUNDED = 1e-13
POSITION, VELOCITY = "; p.position", "; p.velocity"


def draw_part(rng: Random) -> float:
    """Draw a duration, or a damping, that is large enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


@pytest.mark.exercise("B3.4", asks="The duration may be 0 or negative", read=DRIFT)
def test_a_drift_moves_the_position_alone(rng: Random) -> None:
    x, v, a, damping = vector(rng), vector(rng), vector(rng), draw_part(rng)
    for h in (draw_part(rng), 2, 0.0, -draw_part(rng)):
        with calls(
            f"You reject a duration of {h}, but drift must accept every duration. A negative one "
            "moves the particle back."
        ):
            p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), damping=damping)
            p.drift(h)
        slips = {
            "You use the acceleration in drift, but only kick may use it.": x + (v + a * h) * h,
            "You damp the velocity in drift. Only read the velocity there, because kick does the "
            "damping.": x + v * (damping**h * h),
            "You add the whole velocity, which is the displacement in one second.": x + v,
            "You move backward. Add the velocity times h instead of subtracting it.": x - v * h,
            "Your position is now only v h, the displacement. Add it to the old position.": v * h,
            "You use the acceleration in drift, but only kick may use it. Leave out a h^2 / 2.":
                x + v * h + a * (h * h / 2.0),
            "The position did not change. Add the velocity times the duration h to it. If you do, "
            "assign the new vector to self.position, not to a local variable.": x,
            "You add a h to the position. Use the velocity instead of the acceleration.": x + a * h,
        }  # fmt: skip
        cause = "A drift must add v h to the position, where v is the velocity and h the duration."
        found = slips if h else {}
        expect_close(p.position, x + v * h, found, then=POSITION, tolerance=ROUNDED, cause=cause)
        for name, now, before in (("velocity", p.velocity, v), ("acceleration", p.acceleration, a)):
            cause = (
                f"Your drift changes the {name}, but it must change only the position. Read "
                f"self.{name} without changing it."
            )
            expect_unchanged(f"p.{name}", now, before, cause=cause)


@pytest.mark.exercise("B3.4", asks="A kick changes only the velocity", read=KICK)
def test_a_kick_changes_the_velocity_alone(rng: Random) -> None:
    x, v, a, drawn = vector(rng), vector(rng), vector(rng), draw_part(rng)
    for h, damping, mass in (
        (draw_part(rng), drawn, 1.0),
        (2, drawn, 1.0),
        (0.0, drawn, 1.0),
        (-drawn, 1.0, 1.0),
        (draw_part(rng), drawn, 4.0),
        (draw_part(rng), 0.0, 1.0),
        (draw_part(rng), 2.0, 1.0),
        (0.0, 0.0, 1.0),
    ):
        with calls(
            "A kick must change the velocity to v' = (v + a h) d^h, even if h is 0 or negative. "
            "Add a h first, and then multiply the sum by d^h."
        ):
            p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping)
            p.kick(h)
        keep, moved = damping**h, v + a * h
        undamped = (
            "You treat a damping of 0 as no damping. Python treats 0 as false in an if statement, "
            "so don't use the damping as the condition."
        )
        slips = {
            "You damp only the old velocity, as in Eq. 3.6, but the engine follows the book's "
            "listing (E-16). Compute (v + a h) d^h, where h is the duration.": v * keep + a * h,
            "You add the whole acceleration, which is the change of velocity in one second. "
            "Multiply it by the duration h first.": (v + a) * keep,
            "You multiply by d h, but h is an exponent. Multiply the velocity by damping**h.":
                moved * damping * h,
            "You multiply by (1 - d)^h. The damping d is what is kept, so multiply by d^h.":
                moved * abs(1.0 - damping) ** abs(h),
            "Your velocity is now only a h. Add it to the old velocity, and damp the sum.": a * h,
            "You leave out the acceleration.": v * keep,
            "You multiply the acceleration by the mass. The mass doesn't matter here.":
                (v + a * h * mass) * keep,
            "You multiply the velocity by the damping d, whatever the duration is. The damping is "
            "given per second, so multiply by d^h.": moved * damping,
            "You don't damp the velocity." if damping else undamped: moved,
            "You divide the acceleration by the mass, which is right only for a force.":
                (v + a * h / mass) * keep,
            "The velocity did not change.": v,
        }  # fmt: skip
        found = slips if h and damping != 1.0 else {}
        expect_close(p.velocity, moved * keep, found, then=VELOCITY, tolerance=ROUNDED)
        factor = (
            "Your kick changes the damping of the particle, so the next kick damps by another "
            "factor. Compute d^h in a new variable."
        )
        expect_close(p.damping, damping, then="; p.damping", tolerance=0.0, cause=factor)
        for name, now, before in (("position", p.position, x), ("acceleration", p.acceleration, a)):
            cause = (
                f"Your kick changes the {name}, but it must change only the velocity. Leave "
                f"self.{name} unchanged."
            )
            expect_unchanged(f"p.{name}", now, before, cause=cause)


@pytest.mark.exercise("B3.4", asks="a step may consist of several drifts", read=MOVES)
def test_half_a_drift_a_kick_and_half_a_drift_fall_exactly(rng: Random) -> None:
    """Only here a particle drifts twice, so that the second drift must use the new velocity."""
    x, v, a, h = vector(rng), vector(rng), vector(rng), draw_part(rng)
    with calls(
        "Half a drift, a kick and another half drift must give the exact position p + v h + a h^2 "
        "/ 2. Check that each call continues from the current position and velocity."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a))
        p.drift(h / 2.0)
        p.kick(h)
        p.drift(h / 2.0)
    exact = x + v * h + a * (h * h / 2.0)
    expect_close(p.position, exact, then=POSITION, tolerance=ROUNDED)
    expect_close(p.velocity, v + a * h, then=VELOCITY, tolerance=ROUNDED)


@pytest.mark.exercise("B3.4", asks="An immovable particle does not move at all", read=MOVES)
def test_no_move_changes_an_immovable_particle(rng: Random) -> None:
    x, v, a, h = vector(rng), vector(rng), vector(rng), draw_part(rng)
    for name in ("drift", "kick"):
        with calls(
            f"Your {name} changes a particle with an infinite mass. If the inverse_mass is 0, "
            "return from the method without changing anything.",
            f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass=math.inf); p.{name}({h})",
        ):
            p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf, damping=0.5)
            getattr(p, name)(h)
        expect_unchanged("p.position", p.position, x)
        expect_unchanged("p.velocity", p.velocity, v)
    with calls(
        "The particle has a finite mass now, so drift and kick must change it again. Check "
        "inverse_mass in every call instead of storing the result."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
        p.mass = 2.0
        p.drift(h)
        p.kick(h)
    expect_close(p.position, x + v * h, then=POSITION, tolerance=ROUNDED)
    expect_close(p.velocity, v + a * h, then=VELOCITY, tolerance=ROUNDED)
