"""Mini-projects 8.2, a cube of rods, and 8.3, a wheel."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.cube import fewest_rods
from ch08_mass_aggregate.scene_probes import cube_rods, deformed, driven, spun, wheel_rods
from draw import components, direction, number, positive_number
from expect import about, blame, cause_of, expect_close, expect_error, expect_exactly
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
    about.read = FEWEST
    for count, wanted, cause in (
        (8, 18, "eight corners move in 24 ways, a rigid body in 6: 24 - 6 rods"),
        (3, 3, "a triangle"),
        (2, 1, "two particles and a rod"),
        (1, 0, "one particle is rigid by itself"),
        (4, 6, "a tetrahedron"),
    ):
        about(f"fewest_rods({count})", cause=cause)
        got = fewest_rods(count)
        if count == 8:
            mistakes = [
                (24, "that is all the ways in which eight corners move: a rigid body keeps six"),
                (13, "that is 2 n - 3, of a flat figure: in space it is 3 n - 6"),
                (21, "that is 3 n - 3: a rigid body moves in three ways, and turns in three"),
            ]
            blame(got, mistakes)
        expect_exactly(got, wanted)
    count = rng.randint(9, 99)
    about.call = f"fewest_rods({count})"
    about.cause = "three for each particle, less the six motions of a rigid body"
    expect_exactly(fewest_rods(count), 3 * count - 6)


@pytest.mark.exercise("8.2")
@pytest.mark.robust
def test_a_number_of_particles_is_1_or_more() -> None:
    about.read = FEWEST
    for bad, error in ((0, ValueError), (-3, ValueError), (8.0, TypeError), ("8", TypeError)):
        expect_error(
            lambda bad=bad: fewest_rods(bad),
            error,
            call=f"fewest_rods({bad!r})",
            allowed=lambda: fewest_rods(8),
            cause="there are 1, 2, 3 or more particles",
        )


@pytest.mark.exercise("8.2", weight=2)
def test_the_cube_is_rigid() -> None:
    about("cube_rods()", cause="each rod is a pair of two different numbers from 0 to 7", read=CUBE)
    rods = cube_rods()
    wrong = [
        rod
        for rod in rods
        if len(rod) != 2 or not all(type(i) is int and 0 <= i < 8 for i in rod) or rod[0] == rod[1]
    ]
    expect_exactly(wrong, [], then=": what is no pair of corners")
    left = motions(CORNERS, rods, HELD)
    different = len({tuple(sorted(rod)) for rod in rods})
    about.cause = f"{different} different rods, of which {18 - len(left)} count, where 18 are "
    about.cause += "needed"
    if left:
        about.cause += f"; they leave this motion: {told(left[0], 'corner')}"
    expect_exactly(
        len(left), 0, then=": how many motions they leave, besides those of a rigid body"
    )


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
    about.read = WHEEL
    hub, rim = draw_rim(rng, count)
    about.call = f"rods_of(hub, a rim of {count}); the ends of its rods, where the hub is number 0"
    about.cause = "a spoke from the hub to each, and a rod from each to the next, and from the "
    about.cause += "last to the first"
    rods = sorted(wheel_rods(hub, rim))
    wanted = [(0, i + 1) for i in range(count)] + [(i, i + 1) for i in range(1, count)]
    wanted = sorted([*wanted, (1, count)])
    got = [(i, j) for i, j, _ in rods]
    if missing := [pair for pair in wanted if pair not in got]:
        about.cause = f"{missing[0]} is missing: {about.cause}"
    expect_exactly(got, wanted)
    about.cause = "each rod is as long as its ends are apart now"
    places = [hub, *rim]
    for i, j, length in rods:
        about.call = f"rods_of(hub, rim); the length of the rod from {places[i]} to {places[j]}"
        wanted = math.dist(places[i], places[j])
        expect_close(length, wanted, tolerance=1e-12)


@pytest.mark.exercise("8.3b")
def test_the_drive_pushes_round_the_hub(rng: Random) -> None:
    about.read = DRIVE
    hub, force, already = components(rng), number(rng), components(rng)
    about.cause = "the force is F (-sin, cos, 0) of the spoke's angle in the X-Y plane: a right "
    about.cause += "angle to it, counter-clockwise, and of the same size at every distance"
    about.call = "RimDrive(hub at (1, 2, 3), 10).update_force(particle, 0.1), the particle at (4, "
    about.call += "6, 15)"
    got, _ = driven((1.0, 2.0, 3.0), 10.0, [(4.0, 6.0, 15.0)], (0.0, 0.0, 0.0))[0]
    mistakes = [
        ((6.0, 8.0, 0.0), "that is along the spoke: (-y, x) is (x, y) turned by a right angle"),
        ((8.0, -6.0, 0.0), "that is clockwise: (-y, x) is counter-clockwise, where (y, -x) is not"),
        ((-40.0, 30.0, 0.0), "it grows with the distance: divide (-y, x) by the spoke's length"),
        ((6.0, 8.0, 24.0), "that is along the spoke, and along Z: (-y, x) is turned, in the plane"),
        ((-40.0 / 13.0, 30.0 / 13.0, 0.0), "the length is that in the X-Y plane, sqrt(x^2 + y^2)"),
        (
            (-60.0 / math.sqrt(52.0), 40.0 / math.sqrt(52.0), 0.0),
            "that is round the origin: the spoke is seen from the hub",
        ),
    ]
    seen = cause_of(got, mistakes, about.cause)
    expect_close(got, (-8.0, 6.0, 0.0), cause=seen)
    places, wanted = [], []
    for most in (0.1, 0.9, 3.0):  # inside of 1 m as well as outside
        angle, radius = positive_number(rng, 0.1, 6.0), positive_number(rng, 0.01, most)
        c, s = math.cos(angle), math.sin(angle)
        places.append((hub[0] + radius * c, hub[1] + radius * s, hub[2] + number(rng)))
        wanted.append((already[0] - force * s, already[1] + force * c, already[2]))
    about.call = f"RimDrive(hub at {hub}, {force}).update_force(particle, 0.1), after "
    about.call += f"particle.add_force(Vector3{already}); the particle at "
    done = driven(hub, force, places, already)
    for place, force_of_all, (got, after) in zip(places, wanted, done, strict=True):
        # The angle of a spoke of a centimetre is rounded to 1e-13.
        expect_close(got, force_of_all, then=f"{place}", tolerance=1e-11)
        moves = "a force moves nothing by itself: work on a new vector"
        expect_close(after, place, then=f"{place}; its place then", cause=moves, tolerance=0.0)
    about.cause = "at the hub, and right before it, there is no direction, and no force"
    for place in (hub, (hub[0], hub[1], hub[2] + 1.0)):
        got = driven(hub, force, [place], already)[0][0]
        expect_close(got, already, then=f"{place}", tolerance=0.0)


@pytest.mark.exercise("8.3b")
def test_the_spin_is_that_of_the_whole_rim(rng: Random) -> None:
    about.read = SPIN
    hub, rim = draw_rim(rng, 5)
    drift, rate = components(rng), number(rng)
    masses = [positive_number(rng) for _ in rim]
    moving = [
        (drift[0] - rate * (y - hub[1]), drift[1] + rate * (x - hub[0]), drift[2])
        for x, y, _ in rim
    ]
    about.call = f"spin(hub, rim) of a rim that turns at {rate} rad/s about a hub that moves at "
    about.call += f"{drift}"
    about.cause = "positions and velocities are those seen from the hub"
    got = spun((hub, drift), list(zip(rim, moving, masses, strict=True)))
    seen = [(x - hub[0], y - hub[1]) for x, y, _ in rim]
    parts = list(zip(masses, seen, strict=True))
    inertia = math.fsum(m * (x * x + y * y) for m, (x, y) in parts)
    drifting = math.fsum(m * (x * drift[1] - y * drift[0]) for m, (x, y) in parts)
    mistakes = [
        (-rate, "the sign is turned round: counter-clockwise is positive, x v_y - y v_x"),
        (rate * inertia, "that is the angular momentum: divide it by the sum of m (x^2 + y^2)"),
        (rate + drifting / inertia, "the hub's velocity is not taken off: it moves as well"),
    ]
    blame(got, mistakes)
    expect_close(got, rate, tolerance=1e-12)
    about.call = "spin(hub, rim) of 1 kg at (1, 0, 0), velocity (0, 2, 0), and 3 kg at (0, 2, 0), "
    about.call += "velocity (-2, 0, 0), the hub at rest at (0, 0, 0)"
    about.cause = "sum of m (x v_y - y v_x), 14, divided by the sum of m (x^2 + y^2), 13"
    one, two = ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), 1.0), ((0.0, 2.0, 0.0), (-2.0, 0.0, 0.0), 3.0)
    got = spun(((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), [one, two])
    mistakes = [
        (1.2, "the masses are left out, above and below"),
        (1.5, "that is the mean of the particles' own rates: sum above and below, and then divide"),
        (2.0, "the distance is squared: the sum of m (x^2 + y^2) is 13"),
        (14.0, "that is the angular momentum: divide it by the sum of m (x^2 + y^2)"),
    ]
    blame(got, mistakes)
    expect_close(got, 14.0 / 13.0)
    v = [components(rng) for _ in rim]
    turning = math.fsum(
        m * (x * w[1] - y * w[0]) for m, (x, y), w in zip(masses, seen, v, strict=True)
    )
    about.call = f"spin(hub, rim) of a rim at {rim}, velocities {v}, masses {masses}, the hub at "
    about.call += "rest"
    about.cause = "sum of m (x v_y - y v_x), divided by the sum of m (x^2 + y^2): mass counts, and "
    about.cause += "so does the square of the distance"
    got = spun((hub, (0.0, 0.0, 0.0)), list(zip(rim, v, masses, strict=True)))
    expect_close(got, turning / inertia, tolerance=1e-12)
    about.cause = "no moment of inertia, no spin: 0"
    for where, rim in (("no particles", []), ("one at the hub", [(hub, components(rng), 2.0)])):
        got = spun((hub, drift), rim)
        about.call = f"spin(hub, rim) of a rim of {where}"
        expect_close(got, 0.0, tolerance=0.0)


@pytest.mark.exercise("8.3c")
def test_the_deformation_is_that_of_the_worst_rod(rng: Random) -> None:
    about.read = DEFORMATION
    way = direction(rng)
    a, b, c = (positive_number(rng, 1.0, 3.0) for _ in range(3))
    for name, rods, wanted in (
        ("too long by 5 %, and a right one", [(a, 1.05 * a), (b, b)], 0.05),
        ("too short by 7 %, and one too long by 2 %", [(a, 0.93 * a), (b, 1.02 * b)], 0.07),
        ("too long by 1 %, 4 %, 2 %", [(a, 1.01 * a), (b, 1.04 * b), (c, 1.02 * c)], 0.04),
    ):
        about.call = f"deformation of rods of lengths {[length for length, _ in rods]}: {name}"
        about.cause = "abs(length / rod.length - 1), the largest of all: too short counts as well, "
        about.cause += "and as a share of its own length"
        got = deformed(rods, way)
        shares = [now / length - 1.0 for length, now in rods]
        mistakes = [
            (max(abs(now - length) for length, now in rods), "that is in m: divide by rod.length"),
            (math.fsum(map(abs, shares)) / len(shares), "that is the mean: the largest is wanted"),
            (max(shares), "too short counts as well: take abs() of each"),
            (1.0 + max(shares), "that is length / rod.length: how far it is from 1 is wanted"),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12)
    about.call, about.cause = "deformation([])", "without rods nothing is deformed: 0"
    expect_close(deformed([], way), 0.0, tolerance=0.0)
