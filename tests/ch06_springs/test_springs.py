"""Springs with two ends, build task B6.1: the force, and who gets it."""

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
    """Return what likely mistakes make of the force of hooke."""
    length = math.hypot(*offset)
    d = [part / length for part in offset]
    rate = sum(part * v for part, v in zip(d, velocity, strict=True))
    pull = k * (length - rest)

    def along(size: float) -> list[float]:
        return [size * part for part in d]

    return {
        "the listing's abs(l - l0), with which a compressed spring pulls (E-3)": along(
            -abs(pull) - c * rate
        ),
        "damping that pushes with the motion": along(c * rate - pull),
        "a force along the offset, with the minus forgotten": along(pull + c * rate),
        "-k l d^, without the rest length": along(-k * length - c * rate),
        "the right size times the offset, which is no unit vector": along(
            -(pull + c * rate) * length
        ),
        "l^2 in the place of the length": along(-k * (length**2 - rest) - c * rate),
        "a spring without its damping": along(-pull),
        "no force, as of a rope, which is slack where it is short": along(0.0 * pull),
        "damping of all of the velocity, -c v": [
            a - c * v for a, v in zip(along(-pull), velocity, strict=True)
        ],
        "damping by the speed |v|": along(-pull - c * math.hypot(*velocity)),
        "damping by v . offset, and the offset is no unit vector": along(-pull - c * rate * length),
    }


@pytest.mark.exercise("B6.1")
def test_a_stretched_spring_pulls_and_a_compressed_one_pushes(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    for share, cause in (
        (1.5, "a spring that is longer than at rest pulls this end back: against the offset"),
        (0.5, "a spring that is shorter than at rest pushes this end away"),
        (1e-3, "a spring that is shorter than at rest pushes this end away"),
    ):
        about.cause = cause
        offset = tuple(share * rest * part for part in d)
        about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, {rest})"
        wanted = hooke(offset, ZERO, k, rest, 0.0)
        got = expect_vector(spring_force(Vector3(*offset), Vector3(), k, rest))
        blame(got, spring_slips(offset, ZERO, k, rest, 0.0))
        # A few roundings of numbers up to 60.
        expect_close(got, wanted, tolerance=1e-12)
    about.call = "spring_force(Vector3(1, 0, 0), Vector3(), 10, 2)"
    about.cause = "length 1, at rest 2: it pushes with 10 N; printed is a pull of 10 N (E-3)"
    got = xyz(spring_force(Vector3(1.0, 0.0, 0.0), Vector3(), 10.0, 2.0))
    expect_close(got, (10.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1")
def test_damping_acts_along_the_spring_alone(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 1.0, 5.0), positive_number(rng)
    about.cause = "damping is -c l' d^, with l' = v . d^, the part of the velocity along the spring"
    for v, stiffness in ((velocity, 0.0), (velocity, k)):
        about.call = f"spring_force(Vector3{offset}, Vector3{v}, {stiffness}, {rest}, {c})"
        got = xyz(spring_force(Vector3(*offset), Vector3(*v), stiffness, rest, c))
        wanted = hooke(offset, v, stiffness, rest, c)
        why = named(got, about.cause, spring_slips(offset, v, stiffness, rest, c))
        # A few roundings of numbers up to 300.
        expect_close(got, wanted, cause=why, tolerance=1e-11)
    across = (-offset[1], offset[0], 0.0)
    about.call = f"spring_force(Vector3{offset}, Vector3{across}, 0.0, {rest}, {c})"
    about.cause = "motion straight across the spring does not change its length: no damping"
    got = xyz(spring_force(Vector3(*offset), Vector3(*across), 0.0, rest, c))
    expect_close(got, ZERO, tolerance=1e-11)
    about.call = "spring_force(Vector3(0, 2, 0), Vector3(0, 3, 0), 0.0, 2.0, 5.0)"
    about.cause = "a spring that grows longer is held back: against the velocity, c times it"
    got = xyz(spring_force(Vector3(0.0, 2.0, 0.0), Vector3(0.0, 3.0, 0.0), 0.0, 2.0, 5.0))
    expect_close(got, (0.0, -15.0, 0.0))
    about.cause = "a compressed spring has its damping too, even where that is more than its push"
    for speed, wanted in ((-5.0, 25.0), (5.0, -5.0)):
        about.call = f"spring_force(Vector3(0, 1, 0), Vector3(0, {speed}, 0), 10, 2, 3)"
        got = xyz(spring_force(Vector3(0.0, 1.0, 0.0), Vector3(0.0, speed, 0.0), 10.0, 2.0, 3.0))
        expect_close(got, (0.0, wanted, 0.0))


@pytest.mark.exercise("B6.1")
def test_ends_at_one_place_have_no_direction(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"spring_force(Vector3(), Vector3{v}, 100.0, 2.0, 3.0)"
    about.cause = "without an offset there is no direction, and no force: normalized() keeps zero "
    about.cause += "as zero"
    got = xyz(spring_force(Vector3(), Vector3(*v), 100.0, 2.0, 3.0))
    expect_close(got, ZERO)
    about.call = "spring_force(Vector3(0, 1e-9, 0), Vector3(), 100.0, 2.0)"
    about.cause = "ends that are near each other are not at one place: the spring pushes with k l0"
    got = xyz(spring_force(Vector3(0.0, 1e-9, 0.0), Vector3(), 100.0, 2.0))
    expect_close(got, (0.0, 200.0 - 1e-7, 0.0), tolerance=1e-10)
    about.call = f"p at the anchor with velocity {v}; AnchoredSpring(Vector3{v}, 100.0, 2.0, "
    about.call += "3.0).update_force(p, 0.5); p.force_accumulator"
    p = Particle(Vector3(*v), Vector3(*v))
    AnchoredSpring(Vector3(*v), 100.0, 2.0, 3.0).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    about.cause = "the offset is p.position minus the anchor, here zero: no direction, no force"
    slips = {"the spring of (0, 0, 0), with no anchor taken off": hooke(v, v, 100.0, 2.0, 3.0)}
    expect_close(got, ZERO, cause=named(got, about.cause, slips))
    about.call = "spring_force(Vector3(2, 0, 0), Vector3(), 100.0, 1.0)"
    about.cause = "where there is a direction there is a force"
    got = xyz(spring_force(Vector3(2.0, 0.0, 0.0), Vector3(), 100.0, 1.0))
    expect_close(got, (-100.0, 0.0, 0.0))


@pytest.mark.exercise("B6.1")
def test_the_vectors_of_a_spring_are_only_read(rng: Random) -> None:
    about.read = READ
    offset, velocity = components(rng), components(rng)
    about.call = f"o, v = Vector3{offset}, Vector3{velocity}; spring_force(o, v, 3.0, 1.0, 2.0)"
    about.cause = "normalize and *= work in place: use normalized and *"
    o, v = Vector3(*offset), Vector3(*velocity)
    force = spring_force(o, v, 3.0, 1.0, 2.0)
    expect_unchanged("o", xyz(o), offset)
    expect_unchanged("v", xyz(v), velocity)
    wanted = hooke(offset, velocity, 3.0, 1.0, 2.0)
    about.cause = "-(k (l - l0) + c l') d^"
    expect_close(xyz(force), wanted, tolerance=1e-11)
    about.call = f"p at {offset}, velocity {velocity}; q at {velocity}, velocity {offset}; "
    about.call += "Spring(q, 3.0, 1.0, 2.0).update_force(p, 0.5)"
    about.cause = "-= and normalize work in place: use - and normalized"
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
    about.cause = "what comes back is new, where there is no direction too"
    o = Vector3()
    f = spring_force(o, Vector3(), 3.0, 1.0)
    f.x = 99.0
    expect_unchanged("o", xyz(o), ZERO)


@pytest.mark.exercise("B6.1")
def test_a_spring_acts_on_the_particle_it_is_asked_for(rng: Random) -> None:
    about.read = "book 6.2.1 and the docstring of Spring"
    here, there, v, w, f = (components(rng) for _ in range(5))
    k, c = positive_number(rng), positive_number(rng)
    rest = round(2.0 * math.dist(here, there), 3)  # it is too short, and below too long
    about.call = f"p at {here}, velocity {v}; q at {there}, velocity {w}; p.add_force(Vector3{f}); "
    about.call += f"p has 2 kg, q 3 kg; s = Spring(q, {k}, {rest}, {c}); s.update_force(p, 0.5)"
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    q = Particle(Vector3(*there), Vector3(*w), mass=3.0)
    p.add_force(Vector3(*f))
    about.cause = "offset and velocity are the particle's minus the other's, damping counts, and "
    about.cause += "the force is added to p's; no mass is in it"
    s = Spring(q, k, rest, c)
    s.update_force(p, 0.5)
    offset = tuple(a - b for a, b in zip(here, there, strict=True))
    relative = tuple(a - b for a, b in zip(v, w, strict=True))
    pull = hooke(offset, relative, k, rest, c)
    wanted = tuple(a + b for a, b in zip(f, pull, strict=True))
    got = xyz(p.force_accumulator)
    back = tuple(-part for part in offset)
    forces = {
        "a spring with q's place minus p's, the other way round": hooke(back, relative, k, rest, c),
        "a spring with q's velocity minus p's, the other way round": hooke(
            offset, tuple(-part for part in relative), k, rest, c
        ),
        "a spring with p's velocity alone, and q's is not taken off": hooke(offset, v, k, rest, c),
        "a spring without its damping": hooke(offset, relative, k, rest, 0.0),
        "a push, the opposite of the force": tuple(-part for part in pull),
        "the force divided by the mass of p": tuple(part / 2.0 for part in pull),
        "the force divided by the mass of q": tuple(part / 3.0 for part in pull),
        "no force on p, the particle that it is asked for": ZERO,
    }
    slips = {name: [a + b for a, b in zip(f, force, strict=True)] for name, force in forces.items()}
    slips["the pull alone, and what was there is lost"] = [*pull]
    blame(got, slips)
    # A few roundings of numbers up to 600.
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)
    about.cause = "one Spring acts on one end; q gets its force from a Spring of its own"
    expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator")
    about.call = "s = Spring(q, 1, 1, 1) has acted; s.stiffness, s.rest_length, s.damping = 5, 2, "
    about.call += "3; p at (0, 3, 0), velocity (0, 1, 0), q at rest at (0, 0, 0); "
    about.call += "s.update_force(p, 0.5)"
    about.cause = "read the attributes each time: -(5 (3 - 2) + 3 * 1)"
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
    # It is too long at the first anchor, and too short at the second.
    rest, longer = round(0.5 * math.dist(here, first), 3), round(2.0 * math.dist(here, second), 3)
    k, c = positive_number(rng), positive_number(rng)
    about.call = f"p at {here}, velocity {v}; s = AnchoredSpring(Vector3{first}, {k}, {rest}, "
    about.call += f"{c}); "
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    s = AnchoredSpring(Vector3(*first), k, rest, c)
    about.call += "s.update_force(p, 0.5)"
    about.cause = "the offset is the particle's position minus the anchor, the velocity its own; "
    about.cause += "stiffness, rest length and damping are the spring's, and no mass is in the "
    about.cause += "force"
    s.update_force(p, 0.5)
    offset = tuple(a - b for a, b in zip(here, first, strict=True))
    wanted = hooke(offset, v, k, rest, c)
    got = xyz(p.force_accumulator)
    slips = {
        "a spring with anchor minus position, the other way round": hooke(
            tuple(-part for part in offset), v, k, rest, c
        ),
        "a spring without its damping": hooke(offset, v, k, rest, 0.0),
        "a spring with a rest length of 0": hooke(offset, v, k, 0.0, c),
        "the spring of (0, 0, 0), with no anchor taken off": hooke(here, v, k, rest, c),
        "a push, the opposite of the force": tuple(-part for part in wanted),
    }
    blame(got, slips)
    expect_close(got, wanted, tolerance=1e-11)
    about.call += f"; p.clear_forces(); s.anchor = Vector3{second}; s.stiffness, s.rest_length, "
    about.call += "s.damping = "
    about.call += f"{2 * k}, {longer}, {4 * c}; s.update_force(p, 0.5)"
    about.cause = "read the attributes each time: a camera's anchor moves"
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
    about.call += "spring.update_force(p, h), p.integrate(h) in frames of 1/4000 s, to the third "
    about.call += "return"
    about.cause = "chi^2 = k / m: a period of 2 pi / 5 s, whatever the direction"
    for axis in range(3):
        start = [0.0, 0.0, 0.0]
        start[axis] = 0.5
        period = swinging((start[0], start[1], start[2]), 50.0, 2.0, 1.0 / 4000.0, 12000)
        # Explicit Euler's own error in the period is k h^2 / m / 3, some 5e-7 of it, and a
        # crossing lies between two frames.
        wanted = 2.0 * math.pi / 5.0
        expect_close(period, wanted, then=": period", tolerance=1e-4)


@pytest.mark.exercise("B6.1")
def test_a_spring_of_its_length_at_rest_does_nothing(rng: Random) -> None:
    about.read = READ
    d, k, rest = direction(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    offset = tuple(rest * part for part in d)
    about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, {rest})"
    about.cause = "k (l - l0) is 0 where l is l0"
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, rest))
    expect_close(got, ZERO, tolerance=1e-13)
    about.call = f"spring_force(Vector3{offset}, Vector3(), {k}, 0.0)"
    about.cause = "a spring without a rest length pulls with k times the offset"
    got = xyz(spring_force(Vector3(*offset), Vector3(), k, 0.0))
    wanted = tuple(-k * part for part in offset)
    expect_close(got, wanted)
