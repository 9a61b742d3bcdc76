"""The contact resolver: the fastest first, and the deepest first, build tasks B7.5 and B7.6."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch07_constraints.probes import resolved, stacked
from draw import Components, components, direction, dot, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
RIGHT = (1.0, 0.0, 0.0)
LEFT = (-1.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
FASTEST = "book 7.3.1, and the docstring of ContactResolver.resolve_velocities"
DEEPEST = "book 7.3.1, E-8, and the docstring of ContactResolver.resolve_penetrations"
Body = tuple[Components, Components, float]


def row(*speeds: float, mass: float = 1.0) -> list[Body]:
    """Return bodies along X that touch, with speeds along X."""
    return [((float(i), 0.0, 0.0), (speed, 0.0, 0.0), mass) for i, speed in enumerate(speeds)]


def touching(*pairs: tuple[int, int], restitution: float = 0.0) -> list:
    """Return contacts of pairs in a row, without depth; the second body is to the left."""
    return [(a, b, RIGHT, restitution, 0.0) for a, b in pairs]


@pytest.mark.exercise("B7.5")
def test_what_closes_fastest_is_first() -> None:
    about.read = FASTEST
    contacts = touching((1, 0), (2, 1), restitution=0.5)
    about.call = "three balls of 1 kg in a row with 1, 0 and -3 m/s, restitution 0.5; "
    about.call += "resolve_velocities([left pair, right pair], limit, 0.5), limit"
    for limit, wanted, cause in (
        (1, (1.0, -2.25, -0.75), "the right pair closes with 3 m/s, the left one with 1"),
        (2, (-1.4375, 0.1875, -0.75), "then the left one, which closes with 3.25 m/s by now"),
        (9, (-1.4375, -0.515625, -0.046875), "and the right pair once more; then all part"),
    ):
        about.cause = cause
        about.cause += ": look at all contacts again before each resolution, and end after limit "
        about.cause += "of them"
        used, bodies, _ = resolved(row(1.0, 0.0, -3.0), contacts, "resolve_velocities", limit)
        got = tuple(velocity[0] for _, velocity in bodies)
        mistakes = [
            ((1.0, 0.0, -3.0), "nothing is resolved: what closes is below -VELOCITY_TOLERANCE"),
            ((0.25, 0.75, -3.0), "the first that closes was taken: take the lowest of them all"),
            ((-1.4375, -0.515625, -0.046875), f"the limit is {limit}: three were resolved"),
            ((-1.4375, 0.1875, -0.75), "the right pair closes again now: look at all once more"),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, then=f" {limit}: velocities")
        about.cause = "it returns how many contacts it has resolved, and ends when none closes"
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
    contacts = [
        (0, -1, UP, 1.0, 0.5),
        (1, -1, UP, 1.0, 0.75),
        (2, 3, UP, 0.0, -0.25),
    ]
    about.call = f"a of 100 kg with (0, -2, 0), b of 100 kg with ({side}, -1, {side}), both with "
    about.call += "the ground and restitution 1; c of 1 kg at rest over a wall with (0, 3, 0), "
    about.call += "restitution 0, 0.25 m apart; resolve_velocities of a, b and c, limit 1"
    about.cause = "what closes fastest is resolved, c with 3 m/s: not what is heaviest, bounces "
    about.cause += "most, is fastest along the ground, or is deepest; and an immovable other may "
    about.cause += "have a velocity"
    used, after, depths = resolved(bodies, contacts, "resolve_velocities", 1)
    got = tuple(velocity[1] for _, velocity in after[:3])
    mistakes = [
        ((2.0, -1.0, 0.0), "a was resolved, c closes faster: by how much is the separating "
         "velocity alone, not the depth (c is apart), the bounce, or whether the other moves"),
        ((-2.0, 1.0, 0.0), "b was resolved, the deepest, and fastest along the ground: c closes "
         "fastest, by its separating velocity"),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, (-2.0, -1.0, 3.0), then=": velocities upwards")
    expect_exactly(used, 1, then="; returned", cause="one was resolved")
    about.cause = "the list stays in its order"
    expect_close(depths, (0.5, 0.75, -0.25), then="; penetrations of the contacts")
    about.call = "resolve_velocities([], 9, 0.5)"
    about.cause = "without contacts there is nothing to resolve: 0, and no error"
    used, _, _ = resolved([], [], "resolve_velocities", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.5")
def test_of_equal_ones_the_first_is_taken() -> None:
    about.read = FASTEST
    about.cause = "both close with 2 m/s: the first in the list is taken, as < keeps it"
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
        expect_exactly(used, 1, then="; returned", cause="one was resolved")


@pytest.mark.exercise("B7.5")
def test_a_push_goes_through_a_row(rng: Random) -> None:
    about.read = FASTEST
    speed, mass = positive_number(rng), positive_number(rng)
    pairs = [(4, 3), (2, 1), (3, 2), (1, 0)]
    about.call = f"five balls of {mass} kg in a row, the first with {speed} m/s, restitution 1; "
    about.call += f"resolve_velocities of the pairs {pairs}, limit"
    for limit, leaves, cause in (
        (2, 2, "one pair closes at a time, and passes all of the motion on: end at the limit"),
        (4, 4, "the last ball flies off, and the others stand"),
        (50, 4, "then nothing closes: end before the limit"),
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
        (1e-13, 0.0, 0, "slower than VELOCITY_TOLERANCE is rounding: leave it"),
        (1e-11, 0.0, 1, "faster than VELOCITY_TOLERANCE is to be resolved"),
        (0.5, -1.0, 1, "how deep a contact is does not matter here"),
        (-0.5, 1.0, 0, "what parts is left alone, however deep it is"),
        (0.0, 1.0, 0, "the listing resolves what is deep as well: here the other phase does"),
        (1e-13, 1.0, 0, "slower than VELOCITY_TOLERANCE is rounding, however deep it is"),
        (1e-11, 1.0, 1, "faster than VELOCITY_TOLERANCE is to be resolved"),
    ):
        about.cause = cause
        u = components(rng)  # what is fast along the contact closes no faster
        v = tuple(p - (closing + dot(u, n)) * q for p, q in zip(u, n, strict=True))
        if closing == 0.0:
            v = (n[1], -n[0], 0.0)  # straight across, without a rounding
        about.call = f"a with velocity {v}; resolve_velocities([Contact(a, None, Vector3{n}, 0, "
        about.call += f"{depth})], 9, 0.5)"
        bodies = [(ZERO, v, 2.0)]
        about.cause += "; how fast it closes is told along its own normal, also beside the world"
        used, after, depths = resolved(bodies, [(0, -1, n, 0.0, depth)], "resolve_velocities", 9)
        expect_exactly(used, wanted, then=": returned")
        got = -dot(after[0][1], n)
        left = 0.0 if wanted else closing
        # Some roundings of numbers up to 20.
        expect_close(got, left, then=": how fast it closes", tolerance=5e-14)
        about.cause = "velocities only: places and depths are for the other phase"
        expect_close(after[0][0], ZERO, then=": position")
        expect_close(depths[0], depth, then=": penetration")


@pytest.mark.exercise("B7.5")
def test_many_contacts_come_to_an_end(rng: Random) -> None:
    about.read = FASTEST
    bodies = [(components(rng), components(rng), positive_number(rng, 2.0, 5.0)) for _ in range(6)]
    # Two more, one behind the other on their way to the immovable one: it throws both back.
    bodies += [*row(5.0, 2.0), (ZERO, ZERO, math.inf)]
    contacts = touching((8, 7), (7, 6), restitution=0.5)
    for a, b in [(0, 8), (1, 0), (2, 0), (2, 1), (3, 1), (3, 8), (4, 2), (5, 3), (5, 4)]:
        n = direction(rng)
        if dot(bodies[a][1], n) > dot(bodies[b][1], n):
            n = (-n[0], -n[1], -n[2])
        contacts.append((a, b, n, 0.5, 0.0))
    about.call = "9 particles, one of them immovable, with 11 contacts that all close, restitution "
    about.call += "0.5; resolve_velocities, limit 2000"
    about.cause = "it goes on until nothing closes faster than VELOCITY_TOLERANCE"
    used, after, _ = resolved(bodies, contacts, "resolve_velocities", 2000)
    got = max(dot(after[b][1], n) - dot(after[a][1], n) for a, b, n, _, _ in contacts)
    # VELOCITY_TOLERANCE is 1e-12; what parts is right, and none parts faster than 100 m/s.
    expect_close(
        got,
        -50.0,
        then=": how fast the worst one still closes, or parts if negative",
        tolerance=50.0 + 2e-12,
    )
    # One resolution changes two bodies, and no two bodies have a part in all of the contacts.
    about.cause = "it returns how many it has resolved, which is more than 1 and less than the "
    about.cause += "limit here"
    expect_close(used, 1000, then=": returned", tolerance=998)
    before, now = (
        sum(0.5 * m * dot(v, v) for (_, _, m), v in zip(bodies[:8], velocities, strict=False))
        for velocities in ([v for _, v, _ in bodies], [v for _, v in after])
    )
    about.cause = "an impulse at restitution 0.5 takes energy out, and never puts some in"
    expect_close(
        now / before, 0.5, then=": the kinetic energy, as a share of that before", tolerance=0.5
    )


@pytest.mark.exercise("B7.5")
def test_each_resolution_knows_the_duration() -> None:
    about.read = FASTEST
    about.call = "a and b with velocity (0, -4, 0), acceleration (0, -4, 0); resolve_velocities of "
    about.call += "their contacts with the ground, restitution 0.75, limit 9, duration"
    about.cause = "give the duration on to Contact.resolve_velocity: what the frame has built up "
    about.cause += "does not bounce"
    for duration, wanted in ((0.25, 2.25), (0.5, 1.5), (1.0, 0.0)):
        contacts = [(0, -1, UP, 0.75, 0.0), (1, -1, UP, 0.75, 0.0)]
        bodies = [(ZERO, (0.0, -4.0, 0.0), 2.0), (ZERO, (0.0, -4.0, 0.0), 3.0)]
        pull = (0.0, -4.0, 0.0)
        _, after, _ = resolved(bodies, contacts, "resolve_velocities", 9, duration, pull)
        got = (after[0][1][1], after[1][1][1])
        expect_close(got, (wanted, wanted), then=f" {duration}: velocities upwards")


@pytest.mark.exercise("B7.6")
def test_what_is_deepest_is_first() -> None:
    about.read = DEEPEST
    bodies = row(1.0, 0.0, -1.0)
    about.call = "three balls of 1 kg in a row, with 1, 0 and -1 m/s; resolve_penetrations of the "
    about.call += "two contacts of the middle one, 0.5 m deep with the left and 0.75 m with the "
    about.call += "right one, limit"
    contacts = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.75)]
    for limit, wanted, depths, cause in (
        (1, (0.0, 0.625, 2.375), (0.875, 0.0), "the deepest first: both move by half of it"),
        (
            2,
            (-0.4375, 1.0625, 2.375),
            (0.0, 0.4375),
            "then the left one, which is 0.875 m deep by now: the middle one was pushed into it",
        ),
        (
            3,
            (-0.4375, 0.84375, 2.59375),
            (0.21875, 0.0),
            "and so on",
        ),
    ):
        about.cause = cause
        used, after, got_depths = resolved(bodies, contacts, "resolve_penetrations", limit)
        got = tuple(place[0] for place, _ in after)
        mistakes = [((-0.25, 1.25, 2.0), "the left pair was taken: the right one is deeper")]
        if isinstance(used, int) and used > limit:
            about.cause = f"the limit is {limit}: {used} were resolved"
        seen = cause_of(got, mistakes, about.cause)
        expect_close(got, wanted, then=f" {limit}: places", cause=seen)
        about.cause += "; each move changes how deep the other contact of the middle one is (E-8)"
        mistakes = [
            ((0.5, 0.0), "the left one is still 0.5 m: the middle ball was moved 0.375 m into it, "
             "and that changes its other contact; the listing leaves it out (E-8)"),
            ((0.125, 0.0), "the sign: the other contact got less deep, but the middle ball was "
             "moved into the left one, by 0.375 m"),
            ((0.875, -0.75), "the resolved contact was changed once more: it is 0 by itself, so "
             "leave it out of the loop over the others"),
            ((0.0, 0.0), "the right one is still 0: the middle ball is its other, and an other "
             "that moves changes it too"),
            ((0.0, -0.4375), "the sign for an other is the opposite: it was moved into the "
             "contact, by 0.4375 m"),
        ]  # fmt: skip
        blame(got_depths, mistakes)
        expect_close(got_depths, depths, then=f" {limit}: penetrations")
        about.cause = "it returns how many contacts it has resolved"
        expect_exactly(used, limit, then=f" {limit}: returned")
        got = tuple(velocity[0] for _, velocity in after)
        about.cause = "places only: velocities are for the other phase"
        expect_close(got, (1.0, 0.0, -1.0), then=f" {limit}: velocities")
    about.call = "the same with 0.5 m each, limit 1: penetrations"
    for order in ((0, 1), (1, 0)):
        equal = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5)]
        about.cause = "both are 0.5 m deep: the first in the list is taken"
        _, _, got = resolved(bodies, [equal[i] for i in order], "resolve_penetrations", 1)
        expect_close(got, (0.0, 0.75), then=f", order {order}")


@pytest.mark.exercise("B7.6")
def test_one_contact_is_resolved_once(rng: Random) -> None:
    about.read = DEEPEST
    n, mass, depth = direction(rng), positive_number(rng), positive_number(rng, 0.1, 0.9)
    for deep, wanted, cause in (
        (depth, 1, "once it touches, it is done: the book's listing moves it again (E-8)"),
        (2e-9, 1, "deeper than DEPTH_TOLERANCE is to be resolved"),
        (5e-10, 0, "what is less deep than DEPTH_TOLERANCE touches: leave it"),
        (-1.0, 0, "what is apart is left alone"),
    ):
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
    about.cause = "without contacts there is nothing to resolve: 0, and no error"
    used, _, _ = resolved([], [], "resolve_penetrations", 9)
    expect_exactly(used, 0)


@pytest.mark.exercise("B7.6")
def test_a_move_changes_all_contacts_of_its_particles(rng: Random) -> None:
    about.read = DEEPEST
    n, ma, mb = direction(rng), positive_number(rng), positive_number(rng)
    # a and b are the ones that move; c and d are theirs, e and f nobody's. e is where a is.
    bodies = [(components(rng), ZERO, mass) for mass in (ma, mb, math.inf, 4.0, 5.0, 6.0)]
    bodies[4] = (bodies[0][0], ZERO, 5.0)
    normals = [direction(rng) for _ in range(9)]
    ends = [(0, 2), (2, 0), (1, 3), (3, 1), (0, -1), (1, -1), (0, 1), (1, 0), (4, 5)]
    others = [(p, q, m, 0.0, -5.0) for (p, q), m in zip(ends, normals, strict=True)]
    others.append((4, -1, normals[0], 0.0, -5.0))
    names = {-1: "the world", 0: "a", 1: "b", 2: "c", 3: "d", 4: "e", 5: "f"}
    between_two = {0: 0.5 * mb / (ma + mb), 1: -0.5 * ma / (ma + mb)}
    for end, moves in ((1, between_two), (-1, {0: 0.5})):
        about.call = f"a of {ma} kg and {names[end]} (b has {mb} kg) are 0.5 m deep in each other, "
        about.call += f"normal {n}; resolve_penetrations, limit 1; the penetration of another "
        about.call += "contact, -5 before, between"
        contacts = [others[0], (0, end, n, 0.0, 0.5), *others[1:]]
        about.cause = "the contact itself touches"
        _, _, depths = resolved(bodies, contacts, "resolve_penetrations", 1)
        name = f"{about.call[:-8]} itself"
        expect_close(depths[1], 0.0, call=name)
        for (p, q, m, _, _), got in zip(others, [depths[0], *depths[2:]], strict=True):
            wanted = -5.0 - (moves.get(p, 0.0) - moves.get(q, 0.0)) * dot(n, m)
            about.cause = "less by how far its particle moved along its normal, more by how far "
            about.cause += "its other did, whatever its other end; the world never moves: `is` "
            about.cause += "tells two particles apart, and None is None as well"
            expect_close(got, wanted, then=f" {names[p]} and {names[q]}", tolerance=1e-14)


@pytest.mark.exercise("B7.6")
def test_both_phases_have_their_own_limit() -> None:
    about.read = "the docstring of ContactResolver"
    bodies = [*row(2.0, 0.0, -2.0), ((9.0, 0.0, 0.0), RIGHT, math.inf)]
    pairs = [(1, 0, RIGHT, 0.0, 0.5), (2, 1, RIGHT, 0.0, 0.5), (3, -1, LEFT, 0.0, 9.0)]
    about.call = "three balls of 1 kg in a row with 2, 0 and -2 m/s, two pairs 0.5 m deep, "
    about.call += "restitution 0; an immovable one deep in the world; "
    for iterations, wanted, cause in (
        (
            None,
            8,
            "each phase goes on while something closes, or is deep, up to twice the contacts",
        ),
        (3, 6, "each phase may use the 3 iterations of its own"),
        (1, 2, "each phase may use the one iteration of its own"),
    ):
        about.cause = cause
        used, after, _ = resolved(bodies, pairs, "resolve_contacts", iterations or 0)
        expect_exactly(
            used, wanted, then=f"ContactResolver({iterations}).resolve_contacts; iterations_used"
        )
        about.cause = "the places in the end are those of resolve_penetrations"
        got = math.fsum(place[0] for place, _ in after[:3])
        expect_close(
            got,
            3.0,
            then=f"ContactResolver({iterations}).resolve_contacts; the sum of the places",
            tolerance=1e-14,
        )
    pairs = [(1, 0, RIGHT, 0.0, 0.0), (2, 1, RIGHT, 0.0, -0.5)]
    about.cause = "where nothing closes and nothing is deep, nothing is used"
    used, after, _ = resolved(row(0.0, 0.0, 0.0), pairs, "resolve_contacts", 0)
    expect_exactly(used, 0, then="the balls at rest and apart; iterations_used")
    got = tuple(place[0] for place, _ in after)
    expect_close(got, (0.0, 1.0, 2.0), then="the balls at rest: places")


@pytest.mark.exercise("B7.6")
def test_a_stack_of_three_settles() -> None:
    about.read = "book 7.3.1, and the docstring of ContactResolver"
    about.call = "three spheres of 1 kg, radius 0.5 m, stacked on the ground; 5 s at h = 1/60, "
    about.call += "velocity first, with ContactResolver()"
    about.cause = "twice the contacts are iterations enough for three: if it sinks, a phase leaves "
    about.cause += "depths or speeds behind"
    heights, overlap = stacked(3, 0.5, None, 300, 1.0 / 60.0)
    # Measured: at most 0.015 m of overlap, which is what two iterations a contact leave.
    expect_close(heights, (0.5, 1.5, 2.5), then=": heights", tolerance=0.02)
    expect_close(overlap, 0.0, then=": the largest overlap after a frame, m", tolerance=0.02)
