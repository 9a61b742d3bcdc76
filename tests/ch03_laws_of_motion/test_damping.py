"""The two equations for damping, build task B3.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import damping as forms
from draw import Components, components
from expect import (
    about,
    blame,
    expect_close,
    expect_unchanged,
    xyz,
)


def draw_damping(rng: Random) -> float:
    """Draw a damping that is far enough from 1 for each mistake to show."""
    return round(rng.uniform(0.3, 0.9), 3)


def combined(v: Components, a: Components, kept: float, gained: float) -> Components:
    """Return v kept + a gained, the general form of both damping equations."""
    return v[0] * kept + a[0] * gained, v[1] * kept + a[1] * gained, v[2] * kept + a[2] * gained


# B3.3 Two equations for damping


@pytest.mark.exercise("B3.3", asks="every step keeps the fraction d")
def test_damping_per_frame_does_not_depend_on_the_duration(rng: Random) -> None:
    v, a = components(rng), components(rng)
    about.read = "book 3.3, Eq. 3.5"
    for d, h in ((draw_damping(rng), 0.1), (draw_damping(rng), 0.7), (0.0, 0.5), (1.5, 0.5)):
        about.call = (
            f"v, a = Vector3{v}, Vector3{a}; damp_per_frame(v, a, damping={d}, duration={h})"
        )
        about.cause = (
            "Eq. 3.5 is v' = v d + a h. Multiply the velocity by the damping d, and then add the "
            "acceleration times the duration h."
        )
        got = forms.damp_per_frame(Vector3(*v), Vector3(*a), d, h)
        undamped = (
            "You don't damp the velocity. Multiply it by the damping before you add the "
            "acceleration times the duration."
        )
        if d == 0.0:
            undamped = (
                "You treat a damping of 0 as no damping. Python treats 0 as false in an if "
                "statement, so don't use the damping as the condition."
            )
        mistakes = [
            (
                combined(v, a, d**h, h),
                "You multiply the velocity by damping^duration, as in Eq. 3.6, but this "
                "function implements Eq. 3.5. Multiply it by the damping itself, whatever "
                "the duration is.",
            ),
            (
                combined(v, a, d, 1.0),
                "You add the whole acceleration, which is the change of velocity in one second. "
                "Multiply it by the duration of the step first.",
            ),
            (
                combined(v, a, d, d * h),
                "You damp the acceleration as well. In Eq. 3.5 the damping applies only to the "
                "old velocity.",
            ),
            (combined(v, a, 1.0, h), undamped),
            (
                combined(v, a, 1.0 - d, h),
                "You multiply the velocity by 1 - d, the fraction that is lost. Multiply it by d, "
                "the fraction that is kept.",
            ),
            (combined(v, a, d * h, h), "You multiply the velocity by d h. Multiply it by d alone."),
            (combined(v, a, d, 0.0), "You leave out the acceleration. Add a h to v d."),
            (combined(v, a, d, -h), "You subtract a h. Add it to v d."),
        ]
        blame(xyz(got), mistakes)
        wanted = combined(v, a, d, h)
        expect_close(xyz(got), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="every second keeps the fraction d")
def test_damping_per_second_depends_on_the_duration(rng: Random) -> None:
    v, drawn = components(rng), draw_damping(rng)
    about.read = "book 3.3, Eq. 3.6"
    for d, h in ((drawn, 0.25), (drawn, 1.0), (drawn, 2.0), (0.0, 0.5), (1.5, 0.5)):
        about.call = (
            f"v, a = Vector3{v}, Vector3(0, 0, 0); damp_per_second(v, a, damping={d}, duration={h})"
        )
        about.cause = (
            "The acceleration is 0 here, so Eq. 3.6 becomes v' = v d^h, where d is the damping and "
            "h the duration. Check how you compute d^h."
        )
        got = forms.damp_per_second(Vector3(*v), Vector3(), d, h)
        mistakes = [
            (
                combined(v, v, d, 0.0),
                "You multiply the velocity by the damping d, as in Eq. 3.5, but this function "
                "implements Eq. 3.6. Multiply it by d^h, where h is the duration.",
            ),
            (
                combined(v, v, d * h, 0.0),
                "You multiply the velocity by the damping times the duration, but in Eq. 3.6 "
                "the duration is an exponent. Use damping**duration.",
            ),
            (
                combined(v, v, 1.0 - d**h, 0.0),
                "You multiply the velocity by 1 - d^h, the fraction that is lost. Multiply it by "
                "d^h, the fraction that is kept.",
            ),
            (
                combined(v, v, h**d, 0.0),
                "You swap the base and the exponent. Use damping**duration.",
            ),
            (
                combined(v, v, d ** (1.0 / h), 0.0),
                "Your exponent is 1 / h, the step rate. Use the duration, as in damping**duration.",
            ),
        ]
        blame(xyz(got), mistakes)
        wanted = combined(v, v, d**h, 0.0)
        expect_close(xyz(got), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="Compute v' = v d^h + a h")
def test_the_equation_does_not_damp_what_the_acceleration_adds(rng: Random) -> None:
    v, a = components(rng), components(rng)
    about.read = "book 3.3, Eq. 3.6, and errata.md"
    for d in (draw_damping(rng), 0.0, 1.5):
        about.call = (
            f"v, a = Vector3{v}, Vector3{a}; damp_per_second(v, a, damping={d}, duration=0.5)"
        )
        about.cause = (
            "Eq. 3.6 is v' = v d^h + a h. Damp only the old velocity, and then add the "
            "acceleration times the duration h without damping it."
        )
        got = forms.damp_per_second(Vector3(*v), Vector3(*a), d, 0.5)
        listing = (
            "You damp the acceleration term as well, as the book's listing does (E-16). In Eq. 3.6 "
            "the factor d^h applies only to the old velocity."
        )
        kept = math.sqrt(d)
        mistakes = [
            (combined(v, a, kept, 0.5 * kept), listing),
            (
                combined(v, a, kept, 1.0),
                "You add the whole acceleration, which is the change of velocity in one second. "
                "Multiply it by the duration of the step first.",
            ),
            (combined(v, a, kept, 0.0), "You leave out the acceleration. Add a h to v d^h."),
        ]
        blame(xyz(got), mistakes)
        wanted = combined(v, a, kept, 0.5)
        expect_close(xyz(got), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="the velocity after a time step as a new vector")
def test_both_equations_give_a_new_vector(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.read = "the docstring in damping.py"
    for name in ("damp_per_frame", "damp_per_second"):
        about.call = (
            f"v, a = Vector3{first}, Vector3{second}; {name}(v, a, damping=0.5, duration=2.0)"
        )
        v, a = Vector3(*first), Vector3(*second)
        result = getattr(forms, name)(v, a, 0.5, 2.0)
        for vector, now, before in (("v", xyz(v), first), ("a", xyz(a), second)):
            about.cause = (
                f"You change {vector}, which belongs to the caller, because operators such as *= "
                "work in place. Compute the result in a new vector."
            )
            expect_unchanged(vector, now, before)
        kept = {"damp_per_frame": 0.5, "damp_per_second": 0.25}[name]
        wanted = tuple(first[i] * kept + second[i] * 2.0 for i in range(3))
        sums = {"damp_per_frame": "v d + a h", "damp_per_second": "v d^h + a h"}
        about.cause = f"The result is wrong. Compute {sums[name]} in a new vector."
        expect_close(xyz(result), wanted, tolerance=1e-13)
