"""Bungees, build task B6.2: springs that only pull."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredBungee, Bungee
from draw import Components, components, direction, positive_number
from expect import UNCHANGED, about, blame, expect_close, expect_unchanged, scoped, xyz

ZERO = (0.0, 0.0, 0.0)
BOTH = ("Bungee", "AnchoredBungee")
STILL = (0.0, 0.0, 0.0)


@scoped
def rope(
    kind: str,
    base: Components,
    offset: tuple[float, ...],
    velocity: Components,
    numbers: tuple[float, float, float],
) -> tuple[str, Bungee | AnchoredBungee, Particle]:
    """Return a bungee, and a particle at an offset from its other end and a velocity from there."""
    place = tuple(b + o for b, o in zip(base, offset, strict=True))
    k, rest, c = numbers
    p = Particle(Vector3(*place), Vector3(*velocity), mass=3.0)
    if kind == "Bungee":
        other = Particle(Vector3(*base), Vector3(1.0, -2.0, 3.0))
        p.velocity += Vector3(1.0, -2.0, 3.0)
        bungee = Bungee(other, k, rest, c)
        start, end = f"q at {base} with velocity (1, -2, 3); ", "Bungee(q"
    else:
        bungee = AnchoredBungee(Vector3(*base), k, rest, c)
        start, end = "", f"AnchoredBungee(anchor=Vector3{base}"
    about.call = f"{start}p at {place}, with velocity {velocity}{' relative to q' * bool(start)}; "
    about.call += f"rope = {end}, stiffness={k}, rest_length={rest}, damping={c}); the rope is "
    about.call += f"{math.hypot(*offset):.5g} m long; rope.update_force(p, 0.5); "
    about.call += "p.force_accumulator, in N"
    return about.call, bungee, p


@pytest.mark.exercise("B6.2", asks="When it is stretched, it pulls like a spring.")
def test_a_stretched_rope_pulls(rng: Random) -> None:
    about.read = "book 6.2.3 and the docstring of Bungee"
    for kind in BOTH:
        base, d = components(rng), direction(rng)
        k, rest = positive_number(rng), positive_number(rng, 1.0, 4.0)
        for extension in (positive_number(rng, 0.3, 3.0), 1e-4):
            offset = tuple((rest + extension) * part for part in d)
            about.call, bungee, p = rope(kind, base, offset, STILL, (k, rest, 0.0))
            about.cause = (
                "The rope is longer than its rest length l0, so it must pull p toward its other "
                "end. The size of the pull is k (l - l0), where k is the stiffness and l the "
                "length."
            )
            before = xyz(p.position), xyz(p.velocity)
            bungee.update_force(p, 0.5)
            got = xyz(p.force_accumulator)
            wanted = tuple(-k * extension * part for part in d)
            slips = {
                (
                    "Your stretched rope pushes, as in the book's listing (E-4). Reverse the sign "
                    "of the force, so that it pulls p toward the other end."
                ): [-part for part in wanted],
                "Your stretched rope exerts no force. Either your condition for a slack rope is "
                "wrong, or the one for a force that would push.": ZERO,
                "You multiplied the force by the duration, which is 0.5 s here. Add the force "
                "itself.": [0.5 * part for part in wanted],
                "Your force is the stiffness times the whole length of the rope. Only the "
                "extension counts, so subtract the rest length from the length.": [
                    -k * (rest + extension) * part for part in d
                ],
                "You multiply by the whole offset, so a long rope pulls too strongly. Normalize "
                "the offset first.": [part * (rest + extension) for part in wanted],
            }
            blame(got, slips)
            if tuple(got) == ZERO:  # while it is short, does it pull if the damping is strong?
                short, (x, y, z) = tuple(0.5 * rest * part for part in d), d
                apart = (9.0 * k * x, 9.0 * k * y, 9.0 * k * z)
                _, slack, q = rope(kind, base, short, apart, (k, rest, rest))
                slack.update_force(q, 0.5)
                if any(xyz(q.force_accumulator)):
                    about.cause = "Your rope acts while it is shorter than its rest length, but "
                    about.cause += "not while it is longer. Reverse your condition for its length."
            # The offset is read from positions up to 20 m, so it is some 1e-15 m off.
            expect_close(got, wanted, tolerance=1e-12)
            expect_unchanged("p.position", xyz(p.position), before[0], cause=UNCHANGED)
            expect_unchanged("p.velocity", xyz(p.velocity), before[1], cause=UNCHANGED)


@pytest.mark.exercise("B6.2", asks="no force, unless it is longer than its rest length")
def test_a_slack_rope_exerts_no_force(rng: Random) -> None:
    about.read = "book 6.2.3 and the docstring of Bungee"
    for kind in BOTH:
        base, d = components(rng), direction(rng)
        k, rest = positive_number(rng), positive_number(rng, 2.0, 4.0)
        c = positive_number(rng)
        for share, speed, cause in (
            (
                0.5,
                0.0,
                "Your slack rope exerts a force. A rope that is shorter than its rest length "
                "must not exert any.",
            ),
            (
                0.9,
                5.0,
                "Your rope damps the motion although it is slack. A rope that is shorter than its "
                "rest length exerts no force at all, so don't add damping either.",
            ),
            (
                0.0,
                5.0,
                "Both ends are at the same position, so the rope is slack and has no "
                "direction. Add no force.",
            ),
        ):
            about.cause = cause
            offset = tuple(share * rest * part for part in d)
            velocity = (speed * d[0], speed * d[1], speed * d[2])
            about.call, bungee, p = rope(kind, base, offset, velocity, (k, rest, c))
            bungee.update_force(p, 0.5)
            got = xyz(p.force_accumulator)
            expect_close(got, ZERO)
        about.call, bungee, p = rope(kind, STILL, (2.0, 0.0, 0.0), (5.0, 0.0, 0.0), (3.0, 2.0, 3.0))
        about.cause = (
            "At exactly its rest length the rope is still slack, so it does not damp the motion "
            "either. Compare with > instead of >=."
        )
        bungee.update_force(p, 0.5)
        expect_close(xyz(p.force_accumulator), ZERO)
        about.cause = (
            "The rope was slack in an earlier call, but now it is stretched and must pull. Don't "
            "store anything between calls."
        )
        offset = tuple(2.0 * rest * part for part in d)
        about.call, bungee, p = rope(kind, base, offset, STILL, (k, rest, 0.0))
        bungee.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        wanted = tuple(-k * rest * part for part in d)
        expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B6.2", asks="damping reduces its pull, but the rope must never push")
def test_damping_of_a_rope_never_makes_it_push(rng: Random) -> None:
    about.read = "the docstring of Bungee.update_force"
    for kind in BOTH:
        base, d = components(rng), direction(rng)
        k, rest, c = positive_number(rng), positive_number(rng, 1.0, 4.0), positive_number(rng)
        extension = positive_number(rng, 0.3, 3.0)
        offset = tuple((rest + extension) * part for part in d)
        still = k * extension / c  # the speed of shortening at which nothing is left of the pull
        for share, cause in (
            (
                -0.5,
                "The rope is getting longer, and the damping c resists this by adding to the "
                "pull. The pull is k x + c l', where x is the extension and l' the rate at "
                "which the length grows.",
            ),
            (
                0.5,
                "The rope is getting shorter, and the damping c resists this by reducing the "
                "pull. The pull is k x + c l', where x is the extension and l' the rate at "
                "which the length grows.",
            ),
            (
                2.0,
                "The damping is larger than the pull here, so the sum of both would push. A "
                "rope can't push, so add no force.",
            ),
            (
                1.001,
                "The damping is slightly larger than the pull here, so the sum of both "
                "would push a little. A rope can't push at all, so add no force.",
            ),
        ):
            about.cause = cause
            speed = -share * still
            velocity = (speed * d[0], speed * d[1], speed * d[2])
            about.call, bungee, p = rope(kind, base, offset, velocity, (k, rest, c))
            bungee.update_force(p, 0.5)
            got = xyz(p.force_accumulator)
            left = max(k * extension * (1.0 - share), 0.0)
            wanted = tuple(-left * part for part in d)
            own = sum(part * u for part, u in zip(d, xyz(p.velocity), strict=True))
            slips = {
                "Your damping has no effect while the rope gets shorter. It must reduce the pull."
                if share > 0.0
                else "You left out the damping. Increase the pull by the damping times the rate at "
                "which the length grows.": [-k * extension * part for part in d],
                "Your damping has the wrong sign. It must increase the pull while the rope gets "
                "longer, and reduce it while the rope gets shorter.": [
                    -k * extension * (1.0 + share) * part for part in d
                ],
                (
                    "The damping is so large here that your rope pushes. A rope can only pull, "
                    "so add no force in this case."
                ): [-k * extension * (1.0 - share) * part for part in d],
                "Your damping uses only the velocity of p, but the motion of q changes the "
                "length too. Subtract q's velocity from p's.": [
                    -(k * extension + c * own) * part for part in d
                ],
            }
            blame(got, slips)
            expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B6.2", asks="adds to the forces that the particle already has")
def test_a_rope_adds_its_pull_to_other_forces(rng: Random) -> None:
    about.read = "the docstring of Bungee"
    f = components(rng)
    about.cause = (
        "Your rope must add a pull of 4 N along Y to the force that p already has. Use add_force, "
        "which keeps that force."
    )
    about.call = f"p at (0, -3, 0) and q at (0, 0, 0); p.add_force(Vector3{f}); Bungee(q, "
    about.call += "stiffness=2.0, rest_length=1.0).update_force(p, 0.5)"
    p, q = Particle(Vector3(0.0, -3.0, 0.0)), Particle(mass=math.inf)
    p.add_force(Vector3(*f))
    Bungee(q, 2.0, 1.0).update_force(p, 0.5)
    wanted = (f[0], f[1] + 4.0, f[2])
    expect_close(xyz(p.force_accumulator), wanted, then="; p.force_accumulator, in N")
    only = "You added a force to q as well. A Bungee acts only on the particle that is passed to "
    only += "update_force."
    expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator, in N", cause=only)
    about.read = "the docstring of AnchoredBungee"
    for kind in BOTH:
        about.call, bungee, p = rope(kind, STILL, (0.0, -3.0, 0.0), STILL, (2.0, 1.0, 0.0))
        about.call = f"p at (0, -3, 0); p.add_force(Vector3{f}); b is a {kind} with stiffness=2.0 "
        about.call += "and rest_length=1.0 whose other end is at (0, 0, 0); b.update_force(p, 0.5)"
        about.cause = (
            "Your rope must add a pull of 4 N along Y to the force that p already has. Use "
            "add_force, which keeps that force."
        )
        p.add_force(Vector3(*f))
        bungee.update_force(p, 0.5)
        wanted = (f[0], f[1] + 4.0, f[2])
        got = xyz(p.force_accumulator)
        expect_close(got, wanted, then="; p.force_accumulator, in N")
        about.call += "; p.clear_forces(); b.stiffness, b.rest_length, b.damping = 3, 2, 0.5; "
        about.call += "p.velocity.y -= 1; b.update_force(p, 0.5)"
        about.cause = (
            "The check changes the attributes of b before this call, so the pull must be 3 (3 - "
            "2) + 0.5 * 1. Read the attributes in every call instead of storing a result."
        )
        p.clear_forces()
        p.velocity = p.velocity + Vector3(0.0, -1.0, 0.0)
        bungee.stiffness, bungee.rest_length, bungee.damping = 3.0, 2.0, 0.5
        bungee.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, (0.0, 3.5, 0.0), then="; p.force_accumulator, in N")
