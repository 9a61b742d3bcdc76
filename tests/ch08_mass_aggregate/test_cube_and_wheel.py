"""Mini-projects 8.2, a cube of rods, and 8.3, a wheel."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.cube import fewest_rods
from ch08_mass_aggregate.scene_probes import cube_rods, deformed, driven, spun, wheel_rods
from draw import components, direction, number, positive_number
from expect import expect_close, expect_error, expect_exactly
from rigidity import motions, told

CUBE = "mini-project 8.2, and the docstring of cube_rods"
FEWEST = "mini-project 8.2, and the docstring of fewest_rods"
WHEEL = "mini-project 8.3, and the docstring of rods_of"
DRIVE = "mini-project 8.3, and the docstring of RimDrive.update_force"
SPIN = "the docstring of spin"
DEFORMATION = "mini-project 8.3, and the docstring of deformation"
CORNERS = [(float(i % 2), float(i // 2 % 2), float(i // 4)) for i in range(8)]
# Corner 0 is held, 1 moves along X only, and 2 in the X-Y plane: no rigid body moves then.
HELD = (0, 1, 2, 4, 5, 8)


@pytest.mark.exercise("8.2")
def test_how_many_rods_are_necessary(rng: Random) -> None:
    read = FEWEST
    for count, wanted, cause in (
        (8, 18, "eight corners move in 24 ways, a rigid body in 6: 24 - 6 rods"),
        (3, 3, "a triangle"),
        (2, 1, "two particles and a rod"),
        (1, 0, "one particle is rigid by itself"),
        (4, 6, "a tetrahedron"),
    ):
        call = f"fewest_rods({count})"
        expect_exactly(call, fewest_rods(count), wanted, cause=cause, read=read)
    count = rng.randint(9, 99)
    call = f"fewest_rods({count})"
    cause = "three for each particle, less the six motions of a rigid body"
    expect_exactly(call, fewest_rods(count), 3 * count - 6, cause=cause, read=read)
    for bad, error in ((0, ValueError), (-3, ValueError), (8.0, TypeError), ("8", TypeError)):
        expect_error(
            f"fewest_rods({bad!r})",
            lambda bad=bad: fewest_rods(bad),
            error,
            allowed=lambda: fewest_rods(8),
            cause="there are 1, 2, 3 or more particles",
            read=read,
        )


@pytest.mark.exercise("8.2", weight=2)
def test_the_cube_is_rigid() -> None:
    read = CUBE
    call = "cube_rods()"
    cause = "each rod is a pair of two different numbers from 0 to 7"
    rods = cube_rods()
    wrong = [
        rod
        for rod in rods
        if len(rod) != 2 or not all(type(i) is int and 0 <= i < 8 for i in rod) or rod[0] == rod[1]
    ]
    expect_exactly(f"{call}: what is no pair of corners", wrong, [], cause=cause, read=read)
    left = motions(CORNERS, rods, HELD)
    different = len({tuple(sorted(rod)) for rod in rods})
    cause = f"{different} different rods, of which {18 - len(left)} count, where 18 are needed"
    if left:
        cause += f"; they leave this motion: {told(left[0], 'corner')}"
    name = f"{call}: how many motions they leave, besides those of a rigid body"
    expect_exactly(name, len(left), 0, cause=cause, read=read)


def draw_rim(rng: Random, count: int) -> tuple[tuple[float, float, float], list]:
    """Draw a hub, and a rim about it whose radius is not everywhere the same."""
    hub = components(rng)
    rim = []
    for i in range(count):
        angle, radius = math.tau * i / count, positive_number(rng, 1.0, 2.0)
        z = hub[2] + number(rng)
        place = (hub[0] + radius * math.cos(angle), hub[1] + radius * math.sin(angle), z)
        rim.append(place)
    return hub, rim


@pytest.mark.exercise("8.3a")
@pytest.mark.parametrize("count", [3, 8])
def test_a_wheel_has_spokes_and_a_rim(rng: Random, count: int) -> None:
    read = WHEEL
    hub, rim = draw_rim(rng, count)
    call = f"rods_of(hub, a rim of {count}); the ends of its rods, where the hub is number 0"
    cause = "a spoke from the hub to each, and a rod from each to the next, and from the last to "
    cause += "the first"
    rods = sorted(wheel_rods(hub, rim))
    wanted = [(0, i + 1) for i in range(count)] + [(i, i + 1) for i in range(1, count)]
    wanted = sorted([*wanted, (1, count)])
    expect_exactly(call, [(i, j) for i, j, _ in rods], wanted, cause=cause, read=read)
    call = f"rods_of(hub at {hub}, rim at {rim}); the lengths of its rods"
    cause = "each rod is as long as its ends are apart now"
    places = [hub, *rim]
    lengths = [math.dist(places[i], places[j]) for i, j, _ in rods]
    got = [length for _, _, length in rods]
    expect_close(call, got, lengths, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("8.3b")
def test_the_drive_pushes_round_the_hub(rng: Random) -> None:
    read = DRIVE
    hub, force, already = components(rng), number(rng), components(rng)
    cause = "the force is F (-sin, cos, 0) of the spoke's angle in the X-Y plane: a right angle "
    cause += "to it, counter-clockwise, and of the same size at every distance"
    places, wanted = [], []
    for _ in range(3):
        angle, radius = positive_number(rng, 0.1, 6.0), positive_number(rng, 0.01, 3.0)
        c, s = math.cos(angle), math.sin(angle)
        places.append((hub[0] + radius * c, hub[1] + radius * s, hub[2] + number(rng)))
        wanted.append((already[0] - force * s, already[1] + force * c, already[2]))
    call = f"RimDrive(hub at {hub}, {force}).update_force(particle, 0.1), after "
    call += f"particle.add_force(Vector3{already}); the particle at "
    done = driven(hub, force, places, already)
    for place, force_of_all, (got, after) in zip(places, wanted, done, strict=True):
        # The angle of a spoke of a centimetre is rounded to 1e-13.
        name = f"{call}{place}"
        expect_close(name, got, force_of_all, cause=cause, read=read, tolerance=1e-11)
        name = f"{call}{place}; its place then"
        moves = "a force moves nothing by itself: work on a new vector"
        expect_close(name, after, place, cause=moves, read=read, tolerance=0.0)
    cause = "at the hub, and right before it, there is no direction, and no force"
    for place in (hub, (hub[0], hub[1], hub[2] + 1.0)):
        got = driven(hub, force, [place], already)[0][0]
        expect_close(f"{call}{place}", got, already, cause=cause, read=read, tolerance=0.0)


@pytest.mark.exercise("8.3b")
def test_the_spin_is_that_of_the_whole_rim(rng: Random) -> None:
    read = SPIN
    hub, rim = draw_rim(rng, 5)
    drift, rate = components(rng), number(rng)
    masses = [positive_number(rng) for _ in rim]
    moving = [
        (drift[0] - rate * (y - hub[1]), drift[1] + rate * (x - hub[0]), drift[2])
        for x, y, _ in rim
    ]
    call = f"spin(hub, rim) of a rim that turns at {rate} rad/s about a hub that moves at {drift}"
    cause = "positions and velocities are those seen from the hub"
    got = spun((hub, drift), list(zip(rim, moving, masses, strict=True)))
    expect_close(call, got, rate, cause=cause, read=read, tolerance=1e-12)
    v = [components(rng) for _ in rim]
    seen = [(x - hub[0], y - hub[1]) for x, y, _ in rim]
    turning = math.fsum(
        m * (x * w[1] - y * w[0]) for m, (x, y), w in zip(masses, seen, v, strict=True)
    )
    inertia = math.fsum(m * (x * x + y * y) for m, (x, y) in zip(masses, seen, strict=True))
    call = f"spin(hub, rim) of a rim at {rim}, velocities {v}, masses {masses}, the hub at rest"
    cause = "sum of m (x v_y - y v_x), divided by the sum of m (x^2 + y^2): mass counts, and so "
    cause += "does the square of the distance"
    got = spun((hub, (0.0, 0.0, 0.0)), list(zip(rim, v, masses, strict=True)))
    expect_close(call, got, turning / inertia, cause=cause, read=read, tolerance=1e-12)
    cause = "no moment of inertia, no spin: 0"
    for where, rim in (("no particles", []), ("one at the hub", [(hub, components(rng), 2.0)])):
        got = spun((hub, drift), rim)
        call = f"spin(hub, rim) of a rim of {where}"
        expect_close(call, got, 0.0, cause=cause, read=read, tolerance=0.0)


@pytest.mark.exercise("8.3c")
def test_the_deformation_is_that_of_the_worst_rod(rng: Random) -> None:
    read = DEFORMATION
    way = direction(rng)
    a, b, c = (positive_number(rng, 1.0, 3.0) for _ in range(3))
    for name, rods, wanted in (
        ("too long by 5 %, and a right one", [(a, 1.05 * a), (b, b)], 0.05),
        ("too short by 7 %, and one too long by 2 %", [(a, 0.93 * a), (b, 1.02 * b)], 0.07),
        ("too long by 1 %, 4 %, 2 %", [(a, 1.01 * a), (b, 1.04 * b), (c, 1.02 * c)], 0.04),
    ):
        call = f"deformation of rods of lengths {[length for length, _ in rods]}: {name}"
        cause = (
            "abs(length / rod.length - 1), the largest of all: too short counts as well, and as "
        )
        cause += "a share of its own length"
        got = deformed(rods, way)
        expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-12)
    call, cause = "deformation([])", "without rods nothing is deformed: 0"
    expect_close(call, deformed([], way), 0.0, cause=cause, read=read, tolerance=0.0)
