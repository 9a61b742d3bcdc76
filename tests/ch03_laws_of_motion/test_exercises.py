"""Exercises 3.1, 3.2 and 3.4; 3.3 is in test_particle.py, 3.5 in test_damping.py."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import exercises
from draw import Components, components
from expect import expect_close, expect_error, expect_unchanged, xyz

# 3.1 The same force on two masses


@pytest.mark.exercise("3.1")
def test_twice_the_mass_gets_half_the_speed() -> None:
    call = "speed_ratio(2, 1)"
    cause = "a = f / m: the heavier one is the slower one. The book's sentence says f m (E-1)"
    read = "book 3.2, Eq. 3.2; errata.md"
    expect_close(call, exercises.speed_ratio(2, 1), 0.5, cause=cause, read=read)


@pytest.mark.exercise("3.1")
def test_speeds_go_as_the_inverse_masses(rng: Random) -> None:
    first, second = round(rng.uniform(1.0, 9.0), 3), round(rng.uniform(10.0, 90.0), 3)
    call = f"speed_ratio({first}, {second})"
    cause = "the first speed over the second: (f t / m1) / (f t / m2)"
    read = "the docstring of speed_ratio"
    got = exercises.speed_ratio(first, second)
    expect_close(call, got, second / first, cause=cause, read=read)


@pytest.mark.exercise("3.1", weight=0.5)
@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_the_masses_of_a_ratio_are_positive_and_finite(bad: float) -> None:
    cause = "positive of arguments.py refuses it in one line"
    read = "the docstring of speed_ratio"
    for masses in ((bad, 1.0), (1.0, bad), (bad, bad)):
        call = f"speed_ratio{masses}"
        expect_error(
            call,
            lambda masses=masses: exercises.speed_ratio(*masses),
            ValueError,
            allowed=lambda: exercises.speed_ratio(1.0, 1.0),
            cause=cause,
            read=read,
        )


# 3.2 Gravity between two people


@pytest.mark.exercise("3.2")
def test_the_force_between_two_people_of_100_kg() -> None:
    call = "gravity_between(100, 100, 1)"
    cause = "G m1 m2 / r^2, with G = 6.67428e-11"
    read = "book 3.2, Eq. 3.3"
    got = exercises.gravity_between(100, 100, 1)
    expect_close(call, got, 6.67428e-7, cause=cause, read=read, tolerance=1e-20)


@pytest.mark.exercise("3.2")
def test_the_force_falls_with_the_square_of_the_distance(rng: Random) -> None:
    m1, m2 = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    cause = "the distance is squared, and the masses are multiplied"
    read = "book 3.2, Eq. 3.3"
    for distance in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        call = f"gravity_between({m1}, {m2}, {distance})"
        got = exercises.gravity_between(m1, m2, distance)
        wanted = 6.67428e-11 * m1 * m2 / (distance * distance)
        expect_close(call, got, wanted, cause=cause, read=read)


@pytest.mark.exercise("3.2", weight=0.5)
@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_masses_and_distance_are_positive_and_finite(bad: float) -> None:
    cause = "positive of arguments.py refuses it in one line"
    read = "the docstring of gravity_between"
    for data in ((bad, 1.0, 1.0), (1.0, bad, 1.0), (1.0, 1.0, bad)):
        call = f"gravity_between{data}"
        expect_error(
            call,
            lambda data=data: exercises.gravity_between(*data),
            ValueError,
            allowed=lambda: exercises.gravity_between(1.0, 1.0, 1.0),
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("3.2", weight=0.5)
def test_text_is_no_mass_and_no_distance() -> None:
    cause = "positive of arguments.py raises the TypeError for you"
    read = "the docstring of gravity_between"
    data: Any
    for data in (("2", 1.0, 1.0), (1.0, "2", 1.0), (1.0, 1.0, "2")):
        call = f"gravity_between{data}"
        expect_error(
            call,
            lambda data=data: exercises.gravity_between(*data),
            TypeError,
            allowed=lambda: exercises.gravity_between(1.0, 1.0, 1.0),
            cause=cause,
            read=read,
        )


# 3.4 A position by equation, in steps, and the difference

START, VELOCITY, ACCELERATION = (2.0, 5.0, -1.0), (1.0, -1.0, 2.0), (-2.0, 1.0, 0.5)
EXAMPLE = f"Vector3{START}, Vector3{VELOCITY}, Vector3{ACCELERATION}"


def vectors(*all_of: Components) -> tuple[Any, ...]:
    """Return new vectors of these components."""
    return tuple(Vector3(*a) for a in all_of)


@pytest.mark.exercise("3.4a")
def test_five_seconds_by_the_equation() -> None:
    call = f"position_by_equation({EXAMPLE}, 5)"
    cause = "p + v t + a t^2 / 2: 2 + 5 - 25 on X"
    read = "book 2.2, Eq. 2.9"
    got = exercises.position_by_equation(*vectors(START, VELOCITY, ACCELERATION), 5)
    expect_close(call, xyz(got), (-18.0, 12.5, 15.25), cause=cause, read=read)


@pytest.mark.exercise("3.4a")
def test_the_equation_gives_a_new_position(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    position, velocity, acceleration = vectors(x, v, a)
    cause = "p + v t + a t^2 / 2, as a new vector"
    read = "book 2.2, Eq. 2.9"
    for t in (round(rng.uniform(2.0, 9.0), 3), 0.25):
        call = f"p, v, a = Vector3{x}, Vector3{v}, Vector3{a}; position_by_equation(p, v, a, {t})"
        got = exercises.position_by_equation(position, velocity, acceleration, t)
        wanted = tuple(x[i] + v[i] * t + 0.5 * a[i] * t * t for i in range(3))
        # Rounding of numbers up to 400.
        expect_close(call, xyz(got), wanted, cause=cause, read=read, tolerance=1e-12)
        expect_unchanged(call, "p", xyz(position), x, read=read)
        expect_unchanged(call, "v", xyz(velocity), v, read=read)
        expect_unchanged(call, "a", xyz(acceleration), a, read=read)


@pytest.mark.exercise("3.4a", weight=0.5)
@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_the_time_of_the_equation_is_positive_and_finite(bad: float) -> None:
    call = f"position_by_equation({EXAMPLE}, {bad})"
    cause = "positive of arguments.py refuses it in one line"
    read = "the docstring of position_by_equation"
    data = vectors(START, VELOCITY, ACCELERATION)
    expect_error(
        call,
        lambda: exercises.position_by_equation(*data, bad),
        ValueError,
        allowed=lambda: exercises.position_by_equation(*data, 1.0),
        cause=cause,
        read=read,
    )


@pytest.mark.exercise("3.4b")
def test_one_step_and_five_steps_of_a_second() -> None:
    read = "book 2.2, Eq. 2.7 and 2.8"
    cause = "a pair is wanted: position and velocity after p' = p + v h and then v' = v + a h"
    wanted = {
        1: ((3.0, 4.0, 1.0), (-1.0, 0.0, 2.5)),
        5: ((-13.0, 10.0, 14.0), (-9.0, 4.0, 4.5)),
    }
    for steps, (x, v) in wanted.items():
        call = f"state_by_steps({EXAMPLE}, 1, {steps})"
        position, velocity = exercises.state_by_steps(
            *vectors(START, VELOCITY, ACCELERATION), 1, steps
        )
        expect_close(f"{call}, the first", xyz(position), x, cause=cause, read=read)
        expect_close(f"{call}, the second", xyz(velocity), v, cause=cause, read=read)


@pytest.mark.exercise("3.4b")
def test_many_steps_lag_by_half_a_step_and_change_no_argument(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    p, velocity, acceleration = vectors(x, v, a)
    call = f"p, v, a = Vector3{x}, Vector3{v}, Vector3{a}; state_by_steps(p, v, a, {h}, {steps})"
    cause = "n steps of h seconds: n h seconds in all, each from where the last one ended"
    read = "book 2.2, Eq. 2.7 and 2.8"
    position, last = exercises.state_by_steps(p, velocity, acceleration, h, steps)
    t = h * steps
    wanted = tuple(x[i] + v[i] * t + 0.5 * a[i] * t * (t - h) for i in range(3))
    # Some 40 roundings of numbers up to 2000.
    name = f"{call}, the first"
    expect_close(name, xyz(position), wanted, cause=cause, read=read, tolerance=1e-10)
    wanted = tuple(v[i] + a[i] * t for i in range(3))
    name = f"{call}, the second"
    expect_close(name, xyz(last), wanted, cause=cause, read=read, tolerance=1e-11)
    expect_unchanged(call, "p", xyz(p), x, read=read)
    expect_unchanged(call, "v", xyz(velocity), v, read=read)
    expect_unchanged(call, "a", xyz(acceleration), a, read=read)


BAD_STEPS = [(0.0, 5), (-1.0, 5), (math.inf, 5), (math.nan, 5), (1.0, 0), (1.0, -1)]


@pytest.mark.exercise("3.4b", weight=0.5)
@pytest.mark.parametrize(("duration", "steps"), BAD_STEPS)
def test_steps_need_a_duration_and_a_number(duration: float, steps: int) -> None:
    expect_refusal("state_by_steps", duration, steps)


def expect_refusal(name: str, duration: float, steps: int) -> None:
    """Expect an exercise to refuse a duration or a number of steps."""
    call = f"{name}({EXAMPLE}, {duration}, {steps})"
    cause = "a loop over range(0) does nothing, in silence: ask for 1 step or more"
    if steps > 0:
        cause = "Particle.integrate refuses the duration, if you use it"
    read = f"the docstring of {name}"
    data = vectors(START, VELOCITY, ACCELERATION)
    function = getattr(exercises, name)
    expect_error(
        call,
        lambda: function(*data, duration, steps),
        ValueError,
        allowed=lambda: function(*data, 1.0, 1),
        cause=cause,
        read=read,
    )


@pytest.mark.exercise("3.4d")
def test_five_steps_are_off_by_half_a_step() -> None:
    call = f"stepping_error({EXAMPLE}, 1, 5)"
    cause = "stepped minus exact: -13 - (-18) on X"
    read = "book 3, exercise 3.4"
    got = exercises.stepping_error(*vectors(START, VELOCITY, ACCELERATION), 1, 5)
    expect_close(call, xyz(got), (5.0, -2.5, -1.25), cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("3.4d")
def test_the_error_is_a_t_h_over_2(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    h, steps = round(rng.uniform(0.1, 0.5), 3), rng.randrange(10, 40)
    call = f"stepping_error(Vector3{x}, Vector3{v}, Vector3{a}, {h}, {steps})"
    cause = "-a t h / 2, where t is the time of all steps together: halve h, and it halves"
    read = "book 3, exercise 3.4"
    got = exercises.stepping_error(*vectors(x, v, a), h, steps)
    wanted = tuple(-0.5 * a[i] * h * steps * h for i in range(3))
    # Rounding of positions up to 2000.
    expect_close(call, xyz(got), wanted, cause=cause, read=read, tolerance=1e-10)


@pytest.mark.exercise("3.4d", weight=0.25)
@pytest.mark.parametrize(("duration", "steps"), BAD_STEPS)
def test_an_error_needs_a_duration_and_a_number(duration: float, steps: int) -> None:
    expect_refusal("stepping_error", duration, steps)
