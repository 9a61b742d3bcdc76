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
from expect import about, blame, expect_close, expect_exactly, expect_unchanged, scoped, xyz

BURST_FRAME = 16  # of a quarter of a second each: 4 s

ROUNDED = 1e-12  # some rounding errors of numbers up to 30


@scoped
def thrown(*, frames: int, others: tuple[str, ...] = ()) -> tuple[str, Any]:
    """Throw a grenade, fire others, and update the range in frames of a quarter of a second."""
    fired = "; ".join(f'r.fire("{name}")' for name in ("grenade", *others))
    about.call = f"{fired}; r.update(0.25) {frames} times; r.shots"
    at = ballistics.BallisticRange()
    at.fire("grenade")
    for name in others:
        at.fire(name)
    for _ in range(frames):
        at.update(0.25)
    return about.call, at


@pytest.mark.exercise("4.1")
def test_a_bounce_turns_half_of_the_fall_upwards(rng: Random) -> None:
    x, vx, vz = number(rng), number(rng), number(rng)
    y, drawn = -round(rng.uniform(0.1, 0.9), 3), -round(rng.uniform(2.0, 9.0), 3)
    about.read = "the docstring of bounce"
    for vy in (drawn, -0.125):
        about.call = f"p = Particle(Vector3({x}, {y}, 3), Vector3({vx}, {vy}, {vz})); bounce(p)"
        p = Particle(Vector3(x, y, 3.0), Vector3(vx, vy, vz))
        grenade.bounce(p)
        mirrored = (
            "You put the grenade as high above the ground as it was below. Set y to 0 instead."
        )
        about.cause = (
            "A grenade that is below the ground must be moved back to the surface. Set y to 0, and "
            "leave x and z unchanged."
        )
        blame(xyz(p.position), [((x, -y, 3.0), mirrored)])
        expect_close(xyz(p.position), (x, 0.0, 3.0), then="; p.position")
        about.cause = (
            "Reverse the Y component of the velocity and multiply it by BOUNCE, which is 0.5. "
            "Multiply the X and Z components by SLIDE, which is 0.8."
        )
        wanted = (0.8 * vx, -0.5 * vy, 0.8 * vz)
        all_of_it = (
            "The vertical velocity was reversed, but the grenade did not slow down. Multiply it by "
            "BOUNCE, which is 0.5."
        )
        mistakes = [
            ((0.8 * vx, -vy, 0.8 * vz), all_of_it),
            (
                (vx, -0.5 * vy, vz),
                (
                    "The velocity along the ground did not change, but a bounce must slow it down. "
                    "Multiply it by SLIDE, which is 0.8."
                ),
            ),
            (
                (0.8 * vx, 0.5 * vy, 0.8 * vz),
                "The grenade still moves down after the bounce. Flip the sign of its velocity "
                "along Y.",
            ),
            (
                (vx, vy, vz),
                "The velocity did not change, but a grenade that drops below the ground must "
                "bounce.",
            ),
        ]
        blame(xyz(p.velocity), mistakes)
        expect_close(xyz(p.velocity), wanted, then="; p.velocity")


@pytest.mark.exercise("4.1")
def test_what_is_not_below_the_ground_does_not_bounce(rng: Random) -> None:
    v = (number(rng), -round(rng.uniform(2.0, 9.0), 3), number(rng))
    about(
        cause="This grenade is not below the ground, so it must not bounce. Below the ground "
        "means y < 0.",
        read="the docstring of bounce",
    )
    for y in (0.0, round(rng.uniform(0.5, 9.0), 3)):
        about.call = f"p = Particle(Vector3(1, {y}, 3), Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, y, 3.0), Vector3(*v))
        grenade.bounce(p)
        now = xyz(p.position)
        expect_unchanged("p.position", now, (1.0, y, 3.0))
        expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.call = f"p = Particle(Vector3(1, -1e-9, 3), Vector3{v}); bounce(p); p.position.y"
    about.cause = "Even a grenade that is only 1e-9 m below the ground must be moved back to y = 0."
    p = Particle(Vector3(1.0, -1e-9, 3.0), Vector3(*v))
    grenade.bounce(p)
    expect_close(p.position.y, 0.0, tolerance=0.0)


@pytest.mark.exercise("4.1")
def test_what_rises_already_is_not_turned_round_again(rng: Random) -> None:
    about.cause = (
        "This grenade is no longer falling. Reverse the velocity only if it points down, or you "
        "send the grenade back into the ground."
    )
    about.read = "the docstring of bounce"
    for vy in (round(rng.uniform(2.0, 9.0), 3), 0.0):
        v = (number(rng), vy, number(rng))
        about.call = f"p = Particle(Vector3(1, -0.5, 3), Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, -0.5, 3.0), Vector3(*v))
        grenade.bounce(p)
        got = xyz(p.position)
        expect_close(got, (1.0, 0.0, 3.0), then="; p.position")
        expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("4.1")
def test_the_fragments_share_the_mass_and_the_momentum(rng: Random) -> None:
    x, v, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    a, damping = components(rng), round(rng.uniform(0.1, 0.8), 3)
    about.call = (
        f"fragments(p), p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass={mass!r}, "
        f"damping={damping!r})"
    )
    about.read = "the docstring of fragments"
    pieces = probes.burst(x, v, mass, a, damping)
    about.cause = (
        "A grenade bursts into 12 fragments (FRAGMENTS), so return a list of 12 particles."
    )
    expect_exactly(len(pieces), 12, then=", how many")
    for piece in pieces:
        about.cause = (
            "The fragments share the mass of the grenade equally, so each has a twelfth of it."
        )
        expect_close(piece[0], mass / 12.0, then=", a mass")
        about.cause = (
            "Each fragment must have the position, acceleration and damping of the grenade."
        )
        expect_close(piece[1], damping, then=", a damping")
        expect_close(piece[2:5], x, then=", a position")
        expect_close(piece[8:], a, then=", an acceleration")
    about.cause = (
        "A burst doesn't change the total momentum, so the velocities of the fragments relative to "
        "the grenade must add up to 0."
    )
    total = tuple(math.fsum(piece[0] * piece[axis] for piece in pieces) for axis in (5, 6, 7))
    wanted = tuple(mass * component for component in v)
    if max(abs(component) for component in total) < 1e-9:
        about.cause = (
            "The total momentum of the fragments is 0, so the motion of the grenade was lost. Add "
            "the grenade's velocity to that of each fragment."
        )
    # The rounding errors of 12 numbers up to 25 x 9 / 12.
    expect_close(total, wanted, then=", momentum", tolerance=1e-11)


@pytest.mark.exercise("4.1")
def test_the_fragments_fly_apart_each_with_15_meters_a_second(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about(f"fragments(p), p = Particle(Vector3{x}, Vector3{v})", read="the docstring of fragments")
    relative = [tuple(piece[5 + i] - v[i] for i in range(3)) for piece in probes.burst(x, v, 1.0)]
    about.cause = (
        "Each fragment must move at FRAGMENT_SPEED relative to the grenade. Check the length of "
        "the velocity that you add to the grenade's."
    )
    for velocity in relative:
        expect_close(
            math.hypot(*velocity), 15.0, then=", speed of a fragment relative to p", tolerance=1e-11
        )
    expect_exactly(
        len(relative),
        12,
        then=", how many",
        cause="A grenade bursts into 12 fragments, so return a list of 12 particles.",
    )
    pairs = [math.dist(a, b) for a, b in itertools.combinations(relative, 2)]
    about.cause = (
        "At least two fragments fly in the same direction. Give each of them a direction of its "
        "own."
    )
    near = sum(pair < 0.1 for pair in pairs)
    expect_exactly(near, 0, then=", how many pairs of velocities differ by less than 0.1 m/s")


@pytest.mark.exercise("4.1")
def test_a_burst_leaves_the_grenade_as_it_was(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about.call = f"p = Particle(Vector3{x}, Vector3{v}, mass=6); pieces = fragments(p)"
    about.cause = (
        "Each fragment must be a new particle with its own vectors, so that changing one fragment "
        "affects neither the grenade nor the other fragments."
    )
    about.read = "the docstring of fragments"
    p = Particle(Vector3(*x), Vector3(*v), mass=6.0)
    pieces = grenade.fragments(p)
    pieces[0].position.x = 99.0
    about.call += "; pieces[0].position.x = 99"
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    expect_close(p.mass, 6.0, then="; p.mass")
    now = xyz(pieces[1].position)
    expect_unchanged("pieces[1].position", now, x)


@pytest.mark.exercise("4.1")
def test_a_grenade_bounces_until_its_fuse_has_burnt() -> None:
    frames = BURST_FRAME - 1
    about.call = f'r.fire("grenade"); r.update(0.25) {frames} times; its height after each'
    about.cause = (
        "A grenade that hits the ground must bounce, so it is not spent there. Call bounce before "
        "is_spent."
    )
    about.read = "the docstrings of update and grenade_after"
    heights = probes.heights_of("grenade", 0.25, frames)
    expect_exactly(len(heights), frames, then=", how many heights")
    about.cause = (
        "The grenade lands in step 12, and bounce must move it back to y = 0. It must not burst "
        "until its fuse of 4 s has burnt down."
    )
    lowest = min(heights)
    # It lands in frame 12 and is put back to exactly 0.
    expect_close(lowest, 0.0, then=", the lowest", tolerance=ROUNDED)
    landed = heights.index(lowest)
    about.cause = (
        "After the bounce, the grenade must rise again, at half the speed with which it hit the "
        "ground."
    )
    risen = max(heights[landed:]) > 0.5
    expect_exactly(risen, True, then=", over 0.5 m after that")


@pytest.mark.exercise("4.1")
def test_a_grenade_bursts_when_its_age_has_reached_4_seconds() -> None:
    about(
        cause="The fuse burns for 4 s, which is the value of FUSE. Until then, the grenade must "
        "not burst."
    )
    about.read = "the docstring of grenade_after"
    about.call, at = thrown(frames=BURST_FRAME - 1)
    types = tuple(shot.type for shot in at.shots)
    expect_exactly(types, ("grenade",), then=", their types")
    about.cause = (
        "The grenade is now 4 s old, so it must burst. Replace it with 12 shots of type fragment "
        "and age 0."
    )
    about.call, at = thrown(frames=BURST_FRAME)
    types = tuple(shot.type for shot in at.shots)
    if types == ("grenade",) * 12:
        about.cause = (
            "The grenade burst into 12 shots, but they still have the type of the grenade. Give "
            "each of them the type fragment."
        )
    expect_exactly(types, ("fragment",) * 12, then=", their types")
    ages = tuple(shot.age for shot in at.shots)
    expect_close(ages, (0.0,) * 12, then=", their ages", tolerance=0.0)


@pytest.mark.exercise("4.1")
def test_other_shots_go_on_and_fragments_are_spent_like_them() -> None:
    about.read = "the docstrings of update and is_spent"
    about.cause = "Only the grenade bursts. The fireball has no fuse, so it flies on."
    about.call, at = thrown(frames=BURST_FRAME, others=("fireball",))
    types = [shot.type for shot in at.shots]
    about.cause += (
        " In the list, the fragments take the place of their grenade, ahead of the fireball."
    )
    expect_exactly(types, ["fragment"] * 12 + ["fireball"], then=", their types in order")
    about.cause = (
        "Only grenades bounce. Remove a fragment that falls below the ground, like any other shot."
    )
    about.call, at = thrown(frames=BURST_FRAME + 40)
    expect_exactly(len(at.shots), 0, then=", how many")


@pytest.mark.exercise("4.1")
def test_a_grenade_past_the_end_of_the_range_is_spent() -> None:
    about.call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); grenade_after(shot)'
    about.cause = (
        "This grenade is past the end of the range, so it is spent. Call is_spent for grenades too."
    )
    about.read = "the docstring of grenade_after"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 0, then=", how many")
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 2; grenade_after(shot)'
    )
    about.cause = (
        "This grenade is still in flight and its fuse still burns. Return a list with only the "
        "grenade in it."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 2.0
    left = [(each.type, each.age) for each in ballistics.grenade_after(shot)]
    expect_exactly(left, [("grenade", 2.0)])


@pytest.mark.exercise("4.1")
def test_a_grenade_bounces_before_it_bursts_and_bursts_before_it_is_spent() -> None:
    about.read = "the docstring of grenade_after"
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0, -8, 5))); shot.age = 4; '
        "grenade_after(shot)"
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0.0, -8.0, 5.0)))
    shot.age = 4.0
    left = ballistics.grenade_after(shot)
    about.cause = (
        "This grenade is below the ground when its fuse burns down. Let it bounce first, so that "
        "the fragments start on the ground."
    )
    heights = [each.particle.position.y for each in left]
    expect_close(heights, [0.0] * 12, then=", heights", tolerance=0.0)
    about.cause = (
        "The fragments must inherit the velocity from after the bounce, which is 4 m/s upward and "
        "4 m/s along Z. Call bounce before fragments."
    )
    mean = [math.fsum(each.particle.velocity.y for each in left) / 12.0]
    mean.append(math.fsum(each.particle.velocity.z for each in left) / 12.0)
    expect_close(
        mean, (4.0, 4.0), then=", means of the velocities along Y and Z", tolerance=ROUNDED
    )
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); shot.age = 6; grenade_after(shot)'
    )
    about.cause = (
        "A grenade whose fuse has burnt down bursts, even past the end of the range. Check the "
        "fuse before you call is_spent."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    shot.age = 6.0
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 12, then=", how many")
