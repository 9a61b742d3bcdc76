"""Exercises 3.1, 3.2 and 3.4. Exercises 3.3 and 3.5 are in other files."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import exercises
from draw import Triple, vector
from expect import expect_close, expect_that, expect_unchanged, xyz

DOC = "the docstring of the function"
MASS, GRAVITY = "book 3.2, Eq. 3.2; docs/errata.md", "book 3.2, Eq. 3.3"
EQUATION, LAG = "book 2.2, Eq. 2.9", "book 3, exercise 3.4"
FLOOR = "You divide with //, which rounds down to a whole number. Use / instead."
G = 6.67428e-11
START, VELOCITY = Triple((2.0, 5.0, -1.0)), Triple((1.0, -1.0, 2.0))
ACCELERATION = Triple((-2.0, 1.0, 0.5))
STEPS = "book 2.2, Eq. 2.7 and 2.8; docs/errata.md"
POSITION_FIRST = (
    "You return the two results in the wrong order. Return the position first and the velocity "
    "second."
)
ERROR = (
    "The error is the position after the steps minus the exact position at their total time t. It "
    "equals -a t h / 2, where h is the duration of a step. Return it as a vector."
)

# 3.1 The same force on two masses


@pytest.mark.exercise("3.1", asks="the same force has half the effect", read=MASS)
def test_twice_the_mass_gets_half_the_speed() -> None:
    with calls(
        "The same force accelerates the heavier body less, by a = f / m. Return the speed of the "
        "first body divided by that of the second."
    ):
        got = exercises.speed_ratio(first_mass=4, second_mass=2)
    slips = {
        "You make the heavier body faster. The book's sentence that acceleration is proportional "
        "to the mass is wrong (E-1), so use a = f / m.": 2.0,
        FLOOR: 0.0,
        "You return only 1 / m1. Divide it by 1 / m2, which gives m2 / m1.": 0.25,
        "You take a square root, as for equal energies. Here the force and the time are equal, so "
        "the ratio of the speeds is m2 / m1.": math.sqrt(0.5),
        "You subtract the masses. Divide the speeds, which gives m2 / m1.": -2.0,
    }
    expect_close(got, 0.5, slips)


@pytest.mark.exercise("3.1", asks="the speed of the first particle divided by the speed", read=DOC)
def test_the_speed_ratio_is_the_inverse_of_the_mass_ratio(rng: Random) -> None:
    first, second = round(rng.uniform(1.0, 9.0), 3), round(rng.uniform(10.0, 90.0), 3)
    with calls(
        "After a time t the two speeds are f t / m1 and f t / m2. Divide the first by the second, "
        "so that f and t cancel."
    ):
        got = exercises.speed_ratio(first_mass=first, second_mass=second)
    slips = {
        FLOOR: second // first,
        "You return only 1 / m1. Divide it by 1 / m2, which gives m2 / m1.": 1.0 / first,
        "You return m1 / m2. The heavier body is slower, so return m2 / m1.": first / second,
    }
    expect_close(got, second / first, slips)


# 3.2 Gravity between two people


@pytest.mark.exercise("3.2", asks="use the book's value, 6.67428e-11", read=GRAVITY)
def test_the_force_between_two_people_of_100_kg() -> None:
    with calls("The force between two masses is G m1 m2 / r^2 (Eq. 3.3), with G = 6.67428e-11."):
        got = exercises.gravity_between(100, 100, distance=1)
    slips = {
        "You add the masses, but the force is proportional to each of them.": G * 200.0,
        "Your force is negative. Return its magnitude, G m1 m2 / r^2.": -G * 1e4,
        "You leave out one of the two masses.": G * 100.0,
        "You leave out the constant G. Multiply by GRAVITATIONAL_CONSTANT.": 1e4,
        "You divide with //, which rounds down to a whole number, here to 0. Use / instead.": 0.0,
        "You divide by distance * 2, which doubles the distance. Its square is distance**2.":
            G * 1e4 / 2.0,
        "You double the force, as / distance * 2 does. Divide by the square, distance**2.":
            G * 1e4 * 2.0,
    }  # fmt: skip
    expect_close(got, 6.67428e-7, slips, tolerance=1e-20)


@pytest.mark.exercise("3.2", asks="Compute the force in N with which two masses", read=GRAVITY)
def test_the_force_falls_with_the_square_of_the_distance(rng: Random) -> None:
    m1, m2 = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    for r in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        with calls(
            "The force between two masses is G m1 m2 / r^2 (Eq. 3.3), where r is the distance."
        ):
            got = exercises.gravity_between(m1, m2, distance=r)
        slips = {
            "You divide by the distance only once.": G * m1 * m2 / r,
            "Either you ignore the distance r, or you write / distance * distance, which divides "
            "by it and then multiplies by it again. Divide by distance**2.": G * m1 * m2,
            "You multiply by r^2, but gravity gets weaker with distance.": G * m1 * m2 * r**2,
        }
        expect_close(got, G * m1 * m2 / (r * r), slips)


# 3.4 A position by equation, in steps, and the difference


@pytest.mark.exercise("3.4a", asks="The result is p' = p + v t + a t^2 / 2", read=EQUATION)
def test_five_seconds_by_the_equation() -> None:
    with calls(
        "The position after a time t must be p' = p + v t + a t^2 / 2. Check each term of your "
        "formula against this."
    ):
        p, v, a = Vector3(*START), Vector3(*VELOCITY), Vector3(*ACCELERATION)
        got = exercises.position_by_equation(p, v, a, time=5)
    slips = {
        "You leave out the factor 1/2 in the last term.": (-43.0, 25.0, 21.5),
        "Either you leave out the last term, a t^2 / 2, or you write its factor as 1 // 2, which "
        "is 0. Write 0.5 or 1 / 2.": (7.0, 0.0, 9.0),
        "You subtract the last term. Add a t^2 / 2.": (32.0, -12.5, 2.75),
        "You leave out the velocity. Add v t.": (-23.0, 17.5, 5.25),
        "You halve the velocity term, too. Halve only the last term.": (-20.5, 15.0, 10.25),
        "You multiply the velocity by t^2. Only the acceleration needs t^2.": (2.0, -7.5, 55.25),
        "Your last term is a t. It must be a t^2 / 2, and t^2 is t**2.": (-3.0, 5.0, 11.5),
        "You multiply the acceleration by t instead of t^2.": (2.0, 2.5, 10.25),
        "You return only the displacement v t + a t^2 / 2. Add the start position p to it.":
            (-20.0, 7.5, 16.25),
        "You add the velocity as if one second had passed.": (-22.0, 16.5, 7.25),
    }  # fmt: skip
    expect_close(xyz(got), (-18.0, 12.5, 15.25), slips)


@pytest.mark.exercise("3.4a", asks="in m, as a new vector", read=EQUATION)
def test_the_equation_gives_a_new_position(rng: Random) -> None:
    start, speed, rate = vector(rng), vector(rng), vector(rng)
    for t in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        with calls(
            "The position after a time t must be p + v t + a t^2 / 2. Return it as a new vector."
        ):
            p, v, a = Vector3(*start), Vector3(*speed), Vector3(*rate)
            got = exercises.position_by_equation(p, v, a, time=t)
        # The rounding errors of numbers up to 400.
        wanted = start + speed * t + rate * (0.5 * t * t)
        expect_close(xyz(got), wanted, tolerance=1e-12)
        for name, now, before in (("p", p, start), ("v", v, speed), ("a", a, rate)):
            cause = (
                f"You change {name}, which belongs to the caller, because +=, *= and add_scaled "
                "work in place. Use + and *, which create a new vector."
            )
            expect_unchanged(name, now, before, cause=cause)


@pytest.mark.exercise(
    "3.4b", asks="Each step first moves the particle with its old velocity", read=STEPS
)
def test_one_step_and_five_steps_of_a_second() -> None:
    wanted_v = {1: (-1.0, 0.0, 2.5), 5: (-9.0, 4.0, 4.5)}
    for steps, wanted in ((1, (3.0, 4.0, 1.0)), (5, (-13.0, 10.0, 14.0))):
        with calls(
            "Return the position and the velocity as a pair. In each step, first change the "
            "position to p' = p + v h, and then the velocity to v' = v + a h."
        ):
            p, v, a = Vector3(*START), Vector3(*VELOCITY), Vector3(*ACCELERATION)
            got = exercises.state_by_steps(p, v, a, duration=1, steps=steps)
        alone = "You return a single vector. Return the position and the velocity as a pair."
        expect_that(not hasattr(got, "x"), "a single vector", "a pair of vectors", cause=alone)
        position, velocity = got
        slips = {
            POSITION_FIRST: wanted_v[steps],
            "Either you take a single step of 5 s, or the velocity stays the same in all steps. "
            "Take five steps of 1 s, and change the velocity in each of them.": (7.0, 0.0, 9.0),
            "You take one step too few. Loop over range(steps), because a loop over range(1, "
            "steps) runs only steps - 1 times.": START if steps == 1 else (-6.0, 7.0, 10.0),
            "Each of your 5 steps lasts 5 s. You multiply the duration by the number of steps, but "
            "it is the duration of one step.": START + 25.0 * VELOCITY + 250.0 * ACCELERATION,
            "You divide the duration by the number of steps. It is the duration of one step.":
                (2.2, 4.4, 1.2),
            "You add the term a h^2 / 2, which this step leaves out. Add only v h.":
                (2.0, 4.5, 1.25) if steps == 1 else (-18.0, 12.5, 15.25),
            "You take one step too many. Loop over range(steps).":
                (2.0, 4.0, 3.5) if steps == 1 else (-22.0, 14.0, 18.5),
            "You change the velocity before the position. Compute the new position first, with the "
            "old velocity (E-17).": (1.0, 5.0, 1.5) if steps == 1 else (-23.0, 15.0, 16.5),
        }  # fmt: skip
        if steps > 1:  # right for a single step
            slips[
                "Either you return after the first step, inside the loop, or each step starts from "
                "the given position. Continue from where the last step ended."
            ] = (3.0, 4.0, 1.0)
        expect_close(xyz(position), wanted, slips, then="; the position")
        expect_close(xyz(velocity), wanted_v[steps], then="; the velocity")


@pytest.mark.exercise("3.4b", asks="None of these functions changes its arguments", read=STEPS)
def test_many_steps_lag_by_half_a_step_and_change_no_argument(rng: Random) -> None:
    start, speed, rate = vector(rng), vector(rng), vector(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    with calls(
        f"Take exactly {steps} steps of {h} s each. Every step must start from the position and "
        "the velocity at the end of the previous step."
    ):
        p, v, a = Vector3(*start), Vector3(*speed), Vector3(*rate)
        position, velocity = exercises.state_by_steps(p, v, a, duration=h, steps=steps)
    t = h * steps
    # The rounding errors of some 40 steps with numbers up to 2000.
    wanted = start + speed * t + rate * (0.5 * t * (t - h))
    expect_close(xyz(position), wanted, then="; the position", tolerance=1e-10)
    expect_close(xyz(velocity), speed + rate * t, then="; the velocity", tolerance=1e-11)
    changes = (
        "You change one of the caller's vectors, because += and add_scaled work in place. Use a "
        "Particle or copies of the vectors."
    )
    for name, now, before in (("p", p, start), ("v", v, speed), ("a", a, rate)):
        expect_unchanged(name, now, before, cause=changes)


def other_errors() -> dict[str, Triple]:
    """Return the errors for other numbers of steps, durations and total times, by their causes."""
    found = {}
    for steps in (5, 1, 4, 6):
        for h in (1.0, 0.2, 5.0):
            taken = f"{steps} steps of {h:g} s" if steps > 1 else f"a single step of {h:g} s"
            for total in (5.0, 1.0, steps * h, 4.0, 6.0, 0.2, 25.0):
                cause = (
                    f"You take {taken}, and subtract the exact position after {total:g} s. Take 5 "
                    "steps of 1 s, and subtract the exact position after their total time, 5 s."
                )
                late = (h * h * steps * (steps - 1) - total * total) / 2.0
                if (steps, h, total) != (5, 1.0, 5.0):
                    found[cause] = VELOCITY * (steps * h - total) + ACCELERATION * late
    return found


@pytest.mark.exercise(
    "3.4d", asks="the position after the steps minus the exact position", read=LAG
)
def test_five_steps_are_off_by_half_a_step() -> None:
    with calls(ERROR):
        p, v, a = Vector3(*START), Vector3(*VELOCITY), Vector3(*ACCELERATION)
        got = exercises.stepping_error(p, v, a, duration=1, steps=5)
    slips = other_errors() | {
        "You subtract the exact position from the velocity. state_by_steps returns the position "
        "first, so take its first result.": (9.0, -8.5, -10.75),
        "You subtract in the wrong order, which flips the sign.": (-5.0, 2.5, 1.25),
        "You return the length of the error.": math.hypot(5.0, 2.5, 1.25),
    }
    expect_close(xyz(got), (5.0, -2.5, -1.25), slips, tolerance=1e-12)


@pytest.mark.exercise(
    "3.4d", asks="the position after the steps minus the exact position", read=LAG
)
def test_the_error_is_a_t_h_over_2(rng: Random) -> None:
    start, speed, rate = vector(rng), vector(rng), vector(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    with calls(ERROR):
        p, v, a = Vector3(*start), Vector3(*speed), Vector3(*rate)
        got = exercises.stepping_error(p, v, a, duration=h, steps=steps)
    # The rounding errors of positions up to 2000.
    expect_close(xyz(got), rate * (-0.5 * h * steps * h), tolerance=1e-10)
