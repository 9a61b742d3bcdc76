"""The contact resolver changes velocities, fastest contact first, build task B7.5."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.probes import resolved
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_between, expect_close, expect_exactly, xyz

ZERO, UP = Triple((0.0, 0.0, 0.0)), Triple((0.0, 1.0, 0.0))
FASTEST = "book 7.3.1, and the docstring of ContactResolver.resolve_velocities"
RETURNED = "; the return value"
SPEEDS = "; the velocities of the balls along x"
COUNT = "Count the resolutions, and return that count, even if the limit was reached."
# The velocities in the first check after up to three resolutions.
STAGES = (
    (1.0, 0.0, -3.0),
    (1.0, -2.25, -0.75),
    (-1.4375, 0.1875, -0.75),
    (-1.4375, -0.515625, -0.046875),
)


@pytest.mark.exercise("B7.5", asks="velocity of the contact that closes fastest", read=FASTEST)
def test_the_fastest_contact_is_resolved_first() -> None:
    right_first = "Resolve the right pair first, because it closes at 3 m/s, the left one at 1 m/s."
    for pairs, limit, left_first, cause in (
        (((2, 1), (1, 0)), 1, "You resolved the contact that closes slowest.", right_first),
        (((1, 0), (2, 1)), 1, "You resolved the first closing contact in the list.", right_first),
        (((1, 0), (2, 1)), 2, "You resolved the left pair first.",
         "After the right pair, resolve the left pair, because it now closes at 3.25 m/s."),
        (((1, 0), (2, 1)), 9, "You resolved the left pair first.",
         "After two resolutions the right pair closes again, so resolve it once more."),
    ):  # fmt: skip
        with calls(f"{cause} Compare all separating velocities before each resolution."):
            balls = [Particle(Vector3(i), Vector3(v)) for i, v in enumerate(STAGES[0])]
            contacts = [Contact(balls[i], balls[j], Vector3(1.0), 0.5) for i, j in pairs]
            used = ContactResolver().resolve_velocities(contacts, limit, 0.5)
        got = tuple(ball.velocity.x for ball in balls)
        many = f"but the limit is {limit}. Stop when you reach the limit."
        two = "You stopped after two resolutions, although the right pair is closing again by "
        two += "then. Search all contacts again after each resolution, and reset the lowest "
        two += "velocity before each search."
        slips = {
            f"{left_first} Choose the contact that closes fastest, which is the one with the "
            "lowest separating velocity.": (0.25, 0.75, -3.0),
            "You resolved no contact at all. A contact closes if its separating velocity is below "
            "-VELOCITY_TOLERANCE, so turn your comparison around.": STAGES[0],
            "You stopped after one resolution, although the left pair still closes. Go on until "
            "you reach the limit.": STAGES[1],
            f"You resolved two contacts, {many}" if limit == 1 else two: STAGES[2],
            f"You resolved three contacts, {many}": STAGES[3],
        }
        wanted = min(limit, 3)
        expect_close(got, STAGES[wanted], slips, then=SPEEDS, unit="m/s")
        why = COUNT
        if used == limit == 9:
            why = "You returned 9, the limit. Stop after three, when no contact closes any more."
        expect_exactly(used, wanted, then=RETURNED, cause=why, unit="resolutions")


@pytest.mark.exercise("B7.5", asks="This phase ignores penetrations", read=FASTEST)
def test_only_the_closing_velocity_decides(rng: Random) -> None:
    side = positive_number(rng, 20.0, 90.0)
    with calls(
        "The contact of c closes fastest, at 3 m/s. Include the velocity of contact.other in the "
        "closing speed, even if it is immovable.",
        "particle a (100 kg) hits the ground with velocity (0, -2, 0) and a restitution of 1; "
        f"particle b (100 kg) hits the ground with velocity ({side}, -1, {side}) and a restitution "
        "of 1; particle c (1 kg) is at rest; an immovable particle hits c from below with velocity "
        "(0, 3, 0) and a restitution of 0; resolver.resolve_velocities(contacts, 1, 0.5) with "
        "these three contacts",
    ):
        bodies = [
            (ZERO, (0.0, -2.0, 0.0), 100.0),
            (ZERO, (side, -1.0, side), 100.0),
            (ZERO, ZERO, 1.0),
            (ZERO, (0.0, 3.0, 0.0), math.inf),
        ]
        contacts = [(0, -1, UP, 1.0, 0.5), (1, -1, UP, 1.0, 0.75), (2, 3, UP, 0.0, -0.25)]
        used, after, depths = resolved(bodies, contacts, 1, velocities=True)
    slips = {
        f"You resolved the contact of {one}, but the contact of c closes faster. Compare only the "
        "separating velocities, whatever the depth and the restitution are.": speeds
        for one, speeds in (("a", (2.0, -1.0, 0.0)), ("b", (-2.0, 1.0, 0.0)))
    }
    got, name = tuple(v[1] for _, v in after[:3]), "; the velocities of a, b and c along y"
    expect_close(got, (-2.0, -1.0, 3.0), slips, then=name, unit="m/s")
    expect_exactly(used, 1, then=RETURNED, cause=COUNT)
    why = "You changed the order of the contacts in the list. The list belongs to the caller, so "
    name, why = "; the penetrations of the contacts, in list order", f"{why}don't sort it."
    expect_close(depths, (0.5, 0.75, -0.25), then=name, cause=why, unit="m")
    with calls("The list of contacts is empty. Return 0 as the number of resolutions."):
        used = ContactResolver().resolve_velocities([], 9, 0.5)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.5", asks="contacts are equally fast, take the first", read=FASTEST)
def test_the_first_of_two_equally_fast_contacts_is_resolved() -> None:
    for pairs, wanted in (
        (((1, 0), (2, 1)), (0.0, 2.0, -2.0)),
        (((2, 1), (1, 0)), (2.0, -2.0, 0.0)),
    ):
        with calls("Both pairs close at 2 m/s, so the first has priority. Use < instead of <=."):
            balls = [Particle(Vector3(i), Vector3(2.0 - 2.0 * i)) for i in range(3)]
            contacts = [Contact(balls[i], balls[j], Vector3(1.0), 1.0) for i, j in pairs]
            used = ContactResolver().resolve_velocities(contacts, 1, 0.5)
        got = tuple(ball.velocity.x for ball in balls)
        expect_close(got, wanted, then=SPEEDS, unit="m/s")
        expect_exactly(used, 1, then=RETURNED, cause=COUNT)


@pytest.mark.exercise("B7.5", asks="Stop after limit resolutions", read=FASTEST)
def test_a_push_goes_through_a_row(rng: Random) -> None:
    """Only here each resolution makes another contact close, in an order unlike the list's."""
    speeds, mass = (positive_number(rng), 0.0, 0.0, 0.0, 0.0), positive_number(rng)
    pairs = ((4, 3), (2, 1), (3, 2), (1, 0))
    for limit, leaves, cause in (
        (2, 2,
         "After two resolutions only the third ball moves. Stop at the limit."),
        (4, 4,
         "Only the last ball moves. Always resolve the contact that closes fastest."),
        (50, 4,
         "After four resolutions no contact is closing, so stop before you reach the limit."),
    ):  # fmt: skip
        with calls(cause):
            balls = [Particle(Vector3(i), Vector3(v), mass=mass) for i, v in enumerate(speeds)]
            contacts = [Contact(balls[i], balls[j], Vector3(1.0), 1.0) for i, j in pairs]
            used = ContactResolver().resolve_velocities(contacts, limit, 0.5)
        got = tuple(ball.velocity.x for ball in balls)
        wanted = tuple(speeds[0] * (i == leaves) for i in range(5))
        expect_close(got, wanted, then=SPEEDS, tolerance=1e-13, unit="m/s")
        expect_exactly(used, min(limit, 4), then=RETURNED, unit="resolutions")


@pytest.mark.exercise("B7.5", asks="or when no contact closes faster than", read=FASTEST)
def test_only_closing_contacts_are_resolved(rng: Random) -> None:
    n = unit_vector(rng)
    noise = "1e-13 m/s is below VELOCITY_TOLERANCE, so treat it as a rounding error and skip it."
    slow = "1e-11 m/s is faster than VELOCITY_TOLERANCE (1e-12 m/s), so resolve this contact."
    for closing, depth, wanted, cause in (
        (1e-13, 0.0, 0, noise),
        (1e-11, 0.0, 1, slow),
        (0.5, -1.0, 1,
         "Resolve every contact that closes, even if its penetration is negative."),
        (-0.5, 1.0, 0,
         "It is already separating at 0.5 m/s. Skip it, however deep it is."),
        (0.0, 1.0, 0,
         "It is deep but doesn't close. Skip it, and leave its depth to resolve_penetrations."),
        (1e-13, 1.0, 0, noise),
        (1e-11, 1.0, 1, slow),
    ):  # fmt: skip
        u = vector(rng)  # the velocity across the normal does not count
        v = u - n * (closing + u @ n) if closing else (n[1], -n[0], 0.0)
        with calls(cause):
            a = Particle(velocity=Vector3(*v), mass=2.0)
            c = Contact(a, None, normal=Vector3(*n), restitution=0.0, penetration=depth)
            used = ContactResolver().resolve_velocities([c], 9, 0.5)
        if used == 9 and depth == 0.0:
            cause = "Measure the speed along the contact's normal: its separating velocity."
        expect_exactly(used, wanted, then=RETURNED, cause=cause, unit="resolutions")
        got, left = -(n @ xyz(a.velocity)), 0.0 if wanted else closing
        # Some roundings of numbers up to 20.
        expect_close(got, left, then="; the closing speed", tolerance=5e-14, unit="m/s")
        why = "Change only velocities here, and leave the rest to resolve_penetrations."
        expect_close(xyz(a.position), ZERO, then="; a.position", cause=why, unit="m")
        expect_close(c.penetration, depth, then="; c.penetration", cause=why, unit="m")


@pytest.mark.exercise("B7.5", asks="or when no contact closes faster than", read=FASTEST)
def test_many_contacts_are_resolved(rng: Random) -> None:
    bodies = [(vector(rng), vector(rng), positive_number(rng, 2.0, 5.0)) for _ in range(6)]
    # Two more move toward the immovable one, one behind the other. It throws both back.
    right = Triple((1.0, 0.0, 0.0))
    bodies += [(ZERO, 5.0 * right, 1.0), (right, 2.0 * right, 1.0), (ZERO, ZERO, math.inf)]
    contacts = [(8, 7, right, 0.5, 0.0), (7, 6, right, 0.5, 0.0)]
    for a, b in [(0, 8), (1, 0), (2, 0), (2, 1), (3, 1), (3, 8), (4, 2), (5, 3), (5, 4)]:
        n = unit_vector(rng)
        closing = bodies[a][1] @ n <= bodies[b][1] @ n
        contacts.append((a, b, n if closing else -n, 0.5, 0.0))
    with calls(
        "At least one contact is still closing at the end. Keep going until no contact closes "
        "faster than VELOCITY_TOLERANCE.",
        "nine particles, one of them immovable, with 11 closing contacts and a restitution of 0.5; "
        "resolver.resolve_velocities(contacts, 2000, 0.5)",
    ):
        used, after, _ = resolved(bodies, contacts, 2000, velocities=True)
    velocities = [Triple(v) for _, v in after]
    got = max((velocities[b] - velocities[a]) @ n for a, b, n, _, _ in contacts)
    name = "; the largest closing speed, negative if all contacts separate"
    # VELOCITY_TOLERANCE is 1e-12. Separating is fine, and nothing separates faster than 100 m/s.
    expect_between(got, -100.0, 2e-12, then=name, unit="m/s")
    # One resolution changes two bodies, and no two bodies take part in all of the contacts.
    why = f"The count is above 1 and below the limit here. {COUNT}"
    expect_between(used, 2, 1998, then=RETURNED, cause=why, unit="resolutions")
    before = sum(m * (v @ v) for _, v, m in bodies[:8])
    now = sum(m * (v @ v) for v, (_, _, m) in zip(velocities[:8], bodies[:8], strict=True))
    why = "The energy has grown. Check signs and masses in Contact.resolve_velocity."
    name = "; the kinetic energy after the call divided by the one before"
    expect_between(now / before, 0.0, 1.0, then=name, cause=why)


@pytest.mark.exercise("B7.5", asks="Pass duration on to resolve_velocity", read=FASTEST)
def test_each_resolution_gets_the_duration() -> None:
    for duration, wanted in ((0.25, 2.25), (0.5, 1.5), (1.0, 0.0)):
        with calls("Pass the duration to resolve_velocity, which leaves out what this step added."):
            a, b = (
                Particle(None, Vector3(0.0, -4.0, 0.0), Vector3(0.0, -4.0, 0.0), mass=mass)
                for mass in (2.0, 3.0)
            )
            contacts = [Contact(p, None, normal=Vector3(*UP), restitution=0.75) for p in (a, b)]
            ContactResolver().resolve_velocities(contacts, 9, duration)
        expect_close(a.velocity.y, wanted, then="; a.velocity.y", unit="m/s")
        expect_close(b.velocity.y, wanted, then="; b.velocity.y", unit="m/s")
