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
# The places of the three balls of the first check after one, two and three resolutions.
AFTER = ((0.0, 0.625, 2.375), (-0.4375, 1.0625, 2.375), (-0.4375, 0.84375, 2.59375))


def row(*speeds: float, mass: float = 1.0) -> list[Body]:
    """Return touching bodies along X, with these speeds along X."""
    return [((float(i), 0.0, 0.0), (speed, 0.0, 0.0), mass) for i, speed in enumerate(speeds)]


@pytest.mark.exercise("B7.6", asks="the penetration of the deepest contact")
def test_the_deepest_contact_is_resolved_first() -> None:
    about.read = DEEPEST
    bodies = row(1.0, 0.0, -1.0)
    setup = "three balls of 1 kg in a row at x = 0, 1 and 2, with velocities of 1, 0 and -1 m/s; "
    setup += "two contacts: the middle ball overlaps the left one by 0.5 m and the right one by "
    setup += "0.75 m; resolver.resolve_penetrations(contacts, "
    contacts = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.75)]
    for limit, wanted, depths, cause in (
        (1, AFTER[0], (0.875, 0.0), "The right pair is deeper, so resolve it first. "
                                               "Move each of its balls by half of the depth."),
        (2, AFTER[1], (0.0, 0.4375),
         "After the right pair, resolve the left pair. It is 0.875 m deep by then, because the "
         "first move pushed the middle ball farther into the left one."),
        (3, AFTER[2], (0.21875, 0.0),
         "After two resolutions the right pair is deeper again, so resolve it once more."),
    ):  # fmt: skip
        about.call = f"{setup}{limit})"
        about.cause = cause
        used, after, got_depths = resolved(bodies, contacts, "resolve_penetrations", limit)
        got = tuple(place[0] for place, _ in after)
        mistakes = [
            (
                (-0.25, 1.25, 2.0),
                "You resolved the left pair first, but the right pair is deeper. Always choose the "
                "deepest contact.",
            )
        ]
        many = f"You resolved more contacts than the limit of {limit} allows. Stop when you reach "
        mistakes += [(places, f"{many}the limit.") for places in AFTER[limit:]]
        if isinstance(used, int) and used > limit:
            about.cause = f"You resolved contacts {used} times, but the limit is {limit}. Stop "
            about.cause += "when you reach the limit."
        seen = cause_of(got, mistakes, about.cause)
        name = "; the positions of the balls along x"
        expect_close(got, wanted, then=name, cause=seen, unit="m")
        about.cause += " When the middle ball moves, update the depth of its other contact (E-8)."
        mistakes = [
            ((0.5, 0.0),
             "When the middle ball moved, you didn't update the depth of the left contact. The "
             "ball is other of the resolved contact, and particle of the left one. Update the "
             "other contacts after each move, although the book's listing doesn't (E-8)."),
            ((0.125, 0.0),
             "You made the left contact shallower, but it should get deeper, because the middle "
             "ball moved toward the left ball. Reverse the sign of the change in its depth."),
            ((0.875, -0.75),
             "You updated the resolved contact twice. resolve_penetration has already set its "
             "depth to 0, so skip this contact in your loop."),
            ((0.0, 0.0),
             "The middle ball is contact.other of the right contact, but you didn't update that "
             "contact when the ball moved. Update a contact if either of its two particles has "
             "moved."),
            ((0.0, -0.4375),
             "Your update for contact.other has the wrong sign. When contact.other moves along "
             "the normal, it comes closer to contact.particle, so add this distance to the "
             "depth."),
        ]  # fmt: skip
        blame(got_depths, mistakes)
        expect_close(
            got_depths, depths, then="; the depths of the left and the right contact", unit="m"
        )
        about.cause = "You returned the wrong number. Count how many times you resolve a contact, "
        about.cause += "and return that count."
        expect_exactly(used, limit, then="; the return value", unit="resolutions")
        got = tuple(velocity[0] for _, velocity in after)
        about.cause = "resolve_penetrations has changed velocities. It should change only "
        about.cause += "positions, and leave velocities to resolve_velocities."
        name = "; the velocities of the balls"
        expect_close(got, (1.0, 0.0, -1.0), then=name, unit="m/s")
    for order in ((0, 1), (1, 0)):
        equal = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5)]
        first, second = ("right", "left") if order[0] else ("left", "right")
        about.call = "three balls of 1 kg in a row, where the middle ball overlaps each of its "
        about.call += f"neighbors by 0.5 m; contacts = [the {first} pair's contact, the {second} "
        about.call += "pair's contact]; resolver.resolve_penetrations(contacts, 1)"
        about.cause = "You resolved the second contact in the list, but both are 0.5 m deep, so "
        about.cause += "the first one has priority. Compare with > instead of >=."
        _, _, got = resolved(bodies, [equal[i] for i in order], "resolve_penetrations", 1)
        name = "; the penetrations of contacts[0] and contacts[1]"
        expect_close(got, (0.0, 0.75), then=name, unit="m")


@pytest.mark.exercise("B7.6", asks="or when no contact is deeper than")
def test_one_contact_is_resolved_once(rng: Random) -> None:
    about.read = DEEPEST
    n, mass, depth = direction(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    for deep, wanted, cause in (
        (depth, 1,
         "You moved the particle again, although it just touches the ground after one "
         "resolution. Update only the other contacts (E-8)."),
        (2e-9, 1,
         "You skipped a contact that is 2e-9 m deep. This is small but above DEPTH_TOLERANCE, "
         "so resolve the contact."),
        (5e-10, 0,
         "You resolved a contact that is only 5e-10 m deep. This is below DEPTH_TOLERANCE, so "
         "treat it as a rounding error and skip the contact."),
        (-1.0, 0,
         "You resolved a contact with a negative penetration, which means that there is a gap "
         "above the ground. Don't move the particle."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"particle a of {mass} kg at (0, 0, 0); c = Contact(a, None, "
        about.call += f"normal=Vector3{n}, restitution=0.0, penetration={deep}); "
        about.call += "resolver.resolve_penetrations([c], 9)"
        used, after, depths = resolved(
            [(ZERO, ZERO, mass)], [(0, -1, n, 0.0, deep)], "resolve_penetrations", 9
        )
        moved, got = tuple(wanted * deep * part for part in n), after[0][0]
        if used == 9 and math.dist(got, moved) < 1e-12:
            about.cause = "You return the limit. Either you go on although no contact is deep any "
            about.cause += "more, or you stop but return the wrong number. Stop when the deepest "
            about.cause += "contact is at most DEPTH_TOLERANCE, and return the number of "
            about.cause += "resolutions so far."
        expect_exactly(used, wanted, then="; the return value", unit="resolutions")
        expect_close(got, moved, then="; a.position", tolerance=1e-15, unit="m")
        left = 0.0 if wanted else deep
        expect_close(depths[0], left, then="; c.penetration", unit="m")
    about.call = "resolver.resolve_penetrations([], 9)"
    about.cause = "The list of contacts is empty, so there is nothing to resolve. Return 0 as the "
    about.cause += "number of resolutions."
    used, _, _ = resolved([], [], "resolve_penetrations", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.6", asks="So update each of these contacts")
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
    names = {-1: "the ground", 0: "a", 1: "b", 2: "c", 3: "d", 4: "e", 5: "f"}
    between_two = {0: 0.5 * mb / (ma + mb), 1: -0.5 * ma / (ma + mb)}
    for end, moves in ((1, between_two), (-1, {0: 0.5})):
        about.call = f"particle a ({ma} kg) and particle b ({mb} kg); a overlaps {names[end]} by "
        about.call += f"0.5 m, with the normal {n}; ten other contacts have a penetration of -5 "
        about.call += "m; resolver.resolve_penetrations(contacts, 1)"
        contacts = [others[0], (0, end, n, 0.0, 0.5), *others[1:]]
        about.cause = "You updated the contact that you resolved. resolve_penetration has already "
        about.cause += "set its penetration to 0, so skip it when you update the others."
        _, _, depths = resolved(bodies, contacts, "resolve_penetrations", 1)
        expect_close(depths[1], 0.0, then="; the penetration of the first contact", unit="m")
        for (p, q, m, _, _), got in zip(others, [depths[0], *depths[2:]], strict=True):
            wanted = -5.0 - (moves.get(p, 0.0) - moves.get(q, 0.0)) * dot(n, m)
            about.cause = "You updated this contact by the wrong amount. Subtract the move of "
            about.cause += "contact.particle along this contact's own normal, and add that of "
            about.cause += "contact.other."
            if q == end == -1 and p == 0:
                about.cause = "Particle a moved, so subtract its move along this contact's normal "
                about.cause += "from the penetration. Skip contact.other if it is None."
            elif wanted == -5.0:
                about.cause = "You updated a contact whose particles haven't moved. Compare "
                about.cause += "particles with `is`, and skip contact.other if it is None."
            elif got == -5.0:
                about.cause = "You didn't update this contact, although a particle of it has "
                about.cause += "moved. Check both contact.particle and contact.other."
            own, others_own = (moves.get(end_of, 0.0) * dot(n, m) for end_of in (p, q))
            slips = [
                (-5.0 + own + others_own, "You added the move of contact.particle along this "
                                          "contact's normal. Subtract it."),
                (-5.0 - own - others_own, "You subtracted the move of contact.other along this "
                                          "contact's normal. Add it."),
            ]  # fmt: skip
            if got != -5.0:
                blame(got, slips)
            name = "; the penetration of one of the ten contacts, which is between "
            name += f"{names[p]} and {names[q]}"
            expect_close(got, wanted, then=name, tolerance=1e-14, unit="m")


@pytest.mark.exercise("B7.6", asks="the number of resolutions in each phase")
def test_both_phases_have_their_own_limit() -> None:
    about.read = "the docstring of ContactResolver"
    bodies = [*row(2.0, 0.0, -2.0), ((9.0, 0.0, 0.0), RIGHT, math.inf)]
    pairs = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5), (3, -1, LEFT, 0.0, 9.0)]
    about.call = "three balls of 1 kg in a row, with velocities of 2, 0 and -2 m/s, overlapping "
    about.call += "their neighbors by 0.5 m; an immovable particle deep in the ground; "
    own = "Your two phases share one limit, but each of them may make up to `iterations` "
    own += "resolutions. Pass the full limit to both."
    default = "The resolver was created without iterations, so the limit of each phase is twice "
    default += "the number of contacts. Count only contacts in which a particle can move."
    for iterations, wanted, cause in ((None, 8, default), (3, 6, own), (1, 2, own)):
        about.cause = cause
        resolver = f"resolver = ContactResolver({iterations or ''}); "
        resolver += "resolver.resolve_contacts(contacts, 0.5)"
        name = f"{about.call}{resolver}; resolver.iterations_used"
        used, after, _ = resolved(bodies, pairs, "resolve_contacts", iterations or 0)
        expect_exactly(used, wanted, call=name)
        about.cause = "The balls are in the wrong positions. Call resolve_penetrations once, after "
        about.cause += "you have called resolve_velocities."
        got = math.fsum(place[0] for place, _ in after[:3])
        name = f"{about.call}{resolver}; the sum of the balls' positions along x"
        expect_close(got, 3.0, call=name, tolerance=1e-14, unit="m")
    name = "three balls at rest in a row, none of them overlapping; resolver = ContactResolver(); "
    name += "resolver.resolve_contacts(contacts, 0.5)"
    pairs = [(1, 0, RIGHT, 0.0, 0.0), (2, 1, RIGHT, 0.0, -0.5)]
    about.cause = "No contact is closing and none has a penetration, so there is nothing to "
    about.cause += "resolve. Set iterations_used to 0."
    used, after, _ = resolved(row(0.0, 0.0, 0.0), pairs, "resolve_contacts", 0)
    expect_exactly(used, 0, call=f"{name}; resolver.iterations_used")
    got = tuple(place[0] for place, _ in after)
    name += "; the positions of the balls along x"
    expect_close(got, (0.0, 1.0, 2.0), call=name, unit="m")


@pytest.mark.exercise("B7.6", asks="None means twice the number of contacts")
def test_a_stack_of_three_settles() -> None:
    about.read = "book 7.3.1, and the docstring of ContactResolver"
    about.call = "three spheres (1 kg, radius 0.5 m) stacked on the ground; 300 semi-implicit "
    about.call += "steps of 1/60 s, each with ContactResolver().resolve_contacts(contacts, 1/60)"
    about.cause = "The stack sinks, because one of your two phases stops too early. Each phase "
    about.cause += "may make two resolutions per contact."
    heights, overlap = stacked(3, 0.5, None, 300, 1.0 / 60.0)
    # Measured: at most 0.015 m of overlap, which is what two iterations per contact leave.
    name = "; the final heights of the centers"
    expect_close(heights, (0.5, 1.5, 2.5), then=name, tolerance=0.02, unit="m")
    name = "; the largest overlap after any step"
    expect_between(overlap, -0.02, 0.02, then=name, unit="m")
