"""Resolving a single contact: its impulse and its penetration, build tasks B7.3 and B7.4."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.probes import lying
from draw import Components, components, direction, dot, number, positive_number
from expect import (
    about,
    cause_of,
    expect_between,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
IMPULSE = "book 7.1.4, and the docstring of Contact.resolve_velocity"
MOVE = "book 7.2.2, E-8, and the docstring of Contact.resolve_penetration"


def along(
    v: Components, n: Components, mistakes: Sequence[tuple[float, str]]
) -> list[tuple[Components, str]]:
    """Return the mistakes with v + s n in place of each number s."""
    return [((v[0] + s * n[0], v[1] + s * n[1], v[2] + s * n[2]), name) for s, name in mistakes]


def closing_velocities(rng: Random, n: Components) -> tuple[Components, Components]:
    """Draw two velocities that approach each other along n at 1 m/s or more."""
    v, w = components(rng), components(rng)
    while dot(w, n) - dot(v, n) < 1.0:
        v, w = components(rng), components(rng)
    return v, w


@pytest.mark.exercise("B7.3")
def test_two_balls_bounce_by_the_inverse_of_their_masses(rng: Random) -> None:
    about.read = IMPULSE
    n = direction(rng)
    v, w = closing_velocities(rng, n)
    samples = [
        ((3.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), 1.0, 2.0, 0.5),
        (v, w, n, positive_number(rng), positive_number(rng), round(rng.uniform(0.1, 0.9), 3)),
    ]
    for v, w, n, ma, mb, c in samples:
        about.call = f"a of {ma} kg, velocity {v}; b of {mb} kg, velocity {w}; Contact(a, b, "
        about.call += f"Vector3{n}, {c}).resolve_velocity()"
        a = Particle(velocity=Vector3(*v), mass=ma)
        b = Particle(velocity=Vector3(*w), mass=mb)
        about.cause = "The impulse is the change of the separating velocity, from v_s to -c v_s, "
        about.cause += "divided by 1 / ma + 1 / mb. It changes a's velocity by n g / ma."
        Contact(a, b, Vector3(*n), c).resolve_velocity()
        closing = dot(v, n) - dot(w, n)
        change = -(1.0 + c) * closing
        wanted_a = tuple(p + mb / (ma + mb) * change * q for p, q in zip(v, n, strict=True))
        wanted_b = tuple(p - ma / (ma + mb) * change * q for p, q in zip(w, n, strict=True))
        got = xyz(a.velocity)
        impulse = change * ma * mb / (ma + mb)
        momentum = "An impulse changes the momentum, not the velocity (E-24). Divide by the mass"
        unlike = -c * closing * impulse / change  # as if it had been at rest before
        mistakes = [
            (change / ma, "The change of velocity was used as the impulse. First divide it by "
             "1 / ma + 1 / mb."),
            (impulse / mb, "The masses are swapped. The impulse changes a's velocity by n g / ma."),
            (-impulse / ma, "The impulse has the wrong sign and makes the contact close faster."),
            (unlike / ma, "v_s is missing from the change. The separating velocity changes from "
             "v_s to -c v_s."),
            (impulse, f"{momentum}: n g / ma."),
        ]  # fmt: skip
        seen = cause_of(got, along(v, n, mistakes), about.cause)
        # A few roundings of numbers up to 40.
        expect_close(got, wanted_a, then="; a.velocity", cause=seen, tolerance=1e-12)
        got = xyz(b.velocity)
        mistakes = [
            (0.0, "The velocity of b did not change. Add -n g / mb to it."),
            (impulse / mb, "b got the impulse with the same sign as a. Add -n g / mb to it."),
            (-impulse, f"{momentum}: -n g / mb."),
        ]
        otherwise = "b gets the opposite impulse, so its velocity changes by -n g / mb."
        about.cause = cause_of(got, along(w, n, mistakes), otherwise)
        expect_close(got, wanted_b, then="; b.velocity", tolerance=1e-12)


@pytest.mark.exercise("B7.3")
def test_momentum_is_kept_and_energy_lost(rng: Random) -> None:
    about.read = "book 7.1.2 and E-7"
    n, ma, mb = direction(rng), positive_number(rng), positive_number(rng)
    for c in (0.0, 0.5, 1.0):
        v, w = closing_velocities(rng, n)
        about.call = f"a of {ma} kg, velocity {v}; b of {mb} kg, velocity {w}; Contact(a, b, "
        about.call += f"Vector3{n}, {c}).resolve_velocity()"
        about.cause = "Momentum is conserved at every restitution. What a gains, b must lose."
        a = Particle(velocity=Vector3(*v), mass=ma)
        b = Particle(velocity=Vector3(*w), mass=mb)
        Contact(a, b, Vector3(*n), c).resolve_velocity()
        va, vb = xyz(a.velocity), xyz(b.velocity)
        got = tuple(ma * p + mb * q for p, q in zip(va, vb, strict=True))
        wanted = tuple(ma * p + mb * q for p, q in zip(v, w, strict=True))
        name = f"{about.call}; the momentum of both"
        # Some roundings of numbers up to 200.
        expect_close(got, wanted, call=name, tolerance=1e-11)
        lost = 0.5 * ma * (dot(v, v) - dot(va, va)) + 0.5 * mb * (dot(w, w) - dot(vb, vb))
        closing = dot(w, n) - dot(v, n)
        wanted = 0.5 * ma * mb / (ma + mb) * (1.0 - c * c) * closing * closing
        name = f"{about.call}; the loss of kinetic energy"
        about.cause = "The loss is mu (1 - c^2) v_s^2 / 2 with mu = ma mb / (ma + mb). In an "
        about.cause += "elastic bounce (c = 1) no kinetic energy is lost (E-7)."
        expect_close(lost, wanted, call=name, tolerance=1e-10)


@pytest.mark.exercise("B7.3")
def test_a_wall_takes_any_impulse(rng: Random) -> None:
    about.read = IMPULSE
    n, c, mass = direction(rng), round(rng.uniform(0.1, 0.9), 3), positive_number(rng)
    v = components(rng)
    if dot(v, n) > 0.0:
        v = (-v[0], -v[1], -v[2])
    wanted = tuple(p - (1.0 + c) * dot(v, n) * q for p, q in zip(v, n, strict=True))
    turned = tuple(-part for part in n)
    for told, normal in (("Contact(a, None", n), ("Contact(a, w", n), ("Contact(w, a", turned)):
        about.call = f"a of {mass} kg, velocity {v}; w immovable; {told}, Vector3{normal}, "
        about.call += f"{c}).resolve_velocity()"
        about.cause = "The inverse mass of the wall is 0, so a gets the whole change of velocity, "
        about.cause += "whatever its mass is."
        a, w = Particle(velocity=Vector3(*v), mass=mass), Particle(mass=math.inf)
        ends = {"Contact(a, None": (a, None), "Contact(a, w": (a, w), "Contact(w, a": (w, a)}[told]
        Contact(*ends, Vector3(*normal), c).resolve_velocity()
        got = xyz(a.velocity)
        expect_close(got, wanted, then="; a.velocity", tolerance=1e-12)
        about.cause = "An immovable particle must keep its velocity."
        got = xyz(w.velocity)
        expect_close(got, ZERO, then="; w.velocity")


@pytest.mark.exercise("B7.3")
def test_what_parts_or_cannot_be_moved_gets_no_impulse(rng: Random) -> None:
    about.read = IMPULSE
    v, w, n = components(rng), components(rng), direction(rng)
    if dot(v, n) < dot(w, n):
        v, w = w, v
    for mass, first, second, cause in (
        (2.0, v, w, "The two particles are separating already, so they need no impulse."),
        (math.inf, w, v, "Both particles are immovable, so the sum of the inverse masses is 0. "
         "Return before you divide by it."),
    ):  # fmt: skip
        about(f"a and b of {mass} kg, velocities {first} and {second}; Contact(a, b, ", cause=cause)
        about.call += f"Vector3{n}, 0.5, 1.0).resolve_velocity(0.5)"
        a, b = (Particle(velocity=Vector3(*u), mass=mass) for u in (first, second))
        Contact(a, b, Vector3(*n), 0.5, 1.0).resolve_velocity(0.5)
        got = xyz(a.velocity)
        expect_unchanged("a.velocity", got, first)
        got = xyz(b.velocity)
        expect_unchanged("b.velocity", got, second)
    about.call = f"a with velocity {w}, b with {v}; c = Contact(a, b, Vector3{n}, 0.0, -1.0); "
    about.call += "a.add_force(Vector3(1, 2, 3)); c.resolve_velocity(0.5)"
    about.cause = "At restitution 0 a contact that was closing must have a separating velocity of "
    about.cause += "0, whatever its penetration is."
    a, b = (Particle(velocity=Vector3(*u)) for u in (w, v))
    a.add_force(Vector3(1.0, 2.0, 3.0))
    c = Contact(a, b, Vector3(*n), 0.0, -1.0)
    c.resolve_velocity(0.5)
    got = dot(xyz(a.velocity), n) - dot(xyz(b.velocity), n)
    expect_close(got, 0.0, tolerance=1e-13)
    for name, now, before in (
        ("c.normal", xyz(c.normal), n),
        ("c.restitution and c.penetration", (c.restitution, c.penetration), (0.0, -1.0)),
        ("a.force_accumulator", xyz(a.force_accumulator), (1.0, 2.0, 3.0)),
    ):
        about.cause = "Change the two velocities and nothing else."
        expect_unchanged(name, now, before)


@pytest.mark.exercise("B7.3")
def test_an_impulse_leaves_rest_at_rest(rng: Random) -> None:
    about.read = "book 7.2.3, and the docstring of Contact.resolve_velocity"
    h, c, side = 0.02, round(rng.uniform(0.3, 0.9), 3), number(rng)
    about.call = f"a with velocity ({side}, {-9.0 * h}, 0), acceleration (0, -9, 0); Contact(a, "
    about.call += f"None, Vector3(0, 1, 0), {c}, 0.125).resolve_velocity({h})"
    about.cause = "Pass the duration to velocity_after. It leaves the velocity that this time step "
    about.cause += "has built up out of the bounce."
    a = Particle(None, Vector3(side, -9.0 * h, 0.0), Vector3(0.0, -9.0, 0.0), mass=3.0)
    Contact(a, None, Vector3(*UP), c, 0.125).resolve_velocity(h)
    got = xyz(a.velocity)
    expect_close(got, (side, 0.0, 0.0), then="; a.velocity")
    about.cause = "Change velocities only. Moving the particles is left to resolve_penetration."
    got = xyz(a.position)
    expect_close(got, ZERO, then="; a.position")


@pytest.mark.exercise("B7.3")
@pytest.mark.robust
def test_an_impulse_needs_a_duration_that_means_something() -> None:
    about.read = IMPULSE
    for velocity, mass in ((-1.0, 2.0), (1.0, 2.0), (-1.0, math.inf)):
        for duration in (-0.5, math.nan, math.inf):
            about.call = f"Contact(a, None, Vector3(0, 1, 0)).resolve_velocity({duration}), a of "
            about.call += f"{mass} kg with velocity (0, {velocity}, 0)"
            about.cause = "Call velocity_after first. It refuses such a duration in every case."
            a = Particle(velocity=Vector3(0.0, velocity, 0.0), mass=mass)
            contact = Contact(a, None, Vector3(*UP))
            expect_error(
                lambda contact=contact, duration=duration: contact.resolve_velocity(duration),
                ValueError,
                allowed=lambda: Contact(Particle(), None, Vector3(*UP)).resolve_velocity(0.5),
            )
            got = xyz(a.velocity)
            before = (0.0, velocity, 0.0)
            expect_unchanged("a.velocity", got, before)


@pytest.mark.exercise("B7.4")
def test_the_lighter_one_moves_more(rng: Random) -> None:
    about.read = MOVE
    p, q, n = components(rng), components(rng), direction(rng)
    ma, mb, depth = positive_number(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    wall = math.inf
    share_of_a = "The depth is divided by inverse mass: a moves by mb / (ma + mb) of it."
    whole_a = "Nothing else can move here, so a moves by the whole depth, whatever its mass is."
    simple, drawn = ((0.0, 2.0, 0.0), UP, 0.5), (p, n, depth)
    small = (p, n, 1e-10)  # only the resolver has a tolerance; a contact resolves any depth
    for (p, n, depth), first, second, share, cause in (
        (simple, 1.0, 3.0, 0.75, share_of_a),
        (drawn, ma, mb, mb / (ma + mb), share_of_a),
        (drawn, ma, wall, 1.0, whole_a),
        (small, wall, mb, 0.0, "a is immovable, so b moves by the whole depth."),
        (small, ma, None, 1.0, whole_a),
    ):
        about(f"a of {first} kg at {p}, b ", cause=cause)
        about.call += f"{'None' if second is None else f'of {second} kg'}; moves = Contact(a, b, "
        about.call += f"Vector3{n}, 0.5, {depth}).resolve_penetration()"
        a = Particle(Vector3(*p), mass=first)
        b = None if second is None else Particle(Vector3(*q), mass=second)
        contact = Contact(a, b, Vector3(*n), 0.5, depth)
        moves = contact.resolve_penetration()
        got = xyz(contact.normal)
        whole = "The contact's normal changed: *= and normalize work in place. Use a new vector."
        expect_unchanged("the normal", got, n, cause=whole)
        move = tuple(share * depth * part for part in n)
        back = tuple((share - 1.0) * depth * part for part in n)
        wanted = tuple(x + m for x, m in zip(p, move, strict=True))
        got = xyz(a.position)
        mistakes = [
            ((1.0 - share) * depth, "The masses are swapped. The lighter particle moves farther."),
            (0.5 * depth,
             "Both particles moved by half of the depth. The lighter one must move farther."),
            (depth, "a moved by the whole depth. b can move too, so divide the depth by inverse "
             "mass."),
            (-share * depth, "The sign is wrong. The normal points from b to a, so a moves along "
             "+n."),
            (0.0, "a did not move. Change its position."),
        ]  # fmt: skip
        both = first != wall and second not in (wall, None)
        seen = cause_of(got, along(p, n, mistakes), about.cause) if both else about.cause
        # A few roundings of numbers up to 10.
        expect_close(got, wanted, then="; a.position", cause=seen, tolerance=1e-14 * 8)
        got = xyz(moves[0])
        expect_close(got, move, then="; moves[0]", tolerance=1e-15)
        about.cause = "b moves against the normal, by the rest of the depth."
        got = xyz(moves[1])
        turned = tuple(-part for part in back)
        why = "The move of b has the wrong sign. It goes along -n."
        seen = cause_of(got, [(turned, why)], about.cause)
        expect_close(got, back, then="; moves[1]", cause=seen, tolerance=1e-15)
        if b is not None:
            wanted = tuple(x + m for x, m in zip(q, back, strict=True))
            got = xyz(b.position)
            expect_close(got, wanted, then="; b.position", tolerance=1e-14 * 8)
        about.cause = "The particles only touch now. Set the penetration to 0, which the book's "
        about.cause += "listing does not do (E-8)."
        got = contact.penetration
        expect_close(got, 0.0, then="; penetration")


@pytest.mark.exercise("B7.4")
def test_what_is_not_in_each_other_is_not_moved(rng: Random) -> None:
    about.read = "E-27, and the docstring of Contact.resolve_penetration"
    p, q, n = components(rng), components(rng), direction(rng)
    gap = "A negative penetration is a gap. Do not change it, however small it is."
    for depth, mass, cause in (
        (0.0, 2.0, "The two particles only touch, so nothing must move."),
        (-positive_number(rng), 2.0, gap),
        (-0.125, 2.0, gap),
        (-1e-10, 2.0, gap),
        (1.0, math.inf, "Both are immovable, so the sum of the inverse masses is 0. Return before "
         "you divide by it."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"a and b of {mass} kg; c = Contact(a, b, Vector3{n}, 0.5, {depth}); moves = "
        about.call += "c.resolve_penetration()"
        a, b = Particle(Vector3(*p), mass=mass), Particle(Vector3(*q), mass=mass)
        c = Contact(a, b, Vector3(*n), 0.5, depth)
        moves = c.resolve_penetration()
        none = "Return two moves in every case. If nothing moves, both are zero vectors."
        expect_exactly(moves is None, False, then="; moves is None", cause=none)
        for name, now, before in (
            ("a.position", xyz(a.position), p),
            ("b.position", xyz(b.position), q),
            ("moves[0]", xyz(moves[0]), ZERO),
            ("moves[1]", xyz(moves[1]), ZERO),
        ):
            expect_close(now, before, then=f"; {name}", tolerance=0.0)
        got = c.penetration
        about.cause = "Nothing moved, so the penetration must not change."
        expect_close(got, depth, then="; c.penetration")
        moves[0].x += 1.0
        about.cause = "Both moves are the same vector. Return two separate vectors."
        got = xyz(moves[1])
        expect_close(got, ZERO, then="; moves[0].x += 1; moves[1]")
    about.call = f"a and b of 2 kg; c = Contact(a, b, Vector3{n}, 0.5, 0.5); "
    about.call += "c.resolve_penetration()"
    a, b = Particle(Vector3(*p), mass=2.0), Particle(Vector3(*q), mass=2.0)
    c = Contact(a, b, Vector3(*n), 0.5, 0.5)
    c.resolve_penetration()
    about.cause = "Set the penetration to 0. Otherwise the next call moves the particles again "
    about.cause += "(E-8)."
    got = c.penetration
    expect_close(got, 0.0, then="; c.penetration")
    about.call += "; moves = c.resolve_penetration()"
    about.cause = "Return the moves of this call. An earlier call's moves are outdated (E-27)."
    moves = c.resolve_penetration()
    got = (*xyz(moves[0]), *xyz(moves[1]))
    expect_close(got, ZERO + ZERO, then="; both moves")


@pytest.mark.exercise("B7.4")
def test_the_moves_are_vectors_of_their_own(rng: Random) -> None:
    about.read = MOVE
    p, q, n = components(rng), components(rng), direction(rng)
    about.call = f"a at {p}; c = Contact(a, None, Vector3{n}, 0.5, 1.0); moves = "
    about.call += "c.resolve_penetration(); moves[0].x += 1; moves[1].x += 1"
    separate = "The moves must be new vectors. Do not return or change the contact's normal or a "
    separate += "particle's position."
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
    expect_close(got, wanted, call=shown, tolerance=1e-14 * 8)
    about.call = f"a at {p}, b at {q}; c = Contact(a, b, Vector3{n}, 0.5, 0.5); moves = "
    about.call += "c.resolve_penetration(); moves[0].x += 1; moves[1].x += 1"
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
        expect_close(got, wanted, call=shown, tolerance=1e-14 * 8)
        got = xyz(particle.velocity)
        shown = f"{about.call}; {name}.velocity"
        about.cause = "Change positions only. Velocities are left to resolve_velocity."
        expect_close(got, ZERO, call=shown)


@pytest.mark.exercise("B7.4")
def test_what_lies_on_the_ground_stays_there() -> None:
    about.read = "book 7.2.3, E-26, and the docstring of Contact.resolve"
    for restitution, generated in ((0.0, False), (0.5, True), (0.9, False), (0.9, True)):
        gravity = "a force added in every step" if generated else "its own acceleration"
        about.call = f"a body of restitution {restitution} lies on the ground, gravity is "
        about.call += f"{gravity}; 15 s of semi-implicit steps of 1/60 s, each with "
        about.call += "Contact.resolve(1/60)"
        sinks = "The body sinks into the ground. Call resolve_penetration, too."
        jumps = "The body jumps. resolve_velocity must not bounce the velocity that gravity has "
        jumps += "built up in the step."
        about.cause = sinks
        heights, fastest = lying(restitution, generated, 900, 1.0 / 60.0)
        # Up to a millimeter counts as rest; rounding leaves some 1e-15 m.
        name = ": the lowest height, m"
        expect_between(min(heights), -1e-3, 1e-3, then=name, cause=sinks)
        name = ": the largest height, m"
        expect_between(max(heights), -1e-3, 1e-3, then=name, cause=jumps)
        # Without the rule it is at 0.08 m/s, at a restitution of 0.5, and more.
        name = ": the largest speed after a step, m/s"
        expect_between(fastest, -1e-6, 1e-6, then=name, cause=jumps)
        expect_exactly(len(heights), 900, then=": the number of steps")
