"""Overcrowding, exercise 6.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import crowded
from ch06_springs.springs import Overcrowding
from draw import components, direction, positive_number
from expect import about, blame, expect_between, expect_close, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.3 and the docstring of Overcrowding"


@pytest.mark.exercise("6.3")
def test_who_is_too_near_pushes(rng: Random) -> None:
    about.read = READ
    here, d, f = components(rng), direction(rng), components(rng)
    distance, k = positive_number(rng, 1.0, 9.0), positive_number(rng)
    for share, cause in (
        (
            0.25,
            (
                "Every particle that is closer than the distance pushes p away with k (distance - "
                "l), where l is how far away it is. The list contains p itself, which doesn't push."
            ),
        ),
        (
            0.9,
            "The other particle is only slightly closer than the distance, so it pushes p away "
            "with a small force. The push is k (distance - l), however small that is.",
        ),
        (
            1.1,
            "The other particle is farther away than the distance, so it exerts no force. Add a "
            "force only if distance - l is positive.",
        ),
    ):
        about.cause = cause
        there = tuple(h + share * distance * part for h, part in zip(here, d, strict=True))
        about.call = f"p of 2 kg at {here}, q of 3 kg at {there}; p.add_force(Vector3{f}); "
        about.call += f"Overcrowding([p, q], {distance}, {k}).update_force(p, 0.5)"
        p = Particle(Vector3(*here), Vector3(1.0, 2.0, 3.0), mass=2.0)
        q = Particle(Vector3(*there), Vector3(-3.0, 2.0, 1.0), mass=3.0)
        p.add_force(Vector3(*f))
        Overcrowding([p, q], distance, k).update_force(p, 0.5)
        push = k * distance * max(1.0 - share, 0.0)
        wanted = tuple(g - push * part for g, part in zip(f, d, strict=True))
        got = xyz(p.force_accumulator)
        near = share * distance
        pushes = {
            "Your force pulls p toward the other particle. It should push p away, so check the "
            "sign of the offset.": -push,
            "There is no push at all. Perhaps your loop ends when it finds p itself in the list. "
            "Skip only p, and continue with the next particle.": 0.0,
            "Your push has the size k at every distance. It should grow as the particles come "
            "closer, so multiply k by (distance - l).": k,
            "You multiplied the push by the whole offset, so the distance counts twice. Multiply "
            "by the unit vector along the offset instead.": push * near,
            "You used the squared distance between the particles. Take the magnitude of the offset "
            "instead.": k * (distance - near**2),
        }
        if share < 1.0:
            slips = {
                slip: [g - size * part for g, part in zip(f, d, strict=True)]
                for slip, size in pushes.items()
            }
            blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)
        about.cause = (
            "You added a force to the other particle as well. Push only the particle that is "
            "passed in, because update_force is called for each particle in turn."
        )
        expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator")


@pytest.mark.exercise("6.3")
def test_every_one_who_is_too_near_counts(rng: Random) -> None:
    about.read = READ
    here = components(rng)
    offsets = [(1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.5), (0.0, -4.0, 0.0)]
    k = positive_number(rng)
    about.call = f"p at {here}, others at distances of 1, 2, 1.5 and 4 m along x, y, -z and -y; "
    about.call += f"crowd = Overcrowding(all, 3.0, {k}); crowd.update_force(p, 0.5)"
    about.cause = (
        "Three of the other four are closer than the distance, and each of them pushes. Add up all "
        "three pushes instead of stopping after the first."
    )
    p = Particle(Vector3(*here))
    others = [Particle(p.position + Vector3(*offset)) for offset in offsets]
    crowd = Overcrowding([others[0], others[1], p, others[2], others[3]], 3.0, k)
    crowd.update_force(p, 0.5)
    wanted = (-2.0 * k, -1.0 * k, 1.5 * k)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-12)
    about.call += "; p.clear_forces(); crowd.particles.pop(); crowd.distance = 1.25; "
    about.call += f"crowd.stiffness = {2 * k}; crowd.update_force(p, 0.5)"
    about.cause = (
        "The check has changed the list, the distance and the stiffness since the last call, so "
        "read these attributes on every call. The distance is 1.25 m now, and only one particle is "
        "closer than that."
    )
    p.clear_forces()
    crowd.particles.pop()
    crowd.distance, crowd.stiffness = 1.25, 2.0 * k
    crowd.update_force(p, 0.5)
    wanted = (-0.5 * k, 0.0, 0.0)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-12)


@pytest.mark.exercise("6.3")
def test_a_particle_does_not_push_itself_nor_who_is_at_its_place(rng: Random) -> None:
    about.read = READ
    here = components(rng)
    about.call = f"p and q at {here}, r 1 m above; Overcrowding([p, q, r], 3.0, "
    about.call += "5.0).update_force(p, 0.5)"
    about.cause = (
        "p and q are at the same position, so a push between them has no direction. Skip q, so "
        "that only r pushes p, downward."
    )
    p, q = Particle(Vector3(*here)), Particle(Vector3(*here))
    r = Particle(p.position + Vector3(0.0, 1.0, 0.0), mass=math.inf)
    crowd = Overcrowding([r, p, q], 3.0, 5.0)
    crowd.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -10.0, 0.0), then="; p.force_accumulator", tolerance=1e-12)
    about.cause = (
        "The list of particles belongs to the caller, so treat it as read-only. Don't reorder it "
        "or move its particles."
    )
    got = [part for one in crowd.particles for part in xyz(one.position)]
    wanted = [here[0], here[1] + 1.0, here[2], *here, *here]
    expect_close(
        got,
        wanted,
        then="; the positions in crowd.particles, as they were: r, p, q",
        tolerance=1e-12,
    )
    about.call = "p at (0, 1e-9, 0), not in the crowd; Overcrowding([q], 3.0, 5.0).update_force(p, "
    about.call += "0.5), q at (0, 0, 0); p.force_accumulator"
    about.cause = (
        "The particle that is pushed doesn't have to be in the list. Its neighbor is very close "
        "but not at the same position, so the push has a direction."
    )
    p, q = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
    Overcrowding([q], 3.0, 5.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, 15.0, 0.0), tolerance=1e-7)


@pytest.mark.exercise("6.3")
def test_a_crowd_moves_apart_and_keeps_its_momentum(rng: Random) -> None:
    about.read = READ
    places = [components(rng) for _ in range(6)]
    places = [(0.1 * x, 0.1 * y, 0.1 * z) for x, y, z in places]
    x, y, z = places[0]
    places[1] = (0.9 * x, 0.9 * y, 0.9 * z)  # two are too near, wherever the others are
    about.call = f"6 particles at {places[0]} ..., damping 0.2, Overcrowding(all, 1.0, 40.0) for "
    about.call += "each; 600 frames of registry.update_forces(h), p.integrate(h)"
    about.cause = (
        "Particles that are closer than 1 m push each other apart with equal and opposite forces. "
        "At the end no two of them should be that close, and the total momentum should still be "
        "zero."
    )
    nearest, momentum = crowded(places, 1.0, 40.0, 0.2, 1.0 / 60.0, 600)
    # Pushed out of the way, each coasts on a little, slowed by the damping.
    before = min(math.dist(a, b) for a in places for b in places if a is not b)
    least = max(0.99, before)
    expect_between(
        nearest, least, math.inf, then=": the smallest distance between two particles at the end"
    )
    # The pushes of each frame are opposite but for rounding, some 1e-14 N.
    expect_close(
        momentum, ZERO, then=": the total momentum, which is the sum of all m v", tolerance=1e-11
    )
