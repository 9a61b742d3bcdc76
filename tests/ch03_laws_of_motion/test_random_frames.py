"""Frames of random duration, exercise 3.5a."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch03_laws_of_motion import exercises
from expect import about, expect_between, expect_close, expect_error, expect_exactly, scoped


@scoped
def frames_of(mean: float, jitter: float, total: float, seed: int) -> list[float]:
    """Return the frames as plain floats."""
    about.call = f"random_frames({mean}, {jitter}, {total}, {seed})"
    about(
        cause="Return a list of floats, one duration for each frame.",
        read="the docstring of random_frames",
    )
    frames: Any = exercises.random_frames(mean, jitter, total, seed)
    plain = isinstance(frames, (list, tuple)) and all(type(frame) is float for frame in frames)
    expect_exactly(plain, True, call=f"are all of {about.call} floats?")
    return list(frames)


@pytest.mark.exercise("3.5a")
def test_the_frames_fill_the_total_time(rng: Random) -> None:
    about.cause = (
        "The durations must add up to exactly the total. Shorten the last frame so that it ends "
        "there."
    )
    about.read = "the docstring of random_frames"
    for mean, total in ((round(rng.uniform(0.01, 0.03), 4), 2.0), (0.1, 1.0), (0.3, 0.2)):
        seed = rng.randrange(1000)
        about.call = f"sum(random_frames({mean}, 0.4, {total}, {seed}))"
        frames = frames_of(mean, 0.4, total, seed)
        # About 200 rounded additions.
        got = math.fsum(frames)
        expect_close(got, total, tolerance=1e-11)


@pytest.mark.exercise("3.5a")
def test_every_frame_but_the_last_is_within_the_jitter(rng: Random) -> None:
    seed, mean = rng.randrange(1000), 0.02
    about.read = "the docstring of random_frames"
    for jitter in (round(rng.uniform(0.2, 0.8), 3), 0.95):
        *frames, last = frames_of(mean, jitter, 8.0, seed)
        about.call = f"random_frames({mean}, {jitter}, 8.0, {seed})"
        about.cause = (
            "Every frame but the last must take between mean * (1 - jitter) and mean * (1 + "
            "jitter). Check the limits of your random numbers."
        )
        farthest = max(frames, key=lambda frame: abs(frame - mean))
        least, most = mean * (1.0 - jitter), mean * (1.0 + jitter)
        name = ": the frame that is farthest from the mean, leaving out the last frame"
        expect_between(farthest, least, most, then=name, tolerance=1e-9 * mean)
        about.cause = (
            "The last frame is whatever remains of the total, so it must be longer than 0 but no "
            "longer than the longest frame that the jitter allows."
        )
        expect_exactly(last > 0.0, True, then=": is the last frame longer than 0?")
        expect_between(last, 0.0, most, then=": the last frame", tolerance=1e-9)


@pytest.mark.exercise("3.5a")
def test_the_frames_spread_evenly_about_the_mean(rng: Random) -> None:
    seed, mean, jitter = rng.randrange(1000), 0.02, 0.5
    about.read = "the docstring of random_frames"
    frames = frames_of(mean, jitter, 20.0, seed)[:-1]
    about.call = f"random_frames({mean}, {jitter}, 20.0, {seed})"
    about.cause = (
        "Draw each duration uniformly from the whole range, which extends to both sides of the "
        "mean."
    )
    # The mean of about 1000 even draws is within 6 of its standard deviations. The chance that a
    # tenth of the range stays empty is 0.9^1000.
    average = math.fsum(frames) / len(frames)
    six_sigma = 6.0 * mean * jitter / math.sqrt(3.0 * 900.0)
    name = f"the mean of all frames of {about.call}"
    expect_close(average, mean, call=name, tolerance=six_sigma)
    reach = (min(frames), max(frames))
    wanted = (mean * (1.0 - jitter), mean * (1.0 + jitter))
    name = f"the shortest and the longest frame of {about.call}"
    expect_close(reach, wanted, call=name, tolerance=0.2 * mean * jitter)
    # Half of the draws lie in the middle half of the range, within 6 deviations.
    inner = sum(abs(frame - mean) < 0.5 * mean * jitter for frame in frames) / len(frames)
    six_sigma = 6.0 * math.sqrt(0.25 / 900.0)
    name = f"the fraction of the frames of {about.call} that are within half the jitter of the mean"
    if inner > 0.5:
        about.cause = (
            "Too many frames are close to the mean. Draw each duration with a single call of "
            "uniform() instead of averaging several random numbers."
        )
    expect_close(inner, 0.5, call=name, tolerance=six_sigma)


@pytest.mark.exercise("3.5a")
def test_without_jitter_all_frames_are_equal() -> None:
    about.cause = (
        "Without jitter, every frame has the mean duration. Rounding can leave about 1e-16 s of "
        "the total, so make sure that it doesn't become a frame of its own."
    )
    about.read = "the docstring of random_frames"
    for mean, count in ((0.125, 8), (0.1, 10)):
        about.call = f"random_frames({mean}, 0.0, 1.0, 3)"
        got = frames_of(mean, 0.0, 1.0, 3)
        expect_close(got, [mean] * count, tolerance=1e-11)
    about.cause = (
        "After two frames, about 1e-7 s of the total is left. That is far more than a rounding "
        "error, so add another frame for it."
    )
    about.call = "random_frames(0.25, 0.0, 0.5000001, 3)"
    got = frames_of(0.25, 0.0, 0.5000001, 3)
    expect_close(got, [0.25, 0.25, 1e-7], tolerance=1e-12)
    about.cause = (
        "A rounding error is always small compared with the total. Here 0.6 % of the total is "
        "left, so add another frame for it."
    )
    about.call = "random_frames(4e-06, 0.0, 8.05e-06, 3)"
    got = frames_of(4e-6, 0.0, 8.05e-6, 3)
    expect_close(got, [4e-6, 4e-6, 5e-8], tolerance=1e-17)


@pytest.mark.exercise("3.5a")
def test_a_seed_repeats_its_frames_and_another_gives_others(rng: Random) -> None:
    seed = rng.randrange(1000)
    about.call = f"random_frames(0.02, 0.5, 1.0, {seed})"
    about.cause = (
        "The frames must depend only on the seed. Create a new random.Random(seed) in the "
        "function, and draw every number from it."
    )
    about.read = "the docstring of random_frames"
    first = frames_of(0.02, 0.5, 1.0, seed)
    others = [frames_of(0.02, 0.5, 1.0, seed + i) for i in (1, 2)]
    again = frames_of(0.02, 0.5, 1.0, seed)
    expect_exactly(again == first, True, then=", called twice: are the results the same?")
    for i, other in enumerate(others, 1):
        expect_exactly(
            other[0] == first[0],
            False,
            then=f", and again with seed {seed + i}: is the first frame the same?",
        )
    name = f"{about.call}: are the frames sorted?"
    about.cause = (
        "The durations only ever increase or only ever decrease, so they seem to be sorted. Return "
        "them in the order in which you drew them."
    )
    in_order = first[:-1] in (sorted(first[:-1]), sorted(first[:-1], reverse=True))
    expect_exactly(in_order, False, call=name)


@pytest.mark.exercise("3.5a")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "bad"),
    [
        ("mean", 0.0),
        ("mean", -0.1),
        ("mean", math.inf),
        ("mean", math.nan),
        ("total", 0.0),
        ("total", -1.0),
        ("total", math.inf),
        ("total", math.nan),
        ("jitter", 1.0),
        ("jitter", -0.1),
        ("jitter", math.nan),
    ],
)
def test_frames_of_no_length_are_refused(name: str, bad: float) -> None:
    arguments: dict[str, Any] = {"mean": 0.1, "jitter": 0.5, "total": 1.0, "seed": 3}
    about.cause = (
        "The mean and the total must be positive and finite, and the jitter must be at least 0 and "
        "below 1. Check all three before you draw the first number, or the loop may never end."
    )
    about.read = "the docstring of random_frames"
    for value in (bad, 1.5) if bad == 1.0 else (bad,):  # at a limit, and beyond it
        bad_ones = arguments | {name: value}
        about.call = "random_frames({mean}, {jitter}, {total}, {seed})".format(**bad_ones)
        expect_error(
            lambda bad_ones=bad_ones: exercises.random_frames(**bad_ones),
            ValueError,
            allowed=lambda: exercises.random_frames(**arguments),
        )
