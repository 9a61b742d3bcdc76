"""Springs that only pull, build task B6.2, and the faked stiff spring, build task B6.11."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import places_on
from ch06_springs.springs import AnchoredBungee, Bungee, FakeStiffSpring
from draw import Triple, positive_number, unit_vector, vector
from expect import UNCHANGED, expect_between, expect_close, expect_unchanged, xyz

ZERO = Triple((0.0, 0.0, 0.0))
BOTH = ("Bungee", "AnchoredBungee")
READ = "book 6.2.3 and the docstring of Bungee"
SLACK = (
    "Your slack rope exerts a force. A rope that is shorter than its rest length must not exert "
    "any."
)
FAKE = "book 6.3.2 and the docstring of FakeStiffSpring"


def stretch(
    kind: str, base: Triple, offset: Triple, v: Triple, k: float, rest: float, c: float, cause: str
) -> tuple[Any, Any, Any]:
    """Let a rope act on p, whose offset and velocity are relative to the rope's other end."""
    w = Triple((1.0, -2.0, 3.0))  # the velocity of the other end
    if kind == "Bungee":
        with calls(cause):
            q = Particle(Vector3(*base), Vector3(*w))
            p = Particle(Vector3(*(base + offset)), Vector3(*(v + w)), mass=3.0)
            rope = Bungee(q, stiffness=k, rest_length=rest, damping=c)
            rope.update_force(p, 0.5)
            got = p.force_accumulator
    else:
        with calls(cause):
            p = Particle(Vector3(*(base + offset)), Vector3(*v), mass=3.0)
            rope = AnchoredBungee(Vector3(*base), stiffness=k, rest_length=rest, damping=c)
            rope.update_force(p, 0.5)
            got = p.force_accumulator
    return rope, p, got


@pytest.mark.exercise("B6.2", asks="When it is stretched, it pulls like a spring.", read=READ)
def test_a_stretched_rope_pulls(rng: Random) -> None:
    for kind in BOTH:
        base, d = vector(rng), unit_vector(rng)
        k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
        none = "Your stretched rope exerts no force. Either your condition for a slack rope is "
        none += "wrong, or the one for a force that would push."
        # While it is short, does it pull if the damping is strong?
        *_, short = stretch(kind, base, 0.5 * rest * d, 9.0 * k * d, k, rest, rest, SLACK)
        if any(xyz(short)):
            none = "Your rope acts while it is shorter than its rest length, but not while it is "
            none += "longer. Reverse your condition for its length."
        for extension in (positive_number(rng, 0.3, 3.0), 1e-4):
            cause = "The rope is longer than its rest length l0, so it must pull p toward its "
            cause += "other end. The pull is k (l - l0), where k is the stiffness and l the length."
            wanted, offset = -k * extension * d, (rest + extension) * d
            _, p, got = stretch(kind, base, offset, ZERO, k, rest, 0.0, cause)
            velocity = xyz(p.velocity)
            slips = {
                "Your stretched rope pushes, as in the book's listing (E-4).": -wanted,
                none: ZERO,
                "You multiplied the force by the duration, which is 0.5 s here.": 0.5 * wanted,
                "Your force is the stiffness times the whole length of the rope.": -k * offset,
                "You multiply by the whole offset instead of its direction.":
                    (rest + extension) * wanted,
            }  # fmt: skip
            # The offset is read from positions up to 20 m, so it is some 1e-15 m off.
            expect_close(got, wanted, slips, tolerance=1e-12, unit="N")
            expect_unchanged("p.position", p.position, base + offset, cause=UNCHANGED)
            expect_unchanged("p.velocity", p.velocity, velocity, cause=UNCHANGED)


@pytest.mark.exercise("B6.2", asks="no force, unless it is longer than its rest length", read=READ)
def test_a_slack_rope_exerts_no_force(rng: Random) -> None:
    for kind in BOTH:
        base, d = vector(rng), unit_vector(rng)
        k, rest, c = positive_number(rng), positive_number(rng, 2.0, 4.0), positive_number(rng)
        for share, speed, cause in (
            (0.5, 0.0, SLACK),
            (0.9, 5.0, "Your rope damps the motion although it is slack. A rope that is shorter "
             "than its rest length exerts no force at all, so don't add damping either."),
            (0.0, 5.0, "Both ends are at the same position, so the rope is slack and has no "
             "direction. Add no force."),
        ):  # fmt: skip
            *_, got = stretch(kind, base, share * rest * d, speed * d, k, rest, c, cause)
            expect_close(got, ZERO, unit="N")
        cause = "At exactly its rest length the rope is still slack. Compare with > instead of >=."
        x = Triple((1.0, 0.0, 0.0))
        *_, got = stretch(kind, ZERO, 2.0 * x, 5.0 * x, 3.0, 2.0, 3.0, cause)
        expect_close(got, ZERO, unit="N")
        cause = "The rope is stretched now, so it must pull. Don't store anything between calls."
        *_, got = stretch(kind, base, 2.0 * rest * d, ZERO, k, rest, 0.0, cause)
        expect_close(got, -k * rest * d, tolerance=1e-12, unit="N")


@pytest.mark.exercise(
    "B6.2",
    asks="damping reduces its pull, but the rope must never push",
    read="the docstring of Bungee.update_force",
)
def test_damping_of_a_rope_never_makes_it_push(rng: Random) -> None:
    pull = "the damping c. The pull is k x + c l', where x is the extension and l' the rate at "
    pull += "which the length grows."
    for kind in BOTH:
        base, d = vector(rng), unit_vector(rng)
        k, rest, c = positive_number(rng), positive_number(rng, 1.0, 4.0), positive_number(rng)
        extension = positive_number(rng, 0.3, 3.0)
        full = -k * extension * d
        for share, cause in (  # at 1, nothing is left of the pull
            (-0.5, f"The rope is getting longer, so its pull is increased by {pull}"),
            (0.5, f"The rope is getting shorter, so its pull is reduced by {pull}"),
            (2.0, "The damping is larger than the pull here, so the sum of both would push. A "
             "rope can't push, so add no force."),
            (1.001, "The damping is slightly larger than the pull here, so the sum of both "
             "would push a little. A rope can't push at all, so add no force."),
        ):  # fmt: skip
            v = -share * k * extension / c * d
            _, p, got = stretch(kind, base, (rest + extension) * d, v, k, rest, c, cause)
            slips = {
                "Your damping has no effect while the rope gets shorter."
                if share > 0.0
                else "You left out the damping.": full,
                "Your damping has the wrong sign.": (1.0 + share) * full,
                "The damping is so large here that your rope pushes. A rope can only pull, "
                "so add no force in this case.": (1.0 - share) * full,
                "Your damping uses only the velocity of p, but the motion of q changes the "
                "length too. Subtract q's velocity from p's.": full - c * (d @ xyz(p.velocity)) * d,
            }
            wanted = max(1.0 - share, 0.0) * full
            expect_close(got, wanted, slips, tolerance=1e-11, unit="N")


@pytest.mark.exercise("B6.2", asks="adds to the forces that the particle already has", read=READ)
def test_a_rope_adds_its_pull_to_other_forces(rng: Random) -> None:
    f = vector(rng)
    cause = "Add a pull of 4 N along Y with add_force, which keeps the force that p already has."
    with calls(cause):
        p, q = Particle(Vector3(0.0, -3.0, 0.0)), Particle(mass=math.inf)
        p.add_force(Vector3(*f))
        Bungee(q, stiffness=2.0, rest_length=1.0).update_force(p, 0.5)
    wanted = f + Triple((0.0, 4.0, 0.0))
    expect_close(p.force_accumulator, wanted, then="; p.force_accumulator", unit="N")
    only = "You added a force to q as well. A Bungee acts only on the particle that is passed to "
    only += "update_force."
    expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=only)
    for kind in BOTH:
        rope, p, _ = stretch(kind, ZERO, Triple((0.0, -3.0, 0.0)), ZERO, 2.0, 1.0, 0.0, cause)
        with calls(cause, more=True):
            p.clear_forces()
            p.add_force(Vector3(*f))
            rope.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, wanted, unit="N")
        with calls("It must pull with 3.5 N now. Read the attributes in every call.", more=True):
            p.clear_forces()
            p.velocity = p.velocity + Vector3(0.0, -1.0, 0.0)
            rope.stiffness, rope.rest_length, rope.damping = 3.0, 2.0, 0.5
            rope.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (0.0, 3.5, 0.0), unit="N")


def true_spring(
    place: Sequence[float], velocity: Sequence[float], k: float, c: float, m: float, t: float
) -> Triple:
    """Return where a true spring with its anchor at (0, 0, 0) takes a particle within t s."""
    root = cmath.sqrt(c * c - 4.0 * k * m)  # by the roots of m r^2 + c r + k
    r, s = (-c + root) / (2.0 * m), (-c - root) / (2.0 * m)
    first, second = cmath.exp(r * t), cmath.exp(s * t)
    return Triple(
        (((v - s * x) * first + (r * x - v) * second) / (r - s)).real
        for x, v in zip(place, velocity, strict=True)
    )


@pytest.mark.exercise("B6.11", asks="the force is m ((T - x) / h^2 - v / h)", read=FAKE)
def test_the_force_by_its_formula() -> None:
    h = 1.0 / 60.0
    with calls(
        "For a mass of 1 kg the force is (T - x) / h^2 - v / h, where T is the position that "
        "damped_spring_state gives for the spring after h seconds, and x is the position of p, "
        "both relative to the anchor."
    ):
        p = Particle(Vector3(1.0, 0.0, 0.0), acceleration=Vector3(0.0, -10.0, 0.0), damping=0.5)
        s = FakeStiffSpring(Vector3(), stiffness=400.0, damping=0.0)
        s.update_force(p, duration=h)
        got = p.force_accumulator
    size = -198.15499326694427
    sizes = {
        "You divide by h and then multiply by h again, because the book's listing says 1 / h * "
        "h (E-6). Divide by h * h instead.": size / 3600.0,
        "You use the force of a real spring, -k x.": -400.0,
        "Your force points away from T.": -size,
        "You divide by h only once.": size / 60.0,
        "You divide T by h^2 instead of T - x.": 3600.0 + size,
        "You use the velocity that a real spring would give p. Use its position, which is the "
        "first number that damped_spring_state returns.": -3600.0 * (20 * math.sin(1 / 3) + 1.0),
        "Your force gives p the velocity on a real spring, and not its position.":
            -1200.0 * math.sin(1.0 / 3.0),
        "You pass the damping of the particle to damped_spring_state, not that of the spring.":
            3600.0 * (true_spring((1.0,), (0.0,), 400.0, 0.5, 1.0, h)[0] - 1.0),
        "Your force is twice as large as it should be. In one step, an acceleration a moves p by a "
        "* h^2 and not by a * h^2 / 2, so divide by h^2.": 2.0 * size,
    }  # fmt: skip
    slips = {slip: (wrong, 0.0, 0.0) for slip, wrong in sizes.items()}
    # 1 - cos(1/3) loses a digit, and is multiplied by 3600.
    expect_close(got, (size, 0.0, 0.0), slips, tolerance=1e-10, unit="N")
    with calls("Here x = 0 and v = 2, so the force along y is T / h^2 - v / h."):
        p = Particle(velocity=Vector3(0.0, 2.0, 0.0))
        s = FakeStiffSpring(Vector3(), stiffness=400.0, damping=0.0)
        s.update_force(p, duration=h)
        got = p.force_accumulator
    size = (2.0 * math.sin(1.0 / 3.0) / 20.0 * 60.0 - 2.0) * 60.0
    sizes = {
        "Your force contains the term -v, as printed in the book (E-6), but v is a velocity "
        "and not an acceleration. Subtract v / h instead, where h is the duration of the "
        "step.": size + 120.0 - 2.0,
        "You add v / h instead of subtracting it.": size + 240.0,
        "You compute where a real spring would take a particle at rest.": -120.0,
        "Your force ignores the velocity v, as if the particle were at rest.": size + 120.0,
        "You compute the force only along the offset from the anchor, which is zero here. Compute "
        "it separately for x, y and z.": 0.0,
    }
    slips = {slip: (0.0, wrong, 0.0) for slip, wrong in sizes.items()}
    expect_close(got, (0.0, size, 0.0), slips, tolerance=1e-10, unit="N")


@pytest.mark.exercise("B6.11", asks="the force is therefore half that of a real spring", read=FAKE)
def test_a_soft_spring_is_faked_too() -> None:
    with calls("The same formula holds for a soft spring. It gives half the force of a real one."):
        p = Particle(Vector3(0.0, 0.0, 1.0))
        FakeStiffSpring(Vector3(), stiffness=0.5, damping=0.0).update_force(p, 0.1)
        got = p.force_accumulator
    wanted = (0.0, 0.0, (math.cos(0.1 * math.sqrt(0.5)) - 1.0) * 100.0)
    slips = {
        "Your spring exerts no force along z. Compute it in the same way as along x and y.": ZERO
    }
    # cos loses three digits, and is multiplied by 100.
    expect_close(got, wanted, slips, tolerance=1e-11, unit="N")


@pytest.mark.exercise("B6.11", asks="the particle reaches the computed position", read=FAKE)
def test_it_lands_where_a_true_spring_would_be(rng: Random) -> None:
    anchor, place, v = vector(rng), vector(rng), vector(rng)
    k, m, h = positive_number(rng, 50.0, 900.0), positive_number(rng), 1.0 / 30.0
    for share in (0.1, 0.6, 3.0):
        c = share * 2.0 * math.sqrt(k * m)
        with calls(
            "Pass damped_spring_state the mass of p, and its position relative to the anchor.",
            f"p of {m} kg at {place} with velocity {v}; s = FakeStiffSpring(anchor="
            f"Vector3{anchor}, stiffness={k}, damping={c:.6g}); s.update_force(p, {h:.6g}); one "
            "step of semi-implicit Euler; p.position",
        ):
            *_, end = places_on("FakeStiffSpring", (anchor, k, c), place, h, 1, velocity=v, mass=m,
                                velocity_first=True)  # fmt: skip
        offset, free = place - anchor, place + v * h
        wanted = anchor + true_spring(offset, v, k, c, m, h)
        slips = {
            "Your force does not depend on the mass. Multiply it by particle.mass.":
                free + (wanted - free) / m,
            "You compute where a real spring would move a particle of 1 kg.":
                anchor + true_spring(offset, v, k, c, 1.0, h),
            "You compute where a real spring without damping would move p.":
                anchor + true_spring(offset, v, k, 0.0, m, h),
            "You compute where a real spring with its anchor at (0, 0, 0) would move p.":
                true_spring(place, v, k, c, m, h),
        }  # fmt: skip
        # Divided by h^2 and multiplied by it again: a few roundings of numbers up to 20.
        expect_close(end, wanted, slips, tolerance=1e-11, unit="m")


@pytest.mark.exercise("B6.11", asks="such a spring is stable at any stiffness", read=FAKE)
def test_a_spring_far_too_stiff_for_the_step_stays_calm(rng: Random) -> None:
    numbers, h = (ZERO, 1e6, 200.0), 1.0 / 60.0
    calm = "An ordinary Spring explodes with semi-implicit Euler if k h^2 / m is above 4, and here "
    calm += "it is 278. The faked spring must come to rest anyway. Use all of its stiffness and "
    calm += "its damping."
    scene = "s = FakeStiffSpring(anchor=Vector3(), stiffness=1e6, damping=200); "
    place = vector(rng)
    with calls(
        calm,
        f"p at {place}; {scene}300 times s.update_force(p, 1/60) and a step of semi-implicit Euler",
    ):
        _, *ends = places_on("FakeStiffSpring", numbers, place, h, 300, velocity_first=True)
    farthest = max(math.hypot(*end) for end in ends)
    left = math.hypot(*ends[-1])
    # After a frame a true one has e^(-100/60) of its start: 19 %.
    then = "; the largest distance from the anchor after a step"
    expect_between(farthest, 0.0, 0.2 * abs(place), then=then, unit="m")
    expect_between(left, 0.0, 1e-9, then="; the distance from the anchor at the end", unit="m")
    with calls(
        calm, f"p at rest at (1, 0, 0); {scene}s.update_force(p, 1/60) and a step; p.position"
    ):
        x = (1.0, 0.0, 0.0)
        _, end = places_on("FakeStiffSpring", numbers, x, h, 1, velocity_first=True)
    wanted = true_spring(x, ZERO, 1e6, 200.0, 1.0, h)
    expect_close(end, wanted, tolerance=1e-10, unit="m")


@pytest.mark.exercise("B6.11", asks="adds to the forces that the particle already has", read=FAKE)
def test_a_faked_spring_beside_other_forces(rng: Random) -> None:
    f, place = vector(rng), vector(rng)
    with calls("p is at rest at the anchor, so add no force, and keep the other forces on p."):
        p = Particle(Vector3(*place), mass=2.0)
        s = FakeStiffSpring(Vector3(*place), stiffness=400.0, damping=3.0)
        p.add_force(Vector3(*f))
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, f, tolerance=1e-12, unit="N")
    expect_unchanged("s.anchor", s.anchor, place, cause=UNCHANGED)
    expect_unchanged("p.position", p.position, place, cause=UNCHANGED)
    with calls("Now p needs no force. Read stiffness and damping in every call.", more=True):
        s.anchor, s.stiffness, s.damping = Vector3(), 0.0, 0.0
        p = Particle(Vector3(*place), Vector3(*f))
        s.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, ZERO, tolerance=1e-12, unit="N")
    for mass, size, tolerance, cause in (
        (math.inf, 0.0, 0.0,
         "You compute a force for an immovable particle, whose mass is infinite. Return without "
         "adding a force to it."),
        (2.0, 8.0 * (math.cos(0.5 * math.sqrt(50.0)) - 1.0), 1e-11,
         "The force is 2 (cos(chi h) - 1) / h^2 here, with chi = sqrt(100 / 2) and h = 0.5. Use "
         "the spring's current attributes and the mass of the particle that is passed in."),
    ):  # fmt: skip
        with calls(cause):
            s = FakeStiffSpring(Vector3(), stiffness=0.0, damping=0.0)
            s.stiffness = 100.0
            p = Particle(Vector3(1.0, 0.0, 0.0), mass=mass)
            s.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (size, 0.0, 0.0), tolerance=tolerance, unit="N")
