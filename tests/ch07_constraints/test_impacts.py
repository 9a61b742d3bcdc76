"""Detectors of what will touch: the ground and pairs of spheres, B7.10 and B7.11."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import told
from draw import components, direction, number, positive_number
from expect import (
    about,
    blame,
    cause_of,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    scoped,
    xyz,
)

ZERO, UP = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
GROUND = "the docstring of GroundPlane.next_impact"
PAIRS = "the docstring of ParticlePairs.next_impact"


@scoped
def expect_impact(impact: Any) -> Any:
    """Expect that there is an impact; return it."""
    about.cause = f"an impact is found, as time and contact: {about.cause}"
    expect_exactly(impact is None, False, then=" is None")
    return impact


@pytest.mark.exercise("B7.10")
def test_the_first_on_the_ground(rng: Random) -> None:
    about.read = GROUND
    height, radius, c = number(rng), 0.25, round(rng.uniform(0.1, 0.9), 3)
    speeds = [positive_number(rng, 1.0, 2.0) for _ in range(4)]
    falls = [3.0, 2.0, 1.0, 2.5]
    places = [(number(rng), height + radius + fall, number(rng)) for fall in falls]
    about.call = f"four spheres {falls} m above the ground, with the speeds {speeds} downwards; g "
    about.call += f"= GroundPlane(particles, {height}, {radius}, {c}); g.next_impact(9.0)"
    particles = [
        Particle(Vector3(*place), Vector3(5.0, -speed, 5.0))
        for place, speed in zip(places, speeds, strict=True)
    ]
    ground = GroundPlane(particles, height, radius, c)
    times = [fall / speed for fall, speed in zip(falls, speeds, strict=True)]
    first = min(times)
    about.cause = "a tuple (time, contact): the smallest time of all particles, and a contact of "
    about.cause += "penetration 0 with its particle, no other, the normal (0, 1, 0) and the "
    about.cause += "restitution"
    impact = expect_impact(ground.next_impact(9.0))
    time, contact = impact[0], impact[1]
    whole = min((fall + radius) / speed for fall, speed in zip(falls, speeds, strict=True))
    mistakes = [
        (max(times), "that is the last of them: the smallest time comes first"),
        (times[0], "that is the first in the list: the smallest time of all is wanted"),
        (whole, "the radius is left out: the lowest point gets there first"),
    ]
    seen = cause_of(time, mistakes, about.cause)
    expect_close(time, first, then=": time", cause=seen, tolerance=1e-13)
    ((a, b, normal, restitution, depth),) = told([contact], particles)
    seen = (a, b, *normal, restitution, depth)
    wanted = (times.index(first), -1, *UP, c, 0.0)
    if depth:
        about.cause = "the depth is 0: the contact is that of the moment when they touch, not of "
        about.cause += "now"
    expect_close(seen, wanted, then=": particle by number, -1 for None, normal, restitution, depth")
    about.cause = "what comes later than the duration is no impact of this frame"
    got = ground.next_impact(0.999 * first)
    expect_exactly(got is None, True, then=f"; g.next_impact({0.999 * first}) is None")
    about.cause = "an impact at the very end of the duration is one"
    got = ground.next_impact(float(time))
    expect_exactly(got is None, False, then=f"; g.next_impact({time!r}) is None")
    about.call += f"; g.height -= 1, g.radius = 0, g.restitution = 0.5; g.next_impact({first!r} + "
    about.call += "9)"
    about.cause = "read the attributes each time: all of them fall 1.25 m further"
    ground.height -= 1.0
    ground.radius, ground.restitution = 0.0, 0.5
    impact = ground.next_impact(first + 9.0)
    later = min((fall + 1.25) / speed for fall, speed in zip(falls, speeds, strict=True))
    seen = (impact[0], impact[1].restitution)
    expect_close(seen, (later, 0.5), then=": time, restitution")
    about.cause = "to look ahead moves nothing"
    for i, particle in enumerate(particles):
        now = (*xyz(particle.position), *xyz(particle.velocity))
        before = (*places[i], 5.0, -speeds[i], 5.0)
        expect_unchanged(f"particles[{i}]", now, before)


@pytest.mark.exercise("B7.10")
def test_the_ground_sees_accelerations_and_walls(rng: Random) -> None:
    about.read = GROUND
    t = positive_number(rng)
    about.call = f"p of 2 kg at (0, {2.5 * t * t}, 0), at rest; p.add_force(Vector3(0, -14, 0)), "
    about.call += "and 2 m/s^2 of its own upwards; p.integrate(1e-9); "
    about.call += "GroundPlane([p]).next_impact(100): time"
    about.cause = "the acceleration is last_acceleration, forces and all: -14 / 2 + 2 = -5 m/s^2; "
    about.cause += "its own 2 m/s^2 alone would take it up"
    p = Particle(Vector3(0.0, 2.5 * t * t, 0.0), None, Vector3(0.0, 2.0, 0.0), mass=2.0)
    p.add_force(Vector3(0.0, -14.0, 0.0))
    p.integrate(1e-9)
    impact = expect_impact(GroundPlane([p]).next_impact(100.0))
    # Its speed of 5e-9 m/s by then makes it come sooner by 1e-9 s.
    expect_close(impact[0], t, tolerance=1e-8)
    about.call = "an immovable particle at height 1 and one of 1 kg at height 2, both with 2 m/s "
    about.call += "downwards; GroundPlane(particles).next_impact(9): time"
    about.cause = "what is immovable does not move, and does not impact"
    down = Vector3(0.0, -2.0, 0.0)
    particles = [
        Particle(Vector3(0.0, 1.0), down, mass=math.inf),
        Particle(Vector3(0.0, 2.0), down),
    ]
    impact = expect_impact(GroundPlane(particles).next_impact(9.0))
    expect_close(impact[0], 1.0)
    about.call = "two particles at height 2 with 2 m/s downwards; "
    about.call += "GroundPlane(particles).next_impact(1)"
    about.cause = "of two at the same time the first in the list is taken"
    particles = [Particle(Vector3(i, 2.0, 0.0), down) for i in range(2)]
    impact = expect_impact(GroundPlane(particles).next_impact(1.0))
    ((first, *_),) = told([impact[1]], particles)
    expect_exactly(first, 0, then=": which")
    expect_close(impact[0], 1.0, then=": time")
    about.call = "p 1 m below the ground with 2 m/s downwards; GroundPlane([p]).next_impact(0): "
    about.call += "time, depth"
    about.cause = "it closes: now, which is within a duration of 0, and with a penetration of 0"
    impact = expect_impact(GroundPlane([Particle(Vector3(0.0, -1.0, 0.0), down)]).next_impact(0.0))
    seen = (impact[0], impact[1].penetration)
    expect_close(seen, (0.0, 0.0))
    about.call = "p immovable; GroundPlane([p]).next_impact(9) is None"
    about.cause = "where nothing can move there is no impact, and no error"
    impact = GroundPlane([Particle(mass=math.inf)]).next_impact(9.0)
    expect_exactly(impact is None, True)


@pytest.mark.exercise("B7.10")
@pytest.mark.robust
def test_the_ground_looks_ahead_for_a_duration() -> None:
    about.read = GROUND
    ground = GroundPlane([Particle(Vector3(0.0, 1.0, 0.0))])
    expect_durations("GroundPlane(particles)", ground)


@scoped
def expect_durations(name: str, detector: object) -> None:
    about.cause = "refuse what is negative or not finite: not_negative of arguments.py does, and "
    about.cause += "what is no number as well"
    for duration, error in (
        (-0.5, ValueError),
        (math.nan, ValueError),
        (math.inf, ValueError),
        ("1", TypeError),
    ):
        expect_error(
            lambda duration=duration: detector.next_impact(duration),
            error,
            call=f"{name}.next_impact({duration!r})",
            allowed=lambda: detector.next_impact(0),
        )


@pytest.mark.exercise("B7.11")
def test_when_two_spheres_meet(rng: Random) -> None:
    about.read = PAIRS
    n, radius, t = direction(rng), positive_number(rng, 0.2, 0.9), positive_number(rng)
    speed, side, c = positive_number(rng), components(rng), round(rng.uniform(0.1, 0.9), 3)
    # Seen from b, a comes along a line; at the time t it is at two radii in the direction n.
    u = components(rng)
    if sum(p * q for p, q in zip(u, n, strict=True)) > 0.0:
        u = (-u[0], -u[1], -u[2])
    q, w = components(rng), side
    p = tuple(x + 2.0 * radius * m - t * s for x, m, s in zip(q, n, u, strict=True))
    v = tuple(x + y for x, y in zip(w, u, strict=True))
    far = (-10.8, 1.4, 0.0)  # the sides of a right triangle: 1.4, 4.8 and 5 = 2 r
    simple = (far, (2.0, 0.0, 0.0), ZERO, (-1.0, 0.0, 0.0), 2.5, 0.5, (-0.96, 0.28, 0.0), 2.0)
    drawn = (p, v, q, w, radius, c, n, t)
    for p, v, q, w, radius, c, n, t in (simple, drawn):
        down = (1.0, -speed, 2.0)
        about.call = f"a at {p}, velocity {v}; b at {q}, velocity {w}; both with acceleration "
        about.call += f"{down}; ParticlePairs([a, b], {radius}, {c}).next_impact(10)"
        about.cause = "of |d + u t| = 2 r, with d and u as a is seen from b, the first solution"
        pair = [
            Particle(Vector3(*p), Vector3(*v), Vector3(*down)),
            Particle(Vector3(*q), Vector3(*w), Vector3(*down), mass=3.0),
        ]
        impact = expect_impact(ParticlePairs(pair, radius, c).next_impact(10.0))
        if p == far:
            mistakes = [
                (5.2, "that is the second solution of |d + u t| = 2 r, where they part"),
                (3.6 - math.sqrt(4.29) / 3.0, "that is for one radius: they touch at 2 r"),
                (3.6, "that is when the middles are nearest: they touch at 2 r"),
                (3.0, "the velocity of b is left out: u is that of a seen from b, va - vb"),
                (6.0, "the velocities are added: u is that of a seen from b, va - vb"),
            ]
            blame(impact[0], mistakes)
        # Places of up to 90 m, rounded, over closing speeds of about 1 m/s; grazing ones lose more.
        expect_close(impact[0], t, then=": time", tolerance=1e-9)
        ((first, second, normal, restitution, depth),) = told([impact[1]], pair)
        about.cause = "the normal leads from b to a, by their places at the time of impact, not of "
        about.cause += "now"
        turned = tuple(-part for part in n)
        mistakes = [(turned, "the normal is turned round: it leads from b to a")]
        blame(normal, mistakes, tolerance=1e-8)
        expect_close(normal, n, then=": normal", tolerance=1e-8)
        about.cause = "the contact has both, the detector's restitution, and at the impact a depth "
        about.cause += "of 0"
        seen = (first, second, restitution, depth)
        expect_close(
            seen, (0, 1, c, 0.0), then=": particle and other by number, restitution, penetration"
        )
        about.cause = "to look ahead moves nothing"
        one, other = pair
        now = (*xyz(one.position), *xyz(one.velocity), *xyz(other.position), *xyz(other.velocity))
        expect_unchanged("a and b", now, (*p, *v, *q, *w))


@pytest.mark.exercise("B7.11")
def test_spheres_that_touch_or_never_meet() -> None:
    about.read = PAIRS
    for x, y, speed, wanted, cause in (
        (2.0, 0.0, -3.0, 0.0, "they touch, and close: now"),
        (1.5, 0.0, -3.0, 0.0, "they overlap, and close: now"),
        (1.5, 0.0, 3.0, None, "they overlap, but part"),
        (5.0, 0.0, 3.0, None, "they part"),
        (5.0, 0.0, 0.0, None, "neither moves, as the other sees it"),
        (5.0, 2.5, -3.0, None, "they pass each other by: the root is negative"),
        (5.0, 2.000001, -3.0, None, "they only just miss each other"),
        (5.0, 0.0, -3.0, 1.0, "they are 5 m apart, and meet at 2 m"),
        (-5.0, 0.0, 3.0, 1.0, "they are 5 m apart, and meet at 2 m"),
        (5.0, 0.0, -0.125, None, "they meet after 24 s, and not within 10"),
        (2.0, 0.0, -1e-9, 0.0, "they touch, and close, if slowly: now"),
        (32.0, 0.0, -3.0, 10.0, "they meet at the very end of the duration"),
        (2.0, 0.0, -1e-13, None, "closing by less than VELOCITY_TOLERANCE is rounding"),
        (0.0, 0.0, 3.0, None, "at one place they do not close"),
    ):
        about(f"a at ({x}, {y}, 0), velocity ({speed}, 0, 0); b at (0, 0, 0); ", cause=cause)
        about.call += "ParticlePairs([a, b], 1.0).next_impact(10.0)"
        pair = [Particle(Vector3(x, y, 0.0), Vector3(speed)), Particle()]
        impact = ParticlePairs(pair, 1.0).next_impact(10.0)
        expect_exactly(impact is None, wanted is None, then=" is None")
        if wanted is not None:
            expect_close(impact[0], wanted, then=": time")
            about.cause = "the contact of an impact has a penetration of 0"
            got = impact[1].penetration
            expect_close(got, 0.0, then=": penetration")
    about.call = "ParticlePairs([a], 1.0).next_impact(10.0) is None"
    about.cause = "one alone meets nobody, and that is no error"
    impact = ParticlePairs([Particle()], 1.0).next_impact(10.0)
    expect_exactly(impact is None, True)
    about.call = "a at (5, 0, 0), velocity (-3, 0, 0), b at (0, 0, 0); p = ParticlePairs([a, b], "
    about.call += "1.0); p.next_impact(1.0); p.radius, p.restitution = 1.75, 0.5; "
    about.call += "p.next_impact(1.0)"
    about.cause = "read the attributes each time"
    pairs = ParticlePairs([Particle(Vector3(5.0), Vector3(-3.0)), Particle()], 1.0)
    pairs.next_impact(1.0)
    pairs.radius, pairs.restitution = 1.75, 0.5
    impact = expect_impact(pairs.next_impact(1.0))
    seen = (impact[0], impact[1].restitution)
    expect_close(seen, (0.5, 0.5), then=": time, restitution")


@pytest.mark.exercise("B7.11")
def test_the_first_pair_of_many(rng: Random) -> None:
    about.read = PAIRS
    speed = positive_number(rng, 1.0, 3.0)
    places = [0.0, 30.0, 3.0, 7.0, 32.5, 9.5]
    speeds = [0.0, speed, 0.0, 0.0, -speed, -speed]
    about.call = f"six spheres of radius 1 at x = {places}, with {speeds} m/s along it; p = "
    about.call += "ParticlePairs(particles, 1.0); p.next_impact(9.0)"
    about.cause = "all pairs, and the smallest time: two are half a metre apart, and both move"
    particles = [Particle(Vector3(x), Vector3(v)) for x, v in zip(places, speeds, strict=True)]
    pairs = ParticlePairs(particles, 1.0)
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, normal, _, _),) = told([impact[1]], particles)
    expect_close((a, b), (1, 4), then=": particle and other by number")
    expect_close(impact[0], 0.25 / speed, then=": time")
    about.cause = "the normal leads to the first of the pair, from the second"
    expect_close(normal, (-1.0, 0.0, 0.0), then=": normal")
    about.call += ", with numbers 1 and 4 immovable"
    about.cause = "two that are immovable stay where they are, and do not meet"
    particles[1].mass = particles[4].mass = math.inf
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_close((a, b), (3, 5), then=": particle and other")
    expect_close(impact[0], 0.5 / speed, then=": time")
    about.call = f"three spheres of radius 1 at 0, 3 and 6, with {speed}, 0 and -{speed} m/s; "
    about.call += "next_impact"
    about.cause = "of two at the same time the first in the order of the list is taken"
    particles = [Particle(Vector3(3.0 * i), Vector3(speed * (1 - i))) for i in range(3)]
    impact = expect_impact(ParticlePairs(particles, 1.0).next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_close((a, b), (0, 1), then=": particle and other")


@pytest.mark.exercise("B7.11")
def test_pairs_fall_alike(rng: Random) -> None:
    about.read = PAIRS
    for ma, mb in ((1.1, 1.3), (3.3, 4.9), (positive_number(rng), positive_number(rng))):
        about.call = f"a of {ma} kg, 5 m from b of {mb} kg at (0, 0, 0), with velocity (-3, 0, 0); "
        about.call += "their weights added as forces, m * 9.81; integrate(1e-9); ParticlePairs([a, "
        about.call += "b], 1.0).next_impact(10): time"
        about.cause = "both fall alike, whatever their masses: f / m is 9.81 for both but for "
        about.cause += "rounding, so accelerations that differ by 1e-15 of them are no reason to "
        about.cause += "refuse"
        pair = [Particle(Vector3(5.0), Vector3(-3.0), mass=ma), Particle(mass=mb)]
        for particle, mass in zip(pair, (ma, mb), strict=True):
            particle.add_force(Vector3(0.0, -9.81 * mass, 0.0))
            particle.integrate(1e-9)
        impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
        # 3e-9 m of the way are made already.
        expect_close(impact[0], 1.0, tolerance=2e-9)
    about.call = "a, immovable, with velocity (9, 9, 9) and acceleration (9, 9, 9), 5 m from b, "
    about.call += "which has (3, 0, 0); ParticlePairs([a, b], 1.0).next_impact(10): time"
    about.cause = "what is immovable stays where it is: it has neither velocity nor acceleration "
    about.cause += "here"
    nines = Vector3(9.0, 9.0, 9.0)
    pair = [Particle(Vector3(5.0), nines, nines, mass=math.inf), Particle(None, Vector3(3.0))]
    impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
    expect_close(impact[0], 1.0)
    ((_, _, normal, _, _),) = told([impact[1]], pair)
    expect_close(normal, (1.0, 0.0, 0.0), call=f"{about.call[:-4]}normal")


@pytest.mark.exercise("B7.11")
@pytest.mark.robust
def test_pairs_look_ahead_for_a_duration() -> None:
    about.read = PAIRS
    pair = [Particle(Vector3(5.0), Vector3(-1.0)), Particle()]
    expect_durations("ParticlePairs([a, b], 1.0)", ParticlePairs(pair, 1.0))
    about.cause = "seen from b, a does not move along a line: refuse it, or the time is a wrong "
    about.cause += "one; whether they close or not, and whichever way they differ"
    for velocity, one, other, force, mass in (
        (-1.0, (0.0, -9.0, 0.0), (0.0, 0.0, 0.0), 0.0, 1.0),
        (1.0, (0.0, -9.0, 0.0), (0.0, 0.0, 0.0), 0.0, 1.0),
        (-1.0, (0.0, 0.0, -9.0), (0.0, -9.0, 0.0), 0.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.000001, 0.0), 0.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.0, 0.0), 1.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.0, 0.0), 0.0, math.inf),
    ):
        about.call = f"a at (5, 0, 0), velocity ({velocity}, 0, 0), acceleration {one}; b of "
        about.call += f"{mass} kg at (0, 0, 0), acceleration {other}, and a force of {force} N "
        about.call += "along X, used by a step; ParticlePairs([a, b], 1.0).next_impact(1.0)"
        bad = [
            Particle(Vector3(5.0), Vector3(velocity), Vector3(*one)),
            Particle(None, None, Vector3(*other), mass=mass),
        ]
        if force:
            bad[1].add_force(Vector3(force))
            bad[1].integrate(1e-9)
        expect_error(
            lambda bad=bad: ParticlePairs(bad, 1.0).next_impact(1.0),
            ValueError,
            allowed=lambda: ParticlePairs(pair, 1.0).next_impact(1.0),
        )
