"""Flights, drag and gravity toward a point, step for step beside pymunk in two dimensions."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import pymunk
import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_second
from ch05_forces.forces import Drag, ForceGenerator, InverseSquareGravity, PointGravity
from ch05_forces.particle import Particle
from scenes.flight import DAMPED_FALL, FREE_FALL, PROJECTILE, Flight, State
from scenes.setup import alone
from scenes.twin import twin_of

FRAMES = (1.0 / 240.0, 1.0 / 60.0, 1.0 / 15.0)
FLIGHTS = {"free fall": FREE_FALL, "damped fall": DAMPED_FALL, "projectile": PROJECTILE}
SECONDS = 4.0


def theirs(flight: Flight, frame: float, frames: int) -> list[State]:
    """Simulate a flight with pymunk, which has two dimensions, and return the states like ours."""
    space, (body,) = twin_of(alone(flight.particle(Particle)))
    states = [State((*body.position, 0.0), (*body.velocity, 0.0))]
    for _ in range(frames):
        space.step(frame)
        states.append(State((*body.position, 0.0), (*body.velocity, 0.0)))
    return states


@pytest.mark.parametrize("name", FLIGHTS)
def test_the_equation_s_form_is_pymunk_s_step_for_step(name: str) -> None:
    flight, frame = FLIGHTS[name], 1.0 / 60.0
    x, v = Vector3(*flight.position), Vector3(*flight.velocity)
    for state in theirs(flight, frame, round(SECONDS / frame)):
        assert tuple(x) == pytest.approx(state.position, abs=1e-11)
        assert tuple(v) == pytest.approx(state.velocity, abs=1e-11)
        x.add_scaled(v, frame)
        v = damp_per_second(v, Vector3(*flight.acceleration), flight.damping, frame)


# Forces


Push = Callable[[Any], Any]  # a force in N on a body of pymunk
K1, K2, MU = 0.8, 0.1, 150.0


def drag(body: Any) -> Any:
    return -body.velocity * (K1 + K2 * body.velocity.length)


def constant(body: Any) -> Any:
    return -body.position.normalized() * 9.0 * body.mass


def inverse_square(body: Any) -> Any:
    return -body.position.normalized() * (MU * body.mass / body.position.length_squared)


def states(
    generator: ForceGenerator, push: Push, g: float, h: float, time: float
) -> Iterable[tuple[Any, Any]]:
    """Yield both states after each frame. Each force is found before the step."""
    space, body = pymunk.Space(), pymunk.Body(2.0, 1.0)
    space.gravity = (0.0, g)
    space.add(body)
    body.position, body.velocity = (3.0, 1.0), (-4.0, 6.0)
    particle = Particle(Vector3(3.0, 1.0), Vector3(-4.0, 6.0), Vector3(0.0, g), mass=2.0)
    for _ in range(round(time / h)):
        generator.update_force(particle, h)
        particle.integrate(h)
        body.apply_force_at_world_point(push(body), body.position)
        space.step(h)
        p, v = particle.position, particle.velocity
        yield (p.x, p.y, v.x, v.y), (*body.position, *body.velocity)


@pytest.mark.parametrize("h", FRAMES)
@pytest.mark.parametrize(
    ("generator", "push", "g", "time"),
    [
        (Drag(K1, K2), drag, -9.81, 5.0),
        (PointGravity(Vector3(), 9.0), constant, 0.0, 2.0),
        (InverseSquareGravity(Vector3(), MU), inverse_square, 0.0, 2.0),
    ],
    ids=["drag", "constant", "inverse square"],
)
def test_a_force_before_the_step_is_ours_step_for_step(
    generator: ForceGenerator, push: Push, g: float, time: float, h: float
) -> None:
    for mine, other in states(generator, push, g, h, time):
        # 1200 roundings of numbers up to 100, which an orbit may amplify.
        assert mine == pytest.approx(other, abs=1e-10)
