"""A Catherine wheel without a force, mini-project 4.4."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch04_particle_engine import probes
from ch04_particle_engine.catherine_wheel import CatherineWheel
from draw import Components, components
from expect import about, blame, expect_close, expect_error, expect_exactly, expect_unchanged, xyz

STILL = (0.0, 0.0, 0.0)
SPARK: probes.RuleData = (7, 9.0, 9.0, STILL, STILL, 1.0, ())

ROUNDED = 1e-12  # some roundings of numbers up to 30, and of a sine


def wheel_of(
    center: Components,
    radius: float = 1.0,
    rate: float = 2.0,
    sparks_per_second: float = 10.0,
    jet: float = 0.0,
    capacity: int = 500,
) -> tuple[Any, Any]:
    """Return a show with one kind of spark, and a wheel."""
    show = probes.show_of([SPARK], capacity, "keep_old", 1)
    return show, CatherineWheel(show, 7, Vector3(*center), radius, rate, sparks_per_second, jet)


@pytest.mark.exercise("4.4")
def test_the_nozzle_is_on_the_rim_and_moves_with_it(rng: Random) -> None:
    center, about.read = components(rng), "the docstring of nozzle"
    radius, rate = round(rng.uniform(0.5, 3.0), 3), round(rng.uniform(1.0, 9.0), 3)
    _, wheel = wheel_of(center, radius, rate)
    for angle in (0.0, round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(2.0, 6.0), 3)):
        about.call = (
            f"wheel about {center}, radius {radius}, rate {rate}; wheel.angle = {angle}; "
            "wheel.nozzle()"
        )
        wheel.angle = angle
        nozzle = wheel.nozzle()
        x, y = math.cos(angle), math.sin(angle)
        about.cause = (
            "The nozzle sits on the rim, at center + radius (cos, sin, 0), with the angle measured "
            "from the X axis."
        )
        wanted = (center[0] + radius * x, center[1] + radius * y, center[2])
        got = xyz(nozzle.position)
        expect_close(got, wanted, then=".position", tolerance=1e-13)
        about.cause = (
            "The velocity of the nozzle is at right angles to the spoke and points from X toward "
            "Y. Its length is rate x radius."
        )
        speed = rate * radius
        wanted = (0.0 - speed * y, speed * x, 0.0)
        got = xyz(nozzle.velocity)
        mistakes = [
            (
                (speed * x, speed * y, 0.0),
                "The velocity points along the spoke, but the rim moves at right angles to it. "
                "Rotate the velocity by a quarter turn.",
            ),
            (
                (speed * y, 0.0 - speed * x, 0.0),
                "The rim moves in the wrong direction. The wheel must turn from X toward Y.",
            ),
            (
                (0.0 - rate * y, rate * x, 0.0),
                "The speed equals the rate, which is an angle per second. Multiply it by the "
                "radius to get the speed of the rim.",
            ),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, then=".velocity", tolerance=ROUNDED)
    about.call = "one = wheel.nozzle(); other = wheel.nozzle(); one.position.x = 99; other.position"
    about.cause = (
        "Two calls to nozzle returned the same particle, or two particles that share a vector. "
        "Create a new particle in every call."
    )
    one, other = wheel.nozzle(), wheel.nozzle()
    before = xyz(other.position)
    one.position.x = 99.0
    expect_unchanged("other.position", xyz(other.position), before)


@pytest.mark.exercise("4.4")
def test_the_jet_goes_against_the_rim(rng: Random) -> None:
    about.read = "the docstring of nozzle"
    rate, jet = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(7.0, 9.0), 3)
    about.call = f"wheel about (0, 5, 0), radius 2, rate {rate}, jet {jet}; wheel.nozzle().velocity"
    about.cause = (
        "The speed along the circle is rate x radius minus the jet, so it is negative if the jet "
        "is faster than the rim."
    )
    _, wheel = wheel_of((0.0, 5.0, 0.0), 2.0, rate, jet=jet)
    got = xyz(wheel.nozzle().velocity)
    mistakes = [
        (
            (0.0, 2.0 * rate + jet, 0.0),
            "You added the speed of the jet to that of the rim. Subtract it, because the jet "
            "blows against the motion of the rim.",
        ),
        (
            (0.0, 2.0 * rate, 0.0),
            "The jet has no effect on the velocity. Subtract its speed from the speed of the rim.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, (0.0, 2.0 * rate - jet, 0.0), tolerance=ROUNDED)


@pytest.mark.exercise("4.4")
def test_the_wheel_turns_by_its_rate(rng: Random) -> None:
    about.read = "the docstring of update"
    rate, h = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(0.1, 0.4), 3)
    about.call = f"wheel with rate {rate}; wheel.update({h}) twice; wheel.nozzle().position"
    about.cause = "Each update must rotate the wheel, so add rate x duration to its angle."
    _, wheel = wheel_of((0.0, 5.0, 0.0), 1.0, rate)
    wheel.update(h)
    wheel.update(h)
    angle = 2.0 * rate * h
    wanted = (math.cos(angle), 5.0 + math.sin(angle), 0.0)
    got = xyz(wheel.nozzle().position)
    expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("4.4")
def test_sparks_are_due_by_the_time_and_not_by_the_frame(rng: Random) -> None:
    about.read = "the docstring of update"
    per_second = rng.randrange(20, 60) + 0.37
    # Sums of frames that are exact in binary, so that no whole spark lies on a rounding.
    for h, frames in ((1.0 / 64.0, 128), (1.0 / 4.0, 8), (2.0, 1)):
        about.call = (
            f"wheel with {per_second} sparks a second; wheel.update({h}) {frames} times; sparks"
        )
        counts = probes.sparks_of_a_wheel(per_second, h, frames)
        about.cause = (
            "After a time t, the whole-number part of sparks_per_second x t must have left the "
            "wheel, however long the steps are."
        )
        if counts[-1] == frames:
            about.cause = (
                "One spark left in every step. The number must depend on how much time has passed, "
                "not on how many steps it took."
            )
        if counts[-1] == 0:
            about.cause = (
                "No sparks left the wheel, because each step is too short for a whole spark. Carry "
                "the fraction of a spark over from step to step."
            )
        expect_exactly(counts[-1], math.floor(per_second * 2.0))
        about.cause = (
            "A step can end with a fraction of a spark. Carry that fraction over to the next step, "
            "so that no sparks are lost."
        )
        wanted = [math.floor(per_second * h * (i + 1)) for i in range(frames)]
        expect_exactly(counts, wanted, then=" after each")


@pytest.mark.exercise("4.4")
def test_sparks_leave_from_the_nozzle_with_its_velocity(rng: Random) -> None:
    about.read = "the docstring of update"
    rate, jet = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(7.0, 9.0), 3)
    about.call = (
        f"wheel about (0, 5, 0), radius 2, rate {rate}, jet {jet}, 10.5 sparks a second; "
        "wheel.update(0.25)"
    )
    about.cause = (
        "The sparks leave from the nozzle, so pass the nozzle's particle at the end of the step as "
        "their parent."
    )
    show, wheel = wheel_of((0.0, 5.0, 0.0), 2.0, rate, 10.5, jet)
    wheel.update(0.25)
    expect_exactly(len(show.fireworks), 2, then=", how many")
    x, y = math.cos(0.25 * rate), math.sin(0.25 * rate)
    speed = 2.0 * rate - jet
    for spark in show.fireworks:
        expect_exactly(spark.type, 7, then=", a type")
        got, wanted = xyz(spark.particle.position), (2.0 * x, 5.0 + 2.0 * y, 0.0)
        before = (
            "The sparks left before the wheel had turned. Rotate the wheel first, and then light "
            "the sparks."
        )
        blame(got, [((2.0, 5.0, 0.0), before)])
        expect_close(got, wanted, then=", a position", tolerance=ROUNDED)
        got, wanted = xyz(spark.particle.velocity), (-speed * y, speed * x, 0.0)
        expect_close(got, wanted, then=", a velocity", tolerance=ROUNDED)


@pytest.mark.exercise("4.4")
def test_sparks_that_found_no_room_are_not_thrown_later() -> None:
    about.call = "a show of 3 slots, wheel with 10.5 sparks a second; wheel.update(1)"
    about.cause = "After 1 s, 10 sparks are due, but the show has room for only 3 of them."
    about.read = "the docstring of update"
    show, wheel = wheel_of((0.0, 5.0, 0.0), capacity=3, sparks_per_second=10.5)
    wheel.update(1.0)
    expect_exactly(len(show.fireworks), 3, then="; len(show.fireworks)")
    about.cause = (
        "After 1 s, 10 sparks are due. Count all of them in wheel.thrown, even those that found no "
        "slot."
    )
    if wheel.thrown == 3:
        about.cause = (
            "You counted only the 3 sparks that found a slot, so the other 7 would be thrown "
            "later. Add all 10 that were due to wheel.thrown."
        )
    expect_exactly(wheel.thrown, 10, then="; wheel.thrown")
    show.update(10.0)
    wheel.update(0.5)
    about.call += "; show.update(10), so that all go out; wheel.update(0.5)"
    about.cause = (
        "After 1.5 s, 15 sparks are due in total. You have already counted 10 of them, so throw 5 "
        "more."
    )
    expect_exactly(wheel.thrown, 15, then="; wheel.thrown")
    about.cause = (
        "The show drops 7 of the first 10 sparks and 2 of the last 5. Check that the second update "
        "lights exactly 5."
    )
    expect_exactly(show.dropped, 7 + 2, then="; show.dropped")


@pytest.mark.exercise("4.4")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -0.5, math.inf, math.nan])
def test_a_wheel_turns_for_a_positive_and_finite_time(bad: float) -> None:
    about(
        f"wheel.update({bad})",
        cause="The duration must be positive and finite. Check it before you change anything.",
    )
    about.read = "the docstring of update"
    _, wheel = wheel_of((0.0, 5.0, 0.0))
    expect_error(
        lambda: wheel.update(bad),
        ValueError,
        allowed=lambda: wheel_of((0.0, 5.0, 0.0))[1].update(0.5),
    )
    now = (wheel.angle, wheel.time)
    expect_unchanged("its angle and time", now, (0.0, 0.0))
