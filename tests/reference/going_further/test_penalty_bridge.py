"""How a ground of springs fails, as erratum E-36 says."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.penalty import PenaltyGround

FRAME = 1.0 / 60.0
GRAVITY = Vector3(0.0, -10.0, 0.0)


def on_ground(height: float, speed: float, share: float) -> tuple[Particle, ForceRegistry]:
    """Return 2 kg above or in a ground with this fraction as k h^2 / m, and their registry."""
    body = Particle(Vector3(0.0, height), Vector3(0.0, speed), GRAVITY, mass=2.0)
    registry = ForceRegistry()
    registry.add(body, PenaltyGround(0.0, share * 2.0 / FRAME**2))
    return body, registry


@pytest.mark.parametrize(("share", "wanted"), [(0.98, "lies"), (1.02, "is thrown")])
def test_e36_a_body_at_rest_on_a_hard_ground_is_thrown_beyond_kappa_4(
    share: float, wanted: str
) -> None:
    """Released 1 % too deep, it stays in the ground at 0.98 of the limit, but not at 1.02."""
    depth = 10.0 * FRAME**2 / (4.0 * share)
    body, registry = on_ground(-1.01 * depth, 0.0, 4.0 * share)
    highest = -math.inf
    for _ in range(20_000):
        semi_implicit_euler([body], registry.update_forces, FRAME)
        highest = max(highest, body.position.y)
    # Below the limit, the oscillation may grow by the root of 1 / (1 - 0.98), about 7, of the 1 %.
    assert (highest < -0.9 * depth) is (wanted == "lies")
    # Above it, it grows by 1.33 per step until the body leaves the ground and flies.
    assert (highest > 1000.0 * depth) is (wanted == "is thrown")


@pytest.mark.parametrize("share", [0.1, 0.5, 1.5, 3.0])
def test_e36_a_ground_throws_no_faster_than_its_step_allows(share: float) -> None:
    """With w = v h, w^2 + kappa x^2 - kappa x w is constant. It enters and exits near 0."""
    speed, fastest = 3.0, 0.0
    for part in range(1, 200):
        body, registry = on_ground(part / 200.0 * speed * FRAME, -speed, share)
        body.acceleration.clear()
        for _ in range(1000):
            semi_implicit_euler([body], registry.update_forces, FRAME)
            if body.position.y > 0.0:
                break
        assert body.position.y > 0.0
        fastest = max(fastest, body.velocity.y / speed)
    known = {0.1: 1.0049, 0.5: 1.0625, 1.5: 1.25, 3.0: 2.0}[share]  # found by the same search
    assert fastest == pytest.approx(known, abs=0.02)
    assert fastest <= 1.0 / math.sqrt(1.0 - share / 4.0) + 1e-12
