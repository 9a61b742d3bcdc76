"""Methods that need no small steps: exact frames, and a ball computed from its impacts alone."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch07_constraints.going_further.bouncing_ball import heights_in_frames
from studies.models.exact_frames import places_in_frames


@pytest.mark.parametrize("damping", [0.3, 0.99, 1.0])
def test_frames_are_on_the_exact_path(damping: float) -> None:
    ball = Particle(Vector3(1.0, 2.0), Vector3(3.0, 8.0), Vector3(0.5, -9.81), damping=damping)
    k = -math.log(damping)
    for number, (x, y) in enumerate(places_in_frames(ball, 0.05, 40), 1):
        t = 0.05 * number
        gone = -math.expm1(-k * t) / k if k else t
        # The series of (t - gone) / k, because the formula loses digits for a small k.
        fallen = sum((-k) ** n * t ** (n + 2) / math.factorial(n + 2) for n in range(40))
        # 40 roundings of numbers up to 20.
        assert x == pytest.approx(1.0 + 3.0 * gone + 0.5 * fallen, abs=1e-12)
        assert y == pytest.approx(2.0 + 8.0 * gone - 9.81 * fallen, abs=1e-12)
    assert tuple(ball.position) == (1.0, 2.0, 0.0)


def test_what_cannot_be_moved_stays() -> None:
    wall = Particle(Vector3(1.0, 2.0), Vector3(3.0), mass=math.inf)
    assert places_in_frames(wall, 0.1, 3) == [(1.0, 2.0)] * 3


def test_a_ball_comes_to_rest_when_all_its_bounces_are_over() -> None:
    """The end sqrt(2 h / g) (1 + e) / (1 - e) is 1.89736660 s for h = 2, g = 10 and e = 0.5."""
    heights = heights_in_frames(2.0, 0.0, 0.5, 1e-4, 18_980, gravity=10.0)
    top = max(heights[13_000:15_000])  # of the second bounce, with a quarter of the speed
    assert top == pytest.approx(2.0 / 16.0, abs=1e-7)
    assert heights[18_970 - 1] > 0.0
    assert heights[18_974:] == [0.0] * (18_980 - 18_974)
    assert min(heights) >= -1e-12


def test_a_ball_without_loss_bounces_on_and_one_with_all_lost_lies_still() -> None:
    first = math.sqrt(2.0 * 2.0 / 10.0)
    # At the top after each 2 * first. There are twenty roundings of times up to 13 s at speed 0.
    heights = heights_in_frames(2.0, 0.0, 1.0, 2.0 * first, 10, gravity=10.0)
    assert heights == pytest.approx([2.0] * 10, abs=1e-12)
    assert heights_in_frames(2.0, 0.0, 0.0, 1.0, 3) == [0.0] * 3
    # Thrown down at 3 m/s from the ground, it bounces at once and leaves at 1.5 m/s.
    assert heights_in_frames(0.0, -3.0, 0.5, 0.1, 1, gravity=10.0) == pytest.approx([0.1])


def test_frames_that_last_for_ever_are_refused() -> None:
    with pytest.raises(ValueError, match="the time of all frames must be finite"):
        heights_in_frames(1.0, 0.0, 0.5, 1e308, 2)
