"""The uplift column, exercise 5.1."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Uplift
from ch05_forces.particle import Particle
from draw import components
from expect import about, expect_close, expect_unchanged, named, scoped, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 5, exercise 5.1; the docstring of Uplift"


def shown(place: tuple) -> tuple:
    """Return a position with six decimals, which are enough for a message."""
    return tuple(round(part, 6) for part in place)


@scoped
def lifted(origin: tuple, radius: float, force: tuple, place: tuple) -> tuple[str, object]:
    """Ask a column for its force on a particle at a place; return the words and the force."""
    about.call = f"p = Particle(position=Vector3{shown(place)}, velocity=Vector3(9, 9, 9), "
    about.call += f"mass=4.0); Uplift(origin=Vector3{origin}, radius={radius}, "
    about.call += f"force=Vector3{force}).update_force(p, 0.5)"
    p = Particle(Vector3(*place), Vector3(9, 9, 9), mass=4.0)
    Uplift(Vector3(*origin), radius, Vector3(*force)).update_force(p, 0.5)
    del about.cause, about.read  # what is said where update_force raises
    return f"{about.call}; p.force_accumulator", xyz(p.force_accumulator)


@pytest.mark.exercise("5.1", asks="if the horizontal distance (in X and Z)")
def test_inside_the_column_the_force_acts_and_outside_it_does_not(rng: Random) -> None:
    about.read = READ
    origin, force, radius = components(rng), components(rng), round(rng.uniform(2.0, 5.0), 3)
    about.cause = "Your condition for a particle inside the column is wrong. Add self.force if "
    about.cause += "sqrt(dx^2 + dz^2), the distance from the axis, is at most the radius."
    # 0.6 and 0.8: the distance is the radius times the share.
    ways = [
        (dx * share * radius, dz * share * radius)
        for share in (0.3, 0.99, 1.01, 1.5, 3.0)
        for dx, dz in ((0.6, 0.8), (-0.8, 0.6), (0.0, -1.0), (-1.0, 0.0))
    ]
    came = [
        lifted(origin, radius, force, (origin[0] + dx, origin[1], origin[2] + dz))
        for dx, dz in ways
    ]
    inside = [math.hypot(dx, dz) <= radius for dx, dz in ways]
    rules = {
        "You measure the distance from the point (0, 0, 0), which is not on the axis of the "
        "column. Measure it from self.origin.": [
            math.hypot(origin[0] + dx, origin[2] + dz) <= radius for dx, dz in ways
        ],
        "You measure the distance in X and Y. The column is vertical, so use X and Z.": [
            abs(dx) <= radius for dx, _ in ways
        ],
        "Your column is square, because you compare dx and dz separately with the radius. "
        "Compare the distance sqrt(dx^2 + dz^2) instead.": [
            max(abs(dx), abs(dz)) <= radius for dx, dz in ways
        ],
        "You compare the sum |dx| + |dz| with the radius. Use the distance sqrt(dx^2 + dz^2) "
        "instead.": [abs(dx) + abs(dz) <= radius for dx, dz in ways],
        "You compare the squared distance with the radius. Square the radius as well.": [
            dx * dx + dz * dz <= radius for dx, dz in ways
        ],
        "Your force acts outside the column instead of inside. Reverse the comparison.": [
            not acts for acts in inside
        ],
        "You compare the distance with the diameter of the column. Compare it with the radius.": [
            math.hypot(dx, dz) <= 2.0 * radius for dx, dz in ways
        ],
        "Your force acts everywhere. Add it only if the distance is at most the radius.": [
            True for _ in ways
        ],
    }
    acted = [got != ZERO for _, got in came]
    if acted != inside:
        about.cause = next((rule for rule in rules if rules[rule] == acted), about.cause)
    if not any(acted) and lifted(origin, radius, force, ZERO)[1] == ZERO:
        about.cause = "Your force does not act anywhere. Call particle.add_force if the particle "
        about.cause += "is inside the column."
    for (call, got), acts in zip(came, inside, strict=True):
        about.call = call
        x, y, z = force
        slips = {
            "You multiply the force by the duration of 0.5 s. self.force is already a force, so "
            "add it unchanged.": (0.5 * x, 0.5 * y, 0.5 * z),
            "You multiply the force by the mass of 4 kg. self.force is already a force, so add "
            "it unchanged.": (4.0 * x, 4.0 * y, 4.0 * z),
            "Your force points straight up, but self.force has another direction. Add the vector "
            "self.force unchanged.": (0.0, math.hypot(x, y, z), 0.0),
        }
        why = named(got, about.cause, slips) if acts else about.cause
        expect_close(got, force if acts else ZERO, cause=why, unit="N")


@pytest.mark.exercise("5.1", asks="without an upper or lower end")
def test_the_column_has_no_upper_or_lower_end(rng: Random) -> None:
    about.read = READ
    origin, force = components(rng), components(rng)
    about.cause = "You include the height in the distance, but the column has no upper or lower "
    about.cause += "end. Measure the distance only in X and Z."
    if lifted(origin, 2.0, force, (origin[0] + 1.0, 500.0, origin[2] - 1.0))[1] != ZERO:
        about.cause = "Your force acts only above self.origin, but the column has no lower end. "
        about.cause += "Don't compare the heights."
    for height in (-500.0, 0.0, 500.0):
        place = (origin[0] + 1.0, height, origin[2] - 1.0)
        about.call, got = lifted(origin, 2.0, force, place)
        expect_close(got, force, unit="N")
        place = (origin[0] + 1.0, height, origin[2] - 2.0)
        about.call, got = lifted(origin, 2.0, force, place)
        expect_close(got, ZERO, unit="N", cause="Your force acts outside the column as well.")


@pytest.mark.exercise("5.1", asks="from the axis is at most radius")
def test_the_edge_belongs_to_the_column(rng: Random) -> None:
    about.read = READ
    force = components(rng)
    about.cause = "Your force does not act exactly at the edge of the column, which counts as "
    about.cause += "inside. Compare with <= instead of <."
    for place in ((4.0, 7.0, 6.0), (1.0, 7.0, -3.0), (-4.0, 7.0, 2.0)):  # 3, 4, 5 and along an axis
        about.call, got = lifted((1.0, 0.0, 2.0), 5.0, force, place)
        expect_close(got, force, unit="N")
    about.cause = "Your force does not act if the radius is 0. The column is then a vertical line, "
    about.cause += "and a particle exactly on it counts as inside."
    about.call, got = lifted((1.0, 0.0, 2.0), 0.0, force, (1.0, 7.0, 2.0))
    expect_close(got, force, unit="N")


@pytest.mark.exercise("5.1", asks="Add the force to the others on particle")
def test_the_uplift_keeps_earlier_forces(rng: Random) -> None:
    about.read = READ
    first, force, moved = components(rng), components(rng), components(rng)
    about.call = f"p = Particle(Vector3(1, 2, 1)); p.add_force(Vector3{first}); uplift = "
    about.call += f"Uplift(origin=Vector3(0, 1, 0), radius=3.0, force=Vector3{force}); "
    about.call += "uplift.update_force(p, 0.5)"
    about.cause = "The sum must contain both self.force and the force that was added before. Add "
    about.cause += "self.force unchanged with add_force."
    p, uplift = Particle(Vector3(1, 2, 1)), Uplift(Vector3(0, 1, 0), 3.0, Vector3(*force))
    p.add_force(Vector3(*first))
    uplift.update_force(p, 0.5)
    wanted = tuple(first[i] + force[i] for i in range(3))
    got = xyz(p.force_accumulator)
    cleared = "The earlier force is missing from the sum. Add self.force with add_force, and don't "
    cleared += "clear any forces."
    about.cause = named(got, about.cause, {cleared: force})
    # One rounding of numbers up to 20.
    expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=1e-13)
    about.cause = "update_force has changed a vector that it must only read. Calculate with its "
    about.cause += "components, or use -, which creates a new vector."
    expect_unchanged("uplift.force", xyz(uplift.force), force)
    expect_unchanged("uplift.origin", xyz(uplift.origin), (0, 1, 0))
    expect_unchanged("p.position", xyz(p.position), (1, 2, 1))
    about.call += (
        "; uplift.origin = Vector3(9, 0, 9); p.clear_forces(); uplift.update_force(p, 0.5)"
    )
    about.cause = "You use the initial uplift.origin, but the column has moved since then. Read "
    about.cause += "self.origin in every call."
    uplift.origin = Vector3(9, 0, 9)
    p.clear_forces()
    uplift.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N")
    uplift.radius, uplift.force = 20.0, Vector3(*moved)
    uplift.update_force(p, 0.5)
    about.cause = "You use the initial values of uplift.radius and uplift.force, which have "
    about.cause += "changed since then. Read self.radius and self.force in every call."
    got = xyz(p.force_accumulator)
    expect_close(
        got,
        moved,
        then=f"; uplift.radius = 20.0; uplift.force = Vector3{moved}; "
        "uplift.update_force(p, 0.5); p.force_accumulator",
        unit="N",
    )
