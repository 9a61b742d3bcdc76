"""Time steps that stop at each impact, build task B7.12."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.flight_probes import flown
from ch07_constraints.time_division import time_division_step
from draw import Triple, positive_number
from expect import (
    expect_between,
    expect_close,
    expect_error,
    expect_exactly,
    expect_that,
    expect_unchanged,
    xyz,
)  # fmt: skip

READ = "book 7.3.2, and the docstring of time_division_step"
DOWN = Triple((0.0, -10.0, 0.0))
FRAME = 1.0 / 60.0
IMPACTS, PLACE, VELOCITY = "; the number of impacts", "; p.position", "; p.velocity"
ZERO = (0.0, 0.0, 0.0)
ZERO_DURATION = "Pass a duration of 0 to resolve_velocity, which ignores what a step has added."


def dropped(
    cause: str, height: float, e: float, h: float, times: int, most: int = 1000, damping: float = 1
) -> Any:
    """Drop a ball, and return the results of flown, but only heights and vertical velocities."""
    limit = "" if most == 1000 else f", max_impacts={most}"
    text = f"a ball (damping {damping:g}) falls {height:g} m to the ground with gravity of 10 "
    text += f"m/s^2 and bounces with a restitution of {e}; time_division_step([ball], ground, "
    with calls(cause, f"{text}{h:.6g}{limit}){f' up to {times} times' if times > 1 else ''}"):
        ball = Particle(Vector3(0.0, height, 0.0), None, Vector3(*DOWN), damping=damping)
        seen, *others = flown([ball], GroundPlane([ball], restitution=e), h, times, most)
    return [(place[1], velocity[1]) for ((place, velocity),) in seen], *others


@pytest.mark.exercise("B7.12", asks="Between impacts the motion is exact", read=READ)
def test_without_an_impact_the_flight_is_exact(rng: Random) -> None:
    v = Triple((positive_number(rng), positive_number(rng), -positive_number(rng)))
    place, h = Triple((0.0, 9.0, 0.0)), 0.5
    with calls("The motion is exact: p + v t + a t^2 / 2, with the velocity v + a t."):
        p = Particle(Vector3(*place), Vector3(*v), Vector3(*DOWN), mass=2.0)
        time_division_step([p], GroundPlane([p]), h)
    slips = {
        "The particle hasn't moved. When there is no further impact, move it for the rest of the "
        "step.": place,
        "You left out the term a t^2 / 2, as explicit Euler does.": place + v * h,
        "You added a t^2 to the position, but the correct term is only half as large.":
            place + v * h + DOWN * h * h,
    }  # fmt: skip
    wanted = place + v * h + DOWN * (0.5 * h * h)
    expect_close(xyz(p.position), wanted, slips, then=PLACE, unit="m")
    expect_close(xyz(p.velocity), v + DOWN * h, then=VELOCITY, unit="m/s")
    with calls("You changed an immovable particle. Leave its position and its velocity unchanged."):
        p = Particle(Vector3(*place), Vector3(*v), Vector3(*DOWN), mass=math.inf)
        p.add_force(Vector3(1.0, 2.0, 3.0))
        time_division_step([p], GroundPlane([p]), h)
    expect_close(xyz(p.position), place, then=PLACE, unit="m")
    expect_close(xyz(p.velocity), v, then=VELOCITY, unit="m/s")
    why = "You left the force in the accumulator. Call kick(0.0) on immovable particles, too."
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", cause=why, unit="N")


@pytest.mark.exercise("B7.12", asks="stop at each impact to resolve it", read=READ)
def test_a_ball_bounces_at_the_right_times(rng: Random) -> None:
    e = round(rng.uniform(0.55, 0.9), 3)  # at 0.5 the bounces end at 3 s
    # It falls for 1 s, bounces at e times 10 m/s, and flies for 2 e, 2 e^2, ... seconds.
    last, bounces = 1.0, 1
    while last + 2.0 * e**bounces <= 3.0:
        last += 2.0 * e**bounces
        bounces += 1
    speed, left = 10.0 * e**bounces, 3.0 - last
    for times, h in ((1, 3.0), (180, FRAME)):
        why = "You missed an impact of this step. After each impact, call next_impact again for "
        why += "what is left of the step: subtract the time of the impact."
        seen, found, asked, _ = dropped(why, 5.0, e, h, times)
        if len(found) > 1000 and asked[-1] == h:
            why = "You pass the whole duration to next_impact again. Pass only what is left."
        elif len(found) > 1000:
            why = f"Your ball stops bouncing. {ZERO_DURATION}"
        elif len(found) > bounces and found[1][2] < 1e-9:
            why = "You resolved it before you moved the particles. Move them to its time first."
        elif len(found) > bounces:
            why = "You found too many impacts. Pass only the time that is left to next_impact."
        expect_exactly(len(found), bounces, then=IMPACTS, cause=why, unit="impacts")
        # Some 200 flights, each with a few roundings of 10 m.
        name = "; the final height in m and the final velocity along y in m/s"
        end = (speed * left - 5.0 * left * left, speed - 10.0 * left)
        why = f"The ball bounces with the wrong speed. {ZERO_DURATION}"
        expect_close(seen[-1], end, then=name, cause=why, tolerance=1e-11)
        why = "Call next_impact once at the start of each step, with the duration of the whole "
        why += "step, and once more after each impact, with the rest of the step."
        name = "; the number of calls to next_impact and the longest duration passed to it in s"
        expect_close((len(asked), max(asked)), (times + bounces, h), then=name, cause=why)


@pytest.mark.exercise("B7.12", asks="of its contact with a duration of 0", read=READ)
def test_a_restitution_of_1_loses_no_energy() -> None:
    why = "No bounce loses energy here. Check how you move the particles between two impacts."
    seen, found, _, _ = dropped(why, 2.0, 1.0, FRAME, 1200)
    heights = [height + velocity**2 / 20.0 for height, velocity in seen]
    # 1200 steps, each with a few roundings of 2 m.
    name = "; the lowest and highest energy / (m g)"
    expect_close((min(heights), max(heights)), (2.0, 2.0), tolerance=1e-11, then=name)
    why = "The first impact is after sqrt(0.4) s, and the others follow every 2 sqrt(0.4) s."
    expect_exactly(len(found), 16, then=IMPACTS, cause=why, unit="impacts")


@pytest.mark.exercise(
    "B7.12", asks="another impact after max_impacts impacts", read="the docstring of TooManyImpacts"
)
def test_a_ball_at_rest_raises_too_many_impacts() -> None:
    wrong = "error.impacts is wrong. Raise TooManyImpacts with the number of resolved impacts."
    many = "You resolved one impact too many. Raise TooManyImpacts without resolving it."
    why = "The impacts never end as the ball comes to rest. Raise TooManyImpacts at the limit."
    seen, _, _, ended = dropped(why, 2.0, 0.5, FRAME, 200)
    expect_that(ended is not None, "no error in 200 steps", "TooManyImpacts", then="; the error")
    impacts, time = ended or (0, 0.0)
    # The last bounces that floats can distinguish are 1e-9 s apart.
    started, ends = (len(seen) - 1) * FRAME, 1.8973666
    if abs(started + FRAME - time - ends) < 1e-7:
        why = "You passed the time that is left in the step. Pass the time since its start."
    name = "; the start of the last step plus error.time"
    expect_close(started + time, ends, then=name, cause=why, tolerance=1e-7, unit="s")
    why = many if impacts == 1001 else wrong
    expect_exactly(impacts, 1000, then="; error.impacts", cause=why)
    why = "On the ground, one impact follows another at time 0. Raise TooManyImpacts."
    _, _, _, ended = dropped(why, 0.0, 0.5, FRAME, 1)
    expect_close(ended or (0, -1.0), (1000, 0.0), then="; error.impacts and error.time in s")
    why = "max_impacts=3 allows three impacts. Raise TooManyImpacts only if there is another."
    _, _, _, ended = dropped(why, 5.0, 0.5, 2.6, 1, most=3)
    expect_that(ended is None, "TooManyImpacts", "no error")
    for most in (3, 1):
        why = "Before the error, move on to the next impact. Don't resolve it, and don't damp."
        seen, _, _, ended = dropped(why, 5.0, 0.5, 9.0, 1, most, damping=0.5)
        impacts, time = ended or (0, 0.0)
        why = many if impacts == most + 1 else wrong
        expect_exactly(impacts, most, then="; error.impacts", cause=why)
        why = "You damped the velocity at each impact. Damp it once, at the end of the step."
        ends = (1.0, 2.0, 2.5, 2.75)[most]
        expect_close(time, ends, then="; error.time", cause=why, tolerance=1e-12, unit="s")
        speed = -10.0 * 0.5**most
        damped = "You applied the damping before you raised TooManyImpacts. Damping acts only at "
        damped += "the end of a complete step"
        slips = {
            "You raised it at the last allowed impact. Move on to the next one.": (0.0, -speed),
            many: (0.0, -0.5 * speed),
            f"{damped}, so raise the error first.": (0.0, speed * 0.5**ends),
            f"{damped}. Raise the error first.": (0.0, speed * 0.5**9.0),
        }
        name = "; the height in m and the velocity along y in m/s after the error"
        expect_close(seen[0], (0.0, speed), slips, then=name, tolerance=1e-12)


@pytest.mark.exercise("B7.12", asks="in the order in which they are found", read=READ)
def test_a_cradle_passes_its_motion_on(rng: Random) -> None:
    speed = positive_number(rng, 0.5, 3.0)  # slow enough that a late exchange shows
    gap = 0.75 * speed  # they arrive in the middle of a step
    for count in (1, 2, 3):
        with calls(
            "Each impact passes the velocity on to the next sphere, so as many spheres should "
            "leave as arrive. Resolve simultaneous impacts one after another.",
            "five spheres (radius 1 m, 2 kg) in a row, with a restitution of 1; the first "
            f"{count} of them at {speed} m/s reach{'es' if count == 1 else ''} the others, which "
            "touch, after 0.75 s; time_division_step(spheres, pairs, 0.5) 4 times",
        ):
            spheres = [
                Particle(Vector3(2.0 * i - gap * (i < count)), Vector3(speed * (i < count)), mass=2)
                for i in range(5)
            ]
            seen, found, _, _ = flown(spheres, ParticlePairs(spheres, 1.0, 1.0), 0.5, 4)
        got = tuple(velocity[0] for _, velocity in seen[-1])
        wanted = tuple(speed if i >= 5 - count else 0.0 for i in range(5))
        name = "; the final velocities along the row"
        expect_close(got, wanted, tolerance=1e-13, then=name, unit="m/s")
        expect_exactly(len(found), count * (5 - count), then=IMPACTS, unit="impacts")


@pytest.mark.exercise("B7.12", asks="finds in the rest of the step", read=READ)
def test_impacts_are_resolved_in_order(rng: Random) -> None:
    # The light sphere in the middle is hit from both sides in turn.
    far = 3.0 + positive_number(rng, 0.1, 0.9)
    with calls(
        "The left and the middle sphere meet first, after 1 s, and this changes the time of the "
        "next impact. Call next_impact again after each impact.",
        f"three spheres (radius 1 m; 3, 1 and 3 kg) at x = -3, 0 and {far:g}, with velocities of "
        "1, 0 and -1 m/s and a restitution of 1; time_division_step(spheres, pairs, 5.0)",
    ):
        a, c = (Particle(Vector3(x), Vector3(v), mass=3.0) for x, v in ((-3.0, 1.0), (far, -1.0)))
        spheres = [a, Particle(), c]
        seen, found, _, _ = flown(spheres, ParticlePairs(spheres, 1.0, 1.0), 5.0, 1)
    # After the first impact: 3 kg at 0.5, 1 kg at 1.5 m/s, which meets the right one at 2.5 m/s.
    got = tuple(time for _, _, time in found[:2])
    name = "; the time of the first impact, and the time from then to the second one"
    expect_close(got, (1.0, (far - 3.0) / 2.5), then=name, tolerance=1e-13, unit="s")
    name = "; the indices of the two spheres in the first two impacts"
    expect_exactly([index for *pair, _ in found[:2] for index in pair], [0, 1, 1, 2], then=name)
    (p, u), (q, v), (r, w) = ((place[0], velocity[0]) for place, velocity in seen[0])
    why = "Impacts with a restitution of 1 conserve both. Resolve each impact only once."
    got = (math.fsum((3.0 * u, v, 3.0 * w)), math.fsum((1.5 * u * u, 0.5 * v * v, 1.5 * w * w)))
    name = "; the final momentum in kg m/s and kinetic energy in J"
    expect_close(got, (0.0, 3.0), then=name, cause=why, tolerance=1e-13)
    why = "Two spheres have passed through each other, so you missed an impact."
    name = "; the smallest final gap"
    expect_between(min(q - p, r - q) - 2.0, -1e-13, math.inf, then=name, cause=why, unit="m")


def bounced(high: float, a: float, h: float) -> tuple[float, float]:
    """Return height and velocity after ``h`` s, if a ball moves down at 4 m/s and bounces once.

    It starts at a height of ``high``, ``a`` is its acceleration, and the restitution is 0.5.
    """
    fall = (4.0 - math.sqrt(16.0 - 2.0 * a * high)) / a
    speed, rest = 0.5 * (4.0 - a * fall), h - fall
    return speed * rest + 0.5 * a * rest * rest, speed + a * rest


@pytest.mark.exercise("B7.12", asks="multiply each velocity once by d^h", read=READ)
def test_forces_and_damping_act_for_one_step(rng: Random) -> None:
    # With a in eighths the ball reaches the ground after exactly 1/8 s.
    mass, a, d, h = rng.choice((0.25, 0.5, 4.0, 8.0)), -rng.randint(8, 24) / 8.0, 0.25, 0.5
    high = 0.5 - 0.0078125 * a
    height, end = bounced(high, a, h)
    end *= d**h
    with calls("The acceleration is the constant one plus force / mass, for the whole step."):
        v, own = Vector3(3.0, -4.0, 0.0), Vector3(0.0, 0.25 * a, 0.0)
        p = Particle(Vector3(0.0, high, 0.0), v, own, mass=mass, damping=d)
        p.add_force(Vector3(0.0, 0.75 * a * mass, 0.0))
        ground = GroundPlane([p], restitution=0.5)
        time_division_step([p], ground, h)
    # Some roundings of 5 m/s.
    without = (3.0 * h, bounced(high, 0.25 * a, h)[0], 0.0)
    slips = {"You used p.acceleration instead of last_acceleration.": without}
    wanted = (3.0 * h, height, 0.0)
    expect_close(xyz(p.position), wanted, slips, then=PLACE, tolerance=1e-13, unit="m")
    slips = {
        "You left out the damping.": (3.0, 2.0 * end, 0.0),
        "You applied the damping for a whole second.": (0.75, 0.5 * end, 0.0),
    }
    why = "Multiply the velocity once by damping ** duration, at the end of the step."
    got, wanted = xyz(p.velocity), (1.5, end, 0.0)
    expect_close(got, wanted, slips, then=VELOCITY, cause=why, tolerance=1e-13, unit="m/s")
    why = "You left the force in the accumulator, or out of last_acceleration. At the start of the "
    why += "step, call particle.kick(0.0), which corrects both without changing the velocity."
    got, name = (*xyz(p.last_acceleration), *xyz(p.force_accumulator)), "; p.last_acceleration "
    name += "in m/s^2 and p.force_accumulator in N, in one tuple"
    expect_close(got, (0.0, a, 0.0, *ZERO), then=name, cause=why, tolerance=1e-14)
    with calls("A force lasts for one step. Call kick(0.0) in each step to clear it.", more=True):
        time_division_step([p], ground, h)
    wanted = (2.25, height + end * h + 0.125 * a * h * h, 0.0)
    expect_close(xyz(p.position), wanted, then=PLACE, tolerance=1e-13, unit="m")
    with calls("The acceleration of q is 8 N / 2 kg = 4 m/s^2. Use its last_acceleration."):
        p, q = Particle(Vector3(0.0, 90.0, 0.0)), Particle(Vector3(9.0, 90.0), mass=2, damping=d)
        q.add_force(Vector3(8.0))
        time_division_step([p, q], GroundPlane([p, q]), h)
    still = (9.0, 90.0, 0.0)
    slips = {"Particle q didn't move. Call kick(0.0) on all, not only on the first one.": still}
    wanted = (9.5, 90.0, 0.0)
    expect_close(xyz(q.position), wanted, slips, then="; q.position", tolerance=1e-13, unit="m")
    expect_close(xyz(q.velocity), (1.0, 0.0, 0.0), then="; q.velocity", tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.12", asks="Do not resolve its penetration", read=READ)
def test_penetrations_are_not_resolved() -> None:
    for speed, height, then, cause in (
        (3.0, 0.5, 3.0, "The particle moves out of the ground. Let it fly, without any impact."),
        (-3.0, -0.25, 1.5, "Don't move it out of the ground. Call only resolve_velocity."),
    ):
        with calls(cause):
            p = Particle(Vector3(0.0, -1.0, 0.0), Vector3(0.0, speed, 0.0), mass=2.0)
            time_division_step([p], GroundPlane([p], restitution=0.5), 0.5)
        expect_close(xyz(p.position), (0.0, height, 0.0), then=PLACE, tolerance=1.5e-13, unit="m")
        expect_close(xyz(p.velocity), (0.0, then, 0.0), then=VELOCITY, unit="m/s")


@pytest.mark.exercise("B7.12", asks="if the duration is not positive and finite", read=READ)
@pytest.mark.robust
def test_a_step_rejects_invalid_arguments() -> None:
    p = Particle(Vector3(0.0, 5.0, 0.0), Vector3(1.0, 2.0, 3.0))
    p.add_force(Vector3(1.0, 0.0, 0.0))
    positive = "The duration must be positive and finite. Call positive from arguments.py."
    whole = "max_impacts must be a whole number from 1, not True. Call whole from arguments.py."
    for duration, most, error, cause in (
        *((duration, 10, ValueError, positive) for duration in (0.0, -1.0, math.nan, math.inf)),
        ("0.5", 10, TypeError, positive),
        *((0.5, most, ValueError, whole) for most in (0, -1)),
        *((0.5, most, TypeError, whole) for most in (2.0, True)),
    ):
        text = "particle p with velocity (1, 2, 3) and a force of 1 N; time_division_step([p], "
        with calls(cause, f"{text}ground, {duration!r}, max_impacts={most!r})"):
            expect_error(
                lambda wrong=(duration, most): time_division_step([p], GroundPlane([p]), *wrong),
                error,
                allowed=lambda: time_division_step([Particle()], GroundPlane([]), 0.5, 1),
            )
        why = "You had already changed the particle. Check both arguments before that."
        expect_unchanged("p.position", p.position, (0.0, 5.0, 0.0), cause=why)
        expect_unchanged("p.velocity", p.velocity, (1.0, 2.0, 3.0), cause=why)
        expect_unchanged("p's force", p.force_accumulator, (1.0, 0.0, 0.0), cause=why)
