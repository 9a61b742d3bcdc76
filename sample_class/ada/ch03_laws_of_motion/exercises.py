"""Chapter 3's exercises as plain functions; nothing they are given is changed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial, reduce
from itertools import chain, repeat
from operator import index
from random import Random
from statistics import fmean

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second

GRAVITATIONAL_CONSTANT = 6.67428e-11  # N m^2/kg^2, the book's value

State = tuple[Vector3, Vector3]


def speed_ratio(first_mass: float, second_mass: float) -> float:
    _require_positive(first_mass=first_mass, second_mass=second_mass)
    return second_mass / first_mass


def gravity_between(first_mass: float, second_mass: float, distance: float) -> float:
    _require_positive(first_mass=first_mass, second_mass=second_mass, distance=distance)
    # The square of this is m1 m2 / r^2, and it fits in a float wherever the force does.
    root = math.sqrt(first_mass) * math.sqrt(second_mass) / distance
    return GRAVITATIONAL_CONSTANT * root * root


def position_by_equation(
    position: Vector3, velocity: Vector3, acceleration: Vector3, time: float
) -> Vector3:
    _require_vectors(position=position, velocity=velocity, acceleration=acceleration)
    _require_positive(time=time)
    mean_velocity = velocity + acceleration * (time / 2)
    return position + mean_velocity * time


def state_by_steps(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> State:
    _require_vectors(position=position, velocity=velocity, acceleration=acceleration)
    _require_positive(duration=duration)

    def step(state: State, seconds: float) -> State:
        place, motion = state
        return place + motion * seconds, motion + acceleration * seconds

    return reduce(step, repeat(duration, _count(steps)), (position, velocity))


def stepping_error(
    position: Vector3, velocity: Vector3, acceleration: Vector3, duration: float, steps: int
) -> Vector3:
    _require_vectors(position=position, velocity=velocity, acceleration=acceleration)
    _require_positive(duration=duration)
    total = duration * _count(steps)
    return Vector3() - acceleration * (total * duration / 2)


def random_frames(mean: float, jitter: float, total: float, seed: int) -> list[float]:
    _require_positive(mean=mean, total=total)
    if not 0 <= _number("jitter", jitter) < 1:
        raise ValueError(f"jitter should be at least 0 and less than 1; it is {jitter!r}")
    if not isinstance(seed, int):
        raise TypeError(f"seed should be an int; it is {seed!r}")
    return list(_fill(total, _draws(mean, jitter, Random(seed))))


def damping_difference(
    velocity: Vector3, acceleration: Vector3, damping: float, runs: Sequence[Sequence[float]]
) -> float:
    _require_vectors(velocity=velocity, acceleration=acceleration)
    if not 0 <= _number("damping", damping) < math.inf:
        raise ValueError(f"damping should be finite and at least 0; it is {damping!r}")
    if min(map(len, runs), default=0) == 0:
        raise ValueError(f"runs should hold one run or more, and none without frames: {runs!r}")
    frames = list(chain.from_iterable(runs))
    for frame in frames:
        _require_positive(frame=frame)

    def end(equation: Callable[..., Vector3], kept: float, run: Sequence[float]) -> Vector3:
        return reduce(lambda v, h: equation(v, acceleration, kept, h), run, velocity)

    by_frame = partial(end, damp_per_frame, damping ** fmean(frames))
    by_second = partial(end, damp_per_second, damping)
    return fmean((by_frame(run) - by_second(run)).magnitude() for run in runs)


def _draws(mean: float, jitter: float, source: Random) -> Iterator[float]:
    """Yield frame times without an end."""
    while True:
        yield mean * (1 + jitter * (2 * source.random() - 1))


def _fill(total: float, draws: Iterator[float]) -> Iterator[float]:
    """Pass draws on until they reach the total, the last one cut to what is left.

    What is left is kept exactly, and a rest of a rounding error or two gets no frame of its own.
    """
    left = Fraction(total)
    crumb = left / 2**50
    while left > crumb:
        frame = min(next(draws), float(left))
        left -= Fraction(frame)
        yield frame


def _number(name: str, value: object) -> float:
    """Return an int or a float as a float, one that does not fit as an infinity."""
    if not isinstance(value, (int, float)):
        raise TypeError(f"{name} should be a number; it is {value!r}")
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def _require_positive(**numbers: object) -> None:
    for name, value in numbers.items():
        if not 0 < _number(name, value) < math.inf:
            raise ValueError(f"{name} should be finite and above 0; it is {value!r}")


def _require_vectors(**vectors: object) -> None:
    for name, value in vectors.items():
        if not isinstance(value, Vector3):
            raise TypeError(f"{name} should be a Vector3; it is {value!r}")


def _count(steps: int) -> int:
    """Return a number of steps, at least one."""
    try:
        count = index(steps)
    except TypeError:
        raise TypeError(f"steps should be a whole number; it is {steps!r}") from None
    if count < 1:
        raise ValueError(f"steps should be at least 1; it is {steps!r}")
    return count
