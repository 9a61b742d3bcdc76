"""Mini-projects 8.2, a cube of rods, and 8.3, a wheel."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.cube import fewest_rods
from ch08_mass_aggregate.scene_probes import (
    cube_rods,
    deformed,
    driven,
    places_after,
    spun,
    wheel_rods,
)
from draw import components, direction, number, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly, expect_that
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


@pytest.mark.exercise("8.2", asks="the smallest number of rods that can make")
def test_how_many_rods_are_necessary(rng: Random) -> None:
    about.read = FEWEST
    for count, wanted, cause in (
        (
            8,
            18,
            "Eight corners have 24 degrees of freedom, and a rigid body keeps 6 of them. Each "
            "rod removes one, so you need at least 24 - 6 rods.",
        ),
        (3, 3, "A triangle of three rods is rigid, so three particles need three rods."),
        (
            2,
            1,
            "Two particles need one rod. Handle this case separately, because the formula 3 n - 6 "
            "holds only for three or more particles.",
        ),
        (1, 0, "A single particle has no distance to keep, so it needs no rod."),
        (4, 6, "A tetrahedron of six rods is rigid, so four particles need six rods."),
    ):
        about(f"fewest_rods({count})", cause=cause)
        got = fewest_rods(count)
        if count == 8:
            mistakes = [
                (24, "You return 24, which counts all degrees of freedom of the eight corners. "
                     "Subtract the 6 of a rigid body, which no rod can remove."),
                (13, "You return 2 n - 3, which holds for particles in a plane. In space, use 3 n "
                     "- 6."),
                (21, "You return 3 n - 3. A rigid body can move in three directions and also "
                     "rotate about three axes, so subtract 6 instead of 3."),
            ]  # fmt: skip
            blame(got, mistakes)
        expect_exactly(got, wanted, unit="rods")
    count = rng.randint(9, 99)
    about.call = f"fewest_rods({count})"
    about.cause = "Each particle has three degrees of freedom, and a rigid body keeps six in "
    about.cause += "total. Each rod removes one, so the number is 3 n - 6."
    expect_exactly(fewest_rods(count), 3 * count - 6, unit="rods")


@pytest.mark.exercise("8.2", asks="move and rotate only as a whole", weight=2)
def test_the_cube_is_rigid() -> None:
    about(
        "cube_rods()",
        cause="Each rod must be a pair of two different corners, numbered from 0 to 7.",
        read=CUBE,
    )
    rods = cube_rods()
    wrong = [
        rod
        for rod in rods
        if len(rod) != 2 or not all(type(i) is int and 0 <= i < 8 for i in rod) or rod[0] == rod[1]
    ]
    if any(8 in rod for rod in wrong):
        about.cause = "There is no corner 8. Number the corners from 0 to 7 instead of 1 to 8."
    expect_that(not wrong, f"the rods {wrong}", "only pairs of corners from 0 to 7")
    left = motions(CORNERS, rods, HELD)
    different = len({tuple(sorted(rod)) for rod in rods})
    faces = [
        (axis, i & axis)
        for i, j in {tuple(sorted(rod)) for rod in rods}
        for axis in (1, 2, 4)
        if i ^ j == 7 - axis
    ]
    if left and len(rods) > different:
        about.cause = f"You list a rod twice, so you have only {different} different rods. Replace "
        about.cause += "the duplicate with a rod that is missing."
    elif different < 18:
        about.cause = f"You have only {different} rods, but a rigid cube needs at least 18. Add "
        about.cause += f"rods to stop motions such as this one: {told(left[0], 'corner')}."
    elif left:
        about.cause = "One of your rods is redundant. Move it"
        if len(set(faces)) < len(faces):
            about.cause = "Two of your diagonals are in the same face. Move one of them to another "
            about.cause += "face"
        about.cause += f" to stop this motion: {told(left[0], 'corner')}."
    expect_exactly(
        len(left),
        0,
        then="; the number of independent ways to deform the cube without changing a rod's length",
        unit="ways",
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


@pytest.mark.exercise("8.3a", asks="A spoke joins the hub to each of them")
@pytest.mark.parametrize("count", [3, 8])
def test_a_wheel_has_spokes_and_a_rim(rng: Random, count: int) -> None:
    hub, rim = draw_rim(rng, count)
    setup = f"a wheel whose hub is particle 0, with particles 1 to {count} around it as the rim; "
    about(f"{setup}rods_of(hub, rim); the two ends of each rod", read=WHEEL)
    about.cause = "Join the hub to each particle of the rim, each particle of the rim to the next "
    about.cause += "one, and the last one to the first. (i + 1) % len(rim) is the index of the "
    about.cause += "next particle: after the last index, it is 0."
    after = places_after("wheel", [hub, *rim])
    expect_all_kept("the position of particle {}", after, [hub, *rim])
    rods = sorted(wheel_rods(hub, rim))
    wanted = [(0, i + 1) for i in range(count)] + [(i, i + 1) for i in range(1, count)]
    wanted = sorted([*wanted, (1, count)])
    got = [(i, j) for i, j, _ in rods]
    missing = [pair for pair in wanted if pair not in got]
    if missing == [(1, count)]:
        about.cause = "Your rim is not closed. Also join its last particle to its first one."
    elif missing and missing == wanted[:count]:
        about.cause = "You create no spokes. Join the hub to each particle of the rim."
    elif missing and missing == wanted[count:]:
        about.cause = "You create only the spokes. Also join each particle of the rim to the next "
        about.cause += "one, and the last one to the first."
    expect_exactly(got, wanted)
    about.cause = "Your rod has the wrong length. Make it as long as the current distance between "
    about.cause += "its two ends."
    if len({length for *_, length in rods}) == 1:
        about.cause = "You give all rods the same length. Make each rod as long as the current "
        about.cause += "distance between its two ends."
    places = [hub, *rim]
    for i, j, length in rods:
        about.call = f"{setup}rods_of(hub, rim); the length of the rod from particle {i} to "
        about.call += f"particle {j}"
        wanted = math.dist(places[i], places[j])
        expect_close(length, wanted, unit="m", tolerance=1e-12)


@pytest.mark.exercise("8.3b", asks="at a right angle to its spoke")
def test_the_drive_pushes_around_the_hub(rng: Random) -> None:
    about.read = DRIVE
    hub, force, already = components(rng), number(rng), components(rng)
    about.cause = "Take the unit vector along the spoke in the X-Y plane, rotate it by a right "
    about.cause += "angle, and multiply it by the force. The force is equally strong at every "
    about.cause += "distance from the hub."
    about.call = (
        "a drive with a force of 10 N, whose hub is at (1, 2, 3) m; a particle of the rim at (4, "
        "6, 15) m; drive.update_force(particle, 0.1); the force on the particle"
    )
    got, _ = driven((1.0, 2.0, 3.0), 10.0, [(4.0, 6.0, 15.0)], (0.0, 0.0, 0.0))[0]
    mistakes = [
        ((6.0, 8.0, 0.0), "Your force acts along the spoke, so it can't turn the wheel. Rotate the "
                          "direction (x, y) by a right angle to (-y, x)."),
        ((8.0, -6.0, 0.0), "Your force drives the wheel clockwise. If the spoke is (x, y), "
                           "use (-y, x) instead of (y, -x)."),
        ((-40.0, 30.0, 0.0), "Your force grows with the distance from the hub. Divide the "
                             "direction by its length before you multiply it by the force."),
        ((6.0, 8.0, 24.0), "Your force acts along the spoke, so it can't turn the wheel. If the "
                           "spoke is (x, y, z), use the direction (-y, x, 0)."),
        ((-40.0 / 13.0, 30.0 / 13.0, 0.0), "You divided the direction by a length that includes z. "
                                           "Divide by sqrt(x^2 + y^2), because the wheel "
                                           "rotates in the X-Y plane."),
        ((-60.0 / math.sqrt(52.0), 40.0 / math.sqrt(52.0), 0.0),
         "You measure the spoke from the origin instead of the hub. Subtract the hub's position "
         "from the particle's."),
    ]  # fmt: skip
    seen = cause_of(got, mistakes, about.cause)
    expect_close(got, (-8.0, 6.0, 0.0), unit="N", cause=seen)
    places, wanted = [], []
    for most in (0.1, 0.9, 3.0):  # less than 1 m as well as more
        angle, radius = positive_number(rng, 0.1, 6.0), positive_number(rng, 0.01, most)
        c, s = math.cos(angle), math.sin(angle)
        places.append((hub[0] + radius * c, hub[1] + radius * s, hub[2] + number(rng)))
        wanted.append((already[0] - force * s, already[1] + force * c, already[2]))
    about.call = (
        f"a drive with a force of {force} N, whose hub is at {hub} m; "
        f"particle.add_force(Vector3{already}); drive.update_force(particle, 0.1); the force on "
        "the particle, which is at "
    )
    done = driven(hub, force, places, already)
    for place, force_of_all, (got, after) in zip(places, wanted, done, strict=True):
        # The angle of a spoke of a centimeter is rounded to 1e-13.
        name = f"{about.call}{place} m"
        expect_close(got, force_of_all, call=name, unit="N", tolerance=1e-11)
        name = f"{about.call}{place} m; its position afterward"
        moves = (
            "Your update_force moves the particle, although it should only add a force. The "
            "operator -= changes a position in place, so work with a new vector."
        )
        expect_close(after, place, call=name, cause=moves, unit="m", tolerance=0.0)
    start = about.call
    for place in (hub, (hub[0], hub[1], hub[2] + 1.0)):
        where = "is at the hub" if place == hub else "differs from the hub only along Z"
        about.cause = f"The particle {where}, so its spoke has no direction in the X-Y plane. Add "
        about.cause += "no force in this case."
        about.call = f"{start}{place} m"
        got = driven(hub, force, [place], already)[0][0]
        expect_close(got, already, unit="N", tolerance=0.0)


@pytest.mark.exercise("8.3b", asks="angular momentum of the rim divided by")
def test_the_spin_is_that_of_the_whole_rim(rng: Random) -> None:
    hub, rim = draw_rim(rng, 5)
    drift, rate = components(rng), number(rng)
    masses = [positive_number(rng) for _ in rim]
    moving = [
        (drift[0] - rate * (y - hub[1]), drift[1] + rate * (x - hub[0]), drift[2])
        for x, y, _ in rim
    ]
    about.call = (
        f"a hub at {tuple(round(one, 3) for one in hub)} m that moves at {drift} m/s; a rim that "
        f"rotates about it at {rate} rad/s; spin(hub, rim)"
    )
    about(
        cause="Divide the angular momentum by the moment of inertia. The hub moves, so subtract "
        "its position and velocity from those of each particle.",
        read=SPIN,
    )
    after = places_after("spin", [hub, *rim])
    expect_kept("hub.position", after[0], hub)
    expect_all_kept("the position of rim[{}]", after[1:], rim)
    got = spun((hub, drift), list(zip(rim, moving, masses, strict=True)))
    seen = [(x - hub[0], y - hub[1]) for x, y, _ in rim]
    parts = list(zip(masses, seen, strict=True))
    placed = list(zip(rim, parts, strict=True))
    inertia = math.fsum(m * (x * x + y * y) for m, (x, y) in parts)
    drifting = math.fsum(m * (x * drift[1] - y * drift[0]) for m, (x, y) in parts)
    mistakes = [
        (-rate, "Your spin has the wrong sign. A counter-clockwise rotation counts as positive, so "
                "the angular momentum is the sum of m (x v_y - y v_x)."),
        (rate * inertia,
         "You return the angular momentum of the rim. Divide it by the moment of inertia, the sum "
         "of m (x^2 + y^2), to get the spin."),
        (rate * inertia / math.fsum(m * (x + y) for m, (x, y) in parts),
         "Your moment of inertia is the sum of m (x + y). Square the coordinates: it is the sum of "
         "m (x^2 + y^2)."),
        (rate + drifting / inertia, "You count the hub's velocity as part of the rotation. "
                                    "Subtract it from the velocity of each particle."),
        (rate * math.fsum(m * (x * p[0] + y * p[1]) for p, (m, (x, y)) in placed)
         / math.fsum(m * (p[0] ** 2 + p[1] ** 2) for p, (m, _) in placed),
         "You measure the positions from the origin instead of the hub. Subtract the hub's "
         "position from that of each particle."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, rate, unit="rad/s", tolerance=1e-12)
    about.call = (
        "a hub at rest at (0, 0, 0) m; a rim particle of 1 kg at (1, 0, 0) m with velocity (0, 2, "
        "0) m/s; a rim particle of 3 kg at (0, 2, 0) m with velocity (-2, 0, 0) m/s; spin(hub, rim)"
    )
    about.cause = "Divide the angular momentum, the sum of m (x v_y - y v_x), by the moment of "
    about.cause += "inertia, the sum of m (x^2 + y^2). Here they are 14 and 13."
    one, two = ((1.0, 0.0, 0.0), (0.0, 2.0, 0.0), 1.0), ((0.0, 2.0, 0.0), (-2.0, 0.0, 0.0), 3.0)
    got = spun(((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)), [one, two])
    mistakes = [
        (1.2, "You leave out the masses. Multiply each particle's term by its mass, both in the "
              "angular momentum and in the moment of inertia."),
        (1.5, "You return the mean of the particles' angular velocities. Divide the sum of m (x "
              "v_y - y v_x) by the sum of m (x^2 + y^2) instead."),
        (2.0, "You didn't square the distance from the hub in the moment of inertia. It is the sum "
              "of m (x^2 + y^2), which is 13 here."),
        (14.0, "You return the angular momentum of the rim. Divide it by the moment of inertia, "
               "the sum of m (x^2 + y^2), to get the spin."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, 14.0 / 13.0, unit="rad/s")
    v = [components(rng) for _ in rim]
    turning = math.fsum(
        m * (x * w[1] - y * w[0]) for m, (x, y), w in zip(masses, seen, v, strict=True)
    )
    about.call = f"spin(hub, rim) with the hub at rest at {hub} m; "
    about.call += "; ".join(
        f"{m} kg at ({x:.6g}, {y:.6g}, {z:.6g}) m with velocity {w} m/s"
        for m, (x, y, z), w in zip(masses, rim, v, strict=True)
    )
    about.cause = "Divide the angular momentum, the sum of m (x v_y - y v_x), by the moment of "
    about.cause += "inertia, the sum of m (x^2 + y^2). In both sums, x and y are relative to the "
    about.cause += "hub."
    got = spun((hub, (0.0, 0.0, 0.0)), list(zip(rim, v, masses, strict=True)))
    expect_close(got, turning / inertia, unit="rad/s", tolerance=1e-12)
    for where, rim in (
        ("The rim has no particles", []),
        ("The only particle of the rim is at the hub", [(hub, components(rng), 2.0)]),
    ):
        about.call = f"spin(hub, rim) with {'one particle' if rim else 'no particles'} in the rim"
        about.cause = f"{where}, so the moment of inertia is 0. Return 0 instead of dividing by it."
        expect_close(spun((hub, drift), rim), 0.0, tolerance=0.0)


@pytest.mark.exercise("8.3c", asks="the largest relative error in the length")
def test_the_deformation_is_that_of_the_worst_rod(rng: Random) -> None:
    about.read = DEFORMATION
    way = direction(rng)
    ends = [components(rng), components(rng)]
    about.call = "deformation([rod]), where a and b are the ends of the rod"
    after = places_after("deformation", ends)
    expect_kept("a.position", after[0], ends[0])
    expect_kept("b.position", after[1], ends[1])
    a, b, c = (positive_number(rng, 1.0, 3.0) for _ in range(3))
    for name, rods, wanted in (
        (
            "the first is 5% too long, and the second has the right length",
            [(a, 1.05 * a), (b, b)],
            0.05,
        ),
        (
            "the first is 7% too short, and the second is 2% too long",
            [(a, 0.93 * a), (b, 1.02 * b)],
            0.07,
        ),
        ("they are 1%, 4% and 2% too long", [(a, 1.01 * a), (b, 1.04 * b), (c, 1.02 * c)], 0.04),
    ):
        *lengths, last = (f"{length}" for length, _ in rods)
        about.call = f"rods that should have lengths of {', '.join(lengths)} and {last} m; at the "
        about.call += f"moment, {name}; deformation(rods)"
        about.cause = "Return the largest deformation of any rod, where the deformation of a rod "
        about.cause += "is abs(length / rod.length - 1)."
        got = deformed(rods, way)
        shares = [now / length - 1.0 for length, now in rods]
        mistakes = [
            (max(abs(now - length) for length, now in rods),
             "You return the largest error in meters. Divide each error by rod.length, so that "
             "long and short rods count the same."),
            (math.fsum(map(abs, shares)) / len(shares),
             "You return the mean of the errors, which hides a single rod that is far off. Return "
             "the largest error instead."),
            (max(shares), "You overlook the rods that are too short, because their errors are "
                          "negative. Take abs() of each error before you look for the largest."),
            (1.0 + max(shares), "You return the ratio length / rod.length, which is 1 for a rod of "
                                "the right length. Subtract 1 to get the error."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12)
    about(
        "deformation([])",
        cause="There are no rods, so there is no largest error. Return 0 in this case.",
    )
    expect_close(deformed([], way), 0.0, tolerance=0.0)
