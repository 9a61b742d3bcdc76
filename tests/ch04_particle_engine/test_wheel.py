"""A Catherine wheel without a force, mini-project 4.4."""

from __future__ import annotations

import itertools
import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch04_particle_engine import probes
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.probes import STILL, fixed
from draw import Components, Triple, vector
from expect import about, expect_close, expect_exactly, expect_unchanged, named, xyz

NOZZLE, UPDATE = "the docstring of nozzle", "the docstring of update"
MIDDLE = Triple((0.0, 5.0, 0.0))

ROUNDED = 1e-12  # some roundings of numbers up to 30, and of a sine


def wheel_of(center: Components, *numbers: float, capacity: int = 500) -> tuple[Any, Any]:
    """Return a show with one kind of spark, and a wheel. Its radius is the first of the numbers."""
    show = probes.show_of([fixed(7, 9.0, STILL)], capacity, "keep_old", 1)
    return show, CatherineWheel(show, 7, Vector3(*center), *numbers)


def spoke(angle: float) -> Triple:
    """Return the direction from the center of a wheel to its nozzle."""
    return Triple((math.cos(angle), math.sin(angle), 0.0))


def tangent(angle: float) -> Triple:
    """Return the direction in which the rim of a wheel moves at its nozzle."""
    return Triple((-math.sin(angle), math.cos(angle), 0.0))


@pytest.mark.exercise("4.4", asks="with a velocity perpendicular to the spoke", read=NOZZLE)
def test_the_nozzle_is_on_the_rim_and_moves_with_it(rng: Random) -> None:
    center, radius = vector(rng), round(rng.uniform(0.5, 3.0), 3)
    rate = round(rng.uniform(1.0, 9.0), 3)
    _, wheel = wheel_of(center, radius, rate, 10.0)
    for angle in (0.0, round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(2.0, 6.0), 3)):
        cause = "The position must be center + radius (cos a, sin a, 0) with a = wheel.angle."
        with calls(
            cause,
            f"a wheel with its center at {center}, a radius of {radius} m and a rate of {rate} "
            f"rad/s; wheel.angle = {angle}; wheel.nozzle()",
        ):
            wheel.angle = angle
            nozzle = wheel.nozzle()
        out, along = spoke(angle), tangent(angle)
        slips = {
            "You leave out the center of the wheel, so the nozzle rotates around the origin. Add "
            "the center to its position.": radius * out,
            "You leave out the radius. Multiply the cosine and the sine by it.": center + out,
            "You have swapped the sine and the cosine. The X axis takes the cosine.":
                center + radius * Triple((out[1], out[0], 0.0)),
            "The angle of the wheel is in radians already. Don't convert it.":
                center + radius * spoke(math.radians(angle)),
        }  # fmt: skip
        why = named(xyz(nozzle.position), cause, slips)
        if xyz(wheel.center) != center:
            why = "You change the center of the wheel, as += does. Compute a new vector."
        wanted = center + radius * out
        expect_close(
            nozzle.position, wanted, then=".position", unit="m", tolerance=1e-13, cause=why
        )
        slips = {
            "Your nozzle moves along the spoke, away from the center.": rate * radius * out,
            "Your nozzle moves in the wrong direction along the rim. The wheel rotates from X "
            "toward Y, so flip the sign of the velocity.": -rate * radius * along,
            "You use the rate of the wheel, in rad/s, as the speed of the nozzle. Multiply the "
            "rate by the radius to get the speed in m/s.": rate * along,
        }
        right = "It must move perpendicular to the spoke, from X toward Y, at rate x radius."
        expect_close(
            nozzle.velocity,
            rate * radius * along,
            slips,
            then=".velocity",
            unit="m/s",
            tolerance=ROUNDED,
            cause=right,
        )
    with calls(
        "Your nozzle method returned the same particle twice, or two particles that share a "
        "vector. Create a new particle in every call.",
        "one = wheel.nozzle(); other = wheel.nozzle(); one.position.x = 99; other.position",
    ):
        one, other = wheel.nozzle(), wheel.nozzle()
        before = xyz(other.position)
        one.position.x = 99.0
    expect_unchanged("other.position", other.position, before)


@pytest.mark.exercise("4.4", asks="is the speed of the rim minus jet", read=NOZZLE)
def test_the_jet_goes_against_the_rim(rng: Random) -> None:
    rate, jet = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(7.0, 9.0), 3)
    with calls(
        "The speed of the sparks is rate x radius minus jet. It is negative here, because the jet "
        "is faster than the rim.",
        f"a wheel with radius 2 m, rate {rate} rad/s and jet {jet} m/s; wheel.nozzle().velocity",
    ):
        got = wheel_of(MIDDLE, 2.0, rate, 10.0, jet)[1].nozzle().velocity
    slips = {
        "You add the speed of the jet to the speed of the rim. Subtract it, because the sparks "
        "leave the nozzle against the motion of the rim.": (0.0, 2.0 * rate + jet, 0.0),
        "You ignore the jet. Subtract its speed from the speed of the rim, which is rate x "
        "radius.": (0.0, 2.0 * rate, 0.0),
    }
    expect_close(got, (0.0, 2.0 * rate - jet, 0.0), slips, unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("4.4", asks="Rotate the wheel for duration s", read=UPDATE)
def test_the_wheel_turns_by_its_rate(rng: Random) -> None:
    rate, h = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(0.1, 0.4), 3)
    with calls(
        "Add rate x duration to the angle of the wheel in every update.",
        f"a wheel with its center at (0, 5, 0), a radius of 1 m and a rate of {rate} rad/s; "
        f"wheel.update({h}) twice; wheel.nozzle().position",
    ):
        _, wheel = wheel_of(MIDDLE, 1.0, rate, 10.0)
        wheel.update(h)
        wheel.update(h)
        got = wheel.nozzle().position
    slips = {
        "You don't rotate the wheel.": MIDDLE + spoke(0.0),
        "After two updates, your wheel has rotated by the angle of one. Add to the angle in each "
        "update instead of replacing it.": MIDDLE + spoke(rate * h),
        "You add the duration to the angle. Multiply it by the rate first, which says how many "
        "radians the wheel rotates per second.": MIDDLE + spoke(2.0 * h),
    }
    expect_close(got, MIDDLE + spoke(2.0 * rate * h), slips, unit="m", tolerance=ROUNDED)


def why_another_number(counts: list[int], per_second: float, h: float, cause: str) -> str:
    """Return why a wheel has lit the wrong number of sparks in 2 s."""
    frames, last = len(counts), counts[-1]
    wanted = [math.floor(per_second * h * (i + 1)) for i in range(frames)]
    again = due = 0
    for whole in wanted:
        if whole > due:
            again, due = again + whole - due, whole - due
    slips = {
        "Each step throws all sparks since the start again. Either you never change thrown, or you "
        "don't subtract it to get the number of sparks that are due.": sum(wanted),
        "You replace thrown by the sparks of the last step. Add them to it, because thrown counts "
        "all sparks since the start.": again,
        "You light a spark that is not due yet, because you round up or to the nearest number. "
        "Round down with math.floor.": math.ceil(per_second * 2.0),
    }
    if any(after < earlier for earlier, after in itertools.pairwise(counts)):
        return "Sparks disappear while the wheel rotates. Don't update the show in its update."
    if last == 0:
        if probes.sparks_of_a_wheel(per_second, 2.0, 1)[-1] == 0:
            return "You light no sparks. Change the wheel's time, and pass them to show.light."
        return "You round down in every step. Carry the fraction of a spark over to the next step."
    if last == frames == 128:
        return "You light one spark in every step. The number must depend on the time."
    if last == frames:
        return "You light only one spark in a step. Pass the number that is due to show.light."
    return named(last, cause, slips) if frames > 1 else cause


@pytest.mark.exercise("4.4", asks="does not depend on the length of the steps", read=UPDATE)
def test_the_number_of_sparks_depends_only_on_the_time(rng: Random) -> None:
    per_second = rng.randrange(20, 60) + 0.37
    # Sums of frames that are exact in binary, so that no whole spark lies on a rounding.
    for h, frames in ((1.0 / 64.0, 128), (1.0 / 4.0, 8), (2.0, 1)):
        with calls(
            "The number of sparks must not depend on the length of the steps. After t seconds it "
            "is sparks_per_second x t, rounded down.",
            f"a wheel that throws {per_second} sparks per second; wheel.update({h}), called "
            f"{frames} times, 2 s in total; the number of sparks lit",
        ):
            counts = probes.sparks_of_a_wheel(per_second, h, frames)
            why = why_another_number(counts, per_second, h, about.cause)
        expect_exactly(counts[-1], math.floor(per_second * 2.0), cause=why)
        carry = "If a step ends with a fraction of a spark, carry it over to the next step."
        wanted = [math.floor(per_second * h * (i + 1)) for i in range(frames)]
        expect_exactly(counts, wanted, then=", after each update", cause=carry)


@pytest.mark.exercise("4.4", asks="All sparks of a step start where the nozzle is", read=UPDATE)
def test_sparks_leave_from_the_nozzle_with_its_velocity(rng: Random) -> None:
    rate, jet = round(rng.uniform(1.0, 3.0), 3), round(rng.uniform(7.0, 9.0), 3)
    with calls(
        "The sparks must start at the nozzle. Pass the particle that nozzle returns at the end of "
        "the step as their parent.",
        f"a wheel with its center at (0, 5, 0), a radius of 2 m and a rate of {rate} rad/s; its "
        f"jet of {jet} m/s throws 10.5 sparks per second; wheel.update(0.25)",
    ):
        show, wheel = wheel_of(MIDDLE, 2.0, rate, 10.5, jet)
        wheel.update(0.25)
    expect_exactly(len(show.fireworks), 2, then="; the number of sparks lit")
    angle = 0.25 * rate
    slips = {
        "You light the sparks before the wheel has rotated. Change the angle first.": (
            2.0,
            5.0,
            0.0,
        )
    }
    for spark in show.fireworks:
        expect_exactly(spark.type, 7, then="; the type of a spark")
        for name, got, wanted, wrong, unit in (
            ("position", spark.particle.position, MIDDLE + 2.0 * spoke(angle), slips, "m"),
            ("velocity", spark.particle.velocity, (2.0 * rate - jet) * tangent(angle), {}, "m/s"),
        ):
            then = f"; the {name} of a spark"
            expect_close(got, wanted, wrong, then=then, unit=unit, tolerance=ROUNDED)


@pytest.mark.exercise("4.4", asks="as thrown even if the show has no room", read=UPDATE)
def test_sparks_that_found_no_room_are_not_thrown_later() -> None:
    with calls(
        "The wheel throws 10 sparks in 1 s, but the show has room for only 3. Pass all of them to "
        "show.light, which doesn't exceed the capacity.",
        "a show with 3 free slots; a wheel that throws 10.5 sparks per second; wheel.update(1.0)",
    ):
        show, wheel = wheel_of(MIDDLE, 1.0, 2.0, 10.5, capacity=3)
        wheel.update(1.0)
    expect_exactly(len(show.fireworks), 3, then="; len(show.fireworks)")
    why = "Count all 10 sparks of the first second in wheel.thrown, even those without a free slot."
    if wheel.thrown == 3:
        why = "You count only sparks that got a slot. Also count those that found none."
    expect_exactly(wheel.thrown, 10, then="; wheel.thrown", cause=why)
    with calls(
        "The wheel throws 15 sparks in 1.5 s. It already threw 10 of them in the first second, so "
        "it must throw 5 more now.",
        "show.update(10.0), after which no spark burns; wheel.update(0.5)",
        more=True,
    ):
        show.update(10.0)
        wheel.update(0.5)
    expect_exactly(wheel.thrown, 15, then="; wheel.thrown")
    five = "The show must drop 7 of the first 10 sparks and 2 of the 5 of the second update."
    expect_exactly(show.dropped, 7 + 2, then="; show.dropped", cause=five)
