"""What a quaternion turns: build tasks B9.9 to B9.11."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.probes import in_parts
from ch09_rotations.quaternion import Quaternion
from draw import components, positive_number
from expect import (
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    expect_vector,
    xyz,
)
from turning import (
    TIGHT,
    X_AXIS,
    Quad,
    draw_quad,
    draw_turn,
    hamilton,
    quad,
    rijk,
    same_sign,
    turned,
)

MAKE = "book 9.2.4, Eq. 9.4, and the docstring of from_axis_angle"
BACK = "the docstring of to_axis_angle"
ROTATE = "the docstring of rotate"
BY_VECTOR = "the docstring of rotate_by, and E-12"
ADD = "book 9.4.10, Eq. 9.5"
FIRST_LINES = "the first lines of quaternion.py"


@pytest.mark.exercise("B9.9")
def test_the_quaternion_of_axis_and_angle(rng: Random) -> None:
    read = MAKE
    call = "Quaternion.from_axis_angle(Vector3(1, 2, 3), 1.2)"
    cause = "the cosine of half the angle, and the axis, normalised, times its sine"
    got = rijk(Quaternion.from_axis_angle(Vector3(1.0, 2.0, 3.0), 1.2))
    # Eight decimals of SciPy's Rotation.from_rotvec.
    wanted = (0.82533561, 0.15090705, 0.30181410, 0.45272115)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-8)
    axis, angle = draw_turn(rng)
    for t in (angle, -angle, 2.0 * math.pi + angle):
        v = Vector3(*axis)
        call = f"Quaternion.from_axis_angle(Vector3{axis}, {t})"
        wanted = quad(axis, t)
        got = rijk(Quaternion.from_axis_angle(v, t))
        if t > math.pi:  # a turn by t - 2 pi is the same, and has the opposite quaternion
            got = same_sign(got, wanted)
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)
        expect_unchanged(call, "axis", xyz(v), axis, read=read)


@pytest.mark.exercise("B9.9")
def test_the_length_of_the_axis_does_not_matter(rng: Random) -> None:
    read = MAKE
    axis, angle = draw_turn(rng)
    cause = "normalise the axis first, or rather a copy of it"
    for scale in (1e-3, 1e200, 1e-200):
        scaled = tuple(component * scale for component in axis)
        call = f"Quaternion.from_axis_angle(Vector3{scaled}, {angle})"
        got = rijk(Quaternion.from_axis_angle(Vector3(*scaled), angle))
        expect_close(call, got, quad(axis, angle), cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.9", weight=0.5)
def test_no_axis_or_no_angle_is_refused() -> None:
    read = MAKE
    for axis, angle, error in (
        ((0.0, 0.0, 0.0), 1.0, ValueError),
        ((0.0, math.nan, 1.0), 1.0, ValueError),
        ((0.0, math.inf, 1.0), 1.0, ValueError),
        ((0.0, 1.0, 1.0), math.nan, ValueError),
        ((0.0, 1.0, 1.0), math.inf, ValueError),
        ((0.0, 1.0, 1.0), "1.0", TypeError),
    ):
        call = f"Quaternion.from_axis_angle(Vector3{axis}, {angle!r})"
        cause = "zero has no direction; finite_vector and finite of arguments.py refuse the rest"
        expect_error(
            call,
            lambda axis=axis, angle=angle: Quaternion.from_axis_angle(Vector3(*axis), angle),
            error,
            allowed=lambda: Quaternion.from_axis_angle(Vector3(0.0, 1.0, 1.0), 1.0),
            cause=cause,
            read=read,
        )
    cause = "three numbers are no Vector3: finite_vector of arguments.py refuses them"
    expect_error(
        "Quaternion.from_axis_angle((0, 1, 1), 1.0)",
        lambda: Quaternion.from_axis_angle((0.0, 1.0, 1.0), 1.0),
        TypeError,
        allowed=lambda: Quaternion.from_axis_angle(Vector3(0.0, 1.0, 1.0), 1.0),
        cause=cause,
        read=FIRST_LINES,
    )


def axis_angle_of(q: Quad, cause: str) -> tuple:
    """Return axis and angle as plain numbers."""
    read = BACK
    call = f"Quaternion{q}.to_axis_angle()"
    quaternion = Quaternion(*q)
    axis, angle = quaternion.to_axis_angle()
    got = expect_vector(f"{call}, the axis", axis, cause=cause, read=read)
    expect_unchanged(call, "q", rijk(quaternion), q, read=read)
    return got, angle


@pytest.mark.exercise("B9.9", weight=2)
def test_axis_and_angle_of_a_quaternion(rng: Random) -> None:
    read = BACK
    cause = "the angle is 2 atan2(|(i, j, k)|, |r|); where r is negative the axis turns round"
    for sign in (1.0, -1.0):
        axis, angle = draw_turn(rng)
        length = math.hypot(*axis)
        wanted = tuple(component / length for component in axis)
        r, i, j, k = (sign * component for component in quad(axis, angle))
        call = f"Quaternion{(r, i, j, k)}.to_axis_angle(), "
        got, turn = axis_angle_of((r, i, j, k), cause)
        expect_close(f"{call}the angle", turn, angle, cause=cause, read=read, tolerance=TIGHT)
        expect_close(f"{call}the axis", got, wanted, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.9")
def test_axis_and_angle_at_the_ends(rng: Random) -> None:
    read = BACK
    axis, _ = draw_turn(rng)
    length = math.hypot(*axis)
    unit = tuple(component / length for component in axis)
    cause = "there is nothing to turn: the angle is 0, and the axis X, for want of one"
    for q in ((1.0, 0.0, 0.0, 0.0), (-1.0, 0.0, 0.0, 0.0)):
        call = f"Quaternion{q}.to_axis_angle(), "
        got, turn = axis_angle_of(q, cause)
        expect_close(f"{call}the angle", turn, 0.0, cause=cause, read=read, tolerance=0.0)
        expect_close(f"{call}the axis", got, X_AXIS, cause=cause, read=read, tolerance=0.0)
    cause = "r is 0 and the angle pi; the axis may point either way"
    q = (0.0, *unit)
    call = f"Quaternion{q}.to_axis_angle(), "
    got, turn = axis_angle_of(q, cause)
    expect_close(f"{call}the angle", turn, math.pi, cause=cause, read=read, tolerance=TIGHT)
    got = same_sign(got, unit)
    expect_close(f"{call}the axis", got, unit, cause=cause, read=read, tolerance=TIGHT)
    cause = "asin loses half of the digits near pi, as acos does near 0: atan2 of sine and cosine"
    for less in (1e-3, 1e-6):
        q = quad(unit, math.pi - less)
        call = f"Quaternion{q}.to_axis_angle(), "
        got, turn = axis_angle_of(q, cause)
        wanted = math.pi - less
        expect_close(f"{call}the angle", turn, wanted, cause=cause, read=read, tolerance=TIGHT)
        expect_close(f"{call}the axis", got, unit, cause=cause, read=read, tolerance=TIGHT)
    cause = "near 0 the cosine is 1 for every angle, so acos finds none: atan2 of sine and cosine"
    for small in (1e-5, 1e-9, 1e-200):
        x, y, z = (component * 0.5 * small for component in unit)
        call = f"Quaternion{(1.0, x, y, z)}.to_axis_angle(), "
        got, turn = axis_angle_of((1.0, x, y, z), cause)
        # A sine is the angle but for its cube, 1e-11 of it and less here.
        near = 1e-10 * small
        expect_close(f"{call}the angle", turn, small, cause=cause, read=read, tolerance=near)
        expect_close(f"{call}the axis", got, unit, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.9", weight=0.5)
def test_axis_and_angle_though_the_length_is_a_little_off(rng: Random) -> None:
    read = BACK
    drawn = draw_quad(rng)
    length = math.hypot(*drawn[1:])
    unit = tuple(component / length for component in drawn[1:])
    cause = "a length that is_unit lets pass may be above 1 or below: atan2 asks only proportions"
    for off in (1.0 + 5e-7, 1.0 - 5e-7):
        for whole in (drawn, (0.0, *unit), (1.0, 0.0, 0.0, 0.0)):
            q = tuple(component * off for component in whole)
            call = f"Quaternion{q}.to_axis_angle(), "
            got, turn = axis_angle_of(q, cause)
            wanted = 2.0 * math.atan2(math.hypot(*q[1:]), q[0])
            expect_close(f"{call}the angle", turn, wanted, cause=cause, read=read, tolerance=1e-5)
            axis = X_AXIS if whole[0] == 1.0 else unit
            got = same_sign(got, axis)
            expect_close(f"{call}the axis", got, axis, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.9", weight=0.5)
def test_each_axis_is_a_new_vector() -> None:
    read = BACK
    call = "axis, _ = Quaternion().to_axis_angle(), a second time, after the first axis is inverted"
    cause = "a new vector in every call: one that is kept is changed by whoever was given it"
    first, _ = Quaternion().to_axis_angle()
    first.invert()
    second, _ = Quaternion().to_axis_angle()
    expect_close(call, xyz(second), X_AXIS, cause=cause, read=read, tolerance=0.0)


def expect_unit_wanted(what: str, use: object, q: Quad, read: str) -> None:
    """Expect a quaternion just off length 1 to be refused, and one that is nearer not to be."""
    cause = "ask is_unit() first: rounding is allowed for, up to 1e-6"
    for length in (1.0 + 2e-6, 1.0 - 2e-6, 0.0, 2.0, math.nan):
        scaled = tuple(component * length for component in q)
        expect_error(
            f"Quaternion{scaled}{what}, of length {length}",
            lambda scaled=scaled: use(Quaternion(*scaled)),
            ValueError,
            allowed=lambda: [
                use(Quaternion(*(component * near for component in q)))
                for near in (1.0 + 5e-7, 1.0 - 5e-7)
            ],
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("B9.9", weight=0.5)
def test_what_is_no_turn_has_no_axis(rng: Random) -> None:
    expect_unit_wanted(".to_axis_angle()", lambda q: q.to_axis_angle(), draw_quad(rng), BACK)


@pytest.mark.exercise("B9.10", weight=2)
def test_a_vector_is_turned(rng: Random) -> None:
    read = ROTATE
    half = math.sqrt(0.5)
    call = f"Quaternion({half}, 0, 0, {half}).rotate(Vector3(1, 0, 0)), 90 degrees about Z"
    cause = "q (0, v) q*, in this order: X goes to Y, counter-clockwise"
    got = xyz(Quaternion(half, 0.0, 0.0, half).rotate(Vector3(1.0, 0.0, 0.0)))
    expect_close(call, got, (0.0, 1.0, 0.0), cause=cause, read=read, tolerance=TIGHT)
    for sign in (1.0, -1.0, 1.0 + 5e-7):
        q, a = tuple(sign * component for component in draw_quad(rng)), components(rng)
        quaternion, v = Quaternion(*q), Vector3(*a)
        call = f"q = Quaternion{q}; q.rotate(Vector3{a})"
        got = xyz(quaternion.rotate(v))
        # Rounding of a vector of a length up to 17; or what a length that is 5e-7 off may make.
        near = 1e-11 if abs(sign) == 1.0 else 1e-4
        expect_close(call, got, turned(q, a), cause=cause, read=read, tolerance=near)
        expect_unchanged(call, "v", xyz(v), a, read=read)
        expect_unchanged(call, "q", rijk(quaternion), q, read=read)
    call = f"v = Vector3{a}; Quaternion().rotate(v), which is inverted then; v"
    cause = "a new vector, where nothing turns too"
    same = Quaternion().rotate(v)
    same.invert()
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read=read)


@pytest.mark.exercise("B9.10", weight=0.5)
def test_what_is_no_turn_turns_nothing(rng: Random) -> None:
    v = Vector3(1.0, 2.0, 3.0)
    expect_unit_wanted(".rotate(Vector3(1, 2, 3))", lambda q: q.rotate(v), draw_quad(rng), ROTATE)


@pytest.mark.exercise("B9.10", weight=0.5)
def test_only_a_vector_is_turned(rng: Random) -> None:
    read = FIRST_LINES
    cause = "three numbers are no Vector3: TypeError"
    q = draw_quad(rng)
    for other in ((1.0, 2.0, 3.0), 1.0):
        expect_error(
            f"Quaternion{q}.rotate({other})",
            lambda other=other: Quaternion(*q).rotate(other),
            TypeError,
            allowed=lambda: [
                Quaternion(*q).rotate(Vector3(*any_will_do))
                for any_will_do in ((1.0, 2.0, 3.0), (math.inf, math.nan, 0.0))
            ],
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("B9.11", weight=2)
def test_a_quaternion_is_turned_on_by_a_vector(rng: Random) -> None:
    read = BY_VECTOR
    cause = "from_axis_angle of the vector and its length, times q, in this order: the axis is the "
    cause += "world's, and (0, vector) itself is no turn"
    for size in (0.3, 1.0, 9.0):
        q, a = draw_quad(rng), tuple(size * component for component in components(rng))
        quaternion, v = Quaternion(*q), Vector3(*a)
        call = f"q = Quaternion{q}; q.rotate_by(Vector3{a}); q"
        returned = quaternion.rotate_by(v)
        wanted = hamilton(quad(a, math.hypot(*a)), q)
        got = same_sign(rijk(quaternion), wanted)
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-11)
        expect_unchanged(call, "the vector", xyz(v), a, read=read)
        call = f"Quaternion{q}.rotate_by(Vector3{a}), what it returns"
        cause_none = "what changes in place returns nothing"
        expect_exactly(call, returned, None, cause=cause_none, read=read)


@pytest.mark.exercise("B9.11")
def test_a_steady_turn_is_exact_in_any_parts() -> None:
    read = BY_VECTOR
    cause = "it is a rotation, not its first order: the angle of each part is its length"
    for parts in (1, 7, 100):
        call = (
            f"{parts} times q.rotate_by(Vector3(0.3, -0.5, 0.8) * 2 / {parts}), from Quaternion()"
        )
        got = in_parts((0.3, -0.5, 0.8), 2.0, parts)
        # Eight decimals of SciPy's Rotation.from_rotvec.
        wanted = (0.54873208, 0.25334573, -0.42224289, 0.67558862)
        got = same_sign(got, wanted)
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-8)


@pytest.mark.exercise("B9.11")
def test_turned_on_by_next_to_nothing(rng: Random) -> None:
    read = BY_VECTOR
    q = draw_quad(rng)
    quaternion = Quaternion(*q)
    call = f"q = Quaternion{q}; q.rotate_by(Vector3(0, 0, 0)); q"
    cause = "zero has no direction, and turns nothing"
    quaternion.rotate_by(Vector3(0.0, 0.0, 0.0))
    expect_close(call, rijk(quaternion), q, cause=cause, read=read, tolerance=0.0)
    cause = "half the vector, to rounding: no small angle may be taken for none"
    for tiny in (1e-9, 1e-200):
        quaternion = Quaternion()
        call = f"q = Quaternion(); q.rotate_by(Vector3(0, {tiny}, 0)); q.j / {tiny}"
        quaternion.rotate_by(Vector3(0.0, tiny, 0.0))
        got = same_sign(rijk(quaternion), (1.0, 0.0, 0.0, 0.0))[2] / tiny
        expect_close(call, got, 0.5, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.11", weight=2)
def test_the_step_of_the_book(rng: Random) -> None:
    read = ADD
    size = positive_number(rng, 0.01, 0.9)
    for scale in (-size, size):
        q, a = draw_quad(rng), components(rng)
        quaternion, v = Quaternion(*q), Vector3(*a)
        call = f"q = Quaternion{q}; q.add_scaled(Vector3{a}, {scale}); q"
        cause = (
            "add scale/2 times (0, vector) q to q: (0, vector) on the left, all four components "
        )
        cause += "of the old q, and do not normalise"
        returned = quaternion.add_scaled(v, scale)
        change = hamilton((0.0, *a), q)
        wanted = [old + 0.5 * scale * new for old, new in zip(q, change, strict=True)]
        expect_close(call, rijk(quaternion), wanted, cause=cause, read=read, tolerance=TIGHT)
        expect_unchanged(call, "the vector", xyz(v), a, read=read)
    cause = "what changes in place returns nothing"
    call = f"Quaternion{q}.add_scaled(Vector3{a}, {scale}), what it returns"
    expect_exactly(call, returned, None, cause=cause, read=read)


@pytest.mark.exercise("B9.11", weight=0.5)
@pytest.mark.parametrize("method", ["rotate_by", "add_scaled"])
def test_turned_by_what_is_no_vector(rng: Random, method: str) -> None:
    read = f"the docstring of {method}"
    q, scale = draw_quad(rng), positive_number(rng)
    cause = "finite_vector and finite of arguments.py refuse it, before anything is changed"
    good = (0.0, 1.0, 1.0)
    bad = [((0.0, n, 1.0), scale, ValueError) for n in (math.nan, math.inf)]
    bad += [(good, n, ValueError) for n in (math.nan, math.inf) if method == "add_scaled"]
    bad += [(good, "1.0", TypeError)] if method == "add_scaled" else []

    def use(quaternion: object, v: object, by: object) -> object:
        return getattr(quaternion, method)(v, *((by,) if method == "add_scaled" else ()))

    for a, by, error in [*bad, (None, scale, TypeError)]:
        quaternion = Quaternion(*q)
        vector = None if a is None else Vector3(*a)
        call = f"q = Quaternion{q}; q.{method}({'None' if a is None else f'Vector3{a}'}"
        call += f", {by!r})" if method == "add_scaled" else ")"
        expect_error(
            call,
            lambda quaternion=quaternion, vector=vector, by=by: use(quaternion, vector, by),
            error,
            allowed=lambda: use(Quaternion(*q), Vector3(*good), scale),
            cause=cause,
            read=read,
        )
        expect_unchanged(call, "q", rijk(quaternion), q, cause=cause, read=read)
    more = (scale,) if method == "add_scaled" else ()
    shown = ", ".join(map(str, (good, *more)))
    expect_error(
        f"Quaternion{q}.{method}({shown})",
        lambda: use(Quaternion(*q), good, scale),
        TypeError,
        allowed=lambda: use(Quaternion(*q), Vector3(*good), scale),
        cause="three numbers are no Vector3: finite_vector of arguments.py refuses them",
        read=FIRST_LINES,
    )
