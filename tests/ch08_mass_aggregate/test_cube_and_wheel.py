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
        (8, 18, "Eight corners have 24 degrees of freedom, and a rigid body has 6: 24 - 6 rods."),
        (3, 3, "A triangle is rigid: three particles need three rods."),
        (2, 1, "Two particles need one rod. The formula 3 n - 6 does not hold for them."),
        (1, 0, "A single particle is rigid without a rod."),
        (4, 6, "A tetrahedron is rigid: four particles need six rods."),
    ):
        about(f"fewest_rods({count})", cause=cause)
        got = fewest_rods(count)
        if count == 8:
            mistakes = [
                (
                    24,
                    "The result is all 24 degrees of freedom of the eight corners. A rigid body "
                    "keeps six of them.",
                ),
                (
                    13,
                    "The result is 2 n - 3, which holds for a flat figure. In space the number is "
                    "3 n - 6.",
                ),
                (
                    21,
                    "The result is 3 n - 3. A rigid body can move in three ways and rotate in "
                    "three.",
                ),
            ]
            blame(got, mistakes)
        expect_exactly(got, wanted)
    count = rng.randint(9, 99)
    about.call = f"fewest_rods({count})"
    about.cause = "Each particle has three degrees of freedom. Subtract the six of a rigid body."
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
            cause="count must be a whole number of 1 or more.",
        )


@pytest.mark.exercise("8.2", weight=2)
def test_the_cube_is_rigid() -> None:
    about(
        "cube_rods()", cause="Each rod must be a pair of different indices from 0 to 7.", read=CUBE
    )
    rods = cube_rods()
    wrong = [
        rod
        for rod in rods
        if len(rod) != 2 or not all(type(i) is int and 0 <= i < 8 for i in rod) or rod[0] == rod[1]
    ]
    expect_exactly(wrong, [], then=": the rods that are not such a pair")
    left = motions(CORNERS, rods, HELD)
    different = len({tuple(sorted(rod)) for rod in rods})
    about.cause = f"You have {different} different rods, but only {18 - len(left)} of the 18 "
    about.cause += "internal motions are prevented."
    if left:
        about.cause += f" This motion is still possible: {told(left[0], 'corner')}."
    expect_exactly(
        len(left), 0, then=": the number of motions they allow, besides those of a rigid body"
    )


def draw_rim(rng: Random, count: int) -> tuple[tuple[float, float, float], list]:
    """Draw a hub, and a rim around it whose radius is not the same everywhere."""
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
    hub, rim = draw_rim(rng, count)
    about(f"rods_of(hub, a rim of {count}): the ends of the rods (the hub is 0)", read=WHEEL)
    about.cause = "Join the hub to each rim particle, each rim particle to the next, and the last "
    about.cause += "one to the first."
    rods = sorted(wheel_rods(hub, rim))
    wanted = [(0, i + 1) for i in range(count)] + [(i, i + 1) for i in range(1, count)]
    wanted = sorted([*wanted, (1, count)])
    got = [(i, j) for i, j, _ in rods]
    if missing := [pair for pair in wanted if pair not in got]:
        about.cause = f"The rod {missing[0]} is missing. {about.cause}"
    expect_exactly(got, wanted)
    about.cause = "The length of a rod is the current distance between its two ends."
    places = [hub, *rim]
    for i, j, length in rods:
        about.call = f"rods_of(hub, rim): the length of the rod from {places[i]} to {places[j]}"
        wanted = math.dist(places[i], places[j])
        expect_close(length, wanted, tolerance=1e-12)


@pytest.mark.exercise("8.3b")
def test_the_drive_pushes_round_the_hub(rng: Random) -> None:
    about.read = DRIVE
    hub, force, already = components(rng), number(rng), components(rng)
    about.cause = "The force is F (-sin, cos, 0) of the spoke's angle in the X-Y plane. It is at a "
    about.cause += "right angle to the spoke and has the same size at every distance."
    about.call = "RimDrive(hub at (1, 2, 3), 10).update_force(particle, 0.1), the particle at (4, "
    about.call += "6, 15)"
    got, _ = driven((1.0, 2.0, 3.0), 10.0, [(4.0, 6.0, 15.0)], (0.0, 0.0, 0.0))[0]
    mistakes = [
        ((6.0, 8.0, 0.0), "This force acts along the spoke. Rotate (x, y) by a right angle: (-y, "
                          "x)."),
        ((8.0, -6.0, 0.0), "This force drives the rim clockwise. Use (-y, x) instead of (y, -x)."),
        ((-40.0, 30.0, 0.0), "The force grows with the distance. Divide (-y, x) by the spoke's "
         "length."),
        ((6.0, 8.0, 24.0), "This force acts along the spoke and along Z. Use (-y, x, 0)."),
        ((-40.0 / 13.0, 30.0 / 13.0, 0.0), "Use the length in the X-Y plane, sqrt(x^2 + y^2)."),
        ((-60.0 / math.sqrt(52.0), 40.0 / math.sqrt(52.0), 0.0), "This force acts around the "
                                                                 "origin. Use the position "
                                                                 "relative to the hub."),
    ]  # fmt: skip
    seen = cause_of(got, mistakes, about.cause)
    expect_close(got, (-8.0, 6.0, 0.0), cause=seen)
    places, wanted = [], []
    for most in (0.1, 0.9, 3.0):  # less than 1 m as well as more
        angle, radius = positive_number(rng, 0.1, 6.0), positive_number(rng, 0.01, most)
        c, s = math.cos(angle), math.sin(angle)
        places.append((hub[0] + radius * c, hub[1] + radius * s, hub[2] + number(rng)))
        wanted.append((already[0] - force * s, already[1] + force * c, already[2]))
    about.call = f"RimDrive(hub at {hub}, {force}).update_force(particle, 0.1), after "
    about.call += f"particle.add_force(Vector3{already}); the particle at "
    done = driven(hub, force, places, already)
    for place, force_of_all, (got, after) in zip(places, wanted, done, strict=True):
        # The angle of a spoke of a centimeter is rounded to 1e-13.
        name = f"{about.call}{place}"
        expect_close(got, force_of_all, call=name, tolerance=1e-11)
        name = f"{about.call}{place}: its position afterward"
        moves = "update_force must not move the particle. Compute with a new vector."
        expect_close(after, place, call=name, cause=moves, tolerance=0.0)
    about.cause = "At the hub, and exactly in front of it, there is no direction, so add no force."
    start = about.call
    for place in (hub, (hub[0], hub[1], hub[2] + 1.0)):
        about.call = f"{start}{place}"
        got = driven(hub, force, [place], already)[0][0]
        expect_close(got, already, tolerance=0.0)


@pytest.mark.exercise("8.3b")
def test_the_spin_is_that_of_the_whole_rim(rng: Random) -> None:
    hub, rim = draw_rim(rng, 5)
    drift, rate = components(rng), number(rng)
    masses = [positive_number(rng) for _ in rim]
    moving = [
        (drift[0] - rate * (y - hub[1]), drift[1] + rate * (x - hub[0]), drift[2])
        for x, y, _ in rim
    ]
    about.call = f"spin(hub, rim) of a rim that rotates at {rate} rad/s about a hub that moves at "
    about.call += f"{drift} m/s"
    about(cause="Take positions and velocities relative to the hub.", read=SPIN)
    got = spun((hub, drift), list(zip(rim, moving, masses, strict=True)))
    seen = [(x - hub[0], y - hub[1]) for x, y, _ in rim]
    parts = list(zip(masses, seen, strict=True))
    inertia = math.fsum(m * (x * x + y * y) for m, (x, y) in parts)
    drifting = math.fsum(m * (x * drift[1] - y * drift[0]) for m, (x, y) in parts)
    mistakes = [
        (-rate, "The sign is wrong. Counter-clockwise is positive: x v_y - y v_x."),
        (
            rate * inertia,
            "The result is the angular momentum. Divide it by the sum of m (x^2 + y^2).",
        ),
        (rate + drifting / inertia, "Subtract the hub's velocity, because the hub moves, too."),
    ]
    blame(got, mistakes)
    expect_close(got, rate, tolerance=1e-12)
    about.call = "spin(hub, rim) of 1 kg at (1, 0, 0), velocity (0, 2, 0), and 3 kg at (0, 2, 0), "
    about.call += "velocity (-2, 0, 0), the hub at rest at (0, 0, 0)"
    about.cause = "The sum of m (x v_y - y v_x) is 14, and the sum of m (x^2 + y^2) is 13."
    one, two = ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), 1.0), ((0.0, 2.0, 0.0), (-2.0, 0.0, 0.0), 3.0)
    got = spun(((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), [one, two])
    mistakes = [
        (1.2, "The masses are missing in both sums. Multiply each term by m."),
        (1.5, "The result is the mean of the particles' rates. Divide the two sums instead."),
        (2.0, "The distance is not squared. The sum of m (x^2 + y^2) is 13."),
        (14.0, "The result is the angular momentum. Divide it by the sum of m (x^2 + y^2)."),
    ]
    blame(got, mistakes)
    expect_close(got, 14.0 / 13.0)
    v = [components(rng) for _ in rim]
    turning = math.fsum(
        m * (x * w[1] - y * w[0]) for m, (x, y), w in zip(masses, seen, v, strict=True)
    )
    about.call = f"spin(hub, rim), the hub at rest at {hub}; "
    about.call += "; ".join(
        f"{m} kg at ({x:.6g}, {y:.6g}, {z:.6g}), velocity {w}"
        for m, (x, y, z), w in zip(masses, rim, v, strict=True)
    )
    about.cause = "Divide the sum of m (x v_y - y v_x) by the sum of m (x^2 + y^2), where "
    about.cause += "x and y are relative to the hub."
    got = spun((hub, (0.0, 0.0, 0.0)), list(zip(rim, v, masses, strict=True)))
    expect_close(got, turning / inertia, tolerance=1e-12)
    about.cause = "If the moment of inertia is 0, return 0."
    for where, rim in (("no particles", []), ("one at the hub", [(hub, components(rng), 2.0)])):
        about.call = f"spin(hub, rim) of a rim of {where}"
        expect_close(spun((hub, drift), rim), 0.0, tolerance=0.0)


@pytest.mark.exercise("8.3c")
def test_the_deformation_is_that_of_the_worst_rod(rng: Random) -> None:
    about.read = DEFORMATION
    way = direction(rng)
    a, b, c = (positive_number(rng, 1.0, 3.0) for _ in range(3))
    for name, rods, wanted in (
        ("5 % too long, and exact", [(a, 1.05 * a), (b, b)], 0.05),
        ("7 % too short, and 2 % too long", [(a, 0.93 * a), (b, 1.02 * b)], 0.07),
        ("1 %, 4 % and 2 % too long", [(a, 1.01 * a), (b, 1.04 * b), (c, 1.02 * c)], 0.04),
    ):
        about.call = f"deformation of rods of lengths {[length for length, _ in rods]}, {name}"
        about.cause = "Return the largest abs(length / rod.length - 1) of all rods."
        got = deformed(rods, way)
        shares = [now / length - 1.0 for length, now in rods]
        mistakes = [
            (max(abs(now - length) for length, now in rods),
             "The result is in m. Divide it by rod.length."),
            (math.fsum(map(abs, shares)) / len(shares),
             "The result is the mean. Return the largest value."),
            (max(shares), "A rod that is too short counts, too. Take abs() of each value."),
            (1.0 + max(shares), "The result is length / rod.length. Return its difference from 1."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12)
    about("deformation([])", cause="Without rods nothing is deformed. Return 0.")
    expect_close(deformed([], way), 0.0, tolerance=0.0)
