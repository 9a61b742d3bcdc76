"""How much uneven frames separate the two equations for damping, exercise 3.5b."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import exercises
from draw import Components, components, rounded
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
MEAN_OF_MEANS = (
    "You compute the mean of each run, and then the mean of these means. A long run has more "
    "steps, so divide the sum of all durations by the number of all steps."
)
SAME_VECTOR = (
    "Your two velocities are always equal at the end, so both names probably stand for the same "
    "vector, which your code changes in place. Compute a new vector for each of them in each step."
)
FLOOR = "You divide with //, which rounds down to a whole number. Use / instead."
NO_MEAN = (
    "Your mean duration is 0, as after a division with //, which rounds down. Then d ** 0 is 1, "
    "and Eq. 3.5 does not damp. Use / instead."
)
PER_RUN = (
    "You divide the sum of all durations by the number of runs. Divide it by the number of all "
    "steps to get their mean duration."
)
SWAPPED = (
    "You swap the two factors. Pass d ** mean to damp_per_frame, and d itself to damp_per_second."
)
RATE = (
    "You divide the number of steps by their total time, which is the frame rate. Divide the time "
    "by the number of steps to get the mean duration."
)
SUM = "You return the sum over all runs. Divide it by the number of runs to get the mean."
OPPOSITE = (
    "In your mean, the differences of the two runs partly cancel. Subtract the two velocities of a "
    "run, and take the length of the result, instead of subtracting their lengths."
)
MIXED = (
    "In each step, you compute one of your two velocities from the other. Let each of them "
    "continue from its own value after the last step."
)
CARRIED = (
    "Your second run starts where the first one ended. Start every run from the given velocity v."
)


def draw_damping(rng: Random) -> float:
    """Draw a damping that is far enough from 1 for each mistake to show."""
    return round(rng.uniform(0.3, 0.9), 3)


def apart(
    v: Components,
    a: Components,
    runs: list[list[float]],
    per_frame: float,
    per_second: float,
) -> float:
    """Return the mean difference for a factor per frame and another one per second."""
    found = []
    for run in runs:
        ends = []
        for u, b in zip(v, a, strict=True):
            by_frame = by_second = u
            for h in run:
                by_frame = by_frame * per_frame + b * h
                by_second = by_second * per_second**h + b * h
            ends.append(by_frame - by_second)
        found.append(math.hypot(*ends))
    return math.fsum(found) / len(found)


@pytest.mark.exercise("3.5b", asks="damping ** mean per step (Eq. 3.5)")
def test_equal_frames_make_no_difference(rng: Random) -> None:
    v, a, damping = components(rng), components(rng), draw_damping(rng)
    h = rng.choice((0.0125, 0.025, 0.05))
    about.call = (
        f"damping_difference(Vector3{v}, Vector3{a}, damping={damping}, runs=[[{h}] * 30, [{h}] * "
        "20])"
    )
    about.cause = (
        "All steps are equally long, so d ** mean is the factor d^h of Eq. 3.6, and both equations "
        "give the same velocity. Check the factor that you pass to damp_per_frame, and let each "
        "velocity continue from its own value."
    )
    about.read = READ
    runs = [[h] * 30, [h] * 20]
    got = exercises.damping_difference(Vector3(*v), Vector3(*a), damping, runs)
    mistakes = [
        (apart(v, a, runs, damping, damping), PER_FRAME),
        (apart(v, a, runs, damping, damping**h), SWAPPED),
        (apart(v, a, runs, 1.0, damping), NO_MEAN),
        (apart(v, a, runs, damping ** (25.0 * h), damping), PER_RUN),
        (apart(v, a, runs, damping ** (1.0 / h), damping), RATE),
        (
            apart(v, a, runs, damping * h, damping),
            "You multiply d by the mean duration. Use the power d ** mean.",
        ),
    ]
    mixed = []
    for run in runs:
        last = list(v)
        for _ in run:
            last = [n * damping**h + b * h for n, b in zip(last, a, strict=True)]
        other = [n * damping**h + b * h for n, b in zip(last, a, strict=True)]
        mixed.append(math.dist(last, other))
    mistakes.append((math.fsum(mixed) / 2.0, MIXED))
    blame(got, mistakes)
    # The rounding errors of numbers up to 20 in 30 steps.
    expect_close(got, 0.0, tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="the mean duration of all steps of all runs")
def test_without_acceleration_the_number_of_steps_makes_the_difference(rng: Random) -> None:
    x, y, z = components(rng)
    damping = draw_damping(rng)
    v = (100.0 * x, 100.0 * y, 100.0 * z)  # so fast that a rounded difference is not 0
    long = round(rng.uniform(0.3, 0.5), 2)
    runs = [[0.1, 0.2] * 4, [long, 0.1, long]]
    about.call = (
        f"damping_difference(Vector3{rounded(v)}, Vector3(), damping={damping}, runs={runs})"
    )
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
    signed = [kept**n - damping**t for n, t in zip(steps, times, strict=True)]
    carried = abs(kept**8 - damping ** times[0]) + abs(kept**11 - damping ** math.fsum(times))
    of_means = (times[0] / 8.0 + times[1] / 3.0) / 2.0
    equal = SAME_VECTOR
    if isinstance(got, (int, float)) and abs(got) < 1e-9:
        # Without acceleration, a mean of each run gives 0, too. With one, it does not.
        other = exercises.damping_difference(Vector3(), Vector3(x, y, z), damping, runs)
        equal = SAME_VECTOR if isinstance(other, (int, float)) and abs(other) < 1e-9 else OWN_MEAN
    mistakes = [
        (difference(damping), PER_FRAME),
        (0.0, equal),
        (speed * sum(signed) / 2.0, OPPOSITE),
        (-speed * sum(signed) / 2.0, OPPOSITE),
        (math.floor(difference(kept)), FLOOR),
        (difference(damping**of_means), MEAN_OF_MEANS),
        (2.0 * difference(kept), SUM),
        (
            2.0 * difference(kept) / sum(steps),
            "You divide the sum of the differences by the number of steps. Divide it by the number "
            "of runs.",
        ),
        (
            speed * abs(kept**8 - damping ** times[0]),
            "You return the difference of one run. Return the mean of the differences of all runs.",
        ),
        (
            speed * abs(kept**3 - damping ** times[1]),
            "You return the difference of one run. Return the mean of the differences of all runs.",
        ),
        (
            speed**2
            * ((kept**8 - damping ** times[0]) ** 2 + (kept**3 - damping ** times[1]) ** 2)
            / 2.0,
            "You return the mean of the squared lengths. Take the length, which is magnitude().",
        ),
        (speed * carried / 2.0, CARRIED),
    ]
    blame(got, mistakes)
    # The rounding errors of numbers up to 2000.
    expect_close(got, difference(kept), tolerance=1e-10)


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
