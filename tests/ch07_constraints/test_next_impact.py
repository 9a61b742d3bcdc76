"""The next impact on the ground and of two spheres, build tasks B7.10 and B7.11."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.probes import told
from draw import Triple, number, positive_number, unit_vector, vector
from expect import about, expect_close, expect_exactly, expect_that, expect_unchanged
from impacts import expect_impact, expect_none, expect_particles

ZERO, UP = Triple((0.0, 0.0, 0.0)), Triple((0.0, 1.0, 0.0))
GROUND = "the docstring of GroundPlane.next_impact"
PAIRS = "the docstring of ParticlePairs.next_impact"
TIME = "; the time of the impact"
FOUND = "; the time in s and the restitution of the impact"
KEPT = "next_impact has changed a particle. It should only predict the impact."


def expect_contact(
    contact: Any,
    particles: list[Any],
    ends: tuple[int, int],
    n: Triple,
    c: float,
    slips: Mapping[str, Sequence[float]] | None = None,
) -> None:
    """Expect the contact of an impact: these indices of particles, this normal and restitution."""
    ((a, b, normal, restitution, depth),) = told([contact], particles)
    names = [f"sphere {i}" for i in range(len(particles))] if len(particles) > 2 else ("a", "b")
    why = about.cause
    if (b, a) == ends:
        why = "The contact's particle comes earlier in the list than its other."
    expect_particles((a, b), ends, names, cause=why)
    why = "The normal points from other, or the ground, to particle, at the time of the impact."
    name = "; the normal of the contact"
    # Positions of up to 90 m, rounded, at closing speeds of about 1 m/s; grazing loses more.
    expect_close(normal, n, slips, then=name, cause=why, tolerance=1e-8)
    why = "Pass the restitution of the detector when you create the contact."
    name = "; the restitution of the contact"
    expect_close(restitution, c, then=name, cause=why, tolerance=1e-13)
    why = "The contact describes the moment of the impact, when the bodies just touch, so its "
    name, why = "; the penetration of the contact", f"{why}penetration is 0."
    expect_close(depth, 0.0, then=name, cause=why, tolerance=1e-13, unit="m")


@pytest.mark.exercise("B7.10", asks="the first impact of a particle on the ground", read=GROUND)
def test_the_first_impact_on_the_ground(rng: Random) -> None:
    height, radius, c = number(rng), 0.25, round(rng.uniform(0.1, 0.9), 3)
    falls, speeds = [3.0, 2.0, 1.0, 2.5], [positive_number(rng, 1.0, 2.0) for _ in range(4)]
    places = [(number(rng), height + radius + fall, number(rng)) for fall in falls]
    with calls(
        "All four spheres reach the ground within 9 s. Compute the time for every sphere, and "
        "return the earliest impact.",
        "the lowest points of four spheres are 3, 2, 1 and 2.5 m above the ground; the spheres "
        f"move down at {speeds} m/s; ground = GroundPlane(spheres, height={height}, "
        f"radius={radius}, restitution={c}); ground.next_impact(9.0)",
    ):
        spheres = [
            Particle(Vector3(*place), Vector3(5.0, -speed, 5.0))
            for place, speed in zip(places, speeds, strict=True)
        ]
        ground = GroundPlane(spheres, height, radius, c)
        time, contact = expect_impact(ground.next_impact(9.0))
    both = [*zip(falls, speeds, strict=True)]
    times = [fall / speed for fall, speed in both]
    first = min(times)
    slips = {
        "You returned the last impact of the four spheres.": max(times),
        "You returned the impact of the first sphere in the list.": times[0],
        "You used the whole speed. Only the velocity along Y closes the gap.":
            min(fall / math.hypot(5.0, speed, 5.0) for fall, speed in both),
        "You left out the radius, so you returned the time when the center reaches the ground. Use "
        "the lowest point of the sphere, which is at y - radius.":
            min((fall + radius) / speed for fall, speed in both),
    }  # fmt: skip
    expect_close(time, first, slips, then=TIME, tolerance=1e-13, unit="s")
    expect_contact(contact, spheres, (times.index(first), -1), UP, c)
    why = "The first impact happens only after the end of the duration, so it doesn't count. "
    early, name = 0.999 * first, f"; ground.next_impact({0.999 * first})"
    expect_none(ground.next_impact(early), then=name, cause=f"{why}Return None.")
    why = "An impact exactly at the end of the duration still counts. Use <= instead of <."
    late = ground.next_impact(float(time)) is not None
    right, name = f"an impact after {first:.6g} s", f"; ground.next_impact({time!r})"
    expect_that(late, "None, as if there were no impact", right, then=name, cause=why)
    with calls(
        "The attributes of the detector have changed, so all spheres now fall 1.25 m farther. Read "
        "height, radius and restitution again on every call.",
        "ground.height -= 1; ground.radius = 0; ground.restitution = 0.5; "
        f"ground.next_impact({first!r} + 9)",
        more=True,
    ):
        ground.height -= 1.0
        ground.radius, ground.restitution = 0.0, 0.5
        time, contact = expect_impact(ground.next_impact(first + 9.0))
    wanted = (min((fall + 1.25) / speed for fall, speed in both), 0.5)
    expect_close((time, contact.restitution), wanted, then=FOUND)
    for sphere, place, speed in zip(spheres, places, speeds, strict=True):
        expect_unchanged("the position of a sphere", sphere.position, place, cause=KEPT)
        velocity = (5.0, -speed, 5.0)
        expect_unchanged("the velocity of a sphere", sphere.velocity, velocity, cause=KEPT)


@pytest.mark.exercise("B7.10", asks="where a is its last_acceleration", read=GROUND)
def test_forces_count_and_immovable_particles_do_not(rng: Random) -> None:
    t, down = positive_number(rng), (0.0, -2.0, 0.0)
    with calls("You left out the force. Use last_acceleration, which includes forces."):
        p = Particle(Vector3(0.0, 2.5 * t * t, 0.0), None, Vector3(0.0, 2.0, 0.0), mass=2.0)
        p.add_force(Vector3(0.0, -14.0, 0.0))
        p.integrate(1e-9)
        impact = GroundPlane([p]).next_impact(100.0)
    # Its speed of 5e-9 m/s after the step brings the impact forward by 1e-9 s.
    expect_close(expect_impact(impact)[0], t, tolerance=1e-8, then=TIME, unit="s")
    with calls("The wall never reaches the ground. Skip immovable particles."):
        wall = Particle(Vector3(0.0, 1.0, 0.0), Vector3(*down), mass=math.inf)
        p = Particle(Vector3(0.0, 2.0, 0.0), Vector3(*down))
        impact = GroundPlane([wall, p]).next_impact(9.0)
    expect_close(expect_impact(impact)[0], 1.0, then=TIME, unit="s")
    with calls("Both reach the ground at the same time. Return the first one in the list."):
        p = Particle(Vector3(0.0, 2.0, 0.0), Vector3(*down))
        q = Particle(Vector3(1.0, 2.0, 0.0), Vector3(*down))
        impact = GroundPlane([p, q]).next_impact(1.0)
    time, contact = expect_impact(impact)
    ((first, *_),) = told([contact], [p, q])
    expect_exactly(first, 0, then="; the index of the particle in the contact")
    expect_close(time, 1.0, then=TIME, unit="s")
    with calls("The particle moves farther into the ground. Return 0 s and a penetration of 0."):
        p = Particle(Vector3(0.0, -1.0, 0.0), Vector3(*down))
        impact = GroundPlane([p]).next_impact(0.0)
    time, contact = expect_impact(impact)
    name = "; the time in s and the penetration in m of the impact"
    expect_close((time, contact.penetration), (0.0, 0.0), then=name)
    with calls("No particle can move. Return None instead of raising an error."):
        impact = GroundPlane([Particle(mass=math.inf)]).next_impact(9.0)
    expect_none(impact)


@pytest.mark.exercise("B7.11", asks="Two spheres have an impact when they touch", read=PAIRS)
def test_when_two_spheres_meet(rng: Random) -> None:
    m, r, late = unit_vector(rng), positive_number(rng, 0.2, 0.9), positive_number(rng)
    # Relative to b, a moves on a line; at the time t it is two radii away in the direction n.
    place, side, move = vector(rng), vector(rng), vector(rng)
    move = -move if move @ m > 0.0 else move
    down, c = (1.0, -positive_number(rng), 2.0), round(rng.uniform(0.1, 0.9), 3)
    far = Triple((-10.8, 1.4, 0.0))  # the sides of a right triangle: 1.4, 4.8 and 5 = 2 r
    right, left = Triple((2.0, 0.0, 0.0)), Triple((-1.0, 0.0, 0.0))
    for p, v, q, w, radius, n, t, slips in (
        (far, right, ZERO, left, 2.5, Triple((-0.96, 0.28, 0.0)), 2.0, {
            "You returned the later of the two solutions, at which the particles have already "
            "passed through each other.": 5.2,
            "You used only one radius.": 3.6 - math.sqrt(4.29) / 3.0,
            "You used 2 r^2 as the square of two radii. It is (2 r)^2 = 4 r^2.":
                3.6 - math.sqrt(10.54) / 3.0,
            "You returned the time when the centers are closest to each other.": 3.6,
            "You used only the velocity of a, but b is moving too.": 3.0,
            "You added the two velocities.": 6.0,
        }),
        (place + m * (2.0 * r) - move * late, side + move, place, side, r, m, late, {}),
    ):  # fmt: skip
        with calls(
            "The particles touch when their centers are two radii apart. Solve |d + u t| = 2 "
            "radius for t, where d = pa - pb and u = va - vb, and take the smaller solution."
        ):
            a = Particle(Vector3(*p), Vector3(*v), Vector3(*down))
            b = Particle(Vector3(*q), Vector3(*w), Vector3(*down), mass=3.0)
            impact = ParticlePairs([a, b], radius=radius, restitution=c).next_impact(10.0)
        time, contact = expect_impact(impact)
        # Positions of up to 90 m, rounded, at closing speeds of about 1 m/s; grazing loses more.
        expect_close(time, t, slips, then=TIME, tolerance=1e-9, unit="s")
        slips = {
            "The normal points the wrong way. It should point from b, the second particle, to a.":
                -n,
            "You computed the normal from the current positions. Use the positions that a and b "
            "will have at the time of the impact.": (p - q) / abs(p - q),
        }  # fmt: skip
        expect_contact(contact, [a, b], (0, 1), n, c, slips)
        expect_unchanged("a.position", a.position, p, cause=KEPT)
        expect_unchanged("a.velocity", a.velocity, v, cause=KEPT)
        expect_unchanged("b.position", b.position, q, cause=KEPT)
        expect_unchanged("b.velocity", b.velocity, w, cause=KEPT)


@pytest.mark.exercise("B7.11", asks="Ignore a slower approach", read=PAIRS)
def test_spheres_that_touch_or_never_meet() -> None:
    approach = "and are approaching each other"
    meet = "are 5 m apart and close at 3 m/s, until their centers are 2 m apart"
    for x, y, speed, wanted, state in (
        (2.0, 0.0, -3.0, 0.0, f"are touching {approach}"),
        (1.5, 0.0, -3.0, 0.0, f"overlap {approach}"),
        (1.5, 0.0, 3.0, None, "are already moving apart, although they overlap"),
        (5.0, 0.0, 3.0, None, "are moving apart and never meet"),
        (5.0, 0.0, 0.0, None, "have the same velocity. Check this before you divide by it"),
        (5.0, 2.5, -3.0, None, "miss, because the number under the square root is negative"),
        (5.0, 2.000001, -3.0, None, "miss each other by 1e-6 m"),
        (5.0, 0.0, -3.0, 1.0, meet),
        (-5.0, 0.0, 3.0, 1.0, meet),
        (5.0, 0.0, -0.125, None, "meet only after 24 s, but the duration is 10 s"),
        (2.0, 0.0, -1e-9, 0.0, f"are touching {approach}, however slowly"),
        (32.0, 0.0, -3.0, 10.0, "meet exactly at the end of the duration, which still counts"),
        (2.0, 0.0, -1e-13, None, "close at 1e-13 m/s, a rounding error below VELOCITY_TOLERANCE"),
        (0.0, 0.0, 3.0, None, "are at the same position, so their distance can only grow"),
    ):
        right = "None" if wanted is None else f"an impact with a time of {wanted:g} s"
        with calls(f"The particles {state}. Return {right}."):
            a, b = Particle(Vector3(x, y, 0.0), Vector3(speed)), Particle()
            impact = ParticlePairs([a, b], radius=1.0).next_impact(10.0)
        if wanted is None:
            expect_none(impact)
            continue
        expect_that(impact is not None, "None, as if there were no impact", right)
        expect_close(impact[0], wanted, then=TIME, unit="s")
        expect_contact(impact[1], [a, b], (0, 1), Triple((math.copysign(1.0, x), 0.0, 0.0)), 0.0)
    with calls("One particle has no pairs. Return None instead of raising an error."):
        impact = ParticlePairs([Particle()], radius=1.0).next_impact(10.0)
    expect_none(impact)
    with calls("The detector's radius and restitution have changed. Read both on every call."):
        a, b = Particle(Vector3(5.0), Vector3(-3.0)), Particle()
        pairs = ParticlePairs([a, b], radius=1.0)
        pairs.next_impact(1.0)
        pairs.radius = 1.75
        pairs.restitution = 0.5
        impact = pairs.next_impact(1.0)
    time, contact = expect_impact(impact)
    expect_close((time, contact.restitution), (0.5, 0.5), then=FOUND)


@pytest.mark.exercise("B7.11", asks="take the first in the order of contacts()", read=PAIRS)
def test_the_first_pair_of_many(rng: Random) -> None:
    speed, left = positive_number(rng, 1.0, 3.0), Triple((-1.0, 0.0, 0.0))
    places, speeds = (0.0, 30.0, 3.0, 7.0, 32.5, 9.5), (0.0, speed, 0.0, 0.0, -speed, -speed)
    with calls(
        "Spheres 1 and 4 meet first. Compute the time for every pair of spheres, even if they are "
        "far apart in the list, and return the earliest impact, not the first or last one found."
    ):
        spheres = [Particle(Vector3(x), Vector3(v)) for x, v in zip(places, speeds, strict=True)]
        pairs = ParticlePairs(spheres, radius=1.0)
        impact = pairs.next_impact(9.0)
    time, contact = expect_impact(impact)
    expect_contact(contact, spheres, (1, 4), left, 0.0)
    expect_close(time, 0.25 / speed, then=TIME, unit="s")
    with calls("Spheres 1 and 4 are immovable now. Use zero as their velocities.", more=True):
        spheres[1].mass = spheres[4].mass = math.inf
        impact = pairs.next_impact(9.0)
    time, contact = expect_impact(impact)
    expect_contact(contact, spheres, (3, 5), left, 0.0)
    expect_close(time, 0.5 / speed, then=TIME, unit="s")
    with calls("Two pairs meet at the same time. Return the one that is first in list order."):
        spheres = [Particle(Vector3(3.0 * i), Vector3(speed * (1 - i))) for i in range(3)]
        impact = ParticlePairs(spheres, radius=1.0).next_impact(9.0)
    expect_contact(expect_impact(impact)[1], spheres, (0, 1), left, 0.0)


@pytest.mark.exercise("B7.11", asks="or differ only by rounding errors", read=PAIRS)
def test_accelerations_may_differ_by_rounding(rng: Random) -> None:
    for ma, mb in ((1.1, 1.3), (3.3, 4.9), (positive_number(rng), positive_number(rng))):
        with calls(
            "You rejected accelerations of 9.81 m/s^2 that differ only by rounding errors. Allow a "
            "difference of up to 1e-12 times their magnitudes.",
            f"particle a of {ma} kg at (5, 0, 0) with velocity (-3, 0, 0); particle b of {mb} kg "
            "at rest at (0, 0, 0); p.add_force(Vector3(0, -9.81 * p.mass, 0)) and "
            "p.integrate(1e-9) for both particles p; ParticlePairs([a, b], "
            "radius=1.0).next_impact(10)",
        ):
            a, b = Particle(Vector3(5.0), Vector3(-3.0), mass=ma), Particle(mass=mb)
            for particle, mass in ((a, ma), (b, mb)):
                particle.add_force(Vector3(0.0, -9.81 * mass, 0.0))
                particle.integrate(1e-9)
            impact = expect_impact(ParticlePairs([a, b], 1.0).next_impact(10.0))
        # The step has already covered 3e-9 m.
        expect_close(impact[0], 1.0, tolerance=2e-9, then=TIME, unit="s")
    with calls("Particle a is immovable. Use zero for its velocity and its acceleration."):
        v, g = Vector3(9.0, 9.0, 9.0), Vector3(9.0, 9.0, 9.0)
        a = Particle(Vector3(5.0), v, g, mass=math.inf)
        b = Particle(None, Vector3(3.0))
        impact = ParticlePairs([a, b], radius=1.0).next_impact(10.0)
    time, contact = expect_impact(impact)
    expect_close(time, 1.0, then=TIME, unit="s")
    expect_contact(contact, [a, b], (0, 1), Triple((1.0, 0.0, 0.0)), 0.0)
