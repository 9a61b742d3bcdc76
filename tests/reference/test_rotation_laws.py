"""The laws of quaternions, for all examples that hypothesis generates."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import UNIT_TOLERANCE, Quaternion

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


def test_hamiltons_rules_hold() -> None:
    i, j, k = Quaternion(0, 1), Quaternion(0, 0, 1), Quaternion(0, 0, 0, 1)
    assert i * i == j * j == k * k == i * j * k == Quaternion(-1.0)
    assert (i * j, j * k, k * i) == (k, i, j)
    assert j * i == Quaternion(0, 0, 0, -1)


@given(turn)
def test_the_conjugate_is_the_inverse_of_a_turn(q: Quaternion) -> None:
    assert near(q * q.conjugate(), ONE)
    assert near(q.conjugate() * q, ONE)


@given(turn, turn, vector)
def test_a_product_turns_as_one_turn_after_the_other(
    a: Quaternion, b: Quaternion, v: Vector3
) -> None:
    assert near((a * b).rotate(v), a.rotate(b.rotate(v)))
    m, n = Matrix3.from_quaternion(a), Matrix3.from_quaternion(b)
    assert near(Matrix3.from_quaternion(a * b), m @ n)
    assert near(m @ v, a.rotate(v))


@given(turn, vector)
def test_a_turn_is_the_quaternion_times_the_vector_times_the_conjugate(
    q: Quaternion, v: Vector3
) -> None:
    assert near(Quaternion(0.0, *q.rotate(v)), q * Quaternion(0.0, *v) * q.conjugate())


@given(turn, vector, vector, st.floats(-1.0, 1.0))
def test_a_turn_is_linear_and_keeps_lengths_angles_and_right_hands(
    q: Quaternion, v: Vector3, w: Vector3, scale: float
) -> None:
    assert near(q.rotate(v + w * scale), q.rotate(v) + q.rotate(w) * scale)
    assert q.rotate(v).magnitude() == pytest.approx(v.magnitude(), abs=ROUNDINGS)
    assert q.rotate(v).dot(q.rotate(w)) == pytest.approx(v.dot(w), abs=ROUNDINGS)
    assert near(q.rotate(v.cross(w)), q.rotate(v).cross(q.rotate(w)))


@given(turn)
def test_the_matrix_of_a_turn_is_orthogonal_with_determinant_1(q: Quaternion) -> None:
    m = Matrix3.from_quaternion(q)
    assert near(m @ m.transpose(), (1, 0, 0, 0, 1, 0, 0, 0, 1))
    assert m.determinant() == pytest.approx(1.0, abs=ROUNDINGS)
    assert near(m.inverse(), m.transpose())
    assert m.is_rotation()


@given(turn, vector)
def test_a_quaternion_and_its_negative_are_one_turn(q: Quaternion, v: Vector3) -> None:
    negative = Quaternion(*(-component for component in q))
    assert q.rotate(v) == negative.rotate(v)  # the same products, with both signs reversed
    assert Matrix3.from_quaternion(q) == Matrix3.from_quaternion(negative)
    (u, angle), (other, same) = q.to_axis_angle(), negative.to_axis_angle()
    assert angle == same
    assert near(u, other) or (math.pi - angle < ROUNDINGS and near(u, -other))


@given(axis, st.floats(0.0, math.pi))
def test_axis_and_angle_come_back(u: Vector3, angle: float) -> None:
    back, same = Quaternion.from_axis_angle(u, angle).to_axis_angle()
    assert same == pytest.approx(angle, abs=1e-15)  # a cosine, a sine and their arc
    if angle == 0.0:
        assert back == Vector3(1.0, 0.0, 0.0)
    elif angle > 1e-300:  # smaller angles have few digits
        at = 1.0 if math.pi - angle > ROUNDINGS else math.copysign(1.0, back.dot(u))
        assert near(back, u.normalized() * at)


@given(turn)
def test_a_matrix_and_a_quaternion_come_back_from_each_other(q: Quaternion) -> None:
    m = Matrix3.from_quaternion(q)
    back = m.to_quaternion()
    assert near(Matrix3.from_quaternion(back), m)
    same = math.copysign(1.0, sum(p * r for p, r in zip(q, back, strict=True)))
    assert near(back, (component * same for component in q))


@given(turn, axis, st.floats(0.0, 10.0))
def test_a_turn_by_a_scaled_axis_is_undone_by_its_negative(
    q: Quaternion, u: Vector3, angle: float
) -> None:
    turned = q.copy()
    turned.rotate_by(u * angle)
    later = Quaternion.from_axis_angle(u, u.magnitude() * angle)
    assert near(turned.rotate(u), later.rotate(q.rotate(u)))
    turned.rotate_by(-(u * angle))
    assert near(turned, q)


@pytest.mark.parametrize("angle", [1e-9, 1e-160, 1e-200, 1e-300])
def test_tiny_angles_keep_their_axis_and_size(angle: float) -> None:
    u, same = Quaternion.from_axis_angle(Vector3(1.0, -2.0, 2.0), angle).to_axis_angle()
    assert same == pytest.approx(angle, rel=1e-15, abs=0.0)  # a few roundings
    assert near(u * 3.0, (1.0, -2.0, 2.0))
    q = Quaternion()
    q.rotate_by(Vector3(0.6, 0.0, 0.8) * angle)
    assert tuple(q) == pytest.approx((1.0, 0.3 * angle, 0.0, 0.4 * angle), rel=1e-15, abs=0.0)


def test_an_angle_of_0_has_x_for_an_axis_and_a_half_turn_any_way() -> None:
    nothing = (Vector3(1.0, 0.0, 0.0), 0.0)
    for q in (ONE, Quaternion(-1.0), Quaternion.from_axis_angle(Vector3(0.0, 1.0, 0.0), 0.0)):
        assert q.to_axis_angle() == nothing
    for sign in (1.0, -1.0):
        u, angle = Quaternion(0.0, 0.0, 0.6 * sign, 0.8 * sign).to_axis_angle()
        assert angle == math.pi
        assert u in (Vector3(0.0, 0.6, 0.8), Vector3(0.0, -0.6, -0.8))


@pytest.mark.parametrize("scale", [1e-200, 1e-160, 1e-3, 1.0, 1e3, 1e160, 1e200])
def test_the_length_and_its_normalizing_are_right_for_tiny_and_huge_numbers(scale: float) -> None:
    q = Quaternion(1.0 * scale, -2.0 * scale, 4.0 * scale, 10.0 * scale)  # 1 + 4 + 16 + 100 = 121
    assert q.magnitude() == pytest.approx(11.0 * scale, rel=4e-16, abs=0.0)  # two roundings
    q.normalize()
    assert tuple(q) == pytest.approx((1 / 11, -2 / 11, 4 / 11, 10 / 11), rel=4e-16)
    direction = Vector3(2.0 * scale, 3.0 * scale, 6.0 * scale)  # length 7
    assert near(Quaternion.from_axis_angle(direction, math.pi), (0.0, 2 / 7, 3 / 7, 6 / 7))


def test_zero_is_normalized_to_the_reference_orientation() -> None:
    q = Quaternion(0.0, 0.0, 0.0, 0.0)
    q.normalize()
    assert q == ONE


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_length_is_1_to_a_millionth(sign: float) -> None:
    near_1, off = (Quaternion(1.0 + sign * far * UNIT_TOLERANCE) for far in (0.999, 1.001))
    v = Vector3(1.0, 2.0, 3.0)
    assert near_1.is_unit()
    assert not off.is_unit()
    assert near_1.rotate(v) == v
    assert near_1.to_axis_angle()[1] == 0.0
    assert Matrix3.from_quaternion(near_1).is_rotation()
    for refused in (lambda: off.rotate(v), off.to_axis_angle, lambda: Matrix3.from_quaternion(off)):
        with pytest.raises(ValueError, match=r"must have length 1, got Quaternion\((1\.0|0\.9)"):
            refused()
    assert not Quaternion(math.nan).is_unit()
    assert not Quaternion(math.inf).is_unit()
