"""Orientations after many steps."""

from __future__ import annotations

import math

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion

STEPS, FRAME = 100_000, 1.0 / 60.0
START = Vector3(1.0, -2.0, 0.5)  # rad/s


def acceleration(step: int) -> Vector3:
    """Return an angular acceleration in rad/s^2 that moves the axis in all directions."""
    return Vector3(math.sin(0.011 * step), 2.0 * math.cos(0.007 * step), math.sin(0.013 * step + 1))


def test_a_hundred_thousand_steps_end_where_scipy_does() -> None:
    """SciPy multiplies neighbors in pairs, with the later rotation on the left."""
    orientation, spin, by_eq_95, spins = Quaternion(), START.copy(), Quaternion(), []
    for step in range(STEPS):
        integrate_rotation(orientation, spin, acceleration(step), FRAME)
        by_eq_95.add_scaled(spin, FRAME)
        spins.append(tuple(spin))
    turns = Rotation.from_rotvec(numpy.array(spins) * FRAME)
    while len(turns) > 1:
        odd = turns[-1:] if len(turns) % 2 else None
        turns = turns[1::2] * turns[: len(turns) - 1 : 2]
        turns = Rotation.concatenate([turns, odd]) if odd is not None else turns
    x, y, z, w = turns.as_quat()[0]
    apart = min(math.dist(orientation, (s * w, s * x, s * y, s * z)) for s in (1.0, -1.0))
    # 100,000 steps with roundings of 1e-16 in random directions add up to about 300 of them. If all
    # had the same direction, it would be a thousand times as many.
    assert apart <= 1e-12
    # Because of normalizing, the length is always within two roundings of 1. The matrix has about
    # five more in each entry.
    assert abs(orientation.magnitude() - 1.0) <= 4e-16
    m = numpy.array([*Matrix3.from_quaternion(orientation)]).reshape(3, 3)
    assert numpy.abs(m @ m.T - numpy.eye(3)).max() <= 3e-15
    # Eq. 9.5 multiplies the length by sqrt(1 + (w h / 2)^2) in every step.
    lengths = numpy.linalg.norm(spins, axis=1)
    grown = math.exp(0.5 * numpy.log1p((0.5 * FRAME * lengths) ** 2).sum())
    assert grown > 1e10
    # About four roundings per step, which may add up at most to their sum.
    assert by_eq_95.magnitude() == pytest.approx(grown, rel=STEPS * 2e-16)
