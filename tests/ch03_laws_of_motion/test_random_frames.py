"""Frames of random duration, exercise 3.5a."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch03_laws_of_motion import exercises
from expect import about, expect_between, expect_close, expect_exactly, expect_that

READ = "the docstring of random_frames"
UNIFORM = (
    "Draw each of them uniformly from mean * (1 - jitter) to mean * (1 + jitter), with a single "
    "call of uniform."
)


def frames_of(mean: float, jitter: float, total: float, seed: int) -> list[float]:
    """Return the frames as plain floats."""
    __tracebackhide__ = True
    with calls("Return a list of floats, with one duration for each frame."):
        frames = exercises.random_frames(mean=mean, jitter=jitter, total=total, seed=seed)
    plain = isinstance(frames, (list, tuple)) and all(type(frame) is float for frame in frames)
    expect_exactly(plain, True, then="; is the result a list of floats?")
    cause = "Your list is too short. Add durations until they fill the total."
    if not frames:
        cause = (
            "Your list is empty. Add each duration to it with frames.append(frame), because frames "
            "+ [frame] makes a new list and leaves frames unchanged."
        )
    elif len(frames) == 1 and abs(frames[0] - total) < 1e-9 * total:
        cause = (
            "Your only frame takes the whole total. A frame lasts as long as you draw, or as long "
            "as is left if that is less, so take the smaller of the two with min."
        )
    least = 1 if total <= mean * (1.0 + jitter) else 2
    shown, wanted = f"a list of {len(frames)}", f"a list of at least {least}"
    then = "; the number of durations"
    expect_that(len(frames) >= least, shown, wanted, then=then, cause=cause)
    return list(frames)


@pytest.mark.exercise("3.5a", asks="so that the sum equals total", read=READ)
def test_the_frames_fill_the_total_time(rng: Random) -> None:
    for mean, total in ((round(rng.uniform(0.01, 0.03), 4), 2.0), (0.1, 1.0), (0.3, 0.2)):
        # About 200 rounded additions.
        got = math.fsum(frames_of(mean, 0.4, total, rng.randrange(1000)))
        cause = "Your frames end before the total. Add frames until they fill it exactly."
        if got > total:
            cause = (
                "Your last frame ends after the total. Shorten it, so that it ends exactly at the "
                "total."
            )
        then = "; the sum of the durations"
        expect_close(got, total, tolerance=1e-11, unit="s", then=then, cause=cause)


@pytest.mark.exercise("3.5a", asks="Each lies uniformly between mean", read=READ)
def test_every_frame_but_the_last_is_within_the_jitter(rng: Random) -> None:
    seed, mean = rng.randrange(1000), 0.02
    for jitter in (round(rng.uniform(0.2, 0.8), 3), 0.95):
        *frames, last = frames_of(mean, jitter, 8.0, seed)
        farthest = max(frames, key=lambda frame: abs(frame - mean))
        least, most = mean * (1.0 - jitter), mean * (1.0 + jitter)
        about(
            cause="A frame is too short or too long. Draw each duration between mean * (1 - "
            "jitter) and mean * (1 + jitter)."
        )
        then = "; the duration that is farthest from the mean, without the last one, in s"
        expect_between(farthest, least, most, then=then, tolerance=1e-9 * mean)
        about(
            cause="The last frame takes what is left of the total. It must be longer than 0, but "
            "not longer than mean * (1 + jitter)."
        )
        expect_exactly(last > 0.0, True, then="; is the last duration above 0?")
        expect_between(last, 0.0, most, then="; the last duration in s", tolerance=1e-9)


@pytest.mark.exercise("3.5a", asks="Each lies uniformly between mean", read=READ)
def test_the_frames_spread_evenly_about_the_mean(rng: Random) -> None:
    mean, jitter = 0.02, 0.5
    *frames, _ = frames_of(mean, jitter, 20.0, rng.randrange(1000))
    # The mean of about 1000 even draws is within 6 of its standard deviations. The chance that a
    # tenth of the range stays empty is 0.9^1000.
    equal = (
        "All your durations are equal, as if each of them came from a new generator with the same "
        "seed. Create random.Random(seed) once, before the loop."
    )
    are_equal = max(frames) - min(frames) < 1e-12
    shown = f"{len(frames)} equal durations"
    expect_that(not are_equal, shown, "different durations", cause=equal)
    got = math.fsum(frames) / len(frames)
    cause = f"Your durations are too {'long' if got > mean else 'short'} on average. {UNIFORM}"
    six_sigma = 6.0 * mean * jitter / math.sqrt(3.0 * 900.0)
    then = "; the mean of the durations, without the last one"
    expect_close(got, mean, tolerance=six_sigma, unit="s", then=then, cause=cause)
    reach, wanted = (min(frames), max(frames)), (mean * (1.0 - jitter), mean * (1.0 + jitter))
    cause = f"Your durations don't fill the whole range. {UNIFORM}"
    then = "; the shortest and the longest duration, without the last one, in s"
    expect_close(reach, wanted, tolerance=0.2 * mean * jitter, then=then, cause=cause)
    # Half of the draws lie in the middle half of the range, within 6 deviations.
    got = sum(abs(frame - mean) < 0.5 * mean * jitter for frame in frames) / len(frames)
    many = "few" if got < 0.5 else "many"
    cause = f"Too {many} of your durations are close to the mean. {UNIFORM}"
    then = "; the fraction of the durations between 0.015 and 0.025 s"
    expect_close(got, 0.5, tolerance=6.0 * math.sqrt(0.25 / 900.0), then=then, cause=cause)


@pytest.mark.exercise("3.5a", asks="A rest below 1e-12 of the total is a rounding error", read=READ)
def test_without_jitter_all_frames_are_equal() -> None:
    for mean, count in ((0.125, 8), (0.1, 10)):
        got = frames_of(mean, 0.0, 1.0, 3)
        cause = "Without jitter, every frame must take exactly the mean."
        if len(got) > count and 0.0 < got[-1] < 1e-9:
            cause = (
                "Your extra frame at the end is only a rounding error of the total. Stop when the "
                "remaining time is below 1e-12 * total."
            )
        expect_close(got, [mean] * count, tolerance=1e-11, cause=cause)
    long = (
        "You drop the last 1e-7 s of the total, which is far more than a rounding error. Add a "
        "third frame for it."
    )
    got = frames_of(0.25, 0.0, 0.5000001, 3)
    expect_close(got, [0.25, 0.25, 1e-7], tolerance=1e-12, cause=long)
    short = (
        "You treat the last 5e-08 s as a rounding error, although that time is 0.6% of the total. "
        "Compare the remaining time with 1e-12 * total, not with a fixed time."
    )
    got = frames_of(4e-6, 0.0, 8.05e-6, 3)
    expect_close(got, [4e-6, 4e-6, 5e-8], tolerance=1e-17, cause=short)


@pytest.mark.exercise("3.5a", asks="take your random numbers from random.Random(seed)", read=READ)
def test_only_the_same_seed_gives_the_same_frames(rng: Random) -> None:
    seed = rng.randrange(1000)
    others = [frames_of(0.02, 0.5, 1.0, seed + i) for i in (1, 2)]
    first, again = (frames_of(0.02, 0.5, 1.0, seed) for _ in range(2))
    cause = (
        "Your random numbers don't depend on the seed alone. Create a new random.Random(seed) in "
        "each call, and draw every number from it."
    )
    shown, wanted = "different frames in the second call", "the same frames in both calls"
    expect_that(again == first, shown, wanted, then=", called twice", cause=cause)
    cause = "Your frames don't depend on the seed. Draw them from random.Random(seed)."
    for i, other in enumerate(others, 1):
        expect_that(
            other[0] != first[0],
            "the same first duration in both calls",
            "another first duration for another seed",
            then=f", and again with seed={seed + i}",
            cause=cause,
        )
    cause = "You sort the durations. Return them in the order in which you drew them."
    is_sorted = first[:-1] in (sorted(first[:-1]), sorted(first[:-1], reverse=True))
    shown, wanted = "sorted durations", "durations in the order in which they were drawn"
    expect_that(not is_sorted, shown, wanted, cause=cause)
