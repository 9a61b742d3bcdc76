"""The faked stiff spring, build task B6.11."""

from __future__ import annotations

import cmath
import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import faked
from ch06_springs.springs import FakeStiffSpring
from draw import components, positive_number
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_between,
    expect_close,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
READ = "book 6.3.2 and the docstring of FakeStiffSpring"


def true_spring(x0: float, v0: float, k: float, c: float, m: float, t: float) -> float:
    """Return where a true spring is after t s, by the roots of m r^2 + c r + k."""
    root = cmath.sqrt(c * c - 4.0 * k * m)
    r, s = (-c + root) / (2.0 * m), (-c - root) / (2.0 * m)
    a, b = (v0 - s * x0) / (r - s), (r * x0 - v0) / (r - s)
    return (a * cmath.exp(r * t) + b * cmath.exp(s * t)).real


@pytest.mark.exercise("B6.11", asks="the force is m ((T - x) / h^2 - v / h)")
def test_the_force_by_its_formula() -> None:
    about.read = READ
    about.call = "p of 1 kg at rest at (1, 0, 0), with acceleration (0, -10, 0) and damping 0.5; "
    about.call += "FakeStiffSpring(anchor=Vector3(), stiffness=400, damping=0).update_force(p, "
    about.call += "1/60)"
    about.cause = "For a mass of 1 kg the force is (T - x) / h^2 - v / h, where T is the position "
    about.cause += "that a real spring would reach in h seconds. The acceleration and the damping "
    about.cause += "of p don't matter."
    p = Particle(Vector3(1.0, 0.0, 0.0), acceleration=Vector3(0.0, -10.0, 0.0), damping=0.5)
    FakeStiffSpring(Vector3(), 400.0, 0.0).update_force(p, 1.0 / 60.0)
    got = xyz(p.force_accumulator)
    wanted = (-198.15499326694427, 0.0, 0.0)
    sizes = {
        "You divide by h and then multiply by h again, because the book's listing says 1 / h * "
        "h (E-6). Divide by h * h instead.": wanted[0] / 3600.0,
        "You use the force of a real spring, -k x. Compute the force that takes p to T, the "
        "position that a real spring would reach in h seconds.": -400.0,
        "Your force points away from T. Either you subtract T from x, or you measure the position "
        "from p to the anchor. Use the vector from the anchor to p, and T - x.": -wanted[0],
        "You divide by h only once, where h is the duration. An acceleration a moves p by a * h^2 "
        "in one step, so divide T - x by h^2.": wanted[0] / 60.0,
        "You divide T by h^2 instead of T - x, where h is the duration. Subtract the current "
        "position first.": 3600.0 + wanted[0],
        "You use the velocity that a real spring would give p. Use its position, which is the "
        "first number that damped_spring_state returns.": 3600.0
        * (-20.0 * math.sin(1.0 / 3.0) - 1.0),
        "Your force gives p the velocity on a real spring, and not its position. Use (T - x) / h^2 "
        "- v / h, where T is the position and h the duration.": -1200.0 * math.sin(1.0 / 3.0),
        "You pass the damping of the particle to damped_spring_state. Pass self.damping, that of "
        "the spring.": 3600.0 * (true_spring(1.0, 0.0, 400.0, 0.5, 1.0, 1.0 / 60.0) - 1.0),
        "Your force is twice as large as it should be. In one step, an acceleration a moves p by a "
        "* h^2 and not by a * h^2 / 2, so divide by h^2.": 2.0 * wanted[0],
    }
    blame(got, {slip: (size, 0.0, 0.0) for slip, size in sizes.items()})
    # 1 - cos(1/3) loses a digit, and is multiplied by 3600.
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-10)
    about.call = "p of 1 kg at (0, 0, 0) with velocity (0, 2, 0); "
    about.call += "FakeStiffSpring(anchor=Vector3(), stiffness=400, damping=0).update_force(p, "
    about.call += "1/60)"
    about.cause = "p moves along y, so the force is (T - x) / h^2 - v / h with x = 0 and v = 2. T "
    about.cause += "is the position that a real spring would reach in h seconds."
    p = Particle(velocity=Vector3(0.0, 2.0, 0.0))
    FakeStiffSpring(Vector3(), 400.0, 0.0).update_force(p, 1.0 / 60.0)
    wanted = (0.0, (2.0 * math.sin(1.0 / 3.0) / 20.0 * 60.0 - 2.0) * 60.0, 0.0)
    got = xyz(p.force_accumulator)
    sizes = {
        "Your force contains the term -v, as printed in the book (E-6), but v is a velocity "
        "and not an acceleration. Subtract v / h instead, where h is the duration of the "
        "step.": wanted[1] + 120.0 - 2.0,
        "You add v / h instead of subtracting it, where h is the duration. p already moves by v h "
        "without a force.": wanted[1] + 240.0,
        "You compute where a real spring would take a particle at rest. Pass its velocity to "
        "damped_spring_state.": -120.0,
        "Your force ignores the velocity v, as if the particle were at rest. Subtract v / h as "
        "well, where h is the duration of the step.": wanted[1] + 120.0,
        "You compute the force only along the offset from the anchor, which is zero here. Compute "
        "it separately for x, y and z.": 0.0,
    }
    blame(got, {slip: (0.0, size, 0.0) for slip, size in sizes.items()})
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-10)


@pytest.mark.exercise("B6.11", asks="the force is therefore half that of a real spring")
def test_a_soft_spring_is_faked_too() -> None:
    about(
        "p of 1 kg at rest at (0, 0, 1); FakeStiffSpring(anchor=Vector3(), stiffness=0.5, ",
        read=READ,
    )
    about.call += "damping=0).update_force(p, 0.1)"
    about.cause = "The force of a soft spring must follow the same formula. It is about half that "
    about.cause += "of a real spring, because semi-implicit Euler moves the particle by a h^2 and "
    about.cause += "not by a h^2 / 2."
    p = Particle(Vector3(0.0, 0.0, 1.0))
    FakeStiffSpring(Vector3(), 0.5, 0.0).update_force(p, 0.1)
    wanted = (0.0, 0.0, (math.cos(0.1 * math.sqrt(0.5)) - 1.0) * 100.0)
    got = xyz(p.force_accumulator)
    only = "Your spring exerts no force along z. Compute it in the same way as along x and y."
    blame(got, [(ZERO, only)])
    # cos loses three digits, and is multiplied by 100.
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)


@pytest.mark.exercise("B6.11", asks="the particle reaches the computed position")
def test_it_lands_where_a_true_spring_would_be(rng: Random) -> None:
    about.read = READ
    anchor, place, v = components(rng), components(rng), components(rng)
    k, m, h = positive_number(rng, 50.0, 900.0), positive_number(rng), 1.0 / 30.0
    for share in (0.1, 0.6, 3.0):
        c = share * 2.0 * math.sqrt(k * m)
        about.call = f"p of {m} kg at {place} with velocity {v}; s = "
        about.call += f"FakeStiffSpring(anchor=Vector3{anchor}, stiffness={k}, damping={c:.6g}); "
        about.call += f"s.update_force(p, {h:.6g}); one step of semi-implicit Euler; p.position "
        about.call += "after the step, in m"
        about.cause = "The step must end at T, the position that a real spring would reach. "
        about.cause += "Compute T on each axis, from the position relative to the anchor, the "
        about.cause += "particle's mass and the spring's damping."
        ends = faked(anchor, place, v, k, c, m, h, 1)
        wanted = tuple(
            a + true_spring(x - a, u, k, c, m, h) for a, x, u in zip(anchor, place, v, strict=True)
        )
        axes = list(zip(anchor, place, v, wanted, strict=True))
        slips = {
            "Your force does not depend on the mass, so it is really an acceleration. Multiply "
            "it by particle.mass.": [x + u * h + (end - x - u * h) / m for _, x, u, end in axes],
            "You compute where a real spring would move a particle of 1 kg. Pass the mass of p to "
            "damped_spring_state.": [
                a + true_spring(x - a, u, k, c, 1.0, h) for a, x, u, _ in axes
            ],
            "You compute where a real spring without damping would move p. Pass self.damping to "
            "damped_spring_state.": [
                a + true_spring(x - a, u, k, 0.0, m, h) for a, x, u, _ in axes
            ],
            "You compute where a real spring with its anchor at (0, 0, 0) would move p. Use the "
            "position of p relative to self.anchor.": [
                true_spring(x, u, k, c, m, h) for _, x, u, _ in axes
            ],
        }
        blame(ends[-1], slips)
        # Divided by h^2 and multiplied by it again: a few roundings of numbers up to 20.
        expect_close(ends[-1], wanted, tolerance=1e-11)


@pytest.mark.exercise("B6.11", asks="such a spring is stable at any stiffness")
def test_a_spring_far_too_stiff_for_the_step_stays_calm(rng: Random) -> None:
    about.read = READ
    place = components(rng)
    about.call = f"p at {place}; s = FakeStiffSpring(anchor=Vector3(), stiffness=1e6, "
    about.call += "damping=200); 300 times s.update_force(p, 1/60) and a step of semi-implicit "
    about.call += "Euler"
    about.cause = "An ordinary Spring explodes with semi-implicit Euler if k h^2 / m is above 4, "
    about.cause += "and here it is 278. The faked spring must come to rest anyway, so check that "
    about.cause += "you use its damping."
    ends = faked(ZERO, place, ZERO, 1e6, 200.0, 1.0, 1.0 / 60.0, 300)
    farthest = max(math.hypot(*end) for end in ends)
    left = math.hypot(*ends[-1])
    start = math.hypot(*place)
    # After a frame a true one has e^(-100/60) of its start: 19 %.
    name = "; the largest distance from the anchor after a step, in m"
    expect_between(farthest, 0.0, 0.2 * start, then=name)
    expect_between(left, 0.0, 1e-9, then="; the distance from the anchor at the end, in m")
    about.call = "the same spring with p at rest at (1, 0, 0); p.position.x after one step, in m"
    wanted = true_spring(1.0, 0.0, 1e6, 200.0, 1.0, 1.0 / 60.0)
    got = faked(ZERO, (1.0, 0.0, 0.0), ZERO, 1e6, 200.0, 1.0, 1.0 / 60.0, 1)[-1][0]
    expect_close(got, wanted, tolerance=1e-10)


@pytest.mark.exercise("B6.11", asks="adds to the forces that the particle already has")
def test_a_faked_spring_beside_other_forces(rng: Random) -> None:
    about.read = "the docstring of FakeStiffSpring.update_force"
    f, place = components(rng), components(rng)
    about.call = f"p of 2 kg at rest at {place}; s = FakeStiffSpring(anchor=Vector3{place}, "
    about.call += f"stiffness=400, damping=3); p.add_force(Vector3{f}); s.update_force(p, 0.5); "
    about.call += "p.force_accumulator, in N"
    about.cause = "The particle is at rest at the anchor, so the spring adds no force. Keep the "
    about.cause += "other forces on p by calling add_force."
    p, s = Particle(Vector3(*place), mass=2.0), FakeStiffSpring(Vector3(*place), 400.0, 3.0)
    p.add_force(Vector3(*f))
    s.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), f, tolerance=1e-12)
    expect_unchanged("s.anchor", xyz(s.anchor), place, cause=UNCHANGED)
    expect_unchanged("p.position", xyz(p.position), place, cause=UNCHANGED)
    about.call = f"s.anchor = Vector3(); s.stiffness = 0.0; s.damping = 0.0; p at {place} with "
    about.call += f"velocity {f}; s.update_force(p, 0.5)"
    about.cause = "The check has set the stiffness and the damping to 0, so p moves at constant "
    about.cause += "velocity and needs no force. Read the attributes in every call."
    s.anchor, s.stiffness, s.damping = Vector3(), 0.0, 0.0
    p = Particle(Vector3(*place), Vector3(*f))
    s.update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, tolerance=1e-12)
    s.stiffness = 100.0
    about.call = "an immovable particle p at (1, 0, 0); s = FakeStiffSpring(anchor=Vector3(), "
    about.call += "stiffness=100, damping=0); s.update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = "You compute a force for an immovable particle, whose mass is infinite. Return "
    about.cause += "without adding a force to it."
    p = Particle(Vector3(1.0, 0.0, 0.0), mass=math.inf)
    s.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO)
    about.call = "p of 2 kg at rest at (1, 0, 0); FakeStiffSpring(anchor=Vector3(), "
    about.call += "stiffness=100, damping=0).update_force(p, 0.5)"
    about.cause = "The force is 2 (cos(chi h) - 1) / h^2 here, with chi = sqrt(100 / 2) and h = "
    about.cause += "0.5. Use the spring's current attributes and the mass of the particle that is "
    about.cause += "passed in."
    p = Particle(Vector3(1.0, 0.0, 0.0), mass=2.0)
    s.update_force(p, 0.5)
    wanted = (8.0 * (math.cos(0.5 * math.sqrt(50.0)) - 1.0), 0.0, 0.0)
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
