"""Target blocks: what happens to a block that a shot hits, exercise 4.3c."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import BallisticRange
from ch04_particle_engine.targets import TargetBlock, strike_first
from draw import Triple, number, vector
from expect import about, expect_close, expect_exactly, expect_unchanged, named, scoped

READ = "the docstring of strike_first"
UPDATE = "the docstring of update"
HITS, FLYING = "; block.hits", "; the number of shots in flight"


def block_at(z: float, thick: float = 1.0, x: float = 0.0) -> Any:
    """Return a block of 5 kg, 2 m wide and high."""
    return TargetBlock(Vector3(x, 1.0, z), (2.0, 2.0, thick), mass=5.0)


def fly(blocks: list[Any], start: float = 0.0) -> tuple[Any, tuple[int, ...]]:
    """Let a shot fly along Z to z = 20. Return what is returned, and the hits of each block."""
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    struck = strike_first(Vector3(0.0, 1.0, start), p, blocks)
    return struck, tuple(block.hits for block in blocks)


@pytest.mark.exercise("4.3c", asks="receives the momentum of the particle along X and Z", read=READ)
def test_a_block_gets_the_momentum_of_the_shot_along_the_ground(rng: Random) -> None:
    v, mass = vector(rng), round(rng.uniform(0.5, 2.0), 3)
    before = Triple((number(rng), 1.5, number(rng)))
    with calls(
        "The block gains the momentum of the shot along X and Z. On these axes, add the shot's "
        "momentum divided by the block's mass to the block's velocity, and leave Y unchanged."
    ):
        block = TargetBlock(Vector3(0.0, 1.0, 5.0), size=(2.0, 2.0, 2.0), mass=8.0)
        block.particle.velocity = Vector3(*before)
        p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=mass)
        struck = strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    level, ratio = Triple((v[0], 0.0, v[2])), mass / 8.0
    slips = {
        "You replace the velocity of the block. Along X and Z, add the shot's momentum divided by "
        "the block's mass to the velocity that the block already has.": ratio * level,
        "You also change the block's velocity along Y, but the ground absorbs the momentum in "
        "that direction. Change only X and Z.": before + ratio * v,
        "You add the whole velocity of the shot. Either you use no mass, or you divide the "
        "momentum by the shot's own mass. Divide it by the mass of the block.": before + level,
        "You divide by the mass of the block twice. Divide the momentum by it once.":
            before + ratio / 8.0 * level,
        "You add the momentum of the shot to the velocity of the block. Divide it by the mass of "
        "the block first.": before + mass * level,
        "Your ratio of the masses is upside down, so a heavy block gets faster than a light one. "
        "Divide the mass of the shot by that of the block.": before + level / ratio,
        "You divide by the mass of the shot and the block together. Divide by the mass of the "
        "block alone, because the shot disappears.": before + mass / (mass + 8.0) * level,
    }  # fmt: skip
    # A rounding or two of numbers up to 20.
    now, wanted = block.particle.velocity, before + ratio * level
    then = "; block.particle.velocity"
    expect_close(now, wanted, slips, then=then, unit="m/s", tolerance=1e-13)
    missing = "You don't count the hit. Add 1 to block.hits when the shot hits the block."
    twice = "You add more than 1 to hits for one shot, perhaps both inside the loop and after it."
    expect_exactly(block.hits, 1, then=HITS, cause=twice if block.hits > 1 else missing)
    expect_exactly(
        None if struck is None else (struck.hits, struck.particle.mass),
        (1, 8.0),
        then="; (hits, mass in kg) of the block that it returns",
        cause="Your function does not return the block that was hit. Return that block.",
    )


@pytest.mark.exercise("4.3c", asks="an immovable block does not move at all", read=READ)
def test_an_immovable_block_counts_a_hit_and_stays(rng: Random) -> None:
    v = vector(rng)
    with calls(
        "This block has an infinite mass, so a hit must not move it. Multiply by its inverse mass, "
        "which is 0, instead of dividing by its mass."
    ):
        block = TargetBlock(Vector3(0.0, 1.0, 5.0), size=(2.0, 2.0, 2.0), mass=math.inf)
        p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=3.0)
        strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    expect_close(block.particle.velocity, (0.0, 0.0, 0.0), then="; block.particle.velocity")
    counts = "A hit counts even if the block cannot move. Add 1 to block.hits in any case."
    expect_exactly(block.hits, 1, then=HITS, cause=counts)


@pytest.mark.exercise("4.3c", asks="Let a shot hit the first target on its path", read=READ)
def test_only_the_first_block_on_the_path_is_hit() -> None:
    cause = "Hit only the block for which hit_fraction is smallest."
    with calls(
        f"The shot stops at the first of the four blocks on its path. {cause}",
        "a shot that flies along Z from z = 0 to 20, through blocks at z = 9, 15, 5 and 12; "
        "strike_first(start, p, blocks)",
    ):
        blocks = [block_at(9.0), block_at(15.0), block_at(5.0), block_at(12.0)]
        _, hits = fly(blocks)
    slips = {
        "You hit every block on the path, but the shot stops at the first one.": (1, 1, 1, 1),
        "You hit the first block in the list, not the first one on the path.": (1, 0, 0, 0),
        "You hit the last block in the list, not the first one on the path. If you compare the "
        "results of hit_fraction, store the smallest one together with its block.": (0, 0, 0, 1),
        "You hit the last block on the path. Either you look for the largest fraction instead "
        "of the smallest, or you pass start and end to hit_fraction in the wrong order.":
            (0, 1, 0, 0),
    }  # fmt: skip
    then, cause = "; the hits of each block", named(hits, cause, slips)
    expect_exactly(hits, (0, 0, 1, 0), then=then, cause=cause)
    speeds = tuple(block.particle.velocity.z for block in blocks)
    expect_close(speeds, (0.0, 0.0, 10.0, 0.0), then="; the speed along Z of each block")


@pytest.mark.exercise("4.3c", asks="it hits the one that comes first in the list", read=READ)
def test_a_shot_hits_the_block_that_it_touches_first() -> None:
    cause = "The long block begins earlier on the path. Compare the results of hit_fraction."
    with calls(
        cause,
        "a long block from z = 4 to 16, with a thin block inside it at z = 9; a shot p that flies "
        "along Z from z = 0 to 20, through both; strike_first(start, p, [thin, long])",
    ):
        _, hits = fly([block_at(9.0, thick=0.1), block_at(10.0, thick=12.0)])
    slips = {"You compare the distances to the centers of the blocks.": (1, 0)}
    then, cause = "; (hits of the thin block, hits of the long block)", named(hits, cause, slips)
    expect_exactly(hits, (0, 1), then=then, cause=cause)
    with calls(
        "You hit the later of two blocks with the same hit_fraction. Hit the one that comes first "
        "in the list.",
        "a shot that reaches two blocks at the same time; strike_first(start, p, blocks); the hits "
        "of each block, in the order of the list",
    ):
        _, hits = fly([block_at(5.0, thick=2.0), block_at(6.0, thick=4.0)])
    expect_exactly(hits, (1, 0))


@pytest.mark.exercise("4.3c", asks="already starts inside the block, the result is 0", read=READ)
def test_a_shot_that_starts_inside_a_block_hits_that_one() -> None:
    with calls(
        "The shot must hit only the second block, for which hit_fraction returns 0. Test for a "
        "miss with `is None`, because Python treats 0 as false in an if statement.",
        "blocks at z = 10 and z = 5; a shot p that starts inside the second block, at z = 5, and "
        "flies along Z to z = 20; strike_first(start, p, blocks); the hits of each block",
    ):
        _, hits = fly([block_at(10.0), block_at(5.0)], start=5.0)
    expect_exactly(hits, (0, 1))


@pytest.mark.exercise("4.3c", asks="Return None if the shot misses every target", read=READ)
def test_a_shot_that_hits_nothing_changes_nothing() -> None:
    with calls(
        "There is no block on the path of this shot. Return None, and don't count a hit.",
        "a shot that flies along Z from z = 0 to 20, and a block beside its path, at x = 9; "
        "strike_first(start, p, [block])",
    ):
        block = block_at(5.0, x=9.0)
        struck, _ = fly([block])
    expect_exactly(struck is None, True, then=" is None")
    expect_exactly(block.hits, 0, then=HITS)
    expect_unchanged("block.particle.velocity", block.particle.velocity, (0.0, 0.0, 0.0))
    expect_exactly(fly([])[0] is None, True, call="strike_first(start, p, []) is None")
    with calls(
        "The check has moved the block onto the path, so the shot must hit it now. Read the "
        "block's current position in every call.",
        "block.particle.position.x = 0.0; strike_first(start, p, [block]); block.hits",
        more=True,
    ):
        block.particle.position.x = 0.0
        fly([block])
    expect_exactly(block.hits, 1)


@scoped
def why_it_passes() -> str:
    """Return why a fast shot passes through a thin block: what hits a thick one shows it."""
    thick = TargetBlock(Vector3(0.0, 1.5, 10.0), (2.0, 2.0, 2.0), mass=35.0)
    about(
        'a range r with a block from z = 9 to 11; r.fire("laser"); r.update(0.1), which takes the '
        "shot to z = 10; r.update(0.1)"
    )
    at = BallisticRange([thick])
    at.fire("laser")
    at.update(0.1)
    if thick.hits:
        return (
            "You pass strike_first the position after the step as the start of the path, so the "
            "path has no length. Keep a copy, as in start = shot.particle.position.copy()."
        )
    at.update(0.1)
    if thick.hits:
        return (
            "You call strike_first before integrate, so the path has no length yet. Call it after "
            "the shot has moved, with a copy of the position that it had before."
        )
    return "Your update never hits a block. Call strike_first for each shot that has moved."


@pytest.mark.exercise("4.3c", asks="remove the shot if it has hit a block", read=UPDATE)
def test_on_the_range_a_fast_shot_is_stopped_by_a_thin_block() -> None:
    scene = 'a range r with a block of 35 kg at z = 20, which is 2 cm thick; r.fire("laser"); '
    with calls(
        "Call strike_first in update for each shot that has moved, with the start of its path, its "
        "particle and self.targets.",
        f"{scene}r.update(0.05) 3 times",
    ):
        block = TargetBlock(Vector3(0.0, 1.5, 20.0), (2.0, 2.0, 0.02), mass=35.0, damping=1.0)
        at = BallisticRange([block])
        at.fire("laser")
        for _ in range(3):
            at.update(0.05)
    early = "The shot has not reached the block yet. Don't remove it before it hits the block."
    expect_exactly(len(at.shots), 1, then=FLYING, cause=early)
    about(f"{scene}r.update(0.05) 5 times")
    for _ in range(2):
        at.update(0.05)
    why = about.cause if block.hits else why_it_passes()
    expect_exactly(block.hits, 1, then=HITS, cause=why)
    kept = "You keep the shot in flight. Remove a shot that has hit a block."
    expect_exactly(len(at.shots), 0, then=FLYING, cause=kept)
    wanted = 0.1 * 100.0 * 0.99**0.25 / 35.0
    expect_close(
        block.particle.velocity.z,
        wanted,
        then="; the speed of the block in m/s",
        cause="The block must gain the momentum after the step. Call strike_first after integrate.",
    )
    with calls(
        "A block that is hit must start to move in the next step. In each update, move the targets "
        "first and then the shots.",
        "r.update(0.5); the z coordinate of the block",
        more=True,
    ):
        at.update(0.5)
    expect_close(block.particle.position.z, 20.0 + 0.5 * wanted)


@pytest.mark.exercise("4.3c", asks="call strike_first for each shot that has moved", read=UPDATE)
def test_on_the_range_each_shot_hits_the_first_block_on_its_path() -> None:
    with calls(
        "Both lasers hit the block at z = 8, and the fireball hits none. In update, call "
        "strike_first for every shot with all targets, and remove only the shots that hit one.",
        "a range r with three blocks: one to the side, one at z = 12 and one at z = 8; a laser, a "
        "fireball to the side and a laser are fired; r.update(0.1)",
    ):
        blocks = [block_at(5.0, x=9.0), block_at(12.0), block_at(8.0)]
        at = BallisticRange(blocks)
        at.fire("laser")
        at.fire("fireball", azimuth=-1.0)
        at.fire("laser")
        at.update(0.1)
    hits = tuple(block.hits for block in blocks)
    slips = {
        "Only one of the two lasers hits. Perhaps your loop ends at the first shot that hits. Go "
        "on with the next shot, with continue instead of break or return.": (0, 0, 1)
    }
    cause = named(hits, about.cause, slips)
    expect_exactly(hits, (0, 0, 2), then="; the hits of each block", cause=cause)
    flying = [shot.type for shot in at.shots]
    expect_exactly(flying, ["fireball"], then="; the types of the shots in flight")


@pytest.mark.exercise("4.3c", asks="the path of each shot before anything else", read=UPDATE)
def test_on_the_range_a_hit_comes_before_the_end_of_a_flight() -> None:
    with calls(
        "This shot passes through the block, at z = 8, before it falls below the ground, so the "
        "hit must count. Call strike_first before is_spent."
    ):
        block = TargetBlock(Vector3(0.0, 1.0, 8.0), size=(2.0, 2.0, 0.5), mass=35.0)
        r = BallisticRange([block])
        r.fire("laser", elevation=-0.1)
        r.update(0.5)
    expect_exactly(block.hits, 1, then=HITS)
    with calls("A block must stop a grenade too. Count the hit, and remove the grenade."):
        block = TargetBlock(Vector3(0.0, 1.0, 8.0), size=(2.0, 9.0, 0.5), mass=35.0)
        r = BallisticRange([block])
        r.fire("grenade", elevation=0.0)
        r.update(0.5)
        r.update(0.5)
    expect_exactly(block.hits, 1, then=HITS)
    expect_exactly(len(r.shots), 0, then=FLYING)
