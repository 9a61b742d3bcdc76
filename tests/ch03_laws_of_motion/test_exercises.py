"""Exercises 3.1, 3.2 and 3.4. Exercises 3.3 and 3.5 are in other files."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import exercises
from draw import Components, components
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_that,
    expect_unchanged,
    xyz,
)

# 3.1 The same force on two masses


@pytest.mark.exercise("3.1", asks="the same force has half the effect")
def test_twice_the_mass_gets_half_the_speed() -> None:
    about(
        "speed_ratio(first_mass=4, second_mass=2)",
        cause="The same force accelerates the heavier body less, by a = f / m. Return the speed of "
        "the first body divided by that of the second.",
    )
    about.read = "book 3.2, Eq. 3.2; errata.md"
    got = exercises.speed_ratio(4, 2)
    faster = (
        "You make the heavier body faster. The book's sentence that acceleration is proportional "
        "to the mass is wrong (E-1), so use a = f / m."
    )
    mistakes = [
        (2.0, faster),
        (0.0, "You divide with //, which rounds down to a whole number. Use / instead."),
        (0.25, "You return only 1 / m1. Divide it by 1 / m2, which gives m2 / m1."),
        (
            math.sqrt(0.5),
            "You take a square root, as for equal energies. Here the force and the time are equal, "
            "so the ratio of the speeds is m2 / m1.",
        ),
        (-2.0, "You subtract the masses. Divide the speeds, which gives m2 / m1."),
    ]
    expect_close(got, 0.5, cause=cause_of(got, mistakes, about.cause))


@pytest.mark.exercise("3.1", asks="the speed of the first particle divided by the speed")
def test_the_speed_ratio_is_the_inverse_of_the_mass_ratio(rng: Random) -> None:
    first, second = round(rng.uniform(1.0, 9.0), 3), round(rng.uniform(10.0, 90.0), 3)
    about.call = f"speed_ratio(first_mass={first}, second_mass={second})"
    about.cause = (
        "After a time t the two speeds are f t / m1 and f t / m2. Divide the first by the second, "
        "so that f and t cancel."
    )
    about.read = "the docstring of speed_ratio"
    got = exercises.speed_ratio(first, second)
    mistakes = [
        (second // first, "You divide with //, which rounds down to a whole number. Use /."),
        (1.0 / first, "You return only 1 / m1. Divide it by 1 / m2, which gives m2 / m1."),
        (first / second, "You return m1 / m2. The heavier body is slower, so return m2 / m1."),
    ]
    blame(got, mistakes)
    expect_close(got, second / first)


# 3.2 Gravity between two people


@pytest.mark.exercise("3.2", asks="use the book's value, 6.67428e-11")
def test_the_force_between_two_people_of_100_kg() -> None:
    about(
        "gravity_between(100, 100, distance=1)",
        cause="The force between two masses is G m1 m2 / r^2 (Eq. 3.3), with G = 6.67428e-11. "
        "Check each factor of your formula against it.",
    )
    about.read = "book 3.2, Eq. 3.3"
    got = exercises.gravity_between(100, 100, 1)
    mistakes = [
        (
            6.67428e-11 * 200,
            "You add the masses, but the force is proportional to each of them. Multiply them "
            "instead.",
        ),
        (-6.67428e-7, "Your force is negative. Return its magnitude, G m1 m2 / r^2."),
        (6.67428e-9, "You leave out one of the two masses. The force is G m1 m2 / r^2."),
        (1e4, "You leave out the constant G. Multiply by GRAVITATIONAL_CONSTANT."),
        (0.0, "You divide with //, which rounds down to a whole number, here to 0. Use / instead."),
        (
            6.67428e-7 / 2.0,
            "You divide by distance * 2, which doubles the distance. Its square is distance**2.",
        ),
        (
            6.67428e-7 * 2.0,
            "You double the force, as / distance * 2 does. Divide by the square, distance**2.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, 6.67428e-7, tolerance=1e-20)


@pytest.mark.exercise("3.2", asks="Compute the force in N with which two masses")
def test_the_force_falls_with_the_square_of_the_distance(rng: Random) -> None:
    m1, m2 = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    about.read = "book 3.2, Eq. 3.3"
    for distance in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        about(
            f"gravity_between({m1}, {m2}, distance={distance})",
            cause="The force between two masses is G m1 m2 / r^2 (Eq. 3.3), where r is the "
            "distance. Check each factor of your formula against it.",
        )
        got = exercises.gravity_between(m1, m2, distance)
        wanted = 6.67428e-11 * m1 * m2 / (distance * distance)
        mistakes = [
            (
                wanted * distance,
                "You divide by the distance only once. Divide by the square of the distance.",
            ),
            (
                wanted * distance**2,
                "Either you ignore the distance r, or you write / distance * distance, which "
                "divides by it and then multiplies by it again. Divide by distance**2.",
            ),
            (
                wanted * distance**4,
                "You multiply by r^2, but gravity gets weaker with distance. Divide by r^2.",
            ),
        ]
        blame(got, mistakes)
        expect_close(got, wanted)


# 3.4 A position by equation, in steps, and the difference

START, VELOCITY, ACCELERATION = (2.0, 5.0, -1.0), (1.0, -1.0, 2.0), (-2.0, 1.0, 0.5)
EXAMPLE = f"p, v, a = Vector3{START}, Vector3{VELOCITY}, Vector3{ACCELERATION}"


def vectors(*all_of: Components) -> tuple[Any, ...]:
    """Return new vectors with these components."""
    return tuple(Vector3(*a) for a in all_of)


@pytest.mark.exercise("3.4a", asks="The result is p' = p + v t + a t^2 / 2")
def test_five_seconds_by_the_equation() -> None:
    about(
        f"{EXAMPLE}; position_by_equation(p, v, a, time=5)",
        cause="The position after a time t must be p' = p + v t + a t^2 / 2. Check each term of "
        "your formula against this.",
    )
    about.read = "book 2.2, Eq. 2.9"
    got = exercises.position_by_equation(*vectors(START, VELOCITY, ACCELERATION), 5)
    mistakes = [
        ((-43.0, 25.0, 21.5), "You leave out the factor 1/2 in the last term, which must be a t^2 "
         "/ 2."),
        ((7.0, 0.0, 9.0), "Either you leave out the last term, a t^2 / 2, or you write its factor "
         "as 1 // 2, which is 0. Write 0.5 or 1 / 2."),
        ((32.0, -12.5, 2.75), "You subtract the last term. Add a t^2 / 2."),
        ((-23.0, 17.5, 5.25), "You leave out the velocity. Add v t."),
        ((-20.5, 15.0, 10.25), "You halve the velocity term, too. Halve only the last term."),
        ((2.0, -7.5, 55.25), "You multiply the velocity by t^2. Only the acceleration needs t^2."),
        ((-3.0, 5.0, 11.5), "Your last term is a t. It must be a t^2 / 2, and t^2 is t**2."),
        ((2.0, 2.5, 10.25), "You multiply the acceleration by t instead of t^2. The last term must "
         "be a t^2 / 2."),
        ((-20.0, 7.5, 16.25), "You return only the displacement v t + a t^2 / 2. Add the start "
         "position p to it."),
        ((-22.0, 16.5, 7.25), "You add the velocity as if one second had passed. Multiply it by "
         "the time t first."),
    ]  # fmt: skip
    blame(xyz(got), mistakes)
    expect_close(xyz(got), (-18.0, 12.5, 15.25))


@pytest.mark.exercise("3.4a", asks="in m, as a new vector")
def test_the_equation_gives_a_new_position(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    position, velocity, acceleration = vectors(x, v, a)
    about.read = "book 2.2, Eq. 2.9"
    for t in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        about.call = (
            f"p, v, a = Vector3{x}, Vector3{v}, Vector3{a}; position_by_equation(p, v, a, time={t})"
        )
        about.cause = (
            "The position after a time t must be p + v t + a t^2 / 2. Return it as a new vector."
        )
        got = exercises.position_by_equation(position, velocity, acceleration, t)
        wanted = tuple(x[i] + v[i] * t + 0.5 * a[i] * t * t for i in range(3))
        # The rounding errors of numbers up to 400.
        expect_close(xyz(got), wanted, tolerance=1e-12)
        for name, now, before in (("p", position, x), ("v", velocity, v), ("a", acceleration, a)):
            about.cause = (
                f"You change {name}, which belongs to the caller, because +=, *= and add_scaled "
                "work in place. Use + and *, which create a new vector."
            )
            expect_unchanged(name, xyz(now), before)


@pytest.mark.exercise("3.4b", asks="Each step first moves the particle with its old velocity")
def test_one_step_and_five_steps_of_a_second() -> None:
    about.read = "book 2.2, Eq. 2.7 and 2.8; errata.md"
    wanted = {1: ((3.0, 4.0, 1.0), (-1.0, 0.0, 2.5)), 5: ((-13.0, 10.0, 14.0), (-9.0, 4.0, 4.5))}
    for steps, (x, v) in wanted.items():
        about.call = f"{EXAMPLE}; state_by_steps(p, v, a, duration=1, steps={steps})"
        about.cause = (
            "Return the position and the velocity as a pair. In each step, first change the "
            "position to p' = p + v h, and then the velocity to v' = v + a h."
        )
        got: Any = exercises.state_by_steps(*vectors(START, VELOCITY, ACCELERATION), 1, steps)
        alone = "You return a single vector. Return the position and the velocity as a pair."
        expect_that(not hasattr(got, "x"), "a single vector", "a pair of vectors", cause=alone)
        position, velocity = got
        few = (
            "You take one step too few. Loop over range(steps), because a loop over range(1, "
            "steps) runs only steps - 1 times."
        )
        mistakes = [
            (
                v,
                "You return the two results in the wrong order. Return the position first and the "
                "velocity second.",
            ),
            (
                (7.0, 0.0, 9.0),
                "Either you take a single step of 5 s, or the velocity stays the same in all "
                "steps. Take five steps of 1 s, and change the velocity in each of them.",
            ),
            (START if steps == 1 else (-6.0, 7.0, 10.0), few),
            (
                (3.0, 4.0, 1.0) if steps > 1 else (math.nan,) * 3,  # right for a single step
                "Either you return after the first step, inside the loop, or each step starts from "
                "the given position. Continue from where the last step ended.",
            ),
            (
                tuple(
                    p + 25.0 * u + 250.0 * b
                    for p, u, b in zip(START, VELOCITY, ACCELERATION, strict=True)
                ),
                "Each of your 5 steps lasts 5 s. You multiply the duration by the number of steps, "
                "but it is the duration of one step.",
            ),
            (
                (2.2, 4.4, 1.2),
                "You divide the duration by the number of steps. It is the duration of one step.",
            ),
            (
                (2.0, 4.5, 1.25) if steps == 1 else (-18.0, 12.5, 15.25),
                "You add the term a h^2 / 2, which this step leaves out. Add only v h.",
            ),
            (
                (2.0, 4.0, 3.5) if steps == 1 else (-22.0, 14.0, 18.5),
                "You take one step too many. Loop over range(steps).",
            ),
            (
                (1.0, 5.0, 1.5) if steps == 1 else (-23.0, 15.0, 16.5),
                "You change the velocity before the position. Compute the new position first, with "
                "the old velocity (E-17).",
            ),
        ]
        blame(xyz(position), mistakes)
        expect_close(xyz(position), x, then="; the position")
        expect_close(xyz(velocity), v, then="; the velocity")


@pytest.mark.exercise("3.4b", asks="None of these functions changes its arguments")
def test_many_steps_lag_by_half_a_step_and_change_no_argument(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    p, velocity, acceleration = vectors(x, v, a)
    about.call = (
        f"p, v, a = Vector3{x}, Vector3{v}, Vector3{a}; state_by_steps(p, v, a, duration={h}, "
        f"steps={steps})"
    )
    about.cause = (
        f"Take exactly {steps} steps of {h} s each. Every step must start from the position and "
        "the velocity at the end of the previous step."
    )
    about.read = "book 2.2, Eq. 2.7 and 2.8"
    position, last = exercises.state_by_steps(p, velocity, acceleration, h, steps)
    t = h * steps
    wanted = tuple(x[i] + v[i] * t + 0.5 * a[i] * t * (t - h) for i in range(3))
    # The rounding errors of some 40 steps with numbers up to 2000.
    expect_close(xyz(position), wanted, then="; the position", tolerance=1e-10)
    wanted = tuple(v[i] + a[i] * t for i in range(3))
    expect_close(xyz(last), wanted, then="; the velocity", tolerance=1e-11)
    about.cause = (
        "You change one of the caller's vectors, because += and add_scaled work in place. Use a "
        "Particle or copies of the vectors."
    )
    expect_unchanged("p", xyz(p), x)
    expect_unchanged("v", xyz(velocity), v)
    expect_unchanged("a", xyz(acceleration), a)


def other_errors() -> list[tuple[Components, str]]:
    """Return the errors for other numbers of steps, durations and total times, with the causes."""
    found: list[tuple[Components, str]] = []
    for steps in (5, 1, 4, 6):
        for h in (1.0, 0.2, 5.0):
            for total in (5.0, 1.0, steps * h, 4.0, 6.0, 0.2, 25.0):
                if (steps, h, total) == (5, 1.0, 5.0):
                    continue
                x, y, z = (
                    v * (steps * h - total)
                    + a * (h * h * steps * (steps - 1) - total * total) / 2.0
                    for v, a in zip(VELOCITY, ACCELERATION, strict=True)
                )
                taken = f"{steps} steps of {h:g} s" if steps > 1 else f"a single step of {h:g} s"
                cause = (
                    f"You take {taken}, and subtract the exact position after {total:g} s. Take 5 "
                    "steps of 1 s, and subtract the exact position after their total time, 5 s."
                )
                found.append(((x, y, z), cause))
    return found


@pytest.mark.exercise("3.4d", asks="the position after the steps minus the exact position")
def test_five_steps_are_off_by_half_a_step() -> None:
    about(
        f"{EXAMPLE}; stepping_error(p, v, a, duration=1, steps=5)",
        cause="The error is the position after the steps minus the exact position. Return this "
        "difference as a vector.",
    )
    about.read = "book 3, exercise 3.4"
    got = exercises.stepping_error(*vectors(START, VELOCITY, ACCELERATION), 1, 5)
    mistakes = [
        *other_errors(),
        (
            (9.0, -8.5, -10.75),
            "You subtract the exact position from the velocity. state_by_steps returns the "
            "position first, so take its first result.",
        ),
        (
            (-5.0, 2.5, 1.25),
            "You subtract in the wrong order, which flips the sign. Return the position after the "
            "steps minus the exact position.",
        ),
        (
            math.hypot(5.0, 2.5, 1.25),
            "You return the length of the error. Return the error itself, which is a vector.",
        ),
    ]
    blame(xyz(got), mistakes)
    expect_close(xyz(got), (5.0, -2.5, -1.25), tolerance=1e-12)


@pytest.mark.exercise("3.4d", asks="the position after the steps minus the exact position")
def test_the_error_is_a_t_h_over_2(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    about.call = (
        f"p, v, a = Vector3{x}, Vector3{v}, Vector3{a}; stepping_error(p, v, a, duration={h}, "
        f"steps={steps})"
    )
    about.cause = (
        "The error must be -a t h / 2, where t = steps x h is the total time. Compare the two "
        "positions at this time t."
    )
    about.read = "book 3, exercise 3.4"
    got = exercises.stepping_error(*vectors(x, v, a), h, steps)
    wanted = tuple(-0.5 * a[i] * h * steps * h for i in range(3))
    # The rounding errors of positions up to 2000.
    expect_close(xyz(got), wanted, tolerance=1e-10)
