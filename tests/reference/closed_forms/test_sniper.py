"""The sniper range: the effect of the wind on a bullet, and rounds that always end."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.sniper import MUZZLE_SPEED, SHOTS, SWING, TARGETS, SniperRange

angle = st.floats(-SWING, SWING)


@given(st.integers(), st.lists(st.tuples(angle, angle), min_size=SHOTS, max_size=SHOTS))
def test_every_round_ends(seed: int, aims: list[tuple[float, float]]) -> None:
    at = SniperRange(seed)
    for aim in aims:
        assert at.shoot(*aim)
        for _ in range(60 * 8):
            at.update(1.0 / 60.0)
            if at.bullet is None:
                break
        assert at.bullet is None, "eight seconds are enough for every shot"
    assert at.is_over()
    assert at.score == sum(hole.points for hole in at.holes)
    assert not at.shoot(0.0, 0.0)


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


@pytest.mark.parametrize("frame", [1.0 / 240.0, 1.0 / 60.0, 1.0 / 20.0])
def test_no_frame_is_too_long_for_a_target(frame: float) -> None:
    for target in TARGETS:
        at = SniperRange(1)
        at.wind.k1 = at.wind.k2 = 0.0
        time = math.hypot(target.x, target.distance) / MUZZLE_SPEED
        rise = time * time  # g t^2 / 2 with g = 2 m/s^2
        at.shoot(
            math.atan2(target.x, target.distance),
            math.atan2(rise, math.hypot(target.x, target.distance)),
        )
        while at.bullet is not None:
            at.update(frame)
        (hole,) = at.holes
        assert hole.target == target
        # The step falls short by g t h / 2, which is 0.083 m in the longest frames.
        assert math.hypot(hole.x, hole.y) < 0.1
