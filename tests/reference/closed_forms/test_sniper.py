"""The effect of the wind on a bullet of the sniper range, against its closed form."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.sniper import MUZZLE_SPEED, SniperRange


def test_the_wind_carries_as_far_as_it_goes_in_the_time_that_the_drag_costs() -> None:
    """With linear drag x = w (t - z / v0) is exact. The error of the step has order 1."""
    errors = []
    for frame in (1.0 / 240.0, 1.0 / 480.0):
        at = SniperRange(1)
        at.wind.k1, at.wind.k2 = 0.2, 0.0
        at.wind.velocity = Vector3(10.0, 0.0, 0.0)
        at.shoot(0.0, 0.0)
        for _ in range(round(0.75 / frame)):
            at.update(frame)
        assert at.bullet is not None
        drift = 10.0 * (1.0 - math.exp(-0.2 * 0.75)) / 0.2  # the path under such drag
        exact = 10.0 * 0.75 - drift
        errors.append(at.bullet.position.x - exact)
        # z has the same relative error, so the rule also holds for the step.
        z = at.bullet.position.z
        assert at.bullet.position.x == pytest.approx(10.0 * (0.75 - z / MUZZLE_SPEED), rel=1e-12)
    assert errors[0] / errors[1] == pytest.approx(2.0, abs=0.01)
