"""The grenade, mini-project 4.1."""

from __future__ import annotations

import itertools
import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import ballistics, grenade, probes
from draw import components, number
from expect import cause_of, expect_close, expect_exactly, expect_unchanged, xyz

BURST_FRAME = 16  # of a quarter of a second each: 4 s

ROUNDED = 1e-12  # some roundings of numbers up to 30


def thrown(*, frames: int, others: tuple[str, ...] = ()) -> tuple[str, Any]:
    """Throw a grenade, fire others, and let frames of a quarter of a second pass."""
    fired = "; ".join(f'r.fire("{name}")' for name in ("grenade", *others))
    call = f"{fired}; r.update(0.25) {frames} times; r.shots"
    at = ballistics.BallisticRange()
    at.fire("grenade")
    for name in others:
        at.fire(name)
    for _ in range(frames):
        at.update(0.25)
    return call, at


@pytest.mark.exercise("4.1")
def test_a_bounce_turns_half_of_the_fall_upwards(rng: Random) -> None:
    x, vx, vz = number(rng), number(rng), number(rng)
    y, drawn = -round(rng.uniform(0.1, 0.9), 3), -round(rng.uniform(2.0, 9.0), 3)
    read = "the docstring of bounce"
    for vy in (drawn, -0.125):
        call = f"p = Particle(Vector3({x}, {y}, 3), Vector3({vx}, {vy}, {vz})); bounce(p)"
        p = Particle(Vector3(x, y, 3.0), Vector3(vx, vy, vz))
        grenade.bounce(p)
        mirrored = "it was put as high above the ground as it was below: y is 0 on the ground"
        cause = "below the ground it is put back to y = 0; x and z stay"
        cause = cause_of(xyz(p.position), [((x, -y, 3.0), mirrored)], cause)
        expect_close(f"{call}; p.position", xyz(p.position), (x, 0.0, 3.0), cause=cause, read=read)
        cause = (
            "half of the speed downwards comes back upwards, and 0.8 of what is along the ground"
        )
        wanted = (0.8 * vx, -0.5 * vy, 0.8 * vz)
        all_of_it = "all of the speed downwards came back: BOUNCE is half of it"
        mistakes = [
            ((0.8 * vx, -vy, 0.8 * vz), all_of_it),
            ((vx, -0.5 * vy, vz), "what is along the ground was kept whole: SLIDE is 0.8 of it"),
            ((0.8 * vx, 0.5 * vy, 0.8 * vz), "it still falls: the sign along Y is turned round"),
            ((vx, vy, vz), "the velocity is as it was: it moves down, so it bounces"),
        ]
        cause = cause_of(xyz(p.velocity), mistakes, cause)
        expect_close(f"{call}; p.velocity", xyz(p.velocity), wanted, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_what_is_not_below_the_ground_does_not_bounce(rng: Random) -> None:
    v = (number(rng), -round(rng.uniform(2.0, 9.0), 3), number(rng))
    cause = "only y < 0 is below the ground"
    read = "the docstring of bounce"
    for y in (0.0, round(rng.uniform(0.5, 9.0), 3)):
        call = f"p = Particle(Vector3(1, {y}, 3), Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, y, 3.0), Vector3(*v))
        grenade.bounce(p)
        now = xyz(p.position)
        expect_unchanged(call, "p.position", now, (1.0, y, 3.0), cause=cause, read=read)
        expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)
    call = f"p = Particle(Vector3(1, -1e-9, 3), Vector3{v}); bounce(p); p.position.y"
    cause = "below the ground is below the ground, by however little"
    p = Particle(Vector3(1.0, -1e-9, 3.0), Vector3(*v))
    grenade.bounce(p)
    expect_close(call, p.position.y, 0.0, cause=cause, read=read, tolerance=0.0)


@pytest.mark.exercise("4.1")
def test_what_rises_already_is_not_turned_round_again(rng: Random) -> None:
    cause = "turned round it would be sent into the ground: only a velocity downwards is changed"
    read = "the docstring of bounce"
    for vy in (round(rng.uniform(2.0, 9.0), 3), 0.0):
        v = (number(rng), vy, number(rng))
        call = f"p = Particle(Vector3(1, -0.5, 3), Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, -0.5, 3.0), Vector3(*v))
        grenade.bounce(p)
        got = xyz(p.position)
        expect_close(f"{call}; p.position", got, (1.0, 0.0, 3.0), cause=cause, read=read)
        expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_the_fragments_share_the_mass_and_the_momentum(rng: Random) -> None:
    x, v, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    a, damping = components(rng), round(rng.uniform(0.1, 0.8), 3)
    call = f"fragments(p), p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, {mass=}, {damping=})"
    read = "the docstring of fragments"
    pieces = probes.burst(x, v, mass, a, damping)
    cause = "FRAGMENTS is 12"
    expect_exactly(f"{call}, how many", len(pieces), 12, cause=cause, read=read)
    for piece in pieces:
        cause = "equal masses, a twelfth of the grenade's each"
        expect_close(f"{call}, a mass", piece[0], mass / 12.0, cause=cause, read=read)
        cause = "the acceleration and the damping are the grenade's, and so is the place"
        expect_close(f"{call}, a damping", piece[1], damping, cause=cause, read=read)
        expect_close(f"{call}, a position", piece[2:5], x, cause=cause, read=read)
        expect_close(f"{call}, an acceleration", piece[8:], a, cause=cause, read=read)
    cause = "the momenta must add up to m v: velocities relative to the grenade add up to 0"
    total = tuple(math.fsum(piece[0] * piece[axis] for piece in pieces) for axis in (5, 6, 7))
    wanted = tuple(mass * component for component in v)
    if max(abs(component) for component in total) < 1e-9:
        cause = "the fragments have the velocity of the grenade besides their own"
    # 12 roundings of numbers up to 25 x 9 / 12.
    expect_close(f"{call}, momentum", total, wanted, cause=cause, read=read, tolerance=1e-11)


@pytest.mark.exercise("4.1")
def test_the_fragments_fly_apart_each_with_15_metres_a_second(rng: Random) -> None:
    x, v = components(rng), components(rng)
    call = f"fragments(p), p = Particle(Vector3{x}, Vector3{v})"
    read = "the docstring of fragments"
    relative = [tuple(piece[5 + i] - v[i] for i in range(3)) for piece in probes.burst(x, v, 1.0)]
    cause = "FRAGMENT_SPEED is the length of the velocity relative to the grenade"
    for velocity in relative:
        name = f"{call}, a speed relative to p"
        expect_close(name, math.hypot(*velocity), 15.0, cause=cause, read=read, tolerance=1e-11)
    expect_exactly(f"{call}, how many", len(relative), 12, cause="12 pieces", read=read)
    pairs = [math.dist(a, b) for a, b in itertools.combinations(relative, 2)]
    cause = "two fragments fly the same way: each has a direction of its own"
    name = f"{call}, pairs of velocities that are within 0.1 m/s"
    near = sum(pair < 0.1 for pair in pairs)
    expect_exactly(name, near, 0, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_a_burst_leaves_the_grenade_as_it_was(rng: Random) -> None:
    x, v = components(rng), components(rng)
    call = f"p = Particle(Vector3{x}, Vector3{v}, mass=6); pieces = fragments(p)"
    cause = "each fragment is a new particle, with vectors of its own"
    read = "the docstring of fragments"
    p = Particle(Vector3(*x), Vector3(*v), mass=6.0)
    pieces = grenade.fragments(p)
    pieces[0].position.x = 99.0
    call += "; pieces[0].position.x = 99"
    expect_unchanged(call, "p.position", xyz(p.position), x, cause=cause, read=read)
    expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)
    expect_close(f"{call}; p.mass", p.mass, 6.0, cause=cause, read=read)
    now = xyz(pieces[1].position)
    expect_unchanged(call, "pieces[1].position", now, x, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_a_grenade_bounces_until_its_fuse_has_burnt() -> None:
    frames = BURST_FRAME - 1
    call = f'r.fire("grenade"); r.update(0.25) {frames} times; its height after each'
    cause = "a grenade below the ground is not spent: bounce comes before is_spent"
    read = "the docstrings of update and grenade_after"
    heights = probes.heights_of("grenade", 0.25, frames)
    name = f"{call}, how many heights"
    expect_exactly(name, len(heights), frames, cause=cause, read=read)
    cause = "it lands in frame 12, and bounce puts it back to y = 0; before 4 s it does not burst"
    lowest = min(heights)
    # It lands in frame 12, and is put back to exactly 0.
    expect_close(f"{call}, the lowest", lowest, 0.0, cause=cause, read=read, tolerance=ROUNDED)
    landed = heights.index(lowest)
    cause = "after the bounce it rises again, with half of its speed"
    risen = max(heights[landed:]) > 0.5
    expect_exactly(f"{call}, over 0.5 m after that", risen, True, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_a_grenade_bursts_when_its_age_has_reached_4_seconds() -> None:
    read = "the docstring of grenade_after"
    cause = "FUSE is 4 s: before, there is one grenade"
    call, at = thrown(frames=BURST_FRAME - 1)
    types = tuple(shot.type for shot in at.shots)
    expect_exactly(f"{call}, their types", types, ("grenade",), cause=cause, read=read)
    cause = "at 4 s its 12 fragments take its place, shots of the type fragment and of age 0"
    call, at = thrown(frames=BURST_FRAME)
    types = tuple(shot.type for shot in at.shots)
    expect_exactly(f"{call}, their types", types, ("fragment",) * 12, cause=cause, read=read)
    ages = tuple(shot.age for shot in at.shots)
    expect_close(f"{call}, their ages", ages, (0.0,) * 12, cause=cause, read=read, tolerance=0.0)


@pytest.mark.exercise("4.1")
def test_other_shots_go_on_and_fragments_are_spent_like_them() -> None:
    read = "the docstrings of update and is_spent"
    cause = "only the grenade bursts: the fireball flies on, and no shot of another type has a fuse"
    call, at = thrown(frames=BURST_FRAME, others=("fireball",))
    types = [shot.type for shot in at.shots]
    name = f"{call}, their types in order"
    cause += ". The fragments stand where their grenade stood, before the younger fireball"
    expect_exactly(name, types, ["fragment"] * 12 + ["fireball"], cause=cause, read=read)
    cause = "fragments do not bounce: below the ground they are dropped, as any other shot is"
    call, at = thrown(frames=BURST_FRAME + 40)
    expect_exactly(f"{call}, how many", len(at.shots), 0, cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_a_grenade_past_the_end_of_the_range_is_spent() -> None:
    call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); grenade_after(shot)'
    cause = "it bounces, but is_spent holds for it as for any other shot"
    read = "the docstring of grenade_after"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    left = ballistics.grenade_after(shot)
    expect_exactly(f"{call}, how many", len(left), 0, cause=cause, read=read)
    call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 2; grenade_after(shot)'
    cause = "the grenade itself is left, alone in a list"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 2.0
    left = [(each.type, each.age) for each in ballistics.grenade_after(shot)]
    expect_exactly(call, left, [("grenade", 2.0)], cause=cause, read=read)


@pytest.mark.exercise("4.1")
def test_a_grenade_bounces_before_it_bursts_and_bursts_before_it_is_spent() -> None:
    read = "the docstring of grenade_after"
    call = (
        'shot = Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0, -8, 5))); shot.age = 4; '
    )
    call += "grenade_after(shot)"
    shot = ballistics.Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0.0, -8.0, 5.0)))
    shot.age = 4.0
    left = ballistics.grenade_after(shot)
    cause = "first the bounce, so that the fragments start on the ground and not below it"
    heights = [each.particle.position.y for each in left]
    expect_close(f"{call}, heights", heights, [0.0] * 12, cause=cause, read=read, tolerance=0.0)
    cause = "and with the velocity after the bounce, 4 m/s upwards and 4 m/s along Z"
    mean = [math.fsum(each.particle.velocity.y for each in left) / 12.0]
    mean.append(math.fsum(each.particle.velocity.z for each in left) / 12.0)
    name = f"{call}, means of the velocities along Y and Z"
    expect_close(name, mean, (4.0, 4.0), cause=cause, read=read, tolerance=ROUNDED)
    call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); shot.age = 6; grenade_after(shot)'
    cause = "once its fuse has burnt it bursts, wherever it is and however old"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    shot.age = 6.0
    left = ballistics.grenade_after(shot)
    expect_exactly(f"{call}, how many", len(left), 12, cause=cause, read=read)
