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
from unmoved import expect_kept

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.3 and the docstring of Overcrowding"


@pytest.mark.exercise("6.3", asks="that particle pushes with the force k")
def test_a_particle_that_is_too_near_pushes(rng: Random) -> None:
    about.read = READ
    here, d, f = components(rng), direction(rng), components(rng)
    distance, k = positive_number(rng, 1.0, 9.0), positive_number(rng)
    for share, cause in (
        (
            0.25,
            "q is closer than self.distance, so it must push p away. The push is k (distance "
            "- l), where k is the stiffness and l the distance of q from p.",
        ),
        (
            0.9,
            "q is only slightly closer than self.distance, so it must push p away with a small "
            "force. The push is k (distance - l), where k is the stiffness and l the "
            "distance of q from p.",
        ),
        (
            1.1,
            "q is farther away than self.distance, so it must not push p. Add a force only for "
            "particles that are closer.",
        ),
    ):
        there = tuple(h + share * distance * part for h, part in zip(here, d, strict=True))
        about.call = f"p at {here}; q at {there}, {share * distance:.5g} m from p; "
        about.call += f"p.add_force(Vector3{f}); crowd = Overcrowding([p, q], distance={distance}, "
        about.call += f"stiffness={k}); crowd.update_force(p, 0.5)"
        about.cause = "The list contains p too, whose distance from itself is 0. Skip p before you "
        about.cause += "divide by the distance."
        p = Particle(Vector3(*here), Vector3(1.0, 2.0, 3.0), mass=2.0)
        q = Particle(Vector3(*there), Vector3(-3.0, 2.0, 1.0), mass=3.0)
        p.add_force(Vector3(*f))
        Overcrowding([p, q], distance, k).update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), here)
        expect_kept("q.position", xyz(q.position), there)
        about.cause = cause
        push = k * distance * max(1.0 - share, 0.0)
        wanted = tuple(g - push * part for g, part in zip(f, d, strict=True))
        got = xyz(p.force_accumulator)
        near = share * distance
        pushes = {
            "Your force pulls p toward q. Reverse its direction, so that it pushes p away.": -push,
            "There is no push, although q is closer than self.distance. Compare the distance of q "
            "from p, not its square, with self.distance.": 0.0,
            "Your push is half of what it should be. Either you divide it by the number of "
            "particles, or you multiply it by the duration.": 0.5 * push,
            "Your push grows with the distance l of q. Multiply the stiffness by (self.distance - "
            "l), so that the nearest particles push the most.": k * near,
            "The size of your push equals the stiffness, however far q is from p. Multiply the "
            "stiffness by (self.distance - l), where l is the distance of q from p.": k,
            "You multiply the push by the whole offset. Normalize the offset first, so that it is "
            "only a direction.": push * near,
            "You use the squared distance between the particles. Use the distance itself, "
            "which is the magnitude of the offset.": k * (distance - near**2),
        }
        if share < 1.0:
            slips = {
                slip: [g - size * part for g, part in zip(f, d, strict=True)]
                for slip, size in pushes.items()
            }
            blame(got, slips)
            first = Particle(Vector3(*here))
            Overcrowding([q, first], distance, k).update_force(first, 0.5)
            if tuple(got) == f and any(xyz(first.force_accumulator)):
                about.cause = "q pushes p only if it comes before p in the list, so your loop ends "
                about.cause += "too early. Skip only p, with continue instead of break or return."
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
        about.cause = (
            "You added a force to q as well. Push only p, the particle that is passed to "
            "update_force."
        )
        expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator, in N")


@pytest.mark.exercise("6.3", asks="from every other particle that is too close")
def test_all_particles_that_are_too_near_push(rng: Random) -> None:
    about.read = READ
    here = components(rng)
    offsets = [(1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, -4.0, 0.0), (0.0, 0.0, -1.5)]
    k = positive_number(rng)
    about.call = f"p at {here}; four others at p + (1, 0, 0), p + (0, 2, 0), p + (0, -4, 0) and "
    about.call += f"p + (0, 0, -1.5); crowd = Overcrowding(all five, distance=3.0, stiffness={k}); "
    about.call += "crowd.update_force(p, 0.5)"
    about.cause = (
        "Three of the other four particles are closer than 3 m, and each of them must push p. Add "
        "up all three pushes."
    )
    p = Particle(Vector3(*here))
    others = [Particle(p.position + Vector3(*offset)) for offset in offsets]
    crowd = Overcrowding([others[0], others[1], p, others[2], others[3]], 3.0, k)
    crowd.update_force(p, 0.5)
    wanted = (-2.0 * k, -1.0 * k, 1.5 * k)
    got = xyz(p.force_accumulator)
    nearest = (
        "Only the first particle, which is also the nearest, pushes p. Add up the pushes of all "
        "particles closer than 3 m."
    )
    blame(got, [((-2.0 * k, 0.0, 0.0), nearest)])
    stopped = "You stop at the first particle that is far enough away. Use continue instead of "
    stopped += "return or break, so that the loop goes on with the next particle."
    blame(got, [((-2.0 * k, -1.0 * k, 0.0), stopped)])
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-12)
    about.call += "; p.clear_forces(); crowd.particles.pop(); crowd.distance = 1.25; "
    about.call += f"crowd.stiffness = {2 * k:.6g}; crowd.update_force(p, 0.5)"
    about.cause = (
        "Before this call, the check changes the list, the distance and the stiffness, so that "
        "only one particle is closer than 1.25 m. Read these attributes in every call."
    )
    p.clear_forces()
    crowd.particles.pop()
    crowd.distance, crowd.stiffness = 1.25, 2.0 * k
    crowd.update_force(p, 0.5)
    wanted = (-0.5 * k, 0.0, 0.0)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-12)


@pytest.mark.exercise("6.3", asks="exactly the same position does not push")
def test_particles_at_the_same_position_do_not_push(rng: Random) -> None:
    about.read = READ
    here = components(rng)
    about.call = f"p and q at {here}, r 1 m above them; Overcrowding([r, p, q], distance=3.0, "
    about.call += "stiffness=5.0).update_force(p, 0.5)"
    about.cause = (
        "p and q are at the same position, so a push between them has no direction. Skip q, so "
        "that only r pushes p, downward."
    )
    p, q = Particle(Vector3(*here)), Particle(Vector3(*here))
    r = Particle(p.position + Vector3(0.0, 1.0, 0.0), mass=math.inf)
    crowd = Overcrowding([r, p, q], 3.0, 5.0)
    crowd.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -10.0, 0.0), then="; p.force_accumulator, in N", tolerance=1e-12)
    about.cause = (
        "The list of particles belongs to the caller. Don't reorder it, don't remove anything from "
        "it, and don't move its particles."
    )
    got = [part for one in crowd.particles for part in xyz(one.position)]
    wanted = [here[0], here[1] + 1.0, here[2], *here, *here]
    expect_close(
        got,
        wanted,
        then="; the positions in crowd.particles, which is [r, p, q]",
        tolerance=1e-12,
    )
    about.call = "p at (0, 1e-9, 0) and q at (0, 0, 0); Overcrowding([q], distance=3.0, "
    about.call += "stiffness=5.0).update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = (
        "p is not in the list, but q must push it anyway. q is very close but not at the same "
        "position, so the push has a direction."
    )
    p, q = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
    Overcrowding([q], 3.0, 5.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, 15.0, 0.0), tolerance=1e-7)


@pytest.mark.exercise("6.3", asks="too close therefore push each other apart")
def test_a_crowd_moves_apart_and_keeps_its_momentum(rng: Random) -> None:
    about.read = READ
    places = [components(rng) for _ in range(6)]
    places = [(0.1 * x, 0.1 * y, 0.1 * z) for x, y, z in places]
    x, y, z = places[0]
    places[1] = (0.9 * x, 0.9 * y, 0.9 * z)  # two are too near, wherever the others are
    about.call = f"6 particles near {places[0]} with damping 0.2, each pushed by Overcrowding(all "
    about.call += "six, distance=1.0, stiffness=40.0); 600 steps of 1/60 s"
    about.cause = (
        "Particles closer than 1 m push each other apart with equal and opposite forces. At the "
        "end no two of them may be that close, and the total momentum must still be zero."
    )
    nearest, momentum = crowded(places, 1.0, 40.0, 0.2, 1.0 / 60.0, 600)
    # Pushed out of the way, each coasts on a little, slowed by the damping.
    before = min(math.dist(a, b) for a in places for b in places if a is not b)
    least = max(0.99, before)
    expect_between(
        nearest,
        least,
        math.inf,
        then="; the smallest distance between two particles at the end, in m",
    )
    # The pushes of each frame are opposite but for rounding, some 1e-14 N.
    expect_close(momentum, ZERO, then="; the total momentum at the end, in kg m/s", tolerance=1e-11)
