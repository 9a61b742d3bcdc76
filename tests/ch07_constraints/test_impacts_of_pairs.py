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
    expect_that,
    expect_unchanged,
    xyz,
)
from impacts import expect_impact, expect_none, expect_particles

ZERO, UP = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
PAIRS = "the docstring of ParticlePairs.next_impact"
TIME, NORMAL = "; the time of the impact", "; the normal of the contact"


@pytest.mark.exercise("B7.11", asks="Two spheres have an impact when they touch")
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
        about.call = f"particle a at {p} with velocity {v}; particle b at {q} with velocity {w}; "
        about.call += f"both with acceleration {down}; ParticlePairs([a, b], radius={radius}, "
        about.call += f"restitution={c}).next_impact(10)"
        about.cause = "The particles touch when their centers are two radii apart. Solve |d + u t| "
        about.cause += "= 2 radius for t, where d = pa - pb and u = va - vb, and take the smaller "
        about.cause += "solution."
        pair = [
            Particle(Vector3(*p), Vector3(*v), Vector3(*down)),
            Particle(Vector3(*q), Vector3(*w), Vector3(*down), mass=3.0),
        ]
        impact = expect_impact(ParticlePairs(pair, radius, c).next_impact(10.0))
        if p == far:
            mistakes = [
                (5.2, "You returned the later of the two solutions, at which the particles have "
                      "already passed through each other. Return the earlier solution, at which "
                      "they begin to touch."),
                (3.6 - math.sqrt(4.29) / 3.0,
                 "You used only one radius. The particles touch when their centers are two radii "
                 "apart, because each particle has this radius."),
                (3.6 - math.sqrt(10.54) / 3.0,
                 "You used 2 r^2 as the square of two radii. It is (2 r)^2 = 4 r^2."),
                (3.6, "You returned the time when the centers are closest to each other. The "
                      "particles touch earlier, when their centers are two radii apart."),
                (3.0, "You used only the velocity of a, but b is moving too. Use the relative "
                      "velocity va - vb."),
                (6.0, "You added the two velocities. How fast the distance changes depends on "
                      "their difference, so use va - vb."),
            ]  # fmt: skip
            blame(impact[0], mistakes)
        # Positions of up to 90 m, rounded, at closing speeds of about 1 m/s; grazing loses more.
        expect_close(impact[0], t, then=TIME, tolerance=1e-9, unit="s")
        ((first, second, normal, restitution, depth),) = told([impact[1]], pair)
        about.cause = "The normal is wrong. Use the unit vector from b to a at the time of the "
        about.cause += "impact."
        turned = tuple(-part for part in n)
        size = math.dist(p, q)
        mistakes = [
            (turned, "The normal points the wrong way. It should point from b, the second "
                     "particle, to a."),
            (tuple((x - y) / size for x, y in zip(p, q, strict=True)),
             "You computed the normal from the current positions. Use the positions that a and b "
             "will have at the time of the impact."),
        ]  # fmt: skip
        blame(normal, mistakes, tolerance=1e-8)
        expect_close(normal, n, then=NORMAL, tolerance=1e-8)
        about.cause = "The contact is wrong. Create it with a as its particle, b as its other, "
        about.cause += "the detector's restitution and a penetration of 0."
        expect_particles((first, second), (0, 1))
        name = "; the restitution of the contact"
        expect_close(restitution, c, then=name, tolerance=1e-13)
        name = "; the penetration of the contact"
        expect_close(depth, 0.0, then=name, tolerance=1e-13, unit="m")
        about.cause = "next_impact has changed a particle. It should only predict the impact, "
        about.cause += "without changing any position or velocity."
        one, other = pair
        expect_unchanged("a.position", xyz(one.position), p)
        expect_unchanged("a.velocity", xyz(one.velocity), v)
        expect_unchanged("b.position", xyz(other.position), q)
        expect_unchanged("b.velocity", xyz(other.velocity), w)


@pytest.mark.exercise("B7.11", asks="Ignore a slower approach")
def test_spheres_that_touch_or_never_meet() -> None:
    about.read = PAIRS
    meet = "The centers are 5 m apart, and the particles touch when their distance is 2 m. At 3 "
    meet += "m/s the impact is after 1 s, so return this time."
    for x, y, speed, wanted, cause in (
        (2.0, 0.0, -3.0, 0.0, (
            "The particles are touching and approaching each other, so the time is 0."
        )),
        (1.5, 0.0, -3.0, 0.0, (
            "The particles overlap and are approaching each other, so the time is 0."
        )),
        (1.5, 0.0, 3.0, None,
         "You returned an impact, but the particles are already moving apart, although they "
         "overlap. Return None."),
        (5.0, 0.0, 3.0, None,
         "You returned an impact, but the particles are moving apart and never meet. Return "
         "None."),
        (5.0, 0.0, 0.0, None, "The particles have the same velocity, so they never meet. Return "
                              "None before you divide by the relative speed."),
        (5.0, 2.5, -3.0, None, "The particles miss each other, so the number under the square "
                               "root is negative. Return None before you take the square root."),
        (5.0, 2.000001, -3.0, None, "The particles miss each other by 1e-6 m, so there is no "
        "impact. Return None."),
        (5.0, 0.0, -3.0, 1.0, meet),
        (-5.0, 0.0, 3.0, 1.0, meet),
        (5.0, 0.0, -0.125, None, "The particles meet after 24 s, but the duration is only 10 s. "
                                 "Return None."),
        (2.0, 0.0, -1e-9, 0.0, "The particles are touching and approaching each other, however "
                               "slowly, so the time is 0."),
        (32.0, 0.0, -3.0, 10.0, "The particles meet exactly at the end of the duration, which "
                                "still counts as an impact. Return it."),
        (2.0, 0.0, -1e-13, None,
         "You returned an impact, but the closing speed of 1e-13 m/s is below "
         "VELOCITY_TOLERANCE. Treat it as a rounding error and return None."),
        (0.0, 0.0, 3.0, None, "Both centers are at the same position, so their distance can only "
                              "grow and there is no impact. Return None."),
    ):  # fmt: skip
        about(cause=cause)
        about.call = f"particle a at ({x:g}, {y:.7g}, 0) with velocity ({speed:g}, 0, 0); particle "
        about.call += "b at rest at (0, 0, 0); ParticlePairs([a, b], radius=1.0).next_impact(10.0)"
        pair = [Particle(Vector3(x, y, 0.0), Vector3(speed)), Particle()]
        impact = ParticlePairs(pair, 1.0).next_impact(10.0)
        if wanted is None:
            expect_none(impact)
        else:
            seen, right = "None, as if there were no impact", f"an impact after {wanted:g} s"
            expect_that(impact is not None, seen, right)
            expect_close(impact[0], wanted, then=TIME, unit="s")
            about.cause = "The penetration of the contact should be 0, because it describes the "
            about.cause += "moment of the impact, when the particles just touch."
            got = impact[1].penetration
            expect_close(got, 0.0, then="; the penetration of the contact", unit="m")
    about.call = "particle a; ParticlePairs([a], radius=1.0).next_impact(10.0)"
    about.cause = "There is only one particle, so there are no pairs. Return None instead of "
    about.cause += "raising an error."
    expect_none(ParticlePairs([Particle()], 1.0).next_impact(10.0))
    about.call = "particle a at (5, 0, 0) with velocity (-3, 0, 0); particle b at rest at (0, 0, "
    about.call += "0); pairs = ParticlePairs([a, b], radius=1.0); pairs.next_impact(1.0); "
    about.call += "pairs.radius = 1.75; pairs.restitution = 0.5; pairs.next_impact(1.0)"
    about.cause = "The radius and the restitution of the detector have changed since the first "
    about.cause += "call. Read both again on every call."
    pairs = ParticlePairs([Particle(Vector3(5.0), Vector3(-3.0)), Particle()], 1.0)
    pairs.next_impact(1.0)
    pairs.radius, pairs.restitution = 1.75, 0.5
    impact = expect_impact(pairs.next_impact(1.0))
    seen = (impact[0], impact[1].restitution)
    expect_close(seen, (0.5, 0.5), then="; the time in s and the restitution of the impact")


@pytest.mark.exercise("B7.11", asks="take the first in the order of contacts()")
def test_the_first_pair_of_many(rng: Random) -> None:
    about.read = PAIRS
    speed = positive_number(rng, 1.0, 3.0)
    places = [0.0, 30.0, 3.0, 7.0, 32.5, 9.5]
    speeds = [0.0, speed, 0.0, 0.0, -speed, -speed]
    about.call = f"six spheres at x = {places}; their velocities along x are {speeds} m/s; pairs = "
    about.call += "ParticlePairs(spheres, radius=1.0); pairs.next_impact(9.0)"
    about.cause = "You found no impact, although spheres 1 and 4 meet. Compute the time for every "
    about.cause += "pair of spheres, not only for neighbors in the list."
    particles = [Particle(Vector3(x), Vector3(v)) for x, v in zip(places, speeds, strict=True)]
    pairs = ParticlePairs(particles, 1.0)
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, normal, _, _),) = told([impact[1]], particles)
    names = [f"sphere {i}" for i in range(6)]
    about.cause = "You returned a later impact than that of spheres 1 and 4. Compare the times of "
    about.cause += "all pairs, and return the earliest impact."
    if (a, b) == (4, 1):
        about.cause = "You returned the right impact, but the contact's particle must come earlier "
        about.cause += "in the list than its other."
    expect_particles((a, b), (1, 4), names)
    expect_close(impact[0], 0.25 / speed, then=TIME, unit="s")
    about.cause = "The normal is wrong. Use the unit vector from the second sphere of the pair to "
    about.cause += "the first."
    expect_close(normal, (-1.0, 0.0, 0.0), then=NORMAL)
    about.call += "; spheres 1 and 4 made immovable; pairs.next_impact(9.0)"
    about.cause = "Spheres 1 and 4 are immovable now, so they never meet. Treat the velocity of an "
    about.cause += "immovable sphere as zero."
    particles[1].mass = particles[4].mass = math.inf
    impact = expect_impact(pairs.next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    expect_particles((a, b), (3, 5), names)
    expect_close(impact[0], 0.5 / speed, then=TIME, unit="s")
    about.call = f"three spheres at x = 0, 3 and 6 with velocities of {speed}, 0 and -{speed} m/s "
    about.call += "along x; ParticlePairs(spheres, radius=1.0).next_impact(9.0)"
    about.cause = "The middle sphere meets both others at the same time. Return the impact that "
    about.cause += "comes first in list order, which is that of spheres 0 and 1."
    particles = [Particle(Vector3(3.0 * i), Vector3(speed * (1 - i))) for i in range(3)]
    impact = expect_impact(ParticlePairs(particles, 1.0).next_impact(9.0))
    ((a, b, *_),) = told([impact[1]], particles)
    if (a, b) == (1, 2):
        about.cause = "You returned the impact of spheres 1 and 2, but spheres 0 and 1 meet at the "
        about.cause += "same time. Return the impact that comes first in list order."
    expect_particles((a, b), (0, 1), names)


@pytest.mark.exercise("B7.11", asks="or differ only by rounding errors")
def test_accelerations_may_differ_by_rounding(rng: Random) -> None:
    about.read = PAIRS
    for ma, mb in ((1.1, 1.3), (3.3, 4.9), (positive_number(rng), positive_number(rng))):
        about.call = f"particle a of {ma} kg at (5, 0, 0) with velocity (-3, 0, 0); particle b of "
        about.call += f"{mb} kg at rest at (0, 0, 0); p.add_force(Vector3(0, -9.81 * p.mass, 0)) "
        about.call += "and p.integrate(1e-9) for both particles p; "
        about.call += "ParticlePairs([a, b], radius=1.0).next_impact(10)"
        about.cause = "You rejected accelerations of 9.81 m/s^2 that differ only by rounding "
        about.cause += "errors. Allow a difference of up to 1e-12 times their magnitudes."
        pair = [Particle(Vector3(5.0), Vector3(-3.0), mass=ma), Particle(mass=mb)]
        for particle, mass in zip(pair, (ma, mb), strict=True):
            particle.add_force(Vector3(0.0, -9.81 * mass, 0.0))
            particle.integrate(1e-9)
        impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
        # The step has already covered 3e-9 m.
        expect_close(impact[0], 1.0, tolerance=2e-9, then=TIME, unit="s")
    about.call = "particle a (immovable) at (5, 0, 0) with velocity and acceleration (9, 9, 9); "
    about.call += "particle b at (0, 0, 0) with velocity (3, 0, 0); ParticlePairs([a, b], "
    about.call += "radius=1.0).next_impact(10)"
    about.cause = "Particle a is immovable, so it doesn't move, whatever its attributes are. Use "
    about.cause += "zero for its velocity and its acceleration."
    nines = Vector3(9.0, 9.0, 9.0)
    pair = [Particle(Vector3(5.0), nines, nines, mass=math.inf), Particle(None, Vector3(3.0))]
    impact = expect_impact(ParticlePairs(pair, 1.0).next_impact(10.0))
    expect_close(impact[0], 1.0, then=TIME, unit="s")
    ((_, _, normal, _, _),) = told([impact[1]], pair)
    expect_close(normal, (1.0, 0.0, 0.0), then=NORMAL)
