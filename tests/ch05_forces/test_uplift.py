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
    cause = (
        "Your condition for a particle inside the column is wrong. Add self.force if "
        "sqrt(dx^2 + dz^2), the distance from the axis, is at most the radius."
    )
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
        "You measure the distance from the point (0, 0, 0), which is not on the axis of the "
        "column. Measure it from self.origin.":
            [math.hypot(x, z) <= radius for x, _, z in places],
        "You measure the distance in X and Y. The column is vertical, so use X and Z.":
            [abs(dx) <= radius for dx, _ in ways],
        "Your column is square, because you compare dx and dz separately with the radius. "
        "Compare the distance sqrt(dx^2 + dz^2) instead.":
            [max(abs(dx), abs(dz)) <= radius for dx, dz in ways],
        "You compare the sum |dx| + |dz| with the radius. Use the distance sqrt(dx^2 + dz^2) "
        "instead.": [abs(dx) + abs(dz) <= radius for dx, dz in ways],
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
        cause = (
            "Your force does not act anywhere. Call particle.add_force if the particle is inside "
            "the column."
        )
    slips = {
        "You multiply the force by the duration of 0.5 s. self.force is already a force, so add it "
        "unchanged.": 0.5 * force,
        "You multiply the force by the mass of 4 kg. self.force is already a force, so add it "
        "unchanged.": 4.0 * force,
        "Your force points straight up, but self.force has another direction. Add the vector "
        "self.force unchanged.": (0.0, abs(force), 0.0),
    }
    for place, acts in zip(places, inside, strict=True):
        got = lifted(cause, origin, radius, force, place)
        expect_close(got, force if acts else ZERO, slips if acts else {}, unit="N")


@pytest.mark.exercise("5.1", asks="without an upper or lower end", read=READ)
def test_the_column_has_no_upper_or_lower_end(rng: Random) -> None:
    origin, force = vector(rng), vector(rng)
    (x, _, z), cause = origin, (
        "You include the height in the distance, but the column has no upper or lower end. Measure "
        "the distance only in X and Z."
    )  # fmt: skip
    if lifted(cause, origin, 2.0, force, (x + 1.0, 500.0, z - 1.0)) != ZERO:
        cause = (
            "Your force acts only above self.origin, but the column has no lower end. Don't "
            "compare the heights."
        )
    outside = "Your force acts outside the column as well."
    for height in (-500.0, 0.0, 500.0):
        got = lifted(cause, origin, 2.0, force, (x + 1.0, height, z - 1.0))
        expect_close(got, force, unit="N")
        got = lifted(outside, origin, 2.0, force, (x + 1.0, height, z - 2.0))
        expect_close(got, ZERO, unit="N")


@pytest.mark.exercise("5.1", asks="from the axis is at most radius", read=READ)
def test_the_edge_belongs_to_the_column(rng: Random) -> None:
    force = vector(rng)
    edge = (
        "Your force does not act exactly at the edge of the column, which counts as inside. "
        "Compare with <= instead of <."
    )
    line = (
        "Your force does not act if the radius is 0. The column is then a vertical line, and a "
        "particle exactly on it counts as inside."
    )
    for x, z, radius, cause in (  # 3, 4, 5 and along an axis
        (4.0, 6.0, 5.0, edge), (1.0, -3.0, 5.0, edge), (-4.0, 2.0, 5.0, edge), (1.0, 2.0, 0.0, line)
    ):  # fmt: skip
        got = lifted(cause, (1.0, 0.0, 2.0), radius, force, (x, 7.0, z))
        expect_close(got, force, unit="N")


@pytest.mark.exercise("5.1", asks="Add the force to the others on particle", read=READ)
def test_the_uplift_keeps_earlier_forces(rng: Random) -> None:
    first, force, moved = vector(rng), vector(rng), vector(rng)
    with calls(
        "The sum must contain both self.force and the force that was added before. Add self.force "
        "unchanged with add_force, and don't clear any forces."
    ):
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
    with calls(
        "You use the initial uplift.origin, but the column has moved since then. Read self.origin "
        "in every call.",
        more=True,
    ):
        uplift.origin = Vector3(9, 0, 9)
        p.clear_forces()
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, ZERO, unit="N")
    with calls(
        "You use the initial values of uplift.radius and uplift.force, which have changed since "
        "then. Read self.radius and self.force in every call.",
        more=True,
    ):
        uplift.radius, uplift.force = 20.0, Vector3(*moved)
        uplift.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, moved, unit="N")
