"""Links: cables, rods, limits and two-sided rods, B7.7, B7.8, 7.6 and G7.1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod, TwoSidedRod
from ch07_constraints.probes import kind_of, swung, told
from draw import Components, components, positive_number
from expect import about, cause_of, expect_close, expect_exactly, expect_unchanged, scoped, xyz
from impacts import expect_list, expect_particles

UP = (0.0, 1.0, 0.0)
CABLE = "book 7.4.1, and the docstring of Cable.contacts"
ROD = "book 7.4.2, E-9, and the docstring of Rod.contacts"
LIMITS = "exercise 7.6, and the docstring of Limits.contacts"
TWO_SIDED = "the docstring of TwoSidedRod.contacts"
# The length of (2, 3, 6) and (6, 2, 3), and of both times a power of 2, has no rounding error.
WAYS = ((2.0, 3.0, 6.0), (-6.0, 2.0, 3.0), (3.0, -6.0, -2.0))


def ends(rng: Random, anchored: bool) -> tuple[list[Any], Components, float, str]:
    """Return both ends, about 7 m apart, the direction to the second, their distance, and words.

    The second end is a particle, or a vector as an anchor. Positions are whole numbers, so the
    distance is exact.
    """
    way = rng.choice(WAYS)
    size = rng.choice((0.5, 1.0, 2.0))
    p = tuple(float(rng.randint(-9, 9)) for _ in range(3))
    q = tuple(x + size * w for x, w in zip(p, way, strict=True))
    a = Particle(Vector3(*p), Vector3(1.0, 2.0, 3.0), mass=2.0)
    b = Vector3(*q) if anchored else Particle(Vector3(*q), Vector3(3.0, 2.0, 1.0), mass=3.0)
    x, y, z = (part / 7.0 for part in way)
    told_ends = f"particle a at {p}; {'anchor = Vector3' if anchored else 'particle b at '}{q}, "
    told_ends += f"{7.0 * size:g} m from a"
    return [a, b], (x, y, z), 7.0 * size, told_ends


@scoped
def expect_contacts(
    call: str,
    link: Any,
    particles: list[Any],
    wanted: list[tuple],
    counts: Sequence[tuple[int, str]] = (),
    far: float = math.nan,
) -> None:
    """Expect these contacts, in this order: ends, normal, restitution, penetration.

    ``counts`` has the likely mistake for a wrong number of contacts, ``far`` is the distance of
    the ends.
    """
    about.call, before = call, places(particles)
    found = link.contacts()
    expect_ends(particles, before)
    expect_list(kind_of(found))
    got = told(found, particles)
    why = about.cause if got else f"You returned no contact. {about.cause}"
    why = cause_of(len(got), counts, why)
    expect_exactly(len(got), len(wanted), cause=why, unit="contacts")
    for i, (seen, right) in enumerate(zip(got, wanted, strict=True)):
        which = f"the {('first', 'second')[i]} contact" if len(wanted) > 1 else "the contact"
        a, b, normal, restitution, depth = seen
        why = "The particles of the contact are wrong. Pass a as particle and "
        why += f"{'b' if right[1] == 1 else 'None'} as other."
        expect_particles((a, b), right[:2], cause=why)
        back = tuple(-part for part in right[2])
        why = f"Your normal points the wrong way. {about.cause}"
        if depth == -right[4] != 0.0 and len(wanted) == 1:
            why = "You gave the contact a negative penetration. Reverse its normal instead, and "
            why += f"keep the penetration positive. {about.cause}"
        why = cause_of(normal, [(back, why)], about.cause)
        expect_close(normal, right[2], then=f"; the normal of {which}", cause=why, tolerance=1e-15)
        why = "You passed the penetration as the restitution. The order of the arguments is "
        why += "Contact(particle, other, normal, restitution, penetration)."
        if restitution != right[4]:
            why = "The contact has the wrong restitution. Pass "
            why += f"{'self.restitution' if right[3] else 0} to Contact instead."
        expect_close(restitution, right[3], then=f"; the restitution of {which}", cause=why)
        sign = "It must be positive, so that the resolver corrects the distance between the ends."
        if len(wanted) > 1:
            sign = "Use distance - length for the first contact, and length - distance for the "
            sign += "second one."
        depths = [
            (-right[4] or math.nan, f"Your penetration has the wrong sign. {sign}"),
            (far, "You used the whole distance between the ends as the penetration. Use the "
                  "difference between this distance and the allowed length."),
        ]  # fmt: skip
        why = "The penetration is wrong. Use the difference between the distance of the ends and "
        why += "the allowed length."
        why = cause_of(depth, depths, about.cause if math.isnan(far) else why)
        # Lengths of up to 20 m, rounded a few times.
        name = f"; the penetration of {which}"
        expect_close(depth, right[4], then=name, cause=why, tolerance=1e-14, unit="m")


def places(pair: list[Any]) -> Components:
    """Return the positions of both ends in one tuple."""
    a, b = (xyz(getattr(end, "position", end)) for end in pair)
    return a + b


@scoped
def expect_ends(pair: list[Any], before: Components) -> None:
    about.cause = "contacts() has changed a position, perhaps with -=, which changes a vector in "
    about.cause += "place. Subtract with -, which creates a new vector."
    now, end = places(pair), "b.position" if hasattr(pair[1], "position") else "anchor"
    expect_unchanged("a.position", now[:3], before[:3])
    expect_unchanged(end, now[3:], before[3:])


@pytest.mark.exercise("B7.7", asks="one contact if the cable is taut")
@pytest.mark.parametrize("anchored", [False, True], ids=["between two", "anchored"])
def test_a_taut_cable_pulls(rng: Random, anchored: bool) -> None:
    about.read = CABLE
    pair, n, length, told_ends = ends(rng, anchored)
    make, name = (AnchoredCable, "AnchoredCable") if anchored else (Cable, "Cable")
    c = round(rng.uniform(0.1, 0.9), 3)
    other = -1 if anchored else 1
    if not anchored:
        pair[0].mass = math.inf
        told_ends = told_ends.replace("a at", "a (immovable) at")
    end = "the anchor" if anchored else "b"
    to_the_end = f"The cable is taut and pulls a toward {end}. Divide the vector from a to {end} "
    to_the_end += "by its length to get the normal."
    before = places(pair)
    for max_length, cause in (
        (1023.0 / 1024.0 * length, to_the_end),
        (0.75 * length, to_the_end),
        (length, "A cable at its maximum length is taut. Return a contact with penetration 0."),
    ):
        about.cause = cause
        about.call = f"{told_ends}; {name}(a, {'anchor' if anchored else 'b'}, "
        about.call += f"max_length={max_length}, restitution={c}).contacts()"
        wanted = [(0, other, n, c, length - max_length)]
        none = [(0, "You returned no contact, but the cable is longer than max_length, so it is "
                    "taut. Return no contact only if it is shorter.")]  # fmt: skip
        none = none if max_length < length else []
        expect_contacts(about.call, make(*pair, max_length, c), pair, wanted, none, far=length)
        expect_ends(pair, before)


@pytest.mark.exercise("B7.7", asks="A slack cable has no contact")
@pytest.mark.parametrize("anchored", [False, True], ids=["between two", "anchored"])
def test_a_slack_cable_does_nothing(rng: Random, anchored: bool) -> None:
    about.read = CABLE
    pair, n, length, told_ends = ends(rng, anchored)
    make, name = (AnchoredCable, "AnchoredCable") if anchored else (Cable, "Cable")
    about.call = f"{told_ends}; c = {name}(a, {'anchor' if anchored else 'b'}, "
    about.call += f"max_length={1.25 * length}); c.contacts()"
    about.cause = "The cable is slack, because the distance between its ends is less than "
    about.cause += "max_length. Return an empty list."
    before = places(pair)
    cable = make(*pair, 1.25 * length)
    for max_length in (1.25 * length, 1025.0 / 1024.0 * length):
        cable.max_length = max_length
        shown = about.call.replace(f"max_length={1.25 * length}", f"max_length={max_length}")
        expect_contacts(shown, cable, pair, [])
        now = [pair[0], cable.anchor] if anchored else pair
        expect_ends(now, before)
    about.call += "; c.max_length /= 4; c.restitution = 0.5; c.contacts()"
    about.cause = "The cable's max_length and restitution have changed since the first call. Read "
    about.cause += "both again on every call."
    cable.max_length, cable.restitution = 0.3125 * length, 0.5
    wanted = [(0, -1 if anchored else 1, n, 0.5, 0.6875 * length)]
    expect_contacts(about.call, cable, pair, wanted)
    about.call += f"; {'anchor' if anchored else 'b'} moved to the opposite side of a; c.contacts()"
    about.cause = (
        "The ends have moved since the first call. Read both positions again on every call."
    )
    x, y, z = xyz(pair[0].position)
    back = (-n[0], -n[1], -n[2])
    there = Vector3(x - length * n[0], y - length * n[1], z - length * n[2])
    if anchored:
        cable.anchor = there
    else:
        pair[1].position = there
    wanted = [(0, -1 if anchored else 1, back, 0.5, 0.6875 * length)]
    expect_contacts(about.call, cable, pair, wanted)
    n = back
    about.cause = "contacts() has changed a position or a velocity. Compute with new vectors, so "
    about.cause += "that nothing moves."
    got = xyz(pair[0].position)
    there = cable.anchor if anchored else pair[1].position
    way = tuple(p - q for p, q in zip(xyz(there), got, strict=True))
    wanted_way = tuple(length * part for part in n)
    expect_close(way, wanted_way, then="; the vector from a to the other end", unit="m")
    got = xyz(pair[0].velocity)
    expect_unchanged("a.velocity", got, (1.0, 2.0, 3.0))


@pytest.mark.exercise("B7.8", asks="if the rod is too short or too long")
@pytest.mark.parametrize("anchored", [False, True], ids=["between two", "anchored"])
def test_a_rod_pulls_and_pushes(rng: Random, anchored: bool) -> None:
    about.read = ROD
    pair, n, length, told_ends = ends(rng, anchored)
    make, name = (AnchoredRod, "AnchoredRod") if anchored else (Rod, "Rod")
    other, end = (-1, "the anchor") if anchored else (1, "b")
    back = (-n[0], -n[1], -n[2])
    both = "You returned two contacts, as the book's text asks (E-9). This Rod follows the book's "
    both += "listing, so return only the contact that pulls or pushes. TwoSidedRod has two."
    none = "The rod has exactly the right length and needs no contact. Return an empty list."
    pulls = f"stretched and pulls a toward {end}. Return a contact whose normal points from a to "
    pulls += f"{end}."
    pushes = f"compressed and pushes a away from {end}. Return a contact whose normal points from "
    pushes += f"{end} to a."
    tiny = length / 1024.0
    for rod, wanted, cause in (
        (0.75 * length, [(0, other, n, 0.0, 0.25 * length)], f"The rod is {pulls}"),
        (1.25 * length, [(0, other, back, 0.0, 0.25 * length)], f"The rod is {pushes}"),
        (1023.0 * tiny, [(0, other, n, 0.0, tiny)], f"The rod is slightly {pulls}"),
        (1025.0 * tiny, [(0, other, back, 0.0, tiny)], f"The rod is slightly {pushes}"),
        (length, [], none),
    ):
        about(cause=cause)
        about.call = f"{told_ends}; r = {name}(a, {'anchor' if anchored else 'b'}, length={rod}); "
        about.call += "r.contacts()"
        link = make(*pair, rod)
        expect_contacts(about.call, link, pair, wanted, [(2, both)], length)
        about.call += f"; r.length = {0.5 * length}; r.contacts()"
        about.cause = "The rod's length has changed since the first call. Read it again on every "
        about.cause += "call."
        link.length = 0.5 * length
        wanted = [(0, other, n, 0.0, 0.5 * length)]
        expect_contacts(about.call, link, pair, wanted)


@pytest.mark.exercise("B7.8", asks="use +Y as the direction to the other end")
def test_a_rod_whose_ends_coincide(rng: Random) -> None:
    about.read = ROD
    p, length = components(rng), positive_number(rng)
    down = (0.0, -1.0, 0.0)
    about.cause = "The ends are at the same position, so normalized() gives no direction. Call "
    about.cause += "direction_of, which returns +Y here, and push a down."
    about.call = f"particles a and b, both at {p}; Rod(a, b, length={length}).contacts()"
    pair = [Particle(Vector3(*p)), Particle(Vector3(*p))]
    expect_contacts(about.call, Rod(*pair, length), pair, [(0, 1, down, 0.0, length)])
    about.call = f"particle a at {p}; r = AnchoredRod(a, Vector3{p}, length={length}); r.contacts()"
    rod = AnchoredRod(pair[0], Vector3(*p), length)
    expect_contacts(about.call, rod, pair, [(0, -1, down, 0.0, length)])
    about.call += f"; r.anchor.y += {2.0 * length:g}; r.contacts()"
    about.cause = "The anchor has moved since the first call. Read it again on every call."
    rod.anchor = Vector3(p[0], p[1] + 2.0 * length, p[2])
    expect_contacts(about.call, rod, pair, [(0, -1, UP, 0.0, length)])


@pytest.mark.exercise("B7.8", asks="You can hang a pendulum from it")
def test_a_pendulum_swings_in_its_period() -> None:
    about.read = "book 7.4.2; the period is 4 sqrt(L / g) K(sin^2(angle / 2))"
    for degrees, period in ((10.0, 1.99070708), (90.0, 2.34523957)):
        angle = math.radians(degrees)
        about.call = "rod = AnchoredRod(bob, Vector3(0, 0, 0), length=1.0); the bob of 1 kg is "
        about.call += f"released at {degrees:g} degrees from the vertical, with gravity of 10 "
        about.call += "m/s^2; semi-implicit steps of 1/1000 s, each followed by contact.resolve "
        about.call += "for rod.contacts()"
        about.cause = "The pendulum swings with the wrong period. The rod's contact should remove "
        about.cause += "only the velocity along the rod, with a restitution of 0."
        bob = Particle(
            Vector3(math.sin(angle), -math.cos(angle), 0.0), acceleration=Vector3(0.0, -10.0, 0.0)
        )
        seen = swung(AnchoredRod(bob, Vector3(), 1.0), bob, 0.001, 1300)
        sides = [place[0] for place, _, _ in seen]
        turn = next((i for i in range(1, 1300) if sides[i - 1] > 0.0 >= sides[i]), 0)
        # A quarter of the period. The error is of order h: 0.001 s of 0.5 s, with a margin of 5.
        got = 4.0 * turn * 0.001
        expect_close(got, period, tolerance=0.01 * period, then="; the period", unit="s")
        name = "; the final distance from the anchor"
        about.cause = "The rod has changed its length. Return a contact whose penetration is the "
        about.cause += "difference from the rod's length, so that each step restores the length."
        got = math.hypot(*seen[-1][0])
        expect_close(got, 1.0, then=name, tolerance=1e-12, unit="m")


@pytest.mark.exercise("B7.8", asks="You can hang a pendulum from it")
def test_a_string_bears_three_times_the_weight() -> None:
    about.read = "book 7.4.2; at the bottom the pull is m g + m v^2 / L, and v^2 = 2 g L"
    mass = 2.0
    about.call = "rod = AnchoredRod(bob, Vector3(0, 0, 0), length=1.0); the bob of 2 kg is "
    about.call += "released at 90 degrees from the vertical, with gravity of 10 m/s^2; "
    about.call += "semi-implicit steps of 1/2000 s, each followed by contact.resolve for "
    about.call += "rod.contacts()"
    about.cause = "The rod pulls with the wrong force. At the bottom it carries the weight m g "
    about.cause += "and bends the path of the bob, which takes another 2 m g."
    bob = Particle(Vector3(1.0, 0.0, 0.0), None, Vector3(0.0, -10.0, 0.0), mass=mass)
    seen = swung(AnchoredRod(bob, Vector3(), 1.0), bob, 0.0005, 1173)  # a quarter of its period
    got = max(pull for _, _, pull in seen[100:])
    # Of order h: measured 59.9 N.
    name = "; the largest pull of the rod on the way down"
    expect_close(got, 3.0 * mass * 10.0, tolerance=0.6, then=name, unit="N")


@pytest.mark.exercise("7.6", asks="return a contact for each limit that is reached")
def test_limits_act_at_their_ends(rng: Random) -> None:
    about.read = LIMITS
    pair, n, length, told_ends = ends(rng, anchored=False)
    back = (-n[0], -n[1], -n[2])
    c = round(rng.uniform(0.1, 0.9), 3)
    between = "The distance is between the two limits, so the link neither pulls nor pushes. "
    between += "Return an empty list."
    for low, high, wanted, cause in (
        (0.5, 1.5, [], between),
        (1023.0 / 1024.0, 1025.0 / 1024.0, [], between),
        (0.25, 0.5, [(0, 1, n, c, 0.5 * length)],
         "The distance exceeds max_length, so the link pulls like a cable. Return a contact "
         "whose normal points from a to b."),
        (0.5, 1.0, [(0, 1, n, c, 0.0)], "The distance is exactly max_length, so the link is taut. "
                                        "Return a contact with a penetration of 0."),
        (1.5, 2.0, [(0, 1, back, c, 0.5 * length)],
         "The distance is below min_length, so the link pushes. Return a contact whose normal "
         "points from b to a."),
        (1.0, 2.0, [(0, 1, back, c, 0.0)],
         "The distance is exactly min_length, so the link has reached its lower limit. Return a "
         "contact with a penetration of 0."),
        (0.0, 2.0, [],
         "A min_length of 0 means that there is no lower limit. Return an empty list."),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"{told_ends}; l = Limits(a, b, min_length={low * length}, "
        about.call += f"max_length={high * length}, restitution={c}); l.contacts()"
        link = Limits(*pair, low * length, high * length, c)
        expect_contacts(about.call, link, pair, wanted, far=length)
    about.call += "; l.min_length = 1; l.max_length = 2; l.restitution = 0.5; l.contacts()"
    about.cause = "The limits and the restitution have changed since the first call. Read these "
    about.cause += "attributes again on every call."
    link.min_length, link.max_length, link.restitution = 1.0, 2.0, 0.5
    wanted = [(0, 1, n, 0.5, length - 2.0)]
    expect_contacts(about.call, link, pair, wanted)


@pytest.mark.exercise("7.6", asks="If both limits are reached, return both")
def test_two_equal_limits_give_two_contacts(rng: Random) -> None:
    about.read = LIMITS
    pair, n, length, told_ends = ends(rng, anchored=False)
    about.call = f"{told_ends}; l = Limits(a, b, min_length={length}, max_length={length}, "
    about.call += "restitution=0.5); l.contacts()"
    about.cause = "The link has reached both limits, which are equal. Return two contacts with "
    about.cause += "opposite normals and a penetration of 0."
    link = Limits(*pair, length, length, 0.5)
    got = told(link.contacts(), pair)
    expect_exactly(len(got), 2, unit="contacts")
    normals = sorted(contact[2] for contact in got)
    wanted = sorted([n, (-n[0], -n[1], -n[2])])
    for seen, right in zip(normals, wanted, strict=True):
        expect_close(seen, right, then="; one of the normals", tolerance=1e-15)
    got = [number for contact in got for number in (contact[0], contact[1], contact[4])]
    name = "; particle, other and penetration of both contacts, in one tuple"
    expect_close(got, (0, 1, 0.0) * 2, then=name)
    same = [Particle(), Particle()]
    for low in (2.0, 0.5, 1e-3):
        about.call = f"particles a and b at the same position; l = Limits(a, b, min_length={low}, "
        about.call += "max_length=3); l.contacts()"
        about.cause = "The distance between the ends is 0, which is below min_length. Return a "
        about.cause += "contact that pushes, with +Y as the direction from a to b."
        link = Limits(*same, low, 3.0)
        wanted = [(0, 1, (0.0, -1.0, 0.0), 0.0, low)]
        expect_contacts(about.call, link, same, wanted)
    about.call += "; then l.min_length = 0; l.contacts()"
    about.cause = "Now min_length is 0, which means that there is no lower limit. Return an empty "
    about.cause += "list, even if the distance is 0."
    link.min_length = 0.0
    expect_contacts(about.call, link, same, [])


@pytest.mark.exercise("G7.1", asks="always return two contacts")
def test_a_two_sided_rod_always_has_both_contacts(rng: Random) -> None:
    about.read = TWO_SIDED
    pair, n, length, told_ends = ends(rng, anchored=False)
    back = (-n[0], -n[1], -n[2])
    for share in (0.75, 1023.0 / 1024.0, 1.0, 1.25):
        depth = (1.0 - share) * length
        about.call = f"{told_ends}; r = TwoSidedRod(a, b, length={share * length}); r.contacts()"
        about.cause = "The first contact pulls and the second one pushes. Their normals point in "
        about.cause += "opposite directions, and their penetrations have opposite signs."
        wanted = [(0, 1, n, 0.0, depth), (0, 1, back, 0.0, -depth)]
        rod = TwoSidedRod(*pair, share * length)
        one = [(1, "You returned only one contact. Return two contacts in every case: one that "
                   "pulls and one that pushes.")]  # fmt: skip
        one += [(0, "You returned no contact. Return both, even if the rod's length is right.")]
        expect_contacts(about.call, rod, pair, wanted, one)
        about.call += f"; r.length = {0.5 * length}; r.contacts()"
        about.cause = "The rod's length has changed since the first call. Read it again on every "
        about.cause += "call."
        rod.length = 0.5 * length
        wanted = [(0, 1, n, 0.0, 0.5 * length), (0, 1, back, 0.0, -0.5 * length)]
        expect_contacts(about.call, rod, pair, wanted)
    about.call = "particles a and b at the same position; TwoSidedRod(a, b, length=2).contacts()"
    about.cause = "The ends are at the same position, so there is no direction between them. Take "
    about.cause += "+Y as the direction from a to b."
    same = [Particle(), Particle()]
    wanted = [(0, 1, UP, 0.0, -2.0), (0, 1, (0.0, -1.0, 0.0), 0.0, 2.0)]
    expect_contacts(about.call, TwoSidedRod(*same, 2.0), same, wanted)
