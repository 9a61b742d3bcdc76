"""Springs, build task B6.1: the particle that they act on."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import swinging
from ch06_springs.springs import AnchoredSpring, Spring
from draw import components, positive_number
from expect import about, blame, expect_close, xyz

ZERO = (0.0, 0.0, 0.0)


def hooke(
    offset: tuple[float, ...], velocity: tuple[float, ...], k: float, rest: float, c: float
) -> tuple[float, ...]:
    length = math.hypot(*offset)
    rate = sum(o * v for o, v in zip(offset, velocity, strict=True)) / length
    size = -(k * (length - rest) + c * rate) / length
    return tuple(size * o for o in offset)


@pytest.mark.exercise("B6.1", asks="Compute the spring force on particle, and add it")
def test_a_spring_acts_on_the_particle_passed_to_it(rng: Random) -> None:
    about.read = "book 6.2.1 and the docstring of Spring"
    here, there, v, w, f = (components(rng) for _ in range(5))
    k, c = positive_number(rng), positive_number(rng)
    rest = round(2.0 * math.dist(here, there), 3)  # compressed here, and stretched below
    about.call = f"p of 2 kg at {here} with velocity {v}; q of 3 kg at {there} with velocity {w}; "
    about.call += f"p.add_force(Vector3{f}); s = Spring(q, stiffness={k}, rest_length={rest}, "
    about.call += f"damping={c}); s.update_force(p, 0.25)"
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    q = Particle(Vector3(*there), Vector3(*w), mass=3.0)
    p.add_force(Vector3(*f))
    about.cause = (
        "Subtract the other particle's position and velocity from p's, compute the force without "
        "any mass, and add it to p."
    )
    s = Spring(q, k, rest, c)
    s.update_force(p, 0.25)
    offset = tuple(a - b for a, b in zip(here, there, strict=True))
    relative = tuple(a - b for a, b in zip(v, w, strict=True))
    pull = hooke(offset, relative, k, rest, c)
    wanted = tuple(a + b for a, b in zip(f, pull, strict=True))
    got = xyz(p.force_accumulator)
    back = tuple(-part for part in offset)
    forces = {
        "You subtract p's position from q's, so the force on p points in the wrong direction. "
        "Subtract q's position from p's instead.": hooke(back, relative, k, rest, c),
        "You subtract p's velocity from q's, so the damping has the wrong sign. Subtract q's "
        "velocity from p's instead.": hooke(offset, tuple(-part for part in relative), k, rest, c),
        "Your damping uses only the velocity of p, but the motion of q changes the length too. "
        "Subtract q's velocity from p's.": hooke(offset, v, k, rest, c),
        "You left out the damping. Pass it to spring_force, together with the velocity of p "
        "relative to q.": hooke(offset, relative, k, rest, 0.0),
        "Your force points in the wrong direction. Either you subtract p's position and velocity "
        "from q's instead of the other way around, or the sign of the force is wrong.": tuple(
            -part for part in pull
        ),
        "You subtract p's position from q's, so the force on p points in the wrong direction, and "
        "your damping uses only p's velocity. Subtract q's position and velocity from p's.": hooke(
            back, v, k, rest, c
        ),
        "You subtract p's position from q's, so the force on p points in the wrong direction, and "
        "you left out the damping. Subtract q's position and velocity from p's.": hooke(
            back, relative, k, rest, 0.0
        ),
        "Your offset is the position of p alone, as if q were at (0, 0, 0). Subtract q's position "
        "from it.": hooke(here, relative, k, rest, c),
        "You swapped the stiffness and the rest length. spring_force takes the stiffness first.": (
            hooke(offset, relative, rest, k, c)
        ),
        "You swapped the rest length and the damping. spring_force takes the damping last.": hooke(
            offset, relative, k, c, rest
        ),
        "You swapped the offset and the velocity. spring_force takes the offset first.": hooke(
            relative, offset, k, rest, c
        ),
        "You multiplied the force by the duration. Add the force itself, because the step "
        "multiplies it by the duration later.": tuple(0.25 * part for part in pull),
        "You divided the force by the mass of p. Add the force itself, because the step "
        "divides it by the mass later.": tuple(part / 2.0 for part in pull),
        "You divided the force by the mass of q. The force of a spring does not depend on any "
        "mass, so leave the masses out.": tuple(part / 3.0 for part in pull),
        "You add no force to p, the particle that is passed to update_force. Add the spring's "
        "force to it, instead of returning the force or adding it to self.other.": ZERO,
    }
    slips = {name: [a + b for a, b in zip(f, force, strict=True)] for name, force in forces.items()}
    slips[
        "Your spring discards the force that p already had. Use add_force, which keeps that force."
    ] = [*pull]
    blame(got, slips)
    # A few roundings of numbers up to 600.
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
    about.cause = (
        "You added a force to q as well. A Spring acts only on the particle that is passed to "
        "update_force, and q needs a Spring of its own."
    )
    expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator, in N")
    about.call = "s = Spring(q, stiffness=1, rest_length=1, damping=1), used once; s.stiffness, "
    about.call += "s.rest_length, s.damping = 5, 2, 3; p at (0, 3, 0) with velocity (0, 1, 0), q "
    about.call += "at rest at (0, 0, 0); s.update_force(p, 0.5)"
    about.cause = (
        "The check changes the attributes of s before this call, so the force must be -(5 (3 - "
        "2) + 3 * 1). Read the attributes in every call."
    )
    s.stiffness, s.rest_length, s.damping = 5.0, 2.0, 3.0
    p, q.position, q.velocity = Particle(Vector3(0, 3, 0), Vector3(0, 1, 0)), Vector3(), Vector3()
    s.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, -8.0, 0.0), then="; p.force_accumulator, in N")


@pytest.mark.exercise("B6.1", asks="You may move anchor, for example")
def test_an_anchor_may_be_moved(rng: Random) -> None:
    about.read = "book 6.2.2 and the docstring of AnchoredSpring"
    here, v = components(rng), components(rng)
    first, second = components(rng), components(rng)
    # The spring is stretched at the first anchor and compressed at the second.
    rest, longer = round(0.5 * math.dist(here, first), 3), round(2.0 * math.dist(here, second), 3)
    k, c = positive_number(rng), positive_number(rng)
    about.call = f"p at {here} with velocity {v}; s = AnchoredSpring(anchor=Vector3{first}, "
    about.call += f"stiffness={k}, rest_length={rest}, damping={c}); "
    p = Particle(Vector3(*here), Vector3(*v), mass=2.0)
    s = AnchoredSpring(Vector3(*first), k, rest, c)
    about.call += "s.update_force(p, 0.25); p.force_accumulator, in N"
    about.cause = (
        "The offset is p.position minus the anchor. The anchor is at rest, so the relative "
        "velocity is p.velocity, and the mass has no effect on the force."
    )
    s.update_force(p, 0.25)
    offset = tuple(a - b for a, b in zip(here, first, strict=True))
    wanted = hooke(offset, v, k, rest, c)
    got = xyz(p.force_accumulator)
    slips = {
        "You subtract the position from the anchor, so the force points in the wrong direction. "
        "Subtract the anchor from the position instead.": hooke(
            tuple(-part for part in offset), v, k, rest, c
        ),
        "You left out the damping. Pass it to spring_force, with the velocity of p.": hooke(
            offset, v, k, rest, 0.0
        ),
        "Your force uses a rest length of 0. Pass self.rest_length to spring_force, so that "
        "only the extension counts.": hooke(offset, v, k, 0.0, c),
        "Your spring acts as if its other end were at (0, 0, 0). Subtract self.anchor from the "
        "position to get the offset.": hooke(here, v, k, rest, c),
        "Your force points in the wrong direction. Either you reverse the velocity as well as the "
        "offset, or the sign of the force is wrong.": tuple(-part for part in wanted),
        "You subtract the position from the anchor, so the force points in the wrong direction, "
        "and you left out the damping. Subtract the anchor from the position.": hooke(
            tuple(-part for part in offset), v, k, rest, 0.0
        ),
        "You swapped the stiffness and the rest length. spring_force takes the stiffness first.": (
            hooke(offset, v, rest, k, c)
        ),
        "You multiplied the force by the duration. Add the force itself, because the step "
        "multiplies it by the duration later.": tuple(0.25 * part for part in wanted),
        "You add no force to p, the particle that is passed to update_force. Add the spring's "
        "force to it with add_force.": ZERO,
    }
    blame(got, slips)
    expect_close(got, wanted, tolerance=1e-11)
    about.call += f"; p.clear_forces(); s.anchor = Vector3{second}; s.stiffness, s.rest_length, "
    about.call += f"s.damping = {2 * k:.6g}, {longer}, {4 * c:.6g}; s.update_force(p, 0.25); "
    about.call += "p.force_accumulator, in N"
    about.cause = (
        "The check changes the anchor and the other attributes of s before this call. Read them "
        "in every call instead of storing a result."
    )
    p.clear_forces()
    s.anchor, s.stiffness, s.rest_length, s.damping = Vector3(*second), 2 * k, longer, 4 * c
    s.update_force(p, 0.25)
    offset = tuple(a - b for a, b in zip(here, second, strict=True))
    wanted = hooke(offset, v, 2.0 * k, longer, 4.0 * c)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B6.1", asks="swings with the angular frequency")
def test_a_particle_on_a_spring_swings_with_its_period() -> None:
    about.read = "book 6.3.2, Eq. 6.3"
    about.call = "p of 2 kg, released 0.5 m from the anchor; AnchoredSpring(anchor=Vector3(), "
    about.call += "stiffness=50, rest_length=0).update_force(p, h) in steps of 1/1000 s until its "
    about.call += "third return"
    about.cause = (
        "The period must be 2 pi sqrt(m / k), which is 1.25664 s here, in every direction. Check "
        "that the force is proportional to the distance from the anchor."
    )
    for axis in range(3):
        start = [0.0, 0.0, 0.0]
        start[axis] = 0.5
        period = swinging((start[0], start[1], start[2]), 50.0, 2.0, 1.0 / 1000.0, 3000)
        # Explicit Euler has a relative error of k h^2 / m / 3 in the period, about 8e-6, and a
        # crossing lies between two steps.
        wanted = 2.0 * math.pi / 5.0
        expect_close(period, wanted, then="; the period in s", tolerance=1e-4)
