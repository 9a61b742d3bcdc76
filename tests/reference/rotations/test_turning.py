"""Orientations after many steps, and three angles with their rates."""

from __future__ import annotations

import math
from functools import cache

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.euler import euler_rates, rate_map
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion

STEPS, FRAME = 100_000, 1.0 / 60.0
START = Vector3(1.0, -2.0, 0.5)  # rad/s
IDENTITY = numpy.eye(3)


def acceleration(step: int) -> Vector3:
    """Return an angular acceleration in rad/s^2 that moves the axis in all directions."""
    return Vector3(math.sin(0.011 * step), 2.0 * math.cos(0.007 * step), math.sin(0.013 * step + 1))


@cache
def turned_on() -> tuple[Quaternion, Quaternion, numpy.ndarray]:
    """Return the results of 100,000 steps by integrate_rotation and by Eq. 9.5, and the spins."""
    orientation, spin, by_eq_95, spins = Quaternion(), START.copy(), Quaternion(), []
    for step in range(STEPS):
        integrate_rotation(orientation, spin, acceleration(step), FRAME)
        by_eq_95.add_scaled(spin, FRAME)
        spins.append(tuple(spin))
    return orientation, by_eq_95, numpy.array(spins)


def skew(q: Quaternion) -> float:
    """Return the largest entry of R R^T - 1, where R is computed from q without normalizing."""
    r, i, j, k = q
    m = numpy.array(
        [
            [1 - 2 * (j * j + k * k), 2 * (i * j - k * r), 2 * (i * k + j * r)],
            [2 * (i * j + k * r), 1 - 2 * (i * i + k * k), 2 * (j * k - i * r)],
            [2 * (i * k - j * r), 2 * (j * k + i * r), 1 - 2 * (i * i + j * j)],
        ]
    )
    return float(numpy.abs(m @ m.T - IDENTITY).max())


def test_a_hundred_thousand_steps_leave_the_matrix_orthogonal() -> None:
    orientation, by_eq_95, spins = turned_on()
    lengths = numpy.linalg.norm(spins, axis=1)
    assert lengths.min() < 1.5  # so that it varies
    assert lengths.max() > 5.0
    # Because of normalizing, the length is always within two roundings of 1. The matrix has about
    # five more in each entry.
    assert abs(orientation.magnitude() - 1.0) <= 4e-16
    assert skew(orientation) <= 3e-15
    m = Matrix3.from_quaternion(orientation)
    product = numpy.array(tuple(m @ m.transpose())).reshape(3, 3)
    print(f"R R^T - 1 after {STEPS} steps: {numpy.abs(product - IDENTITY).max():.1e}")
    assert numpy.abs(product - IDENTITY).max() <= 3e-15
    # Eq. 9.5 multiplies the length by sqrt(1 + (w h / 2)^2) in every step.
    grown = math.exp(0.5 * numpy.log1p((0.5 * FRAME * lengths) ** 2).sum())
    assert grown > 1e10
    # About four roundings per step, which may add up at most to their sum.
    assert by_eq_95.magnitude() == pytest.approx(grown, rel=STEPS * 2e-16)
    assert skew(by_eq_95) > 1e20
    assert not by_eq_95.is_unit()


def test_a_hundred_thousand_steps_end_where_scipy_does() -> None:
    """SciPy multiplies neighbors in pairs, with the later rotation on the left."""
    orientation, _, spins = turned_on()
    turns = Rotation.from_rotvec(spins * FRAME)
    while len(turns) > 1:
        odd = turns[-1:] if len(turns) % 2 else None
        turns = turns[1::2] * turns[: len(turns) - 1 : 2]
        turns = Rotation.concatenate([turns, odd]) if odd is not None else turns
    x, y, z, w = turns.as_quat()[0]
    apart = min(math.dist(orientation, (s * w, s * x, s * y, s * z)) for s in (1.0, -1.0))
    print(f"orientation after {STEPS} steps: {apart:.1e}")
    # 100,000 steps with roundings of 1e-16 in random directions add up to about 300 of them. If all
    # had the same direction, it would be a thousand times as many.
    assert apart <= 1e-12


def angles_of(seed: int, cases: int) -> list[tuple[float, float, float]]:
    rows = numpy.random.default_rng(seed).uniform(-1.0, 1.0, (cases, 3))
    return [(float(x) * 3.0, float(y) * 1.5, float(z) * 3.0) for x, y, z in rows]


def rows_of(m: Matrix3) -> numpy.ndarray:
    return numpy.array(tuple(m)).reshape(3, 3)


@pytest.mark.parametrize("y", [0.0, 0.5, -1.2, 1.57, math.pi / 2, -math.pi / 2, 2.5])
def test_the_rate_map_has_the_singular_values_of_its_angle(y: float) -> None:
    sine = abs(math.sin(y))
    wanted = sorted((math.sqrt(1.0 + sine), 1.0, math.sqrt(1.0 - sine)), reverse=True)
    for x, _, z in angles_of(9, 100):
        values = numpy.linalg.svd(rows_of(rate_map(x, y, z)), compute_uv=False)
        # Roundings of 1. If 1 - sin y is almost 0, its root has half of the digits.
        assert values[:2] == pytest.approx(wanted[:2], abs=2e-15)
        assert values[2] ** 2 == pytest.approx(wanted[2] ** 2, abs=2e-15)
        assert rate_map(x, y, z).determinant() == pytest.approx(math.cos(y), abs=1e-15)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("degrees", [89.0, 89.9, 89.999, 90.001])
def test_the_rates_are_right_close_to_gimbal_lock(degrees: float, sign: float) -> None:
    y, spin = math.radians(degrees) * sign, Vector3(0.3, -0.5, 0.8)
    for x, _, z in [*angles_of(9, 100), (0.0, 0.0, 0.0), (1.0, 0.0, math.pi / 2)]:
        rates = euler_rates(x, y, z, spin)
        along = math.cos(z) * spin.x + math.sin(z) * spin.y  # about X after the rotation by z
        across = math.cos(z) * spin.y - math.sin(z) * spin.x
        wanted = (along / math.cos(y), across, spin.z + along * math.tan(y))
        # Some dozen roundings. The cosine has few correct digits, but affects both sides equally.
        assert tuple(rates) == pytest.approx(wanted, rel=1e-12, abs=1e-12)
