"""The errata of chapter 9: the printed form fails, and the correct form next to it does not."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from ch09_rotations.exercises import balance_offset, center_of_stones, masses_beside
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.quaternion import Quaternion

QUARTER = math.pi / 2.0
X, Z = Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.0, 1.0)
# The rows (2, 1, 1), (0, 1, 3), (1, 0, 2) and a translation. The determinant is 4 + 3 - 1 = 6.
MATRIX = Matrix4(2, 1, 1, 5, 0, 1, 3, -4, 1, 0, 2, 6)
IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)


def farthest(got: Sequence[float], wanted: Sequence[float]) -> float:
    return max(abs(p - q) for p, q in zip(got, wanted, strict=True))


def test_e11_the_printed_matrix_of_a_quaternion_turns_the_other_way() -> None:
    q = Quaternion.from_axis_angle(Z, QUARTER)
    r, i, j, k = q
    printed = Matrix3(
        *(1 - 2 * (j * j + k * k), 2 * (i * j + k * r), 2 * (i * k - j * r)),
        *(2 * (i * j - k * r), 1 - 2 * (i * i + k * k), 2 * (j * k + i * r)),
        *(2 * (i * k + j * r), 2 * (j * k - i * r), 1 - 2 * (i * i + j * j)),
    )
    right = Matrix3.from_quaternion(q)
    # A rounding or two of the root of 1/2, squared and doubled.
    assert tuple(printed @ X) == pytest.approx((0.0, -1.0, 0.0), abs=5e-16)
    assert tuple(right @ X) == pytest.approx((0.0, 1.0, 0.0), abs=5e-16)
    assert tuple(q.rotate(X)) == pytest.approx((0.0, 1.0, 0.0), abs=5e-16)
    assert printed == right.transpose()


def test_e11_the_printed_matrix_of_an_axis_and_an_angle_is_no_rotation() -> None:
    x, y, z = Vector3(1.0, 2.0, 2.0) / 3.0
    c, s, t = math.cos(1.2), math.sin(1.2), 1.0 - math.cos(1.2)

    def transposed(last: float) -> Matrix3:
        return Matrix3(
            *(t * x * x + c, t * x * y + s * z, t * x * z - s * y),
            *(t * x * y - s * z, t * y * y + c, t * y * z + s * x),
            *(t * x * z + s * y, t * y * z - s * x, last),
        )

    printed, mended = transposed(t * z * z + x), transposed(t * z * z + c)
    right = Matrix3.from_quaternion(Quaternion.from_axis_angle(Vector3(x, y, z), 1.2))
    assert not printed.is_rotation()
    assert farthest(tuple(mended.transpose()), tuple(right)) < 1e-15  # a few roundings of 1
    assert printed[2, 2] - right[2, 2] == pytest.approx(x - c, abs=1e-15)
    # In a quarter turn about Z, x and c are both 0, so the error does not show.


def test_e12_the_printed_turn_by_a_vector_multiplies_by_no_turn_at_all() -> None:
    vector = Z * 0.1
    printed, right, first_order = (
        Quaternion() * Quaternion(0.0, *vector),
        Quaternion(),
        Quaternion(),
    )
    right.rotate_by(vector)
    first_order.add_scaled(vector, 1.0)
    first_order.normalize()
    assert printed == Quaternion(0.0, 0.0, 0.0, 0.1)
    # All known digits.
    assert tuple(right) == pytest.approx((0.99875026, 0.0, 0.0, 0.04997917), abs=5.1e-9)
    assert tuple(first_order) == pytest.approx((0.99875234, 0.0, 0.0, 0.04993762), abs=5.1e-9)
    printed.normalize()
    assert printed.to_axis_angle() == (Z, math.pi)  # half a turn in place of 0.1
    assert right.to_axis_angle()[1] == pytest.approx(0.1, rel=1e-15)  # two roundings


def test_e12_the_printed_side_turns_about_an_axis_of_the_object() -> None:
    """A quarter turn about Z takes X to Y, and another about the world's X takes it to Z."""
    start = Quaternion.from_axis_angle(Z, QUARTER)
    right = start.copy()
    right.rotate_by(X * QUARTER)
    from_the_right = start * Quaternion.from_axis_angle(X, QUARTER)
    assert tuple(right.rotate(X)) == pytest.approx((0.0, 0.0, 1.0), abs=1e-15)
    assert tuple(from_the_right.rotate(X)) == pytest.approx((0.0, 1.0, 0.0), abs=1e-15)


def test_e13_the_printed_inverse_reads_a_sixteenth_number() -> None:
    e, inverse = MATRIX.entries, MATRIX.inverse().entries
    lines = {2: (1, 6, 5, 2), 6: (4, 2, 0, 6), 8: (4, 9, 5, 8), 9: (1, 8, 0, 9), 10: (0, 5, 1, 4)}
    for entry, (p, q, r, s) in lines.items():
        with pytest.raises(IndexError):
            (e[p] * e[q] * e[15] - e[r] * e[s]) / MATRIX.determinant()  # printed in five lines
        dropped = (e[p] * e[q] - e[r] * e[s]) / MATRIX.determinant()
        assert inverse[entry] == pytest.approx(dropped, rel=1e-15)  # one division
    assert inverse[8] == pytest.approx(-1.0 / 6.0, rel=1e-15)


def test_e28_the_printed_determinant_begins_with_the_wrong_sign() -> None:
    a, b, c, _, d, e, f, _, g, h, i, _ = MATRIX
    rest = d * h * c + g * b * f - a * h * f - d * b * i + a * e * i
    printed, right = +g * e * c + rest, -g * e * c + rest
    assert (printed, right, MATRIX.determinant()) == (8.0, 6.0, 6.0)
    assert numpy.linalg.det([(a, b, c), (d, e, f), (g, h, i)]) == pytest.approx(6.0, rel=1e-15)


def write_inverse(into: list[float], of: list[float], determinant: float) -> None:
    """Write the inverse one number at a time, column by column: cofactors over the determinant."""
    for column in range(3):
        c, d = 4 * ((column + 1) % 3), 4 * ((column + 2) % 3)
        for row in range(3):
            a, b = (row + 1) % 3, (row + 2) % 3
            into[4 * row + column] = (of[c + a] * of[d + b] - of[c + b] * of[d + a]) / determinant
    for row in range(0, 12, 4):
        into[row + 3] = -sum(into[row + column] * of[4 * column + 3] for column in range(3))


def error(inverse: Sequence[float]) -> float:
    """Return the largest error in the rotation part of the matrix times its inverse."""
    product = MATRIX @ Matrix4(*inverse)
    nine = [(row, column) for row in range(3) for column in range(3)]
    return max(abs(product[row, column] - (row == column)) for row, column in nine)


def test_e29_the_printed_inverse_divides_by_the_determinant_of_another_matrix() -> None:
    """The matrix that will hold the inverse is the identity: its determinant is 1, not 6."""
    holder = list(IDENTITY)
    write_inverse(holder, [*MATRIX], Matrix4(*holder).determinant())
    assert error(holder) == 5.0  # six times too large
    write_inverse(holder, [*MATRIX], MATRIX.determinant())
    assert error(holder) < 1e-15  # some roundings of thirds and sixths
    assert error([*MATRIX.inverse()]) < 1e-15


def test_e30_the_printed_inverting_in_place_reads_what_it_has_written() -> None:
    numbers, kept = [*MATRIX], [*MATRIX]
    write_inverse(numbers, numbers, MATRIX.determinant())
    write_inverse(kept, [*kept], MATRIX.determinant())  # from a copy
    assert error(numbers) == pytest.approx(1.12, abs=5e-3)
    assert error(kept) < 1e-15  # as above
    before = MATRIX.entries
    assert error([*MATRIX.inverse()]) < 1e-15
    assert MATRIX.entries == before  # a matrix never changes


def test_e31_a_step_of_eq_95_does_not_keep_the_length() -> None:
    by_eq_95, right, h = Quaternion(), Quaternion(), 1.0 / 60.0
    for _ in range(60):
        by_eq_95.add_scaled(Z * math.tau, h)
        right.rotate_by(Z * (math.tau * h))
    assert by_eq_95.magnitude() == pytest.approx(1.0856, abs=5e-5)  # all known digits
    # A few roundings in each of 60 steps.
    assert by_eq_95.magnitude() == pytest.approx((1.0 + (math.pi * h) ** 2) ** 30, rel=1e-14)
    assert first_order_drift(math.tau, 1.0, 60)[0] == pytest.approx(by_eq_95.magnitude(), rel=1e-14)
    assert right.magnitude() == pytest.approx(1.0, abs=1e-14)
    product = Quaternion.from_axis_angle(X, 0.3) * Quaternion.from_axis_angle(Z, 0.4)
    assert product.magnitude() == pytest.approx(1.0, abs=4e-16)  # products conserve the length


def test_e32_a_cut_through_the_center_of_mass_leaves_unequal_masses() -> None:
    """Nine equal triangles: a cut along a row passes through the centroid of the whole."""
    corners = (
        [(x, y, 1) for y in range(3) for x in range(3 - y)]  # upright triangles
        + [(x + 1, y + 1, -1) for y in range(2) for x in range(2 - y)]  # inverted triangles
    )
    assert len(corners) == 9
    small = [("", 1.0, x + way / 3.0, y + way / 3.0) for x, y, way in corners]
    assert center_of_stones(small) == pytest.approx((1.0, 1.0), rel=1e-15)  # of (0,0) (3,0) (0,3)
    # The cuts are parallel to the sides. The opposite corner always has four masses.
    for angle, masses in ((0.0, (4.0, 5.0)), (QUARTER, (5.0, 4.0)), (-math.pi / 4.0, (5.0, 4.0))):
        assert masses_beside(small, angle) == masses
        offset, c, s = balance_offset(small, angle), math.cos(angle), math.sin(angle)
        moment = math.fsum(c * y - s * x - offset for _, _, x, y in small)
        assert moment == pytest.approx(0.0, abs=1e-14)  # balanced, apart from some roundings of 3


def test_e33_three_angles_reach_every_orientation() -> None:
    rows = numpy.random.default_rng(9).normal(size=(1000, 4))
    turns = [Quaternion(*row) for row in rows]
    turns += [euler_to_quaternion(x, QUARTER, 0.5 * x) for x in (-2.0, 0.0, 1.0)]  # in gimbal lock
    for q in turns:
        q.normalize()
        m = Matrix3.from_quaternion(q)
        y = math.atan2(-m[2, 0], math.hypot(m[2, 1], m[2, 2]))
        locked = math.hypot(m[2, 1], m[2, 2]) < 1e-9
        x = 0.0 if locked else math.atan2(m[2, 1], m[2, 2])
        z = math.atan2(-m[0, 1], m[1, 1]) if locked else math.atan2(m[1, 0], m[0, 0])
        reached = Matrix3.from_quaternion(euler_to_quaternion(x, y, z))
        # Roundings of 1, which are distributed over the angles if a cosine is small.
        assert farthest(tuple(reached), tuple(m)) < 1e-13


def test_e33_what_is_singular_is_the_map_of_the_rates() -> None:
    maps = [numpy.reshape([*rate_map(1.0, y, 0.3)], (3, 3)) for y in (1.0, QUARTER)]
    assert [numpy.linalg.matrix_rank(m) for m in maps] == [3, 2]
    one, other = (euler_to_quaternion(1.0 + d, QUARTER, 0.3 + d) for d in (0.0, 0.7))
    assert farthest(tuple(one), tuple(other)) < 1e-15  # two angles change without any rotation
    with pytest.raises(ValueError, match="y must not be a quarter turn"):
        euler_rates(1.0, QUARTER, 0.3, Vector3(1.0, 2.0, 3.0))
