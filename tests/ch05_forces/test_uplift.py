"""The uplift column, exercise 5.1."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Uplift
from ch05_forces.particle import Particle
from draw import Components, Triple, vector
from expect import expect_close, xyz
from unmoved import expect_kept

ZERO = (0.0, 0.0, 0.0)
READ = "book 5, exercise 5.1; the docstring of Uplift"


def lifted(cause: str, origin: Components, radius: float, force: Triple, place: Components) -> Any:
    """Return the force of a column on a particle at a place."""
    with calls(cause):
        p = Particle(Vector3(*place), Vector3(9, 9, 9), mass=4.0)
        uplift = Uplift(origin=Vector3(*origin), radius=radius, force=Vector3(*force))
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    return xyz(got)


@pytest.mark.exercise("5.1", asks="if the horizontal distance (in X and Z)", read=READ)
def test_inside_the_column_the_force_acts_and_outside_it_does_not(rng: Random) -> None:
    origin, force, radius = vector(rng), vector(rng), round(rng.uniform(2.0, 5.0), 3)
    cause = "Add self.force if the horizontal distance sqrt(dx^2 + dz^2) is at most the radius."
    # 0.6 and 0.8: the distance is the radius times the share.
    ways = [
        (dx * share * radius, dz * share * radius)
        for share in (0.3, 0.99, 1.01, 1.5, 3.0)
        for dx, dz in ((0.6, 0.8), (-0.8, 0.6), (0.0, -1.0), (-1.0, 0.0))
    ]
    places = [Triple((dx, 0.0, dz)) + origin for dx, dz in ways]
    acted = [lifted(cause, origin, radius, force, place) != ZERO for place in places]
    inside = [math.hypot(dx, dz) <= radius for dx, dz in ways]
    rules = {
        "You measure the distance from the point (0, 0, 0). Measure it from self.origin.":
            [math.hypot(x, z) <= radius for x, _, z in places],
        "You measure the distance in X and Y. The column is vertical, so use X and Z.":
            [abs(dx) <= radius for dx, _ in ways],
        "Your column is square. Compare the distance sqrt(dx^2 + dz^2) with the radius.":
            [max(abs(dx), abs(dz)) <= radius for dx, dz in ways],
        "You compare the sum |dx| + |dz| with the radius. Use sqrt(dx^2 + dz^2) instead.":
            [abs(dx) + abs(dz) <= radius for dx, dz in ways],
        "You compare the squared distance with the radius. Square the radius as well.":
            [dx * dx + dz * dz <= radius for dx, dz in ways],
        "Your force acts outside the column instead of inside. Reverse the comparison.":
            [not acts for acts in inside],
        "You compare the distance with the diameter of the column. Compare it with the radius.":
            [math.hypot(dx, dz) <= 2.0 * radius for dx, dz in ways],
        "Your force acts everywhere. Add it only if the distance is at most the radius.":
            [True for _ in ways],
    }  # fmt: skip
    if acted != inside:
        cause = next((rule for rule in rules if rules[rule] == acted), cause)
    if not any(acted) and lifted(cause, origin, radius, force, ZERO) == ZERO:
        cause = "Your force acts nowhere. Call particle.add_force inside of the column."
    slips = {
        "You multiply the force by the duration of 0.5 s. Add self.force unchanged.": 0.5 * force,
        "You multiply the force by the mass of 4 kg. Add self.force unchanged.": 4.0 * force,
        "Your force points straight up. Add self.force unchanged.": (0.0, abs(force), 0.0),
    }
    for place, acts in zip(places, inside, strict=True):
        got = lifted(cause, origin, radius, force, place)
        expect_close(got, force if acts else ZERO, slips if acts else {}, unit="N")


@pytest.mark.exercise("5.1", asks="without an upper or lower end", read=READ)
def test_the_column_has_no_upper_or_lower_end(rng: Random) -> None:
    origin, force = vector(rng), vector(rng)
    x, _, z = origin
    cause = "You include the height in the distance. Measure it only in X and Z."
    if lifted(cause, origin, 2.0, force, (x + 1.0, 500.0, z - 1.0)) != ZERO:
        cause = "Your force acts only above self.origin. Don't compare the heights."
    outside = "Your force acts outside the column as well."
    for height in (-500.0, 0.0, 500.0):
        got = lifted(cause, origin, 2.0, force, (x + 1.0, height, z - 1.0))
        expect_close(got, force, unit="N")
        got = lifted(outside, origin, 2.0, force, (x + 1.0, height, z - 2.0))
        expect_close(got, ZERO, unit="N")


@pytest.mark.exercise("5.1", asks="from the axis is at most radius", read=READ)
def test_the_edge_belongs_to_the_column(rng: Random) -> None:
    force = vector(rng)
    edge = "The edge of the column counts as inside. Compare with <= instead of <."
    line = "If the radius is 0, the column is a line. A particle exactly on it counts as inside."
    for x, z, radius, cause in (  # 3, 4, 5 and along an axis
        (4.0, 6.0, 5.0, edge), (1.0, -3.0, 5.0, edge), (-4.0, 2.0, 5.0, edge), (1.0, 2.0, 0.0, line)
    ):  # fmt: skip
        got = lifted(cause, (1.0, 0.0, 2.0), radius, force, (x, 7.0, z))
        expect_close(got, force, unit="N")


@pytest.mark.exercise("5.1", asks="Add the force to the others on particle", read=READ)
def test_the_uplift_keeps_earlier_forces(rng: Random) -> None:
    first, force, moved = vector(rng), vector(rng), vector(rng)
    with calls("Add self.force unchanged to the earlier forces, and don't clear any forces."):
        p = Particle(Vector3(1, 2, 1))
        uplift = Uplift(origin=Vector3(0, 1, 0), radius=3.0, force=Vector3(*force))
        p.add_force(Vector3(*first))
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    slips = {"The earlier force is missing from the sum.": force}
    # One rounding of numbers up to 20.
    expect_close(got, first + force, slips, unit="N", tolerance=1e-13)
    expect_kept("uplift.force", xyz(uplift.force), force)
    expect_kept("uplift.origin", xyz(uplift.origin), (0, 1, 0))
    expect_kept("p.position", xyz(p.position), (1, 2, 1))
    with calls("The column has moved. Read self.origin in every call.", more=True):
        uplift.origin = Vector3(9, 0, 9)
        p.clear_forces()
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, ZERO, unit="N")
    with calls("Both have changed. Read self.radius and self.force in every call.", more=True):
        uplift.radius, uplift.force = 20.0, Vector3(*moved)
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, moved, unit="N")
