"""The next impact of two spheres, build task B7.11."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import ParticlePairs
from ch07_constraints.probes import told
from draw import components, direction, positive_number
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_unchanged,
    xyz,
)
from impacts import expect_impact

ZERO, UP = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
PAIRS = "the docstring of ParticlePairs.next_impact"


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
        about.cause = "The spheres touch when their centers are two radii apart. Solve |d + u t| = "
        about.cause += "2 radius, where d = pa - pb and u = va - vb, and take the first solution."
        pair = [
            Particle(Vector3(*p), Vector3(*v), Vector3(*down)),
            Particle(Vector3(*q), Vector3(*w), Vector3(*down), mass=3.0),
        ]
        impact = expect_impact(ParticlePairs(pair, radius, c).next_impact(10.0))
        if p == far:
            mistakes = [
                (5.2, "This is the second solution of the equation, when the spheres have passed "
                      "through each other. Return the first one, when they begin to touch."),
                (3.6 - math.sqrt(4.29) / 3.0,
                 "You used only one radius, but each sphere has one. The spheres touch when their "
                 "centers are two radii apart."),
                (3.6, "This is when the centers are closest to each other. The spheres touch "
                      "earlier, when their centers are two radii apart."),
                (3.0, "You used only a's velocity, but b is moving too. Use the relative velocity "
                      "va - vb."),
                (6.0, "You added the two velocities. The distance changes with their difference, "
                      "so use the relative velocity va - vb."),
            ]  # fmt: skip
            blame(impact[0], mistakes)
        # Positions of up to 90 m, rounded, at closing speeds of about 1 m/s; grazing loses more.
        expect_close(impact[0], t, then=": time", tolerance=1e-9)
        ((first, second, normal, restitution, depth),) = told([impact[1]], pair)
        about.cause = "The normal is wrong. It should be the unit vector from b to a at the time "
        about.cause += "of the impact, so compute it from where they will be by then."
        turned = tuple(-part for part in n)
        mistakes = [
            (
                turned,
                "The normal has the wrong sign. It should point from b, the second particle, to a, "
                "the first.",
            )
        ]
        blame(normal, mistakes, tolerance=1e-8)
        expect_close(normal, n, then=": normal", tolerance=1e-8)
        about.cause = "Create the contact with a as its particle, b as its other, the detector's "
        about.cause += "restitution and a penetration of 0."
        name = f"{about.call}: index of particle and other, restitution, penetration"
        seen = (first, second, restitution, depth)
        expect_close(seen, (0, 1, c, 0.0), call=name)
        about.cause = "next_impact has changed a particle. It should only predict the impact, "
        about.cause += "without changing any position or velocity."
        one, other = pair
        now = (*xyz(one.position), *xyz(one.velocity), *xyz(other.position), *xyz(other.velocity))
        expect_unchanged("a and b", now, (*p, *v, *q, *w))


@pytest.mark.exercise("B7.11")
def test_spheres_that_touch_or_never_meet() -> None:
    about.read = PAIRS
    meet = "The centers are 5 m apart, and the spheres touch when that distance is down to 2 m. "
    meet += "At 3 m/s that takes 1 s, so return 1."
    for x, y, speed, wanted, cause in (
        (2.0, 0.0, -3.0, 0.0, (
            "The spheres are touching and approaching each other, so the time is 0."
        )),
        (1.5, 0.0, -3.0, 0.0, (
            "The spheres overlap and are approaching each other, so the time is 0."
        )),
        (1.5, 0.0, 3.0, None, "The spheres overlap but are already moving apart, so there is no "
                              "impact. Return None."),
        (5.0, 0.0, 3.0, None, "The spheres are moving apart, so they never meet. Return None."),
        (5.0, 0.0, 0.0, None, "The spheres aren't moving relative to each other, so they never "
                              "meet. Return None before you divide by the relative speed."),
        (5.0, 2.5, -3.0, None, "The spheres miss each other. The number under the root is then "
                               "negative, so return None instead of taking the root."),
        (5.0, 2.000001, -3.0, None, "The spheres only just miss each other, so there is no impact. "
        "Return None."),
        (5.0, 0.0, -3.0, 1.0, meet),
        (-5.0, 0.0, 3.0, 1.0, meet),
        (5.0, 0.0, -0.125, None, "The spheres meet after 24 s, which is later than the end of the "
                                 "duration. Return None."),
        (2.0, 0.0, -1e-9, 0.0, "The spheres are touching and approaching each other, however "
                               "slowly, so the time is 0."),
        (32.0, 0.0, -3.0, 10.0, "The spheres meet exactly at the end of the duration. That impact "
                                "still counts, so return it."),
        (2.0, 0.0, -1e-13, None, "Treat a closing speed below VELOCITY_TOLERANCE as a rounding "
                                 "error: there is no impact. Return None."),
        (0.0, 0.0, 3.0, None, "Both centers are at the same position, so the distance can only "
                              "grow and there is no impact. Return None."),
    ):  # fmt: skip
        about(f"a at ({x}, {y}, 0), velocity ({speed}, 0, 0); b at (0, 0, 0); ", cause=cause)
        about.call += "ParticlePairs([a, b], 1.0).next_impact(10.0)"
        pair = [Particle(Vector3(x, y, 0.0), Vector3(speed)), Particle()]
        impact = ParticlePairs(pair, 1.0).next_impact(10.0)
        expect_exactly(impact is None, wanted is None, then=" is None")
        if wanted is not None:
            expect_close(impact[0], wanted, then=": time")
            about.cause = "The contact describes the moment of the impact, when the surfaces just "
            about.cause += "touch, so its penetration should be 0."
            got = impact[1].penetration
            expect_close(got, 0.0, then=": penetration")
    about.call = "ParticlePairs([a], 1.0).next_impact(10.0) is None"
    about.cause = "There is only one particle, so there are no pairs. Return None instead of "
    about.cause += "raising an error."
    impact = ParticlePairs([Particle()], 1.0).next_impact(10.0)
    expect_exactly(impact is None, True)
    about.call = "a at (5, 0, 0), velocity (-3, 0, 0), b at (0, 0, 0); p = ParticlePairs([a, b], "
    about.call += "1.0); p.next_impact(1.0); p.radius, p.restitution = 1.75, 0.5; "
    about.call += "p.next_impact(1.0)"
    about.cause = "The check has changed the radius and the restitution since the first call. "
    about.cause += "Read both again on every call."
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
    about.cause = "This is not the earliest impact, which is between two moving spheres that are "
    about.cause += "0.5 m apart. Compute the time of impact for every pair of particles, and "
    about.cause += "return the smallest."
    particles = [Particle(Vector3(x), Vector3(v)) for x, v in zip(places, speeds, strict=True)]
    pairs = ParticlePairs(particles, 1.0)
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, normal, _, _),) = told([impact[1]], particles)
    expect_close((a, b), (1, 4), then=": index of particle and other")
    expect_close(impact[0], 0.25 / speed, then=": time")
    about.cause = "The normal is wrong. It should be the unit vector from the second particle of "
    about.cause += "the pair to the first."
    expect_close(normal, (-1.0, 0.0, 0.0), then=": normal")
    about.call += ", with particles 1 and 4 immovable"
    about.cause = "Particles 1 and 4 are immovable now, so they stay where they are and never "
    about.cause += "meet. Treat the velocity of an immovable particle as zero."
    particles[1].mass = particles[4].mass = math.inf
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_close((a, b), (3, 5), then=": index of particle and other")
    expect_close(impact[0], 0.5 / speed, then=": time")
    about.call = f"spheres of radius 1 at x = 0, 3 and 6 with {speed}, 0 and -{speed} m/s along x; "
    about.call += "next_impact(9.0)"
    about.cause = "Both impacts happen at the same time. Return the one whose pair comes first in "
    about.cause += "list order."
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
        about.cause = "Both particles fall at 9.81 m/s^2, except for rounding errors from "
        about.cause += "dividing the forces by the masses. Treat accelerations as equal if they "
        about.cause += "differ by at most 1e-12 of their size."
        pair = [Particle(Vector3(5.0), Vector3(-3.0), mass=ma), Particle(mass=mb)]
        for particle, mass in zip(pair, (ma, mb), strict=True):
            particle.add_force(Vector3(0.0, -9.81 * mass, 0.0))
            particle.integrate(1e-9)
        impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
        # The step has already covered 3e-9 m.
        expect_close(impact[0], 1.0, tolerance=2e-9)
    about.call = "a, immovable, at (5, 0, 0) with velocity and acceleration (9, 9, 9); b at (0, 0, "
    about.call += "0), velocity (3, 0, 0); ParticlePairs([a, b], 1.0).next_impact(10): time"
    about.cause = "An immovable particle stays where it is, whatever its attributes say. Use zero "
    about.cause += "for its velocity and its acceleration."
    nines = Vector3(9.0, 9.0, 9.0)
    pair = [Particle(Vector3(5.0), nines, nines, mass=math.inf), Particle(None, Vector3(3.0))]
    impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
    expect_close(impact[0], 1.0)
    ((_, _, normal, _, _),) = told([impact[1]], pair)
    expect_close(normal, (1.0, 0.0, 0.0), call=f"{about.call[:-4]}normal")
