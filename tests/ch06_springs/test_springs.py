"""Springs, build task B6.1: the force."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring, Spring, spring_force
from draw import components, direction, positive_number
from expect import about, blame, expect_close, expect_unchanged, expect_vector, named, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 6.1 and 6.2.1, Eq. 6.1 and 6.2, and the docstring of spring_force"


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
        "Your extension is abs(length - rest_length), as in the book's listing (E-3), so a "
        "compressed spring pulls. Remove abs, so that it pushes.": along(-abs(pull) - c * rate),
        "Your damping has the wrong sign, so it acts in the direction of the motion. It must "
        "oppose the motion.": along(c * rate - pull),
        "Your force has the wrong sign, so a stretched spring pushes. It must pull, in the "
        "direction opposite to the offset.": along(pull + c * rate),
        "Your force is the stiffness times the whole length. Only the extension counts, so "
        "subtract the rest length from the length.": along(-k * length - c * rate),
        "You use the length of the unit vector, which is always 1. Compute the length of the "
        "offset before you normalize it.": along(-k * (1.0 - rest) - c * rate),
        "You multiply the force by the whole offset instead of its direction. Normalize the "
        "offset first.": along(-(pull + c * rate) * length),
        "You use the squared length of the offset. The extension needs the length itself, so "
        "use magnitude().": along(-k * (length**2 - rest) - c * rate),
        "Your force uses only half of the stiffness. The factor 1/2 belongs to the energy of a "
        "spring, not to its force.": along(-0.5 * pull - c * rate),
        "You left out the damping. Add a force along the spring: the damping times the rate at "
        "which the length changes.": along(-pull),
        "Your spring exerts no force here, like a slack rope. Unlike a rope, a spring must push "
        "when it is shorter than its rest length.": along(0.0 * pull),
        "Your damping is -c v, which also slows down motion across the spring. Use only the "
        "component of the velocity v along the spring.": [
            a - c * v for a, v in zip(along(-pull), velocity, strict=True)
        ],
        "Your damping uses the speed |v|, which is never negative. Use the component of v along "
        "the spring, which is negative while the spring gets shorter.": along(
            -pull - c * math.hypot(*velocity)
        ),
        "Your damping uses the dot product of v and the whole offset, which grows with the "
        "length of the spring. Normalize the offset first.": along(-pull - c * rate * length),
    }


@pytest.mark.exercise("B6.1", asks="a stretched spring pulls this end back")
def test_a_stretched_spring_pulls_and_a_compressed_one_pushes(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    pulls = "The spring is longer than its rest length, so it must pull this end back, opposite "
    pulls += "to the offset. Check the sign and the size of the extension."
    pushes = "The spring is shorter than its rest length, so it must push this end away, along "
    pushes += "the offset. Its extension is negative, so don't take the absolute value."
    for share, cause in ((1.5, pulls), (0.5, pushes), (1e-3, pushes)):
        about.cause = cause
        offset = tuple(share * rest * part for part in d)
        about.call = f"offset = Vector3{offset}, which is {share * rest:.4g} m long; "
        about.call += f"spring_force(offset, Vector3(), stiffness={k}, rest_length={rest}), in N"
        wanted = hooke(offset, ZERO, k, rest, 0.0)
        got = expect_vector(spring_force(Vector3(*offset), Vector3(), k, rest))
        blame(got, spring_slips(offset, ZERO, k, rest, 0.0))
        # A few roundings of numbers up to 60.
        expect_close(got, wanted, tolerance=1e-12)
    about.call = "spring_force(offset=Vector3(1, 0, 0), velocity=Vector3(), stiffness=10, "
    about.call += "rest_length=2), in N"
    about.cause = "The spring is 1 m long and its rest length is 2 m, so it must push with 10 N. "
    about.cause += "The formula in the book's listing pulls instead (E-3)."
    got = xyz(spring_force(Vector3(1.0, 0.0, 0.0), Vector3(), 10.0, 2.0))
    expect_close(got, (10.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1", asks="the component of velocity along d^")
def test_damping_acts_only_along_the_spring(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 1.0, 5.0), positive_number(rng)
    about.cause = "The damping must act along the spring, against the motion. Its size is the "
    about.cause += "damping c times the component of the velocity along the spring."
    for v, stiffness in ((velocity, 0.0), (velocity, k)):
        about.call = f"offset, v = Vector3{offset}, Vector3{v}; spring_force(offset, v, "
        about.call += f"stiffness={stiffness}, rest_length={rest}, damping={c}), in N"
        got = xyz(spring_force(Vector3(*offset), Vector3(*v), stiffness, rest, c))
        wanted = hooke(offset, v, stiffness, rest, c)
        why = named(got, about.cause, spring_slips(offset, v, stiffness, rest, c))
        # A few roundings of numbers up to 300.
        expect_close(got, wanted, cause=why, tolerance=1e-11)
    across = (-offset[1], offset[0], 0.0)
    about.call = f"spring_force(offset=Vector3{offset}, velocity=Vector3{across}, stiffness=0.0, "
    about.call += f"rest_length={rest}, damping={c}), in N"
    about.cause = "The end moves at right angles to the spring, so the length does not change and "
    about.cause += "there must be no damping. Use only the component of the velocity along the "
    about.cause += "spring."
    got = xyz(spring_force(Vector3(*offset), Vector3(*across), 0.0, rest, c))
    expect_close(got, ZERO, tolerance=1e-11)
    about.call = "spring_force(offset=Vector3(0, 2, 0), velocity=Vector3(0, 3, 0), stiffness=0.0, "
    about.call += "rest_length=2.0, damping=5.0), in N"
    about.cause = "The end moves away along the spring at 3 m/s, so a damping of 5 N s/m must "
    about.cause += "pull it back with 15 N. Check the sign of the damping."
    got = xyz(spring_force(Vector3(0.0, 2.0, 0.0), Vector3(0.0, 3.0, 0.0), 0.0, 2.0, 5.0))
    expect_close(got, (0.0, -15.0, 0.0))
    about.cause = "A compressed spring is damped like a stretched one, even if the damping is "
    about.cause += "larger than the push. Don't limit the force in either direction."
    for speed, wanted in ((-5.0, 25.0), (5.0, -5.0)):
        about.call = f"spring_force(offset=Vector3(0, 1, 0), velocity=Vector3(0, {speed}, 0), "
        about.call += "stiffness=10, rest_length=2, damping=3), in N"
        got = xyz(spring_force(Vector3(0.0, 1.0, 0.0), Vector3(0.0, speed, 0.0), 10.0, 2.0, 3.0))
        expect_close(got, (0.0, wanted, 0.0))


@pytest.mark.exercise("B6.1", asks="offset has no direction, so the force is then zero")
def test_ends_at_the_same_position_get_no_force(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"offset, v = Vector3(), Vector3{v}; spring_force(offset, v, stiffness=100.0, "
    about.call += "rest_length=2.0, damping=3.0), in N"
    about.cause = (
        "You divide by the length, which is 0 because both ends are at the same position. Use "
        "normalized(), which returns a zero vector here."
    )
    got = xyz(spring_force(Vector3(), Vector3(*v), 100.0, 2.0, 3.0))
    expect_close(got, ZERO)
    about.call = "spring_force(offset=Vector3(0, 1e-9, 0), velocity=Vector3(), stiffness=100, "
    about.call += "rest_length=2), in N"
    about.cause = (
        "Your spring exerts no force, although its ends are 1e-9 m apart. Don't treat a "
        "short length as 0."
    )
    got = xyz(spring_force(Vector3(0.0, 1e-9, 0.0), Vector3(), 100.0, 2.0))
    expect_close(got, (0.0, 200.0 - 1e-7, 0.0), tolerance=1e-10)
    about.call = f"p at the anchor with velocity {v}; s = AnchoredSpring(anchor=Vector3{v}, "
    about.call += "stiffness=100.0, rest_length=2.0, damping=3.0); s.update_force(p, 0.5); "
    about.call += "p.force_accumulator, in N"
    about.read = "book 6.2.2 and the docstring of AnchoredSpring"
    p = Particle(Vector3(*v), Vector3(*v))
    AnchoredSpring(Vector3(*v), 100.0, 2.0, 3.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    about.cause = (
        "The offset is p.position minus the anchor. It is zero here, so there is no direction and "
        "no force."
    )
    slips = {
        "Your spring acts as if its other end were at (0, 0, 0). Subtract self.anchor from the "
        "position to get the offset.": hooke(v, v, 100.0, 2.0, 3.0)
    }
    expect_close(got, ZERO, cause=named(got, about.cause, slips))
    about.read = READ
    about.call = "spring_force(offset=Vector3(2, 0, 0), velocity=Vector3(), stiffness=100.0, "
    about.call += "rest_length=1.0), in N"
    about.cause = (
        "The ends are 2 m apart here, so the spring has a direction and pulls with 100 N. There "
        "is no force only if both ends are at exactly the same position."
    )
    got = xyz(spring_force(Vector3(2.0, 0.0, 0.0), Vector3(), 100.0, 1.0))
    expect_close(got, (-100.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1", asks="The arguments are neither checked nor changed.")
def test_a_spring_changes_none_of_its_arguments(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    about.call = f"o, v = Vector3{offset}, Vector3{velocity}; spring_force(o, v, stiffness=3.0, "
    about.call += "rest_length=1.0, damping=2.0)"
    copies = (
        "The operations normalize, -= and *= work in place. Use normalized, - and *, which "
        "create new vectors."
    )
    o, v = Vector3(*offset), Vector3(*velocity)
    force = spring_force(o, v, 3.0, 1.0, 2.0)
    expect_unchanged("o", xyz(o), offset, cause=f"You changed the offset o. {copies}")
    expect_unchanged("v", xyz(v), velocity, cause=f"You changed the velocity v. {copies}")
    wanted = hooke(offset, velocity, 3.0, 1.0, 2.0)
    about.cause = (
        "The force is wrong. It must be -(k (l - l0) + c l') along the offset, where l is the "
        "length, l0 the rest length and l' the rate at which the length grows."
    )
    expect_close(xyz(force), wanted, tolerance=1e-11)
    about.call = f"p at {offset} with velocity {velocity}; q at {velocity} with velocity {offset}; "
    about.call += "Spring(q, stiffness=3.0, rest_length=1.0, damping=2.0).update_force(p, 0.5)"
    p = Particle(Vector3(*offset), Vector3(*velocity))
    q = Particle(Vector3(*velocity), Vector3(*offset))
    Spring(q, 3.0, 1.0, 2.0).update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, offset),
        ("p.velocity", p.velocity, velocity),
        ("q.position", q.position, velocity),
        ("q.velocity", q.velocity, offset),
    ):
        expect_unchanged(name, xyz(now), before, cause=f"You changed {name}. {copies}")
    about.read = "the docstring of AnchoredSpring"
    about.call = f"spring = AnchoredSpring(anchor=Vector3{offset}, stiffness=3.0, "
    about.call += f"rest_length=1.0); p at {velocity}; spring.update_force(p, 0.5)"
    p, spring = Particle(Vector3(*velocity)), AnchoredSpring(Vector3(*offset), 3.0, 1.0)
    spring.update_force(p, 0.5)
    cause = f"You changed spring.anchor. {copies}"
    expect_unchanged("spring.anchor", xyz(spring.anchor), offset, cause=cause)
    cause = f"You changed p.position. {copies}"
    expect_unchanged("p.position", xyz(p.position), velocity, cause=cause)
    about.call = "o = Vector3(); f = spring_force(o, Vector3(), stiffness=3.0, rest_length=1.0); "
    about.call += "f.x = 99.0"
    about.cause = (
        "You return one of the vectors that were passed in, so changing the result also changes "
        "the caller's vector. Return a new vector, even if the offset is zero."
    )
    o = Vector3()
    f = spring_force(o, Vector3(), 3.0, 1.0)
    f.x = 99.0
    expect_unchanged("o", xyz(o), ZERO)


@pytest.mark.exercise("B6.1", asks="rest length l_0, the spring exerts no force")
def test_a_spring_at_its_rest_length_exerts_no_force(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    offset = tuple(rest * part for part in d)
    about.call = f"spring_force(offset=Vector3{offset}, velocity=Vector3(), stiffness={k}, "
    about.call += f"rest_length={rest}), in N"
    about.cause = "At its rest length the spring has no extension, so there must be no force."
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, rest))
    expect_close(got, ZERO, tolerance=1e-13)
    about.call = f"spring_force(offset=Vector3{offset}, velocity=Vector3(), stiffness={k}, "
    about.call += "rest_length=0.0), in N"
    about.cause = (
        "With a rest length of 0 the extension is the whole length. The force must be minus the "
        "stiffness times the offset."
    )
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, 0.0))
    wanted = tuple(-k * part for part in offset)
    expect_close(got, wanted)
