"""Quaternions compared with SciPy's rotations, on 2,000 random cases each.

SciPy has the scalar last, so its (x, y, z, w) is our (r, i, j, k) rotated by one position. With
``pytest -s`` every test prints the largest deviation.
"""

from __future__ import annotations

import math
import warnings

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import velocity_of_point
from ch09_rotations.euler import euler_to_quaternion
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion

Array = numpy.ndarray
CASES = 2_000
# The compared values have a size of 1 and about ten roundings of 1e-16. 1e-14 is far above that and
# far below any mistake.
ROUNDINGS = 1e-14


def unit(rows: Array) -> Array:
    return rows / numpy.linalg.norm(rows, axis=1)[:, None]


RANDOM = numpy.random.default_rng(9)
A, B = (unit(RANDOM.normal(size=(CASES, 4))) for _ in "ab")  # r, i, j, k
AXES = RANDOM.normal(size=(CASES, 3)) * 10.0 ** RANDOM.uniform(-3.0, 3.0, (CASES, 1))
VECTORS = RANDOM.normal(size=(CASES, 3))
ANGLES = RANDOM.uniform(-10.0, 10.0, (CASES, 3))
OURS_A, OURS_B = ([Quaternion(*row) for row in rows] for rows in (A, B))
OUR_VECTORS = [Vector3(*v) for v in VECTORS]


def theirs(rows: Array) -> Rotation:
    return Rotation.from_quat(numpy.roll(rows, -1, axis=1))


def components(rotations: Rotation) -> Array:
    return numpy.roll(rotations.as_quat(), 1, axis=1)


def deviation(what: str, got: object, wanted: Array, *, signed: bool = True) -> float:
    """Return and print the largest deviation, or NaN. If unsigned, q and -q count as equal."""
    rows = numpy.array([tuple(row) for row in got])
    assert rows.shape == wanted.shape
    if not signed:
        rows = rows * numpy.where((rows * wanted).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    largest = float(numpy.abs(rows - wanted).max())
    print(f"{what}: {largest:.1e} in {len(rows)} cases")
    return largest


def test_the_product_agrees_with_scipy() -> None:
    wanted = components(theirs(A) * theirs(B))
    got = [a * b for a, b in zip(OURS_A, OURS_B, strict=True)]
    assert deviation("product", got, wanted) <= ROUNDINGS


def test_the_conjugate_agrees_with_scipy() -> None:
    # SciPy returns the inverse, possibly with the opposite sign.
    wanted = components(theirs(A).inv())
    assert deviation("conjugate", [a.conjugate() for a in OURS_A], wanted, signed=False) <= 1e-15


def test_a_turned_vector_agrees_with_scipy() -> None:
    got = [a.rotate(v) for a, v in zip(OURS_A, OUR_VECTORS, strict=True)]
    assert deviation("rotate", got, theirs(A).apply(VECTORS)) <= ROUNDINGS


def test_an_axis_of_any_length_and_an_angle_agree_with_scipy() -> None:
    angles = ANGLES[:, 0]
    wanted = components(Rotation.from_rotvec(unit(AXES) * angles[:, None]))
    got = [
        Quaternion.from_axis_angle(Vector3(*axis), float(angle))
        for axis, angle in zip(AXES, angles, strict=True)
    ]
    assert deviation("from_axis_angle", got, wanted, signed=False) <= ROUNDINGS


def test_the_sign_of_a_quaternion_is_that_of_half_the_angle() -> None:
    """From 0 to 4 pi it goes from 1 to -1 and back, which SciPy's sign does not do."""
    for angle in numpy.linspace(0.0, 4.0 * math.pi, 1000):
        q = Quaternion.from_axis_angle(Vector3(0.0, 3.0, 4.0), float(angle))
        sine = math.sin(angle / 2.0)
        wanted = (math.cos(angle / 2.0), 0.0, 0.6 * sine, 0.8 * sine)
        assert tuple(q) == pytest.approx(wanted, abs=2e-16)  # two roundings


def test_axis_and_angle_are_those_of_scipy() -> None:
    wanted = theirs(A).as_rotvec()
    pairs = [a.to_axis_angle() for a in OURS_A]
    assert deviation("to_axis_angle", [axis * angle for axis, angle in pairs], wanted) <= ROUNDINGS
    assert all(0.0 <= angle <= math.pi for _, angle in pairs)
    lengths = [axis.magnitude() for axis, _ in pairs]
    assert lengths == pytest.approx([1.0] * CASES, abs=4e-16)  # each has a division and a rounding


def near_half_turns() -> Array:
    """Return 2,000 half turns, and turns that miss them by 1e-1 to 1e-15 on both sides."""
    missing = numpy.concatenate([[0.0], 10.0 ** -numpy.arange(1.0, 16.0)])
    angles = math.pi + numpy.resize(numpy.concatenate([missing, -missing]), CASES)
    return numpy.column_stack(
        [numpy.cos(angles / 2.0), unit(AXES) * numpy.sin(angles / 2.0)[:, None]]
    )


def test_the_axis_of_a_half_turn_or_nearly_one_is_right_but_for_its_sign() -> None:
    rows = near_half_turns()
    pairs = [Quaternion(*row).to_axis_angle() for row in rows]
    back = [(math.cos(t / 2.0), *(u * math.sin(t / 2.0))) for u, t in pairs]
    assert deviation("to_axis_angle at half-turns", back, rows, signed=False) <= ROUNDINGS
    assert all(0.0 <= angle <= math.pi for _, angle in pairs)


def test_the_matrix_of_a_quaternion_agrees_with_scipy() -> None:
    wanted = theirs(A).as_matrix().reshape(CASES, 9)
    got = [Matrix3.from_quaternion(a) for a in OURS_A]
    assert deviation("from_quaternion", got, wanted) <= ROUNDINGS


def matrices(rows: Array) -> list[Matrix3]:
    return [Matrix3(*m.ravel()) for m in theirs(rows).as_matrix()]


def test_the_quaternion_of_a_matrix_agrees_with_scipy_in_all_four_branches() -> None:
    largest = numpy.abs(A).argmax(axis=1)
    assert numpy.bincount(largest, minlength=4).min() > 400  # about a quarter for each component
    got = [m.to_quaternion() for m in matrices(A)]
    assert deviation("to_quaternion", got, A, signed=False) <= ROUNDINGS
    assert all(abs(q.magnitude() - 1.0) <= 4e-16 for q in got)  # a division and a rounding each


def test_the_quaternion_of_a_half_turn_is_right_where_r_is_rounding_alone() -> None:
    rows = near_half_turns()
    assert numpy.bincount(numpy.abs(rows[:, 1:]).argmax(axis=1), minlength=3).min() > 400
    assert (numpy.abs(rows[:, 0]) < 1e-8).sum() > 800
    got = [m.to_quaternion() for m in matrices(rows)]
    assert deviation("to_quaternion at half-turns", got, rows, signed=False) <= ROUNDINGS


@pytest.mark.parametrize("component", range(4), ids=["r", "i", "j", "k"])
def test_one_component_alone_comes_back_exactly(component: int) -> None:
    q = Quaternion(*(float(place == component) for place in range(4)))
    assert Matrix3.from_quaternion(q).to_quaternion() == q


def test_a_turn_by_a_scaled_axis_is_about_axes_of_the_world() -> None:
    """Lengths are 1e-9 to 20 radians. SciPy's product also has the later rotation on the left."""
    lengths = numpy.concatenate([10.0 ** RANDOM.uniform(-9.0, 0.0, CASES // 2), ANGLES[::2, 0] * 2])
    scaled = unit(AXES) * lengths[:, None]
    got = [a.copy() for a in OURS_A]
    for q, vector in zip(got, scaled, strict=True):
        q.rotate_by(Vector3(*vector))
    wanted = components(Rotation.from_rotvec(scaled) * theirs(A))
    assert deviation("rotate_by", got, wanted, signed=False) <= ROUNDINGS
    other = components(theirs(A) * Rotation.from_rotvec(scaled))  # about the object's own axes
    assert deviation("the other order", got, other, signed=False) > 1.0


def test_a_step_of_eq_95_adds_half_the_product_with_the_vector_on_the_left() -> None:
    """This holds for any vector and scale, and any orientation, not only the reference."""
    scales = ANGLES[:, 1]
    got = [a.copy() for a in OURS_A]
    for q, v, scale in zip(got, OUR_VECTORS, scales, strict=True):
        q.add_scaled(v, float(scale))
    pure = numpy.column_stack([numpy.zeros(CASES), unit(VECTORS)])
    lengths = numpy.linalg.norm(VECTORS, axis=1)
    wanted = A + components(theirs(pure) * theirs(A)) * (0.5 * scales * lengths)[:, None]
    size = 1.0 + 0.5 * numpy.abs(scales) * lengths  # SciPy requires length 1, so scale afterwards
    relative = [numpy.array(tuple(q)) / s for q, s in zip(got, size, strict=True)]
    assert deviation("add_scaled", relative, wanted / size[:, None]) <= ROUNDINGS


def test_three_angles_are_about_axes_of_the_world_x_first() -> None:
    wanted = components(Rotation.from_euler("xyz", ANGLES))  # lower case: extrinsic
    got = [euler_to_quaternion(*(float(angle) for angle in row)) for row in ANGLES]
    assert deviation("euler_to_quaternion", got, wanted, signed=False) <= ROUNDINGS


def test_every_orientation_is_reached_by_three_angles() -> None:
    """SciPy finds the angles for E-33. The last hundred are in gimbal lock."""
    locked = Rotation.from_euler("xyz", [(x, math.pi / 2, z) for x, _, z in ANGLES[:100]])
    rows = numpy.concatenate([A, components(locked)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # SciPy warns and sets one angle to 0
        angles = theirs(rows).as_euler("xyz")
    got = [euler_to_quaternion(*(float(angle) for angle in row)) for row in angles]
    assert deviation("Euler angles of SciPy", got[:CASES], A, signed=False) <= ROUNDINGS
    assert deviation("in gimbal lock", got[CASES:], rows[CASES:], signed=False) <= ROUNDINGS


def test_the_velocity_of_a_point_agrees_with_numpy() -> None:
    points, turning = AXES[::-1], VECTORS * 10.0
    wanted = VECTORS + numpy.cross(turning, points - AXES)
    got = [
        velocity_of_point(Vector3(*point), Vector3(*position), velocity, Vector3(*spin))
        for point, position, velocity, spin in zip(points, AXES, OUR_VECTORS, turning, strict=True)
    ]
    # Each of about eight roundings is relative to the arm times the angular velocity.
    size = numpy.linalg.norm(turning, axis=1) * numpy.linalg.norm(points - AXES, axis=1)
    size = (size + numpy.linalg.norm(VECTORS, axis=1))[:, None]
    relative = [tuple(v) / s for v, s in zip(got, size, strict=True)]
    assert deviation("velocity_of_point", relative, wanted / size) <= 1e-15
