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
    return f"{about.call}; p.force_accumulator, in N", xyz(p.force_accumulator)


@pytest.mark.exercise("5.1")
def test_inside_the_column_the_force_acts_and_outside_it_does_not(rng: Random) -> None:
    about.read = READ
    origin, force, radius = components(rng), components(rng), round(rng.uniform(2.0, 5.0), 3)
    about.cause = "The force must act only inside the column. If the horizontal distance "
    about.cause += "sqrt(dx^2 + dz^2) from its axis is at most the radius, add self.force."
    # 0.6 and 0.8: the distance is the radius times the share.
    ways = [
        (dx * share * radius, dz * share * radius)
        for share in (0.3, 0.99, 1.01, 1.5)
        for dx, dz in ((0.6, 0.8), (-0.8, 0.6), (0.0, -1.0), (-1.0, 0.0))
    ]
    came = [
        lifted(origin, radius, force, (origin[0] + dx, origin[1], origin[2] + dz))
        for dx, dz in ways
    ]
    inside = [math.hypot(dx, dz) <= radius for dx, dz in ways]
    rules = {
        "You measured the distance from (0, 0), but the column is somewhere else. Measure it "
        "from self.origin.": [
            math.hypot(origin[0] + dx, origin[2] + dz) <= radius for dx, dz in ways
        ],
        "You measured the distance in X and Y. The column is vertical, so use X and Z.": [
            abs(dx) <= radius for dx, _ in ways
        ],
        "Your column is square, because you compare dx and dz separately with the radius. "
        "Compare the distance sqrt(dx^2 + dz^2) instead.": [
            max(abs(dx), abs(dz)) <= radius for dx, dz in ways
        ],
        "You compare the sum |dx| + |dz| with the radius. Use the distance sqrt(dx^2 + dz^2) "
        "instead.": [abs(dx) + abs(dz) <= radius for dx, dz in ways],
        "The squared distance was compared with the radius. Square the radius as well.": [
            dx * dx + dz * dz <= radius for dx, dz in ways
        ],
        "Your force acts outside the column instead of inside. Reverse the comparison.": [
            not acts for acts in inside
        ],
        (
            "Your force acts everywhere. The column ends at its radius, so check the distance "
            "before you add the force."
        ): [True for _ in ways],
        (
            "Your force does not act anywhere. Call particle.add_force if the particle is "
            "inside the column."
        ): [False for _ in ways],
    }
    acted = [got != ZERO for _, got in came]
    if acted != inside:
        about.cause = next((rule for rule in rules if rules[rule] == acted), about.cause)
    for (call, got), acts in zip(came, inside, strict=True):
        about.call = call
        x, y, z = force
        slips = {
            "You multiplied the force by the mass of 4 kg. self.force is already a force, so "
            "add it unchanged.": (4.0 * x, 4.0 * y, 4.0 * z),
            "Your force points straight up, but self.force points elsewhere. Add the whole "
            "vector self.force.": (
                0.0,
                math.hypot(x, y, z),
                0.0,
            ),
        }
        why = named(got, about.cause, slips) if acts else about.cause
        expect_close(got, force if acts else ZERO, cause=why)


@pytest.mark.exercise("5.1")
def test_the_column_has_no_end_upwards_or_downwards(rng: Random) -> None:
    about.read = READ
    origin, force = components(rng), components(rng)
    about.cause = "The column has no upper or lower end. Use only the distance in X and Z, and "
    about.cause += "ignore the heights of the particle and of self.origin."
    for height in (-500.0, 0.0, 500.0):
        place = (origin[0] + 1.0, height, origin[2] - 1.0)
        about.call, got = lifted(origin, 2.0, force, place)
        expect_close(got, force)
        place = (origin[0] + 1.0, height, origin[2] - 2.0)
        about.call, got = lifted(origin, 2.0, force, place)
        expect_close(got, ZERO)


@pytest.mark.exercise("5.1")
def test_the_edge_belongs_to_the_column(rng: Random) -> None:
    about.read = READ
    force = components(rng)
    about.cause = "The particle is exactly on the edge of the column, which counts as inside. "
    about.cause += "Compare with <= instead of <."
    for place in ((4.0, 7.0, 6.0), (1.0, 7.0, -3.0), (-4.0, 7.0, 2.0)):  # 3, 4, 5 and along an axis
        about.call, got = lifted((1.0, 0.0, 2.0), 5.0, force, place)
        expect_close(got, force)
    about.cause = "A column with a radius of 0 is a vertical line. The particle is exactly on it, "
    about.cause += "which counts as inside."
    about.call, got = lifted((1.0, 0.0, 2.0), 0.0, force, (1.0, 7.0, 2.0))
    expect_close(got, force)


@pytest.mark.exercise("5.1")
def test_the_uplift_adds_to_the_other_forces(rng: Random) -> None:
    about.read = READ
    first, force, moved = components(rng), components(rng), components(rng)
    about.call = f"p = Particle(Vector3(1, 2, 1)); p.add_force(Vector3{first}); uplift = "
    about.call += f"Uplift(origin=Vector3(0, 1, 0), radius=3.0, force=Vector3{force}); "
    about.call += "uplift.update_force(p, 0.5)"
    about.cause = "The sum must contain both self.force and the force that was added before. Use "
    about.cause += "add_force, which adds to the other forces."
    p, uplift = Particle(Vector3(1, 2, 1)), Uplift(Vector3(0, 1, 0), 3.0, Vector3(*force))
    p.add_force(Vector3(*first))
    uplift.update_force(p, 0.5)
    wanted = tuple(first[i] + force[i] for i in range(3))
    got = xyz(p.force_accumulator)
    # One rounding of numbers up to 20.
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-13)
    about.cause = "update_force has changed the force, the position or the origin. It must only "
    about.cause += "read these vectors."
    expect_unchanged("uplift.force", xyz(uplift.force), force)
    expect_unchanged("uplift.origin", xyz(uplift.origin), (0, 1, 0))
    expect_unchanged("p.position", xyz(p.position), (1, 2, 1))
    about.call = "uplift.origin = Vector3(9, 0, 9); p.clear_forces(); uplift.update_force(p, 0.5)"
    about.cause = "The check moves the column before this call, so the particle is now outside "
    about.cause += "it. Read self.origin in every call."
    uplift.origin = Vector3(9, 0, 9)
    p.clear_forces()
    uplift.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator, in N")
    uplift.radius, uplift.force = 20.0, Vector3(*moved)
    uplift.update_force(p, 0.5)
    about.cause = "The check changes uplift.radius and uplift.force between two calls of "
    about.cause += "update_force. Read self.radius and self.force in every call."
    got = xyz(p.force_accumulator)
    expect_close(
        got,
        moved,
        then=f"; uplift.radius = 20.0; uplift.force = Vector3{moved}; "
        "uplift.update_force(p, 0.5); p.force_accumulator, in N",
    )
