"""A camera on a spring, against the closed forms of a critically damped spring."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch06_springs.going_further.camera import SpringCamera

FRAME = 1.0 / 60.0


def lag_after(omega: float, velocity: Vector3, seconds: float, late: bool = False) -> Vector3:
    """Return how far the camera is behind a target that starts at the camera's position.

    If ``late`` is true, the target moves before the camera does.
    """
    camera, target = SpringCamera(Vector3(1.0, 2.0, 3.0), omega), Vector3(1.0, 2.0, 3.0)
    for _ in range(round(seconds / FRAME)):
        if late:
            target.add_scaled(velocity, FRAME)
        camera.follow(target, FRAME)
        if not late:
            target.add_scaled(velocity, FRAME)
    return target - camera.body.position


@pytest.mark.parametrize("omega", [2.0, 5.0, 20.0])
def test_the_lag_at_constant_speed_is_twice_the_speed_divided_by_omega(omega: float) -> None:
    velocity = Vector3(3.0, -4.0, 12.0)
    # The start has died out to (1 + 40) e^-40 of the lag. A step adds rounding of about 1e-16.
    lag = lag_after(omega, velocity, 40.0 / omega)
    assert (lag - velocity * (2.0 / omega)).magnitude() < 1e-10
    late = lag_after(omega, velocity, 40.0 / omega, late=True)
    assert (late - velocity * (2.0 / omega - FRAME)).magnitude() < 1e-10


def test_the_camera_reaches_a_target_at_rest_and_never_passes_it() -> None:
    """A critically damped spring that starts at rest is at a (1 + w t) e^(-w t) from its anchor."""
    omega, start = 5.0, 2.0
    errors = []
    for substeps in (1, 2, 4):
        camera, worst = SpringCamera(Vector3(start), omega), 0.0
        for i in range(1, 120 * substeps + 1):
            camera.follow(Vector3(), FRAME / substeps)
            time = i * FRAME / substeps
            exact = start * (1.0 + omega * time) * math.exp(-omega * time)
            worst = max(worst, abs(camera.body.position.x - exact))
            assert camera.body.position.x > 0.0
        errors.append(worst)
    # The method has order 1, so each halving of the step halves the error. Measured: 2.01 and 2.01.
    assert errors[0] < 0.05 * start
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.1)
    assert errors[1] / errors[2] == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize(("share", "stays"), [(0.99, True), (1.01, False)])
def test_a_camera_that_is_too_fast_for_the_step_explodes(share: float, stays: bool) -> None:
    """Semi-implicit Euler is stable for k h^2 + 2 c h < 4, so for omega h < 2 (sqrt(2) - 1)."""
    camera = SpringCamera(Vector3(1.0), share * 2.0 * (math.sqrt(2.0) - 1.0) / FRAME)
    for _ in range(2000):
        camera.follow(Vector3(), FRAME)
    assert (camera.body.position.magnitude() < 1.0) is stays
