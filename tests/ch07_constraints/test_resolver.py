"""The contact resolver changes velocities, fastest contact first, build task B7.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.probes import resolved
from draw import Components, components, direction, dot, positive_number
from expect import about, blame, expect_between, expect_close, expect_exactly, expect_that

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


@pytest.mark.exercise("B7.5", asks="velocity of the contact that closes fastest")
def test_the_fastest_contact_is_resolved_first() -> None:
    about.read = FASTEST
    contacts = touching((1, 0), (2, 1), restitution=0.5)
    setup = "three touching balls of 1 kg in a row, with velocities of 1, 0 and -3 m/s along the "
    setup += "row; the contacts of the left and the right pair, with a restitution of 0.5; "
    setup += "resolver.resolve_velocities(contacts, "
    for limit, wanted, cause in (
        (
            1,
            (1.0, -2.25, -0.75),
            "Resolve the right pair first, because it closes at 3 m/s and the left pair only at 1 "
            "m/s.",
        ),
        (
            2,
            (-1.4375, 0.1875, -0.75),
            "After the right pair, resolve the left pair, because it now closes at 3.25 m/s.",
        ),
        (
            9,
            (-1.4375, -0.515625, -0.046875),
            "After two resolutions the right pair closes again, so resolve it once more.",
        ),
    ):
        about.call = f"{setup}{limit}, 0.5)"
        about.cause = f"{cause} Compare the separating velocities of all contacts again before "
        about.cause += "each resolution."
        used, bodies, _ = resolved(row(1.0, 0.0, -3.0), contacts, "resolve_velocities", limit)
        got = tuple(velocity[0] for _, velocity in bodies)
        first = "You resolved the first closing contact in the list. Choose the contact that "
        slowest = "You resolved the contact that closes slowest. Choose the one that "
        if math.dist(got, (0.25, 0.75, -3.0)) < 1e-9:
            other = resolved(row(1.0, 0.0, -3.0), contacts[::-1], "resolve_velocities", 1)[1]
            first = slowest if other[2][1][0] < -2.9 else first
        too_many = f"but the limit is {limit}. Stop when you reach the limit."
        mistakes = [
            ((1.0, 0.0, -3.0),
             "You resolved no contact at all. A contact closes if its separating velocity is "
             "below -VELOCITY_TOLERANCE, so turn your comparison around."),
            ((0.25, 0.75, -3.0),
             f"{first}closes fastest, which is the one with the lowest separating velocity."),
            ((-1.4375, -0.515625, -0.046875), f"You resolved contacts three times, {too_many}"),
            ((-1.4375, 0.1875, -0.75),
             f"You resolved two contacts, {too_many}" if limit == 1 else
             "You stopped after two resolutions, although the right pair is closing again by "
             "then. Search all contacts again after each resolution, and reset the lowest velocity "
             "before each search."),
            ((1.0, -2.25, -0.75), "You stopped after one resolution, although the left pair still "
                                  "closes. Go on until you reach the limit."),
        ]  # fmt: skip
        blame(got, mistakes)
        name = "; the velocities of the three balls"
        expect_close(got, wanted, then=name, unit="m/s")
        about.cause = "You returned the wrong number. Count how many times you resolve a contact, "
        about.cause += "and return that count."
        if used == limit == 9:
            about.cause = "You returned 9, the limit, although no contact closes any more after "
            about.cause += "three resolutions. Stop there, and return the number of resolutions."
        nothing = "The method returned nothing after the last resolution. Return the number of "
        nothing += "resolutions, even if the limit was reached."
        name = "; the return value"
        expect_that(
            used is not None,
            "nothing (None)",
            "1 resolution" if limit == 1 else f"{min(limit, 3)} resolutions",
            then=name,
            cause=nothing,
        )
        expect_exactly(used, min(limit, 3), then=name, unit="resolutions")


@pytest.mark.exercise("B7.5", asks="This phase ignores penetrations")
def test_only_the_closing_velocity_decides(rng: Random) -> None:
    about.read = FASTEST
    side = positive_number(rng, 20.0, 90.0)
    bodies = [
        (ZERO, (0.0, -2.0, 0.0), 100.0),
        (ZERO, (side, -1.0, side), 100.0),
        (ZERO, ZERO, 1.0),
        (ZERO, (0.0, 3.0, 0.0), math.inf),
    ]
    contacts = [(0, -1, UP, 1.0, 0.5), (1, -1, UP, 1.0, 0.75), (2, 3, UP, 0.0, -0.25)]
    about.call = "particle a (100 kg) hits the ground with velocity (0, -2, 0) and a restitution "
    about.call += f"of 1; particle b (100 kg) hits the ground with velocity ({side}, -1, {side}) "
    about.call += "and a restitution of 1; particle c (1 kg) is at rest; an immovable particle "
    about.call += "hits c from below with velocity (0, 3, 0) and a restitution of 0; "
    about.call += "resolver.resolve_velocities(contacts, 1, 0.5) with these three contacts"
    about.cause = "The contact of c closes fastest, at 3 m/s. Include the velocity of "
    about.cause += "contact.other in the closing speed, even if it is immovable."
    used, after, depths = resolved(bodies, contacts, "resolve_velocities", 1)
    got = tuple(velocity[1] for _, velocity in after[:3])
    mistakes = [
        ((2.0, -1.0, 0.0),
         "You resolved the contact of a, but the contact of c closes faster. Compare only the "
         "separating velocities, whatever the depth and the restitution are."),
        ((-2.0, 1.0, 0.0),
         "You resolved the contact of b, which is the deepest, but the contact of c closes "
         "faster. Compare only the separating velocities."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, (-2.0, -1.0, 3.0), then="; the velocities of a, b and c along y", unit="m/s")
    why = "You resolved one contact, so return 1. Count the resolutions and return their number."
    expect_exactly(used, 1, then="; the return value", cause=why)
    about.cause = "You changed the order of the contacts in the list. The list belongs to the "
    about.cause += "caller, so don't sort it."
    name = "; the penetrations of the contacts, in list order"
    expect_close(depths, (0.5, 0.75, -0.25), then=name, unit="m")
    about.call = "resolver.resolve_velocities([], 9, 0.5)"
    about.cause = "The list of contacts is empty, so there is nothing to resolve. Return 0 as the "
    about.cause += "number of resolutions."
    used, _, _ = resolved([], [], "resolve_velocities", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.5", asks="contacts are equally fast, take the first")
def test_the_first_of_two_equally_fast_contacts_is_resolved() -> None:
    about.read = FASTEST
    about.cause = "You resolved the second pair in the list, but both pairs close at 2 m/s, so "
    about.cause += "the first one has priority. Compare with < instead of <=."
    for order, wanted in (
        (((1, 0), (2, 1)), (0.0, 2.0, -2.0)),
        (((2, 1), (1, 0)), (2.0, -2.0, 0.0)),
    ):
        first, second = ("left", "right") if order[0] == (1, 0) else ("right", "left")
        about.call = "three touching balls of 1 kg in a row, with velocities of 2, 0 and -2 m/s "
        about.call += f"along the row; the contacts of the {first} and then the {second} pair, "
        about.call += "with a restitution of 1; resolver.resolve_velocities(contacts, 1, 0.5)"
        contacts = touching(*order, restitution=1.0)
        used, bodies, _ = resolved(row(2.0, 0.0, -2.0), contacts, "resolve_velocities", 1)
        got = tuple(velocity[0] for _, velocity in bodies)
        expect_close(got, wanted, then="; the velocities of the three balls", unit="m/s")
        why = "You resolved one contact, so return 1. Count the resolutions and return their "
        why += "number."
        expect_exactly(used, 1, then="; the return value", cause=why)


@pytest.mark.exercise("B7.5", asks="Stop after limit resolutions")
def test_a_push_goes_through_a_row(rng: Random) -> None:
    about.read = FASTEST
    speed, mass = positive_number(rng), positive_number(rng)
    pairs = [(4, 3), (2, 1), (3, 2), (1, 0)]
    setup = f"five touching balls of {mass} kg in a row, the first with {speed} m/s along the row; "
    setup += f"contacts between neighbors with a restitution of 1, in the order {pairs}; "
    setup += "resolver.resolve_velocities(contacts, "
    for limit, leaves, cause in (
        (
            2,
            2,
            "Each resolution passes the whole velocity on to the next ball, so only the third ball "
            "moves after two resolutions. Stop at the limit.",
        ),
        (
            4,
            4,
            "Only the last ball should move after four resolutions. Always resolve the contact "
            "that closes fastest.",
        ),
        (
            50,
            4,
            "After four resolutions no contact is closing, so stop before you reach the limit.",
        ),
    ):
        about.call = f"{setup}{limit}, 0.5)"
        about.cause = cause
        bodies = row(speed, 0.0, 0.0, 0.0, 0.0, mass=mass)
        contacts = touching(*pairs, restitution=1.0)
        used, after, _ = resolved(bodies, contacts, "resolve_velocities", limit)
        got = tuple(velocity[0] for _, velocity in after)
        wanted = tuple(speed * (i == leaves) for i in range(5))
        name = "; the velocities of the five balls"
        expect_close(got, wanted, then=name, tolerance=1e-13, unit="m/s")
        expect_exactly(used, min(limit, 4), then="; the return value", unit="resolutions")


@pytest.mark.exercise("B7.5", asks="or when no contact closes faster than")
def test_only_closing_contacts_are_resolved(rng: Random) -> None:
    about.read = FASTEST
    n = direction(rng)
    noise = "You resolved a contact that closes at only 1e-13 m/s. This is below "
    noise += "VELOCITY_TOLERANCE, so treat it as a rounding error and skip the contact."
    slow = "You skipped a contact that closes at 1e-11 m/s, which is faster than "
    slow += "VELOCITY_TOLERANCE (1e-12 m/s). Don't use a larger tolerance."
    for closing, depth, wanted, cause in (
        (1e-13, 0.0, 0, noise),
        (1e-11, 0.0, 1, slow),
        (0.5, -1.0, 1,
         "You skipped a closing contact because its penetration is negative. Resolve every "
         "contact that closes, whatever its penetration is."),
        (-0.5, 1.0, 0,
         "You resolved a contact that is already separating at 0.5 m/s. Skip it, however deep "
         "it is."),
        (0.0, 1.0, 0,
         "You resolved a contact that is deep but not closing, as the book's listing does. Skip "
         "it, and leave its depth to resolve_penetrations."),
        (1e-13, 1.0, 0, noise),
        (1e-11, 1.0, 1, slow),
    ):  # fmt: skip
        about.cause = cause
        u = components(rng)  # the velocity across the normal does not count
        v = tuple(p - (closing + dot(u, n)) * q for p, q in zip(u, n, strict=True))
        if closing == 0.0:
            v = (n[1], -n[0], 0.0)  # exactly across the normal
        about.call = f"particle a with velocity {v}; c = Contact(a, None, normal=Vector3{n}, "
        about.call += f"restitution=0.0, penetration={depth}); resolver.resolve_velocities([c], 9, "
        about.call += "0.5)"
        bodies = [(ZERO, v, 2.0)]
        used, after, depths = resolved(bodies, [(0, -1, n, 0.0, depth)], "resolve_velocities", 9)
        if used == 9 and depth == 0.0:
            about.cause = "You reached the limit of nine resolutions, perhaps because you don't "
            about.cause += "measure the speed along the contact's normal. Use the contact's "
            about.cause += "separating velocity."
        expect_exactly(used, wanted, then="; the return value", unit="resolutions")
        got = -dot(after[0][1], n)
        left = 0.0 if wanted else closing
        # Some roundings of numbers up to 20.
        expect_close(got, left, then="; the closing speed", tolerance=5e-14, unit="m/s")
        about.cause = "resolve_velocities has changed a position or a penetration. It should "
        about.cause += "change only velocities, and leave the rest to resolve_penetrations."
        expect_close(after[0][0], ZERO, then="; a.position", unit="m")
        expect_close(depths[0], depth, then="; c.penetration", unit="m")


@pytest.mark.exercise("B7.5", asks="or when no contact closes faster than")
def test_many_contacts_are_resolved(rng: Random) -> None:
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
    about.call = "nine particles, one of them immovable, with 11 closing contacts and a "
    about.call += "restitution of 0.5; resolver.resolve_velocities(contacts, 2000, 0.5)"
    about.cause = "At least one contact is still closing at the end. Keep going until no contact "
    about.cause += "closes faster than VELOCITY_TOLERANCE."
    used, after, _ = resolved(bodies, contacts, "resolve_velocities", 2000)
    got = max(dot(after[b][1], n) - dot(after[a][1], n) for a, b, n, _, _ in contacts)
    name = f"{about.call}; then the largest closing speed, negative if all contacts separate"
    # VELOCITY_TOLERANCE is 1e-12. Separating is fine, and nothing separates faster than 100 m/s.
    expect_between(got, -100.0, 2e-12, call=name, unit="m/s")
    # One resolution changes two bodies, and no two bodies take part in all of the contacts.
    about.cause = "You returned the wrong number. Count how many times you resolve a contact, and "
    about.cause += "return that count, which is above 1 and below the limit here."
    expect_between(used, 2, 1998, then="; the return value", unit="resolutions")
    before, now = (
        sum(0.5 * m * dot(v, v) for (_, _, m), v in zip(bodies[:8], velocities, strict=False))
        for velocities in ([v for _, v, _ in bodies], [v for _, v in after])
    )
    about.cause = "The kinetic energy has grown, but with a restitution of 0.5 impulses can only "
    about.cause += "reduce it. Check the signs and the masses in Contact.resolve_velocity."
    name = f"{about.call}; the kinetic energy after the call divided by the one before"
    expect_between(now / before, 0.0, 1.0, call=name)


@pytest.mark.exercise("B7.5", asks="Pass duration on to resolve_velocity")
def test_each_resolution_gets_the_duration() -> None:
    about.read = FASTEST
    setup = "particles a and b, both with velocity (0, -4, 0) and acceleration (0, -4, 0); both "
    setup += "touch the ground, with a restitution of 0.75; "
    setup += "resolver.resolve_velocities(contacts, 9, "
    about.cause = "Your bounces include the velocity that the acceleration has added in this time "
    about.cause += "step. Pass the duration to Contact.resolve_velocity, which leaves this "
    about.cause += "velocity out."
    for duration, wanted in ((0.25, 2.25), (0.5, 1.5), (1.0, 0.0)):
        about.call = f"{setup}{duration})"
        contacts = [(0, -1, UP, 0.75, 0.0), (1, -1, UP, 0.75, 0.0)]
        bodies = [(ZERO, (0.0, -4.0, 0.0), 2.0), (ZERO, (0.0, -4.0, 0.0), 3.0)]
        pull = (0.0, -4.0, 0.0)
        _, after, _ = resolved(bodies, contacts, "resolve_velocities", 9, duration, pull)
        name = "; the velocities of a and b along y"
        got = (after[0][1][1], after[1][1][1])
        expect_close(got, (wanted, wanted), then=name, unit="m/s")
