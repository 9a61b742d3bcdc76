"""A spring with a limit of elasticity, exercise 6.1."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import ElasticLimitSpring
from draw import positive_number, unit_vector, vector
from expect import expect_close, xyz
from unmoved import expect_kept

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.1 and the docstring of ElasticLimitSpring"


@pytest.mark.exercise("6.1", asks="it behaves like a Spring", read=READ)
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
        got, then = p.force_accumulator, "; p.force_accumulator"
        expect_close(got, wanted, slips, then=then, unit="N", tolerance=1e-12)
        cause = "You added a force to q as well. This spring acts only on the particle that is "
        cause += "passed to update_force."
        expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=cause)
    with calls(
        "The length is exactly the limit here, so the spring must still pull with its full "
        "stiffness. Apply share only to the part of the length beyond the limit."
    ):
        p, q = Particle(Vector3(4.0, 0.0, 0.0)), Particle()
        s = ElasticLimitSpring(q, stiffness=k, rest_length=2.0, limit=4.0, share=0.25)
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-2.0 * k, 0.0, 0.0), unit="N")


@pytest.mark.exercise("6.1", asks="increases the pull by only share times the stiffness", read=READ)
def test_a_spring_beyond_its_limit_is_softer(rng: Random) -> None:
    base, d = vector(rng), unit_vector(rng)
    k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
    limit = rest * 1.5
    for share in (0.25, 0.0, 1.0):
        beyond = positive_number(rng, 0.5, 5.0)
        length = limit + beyond
        place = base + length * d
        with calls(
            "Up to the limit the spring pulls with its full stiffness k, and beyond it with share "
            "* k. The pull is k (limit - rest_length) + share k (length - limit)."
        ):
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
        with calls(
            "The second call must add the same force again, because the spring has no memory. "
            "Don't store anything between calls.",
            more=True,
        ):
            s.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, 2.0 * wanted, unit="N", tolerance=1e-11)


@pytest.mark.exercise("6.1", asks="it has no direction, so its force is zero", read=READ)
def test_ends_at_the_same_position_get_no_elastic_force(rng: Random) -> None:
    place, f = vector(rng), vector(rng)
    with calls(
        "Both ends are at the same position, so the spring has no direction and adds no force. "
        "Leave the other forces on p alone."
    ):
        p, q = Particle(Vector3(*place)), Particle(Vector3(*place), mass=math.inf)
        p.add_force(Vector3(*f))
        s = ElasticLimitSpring(q, stiffness=5.0, rest_length=1.0, limit=2.0, share=0.5)
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, f, unit="N")
    with calls(
        "The check changes the attributes of s and moves q before this call, so the pull must be "
        "4 * 3 + 2 * 4 (4 - 3). Read the attributes in every call.",
        more=True,
    ):
        p.clear_forces()
        q.position = q.position - Vector3(4.0, 0.0, 0.0)
        s.limit, s.share, s.stiffness, s.rest_length = 3.0, 2.0, 4.0, 0.0
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (-20.0, 0.0, 0.0), unit="N", tolerance=1e-12)
