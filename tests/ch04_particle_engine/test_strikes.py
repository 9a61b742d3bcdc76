"""Target blocks: what happens to a block that a shot hits, exercise 4.3c."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import targets
from ch04_particle_engine.ballistics import BallisticRange
from ch04_particle_engine.targets import TargetBlock
from draw import components, number
from expect import about, blame, expect_close, expect_exactly, expect_unchanged, xyz

STRIKE = "the docstring of strike_first"


@pytest.mark.exercise("4.3c")
def test_a_block_gets_the_momentum_of_the_shot_along_the_ground(rng: Random) -> None:
    v, mass, block_mass = components(rng), round(rng.uniform(0.5, 2.0), 3), 8.0
    before = (number(rng), 1.5, number(rng))
    about.call = (
        f"strike_first(start, p, [block]), p with mass {mass} and velocity {v}, block with mass 8 "
        f"and velocity {before}"
    )
    about.cause = (
        "Along X and Z, the shot passes its momentum on to the block, so v' = v + m v_shot / M. "
        "Along Y, the velocity doesn't change, because the ground absorbs the momentum."
    )
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
        (
            (gained[0], 0.0, gained[2]),
            "The velocity of the block was replaced. Add the change m v / M to the velocity that "
            "the block already has.",
        ),
        (
            tuple(before[i] + gained[i] for i in range(3)),
            "The Y component of the block's velocity changed too, but the ground absorbs that "
            "part. Change only X and Z.",
        ),
        (
            (before[0] + v[0], 1.5, before[2] + v[2]),
            "The whole velocity of the shot was added. The block gains only the shot's momentum "
            "divided by its own mass, m v / M.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, then="; block.particle.velocity", read=STRIKE, tolerance=1e-13)
    about.cause = "Count each hit once in block.hits, and return the block that was hit."
    expect_exactly(block.hits, 1, then="; block.hits", read=STRIKE)
    about.call += ", what comes back: its hits and mass"
    struck_is = None if struck is None else (struck.hits, struck.particle.mass)
    expect_exactly(struck_is, (1, 8.0), read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_a_block_that_nothing_moves_is_hit_and_stays(rng: Random) -> None:
    v = components(rng)
    about.call = f"strike_first(start, p, [block]), p with velocity {v}, block with mass math.inf"
    about.cause = (
        "This block has infinite mass, so its inverse mass is 0 and it gains no velocity. Multiply "
        "by the inverse mass instead of dividing by the mass."
    )
    block = TargetBlock(Vector3(0.0, 1.0, 5.0), (2.0, 2.0, 2.0), mass=float("inf"))
    p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=3.0)
    targets.strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    got = xyz(block.particle.velocity)
    expect_close(got, (0.0, 0.0, 0.0), then="; block.particle.velocity", read=STRIKE)
    about.cause = "A hit counts even if the block is too heavy to move."
    expect_exactly(block.hits, 1, then="; block.hits", read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_only_the_first_block_on_the_way_is_hit() -> None:
    about.call = (
        "strike_first(Vector3(0, 1, 0), p at z = 20, blocks at z = 15, 5 and 10), their hits"
    )
    about.cause = (
        "The path leads through several blocks, but the shot stops at the first. Hit only the "
        "block with the smallest fraction."
    )
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
        "The block with the nearer center is not always the first to be hit. Compare the results "
        "of hit_fraction, which say how far along the path each block is."
    )
    about.read = STRIKE
    about.call = (
        "strike_first(Vector3(0, 1, 0), p at z = 20, a block from z = 4 to 16 and a thin one at z "
        "= 9), their hits"
    )
    long = TargetBlock(Vector3(0.0, 1.0, 10.0), (2.0, 2.0, 12.0), mass=5.0)
    thin = TargetBlock(Vector3(0.0, 1.0, 9.0), (2.0, 2.0, 0.1), mass=5.0)
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [thin, long])
    hits = (thin.hits, long.hits)
    expect_exactly(hits, (0, 1), then=", thin one and long one")
    about.call = "two blocks whose near faces are in the same plane; strike_first(...), their hits"
    about.cause = (
        "If the path reaches two blocks at the same fraction, hit the one that comes first in the "
        "list."
    )
    pair = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 2 * z - 8.0), mass=5.0) for z in (5, 6)]
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, pair)
    hits = tuple(block.hits for block in pair)
    expect_exactly(hits, (1, 0))


@pytest.mark.exercise("4.3c")
def test_a_shot_that_starts_inside_a_block_hits_that_one() -> None:
    about.call = "strike_first(Vector3(0, 1, 5), p at z = 20, blocks at z = 10 and 5), their hits"
    about.cause = (
        "A fraction of 0 is a hit. Python treats 0 as false in an if statement, so test for a miss "
        "with `is None`."
    )
    blocks = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 1.0), mass=5.0) for z in (10.0, 5.0)]
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 5.0), p, blocks)
    hits = tuple(block.hits for block in blocks)
    expect_exactly(hits, (0, 1), read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_a_shot_that_hits_nothing_changes_nothing() -> None:
    about.call = "strike_first(Vector3(0, 1, 0), p at z = 20, a block at x = 9)"
    about.cause = "There is no block on this shot's path. Return None, and don't count a hit."
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
    about.call = (
        "the block is moved to x = 0; strike_first(Vector3(0, 1, 0), p, [block]); block.hits"
    )
    about.cause = (
        "The check moves the block onto the path, so the shot must hit it now. Make sure that you "
        "use the block's current position."
    )
    block.particle.position.x = 0.0
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [block])
    expect_exactly(block.hits, 1, read=STRIKE)


@pytest.mark.exercise("4.3c")
def test_on_the_range_a_fast_shot_is_stopped_by_a_thin_block() -> None:
    about.call = (
        'a block of 35 kg, 2 cm thick, at z = 20; r.fire("laser"); r.update(0.05) 5 times; '
    )
    about.cause = (
        "In update, copy the position of the shot before the step, because the vector itself moves "
        "with the shot. Remove a shot that has hit a block."
    )
    about.read = "the docstring of update"
    block = TargetBlock(Vector3(0.0, 1.5, 20.0), (2.0, 2.0, 0.02), mass=35.0, damping=1.0)
    at = BallisticRange([block])
    at.fire("laser")
    for _ in range(3):
        at.update(0.05)
    name = f"{about.call.replace('5 times', '3 times')}shots in flight"
    expect_exactly(
        len(at.shots),
        1,
        call=name,
        cause="The shot has not reached the block yet, so it must still be in flight.",
    )
    for _ in range(2):
        at.update(0.05)
    expect_exactly(block.hits, 1, then="block.hits")
    expect_exactly(len(at.shots), 0, then="shots in flight")
    about.cause = (
        "The block must gain the momentum that the shot has after its step. Call strike_first "
        "after integrate."
    )
    speed = block.particle.velocity.z
    wanted = 0.1 * 100.0 * 0.99**0.25 / 35.0
    expect_close(speed, wanted, then="its speed")
    at.update(0.5)
    about.cause = (
        "In each step, move the targets first and then the shots. A block that is hit then starts "
        "to move in the next step."
    )
    moved = block.particle.position.z
    expect_close(moved, 20.0 + 0.5 * wanted, then="r.update(0.5); its z coordinate")


@pytest.mark.exercise("4.3c")
def test_on_the_range_each_shot_hits_what_is_first_on_its_own_way() -> None:
    about.call = (
        "three blocks, one to the side, one at z = 12 and one at z = 8; fire a laser, a fireball "
        "to the side and another laser; r.update(0.1)"
    )
    about.cause = (
        "Test every shot against all targets. Remove a shot that hits one, and let the others fly "
        "on."
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
        "This shot hits the block before it gets to where it would be spent. Call strike_first "
        "before is_spent."
    )
    about.call = (
        'a block at z = 8; r.fire("laser", elevation=-0.1); r.update(0.5), after which the shot is '
        "below the ground"
    )
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 2.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("laser", elevation=-0.1)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    about.cause = (
        "A block stops a grenade like any other shot. Remove the grenade from the list of shots."
    )
    about.call = 'a block at z = 8; r.fire("grenade", elevation=0.0); r.update(0.5) twice'
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 9.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("grenade", elevation=0.0)
    at.update(0.5)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    expect_exactly(len(at.shots), 0, then="; shots in flight")
