"""A ground of springs and its failures (E-36), and a bridge on springs and its equilibrium."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import runge_kutta_4, semi_implicit_euler
from ch06_springs.penalty import PenaltyGround
from ch06_springs.spring_bridge import hang_bridge

FRAME = 1.0 / 60.0
GRAVITY = Vector3(0.0, -10.0, 0.0)


def on_ground(
    height: float, speed: float, share: float, damping: float = 0.0
) -> tuple[Particle, ForceRegistry]:
    """Return 2 kg above or in a ground with this fraction as k h^2 / m, and their registry."""
    body = Particle(Vector3(0.0, height), Vector3(0.0, speed), GRAVITY, mass=2.0)
    registry = ForceRegistry()
    registry.add(body, PenaltyGround(0.0, share * 2.0 / FRAME**2, damping))
    return body, registry


# Penalty forces


def test_a_body_on_a_spring_of_a_ground_is_back_after_half_a_turn_and_its_flight() -> None:
    """Short frames give an elastic bounce: m v^2 = k y^2 at the deepest point, equal speeds."""
    body = Particle(Vector3(), Vector3(0.0, -3.0), mass=2.0)
    registry = ForceRegistry()
    registry.add(body, PenaltyGround(0.0, 800.0))
    half_turn = math.pi / 20.0
    for _ in range(200):
        runge_kutta_4([body], registry.update_forces, half_turn / 400.0)
    # After a quarter turn in steps of 0.008 rad of order 4, it is 3 / 20 m deep.
    assert tuple(body.position) == pytest.approx((0.0, -0.15, 0.0), abs=1e-10)
    for _ in range(400):
        runge_kutta_4([body], registry.update_forces, half_turn / 400.0)
    # It leaves after another 200 steps. The step at the surface has an error of 1e-5.
    assert body.velocity.y == pytest.approx(3.0, rel=1e-5)
    assert body.position.y == pytest.approx(3.0 * half_turn / 2.0, rel=1e-4)


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


@pytest.mark.parametrize("share", [2.5, 3.0, 3.9])
def test_e36_a_hard_ground_throws_a_falling_body_well_before_kappa_4(share: float) -> None:
    """After a frame in the ground, almost v h deep, v' = -v + kappa v, if that is upward."""
    speed = 50.0
    body, registry = on_ground(0.001 * speed * FRAME, -speed, share)
    body.acceleration.clear()
    for _ in range(2):
        semi_implicit_euler([body], registry.update_forces, FRAME)
    # It was 0.999 v h deep. The tolerance allows for a few roundings of kappa v.
    assert body.velocity.y == pytest.approx(speed * (0.999 * share - 1.0), rel=1e-13)
    assert body.velocity.y > 1.4 * speed
    assert body.position.y > 0.0


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


def test_e36_short_frames_keep_a_fall_within_the_height_it_came_from() -> None:
    """With kappa 0.0001 there are 22 bounces of 1 m, each with about pi / 0.01 frames in it."""
    frame = FRAME / 30.0
    body = Particle(Vector3(0.0, 1.0), acceleration=GRAVITY, mass=2.0)
    registry = ForceRegistry()
    registry.add(body, PenaltyGround(0.0, 1e-4 * 2.0 / frame**2))
    heights = []
    for _ in range(round(20.0 / frame)):
        semi_implicit_euler([body], registry.update_forces, frame)
        heights.append(body.position.y)
    # The first and last frame of a bounce change the energy by up to kappa / 2 either way.
    assert max(heights) == pytest.approx(1.0, abs=22 * 1e-4 / 2.0)
    assert max(heights[-round(2.0 / frame) :]) == pytest.approx(1.0, abs=22 * 1e-4 / 2.0)


# The bridge


def make_bridge(n: int, damping: float) -> tuple[list[Particle], ForceRegistry]:
    planks = [Particle(Vector3(float(i), 2.0, 0.0), mass=4.0) for i in range(n)]
    registry = ForceRegistry()
    hang_bridge(registry, planks, 3.0, 900.0, damping)
    return planks, registry


def test_a_bridge_hangs_lower_by_its_weight_over_the_stiffness() -> None:
    """Every plank sinks by m g / k, and the springs between planks have no load."""
    for n in (1, 2, 7):
        planks, registry = make_bridge(n, 5.0)
        for plank in planks:
            plank.acceleration = GRAVITY.copy()
            plank.position.y -= 4.0 * 10.0 / 900.0
        registry.update_forces(FRAME)
        for plank in planks:
            # 900 N/m times a few roundings of 5 m.
            assert tuple(plank.force_accumulator) == pytest.approx((0.0, 40.0, 0.0), abs=5e-12)
