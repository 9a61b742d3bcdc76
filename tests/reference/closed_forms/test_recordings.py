"""The recorded motions of chapter 2 are what a camera would see of three known motions."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from ch02_vectors import recordings
from ch02_vectors.vector import Vector3

G = 9.81
K2 = 0.0096  # N s^2/m^2, the drag of the filters
STIFFNESS, DAMPING = 20.0, 0.3  # N/m and N s/m


def ball(t: float) -> tuple[float, float]:
    return 4.0 * t, 1.5 + 6.0 * t - G * t * t / 2.0


def filters(t: float) -> tuple[float, float]:
    u = math.sqrt(recordings.FILTERS_MASS * G / K2)
    return 0.0, 2.0 - u * u / G * math.log(math.cosh(G * t / u))


def weight(t: float) -> tuple[float, float]:
    s = DAMPING / (2.0 * recordings.WEIGHT_MASS)
    w = math.sqrt(STIFFNESS / recordings.WEIGHT_MASS - s * s)
    return 0.0, 0.2 * math.exp(-s * t) * (math.cos(w * t) + s / w * math.sin(w * t))


FILMS = [
    (recordings.thrown_ball, ball, 60, 1),
    (recordings.falling_filters, filters, 60, 1),
    (recordings.weight_on_spring, weight, 30, 4),
]


@pytest.mark.parametrize(("film", "exact", "rate", "seconds"), FILMS)
def test_a_recording_is_the_exact_motion_rounded_to_1_mm(
    film: Callable[[], tuple[list[float], list[Vector3]]],
    exact: Callable[[float], tuple[float, float]],
    rate: int,
    seconds: int,
) -> None:
    times, positions = film()
    assert times == [i / rate for i in range(seconds * rate + 1)]
    for t, p in zip(times, positions, strict=True):
        # No coordinate lies so close to half a millimeter that rounding errors matter.
        assert [p.x, p.y, p.z] == [*(round(1000 * n) / 1000 for n in exact(t)), 0.0]
    positions[0].x = 99.0
    assert film()[1][0].x == 0.0


@pytest.mark.parametrize(("exact", "end"), [(filters, 1.0), (weight, 4.0)])
def test_the_formulas_solve_the_equations_of_motion(
    exact: Callable[[float], tuple[float, float]], end: float
) -> None:
    """Compare m a with the forces, by difference quotients of the formula itself."""
    h = 1e-4
    for i in range(1, 50):
        t = end * i / 50
        before, now, after = (exact(t + k * h)[1] for k in (-1, 0, 1))
        v, a = (after - before) / (2.0 * h), (after - 2.0 * now + before) / h**2
        if exact is filters:
            mass, force = recordings.FILTERS_MASS, -recordings.FILTERS_MASS * G + K2 * v * v
        else:
            mass, force = recordings.WEIGHT_MASS, -STIFFNESS * now - DAMPING * v
        # Second differences of numbers up to 2 have rounding errors of about 2e-16 * 4 / h^2 =
        # 8e-8, and the truncation errors are a h^2 / 12 of the fourth derivative, below 1e-4.
        assert abs(mass * a - force) < 1e-5
