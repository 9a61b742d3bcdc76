"""The contact resolver separates particles, deepest contact first, build task B7.6."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.probes import resolved, stacked
from draw import Components, components, direction, dot, positive_number
from expect import about, blame, cause_of, expect_between, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
RIGHT = (1.0, 0.0, 0.0)
LEFT = (-1.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
DEEPEST = "book 7.3.1, E-8, and the docstring of ContactResolver.resolve_penetrations"
Body = tuple[Components, Components, float]


def row(*speeds: float, mass: float = 1.0) -> list[Body]:
    """Return touching bodies along X, with these speeds along X."""
    return [((float(i), 0.0, 0.0), (speed, 0.0, 0.0), mass) for i, speed in enumerate(speeds)]


@pytest.mark.exercise("B7.6")
def test_what_is_deepest_is_first() -> None:
    about.read = DEEPEST
    bodies = row(1.0, 0.0, -1.0)
    about.call = "three balls of 1 kg in a row with 1, 0 and -1 m/s; the middle one overlaps the "
    about.call += "left one by 0.5 m and the right one by 0.75 m; resolve_penetrations of both, "
    about.call += "limit"
    contacts = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.75)]
    for limit, wanted, depths, cause in (
        (1, (0.0, 0.625, 2.375), (0.875, 0.0), "The right pair is deeper, so resolve it first. "
                                               "Each of its balls moves by half of the depth."),
        (2, (-0.4375, 1.0625, 2.375), (0.0, 0.4375),
         "The left pair comes next, because the first move has pushed the middle ball farther into "
         "the left one. That pair is now 0.875 m deep."),
        (3, (-0.4375, 0.84375, 2.59375), (0.21875, 0.0),
         "After two resolutions the right pair is deeper again, so resolve it once more."),
    ):  # fmt: skip
        about.cause = cause
        used, after, got_depths = resolved(bodies, contacts, "resolve_penetrations", limit)
        got = tuple(place[0] for place, _ in after)
        mistakes = [
            (
                (-0.25, 1.25, 2.0),
                "You resolved the left pair first, but the right pair is deeper. Choose the "
                "contact with the largest penetration.",
            )
        ]
        if isinstance(used, int) and used > limit:
            about.cause = f"You resolved {used} contacts, but the limit is {limit}. Stop when you "
            about.cause += "reach it."
        seen = cause_of(got, mistakes, about.cause)
        expect_close(got, wanted, then=f" {limit}: positions", cause=seen)
        about.cause += " When the middle ball moves, the depth of its other contact changes as "
        about.cause += "well (E-8)."
        mistakes = [
            ((0.5, 0.0), "The left contact still has a depth of 0.5 m, although the middle ball "
                         "has moved 0.375 m into it. Update the other contacts after each move, "
                         "which the book's listing omits (E-8)."),
            ((0.125, 0.0), "The left contact has become shallower, although the middle ball has "
                           "moved into it. Check the sign of your update."),
            ((0.875, -0.75),
             "You updated the resolved contact twice. resolve_penetration has already set it to 0, "
             "so skip it in your loop."),
            ((0.0, 0.0), "The depth of the right contact is still 0. The middle ball is that "
                         "contact's other particle, so update contacts for contact.other as well."),
            ((0.0, -0.4375), "The update for contact.other has the wrong sign. When contact.other "
                             "moves along the normal, it moves toward contact.particle, so the "
                             "contact gets deeper. Add the distance that it moved."),
        ]  # fmt: skip
        blame(got_depths, mistakes)
        expect_close(got_depths, depths, then=f" {limit}: penetrations")
        about.cause = "You returned the wrong number. Count how many times you resolve a contact, "
        about.cause += "and return that count."
        expect_exactly(used, limit, then=f" {limit}: returned")
        got = tuple(velocity[0] for _, velocity in after)
        about.cause = "A velocity has changed. Leave the velocities to resolve_velocities: "
        about.cause += "resolve_penetrations changes only positions."
        expect_close(got, (1.0, 0.0, -1.0), then=f" {limit}: velocities")
    about.call = "the same with 0.5 m each, limit 1: penetrations"
    for order in ((0, 1), (1, 0)):
        equal = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5)]
        about.cause = "Both contacts are 0.5 m deep, so resolve the one that comes first in the "
        about.cause += "list."
        _, _, got = resolved(bodies, [equal[i] for i in order], "resolve_penetrations", 1)
        expect_close(got, (0.0, 0.75), then=f", order {order}")


@pytest.mark.exercise("B7.6")
def test_one_contact_is_resolved_once(rng: Random) -> None:
    about.read = DEEPEST
    n, mass, depth = direction(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    for deep, wanted, cause in (
        (depth, 1, "After one resolution the particle just touches the ground, so stop there. The "
                   "book's listing moves the particle again (E-8)."),
        (2e-9, 1, "This contact is shallow, but its depth is above DEPTH_TOLERANCE, so resolve "
                  "it."),
        (5e-10, 0, "This depth is below DEPTH_TOLERANCE, so the particle counts as just touching "
                   "the ground. Don't move it."),
        (-1.0, 0, "The penetration is negative, so there is a gap between the particle and the "
                  "ground. Don't move the particle."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"a of {mass} kg; resolve_penetrations([Contact(a, None, Vector3{n}, 0, "
        about.call += f"{deep})], 9)"
        used, after, depths = resolved(
            [(ZERO, ZERO, mass)], [(0, -1, n, 0.0, deep)], "resolve_penetrations", 9
        )
        expect_exactly(used, wanted, then=": returned")
        moved = tuple(wanted * deep * part for part in n)
        got = after[0][0]
        expect_close(got, moved, then=": position", tolerance=1e-15)
        left = 0.0 if wanted else deep
        expect_close(depths[0], left, then=": penetration")
    about.call = "resolve_penetrations([], 9)"
    about.cause = "The list of contacts is empty, so there is nothing to resolve. Return 0 as the "
    about.cause += "number of resolutions."
    used, _, _ = resolved([], [], "resolve_penetrations", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.6")
def test_a_move_changes_all_contacts_of_its_particles(rng: Random) -> None:
    about.read = DEEPEST
    n, ma, mb = direction(rng), positive_number(rng), positive_number(rng)
    # a and b move; c and d touch them, e and f touch neither. e is at the position of a.
    bodies = [(components(rng), ZERO, mass) for mass in (ma, mb, math.inf, 4.0, 5.0, 6.0)]
    bodies[4] = (bodies[0][0], ZERO, 5.0)
    normals = [direction(rng) for _ in range(9)]
    ends = [(0, 2), (2, 0), (1, 3), (3, 1), (0, -1), (1, -1), (0, 1), (1, 0), (4, 5)]
    others = [(p, q, m, 0.0, -5.0) for (p, q), m in zip(ends, normals, strict=True)]
    others.append((4, -1, normals[0], 0.0, -5.0))
    names = {-1: "the world", 0: "a", 1: "b", 2: "c", 3: "d", 4: "e", 5: "f"}
    between_two = {0: 0.5 * mb / (ma + mb), 1: -0.5 * ma / (ma + mb)}
    for end, moves in ((1, between_two), (-1, {0: 0.5})):
        about.call = f"a of {ma} kg and {names[end]} (b has {mb} kg) overlap by 0.5 m, normal {n}; "
        about.call += "resolve_penetrations, limit 1; the penetration, -5 before, of a second "
        about.call += "contact between"
        contacts = [others[0], (0, end, n, 0.0, 0.5), *others[1:]]
        about.cause = "The contact that you resolved has a penetration again. resolve_penetration "
        about.cause += "has set it to 0, so don't change it after that."
        _, _, depths = resolved(bodies, contacts, "resolve_penetrations", 1)
        name = f"{about.call[: about.call.index('; the')]}; its penetration"
        expect_close(depths[1], 0.0, call=name)
        for (p, q, m, _, _), got in zip(others, [depths[0], *depths[2:]], strict=True):
            wanted = -5.0 - (moves.get(p, 0.0) - moves.get(q, 0.0)) * dot(n, m)
            about.cause = "For each other contact, subtract the distance that contact.particle "
            about.cause += "moved along its normal, and add the distance that contact.other "
            about.cause += (
                "moved. Compare particles with `is`, and skip contact.other if it is None."
            )
            name = f"{about.call} {names[p]} and {names[q]}"
            expect_close(got, wanted, call=name, tolerance=1e-14)


@pytest.mark.exercise("B7.6")
def test_both_phases_have_their_own_limit() -> None:
    about.read = "the docstring of ContactResolver"
    bodies = [*row(2.0, 0.0, -2.0), ((9.0, 0.0, 0.0), RIGHT, math.inf)]
    pairs = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5), (3, -1, LEFT, 0.0, 9.0)]
    about.call = "three balls of 1 kg in a row with 2, 0 and -2 m/s, both pairs 0.5 m deep, "
    about.call += "restitution 0; an immovable one deep in the ground; "
    own = "Your two phases share one limit, but each of them may resolve up to `iterations` "
    own += "contacts. Pass the full limit to both."
    default = "The check passes no iterations, so the limit of each phase is twice the number of "
    default += "contacts. Count only contacts in which a particle can move."
    for iterations, wanted, cause in ((None, 8, default), (3, 6, own), (1, 2, own)):
        about.cause = cause
        name = f"{about.call}ContactResolver({iterations}).resolve_contacts; iterations_used"
        used, after, _ = resolved(bodies, pairs, "resolve_contacts", iterations or 0)
        expect_exactly(used, wanted, call=name)
        about.cause = "The final positions are not what resolve_penetrations would give. Call it "
        about.cause += "once, after you have resolved the velocities."
        got = math.fsum(place[0] for place, _ in after[:3])
        name = f"{about.call}ContactResolver({iterations}).resolve_contacts; sum of the positions"
        expect_close(got, 3.0, call=name, tolerance=1e-14)
    name = f"{about.call}the balls at rest and apart; iterations_used"
    pairs = [(1, 0, RIGHT, 0.0, 0.0), (2, 1, RIGHT, 0.0, -0.5)]
    about.cause = "No contact is closing and none has a penetration, so there is nothing to "
    about.cause += "resolve. Set iterations_used to 0."
    used, after, _ = resolved(row(0.0, 0.0, 0.0), pairs, "resolve_contacts", 0)
    expect_exactly(used, 0, call=name)
    got = tuple(place[0] for place, _ in after)
    expect_close(got, (0.0, 1.0, 2.0), then="the balls at rest: positions")


@pytest.mark.exercise("B7.6")
def test_a_stack_of_three_settles() -> None:
    about.read = "book 7.3.1, and the docstring of ContactResolver"
    about.call = "three spheres of 1 kg, radius 0.5 m, stacked on the ground; 5 s of semi-implicit "
    about.call += "steps of 1/60 s with ContactResolver()"
    about.cause = "Two iterations per contact are enough for a stack of three spheres. If the "
    about.cause += "stack sinks, one of the two phases stops too early. Check the limits."
    heights, overlap = stacked(3, 0.5, None, 300, 1.0 / 60.0)
    # Measured: at most 0.015 m of overlap, which is what two iterations per contact leave.
    expect_close(heights, (0.5, 1.5, 2.5), then=": heights", tolerance=0.02)
    expect_between(overlap, -0.02, 0.02, then=": the largest overlap after a step, m")
