"""Detectors of future contacts: the ground and pairs of spheres, B7.10 and B7.11."""

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
    """Expect an impact, as time and contact, and return it."""
    about.cause = f"Return (time, contact), since there is an impact here. {about.cause}"
    pair = isinstance(impact, (tuple, list)) and len(impact) == 2
    expect_exactly(pair, True, then=" is (time, contact)")
    return impact


@pytest.mark.exercise("B7.10")
def test_the_first_on_the_ground(rng: Random) -> None:
    about.read = GROUND
    height, radius, c = number(rng), 0.25, round(rng.uniform(0.1, 0.9), 3)
    speeds = [positive_number(rng, 1.0, 2.0) for _ in range(4)]
    falls = [3.0, 2.0, 1.0, 2.5]
    places = [(number(rng), height + radius + fall, number(rng)) for fall in falls]
    about.call = f"four spheres {falls} m above the ground, with the speeds {speeds} downwards; "
    about.call += f"g = GroundPlane(particles, {height}, {radius}, {c}); g.next_impact(9.0)"
    particles = [
        Particle(Vector3(*place), Vector3(5.0, -speed, 5.0))
        for place, speed in zip(places, speeds, strict=True)
    ]
    ground = GroundPlane(particles, height, radius, c)
    times = [fall / speed for fall, speed in zip(falls, speeds, strict=True)]
    first = min(times)
    about.cause = "Return the earliest of the four impacts."
    impact = expect_impact(ground.next_impact(9.0))
    time, contact = impact[0], impact[1]
    whole = min((fall + radius) / speed for fall, speed in zip(falls, speeds, strict=True))
    mistakes = [
        (max(times), "The result is the last impact. Return the earliest one."),
        (
            times[0],
            "The result is the impact of the first particle in the list. Compare all particles.",
        ),
        (whole, "The radius is missing. The lowest point of the sphere arrives first."),
    ]
    seen = cause_of(time, mistakes, about.cause)
    name = f"{about.call}: time"
    expect_close(time, first, call=name, cause=seen, tolerance=1e-13)
    ((a, b, normal, restitution, depth),) = told([contact], particles)
    seen = (a, b, *normal, restitution, depth)
    wanted = (times.index(first), -1, *UP, c, 0.0)
    about.cause = "The contact is wrong. Pass it the particle, None as its other, the normal (0, "
    about.cause += "1, 0), the detector's restitution and a penetration of 0."
    for part, cause in (
        (0, "The particle must be the one that arrives first."),
        (1, "The ground is not a particle, so the contact's other must be None."),
        (3, "The normal must be (0, 1, 0), from the ground to the particle."),
        (5, "Pass the detector's restitution to the contact."),
        (6, "The contact describes the moment of the impact. Its penetration is 0."),
    ):
        if seen[part] != wanted[part]:
            about.cause = cause
            break
    name = f"{about.call}: index of particle and other (-1 is None), normal, restitution, depth"
    expect_close(seen, wanted, call=name)
    about.cause = "This impact comes after the duration. Return None."
    name = f"{about.call}; g.next_impact({0.999 * first}) is None"
    got = ground.next_impact(0.999 * first)
    expect_exactly(got is None, True, call=name)
    about.cause = "An impact exactly at the end of the duration counts, too."
    got = ground.next_impact(float(time))
    name = f"{about.call}; g.next_impact({time!r}) is None"
    expect_exactly(got is None, False, call=name)
    about.call += f"; g.height -= 1, g.radius = 0, g.restitution = 0.5; g.next_impact({first!r} + "
    about.call += "9)"
    about.cause = "Read height, radius and restitution on every call: all now fall 1.25 m farther."
    ground.height -= 1.0
    ground.radius, ground.restitution = 0.0, 0.5
    impact = ground.next_impact(first + 9.0)
    later = min((fall + 1.25) / speed for fall, speed in zip(falls, speeds, strict=True))
    seen = (impact[0], impact[1].restitution)
    expect_close(seen, (later, 0.5), then=": time, restitution")
    about.cause = "Looking ahead must not move anything."
    for i, particle in enumerate(particles):
        now = (*xyz(particle.position), *xyz(particle.velocity))
        before = (*places[i], 5.0, -speeds[i], 5.0)
        expect_unchanged(f"particles[{i}]", now, before)


@pytest.mark.exercise("B7.10")
def test_the_ground_sees_accelerations_and_walls(rng: Random) -> None:
    about.read = GROUND
    t = positive_number(rng)
    about.call = f"p of 2 kg at rest at (0, {2.5 * t * t}, 0), acceleration (0, 2, 0); "
    about.call += "p.add_force(Vector3(0, -14, 0)); p.integrate(1e-9); "
    about.call += "GroundPlane([p]).next_impact(100): time"
    about.cause = "Use last_acceleration, which includes the forces: -14 / 2 + 2 = -5 m/s^2. With "
    about.cause += "acceleration alone the particle would rise."
    p = Particle(Vector3(0.0, 2.5 * t * t, 0.0), None, Vector3(0.0, 2.0, 0.0), mass=2.0)
    p.add_force(Vector3(0.0, -14.0, 0.0))
    p.integrate(1e-9)
    impact = expect_impact(GroundPlane([p]).next_impact(100.0))
    # Its speed of 5e-9 m/s after the step brings the impact forward by 1e-9 s.
    expect_close(impact[0], t, tolerance=1e-8)
    about.call = "an immovable particle at height 1 and one of 1 kg at height 2, both with "
    about.call += "velocity (0, -2, 0); GroundPlane(particles).next_impact(9): time"
    about.cause = "An immovable particle does not move, so it has no impact. Skip it."
    down = Vector3(0.0, -2.0, 0.0)
    particles = [
        Particle(Vector3(0.0, 1.0), down, mass=math.inf),
        Particle(Vector3(0.0, 2.0), down),
    ]
    impact = expect_impact(GroundPlane(particles).next_impact(9.0))
    expect_close(impact[0], 1.0)
    about.call = "two particles at height 2 with velocity (0, -2, 0); "
    about.call += "GroundPlane(particles).next_impact(1)"
    about.cause = (
        "If two impacts are at the same time, the particle that is first in the list counts."
    )
    particles = [Particle(Vector3(i, 2.0, 0.0), down) for i in range(2)]
    impact = expect_impact(GroundPlane(particles).next_impact(1.0))
    ((first, *_),) = told([impact[1]], particles)
    expect_exactly(first, 0, then=": index of the particle")
    expect_close(impact[0], 1.0, then=": time")
    about.call = "p at height -1 with velocity (0, -2, 0); GroundPlane([p]).next_impact(0): time, "
    about.call += "penetration"
    about.cause = (
        "The particle is in the ground and closing. The impact is at time 0, with penetration 0."
    )
    impact = expect_impact(GroundPlane([Particle(Vector3(0.0, -1.0, 0.0), down)]).next_impact(0.0))
    seen = (impact[0], impact[1].penetration)
    expect_close(seen, (0.0, 0.0))
    about.call = "p immovable; GroundPlane([p]).next_impact(9) is None"
    about.cause = "If nothing can move, return None instead of raising an error."
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
    about.cause = "Refuse a duration that is negative or not finite. Call not_negative from "
    about.cause += "arguments.py."
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
    # Relative to b, a moves on a line; at time t it is two radii away in the direction n.
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
        about.cause = "Solve |d + u t| = 2 radius with d = pa - pb and u = va - vb, and take the "
        about.cause += "first solution."
        pair = [
            Particle(Vector3(*p), Vector3(*v), Vector3(*down)),
            Particle(Vector3(*q), Vector3(*w), Vector3(*down), mass=3.0),
        ]
        impact = expect_impact(ParticlePairs(pair, radius, c).next_impact(10.0))
        if p == far:
            mistakes = [
                (5.2, "The result is the second solution, when the spheres separate. Return the "
                    "first."),
                (3.6 - math.sqrt(4.29) / 3.0,
                 "The result uses one radius. The spheres touch when their centers are two "
                 "radii apart."),
                (3.6, "The result is the time when the centers are closest. The spheres touch "
                    "earlier, when the centers are two radii apart."),
                (3.0, "The velocity of b is missing. Use the relative velocity va - vb."),
                (6.0, "The velocities were added. Use the relative velocity va - vb."),
            ]  # fmt: skip
            blame(impact[0], mistakes)
        # Positions of up to 90 m, rounded, at closing speeds of about 1 m/s; grazing loses more.
        expect_close(impact[0], t, then=": time", tolerance=1e-9)
        ((first, second, normal, restitution, depth),) = told([impact[1]], pair)
        about.cause = "The normal points from b to a, at their positions at the time of impact."
        turned = tuple(-part for part in n)
        mistakes = [(turned, "The normal has the wrong sign. It points from b to a.")]
        blame(normal, mistakes, tolerance=1e-8)
        expect_close(normal, n, then=": normal", tolerance=1e-8)
        about.cause = "The contact has both particles, the detector's restitution and a "
        about.cause += "penetration of 0."
        name = f"{about.call}: index of particle and other, restitution, penetration"
        seen = (first, second, restitution, depth)
        expect_close(seen, (0, 1, c, 0.0), call=name)
        about.cause = "Looking ahead must not move anything."
        one, other = pair
        now = (*xyz(one.position), *xyz(one.velocity), *xyz(other.position), *xyz(other.velocity))
        expect_unchanged("a and b", now, (*p, *v, *q, *w))


@pytest.mark.exercise("B7.11")
def test_spheres_that_touch_or_never_meet() -> None:
    about.read = PAIRS
    meet = "The centers are 5 m apart. The spheres touch when this distance is 2 m."
    for x, y, speed, wanted, cause in (
        (2.0, 0.0, -3.0, 0.0, "The spheres touch and approach each other, so the time is 0."),
        (1.5, 0.0, -3.0, 0.0, "The spheres overlap and approach each other, so the time is 0."),
        (1.5, 0.0, 3.0, None, "The spheres overlap, but they move apart. Return None."),
        (5.0, 0.0, 3.0, None, "The spheres move apart. Return None."),
        (5.0, 0.0, 0.0, None, "The spheres do not move relative to each other. Return None."),
        (5.0, 2.5, -3.0, None, "The spheres miss, because the number under the root is negative."),
        (5.0, 2.000001, -3.0, None, "The spheres only just miss each other. Return None."),
        (5.0, 0.0, -3.0, 1.0, meet),
        (-5.0, 0.0, 3.0, 1.0, meet),
        (5.0, 0.0, -0.125, None, "They meet after 24 s, later than the duration. Return None."),
        (2.0, 0.0, -1e-9, 0.0, "The spheres touch and slowly approach, so the time is 0."),
        (32.0, 0.0, -3.0, 10.0, "The spheres meet exactly at the end of the duration."),
        (2.0, 0.0, -1e-13, None, "A closing speed below VELOCITY_TOLERANCE is rounding error."),
        (0.0, 0.0, 3.0, None, "The positions are equal, so the spheres are not closing."),
    ):
        about(f"a at ({x}, {y}, 0), velocity ({speed}, 0, 0); b at (0, 0, 0); ", cause=cause)
        about.call += "ParticlePairs([a, b], 1.0).next_impact(10.0)"
        pair = [Particle(Vector3(x, y, 0.0), Vector3(speed)), Particle()]
        impact = ParticlePairs(pair, 1.0).next_impact(10.0)
        expect_exactly(impact is None, wanted is None, then=" is None")
        if wanted is not None:
            expect_close(impact[0], wanted, then=": time")
            about.cause = "The contact describes the moment of the impact. Its penetration is 0."
            got = impact[1].penetration
            expect_close(got, 0.0, then=": penetration")
    about.call = "ParticlePairs([a], 1.0).next_impact(10.0) is None"
    about.cause = "A single particle has no pair. Return None instead of raising an error."
    impact = ParticlePairs([Particle()], 1.0).next_impact(10.0)
    expect_exactly(impact is None, True)
    about.call = "a at (5, 0, 0), velocity (-3, 0, 0), b at (0, 0, 0); p = ParticlePairs([a, b], "
    about.call += "1.0); p.next_impact(1.0); p.radius, p.restitution = 1.75, 0.5; "
    about.call += "p.next_impact(1.0)"
    about.cause = "Read radius and restitution again on every call."
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
    about.call = f"six spheres of radius 1 at x = {places} with velocities {speeds} along x; p = "
    about.call += "ParticlePairs(particles, 1.0); p.next_impact(9.0)"
    about.cause = "Compare all pairs and return the earliest impact. Here it is a pair 0.5 m apart "
    about.cause += "in which both spheres move."
    particles = [Particle(Vector3(x), Vector3(v)) for x, v in zip(places, speeds, strict=True)]
    pairs = ParticlePairs(particles, 1.0)
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, normal, _, _),) = told([impact[1]], particles)
    expect_close((a, b), (1, 4), then=": index of particle and other")
    expect_close(impact[0], 0.25 / speed, then=": time")
    about.cause = "The normal points from the second particle of the pair to the first."
    expect_close(normal, (-1.0, 0.0, 0.0), then=": normal")
    about.call += ", with particles 1 and 4 immovable"
    about.cause = "Immovable particles stay where they are, so 1 and 4 do not meet."
    particles[1].mass = particles[4].mass = math.inf
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_close((a, b), (3, 5), then=": index of particle and other")
    expect_close(impact[0], 0.5 / speed, then=": time")
    about.call = f"spheres of radius 1 at x = 0, 3 and 6 with {speed}, 0 and -{speed} m/s along x; "
    about.call += "next_impact(9.0)"
    about.cause = (
        "If two impacts are at the same time, the pair that is first in list order counts."
    )
    particles = [Particle(Vector3(3.0 * i), Vector3(speed * (1 - i))) for i in range(3)]
    impact = expect_impact(ParticlePairs(particles, 1.0).next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_close((a, b), (0, 1), then=": index of particle and other")


@pytest.mark.exercise("B7.11")
def test_pairs_fall_alike(rng: Random) -> None:
    about.read = PAIRS
    for ma, mb in ((1.1, 1.3), (3.3, 4.9), (positive_number(rng), positive_number(rng))):
        about.call = f"a of {ma} kg at (5, 0, 0), velocity (-3, 0, 0); b of {mb} kg at (0, 0, 0); "
        about.call += "on both a force of 9.81 m down; integrate(1e-9); ParticlePairs([a, "
        about.call += "b], 1.0).next_impact(10): time"
        about.cause = "Both particles fall with 9.81 m/s^2. Dividing force by mass leaves rounding "
        about.cause += "errors, so accept accelerations that differ by 1e-12 of their size."
        pair = [Particle(Vector3(5.0), Vector3(-3.0), mass=ma), Particle(mass=mb)]
        for particle, mass in zip(pair, (ma, mb), strict=True):
            particle.add_force(Vector3(0.0, -9.81 * mass, 0.0))
            particle.integrate(1e-9)
        impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
        # The step has already covered 3e-9 m.
        expect_close(impact[0], 1.0, tolerance=2e-9)
    about.call = "a, immovable, at (5, 0, 0) with velocity and acceleration (9, 9, 9); b at (0, 0, "
    about.call += "0), velocity (3, 0, 0); ParticlePairs([a, b], 1.0).next_impact(10): time"
    about.cause = "An immovable particle stays where it is. Use zero for its velocity and "
    about.cause += "acceleration."
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
    about.cause = "With different accelerations the relative path is curved, and the time would be "
    about.cause += "wrong. Raise ValueError, even if the two are moving apart."
    for velocity, one, other, force, mass in (
        (-1.0, (0.0, -9.0, 0.0), (0.0, 0.0, 0.0), 0.0, 1.0),
        (1.0, (0.0, -9.0, 0.0), (0.0, 0.0, 0.0), 0.0, 1.0),
        (-1.0, (0.0, 0.0, -9.0), (0.0, -9.0, 0.0), 0.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.000001, 0.0), 0.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.0, 0.0), 1.0, 1.0),
        (-1.0, (0.0, -9.0, 0.0), (0.0, -9.0, 0.0), 0.0, math.inf),
    ):
        about.call = f"a at (5, 0, 0), velocity ({velocity}, 0, 0), acceleration {one}; b of "
        about.call += f"{mass} kg at (0, 0, 0), acceleration {other}, after a step with a force of "
        about.call += f"{force} N along x; ParticlePairs([a, b], 1.0).next_impact(1.0)"
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
