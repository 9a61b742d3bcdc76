"""The penetration of a single contact, build task B7.4."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.probes import lying
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_between, expect_close, expect_that, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
MOVE = "book 7.2.2, E-8, and the docstring of Contact.resolve_penetration"
TWICE = "E-27, and the docstring of Contact.resolve_penetration"
REST = "book 7.2.3, E-26, and the docstring of Contact.resolve"
IN_PLACE = "You changed the contact's normal in place, as *= does. Use * to compute a move."
ROUNDED = 8e-14  # a few roundings of numbers up to 10


def expect_two(moves: Any) -> None:
    """Expect a tuple of two moves."""
    why = "Always return two moves, and make both of them zero vectors if nothing moves."
    two, got = isinstance(moves, (tuple, list)) and len(moves) == 2, "moves is something else"
    if moves is None:
        why, got = f"You returned None. {why}", "moves is None"
    expect_that(two, got, "moves is a tuple of two vectors", cause=why)


@pytest.mark.exercise("B7.4", asks="so the lighter one moves farther", read=MOVE)
def test_the_lighter_particle_moves_farther(rng: Random) -> None:
    place, q, m, deep = vector(rng), vector(rng), unit_vector(rng), positive_number(rng, 0.1, 0.9)
    ma, mb = positive_number(rng), positive_number(rng)
    share_of_a = "Move a by mb / (ma + mb) of the depth, so that the lighter one moves farther."
    for p, n, depth, first, second, share, cause in (
        (Triple((0.0, 2.0, 0.0)), Triple((0.0, 1.0, 0.0)), 0.5, 2.0, 6.0, 0.75, share_of_a),
        (place, m, deep, ma, mb, mb / (ma + mb), share_of_a),
        (place, m, deep, ma, math.inf, 1.0, "Only a can move here, so move it by the whole depth."),
        # Only the resolver has a tolerance. A contact resolves any depth.
        (place, m, 1e-10, math.inf, mb, 0.0, "Only b can move, so move it by the whole depth."),
    ):
        with calls(cause):
            a, b = Particle(Vector3(*p), mass=first), Particle(Vector3(*q), mass=second)
            c = Contact(a, b, normal=Vector3(*n), restitution=0.5, penetration=depth)
            moves = c.resolve_penetration()
        expect_two(moves)
        expect_unchanged("c.normal", c.normal, n, cause=IN_PLACE)
        slips = {}
        if xyz(a.velocity) != ZERO:
            slips["You added the move to the velocity of a. Add it to the position instead."] = p
        elif math.inf not in (first, second):
            slips = {
                "The masses are swapped: your heavier particle moves farther.":
                    p + n * ((1.0 - share) * depth),
                "You moved each particle by half of the depth.": p + n * (0.5 * depth),
                "You moved a by the whole depth, but b can move too.": p + n * depth,
                "You moved a toward b, but the normal points from b to a.": p - n * (share * depth),
                "The position of a didn't change.": p,
                "You multiplied by the mass of a instead of its inverse mass.":
                    p + n * (depth * first / (1.0 / first + 1.0 / second)),
            }  # fmt: skip
        move, back, name = n * (share * depth), n * ((share - 1.0) * depth), "; a.position"
        expect_close(xyz(a.position), p + move, slips, then=name, tolerance=ROUNDED, unit="m")
        why = "The position of a is right. Return the vector by which you moved a as moves[0]."
        expect_close(xyz(moves[0]), move, then="; moves[0]", cause=why, tolerance=1e-15, unit="m")
        slips = {
            "You moved b toward a. The normal points from b to a, so move b against the normal.":
                -back
        }  # fmt: skip
        if math.dist(xyz(b.position), q + back) < 1e-9:
            slips = {
                "You moved b correctly, but the vector that you returned for b points the opposite "
                "way. Return the vector that you added to the position of b.": -back
            }
        why = "Particle b moves by the rest of the depth, against the normal, as moves[1] says."
        name = "; moves[1]"
        expect_close(xyz(moves[1]), back, slips, then=name, cause=why, tolerance=1e-15, unit="m")
        name = "; b.position"
        expect_close(xyz(b.position), q + back, then=name, cause=why, tolerance=ROUNDED, unit="m")
        why = "No overlap is left. Set the penetration to 0, although the book doesn't (E-8)."
        expect_close(c.penetration, 0.0, then="; c.penetration", cause=why, unit="m")


@pytest.mark.exercise("B7.4", asks="If the penetration is 0 or negative", read=TWICE)
def test_particles_that_do_not_overlap_are_not_moved(rng: Random) -> None:
    p, q, n = vector(rng), vector(rng), unit_vector(rng)
    gap = "You closed a gap. A negative penetration means a gap, however small. Move nothing."
    for depth, mass, cause in (
        (0.0, 2.0,
         "The penetration is 0, so they just touch. Don't move either of them."),
        (-positive_number(rng), 2.0, gap),
        (-0.125, 2.0, gap),
        (-1e-10, 2.0, gap),
        (1.0, math.inf, "The sum of their inverse masses is 0. Return two zero vectors first."),
    ):  # fmt: skip
        with calls(cause):
            a, b = Particle(Vector3(*p), mass=mass), Particle(Vector3(*q), mass=mass)
            c = Contact(a, b, normal=Vector3(*n), restitution=0.5, penetration=depth)
            moves = c.resolve_penetration()
        expect_two(moves)
        zero = "No particle moves here, so make both of the moves that you return zero vectors."
        for name, now, before, why in (
            ("a.position", xyz(a.position), p, cause),
            ("b.position", xyz(b.position), q, cause),
            ("moves[0]", xyz(moves[0]), ZERO, zero),
            ("moves[1]", xyz(moves[1]), ZERO, zero),
        ):
            expect_close(now, before, then=f"; {name}", cause=why, tolerance=0.0, unit="m")
        why = "No particle moved, so leave the penetration as it is."
        expect_close(c.penetration, depth, then="; c.penetration", cause=why, unit="m")
        with calls("Both moves are the same object. Return two separate vectors.", more=True):
            moves[0].x += 1.0
        expect_close(xyz(moves[1]), ZERO, then="; moves[1]", unit="m")
    with calls("Set the penetration to 0, or the next call will move the particles again (E-8)."):
        a, b = Particle(Vector3(*p), mass=2.0), Particle(Vector3(*q), mass=2.0)
        c = Contact(a, b, normal=Vector3(*n), restitution=0.5, penetration=0.5)
        c.resolve_penetration()
    expect_close(c.penetration, 0.0, then="; c.penetration", unit="m")
    with calls("Nothing moved, so return zero vectors, not the first moves (E-27).", more=True):
        moves = c.resolve_penetration()
    expect_close(xyz(moves[0]), ZERO, then="; moves[0]", unit="m")
    expect_close(xyz(moves[1]), ZERO, then="; moves[1]", unit="m")


@pytest.mark.exercise("B7.4", asks="as two new vectors", read=MOVE)
def test_the_moves_are_new_vectors(rng: Random) -> None:
    p, q, n = vector(rng), vector(rng), unit_vector(rng)
    separate = "The returned vectors are the contact's normal or a particle's position, so "
    separate += "changing them changes the contact or the particle. Return two new vectors."
    with calls(separate):
        a = Particle(Vector3(*p))
        c = Contact(a, None, normal=Vector3(*n), restitution=0.5, penetration=0.5)
        moves = c.resolve_penetration()
    expect_unchanged("c.normal", c.normal, n, cause=IN_PLACE)
    why = "Only a can move, by the whole depth. Return its displacement and a zero vector."
    expect_close(xyz(moves[0]), n * 0.5, then="; moves[0]", cause=why, tolerance=1e-15, unit="m")
    expect_close(xyz(moves[1]), ZERO, then="; moves[1]", cause=why, unit="m")
    with calls(separate, more=True):
        moves[0].x += 1.0
        moves[1].x += 1.0
    expect_unchanged("c.normal", c.normal, n)
    expect_close(xyz(a.position), p + n * 0.5, then="; a.position", tolerance=ROUNDED, unit="m")
    with calls(separate):
        a, b = Particle(Vector3(*p)), Particle(Vector3(*q))
        c = Contact(a, b, normal=Vector3(*n), restitution=0.5, penetration=0.5)
        moves = c.resolve_penetration()
        moves[0].x += 1.0
        moves[1].x += 1.0
    expect_unchanged("c.normal", c.normal, n)
    why = "resolve_penetration should change only positions, but it changed a velocity."
    for name, particle, wanted in (("a", a, p + n * 0.25), ("b", b, q - n * 0.25)):
        got, position = particle.position, f"; {name}.position"
        expect_close(got, wanted, then=position, tolerance=ROUNDED, unit="m")
        expect_close(xyz(particle.velocity), ZERO, then=f"; {name}.velocity", cause=why, unit="m/s")


@pytest.mark.exercise("B7.4", asks="Move the two particles apart along the normal", read=REST)
def test_a_resting_body_stays_on_the_ground() -> None:
    """Only here many steps would add up a small sinking or bouncing."""
    for restitution, generated in ((0.0, False), (0.5, True), (0.9, False), (0.9, True)):
        gravity = "a force added in every step" if generated else "the body's acceleration"
        with calls(
            "The body sinks into the ground, perhaps because you resolve only its velocity. "
            "Contact.resolve should call resolve_velocity and then resolve_penetration.",
            f"a body at rest on the ground, where gravity is {gravity}; 900 semi-implicit steps of "
            f"1/60 s, each followed by contact.resolve(1/60) with a restitution of {restitution}",
        ):
            heights, fastest = lying(restitution, generated)
        # Up to a millimeter counts as rest; rounding leaves some 1e-15 m.
        name = "; the lowest height of the body"
        expect_between(min(heights), -1e-3, 1e-3, then=name, unit="m")
        why = "Pass the duration to resolve_velocity, so that gravity's velocity doesn't bounce."
        name = "; the largest height of the body"
        expect_between(max(heights), -1e-3, 1e-3, then=name, cause=why, unit="m")
        # Without the rule it is at 0.08 m/s, at a restitution of 0.5, and more.
        name = "; the largest speed after a step"
        expect_between(fastest, -1e-6, 1e-6, then=name, cause=why, unit="m/s")
