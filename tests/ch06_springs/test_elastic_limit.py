"""A spring with a limit of elasticity, exercise 6.1."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import ElasticLimitSpring
from draw import components, direction, positive_number
from expect import about, blame, expect_close, xyz
from unmoved import expect_kept

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.1 and the docstring of ElasticLimitSpring"


@pytest.mark.exercise("6.1", asks="it behaves like a Spring")
def test_up_to_its_limit_it_acts_like_any_spring(rng: Random) -> None:
    about.read = READ
    base, d = components(rng), direction(rng)
    k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
    for share, cause in (
        (
            1.9,
            "The spring is stretched, but not beyond its limit, so it must pull like any other "
            "spring. The size of the pull is the stiffness times the extension.",
        ),
        (
            0.5,
            "The spring is shorter than its rest length, so it must push like any other "
            "spring. The size of the push is the stiffness times the missing length.",
        ),
        (
            0.1,
            "The limit applies only to stretching. A compressed spring must push with its "
            "full stiffness, however short it is.",
        ),
    ):
        about.cause = cause
        place = tuple(b + share * rest * part for b, part in zip(base, d, strict=True))
        about.call = f"p at {place}; q at {base}, {share * rest:.5g} m from p; "
        about.call += f"s = ElasticLimitSpring(q, stiffness={k}, rest_length={rest}, "
        about.call += f"limit={1.95 * rest:.6g}, share=0.25); s.update_force(p, 0.5)"
        p, q = Particle(Vector3(*place), Vector3(1.0, 2.0, 3.0), mass=3.0), Particle(Vector3(*base))
        ElasticLimitSpring(q, k, rest, 1.95 * rest, 0.25).update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), place)
        expect_kept("q.position", xyz(q.position), base)
        wanted = tuple(-k * (share - 1.0) * rest * part for part in d)
        got = xyz(p.force_accumulator)
        opposite = [-part for part in wanted]
        whole = "You also add share times the whole extension. The part with share begins at the "
        whole += "limit, and the spring is shorter than that here."
        slips = {
            whole: [1.25 * part for part in wanted],
            "You add no force to p. Up to its limit, the spring must act like any other spring.": (
                ZERO
            ),
            "The sign of your force is wrong, so the stretched spring pushes. It must pull p "
            "toward q.": opposite,
        }
        if share < 1.0:
            slips = {
                "Your compressed spring exerts no force. It must push like any other spring if it "
                "is shorter than its rest length.": ZERO,
                "Your extension is abs(length - rest_length), so a compressed spring pulls. "
                "Remove abs to keep the sign (E-3).": opposite,
            }
        blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-12)
        about.cause = (
            "You added a force to q as well. This spring acts only on the particle that is passed "
            "to update_force."
        )
        expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator, in N")
    about.call = f"p at (4, 0, 0), q at (0, 0, 0); ElasticLimitSpring(q, {k}, 2, 4, "
    about.call += "0.25).update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = (
        "The length is exactly the limit here, so the spring must still pull with its full "
        "stiffness. Apply share only to the part of the length beyond the limit."
    )
    p, q = Particle(Vector3(4.0, 0.0, 0.0)), Particle()
    ElasticLimitSpring(q, k, 2.0, 4.0, 0.25).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (-2.0 * k, 0.0, 0.0))


@pytest.mark.exercise("6.1", asks="increases the pull by only share times the stiffness")
def test_a_spring_beyond_its_limit_is_softer(rng: Random) -> None:
    about.read = READ
    base, d = components(rng), direction(rng)
    k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
    limit = rest * 1.5
    for share in (0.25, 0.0, 1.0):
        beyond = positive_number(rng, 0.5, 5.0)
        length = limit + beyond
        place = tuple(b + length * part for b, part in zip(base, d, strict=True))
        about.call = f"p at {place}; q at {base}, {length:.5g} m from p; s = "
        about.call += f"ElasticLimitSpring(q, stiffness={k}, rest_length={rest}, "
        about.call += f"limit={limit:.6g}, share={share}); s.update_force(p, 0.5)"
        about.cause = (
            "Up to the limit the spring pulls with its full stiffness k, and beyond it with share "
            "* k. The pull is k (limit - rest_length) + share k (length - limit)."
        )
        p, q = Particle(Vector3(*place), mass=3.0), Particle(Vector3(*base))
        spring = ElasticLimitSpring(q, k, rest, limit, share)
        spring.update_force(p, 0.5)
        expect_kept("p.position", xyz(p.position), place)
        wanted = tuple(-k * (limit - rest + share * beyond) * part for part in d)
        late = rest + limit  # the length of a limit that is counted from the rest length
        sizes = {
            (
                "Your force stops growing at the limit. Beyond the limit, add share * stiffness * "
                "(length - limit) to the force."
            ): limit - rest,
            (
                "You multiply the whole extension by share. Apply share only to the part of "
                "the length beyond the limit."
            ): share * (length - rest),
            "Your spring keeps its full stiffness beyond the limit. Use share * stiffness for the "
            "part of the length that is beyond the limit.": length - rest,
            "Your pull includes only the part of the length beyond the limit. Add the pull up to "
            "the limit, which is stiffness * (limit - rest_length).": share * beyond,
            "Beyond the limit, you use 1 - share instead of share. The additional stiffness is "
            "share * stiffness.": limit - rest + (1.0 - share) * beyond,
            "You compare the limit with the extension, although it is a length. Compare it with "
            "the length of the spring.": min(length - rest, limit) + share * beyond,
            "You compare the limit with the extension. Compare it with the length of the "
            "spring instead.": (min(length, late) - rest + share * max(length - late, 0.0)),
        }
        got = xyz(p.force_accumulator)
        slips = {slip: [-k * size * part for part in d] for slip, size in sizes.items()}
        blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
        about.cause = (
            "The second call must add the same force again, because the spring has no memory. "
            "Don't store anything between calls."
        )
        spring.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        twice = tuple(2.0 * part for part in wanted)
        then = "; s.update_force(p, 0.5); p.force_accumulator, in N"
        expect_close(got, twice, then=then, tolerance=1e-11)


@pytest.mark.exercise("6.1", asks="it has no direction, so its force is zero")
def test_ends_at_the_same_position_get_no_elastic_force(rng: Random) -> None:
    about.read = READ
    place, f = components(rng), components(rng)
    about.call = f"p and q at {place}; p.add_force(Vector3{f}); s = ElasticLimitSpring(q, 5.0, "
    about.call += "1.0, 2.0, 0.5); s.update_force(p, 0.5)"
    about.cause = (
        "Both ends are at the same position, so the spring has no direction and adds no force. "
        "Leave the other forces on p alone."
    )
    p, q = Particle(Vector3(*place)), Particle(Vector3(*place), mass=math.inf)
    p.add_force(Vector3(*f))
    s = ElasticLimitSpring(q, 5.0, 1.0, 2.0, 0.5)
    s.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), f, then="; p.force_accumulator, in N")
    about.call += "; p.clear_forces(); q.position = q.position - Vector3(4, 0, 0); s.limit = 3.0; "
    about.call += "s.share = 2.0; s.stiffness = 4.0; s.rest_length = 0.0; s.update_force(p, 0.5)"
    about.cause = (
        "The check changes the attributes of s and moves q before this call, so the pull must be "
        "4 * 3 + 2 * 4 (4 - 3). Read the attributes in every call."
    )
    p.clear_forces()
    q.position = q.position - Vector3(4.0, 0.0, 0.0)
    s.limit, s.share, s.stiffness, s.rest_length = 3.0, 2.0, 4.0, 0.0
    s.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (-20.0, 0.0, 0.0), then="; p.force_accumulator, in N", tolerance=1e-12)
