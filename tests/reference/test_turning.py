"""Orientations after many steps, and three angles with their rates."""

from __future__ import annotations

import math
from functools import cache

import numpy
import pytest
from scipy.spatial.transform import Rotation

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift, integrate_rotation
from ch09_rotations.euler import euler_rates, euler_to_quaternion, rate_map
from ch09_rotations.matrix import SINGULAR, Matrix3
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
    with pytest.raises(ValueError, match="q must have length 1"):
        Matrix3.from_quaternion(by_eq_95)


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


def test_the_angular_velocity_is_moved_on_before_the_orientation() -> None:
    _, _, spins = turned_on()
    total = numpy.array(tuple(START)) + FRAME * numpy.sum(
        [tuple(acceleration(step)) for step in range(STEPS)], axis=0
    )
    assert spins[-1] == pytest.approx(total, abs=1e-9)  # 100,000 roundings of some rad/s
    assert tuple(spins[0]) == tuple(START + acceleration(0) * FRAME)


@pytest.mark.parametrize("steps", [1, 7, 1000])
def test_a_steady_turn_is_exact_in_any_number_of_steps(steps: int) -> None:
    q, spin = Quaternion(), Vector3(0.3, -0.5, 0.8)
    for _ in range(steps):
        integrate_rotation(q, spin, Vector3(), 2.0 / steps)
    wanted = (0.54873208, 0.25334573, -0.42224289, 0.67558862)
    assert tuple(q) == pytest.approx(wanted, abs=5.1e-9)  # all known digits
    speed = math.sqrt(0.98)  # the closed form has more digits
    shares = [component / speed * math.sin(speed) for component in spin]
    # A rounding or two per step.
    assert tuple(q) == pytest.approx((math.cos(speed), *shares), abs=1e-15 * (1 + steps / 10))
    assert spin == Vector3(0.3, -0.5, 0.8)


def test_the_turn_of_a_known_axis_and_angle() -> None:
    wanted = (0.82533561, 0.15090705, 0.30181410, 0.45272115)
    q = Quaternion.from_axis_angle(Vector3(1.0, 2.0, 3.0), 1.2)
    assert tuple(q) == pytest.approx(wanted, abs=5.1e-9)


@pytest.mark.parametrize("steps", [1, 10, 300])
def test_an_acceleration_about_one_axis_has_a_closed_form(steps: int) -> None:
    """The step is semi-implicit, so n steps rotate by w n h + alpha h^2 n (n + 1) / 2."""
    axis, speed, gain, h = Vector3(2.0, -1.0, 2.0) / 3.0, 0.7, -0.4, 0.01
    q, spin = Quaternion(), axis * speed
    for _ in range(steps):
        integrate_rotation(q, spin, axis * gain, h)
    angle = speed * steps * h + gain * h * h * steps * (steps + 1) / 2.0
    wanted = Quaternion.from_axis_angle(axis, angle)
    assert tuple(q) == pytest.approx(tuple(wanted), abs=1e-15 * (1 + steps / 10))  # as above
    assert tuple(spin) == pytest.approx(tuple(axis * (speed + gain * h * steps)), abs=1e-14)
    explicit = angle - gain * h * h * steps  # with the old angular velocity in each step
    assert abs(explicit - angle) > 1e-5


@pytest.mark.parametrize(
    ("speed", "duration", "steps"), [(2 * math.pi, 1.0, 60), (-3.0, 2.0, 5), (0.0, 1.0, 3)]
)
def test_the_drift_of_eq_95_is_what_its_steps_do(speed: float, duration: float, steps: int) -> None:
    q, angle = Quaternion(), 0.0
    for _ in range(steps):
        before = q.copy()
        q.add_scaled(Vector3(0.0, 0.6, 0.8) * speed, duration / steps)
        turned = q * before.conjugate()
        angle += 2.0 * math.atan2(0.6 * turned.j + 0.8 * turned.k, turned.r)
    length, lacking = first_order_drift(speed, duration, steps)
    assert length == pytest.approx(q.magnitude(), rel=1e-14)  # a few roundings per step
    assert lacking == pytest.approx(speed * duration - angle, abs=1e-13)


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


def test_the_rates_of_the_angles_make_the_angular_velocity() -> None:
    """By central differences, the velocity is twice the vector part of q' q*."""
    apart, tiny = 0.0, 1e-5
    for angles, rates in zip(angles_of(9, 300), angles_of(10, 300), strict=True):
        ahead, behind = (
            euler_to_quaternion(*(a + way * tiny * r for a, r in zip(angles, rates, strict=True)))
            for way in (1.0, -1.0)
        )
        slope = Quaternion(*((p - q) / (2.0 * tiny) for p, q in zip(ahead, behind, strict=True)))
        turning = slope * euler_to_quaternion(*angles).conjugate()
        wanted = Vector3(turning.i, turning.j, turning.k) * 2.0
        apart = max(apart, math.dist(rate_map(*angles) @ Vector3(*rates), wanted))
        back = euler_rates(*angles, rate_map(*angles) @ Vector3(*rates))
        # Roundings of rates of about 5 rad/s, over cos 1.5 = 0.07, as often as the map is squared.
        assert tuple(back) == pytest.approx(rates, abs=1e-12)
    # Third order: (5 tiny)^2 = 2.5e-9 times 5 / 6, plus roundings of 1e-16 / tiny = 1e-11.
    assert apart <= 5e-9


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


@pytest.mark.parametrize(
    "y", [math.pi / 2, -math.pi / 2, 3 * math.pi / 2], ids=["90", "-90", "270"]
)
# At 0, 90 and 180 degrees a row of the map is as small as its determinant, and so is the product of
# lengths with which inverse() compares the determinant.
@pytest.mark.parametrize("z", [0.3, -1.0, 0.01, 1e-5, 0.0, math.pi / 2, math.pi])
def test_there_are_no_rates_in_gimbal_lock(y: float, z: float) -> None:
    for x in (0.0, 1.0):
        with pytest.raises(ValueError, match=f"y must not be a quarter turn .*, got {y!r}"):
            euler_rates(x, y, z, Vector3(0.3, -0.5, 0.8))


@pytest.mark.parametrize("z", [0.3, 0.0, math.pi / 2])
def test_gimbal_lock_ends_where_the_cosine_is_above_its_limit(z: float) -> None:
    spin = Vector3(0.3, -0.5, 0.8)
    with pytest.raises(ValueError, match="y must not be a quarter turn"):
        euler_rates(0.0, math.acos(0.9 * SINGULAR), z, spin)
    y = math.acos(1.1 * SINGULAR)
    rate = (math.cos(z) * spin.x + math.sin(z) * spin.y) / math.cos(y)
    # The cosine is 1e-13, and the numerator has a rounding or two.
    assert euler_rates(0.0, y, z, spin).x == pytest.approx(rate, rel=1e-14)
