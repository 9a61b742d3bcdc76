"""The penetration of a single contact, build task B7.4."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.probes import lying
from draw import components, direction, positive_number
from expect import (
    about,
    cause_of,
    expect_between,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    xyz,
)
from impacts import of_mass

ZERO = (0.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
MOVE = "book 7.2.2, E-8, and the docstring of Contact.resolve_penetration"


def expect_two(moves: Any) -> None:
    """Expect a tuple of two moves."""
    none = "You returned None. Always return two moves, and make both of them zero vectors if "
    none += "nothing moves."
    two, got = isinstance(moves, (tuple, list)) and len(moves) == 2, "moves is None"
    if moves is not None:
        none, got = none.removeprefix("You returned None. "), "moves is something else"
    expect_that(two, got, "moves is a tuple of two vectors", cause=none)


@pytest.mark.exercise("B7.4", asks="so the lighter one moves farther")
def test_the_lighter_particle_moves_farther(rng: Random) -> None:
    about.read = MOVE
    p, q, n = components(rng), components(rng), direction(rng)
    ma, mb, depth = positive_number(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    wall = math.inf
    share_of_a = "You moved a by the wrong distance. Divide the depth between both particles: a "
    share_of_a += "moves by mb / (ma + mb) of it, so the lighter particle moves farther."
    whole_a = "Only a can move here, so move it by the whole depth, whatever its mass is."
    simple, drawn = ((0.0, 2.0, 0.0), UP, 0.5), (p, n, depth)
    small = (p, n, 1e-10)  # only the resolver has a tolerance; a contact resolves any depth
    for (p, n, depth), first, second, share, cause in (
        (simple, 2.0, 6.0, 0.75, share_of_a),
        (drawn, ma, mb, mb / (ma + mb), share_of_a),
        (drawn, ma, wall, 1.0, whole_a),
        (small, wall, mb, 0.0, "Particle a is immovable, so move b by the whole depth."),
        (small, ma, None, 1.0, whole_a),
    ):
        about(cause=cause)
        there = "" if second is None else f"particle b ({of_mass(second)}) at {q}; "
        about.call = f"particle a ({of_mass(first)}) at {p}; {there}c = Contact(a, "
        about.call += f"{'b' if there else 'None'}, normal=Vector3{n}, restitution=0.5, "
        about.call += f"penetration={depth}); moves = c.resolve_penetration()"
        a = Particle(Vector3(*p), mass=first)
        b = None if second is None else Particle(Vector3(*q), mass=second)
        contact = Contact(a, b, Vector3(*n), 0.5, depth)
        moves = contact.resolve_penetration()
        expect_two(moves)
        got = xyz(contact.normal)
        whole = "You changed the contact's normal in place, as *= does. Use * to compute each "
        whole += "move, because it creates a new vector."
        expect_unchanged("c.normal", got, n, cause=whole)
        move = tuple(share * depth * part for part in n)
        back = tuple((share - 1.0) * depth * part for part in n)
        wanted = tuple(x + m for x, m in zip(p, move, strict=True))
        got = xyz(a.position)
        mistakes = [
            ((1.0 - share) * depth, "The masses are swapped: your heavier particle moves farther. "
                                    "Move a by mb / (ma + mb) of the depth."),
            (0.5 * depth,
             "You moved each particle by half of the depth, which is right only for equal masses. "
             "Move a by mb / (ma + mb) of the depth."),
            (depth, "You moved a by the whole depth, but b can move too. Divide the depth between "
                    "them in proportion to their inverse masses."),
            (-share * depth, "You moved a toward b, so the particles overlap even more. The "
                             "normal points from b to a, so move a along +n."),
            (0.0, "The position of a didn't change. Add the vector that you return as the first "
                  "move to the position of a."),
        ]  # fmt: skip
        if both := first != wall and second not in (wall, None):
            times = "You multiplied by the mass of a. Multiply by its inverse mass, so that the "
            times += "lighter particle moves farther."
            mistakes.append((depth * first / (1.0 / first + 1.0 / second), times))
        if xyz(a.velocity) != ZERO:
            why = "You added the move to the velocity of a. Add it to the position of a instead."
            mistakes = [(0.0, why)]
        moved = [(tuple(x + s * y for x, y in zip(p, n, strict=True)), why) for s, why in mistakes]
        seen = cause_of(got, moved, about.cause) if both else about.cause
        # A few roundings of numbers up to 10.
        expect_close(got, wanted, then="; a.position", cause=seen, tolerance=1e-14 * 8, unit="m")
        got = xyz(moves[0])
        first_move = "a is at the right position, but moves[0] is not the displacement of a. "
        first_move += "Return the vector by which you moved a."
        expect_close(got, move, then="; moves[0]", cause=first_move, tolerance=1e-15, unit="m")
        about.cause = "Particle b moves by the rest of the depth, against the normal. Return this "
        about.cause += "displacement as the second move, or zero if b doesn't move."
        got = xyz(moves[1])
        turned = tuple(-part for part in back)
        why = "You moved b toward a. The normal points from b to a, so move b against the normal."
        there = [*map(sum, zip(q, back, strict=True))]
        if b is not None and math.dist(xyz(b.position), there) < 1e-9:
            why = "You moved b correctly, but the vector that you returned for b points the "
            why += "opposite way. Return the vector that you added to the position of b."
        seen = cause_of(got, [(turned, why)], about.cause)
        expect_close(got, back, then="; moves[1]", cause=seen, tolerance=1e-15, unit="m")
        if b is not None:
            wanted = tuple(x + m for x, m in zip(q, back, strict=True))
            got = xyz(b.position)
            expect_close(got, wanted, then="; b.position", tolerance=1e-14 * 8, unit="m")
        about.cause = "After this move there is no overlap left. Set the contact's penetration to "
        about.cause += "0, although the book's listing doesn't (E-8)."
        got = contact.penetration
        expect_close(got, 0.0, then="; c.penetration", unit="m")


@pytest.mark.exercise("B7.4", asks="If the penetration is 0 or negative")
def test_particles_that_do_not_overlap_are_not_moved(rng: Random) -> None:
    about.read = "E-27, and the docstring of Contact.resolve_penetration"
    p, q, n = components(rng), components(rng), direction(rng)
    gap = "You closed a gap. A negative penetration means that the particles don't touch, so don't "
    gap += "move them, however small the gap is."
    for depth, mass, cause in (
        (0.0, 2.0,
         "You moved the particles, but the penetration is 0, so they just touch. Don't move "
         "either of them."),
        (-positive_number(rng), 2.0, gap),
        (-0.125, 2.0, gap),
        (-1e-10, 2.0, gap),
        (1.0, math.inf, "Both particles are immovable, so the sum of their inverse masses is 0. "
                        "Return two zero vectors before you divide by this sum."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"particle a ({of_mass(mass)}) at {p}; particle b ({of_mass(mass)}) at {q}; c "
        about.call += f"= Contact(a, b, normal=Vector3{n}, restitution=0.5, penetration={depth}); "
        about.call += "moves = c.resolve_penetration()"
        a, b = Particle(Vector3(*p), mass=mass), Particle(Vector3(*q), mass=mass)
        c = Contact(a, b, Vector3(*n), 0.5, depth)
        moves = c.resolve_penetration()
        expect_two(moves)
        zero = "No particle moves here, so make both of the moves that you return zero vectors."
        for name, now, before in (
            ("a.position", xyz(a.position), p),
            ("b.position", xyz(b.position), q),
            ("moves[0]", xyz(moves[0]), ZERO),
            ("moves[1]", xyz(moves[1]), ZERO),
        ):
            why = zero if "moves" in name else about.cause
            expect_close(now, before, then=f"; {name}", cause=why, tolerance=0.0, unit="m")
        got = c.penetration
        about.cause = "You changed the penetration although no particle moved. Set it to 0 only "
        about.cause += "after you have moved a particle."
        expect_close(got, depth, then="; c.penetration", unit="m")
        moves[0].x += 1.0
        about.cause = "Both moves are the same Vector3 object, so changing one changes the other. "
        about.cause += "Return two separate vectors."
        got = xyz(moves[1])
        expect_close(got, ZERO, then="; moves[0].x += 1; moves[1]", unit="m")
    about.call = f"particle a (2 kg) at {p}; particle b (2 kg) at {q}; c = Contact(a, b, "
    about.call += f"normal=Vector3{n}, restitution=0.5, penetration=0.5); c.resolve_penetration()"
    a, b = Particle(Vector3(*p), mass=2.0), Particle(Vector3(*q), mass=2.0)
    c = Contact(a, b, Vector3(*n), 0.5, 0.5)
    c.resolve_penetration()
    about.cause = "You moved the particles but didn't change the contact's penetration. Set it to "
    about.cause += "0, or the next call will move the particles again (E-8)."
    got = c.penetration
    expect_close(got, 0.0, then="; c.penetration", unit="m")
    about.call += "; moves = c.resolve_penetration()"
    about.cause = "The second call moved nothing, so both of its moves should be zero vectors. "
    about.cause += "Don't return the moves of the first call again (E-27)."
    moves = c.resolve_penetration()
    got = (*xyz(moves[0]), *xyz(moves[1]))
    expect_close(got, ZERO + ZERO, then="; moves[0] and moves[1] in one tuple", unit="m")


@pytest.mark.exercise("B7.4", asks="as two new vectors")
def test_the_moves_are_new_vectors(rng: Random) -> None:
    about.read = MOVE
    p, q, n = components(rng), components(rng), direction(rng)
    about.call = f"particle a at {p}; c = Contact(a, None, normal=Vector3{n}, restitution=0.5, "
    about.call += "penetration=1.0); moves = c.resolve_penetration(); moves[0].x += 1; moves[1].x "
    about.call += "+= 1"
    separate = "The returned vectors are the contact's normal or a particle's position, so "
    separate += "changing them changes the contact or the particle. Return two new vectors."
    about.cause = separate
    a = Particle(Vector3(*p))
    c = Contact(a, None, Vector3(*n), 0.5, 1.0)
    moves = c.resolve_penetration()
    moves[0].x += 1.0
    moves[1].x += 1.0
    got = xyz(c.normal)
    expect_unchanged("c.normal", got, n)
    got = xyz(a.position)
    wanted = tuple(x + part for x, part in zip(p, n, strict=True))
    shown = f"{about.call}; a.position"
    expect_close(got, wanted, call=shown, tolerance=1e-14 * 8, unit="m")
    about.call = f"particle a at {p}; particle b at {q}; c = Contact(a, b, normal=Vector3{n}, "
    about.call += "restitution=0.5, penetration=0.5); moves = c.resolve_penetration(); moves[0].x "
    about.call += "+= 1; moves[1].x += 1"
    about.cause = separate
    a, b = Particle(Vector3(*p)), Particle(Vector3(*q))
    c = Contact(a, b, Vector3(*n), 0.5, 0.5)
    moves = c.resolve_penetration()
    moves[0].x += 1.0
    moves[1].x += 1.0
    got = xyz(c.normal)
    expect_unchanged("c.normal", got, n)
    for name, particle, place, sign in (("a", a, p, 0.25), ("b", b, q, -0.25)):
        wanted = tuple(x + sign * part for x, part in zip(place, n, strict=True))
        got = xyz(particle.position)
        shown = f"{about.call}; {name}.position"
        expect_close(got, wanted, call=shown, tolerance=1e-14 * 8, unit="m")
        got = xyz(particle.velocity)
        shown = f"{about.call}; {name}.velocity"
        about.cause = "resolve_penetration has changed a velocity. It should change only "
        about.cause += "positions, and leave velocities to resolve_velocity."
        expect_close(got, ZERO, call=shown, unit="m/s")


@pytest.mark.exercise("B7.4", asks="Move the two particles apart along the normal")
def test_a_resting_body_stays_on_the_ground() -> None:
    about.read = "book 7.2.3, E-26, and the docstring of Contact.resolve"
    for restitution, generated in ((0.0, False), (0.5, True), (0.9, False), (0.9, True)):
        gravity = "a force added in every step" if generated else "the body's acceleration"
        about.call = f"a body at rest on the ground, where gravity is {gravity}; 900 semi-implicit "
        about.call += "steps of 1/60 s, each followed by contact.resolve(1/60) with a restitution "
        about.call += f"of {restitution}"
        sinks = "The body sinks into the ground, perhaps because you resolve only its velocity. "
        sinks += "Contact.resolve should call resolve_velocity and then resolve_penetration."
        jumps = "The bounce includes the velocity that gravity adds in each time step. Pass the "
        jumps += "duration to resolve_velocity, which leaves this velocity out."
        about.cause = sinks
        heights, fastest = lying(restitution, generated, 900, 1.0 / 60.0)
        # Up to a millimeter counts as rest; rounding leaves some 1e-15 m.
        name = "; the lowest height of the body"
        expect_between(min(heights), -1e-3, 1e-3, then=name, cause=sinks, unit="m")
        name = "; the largest height of the body"
        expect_between(max(heights), -1e-3, 1e-3, then=name, cause=jumps, unit="m")
        # Without the rule it is at 0.08 m/s, at a restitution of 0.5, and more.
        name = "; the largest speed after a step"
        expect_between(fastest, -1e-6, 1e-6, then=name, cause=jumps, unit="m/s")
        expect_exactly(len(heights), 900, then="; the number of steps")
