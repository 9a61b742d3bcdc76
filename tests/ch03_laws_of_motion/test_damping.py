"""The two equations for damping (B3.3), and how much uneven frames separate them (3.5b)."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import damping as forms
from ch03_laws_of_motion import exercises
from draw import Triple, vector
from expect import UNCHANGED, expect_close, expect_unchanged, xyz

EQUATION = "book 3.3, Eq. 3.6, and docs/errata.md"
DOC = "the docstring of the function"
ZERO = Triple((0.0, 0.0, 0.0))
READ = "book 3, exercise 3.5; Eq. 3.5 and 3.6"
WHOLE = (
    "You add the whole acceleration, which is the change of velocity in one second. Multiply it by "
    "the duration of the step first."
)
PER_FRAME = (
    "You pass d itself to both equations, so Eq. 3.5 damps once per step as much as Eq. 3.6 does "
    "in a whole second. Use d ** mean for Eq. 3.5, with the mean duration of all steps of all runs."
)
OWN_MEAN = (
    "You compute a new mean for each run. A game has one factor for all of its frames, so use the "
    "mean duration of all steps of all runs."
)
SAME_VECTOR = (
    "Your two velocities are always equal at the end, so both names probably stand for the same "
    "vector, which your code changes in place. Compute a new vector for each of them in each step."
)
OPPOSITE = (
    "In your mean, the differences of the two runs partly cancel. Subtract the two velocities of a "
    "run, and take the length of the result, instead of subtracting their lengths."
)
ONE_RUN = "You return the difference of one run. Return the mean of the differences of all runs."
SUM = "You return the sum over all runs. Divide it by the number of runs to get the mean."
CARRIED = (
    "Your second run starts where the first one ended. Start every run from the given velocity v."
)


def draw_damping(rng: Random) -> float:
    """Draw a damping that is far enough from 1 for each mistake to show."""
    return round(rng.uniform(0.3, 0.9), 3)


# B3.3 Two equations for damping


@pytest.mark.exercise("B3.3", asks="every step keeps the fraction d", read="book 3.3, Eq. 3.5")
def test_damping_per_frame_does_not_depend_on_the_duration(rng: Random) -> None:
    v, a = vector(rng), vector(rng)
    for d, h in ((draw_damping(rng), 0.1), (draw_damping(rng), 0.7), (0.0, 0.5), (1.5, 0.5)):
        with calls(
            "Eq. 3.5 is v' = v d + a h. Multiply the velocity by the damping d, and then add the "
            "acceleration times the duration h."
        ):
            got = forms.damp_per_frame(Vector3(*v), Vector3(*a), damping=d, duration=h)
        undamped = (
            "You treat a damping of 0 as no damping. Python treats 0 as false in an if statement, "
            "so don't use the damping as the condition."
        )
        slips = {
            "You multiply the velocity by damping^duration, as in Eq. 3.6, but this function "
            "implements Eq. 3.5. Multiply it by the damping itself, whatever the duration is.":
                v * d**h + a * h,
            WHOLE: v * d + a,
            "You damp the acceleration as well. In Eq. 3.5 the damping applies only to the old "
            "velocity.": (v + a * h) * d,
            "You don't damp the velocity." if d else undamped: v + a * h,
            "You multiply the velocity by 1 - d, the fraction that is lost. Multiply it by d, the "
            "fraction that is kept.": v * (1.0 - d) + a * h,
            "You multiply the velocity by d h.": v * (d * h) + a * h,
            "You leave out the acceleration.": v * d,
            "You subtract a h. Add it to v d.": v * d - a * h,
        }  # fmt: skip
        expect_close(xyz(got), v * d + a * h, slips, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="every second keeps the fraction d", read="book 3.3, Eq. 3.6")
def test_damping_per_second_depends_on_the_duration(rng: Random) -> None:
    v, drawn = vector(rng), draw_damping(rng)
    for d, h in ((drawn, 0.25), (drawn, 1.0), (drawn, 2.0), (0.0, 0.5), (1.5, 0.5)):
        with calls(
            "The acceleration is 0 here, so Eq. 3.6 becomes v' = v d^h, where d is the damping and "
            "h the duration. Check how you compute d^h."
        ):
            got = forms.damp_per_second(Vector3(*v), Vector3(), damping=d, duration=h)
        slips = {
            "You multiply the velocity by the damping d, as in Eq. 3.5, but this function "
            "implements Eq. 3.6. Multiply it by d^h, where h is the duration.": v * d,
            "You multiply the velocity by the damping times the duration, but in Eq. 3.6 the "
            "duration is an exponent. Use damping**duration.": v * (d * h),
            "You multiply the velocity by 1 - d^h, the fraction that is lost. Multiply it by d^h, "
            "the fraction that is kept.": v * (1.0 - d**h),
            "You swap the base and the exponent. Use damping**duration.": v * h**d,
            "Your exponent is 1 / h, the step rate. Use the duration, as in damping**duration.":
                v * d ** (1.0 / h),
        }  # fmt: skip
        expect_close(xyz(got), v * d**h, slips, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="Compute v' = v d^h + a h", read=EQUATION)
def test_the_equation_does_not_damp_what_the_acceleration_adds(rng: Random) -> None:
    v, a = vector(rng), vector(rng)
    for d in (draw_damping(rng), 0.0, 1.5):
        with calls(
            "Eq. 3.6 is v' = v d^h + a h. Damp only the old velocity, and then add the "
            "acceleration times the duration h without damping it."
        ):
            got = forms.damp_per_second(Vector3(*v), Vector3(*a), damping=d, duration=0.5)
        kept = math.sqrt(d)
        slips = {
            "You damp the acceleration term as well, as the book's listing does (E-16). In Eq. 3.6 "
            "the factor d^h applies only to the old velocity.": (v + 0.5 * a) * kept,
            WHOLE: v * kept + a,
            "You leave out the acceleration.": v * kept,
        }
        expect_close(xyz(got), v * kept + 0.5 * a, slips, tolerance=1e-13)


@pytest.mark.exercise("B3.3", asks="the velocity after a time step as a new vector", read=DOC)
def test_both_equations_give_a_new_vector(rng: Random) -> None:
    first, second = vector(rng), vector(rng)
    for name, kept, formula in (
        ("damp_per_frame", 0.5, "v d + a h"),
        ("damp_per_second", 0.25, "v d^h + a h"),
    ):
        with calls(
            f"The result is wrong. Compute {formula} in a new vector.",
            f"v, a = Vector3{first}, Vector3{second}; {name}(v, a, damping=0.5, duration=2.0)",
        ):
            v, a = Vector3(*first), Vector3(*second)
            got = getattr(forms, name)(v, a, damping=0.5, duration=2.0)
        for which, now, before in (("v", v, first), ("a", a, second)):
            cause = (
                f"You change {which}, which belongs to the caller, because operators such as *= "
                "work in place. Compute the result in a new vector."
            )
            expect_unchanged(which, now, before, cause=cause)
        expect_close(xyz(got), first * kept + second * 2.0, tolerance=1e-13)


# 3.5b The difference of the two equations


def ends(
    v: Triple, a: Triple, runs: list[list[float]], per_frame: float, per_second: float
) -> list[tuple[Triple, Triple]]:
    """Return the velocities after each run, for a factor per frame and another one per second."""
    found = []
    for run in runs:
        by_frame = by_second = v
        for h in run:
            by_frame = by_frame * per_frame + a * h
            by_second = by_second * per_second**h + a * h
        found.append((by_frame, by_second))
    return found


def apart(
    v: Triple, a: Triple, runs: list[list[float]], per_frame: float, per_second: float
) -> float:
    """Return the mean difference for a factor per frame and another one per second."""
    found = [abs(one - other) for one, other in ends(v, a, runs, per_frame, per_second)]
    return math.fsum(found) / len(found)


@pytest.mark.exercise("3.5b", asks="damping ** mean per step (Eq. 3.5)", read=READ)
def test_equal_frames_make_no_difference(rng: Random) -> None:
    v, a, damping = vector(rng), vector(rng), draw_damping(rng)
    h = rng.choice((0.0125, 0.025, 0.05))
    with calls(
        "All steps are equally long, so d ** mean is the factor d^h of Eq. 3.6, and both equations "
        "give the same velocity. Check the factor that you pass to damp_per_frame, and let each "
        "velocity continue from its own value."
    ):
        got = exercises.damping_difference(
            Vector3(*v), Vector3(*a), damping=damping, runs=[[h] * 30, [h] * 20]
        )
    runs = [[h] * 30, [h] * 20]
    # Where one velocity is computed from the other, it is one step ahead of it.
    last, next_one = (
        ends(v, a, [[h] * (n + m) for n in (30, 20)], damping**h, 1.0) for m in (0, 1)
    )
    mixed = [abs(one - other) for (one, _), (other, _) in zip(last, next_one, strict=True)]
    slips = {
        PER_FRAME: apart(v, a, runs, damping, damping),
        "You swap the two factors. Pass d ** mean to damp_per_frame, and d itself to "
        "damp_per_second.": apart(v, a, runs, damping, damping**h),
        "Your mean duration is 0, as after a division with //, which rounds down. Then d ** 0 is "
        "1, and Eq. 3.5 does not damp. Use / instead.": apart(v, a, runs, 1.0, damping),
        "You divide the sum of all durations by the number of runs. Divide it by the number of all "
        "steps to get their mean duration.": apart(v, a, runs, damping ** (25.0 * h), damping),
        "You divide the number of steps by their total time, which is the frame rate. Divide the "
        "time by the number of steps to get the mean duration.":
            apart(v, a, runs, damping ** (1.0 / h), damping),
        "You multiply d by the mean duration. Use the power d ** mean.":
            apart(v, a, runs, damping * h, damping),
        "In each step, you compute one of your two velocities from the other. Let each of them "
        "continue from its own value after the last step.": math.fsum(mixed) / 2.0,
    }  # fmt: skip
    # The rounding errors of numbers up to 20 in 30 steps.
    expect_close(got, 0.0, slips, tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="the mean duration of all steps of all runs", read=READ)
def test_without_acceleration_the_number_of_steps_makes_the_difference(rng: Random) -> None:
    drawn, damping = vector(rng), draw_damping(rng)
    v = 100.0 * drawn  # so fast that a rounded difference is not 0
    long = round(rng.uniform(0.3, 0.5), 2)
    runs = [[0.1, 0.2] * 4, [long, 0.1, long]]
    with calls(
        "Without acceleration, Eq. 3.5 leaves d ** (mean * n) of the velocity after n steps, and "
        "Eq. 3.6 leaves d ** t after t seconds. Use one mean duration for all steps of all runs."
    ):
        got = exercises.damping_difference(Vector3(*v), Vector3(), damping=damping, runs=runs)
    one, two = 1.2, 2.0 * long + 0.1  # the times of the 8 steps and the 3 steps
    kept = damping ** ((one + two) / 11.0)
    first, second = (abs(v) * (kept**n - damping**t) for n, t in ((8, one), (3, two)))
    wanted = (abs(first) + abs(second)) / 2.0
    of_means = damping ** ((one / 8.0 + two / 3.0) / 2.0)
    carried = abs(first) + abs(v) * abs(kept**11 - damping ** (one + two))
    equal = SAME_VECTOR
    if isinstance(got, (int, float)) and abs(got) < 1e-9:
        # Without acceleration, a mean of each run gives 0, too. With one, it does not.
        other = exercises.damping_difference(Vector3(), Vector3(*drawn), damping, runs)
        equal = SAME_VECTOR if isinstance(other, (int, float)) and abs(other) < 1e-9 else OWN_MEAN
    slips = {
        PER_FRAME: apart(v, ZERO, runs, damping, damping),
        equal: 0.0,
        OPPOSITE: abs(first + second) / 2.0,
        f"{OPPOSITE} A length is never negative.": -abs(first + second) / 2.0,
        "You divide with //, which rounds down to a whole number. Use / instead.": wanted // 1.0,
        "You compute the mean of each run, and then the mean of these means. A long run has more "
        "steps, so divide the sum of all durations by the number of all steps.":
            apart(v, ZERO, runs, of_means, damping),
        SUM: 2.0 * wanted,
        "You divide the sum of the differences by the number of steps. Divide it by the number of "
        "runs.": 2.0 * wanted / 11.0,
        ONE_RUN: abs(first),
        f"{ONE_RUN} It is that of the last run.": abs(second),
        "You return the mean of the squared lengths. Take the length, which is magnitude().":
            (first**2 + second**2) / 2.0,
        CARRIED: carried / 2.0,
    }  # fmt: skip
    # The rounding errors of numbers up to 2000.
    expect_close(got, wanted, slips, tolerance=1e-10)


@pytest.mark.exercise("3.5b", asks="Return the mean over all runs", read=READ)
def test_the_difference_is_averaged_over_the_runs(rng: Random) -> None:
    v, a, damping = vector(rng), vector(rng), draw_damping(rng)
    runs = [[round(rng.uniform(0.05, 0.3), 3) for _ in range(n)] for n in (2, 3, 5)]
    per_frame = damping ** (math.fsum(map(math.fsum, runs)) / 10.0)  # 10 steps in all
    found = ends(v, a, runs, per_frame, damping)
    joined = [runs[0], runs[0] + runs[1], runs[0] + runs[1] + runs[2]]
    wanted, carried = apart(v, a, runs, per_frame, damping), apart(v, a, joined, per_frame, damping)
    with calls(
        "Take the length of the difference of the two velocities at the end of each run, and "
        "return the mean of these lengths."
    ):
        got = exercises.damping_difference(Vector3(*v), Vector3(*a), damping=damping, runs=runs)
    slips = {
        SUM: wanted * 3.0,
        "You return the difference of the speeds. Subtract the velocities as vectors first, and "
        "then take the length of the difference.":
            math.fsum(abs(abs(one) - abs(other)) for one, other in found) / 3.0,
        "You return the difference after the last run alone.": abs(found[-1][0] - found[-1][1]),
        CARRIED: carried,
    }  # fmt: skip
    expect_close(got, wanted, slips, tolerance=1e-12)


@pytest.mark.exercise("3.5b", asks="None of these functions changes its arguments", read=DOC)
def test_the_difference_is_zero_without_damping(rng: Random) -> None:
    """Of the checks of this function, only this one tests whether the vectors change."""
    first, second = vector(rng), vector(rng)
    with calls(
        "With a damping of 1, both equations give v + a h, so the difference must be 0. Check how "
        "you use the damping in each of them."
    ):
        v, a = Vector3(*first), Vector3(*second)
        got = exercises.damping_difference(v, a, damping=1.0, runs=[[0.5, 0.5]])
    expect_close(got, 0.0, tolerance=1e-13)
    expect_unchanged("v", v, first, cause=UNCHANGED)
    expect_unchanged("a", a, second, cause=UNCHANGED)
