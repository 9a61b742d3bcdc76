"""The step compared with that of pymunk, an engine in two dimensions."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_second
from scenes.drag_flight import (
    DAMPED_FALL,
    DRAG_FLIGHTS,
    FREE_FALL,
    MODELS,
    PROJECTILE,
    DragFlight,
    State,
)
from scenes.drag_flight import with_particle as ours
from scenes.drag_flight import with_pymunk as theirs

FRAMES = (1.0 / 240.0, 1.0 / 60.0, 1.0 / 15.0)


def expect_equal(first: list[State], second: list[State], tolerance: float) -> None:
    for one, other in zip(first, second, strict=True):
        assert one.position == pytest.approx(other.position, abs=tolerance)
        assert one.velocity == pytest.approx(other.velocity, abs=tolerance)


@pytest.mark.parametrize("frame", FRAMES)
def test_without_damping_every_step_is_pymunk_s(frame: float) -> None:
    """Both move the position with the velocity before the step, as explicit Euler does."""
    frames = round(FREE_FALL.duration / frame)
    # 1200 roundings of numbers up to 125, added in two orders.
    expect_equal(ours(FREE_FALL, frame, frames), theirs(FREE_FALL, frame, frames), 1e-11)


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("flight", [DAMPED_FALL, PROJECTILE], ids=lambda flight: flight.name)
def test_with_damping_pymunk_is_ahead_by_what_equation_3_6_does_not_damp(
    flight: DragFlight, frame: float
) -> None:
    """Pymunk has v' = v d^h + a h (Eq. 3.6), and the engine (v + a h) d^h, as the listing does.

    With D = d^h, the difference between the velocities is multiplied by D in each step and grows by
    a h (1 - D). After n steps it is a h (1 - D^n). The difference between the positions is the sum
    of h times that.
    """
    frames = round(flight.duration / frame)
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


@pytest.mark.parametrize("flight", DRAG_FLIGHTS, ids=lambda flight: flight.name)
def test_the_equation_s_form_is_pymunk_s_step_for_step(flight: DragFlight) -> None:
    frame = 1.0 / 60.0
    x, v = Vector3(*flight.start.position), Vector3(*flight.start.velocity)
    states = [State((x.x, x.y, x.z), (v.x, v.y, v.z))]
    frames = round(flight.duration / frame)
    for _ in range(frames):
        x.add_scaled(v, frame)
        v = damp_per_second(v, Vector3(*flight.acceleration), flight.damping, frame)
        states.append(State((x.x, x.y, x.z), (v.x, v.y, v.z)))
    expect_equal(states, theirs(flight, frame, frames), 1e-11)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("flight", DRAG_FLIGHTS, ids=lambda flight: flight.name)
def test_every_model_comes_to_the_exact_path_in_the_first_order(
    flight: DragFlight, model: str
) -> None:
    exact = flight.exact(flight.duration).position
    coarse, fine = (
        math.dist(MODELS[model](flight, flight.duration / n, n)[-1].position, exact)
        for n in (500, 1000)
    )
    # If h is halved, so is the error. The next order changes that by less than a hundredth.
    assert coarse / fine == pytest.approx(2.0, abs=0.02)
