"""The blob: its bonds and its spread, B8.8 and B8.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.scene_probes import bonded, places_after, settled_blob, spread_of
from draw import Components, components, direction, positive_number
from expect import (
    about,
    blame,
    expect_close,
    expect_that,
    scoped,
)
from unmoved import expect_all_kept, expect_kept

BOND = "the docstring of Bond, and of Bond.update_force"
SPREAD = "the docstring of spread"
ZERO = (0.0, 0.0, 0.0)
CALLS = (
    "the distance between a and b is set to {} m; at each distance, bond.update_force({}, 0.1) and "
    "then bond.update_force({}, 0.1) are called"
)


def draw_bond(rng: Random) -> tuple[float, float, float, float, float]:
    """Draw stiffness, rest length, limit, share and break length."""
    rest = positive_number(rng, 0.5, 2.0)
    limit = rest + positive_number(rng, 0.2, 1.0)
    return positive_number(rng), rest, limit, positive_number(rng, 0.1, 0.9), limit + 1.0


def in_words(lengths: list[float]) -> str:
    """Return these lengths in order, such as "2.5 and then 1.25"."""
    *rest, last = (f"{length:.9g}" for length in lengths)
    return f"{', '.join(rest)} and then {last}"


def pull(length: float, k: float, rest: float, limit: float, share: float) -> float:
    """Return the force that pulls the ends together. It is negative if it pushes."""
    return k * (min(length, limit) - rest) + share * k * max(0.0, length - limit)


@scoped
def expect_forces(
    call: str, seen: tuple, force: float, way: Components, when: str = "", *, swapped: bool = True
) -> None:
    about.call = call
    on_a = tuple(force * w + 0.0 for w in way)  # which is 0.0 instead of -0.0
    on_b = tuple(-force * w + 0.0 for w in way)
    if force:
        both = "Your update_force pulls both ends in each call. It is called once for each end, so "
        both += "pull only the particle that is passed."
        mistakes = [
            ((*(2.0 * part for part in on_a), *on_b), both),
            ((*on_a, *(2.0 * part for part in on_b)), both),
            (
                (*ZERO, *ZERO),
                "Neither end gets a force, probably because you swapped the two springs. "
                "self._to_b acts on a, and self._to_a acts on b."
                if swapped
                else about.cause,
            ),
            (
                (*on_a, *ZERO),
                "Only a gets a force, probably because you use self._to_b for both ends. Use "
                "self._to_a for b.",
            ),
            (
                (*on_a, *on_a),
                "Both ends get the same force, but the two forces should be opposite. Let "
                "self._to_a act on b.",
            ),
        ]
        blame((*seen[0], *seen[1]), mistakes)
    # Rounding of forces of some tens of N.
    expect_close(seen[0], on_a, then=f"; the force on a{when}", unit="N", tolerance=1e-11)
    expect_close(seen[1], on_b, then=f"; the force on b{when}", unit="N", tolerance=1e-11)


@pytest.mark.exercise("B8.8", asks="the bond is an ordinary spring")
def test_a_bond_is_a_spring_with_a_limit(rng: Random) -> None:
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    lengths = [0.5 * rest, rest, 0.5 * (rest + limit), limit, 0.5 * (limit + most)]
    about(
        f"bond = Bond(a, b, stiffness={k}, rest_length={rest}, limit={limit}, share={share}, "
        f"break_length={most}); ",
        read=BOND,
    )
    ends = [components(rng), components(rng)]
    after, call = places_after("bond", ends), about.call
    about.call += "bond.update_force(a, 0.1)"
    expect_kept("a.position", after[0], ends[0])
    expect_kept("b.position", after[1], ends[1])
    about.call = call
    about.cause = "If the bond holds, let the spring self._to_b act on a, and the spring "
    about.cause += "self._to_a act on b."
    for length, seen in zip(
        lengths, bonded(lengths, k, rest, limit, share, most, way), strict=True
    ):
        force = pull(length, k, rest, limit, share)
        name = f"{about.call}ends a and b are {length:.6g} m apart; bond.update_force(a, 0.1); "
        name += "bond.update_force(b, 0.1)"
        expect_forces(name, seen, force, way)
        why = "This bond is not too long, so it must not break. Change holds only if the bond "
        why += "breaks or heals."
        broken, holds = "the bond is broken", "the bond still holds"
        expect_that(seen[2] is True, broken, holds, call=name, cause=why)


@pytest.mark.exercise("B8.8", asks="it breaks and exerts no force until it heals")
@pytest.mark.parametrize("swap", [False, True], ids=["a first", "b first"])
def test_a_bond_breaks_and_heals(rng: Random, swap: bool) -> None:
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    about(
        f"bond = Bond(a, b, stiffness={k}, rest_length={rest}, limit={limit}, share={share}, "
        f"break_length={most})",
        read=BOND,
    )
    causes = {
        "breaks": "Your bond doesn't break although it is longer than break_length. Set self.holds "
        "to False in this case. Without self, holds is only a local variable.",
        "broken": "Your bond heals too early, while it is still longer than rest_length. Keep it "
        "broken until its length is rest_length or less.",
        "heals": "Your broken bond doesn't heal although it is shorter than rest_length. Set holds "
        "to True in this case.",
        "holds": "Your bond breaks again too early. Let it hold until it is longer than "
        "break_length.",
    }
    late = {
        "breaks": "Your bond still pulls in the call in which it breaks. In every call to "
        "update_force, for a and for b, update holds before you add a force.",
        "broken": "Your broken bond still pulls. Add a force only if the bond holds.",
        "heals": "Your bond heals, but it adds no force in the same call. Update holds before you "
        "add the force.",
        "holds": "The force of your bond is wrong after it has healed.",
    }
    story = [
        (most, True, "holds"),
        (1.001 * most, False, "breaks"),
        (0.5 * (limit + most), False, "broken"),
        (1.001 * rest, False, "broken"),
        (0.999 * rest, True, "heals"),
        (0.5 * (limit + most), True, "holds"),
        (2.0 * most, False, "breaks"),
        (0.5 * rest, True, "heals"),
    ]
    lengths = [length for length, _, _ in story]
    about.cause = causes["holds"]
    seen = bonded(lengths, k, rest, limit, share, most, way, swap)
    pulls = [any(one[0]) or any(one[1]) for one in seen]
    if pulls[2]:  # it does so in a later call too
        late["breaks"] = late["broken"]
    for i, (length, holds, what) in enumerate(story):
        if what == "holds" and i == 0:
            continue  # rounding may have made it slightly longer
        name = f"{about.call}; {CALLS.format(in_words(lengths[: i + 1]), *'ba' if swap else 'ab')}"
        about.cause = causes[what]
        words = {True: "the bond holds", False: "the bond is broken"}
        then = "; whether the bond holds at the last distance"
        expect_that(seen[i][2] is holds, words[not holds], words[holds], call=name, then=then)
        about.cause = late[what]
        force = pull(length, k, rest, limit, share) if holds else 0.0
        expect_forces(name, seen[i], force, way, " at the last distance", swapped=not any(pulls))


@pytest.mark.exercise("B8.8", asks="It heals when the distance between its ends")
def test_a_bond_exactly_at_its_limits(rng: Random) -> None:
    about.read = BOND
    rest = 0.25 * rng.randint(3, 6)
    most = rest + 0.25 * rng.randint(2, 5)
    lengths = [most, most + 1e-6, rest + 1e-6, rest]
    about.call = (
        f"bond = Bond(a, b, stiffness=30, rest_length={rest}, limit={rest}, share=0.5, "
        f"break_length={most}); {CALLS.format(in_words(lengths), *'ab')}; whether the bond holds "
        "at each distance"
    )
    about.cause = "Your bond breaks at exactly break_length. It should break only if it is longer "
    about.cause += "than that."
    # Quarters of a meter from the origin are not rounded.
    seen = bonded(lengths, 30.0, rest, rest, 0.5, most, (1.0, 0.0, 0.0), origin=ZERO)
    got = [holds for _, _, holds in seen]
    if got == [True] * 4:
        about.cause = "Your bond doesn't break if it is slightly longer than break_length. Let it "
        about.cause += "break at any greater length."
    elif got == [True, False, False, False]:
        about.cause = "Your broken bond doesn't heal at exactly rest_length. It should heal if its "
        about.cause += "length is rest_length or less."
    elif got == [True, False, True, True]:
        about.cause = "Your bond heals too early, while it is still longer than rest_length. Keep "
        about.cause += "it broken until its length is rest_length or less."
    got, wanted = (
        ", ".join("holds" if one else "broken" for one in some)
        for some in (got, (True, False, False, True))
    )
    expect_that(got == wanted, got, wanted)


@pytest.mark.exercise("B8.8", asks="if the bond is intact")
def test_bonds_keep_a_blob_together() -> None:
    about(
        "a blob of seven particles with bonds between all of them, 3 s after it was dropped",
        read=BOND,
    )
    about.cause = "Your blob collapses or flies apart. Check the direction of the forces: a bond "
    about.cause += "pushes its ends apart when it is too short, and pulls them together when it is "
    about.cause += "too long."
    before, after = settled_blob(180, 1.0 / 60.0)
    # Under its own weight, such a blob spreads by 1 to 2 %.
    share = _spread(after) / _spread(before)
    seen = f"its spread changes by {share - 1.0:+.0%}"
    expect_that(0.9 < share < 1.1, seen, "its spread changes by less than 10%")


def _spread(places: list[Components]) -> float:
    middle = [math.fsum(place[k] for place in places) / len(places) for k in range(3)]
    return math.sqrt(math.fsum(math.dist(place, middle) ** 2 for place in places) / len(places))


@pytest.mark.exercise("B8.9", asks="the root mean square distance of the particles")
def test_the_spread_is_the_root_of_the_mean_square(rng: Random) -> None:
    about(
        "four particles of equal mass at the corners of a square with sides of 2 m; "
        "spread(particles)",
        read=SPREAD,
    )
    about.cause = "The center of mass is the middle of the square, and every corner is sqrt(2) m "
    about.cause += "away from it. So each squared distance is 2 m^2, and the root of their mean is "
    about.cause += "sqrt(2) m."
    x, y, z = components(rng)
    square = [(x + i, y + j, z) for i in (0.0, 2.0) for j in (0.0, 2.0)]
    got, after = spread_of(square, [3.0] * 4)
    mistakes = [
        (2.0**0.25, "You didn't square the distances. Square each of them before you take their "
                    "mean."),
        (math.sqrt(8.0 / 12.0), "You divide by the total mass, but you don't multiply the squared "
                                "distances by the masses."),
        (2.0, "You return the mean of the squared distances, in m^2. Take its square root to get a "
              "length."),
        (math.sqrt(8.0),
         "You take the square root of a sum, not of a mean. Divide the sum by the total mass "
         "before you take the root."),
        (math.sqrt(24.0),
         "You take the square root of a sum, not of a mean. Divide the sum by the total mass "
         "before you take the root."),
        (math.sqrt(2.0 + math.hypot(x + 1.0, y + 1.0, z) ** 2),
         "You measure the distances from the origin, so the result changes if all particles move "
         "together. Measure the distances from the center of mass."),
    ]  # fmt: skip
    expect_all_kept("particles[{}].position", after, square)
    blame(got, mistakes)
    expect_close(got, math.sqrt(2.0), unit="m", tolerance=1e-12)
    m, n = positive_number(rng), positive_number(rng)
    p, q = components(rng), components(rng)
    about.call = f"a, a particle of {m} kg at {p} m; b, a particle of {n} kg at {q} m; "
    about.call += "spread([a, b])"
    about.cause = "Weight each squared distance from the center of mass by the particle's mass. "
    about.cause += "For two particles the result is sqrt(m n) / (m + n) times the distance between "
    about.cause += "them."
    wanted = math.sqrt(m * n) / (m + n) * math.dist(p, q)
    got = spread_of([p, q], [m, n])[0]
    apart, total = math.dist(p, q), m + n
    ways = (n / total * apart, m / total * apart)  # of both from their center of mass
    mistakes = [
        ((m * ways[0] + n * ways[1]) / total,
         "You return the mean of the distances. Average their squares instead, weighted by mass, "
         "and then take the square root."),
        (0.5 * apart,
         "You measure the distances from the midpoint of the two particles. Measure them from the "
         "center of mass, which is nearer the heavier one."),
        (math.hypot(*ways) / math.sqrt(2.0), "You average the squared distances without the "
                                             "masses. Multiply each squared distance by its mass, "
                                             "and divide the sum by the total mass."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, wanted, unit="m", tolerance=1e-12)
    about(
        f"a single particle at {p} m; spread([particle])",
        cause="A single particle is its own center of mass, so the spread is 0.",
    )
    expect_close(spread_of([p], [m])[0], 0.0, unit="m", tolerance=1e-12)
