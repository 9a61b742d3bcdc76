"""The exercises of chapter 9 compared with SciPy's rotations, complex numbers and inverses."""

from __future__ import annotations

import math

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.exercises import (
    back_to_reference,
    easy_inverse,
    read_off,
    turned_by_sense,
    turned_by_steps,
    two_other_turns,
)
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.quaternion import Quaternion

CASES = 1000
RANDOM = numpy.random.default_rng(9)
ROWS = RANDOM.normal(size=(CASES, 4))
ROWS /= numpy.linalg.norm(ROWS, axis=1)[:, None]
PLACES, RATES = RANDOM.normal(size=(CASES, 3)), RANDOM.uniform(-3.0, 3.0, CASES)


def theirs(q: Quaternion) -> Rotation:
    return Rotation.from_quat([q.i, q.j, q.k, q.r])


def test_the_two_other_turns_are_the_only_ones_in_steps_of_30_degrees() -> None:
    wanted = Rotation.from_euler("xyz", [90.0, 90.0, 0.0], degrees=True)
    ends = {}
    for a in range(-180, 181, 30):
        for b in range(-180, 181, 30):
            turned = Rotation.from_euler("zx", [a, b], degrees=True)  # extrinsic: Z first
            ends[a, b] = (wanted * turned.inv()).magnitude()
    # The arc cosine or sine of some roundings.
    assert [pair for pair, apart in ends.items() if apart < 1e-7] == [two_other_turns()]


def test_the_turn_back_to_the_reference_undoes_any_orientation() -> None:
    for row in ROWS:
        q = Quaternion(*row)
        axis, angle = back_to_reference(q)
        back = Quaternion.from_axis_angle(axis, angle) * q
        assert abs(back.r) == pytest.approx(1.0, abs=1e-15)  # roundings of four products
        assert math.hypot(back.i, back.j, back.k) < 1e-15
        assert abs(angle) == pytest.approx(theirs(q).magnitude(), abs=4e-15)


def test_a_steady_turn_is_that_of_scipy_and_its_steps_miss_by_what_scipy_says() -> None:
    for row, rate in zip(ROWS, RATES, strict=True):
        q = Quaternion(*row)
        wanted = Rotation.from_rotvec([rate * 2.0, 0.0, 0.0]) * theirs(q)
        right = turned_by_sense(q, rate, 2.0)
        assert (theirs(right) * wanted.inv()).magnitude() < 1e-14  # some roundings of 1
        for steps in (1, 4):
            stepped, error = turned_by_steps(q, rate, 2.0, steps)
            apart = (wanted * theirs(stepped).inv()).magnitude()
            assert error == pytest.approx(apart, abs=1e-14)
            # A step of Eq. 9.5 rotates by twice the arc whose tangent is half of the angle.
            missed = abs(
                math.remainder(2.0 * rate - 2.0 * steps * math.atan(rate / steps), math.tau)
            )
            assert error == pytest.approx(missed, abs=1e-14)


def test_a_rotation_and_a_position_are_read_off_and_inverted_without_dividing() -> None:
    for row, place in zip(ROWS, PLACES, strict=True):
        q, p = Quaternion(*row), Vector3(*place)
        m = Matrix4.from_orientation_and_position(q, p)
        assert read_off(m) == (Matrix3.from_quaternion(q), p)
        # A few roundings of positions within 5 m.
        assert tuple(easy_inverse(m)) == pytest.approx(tuple(m.inverse()), abs=1e-14)
