"""The step compared with that of pymunk, an engine in two dimensions."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_second
from ch05_forces.particle import Particle
from scenes.flight import DAMPED_FALL, FREE_FALL, PROJECTILE, Flight, State
from scenes.flight import flown as ours
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


def expect_equal(first: list[State], second: list[State], tolerance: float) -> None:
    for one, other in zip(first, second, strict=True):
        assert one.position == pytest.approx(other.position, abs=tolerance)
        assert one.velocity == pytest.approx(other.velocity, abs=tolerance)


@pytest.mark.parametrize("frame", FRAMES)
def test_without_damping_every_step_is_pymunk_s(frame: float) -> None:
    """Both move the position with the velocity before the step, as explicit Euler does."""
    frames = round(SECONDS / frame)
    # 960 roundings of numbers up to 80, added in two orders.
    expect_equal(ours(FREE_FALL, frame, frames), theirs(FREE_FALL, frame, frames), 1e-11)


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("name", ["damped fall", "projectile"])
def test_with_damping_pymunk_is_ahead_by_what_equation_3_6_does_not_damp(
    name: str, frame: float
) -> None:
    """Pymunk has v' = v d^h + a h (Eq. 3.6), and the engine (v + a h) d^h, as the listing does.

    With D = d^h, the difference between the velocities is multiplied by D in each step and grows by
    a h (1 - D). After n steps it is a h (1 - D^n). The difference between the positions is the sum
    of h times that.
    """
    flight = FLIGHTS[name]
    frames = round(SECONDS / frame)
    keep = flight.damping**frame
    for n, (mine, other) in enumerate(
        zip(ours(flight, frame, frames), theirs(flight, frame, frames), strict=True)
    ):
        gone = 1.0 - keep**n
        apart = frame * frame * (n - gone / (1.0 - keep))
        for i, a in enumerate(flight.acceleration):
            velocity = other.velocity[i] - mine.velocity[i]
            position = other.position[i] - mine.position[i]
            # Some thousand roundings of numbers up to 100.
            assert velocity == pytest.approx(a * frame * gone, abs=1e-11)
            assert position == pytest.approx(a * apart, abs=1e-11)


@pytest.mark.parametrize("name", FLIGHTS)
def test_the_equation_s_form_is_pymunk_s_step_for_step(name: str) -> None:
    flight, frame = FLIGHTS[name], 1.0 / 60.0
    x, v = Vector3(*flight.position), Vector3(*flight.velocity)
    states = [State((x.x, x.y, x.z), (v.x, v.y, v.z))]
    frames = round(SECONDS / frame)
    for _ in range(frames):
        x.add_scaled(v, frame)
        v = damp_per_second(v, Vector3(*flight.acceleration), flight.damping, frame)
        states.append(State((x.x, x.y, x.z), (v.x, v.y, v.z)))
    expect_equal(states, theirs(flight, frame, frames), 1e-11)


@pytest.mark.parametrize("simulate", [ours, theirs])
@pytest.mark.parametrize("name", FLIGHTS)
def test_both_come_to_the_exact_path_in_the_first_order(
    name: str, simulate: Callable[[Flight, float, int], list[State]]
) -> None:
    flight = FLIGHTS[name]
    exact = flight.exact(SECONDS).position
    coarse, fine = (
        math.dist(simulate(flight, SECONDS / n, n)[-1].position, exact) for n in (500, 1000)
    )
    # If h is halved, so is the error. The next order changes that by less than a hundredth.
    assert coarse / fine == pytest.approx(2.0, abs=0.02)
