"""Bungees, build task B6.2: springs that only pull."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredBungee, Bungee
from draw import Triple, positive_number, unit_vector, vector
from expect import UNCHANGED, expect_close, expect_unchanged, xyz

ZERO = Triple((0.0, 0.0, 0.0))
BOTH = ("Bungee", "AnchoredBungee")
READ = "book 6.2.3 and the docstring of Bungee"
SLACK = (
    "Your slack rope exerts a force. A rope that is shorter than its rest length must not exert "
    "any."
)


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
        cause = "At exactly its rest length the rope is still slack, so it does not damp the "
        cause += "motion either. Compare with > instead of >=."
        x = Triple((1.0, 0.0, 0.0))
        *_, got = stretch(kind, ZERO, 2.0 * x, 5.0 * x, 3.0, 2.0, 3.0, cause)
        expect_close(got, ZERO, unit="N")
        cause = "The rope was slack in an earlier call, but now it is stretched and must pull. "
        cause += "Don't store anything between calls."
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


@pytest.mark.exercise(
    "B6.2",
    asks="adds to the forces that the particle already has",
    read="the docstrings of Bungee and AnchoredBungee",
)
def test_a_rope_adds_its_pull_to_other_forces(rng: Random) -> None:
    f = vector(rng)
    cause = "Your rope must add a pull of 4 N along Y to the force that p already has. Use "
    cause += "add_force, which keeps that force."
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
        with calls(
            "The check changes the attributes of the rope before this call, so the pull must be 3 "
            "(3 - 2) + 0.5 * 1. Read the attributes in every call instead of storing a result.",
            more=True,
        ):
            p.clear_forces()
            p.velocity = p.velocity + Vector3(0.0, -1.0, 0.0)
            rope.stiffness, rope.rest_length, rope.damping = 3.0, 2.0, 0.5
            rope.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, (0.0, 3.5, 0.0), unit="N")
