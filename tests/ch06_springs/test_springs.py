"""Springs, build task B6.1: the force, and the particle that it acts on."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import period_on
from ch06_springs.springs import AnchoredSpring, Spring, spring_force
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_close, expect_unchanged, expect_vector, xyz

ZERO = Triple((0.0, 0.0, 0.0))
ENDS = "book 6.2.1 and the docstring of Spring"
READ = "book 6.1 and 6.2.1, Eq. 6.1 and 6.2, and the docstring of spring_force"
ANCHORED = "book 6.2.2 and the docstring of AnchoredSpring"
RULE = (
    "The force is -(k (l - l0) + c l') d, where d is the normalized offset, l the length of the "
    "offset, l0 the rest length and l' = v . d."
)
COPIES = (
    "The operations normalize, -= and *= work in place. Use normalized, - and *, which create new "
    "vectors."
)


def hooke(offset: Triple, velocity: Triple, k: float, rest: float, c: float = 0.0) -> Triple:
    """Return the force of a spring on an end, whose position and velocity are relative."""
    d = offset / abs(offset)
    return -(k * (abs(offset) - rest) + c * (velocity @ d)) * d


def spring_slips(
    offset: Triple, v: Triple, k: float, rest: float, c: float = 0.0
) -> dict[str, Triple]:
    """Return the force of hooke after each likely mistake, keyed by its explanation."""
    length = abs(offset)
    d = offset / length
    rate, pull = v @ d, k * (length - rest)
    return {
        "Your extension is abs(length - rest_length), as in the book's listing (E-3), so a "
        "compressed spring pulls. Remove abs, so that it pushes.": -(abs(pull) + c * rate) * d,
        "Your damping has the wrong sign.": (c * rate - pull) * d,
        "Your force has the wrong sign, so a stretched spring pushes.": (pull + c * rate) * d,
        "Your force is the stiffness times the whole length. Only the extension counts, so "
        "subtract the rest length from the length.": -(k * length + c * rate) * d,
        "You use the length of the unit vector, which is 1.": -(k * (1.0 - rest) + c * rate) * d,
        "You multiply by the whole offset instead of its direction.": -(pull + c * rate) * offset,
        "You use the squared length of the offset.": -(k * (length**2 - rest) + c * rate) * d,
        "Your force uses only half of the stiffness.": -(0.5 * pull + c * rate) * d,
        "You left out the damping.": -pull * d,
        "Your spring exerts no force here, like a slack rope.": ZERO,
        "Your damping is -c v, which also slows down motion across the spring. Use only the "
        "component of the velocity v along the spring.": -pull * d - c * v,
        "Your damping uses the speed |v|, which is never negative.": -(pull + c * abs(v)) * d,
        "Your damping uses the dot product of v and the whole offset.":
            -(pull + c * rate * length) * d,
    }  # fmt: skip


@pytest.mark.exercise("B6.1", asks="a stretched spring pulls this end back", read=READ)
def test_a_stretched_spring_pulls_and_a_compressed_one_pushes(rng: Random) -> None:
    d, k, rest = unit_vector(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    pulls = f"The spring is longer than its rest length, so it must pull this end back. {RULE}"
    pushes = f"The spring is shorter than its rest length, so it must push this end away. {RULE}"
    for share, cause in ((1.5, pulls), (0.5, pushes), (1e-3, pushes)):
        offset = share * rest * d
        with calls(cause):
            got = spring_force(Vector3(*offset), Vector3(), stiffness=k, rest_length=rest)
        wanted, slips = hooke(offset, ZERO, k, rest), spring_slips(offset, ZERO, k, rest)
        # A few roundings of numbers up to 60.
        expect_close(expect_vector(got), wanted, slips, tolerance=1e-12, unit="N")
    with calls("It is 1 m too short, so it must push with 10 N. The book's listing pulls (E-3)."):
        got = spring_force(Vector3(1.0, 0.0, 0.0), Vector3(), stiffness=10.0, rest_length=2.0)
    expect_close(xyz(got), (10.0, 0.0, 0.0), unit="N")


@pytest.mark.exercise("B6.1", asks="the component of velocity along d^", read=READ)
def test_damping_acts_only_along_the_spring(rng: Random) -> None:
    d, w, y = vector(rng), vector(rng), Triple((0.0, 1.0, 0.0))
    k, rest, c = positive_number(rng), positive_number(rng, 1.0, 5.0), positive_number(rng)
    along = f"The damping must act along the spring, against the motion. {RULE}"
    like = "A compressed spring is damped like a stretched one, even if the damping is larger than "
    like += "the push. Don't limit the force in either direction."
    for offset, v, stiffness, length, damping, cause in (
        (d, w, 0.0, rest, c, along),
        (d, w, k, rest, c, along),
        (d, Triple((-d[1], d[0], 0.0)), 0.0, rest, c,
         "The end moves at right angles to the spring, so the length does not change and there "
         "must be no damping. Use only the component of the velocity along the spring."),
        (2.0 * y, 3.0 * y, 0.0, 2.0, 5.0,
         "The end moves away along the spring at 3 m/s, so a damping of 5 N s/m must pull it back "
         "with 15 N. Check the sign of the damping."),
        (y, -5.0 * y, 10.0, 2.0, 3.0, like),
        (y, 5.0 * y, 10.0, 2.0, 3.0, like),
    ):  # fmt: skip
        with calls(cause):
            o, u = Vector3(*offset), Vector3(*v)
            got = spring_force(o, u, stiffness, rest_length=length, damping=damping)
        wanted = hooke(offset, v, stiffness, length, damping)
        slips = spring_slips(offset, v, stiffness, length, damping) if cause == along else {}
        near = 1e-11 if offset is d else None  # a few roundings of numbers up to 300
        expect_close(xyz(got), wanted, slips, tolerance=near, unit="N")


@pytest.mark.exercise("B6.1", asks="offset has no direction, so the force is then zero", read=READ)
def test_ends_at_the_same_position_get_no_force(rng: Random) -> None:
    v = vector(rng)
    for offset, velocity, c, wanted, tolerance, cause in (
        (ZERO, v, 3.0, ZERO, 0.0,
         "You divide by the length, which is 0 because both ends are at the same position. Use "
         "normalized(), which returns a zero vector here."),
        ((0.0, 1e-9, 0.0), ZERO, 0.0, (0.0, 200.0 - 1e-7, 0.0), 1e-10,
         "Your spring exerts no force, although its ends are 1e-9 m apart. Don't treat a short "
         "length as 0."),
        ((4.0, 0.0, 0.0), ZERO, 0.0, (-200.0, 0.0, 0.0), 2e-11,
         "The ends are 4 m apart here, so the spring has a direction and pulls with 200 N. There "
         "is no force only if both ends are at exactly the same position."),
    ):  # fmt: skip
        with calls(cause):
            o, w = Vector3(*offset), Vector3(*velocity)
            got = spring_force(o, w, stiffness=100.0, rest_length=2.0, damping=c)
        expect_close(xyz(got), wanted, tolerance=tolerance, unit="N")
    with calls("The offset, p.position minus the anchor, is zero here, so there is no force."):
        p = Particle(Vector3(*v), Vector3(*v))
        s = AnchoredSpring(Vector3(*v), stiffness=100.0, rest_length=2.0, damping=3.0)
        s.update_force(p, 0.5)
        got = p.force_accumulator
    slips = {
        "Your spring acts as if its other end were at (0, 0, 0). Subtract self.anchor from the "
        "position to get the offset.": hooke(v, v, 100.0, 2.0, 3.0)
    }
    expect_close(got, ZERO, slips, unit="N", read=ANCHORED)


@pytest.mark.exercise("B6.1", asks="The arguments are neither checked nor changed.", read=READ)
def test_a_spring_changes_none_of_its_arguments(rng: Random) -> None:
    offset, velocity = vector(rng), vector(rng)
    with calls(RULE):
        o, v = Vector3(*offset), Vector3(*velocity)
        got = spring_force(o, v, stiffness=3.0, rest_length=1.0, damping=2.0)
    expect_unchanged("o", o, offset, cause=f"You changed the offset o. {COPIES}")
    expect_unchanged("v", v, velocity, cause=f"You changed the velocity v. {COPIES}")
    expect_close(xyz(got), hooke(offset, velocity, 3.0, 1.0, 2.0), tolerance=1e-11, unit="N")
    with calls(COPIES):
        p = Particle(Vector3(*offset), Vector3(*velocity))
        q = Particle(Vector3(*velocity), Vector3(*offset))
        Spring(q, stiffness=3.0, rest_length=1.0, damping=2.0).update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, offset),
        ("p.velocity", p.velocity, velocity),
        ("q.position", q.position, velocity),
        ("q.velocity", q.velocity, offset),
    ):
        expect_unchanged(name, now, before, cause=f"You changed {name}. {COPIES}")
    with calls(COPIES):
        p, s = Particle(Vector3(*velocity)), AnchoredSpring(Vector3(*offset), 3.0, rest_length=1.0)
        s.update_force(p, 0.5)
    for name, now, before in (("s.anchor", s.anchor, offset), ("p.position", p.position, velocity)):
        cause = f"You changed {name}. {COPIES}"
        expect_unchanged(name, now, before, cause=cause, read=ANCHORED)
    with calls("You return one of your arguments. Return a new vector, even if it is zero."):
        o = Vector3()
        f = spring_force(o, Vector3(), stiffness=3.0, rest_length=1.0)
        f.x = 99.0
    expect_unchanged("o", o, ZERO)


@pytest.mark.exercise("B6.1", asks="rest length l_0, the spring exerts no force", read=READ)
def test_a_spring_at_its_rest_length_exerts_no_force(rng: Random) -> None:
    d, k, length = unit_vector(rng), positive_number(rng), positive_number(rng, 1.0, 5.0)
    for rest, cause in (
        (length, "At its rest length the spring has no extension, so there must be no force."),
        (0.0, "With a rest length of 0 the extension is the whole length. The force must be minus "
         "the stiffness times the offset."),
    ):  # fmt: skip
        with calls(cause):
            offset = Vector3(*(length * d))
            got = spring_force(offset, Vector3(), stiffness=k, rest_length=rest)
        wanted = -k * (length - rest) * d
        expect_close(xyz(got), wanted, unit="N", tolerance=None if rest == 0.0 else 1e-13)


@pytest.mark.exercise("B6.1", asks="Compute the spring force on particle, and add it", read=ENDS)
def test_a_spring_acts_on_the_particle_passed_to_it(rng: Random) -> None:
    here, there, v, w, f = vector(rng), vector(rng), vector(rng), vector(rng), vector(rng)
    k, c = positive_number(rng), positive_number(rng)
    rest = round(2.0 * math.dist(here, there), 3)  # compressed here, and stretched below
    with calls(
        "The force on p is spring_force(offset, velocity, stiffness, rest_length, damping), with "
        "p's position minus q's, and p's velocity minus q's."
    ):
        p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
        q = Particle(Vector3(*there), Vector3(*w), mass=3.0)
        p.add_force(Vector3(*f))
        s = Spring(q, stiffness=k, rest_length=rest, damping=c)
        s.update_force(p, 0.25)
    offset, relative = here - there, v - w
    pull = hooke(offset, relative, k, rest, c)
    back = "You subtract p's position from q's, so the force on p points in the wrong direction"
    forces = {
        f"{back}.": hooke(-offset, relative, k, rest, c),
        "You subtract p's velocity from q's, so the damping has the wrong sign.":
            hooke(offset, -relative, k, rest, c),
        "Your damping uses only the velocity of p, but the motion of q changes the length too. "
        "Subtract q's velocity from p's.": hooke(offset, v, k, rest, c),
        "You left out the damping.": hooke(offset, relative, k, rest),
        "Your force points in the wrong direction. Either you subtract p's position and velocity "
        "from q's instead of the other way around, or the sign of the force is wrong.": -pull,
        f"{back}, and your damping uses only p's velocity.": hooke(-offset, v, k, rest, c),
        f"{back}, and you left out the damping.": hooke(-offset, relative, k, rest),
        "Your offset is the position of p alone, as if q were at (0, 0, 0).":
            hooke(here, relative, k, rest, c),
        "You swapped the stiffness and the rest length.": hooke(offset, relative, rest, k, c),
        "You swapped the rest length and the damping.": hooke(offset, relative, k, c, rest),
        "You swapped the offset and the velocity.": hooke(relative, offset, k, rest, c),
        "You multiplied the force by the duration.": 0.25 * pull,
        "You divided the force by the mass of p.": pull / 2.0,
        "You divided the force by the mass of q.": pull / 3.0,
        "You add no force to p, perhaps because you return it, or add it to self.other.": ZERO,
        "Your spring discards the force that p already had. Use add_force, which keeps that "
        "force.": pull - f,
    }  # fmt: skip
    slips = {slip: f + force for slip, force in forces.items()}
    # A few roundings of numbers up to 600.
    expect_close(p.force_accumulator, f + pull, slips, then="; p.force_accumulator", unit="N",
                 tolerance=1e-11)  # fmt: skip
    cause = "You added a force to q as well. A Spring acts only on p, which is passed to it."
    expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=cause)
    with calls("The force must be -8 N now. Read the attributes in every call.", more=True):
        s.stiffness, s.rest_length, s.damping = 5.0, 2.0, 3.0
        p = Particle(Vector3(0.0, 3.0, 0.0), Vector3(0.0, 1.0, 0.0))
        q.position, q.velocity = Vector3(), Vector3()
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, (0.0, -8.0, 0.0), unit="N")


@pytest.mark.exercise("B6.1", asks="You may move anchor, for example", read=ANCHORED)
def test_an_anchor_may_be_moved(rng: Random) -> None:
    here, v, first, second = vector(rng), vector(rng), vector(rng), vector(rng)
    # The spring is stretched at the first anchor and compressed at the second.
    rest, longer = round(0.5 * math.dist(here, first), 3), round(2.0 * math.dist(here, second), 3)
    k, c = positive_number(rng), positive_number(rng)
    with calls(
        "The force on p is spring_force(offset, velocity, stiffness, rest_length, damping), with "
        "p's position minus the anchor, and p's velocity."
    ):
        p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
        s = AnchoredSpring(Vector3(*first), stiffness=k, rest_length=rest, damping=c)
        s.update_force(p, 0.25)
        got = p.force_accumulator
    offset, wanted = here - first, hooke(here - first, v, k, rest, c)
    back = "You subtract the position from the anchor, so the force points in the wrong direction"
    slips = {
        f"{back}.": hooke(-offset, v, k, rest, c),
        "You left out the damping.": hooke(offset, v, k, rest),
        "Your force uses a rest length of 0.": hooke(offset, v, k, 0.0, c),
        "Your spring acts as if its other end were at (0, 0, 0).": hooke(here, v, k, rest, c),
        "Your force points in the wrong direction. Either you reverse the velocity as well as the "
        "offset, or the sign of the force is wrong.": -wanted,
        f"{back}, and you left out the damping.": hooke(-offset, v, k, rest),
        "You swapped the stiffness and the rest length.": hooke(offset, v, rest, k, c),
        "You multiplied the force by the duration.": 0.25 * wanted,
        "You add no force to p, the particle that is passed to update_force.": ZERO,
    }  # fmt: skip
    expect_close(got, wanted, slips, tolerance=1e-11, unit="N")
    with calls("Read the anchor and the other attributes in every call.", more=True):
        p.clear_forces()
        s.anchor = Vector3(*second)
        s.stiffness, s.rest_length, s.damping = 2.0 * k, longer, 4.0 * c
        s.update_force(p, 0.25)
        got = p.force_accumulator
    wanted = hooke(here - second, v, 2.0 * k, longer, 4.0 * c)
    expect_close(got, wanted, tolerance=1e-11, unit="N")


@pytest.mark.exercise("B6.1", asks="swings with the angular frequency", read="book 6.3.2, Eq. 6.3")
def test_a_particle_on_a_spring_swings_with_its_period() -> None:
    h = 1.0 / 1000.0
    for axis in range(3):
        start = [0.0, 0.0, 0.0]
        start[axis] = 0.5
        with calls(
            "The period must be 2 pi sqrt(m / k), here 1.25664 s, in every direction.",
            "p of 2 kg, released 0.5 m from the anchor; AnchoredSpring(anchor=Vector3(), "
            "stiffness=50, rest_length=0).update_force(p, h) in steps of 1/1000 s until its third "
            "return; the period",
        ):
            period = period_on("AnchoredSpring", (ZERO, 50.0, 0.0), start, h, 3000, mass=2.0)
        # Explicit Euler has a relative error of k h^2 / m / 3 in the period, about 8e-6, and a
        # crossing lies between two steps.
        expect_close(period, 2.0 * math.pi / 5.0, tolerance=1e-4, unit="s")
