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
    expect_that,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
READ = "book 7.3.2, and the docstring of time_division_step"
DOWN = (0.0, -10.0, 0.0)
FRAME = 1.0 / 60.0


@pytest.mark.exercise("B7.12", asks="Between impacts the motion is exact")
def test_without_an_impact_the_flight_is_exact(rng: Random) -> None:
    about.read = READ
    v, h = (positive_number(rng), positive_number(rng), -positive_number(rng)), 0.5
    about.call = f"particle p at (0, 9, 0) with velocity {v} and acceleration {DOWN}; "
    about.call += f"time_division_step([p], ground, {h}), without an impact; "
    about.cause = "The acceleration is constant between impacts, so the new position is exactly p "
    about.cause += "+ v t + a t^2 / 2, and the new velocity is v + a t."
    after, _, _, _ = flown([((0.0, 9.0, 0.0), v, 2.0)], DOWN, 0.0, (0.5, None), h, 1)
    place, velocity = after[0][0]
    wanted = (v[0] * h, 9.0 + v[1] * h - 5.0 * h * h, v[2] * h)
    without = (wanted[0], 9.0 + v[1] * h, wanted[2])
    mistakes = [
        ((0.0, 9.0, 0.0),
         "The particle hasn't moved. When there is no further impact, move it for the rest of the "
         "step."),
        (without,
         "You left out the term a t^2 / 2, as explicit Euler does. Use p + v t + a t^2 / 2."),
        ((wanted[0], 9.0 + v[1] * h - 10.0 * h * h, wanted[2]),
         "You added a t^2 to the position, but the correct term is only half as large. Use p + v "
         "t + a t^2 / 2."),
    ]  # fmt: skip
    seen = cause_of(place, mistakes, about.cause)
    expect_close(place, wanted, then="p.position", cause=seen, unit="m")
    expect_close(velocity, (v[0], v[1] - 10.0 * h, v[2]), then="p.velocity", unit="m/s")
    about.call = "an immovable particle p at (0, 0, 0) with velocity (1, 2, 3); "
    about.call += f"time_division_step([p], ground, {h}); "
    about.cause = "You changed an immovable particle. Leave its position and its velocity "
    about.cause += "unchanged."
    seen, _, _, _ = flown([(ZERO, (1.0, 2.0, 3.0), math.inf)], DOWN, 0.0, (0.5, None), h, 1)
    place, velocity = seen[0][0]
    expect_close(place, ZERO, then="p.position", tolerance=3e-13, unit="m")
    expect_close(velocity, (1.0, 2.0, 3.0), then="p.velocity", unit="m/s")


@pytest.mark.exercise("B7.12", asks="stop at each impact to resolve it")
def test_a_ball_bounces_at_the_right_times(rng: Random) -> None:
    about.read = READ
    e = round(rng.uniform(0.55, 0.9), 3)  # at 0.5 the bounces end at 3 s
    for frames, h in ((1, 3.0), (180, FRAME)):
        about.call = "a ball falls 5 m to the ground with gravity of 10 m/s^2; it bounces with a "
        about.call += f"restitution of {e}; time_division_step([ball], ground, {h:.6g}) "
        about.call += "once; " if frames == 1 else f"{frames} times; "
        # It falls for 1 s, bounces at e times 10 m/s, and flies for 2 e, 2 e^2, ... seconds.
        times, t = [], 1.0
        while t <= 3.0:
            times.append(t)
            t += 2.0 * e ** len(times)
        about.cause = "You missed an impact of this step. After each impact, call next_impact "
        about.cause += "again for what is left of the step: subtract the time of the impact."
        ball = [((0.0, 5.0, 0.0), ZERO, 2.0)]
        seen, found, asked, _ = flown(ball, DOWN, 0.0, (e, None), h, frames)
        if len(found) > len(times):
            about.cause = "You found more impacts than there are. Subtract the time of each impact "
            about.cause += "from the rest of the step, and pass what is left to next_impact."
            if found[1][2] < 1e-9:
                about.cause = "You resolved an impact before you moved the particles. Move all of "
                about.cause += "them to the time of the impact first."
        if len(found) > 1000 and asked[-1] == h:
            about.cause = "You pass the whole duration to next_impact again after each impact, so "
            about.cause += "the step never ends. Pass only the time that is left in the step."
        elif len(found) > 1000:
            about.cause = "Your ball stops bouncing. Call resolve_velocity at each impact with a "
            about.cause += "duration of 0, because it ignores velocity gained during the duration."
        expect_exactly(len(found), len(times), then="the number of impacts", unit="impacts")
        last, bounces = times[-1], len(times)
        left = 3.0 - last
        speed = 10.0 * e**bounces
        wanted = (speed * left - 5.0 * left * left, speed - 10.0 * left)
        place, velocity = seen[-1][0]
        about.cause = "The ball bounces with the wrong speed. Pass a duration of 0 to "
        about.cause += "resolve_velocity, because it ignores velocity gained during the duration."
        # Some 200 flights, each with a few roundings of 10 m.
        name = "the final height in m and the final velocity along y in m/s"
        expect_close((place[1], velocity[1]), wanted, then=name, tolerance=1e-11)
        about.cause = "You called next_impact with the wrong duration. Pass the duration of the "
        about.cause += "whole step to the first call, and the rest of the step to each later call."
        expect_close(max(asked), h, then="the longest duration passed to next_impact", unit="s")
        about.cause = "You called next_impact too often or too rarely. Call it once at the start "
        about.cause += "of each step and once more after each impact."
        expect_exactly(len(asked), frames + bounces, then="calls to next_impact", unit="calls")


@pytest.mark.exercise("B7.12", asks="of its contact with a duration of 0")
def test_a_restitution_of_1_loses_no_energy() -> None:
    about.read = READ
    about.call = "a ball falls 2 m to the ground with gravity of 10 m/s^2; it bounces with a "
    about.call += "restitution of 1; time_division_step([ball], ground, 1/60) 1200 times; "
    about.cause = "The energy has changed, although no bounce loses any energy at a restitution of "
    about.cause += "1. Check how you move the particles between two impacts."
    seen, found, _, _ = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (1.0, None), FRAME, 1200)
    heights = [place[1] + velocity[1] ** 2 / 20.0 for ((place, velocity),) in seen]
    got = (min(heights), max(heights))
    # 1200 steps, each with a few roundings of 2 m.
    expect_close(got, (2.0, 2.0), tolerance=1e-11, then="the lowest and highest energy / (m g)")
    about.cause = "The number of impacts is wrong. The first impact is after sqrt(0.4) s, and the "
    about.cause += "others follow every 2 sqrt(0.4) s."
    expect_exactly(len(found), 16, then="the number of impacts", unit="impacts")


@pytest.mark.exercise("B7.12", asks="another impact after max_impacts impacts")
def test_a_ball_at_rest_raises_too_many_impacts() -> None:
    about.read = "the docstring of TooManyImpacts"
    about.call = "a ball falls 2 m to the ground with gravity of 10 m/s^2; it bounces with a "
    about.call += "restitution of 0.5; time_division_step([ball], ground, 1/60) repeatedly, until "
    about.call += "it raises an error; "
    about.cause = "You raised no error, although the impacts never end as the ball comes to rest. "
    about.cause += "Raise TooManyImpacts if there is another impact after max_impacts impacts."
    seen, _, _, ended = flown([((0.0, 2.0, 0.0), ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 200)
    expect_that(ended is not None, "no error in 200 steps", "TooManyImpacts", then="the error")
    impacts, time = ended or (0, 0.0)
    got = (len(seen) - 1) * FRAME + time
    # The last bounces that floats can distinguish are 1e-9 s apart.
    ends = 1.8973666
    early = int(ends / FRAME) * FRAME
    name = "The time in your error is the time that is left in the step. Pass the time since the "
    blame(got, [(2.0 * early + FRAME - ends, f"{name}start of the step.")], tolerance=1e-7)
    name = "the start of the last step plus error.time"
    expect_close(got, ends, then=name, tolerance=1e-7, unit="s")
    many = "You resolved one impact too many. If there is another impact after max_impacts "
    many += "impacts, raise TooManyImpacts without resolving it."
    wrong = "error.impacts is wrong. Raise TooManyImpacts with the number of resolved impacts."
    why = many if impacts == 1001 else wrong
    expect_exactly(impacts, 1000, then="error.impacts", cause=why)
    about.call = "particle p lies on the ground, with gravity of 10 m/s^2 and a restitution of "
    about.call += "0.5; time_division_step([p], ground, 1/60); error.impacts and error.time in s"
    about.cause = "A particle that lies on the ground has one impact after another at time 0. "
    about.cause += "Raise TooManyImpacts after max_impacts impacts."
    _, _, _, ended = flown([(ZERO, ZERO, 1.0)], DOWN, 0.0, (0.5, None), FRAME, 1)
    expect_close(ended or (0, -1.0), (1000, 0.0))
    falls = "a ball falls 5 m to the ground with gravity of 10 m/s^2; it bounces with a "
    falls += "restitution of 0.5; "
    about.call = f"{falls}time_division_step([ball], ground, 2.6, max_impacts=3)"
    about.cause = "You raised an error after three impacts, but max_impacts=3 allows them. Raise "
    about.cause += "it only if there is another impact."
    body = ((0.0, 5.0, 0.0), ZERO, 1.0)
    _, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 2.6, 1, 3)
    expect_that(ended is None, "TooManyImpacts", "no error")
    for most in (3, 1):
        about.call = falls.replace("a ball falls", "a ball with a damping of 0.5 falls")
        about.call += f"time_division_step([ball], ground, 9.0, max_impacts={most})"
        about.cause = wrong
        seen, _, _, ended = flown([body], DOWN, 0.0, (0.5, None), 9.0, 1, most, 0.5)
        impacts, time = ended or (0, 0.0)
        times = [1.0, 2.0, 2.5, 2.75]
        why = many if impacts == most + 1 else wrong
        expect_exactly(impacts, most, then="; error.impacts", cause=why)
        about.cause = "Your impacts come too early, because you damped the velocity at each "
        about.cause += "impact. Apply the damping once, at the end of the step."
        expect_close(time, times[most], then="; error.time", tolerance=1e-12, unit="s")
        place, velocity = seen[0][0]
        speed = -10.0 * 0.5**most
        about.cause = "Before you raise TooManyImpacts, move the particles to the time of the next "
        about.cause += "impact. Don't resolve that impact, and don't apply the damping."
        stayed = "You raised the error while the particles were still at the last allowed impact. "
        stayed += "Move them to the time of the next impact first."
        damped = "You applied the damping before you raised TooManyImpacts. Damping acts only at "
        damped += "the end of a complete step, so raise the error first."
        mistakes = [(speed * 0.5**t, damped) for t in (times[most], 9.0)]
        blame(velocity[1], [(-speed, stayed), (-0.5 * speed, many), *mistakes])
        expect_close(place[1], 0.0, then="; the height after the error", tolerance=1e-12, unit="m")
        name = "; the velocity along y after the error"
        expect_close(velocity[1], speed, then=name, tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.12", asks="in the order in which they are found")
def test_a_cradle_passes_its_motion_on(rng: Random) -> None:
    about.read = "book 7.3.2; simultaneous impacts are resolved one after the other"
    speed = positive_number(rng, 0.5, 3.0)  # slow enough that a late exchange shows
    for count in (1, 2, 3):
        speeds = [speed if i < count else 0.0 for i in range(5)]
        gap = 0.75 * speed  # they arrive in the middle of a step
        places = [2.0 * i - (gap if i < count else 0.0) for i in range(5)]
        about.call = "five spheres (radius 1 m, 2 kg) in a row, with a restitution of 1; the first "
        about.call += f"{count} of them at {speed} m/s reach{'es' if count == 1 else ''} the "
        about.call += "others, which touch, after 0.75 s; "
        about.call += "time_division_step(spheres, pairs, 0.5) 4 times; "
        about.cause = "Each impact passes the velocity on to the next sphere, so as many spheres "
        about.cause += "should leave as arrive. Resolve simultaneous impacts one after another."
        bodies = [((x, 0.0, 0.0), (v, 0.0, 0.0), 2.0) for x, v in zip(places, speeds, strict=True)]
        seen, found, _, _ = flown(bodies, ZERO, 1.0, (None, 1.0), 0.5, 4)
        got = tuple(velocity[0] for _, velocity in seen[-1])
        wanted = tuple(speed if i >= 5 - count else 0.0 for i in range(5))
        name = "the final velocities along the row"
        expect_close(got, wanted, tolerance=1e-13, then=name, unit="m/s")
        right = count * (5 - count)
        expect_exactly(len(found), right, then="the number of impacts", unit="impacts")


@pytest.mark.exercise("B7.12", asks="finds in the rest of the step")
def test_impacts_are_resolved_in_order(rng: Random) -> None:
    about.read = READ
    # Spheres of radius 1 along X. The light one in the middle is hit from both sides in turn.
    late = positive_number(rng, 0.1, 0.9)
    bodies = [
        ((-3.0, 0.0, 0.0), (1.0, 0.0, 0.0), 3.0),
        (ZERO, ZERO, 1.0),
        ((3.0 + late, 0.0, 0.0), (-1.0, 0.0, 0.0), 3.0),
    ]
    about.call = f"three spheres (radius 1 m; 3, 1 and 3 kg) at x = -3, 0 and {3.0 + late:g}, with "
    about.call += "velocities of 1, 0 and -1 m/s and a restitution of 1; "
    about.call += "time_division_step(spheres, pairs, 5.0); "
    about.cause = "The left and the middle sphere meet first, after 1 s, and this changes the time "
    about.cause += "of the next impact. Call next_impact again after each impact."
    seen, found, _, _ = flown(bodies, ZERO, 1.0, (None, 1.0), 5.0, 1)
    # After the first impact: 3 kg at 0.5, 1 kg at 1.5 m/s, which meets the right one at 2.5 m/s.
    wanted_times = (1.0, late / 2.5)
    got = tuple(time for _, _, time in found[:2])
    name = "the time of the first impact, and the time from then to the second one"
    expect_close(got, wanted_times, then=name, tolerance=1e-13, unit="s")
    name = "the indices of the two spheres in the first two impacts"
    pairs = [number for a, b, _ in found[:2] for number in (a, b)]
    expect_exactly(pairs, [0, 1, 1, 2], then=name)
    about.cause = "Impacts with a restitution of 1 conserve the momentum and the kinetic energy. "
    about.cause += "Check that you resolve each impact only once."
    parts = [(m, v[0]) for (_, _, m), (_, v) in zip(bodies, seen[0], strict=True)]
    momentum = math.fsum(m * v for m, v in parts)
    energy = math.fsum(0.5 * m * v**2 for m, v in parts)
    name = "the final momentum in kg m/s and kinetic energy in J"
    expect_close((momentum, energy), (0.0, 3.0), then=name, tolerance=1e-13)
    about.cause = "Two spheres have passed through each other, so you missed an impact. Call "
    about.cause += "next_impact again after each impact."
    gaps = [right[0][0] - left[0][0] - 2.0 for left, right in pairwise(seen[0])]
    got = min(0.0, *gaps)
    expect_close(got, 0.0, then="the smallest final gap", tolerance=1e-13, unit="m")


def bounced(high: float, a: float, h: float) -> tuple[float, float]:
    """Return height and velocity after ``h`` s, if a ball moves down at 4 m/s and bounces once.

    It starts at a height of ``high``, ``a`` is its acceleration, and the restitution is 0.5.
    """
    fall = (4.0 - math.sqrt(16.0 - 2.0 * a * high)) / a
    speed, rest = 0.5 * (4.0 - a * fall), h - fall
    return speed * rest + 0.5 * a * rest * rest, speed + a * rest


@pytest.mark.exercise("B7.12", asks="multiply each velocity once by d^h")
def test_forces_and_damping_act_for_one_step(rng: Random) -> None:
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
    about.call = f"particle p ({mass} kg, damping {d}) at (0, {high:.6g}, 0) with velocity (3, -4, "
    about.call += f"0); its acceleration is {own}; p.add_force(Vector3{force}); "
    about.call += f"time_division_step([p], ground, {h}) with a restitution of 0.5; "
    height, end = bounced(high, a, h)
    end *= d**h
    about.cause = "The acceleration of p is its constant acceleration plus force / mass. Use it "
    about.cause += "for the whole step, even after an impact."
    bouncing, falling, fixed = pushed(pushes, d, h)
    # Some roundings of 5 m/s.
    wanted = (3.0 * h, height, 0.0)
    blame(bouncing[0], [
        ((3.0 * h, bounced(high, own[1], h)[0], 0.0),
         "You used p.acceleration, which doesn't include the force. Use last_acceleration "
         "instead, which includes force / mass."),
    ])  # fmt: skip
    expect_close(bouncing[0], wanted, then="p.position", tolerance=1e-13, unit="m")
    about.cause = "Apply the damping once for the whole step: multiply the velocity by damping ** "
    about.cause += "duration at the end."
    mistakes = [
        ((3.0, 2.0 * end, 0.0), "You left out the damping. Multiply the velocity by damping ** "
                                "duration at the end of the step."),
        ((0.75, 0.5 * end, 0.0),
         "You applied the damping for a whole second, but the step is shorter. Multiply the "
         "velocity by damping ** duration."),
    ]  # fmt: skip
    blame(bouncing[1], mistakes)
    wanted = (1.5, end, 0.0)
    expect_close(bouncing[1], wanted, then="p.velocity", tolerance=1e-13, unit="m/s")
    about.cause = "p.last_acceleration must include the force of this step. Call "
    about.cause += "particle.kick(0.0), which updates it without changing the velocity."
    name = "p.last_acceleration"
    expect_close(bouncing[2], (0.0, a, 0.0), then=name, tolerance=1e-14, unit="m/s^2")
    about.cause = "You left the force in the accumulator, but a force acts for only one step. Call "
    about.cause += "particle.kick(0.0), which clears it without changing the velocity."
    expect_close(bouncing[3], ZERO, then="p.force_accumulator", unit="N")
    about.cause = "The acceleration of q is f / m = 8 N / 2 kg = 4 m/s^2. Use "
    about.cause += "the last_acceleration of each particle when you move it."
    bounces = about.call
    about.call = "particles p, q and r; q (2 kg, damping 0.25) is at rest at (9, 90, 0) with a "
    about.call += f"force of (8, 0, 0) N; time_division_step([p, q, r], ground, {h}); "
    still = "Particle q hasn't moved, although a force of 8 N acts on it. Call kick(0.0) on every "
    still += "particle at the start of the step, not only on the first one."
    blame(falling[0], [((9.0, 90.0, 0.0), still)])
    expect_close(falling[0], (9.5, 90.0, 0.0), then="q.position", tolerance=1e-13, unit="m")
    expect_close(falling[1], (1.0, 0.0, 0.0), then="q.velocity", tolerance=1e-13, unit="m/s")
    about.cause = "You changed an immovable particle, or left forces on it. Call kick(0.0) on it, "
    about.cause += "but don't move it."
    about.call = "an immovable particle p at (9, 9, 9) with velocity (1, 2, 3) and force (1, 2, "
    about.call += f"3); time_division_step([p], ground, {h}); "
    expect_close(fixed[0], (9.0, 9.0, 9.0), then="p.position", tolerance=9e-13, unit="m")
    expect_close(fixed[1], (1.0, 2.0, 3.0), then="p.velocity", tolerance=9e-13, unit="m/s")
    expect_close(fixed[3], ZERO, then="p.force_accumulator", tolerance=9e-13, unit="N")
    about.call = f"{bounces}a second step; "
    about.cause = "The force still acts in the second step, but a force lasts for only one step. "
    about.cause += "Call kick(0.0) at the start of each step to clear the forces."
    wanted = (2.25, height + end * h + 0.125 * a * h * h, 0.0)
    expect_close(bouncing[4], wanted, then="p.position", tolerance=1e-13, unit="m")


@pytest.mark.exercise("B7.12", asks="Do not resolve its penetration")
def test_penetrations_are_not_resolved() -> None:
    about.read = READ
    below = "particle p at (0, -1, 0), below the ground, with velocity "
    after = "; time_division_step([p], ground, 0.5); "
    about.call = f"{below}(0, 3, 0){after}"
    about.cause = "The particle is below the ground but moves out of it, so there is no impact. "
    about.cause += "Let it fly, and don't resolve its penetration."
    seen = flown([((0.0, -1.0, 0.0), (0.0, 3.0, 0.0), 2.0)], ZERO, 0.0, (0.5, None), 0.5, 1)[0]
    place, velocity = seen[0][0]
    expect_close(place, (0.0, 0.5, 0.0), then="p.position", tolerance=3e-13, unit="m")
    expect_close(velocity, (0.0, 3.0, 0.0), then="p.velocity", unit="m/s")
    about.call = f"{below}(0, -3, 0) and a restitution of 0.5{after}"
    about.cause = "You moved the particle out of the ground, but time_division_step resolves only "
    about.cause += "velocities. Call only resolve_velocity."
    seen = flown([((0.0, -1.0, 0.0), (0.0, -3.0, 0.0), 2.0)], ZERO, 0.0, (0.5, None), 0.5, 1)[0]
    place, velocity = seen[0][0]
    expect_close(place, (0.0, -0.25, 0.0), then="p.position", tolerance=1.5e-13, unit="m")
    expect_close(velocity, (0.0, 1.5, 0.0), then="p.velocity", unit="m/s")


@pytest.mark.exercise("B7.12", asks="if the duration is not positive and finite")
@pytest.mark.robust
def test_a_step_rejects_invalid_arguments() -> None:
    about.read = READ
    p = Particle(Vector3(0.0, 5.0, 0.0), Vector3(1.0, 2.0, 3.0))
    p.add_force(Vector3(1.0, 0.0, 0.0))
    bad: list[tuple[tuple, type[Exception]]] = [
        ((duration, 10), ValueError) for duration in (0.0, -1.0, math.nan, math.inf)
    ]
    bad += [((0.5, 0), ValueError), ((0.5, -1), ValueError), ((0.5, 2.0), TypeError)]
    bad += [(("0.5", 10), TypeError), ((0.5, True), TypeError)]
    for numbers, error in bad:
        about.call = "particle p with velocity (1, 2, 3) and a force of 1 N; "
        about.call += f"time_division_step([p], ground, {numbers[0]!r}, max_impacts={numbers[1]!r})"
        about.cause = f"max_impacts is {numbers[1]!r}, but it must be a whole number of at least "
        about.cause += "1. Call whole from arguments.py, which raises the error for you."
        if numbers[1] is True:
            about.cause = "max_impacts is True, which Python treats as the int 1. Call whole from "
            about.cause += "arguments.py, which rejects True."
        elif numbers[1] == 10:
            about.cause = f"The duration is {numbers[0]!r}, but it must be positive and finite. "
            about.cause += "Call positive from arguments.py, which raises the error for you."
        expect_error(
            lambda numbers=numbers: time_division_step([p], GroundPlane([p]), *numbers),
            error,
            allowed=lambda: time_division_step(
                [Particle(Vector3(0.0, 5.0, 0.0))], GroundPlane([]), 0.5, 1
            ),
        )
        got = (*xyz(p.position), *xyz(p.velocity), *xyz(p.force_accumulator))
        before = (0.0, 5.0, 0.0, 1.0, 2.0, 3.0, 1.0, 0.0, 0.0)
        name = "the tuple of p's position, velocity and force"
        late = "time_division_step raised the right error, but only after it had changed the "
        late += "particle. Check both arguments before you change anything."
        expect_unchanged(name, got, before, cause=late)
