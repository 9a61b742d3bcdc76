"""Fixed steps: the run does not depend on the frame times, and no time is lost."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Cable
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.world import ParticleWorld

DURATION = 1.0 / 60.0
GRAVITY = Vector3(0.0, -9.81, 0.0)


def pair() -> tuple[list[Particle], ParticleWorld]:
    """Return two bouncing balls on a cable. Different steps never give the same motion."""
    balls = [
        Particle(Vector3(0.0, 2.0), Vector3(1.0), GRAVITY, damping=0.9),
        Particle(Vector3(0.5, 3.0), Vector3(-3.0, 1.0), GRAVITY, mass=2.0, damping=0.9),
    ]
    links = [Cable(*balls, 1.5, 0.7), GroundPlane(balls, restitution=0.8)]
    return balls, ParticleWorld(balls, links)


def after(frames: list[float]) -> tuple[list[float], int, list[float]]:
    """Return the final state, the number of steps, and their durations."""
    balls, world = pair()
    durations: list[float] = []

    def step(duration: float) -> None:
        durations.append(duration)
        world.step(duration)

    clock = FixedStep(step, DURATION)
    steps = sum(clock.advance(frame) for frame in frames)
    return [x for ball in balls for x in (*ball.position, *ball.velocity)], steps, durations


def uneven(seed: int) -> list[float]:
    """Return frame times that fill 5 s: 5 to 40 ms, and half a second from time to time."""
    draw, frames = random.Random(seed), [0.0]
    while sum(frames) < 4.4:
        frames.append(0.5 if draw.random() < 0.02 else draw.uniform(0.005, 0.04))
    return [*frames, 5.0 - sum(frames)]


@pytest.mark.parametrize("seed", range(5))
def test_uneven_frames_end_exactly_where_even_ones_do(seed: int) -> None:
    even, steps, _ = after([DURATION] * 300)
    uneven_end, uneven_steps, durations = after(uneven(seed))
    assert steps == uneven_steps == 300
    assert set(durations) == {DURATION}
    assert uneven_end == even  # to the last bit, because the steps are the same
    assert after([5.0])[0] == even
    assert after([0.001] * 5000)[0] == even


def test_steps_of_the_pictures_length_do_not() -> None:
    balls, world = pair()
    for frame in uneven(1):
        if frame > 0.0:
            world.step(frame)
    even, _, _ = after([DURATION] * 300)
    assert abs(balls[0].position.x - even[0]) > 0.01


@given(
    frames=st.lists(st.floats(0.0, 2.0), max_size=40),
    duration=st.floats(0.01, 0.5),
    most=st.one_of(st.none(), st.integers(1, 8)),
)
def test_no_time_is_lost(frames: list[float], duration: float, most: int | None) -> None:
    made: list[float] = []
    clock, steps = FixedStep(made.append, duration, most), 0
    for frame in frames:
        count = clock.advance(frame)
        steps += count
        assert most is None or count <= most
        # Less than a step is left. A step that is early by 1e-9 of itself is owed as much.
        assert -1.1e-9 * duration <= clock.left < duration
    assert made == [duration] * steps
    elapsed = sum(Fraction(frame) for frame in frames)
    known = steps * Fraction(duration) + Fraction(clock.left) + Fraction(clock.dropped)
    # At most 80 s in 8000 steps, each with a rounding of 2 s, which is 2^-53 of that.
    assert abs(float(known - elapsed)) <= 8000 * 2.0 * 2.0**-53
    if most is None:
        assert clock.dropped == 0.0
