"""Nets against closed forms, DirectChain and SciPy: lengths, orders, and which cables pull."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits
from plots.drawing import slope
from scenes.links import Strut
from studies.accuracy.catalog import scenes_with
from studies.models.direct_net import DirectNet
from studies.models.elimination import Elimination
from studies.models.smooth_net import SmoothNet, hermite

DOWN = Vector3(0.0, -10.0)
H = 1.0 / 240.0  # s
KINDS = [DirectNet, SmoothNet]
Make = Callable[[list[Any]], Any]


def test_elimination_refuses_a_singular_matrix() -> None:
    with pytest.raises(ArithmeticError, match="equation 0 has no unique solution"):
        Elimination(1, []).factor([0.0])


@pytest.mark.parametrize("kind", KINDS)
def test_a_slack_cable_lets_fall_and_then_stops_what_falls(kind: Make) -> None:
    """1 kg and 3 kg one above the other: the cable between them is slack until the upper stops."""
    upper = Particle(Vector3(), acceleration=DOWN)
    lower = Particle(Vector3(0.0, -0.5), acceleration=DOWN, mass=3.0)
    net = kind([AnchoredCable(upper, Vector3(0.0, 1.0), 1.8), Cable(upper, lower, 1.0)])
    for _ in range(48):  # 0.2 s: it has fallen 0.2 m, and no cable is taut
        net.step(H)
    assert upper.position.y == pytest.approx(-0.2, abs=1e-9)
    assert lower.position.y == pytest.approx(-0.7, abs=1e-9)
    for _ in range(192):
        net.step(H)
    assert upper.position.y == pytest.approx(-0.8, abs=1e-9)
    assert lower.position.y == pytest.approx(-1.8, abs=1e-9)
    assert lower.velocity.magnitude() < 0.03  # DirectNet has it half a step earlier


@pytest.mark.parametrize("kind", KINDS)
def test_a_jerk_keeps_momentum_and_ends_at_one_speed(kind: Make) -> None:
    """Without bounce two bodies on a cable go on together: (1 * 4 + 3 * 0) / 4 = 1 m/s."""
    still, fast = Particle(mass=3.0), Particle(Vector3(0.5), Vector3(4.0))
    net = kind([Cable(still, fast, 1.0)])
    for _ in range(60):
        net.step(H)
    assert still.velocity.x == pytest.approx(1.0, rel=1e-9)
    assert fast.velocity.x == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_a_strut_pushes_and_does_not_pull(kind: Make) -> None:
    ball, knot = Particle(Vector3(0.0, 1.0), Vector3(0.0, -2.0)), Particle()
    net = kind([Strut(ball, knot, 0.5)])
    for _ in range(120):
        net.step(H)
    assert (ball.velocity.y, knot.velocity.y) == pytest.approx((-1.0, -1.0), rel=1e-9)
    ball.velocity.y = 3.0
    net.step(H)
    assert (ball.velocity.y, knot.velocity.y) == pytest.approx((3.0, -1.0), rel=1e-9)


@pytest.mark.parametrize(("model", "order"), [("direct net", 2), ("smooth net, order 4", 4)])
def test_swinging_errors_fall_by_the_order(model: str, order: int) -> None:
    (scene,) = scenes_with("swinging")
    run = next(one for one in scene.models if one.name == model).run
    errors = [scene.error(run(steps)) for steps in (1, 2)]
    assert slope([1.0, 0.5], errors) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize(
    ("name", "apart"), [("swinging", 1e-10), ("walked", 1e-8), ("6 by 6", 1e-6)]
)
def test_scipy_finds_the_same_motion_from_the_equations(name: str, apart: float) -> None:
    (scene,) = scenes_with(name)
    assert scene.differs is not None
    assert scene.differs() < apart


def test_redundant_cables_share_a_pull() -> None:
    weight = Particle(Vector3(0.0, -1.0), acceleration=DOWN)
    net = DirectNet([AnchoredCable(weight, Vector3(), 1.0) for _ in range(3)])
    for _ in range(10):
        net.step(H)
    assert net.tensions == pytest.approx([10.0 / 3.0] * 3, rel=1e-5)


def test_damping_is_a_drag() -> None:
    body = Particle(Vector3(), Vector3(2.0), damping=0.5)
    other = Particle(Vector3(0.0, 1.0))
    net = SmoothNet([Limits(body, other, 0.0, 9.0)])
    for _ in range(60):
        net.step(1.0 / 60.0)
    assert body.velocity.x == pytest.approx(1.0, rel=1e-9)
    assert body.position.x == pytest.approx(1.0 / math.log(2.0), rel=1e-9)


def test_a_cubic_is_exact_for_a_cubic() -> None:
    assert hermite([0.0], [0.0], [8.0], [12.0], 2.0, 0.25) == pytest.approx([0.125])


def test_lengths_that_contradict_each_other_are_an_arithmetic_error() -> None:
    weight = Particle(Vector3(0.0, -1.0), acceleration=DOWN)
    rods = [AnchoredRod(weight, Vector3(), 1.0), AnchoredRod(weight, Vector3(0.0, -3.0), 1.0)]
    with pytest.raises(ArithmeticError):
        DirectNet(rods).step(H)
