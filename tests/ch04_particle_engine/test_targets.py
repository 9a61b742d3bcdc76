"""Target blocks: the segment test 4.3b and the blow 4.3c."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import targets
from ch04_particle_engine.ballistics import BallisticRange
from ch04_particle_engine.targets import TargetBlock
from draw import Components, components, number
from expect import about, blame, expect_close, expect_exactly, expect_unchanged, xyz

READ = "the docstring of hit_fraction"
# A box from (1, 2, 3) to (3, 6, 9): numbers that are exact in binary.
CENTER, SIZE = (2.0, 4.0, 6.0), (2.0, 4.0, 6.0)

ROUNDED = 1e-12  # some roundings of numbers up to 20, divided by at least 1


def words(start: Components, end: Components) -> str:
    """Return the call for this box in words."""
    return f"box from (1, 2, 3) to (3, 6, 9); hit_fraction(Vector3{start}, Vector3{end}, box)"


def fraction(start: Components, end: Components) -> float | None:
    """Return what comes back for this box."""
    box = TargetBlock(Vector3(*CENTER), SIZE, mass=10.0)
    return targets.hit_fraction(Vector3(*start), Vector3(*end), box)


@pytest.mark.exercise("4.3b")
def test_a_fast_shot_does_not_pass_through_a_thin_block(rng: Random) -> None:
    z = round(rng.uniform(10.2, 11.4), 3)
    about.call = f"block 1 cm thick at z = {z}; hit_fraction(Vector3(0, 1, 10), Vector3(0.1, 1.1, "
    about.call += "11.67), block)"
    about.cause = (
        "Neither end of the path is inside the block, but the path goes through it. Test the "
        "path, not its ends."
    )
    block = TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 0.01), mass=10.0)
    got = targets.hit_fraction(Vector3(0.0, 1.0, 10.0), Vector3(0.1, 1.1, 11.67), block)
    expect_exactly(got is None, False, then=" is None", read=READ)
    wanted = (z - 0.005 - 10.0) / 1.67
    about.cause = "Return the fraction at which the path crosses the near face."
    whole = "size holds the lengths of whole sides. Half of each is on either side of the center."
    blame(got, [((z - 0.01 - 10.0) / 1.67, whole)])
    expect_close(got, wanted, read=READ, tolerance=ROUNDED)


@pytest.mark.exercise("4.3b")
def test_a_way_through_the_box_hits_it_where_it_enters() -> None:
    about.cause = (
        "On each axis, one part of the path lies between the two faces, and that part begins at "
        "the smaller fraction. The path enters the box at the latest of the three beginnings."
    )
    for start, end, wanted in (
        ((1.5, 3.0, 1.0), (2.5, 5.0, 9.0), 0.25),
        ((1.5, 3.0, 17.0), (2.5, 5.0, 1.0), 0.5),
        ((-1.0, 3.0, 4.0), (7.0, 5.0, 8.0), 0.25),
        ((1.5, 10.0, 4.0), (2.5, -6.0, 8.0), 0.25),
        # Past the box on Z before the end of the way, and between its other faces by then.
        ((0.0, 3.0, 0.0), (4.0, 5.0, 16.0), 0.25),
        ((4.0, 5.0, 16.0), (0.0, 3.0, 0.0), 0.4375),
    ):
        about.call = words(start, end)
        got = fraction(start, end)
        expect_exactly(got is None, False, then=" is None", read=READ)
        expect_close(got, wanted, read=READ)


@pytest.mark.exercise("4.3b")
def test_a_way_along_an_axis_has_two_others_to_ask_without_dividing() -> None:
    about.cause = (
        "If the path does not move along an axis, do not divide. It is then between those two "
        "faces either all the time or never."
    )
    for start, end, wanted in (
        ((2.0, 4.0, 1.0), (2.0, 4.0, 9.0), 0.25),
        ((2.0, 4.0, 17.0), (2.0, 4.0, 1.0), 0.5),
        ((-1.0, 4.0, 6.0), (7.0, 4.0, 6.0), 0.25),
    ):
        about.call = words(start, end)
        got = fraction(start, end)
        expect_exactly(got is None, False, then=" is None", read=READ)
        expect_close(got, wanted, read=READ)


@pytest.mark.exercise("4.3b")
def test_a_slanting_way_enters_when_it_is_between_all_three_pairs_of_faces(rng: Random) -> None:
    about.cause = (
        "Each axis gives a part of the path between two faces. The path enters the box at the "
        "latest of their beginnings, not at the first."
    )
    # From outside on all axes to the middle of the box: entered at the greatest of the three.
    sizes = tuple(round(rng.uniform(1.0, 3.0), 3) for _ in range(3))
    center = components(rng)
    away = tuple(number(rng, 4.0, 9.0) for _ in range(3))
    for sign, turn in ((1.0, 0), (-1.0, 0), (1.0, 1), (1.0, 2)):  # the last face on each axis
        sizes, away = sizes[turn:] + sizes[:turn], away[turn:] + away[:turn]
        start = tuple(c + sign * a for c, a in zip(center, away, strict=True))
        about.call = f"block = TargetBlock(Vector3{center}, {sizes}, mass=10); "
        about.call += f"hit_fraction(Vector3{start}, Vector3{center}, block)"
        block = TargetBlock(Vector3(*center), sizes, mass=10.0)
        got = targets.hit_fraction(Vector3(*start), Vector3(*center), block)
        expect_exactly(got is None, False, then=" is None", read=READ)
        wanted = max(1.0 - side / 2.0 / abs(a) for side, a in zip(sizes, away, strict=True))
        expect_close(got, wanted, read=READ, tolerance=ROUNDED)


@pytest.mark.exercise("4.3b")
def test_asking_changes_neither_the_way_nor_the_block(rng: Random) -> None:
    start, end, center = components(rng), components(rng), components(rng)
    about.call = f"hit_fraction(start, end, block), start = Vector3{start}, end = Vector3{end}"
    first, last = Vector3(*start), Vector3(*end)
    block = TargetBlock(Vector3(*center), (1.0, 2.0, 3.0), mass=10.0)
    about(cause="Compute with numbers or with new vectors. Do not change the arguments.", read=READ)
    targets.hit_fraction(first, last, block)
    expect_unchanged("start", xyz(first), start)
    expect_unchanged("end", xyz(last), end)
    now = xyz(block.particle.position)
    expect_unchanged("block.particle.position", now, center)
    # Where the first answer counts, so that this is no check of doing nothing.
    inside = Vector3(*center)
    about.call = f"hit_fraction(middle, end, block), middle = Vector3{center}, twice, and the "
    about.call += "other way"
    other = Vector3(*(2.0 * c - e for c, e in zip(center, end, strict=True)))
    answers = [targets.hit_fraction(inside, there, block) for there in (last, last, other)]
    about.cause = "A path that starts inside hits at once. Return 0, and never a negative fraction."
    expect_exactly(answers[0] is None, False, then=" is None")
    expect_close(answers, (0.0, 0.0, 0.0), tolerance=0.0)


@pytest.mark.exercise("4.3b")
def test_a_way_beside_before_or_behind_the_box_misses() -> None:
    for start, end, missed, cause in (
        ((3.5, 4.0, 1.0), (3.5, 4.0, 9.0), True, "The path runs along Z, beside the box."),
        ((2.9, 4.0, 1.0), (2.9, 4.0, 9.0), False, "The path is 0.9 m off, within half a side."),
        ((1.1, 4.0, 1.0), (1.1, 4.0, 9.0), False, "It is 0.9 m off on the other side, so it hits."),
        ((2.0, 1.5, 1.0), (2.0, 1.5, 9.0), True, "The path passes below the box."),
        ((2.0, 4.0, 0.0), (2.0, 4.0, 2.9), True, "The path ends before it reaches the box."),
        ((2.0, 4.0, 9.5), (2.0, 4.0, 20.0), True, "The path starts behind the box."),
        ((2.0, 4.0, -1.0), (2.0, 4.0, -9.0), True, "The path leads away from the box."),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        expect_exactly(got is None, missed, then=" is None", read=READ)


@pytest.mark.exercise("4.3b")
def test_a_way_that_cuts_the_corner_misses() -> None:
    beside = "The path is between the faces of X and between those of Z, but never between both."
    through = "The path is between the faces of X, Y and Z at the same time, so it hits."
    for start, end, missed, cause in (
        ((0.0, 4.0, 8.0), (4.0, 4.0, 16.0), True, beside),
        ((0.0, 4.0, 4.0), (4.0, 4.0, 8.0), False, through),
        ((4.0, 4.0, 4.0), (2.0, 4.0, 1.0), True, beside),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        expect_exactly(got is None, missed, then=" is None", read=READ)


@pytest.mark.exercise("4.3b")
def test_touching_counts_and_so_does_a_start_inside() -> None:
    for start, end, wanted, cause in (
        ((2.0, 4.0, 1.0), (2.0, 4.0, 3.0), 1.0, "The path ends on the face, which is a hit."),
        ((3.0, 4.0, 1.0), (3.0, 4.0, 9.0), 0.25, "The path runs along the face, which is a hit."),
        ((1.0, 4.0, 1.0), (1.0, 4.0, 9.0), 0.25, "The path runs along the face, which is a hit."),
        ((2.0, 4.0, 9.0), (2.0, 4.0, 12.0), 0.0, "The path starts on the face, which is a hit."),
        ((2.0, 4.0, 5.0), (2.0, 4.0, 30.0), 0.0, "The path starts inside the box."),
        ((2.0, 4.0, 5.0), (2.5, 5.0, 7.0), 0.0, "The path starts and ends inside the box."),
        ((2.0, 4.0, 5.0), (2.0, 4.0, 5.0), 0.0, "The path has no length, but it is inside."),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        expect_exactly(got is None, False, then=" is None", read=READ)
        expect_close(got, wanted, read=READ, tolerance=0.0)
    about(words((2.0, 4.0, 2.0), (2.0, 4.0, 2.0)), cause="The path has no length and is outside.")
    got = fraction((2.0, 4.0, 2.0), (2.0, 4.0, 2.0))
    expect_exactly(got, None, read=READ)


# 4.3c Blocks of several masses

STRIKE = "the docstring of strike_first"


@pytest.mark.exercise("4.3c")
def test_a_block_gets_the_momentum_of_the_shot_along_the_ground(rng: Random) -> None:
    v, mass, block_mass = components(rng), round(rng.uniform(0.5, 2.0), 3), 8.0
    before = (number(rng), 1.5, number(rng))
    about.call = f"strike_first(start, p, [block]), p with mass {mass} and velocity {v}, block "
    about.call += f"with mass 8 and velocity {before}"
    about.cause = "v' = v + m v_shot / M along X and Z. The ground absorbs the part along Y."
    block = TargetBlock(Vector3(0.0, 1.0, 5.0), (2.0, 2.0, 2.0), mass=block_mass)
    block.particle.velocity = Vector3(*before)
    p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=mass)
    struck = targets.strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    got = xyz(block.particle.velocity)
    ratio = mass / block_mass
    wanted = (before[0] + ratio * v[0], 1.5, before[2] + ratio * v[2])
    # A rounding or two of numbers up to 20.
    gained = tuple(mass * n / block_mass for n in v)
    mistakes = [
        ((gained[0], 0.0, gained[2]), "The velocity was replaced. Add to it."),
        (
            tuple(before[i] + gained[i] for i in range(3)),
            "The ground absorbs the part along Y. Change only X and Z.",
        ),
        (
            (before[0] + v[0], 1.5, before[2] + v[2]),
            "The shot's whole velocity was added. Add m v / M.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, then="; block.particle.velocity", read=STRIKE, tolerance=1e-13)
    about.cause = "Count each hit once, and return the block that was hit."
    expect_exactly(block.hits, 1, then="; block.hits", read=STRIKE)
    about.call += ", what comes back: its hits and mass"
    struck_is = None if struck is None else (struck.hits, struck.particle.mass)
    expect_exactly(struck_is, (1, 8.0), read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_a_block_that_nothing_moves_is_hit_and_stays(rng: Random) -> None:
    v = components(rng)
    about.call = f"strike_first(start, p, [block]), p with velocity {v}, block with mass math.inf"
    about.cause = (
        "The inverse mass is 0, so the block gains no velocity. Do not divide by an infinite mass."
    )
    block = TargetBlock(Vector3(0.0, 1.0, 5.0), (2.0, 2.0, 2.0), mass=float("inf"))
    p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=3.0)
    targets.strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    got = xyz(block.particle.velocity)
    expect_close(got, (0.0, 0.0, 0.0), then="; block.particle.velocity", read=STRIKE)
    about.cause = "A hit counts whether or not the block moves."
    expect_exactly(block.hits, 1, then="; block.hits", read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_only_the_first_block_on_the_way_is_hit() -> None:
    about.call = "strike_first(Vector3(0, 1, 0), p at z = 20, blocks at z = 15, 5 and 10), their "
    about.call += "hits"
    about.cause = "Hit only the block with the smallest fraction."
    blocks = [
        TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 1.0), mass=5.0) for z in (15.0, 5.0, 10.0)
    ]
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, blocks)
    hits = tuple(block.hits for block in blocks)
    expect_exactly(hits, (0, 1, 0), read=STRIKE)
    speeds = tuple(block.particle.velocity.z for block in blocks)
    about.call = about.call.replace("their hits", "their speeds along Z")
    expect_close(speeds, (0.0, 10.0, 0.0), read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_first_is_who_is_touched_first_and_not_who_is_nearer() -> None:
    about.cause = (
        "Compare the results of hit_fraction, which say how far along the path each block is hit. "
        "The distances of the blocks do not show that."
    )
    about.read = STRIKE
    about.call = "strike_first(Vector3(0, 1, 0), p at z = 20, a block from z = 4 to 16 and a thin "
    about.call += "one at z = 9), their hits"
    long = TargetBlock(Vector3(0.0, 1.0, 10.0), (2.0, 2.0, 12.0), mass=5.0)
    thin = TargetBlock(Vector3(0.0, 1.0, 9.0), (2.0, 2.0, 0.1), mass=5.0)
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [thin, long])
    hits = (thin.hits, long.hits)
    expect_exactly(hits, (0, 1), then=", thin one and long one")
    about.call = "two blocks with one and the same face; strike_first(...), their hits"
    about.cause = "If the path touches two blocks at once, the first one in the list is hit."
    pair = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 2 * z - 8.0), mass=5.0) for z in (5, 6)]
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, pair)
    hits = tuple(block.hits for block in pair)
    expect_exactly(hits, (1, 0))


@pytest.mark.exercise("4.3c")
def test_a_shot_that_starts_inside_a_block_hits_that_one() -> None:
    about.call = "strike_first(Vector3(0, 1, 5), p at z = 20, blocks at z = 10 and 5), their hits"
    about.cause = "A fraction of 0 is a hit. Test for `is None`, because Python treats 0 as false."
    blocks = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 1.0), mass=5.0) for z in (10.0, 5.0)]
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 5.0), p, blocks)
    hits = tuple(block.hits for block in blocks)
    expect_exactly(hits, (0, 1), read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_a_shot_that_hits_nothing_changes_nothing() -> None:
    about.call = "strike_first(Vector3(0, 1, 0), p at z = 20, a block at x = 9)"
    about.cause = "No block is on the path, so return None and do not count a hit."
    block = TargetBlock(Vector3(9.0, 1.0, 5.0), (2.0, 2.0, 1.0), mass=5.0)
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    got = targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [block])
    expect_exactly(got is None, True, then=" is None", read=STRIKE)
    expect_exactly(block.hits, 0, then="; block.hits", read=STRIKE)
    now = xyz(block.particle.velocity)
    expect_unchanged("its velocity", now, (0.0, 0.0, 0.0), read=STRIKE)
    about.call = "strike_first(Vector3(0, 1, 0), p, [])"
    got = targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [])
    expect_exactly(got is None, True, then=" is None", read=STRIKE)
    about.call = "the block is moved to x = 0; strike_first(Vector3(0, 1, 0), p, [block]); "
    about.call += "block.hits"
    about.cause = "Now the block is on the path."
    block.particle.position.x = 0.0
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [block])
    expect_exactly(block.hits, 1, read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_on_the_range_a_fast_shot_is_stopped_by_a_thin_block() -> None:
    about.call = (
        'a block of 35 kg, 2 cm thick, at z = 20; r.fire("laser"); r.update(0.05) 5 times; '
    )
    about.cause = (
        "In update, copy the position before the step. Otherwise it moves along with the shot. "
        "Remove a shot that has hit."
    )
    about.read = "the docstring of update"
    block = TargetBlock(Vector3(0.0, 1.5, 20.0), (2.0, 2.0, 0.02), mass=35.0, damping=1.0)
    at = BallisticRange([block])
    at.fire("laser")
    for _ in range(3):
        at.update(0.05)
    name = f"{about.call.replace('5 times', '3 times')}shots in flight"
    expect_exactly(len(at.shots), 1, call=name, cause="The shot has not reached the block yet.")
    for _ in range(2):
        at.update(0.05)
    expect_exactly(block.hits, 1, then="block.hits")
    expect_exactly(len(at.shots), 0, then="shots in flight")
    about.cause = "The block gets the momentum that the shot has after its step."
    speed = block.particle.velocity.z
    wanted = 0.1 * 100.0 * 0.99**0.25 / 35.0
    expect_close(speed, wanted, then="its speed")
    at.update(0.5)
    about.cause = (
        "First the targets move, then the shots. So a block moves from the step after the hit on."
    )
    moved = block.particle.position.z
    expect_close(moved, 20.0 + 0.5 * wanted, then="r.update(0.5); where it is")


@pytest.mark.exercise("4.3c")
def test_on_the_range_each_shot_hits_what_is_first_on_its_own_way() -> None:
    about.call = "blocks aside, at z = 12 and at z = 8; fire a laser, a fireball to the side and "
    about.call += "another laser; r.update(0.1)"
    about.cause = (
        "Test every shot against all targets. A shot hits at most one target, and the other shots "
        "fly on."
    )
    about.read = "the docstring of update"
    blocks = [
        TargetBlock(Vector3(x, 1.5, z), (2.0, 2.0, 0.5), mass=35.0)
        for x, z in ((9.0, 5.0), (0.0, 12.0), (0.0, 8.0))
    ]
    at = BallisticRange(blocks)
    at.fire("laser")
    at.fire("fireball", azimuth=-1.0)
    at.fire("laser")
    at.update(0.1)
    hits = tuple(block.hits for block in blocks)
    expect_exactly(hits, (0, 0, 2), then="; hits")
    flying = [shot.type for shot in at.shots]
    expect_exactly(flying, ["fireball"], then="; types in flight")


@pytest.mark.exercise("4.3c")
def test_on_the_range_a_hit_comes_before_the_end_of_a_flight() -> None:
    about.read = "the docstring of update"
    about.cause = (
        "The shot hits before it reaches the point where it is spent. Call strike_first first."
    )
    about.call = (
        'a block at z = 8; r.fire("laser", elevation=-0.1); r.update(0.5), which ends below 0'
    )
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 2.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("laser", elevation=-0.1)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    about.cause = "A block stops a grenade like any other shot."
    about.call = 'a block at z = 8; r.fire("grenade", elevation=0.0); r.update(0.5) twice'
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 9.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("grenade", elevation=0.0)
    at.update(0.5)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    expect_exactly(len(at.shots), 0, then="; shots in flight")
