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
    UNCHANGED,
    about,
    expect_close,
    expect_error,
    expect_exactly,
    expect_finite_numbers,
    expect_unchanged,
    expect_vector,
    scoped,
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
    about.read = "the docstring of two_other_turns"
    about.call, about.cause = "two_other_turns()", "return two angles, in degrees"
    a, b = two_other_turns()
    both = hamilton(quad(X_AXIS, math.radians(b)), quad(Z_AXIS, math.radians(a)))
    about.cause = "fixed axes, right-handed, in degrees: take a book, and follow its axes through "
    about.cause += "both"
    slips = {
        "a and b exchanged": (90.0, -90.0),
        "right but for the sign of a": (90.0, 90.0),
        "right but for the sign of b": (-90.0, -90.0),
        "in radians": (-0.5 * math.pi, 0.5 * math.pi),
    }
    about.cause = named((a, b), about.cause, slips)
    for name, axis, wanted in (
        ("X", X_AXIS, (0.0, 0.0, -1.0)),
        ("Y", Y_AXIS, (1.0, 0.0, 0.0)),
        ("Z", Z_AXIS, (0.0, -1.0, 0.0)),
    ):
        about.call = f"two_other_turns(): by {a} degrees about Z, then by {b} about X, the "
        about.call += f"object's {name}"
        got = tuple(round(component, 9) for component in turned(both, axis))
        expect_close(got, wanted, tolerance=0.0)


@pytest.mark.exercise("9.1")
def test_the_angles_are_within_half_a_turn() -> None:
    about.read = "the docstring of two_other_turns"
    about.call, about.cause = "two_other_turns()", "degrees from -180 to 180: 270 is -90"
    for letter, angle in zip("ab", two_other_turns(), strict=True):
        allowed = isinstance(angle, (int, float)) and abs(angle) <= 180.0
        expect_exactly(allowed, True, then=f", {letter}, which is {angle}: is it from -180 to 180")


# 9.2 One turn back to the reference


@scoped
def way_back(q: Quad) -> tuple:
    """Return axis and angle of the way back as plain numbers."""
    about(f"back_to_reference(Quaternion{q})", read=BACK)
    about.cause = "return a pair: a Vector3 of length 1, and an angle in radians"
    orientation = Quaternion(*q)
    axis, angle = back_to_reference(orientation)
    expect_unchanged("orientation", rijk(orientation), q, cause=UNCHANGED)
    unit = expect_vector(axis, then=", the axis")
    length = math.hypot(*unit)
    expect_close(length, 1.0, then=", the axis's length", tolerance=TIGHT)
    about.cause = "from -pi to pi: a turn by more is one by less about the opposite axis"
    turn = math.degrees(2.0 * math.atan2(math.hypot(*q[1:]), abs(q[0])))
    slips = {"an angle in degrees, not in radians": turn, "an angle in degrees": -turn}
    if angle:
        about.cause = named(angle, about.cause, slips)
    allowed = isinstance(angle, (int, float)) and abs(angle) <= math.pi + 1e-12
    expect_exactly(allowed, True, then=f": is its angle, {angle}, from -pi to pi")
    return unit, angle


@pytest.mark.exercise("9.2", weight=2)
def test_one_turn_leads_back(rng: Random) -> None:
    about.read = BACK
    axis, small, large = components(rng), rng.uniform(0.1, 1.0), rng.uniform(3.3, 6.0)
    about.cause = "the turn that undoes it is its conjugate, about the same axis by the opposite "
    about.cause += "angle"
    drawn = [draw_quad(rng), quad(axis, small), quad(axis, large), quad(axis, -small)]
    for q in ((0.5, 0.5, 0.5, 0.5), *drawn):
        unit, angle = way_back(q)
        about.call = f"back_to_reference(Quaternion{q}): after a turn by {angle} about {unit} it "
        about.call += "is at"
        reference = (1.0, 0.0, 0.0, 0.0)
        got = same_sign(hamilton(quad(unit, angle), q), reference)
        slips = {
            "where the turn there, made once more, leads": same_sign(hamilton(q, q), reference),
            "where half the angle leads": same_sign(quad(q[1:], math.acos(q[0])), reference),
        }
        why = named(got, about.cause, slips)
        expect_close(got, reference, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("9.2")
def test_the_way_back_at_the_ends(rng: Random) -> None:
    about(cause="it is at the reference: the angle is 0, about any axis", read=BACK)
    for q in ((1.0, 0.0, 0.0, 0.0), (-1.0, 0.0, 0.0, 0.0)):
        _, angle = way_back(q)
        about.call = f"back_to_reference(Quaternion{q}), the angle"
        expect_close(angle, 0.0, tolerance=0.0)
    axis, near = turned(draw_quad(rng), X_AXIS), math.pi - 2e-7
    about.cause = "half a turn is undone by half a turn about the same axis, either way"
    for q, turn in (((0.0, *axis), math.pi), (quad(axis, near), near)):
        unit, angle = way_back(q)
        got, wanted = (abs(angle), *same_sign(unit, axis)), (turn, *axis)
        about.call = f"back_to_reference(Quaternion{q}), the angle without its sign, and the axis"
        expect_close(got, wanted, tolerance=TIGHT)


@pytest.mark.exercise("9.2")
@pytest.mark.robust
def test_no_way_back_from_what_is_no_orientation() -> None:
    about.cause = "to_axis_angle refuses what has not length 1"
    for numbers in ((1.0, 1.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)):
        expect_error(
            lambda numbers=numbers: back_to_reference(Quaternion(*numbers)),
            ValueError,
            call=f"back_to_reference(Quaternion{numbers})",
            allowed=lambda: back_to_reference(Quaternion(0.6, 0.8, 0.0, 0.0)),
            read=BACK,
        )
    expect_error(
        lambda: back_to_reference((1.0, 0.0, 0.0, 0.0)),
        TypeError,
        call="back_to_reference((1, 0, 0, 0))",
        allowed=lambda: back_to_reference(Quaternion(0.6, 0.8, 0.0, 0.0)),
        cause="four numbers are no Quaternion: TypeError",
        read=FIRST_LINES,
    )


# 9.3a Two quaternions without j and k


@pytest.mark.exercise("9.3a")
def test_a_product_without_j_and_k(rng: Random) -> None:
    about.read = PLANE
    (r, i), (s, j) = ((number(rng, 1.5), number(rng, 1.5)) for _ in range(2))
    about.call = f"product_without_j_and_k(Quaternion({r}, {i}, 0, 0), Quaternion({s}, {j}, 0, 0))"
    about.cause = "the scalar part is r r' - i i', since i i is -1, and beside i stands r i' + i r'"
    a, b = Quaternion(r, i, 0.0, 0.0), Quaternion(s, j, 0.0, 0.0)
    got = rijk(product_without_j_and_k(a, b))
    product = complex(r, i) * complex(s, j)
    wanted = (product.real, product.imag, 0.0, 0.0)
    expect_unchanged("a", rijk(a), (r, i, 0.0, 0.0), cause=UNCHANGED)
    expect_unchanged("b", rijk(b), (s, j, 0.0, 0.0), cause=UNCHANGED)
    slips = {
        "what comes of i i = 1": (r * s + i * j, product.imag, 0.0, 0.0),
        "component times component": (r * s, i * j, 0.0, 0.0),
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=TIGHT)
    about.cause = "a * b makes sixteen: leave out what is zero"
    got = max(4, multiplications((r, i), (s, j)))
    expect_exactly(got, 4, then=": multiplications, where more than four are made")


@pytest.mark.exercise("9.3a")
@pytest.mark.robust
def test_a_product_with_j_or_k_is_refused(rng: Random) -> None:
    about.read = PLANE
    r, i, n = number(rng), number(rng), number(rng)
    good = (r, i, 0.0, 0.0)
    about.cause = "a j or a k that is not zero would be lost: ValueError; a NaN is not zero either"
    pairs = [(n, 0.0), (-n, 0.0), (0.0, n), (0.0, -n), (n, n), (n, -n), (math.nan, 0.0)]
    for bad in ((r, i, *pair) for pair in (*pairs, (0.0, math.nan), (1e-12, 0.0), (0.0, -1e-12))):
        for a, b in ((bad, good), (good, bad)):
            expect_error(
                lambda a=a, b=b: product_without_j_and_k(Quaternion(*a), Quaternion(*b)),
                ValueError,
                call=f"product_without_j_and_k(Quaternion{a}, Quaternion{b})",
                allowed=lambda: product_without_j_and_k(Quaternion(*good), Quaternion(*good)),
            )
    for which, attempt in (
        ("a complex number, and a Quaternion", lambda: product_without_j_and_k(2.0, Quaternion())),
        ("a Quaternion, and a number", lambda: product_without_j_and_k(Quaternion(), 2.0)),
    ):
        expect_error(
            attempt,
            TypeError,
            call=f"product_without_j_and_k(...), of {which}",
            allowed=lambda: product_without_j_and_k(Quaternion(*good), Quaternion(*good)),
            cause="a number is no Quaternion: TypeError",
            read=FIRST_LINES,
        )


# 9.4 A steady turn, by sense and by steps


@pytest.mark.exercise("9.4")
def test_a_steady_turn_is_one_rotation(rng: Random) -> None:
    about.read = SENSE
    size = positive_number(rng, 0.2, 4.0)
    for q, rate in (((0.5, 0.5, 0.5, 0.5), size), (draw_quad(rng), -size), (draw_quad(rng), 0.0)):
        duration = positive_number(rng, 0.5, 3.0)
        orientation = Quaternion(*q)
        about.call = f"turned_by_sense(Quaternion{q}, {rate}, {duration})"
        about.cause = "one turn by rate times duration about the world's X, on the left of the "
        about.cause += "product"
        if rate == 0.0:
            about.cause = "a rate of 0 turns nothing, about any axis: the axis is X, and the angle "
            about.cause += "is 0"
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
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        expect_unchanged("orientation", rijk(orientation), q, cause=UNCHANGED)
    about.call = f"q = Quaternion{q}; turned_by_sense(q, 0, 1), which is changed then; q"
    about.cause = "a new one, where nothing turns too"
    turned_by_sense(orientation, 0.0, 1.0).r = 9.0
    expect_unchanged("q", rijk(orientation), q)


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
    about.read = BY_STEPS
    for q, steps, share in (
        ((0.5, 0.5, 0.5, 0.5), 1, 1.0),
        (draw_quad(rng), 2, -1.0),
        (draw_quad(rng), 1000, 0.3),  # so little is missing that acos tells nothing of it
        (draw_quad(rng), 3, 0.0),
    ):
        rate, duration = share * positive_number(rng, 0.3, 1.2), positive_number(rng, 1.0, 2.0)
        orientation = Quaternion(*q)
        about.call = f"turned_by_steps(Quaternion{q}, {rate}, {duration}, {steps})"
        about.cause = "add_scaled in steps of duration / steps, on a copy, which is normalised at "
        about.cause += "the end"
        if steps == 1:
            about.call = f"turned_by_steps(Quaternion{q}, {rate}, {duration})"
            result, error = turned_by_steps(orientation, rate, duration)
        else:
            result, error = turned_by_steps(orientation, rate, duration, steps)
        wanted = stepped(q, rate, duration, steps)
        got = same_sign(rijk(result), wanted)
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
        why = named(got, about.cause, slips)
        expect_close(got, wanted, then=", the orientation", cause=why, tolerance=TIGHT)
        turn = abs(rate * duration)
        missing = turn - 2.0 * steps * math.atan(0.5 * turn / steps)
        about.cause = "the angle of the turn from the one to the other, in radians and not negative"
        slips = {
            "half the angle": 0.5 * missing,
            "the angle with its sign": -missing,
            "an angle in degrees": math.degrees(missing),
        }
        why = named(error, about.cause, slips)
        if isinstance(error, (int, float)) and 1e-11 < abs(error - missing) < 1e-7:
            why = f"acos loses half of the digits where the turn is small, as here: {about.cause}"
        expect_close(error, missing, then=", the error", cause=why, tolerance=1e-11)
        expect_unchanged("orientation", rijk(orientation), q, cause=UNCHANGED)


@pytest.mark.exercise("9.4")
def test_an_error_is_at_most_half_a_turn() -> None:
    about.read = BY_STEPS
    q = (0.5, 0.5, 0.5, 0.5)
    about.call = f"turned_by_steps(Quaternion{q}, 3, 2), the error"
    about.cause = "a turn by more than pi is one by less the other way round"
    # It should turn by 6 rad, and turns by 2 atan 3 = 2.50: 3.50 are missing, or 2.78 too many.
    wanted = math.tau - (6.0 - 2.0 * math.atan(3.0))
    got = turned_by_steps(Quaternion(*q), 3.0, 2.0)[1]
    expect_close(got, wanted, tolerance=1e-11)


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
    about.cause = "whole of arguments.py asks for a whole number of 1 or more"
    for steps, error in ((0, ValueError), (-1, ValueError), (2.0, TypeError)):
        expect_error(
            lambda steps=steps: turned_by_steps(Quaternion(), 1.0, 2.0, steps),
            error,
            call=f"turned_by_steps(Quaternion(), 1, 2, {steps})",
            allowed=lambda: turned_by_steps(Quaternion(), 1.0, 2.0, 3),
            read=BY_STEPS,
        )
    about.cause = "its length is not 1: to_axis_angle refuses it, or you do"
    for length in (2.0, 1.000002):
        expect_error(
            lambda length=length: turned_by_steps(Quaternion(length, 0.0, 0.0, 0.0), 1.0, 2.0),
            ValueError,
            call=f"turned_by_steps(Quaternion({length}, 0, 0, 0), 1, 2)",
            allowed=lambda: [
                turned_by_steps(Quaternion(near, 0.0, 0.0, 0.0), 1.0, 2.0)
                for near in (1.0, 1.0 + 5e-7)
            ],
            read=BY_STEPS,
        )
    for name, function in (("sense", turned_by_sense), ("steps", turned_by_steps)):
        expect_error(
            lambda function=function: function((1.0, 0.0, 0.0, 0.0), 1.0, 2.0),
            TypeError,
            call=f"turned_by_{name}((1, 0, 0, 0), 1, 2)",
            allowed=lambda function=function: function(Quaternion(), 1.0, 2.0),
            cause="four numbers are no Quaternion: TypeError",
            read=FIRST_LINES,
        )
