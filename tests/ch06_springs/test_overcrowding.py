"""Overcrowding, exercise 6.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import crowded
from ch06_springs.springs import Overcrowding
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_between, expect_close, xyz
from unmoved import expect_kept

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.3 and the docstring of Overcrowding"


@pytest.mark.exercise("6.3", asks="that particle pushes with the force k", read=READ)
def test_a_particle_that_is_too_near_pushes(rng: Random) -> None:
    here, d, f = vector(rng), unit_vector(rng), vector(rng)
    distance, k = positive_number(rng, 1.0, 9.0), positive_number(rng)
    size = "The push is k (distance - l), where k is the stiffness and l the distance of q from p."
    for share, cause in (
        (0.25, f"q is closer than self.distance, so it must push p away. {size}"),
        (0.9, "q is only slightly closer than self.distance, so it must push p away with a small "
         f"force. {size}"),
        (1.1, "q is farther away than self.distance, so it must not push p. Add a force only for "
         "particles that are closer."),
    ):  # fmt: skip
        near = share * distance
        there = here + near * d
        with calls(
            "The list contains p too, whose distance from itself is 0. Skip p before you divide by "
            "the distance."
        ):
            p = Particle(Vector3(*here), Vector3(1.0, 2.0, 3.0), mass=2.0)
            q = Particle(Vector3(*there), Vector3(-3.0, 2.0, 1.0), mass=3.0)
            p.add_force(Vector3(*f))
            crowd = Overcrowding([p, q], distance=distance, stiffness=k)
            crowd.update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), here)
        expect_kept("q.position", xyz(q.position), there)
        push, got = k * distance * max(1.0 - share, 0.0), xyz(p.force_accumulator)
        none = "There is no push, although q is closer than self.distance. Compare the distance of "
        none += "q from p, not its square, with self.distance."
        last = Particle(Vector3(*here))
        Overcrowding([q, last], distance, k).update_force(last, 0.5)
        if any(xyz(last.force_accumulator)):
            none = "q pushes p only if it comes before p in the list, so your loop ends too early. "
            none += "Skip only p, with continue instead of break or return."
        pushes = {
            "Your force pulls p toward q.": -push,
            none: 0.0,
            "Your push is half of what it should be. Either you divide it by the number of "
            "particles, or you multiply it by the duration.": 0.5 * push,
            "Your push grows with the distance l of q.": k * near,
            "The size of your push equals the stiffness, however far q is from p.": k,
            "You multiply the push by the whole offset instead of its direction.": push * near,
            "You use the squared distance between the particles.": k * (distance - near**2),
        }
        slips = {slip: f - wrong * d for slip, wrong in pushes.items()} if share < 1.0 else {}
        then = "; p.force_accumulator"
        expect_close(got, f - push * d, slips, then=then, unit="N", cause=cause, tolerance=1e-11)
        cause = "You added a force to q as well. Push only p, the particle that is passed to "
        cause += "update_force."
        expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=cause)


@pytest.mark.exercise("6.3", asks="from every other particle that is too close", read=READ)
def test_all_particles_that_are_too_near_push(rng: Random) -> None:
    here, k = vector(rng), positive_number(rng)
    with calls(
        "Three of the other four particles are closer than 3 m, and each of them must push p. Add "
        "up all three pushes."
    ):
        p = Particle(Vector3(*here))
        a = Particle(p.position + Vector3(1.0, 0.0, 0.0))
        b = Particle(p.position + Vector3(0.0, 2.0, 0.0))
        c = Particle(p.position + Vector3(0.0, -4.0, 0.0))
        d = Particle(p.position + Vector3(0.0, 0.0, -1.5))
        crowd = Overcrowding([a, b, p, c, d], distance=3.0, stiffness=k)
        crowd.update_force(p, 0.5)
        got = p.force_accumulator
    slips = {
        "Only the first particle, which is also the nearest, pushes p.": (-2.0 * k, 0.0, 0.0),
        "You stop at the first particle that is far enough away. Use continue instead of return or "
        "break, so that the loop goes on with the next particle.": (-2.0 * k, -1.0 * k, 0.0),
    }
    expect_close(got, (-2.0 * k, -1.0 * k, 1.5 * k), slips, tolerance=1e-12, unit="N")
    with calls(
        "Before this call, the check changes the list, the distance and the stiffness, so that "
        "only one particle is closer than 1.25 m. Read these attributes in every call.",
        more=True,
    ):
        p.clear_forces()
        crowd.particles.pop()
        crowd.distance, crowd.stiffness = 1.25, 2.0 * k
        crowd.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-0.5 * k, 0.0, 0.0), tolerance=1e-12, unit="N")


@pytest.mark.exercise("6.3", asks="exactly the same position does not push", read=READ)
def test_particles_at_the_same_position_do_not_push(rng: Random) -> None:
    here = vector(rng)
    with calls(
        "p and q are at the same position, so a push between them has no direction. Skip q, so "
        "that only r pushes p, downward."
    ):
        p, q = Particle(Vector3(*here)), Particle(Vector3(*here))
        r = Particle(p.position + Vector3(0.0, 1.0, 0.0), mass=math.inf)
        crowd = Overcrowding([r, p, q], distance=3.0, stiffness=5.0)
        crowd.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, -10.0, 0.0), tolerance=1e-12, unit="N")
    cause = "The list of particles belongs to the caller. Don't reorder it, don't remove anything "
    cause += "from it, and don't move its particles."
    got = [part for one in crowd.particles for part in xyz(one.position)]
    wanted = [*(here + Triple((0.0, 1.0, 0.0))), *here, *here]
    then = "; the positions in crowd.particles, which is [r, p, q]"
    expect_close(got, wanted, then=then, cause=cause, tolerance=1e-12)
    with calls(
        "p is not in the list, but q must push it anyway. q is very close but not at the same "
        "position, so the push has a direction."
    ):
        p, q = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
        Overcrowding([q], distance=3.0, stiffness=5.0).update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, 15.0, 0.0), tolerance=1e-7, unit="N")


@pytest.mark.exercise("6.3", asks="too close therefore push each other apart", read=READ)
def test_a_crowd_moves_apart_and_keeps_its_momentum(rng: Random) -> None:
    places = [0.1 * vector(rng) for _ in range(6)]
    places[1] = 0.9 * places[0]  # two are too near, wherever the others are
    with calls(
        "Particles closer than 1 m push each other apart with equal and opposite forces. At the "
        "end no two of them may be that close, and the total momentum must still be zero.",
        f"6 particles near {places[0]} with damping 0.2, each pushed by Overcrowding(all six, "
        "distance=1.0, stiffness=40.0); 600 steps of 1/60 s",
    ):
        nearest, momentum = crowded(places, 1.0, 40.0, 0.2)
    # Pushed out of the way, each coasts on a little, slowed by the damping.
    before = min(math.dist(a, b) for a in places for b in places if a is not b)
    then = "; the smallest distance between two particles at the end"
    expect_between(nearest, max(0.99, before), math.inf, then=then, unit="m")
    # The pushes of each frame are opposite but for rounding, some 1e-14 N.
    expect_close(momentum, ZERO, then="; the total momentum", unit="kg m/s", tolerance=1e-11)
