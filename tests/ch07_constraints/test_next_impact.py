"""The next impact on the ground, and the durations of both detectors, B7.10 and B7.11."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import told
from draw import number, positive_number
from expect import (
    about,
    cause_of,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    scoped,
    xyz,
)
from impacts import expect_impact

ZERO, UP = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
GROUND = "the docstring of GroundPlane.next_impact"
PAIRS = "the docstring of ParticlePairs.next_impact"


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
    about.cause = "Each of the four spheres hits the ground within the duration. Compute the times "
    about.cause += "of all four impacts, and return the earliest."
    impact = expect_impact(ground.next_impact(9.0))
    time, contact = impact[0], impact[1]
    whole = min((fall + radius) / speed for fall, speed in zip(falls, speeds, strict=True))
    mistakes = [
        (max(times), "This is the time of the last impact. Return the time of the earliest one "
                     "instead."),
        (times[0], "This is the impact of the first particle in the list. Compute the times for "
                   "all particles and return the earliest one."),
        (whole, "You left out the radius, so this is when the center arrives. The lowest point of "
                "the sphere, at y - radius, arrives earlier."),
    ]  # fmt: skip
    seen = cause_of(time, mistakes, about.cause)
    name = f"{about.call}: time"
    expect_close(time, first, call=name, cause=seen, tolerance=1e-13)
    ((a, b, normal, restitution, depth),) = told([contact], particles)
    seen = (a, b, *normal, restitution, depth)
    wanted = (times.index(first), -1, *UP, c, 0.0)
    about.cause = "The time is right, but the contact isn't. Create it with the particle, None as "
    about.cause += "its other, the normal (0, 1, 0), the detector's restitution and a penetration "
    about.cause += "of 0."
    for part, cause in (
        (0, "The contact belongs to the wrong particle. It should be the one that reaches the "
            "ground first."),
        (1, "The ground is not a particle, so pass None as the contact's other."),
        (3, "The normal points from the ground to the particle, so it should be (0, 1, 0)."),
        (5, "The contact has the wrong restitution. Pass the restitution of the detector when you "
        "create the contact."),
        (6, "The contact describes the moment of the impact, when the surfaces just touch, so its "
            "penetration should be 0."),
    ):  # fmt: skip
        if seen[part] != wanted[part]:
            about.cause = cause
            break
    name = f"{about.call}: index of particle and other (-1 is None), normal, restitution, depth"
    expect_close(seen, wanted, call=name)
    about.cause = "The first impact happens only after the end of the duration, so there is none "
    about.cause += "to report. Return None."
    name = f"{about.call}; g.next_impact({0.999 * first}) is None"
    got = ground.next_impact(0.999 * first)
    expect_exactly(got is None, True, call=name)
    about.cause = "The first impact is exactly at the end of the duration. It still counts, so "
    about.cause += "compare with <= instead of <."
    got = ground.next_impact(float(time))
    name = f"{about.call}; g.next_impact({time!r}) is None"
    expect_exactly(got is None, False, call=name)
    about.call += f"; g.height -= 1, g.radius = 0, g.restitution = 0.5; g.next_impact({first!r} + "
    about.call += "9)"
    about.cause = "The check has changed the detector's attributes, so all spheres now fall 1.25 "
    about.cause += "m farther. Read height, radius and restitution again on every call."
    ground.height -= 1.0
    ground.radius, ground.restitution = 0.0, 0.5
    impact = ground.next_impact(first + 9.0)
    later = min((fall + 1.25) / speed for fall, speed in zip(falls, speeds, strict=True))
    seen = (impact[0], impact[1].restitution)
    expect_close(seen, (later, 0.5), then=": time, restitution")
    about.cause = "next_impact has changed a particle. It should only predict the impact, without "
    about.cause += "changing any position or velocity."
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
    about.cause = "Forces accelerate the particle as well, so use last_acceleration, which "
    about.cause += "includes them and is -5 m/s^2 here. Under the constant acceleration alone, the "
    about.cause += "particle would rise and never reach the ground."
    p = Particle(Vector3(0.0, 2.5 * t * t, 0.0), None, Vector3(0.0, 2.0, 0.0), mass=2.0)
    p.add_force(Vector3(0.0, -14.0, 0.0))
    p.integrate(1e-9)
    impact = expect_impact(GroundPlane([p]).next_impact(100.0))
    # Its speed of 5e-9 m/s after the step brings the impact forward by 1e-9 s.
    expect_close(impact[0], t, tolerance=1e-8)
    about.call = "an immovable particle at height 1 and one of 1 kg at height 2, both with "
    about.call += "velocity (0, -2, 0); GroundPlane(particles).next_impact(9): time"
    about.cause = "The first particle is immovable, so it stays where it is, whatever its velocity "
    about.cause += "says. Skip immovable particles."
    down = Vector3(0.0, -2.0, 0.0)
    particles = [
        Particle(Vector3(0.0, 1.0), down, mass=math.inf),
        Particle(Vector3(0.0, 2.0), down),
    ]
    impact = expect_impact(GroundPlane(particles).next_impact(9.0))
    expect_close(impact[0], 1.0)
    about.call = "two particles at height 2 with velocity (0, -2, 0); "
    about.call += "GroundPlane(particles).next_impact(1)"
    about.cause = "Both impacts happen at the same time. Return the one whose particle comes "
    about.cause += "first in the list."
    particles = [Particle(Vector3(i, 2.0, 0.0), down) for i in range(2)]
    impact = expect_impact(GroundPlane(particles).next_impact(1.0))
    ((first, *_),) = told([impact[1]], particles)
    expect_exactly(first, 0, then=": index of the particle")
    expect_close(impact[0], 1.0, then=": time")
    about.call = "p at height -1 with velocity (0, -2, 0); GroundPlane([p]).next_impact(0): time, "
    about.call += "penetration"
    about.cause = "The particle is inside the ground and moving farther in, so the impact is now. "
    about.cause += "Return a time of 0 and a contact with a penetration of 0."
    impact = expect_impact(GroundPlane([Particle(Vector3(0.0, -1.0, 0.0), down)]).next_impact(0.0))
    seen = (impact[0], impact[1].penetration)
    expect_close(seen, (0.0, 0.0))
    about.call = "p immovable; GroundPlane([p]).next_impact(9) is None"
    about.cause = "No particle can move, so there is no impact. Return None instead of raising an "
    about.cause += "error."
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
    about.cause = "Reject a duration that is negative, not finite or not a number. Call "
    about.cause += "not_negative from arguments.py."
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
@pytest.mark.robust
def test_pairs_look_ahead_for_a_duration() -> None:
    about.read = PAIRS
    pair = [Particle(Vector3(5.0), Vector3(-1.0)), Particle()]
    expect_durations("ParticlePairs([a, b], 1.0)", ParticlePairs(pair, 1.0))
    about.cause = "With different accelerations the relative path is curved, so the equation for "
    about.cause += "a straight line gives the wrong time. Raise ValueError, even if the two "
    about.cause += "particles are moving apart."
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
