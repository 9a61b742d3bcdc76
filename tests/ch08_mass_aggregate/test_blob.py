"""The blob: its bonds and its spread, B8.8 and B8.9."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.blob import Bond, spread
from ch08_mass_aggregate.scene_probes import settled_blob
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_close, expect_exactly, expect_that, named, xyz
from unmoved import expect_all_kept, expect_kept

BOND = "the docstring of Bond, and of Bond.update_force"
SPREAD = "the docstring of spread"
ZERO = Triple((0.0, 0.0, 0.0))
HOLDS = "; whether the bond holds at the last distance"
EARLY = "Your bond heals too early. Keep it broken until it is not longer than rest_length."
SWAPPED = "Neither end gets a force. Perhaps you swapped the two springs: self._to_b acts on a."


class Sample:
    """The numbers of a bond, and the direction from a to b."""

    def __init__(self, rng: Random) -> None:
        self.rest = positive_number(rng, 0.5, 2.0)
        self.limit = self.rest + positive_number(rng, 0.2, 1.0)
        self.stiffness, self.share = positive_number(rng), positive_number(rng, 0.1, 0.9)
        self.most, self.way = self.limit + 1.0, unit_vector(rng)
        self.origin, self.order = Triple((1.0, 2.0, 3.0)), "ab"

    def pull(self, length: float) -> float:
        """Return the force that pulls the ends together. It is negative if it pushes."""
        spring = min(length, self.limit) - self.rest
        return self.stiffness * (spring + self.share * max(0.0, length - self.limit))

    def at(self, lengths: Sequence[float], cause: str) -> list[Any]:
        """Return the force on a, that on b, and whether the bond holds, at each length in turn."""
        seen, told = [], " and then ".join(f"{length:.9g}" for length in lengths)
        text = f"bond = Bond(a, b, stiffness={self.stiffness}, rest_length={self.rest}, "
        text += f"limit={self.limit}, share={self.share}, break_length={self.most}); the distance "
        text += f"between a and b is set to {told} m, each time followed by "
        text += f"bond.update_force({self.order[0]}, 0.1); bond.update_force({self.order[1]}, 0.1)"
        with calls(cause, text):
            a, b = Particle(Vector3(*self.origin)), Particle()
            bond = Bond(a, b, self.stiffness, self.rest, self.limit, self.share, self.most)
            for length in lengths:
                b.position = Vector3(*(self.origin + length * self.way))
                for end in (a, b) if self.order == "ab" else (b, a):
                    end.clear_forces()
                    bond.update_force(end, 0.1)
                forces = xyz(a.force_accumulator), xyz(b.force_accumulator)
                seen.append((*forces, bool(bond.holds), xyz(a.position), xyz(b.position)))
        return seen

    def expect_forces(self, seen: Any, force: float, cause: str, swapped: str = "") -> None:
        on_a, on_b = force * self.way, -force * self.way
        both = "Your update_force pulls both ends in each call. Pull only the one that is passed."
        slips = {
            both: (*(2.0 * on_a), *on_b) if self.order == "ab" else (*on_a, *(2.0 * on_b)),
            swapped: (*ZERO, *ZERO) if swapped else (math.nan,) * 6,
            "Only a gets a force. Let self._to_a act on b.": (*on_a, *ZERO),
            "Both ends get the same force. Let self._to_a act on b.": (*on_a, *on_a),
        }
        why = named((*seen[0], *seen[1]), cause, slips if force else {})
        # Rounding of forces of some tens of N.
        for name, got, wanted in (("a", seen[0], on_a), ("b", seen[1], on_b)):
            then = f"; the force on {name} at the last distance"
            expect_close(got, wanted, then=then, cause=why, unit="N", tolerance=1e-11)


@pytest.mark.exercise("B8.8", asks="the bond is an ordinary spring", read=BOND)
def test_a_bond_is_a_spring_with_a_limit(rng: Random) -> None:
    bond = Sample(rng)
    rest, limit = bond.rest, bond.limit
    why = "If the bond holds, let self._to_b act on a, and self._to_a on b."
    for length in (0.5 * rest, rest, 0.5 * (rest + limit), limit, 0.5 * (limit + bond.most)):
        (seen,) = bond.at([length], why)
        for name, now, before in (
            ("a", seen[3], bond.origin),
            ("b", seen[4], bond.origin + length * bond.way),
        ):
            expect_kept(f"{name}.position", now, before)
        bond.expect_forces(seen, bond.pull(length), why, SWAPPED)
        why_not = "This bond is not too long. Change holds only if the bond breaks or heals."
        expect_exactly(seen[2], True, then="; bond.holds", cause=why_not)


@pytest.mark.exercise("B8.8", asks="it breaks and exerts no force until it heals", read=BOND)
@pytest.mark.parametrize("order", ["ab", "ba"], ids=["a first", "b first"])
def test_a_bond_breaks_and_heals(rng: Random, order: str) -> None:
    bond = Sample(rng)
    bond.order = order
    broken = "Your broken bond still pulls. Add a force only if the bond holds."
    causes = {
        "breaks": ("Your bond doesn't break although it is longer than break_length. Set "
                   "self.holds to False in this case. Without self, holds is only a local "
                   "variable.",
                   "Your bond still pulls in the call in which it breaks. In every call to "
                   "update_force, for a and for b, update holds before you add a force."),
        "broken": (EARLY, broken),
        "heals": ("Your broken bond doesn't heal although it is shorter than rest_length. Set "
                  "holds to True in this case.",
                  "Your bond heals, but it exerts no force at once. Update holds first."),
        "holds": ("Your bond breaks too early. Let it hold until it is longer than break_length.",
                  "The force of your bond is wrong after it has healed."),
    }  # fmt: skip
    stretched = 0.5 * (bond.limit + bond.most)
    story = [
        (bond.most, "holds"),
        (1.001 * bond.most, "breaks"),
        (stretched, "broken"),
        (1.001 * bond.rest, "broken"),
        (0.999 * bond.rest, "heals"),
        (stretched, "holds"),
        (2.0 * bond.most, "breaks"),
        (0.5 * bond.rest, "heals"),
    ]
    lengths = [length for length, _ in story]
    every = bond.at(lengths, causes["holds"][0])
    pulls = [any(one[0]) or any(one[1]) for one in every]
    for i, (length, what) in enumerate(story[1:], 1):  # rounding may have broken the first
        one, other = causes[what]
        if what == "breaks" and pulls[2]:  # it pulls in a later call too
            other = broken
        seen, holds = bond.at(lengths[: i + 1], one)[-1], what in ("heals", "holds")
        words = {True: "the bond holds", False: "the bond is broken"}
        expect_that(seen[2] is holds, words[not holds], words[holds], then=HOLDS)
        force = bond.pull(length) if holds else 0.0
        bond.expect_forces(seen, force, other, "" if any(pulls) else SWAPPED)


@pytest.mark.exercise("B8.8", asks="It heals when the distance between its ends", read=BOND)
def test_a_bond_exactly_at_its_limits(rng: Random) -> None:
    bond = Sample(rng)
    bond.rest = bond.limit = 0.25 * rng.randint(3, 6)
    bond.most = bond.rest + 0.25 * rng.randint(2, 5)
    # Quarters of a meter from the origin are not rounded.
    bond.origin, bond.way = ZERO, Triple((1.0, 0.0, 0.0))
    why = "Your bond breaks at exactly break_length. Let it break only at a greater length."
    seen = bond.at([bond.most, bond.most + 1e-6, bond.rest + 1e-6, bond.rest], why)
    got = tuple(holds for _, _, holds, *_ in seen)
    why = {
        (True, True, True, True): "Your bond doesn't break if it is slightly longer than "
        "break_length. Let it break at any greater length.",
        (True, False, False, False): "Your broken bond doesn't heal at exactly rest_length. It "
        "should heal if its length is rest_length or less.",
        (True, False, True, True): EARLY,
    }.get(got, why)
    name = "; whether the bond holds at each distance"
    expect_exactly(got, (True, False, False, True), then=name, cause=why)


@pytest.mark.exercise("B8.8", asks="if the bond is intact", read=BOND)
def test_bonds_keep_a_blob_together() -> None:
    """Only here many bonds act at once, while both ends of each of them move."""
    with calls(
        "Your blob collapses or flies apart. Check the direction of the forces: a bond pushes its "
        "ends apart when it is too short, and pulls them together when it is too long.",
        "a blob of seven particles with bonds between all of them, 3 s after it was dropped",
    ):
        before, after = settled_blob(180, 1.0 / 60.0)

    def spread_of(places: Sequence[Sequence[float]]) -> float:
        middle = [math.fsum(place[k] for place in places) / len(places) for k in range(3)]
        return math.hypot(*(math.dist(place, middle) for place in places))

    # Under its own weight, such a blob spreads by 1 to 2 %.
    share = spread_of(after) / spread_of(before)
    seen = f"its spread changes by {share - 1.0:+.0%}"
    expect_that(0.9 < share < 1.1, seen, "its spread changes by less than 10%")


@pytest.mark.exercise("B8.9", asks="the root mean square distance of the particles", read=SPREAD)
def test_the_spread_is_the_root_of_the_mean_square(rng: Random) -> None:
    x, y, z = vector(rng)
    m, n, p, q = positive_number(rng), positive_number(rng), vector(rng), vector(rng)
    square = [Triple((x + i, y + j, z)) for i in (0.0, 2.0) for j in (0.0, 2.0)]
    summed = "You take the square root of the sum of {}, not of a mean. Divide the sum by the "
    summed += "total mass before you take the root."
    of_square = {
        "You didn't square the distances. Square each of them before you take their mean.":
            2.0**0.25,
        "You divide by the total mass, but you don't multiply the squared distances by the masses.":
            math.sqrt(8.0 / 12.0),
        "You return the mean of the squared distances, in m^2. Take its square root.": 2.0,
        summed.format("the squared distances"): math.sqrt(8.0),
        summed.format("the masses times the squared distances"): math.sqrt(24.0),
        "You measure the distances from the origin, so the result changes if all particles move "
        "together. Measure the distances from the center of mass.":
            math.sqrt(2.0 + math.hypot(x + 1.0, y + 1.0, z) ** 2),
    }  # fmt: skip
    apart, total = abs(p - q), m + n
    ways = (n / total * apart, m / total * apart)  # of both from their center of mass
    of_two = {
        "You return the mean of the distances. Average their squares instead.": (
            m * ways[0] + n * ways[1]
        )
        / total,
        "You measure the distances from the midpoint, not from the center of mass.": 0.5 * apart,
        "You average the squared distances without the masses.": math.hypot(*ways) / math.sqrt(2.0),
    }
    for bodies, wanted, slips, cause in (
        ([(place, 3.0) for place in square], math.sqrt(2.0), of_square,
         "The center of mass is the middle of the square, and every corner is sqrt(2) m away from "
         "it. So each squared distance is 2 m^2, and the root of their mean is sqrt(2) m."),
        ([(p, m), (q, n)], math.sqrt(m * n) / total * apart, of_two,
         "Weight each squared distance from the center of mass by the particle's mass. For two "
         "particles the result is sqrt(m n) / (m + n) times the distance between them."),
        ([(p, m)], 0.0, {},
         "A single particle is its own center of mass, so the spread is 0."),
    ):  # fmt: skip
        with calls(cause):
            particles = [Particle(Vector3(*place), mass=mass) for place, mass in bodies]
            got = spread(particles)
        now = [particle.position for particle in particles]
        expect_all_kept("particles[{}].position", now, [place for place, _ in bodies])
        expect_close(got, wanted, slips, unit="m", tolerance=1e-12)
