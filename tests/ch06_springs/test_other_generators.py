"""Generators of exercises 6.1, 6.3 and 6.4: a limit of elasticity, a crowd, a homing bullet."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import chased, crowded
from ch06_springs.springs import ElasticLimitSpring, HomingBullet, Overcrowding
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_between, expect_close, expect_unchanged, xyz
from unmoved import expect_kept

ZERO = Triple((0.0, 0.0, 0.0))
ELASTIC = "exercise 6.1 and the docstring of ElasticLimitSpring"
CROWD = "exercise 6.3 and the docstring of Overcrowding"
HOMING = "exercise 6.4 and the docstring of HomingBullet"
ALONE = "You added a force to q as well. Add it only to p, which is passed to update_force."


def expect_forces(
    p: Particle, wanted: Triple, slips: dict[str, Triple], q: Particle, cause: str, near: float
) -> None:
    """Expect a force on p, within a tolerance, and none on q."""
    __tracebackhide__ = True
    got, then = p.force_accumulator, "; p.force_accumulator"
    expect_close(got, wanted, slips, then=then, unit="N", cause=cause, tolerance=near)
    expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=ALONE)


@pytest.mark.exercise("6.1", asks="it behaves like a Spring", read=ELASTIC)
def test_up_to_its_limit_it_acts_like_any_spring(rng: Random) -> None:
    base, d = vector(rng), unit_vector(rng)
    k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
    for share, cause in (
        (1.9,
         "The spring is stretched, but not beyond its limit, so it must pull like any other "
         "spring. The size of the pull is the stiffness times the extension."),
        (0.5,
         "The spring is shorter than its rest length, so it must push like any other spring. The "
         "size of the push is the stiffness times the missing length."),
        (0.1,
         "The limit applies only to stretching. A compressed spring must push with its full "
         "stiffness, however short it is."),
    ):  # fmt: skip
        place, limit = base + share * rest * d, 1.95 * rest
        with calls(cause):
            p = Particle(Vector3(*place), Vector3(1.0, 2.0, 3.0), mass=3.0)
            q = Particle(Vector3(*base))
            s = ElasticLimitSpring(q, stiffness=k, rest_length=rest, limit=limit, share=0.25)
            s.update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), place)
        expect_kept("q.position", xyz(q.position), base)
        wanted = -k * (share - 1.0) * rest * d
        slips = {
            "You also add share times the whole extension. The part with share begins at the "
            "limit, and the spring is shorter than that here.": 1.25 * wanted,
            "You add no force to p.": ZERO,
            "The sign of your force is wrong, so the stretched spring pushes.": -wanted,
        }
        if share < 1.0:
            slips = {
                "Your compressed spring exerts no force.": ZERO,
                "Your extension is abs(length - rest_length), so a compressed spring pulls. "
                "Remove abs to keep the sign (E-3).": -wanted,
            }
        expect_forces(p, wanted, slips, q, cause, 1e-12)
    with calls("At exactly the limit, the pull is still the stiffness times the extension."):
        p, q = Particle(Vector3(4.0, 0.0, 0.0)), Particle()
        s = ElasticLimitSpring(q, stiffness=k, rest_length=2.0, limit=4.0, share=0.25)
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-2.0 * k, 0.0, 0.0), unit="N")


@pytest.mark.exercise(
    "6.1", asks="increases the pull by only share times the stiffness", read=ELASTIC
)
def test_a_spring_beyond_its_limit_is_softer(rng: Random) -> None:
    base, d = vector(rng), unit_vector(rng)
    k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
    limit = rest * 1.5
    for share in (0.25, 0.0, 1.0):
        beyond = positive_number(rng, 0.5, 5.0)
        length = limit + beyond
        place = base + length * d
        with calls("The pull is k (limit - rest_length) + share k (length - limit) here."):
            p, q = Particle(Vector3(*place), mass=3.0), Particle(Vector3(*base))
            s = ElasticLimitSpring(q, stiffness=k, rest_length=rest, limit=limit, share=share)
            s.update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), place)
        wanted = -k * (limit - rest + share * beyond) * d
        late = rest + limit  # the length of a limit that is counted from the rest length
        sizes = {
            "Your force stops growing at the limit.": limit - rest,
            "You multiply the whole extension by share. Apply share only to the part of the length "
            "beyond the limit.": share * (length - rest),
            "Your spring keeps its full stiffness beyond the limit.": length - rest,
            "Your pull includes only the part of the length beyond the limit.": share * beyond,
            "Beyond the limit, you use 1 - share.": limit - rest + (1.0 - share) * beyond,
            "You compare the limit with the extension, although it is a length.":
                min(length - rest, limit) + share * beyond,
            "You compare the limit with the extension. Compare it with the length of the spring "
            "instead.": min(length, late) - rest + share * max(length - late, 0.0),
        }  # fmt: skip
        slips = {slip: -k * size * d for slip, size in sizes.items()}
        got, then = p.force_accumulator, "; p.force_accumulator"
        expect_close(got, wanted, slips, then=then, unit="N", tolerance=1e-11)
        with calls("The second call must add the same force again. Don't store it.", more=True):
            s.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, 2.0 * wanted, unit="N", tolerance=1e-11)


@pytest.mark.exercise("6.1", asks="it has no direction, so its force is zero", read=ELASTIC)
def test_ends_at_the_same_position_get_no_elastic_force(rng: Random) -> None:
    place, f = vector(rng), vector(rng)
    with calls("The spring has no direction here, so add no force, and keep the others on p."):
        p, q = Particle(Vector3(*place)), Particle(Vector3(*place), mass=math.inf)
        p.add_force(Vector3(*f))
        s = ElasticLimitSpring(q, stiffness=5.0, rest_length=1.0, limit=2.0, share=0.5)
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, f, unit="N")
    with calls("The pull is now 4 * 3 + 8 (4 - 3). Read the attributes in every call.", more=True):
        p.clear_forces()
        q.position = q.position - Vector3(4.0, 0.0, 0.0)
        s.limit, s.share, s.stiffness, s.rest_length = 3.0, 2.0, 4.0, 0.0
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-20.0, 0.0, 0.0), unit="N", tolerance=1e-12)


@pytest.mark.exercise("6.3", asks="that particle pushes with the force k", read=CROWD)
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
        with calls("p is in the list too, at a distance of 0. Skip p before you divide."):
            p = Particle(Vector3(*here), Vector3(1.0, 2.0, 3.0), mass=2.0)
            q = Particle(Vector3(*there), Vector3(-3.0, 2.0, 1.0), mass=3.0)
            p.add_force(Vector3(*f))
            crowd = Overcrowding([p, q], distance=distance, stiffness=k)
            crowd.update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), here)
        expect_kept("q.position", xyz(q.position), there)
        push = k * distance * max(1.0 - share, 0.0)
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
        expect_forces(p, f - push * d, slips, q, cause, 1e-11)


@pytest.mark.exercise("6.3", asks="from every other particle that is too close", read=CROWD)
def test_all_particles_that_are_too_near_push(rng: Random) -> None:
    here, k = vector(rng), positive_number(rng)
    with calls("Three of the other four particles are closer than 3 m. Add up their pushes."):
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
    with calls("Only one is closer than 1.25 m now. Read the attributes in every call.", more=True):
        p.clear_forces()
        crowd.particles.pop()
        crowd.distance, crowd.stiffness = 1.25, 2.0 * k
        crowd.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-0.5 * k, 0.0, 0.0), tolerance=1e-12, unit="N")


@pytest.mark.exercise("6.3", asks="exactly the same position does not push", read=CROWD)
def test_particles_at_the_same_position_do_not_push(rng: Random) -> None:
    here = vector(rng)
    with calls("A push between p and q has no direction. Skip q, so that only r pushes p down."):
        p, q = Particle(Vector3(*here)), Particle(Vector3(*here))
        r = Particle(p.position + Vector3(0.0, 1.0, 0.0), mass=math.inf)
        crowd = Overcrowding([r, p, q], distance=3.0, stiffness=5.0)
        crowd.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, -10.0, 0.0), tolerance=1e-12, unit="N")
    cause = "The list belongs to the caller. Don't change it, and don't move its particles."
    got = [part for one in crowd.particles for part in xyz(one.position)]
    wanted = [*(here + Triple((0.0, 1.0, 0.0))), *here, *here]
    then = "; the positions in crowd.particles, which is [r, p, q]"
    expect_close(got, wanted, then=then, cause=cause, tolerance=1e-12)
    with calls("p is not in the list, but q must push it, because they are not quite together."):
        p, q = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
        Overcrowding([q], distance=3.0, stiffness=5.0).update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, 15.0, 0.0), tolerance=1e-7, unit="N")


@pytest.mark.exercise("6.3", asks="too close therefore push each other apart", read=CROWD)
def test_a_crowd_moves_apart_and_keeps_its_momentum(rng: Random) -> None:
    places = [0.1 * vector(rng) for _ in range(6)]
    places[1] = 0.9 * places[0]  # two are too near, wherever the others are
    with calls(
        "At the end no two may be closer than 1 m, and the total momentum must still be zero.",
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


@pytest.mark.exercise(
    "6.4", asks="the future position of the bullet to the future position", read=HOMING
)
def test_it_aims_at_the_predicted_position(rng: Random) -> None:
    here, v, there, w, f = vector(rng), vector(rng), vector(rng), vector(rng), vector(rng)
    k, ahead = positive_number(rng), positive_number(rng)
    down = Triple((0.0, -9.0, 0.0))
    for time in (0.0, ahead):
        cause = "The force is the stiffness times the vector from where p will be after look_ahead "
        cause += "seconds to where q will be. Assume that both keep their velocities until then."
        with calls(cause):
            p = Particle(Vector3(*here), Vector3(*v), Vector3(*down), mass=3.0, damping=0.5)
            q = Particle(Vector3(*there), Vector3(*w), Vector3(*(2 * down)), mass=5.0, damping=0.7)
            p.add_force(Vector3(*f))
            HomingBullet(target=q, stiffness=k, look_ahead=time).update_force(p, 0.5)
        now, closing = there - here, w - v
        way = now + closing * time
        pulls = {
            "Your force pushes the bullet away from its target.": -k * way,
            "You left out the stiffness.": way,
            "You normalized the vector, so the size of your force is always the stiffness.":
                k * way / abs(way),
            "Your force uses the current positions of the bullet and the target.": k * now,
            "Your prediction leaves out the bullet's own velocity.": k * (now + w * time),
            "Your prediction leaves out the target's velocity.": k * (now - v * time),
            "Your prediction has the wrong sign, so it looks back.": k * (now - closing * time),
            "You add the velocities of the two.": k * (now + (w + v) * time),
            "Your vector is the target's position alone, as if the bullet were at (0, 0, 0).":
                k * (there + w * time),
            "You multiply the force by the bullet's mass.": 3.0 * k * way,
            "Your prediction includes the accelerations.": k * (way + 0.5 * time**2 * down),
            "Your prediction looks ahead by 0.5 s, the duration of the step.":
                k * (now + closing * 0.5),
        }  # fmt: skip
        slips = {slip: f + pull for slip, pull in pulls.items()}
        # A few roundings of numbers up to 2000.
        expect_forces(p, f + k * way, slips, q, cause, 1e-11)


@pytest.mark.exercise("6.4", asks="and changes nothing else", read=HOMING)
def test_bullet_and_target_are_not_moved(rng: Random) -> None:
    here, v, there, w = vector(rng), vector(rng), vector(rng), vector(rng)
    with calls("Read the positions and the velocities, but don't change them."):
        p, q = Particle(Vector3(*here), Vector3(*v)), Particle(Vector3(*there), Vector3(*w))
        b = HomingBullet(target=q, stiffness=2.0, look_ahead=3.0)
        b.update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, here),
        ("p.velocity", p.velocity, v),
        ("q.position", q.position, there),
        ("q.velocity", q.velocity, w),
    ):
        changed = f"You changed {name}. add_scaled, += and *= work in place, so use + and *, which "
        expect_unchanged(name, now, before, cause=f"{changed}create new vectors.")
    with calls("Read the stiffness, look_ahead and the velocities in every call.", more=True):
        p.clear_forces()
        b.stiffness, b.look_ahead, q.velocity = 4.0, 1.0, Vector3(*v)
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 4.0 * (there - here), unit="N", tolerance=1e-11)
    with calls("Read self.target in every call. It may also be immovable.", more=True):
        p.clear_forces()
        b.target = Particle(Vector3(*w), mass=math.inf)
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 4.0 * (w - here - v), unit="N", tolerance=1e-11)


@pytest.mark.exercise("6.4", asks="steers a bullet toward the future position", read=HOMING)
def test_it_catches_a_target_that_flies_straight_on(rng: Random) -> None:
    start, w = vector(rng), vector(rng)
    with calls(
        "The bullet must reach the target and stay with it. Use the velocities of both.",
        f"p at rest at (0, 0, 0); q at {start} with velocity {w}; 20 s of HomingBullet(target=q, "
        "stiffness=4.0, look_ahead=1.0) in steps of 1/240 s; distance between p and q",
    ):
        distances = chased(start, w, 4.0, 1.0)
    expect_close(distances[-1], 0.0, then=" at the end", tolerance=1e-6, unit="m")
    # Critically damped, c = k T = 4 and c^2 = 4 k m, from rest: after t s (1 + 2 t) e^-2t of the
    # way is left, and w t e^-2t of the velocity's. Of first order, the step is 0.02 off at most.
    wanted = abs(3.0 * start + w) * math.exp(-2.0)
    expect_close(distances[240], wanted, then=" after 1 s", tolerance=0.05, unit="m")
