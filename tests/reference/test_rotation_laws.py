"""The laws of quaternions, for all examples that hypothesis generates."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion

ONE = Quaternion()

# Numbers so small that every sum and product below is an exact whole number, without tolerances.
number = st.integers(-1000, 1000)
whole = st.tuples(number, number, number, number).map(lambda four: Quaternion(*four))

share = st.floats(-1.0, 1.0)
axis = (
    st.tuples(share, share, share)
    .map(lambda three: Vector3(*three))
    .filter(lambda v: v.magnitude() > 0.1)
)
turn = st.builds(Quaternion.from_axis_angle, axis, st.floats(-10.0, 10.0))
vector = st.tuples(share, share, share).map(lambda three: Vector3(*three))

# For vectors up to length 2 after about thirty roundings of 1.1e-16, which mostly cancel.
ROUNDINGS = 1e-14


def near(got: object, wanted: object) -> bool:
    return list(got) == pytest.approx(list(wanted), abs=ROUNDINGS)  # type: ignore[call-overload]


def squared(q: Quaternion) -> float:
    return q.r**2 + q.i**2 + q.j**2 + q.k**2


@given(whole, whole, whole)
def test_products_are_associative_and_distribute_exactly(
    a: Quaternion, b: Quaternion, c: Quaternion
) -> None:
    assert (a * b) * c == a * (b * c)
    summed = Quaternion(*(p + q for p, q in zip(b, c, strict=True)))
    assert a * summed == Quaternion(*(p + q for p, q in zip(a * b, a * c, strict=True)))
    assert a * ONE == ONE * a == a


@given(whole, whole)
def test_the_conjugate_turns_products_round_and_the_length_is_multiplied(
    a: Quaternion, b: Quaternion
) -> None:
    assert (a * b).conjugate() == b.conjugate() * a.conjugate()
    assert squared(a * b) == squared(a) * squared(b)
    assert a * a.conjugate() == a.conjugate() * a == Quaternion(squared(a))
    # One rounding of each root, and one of their product.
    assert (a * b).magnitude() == pytest.approx(a.magnitude() * b.magnitude(), rel=1e-15)


@given(turn, vector)
def test_a_quaternion_and_its_negative_are_one_turn(q: Quaternion, v: Vector3) -> None:
    negative = Quaternion(*(-component for component in q))
    assert q.rotate(v) == negative.rotate(v)  # the same products, with both signs reversed
    assert Matrix3.from_quaternion(q) == Matrix3.from_quaternion(negative)
    (u, angle), (other, same) = q.to_axis_angle(), negative.to_axis_angle()
    assert angle == same
    assert near(u, other) or (math.pi - angle < ROUNDINGS and near(u, -other))


@pytest.mark.parametrize("angle", [1e-9, 1e-160, 1e-200, 1e-300])
def test_tiny_angles_keep_their_axis_and_size(angle: float) -> None:
    u, same = Quaternion.from_axis_angle(Vector3(1.0, -2.0, 2.0), angle).to_axis_angle()
    assert same == pytest.approx(angle, rel=1e-15, abs=0.0)  # a few roundings
    assert near(u * 3.0, (1.0, -2.0, 2.0))
    q = Quaternion()
    q.rotate_by(Vector3(0.6, 0.0, 0.8) * angle)
    assert tuple(q) == pytest.approx((1.0, 0.3 * angle, 0.0, 0.4 * angle), rel=1e-15, abs=0.0)
