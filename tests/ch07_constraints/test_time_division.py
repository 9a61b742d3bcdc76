"""Time steps that stop at each impact, build task B7.12."""

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
    about.call = f"p at (0, 9, 0), velocity {v}, acceleration {DOWN}; one step of {h} s; its "
    about.cause = "Between two impacts the acceleration is constant, so you can compute the "
    about.cause += "motion exactly. The new position is p + v t + a t^2 / 2, and the new velocity "
    about.cause += "is v + a t."
    after, _, _, _ = flown([((0.0, 9.0, 0.0), v, 2.0)], DOWN, 0.0, (0.5, None), h, 1)
    place, velocity = after[0][0]
    wanted = (v[0] * h, 9.0 + v[1] * h - 5.0 * h * h, v[2] * h)
    without = (wanted[0], 9.0 + v[1] * h, wanted[2])
    mistakes = [
        ((0.0, 9.0, 0.0),
         "The particle hasn't moved. When there are no more impacts in the step, move every "
         "particle to the end of the step."),
        (without, (
            "You left out the term a t^2 / 2, as explicit Euler does. Use p + v t + a t^2 / 2."
        )),
        ((wanted[0], 9.0 + v[1] * h - 10.0 * h * h, wanted[2]),
         "Your step adds a t^2 to the position. The velocity grows from v to v + a t, so on "
         "average only half of that growth counts: the term is a t^2 / 2."),
    ]  # fmt: skip
    seen = cause_of(place, mistakes, about.cause)
    expect_close(place, wanted, then="position", cause=seen)
    wanted = (v[0], v[1] - 10.0 * h, v[2])
    expect_close(velocity, wanted, then="velocity")
    about.call = "an immovable particle with velocity (1, 2, 3); one step: position, velocity"
    about.cause = "An immovable particle stays where it is, whatever its velocity says. Leave it "
    about.cause += "out when you move the particles."
    body = (ZERO, (1.0, 2.0, 3.0), math.inf)
    seen, _, _, _ = flown([body], DOWN, 0.0, (0.5, None), h, 1)
    expect_close(sum(seen[0][0], ()), (*ZERO, 1.0, 2.0, 3.0))


@pytest.mark.exercise("B7.12")
def test_a_ball_bounces_when_it_is_due(rng: Random) -> None:
    about.read = READ
    e = round(rng.uniform(0.55, 0.9), 3)  # at 0.5 the bounces end at 3 s
    for frames, h in ((1, 3.0), (180, FRAME)):
        about.call = f"a ball falls 5 m, g = 10, restitution {e}; {frames} steps of {h:.6g} s: "
        # It falls for 1 s, bounces at e times 10 m/s, and flies for 2 e, 2 e^2, ... seconds.
        times, t = [], 1.0
        while t <= 3.0:
            times.append(t)
            t += 2.0 * e ** len(times)
        about.cause = "A step can contain several impacts. Move the particles to each impact, "
        about.cause += "resolve its velocity, and ask for the next impact in what is left of the "
        about.cause += "step."
        seen, found, asked, _ = flown(
            [((0.0, 5.0, 0.0), ZERO, 2.0)], DOWN, 0.0, (e, None), h, frames
        )
        if len(found) > 1000:
            about.cause = "Your step keeps finding impacts forever. Pass next_impact only the "
            about.cause += "time that is left in the step, and resolve each velocity with a "
            about.cause += "duration of 0."
        if h > 1.0 and len(found) == 1:
            about.cause = "You resolved only the first impact, but there is a second one before "
            about.cause += "the step ends. After each impact, call next_impact again for the rest "
            about.cause += "of the step."
        expect_exactly(len(found), len(times), then="number of impacts")
        expect_exactly(len(found), len(times), then="impacts")
        last, bounces = times[-1], len(times)
        left = 3.0 - last
        speed = 10.0 * e**bounces
        wanted = (speed * left - 5.0 * left * left, speed - 10.0 * left)
        place, velocity = seen[-1][0]
        about.cause = "Resolve each velocity at the time of its impact with a duration of 0. With "
        about.cause += "any other duration, part of the velocity is left out of the bounce."
        # Some 200 flights, each with a few roundings of 10 m.
        name = f"{about.call}height and speed"
        expect_close((place[1], velocity[1]), wanted, call=name, tolerance=1e-11)
        about.cause = "You called next_impact with the wrong duration. Pass the duration of the "
        about.cause += "whole step to the first call, and the time that is left in the step to "
        about.cause += "each later one."
        name = f"{about.call}the longest duration that next_impact got"
        expect_close(max(asked), h, call=name)
        name = f"{about.call}number of calls of next_impact"
        about.cause = "You called next_impact too often or not often enough. Call it once at the "
        about.cause += "start of the step and once more after each impact."
        expect_exactly(len(asked), frames + bounces, call=name)


@pytest.mark.exercise("B7.12")
def test_nothing_is_lost_at_restitution_one() -> None:
    about.read = READ
    about.call = "a ball falls 2 m, g = 10, restitution 1; 20 s of steps of 1/60 s: the lowest and "
    about.call += "highest energy, divided by m g, in m"
    about.cause = "The motion between bounces is exact, and a bounce with a restitution of 1 "
    about.cause += "loses no energy, so the ball should always rise back to 2 m. Check how you "
    about.cause += "move the particles between the impacts."
    seen, found, _, _ = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (1.0, None), FRAME, 1200)
    heights = [place[1] + velocity[1] ** 2 / 20.0 for ((place, velocity),) in seen]
    got = (min(heights), max(heights))
    # 1200 steps, each with a few roundings of 2 m.
    expect_close(got, (2.0, 2.0), tolerance=1e-11)
    name = "the same: number of impacts"
    about.cause = "The first impact is due after sqrt(0.4) s, and from then on there should be "
    about.cause += "one every 2 sqrt(0.4) s."
    expect_exactly(len(found), 16, call=name)


@pytest.mark.exercise("B7.12")
def test_rest_is_told_with_its_time() -> None:
    about.read = "the docstring of TooManyImpacts"
    about.call = "a ball falls 2 m, g = 10, restitution 0.5; steps of 1/60 s until TooManyImpacts: "
    about.cause = "The bounces get lower and end after sqrt(2 h / g) (1 + e) / (1 - e) s. After "
    about.cause += "that the ball is at rest and the impacts never stop, so raise TooManyImpacts."
    seen, _, _, ended = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 200)
    expect_exactly(ended is not None, True, then="was it raised?")
    impacts, time = ended or (0, 0.0)
    got = (len(seen) - 1) * FRAME + time
    # The last bounces that floats can distinguish are 1e-9 s apart.
    ends = 1.8973666
    early = int(ends / FRAME) * FRAME
    name = "This is the time that is left in the step. Pass the time since the start of the step "
    name += "to the error."
    mistakes = [(2.0 * early + FRAME - ends, name)]
    blame(got, mistakes, tolerance=1e-7)
    expect_close(got, ends, then="its time, s", tolerance=1e-7)
    about.cause = "Resolve at most max_impacts impacts per step. If there is another one, raise "
    about.cause += "TooManyImpacts without resolving it."
    expect_exactly(impacts, 1000, then="error.impacts")
    about.call = "a particle lies on the ground, g = 10, restitution 0.5; one step: error.impacts "
    about.call += "and error.time"
    about.cause = "A particle that lies on the ground has one impact after another at time 0, "
    about.cause += "forever. Raise TooManyImpacts after max_impacts impacts."
    _, _, _, ended = flown([(ZERO, ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 1)
    expect_close(ended or (0, -1.0), (1000, 0.0))
    about.call = "a ball falls 5 m, g = 10, restitution 0.5; one step of 2.6 s, max_impacts 3: was "
    about.call += "TooManyImpacts raised?"
    about.cause = "The ball bounces three times, after 1, 2 and 2.5 s. Three impacts are allowed, "
    about.cause += "so don't raise an error."
    body = ((0.0, 5.0, 0.0), ZERO, 1.0)
    _, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 2.6, 1, 3)
    expect_exactly(ended is not None, False)
    for most in (3, 1):
        about.call = "a ball of damping 0.5 falls 5 m, g = 10, restitution 0.5; one step of 9 s, "
        about.call += "max_impacts "
        about.cause = "Resolve at most max_impacts impacts per step. If there is another one, "
        about.cause += "raise TooManyImpacts without resolving it."
        seen, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 9.0, 1, most, 0.5)
        impacts, time = ended or (0, 0.0)
        times = [1.0, 2.0, 2.5, 2.75]
        expect_exactly(impacts, most, then=f"{most}: error.impacts")
        about.cause = "The impacts are due at 1, 2, 2.5 and 2.75 s. If you damp the velocity at "
        about.cause += "each impact, they come too early, so apply the damping only once, at the "
        about.cause += "end of the step."
        name = f"{about.call}{most}: error.time"
        expect_close(time, times[most], call=name, tolerance=1e-12)
        place, velocity = seen[0][0]
        speed = -10.0 * 0.5**most
        about.cause = "Before you raise TooManyImpacts, move the particles to the time of the "
        about.cause += "next impact. Don't resolve that impact, and don't apply the damping."
        early = "You left the particles where the last allowed impact happened. Move them to the "
        early += "time of the next impact, and then raise the error."
        blame((place[1], velocity[1]), [((0.0, -speed), early)])
        name = f"{about.call}{most}: height and velocity then"
        expect_close((place[1], velocity[1]), (0.0, speed), call=name, tolerance=1e-12)


@pytest.mark.exercise("B7.12")
def test_a_cradle_passes_its_motion_on(rng: Random) -> None:
    about.read = "book 7.3; simultaneous impacts are resolved one after the other"
    speed = positive_number(rng, 0.5, 3.0)  # slow enough that a late exchange shows
    for count in (1, 2, 3):
        speeds = [speed if i < count else 0.0 for i in range(5)]
        gap = 0.75 * speed  # they arrive in the middle of a step
        places = [2.0 * i - (gap if i < count else 0.0) for i in range(5)]
        about.call = f"five spheres of radius 1, mass 2, restitution 1; the first {count} arrive "
        about.call += f"at {speed} m/s after 0.75 s, the others touch; 2 s in steps of 0.5 s: "
        about.call += "velocities"
        about.cause = "Each impact passes the velocity straight on to the next sphere, so as many "
        about.cause += "spheres should leave as arrive. Resolve the impacts one after another, "
        about.cause += "even if they happen at the same time."
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
    # Spheres of radius 1 along X. The light one in the middle is hit from both sides in turn.
    late = positive_number(rng, 0.1, 0.9)
    bodies = [
        ((-3.0, 0.0, 0.0), (1.0, 0.0, 0.0), 3.0),
        (ZERO, ZERO, 1.0),
        ((3.0 + late, 0.0, 0.0), (-1.0, 0.0, 0.0), 3.0),
    ]
    about.call = f"spheres of radius 1, of 3, 1 and 3 kg, at -3, 0 and {3.0 + late}, with 1, 0 and "
    about.call += "-1 m/s, restitution 1; a step of 5 s: "
    about.cause = "The left sphere hits first, after 1 s. That impact changes the time of the "
    about.cause += "next one, so call next_impact again after each impact."
    seen, found, _, _ = flown(bodies, ZERO, 1.0, (None, 1.0), 5.0, 1)
    # After the first impact: 3 kg at 0.5, 1 kg at 1.5 m/s, which meets the right one at 2.5 m/s.
    wanted_times = (1.0, late / 2.5)
    got = tuple(time for _, _, time in found[:2])
    name = f"{about.call}times of the first two impacts, each since the previous one"
    expect_close(got, wanted_times, call=name, tolerance=1e-13)
    name = f"{about.call}their pairs, by index"
    pairs = [number for a, b, _ in found[:2] for number in (a, b)]
    expect_exactly(pairs, [0, 1, 1, 2], call=name)
    about.cause = "With a restitution of 1, impacts conserve momentum and kinetic energy. Check "
    about.cause += "that you resolve each impact only once."
    momentum = math.fsum(m * v[0] for (_, _, m), (_, v) in zip(bodies, seen[0], strict=True))
    energy = math.fsum(
        0.5 * m * v[0] ** 2 for (_, _, m), (_, v) in zip(bodies, seen[0], strict=True)
    )
    name = f"{about.call}momentum and kinetic energy"
    expect_close((momentum, energy), (0.0, 3.0), call=name, tolerance=1e-13)
    about.cause = "Two spheres have passed through each other, so you missed an impact. Call "
    about.cause += "next_impact again after each impact."
    gaps = [right[0][0] - left[0][0] - 2.0 for left, right in pairwise(seen[0])]
    got = min(0.0, *gaps)
    expect_close(got, 0.0, then="overlap", tolerance=1e-13)


def bounced(high: float, a: float, h: float) -> tuple[float, float]:
    """Return height and velocity after ``h`` s, if a ball moves down at 4 m/s and bounces once.

    It starts at a height of ``high``, ``a`` is its acceleration, and the restitution is 0.5.
    """
    fall = (4.0 - math.sqrt(16.0 - 2.0 * a * high)) / a
    speed, rest = 0.5 * (4.0 - a * fall), h - fall
    return speed * rest + 0.5 * a * rest * rest, speed + a * rest


@pytest.mark.exercise("B7.12")
def test_a_frame_uses_the_forces_up(rng: Random) -> None:
    about.read = READ
    # With a in eighths the ball reaches the ground after exactly 1/8 s.
    mass, a, d, h = rng.choice((0.25, 0.5, 4.0, 8.0)), -rng.randint(8, 24) / 8.0, 0.25, 0.5
    fall = 0.125
    high = 4.0 * fall - 0.5 * a * fall * fall
    # The first one bounces, the second only falls, and the third is immovable.
    own, force = (0.0, 0.25 * a, 0.0), (0.0, 0.75 * a * mass, 0.0)
    pushes = [
        ((0.0, high, 0.0), (3.0, -4.0, 0.0), own, force, mass),
        ((9.0, 90.0, 0.0), ZERO, ZERO, (8.0, 0.0, 0.0), 2.0),
        ((9.0, 9.0, 9.0), (1.0, 2.0, 3.0), ZERO, (1.0, 2.0, 3.0), math.inf),
    ]
    about.call = f"p of {mass} kg, damping {d}, at (0, {high}, 0), v (3, -4, 0), a {own}, force "
    about.call += f"{force}; a step of {h} s, ground of restitution 0.5; "
    height, end = bounced(high, a, h)
    end *= d**h
    about.cause = "The acceleration is the constant acceleration plus f / m. It stays the same "
    about.cause += "for the whole step, even after an impact."
    bouncing, falling, fixed = pushed(pushes, d, h)
    # Some roundings of 5 m/s.
    name = f"{about.call}position"
    wanted = (3.0 * h, height, 0.0)
    blame(bouncing[0], [
        ((3.0 * h, bounced(high, own[1], h)[0], 0.0),
         "You used only the constant acceleration. The force accelerates the particle too, so add "
         "f / m, before the impact and after it."),
    ])  # fmt: skip
    expect_close(bouncing[0], wanted, call=name, tolerance=1e-13)
    about.cause = "Apply the damping once for the whole step: multiply the velocity by damping ** "
    about.cause += "duration at the end."
    name = f"{about.call}velocity"
    mistakes = [
        ((3.0, 2.0 * end, 0.0), "You left out the damping, so nothing slows the particle down. "
                                "Multiply the velocity by damping ** duration at the end of the "
                                "step."),
        ((0.75, 0.5 * end, 0.0),
         "You multiplied the velocity by the damping for a whole second. The step is shorter, so "
         "multiply by damping ** duration."),
    ]  # fmt: skip
    blame(bouncing[1], mistakes)
    expect_close(bouncing[1], (1.5, end, 0.0), call=name, tolerance=1e-13)
    about.cause = "Forces act for one step and are then cleared. particle.kick(0.0) clears them "
    about.cause += "without changing the velocity, and afterward last_acceleration includes them."
    wanted = (0.0, a, 0.0)
    name = f"{about.call}p.last_acceleration"
    expect_close(bouncing[2], wanted, call=name, tolerance=1e-14)
    expect_close(bouncing[3], ZERO, then="p.force_accumulator")
    about.cause = "This particle has a force of its own, so its acceleration is f / m, which is 8 "
    about.cause += "N / 2 kg = 4 m/s^2. Use the last_acceleration of each particle when you move "
    about.cause += "it."
    got = falling[0] + falling[1]
    name = "the second of three particles: 2 kg, damping 0.25, at rest at (9, 90, 0), with a force "
    name += f"of (8, 0, 0); a step of {h} s without an impact: position, velocity"
    wanted = (9.5, 90.0, 0.0, 1.0, 0.0, 0.0)
    still = "This particle hasn't moved, although a force of 8 N along X acts on it. Call "
    still += "kick(0.0) on every particle at the start of the step, not only on the first one."
    blame(got, [((9.0, 90.0, 0.0, 0.0, 0.0, 0.0), still)])
    expect_close(got, wanted, call=name, tolerance=1e-13)
    about.cause = "An immovable particle keeps its position and velocity, but you have to clear "
    about.cause += "its forces like those of any other particle."
    got = fixed[0] + fixed[1] + fixed[3]
    name = "an immovable particle at (9, 9, 9), velocity (1, 2, 3), with a force of (1, 2, 3); a "
    name += f"step of {h} s: position, velocity, force"
    wanted = (9.0, 9.0, 9.0, 1.0, 2.0, 3.0, 0.0, 0.0, 0.0)
    expect_close(got, wanted, call=name)
    about.call += "a second step; "
    about.cause = "The force still acts in the second step, but a force lasts for only one step. "
    about.cause += "Call kick(0.0) at the start of each step to use up the forces."
    wanted = (2.25, height + end * h + 0.125 * a * h * h, 0.0)
    name = f"{about.call}position"
    expect_close(bouncing[4], wanted, call=name, tolerance=1e-13)


@pytest.mark.exercise("B7.12")
def test_depths_are_not_looked_at() -> None:
    about.read = READ
    about.call = "a particle 1 m below the ground, velocity (0, 3, 0); a step of 0.5 s: position, "
    about.call += "velocity"
    about.cause = "The particle is below the ground but on its way out, so there is no impact. "
    about.cause += "This step doesn't resolve penetrations either, so don't move the particle up."
    body = ((0.0, -1.0, 0.0), (0.0, 3.0, 0.0), 2.0)
    seen, _, _, _ = flown([body], ZERO, 0.0, (0.5, None), 0.5, 1)
    got = seen[0][0][0] + seen[0][0][1]
    expect_close(got, (0.0, 0.5, 0.0, 0.0, 3.0, 0.0))
    about.call = "the same with velocity (0, -3, 0), restitution 0.5: position, velocity"
    body = ((0.0, -1.0, 0.0), (0.0, -3.0, 0.0), 2.0)
    about.cause = "The particle should bounce at once, without being moved out of the ground "
    about.cause += "first. Call only resolve_velocity, and leave the penetration alone."
    seen, _, _, _ = flown([body], ZERO, 0.0, (0.5, None), 0.5, 1)
    got = seen[0][0][0] + seen[0][0][1]
    expect_close(got, (0.0, -0.25, 0.0, 0.0, 1.5, 0.0))


@pytest.mark.exercise("B7.12")
@pytest.mark.robust
def test_a_frame_needs_numbers_that_mean_something() -> None:
    about.read = READ
    p = Particle(Vector3(0.0, 5.0, 0.0), Vector3(1.0, 2.0, 3.0))
    p.add_force(Vector3(1.0, 0.0, 0.0))
    bad: list[tuple[tuple, type[Exception]]] = [
        ((duration, 10), ValueError) for duration in (0.0, -1.0, math.nan, math.inf)
    ]
    bad += [((0.5, 0), ValueError), ((0.5, -1), ValueError), ((0.5, 2.0), TypeError)]
    bad += [(("0.5", 10), TypeError), ((0.5, True), TypeError)]
    for numbers, error in bad:
        about.call = "p with velocity (1, 2, 3) and a force of 1 N; time_division_step([p], "
        about.call += f"ground, {numbers[0]!r}, {numbers[1]!r})"
        about.cause = f"max_impacts must not be {numbers[1]!r}. Call whole from arguments.py at "
        about.cause += "the start to check it."
        if numbers[1] is True:
            about.cause = "max_impacts must not be True, even though Python treats True as an "
            about.cause += "int. Call whole from arguments.py, which rejects it."
        elif numbers[1] == 10:
            about.cause = f"The duration must not be {numbers[0]!r}. Call positive from "
            about.cause += "arguments.py at the start to check it."
        expect_error(
            lambda numbers=numbers: time_division_step([p], GroundPlane([p]), *numbers),
            error,
            allowed=lambda: time_division_step(
                [Particle(Vector3(0.0, 5.0, 0.0))], GroundPlane([]), 0.5, 1
            ),
        )
        got = (*xyz(p.position), *xyz(p.velocity), *xyz(p.force_accumulator))
        before = (0.0, 5.0, 0.0, 1.0, 2.0, 3.0, 1.0, 0.0, 0.0)
        name = "position, velocity and force"
        late = "Your step raised an error, but only after it had changed the particle. Check both "
        late += "arguments before you change anything."
        expect_unchanged(name, got, before, cause=late)
