"""The two moves that make up a step, build task B3.4: drift and kick."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import Components, components
from expect import about, blame, expect_close, expect_unchanged, xyz

# The rounding errors of a few operations on numbers up to 40.
ROUNDED = 1e-13


def draw_part(rng: Random) -> float:
    """Draw a duration that is long enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


def a_particle(
    x: Components, v: Components, a: Components, mass: float = 1.0, damping: float = 1.0
) -> tuple[str, Particle]:
    """Return the code that makes a particle, and the particle."""
    words = f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a"
    words += f", {mass=}".replace("inf", "math.inf") if mass != 1.0 else ""
    words += f", {damping=})" if damping != 1.0 else ")"
    return words, Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping)


@pytest.mark.exercise("B3.4", asks="The duration may be 0 or negative")
def test_a_drift_moves_the_position_alone(rng: Random) -> None:
    x, v, a, damping = components(rng), components(rng), components(rng), draw_part(rng)
    about.read = "the docstring of drift"
    for h in (draw_part(rng), 2, 0.0, -draw_part(rng)):
        words, p = a_particle(x, v, a, damping=damping)
        about.call = f"{words}; p.drift({h})"
        about.cause = (
            f"You reject a duration of {h}, but drift must accept every duration. A negative one "
            "moves the particle back."
        )
        p.drift(h)
        about.cause = "A drift must add v h to the position, where h is the duration."
        got = xyz(p.position)
        mistakes = [
            (
                tuple(x[i] + (v[i] + a[i] * h) * h for i in range(3)),
                "You use the acceleration in drift, but only kick may use it. Add only the "
                "velocity times the duration to the position.",
            ),
            (
                tuple(x[i] + v[i] * damping**h * h for i in range(3)),
                "You damp the velocity in drift. Only read the velocity there, because kick does "
                "the damping.",
            ),
            (
                tuple(x[i] + v[i] for i in range(3)),
                "You add the whole velocity, which is the displacement in one second. Multiply it "
                "by the duration h.",
            ),
            (
                tuple(x[i] - v[i] * h for i in range(3)),
                "You move backward. Add the velocity times h instead of subtracting it.",
            ),
            (
                tuple(n * h for n in v),
                "Your position is now only v h, the displacement. Add it to the old position.",
            ),
            (
                tuple(x[i] + v[i] * h + a[i] * h * h / 2.0 for i in range(3)),
                "You use the acceleration in drift, but only kick may use it. Leave out a h^2 / 2.",
            ),
            (
                x,
                "The position did not change. Add the velocity times the duration h to it. If you "
                "do, assign the new vector to self.position, not to a local variable.",
            ),
            (
                tuple(x[i] + a[i] * h for i in range(3)),
                "You add a h to the position. Use the velocity instead of the acceleration.",
            ),
        ]
        blame(got, mistakes if h else [])
        wanted = tuple(x[i] + v[i] * h for i in range(3))
        expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)
        for name, before in (("velocity", v), ("acceleration", a)):
            about.cause = (
                f"Your drift changes the {name}, but it must change only the position. Read "
                f"self.{name} without changing it."
            )
            expect_unchanged(f"p.{name}", xyz(getattr(p, name)), before)


@pytest.mark.exercise("B3.4", asks="A kick changes only the velocity")
def test_a_kick_changes_the_velocity_alone(rng: Random) -> None:
    x, v, a, drawn = components(rng), components(rng), components(rng), draw_part(rng)
    about.read = "the docstring of kick"
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
        words, p = a_particle(x, v, a, mass, damping)
        about.call = f"{words}; p.kick({h})"
        about.cause = (
            "A kick must change the velocity to v' = (v + a h) d^h, even if h is 0 or negative. "
            "Add a h first, and then multiply the sum by d^h."
        )
        p.kick(h)
        got = xyz(p.velocity)
        keep = damping**h
        mistakes = [
            (
                tuple(v[i] * keep + a[i] * h for i in range(3)),
                "You damp only the old velocity, as in Eq. 3.6, but the engine follows the book's "
                "listing (E-16). Compute (v + a h) d^h, where h is the duration.",
            ),
            (
                tuple(v[i] * keep + a[i] * keep for i in range(3)),
                "You add the whole acceleration, which is the change of velocity in one second. "
                "Multiply it by the duration h first.",
            ),
            (
                tuple((v[i] + a[i] * h) * damping * h for i in range(3)),
                "You multiply by d h, but h is an exponent. Multiply the velocity by damping**h.",
            ),
            (
                tuple((v[i] + a[i] * h) * abs(1.0 - damping) ** abs(h) for i in range(3)),
                "You multiply by (1 - d)^h. The damping d is what is kept, so multiply by d^h.",
            ),
            (
                tuple(a[i] * h for i in range(3)),
                "Your velocity is now only a h. Add it to the old velocity, and damp the sum.",
            ),
            (
                tuple(v[i] * keep for i in range(3)),
                "You leave out the acceleration. Add a h to the velocity before you damp it.",
            ),
            (
                tuple((v[i] + a[i] * h * mass) * keep for i in range(3)),
                "You multiply the acceleration by the mass. The mass doesn't matter here.",
            ),
            (
                tuple((v[i] + a[i] * h) * damping for i in range(3)),
                "You multiply the velocity by the damping d, whatever the duration is. The damping "
                "is given per second, so multiply by d^h.",
            ),
            (
                tuple(v[i] + a[i] * h for i in range(3)),
                "You don't damp the velocity. Multiply it by d^h after you add a h."
                if damping
                else "You treat a damping of 0 as no damping. Python treats 0 as false in an if "
                "statement, so don't use the damping as the condition.",
            ),
            (
                tuple((v[i] + a[i] * h / mass) * keep for i in range(3)),
                "You divide the acceleration by the mass, which is right only for a force. Add the "
                "acceleration times h to the velocity instead.",
            ),
            (
                v,
                "The velocity did not change. Add the acceleration times the duration h to it.",
            ),
        ]
        blame(got, mistakes if h and damping != 1.0 else [])
        wanted = tuple((v[i] + a[i] * h) * keep for i in range(3))
        expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
        about.cause = (
            "Your kick changes the damping of the particle, so the next kick damps by another "
            "factor. Compute d^h in a new variable."
        )
        expect_close(p.damping, damping, then="; p.damping", tolerance=0.0)
        for name, before in (("position", x), ("acceleration", a)):
            about.cause = (
                f"Your kick changes the {name}, but it must change only the velocity. Leave "
                f"self.{name} unchanged."
            )
            expect_unchanged(f"p.{name}", xyz(getattr(p, name)), before)


@pytest.mark.exercise("B3.4", asks="a step may consist of several drifts")
def test_half_a_drift_a_kick_and_half_a_drift_fall_exactly(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_part(rng)
    words, p = a_particle(x, v, a)
    about.call = f"{words}; p.drift({h} / 2); p.kick({h}); p.drift({h} / 2)"
    about.cause = (
        "Half a drift, a kick and another half drift must give the exact position p + v h + a h^2 "
        "/ 2. Check that each call continues from the current position and velocity."
    )
    about.read = "book 2.2.2, Eq. 2.9, and the docstrings of drift and kick"
    p.drift(h / 2.0)
    p.kick(h)
    p.drift(h / 2.0)
    wanted = tuple(x[i] + v[i] * h + a[i] * h * h / 2.0 for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)
    wanted = tuple(v[i] + a[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)


@pytest.mark.exercise("B3.4", asks="An immovable particle does not move at all")
def test_no_move_changes_an_immovable_particle(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_part(rng)
    for move in ("drift", "kick"):
        about.cause = (
            f"Your {move} changes a particle with an infinite mass. If the inverse_mass is 0, "
            "return from the method without changing anything."
        )
        words, p = a_particle(x, v, a, math.inf, 0.5)
        about(f"{words}; p.{move}({h})", read=f"the docstring of {move}")
        getattr(p, move)(h)
        expect_unchanged("p.position", xyz(p.position), x)
        expect_unchanged("p.velocity", xyz(p.velocity), v)
    words, p = a_particle(x, v, a, math.inf)
    about.call = f"{words}; p.mass = 2.0; p.drift({h}); p.kick({h})"
    about.read = "the docstrings of drift and kick"
    about.cause = (
        "The particle has a finite mass now, so drift and kick must change it again. Check "
        "inverse_mass in every call instead of storing the result."
    )
    p.mass = 2.0
    p.drift(h)
    p.kick(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)
    wanted = tuple(v[i] + a[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
