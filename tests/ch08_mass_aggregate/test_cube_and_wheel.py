"""Mini-projects 8.2, a cube of rods, and 8.3, a wheel."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import Rod
from ch08_mass_aggregate.cube import cube_rods, fewest_rods
from ch08_mass_aggregate.scene_probes import rods
from ch08_mass_aggregate.wheel import RimDrive, deformation, rods_of, spin
from draw import Triple, number, positive_number, unit_vector, vector
from expect import expect_close, expect_exactly, expect_that, named
from rigidity import motions, told
from unmoved import expect_all_kept, expect_kept

CUBE = "mini-project 8.2, and the docstring of cube_rods"
FEWEST = "mini-project 8.2, and the docstring of fewest_rods"
WHEEL = "mini-project 8.3, and the docstring of rods_of"
DRIVE = "mini-project 8.3, and the docstring of RimDrive.update_force"
SPIN = "the docstring of spin"
DEFORMATION = "mini-project 8.3, and the docstring of deformation"
CORNERS = [(float(i % 2), float(i // 2 % 2), float(i // 4)) for i in range(8)]
# Corner 0 is held, 1 moves along X only, and 2 in the X-Y plane: no rigid body moves then.
HELD = (0, 1, 2, 4, 5, 8)
ZERO = Triple((0.0, 0.0, 0.0))
LARGEST = "Return the largest value of abs(length / rod.length - 1) of any rod."
MOMENTUM = "You return the angular momentum of the rim."


@pytest.mark.exercise("8.2", asks="the smallest number of rods that can make", read=FEWEST)
def test_how_many_rods_are_necessary(rng: Random) -> None:
    count = rng.randint(9, 99)
    for n, wanted, cause in (
        (8, 18, "Eight corners have 24 degrees of freedom, and a rigid body keeps 6 of them. Each "
                "rod removes one, so you need at least 24 - 6 rods."),
        (3, 3, "A triangle of three rods is rigid, so three particles need three rods."),
        (2, 1, "Two particles need one rod. Handle this case separately, because the formula 3 n - "
               "6 holds only for three or more particles."),
        (1, 0, "A single particle has no distance to keep, so it needs no rod."),
        (4, 6, "A tetrahedron of six rods is rigid, so four particles need six rods."),
        (count, 3 * count - 6, "Each particle has three degrees of freedom, and a rigid body keeps "
                               "six in total. Each rod removes one, so the number is 3 n - 6."),
    ):  # fmt: skip
        with calls(cause):
            got = fewest_rods(n)
        slips = {
            "You return 24, which counts all degrees of freedom of the eight corners.": 24,
            "You return 2 n - 3, which holds for particles in a plane. In space, use 3 n - 6.": 13,
            "You return 3 n - 3. A rigid body can move and also rotate, so subtract 6.": 21,
        }
        why = named(got, cause, slips if n == 8 else {})
        expect_exactly(got, wanted, unit="rods", cause=why)


@pytest.mark.exercise("8.2", asks="move and rotate only as a whole", weight=2, read=CUBE)
def test_the_cube_is_rigid() -> None:
    why = "Each rod must be a pair of two different corners, numbered from 0 to 7."
    with calls(why):
        made = cube_rods()
    made = [tuple(rod) for rod in made]
    wrong = [
        rod
        for rod in made
        if len(rod) != 2 or not all(type(i) is int and 0 <= i < 8 for i in rod) or rod[0] == rod[1]
    ]
    if any(8 in rod for rod in wrong):
        why = "There is no corner 8. Number the corners from 0 to 7 instead of 1 to 8."
    wanted = "only pairs of corners from 0 to 7"
    expect_that(not wrong, f"the rods {wrong}", wanted, cause=why)
    left = motions(CORNERS, made, HELD)
    pairs = {tuple(sorted(rod)) for rod in made}
    faces = [(axis, i & axis) for i, j in pairs for axis in (1, 2, 4) if i ^ j == 7 - axis]
    moves = told(left[0], "corner") if left else ""
    if len(made) > len(pairs):
        why = f"You list a rod twice, so you have only {len(pairs)} different rods. Replace one."
    elif len(pairs) < 18:
        why = f"You have only {len(pairs)} rods, but a rigid cube needs at least 18. Add rods to "
        why += f"stop motions such as this one: {moves}."
    elif len(set(faces)) < len(faces):
        why = "Two of your diagonals are in the same face. Move one of them to another face to "
        why += f"stop this motion: {moves}."
    else:
        why = f"One of your rods is redundant. Move it to stop this motion: {moves}."
    name = "; the number of independent ways to deform the cube without changing a rod's length"
    expect_exactly(len(left), 0, then=name, unit="ways", cause=why)


def draw_rim(rng: Random, count: int) -> tuple[Triple, list[Triple]]:
    """Draw a hub, and a rim around it whose radius is not the same everywhere."""
    hub, rim = vector(rng), []
    for i in range(count):
        angle, radius = math.tau * i / count, positive_number(rng, 1.0, 2.0)
        rim.append(hub + Triple((radius * math.cos(angle), radius * math.sin(angle), number(rng))))
    return hub, rim


@pytest.mark.exercise("8.3a", asks="A spoke joins the hub to each of them", read=WHEEL)
@pytest.mark.parametrize("count", [3, 8])
def test_a_wheel_has_spokes_and_a_rim(rng: Random, count: int) -> None:
    hub, rim = draw_rim(rng, count)
    places = [hub, *rim]
    why = "Join the hub to each particle of the rim, each particle of the rim to the next one, and "
    why += "the last one to the first. (i + 1) % len(rim) is the index of the next particle."
    text = f"a wheel whose hub is particle 0, with particles 1 to {count} around it as the rim; "
    text += "rods_of(hub, rim)"
    with calls(why, text):
        particles = [Particle(Vector3(*place)) for place in places]
        particles[0].mass = math.inf
        made = sorted(rods(rods_of(particles[0], particles[1:]), particles))
    expect_all_kept("the position of particle {}", [one.position for one in particles], places)
    spokes = [(0, i + 1) for i in range(count)]
    circle = [(1, count), *((i, i + 1) for i in range(1, count))]
    wanted = sorted(spokes + circle)
    got = [(i, j) for i, j, _ in made]
    missing = [pair for pair in wanted if pair not in got]
    if missing == [(1, count)]:
        why = "Your rim is not closed. Also join its last particle to its first one."
    elif missing == spokes:
        why = "You create no spokes. Join the hub to each particle of the rim."
    elif missing == sorted(circle):
        why = f"You create only the spokes. {why}"
    expect_exactly(got, wanted, then="; the two ends of each rod", cause=why)
    why = "Your rod has the wrong length."
    if len({length for *_, length in made}) == 1:
        why = "You give all rods the same length."
    why += " Make each rod as long as the current distance between its two ends."
    for i, j, length in made:
        name = f"; the length of the rod from particle {i} to particle {j}"
        wanted = math.dist(places[i], places[j])
        expect_close(length, wanted, then=name, cause=why, unit="m", tolerance=1e-12)


@pytest.mark.exercise("8.3b", asks="at a right angle to its spoke", read=DRIVE)
def test_the_drive_pushes_around_the_hub(rng: Random) -> None:
    hub, force, already = vector(rng), number(rng), vector(rng)
    around = "Take the unit vector along the spoke in the X-Y plane, rotate it by a right angle, "
    around += "and multiply it by the force. The force doesn't depend on the distance."
    at_hub = "The spoke of this particle has no direction in the X-Y plane. Add no force then."
    simple = Triple((1.0, 2.0, 3.0)), 10.0, ZERO
    samples = [(*simple, (4.0, 6.0, 15.0), Triple((-8.0, 6.0, 0.0)), around)]
    for most in (0.1, 0.9, 3.0):  # less than 1 m as well as more
        angle, radius = positive_number(rng, 0.1, 6.0), positive_number(rng, 0.01, most)
        c, s = math.cos(angle), math.sin(angle)
        place = hub + Triple((radius * c, radius * s, number(rng)))
        samples.append((hub, force, already, place, force * Triple((-s, c, 0.0)), around))
    for place in (hub, hub + Triple((0.0, 0.0, 1.0))):
        samples.append((hub, force, already, place, ZERO, at_hub))
    slips = {
        "Your force acts along the spoke. Rotate its direction (x, y) to (-y, x).": (6.0, 8.0, 0.0),
        "Your force drives the wheel clockwise. Use (-y, x) instead of (y, -x).": (8.0, -6.0, 0.0),
        "Your force grows with the distance from the hub. Divide by it.": (-40.0, 30.0, 0.0),
        "Your force acts along the spoke. Rotate its direction to (-y, x, 0).": (6.0, 8.0, 24.0),
        "You divided by a length that includes z, but the wheel rotates in the X-Y plane.":
            Triple((-40.0, 30.0, 0.0)) / 13.0,
        "You measure the spoke from the origin instead of the hub.":
            Triple((-60.0, 40.0, 0.0)) / math.sqrt(52.0),
    }  # fmt: skip
    for center, size, before, place, wanted, cause in samples:
        with calls(cause):
            drive = RimDrive(Particle(Vector3(*center), mass=math.inf), force=size)
            particle = Particle(Vector3(*place), mass=2.0)
            particle.add_force(Vector3(*before))
            drive.update_force(particle, 0.1)
            got = particle.force_accumulator
        # The angle of a spoke of a centimeter is rounded to 1e-13.
        near = 0.0 if wanted == ZERO else 1e-11
        some = slips if center == simple[0] else {}
        expect_close(got, before + wanted, some, unit="N", tolerance=near)
        expect_kept("particle.position", particle.position, place)


def spun(hub: Triple, drift: Triple, rim: list[tuple[Triple, Triple, float]], cause: str) -> Any:
    """Return the spin of a rim, given by position, velocity and mass of each particle."""
    with calls(cause):
        middle = Particle(Vector3(*hub), Vector3(*drift), mass=math.inf)
        made = [Particle(Vector3(*p), Vector3(*v), mass=m) for p, v, m in rim]
        got = spin(middle, made)
    expect_kept("hub.position", middle.position, hub)
    now = [particle.position for particle in made]
    expect_all_kept("the position of rim[{}]", now, [p for p, _, _ in rim])
    return got


@pytest.mark.exercise("8.3b", asks="angular momentum of the rim divided by", read=SPIN)
def test_the_spin_is_that_of_the_whole_rim(rng: Random) -> None:
    hub, rim = draw_rim(rng, 5)
    drift, rate = vector(rng), number(rng)
    masses = [positive_number(rng) for _ in rim]
    spin_of = "Divide the angular momentum, the sum of m (x v_y - y v_x), by the moment of "
    spin_of += "inertia, the sum of m (x^2 + y^2). Both are relative to the hub."
    parts = list(zip(masses, (place - hub for place in rim), rim, strict=True))
    turning = [drift + rate * Triple((-r[1], r[0], 0.0)) for _, r, _ in parts]
    inertia = math.fsum(m * (r[0] ** 2 + r[1] ** 2) for m, r, _ in parts)
    got = spun(hub, drift, list(zip(rim, turning, masses, strict=True)), spin_of)
    slips = {
        "Your spin has the wrong sign, but a counter-clockwise rotation counts as positive.": -rate,
        MOMENTUM: rate * inertia,
        "Your moment of inertia is the sum of m (x + y).":
            rate * inertia / math.fsum(m * (r[0] + r[1]) for m, r, _ in parts),
        "You count the hub's velocity as part of the rotation.":
            rate + math.fsum(m * r.cross(drift)[2] for m, r, _ in parts) / inertia,
        "You measure the positions from the origin instead of the hub.":
            rate * math.fsum(m * (r[0] * p[0] + r[1] * p[1]) for m, r, p in parts)
            / math.fsum(m * (p[0] ** 2 + p[1] ** 2) for m, _, p in parts),
    }  # fmt: skip
    expect_close(got, rate, slips, unit="rad/s", tolerance=1e-12)
    one = Triple((1.0, 0.0, 0.0)), Triple((0.0, 2.0, 0.0)), 1.0
    two = Triple((0.0, 2.0, 0.0)), Triple((-2.0, 0.0, 0.0)), 3.0
    slips = {
        "You leave out the masses.": 1.2,
        "You return the mean of the particles' angular velocities.": 1.5,
        "You didn't square the distance from the hub in the moment of inertia.": 2.0,
        MOMENTUM: 14.0,
    }
    got = spun(ZERO, ZERO, [one, two], f"{spin_of} Here they are 14 and 13.")
    expect_close(got, 14.0 / 13.0, slips, unit="rad/s")
    v = [vector(rng) for _ in rim]
    got = spun(hub, ZERO, list(zip(rim, v, masses, strict=True)), spin_of)
    wanted = math.fsum(m * r.cross(w)[2] for (m, r, _), w in zip(parts, v, strict=True)) / inertia
    expect_close(got, wanted, unit="rad/s", tolerance=1e-12)
    for rim, where in (
        ([], "The rim has no particles"),
        ([(hub, vector(rng), 2.0)], "The only particle of the rim is at the hub"),
    ):
        why = f"{where}, so the moment of inertia is 0. Return 0 instead of dividing by it."
        expect_close(spun(hub, drift, rim, why), 0.0, tolerance=0.0)


@pytest.mark.exercise("8.3c", asks="the largest relative error in the length", read=DEFORMATION)
def test_the_deformation_is_that_of_the_worst_rod(rng: Random) -> None:
    start, way = vector(rng), unit_vector(rng)
    a, b, c = (positive_number(rng, 1.0, 3.0) for _ in range(3))
    for shares, wanted in (((0.05, 0.0), 0.05), ((-0.07, 0.02), 0.07), ((0.01, 0.04, 0.02), 0.04)):
        should = (a, b, c)[: len(shares)]
        lengths = [round(n * (1.0 + share), 9) for n, share in zip(should, shares, strict=True)]
        shares = [now / length - 1.0 for now, length in zip(lengths, should, strict=True)]
        text = f"rods with rod.length = {should} m, whose ends are {tuple(lengths)} m apart; "
        with calls(LARGEST, f"{text}deformation(rods)"):
            ends = [
                (Particle(Vector3(*start)), Particle(Vector3(*(start + way * now))))
                for now in lengths
            ]
            got = deformation([Rod(*pair, size) for pair, size in zip(ends, should, strict=True)])
        expect_kept("a.position", ends[0][0].position, start)
        expect_kept("b.position", ends[0][1].position, start + way * lengths[0])
        slips = {
            "You return the largest error in meters. Divide each error by rod.length.":
                max(abs(now - size) for now, size in zip(lengths, should, strict=True)),
            "You return the mean of the errors. Return the largest one.":
                math.fsum(map(abs, shares)) / len(shares),
            "You overlook rods that are too short. Take abs() of each error.": max(shares),
            "You return the ratio length / rod.length. Subtract 1 to get the error.":
                1.0 + max(shares),
        }  # fmt: skip
        expect_close(got, wanted, slips, tolerance=1e-12)
    with calls("There are no rods, so there is no largest error. Return 0 in this case."):
        got = deformation([])
    expect_close(got, 0.0, tolerance=0.0)
