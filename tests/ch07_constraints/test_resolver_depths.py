"""The contact resolver separates particles, deepest contact first, build task B7.6."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.probes import piled, resolved
from draw import positive_number, unit_vector, vector
from expect import expect_between, expect_close, expect_exactly, xyz

ZERO = (0.0, 0.0, 0.0)
DEEPEST = "book 7.3.1, E-8, and the docstring of ContactResolver.resolve_penetrations"
RESOLVER = "book 7.3.1, and the docstring of ContactResolver"
RETURNED = "; the return value"
# The places of the three balls of the first check after one, two and three resolutions.
AFTER = ((0.0, 0.625, 2.375), (-0.4375, 1.0625, 2.375), (-0.4375, 0.84375, 2.59375))


@pytest.mark.exercise("B7.6", asks="the penetration of the deepest contact", read=DEEPEST)
def test_the_deepest_contact_is_resolved_first() -> None:
    for limit, depths, cause in (
        (1, (0.875, 0.0),
         "The right pair is deeper. Move each of its balls by half of the depth."),
        (2, (0.0, 0.4375),
         "After the right pair, resolve the left pair. It is 0.875 m deep by then, because the "
         "first move pushed the middle ball farther into the left one."),
        (3, (0.21875, 0.0),
         "After two resolutions the right pair is deeper again, so resolve it once more."),
    ):  # fmt: skip
        with calls(cause):
            balls = [Particle(Vector3(i), Vector3(1.0 - i)) for i in range(3)]
            left = Contact(balls[1], balls[0], Vector3(1.0), penetration=0.5)
            right = Contact(balls[2], balls[1], Vector3(1.0), penetration=0.75)
            used = ContactResolver().resolve_penetrations([left, right], limit)
        many = f"You resolved more contacts than the limit of {limit} allows. Stop when you reach "
        many += "the limit."
        got, name = tuple(ball.position.x for ball in balls), "; the positions of the balls along x"
        slips = {
            "You resolved the left pair first, but the right pair is deeper. Always choose the "
            "deepest contact.": (-0.25, 1.25, 2.0)
        }
        if got in AFTER[limit:] or (isinstance(used, int) and used > limit):
            slips = {many: got}
        expect_close(got, AFTER[limit - 1], slips, then=name, unit="m")
        slips = {
            "When the middle ball moved, you didn't update the depth of the left contact. The ball "
            "is other of the resolved contact, and particle of the left one. Update the other "
            "contacts after each move, although the book's listing doesn't (E-8).": (0.5, 0.0),
            "You made the left contact shallower, but it should get deeper, because the middle "
            "ball moved toward the left ball. Reverse the sign of the change in its depth.":
                (0.125, 0.0),
            "You updated the resolved contact twice. resolve_penetration has already set its depth "
            "to 0, so skip this contact in your loop.": (0.875, -0.75),
            "The middle ball is contact.other of the right contact, but you didn't update that "
            "contact when the ball moved. Update a contact if either of its two particles has "
            "moved.": (0.0, 0.0),
            "Your update for contact.other has the wrong sign. When contact.other moves along the "
            "normal, it comes closer to contact.particle, so add this distance to the depth.":
                (0.0, -0.4375),
        }  # fmt: skip
        got, name = (left.penetration, right.penetration), "; the depths of the left and the right "
        why = "When the middle ball moves, update the depth of its other contact (E-8)."
        expect_close(got, depths, slips, then=f"{name}contact", cause=why, unit="m")
        why = "Count how many times you resolve a contact, and return that count."
        expect_exactly(used, limit, then=RETURNED, cause=why, unit="resolutions")
        why = "Here, change only positions. Leave velocities to resolve_velocities."
        got, name = tuple(ball.velocity.x for ball in balls), "; the velocities of the balls"
        expect_close(got, (1.0, 0.0, -1.0), then=name, cause=why, unit="m/s")
    for pairs in (((1, 0), (2, 1)), ((2, 1), (1, 0))):
        with calls("Both are 0.5 m deep, so the first one has priority. Use > instead of >=."):
            balls = [Particle(Vector3(i)) for i in range(3)]
            one, two = (
                Contact(balls[i], balls[j], Vector3(1.0), penetration=0.5) for i, j in pairs
            )
            ContactResolver().resolve_penetrations([one, two], 1)
        got, name = (one.penetration, two.penetration), "; one.penetration, two.penetration"
        expect_close(got, (0.0, 0.75), then=name, unit="m")


@pytest.mark.exercise("B7.6", asks="or when no contact is deeper than", read=DEEPEST)
def test_one_contact_is_resolved_once(rng: Random) -> None:
    n, mass, depth = unit_vector(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    for deep, wanted, cause in (
        (depth, 1,
         "One resolution is enough. Update only the other contacts (E-8)."),
        (2e-9, 1,
         "2e-9 m is above DEPTH_TOLERANCE, so resolve the contact."),
        (5e-10, 0,
         "5e-10 m is below DEPTH_TOLERANCE, a rounding error. Skip the contact."),
        (-1.0, 0,
         "A negative penetration is a gap above the ground. Don't move the particle."),
    ):  # fmt: skip
        with calls(cause):
            a = Particle(mass=mass)
            c = Contact(a, None, normal=Vector3(*n), restitution=0.0, penetration=deep)
            used = ContactResolver().resolve_penetrations([c], 9)
        move, left = n * (wanted * deep), 0.0 if wanted else deep
        if used == 9 and math.dist(move, xyz(a.position)) < 1e-12:
            cause = "You return the limit. Either you go on although no contact is deep any more, "
            cause += "or you stop but return the wrong number. Stop when the deepest contact is at "
            cause += "most DEPTH_TOLERANCE, and return the number of resolutions so far."
        expect_exactly(used, wanted, then=RETURNED, cause=cause, unit="resolutions")
        expect_close(xyz(a.position), move, then="; a.position", tolerance=1e-15, unit="m")
        expect_close(c.penetration, left, then="; c.penetration", unit="m")
    with calls("The list of contacts is empty. Return 0 as the number of resolutions."):
        used = ContactResolver().resolve_penetrations([], 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.6", asks="So update each of these contacts", read=DEEPEST)
def test_a_move_changes_all_contacts_of_its_particles(rng: Random) -> None:
    n, ma, mb = unit_vector(rng), positive_number(rng), positive_number(rng)
    # a and b move; c and d touch them, e and f touch neither. e is at the position of a.
    bodies = [(vector(rng), ZERO, mass) for mass in (ma, mb, math.inf, 4.0, 5.0, 6.0)]
    bodies[4] = (bodies[0][0], ZERO, 5.0)
    normals = [unit_vector(rng) for _ in range(9)]
    ends = [(0, 2), (2, 0), (1, 3), (3, 1), (0, -1), (1, -1), (0, 1), (1, 0), (4, 5), (4, -1)]
    others = [(p, q, m, 0.0, -5.0) for (p, q), m in zip(ends, [*normals, normals[0]], strict=True)]
    names = ("a", "b", "c", "d", "e", "f", "the ground")
    between_two = {0: 0.5 * mb / (ma + mb), 1: -0.5 * ma / (ma + mb)}
    for end, moves in ((1, between_two), (-1, {0: 0.5})):
        with calls(
            "You updated the contact that you resolved. resolve_penetration has already set its "
            "penetration to 0, so skip it when you update the others.",
            f"particle a ({ma} kg) and particle b ({mb} kg); a overlaps {names[end]} by 0.5 m, "
            f"with the normal {n}; ten other contacts have a penetration of -5 m; "
            "resolver.resolve_penetrations(contacts, 1)",
        ):
            contacts = [others[0], (0, end, n, 0.0, 0.5), *others[1:]]
            _, _, depths = resolved(bodies, contacts, 1, velocities=False)
        got = depths.pop(1)
        expect_close(got, 0.0, then="; the penetration of the first contact", unit="m")
        for (p, q, m, _, _), got in zip(others, depths, strict=True):
            own, other = moves.get(p, 0.0) * (n @ m), moves.get(q, 0.0) * (n @ m)
            wanted = -5.0 - own + other
            why = "You updated this contact by the wrong amount. Subtract the move of "
            why += "contact.particle along this contact's own normal, and add that of "
            why += "contact.other."
            if q == end == -1 and p == 0:
                why = "Subtract the move of a along this normal. Skip contact.other if it is None."
            elif wanted == -5.0:
                why = "Its particles haven't moved. Compare with `is`, and skip an other of None."
            elif got == -5.0:
                why = "Its particle has moved. Check both contact.particle and contact.other."
            slips = {
                "You added the move of contact.particle along this contact's normal. Subtract it.":
                    -5.0 + own + other,
                "You subtracted the move of contact.other along this contact's normal. Add it.":
                    -5.0 - own - other,
            }  # fmt: skip
            name = "; the penetration of one of the ten contacts, which is between "
            name += f"{names[p]} and {names[q]}"
            slips = {} if got == -5.0 else slips
            expect_close(got, wanted, slips, then=name, cause=why, tolerance=1e-14, unit="m")


@pytest.mark.exercise("B7.6", asks="None means twice the number of contacts", read=RESOLVER)
def test_a_stack_of_three_settles() -> None:
    """Only here gravity presses a whole stack together, in every one of many steps."""
    with calls(
        "The stack sinks, because one of your two phases stops too early. Each phase may make two "
        "resolutions per contact.",
        "three spheres (1 kg, radius 0.5 m) stacked on the ground; 300 semi-implicit steps of 1/60 "
        "s, each with ContactResolver().resolve_contacts(contacts, 1/60)",
    ):
        heights, overlap = piled(3, None, 300, detect=False)
    # Measured: at most 0.015 m of overlap, which is what two iterations per contact leave.
    name = "; the final heights of the centers"
    expect_close(heights, (0.5, 1.5, 2.5), then=name, tolerance=0.02, unit="m")
    name = "; the largest overlap after any step"
    expect_between(overlap, -0.02, 0.02, then=name, unit="m")
