"""Springs with two ends, build task B6.1: the force, and the particle that it acts on."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import swinging
from ch06_springs.springs import AnchoredSpring, Spring, spring_force
from draw import components, direction, positive_number
from expect import about, blame, expect_close, expect_unchanged, expect_vector, named, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 6.2.1, Eq. 6.1 and 6.2, and the docstring of spring_force"


def hooke(
    offset: tuple[float, ...], velocity: tuple[float, ...], k: float, rest: float, c: float
) -> tuple[float, ...]:
    length = math.hypot(*offset)
    rate = sum(o * v for o, v in zip(offset, velocity, strict=True)) / length
    size = -(k * (length - rest) + c * rate) / length
    return tuple(size * o for o in offset)


def spring_slips(
    offset: tuple[float, ...], velocity: tuple[float, ...], k: float, rest: float, c: float
) -> dict[str, list[float]]:
    """Return the force of hooke after each likely mistake, keyed by its explanation."""
    length = math.hypot(*offset)
    d = [part / length for part in offset]
    rate = sum(part * v for part, v in zip(d, velocity, strict=True))
    pull = k * (length - rest)

    def along(size: float) -> list[float]:
        return [size * part for part in d]

    return {
        "Your extension is abs(l - l0), so a compressed spring pulls. Remove abs (E-3), because a "
        "compressed spring pushes this end away, along the offset.": along(-abs(pull) - c * rate),
        "Your damping pushes in the direction of the motion, so the spring would swing wider and "
        "wider. It has to oppose the motion, so check its sign.": along(c * rate - pull),
        "The force points along the offset, so a stretched spring would push its end even farther "
        "away. Perhaps you left out the minus sign.": along(pull + c * rate),
        "Your force is -k l d^, as if the rest length were 0. Only the extension counts, so "
        "subtract the rest length from the length.": along(-k * length - c * rate),
        "You multiplied the force by the whole offset, so a long spring is too strong. The offset "
        "only gives the direction, so normalize it first.": along(-(pull + c * rate) * length),
        "You used the squared length of the offset. The extension needs the length itself, so take "
        "the magnitude.": along(-k * (length**2 - rest) - c * rate),
        "You left out the damping force. Add -c (v . d^) d^ along the spring.": along(-pull),
        "There is no force, as if this were a slack rope. Unlike a rope, a spring pushes when it "
        "is shorter than its rest length.": along(0.0 * pull),
        "Your damping is -c v, which also slows down motion across the spring, although that "
        "doesn't change its length. Use only the part of v along the spring.": [
            a - c * v for a, v in zip(along(-pull), velocity, strict=True)
        ],
        "Your damping uses the speed |v|, which is positive even while the spring gets shorter. "
        "Use v . d^, the rate at which the length changes.": along(
            -pull - c * math.hypot(*velocity)
        ),
        "Your damping uses v . offset, which grows with the length of the spring. Normalize the "
        "offset first.": along(-pull - c * rate * length),
    }


@pytest.mark.exercise("B6.1")
def test_a_stretched_spring_pulls_and_a_compressed_one_pushes(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    pulls = (
        "A spring that is longer than its rest length pulls this end back, against the offset. "
        "Check the sign and the size of the extension."
    )
    pushes = (
        "A spring that is shorter than its rest length pushes this end away, along the offset. Its "
        "extension is negative, so don't take the absolute value."
    )
    for share, cause in ((1.5, pulls), (0.5, pushes), (1e-3, pushes)):
        about.cause = cause
        offset = tuple(share * rest * part for part in d)
        about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, {rest})"
        wanted = hooke(offset, ZERO, k, rest, 0.0)
        got = expect_vector(spring_force(Vector3(*offset), Vector3(), k, rest))
        blame(got, spring_slips(offset, ZERO, k, rest, 0.0))
        # A few roundings of numbers up to 60.
        expect_close(got, wanted, tolerance=1e-12)
    about.call = "spring_force(Vector3(1, 0, 0), Vector3(), 10, 2)"
    about.cause = "The length is 1 m and the rest length 2 m, so the spring pushes with 10 N. The "
    about.cause += "printed formula gives a pull (E-3)."
    got = xyz(spring_force(Vector3(1.0, 0.0, 0.0), Vector3(), 10.0, 2.0))
    expect_close(got, (10.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1")
def test_damping_acts_along_the_spring_alone(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 1.0, 5.0), positive_number(rng)
    about.cause = (
        "The damping force is -c (v . d^) d^, where d^ is the unit vector along the spring. It "
        "depends only on the part of the velocity along the spring."
    )
    for v, stiffness in ((velocity, 0.0), (velocity, k)):
        about.call = f"spring_force(Vector3{offset}, Vector3{v}, {stiffness}, {rest}, {c})"
        got = xyz(spring_force(Vector3(*offset), Vector3(*v), stiffness, rest, c))
        wanted = hooke(offset, v, stiffness, rest, c)
        why = named(got, about.cause, spring_slips(offset, v, stiffness, rest, c))
        # A few roundings of numbers up to 300.
        expect_close(got, wanted, cause=why, tolerance=1e-11)
    across = (-offset[1], offset[0], 0.0)
    about.call = f"spring_force(Vector3{offset}, Vector3{across}, 0.0, {rest}, {c})"
    about.cause = (
        "The end moves at a right angle to the spring here, so the length doesn't change and there "
        "is nothing to damp. Use only the part of v along the spring."
    )
    got = xyz(spring_force(Vector3(*offset), Vector3(*across), 0.0, rest, c))
    expect_close(got, ZERO, tolerance=1e-11)
    about.call = "spring_force(Vector3(0, 2, 0), Vector3(0, 3, 0), 0.0, 2.0, 5.0)"
    about.cause = (
        "The end moves away along the spring at 3 m/s, so a damping of 5 N s/m pulls it back "
        "with 15 N. Check the sign of the damping."
    )
    got = xyz(spring_force(Vector3(0.0, 2.0, 0.0), Vector3(0.0, 3.0, 0.0), 0.0, 2.0, 5.0))
    expect_close(got, (0.0, -15.0, 0.0))
    about.cause = (
        "A compressed spring is damped like a stretched one, even if the damping outweighs the "
        "push. Don't clamp the force in either direction."
    )
    for speed, wanted in ((-5.0, 25.0), (5.0, -5.0)):
        about.call = f"spring_force(Vector3(0, 1, 0), Vector3(0, {speed}, 0), 10, 2, 3)"
        got = xyz(spring_force(Vector3(0.0, 1.0, 0.0), Vector3(0.0, speed, 0.0), 10.0, 2.0, 3.0))
        expect_close(got, (0.0, wanted, 0.0))


@pytest.mark.exercise("B6.1")
def test_ends_at_one_place_have_no_direction(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"spring_force(Vector3(), Vector3{v}, 100.0, 2.0, 3.0)"
    about.cause = (
        "Both ends are at the same position, so the spring has no direction and exerts no force. "
        "normalized() returns a zero vector in that case, so the formula works as is."
    )
    got = xyz(spring_force(Vector3(), Vector3(*v), 100.0, 2.0, 3.0))
    expect_close(got, ZERO)
    about.call = "spring_force(Vector3(0, 1e-9, 0), Vector3(), 100.0, 2.0)"
    about.cause = (
        "The two ends are very close but not at the same position, so the spring still has a "
        "direction. It pushes with almost k l0, which is 200 N here."
    )
    got = xyz(spring_force(Vector3(0.0, 1e-9, 0.0), Vector3(), 100.0, 2.0))
    expect_close(got, (0.0, 200.0 - 1e-7, 0.0), tolerance=1e-10)
    about.call = f"p at the anchor with velocity {v}; AnchoredSpring(Vector3{v}, 100.0, 2.0, "
    about.call += "3.0).update_force(p, 0.5); p.force_accumulator"
    p = Particle(Vector3(*v), Vector3(*v))
    AnchoredSpring(Vector3(*v), 100.0, 2.0, 3.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    about.cause = (
        "The offset is p.position minus the anchor. It is zero here, so there is no direction "
        "and no force."
    )
    slips = {
        "Your spring behaves as if its other end were at (0, 0, 0). Subtract self.anchor from the "
        "position to get the offset.": hooke(v, v, 100.0, 2.0, 3.0)
    }
    expect_close(got, ZERO, cause=named(got, about.cause, slips))
    about.call = "spring_force(Vector3(2, 0, 0), Vector3(), 100.0, 1.0)"
    about.cause = (
        "The ends are 2 m apart here, so the spring has a direction and pulls with 100 N. The "
        "force vanishes only if both ends are at exactly the same position."
    )
    got = xyz(spring_force(Vector3(2.0, 0.0, 0.0), Vector3(), 100.0, 1.0))
    expect_close(got, (-100.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1")
def test_the_vectors_of_a_spring_are_only_read(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    about.call = f"o, v = Vector3{offset}, Vector3{velocity}; spring_force(o, v, 3.0, 1.0, 2.0)"
    about.cause = (
        "Don't change the two vectors that are passed in. normalize and *= work in place, so use "
        "normalized and *, which return new vectors."
    )
    o, v = Vector3(*offset), Vector3(*velocity)
    force = spring_force(o, v, 3.0, 1.0, 2.0)
    expect_unchanged("o", xyz(o), offset)
    expect_unchanged("v", xyz(v), velocity)
    wanted = hooke(offset, velocity, 3.0, 1.0, 2.0)
    about.cause = (
        "The vectors are unchanged, but the force is wrong. It must be -(k (l - l0) + c l') d^, "
        "where l' is the rate at which the length grows."
    )
    expect_close(xyz(force), wanted, tolerance=1e-11)
    about.call = f"p at {offset}, velocity {velocity}; q at {velocity}, velocity {offset}; "
    about.call += "Spring(q, 3.0, 1.0, 2.0).update_force(p, 0.5)"
    about.cause = (
        "The spring must not change any position or velocity. -= and normalize work in place, so "
        "use - and normalized, which return new vectors."
    )
    p = Particle(Vector3(*offset), Vector3(*velocity))
    q = Particle(Vector3(*velocity), Vector3(*offset))
    Spring(q, 3.0, 1.0, 2.0).update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, offset),
        ("p.velocity", p.velocity, velocity),
        ("q.position", q.position, velocity),
        ("q.velocity", q.velocity, offset),
    ):
        expect_unchanged(name, xyz(now), before)
    about.read = "the docstring of AnchoredSpring"
    about.call = f"spring = AnchoredSpring(Vector3{offset}, 3.0, 1.0); p at {velocity}; "
    about.call += "spring.update_force(p, 0.5)"
    p, spring = Particle(Vector3(*velocity)), AnchoredSpring(Vector3(*offset), 3.0, 1.0)
    spring.update_force(p, 0.5)
    expect_unchanged("spring.anchor", xyz(spring.anchor), offset)
    expect_unchanged("p.position", xyz(p.position), velocity)
    about.call = "o = Vector3(); f = spring_force(o, Vector3(), 3.0, 1.0); f.x = 99.0"
    about.cause = (
        "Perhaps you returned one of the vectors that were passed in, so changing the result also "
        "changes the caller's vector. Return a new vector, even if the offset has no direction."
    )
    o = Vector3()
    f = spring_force(o, Vector3(), 3.0, 1.0)
    f.x = 99.0
    expect_unchanged("o", xyz(o), ZERO)


@pytest.mark.exercise("B6.1")
def test_a_spring_acts_on_the_particle_it_is_asked_for(rng: Random) -> None:
    about.read = "book 6.2.1 and the docstring of Spring"
    here, there, v, w, f = (components(rng) for _ in range(5))
    k, c = positive_number(rng), positive_number(rng)
    rest = round(2.0 * math.dist(here, there), 3)  # compressed here, and stretched below
    about.call = f"p at {here}, velocity {v}; q at {there}, velocity {w}; p.add_force(Vector3{f}); "
    about.call += f"p has 2 kg, q 3 kg; s = Spring(q, {k}, {rest}, {c}); s.update_force(p, 0.5)"
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    q = Particle(Vector3(*there), Vector3(*w), mass=3.0)
    p.add_force(Vector3(*f))
    about.cause = (
        "Subtract the other particle's position and velocity from p's, and add the force to p. The "
        "force depends only on the spring's length and how fast it changes, not on any mass."
    )
    s = Spring(q, k, rest, c)
    s.update_force(p, 0.5)
    offset = tuple(a - b for a, b in zip(here, there, strict=True))
    relative = tuple(a - b for a, b in zip(v, w, strict=True))
    pull = hooke(offset, relative, k, rest, c)
    wanted = tuple(a + b for a, b in zip(f, pull, strict=True))
    got = xyz(p.force_accumulator)
    back = tuple(-part for part in offset)
    forces = {
        "Your offset is q - p, so the force on p points the wrong way. Subtract the other "
        "particle's position from p's instead.": hooke(back, relative, k, rest, c),
        "Your velocity is q's minus p's, so the damping has the wrong sign. Subtract the other "
        "particle's velocity from p's instead.": hooke(
            offset, tuple(-part for part in relative), k, rest, c
        ),
        "Your damping uses p's velocity alone, but q's motion changes the length too. Subtract q's "
        "position and velocity from p's.": hooke(offset, v, k, rest, c),
        "You left out the damping force. Add -c (v . d^) d^ along the spring.": hooke(
            offset, relative, k, rest, 0.0
        ),
        "The force points the wrong way. Check its sign and the order in which you subtract the "
        "two positions.": tuple(-part for part in pull),
        "You divided the force by p's mass. The integrator does that later, so add the force "
        "itself.": tuple(part / 2.0 for part in pull),
        "You divided the force by q's mass. A spring's force doesn't depend on any mass, so leave "
        "the masses out.": tuple(part / 3.0 for part in pull),
        "There is no force on p, although p is the particle that was passed in. Pass the spring's "
        "force to particle.add_force.": ZERO,
    }
    slips = {name: [a + b for a, b in zip(f, force, strict=True)] for name, force in forces.items()}
    slips[
        "The force that was already on p is gone. Call add_force, which adds to the existing force "
        "instead of replacing it."
    ] = [*pull]
    blame(got, slips)
    # A few roundings of numbers up to 600.
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)
    about.cause = (
        "You added a force to q as well. A Spring acts only on the particle that is passed in; q "
        "needs a Spring of its own."
    )
    expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator")
    about.call = "s = Spring(q, 1, 1, 1) has acted; s.stiffness, s.rest_length, s.damping = 5, 2, "
    about.call += "3; p at (0, 3, 0), velocity (0, 1, 0), q at rest at (0, 0, 0); "
    about.call += "s.update_force(p, 0.5)"
    about.cause = (
        "The check changed the attributes after it created the spring, so the force is now -(5 (3 "
        "- 2) + 3 * 1). Read the attributes on every call."
    )
    s.stiffness, s.rest_length, s.damping = 5.0, 2.0, 3.0
    p, q.position, q.velocity = Particle(Vector3(0, 3, 0), Vector3(0, 1, 0)), Vector3(), Vector3()
    s.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -8.0, 0.0), then="; p.force_accumulator")


@pytest.mark.exercise("B6.1")
def test_an_anchor_may_be_moved(rng: Random) -> None:
    about.read = "book 6.2.2 and the docstring of AnchoredSpring"
    here, v = components(rng), components(rng)
    first, second = components(rng), components(rng)
    # The spring is stretched at the first anchor and compressed at the second.
    rest, longer = round(0.5 * math.dist(here, first), 3), round(2.0 * math.dist(here, second), 3)
    k, c = positive_number(rng), positive_number(rng)
    about.call = f"p at {here}, velocity {v}; s = AnchoredSpring(Vector3{first}, {k}, {rest}, "
    about.call += f"{c}); "
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    s = AnchoredSpring(Vector3(*first), k, rest, c)
    about.call += "s.update_force(p, 0.5)"
    about.cause = (
        "The offset is p.position minus the anchor, and because the anchor is at rest, the "
        "relative velocity is simply p.velocity. The mass has no effect on a spring's force."
    )
    s.update_force(p, 0.5)
    offset = tuple(a - b for a, b in zip(here, first, strict=True))
    wanted = hooke(offset, v, k, rest, c)
    got = xyz(p.force_accumulator)
    slips = {
        "Your offset is anchor - position, so the force points the wrong way. Use position - "
        "anchor instead.": hooke(tuple(-part for part in offset), v, k, rest, c),
        "You left out the damping force. Add -c (v . d^) d^ along the spring.": hooke(
            offset, v, k, rest, 0.0
        ),
        "Your force uses a rest length of 0. Pass self.rest_length on, so that only the extension "
        "counts.": hooke(offset, v, k, 0.0, c),
        "Your spring behaves as if its other end were at (0, 0, 0). Subtract self.anchor from the "
        "position to get the offset.": hooke(here, v, k, rest, c),
        "The force points the wrong way. Check its sign and the order in which you subtract the "
        "two positions.": tuple(-part for part in wanted),
    }
    blame(got, slips)
    expect_close(got, wanted, tolerance=1e-11)
    about.call += f"; p.clear_forces(); s.anchor = Vector3{second}; s.stiffness, s.rest_length, "
    about.call += f"s.damping = {2 * k}, {longer}, {4 * c}; s.update_force(p, 0.5)"
    about.cause = (
        "The check changed the anchor and the other attributes after it created the spring. Read "
        "them on every call instead of caching a result."
    )
    p.clear_forces()
    s.anchor, s.stiffness, s.rest_length, s.damping = Vector3(*second), 2 * k, longer, 4 * c
    s.update_force(p, 0.5)
    offset = tuple(a - b for a, b in zip(here, second, strict=True))
    wanted = hooke(offset, v, 2.0 * k, longer, 4.0 * c)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B6.1")
def test_a_particle_between_two_springs_swings_with_its_period() -> None:
    about.read = "book 6.3.2, Eq. 6.3"
    about.call = "p of 2 kg, AnchoredSpring(Vector3(), 50, 0), released 0.5 m away; "
    about.call += "spring.update_force(p, h), p.integrate(h) in steps of 1/1000 s, to the third "
    about.call += "return"
    about.cause = (
        "The period should be 2 pi sqrt(m / k), which is 2 pi / 5 s here, in every direction. "
        "Check that the force is proportional to the distance from the anchor."
    )
    for axis in range(3):
        start = [0.0, 0.0, 0.0]
        start[axis] = 0.5
        period = swinging((start[0], start[1], start[2]), 50.0, 2.0, 1.0 / 1000.0, 3000)
        # Explicit Euler has a relative error of k h^2 / m / 3 in the period, about 8e-6, and a
        # crossing lies between two steps.
        wanted = 2.0 * math.pi / 5.0
        expect_close(period, wanted, then=": period", tolerance=1e-4)


@pytest.mark.exercise("B6.1")
def test_a_spring_of_its_length_at_rest_does_nothing(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    offset = tuple(rest * part for part in d)
    about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, {rest})"
    about.cause = (
        "At its rest length the spring has no extension, so k (l - l0) is 0 and there is no force."
    )
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, rest))
    expect_close(got, ZERO, tolerance=1e-13)
    about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, 0.0)"
    about.cause = (
        "With a rest length of 0 the extension is the whole length, so the force is -k times the "
        "offset."
    )
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, 0.0))
    wanted = tuple(-k * part for part in offset)
    expect_close(got, wanted)
