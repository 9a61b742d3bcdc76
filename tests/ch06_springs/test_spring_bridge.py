"""Going further, G6.2: a bridge held up by springs."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch06_springs.probes import hung_bridge, loaded, planks_of_a_new_bridge, settled_bridge
from draw import Components, components, number, positive_number
from expect import about, blame, expect_between, expect_close, named
from unmoved import expect_all_kept

ZERO = (0.0, 0.0, 0.0)
HANG = "the docstring of hang_bridge"
LOAD = "the docstring of load_bridge"


def pull(
    end: tuple[Components, Components],
    other: tuple[Components, Components],
    k: float,
    rest: float,
    c: float,
) -> tuple[float, ...]:
    """Return the force of a spring on one end. Each end is a position and a velocity."""
    offset, velocity = (
        [a - b for a, b in zip(p, q, strict=True)] for p, q in zip(end, other, strict=True)
    )
    length = math.hypot(*offset)
    rate = sum(a * b for a, b in zip(offset, velocity, strict=True)) / length
    return tuple(-(k * (length - rest) + c * rate) / length * part for part in offset)


def draw_places(rng: Random) -> list[Components]:
    y, z = number(rng), number(rng)
    return [(1.5 * i, y + round(rng.uniform(-0.2, 0.2), 3), z) for i in range(5)]


@pytest.mark.exercise("G6.2", asks="so it exerts no force at the start")
def test_a_new_bridge_is_at_rest(rng: Random) -> None:
    about.read = HANG
    places = draw_places(rng)
    numbers = positive_number(rng), positive_number(rng), positive_number(rng)
    hang = "hang_bridge(registry, planks, height={}, stiffness={}, damping={})".format(*numbers)
    about.call = hang
    expect_all_kept("planks[{}].position", planks_of_a_new_bridge(places, numbers), places)
    about.call += "; registry.update_forces(0.5)"
    about.cause = "A spring of your new bridge is stretched. As the rest length, use the height "
    about.cause += "for a hanger and the distance between two planks for the spring that joins "
    about.cause += "them."
    forces = hung_bridge(places, [(place, ZERO) for place in places], numbers)[:-1]
    # Lengths of up to 20 m are 1e-14 m off, times a stiffness of up to 9 N/m.
    height, k, _ = numbers
    for i, force in enumerate(forces):
        x, y, z = places[i]
        slips = {
            "Your hangers have a rest length of 0, so they already pull the planks up at the "
            "start. Use the height as the rest length of each hanger.": [0.0, k * height, 0.0],
            "You swapped the stiffness and the rest length of the hangers. AnchoredSpring takes "
            "the stiffness first.": (0.0, height * (height - k), 0.0),
            "Your anchors are at y = height. Put the anchor of each plank at its own y + height, "
            "straight above it.": (0.0, k * (height - y - height), 0.0)
            if height > y
            else (0.0, k * (height - y + height), 0.0),
            "You put the anchors of all hangers above planks[0]. Put each anchor straight above "
            "its own plank.": pull(
                (places[i], ZERO), ((places[0][0], places[0][1] + height, z), ZERO), k, height, 0.0
            ),
        }
        if i == 0:
            slips[
                "The springs between your planks have a rest length of 0. Use the distance between "
                "the two planks instead."
            ] = [k * (b - a) for a, b in zip(places[0], places[1], strict=True)]
            slips[
                "The springs between your planks have the height as their rest length. Use the "
                "distance between the two planks instead."
            ] = pull((places[0], ZERO), (places[1], ZERO), k, height, 0.0)
        blame(force, slips)
        expect_close(force, ZERO, then=f"; planks[{i}].force_accumulator, in N", tolerance=1e-12)
    about.call = f"{hang} with a single plank; the check lowers this plank by 0.5 m; "
    about.call += "registry.update_forces(0.5)"
    about.cause = "The hanger is stretched by 0.5 m, so it must pull the plank up with 0.5 m times "
    about.cause += "the stiffness. Add one AnchoredSpring for each plank to the registry."
    x, y, z = places[0]
    got = hung_bridge(places[:1], [((x, y - 0.5, z), ZERO)], numbers)
    wanted = (0.0, 0.5 * numbers[1], 0.0)
    none = "No hanger pulls on the lowered plank, although it is 0.5 m too low. Add an "
    none += "AnchoredSpring for each plank to the registry."
    blame(got[0], [(ZERO, none)])
    expect_close(got[0], wanted, then="; planks[0].force_accumulator, in N", tolerance=1e-11)


@pytest.mark.exercise("G6.2", asks="join neighboring planks with springs")
def test_springs_pull_a_moved_plank_back(rng: Random) -> None:
    about.read = HANG
    places = draw_places(rng)
    height, k, c = positive_number(rng, 2.0, 9.0), positive_number(rng), positive_number(rng)
    moved = [tuple(0.05 * part for part in components(rng)) for _ in places]
    after = [
        ((p[0] + m[0], p[1] + m[1], p[2] + m[2]), components(rng))
        for p, m in zip(places, moved, strict=True)
    ]
    about.call = f"hang_bridge(registry, planks, height={height}, stiffness={k}, damping={c}); the "
    about.call += "check moves all planks a little and gives them velocities; "
    about.call += "registry.update_forces(0.5)"
    about.cause = "Hang each plank from one AnchoredSpring whose anchor is straight above it. Then "
    about.cause += "join each plank to the next with one call of connect, which acts on both ends."
    forces = hung_bridge(places, after, (height, k, c))
    for i, end in enumerate(after):
        if i == 2:  # it is immovable, so the force that it receives does not matter
            continue
        x, y, z = places[i]
        parts = [pull(end, ((x, y + height, z), ZERO), k, height, c)]
        for j in (i - 1, i + 1):
            if 0 <= j < len(places):
                parts.append(pull(end, after[j], k, math.dist(places[i], places[j]), c))
        wanted = tuple(math.fsum(part[axis] for part in parts) for axis in range(3))
        below = pull(end, ((x, y - height, z), ZERO), k, height, c)
        ropes = [total - hanger for total, hanger in zip(wanted, parts[0], strict=True)]
        last = pull(end, after[-1], k, math.dist(places[i], places[-1]), c) if i == 0 else ZERO
        slips = {
            "Your hangers pull but never push. Use an AnchoredSpring for each plank instead of an "
            "AnchoredBungee.": ropes,
            "You also connect the last plank to the first one. Connect only planks that are next "
            "to each other.": [total + part for total, part in zip(wanted, last, strict=True)],
            "Your anchors are below the planks. Add the height to y, so that each plank hangs "
            "from an anchor above it.": [
                rope + part for rope, part in zip(ropes, below, strict=True)
            ],
            "Your hangers have no damping. Pass the damping to AnchoredSpring.": [
                rope + part
                for rope, part in zip(
                    ropes, pull(end, ((x, y + height, z), ZERO), k, height, 0.0), strict=True
                )
            ],
            "Only your hangers have an effect, because no springs join the planks to each other. "
            "Call connect for each pair of neighboring planks.": parts[0],
            "Your springs between the planks act twice. A single call to connect already makes "
            "the spring act on both planks, so call connect only once per pair.": [
                total + rope for total, rope in zip(wanted, ropes, strict=True)
            ],
        }
        why = named(forces[i], about.cause, slips)
        expect_close(
            forces[i],
            wanted,
            then=f"; planks[{i}].force_accumulator, in N",
            cause=why,
            tolerance=1e-11,
        )
    about.cause = "The registry already held another spring, which must keep acting. Add your "
    about.cause += "springs without clearing the registry."
    expect_close(
        forces[-1],
        (0.0, -2.0, 0.0),
        then="; the force in N of another spring that was in the registry before",
    )


@pytest.mark.exercise("G6.2", asks="these two carry 1 - s and s of the weight")
def test_a_walker_is_carried_by_the_planks_beside_him(rng: Random) -> None:
    about.read = LOAD
    places = [(-1.5, 0.0, 0.0), (-0.5, 0.5, 0.0), (1.5, 0.0, 1.0)]
    weight = positive_number(rng, 1.0, 900.0)
    for x, shares, cause in (
        (
            -1.25,
            (0.75, 0.25, 0.0),
            "The two planks beside the person carry the wrong fractions of the weight. They must "
            "carry 1 - s and s, so that the nearer plank carries more.",
        ),
        (
            1.0,
            (0.0, 0.25, 0.75),
            "The fraction s must go from 0 at one plank to 1 at the next. Divide the person's "
            "distance from the first of these planks by the gap between them, which is 2 m here.",
        ),
        (
            -0.5,
            (0.0, 1.0, 0.0),
            "The person is exactly on a plank, so this plank must carry the whole weight.",
        ),
        (
            -7.0,
            (1.0, 0.0, 0.0),
            "The person is before the first plank, so the first plank must carry the whole "
            "weight. Clamp x to the range from the first plank to the last.",
        ),
        (
            9.0,
            (0.0, 0.0, 1.0),
            "The person is beyond the last plank, so the last plank must carry the whole weight. "
            "Clamp x to the range from the first plank to the last.",
        ),
        (
            -1.5,
            (1.0, 0.0, 0.0),
            "The person is exactly on the first plank, which must carry the whole weight. There "
            "is no plank before it.",
        ),
        (
            1.5,
            (0.0, 0.0, 1.0),
            "The person is exactly on the last plank, which must carry the whole weight. There "
            "is no plank after it.",
        ),
    ):
        about(
            f"planks at x = -1.5, -0.5 and 1.5; load_bridge(planks, x={x}, weight={weight})",
            cause=cause,
        )
        forces = loaded(places, x, weight)
        got = [force[1] - 2.0 for force in forces]
        wanted = [-weight * share for share in shares]
        beside = max(shares) < 1.0
        slips = {
            "You swapped the fractions s and 1 - s of the weight that the two planks carry. The "
            "plank nearer to the person must carry more.": [
                -weight * (1.0 - share) if share else 0.0 for share in shares
            ],
            "You give all of the weight to the nearest plank. Divide it between the two planks "
            "beside the person, using the fractions 1 - s and s.": [
                -weight * (share == max(shares)) for share in shares
            ],
            "You give each of the two planks half of the weight. The nearer plank must carry more, "
            "so use the fractions 1 - s and s.": [
                -0.5 * weight * (share > 0.0) for share in shares
            ],
            "You divide the weight between all planks. Only the two planks beside the person carry "
            "it, with the fractions 1 - s and s.": [-weight / 3.0] * 3,
            "Each of the two planks gets the whole weight. Divide it between them, with the "
            "fractions 1 - s and s.": [-weight * (share > 0.0) for share in shares],
            "Your weight pushes the planks up. Weight points down, so its y component must be "
            "negative.": [-part for part in wanted],
            "You multiply the weight by 9.81. It is already a force in N and not a mass in kg, so "
            "use it unchanged.": [9.81 * part for part in wanted],
        }
        twice = {
            "This plank carries the weight twice, once with each of its neighbors. Stop at the "
            "first pair of planks that the person is between.": [2.0 * part for part in wanted],
        }
        about.cause = named(got, about.cause, slips if beside else twice)
        expect_close(
            got,
            wanted,
            then="; the y component of the force that it adds to each plank, in N",
            tolerance=1e-12 * weight,
        )
        got = [part for force in forces for part in (force[0], force[2])]
        expect_close(
            got,
            [1.0, 3.0] * 3,
            then="; the x and z components of all forces in N, which must not change",
        )
    about.call = f"a single plank at x = -1.5; load_bridge([plank], x=4.0, weight={weight}); the y "
    about.call += "component of the force that it adds, in N"
    about.cause = "This bridge has only one plank, which must carry the whole weight, wherever the "
    about.cause += "person is. Don't look for a second plank."
    got = loaded(places[:1], 4.0, weight)[0][1] - 2.0
    expect_close(got, -weight, tolerance=1e-12 * weight)


@pytest.mark.exercise("G6.2", asks="Hang each plank of a bridge from its own spring")
def test_a_loaded_bridge_sags_under_its_walker() -> None:
    about.read = "the docstrings of hang_bridge and load_bridge"
    places = [(float(i), 0.0, 0.0) for i in range(7)]
    about.call = "7 planks of 2 kg on hang_bridge(registry, planks, height=3, stiffness=200, "
    about.call += "damping=20); load_bridge(planks, x=3, weight=100) in every step for 20 s; the "
    about.call += "total pull of the hangers in N"
    about.cause = "At the end the bridge is at rest. The total pull of the hangers must equal the "
    about.cause += "weight of the planks plus that of the person."
    ends = settled_bridge(places, (3.0, 200.0, 20.0), 2.0, (3.0, 100.0), 1200)
    up = math.fsum(
        pull((end, ZERO), ((place[0], 3.0, 0.0), ZERO), 200.0, 3.0, 0.0)[1]
        for end, place in zip(ends, places, strict=True)
    )
    # By then the swings have died out to e^-20 of some 100 N.
    expect_close(up, 7.0 * 2.0 * 10.0 + 100.0, tolerance=1e-4)
    about.call = "the same bridge; how far planks[0], planks[1] and planks[2] sag in m, compared "
    about.call += "with the last three planks"
    about.cause = "The person is on the middle plank, so the bridge must sag equally on both "
    about.cause += "sides. Hang all planks from the same kind of spring, and connect all neighbors."
    sags = [-end[1] for end in ends]
    expect_close(sags[:3], sags[:3:-1], tolerance=1e-6)
    about.call = "the same bridge; the sag of the middle plank minus that of the first plank, in m"
    about.cause = "The planks near the person must sag more than those at the ends, although the "
    about.cause += "springs between the planks spread the load. Check that neighboring planks are "
    about.cause += "connected."
    # Without ropes between them 100 N over 200 N/m would be 0.5 m; the ropes share it out.
    expect_between(sags[3] - sags[0], 0.2, 0.499)
