"""Exercises 9.1 to 9.4; the others are in test_read_off.py and test_stones.py."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch09_rotations.exercise_probes import multiplications
from ch09_rotations.exercises import (
    back_to_reference,
    product_without_j_and_k,
    turned_by_sense,
    turned_by_steps,
    two_other_turns,
)
from ch09_rotations.quaternion import Quaternion
from draw import components, number, positive_number
from expect import (
    expect_close,
    expect_error,
    expect_exactly,
    expect_finite_numbers,
    expect_unchanged,
    expect_vector,
)
from turning import (
    TIGHT,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Quad,
    draw_quad,
    hamilton,
    named,
    quad,
    rijk,
    same_sign,
    turned,
)

FIRST_LINES = "the first lines of exercises.py"
BACK = "the docstring of back_to_reference"
PLANE = "the docstring of product_without_j_and_k"
SENSE = "the docstring of turned_by_sense"
BY_STEPS = "the docstring of turned_by_steps, and Eq. 9.5"


# 9.1 Two turns, and two others


@pytest.mark.exercise("9.1")
def test_two_turns_end_where_two_others_do() -> None:
    read = "the docstring of two_other_turns"
    call, cause = "two_other_turns()", "return two angles, in degrees"
    a, b = two_other_turns()
    both = hamilton(quad(X_AXIS, math.radians(b)), quad(Z_AXIS, math.radians(a)))
    cause = "fixed axes, right-handed, in degrees: take a book, and follow its axes through both"
    slips = {
        "a and b exchanged": (90.0, -90.0),
        "right but for the sign of a": (90.0, 90.0),
        "right but for the sign of b": (-90.0, -90.0),
        "in radians": (-0.5 * math.pi, 0.5 * math.pi),
    }
    cause = named((a, b), cause, slips)
    for name, axis, wanted in (
        ("X", X_AXIS, (0.0, 0.0, -1.0)),
        ("Y", Y_AXIS, (1.0, 0.0, 0.0)),
        ("Z", Z_AXIS, (0.0, -1.0, 0.0)),
    ):
        call = (
            f"two_other_turns(): by {a} degrees about Z, then by {b} about X, the object's {name}"
        )
        got = tuple(round(component, 9) for component in turned(both, axis))
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=0.0)


@pytest.mark.exercise("9.1")
def test_the_angles_are_within_half_a_turn() -> None:
    read = "the docstring of two_other_turns"
    call, cause = "two_other_turns()", "degrees from -180 to 180: 270 is -90"
    for letter, angle in zip("ab", two_other_turns(), strict=True):
        name = f"{call}, {letter}, which is {angle}: is it from -180 to 180"
        allowed = isinstance(angle, (int, float)) and abs(angle) <= 180.0
        expect_exactly(name, allowed, True, cause=cause, read=read)


# 9.2 One turn back to the reference


def way_back(q: Quad) -> tuple:
    """Return axis and angle of the way back as plain numbers."""
    read = BACK
    call = f"back_to_reference(Quaternion{q})"
    cause = "return a pair: a Vector3 of length 1, and an angle in radians"
    orientation = Quaternion(*q)
    axis, angle = back_to_reference(orientation)
    expect_unchanged(call, "orientation", rijk(orientation), q, read=read)
    unit = expect_vector(f"{call}, the axis", axis, cause=cause, read=read)
    length = math.hypot(*unit)
    expect_close(f"{call}, the axis's length", length, 1.0, cause=cause, read=read, tolerance=TIGHT)
    cause = "from -pi to pi: a turn by more is one by less about the opposite axis"
    turn = math.degrees(2.0 * math.atan2(math.hypot(*q[1:]), abs(q[0])))
    slips = {"an angle in degrees, not in radians": turn, "an angle in degrees": -turn}
    if angle:
        cause = named(angle, cause, slips)
    name = f"{call}: is its angle, {angle}, from -pi to pi"
    allowed = isinstance(angle, (int, float)) and abs(angle) <= math.pi + 1e-12
    expect_exactly(name, allowed, True, cause=cause, read=read)
    return unit, angle


@pytest.mark.exercise("9.2", weight=2)
def test_one_turn_leads_back(rng: Random) -> None:
    read = BACK
    axis, small, large = components(rng), rng.uniform(0.1, 1.0), rng.uniform(3.3, 6.0)
    cause = "the turn that undoes it is its conjugate, about the same axis by the opposite angle"
    drawn = [draw_quad(rng), quad(axis, small), quad(axis, large), quad(axis, -small)]
    for q in ((0.5, 0.5, 0.5, 0.5), *drawn):
        unit, angle = way_back(q)
        call = f"back_to_reference(Quaternion{q}): after a turn by {angle} about {unit} it is at"
        reference = (1.0, 0.0, 0.0, 0.0)
        got = same_sign(hamilton(quad(unit, angle), q), reference)
        slips = {
            "where the turn there, made once more, leads": same_sign(hamilton(q, q), reference),
            "where half the angle leads": same_sign(quad(q[1:], math.acos(q[0])), reference),
        }
        why = named(got, cause, slips)
        expect_close(call, got, reference, cause=why, read=read, tolerance=TIGHT)


@pytest.mark.exercise("9.2")
def test_the_way_back_at_the_ends(rng: Random) -> None:
    read = BACK
    cause = "it is at the reference: the angle is 0, about any axis"
    for q in ((1.0, 0.0, 0.0, 0.0), (-1.0, 0.0, 0.0, 0.0)):
        _, angle = way_back(q)
        call = f"back_to_reference(Quaternion{q}), the angle"
        expect_close(call, angle, 0.0, cause=cause, read=read, tolerance=0.0)
    axis, near = turned(draw_quad(rng), X_AXIS), math.pi - 2e-7
    cause = "half a turn is undone by half a turn about the same axis, either way"
    for q, turn in (((0.0, *axis), math.pi), (quad(axis, near), near)):
        unit, angle = way_back(q)
        got, wanted = (abs(angle), *same_sign(unit, axis)), (turn, *axis)
        call = f"back_to_reference(Quaternion{q}), the angle without its sign, and the axis"
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("9.2")
@pytest.mark.robust
def test_no_way_back_from_what_is_no_orientation() -> None:
    cause = "to_axis_angle refuses what has not length 1"
    for numbers in ((1.0, 1.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)):
        expect_error(
            f"back_to_reference(Quaternion{numbers})",
            lambda numbers=numbers: back_to_reference(Quaternion(*numbers)),
            ValueError,
            allowed=lambda: back_to_reference(Quaternion(0.6, 0.8, 0.0, 0.0)),
            cause=cause,
            read=BACK,
        )
    expect_error(
        "back_to_reference((1, 0, 0, 0))",
        lambda: back_to_reference((1.0, 0.0, 0.0, 0.0)),
        TypeError,
        allowed=lambda: back_to_reference(Quaternion(0.6, 0.8, 0.0, 0.0)),
        cause="four numbers are no Quaternion: TypeError",
        read=FIRST_LINES,
    )


# 9.3a Two quaternions without j and k


@pytest.mark.exercise("9.3a")
def test_a_product_without_j_and_k(rng: Random) -> None:
    read = PLANE
    (r, i), (s, j) = ((number(rng, 1.5), number(rng, 1.5)) for _ in range(2))
    call = f"product_without_j_and_k(Quaternion({r}, {i}, 0, 0), Quaternion({s}, {j}, 0, 0))"
    cause = "the scalar part is r r' - i i', since i i is -1, and beside i stands r i' + i r'"
    a, b = Quaternion(r, i, 0.0, 0.0), Quaternion(s, j, 0.0, 0.0)
    got = rijk(product_without_j_and_k(a, b))
    product = complex(r, i) * complex(s, j)
    wanted = (product.real, product.imag, 0.0, 0.0)
    expect_unchanged(call, "a", rijk(a), (r, i, 0.0, 0.0), read=read)
    expect_unchanged(call, "b", rijk(b), (s, j, 0.0, 0.0), read=read)
    slips = {
        "what comes of i i = 1": (r * s + i * j, product.imag, 0.0, 0.0),
        "component times component": (r * s, i * j, 0.0, 0.0),
    }
    why = named(got, cause, slips)
    expect_close(call, got, wanted, cause=why, read=read, tolerance=TIGHT)
    name = f"{call}: multiplications, where more than four are made"
    cause = "a * b makes sixteen: leave out what is zero"
    got = max(4, multiplications((r, i), (s, j)))
    expect_exactly(name, got, 4, cause=cause, read=read)


@pytest.mark.exercise("9.3a")
@pytest.mark.robust
def test_a_product_with_j_or_k_is_refused(rng: Random) -> None:
    read = PLANE
    r, i, n = number(rng), number(rng), number(rng)
    good = (r, i, 0.0, 0.0)
    cause = "a j or a k that is not zero would be lost: ValueError; a NaN is not zero either"
    pairs = [(n, 0.0), (-n, 0.0), (0.0, n), (0.0, -n), (n, n), (n, -n), (math.nan, 0.0)]
    for bad in ((r, i, *pair) for pair in (*pairs, (0.0, math.nan), (1e-12, 0.0), (0.0, -1e-12))):
        for a, b in ((bad, good), (good, bad)):
            expect_error(
                f"product_without_j_and_k(Quaternion{a}, Quaternion{b})",
                lambda a=a, b=b: product_without_j_and_k(Quaternion(*a), Quaternion(*b)),
                ValueError,
                allowed=lambda: product_without_j_and_k(Quaternion(*good), Quaternion(*good)),
                cause=cause,
                read=read,
            )
    for which, attempt in (
        ("a complex number, and a Quaternion", lambda: product_without_j_and_k(2.0, Quaternion())),
        ("a Quaternion, and a number", lambda: product_without_j_and_k(Quaternion(), 2.0)),
    ):
        expect_error(
            f"product_without_j_and_k(...), of {which}",
            attempt,
            TypeError,
            allowed=lambda: product_without_j_and_k(Quaternion(*good), Quaternion(*good)),
            cause="a number is no Quaternion: TypeError",
            read=FIRST_LINES,
        )


# 9.4 A steady turn, by sense and by steps


@pytest.mark.exercise("9.4")
def test_a_steady_turn_is_one_rotation(rng: Random) -> None:
    read = SENSE
    size = positive_number(rng, 0.2, 4.0)
    for q, rate in (((0.5, 0.5, 0.5, 0.5), size), (draw_quad(rng), -size), (draw_quad(rng), 0.0)):
        duration = positive_number(rng, 0.5, 3.0)
        orientation = Quaternion(*q)
        call = f"turned_by_sense(Quaternion{q}, {rate}, {duration})"
        cause = "one turn by rate times duration about the world's X, on the left of the product"
        if rate == 0.0:
            cause = "a rate of 0 turns nothing, about any axis: the axis is X, and the angle is 0"
        turn = quad(X_AXIS, rate * duration)
        wanted = hamilton(turn, q)
        got = same_sign(rijk(turned_by_sense(orientation, rate, duration)), wanted)
        slips = {
            "the turn on the right of the product, about the object's own X": hamilton(q, turn),
            "the turn alone, without the orientation before it": turn,
            "a turn by half the angle": hamilton(quad(X_AXIS, 0.5 * rate * duration), q),
            "a turn by the rate, whatever the duration": hamilton(quad(X_AXIS, rate), q),
            "a turn the other way round": hamilton(quad(X_AXIS, -rate * duration), q),
            "one step of Eq. 9.5, and not a turn": stepped(q, rate, duration, 1),
        }
        slips = {name: same_sign(slip, wanted) for name, slip in slips.items()}
        why = named(got, cause, slips)
        expect_close(call, got, wanted, cause=why, read=read, tolerance=TIGHT)
        expect_unchanged(call, "orientation", rijk(orientation), q, read=read)
    call = f"q = Quaternion{q}; turned_by_sense(q, 0, 1), which is changed then; q"
    cause = "a new one, where nothing turns too"
    turned_by_sense(orientation, 0.0, 1.0).r = 9.0
    expect_unchanged(call, "q", rijk(orientation), q, cause=cause, read=read)


def stepped(q: Quad, rate: float, duration: float, steps: int) -> Quad:
    """Return where steps of Eq. 9.5 about X end, normalised."""
    half = 0.5 * rate * duration / steps
    for _ in range(steps):
        change = hamilton((0.0, half, 0.0, 0.0), q)
        q = tuple(old + new for old, new in zip(q, change, strict=True))
    length = math.hypot(*q)
    return tuple(component / length for component in q)


@pytest.mark.exercise("9.4", weight=2)
def test_a_steady_turn_in_steps_of_the_book(rng: Random) -> None:
    read = BY_STEPS
    for q, steps, share in (
        ((0.5, 0.5, 0.5, 0.5), 1, 1.0),
        (draw_quad(rng), 2, -1.0),
        (draw_quad(rng), 1000, 0.3),  # so little is missing that acos tells nothing of it
        (draw_quad(rng), 3, 0.0),
    ):
        rate, duration = share * positive_number(rng, 0.3, 1.2), positive_number(rng, 1.0, 2.0)
        orientation = Quaternion(*q)
        call = f"turned_by_steps(Quaternion{q}, {rate}, {duration}, {steps})"
        cause = "add_scaled in steps of duration / steps, on a copy, which is normalised at the end"
        if steps == 1:
            call = f"turned_by_steps(Quaternion{q}, {rate}, {duration})"
            result, error = turned_by_steps(orientation, rate, duration)
        else:
            result, error = turned_by_steps(orientation, rate, duration, steps)
        wanted = stepped(q, rate, duration, steps)
        got = same_sign(rijk(result), wanted)
        name = f"{call}, the orientation"
        half = 0.5 * rate * duration / steps
        size = (1.0 + half * half) ** (0.5 * steps)
        slips = {
            "what comes of steps that are as long as the whole duration": stepped(
                q, rate, duration * steps, steps
            ),
            "what comes of one step of the whole duration": stepped(q, rate, duration, 1),
            "not normalised": [size * component for component in wanted],
            "the exact turn, not that of Eq. 9.5": hamilton(quad(X_AXIS, rate * duration), q),
            "the orientation as it was": q,
        }
        slips = {label: same_sign(slip, wanted) for label, slip in slips.items()}
        why = named(got, cause, slips)
        expect_close(name, got, wanted, cause=why, read=read, tolerance=TIGHT)
        turn = abs(rate * duration)
        missing = turn - 2.0 * steps * math.atan(0.5 * turn / steps)
        cause = "the angle of the turn from the one to the other, in radians and not negative"
        name = f"{call}, the error"
        slips = {
            "half the angle": 0.5 * missing,
            "the angle with its sign": -missing,
            "an angle in degrees": math.degrees(missing),
        }
        why = named(error, cause, slips)
        if isinstance(error, (int, float)) and 1e-11 < abs(error - missing) < 1e-7:
            why = f"acos loses half of the digits where the turn is small, as here: {cause}"
        expect_close(name, error, missing, cause=why, read=read, tolerance=1e-11)
        expect_unchanged(call, "orientation", rijk(orientation), q, read=read)


@pytest.mark.exercise("9.4")
def test_an_error_is_at_most_half_a_turn() -> None:
    read = BY_STEPS
    q = (0.5, 0.5, 0.5, 0.5)
    call = f"turned_by_steps(Quaternion{q}, 3, 2), the error"
    cause = "a turn by more than pi is one by less the other way round"
    # It should turn by 6 rad, and turns by 2 atan 3 = 2.50: 3.50 are missing, or 2.78 too many.
    wanted = math.tau - (6.0 - 2.0 * math.atan(3.0))
    got = turned_by_steps(Quaternion(*q), 3.0, 2.0)[1]
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-11)


@pytest.mark.exercise("9.4")
@pytest.mark.robust
def test_a_turn_of_nothing_is_refused() -> None:
    bad = ((1, 0.0), (1, -1.0))
    expect_finite_numbers(
        "turned_by_sense(...), with rate and duration ",
        lambda rate, duration: turned_by_sense(Quaternion(), rate, duration),
        (1, 2),
        bad,
        read=SENSE,
    )
    expect_finite_numbers(
        "turned_by_steps(...), with rate and duration ",
        lambda rate, duration: turned_by_steps(Quaternion(), rate, duration),
        (1, 2),
        bad,
        read=BY_STEPS,
    )
    cause = "whole of arguments.py asks for a whole number of 1 or more"
    for steps, error in ((0, ValueError), (-1, ValueError), (2.0, TypeError)):
        expect_error(
            f"turned_by_steps(Quaternion(), 1, 2, {steps})",
            lambda steps=steps: turned_by_steps(Quaternion(), 1.0, 2.0, steps),
            error,
            allowed=lambda: turned_by_steps(Quaternion(), 1.0, 2.0, 3),
            cause=cause,
            read=BY_STEPS,
        )
    cause = "its length is not 1: to_axis_angle refuses it, or you do"
    for length in (2.0, 1.000002):
        expect_error(
            f"turned_by_steps(Quaternion({length}, 0, 0, 0), 1, 2)",
            lambda length=length: turned_by_steps(Quaternion(length, 0.0, 0.0, 0.0), 1.0, 2.0),
            ValueError,
            allowed=lambda: [
                turned_by_steps(Quaternion(near, 0.0, 0.0, 0.0), 1.0, 2.0)
                for near in (1.0, 1.0 + 5e-7)
            ],
            cause=cause,
            read=BY_STEPS,
        )
    for name, function in (("sense", turned_by_sense), ("steps", turned_by_steps)):
        expect_error(
            f"turned_by_{name}((1, 0, 0, 0), 1, 2)",
            lambda function=function: function((1.0, 0.0, 0.0, 0.0), 1.0, 2.0),
            TypeError,
            allowed=lambda function=function: function(Quaternion(), 1.0, 2.0),
            cause="four numbers are no Quaternion: TypeError",
            read=FIRST_LINES,
        )
