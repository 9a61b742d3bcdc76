"""The next impact on the ground, B7.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.probes import told
from draw import number, positive_number
from expect import (
    about,
    cause_of,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    xyz,
)
from impacts import expect_impact, expect_none, expect_particles

ZERO, UP = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
GROUND = "the docstring of GroundPlane.next_impact"
PAIRS = "the docstring of ParticlePairs.next_impact"
TIME = "; the time of the impact"


@pytest.mark.exercise("B7.10", asks="the first impact of a particle on the ground")
def test_the_first_impact_on_the_ground(rng: Random) -> None:
    about.read = GROUND
    height, radius, c = number(rng), 0.25, round(rng.uniform(0.1, 0.9), 3)
    speeds = [positive_number(rng, 1.0, 2.0) for _ in range(4)]
    falls = [3.0, 2.0, 1.0, 2.5]
    places = [(number(rng), height + radius + fall, number(rng)) for fall in falls]
    about.call = "the lowest points of four spheres are 3, 2, 1 and 2.5 m above the ground; the "
    about.call += "spheres move down at {}, {}, {} and {} m/s; ".format(*speeds)
    about.call += f"ground = GroundPlane(spheres, height={height}, radius={radius}, "
    about.call += f"restitution={c}); ground.next_impact(9.0)"
    particles = [
        Particle(Vector3(*place), Vector3(5.0, -speed, 5.0))
        for place, speed in zip(places, speeds, strict=True)
    ]
    ground = GroundPlane(particles, height, radius, c)
    times = [fall / speed for fall, speed in zip(falls, speeds, strict=True)]
    first = min(times)
    about.cause = "All four spheres reach the ground within 9 s. Compute the time for every "
    about.cause += "sphere, and return the earliest impact."
    impact = expect_impact(ground.next_impact(9.0))
    time, contact = impact[0], impact[1]
    whole = min((fall + radius) / speed for fall, speed in zip(falls, speeds, strict=True))
    mistakes = [
        (max(times), "You returned the last impact of the four spheres. Return the earliest impact "
                     "instead."),
        (times[0], "You returned the impact of the first sphere in the list. Compute the times for "
                   "all spheres, and return the earliest impact."),
        (min(fall / math.hypot(5, v, 5) for fall, v in zip(falls, speeds, strict=True)),
         "You used the whole speed. Only the velocity along Y closes the gap."),
        (whole, "You left out the radius, so you returned the time when the center reaches the "
                "ground. Use the lowest point of the sphere, which is at y - radius."),
    ]  # fmt: skip
    seen = cause_of(time, mistakes, about.cause)
    name = f"{about.call}; the time of the impact"
    expect_close(time, first, call=name, cause=seen, tolerance=1e-13, unit="s")
    ((a, b, normal, restitution, depth),) = told([contact], particles)
    seen = (a, b, *normal, restitution, depth)
    wanted = (times.index(first), -1, *UP, c, 0.0)
    about.cause = "The time is right, but the contact isn't. Create it with the particle, None as "
    about.cause += "its other, the normal (0, 1, 0) and the detector's restitution."
    for part, cause in (
        (0, "The contact belongs to the wrong sphere. Use the sphere that reaches the ground "
            "first."),
        (1, "The ground is not a particle, so pass None as the contact's other."),
        (3, "The normal of the contact is wrong. Use (0, 1, 0), which points out of the ground."),
        (5, "The contact has the wrong restitution. Pass the restitution of the detector when you "
        "create the contact."),
        (6, "You used the current penetration. The contact describes the moment of the impact, "
            "when the sphere just touches the ground, so use 0."),
    ):  # fmt: skip
        if seen[part] != wanted[part]:
            about.cause = cause
            break
    names = [f"sphere {i}" for i in range(4)]
    expect_particles(seen[:2], wanted[:2], names)
    limit = 1e-13 * max(map(abs, wanted))
    expect_close(seen[2:5], UP, then="; the normal of the contact", tolerance=limit)
    name = "; the restitution of the contact"
    expect_close(restitution, c, then=name, tolerance=limit)
    name = "; the penetration of the contact"
    expect_close(depth, 0.0, then=name, tolerance=limit, unit="m")
    about.cause = "The first impact happens only after the end of the duration, so it doesn't "
    about.cause += "count. Return None."
    expect_none(ground.next_impact(0.999 * first), then=f"; ground.next_impact({0.999 * first})")
    about.cause = "You left out an impact exactly at the end of the duration, which still counts. "
    about.cause += "Compare the time of the impact with the duration, using <= instead of <."
    got = ground.next_impact(float(time))
    name = f"; ground.next_impact({time!r})"
    missed = "None, as if there were no impact"
    expect_that(got is not None, missed, f"an impact after {first:.6g} s", then=name)
    about.call += "; ground.height -= 1; ground.radius = 0; ground.restitution = 0.5; "
    about.call += f"ground.next_impact({first!r} + 9)"
    about.cause = "The attributes of the detector have changed, so all spheres now fall 1.25 m "
    about.cause += "farther. Read height, radius and restitution again on every call."
    ground.height -= 1.0
    ground.radius, ground.restitution = 0.0, 0.5
    impact = ground.next_impact(first + 9.0)
    later = min((fall + 1.25) / speed for fall, speed in zip(falls, speeds, strict=True))
    seen = (impact[0], impact[1].restitution)
    name = "; the time in s and the restitution of the impact"
    expect_close(seen, (later, 0.5), then=name)
    about.cause = "next_impact has changed a sphere. It should only predict the impact, without "
    about.cause += "changing any position or velocity."
    for i, particle in enumerate(particles):
        now = (*xyz(particle.position), *xyz(particle.velocity))
        before = (*places[i], 5.0, -speeds[i], 5.0)
        expect_unchanged(f"the position and velocity of sphere {i}", now, before)


@pytest.mark.exercise("B7.10", asks="where a is its last_acceleration")
def test_forces_count_and_immovable_particles_do_not(rng: Random) -> None:
    about.read = GROUND
    t = positive_number(rng)
    about.call = f"particle p of 2 kg at rest at (0, {2.5 * t * t}, 0) with an acceleration of (0, "
    about.call += "2, 0); p.add_force(Vector3(0, -14, 0)); p.integrate(1e-9); "
    about.call += "GroundPlane([p]).next_impact(100)"
    about.cause = "You used only p's constant acceleration, which lifts p, and left out the "
    about.cause += "force. Use last_acceleration, which includes forces."
    p = Particle(Vector3(0.0, 2.5 * t * t, 0.0), None, Vector3(0.0, 2.0, 0.0), mass=2.0)
    p.add_force(Vector3(0.0, -14.0, 0.0))
    p.integrate(1e-9)
    impact = expect_impact(GroundPlane([p]).next_impact(100.0))
    # Its speed of 5e-9 m/s after the step brings the impact forward by 1e-9 s.
    expect_close(impact[0], t, tolerance=1e-8, then=TIME, unit="s")
    about.call = "an immovable particle at a height of 1 m and a particle of 1 kg at 2 m, both "
    about.call += "with velocity (0, -2, 0); GroundPlane(particles).next_impact(9)"
    about.cause = "The first particle is immovable and never reaches the ground. Skip immovable "
    about.cause += "particles, and return the impact of the second one."
    down = Vector3(0.0, -2.0, 0.0)
    particles = [
        Particle(Vector3(0.0, 1.0), down, mass=math.inf),
        Particle(Vector3(0.0, 2.0), down),
    ]
    impact = expect_impact(GroundPlane(particles).next_impact(9.0))
    expect_close(impact[0], 1.0, then=TIME, unit="s")
    about.call = "two particles at a height of 2 m with velocity (0, -2, 0); "
    about.call += "GroundPlane(particles).next_impact(1)"
    about.cause = "You returned the impact of the second particle, but both reach the ground at "
    about.cause += "the same time. Return the impact of the first one in the list."
    particles = [Particle(Vector3(i, 2.0, 0.0), down) for i in range(2)]
    impact = expect_impact(GroundPlane(particles).next_impact(1.0))
    ((first, *_),) = told([impact[1]], particles)
    expect_exactly(first, 0, then="; the index of the particle in the contact")
    expect_close(impact[0], 1.0, then=TIME, unit="s")
    about.call = "particle p, 1 m below the ground, with velocity (0, -2, 0); "
    about.call += "GroundPlane([p]).next_impact(0)"
    about.cause = "The particle is inside the ground and moves farther in, so the impact is now. "
    about.cause += "Return a time of 0 and a contact with a penetration of 0."
    impact = expect_impact(GroundPlane([Particle(Vector3(0.0, -1.0, 0.0), down)]).next_impact(0.0))
    seen = (impact[0], impact[1].penetration)
    name = "; the time in s and the penetration in m of the impact"
    expect_close(seen, (0.0, 0.0), then=name)
    about.call = "an immovable particle p; GroundPlane([p]).next_impact(9)"
    about.cause = "No particle can move, so there is no impact. Return None instead of raising an "
    about.cause += "error."
    expect_none(GroundPlane([Particle(mass=math.inf)]).next_impact(9.0))
