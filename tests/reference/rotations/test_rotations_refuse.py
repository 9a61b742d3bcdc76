"""Rotations reject bad arguments with a clear message, and then nothing has changed."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, integrate_rotation, velocity_of_point
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from ch09_rotations.exercises import (
    back_to_reference,
    easy_inverse,
    product_without_j_and_k,
    read_off,
    turned_by_sense,
    turned_by_steps,
)
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion

NAN, INF = math.nan, math.inf
V, Q = Vector3(1.0, 2.0, 3.0), Quaternion(0.6, 0.0, 0.8, 0.0)
BAD = Vector3(1.0, NAN, 3.0)
LONG = Quaternion(1.0 + 2e-6)
NINE, TWELVE = Matrix3(*range(9)), Matrix4(*range(12))
OF_LENGTH_1 = r"must have length 1, got Quaternion\(1\.000002, "
FINITE = r"must have finite components, got Vector3\(1\.0, nan, 3\.0\)"


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: Quaternion("a"), ValueError, "could not convert"),
        (lambda: Quaternion(1, None), TypeError, "NoneType"),
        (lambda: Q * 2, TypeError, "unsupported operand"),
        (lambda: 2 * Q, TypeError, "unsupported operand"),
        (lambda: Q * V, TypeError, "unsupported operand"),
        (lambda: Quaternion.from_axis_angle(Vector3(), 1), ValueError, "axis must not be zero"),
        (lambda: Quaternion.from_axis_angle(BAD, 1), ValueError, f"axis {FINITE}"),
        (
            lambda: Quaternion.from_axis_angle(1.0, 1),
            TypeError,
            r"axis must be a Vector3, got 1\.0",
        ),
        (lambda: Quaternion.from_axis_angle(V, INF), ValueError, "angle must be finite, got inf"),
        (lambda: Quaternion.from_axis_angle(V, "1"), TypeError, "angle must be a number, got '1'"),
        (LONG.to_axis_angle, ValueError, OF_LENGTH_1),
        (Quaternion(NAN).to_axis_angle, ValueError, "must have length 1"),
        (lambda: LONG.rotate(V), ValueError, OF_LENGTH_1),
        (lambda: Q.rotate((1, 2, 3)), TypeError, r"v must be a Vector3, got \(1, 2, 3\)"),
        (lambda: Matrix3(*range(8)), TypeError, "nine numbers, row by row, got 8"),
        (lambda: Matrix3(*range(12)), TypeError, "nine numbers, row by row, got 12"),
        (lambda: Matrix3(range(9)), TypeError, "nine numbers, row by row, got 1"),
        (lambda: Matrix3(*[None] * 9), TypeError, "NoneType"),
        (lambda: Matrix3(*["a"] * 9), ValueError, "could not convert"),
        (lambda: Matrix4(*range(9)), TypeError, "twelve numbers, row by row, got 9"),
        (lambda: Matrix4(*range(16)), TypeError, "twelve numbers, row by row, got 16"),
        (lambda: NINE[3, 0], IndexError, r"from 0 to 2, got \(3, 0\)"),
        (lambda: NINE[0, -1], IndexError, r"from 0 to 2, got \(0, -1\)"),
        (lambda: TWELVE[0, 4], IndexError, r"column from 0 to 3, got \(0, 4\)"),
        (lambda: TWELVE[3, 3], IndexError, r"row must be from 0 to 2 .*, got \(3, 3\)"),
        (lambda: NINE @ 2, TypeError, "unsupported operand"),
        (lambda: NINE @ TWELVE, TypeError, "unsupported operand"),
        (lambda: TWELVE @ NINE, TypeError, "unsupported operand"),
        (lambda: NINE.transform(2.0), TypeError, r"v must be a Vector3, got 2\.0"),
        (lambda: NINE.product(TWELVE), TypeError, r"m must be a Matrix3, got Matrix4\("),
        (lambda: TWELVE.transform(None), TypeError, "v must be a Vector3, got None"),
        (lambda: TWELVE.product(NINE), TypeError, r"m must be a Matrix4, got Matrix3\("),
        (lambda: TWELVE.transform_inverse(1), TypeError, "v must be a Vector3, got 1"),
        (lambda: TWELVE.transform_direction(1), TypeError, "v must be a Vector3, got 1"),
        (lambda: TWELVE.transform_inverse_direction(1), TypeError, "v must be a Vector3, got 1"),
        (lambda: NINE.inverse(), ValueError, r"got determinant 0\.0, .*limit: 1e-13"),
        (lambda: Matrix3.from_quaternion(LONG), ValueError, f"q {OF_LENGTH_1}"),
        (lambda: Matrix3.from_quaternion(V), TypeError, r"q must be a Quaternion, got Vector3\("),
        (lambda: NINE.to_quaternion(), ValueError, r"must be a rotation, got Matrix3\(0\.0, 1\.0"),
        (lambda: Matrix4.from_orientation_and_position(LONG, V), ValueError, f"q {OF_LENGTH_1}"),
        (lambda: Matrix4.from_orientation_and_position(V, V), TypeError, "q must be a Quaternion"),
        (
            lambda: Matrix4.from_orientation_and_position(Q, 1),
            TypeError,
            "p must be a Vector3, got 1",
        ),
        (
            lambda: change_basis(NINE, TWELVE),
            TypeError,
            "m and basis must be matrices of the same size",
        ),
        (lambda: change_basis(Q, Q), TypeError, "m and basis must be matrices of the same size"),
        (lambda: change_basis(NINE, NINE), ValueError, "must have an inverse"),
        (lambda: euler_to_quaternion(NAN, 0, 0), ValueError, "must be finite, got nan"),
        (lambda: euler_to_quaternion(0, "y", 0), TypeError, "must be a number, got 'y'"),
        (lambda: rate_map(INF, 0, 0), ValueError, "x must be finite, got inf"),
        (lambda: rate_map(0, NAN, 0), ValueError, "y must be finite, got nan"),
        (lambda: rate_map(0, 0, None), TypeError, "z must be a number, got None"),
        (lambda: euler_rates(0, 0, 0, BAD), ValueError, f"angular_velocity {FINITE}"),
        (lambda: euler_rates(0, 0, 0, 1), TypeError, "angular_velocity must be a Vector3, got 1"),
        (lambda: velocity_of_point(BAD, V, V, V), ValueError, f"point {FINITE}"),
        (lambda: velocity_of_point(V, BAD, V, V), ValueError, f"position {FINITE}"),
        (lambda: velocity_of_point(V, V, BAD, V), ValueError, f"^velocity {FINITE}"),
        (lambda: velocity_of_point(V, V, V, BAD), ValueError, f"angular_velocity {FINITE}"),
        (lambda: velocity_of_point(V, V, 1, V), TypeError, "^velocity must be a Vector3, got 1"),
        (lambda: first_order_drift(NAN, 1, 1), ValueError, "angular_speed must be finite, got nan"),
        (lambda: first_order_drift(1, 0, 1), ValueError, "duration must be positive .*, got 0"),
        (lambda: first_order_drift(1, 1, 0), ValueError, "steps must be 1 or more, got 0"),
        (
            lambda: first_order_drift(1, 1, 2.0),
            TypeError,
            r"steps must be a whole number, got 2\.0",
        ),
        (lambda: back_to_reference(LONG), ValueError, OF_LENGTH_1),
        (lambda: back_to_reference(V), TypeError, "orientation must be a Quaternion"),
        (lambda: product_without_j_and_k(Q, LONG), ValueError, "a must have j and k zero"),
        (
            lambda: product_without_j_and_k(LONG, Quaternion(1, 0, 0, NAN)),
            ValueError,
            "b must have",
        ),
        (lambda: product_without_j_and_k(LONG, 2), TypeError, "b must be a Quaternion, got 2"),
        (lambda: turned_by_sense(Q, INF, 1), ValueError, "rate must be finite, got inf"),
        (lambda: turned_by_sense(Q, 1, -1), ValueError, "duration must be positive .*, got -1"),
        (lambda: turned_by_steps(LONG, 1, 1), ValueError, "must have length 1"),
        (lambda: turned_by_steps(Q, 1, 1, 0), ValueError, "steps must be 1 or more, got 0"),
        (lambda: turned_by_steps(Q, 1, 1, True), TypeError, "steps must be a whole number"),
        (lambda: read_off(TWELVE), ValueError, "matrix must be a rotation and a translation"),
        (lambda: read_off(NINE), TypeError, r"matrix must be a Matrix4, got Matrix3\("),
        (lambda: easy_inverse(NINE), TypeError, r"matrix must be a Matrix4, got Matrix3\("),
    ],
)
def test_what_makes_no_sense_is_refused_by_name(
    call: Callable[[], object], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        call()


@pytest.mark.parametrize(
    ("spin", "acceleration", "duration", "error", "words"),
    [
        (V, V, 0.0, ValueError, r"duration must be positive and finite, got 0\.0"),
        (V, V, -1.0, ValueError, r"duration must be positive and finite, got -1\.0"),
        (V, V, NAN, ValueError, "duration must be positive and finite, got nan"),
        (V, V, INF, ValueError, "duration must be positive and finite, got inf"),
        (V, V, "1", TypeError, "duration must be a number, got '1'"),
        (BAD, V, 1.0, ValueError, f"angular_velocity {FINITE}"),
        (V, BAD, 1.0, ValueError, f"angular_acceleration {FINITE}"),
        (V, 1.0, 1.0, TypeError, r"angular_acceleration must be a Vector3, got 1\.0"),
        (Vector3(1e300), V, 1e300, ValueError, "must have finite components"),
    ],
)
def test_a_refused_step_changes_nothing(
    spin: Vector3, acceleration: Vector3, duration: float, error: type[Exception], words: str
) -> None:
    q, kept = Q.copy(), spin.copy()
    with pytest.raises(error, match=words):
        integrate_rotation(q, kept, acceleration, duration)
    assert q == Q
    assert repr(kept) == repr(spin)  # NaN is not equal to itself
    with pytest.raises(TypeError, match=r"orientation must be a Quaternion, got Vector3\("):
        integrate_rotation(V, kept, V, 1.0)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda q: q.rotate_by(BAD), ValueError, f"vector {FINITE}"),
        (lambda q: q.rotate_by(Vector3(INF)), ValueError, "vector must have finite components"),
        (lambda q: q.rotate_by(1.0), TypeError, r"vector must be a Vector3, got 1\.0"),
        (lambda q: q.add_scaled(BAD, 1.0), ValueError, f"vector {FINITE}"),
        (lambda q: q.add_scaled(V, NAN), ValueError, "scale must be finite, got nan"),
        (lambda q: q.add_scaled(V, None), TypeError, "scale must be a number, got None"),
        (lambda q: q.add_scaled(None, 1.0), TypeError, "vector must be a Vector3, got None"),
    ],
)
def test_a_refused_turn_leaves_the_quaternion_as_it_was(
    call: Callable[[Quaternion], None], error: type[Exception], words: str
) -> None:
    q = Q.copy()
    with pytest.raises(error, match=words):
        call(q)
    assert q == Q


def test_what_returns_a_new_one_leaves_the_old_as_it_was() -> None:
    q, v, p, m = Q.copy(), V.copy(), V.copy(), Matrix4(0, -1, 0, 4, 1, 0, 0, 5, 0, 0, 1, 6)
    entries, three = m.entries, Matrix3.from_quaternion(q)
    q.rotate(v)
    q.to_axis_angle()
    q.conjugate()
    Quaternion.from_axis_angle(v, 1.0)
    m.transform(v)
    m.inverse()
    m.transform_inverse(v)
    three.inverse()
    velocity_of_point(v, p, v, p)
    turned_by_steps(q, 1.0, 1.0, 3)
    Quaternion(q.r, q.i, q.j, q.k).rotate_by(v)
    assert (q, v, p, m.entries) == (Q, V, V, entries)
    assert three == Matrix3.from_quaternion(Q)
    assert Quaternion() * q is not q
    zero = Vector3()
    q.rotate_by(zero)
    assert q == Q
    assert q != (0.6, 0.0, 0.8, 0.0)
    assert m != three
