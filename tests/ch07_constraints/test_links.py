"""Links: cables, rods, limits and two-sided rods, B7.7, B7.8, 7.6 and G7.1."""

from __future__ import annotations

import math
from collections.abc import Mapping
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, AnchoredRod, Cable, Limits, Rod, TwoSidedRod
from ch07_constraints.probes import kind_of, swung, told
from draw import Triple, positive_number, vector
from expect import expect_close, expect_exactly, expect_unchanged, named, xyz
from impacts import expect_list, expect_particles

UP = Triple((0.0, 1.0, 0.0))
CABLE = "book 7.4.1, and the docstring of Cable.contacts"
ROD = "book 7.4.2, E-9, and the docstring of Rod.contacts"
PERIOD = "book 7.4.2; the period is 4 sqrt(L / g) K(sin^2(angle / 2))"
PULL = "book 7.4.2; at the bottom the pull is m g + m v^2 / L, and v^2 = 2 g L"
LIMITS = "exercise 7.6, and the docstring of Limits.contacts"
TWO_SIDED = "the docstring of TwoSidedRod.contacts"
BOTH = pytest.mark.parametrize("anchored", [False, True], ids=["between two", "anchored"])
AGAIN = "The attributes have changed since the first call. Read all of them again on every call."
# The length of (2, 3, 6) and (6, 2, 3), and of both times a power of 2, has no rounding error.
WAYS = ((2.0, 3.0, 6.0), (-6.0, 2.0, 3.0), (3.0, -6.0, -2.0))


def ends(rng: Random, kind: str, anchored: bool = False) -> Any:
    """Return the particles, the second end, its direction and distance, and the begin of a call.

    The second end is a particle, or a vector as an anchor. Positions are whole numbers, so the
    distance of about 7 m is exact.
    """
    way, size = Triple(rng.choice(WAYS)), rng.choice((0.5, 1.0, 2.0))
    p = Triple(float(rng.randint(-9, 9)) for _ in range(3))
    q, length = p + way * size, 7.0 * size
    a = Particle(Vector3(*p), Vector3(1.0, 2.0, 3.0), mass=2.0)
    text = f"particle a at {p}; {'anchor = Vector3' if anchored else 'particle b at '}{q}, "
    text += f"{length:g} m from a; link = "
    if anchored:
        return [a], Vector3(*q), way / 7.0, length, f"{text}Anchored{kind}(a, anchor, "
    b = Particle(Vector3(*q), Vector3(3.0, 2.0, 1.0), mass=3.0)
    return [a, b], b, way / 7.0, length, f"{text}{kind}(a, b, "


def expect_contacts(
    cause: str,
    call: str,
    link: Any,
    particles: list[Any],
    *wanted: tuple[Triple, float, float],
    counts: Mapping[str, float] | None = None,
    far: float = math.nan,
) -> None:
    """Expect these normals, restitutions and penetrations of contacts between both ends.

    ``counts`` has the likely mistake for a wrong number of contacts, ``far`` is the distance of
    the ends.
    """
    anchored = len(particles) == 1
    end = link.anchor if anchored else particles[1].position
    before = xyz(particles[0].position), xyz(particles[0].velocity), xyz(end)
    with calls(cause, call):
        found = link.contacts()
    why = "contacts() has changed a position or a velocity. Subtract with - instead of -=."
    expect_unchanged("a.position", particles[0].position, before[0], cause=why)
    expect_unchanged("a.velocity", particles[0].velocity, before[1], cause=why)
    end = link.anchor if anchored else particles[1].position
    expect_unchanged("anchor" if anchored else "b.position", end, before[2], cause=why)
    expect_list(kind_of(found))
    got = told(found, particles)
    why = named(len(got), cause if got else f"You returned no contact. {cause}", counts or {})
    expect_exactly(len(got), len(wanted), cause=why, unit="contacts")
    for i, (seen, (n, c, deep)) in enumerate(zip(got, wanted, strict=True)):
        which = f"the {('first', 'second')[i]} contact" if len(wanted) > 1 else "the contact"
        a, b, normal, restitution, depth = seen
        why = f"The particles are wrong. Pass a as particle and {'None' if anchored else 'b'} as "
        expect_particles((a, b), (0, -1 if anchored else 1), cause=f"{why}other.")
        slips = {"Your normal points the wrong way.": -n}
        if depth == -deep != 0.0 and len(wanted) == 1:
            why = "You gave the contact a negative penetration. Reverse its normal instead, and "
            slips = {f"{why}keep the penetration positive. {cause}": -n}
        expect_close(normal, n, slips, then=f"; the normal of {which}", tolerance=1e-15)
        why = "You passed the penetration as the restitution. The order of the arguments is "
        why += "Contact(particle, other, normal, restitution, penetration)."
        if restitution != deep:
            why = f"Pass {'self.restitution' if c else 0} to Contact as the restitution."
        expect_close(restitution, c, then=f"; the restitution of {which}", cause=why)
        sign = "It must be positive, so that the resolver corrects the distance between the ends."
        if len(wanted) > 1:
            sign = "Use distance - length for the first contact, and the opposite for the second."
        why = "Use the difference between the distance of the ends and the allowed length."
        slips = {
            f"Your penetration has the wrong sign. {sign}": -deep or math.nan,
            "You used the whole distance between the ends as the penetration.": far,
        }
        # Lengths of up to 20 m, rounded a few times.
        name, why = f"; the penetration of {which}", cause if math.isnan(far) else why
        expect_close(depth, deep, slips, then=name, cause=why, tolerance=1e-14, unit="m")


@pytest.mark.exercise("B7.7", asks="one contact if the cable is taut", read=CABLE)
@BOTH
def test_a_taut_cable_pulls(rng: Random, anchored: bool) -> None:
    particles, end, n, length, text = ends(rng, "Cable", anchored)
    c, name = round(rng.uniform(0.1, 0.9), 3), "the anchor" if anchored else "b"
    if not anchored:
        particles[0].mass = math.inf
        text = text.replace("a at", "a (immovable) at")
    none = "The cable is longer than max_length. Return no contact only if it is shorter."
    taut = f"The cable is taut. The normal is the unit vector from a to {name}."
    for high, counts, cause in (
        (1023.0 / 1024.0 * length, {none: 0}, taut),
        (0.75 * length, {none: 0}, taut),
        (length, {}, "A cable at its maximum length is taut. Return a contact with penetration 0."),
    ):
        call = f"{text}max_length={high}, restitution={c}); link.contacts()"
        cable = (AnchoredCable if anchored else Cable)(particles[0], end, high, c)
        wanted = (n, c, length - high)
        expect_contacts(cause, call, cable, particles, wanted, counts=counts, far=length)


@pytest.mark.exercise("B7.7", asks="A slack cable has no contact", read=CABLE)
@BOTH
def test_a_slack_cable_does_nothing(rng: Random, anchored: bool) -> None:
    particles, end, n, length, text = ends(rng, "Cable", anchored)
    for high in (1025.0 / 1024.0 * length, 1.25 * length):
        cause = "The cable is slack: its ends are nearer than max_length. Return an empty list."
        call = f"{text}max_length={high}); link.contacts()"
        cable = (AnchoredCable if anchored else Cable)(particles[0], end, high)
        expect_contacts(cause, call, cable, particles)
    call += "; link.max_length /= 4; link.restitution = 0.5; link.contacts()"
    cable.max_length, cable.restitution = 0.3125 * length, 0.5
    expect_contacts(AGAIN, call, cable, particles, (n, 0.5, 0.6875 * length))
    call += f"; {'anchor' if anchored else 'b'} moved to the opposite side of a; link.contacts()"
    there = Vector3(*(Triple(xyz(particles[0].position)) - n * length))
    if anchored:
        cable.anchor = there
    else:
        end.position = there
    expect_contacts(AGAIN, call, cable, particles, (-n, 0.5, 0.6875 * length))


@pytest.mark.exercise("B7.8", asks="if the rod is too short or too long", read=ROD)
@BOTH
def test_a_rod_pulls_and_pushes(rng: Random, anchored: bool) -> None:
    particles, end, n, length, text = ends(rng, "Rod", anchored)
    name = "the anchor" if anchored else "b"
    both = "You returned two contacts, as the book's text asks (E-9). This Rod follows the book's "
    both += "listing, so return only the contact that pulls or pushes. TwoSidedRod has two."
    none = "The rod has exactly the right length and needs no contact. Return an empty list."
    pulls = f"stretched and pulls a toward {name}. The normal points from a to {name}."
    pushes = f"compressed and pushes a away from {name}. The normal points from {name} to a."
    for share, normal, cause in (
        (0.75, n, f"The rod is {pulls}"),
        (1.25, -n, f"The rod is {pushes}"),
        (1023.0 / 1024.0, n, f"The rod is slightly {pulls}"),
        (1025.0 / 1024.0, -n, f"The rod is slightly {pushes}"),
        (1.0, n, none),
    ):
        call = f"{text}length={share * length}); link.contacts()"
        rod = (AnchoredRod if anchored else Rod)(particles[0], end, share * length)
        wanted = [(normal, 0.0, abs(1.0 - share) * length)] if share != 1.0 else []
        expect_contacts(cause, call, rod, particles, *wanted, counts={both: 2}, far=length)
        call += f"; link.length = {0.5 * length}; link.contacts()"
        rod.length = 0.5 * length
        expect_contacts(AGAIN, call, rod, particles, (n, 0.0, 0.5 * length))


@pytest.mark.exercise("B7.8", asks="use +Y as the direction to the other end", read=ROD)
def test_a_rod_whose_ends_coincide(rng: Random) -> None:
    p, length = vector(rng), positive_number(rng)
    why = "The ends are at the same position. Push a down, as direction_of returns +Y here."
    call = f"particles a and b, both at {p}; Rod(a, b, length={length}).contacts()"
    pair = [Particle(Vector3(*p)), Particle(Vector3(*p))]
    expect_contacts(why, call, Rod(*pair, length), pair, (-UP, 0.0, length))
    call = f"particle a at {p}; rod = AnchoredRod(a, Vector3{p}, length={length}); rod.contacts()"
    rod = AnchoredRod(pair[0], Vector3(*p), length)
    expect_contacts(why, call, rod, pair[:1], (-UP, 0.0, length))
    call += f"; rod.anchor.y += {2.0 * length:g}; rod.contacts()"
    rod.anchor = Vector3(*(p + UP * (2.0 * length)))
    expect_contacts(AGAIN, call, rod, pair[:1], (UP, 0.0, length))


def pendulum(cause: str, degrees: float, h: float, steps: int) -> Any:
    """Let a pendulum swing: return the results of swung."""
    text = "rod = AnchoredRod(bob, Vector3(0, 0, 0), length=1.0); the bob of 2 kg is released at "
    text += f"{degrees:g} degrees from the vertical, with gravity of 10 m/s^2; semi-implicit steps "
    with calls(cause, f"{text}of {h} s, each followed by contact.resolve for rod.contacts()"):
        place = Vector3(math.sin(math.radians(degrees)), -math.cos(math.radians(degrees)))
        bob = Particle(place, acceleration=Vector3(0.0, -10.0, 0.0), mass=2.0)
        return swung(AnchoredRod(bob, Vector3(), 1.0), bob, h, steps)


@pytest.mark.exercise("B7.8", asks="You can hang a pendulum from it", read=PERIOD)
def test_a_pendulum_swings_in_its_period() -> None:
    for degrees, period in ((10.0, 1.99070708), (90.0, 2.34523957)):
        why = "The rod's contact should only remove the velocity along the rod, without a bounce."
        seen = pendulum(why, degrees, 0.001, 1300)
        sides = [place[0] for place, _, _ in seen]
        turn = next((i for i in range(1, 1300) if sides[i - 1] > 0.0 >= sides[i]), 0)
        # A quarter of the period. The error is of order h: 0.001 s of 0.5 s, with a margin of 5.
        got, limit = 4.0 * turn * 0.001, 0.01 * period
        expect_close(got, period, tolerance=limit, then="; the period", unit="s")
        why = "Return a contact that has the difference from the rod's length as penetration."
        got, name = math.hypot(*seen[-1][0]), "; the final distance from the anchor"
        expect_close(got, 1.0, then=name, cause=why, tolerance=1e-12, unit="m")


@pytest.mark.exercise("B7.8", asks="You can hang a pendulum from it", read=PULL)
def test_a_string_bears_three_times_the_weight() -> None:
    """Only here the force of the rod is measured, which the period does not show."""
    why = "At the bottom the rod carries the weight m g and bends the path, which takes 2 m g."
    seen = pendulum(why, 90.0, 0.0005, 1173)  # a quarter of its period
    # Of order h: measured 59.9 N.
    got, name = max(pull for _, _, pull in seen[100:]), "; the largest pull of the rod on the way "
    expect_close(got, 60.0, tolerance=0.6, then=f"{name}down", unit="N")


@pytest.mark.exercise("7.6", asks="return a contact for each limit that is reached", read=LIMITS)
def test_limits_act_at_their_ends(rng: Random) -> None:
    particles, b, n, length, text = ends(rng, "Limits")
    c = round(rng.uniform(0.1, 0.9), 3)
    between = "The distance is between the two limits. Return an empty list."
    for low, high, wanted, cause in (
        (0.5, 1.5, [], between),
        (1023.0 / 1024.0, 1025.0 / 1024.0, [], between),
        (0.25, 0.5, [(n, c, 0.5 * length)],
         "The distance exceeds max_length, so pull: the normal points from a to b."),
        (0.5, 1.0, [(n, c, 0.0)],
         "The distance is exactly max_length. Return a contact with a penetration of 0."),
        (1.5, 2.0, [(-n, c, 0.5 * length)],
         "The distance is below min_length, so push: the normal points from b to a."),
        (1.0, 2.0, [(-n, c, 0.0)],
         "The distance is exactly min_length. Return a contact with a penetration of 0."),
        (0.0, 2.0, [],
         "A min_length of 0 means that there is no lower limit. Return an empty list."),
    ):  # fmt: skip
        call = f"{text}min_length={low * length}, max_length={high * length}, restitution={c}); "
        call += "link.contacts()"
        link = Limits(particles[0], b, low * length, high * length, c)
        expect_contacts(cause, call, link, particles, *wanted, far=length)
    call += "; link.min_length = 1; link.max_length = 2; link.restitution = 0.5; link.contacts()"
    link.min_length, link.max_length, link.restitution = 1.0, 2.0, 0.5
    expect_contacts(AGAIN, call, link, particles, (n, 0.5, length - 2.0))


@pytest.mark.exercise("7.6", asks="If both limits are reached, return both", read=LIMITS)
def test_two_equal_limits_give_two_contacts(rng: Random) -> None:
    pair, _, n, length, text = ends(rng, "Limits")
    with calls(
        "The link has reached both limits, which are equal. Return two contacts with opposite "
        "normals and a penetration of 0.",
        f"{text}min_length={length}, max_length={length}, restitution=0.5); link.contacts()",
    ):
        got = told(Limits(*pair, length, length, 0.5).contacts(), pair)
    expect_exactly(len(got), 2, unit="contacts")
    normals = sorted(contact[2] for contact in got)
    for seen, right in zip(normals, sorted([n, -n]), strict=True):
        expect_close(seen, right, then="; one of the normals", tolerance=1e-15)
    numbers = [number for contact in got for number in (contact[0], contact[1], contact[4])]
    name = "; particle, other and penetration of both contacts, in one tuple"
    expect_close(numbers, (0, 1, 0.0) * 2, then=name)
    same = [Particle(), Particle()]
    why = "The distance of 0 is below min_length. Push, with +Y as the direction from a to b."
    for low in (2.0, 0.5, 1e-3):
        call = f"particles a and b at the same position; link = Limits(a, b, min_length={low}, "
        call += "max_length=3); link.contacts()"
        link = Limits(*same, low, 3.0)
        expect_contacts(why, call, link, same, (-UP, 0.0, low))
    why = "A min_length of 0 means no lower limit, even if the distance is 0. Return []."
    link.min_length = 0.0
    expect_contacts(why, f"{call}; link.min_length = 0; link.contacts()", link, same)


@pytest.mark.exercise("G7.1", asks="always return two contacts", read=TWO_SIDED)
def test_a_two_sided_rod_always_has_both_contacts(rng: Random) -> None:
    pair, _, n, length, text = ends(rng, "TwoSidedRod")
    counts = {
        "You returned only one contact. Return two contacts in every case.": 1,
        "You returned no contact. Return both, even if the rod's length is right.": 0,
    }
    why = "The first contact pulls and the second one pushes, with opposite penetrations."
    for share in (0.75, 1023.0 / 1024.0, 1.0, 1.25):
        call = f"{text}length={share * length}); link.contacts()"
        rod, depth = TwoSidedRod(*pair, share * length), (1.0 - share) * length
        expect_contacts(why, call, rod, pair, (n, 0.0, depth), (-n, 0.0, -depth), counts=counts)
        call += f"; link.length = {0.5 * length}; link.contacts()"
        depth = rod.length = 0.5 * length
        expect_contacts(AGAIN, call, rod, pair, (n, 0.0, depth), (-n, 0.0, -depth))
    call = "particles a and b at the same position; TwoSidedRod(a, b, length=2).contacts()"
    why = "The ends are at the same position. Take +Y as the direction from a to b."
    same = [Particle(), Particle()]
    expect_contacts(why, call, TwoSidedRod(*same, 2.0), same, (UP, 0.0, -2.0), (-UP, 0.0, 2.0))
