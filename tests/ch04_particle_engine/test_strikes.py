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
from expect import about, blame, expect_close, expect_exactly, expect_unchanged, scoped, xyz

STRIKE = "the docstring of strike_first"


@pytest.mark.exercise("4.3c", asks="receives the momentum of the particle along X and Z")
def test_a_block_gets_the_momentum_of_the_shot_along_the_ground(rng: Random) -> None:
    v, mass, block_mass = components(rng), round(rng.uniform(0.5, 2.0), 3), 8.0
    before = (number(rng), 1.5, number(rng))
    about.call = (
        f"a shot p of {mass} kg with the velocity {v}; it is inside a block of 8 kg with the "
        f"velocity {before}; strike_first(start, p, [block])"
    )
    about.read = STRIKE
    about.cause = (
        "The block gains the momentum of the shot along X and Z. On these axes, add the shot's "
        "momentum divided by the block's mass to the block's velocity, and leave Y unchanged."
    )
    block = TargetBlock(Vector3(0.0, 1.0, 5.0), (2.0, 2.0, 2.0), mass=block_mass)
    block.particle.velocity = Vector3(*before)
    p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=mass)
    struck = targets.strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    got = xyz(block.particle.velocity)
    ratio, together = mass / block_mass, mass / (mass + block_mass)
    wanted = (before[0] + ratio * v[0], 1.5, before[2] + ratio * v[2])
    # A rounding or two of numbers up to 20.
    gained = tuple(mass * n / block_mass for n in v)
    mistakes = [
        (
            (gained[0], 0.0, gained[2]),
            "You replace the velocity of the block. Instead, add the shot's momentum divided "
            "by the block's mass to the velocity that the block already has.",
        ),
        (
            tuple(before[i] + gained[i] for i in range(3)),
            "You also change the block's velocity along Y, but the ground absorbs the momentum in "
            "that direction. Change only X and Z.",
        ),
        (
            (before[0] + v[0], 1.5, before[2] + v[2]),
            "You add the whole velocity of the shot. Either you use no mass, or you divide the "
            "momentum by the shot's own mass. Divide it by the mass of the block.",
        ),
        (
            (before[0] + ratio * v[0] / block_mass, 1.5, before[2] + ratio * v[2] / block_mass),
            "You divide by the mass of the block twice. Divide the momentum by it once.",
        ),
        (
            (before[0] + mass * v[0], 1.5, before[2] + mass * v[2]),
            "You add the momentum of the shot to the velocity of the block. Divide it by the mass "
            "of the block first.",
        ),
        (
            (before[0] + v[0] / ratio, 1.5, before[2] + v[2] / ratio),
            "Your ratio of the masses is upside down, so a heavy block gets faster than a light "
            "one. Divide the mass of the shot by that of the block.",
        ),
        (
            (before[0] + together * v[0], 1.5, before[2] + together * v[2]),
            "You divide by the mass of the shot and the block together. Divide by the mass of the "
            "block alone, because the shot disappears.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, then="; block.particle.velocity", unit="m/s", tolerance=1e-13)
    about.cause = "You don't count the hit. Add 1 to block.hits when the shot hits the block."
    if block.hits > 1:
        about.cause = (
            "You add more than 1 to hits for one shot. Perhaps you count the hit both inside the "
            "loop and after it."
        )
    expect_exactly(block.hits, 1, then="; block.hits")
    about.cause = "Your function does not return the block that was hit. Return that block."
    about.call += "; (hits, mass in kg) of the block that it returns"
    struck_is = None if struck is None else (struck.hits, struck.particle.mass)
    expect_exactly(struck_is, (1, 8.0))


@pytest.mark.exercise("4.3c", asks="an immovable block does not move at all")
def test_an_immovable_block_counts_a_hit_and_stays(rng: Random) -> None:
    about.read = STRIKE
    v = components(rng)
    about.call = (
        f"a shot p with the velocity {v}, inside a block with mass math.inf; strike_first(start, "
        "p, [block])"
    )
    about.cause = (
        "This block has an infinite mass, so a hit must not move it. Multiply by its inverse mass, "
        "which is 0, instead of dividing by its mass."
    )
    block = TargetBlock(Vector3(0.0, 1.0, 5.0), (2.0, 2.0, 2.0), mass=float("inf"))
    p = Particle(Vector3(0.0, 1.0, 5.0), Vector3(*v), mass=3.0)
    targets.strike_first(Vector3(0.0, 1.0, 3.0), p, [block])
    got = xyz(block.particle.velocity)
    expect_close(got, (0.0, 0.0, 0.0), then="; block.particle.velocity")
    about.cause = "A hit counts even if the block cannot move. Add 1 to block.hits in any case."
    expect_exactly(block.hits, 1, then="; block.hits")


@pytest.mark.exercise("4.3c", asks="Let a shot hit the first target on its path")
def test_only_the_first_block_on_the_path_is_hit() -> None:
    about.read = STRIKE
    about.call = (
        "a shot that flies along Z from z = 0 to 20, through blocks at z = 9, 15, 5 and 12; "
        "strike_first(start, p, blocks); the hits of each block"
    )
    smallest = "Hit only the block for which hit_fraction is smallest"
    about.cause = f"The shot stops at the first of the four blocks on its path. {smallest}."
    blocks = [
        TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 1.0), mass=5.0) for z in (9.0, 15.0, 5.0, 12.0)
    ]
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, blocks)
    hits = tuple(block.hits for block in blocks)
    mistakes = [
        (
            (1, 1, 1, 1),
            f"You hit every block on the path, but the shot stops at the first one. {smallest}.",
        ),
        (
            (1, 0, 0, 0),
            f"You hit the first block in the list, not the first one on the path. {smallest}.",
        ),
        (
            (0, 0, 0, 1),
            f"You hit the last block in the list, not the first one on the path. {smallest}. If "
            "you compare the fractions, store the smallest one together with its block.",
        ),
        (
            (0, 1, 0, 0),
            "You hit the last block on the path. Either you look for the largest fraction instead "
            "of the smallest, or you pass start and end to hit_fraction in the wrong order.",
        ),
    ]
    blame(hits, mistakes)
    expect_exactly(hits, (0, 0, 1, 0))
    speeds = tuple(block.particle.velocity.z for block in blocks)
    about.call = about.call.replace("the hits of", "the speed along Z of")
    expect_close(speeds, (0.0, 0.0, 10.0, 0.0))


@pytest.mark.exercise("4.3c", asks="it hits the one that comes first in the list")
def test_a_shot_hits_the_block_that_it_touches_first() -> None:
    about.cause = (
        "The long block begins earlier on the path, so the shot hits only this block. Compare the "
        "results of hit_fraction."
    )
    about.read = STRIKE
    about.call = (
        "a long block from z = 4 to 16, with a thin block inside it at z = 9; a shot p that flies "
        "along Z from z = 0 to 20, through both; strike_first(start, p, blocks)"
    )
    long = TargetBlock(Vector3(0.0, 1.0, 10.0), (2.0, 2.0, 12.0), mass=5.0)
    thin = TargetBlock(Vector3(0.0, 1.0, 9.0), (2.0, 2.0, 0.1), mass=5.0)
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [thin, long])
    hits = (thin.hits, long.hits)
    centers = (
        "You compare the distances to the centers of the blocks, but the long block begins earlier "
        "on the path. Compare the results of hit_fraction instead."
    )
    blame(hits, [((1, 0), centers)])
    expect_exactly(hits, (0, 1), then="; (hits of the thin block, hits of the long block)")
    about.call = (
        "a shot that reaches two blocks at the same time; strike_first(start, p, blocks); the hits "
        "of each block, in the order of the list"
    )
    about.cause = (
        "You hit the later of two blocks with the same hit_fraction. Hit the one that comes first "
        "in the list."
    )
    pair = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 2 * z - 8.0), mass=5.0) for z in (5, 6)]
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, pair)
    hits = tuple(block.hits for block in pair)
    expect_exactly(hits, (1, 0))


@pytest.mark.exercise("4.3c", asks="already starts inside the block, the result is 0")
def test_a_shot_that_starts_inside_a_block_hits_that_one() -> None:
    about.read = STRIKE
    about.call = (
        "blocks at z = 10 and z = 5; a shot p that starts inside the second block, at z = 5, and "
        "flies along Z to z = 20; strike_first(start, p, blocks); the hits of each block"
    )
    about.cause = (
        "The shot must hit only the second block, for which hit_fraction returns 0. Test for a "
        "miss with `is None`, because Python treats 0 as false in an if statement."
    )
    blocks = [TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 1.0), mass=5.0) for z in (10.0, 5.0)]
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    targets.strike_first(Vector3(0.0, 1.0, 5.0), p, blocks)
    hits = tuple(block.hits for block in blocks)
    expect_exactly(hits, (0, 1))


@pytest.mark.exercise("4.3c", asks="Return None if the shot misses every target")
def test_a_shot_that_hits_nothing_changes_nothing() -> None:
    about.read = STRIKE
    about.call = (
        "a shot that flies along Z from z = 0 to 20, and a block beside its path, at x = 9; "
        "strike_first(start, p, [block])"
    )
    about.cause = "There is no block on the path of this shot. Return None, and don't count a hit."
    block = TargetBlock(Vector3(9.0, 1.0, 5.0), (2.0, 2.0, 1.0), mass=5.0)
    p = Particle(Vector3(0.0, 1.0, 20.0), Vector3(0.0, 0.0, 50.0))
    got = targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [block])
    expect_exactly(got is None, True, then=" is None")
    expect_exactly(block.hits, 0, then="; block.hits")
    now = xyz(block.particle.velocity)
    expect_unchanged("block.particle.velocity", now, (0.0, 0.0, 0.0))
    about.call = "strike_first(start, p, []), without any block"
    got = targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [])
    expect_exactly(got is None, True, then=" is None")
    about.call = (
        "the block is moved into the path of the shot, to x = 0; strike_first(start, p, [block]); "
        "block.hits"
    )
    about.cause = (
        "The check has moved the block onto the path, so the shot must hit it now. Read the "
        "block's current position in every call."
    )
    block.particle.position.x = 0.0
    targets.strike_first(Vector3(0.0, 1.0, 0.0), p, [block])
    expect_exactly(block.hits, 1)


@scoped
def why_it_passes() -> str:
    """Return why a fast shot passes through a thin block: what hits a thick one shows it."""
    about.call = (
        'a range r with a block from z = 9 to 11; r.fire("laser"); r.update(0.1), which takes the '
        "shot to z = 10; r.update(0.1)"
    )
    thick = TargetBlock(Vector3(0.0, 1.5, 10.0), (2.0, 2.0, 2.0), mass=35.0)
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


@pytest.mark.exercise("4.3c", asks="remove the shot if it has hit a block")
def test_on_the_range_a_fast_shot_is_stopped_by_a_thin_block() -> None:
    about.call = (
        'a range r with a block of 35 kg at z = 20, which is 2 cm thick; r.fire("laser"); '
        "r.update(0.05) 5 times; "
    )
    about.cause = (
        "Call strike_first in update for each shot that has moved, with the start of its path, its "
        "particle and self.targets."
    )
    about.read = "the docstring of update"
    block = TargetBlock(Vector3(0.0, 1.5, 20.0), (2.0, 2.0, 0.02), mass=35.0, damping=1.0)
    at = BallisticRange([block])
    at.fire("laser")
    for _ in range(3):
        at.update(0.05)
    name = f"{about.call.replace('5 times', '3 times')}the number of shots in flight"
    expect_exactly(
        len(at.shots),
        1,
        call=name,
        cause="After 0.15 s the shot has not reached the block yet. Don't remove it before it hits "
        "the block.",
    )
    for _ in range(2):
        at.update(0.05)
    if block.hits == 0:
        about.cause = why_it_passes()
    expect_exactly(block.hits, 1, then="block.hits")
    about.cause = "You keep the shot in flight. Remove a shot that has hit a block."
    expect_exactly(len(at.shots), 0, then="the number of shots in flight")
    about.cause = (
        "The block must gain the momentum that the shot has after its step. Call strike_first "
        "after integrate."
    )
    speed = block.particle.velocity.z
    wanted = 0.1 * 100.0 * 0.99**0.25 / 35.0
    expect_close(speed, wanted, then="the speed of the block in m/s")
    at.update(0.5)
    about.cause = (
        "A block that is hit must start to move in the next step. In each update, move the targets "
        "first and then the shots."
    )
    moved = block.particle.position.z
    expect_close(moved, 20.0 + 0.5 * wanted, then="r.update(0.5); the z coordinate of the block")


@pytest.mark.exercise("4.3c", asks="call strike_first for each shot that has moved")
def test_on_the_range_each_shot_hits_the_first_block_on_its_path() -> None:
    about.call = (
        "a range r with three blocks: one to the side, one at z = 12 and one at z = 8; a laser, a "
        "fireball to the side and a laser are fired; r.update(0.1)"
    )
    about.cause = (
        "Both lasers hit the block at z = 8, and the fireball hits none. In update, call "
        "strike_first for every shot with all targets, and remove only the shots that hit one."
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
    if hits == (0, 0, 1):
        about.cause = (
            "Only one of the two lasers hits. Perhaps your loop ends at the first shot that hits. "
            "Go on with the next shot, with continue instead of break or return."
        )
    expect_exactly(hits, (0, 0, 2), then="; the hits of each block")
    flying = [shot.type for shot in at.shots]
    expect_exactly(flying, ["fireball"], then="; the types of the shots in flight")


@pytest.mark.exercise("4.3c", asks="the path of each shot before anything else")
def test_on_the_range_a_hit_comes_before_the_end_of_a_flight() -> None:
    about.read = "the docstring of update"
    about.cause = (
        "This shot hits the block before it falls below the ground, so the hit must count. Call "
        "strike_first before is_spent."
    )
    about.call = (
        'a range r with a block at z = 8; r.fire("laser", elevation=-0.1); r.update(0.5), which '
        "takes the shot through the block and below the ground"
    )
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 2.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("laser", elevation=-0.1)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    about.cause = (
        "A block must stop a grenade like any other shot. Count the hit, and remove the grenade "
        "from the list of shots."
    )
    about.call = (
        'a range r with a block at z = 8; r.fire("grenade", elevation=0.0); r.update(0.5) twice'
    )
    block = TargetBlock(Vector3(0.0, 1.0, 8.0), (2.0, 9.0, 0.5), mass=35.0)
    at = BallisticRange([block])
    at.fire("grenade", elevation=0.0)
    at.update(0.5)
    at.update(0.5)
    expect_exactly(block.hits, 1, then="; block.hits")
    expect_exactly(len(at.shots), 0, then="; the number of shots in flight")
