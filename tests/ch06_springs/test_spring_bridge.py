"""Going further, G6.2: a bridge held up by springs."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.probes import hung_bridge, loaded, settled_bridge
from ch06_springs.spring_bridge import hang_bridge, load_bridge
from draw import Components, components, number, positive_number
from expect import about, blame, expect_between, expect_close, expect_error, named, xyz

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
    """Return the force of a spring on its end, each end a place and a velocity."""
    offset, velocity = (
        [a - b for a, b in zip(p, q, strict=True)] for p, q in zip(end, other, strict=True)
    )
    length = math.hypot(*offset)
    rate = sum(a * b for a, b in zip(offset, velocity, strict=True)) / length
    return tuple(-(k * (length - rest) + c * rate) / length * part for part in offset)


def draw_places(rng: Random) -> list[Components]:
    y, z = number(rng), number(rng)
    return [(1.5 * i, y + round(rng.uniform(-0.2, 0.2), 3), z) for i in range(5)]


@pytest.mark.exercise("G6.2")
def test_a_new_bridge_is_at_rest(rng: Random) -> None:
    about.read = HANG
    places = draw_places(rng)
    numbers = positive_number(rng), positive_number(rng), positive_number(rng)
    about.call = "hang_bridge(registry, planks, {}, {}, {}); registry.update_forces(0.5)".format(
        *numbers
    )
    about.cause = (
        "A new bridge must be at rest, so no spring is stretched. Use the height as the rest "
        "length of the hangers, and the distance between two planks for the others."
    )
    forces = hung_bridge(places, [(place, ZERO) for place in places], numbers)[:-1]
    # Lengths of up to 20 m are 1e-14 m off, times a stiffness of up to 9 N/m.
    height, k, _ = numbers
    for i, force in enumerate(forces):
        slack = "The hangers pull as if their rest length were 0. Use the height instead."
        blame(force, [((0.0, k * height, 0.0), slack)])
        expect_close(force, ZERO, then=f"; planks[{i}].force_accumulator", tolerance=1e-12)
    about.call += ", the first plank 0.5 m lower"
    about.cause = (
        "This plank was moved away from its rest position, so its springs must pull it back."
    )
    x, y, z = places[0]
    got = hung_bridge(places[:1], [((x, y - 0.5, z), ZERO)], numbers)
    wanted = (0.0, 0.5 * numbers[1], 0.0)
    expect_close(got[0], wanted, then=", and no others", tolerance=1e-11)


@pytest.mark.exercise("G6.2")
def test_hangers_and_ropes_pull_a_plank_back(rng: Random) -> None:
    about.read = HANG
    places = draw_places(rng)
    height, k, c = positive_number(rng, 2.0, 9.0), positive_number(rng), positive_number(rng)
    moved = [tuple(0.05 * part for part in components(rng)) for _ in places]
    after = [
        ((p[0] + m[0], p[1] + m[1], p[2] + m[2]), components(rng))
        for p, m in zip(places, moved, strict=True)
    ]
    about.call = f"hang_bridge(registry, planks, {height}, {k}, {c}); all planks moved a little, "
    about.call += "with velocities; registry.update_forces(0.5)"
    about.cause = (
        "Attach one AnchoredSpring straight above each plank, and connect each plank to the next "
        "one. Connect each pair once, because connect acts on both ends."
    )
    forces = hung_bridge(places, after, (height, k, c))
    for i, end in enumerate(after):
        if i == 2:  # it is immovable, and no spring asks for it: how much it gets is left open
            continue
        x, y, z = places[i]
        parts = [pull(end, ((x, y + height, z), ZERO), k, height, c)]
        for j in (i - 1, i + 1):
            if 0 <= j < len(places):
                parts.append(pull(end, after[j], k, math.dist(places[i], places[j]), c))
        wanted = tuple(math.fsum(part[axis] for part in parts) for axis in range(3))
        below = pull(end, ((x, y - height, z), ZERO), k, height, c)
        slips = {
            "Your anchors are below the planks, so the hangers push instead of pulling. Place "
            "each anchor straight above its plank.": [
                total - hanger + part
                for total, hanger, part in zip(wanted, parts[0], below, strict=True)
            ],
            "Only the hangers act. Connect neighboring planks to each other, too.": parts[0],
            "Each spring between two planks acts twice. connect already acts on both ends, so "
            "connect each pair once.": [
                2.0 * total - hanger for total, hanger in zip(wanted, parts[0], strict=True)
            ],
        }
        why = named(forces[i], about.cause, slips)
        expect_close(
            forces[i], wanted, then=f"; planks[{i}].force_accumulator", cause=why, tolerance=1e-11
        )
    about.cause = (
        "The spring that was registered before must keep its force. Add your springs without "
        "clearing the registry."
    )
    expect_close(
        forces[-1],
        (0.0, -2.0, 0.0),
        then="; the force of another spring that the registry had before, upwards",
    )


@pytest.mark.exercise("G6.2")
def test_a_walker_is_carried_by_the_planks_beside_him(rng: Random) -> None:
    about.read = LOAD
    places = [(-1.5, 0.0, 0.0), (-0.5, 0.5, 0.0), (1.5, 0.0, 1.0)]
    weight = positive_number(rng, 1.0, 900.0)
    for x, shares, cause in (
        (
            -1.25,
            (0.75, 0.25, 0.0),
            "Two planks share the weight of the walker, and the nearer one carries more. Their "
            "fractions of the weight are 1 - s and s.",
        ),
        (
            1.0,
            (0.0, 0.25, 0.75),
            "The fraction s goes from 0 at one plank to 1 at the next, "
            "whatever their distance is. Divide by the gap between the two.",
        ),
        (-0.5, (0.0, 1.0, 0.0), "A walker directly above a plank is carried by that plank alone."),
        (-7.0, (1.0, 0.0, 0.0), "A walker before the first plank is carried by that plank alone."),
        (9.0, (0.0, 0.0, 1.0), "A walker beyond the last plank is carried by that plank alone."),
        (
            -1.5,
            (1.0, 0.0, 0.0),
            "A walker directly above the first plank is carried by that plank alone.",
        ),
        (
            1.5,
            (0.0, 0.0, 1.0),
            "A walker directly above the last plank is carried by that plank alone.",
        ),
    ):
        about(f"planks at x = -1.5, -0.5 and 1.5; load_bridge(planks, {x}, {weight})", cause=cause)
        forces = loaded(places, x, weight)
        got = [force[1] - 2.0 for force in forces]
        wanted = [-weight * share for share in shares]
        beside = max(shares) < 1.0
        slips = {
            "The fractions s and 1 - s are swapped, so the more distant plank carries more. "
            "Exchange them.": [-weight * (1.0 - share) if share else 0.0 for share in shares],
            "Your two planks carry half of the weight each. The nearer one must carry more.": [
                -0.5 * weight * (share > 0.0) for share in shares
            ],
            "Your force points up. A weight pulls down, so its y component must be negative.": [
                -part for part in wanted
            ],
            "Your force is 9.81 times too large. The weight is already in N, so do not multiply "
            "it by g.": [9.81 * part for part in wanted],
        }
        about.cause = named(got, about.cause, slips) if beside else about.cause
        expect_close(
            got,
            wanted,
            then=": forces upwards, less the 2 N that were there",
            tolerance=1e-12 * weight,
        )
        got = [part for force in forces for part in (force[0], force[2])]
        expect_close(got, [1.0, 3.0] * 3, then=": forces along x and z stay")
    about.call = f"one plank at x = -1.5; load_bridge([plank], 4.0, {weight})"
    about.cause = "If there is only one plank, it carries the whole weight."
    got = loaded(places[:1], 4.0, weight)[0][1] - 2.0
    expect_close(got, -weight, tolerance=1e-12 * weight)
    about.call = "load_bridge(planks, 0.0, 4.0), both planks at x = 0; the sum of what they carry"
    about.cause = "However close the planks are, together they carry the whole weight."
    got = math.fsum(force[1] - 2.0 for force in loaded([ZERO, ZERO], 0.0, 4.0))
    expect_close(got, -4.0)


@pytest.mark.exercise("G6.2")
def test_a_loaded_bridge_sags_under_its_walker() -> None:
    about.read = "the docstrings of hang_bridge and load_bridge"
    places = [(float(i), 0.0, 0.0) for i in range(7)]
    about.call = "7 planks of 2 kg, hang_bridge(registry, planks, 3, 200, 20); load_bridge(planks, "
    about.call += "3, 100) in every frame, 20 s: the pull of all hangers less 7 m g and 100 N"
    about.cause = (
        "The loaded bridge has come to rest, so the hangers together must carry the weight of the "
        "planks and of the walker."
    )
    ends = settled_bridge(places, (3.0, 200.0, 20.0), 2.0, (3.0, 100.0), 1200)
    up = math.fsum(
        pull((end, ZERO), ((place[0], 3.0, 0.0), ZERO), 200.0, 3.0, 0.0)[1]
        for end, place in zip(ends, places, strict=True)
    )
    # By then the swings have died out to e^-20 of some 100 N.
    expect_close(up, 7.0 * 2.0 * 10.0 + 100.0, tolerance=1e-4)
    about.call = "the same bridge: its sag is the same on both sides of the walker in the middle"
    sags = [-end[1] for end in ends]
    expect_close(sags[:3], sags[:3:-1], tolerance=1e-6)
    about.call = "the same bridge: the sag in the middle, less that at the end"
    about.cause = "The planks beside the walker sag more than those far away."
    # Without ropes between them 100 N over 200 N/m would be 0.5 m; the ropes share it out.
    expect_between(sags[3] - sags[0], 0.2, 0.499)


@pytest.mark.exercise("G6.2")
@pytest.mark.robust
def test_a_bridge_needs_numbers_that_mean_something() -> None:
    about(cause="Check all arguments before the first call of add.", read=HANG)
    planks = [Particle(), Particle()]
    registry = ForceRegistry()
    for bad in (
        (0.0, 1.0, 1.0),
        (-1.0, 1.0, 1.0),
        (math.nan, 1.0, 1.0),
        (1.0, -1.0, 1.0),
        (1.0, 1.0, -1.0),
        (1.0, math.inf, 1.0),
        (1.0, 1.0, math.nan),
    ):
        for some, name in ((planks, "planks"), ([], "[]")):
            expect_error(
                lambda bad=bad, some=some: hang_bridge(registry, some, *bad),
                ValueError,
                call="hang_bridge(registry, {}, {}, {}, {})".format(name, *bad),
                allowed=lambda: hang_bridge(ForceRegistry(), planks, 1.0, 1.0, 1.0),
            )
    about.call = "hang_bridge(registry, planks, ...) was refused; planks[0] is moved; "
    about.call += "registry.update_forces(0.5)"
    about.cause = (
        "The call raised an error, so it must not change the registry. Check all arguments before "
        "you register the first spring."
    )
    planks[0].position.y = -0.5
    registry.update_forces(0.5)
    got = xyz(planks[0].force_accumulator)
    expect_close(got, ZERO, then="; its force_accumulator")
    about.read = LOAD
    about.cause = (
        "Refuse this argument with ValueError. The functions of arguments.py do that. There must "
        "be at least one plank."
    )
    for count, x, weight in (
        (0, 1.0, 1.0),
        (2, math.nan, 1.0),
        (2, math.inf, 1.0),
        (2, -math.inf, 1.0),
        (2, 1.0, -1.0),
        (2, 1.0, math.inf),
        (2, 1.0, math.nan),
    ):
        expect_error(
            lambda count=count, x=x, weight=weight: load_bridge(planks[:count], x, weight),
            ValueError,
            call=f"load_bridge({count} planks, {x}, {weight})",
            allowed=lambda: load_bridge(planks, 1.0, 0.0),
        )
