"""Forces compared with pymunk: drag, and gravity toward a point, in the plane."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pymunk
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceGenerator, InverseSquareGravity, PointGravity
from ch05_forces.particle import Particle

FRAMES = (1.0 / 240.0, 1.0 / 60.0, 1.0 / 15.0)
MASS = 2.0
START, MOTION, DOWN = (3.0, 1.0), (-4.0, 6.0), (0.0, -9.81)
State = tuple[float, float, float, float]


def ours(generator: ForceGenerator, gravity: tuple[float, float], h: float, n: int) -> list[State]:
    """Return the state after every frame. As in the registry, forces come before the step."""
    particle = Particle(Vector3(*START), Vector3(*MOTION), Vector3(*gravity), mass=MASS)
    seen = []
    for _ in range(n):
        generator.update_force(particle, h)
        particle.integrate(h)
        p, v = particle.position, particle.velocity
        seen.append((p.x, p.y, v.x, v.y))
    return seen


def theirs(
    gravity: tuple[float, float],
    h: float,
    n: int,
    *,
    before: Callable[[Any], None] = lambda _: None,
    velocity: Callable[[Any, Any, float, float], None] | None = None,
) -> list[State]:
    """Return a body's state after every frame. ``before`` is called before each step."""
    space = pymunk.Space()
    space.gravity = gravity
    body = pymunk.Body(MASS, 1.0)
    body.position, body.velocity = START, MOTION
    if velocity is not None:
        body.velocity_func = velocity
    space.add(body)
    seen = []
    for _ in range(n):
        before(body)
        space.step(h)
        seen.append((*body.position, *body.velocity))
    return seen


def expect_equal(first: list[State], second: list[State], tolerance: float) -> None:
    for one, other in zip(first, second, strict=True):
        assert one == pytest.approx(other, abs=tolerance)


@pytest.mark.parametrize("h", FRAMES)
@pytest.mark.parametrize(("k1", "k2"), [(0.8, 0.0), (0.0, 0.1), (0.8, 0.1)])
def test_drag_as_a_velocity_function_is_our_drag_step_for_step(
    h: float, k1: float, k2: float
) -> None:
    """Pymunk moves first and then updates the velocity, so drag uses only the old velocity."""

    def velocity(body: Any, gravity: Any, damping: float, dt: float) -> None:
        v = body.velocity
        drag = -v * (k1 + k2 * v.length) / body.mass
        pymunk.Body.update_velocity(body, gravity + drag, damping, dt)

    n = round(5.0 / h)
    # 1200 roundings of numbers up to 100.
    expect_equal(ours(Drag(k1, k2), DOWN, h, n), theirs(DOWN, h, n, velocity=velocity), 1e-11)


def central(size: Callable[[float], float]) -> Callable[[Any], Any]:
    """Return a function of a body for an acceleration of this size toward the origin."""

    def acceleration(body: Any) -> Any:
        return -body.position.normalized() * size(body.position.length)

    return acceleration


CENTRAL = [
    pytest.param(PointGravity(Vector3(), 9.0), central(lambda _: 9.0), id="constant"),
    pytest.param(
        InverseSquareGravity(Vector3(), 150.0),
        central(lambda r: 150.0 / r / r),
        id="inverse square",
    ),
]


@pytest.mark.parametrize("h", FRAMES)
@pytest.mark.parametrize(("generator", "acceleration"), CENTRAL)
def test_point_gravity_as_a_force_before_the_step_is_ours(
    generator: ForceGenerator, acceleration: Callable[[Any], Any], h: float
) -> None:
    def push(body: Any) -> None:
        body.apply_force_at_world_point(acceleration(body) * body.mass, body.position)

    n = round(2.0 / h)
    # 480 roundings of numbers up to 20, which the orbit may amplify.
    expect_equal(ours(generator, (0.0, 0.0), h, n), theirs((0.0, 0.0), h, n, before=push), 1e-10)


@pytest.mark.parametrize("h", FRAMES)
@pytest.mark.parametrize(("generator", "acceleration"), CENTRAL)
def test_point_gravity_as_a_velocity_function_is_asked_after_the_move(
    generator: ForceGenerator, acceleration: Callable[[Any], Any], h: float
) -> None:
    """Pymunk's velocity function sees the position after the frame's move.

    That is the symplectic form of the step, in which the force belongs to the new position. Ours
    does the same if the generator is evaluated after the particle has moved.
    """

    def velocity(body: Any, gravity: Any, damping: float, dt: float) -> None:
        pymunk.Body.update_velocity(body, gravity + acceleration(body), damping, dt)

    n = round(2.0 / h)
    particle = Particle(Vector3(*START), Vector3(*MOTION), mass=MASS)
    seen = []
    for _ in range(n):
        ahead = Particle(particle.position + particle.velocity * h, mass=MASS)
        generator.update_force(ahead, h)
        particle.add_force(ahead.force_accumulator)
        particle.integrate(h)
        p, v = particle.position, particle.velocity
        seen.append((p.x, p.y, v.x, v.y))
    expect_equal(seen, theirs((0.0, 0.0), h, n, velocity=velocity), 1e-10)


def test_the_order_decides_whether_an_orbit_drifts() -> None:
    """Over ten turns of an ellipse, our step gains energy. Pymunk's hardly gains any."""

    def energy(state: State) -> float:
        x, y, vx, vy = state
        return 0.5 * (vx * vx + vy * vy) - 150.0 / math.hypot(x, y)

    def velocity(body: Any, gravity: Any, damping: float, dt: float) -> None:
        pull = -body.position.normalized() * 150.0 / body.position.length_squared
        pymunk.Body.update_velocity(body, gravity + pull, damping, dt)

    start = energy((*START, *MOTION))
    turn = 2.0 * math.pi * 150.0 / (-2.0 * start) ** 1.5
    h, n = turn / 4000.0, 40_000
    drifted = energy(ours(InverseSquareGravity(Vector3(), 150.0), (0.0, 0.0), h, n)[-1]) / start
    kept = energy(theirs((0.0, 0.0), h, n, velocity=velocity)[-1]) / start
    # Bound orbits have a negative energy, so a smaller magnitude is a wider orbit.
    assert drifted < 0.9
    assert kept == pytest.approx(1.0, abs=1e-3)
