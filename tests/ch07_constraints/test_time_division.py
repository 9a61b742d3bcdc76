"""Frames that stop at each impact, build task B7.12."""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.flight_probes import flown, pushed
from ch07_constraints.time_division import time_division_step
from draw import positive_number
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
READ = "book 7.3, and the docstring of time_division_step"
DOWN = (0.0, -10.0, 0.0)
FRAME = 1.0 / 60.0


@pytest.mark.exercise("B7.12")
def test_without_an_impact_the_flight_is_exact(rng: Random) -> None:
    about.read = READ
    v, h = (positive_number(rng), positive_number(rng), -positive_number(rng)), 0.5
    about.call = f"p at (0, 9, 0), velocity {v}, acceleration {DOWN}; one frame of {h} s; its "
    about.cause = "p + v t + a t^2 / 2 and v + a t: the term with t^2 is what makes it exact"
    after, _, _, _ = flown([((0.0, 9.0, 0.0), v, 2.0)], DOWN, 0.0, (0.5, None), h, 1)
    place, velocity = after[0][0]
    wanted = (v[0] * h, 9.0 + v[1] * h - 5.0 * h * h, v[2] * h)
    without = (wanted[0], 9.0 + v[1] * h, wanted[2])
    mistakes = [
        ((0.0, 9.0, 0.0), "it has not moved: fly to the end of the frame after the last impact"),
        (without, "the term with t^2 is left out, as explicit Euler does: p + v t + a t^2 / 2"),
        (
            (wanted[0], 9.0 + v[1] * h - 10.0 * h * h, wanted[2]),
            "half of a t^2: p + v t + a t^2 / 2",
        ),
    ]
    seen = cause_of(place, mistakes, about.cause)
    expect_close(place, wanted, then="position", cause=seen)
    wanted = (v[0], v[1] - 10.0 * h, v[2])
    expect_close(velocity, wanted, then="velocity")
    about.call = "an immovable particle with velocity (1, 2, 3); one frame: position, velocity"
    about.cause = "what is immovable stays where it is"
    body = (ZERO, (1.0, 2.0, 3.0), math.inf)
    seen, _, _, _ = flown([body], DOWN, 0.0, (0.5, None), h, 1)
    expect_close(sum(seen[0][0], ()), (*ZERO, 1.0, 2.0, 3.0))


@pytest.mark.exercise("B7.12")
def test_a_ball_bounces_when_it_is_due(rng: Random) -> None:
    about.read = READ
    e = round(rng.uniform(0.55, 0.9), 3)  # at 0.5 the bounces end at 3 s
    for frames, h in ((1, 3.0), (180, FRAME)):
        about.call = f"a ball falls 5 m, g = 10, restitution {e}; frames of {h:.6g} s, {frames} of "
        about.call += "them: "
        # It falls for 1 s, bounces at e times 10 m/s, and flies for 2 e, 2 e^2, ... seconds.
        times, t = [], 1.0
        while t <= 3.0:
            times.append(t)
            t += 2.0 * e ** len(times)
        about.cause = "as many impacts as there are bounces in 3 s: fly to each, resolve its "
        about.cause += "velocity, and ask for the next one in what is left of the frame"
        seen, found, asked, _ = flown(
            [((0.0, 5.0, 0.0), ZERO, 2.0)], DOWN, 0.0, (e, None), h, frames
        )
        if len(found) > 1000:
            about.cause = "impacts without an end: either the whole frame is asked for again, and "
            about.cause += "not what is left of it, or the bounce is lost: resolve_velocity() is "
            about.cause += "for 0 s here"
        if h > 1.0 and len(found) == 1:
            about.cause = "one impact, and there are more in what is left of the frame: ask again"
        expect_exactly(len(found), len(times), then="impacts")
        last, bounces = times[-1], len(times)
        left = 3.0 - last
        speed = 10.0 * e**bounces
        wanted = (speed * left - 5.0 * left * left, speed - 10.0 * left)
        place, velocity = seen[-1][0]
        about.cause = "a bounce of restitution e, at the time of impact, and for a duration of 0: "
        about.cause += "nothing of it was built up by a frame"
        # Some 200 flights, each with a few roundings of 10 m.
        expect_close((place[1], velocity[1]), wanted, then="height and speed", tolerance=1e-11)
        about.cause = "it asks for what is left of the frame: first for all of it"
        expect_close(max(asked), h, then="the longest that the detector was asked for")
        about.cause = "once a frame, and once more after each impact"
        expect_exactly(len(asked), frames + bounces, then="how often the detector was asked")


@pytest.mark.exercise("B7.12")
def test_nothing_is_lost_at_restitution_one() -> None:
    about.read = READ
    about.call = "a ball falls 2 m, g = 10, restitution 1; 20 s at 60 Hz: the energy for each kg "
    about.call += "and g, m"
    about.cause = "steps with a resolver climb or sink; from impact to impact 2 m stay 2 m"
    seen, found, _, _ = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (1.0, None), FRAME, 1200)
    heights = [place[1] + velocity[1] ** 2 / 20.0 for ((place, velocity),) in seen]
    got = (min(heights), max(heights))
    # 1200 frames, each with a few roundings of 2 m.
    expect_close(got, (2.0, 2.0), tolerance=1e-11)
    name = "the same: impacts"
    about.cause = "one each 2 sqrt(0.4) s, from sqrt(0.4) s on: 16 in 20 s"
    expect_exactly(len(found), 16, call=name)


@pytest.mark.exercise("B7.12")
def test_rest_is_told_with_its_time() -> None:
    about.read = "the docstring of TooManyImpacts"
    about.call = "a ball falls 2 m, g = 10, restitution 0.5; frames of 1/60 s until "
    about.call += "TooManyImpacts: "
    about.cause = "it bounces ever lower, for sqrt(2 h / g) (1 + e) / (1 - e) s in all; then it "
    about.cause += "rests, and impacts without an end: raise TooManyImpacts, with the time in the "
    about.cause += "frame"
    seen, _, _, ended = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 200)
    expect_exactly(ended is not None, True, then="was it raised?")
    impacts, time = ended or (0, 0.0)
    got = (len(seen) - 1) * FRAME + time
    # The last bounces that a float can tell are 1e-9 s apart.
    ends = 1.8973666
    early = int(ends / FRAME) * FRAME
    name = "that is by what is left of the frame: its time is since the frame began"
    mistakes = [(2.0 * early + FRAME - ends, name)]
    blame(got, mistakes, tolerance=1e-7)
    expect_close(got, ends, then="the time of it, s", tolerance=1e-7)
    about.cause = "where there is another impact after max_impacts of them, none more is resolved"
    expect_exactly(impacts, 1000, then="error.impacts")
    about.call = "a particle lies on the ground, g = 10, restitution 0.5; a frame: error.impacts "
    about.call += "and time"
    about.cause = "what rests impacts at 0, time and again: say so, and do not give up silently"
    _, _, _, ended = flown([(ZERO, ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 1)
    expect_close(ended or (0, -1.0), (1000, 0.0))
    about.call = "a ball falls 5 m, g = 10, restitution 0.5; one frame of 2.6 s, max_impacts 3: "
    about.call += "was TooManyImpacts raised?"
    about.cause = "it bounces after 1, 2 and 2.5 s: three are allowed, and there is no fourth in "
    about.cause += "the frame"
    body = ((0.0, 5.0, 0.0), ZERO, 1.0)
    _, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 2.6, 1, 3)
    expect_exactly(ended is not None, False)
    for most in (3, 1):
        about.call = "a ball of damping 0.5 falls 5 m, g = 10, restitution 0.5; one frame of 9 s, "
        about.call += "max_impacts "
        about.cause = "where there is another impact after max_impacts of them, none more is "
        about.cause += "resolved"
        seen, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 9.0, 1, most, 0.5)
        impacts, time = ended or (0, 0.0)
        times = [1.0, 2.0, 2.5, 2.75]
        expect_exactly(impacts, most, then=f"{most}: error.impacts")
        about.cause = "impacts at 1, 2, 2.5 and 2.75 s: they come sooner where each of them damps, "
        about.cause += "and damping is for the end of the frame"
        expect_close(time, times[most], then=f"{most}: error.time", tolerance=1e-12)
        place, velocity = seen[0][0]
        speed = -10.0 * 0.5**most
        about.cause = "the particles are then where they are at the time of the next impact, "
        about.cause += "unresolved, and not yet damped"
        early = "that is after the last impact: fly to the next one, and raise then"
        blame((place[1], velocity[1]), [((0.0, -speed), early)])
        expect_close(
            (place[1], velocity[1]),
            (0.0, speed),
            then=f"{most}: height and speed then",
            tolerance=1e-12,
        )


@pytest.mark.exercise("B7.12")
def test_a_cradle_passes_its_motion_on(rng: Random) -> None:
    about.read = "book 7.3; simultaneous impacts are resolved one after the other"
    speed = positive_number(rng, 0.5, 3.0)  # so slow that passing on too late shows
    for count in (1, 2, 3):
        speeds = [speed if i < count else 0.0 for i in range(5)]
        gap = 0.75 * speed  # they arrive in the middle of a frame
        places = [2.0 * i - (gap if i < count else 0.0) for i in range(5)]
        about.call = f"five spheres of radius 1, mass 2, restitution 1; the first {count} arrive "
        about.call += f"with {speed} m/s after 0.75 s, the others touch; 2 s in frames of 0.5 s: "
        about.call += "velocities"
        about.cause = "each impact passes the motion on to the next sphere, at the same time: as "
        about.cause += "many leave as have come"
        bodies = [((x, 0.0, 0.0), (v, 0.0, 0.0), 2.0) for x, v in zip(places, speeds, strict=True)]
        seen, found, _, _ = flown(bodies, ZERO, 1.0, (None, 1.0), 0.5, 4)
        got = tuple(velocity[0] for _, velocity in seen[-1])
        wanted = tuple(speed if i >= 5 - count else 0.0 for i in range(5))
        expect_close(got, wanted, tolerance=1e-13)
        name = f"{about.call[:-10]}impacts"
        expect_exactly(len(found), count * (5 - count), call=name)


@pytest.mark.exercise("B7.12")
def test_impacts_come_in_their_order(rng: Random) -> None:
    about.read = READ
    # Spheres of radius 1 along X; a small one in the middle is hit from both sides in turn.
    late = positive_number(rng, 0.1, 0.9)
    bodies = [
        ((-3.0, 0.0, 0.0), (1.0, 0.0, 0.0), 3.0),
        (ZERO, ZERO, 1.0),
        ((3.0 + late, 0.0, 0.0), (-1.0, 0.0, 0.0), 3.0),
    ]
    about.call = f"spheres of radius 1 and 3, 1 and 3 kg at -3, 0 and {3.0 + late}, with 1, 0 and "
    about.call += "-1 m/s, restitution 1; a frame of 5 s: "
    about.cause = "the left one comes first, after 1 s; what it changes decides when the next "
    about.cause += "impact is"
    seen, found, _, _ = flown(bodies, ZERO, 1.0, (None, 1.0), 5.0, 1)
    # After the first impact: 3 kg at 0.5, 1 kg at 1.5 m/s, which meets the right one at 2.5 m/s.
    wanted_times = (1.0, late / 2.5)
    got = tuple(time for _, _, time in found[:2])
    expect_close(
        got,
        wanted_times,
        then="times of the first two impacts, each since the one before",
        tolerance=1e-13,
    )
    pairs = [number for a, b, _ in found[:2] for number in (a, b)]
    expect_exactly(pairs, [0, 1, 1, 2], then="which pairs")
    about.cause = "momentum and, at restitution 1, energy are what they were"
    momentum = math.fsum(m * v[0] for (_, _, m), (_, v) in zip(bodies, seen[0], strict=True))
    energy = math.fsum(
        0.5 * m * v[0] ** 2 for (_, _, m), (_, v) in zip(bodies, seen[0], strict=True)
    )
    expect_close(
        (momentum, energy), (0.0, 3.0), then="momentum and kinetic energy", tolerance=1e-13
    )
    about.cause = "spheres do not pass through each other"
    gaps = [right[0][0] - left[0][0] - 2.0 for left, right in pairwise(seen[0])]
    got = min(0.0, *gaps)
    expect_close(got, 0.0, then="overlap", tolerance=1e-13)


@pytest.mark.exercise("B7.12")
def test_a_frame_uses_the_forces_up(rng: Random) -> None:
    about.read = READ
    # With a in eighths, the ground is reached after 1/8 s, without a rounding.
    mass, a, d, h = rng.choice((0.25, 0.5, 4.0, 8.0)), -rng.randint(8, 24) / 8.0, 0.25, 0.5
    fall = 0.125
    high = 4.0 * fall - 0.5 * a * fall * fall
    # The first one bounces; the second only falls; the third is immovable.
    own, force = (0.0, 0.25 * a, 0.0), (0.0, 0.75 * a * mass, 0.0)
    pushes = [
        ((0.0, high, 0.0), (3.0, -4.0, 0.0), own, force, mass),
        ((9.0, 90.0, 0.0), ZERO, ZERO, (8.0, 0.0, 0.0), 2.0),
        ((9.0, 9.0, 9.0), (1.0, 2.0, 3.0), ZERO, (1.0, 2.0, 3.0), math.inf),
    ]
    about.call = f"p of {mass} kg, damping {d}, at (0, {high}, 0), velocity (3, -4, 0), "
    about.call += f"acceleration {own}, and a force {force}; a frame of {h} s, ground at 0, "
    about.call += "restitution 0.5; "
    speed, rest = 0.5 * (4.0 - a * fall), h - fall
    height = speed * rest + 0.5 * a * rest * rest
    end = 0.5 * (speed + a * rest)
    about.cause = "the acceleration is the constant one and f / m, throughout the frame, before "
    about.cause += "and after an impact"
    bouncing, falling, fixed = pushed(pushes, d, h)
    # Some roundings of 5 m/s.
    wanted = (3.0 * h, height, 0.0)
    expect_close(bouncing[0], wanted, then="position", tolerance=1e-13)
    about.cause = "damping multiplies the velocity by d^h, once, at the end of the frame"
    mistakes = [
        ((3.0, 2.0 * end, 0.0), "damping is left out: d^h times the velocity, at the end"),
        ((0.75, 0.5 * end, 0.0), "that is d, the damping of a second: this frame has d^h"),
    ]
    blame(bouncing[1], mistakes)
    expect_close(bouncing[1], (1.5, end, 0.0), then="velocity", tolerance=1e-13)
    about.cause = "the frame uses the forces up: let Particle.integrate do it, and put place and "
    about.cause += "velocity back; last_acceleration is that of the frame"
    wanted = (0.0, a, 0.0)
    expect_close(bouncing[2], wanted, then="p.last_acceleration", tolerance=1e-14)
    expect_close(bouncing[3], ZERO, then="p.force_accumulator")
    about.cause = "each particle has its own forces: 8 N on 2 kg, without an impact"
    got = falling[0] + falling[1]
    wanted = (9.5, 90.0, 0.0, 1.0, 0.0, 0.0)
    expect_close(
        got,
        wanted,
        then="another one, at (9, 90, 0) at rest, 8 N along X: position, velocity",
        tolerance=1e-13,
    )
    about.cause = "what is immovable stays as it is, and loses its forces"
    got = fixed[0] + fixed[1] + fixed[3]
    wanted = (9.0, 9.0, 9.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0)
    expect_close(
        got, wanted, then="an immovable one, velocity (1, 2, 3): position, velocity, force"
    )
    about.call += "another frame; "
    about.cause = "in the next frame the force is gone"
    wanted = (2.25, height + end * h + 0.125 * a * h * h, 0.0)
    expect_close(bouncing[4], wanted, then="position", tolerance=1e-13)


@pytest.mark.exercise("B7.12")
def test_depths_are_not_looked_at() -> None:
    about.read = READ
    about.call = "a particle 1 m below the ground, velocity (0, 3, 0); a frame of 0.5 s: position, "
    about.call += "velocity"
    about.cause = "velocities of impacts are resolved, and nothing else: it is on its way out"
    body = ((0.0, -1.0, 0.0), (0.0, 3.0, 0.0), 2.0)
    seen, _, _, _ = flown([body], ZERO, 0.0, (0.5, None), 0.5, 1)
    got = seen[0][0][0] + seen[0][0][1]
    expect_close(got, (0.0, 0.5, 0.0, 0.0, 3.0, 0.0))
    about.call = "the same with velocity (0, -3, 0), restitution 0.5: position, velocity"
    body = ((0.0, -1.0, 0.0), (0.0, -3.0, 0.0), 2.0)
    about.cause = "it closes, so it bounces at once, where it is: contact.resolve_velocity() alone"
    seen, _, _, _ = flown([body], ZERO, 0.0, (0.5, None), 0.5, 1)
    got = seen[0][0][0] + seen[0][0][1]
    expect_close(got, (0.0, -0.25, 0.0, 0.0, 1.5, 0.0))


@pytest.mark.exercise("B7.12")
@pytest.mark.robust
def test_a_frame_needs_numbers_that_mean_something() -> None:
    about.read = READ
    p = Particle(Vector3(0.0, 5.0, 0.0), Vector3(1.0, 2.0, 3.0))
    p.add_force(Vector3(1.0, 0.0, 0.0))
    about.cause = "refuse it before anything is moved: positive of arguments.py for the duration, "
    about.cause += "and 1 or more, a whole number, for max_impacts"
    bad: list[tuple[tuple, type[Exception]]] = [
        ((duration, 10), ValueError) for duration in (0.0, -1.0, math.nan, math.inf)
    ]
    bad += [((0.5, 0), ValueError), ((0.5, -1), ValueError), ((0.5, 2.0), TypeError)]
    bad += [(("0.5", 10), TypeError), ((0.5, True), TypeError)]
    for numbers, error in bad:
        about.call = "p with velocity (1, 2, 3) and a force of 1 N; time_division_step([p], "
        about.call += f"ground, {numbers[0]!r}, {numbers[1]!r})"
        expect_error(
            lambda numbers=numbers: time_division_step([p], GroundPlane([p]), *numbers),
            error,
            allowed=lambda: time_division_step(
                [Particle(Vector3(0.0, 5.0, 0.0))], GroundPlane([]), 0.5, 1
            ),
        )
        got = (*xyz(p.position), *xyz(p.velocity), *xyz(p.force_accumulator))
        before = (0.0, 5.0, 0.0, 1.0, 2.0, 3.0, 1.0, 0.0, 0.0)
        name = "place, velocity and force"
        expect_unchanged(name, got, before)
