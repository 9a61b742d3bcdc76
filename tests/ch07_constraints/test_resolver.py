"""The contact resolver changes velocities, fastest contact first, build task B7.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.probes import resolved
from draw import Components, components, direction, dot, positive_number
from expect import about, blame, expect_between, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
RIGHT = (1.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
FASTEST = "book 7.3.1, and the docstring of ContactResolver.resolve_velocities"
Body = tuple[Components, Components, float]


def row(*speeds: float, mass: float = 1.0) -> list[Body]:
    """Return touching bodies along X, with these speeds along X."""
    return [((float(i), 0.0, 0.0), (speed, 0.0, 0.0), mass) for i, speed in enumerate(speeds)]


def touching(*pairs: tuple[int, int], restitution: float = 0.0) -> list:
    """Return contacts of depth 0 between pairs in a row. The second body is on the left."""
    return [(a, b, RIGHT, restitution, 0.0) for a, b in pairs]


@pytest.mark.exercise("B7.5")
def test_what_closes_fastest_is_first() -> None:
    about.read = FASTEST
    contacts = touching((1, 0), (2, 1), restitution=0.5)
    about.call = "three balls of 1 kg in a row with 1, 0 and -3 m/s, restitution 0.5; "
    about.call += "resolve_velocities([left pair, right pair], limit, 0.5), limit"
    for limit, wanted, cause in (
        (
            1,
            (1.0, -2.25, -0.75),
            "Resolve the right pair first: it is closing at 3 m/s, the left pair only at 1 m/s.",
        ),
        (
            2,
            (-1.4375, 0.1875, -0.75),
            "The left pair comes next, because it is now closing at 3.25 m/s.",
        ),
        (
            9,
            (-1.4375, -0.515625, -0.046875),
            "After two resolutions the right pair is closing again, so resolve it once more.",
        ),
    ):
        about.cause = f"{cause} Compare the separating velocities of all contacts again before "
        about.cause += "each resolution."
        used, bodies, _ = resolved(row(1.0, 0.0, -3.0), contacts, "resolve_velocities", limit)
        got = tuple(velocity[0] for _, velocity in bodies)
        mistakes = [
            ((1.0, 0.0, -3.0), "You resolved no contact at all. A contact is closing if its "
                               "separating velocity is below -VELOCITY_TOLERANCE, so check the "
                               "sign in your comparison."),
            ((0.25, 0.75, -3.0),
             "You resolved the first closing contact in the list. Choose the one that is closing "
             "fastest, which has the lowest separating velocity."),
            ((-1.4375, -0.515625, -0.046875), "You resolved three contacts, but the limit is "
                                              f"{limit}. Stop when you reach it."),
            ((-1.4375, 0.1875, -0.75), "You stopped after two resolutions, but the right pair is "
                                       "closing again. Keep going until no contact is closing or "
                                       "you reach the limit."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, then=f" {limit}: velocities")
        about.cause = "Stop when no contact is closing anymore or when you reach the limit, and "
        about.cause += "return how many times you resolved a contact."
        expect_exactly(used, min(limit, 3), then=f" {limit}: returned")


@pytest.mark.exercise("B7.5")
def test_the_fastest_is_by_its_closing_velocity(rng: Random) -> None:
    about.read = FASTEST
    side = positive_number(rng, 20.0, 90.0)
    bodies = [
        (ZERO, (0.0, -2.0, 0.0), 100.0),
        (ZERO, (side, -1.0, side), 100.0),
        (ZERO, ZERO, 1.0),
        (ZERO, (0.0, 3.0, 0.0), math.inf),
    ]
    contacts = [(0, -1, UP, 1.0, 0.5), (1, -1, UP, 1.0, 0.75), (2, 3, UP, 0.0, -0.25)]
    about.call = f"a of 100 kg with (0, -2, 0) and b of 100 kg with ({side}, -1, {side}) hit the "
    about.call += "ground, restitution 1; c of 1 kg at rest, 0.25 m above a wall that moves with "
    about.call += "(0, 3, 0), restitution 0; resolve_velocities of the three contacts, limit 1"
    about.cause = "Resolve the contact that is closing fastest, which is c's. It is closing at 3 "
    about.cause += "m/s because its wall moves, so include the velocity of the other particle even "
    about.cause += "if that particle is immovable."
    used, after, depths = resolved(bodies, contacts, "resolve_velocities", 1)
    got = tuple(velocity[1] for _, velocity in after[:3])
    mistakes = [
        ((2.0, -1.0, 0.0), "You resolved a's contact, but c's is closing faster. Compare only the "
                           "separating velocities: the depth, the restitution and an immovable end "
                           "make no difference here."),
        ((-2.0, 1.0, 0.0), "You resolved b's contact. It is the deepest, and b is the fastest "
                           "particle, but only the separating velocity counts in this phase. It is "
                           "lowest for c's contact, so resolve that one first."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, (-2.0, -1.0, 3.0), then=": upward velocities")
    why = "You resolved exactly one contact here, so return 1. Count the resolutions and return "
    why += "the total."
    expect_exactly(used, 1, then="; returned", cause=why)
    about.cause = "The contacts are in a different order now. The list belongs to the caller, so "
    about.cause += "don't sort or reorder it."
    expect_close(depths, (0.5, 0.75, -0.25), then="; penetrations of the contacts")
    about.call = "resolve_velocities([], 9, 0.5)"
    about.cause = "The list of contacts is empty, so there is nothing to resolve. Return 0 as the "
    about.cause += "number of resolutions."
    used, _, _ = resolved([], [], "resolve_velocities", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.5")
def test_of_equal_ones_the_first_is_taken() -> None:
    about.read = FASTEST
    about.cause = "Both pairs are closing at 2 m/s, so resolve the one that comes first in the "
    about.cause += "list. If your code chose the second one, compare with < instead of <=."
    for order, wanted in (
        (((1, 0), (2, 1)), (0.0, 2.0, -2.0)),
        (((2, 1), (1, 0)), (2.0, -2.0, 0.0)),
    ):
        about.call = "three balls of 1 kg in a row with 2, 0 and -2 m/s, restitution 1; "
        about.call += f"resolve_velocities, limit 1, of the pairs {order}: velocities"
        contacts = touching(*order, restitution=1.0)
        used, bodies, _ = resolved(row(2.0, 0.0, -2.0), contacts, "resolve_velocities", 1)
        got = tuple(velocity[0] for _, velocity in bodies)
        expect_close(got, wanted)
        why = "You resolved exactly one contact here, so return 1. Count the resolutions and "
        why += "return the total."
        expect_exactly(used, 1, then="; returned", cause=why)


@pytest.mark.exercise("B7.5")
def test_a_push_goes_through_a_row(rng: Random) -> None:
    about.read = FASTEST
    speed, mass = positive_number(rng), positive_number(rng)
    pairs = [(4, 3), (2, 1), (3, 2), (1, 0)]
    about.call = f"five balls of {mass} kg in a row, the first with {speed} m/s, restitution 1; "
    about.call += f"resolve_velocities of the pairs {pairs}, limit"
    for limit, leaves, cause in (
        (
            2,
            2,
            "Each resolution passes the whole velocity on to the next ball, so after two of them "
            "the third ball is moving. Stop at the limit.",
        ),
        (
            4,
            4,
            "After four resolutions, the last ball should have the whole velocity, and all the "
            "others should be at rest.",
        ),
        (
            50,
            4,
            "After four resolutions no contact is closing, so stop before you reach the limit.",
        ),
    ):
        about.cause = cause
        bodies = row(speed, 0.0, 0.0, 0.0, 0.0, mass=mass)
        contacts = touching(*pairs, restitution=1.0)
        used, after, _ = resolved(bodies, contacts, "resolve_velocities", limit)
        got = tuple(velocity[0] for _, velocity in after)
        wanted = tuple(speed * (i == leaves) for i in range(5))
        expect_close(got, wanted, then=f" {limit}: velocities", tolerance=1e-13)
        expect_exactly(used, min(limit, 4), then=f" {limit}: returned")


@pytest.mark.exercise("B7.5")
def test_only_what_closes_is_resolved(rng: Random) -> None:
    about.read = FASTEST
    n = direction(rng)
    for closing, depth, wanted, cause in (
        (1e-13, 0.0, 0, "This closing speed is below VELOCITY_TOLERANCE, so treat it as a rounding "
                        "error and don't resolve the contact."),
        (1e-11, 0.0, 1, "This contact is closing slowly, but faster than VELOCITY_TOLERANCE, so "
                        "resolve it."),
        (0.5, -1.0, 1, "This contact is closing, so resolve it. Its penetration is negative, but "
                       "that makes no difference in this phase."),
        (-0.5, 1.0, 0, "This contact is already separating, so don't resolve it, however deep it "
                       "is."),
        (0.0, 1.0, 0, "This contact is deep but not closing, so don't resolve its velocity. Unlike "
                      "the book's listing, leave deep contacts to resolve_penetrations."),
        (1e-13, 1.0, 0, "This closing speed is below VELOCITY_TOLERANCE, so treat it as a rounding "
                        "error and don't resolve the contact."),
        (1e-11, 1.0, 1, "This contact is closing slowly, but faster than VELOCITY_TOLERANCE, so "
                        "resolve it."),
    ):  # fmt: skip
        about.cause = cause
        u = components(rng)  # the velocity across the normal does not count
        v = tuple(p - (closing + dot(u, n)) * q for p, q in zip(u, n, strict=True))
        if closing == 0.0:
            v = (n[1], -n[0], 0.0)  # exactly across the normal
        about.call = f"a with velocity {v}; resolve_velocities([Contact(a, None, Vector3{n}, 0, "
        about.call += f"{depth})], 9, 0.5)"
        bodies = [(ZERO, v, 2.0)]
        about.cause += " Use only the velocity along the contact's normal."
        used, after, depths = resolved(bodies, [(0, -1, n, 0.0, depth)], "resolve_velocities", 9)
        expect_exactly(used, wanted, then=": returned")
        got = -dot(after[0][1], n)
        left = 0.0 if wanted else closing
        # Some roundings of numbers up to 20.
        expect_close(got, left, then=": the closing speed", tolerance=5e-14)
        about.cause = "A position or a penetration has changed. Leave those to "
        about.cause += "resolve_penetrations: resolve_velocities changes only velocities."
        expect_close(after[0][0], ZERO, then=": position")
        expect_close(depths[0], depth, then=": penetration")


@pytest.mark.exercise("B7.5")
def test_many_contacts_come_to_an_end(rng: Random) -> None:
    about.read = FASTEST
    bodies = [(components(rng), components(rng), positive_number(rng, 2.0, 5.0)) for _ in range(6)]
    # Two more move toward the immovable one, one behind the other. It throws both back.
    bodies += [*row(5.0, 2.0), (ZERO, ZERO, math.inf)]
    contacts = touching((8, 7), (7, 6), restitution=0.5)
    for a, b in [(0, 8), (1, 0), (2, 0), (2, 1), (3, 1), (3, 8), (4, 2), (5, 3), (5, 4)]:
        n = direction(rng)
        if dot(bodies[a][1], n) > dot(bodies[b][1], n):
            n = (-n[0], -n[1], -n[2])
        contacts.append((a, b, n, 0.5, 0.0))
    about.call = "9 particles, one of them immovable, with 11 closing contacts, restitution 0.5; "
    about.call += "resolve_velocities, limit 2000"
    about.cause = "Some contact is still closing at the end. Keep going until no contact is "
    about.cause += "closing faster than VELOCITY_TOLERANCE."
    used, after, _ = resolved(bodies, contacts, "resolve_velocities", 2000)
    got = max(dot(after[b][1], n) - dot(after[a][1], n) for a, b, n, _, _ in contacts)
    name = f"{about.call}: the largest closing speed left (negative when all separate)"
    # VELOCITY_TOLERANCE is 1e-12. Separating is fine, and nothing separates faster than 100 m/s.
    expect_between(got, -100.0, 2e-12, call=name)
    # One resolution changes two bodies, and no two bodies take part in all of the contacts.
    about.cause = "You returned the wrong number. Count how many times you resolve a contact, and "
    about.cause += "return that count, which is above 1 and below the limit here."
    expect_between(used, 2, 1998, then=": returned")
    before, now = (
        sum(0.5 * m * dot(v, v) for (_, _, m), v in zip(bodies[:8], velocities, strict=False))
        for velocities in ([v for _, v, _ in bodies], [v for _, v in after])
    )
    about.cause = "The kinetic energy has grown, but with a restitution of 0.5 impulses can only "
    about.cause += "reduce it. Check the signs and the masses in Contact.resolve_velocity."
    name = f"{about.call}: ratio of the kinetic energy to its value before"
    expect_between(now / before, 0.0, 1.0, call=name)


@pytest.mark.exercise("B7.5")
def test_each_resolution_knows_the_duration() -> None:
    about.read = FASTEST
    about.call = "a and b with velocity (0, -4, 0), acceleration (0, -4, 0); resolve_velocities of "
    about.call += "their contacts with the ground, restitution 0.75, limit 9, duration"
    about.cause = "The velocity that the time step has added should not bounce. Pass the duration "
    about.cause += "on to Contact.resolve_velocity, which takes care of that."
    for duration, wanted in ((0.25, 2.25), (0.5, 1.5), (1.0, 0.0)):
        contacts = [(0, -1, UP, 0.75, 0.0), (1, -1, UP, 0.75, 0.0)]
        bodies = [(ZERO, (0.0, -4.0, 0.0), 2.0), (ZERO, (0.0, -4.0, 0.0), 3.0)]
        pull = (0.0, -4.0, 0.0)
        _, after, _ = resolved(bodies, contacts, "resolve_velocities", 9, duration, pull)
        name = f"{about.call} {duration}: upward velocities"
        got = (after[0][1][1], after[1][1][1])
        expect_close(got, (wanted, wanted), call=name)
