"""How much uneven frames separate the two equations for damping, exercise 3.5b."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import exercises
from draw import components
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_unchanged,
    xyz,
)

READ = "book 3, exercise 3.5; Eq. 3.5 and 3.6"
PER_FRAME = (
    "You pass d itself to both equations, so Eq. 3.5 damps once per step as much as Eq. 3.6 does "
    "in a whole second. Use d ** mean for Eq. 3.5, with the mean duration of all steps of all runs."
)
OWN_MEAN = (
    "You compute a new mean for each run. A game has one factor for all of its frames, so use the "
    "mean duration of all steps of all runs."
)
EQUAL = (
    "Your two velocities are equal at the end. Either both names stand for the same vector, or you "
    "compute a new mean for each run. Use the mean duration of all steps of all runs."
)
SUM = "You return the sum over all runs. Divide it by the number of runs to get the mean."
CARRIED = (
    "Your second run starts where the first one ended. Start every run from the given velocity v."
)


def draw_damping(rng: Random) -> float:
    """Draw a damping that is far enough from 1 for each mistake to show."""
    return round(rng.uniform(0.3, 0.9), 3)


@pytest.mark.exercise("3.5b", asks="So both lose equally much if all steps")
def test_equal_frames_make_no_difference(rng: Random) -> None:
    v, a, damping = components(rng), components(rng), draw_damping(rng)
    h = rng.choice((0.0125, 0.025, 0.05))
    about.call = (
        f"damping_difference(Vector3{v}, Vector3{a}, damping={damping}, runs=[[{h}] * 30, [{h}] * "
        "20])"
    )
    about.cause = (
        "All steps are equally long, so d ** mean is the factor d^h of Eq. 3.6, and both equations "
        "give the same velocity. Check the factor that you pass to damp_per_frame."
    )
    about.read = READ
    runs = [[h] * 30, [h] * 20]
    got = exercises.damping_difference(Vector3(*v), Vector3(*a), damping, runs)
    confused = []
    for frames in (30, 20):
        ends = []
        for u, b in zip(v, a, strict=True):
            by_frame = by_second = u
            for _ in range(frames):
                by_frame = by_frame * damping + b * h
                by_second = by_second * damping**h + b * h
            ends.append(by_frame - by_second)
        confused.append(math.hypot(*ends))
    blame(got, [(math.fsum(confused) / 2.0, PER_FRAME)])
    # The rounding errors of numbers up to 20 in 30 steps.
    expect_close(got, 0.0, tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="the mean duration of all steps of all runs")
def test_without_acceleration_the_number_of_steps_makes_the_difference(rng: Random) -> None:
    v, damping = components(rng), draw_damping(rng)
    long = round(rng.uniform(0.3, 0.5), 2)
    runs = [[0.1, 0.2] * 4, [long, 0.1, long]]
    about.call = f"damping_difference(Vector3{v}, Vector3(), damping={damping}, runs={runs})"
    about.cause = (
        "Without acceleration, Eq. 3.5 leaves d ** (mean * n) of the velocity after n steps, and "
        "Eq. 3.6 leaves d ** t after t seconds. Use one mean duration for all steps of all runs."
    )
    about.read = READ
    got = exercises.damping_difference(Vector3(*v), Vector3(), damping, runs)
    steps, times = [8, 3], [1.2, 2.0 * long + 0.1]
    mean = sum(times) / sum(steps)
    speed = math.hypot(*v)

    def difference(factor: float) -> float:
        both = zip(steps, times, strict=True)
        return speed * math.fsum(abs(factor**n - damping**t) for n, t in both) / 2.0

    kept = damping**mean
    carried = abs(kept**8 - damping ** times[0]) + abs(kept**11 - damping ** math.fsum(times))
    of_means = (times[0] / 8.0 + times[1] / 3.0) / 2.0
    mistakes = [
        (difference(damping), PER_FRAME),
        (0.0, EQUAL),
        (difference(damping**of_means), OWN_MEAN),
        (2.0 * difference(kept), SUM),
        (speed * carried / 2.0, CARRIED),
    ]
    blame(got, mistakes)
    expect_close(got, difference(kept), tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="Return the mean over all runs")
def test_the_difference_is_averaged_over_the_runs(rng: Random) -> None:
    v, a, damping = components(rng), components(rng), draw_damping(rng)
    runs = [[round(rng.uniform(0.05, 0.3), 3) for _ in range(n)] for n in (2, 3, 5)]
    about.call = (
        f"v, a = Vector3{v}, Vector3{a}; runs = {runs}; damping_difference(v, a, "
        f"damping={damping}, runs=runs)"
    )
    about.cause = (
        "Take the length of the difference of the two velocities at the end of each run, and "
        "return the mean of these lengths."
    )
    about.read = READ
    got = exercises.damping_difference(Vector3(*v), Vector3(*a), damping, runs)
    per_frame = damping ** (math.fsum(map(math.fsum, runs)) / 10.0)  # 10 steps in all
    distances, speeds, carried = [], [], []
    states = [(n, n) for n in v]
    for run in runs:
        for h in run:
            states = [
                (one * per_frame + a[i] * h, other * damping**h + a[i] * h)
                for i, (one, other) in enumerate(states)
            ]
        carried.append(math.dist(*zip(*states, strict=True)))
        ends = []
        for i in range(3):
            by_frame = by_second = v[i]
            for h in run:
                by_frame = by_frame * per_frame + a[i] * h
                by_second = by_second * damping**h + a[i] * h
            ends.append((by_frame, by_second))
        by_frames, by_seconds = zip(*ends, strict=True)
        distances.append(math.dist(by_frames, by_seconds))
        speeds.append(abs(math.hypot(*by_frames) - math.hypot(*by_seconds)))
    wanted = math.fsum(distances) / len(distances)
    mistakes = [
        (wanted * len(runs), SUM),
        (
            math.fsum(speeds) / len(speeds),
            "You return the difference of the speeds. Subtract the velocities as vectors first, "
            "and then take the length of the difference.",
        ),
        (
            distances[-1],
            "You return the difference after the last run alone. Return the mean of the "
            "differences of all runs.",
        ),
        (math.fsum(carried) / len(carried), CARRIED),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="None of these functions changes its arguments")
def test_the_difference_is_zero_without_damping(rng: Random) -> None:
    first, second = components(rng), components(rng)
    v, a = Vector3(*first), Vector3(*second)
    about.call = (
        f"v, a = Vector3{first}, Vector3{second}; damping_difference(v, a, damping=1.0, "
        "runs=[[0.5, 0.5]])"
    )
    about.cause = (
        "With a damping of 1, both equations give v + a h, so the difference must be 0. Check how "
        "you use the damping in each of them."
    )
    about.read = "the docstring of damping_difference"
    got = exercises.damping_difference(v, a, 1.0, [[0.5, 0.5]])
    expect_close(got, 0.0, tolerance=1e-13)
    expect_unchanged("v", xyz(v), first, cause=UNCHANGED)
    expect_unchanged("a", xyz(a), second, cause=UNCHANGED)
