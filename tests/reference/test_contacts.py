"""Bodies at rest stay at rest, alone and in stacks, and the stacks that sink are known."""

from __future__ import annotations

from itertools import pairwise

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0, 0.0)


@pytest.mark.parametrize("off", [-0.9e-6, 0.0, 0.9e-6])
def test_a_normal_within_a_millionth_of_unit_length_is_taken_and_copied(off: float) -> None:
    normal = Vector3(0.6, 0.0, 0.8) * (1.0 + off)
    contact = Contact(Particle(), None, normal)
    assert contact.normal == normal
    assert contact.normal is not normal


@pytest.mark.parametrize("built_in", [True, False])
@pytest.mark.parametrize("c", [0.0, 0.9])
def test_what_rests_stays_for_a_minute(c: float, built_in: bool) -> None:
    """The first frame closes with g h at most, so the ball is stopped, corrected, and stays."""
    ball = Particle(Vector3(0.0, 5e-4), acceleration=UP * (-9.81 if built_in else 0.0))
    registry, ground = ForceRegistry(), GroundPlane([ball], restitution=c)
    if not built_in:
        registry.add(ball, Gravity(UP * -9.81))
    for _ in range(3600):
        semi_implicit_euler([ball], registry.update_forces, FRAME)
        ContactResolver().resolve_contacts(ground.contacts(), FRAME)
        # Each frame corrects the depth, with an error of one rounding of g h^2 = 3 mm.
        assert abs(ball.position.y) <= 1e-18


def test_ten_on_each_other_sink_with_the_default_number_of_iterations() -> None:
    """The default of two iterations per contact does not carry the weight of ten balls."""
    heights, worst = settle(10)
    assert worst > 0.5
    assert heights[-1] < 8.5  # 8.27 was measured, so more than one diameter in ten is lost


def settle(n: int) -> tuple[list[float], float]:
    """Stack balls of 1 m. Return their heights after 10 s, and the largest overlap."""
    balls = [Particle(Vector3(0.0, 0.5 + i), acceleration=UP * -9.81) for i in range(n)]
    both = Detectors(GroundPlane(balls, 0.0, 0.5), ParticlePairs(balls, 0.5))
    worst = 0.0
    for _ in range(600):
        semi_implicit_euler(balls, lambda _: None, FRAME)
        ContactResolver().resolve_contacts(both.contacts(), FRAME)
        heights = [ball.position.y for ball in balls]
        gaps = [heights[0] - 0.5 + 1.0, *(b - a for a, b in pairwise(heights))]
        worst = max(worst, *(1.0 - gap for gap in gaps))
    return heights, worst
