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
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_that,
    expect_unchanged,
    scoped,
    xyz,
)

BURST_FRAME = 16  # of a quarter of a second each: 4 s

TWELVE = "A grenade bursts into 12 fragments (FRAGMENTS). Return a list of 12 particles."

ROUNDED = 1e-12  # some rounding errors of numbers up to 30


@scoped
def thrown(*, frames: int, others: tuple[str, ...] = ()) -> tuple[str, Any]:
    """Throw a grenade, fire others, and update the range in frames of a quarter of a second."""
    fired = "; ".join(f'r.fire("{name}")' for name in ("grenade", *others))
    about.call = f"r = BallisticRange(); {fired}; for i in range({frames}): r.update(0.25)"
    at = ballistics.BallisticRange()
    at.fire("grenade")
    for name in others:
        at.fire(name)
    for _ in range(frames):
        at.update(0.25)
    return about.call, at


@pytest.mark.exercise("4.1", asks="reverse its vertical velocity and multiply it by BOUNCE")
def test_a_bounce_reverses_and_reduces_the_velocity(rng: Random) -> None:
    x, vx, vz = number(rng), number(rng), number(rng)
    y, drawn = -round(rng.uniform(0.1, 0.9), 3), -round(rng.uniform(2.0, 9.0), 3)
    about.read = "the docstring of bounce"
    for vy in (drawn, -0.125):
        about.call = (
            f"p = Particle(position=Vector3({x}, {y}, 3), velocity=Vector3({vx}, {vy}, {vz})); "
            "bounce(p)"
        )
        p = Particle(Vector3(x, y, 3.0), Vector3(vx, vy, vz))
        grenade.bounce(p)
        mirrored = (
            "You move the grenade as far above the ground as it was below. Set its y to 0 instead."
        )
        about.cause = "Set the y of the grenade to 0, and leave x and z unchanged."
        below = f"You leave the grenade below the ground. {about.cause}"
        blame(xyz(p.position), [((x, -y, 3.0), mirrored), ((x, y, 3.0), below)])
        expect_close(xyz(p.position), (x, 0.0, 3.0), then="; p.position", unit="m")
        about.cause = (
            "Reverse the Y component of the velocity and multiply it by BOUNCE, which is 0.5. "
            "Multiply X and Z by SLIDE, which is 0.8."
        )
        wanted = (0.8 * vx, -0.5 * vy, 0.8 * vz)
        all_of_it = (
            "You reverse the Y component of the velocity without making it smaller. Also multiply "
            "it by BOUNCE, which is 0.5."
        )
        mistakes = [
            ((0.8 * vx, -vy, 0.8 * vz), all_of_it),
            (
                (vx, -0.5 * vy, vz),
                "You leave the X and Z components of the velocity unchanged. Multiply both by "
                "SLIDE, which is 0.8.",
            ),
            (
                (0.8 * vx, 0.5 * vy, 0.8 * vz),
                "You don't reverse the vertical velocity, so the grenade still moves down after "
                "the bounce. Flip the sign of its Y component.",
            ),
            (
                (vx, vy, vz),
                f"Your grenade doesn't bounce if it moves down at {-vy} m/s. Every grenade that "
                "is below the ground and moves down must bounce.",
            ),
        ]
        blame(xyz(p.velocity), mistakes)
        expect_close(xyz(p.velocity), wanted, then="; p.velocity", unit="m/s")


@pytest.mark.exercise("4.1", asks="on or above the ground does not change")
def test_a_grenade_on_or_above_the_ground_does_not_bounce(rng: Random) -> None:
    v = (number(rng), -round(rng.uniform(2.0, 9.0), 3), number(rng))
    about.read = "the docstring of bounce"
    for y in (0.0, round(rng.uniform(0.5, 9.0), 3)):
        about.cause = (
            f"You let a grenade bounce at y = {y}, which is not below the ground. Let it bounce "
            "only if y < 0."
        )
        about.call = f"p = Particle(position=Vector3(1, {y}, 3), velocity=Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, y, 3.0), Vector3(*v))
        grenade.bounce(p)
        now = xyz(p.position)
        expect_unchanged("p.position", now, (1.0, y, 3.0))
        expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.call = (
        f"p = Particle(position=Vector3(1, -1e-9, 3), velocity=Vector3{v}); bounce(p); p.position.y"
    )
    about.cause = (
        "This grenade is only 1e-9 m below the ground, but it must bounce too. Move every particle "
        "with y < 0 back to y = 0."
    )
    p = Particle(Vector3(1.0, -1e-9, 3.0), Vector3(*v))
    grenade.bounce(p)
    expect_close(p.position.y, 0.0, tolerance=0.0)


@pytest.mark.exercise("4.1", asks="If it is also moving down")
def test_a_grenade_that_does_not_move_down_keeps_its_velocity(rng: Random) -> None:
    about.cause = (
        "This grenade is already moving up or is at rest. Move it to y = 0, but change its "
        "velocity only if the velocity points down."
    )
    about.read = "the docstring of bounce"
    for vy in (round(rng.uniform(2.0, 9.0), 3), 0.0):
        v = (number(rng), vy, number(rng))
        about.call = f"p = Particle(position=Vector3(1, -0.5, 3), velocity=Vector3{v}); bounce(p)"
        p = Particle(Vector3(1.0, -0.5, 3.0), Vector3(*v))
        grenade.bounce(p)
        got = xyz(p.position)
        expect_close(got, (1.0, 0.0, 3.0), then="; p.position", unit="m")
        up = (
            "You change the velocity of a grenade that is not moving down. Change the velocity "
            "only if its Y component is negative."
        )
        expect_unchanged("p.velocity", xyz(p.velocity), v, cause=up)


@pytest.mark.exercise("4.1", asks="so that a burst conserves momentum")
def test_the_fragments_share_the_mass_and_the_momentum(rng: Random) -> None:
    x, v, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    a, damping = components(rng), round(rng.uniform(0.1, 0.8), 3)
    about.call = (
        f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a, mass={mass!r}, "
        f"damping={damping!r}); pieces = fragments(p)"
    )
    about.read = "the docstring of fragments"
    pieces = probes.burst(x, v, mass, a, damping)
    about.cause = TWELVE
    expect_exactly(len(pieces), 12, then="; len(pieces)")
    for piece in pieces:
        about.cause = (
            "The 12 fragments share the mass of the grenade equally. Give each of them a twelfth "
            "of that mass."
        )
        whole = (
            "You give each fragment the whole mass of the grenade. Divide that mass equally among "
            "the 12 fragments."
        )
        blame(piece[0], [(mass, whole)])
        expect_close(piece[0], mass / 12.0, then="; the mass of a fragment", unit="kg")
        for name, got, of_grenade in (
            ("damping", piece[1], damping),
            ("position", piece[2:5], x),
            ("acceleration", piece[8:], a),
        ):
            about.cause = (
                f"Your fragments don't get the {name} of the grenade. Pass its {name} to each new "
                "Particle."
            )
            expect_close(got, of_grenade, then=f"; the {name} of a fragment")
    about.cause = (
        "The directions of your fragments don't add up to 0, so the burst changes the total "
        "momentum. Choose them in opposite pairs, for example."
    )
    total = tuple(math.fsum(piece[0] * piece[axis] for piece in pieces) for axis in (5, 6, 7))
    wanted = tuple(mass * component for component in v)
    if max(abs(component) for component in total) < 1e-9:
        about.cause = (
            "You leave out the velocity of the grenade, so the total momentum of the fragments is "
            "0. Add the grenade's velocity to that of each fragment."
        )
    # The rounding errors of 12 numbers up to 25 x 9 / 12.
    name = "; the total momentum of the fragments"
    expect_close(total, wanted, then=name, unit="kg m/s", tolerance=1e-11)


@pytest.mark.exercise("4.1", asks="piece flies at FRAGMENT_SPEED in a different direction")
def test_the_fragments_fly_apart_each_with_15_meters_a_second(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about(
        f"p = Particle(position=Vector3{x}, velocity=Vector3{v}); pieces = fragments(p)",
        read="the docstring of fragments",
    )
    relative = [tuple(piece[5 + i] - v[i] for i in range(3)) for piece in probes.burst(x, v, 1.0)]
    cause = (
        "Each fragment must move at FRAGMENT_SPEED, which is 15 m/s, relative to the grenade. "
        "Normalize its direction before you multiply by this speed."
    )
    left_out = (
        "You leave out the velocity of the grenade. Add it to the velocity of each fragment, which "
        "is 15 m/s only relative to the grenade."
    )
    name = "; the speed of a fragment relative to the grenade p"
    for velocity in relative:
        own = math.hypot(*(n + v[i] for i, n in enumerate(velocity)))
        about.cause = left_out if abs(own - 15.0) < 1e-9 else cause
        expect_close(math.hypot(*velocity), 15.0, then=name, unit="m/s", tolerance=1e-11)
    expect_exactly(len(relative), 12, then="; len(pieces)", cause=TWELVE)
    pairs = [math.dist(a, b) for a, b in itertools.combinations(relative, 2)]
    about.cause = (
        "Several of your fragments fly in the same direction. Give each of the 12 fragments a "
        "different direction."
    )
    near = sum(pair < 0.1 for pair in pairs)
    name = "; the number of pairs of fragments with the same velocity, to within 0.1 m/s"
    expect_exactly(near, 0, then=name)


@pytest.mark.exercise("4.1", asks="The particle of the grenade does not change")
def test_a_burst_leaves_the_grenade_as_it_was(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about.call = (
        f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, mass=6); pieces = fragments(p)"
    )
    about.cause = (
        "A fragment shares a vector with the grenade or with another fragment. Create a new "
        "particle with new vectors for each fragment."
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


@pytest.mark.exercise("4.1", asks="now below the ground, let it bounce first")
def test_a_grenade_bounces_until_its_fuse_has_burnt() -> None:
    frames = BURST_FRAME - 1
    about.call = 'r = BallisticRange(); r.fire("grenade"); '
    about.call += f"for i in range({frames}): r.update(0.25)"
    about.cause = (
        "Your grenade disappears before its fuse has burned down, perhaps because it falls below "
        "the ground. In update, call grenade_after for each grenade, which calls bounce before "
        "is_spent."
    )
    about.read = "the docstrings of update and grenade_after"
    heights = probes.heights_of("grenade", 0.25, frames)
    expect_exactly(
        len(heights),
        frames,
        then="; the number of updates that the grenade survives",
    )
    about.cause = "The grenade never returns to y = 0. Let bounce move it there when it lands."
    lowest = min(heights)
    if lowest > ROUNDED and len(thrown(frames=1)[1].shots) > 1:
        about.cause = "Your grenade bursts in the first update, so it never reaches the ground. It "
        about.cause += "must not burst before its age reaches FUSE, which is 4 s."
    # It lands in frame 12 and is put back to exactly 0.
    lowest_of = "; the lowest height that the grenade reaches"
    expect_close(lowest, 0.0, then=lowest_of, unit="m", tolerance=ROUNDED)
    landed = heights.index(lowest)
    about.cause = (
        "The grenade does not rise again after its bounce. It must leave the ground at half the "
        "speed at which it fell."
    )
    risen = max(heights[landed:])
    highest = "; the greatest height after the bounce"
    expect_that(risen > 0.5, f"{risen:.6g} m", "more than 0.5 m", then=highest)


@pytest.mark.exercise("4.1", asks="If the age of the grenade has reached FUSE")
def test_a_grenade_bursts_when_its_age_has_reached_4_seconds() -> None:
    about(
        cause="The fuse of a grenade burns for 4 s (FUSE). Until then, keep the grenade in the "
        "list and don't let it burst."
    )
    about.read = "the docstring of grenade_after"
    about.call, at = thrown(frames=BURST_FRAME - 1)
    types = tuple(shot.type for shot in at.shots)
    expect_exactly(types, ("grenade",), then="; the types of the shots")
    about.cause = (
        "After 4 s, your grenade has not burst into 12 fragments. Return 12 shots of the type "
        "fragment as soon as the age of the grenade reaches FUSE."
    )
    about.call, at = thrown(frames=BURST_FRAME)
    types = tuple(shot.type for shot in at.shots)
    if types == ("grenade",) * 12:
        about.cause = (
            "The 12 shots of your burst still have the type grenade. Give each of them the type "
            "fragment."
        )
    if "grenade" in types and "fragment" in types:
        about.cause = "The grenade is still there. In update, replace the grenade by its fragments."
    kinds = " and ".join(sorted({str(type) for type in types}))
    shown = f"{len(types)} shot{'s' * (len(types) != 1)}{' of type ' * bool(types)}{kinds}"
    holds = types == ("fragment",) * 12
    expect_that(holds, shown, "12 shots of type fragment", then="; the shots on the range")
    ages = tuple(shot.age for shot in at.shots)
    expect_close(ages, (0.0,) * 12, then="; the ages of the shots in s", tolerance=0.0)


@pytest.mark.exercise("4.1", asks="replace each grenade by the shots")
def test_other_shots_fly_on_and_spent_fragments_are_removed() -> None:
    about.read = "the docstrings of update and is_spent"
    about.cause = "Only the grenade bursts, and the fireball keeps flying."
    about.call, at = thrown(frames=BURST_FRAME, others=("fireball",))
    types = [shot.type for shot in at.shots]
    about.cause += " In the list, put the fragments where the grenade was, before the fireball."
    expect_exactly(
        types, ["fragment"] * 12 + ["fireball"], then="; the types of the shots, in order"
    )
    about.cause = (
        "Some fragments are still in the list. Only grenades bounce, so remove a fragment that "
        "falls below the ground, like any other shot."
    )
    about.call, at = thrown(frames=BURST_FRAME + 40)
    expect_exactly(len(at.shots), 0, then="; the number of shots")


@pytest.mark.exercise("4.1", asks="an empty list if is_spent is True for it")
def test_a_grenade_past_the_end_of_the_range_is_spent() -> None:
    about.call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); len(grenade_after(shot))'
    about.cause = (
        "You keep a grenade that is past the end of the range, at z = 201 m. Call is_spent for "
        "grenades too, and return an empty list if it returns True."
    )
    about.read = "the docstring of grenade_after"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 0)
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 2; grenade_after(shot)'
    )
    about.cause = (
        "This grenade is still in flight, and its fuse still burns. Return a list that contains "
        "only the grenade."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 2.0
    left = [(each.type, each.age) for each in ballistics.grenade_after(shot)]
    expect_exactly(left, [("grenade", 2.0)], then="; (type, age) of each shot in the result")


@pytest.mark.exercise("4.1", asks="let it bounce first. Then check its fuse")
def test_a_grenade_bounces_before_it_bursts_and_bursts_before_it_is_spent() -> None:
    about.read = "the docstring of grenade_after"
    about.call = (
        "p = Particle(position=Vector3(0, -0.5, 9), velocity=Vector3(0, -8, 5)); shot = "
        'Shot("grenade", p); shot.age = 4; grenade_after(shot)'
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0.0, -8.0, 5.0)))
    shot.age = 4.0
    left = ballistics.grenade_after(shot)
    about.cause = (
        "Your grenade bursts before it bounces, so its fragments start below the ground. Call "
        "bounce before fragments."
    )
    heights = [each.particle.position.y for each in left]
    if len(heights) != 12:
        about.cause = TWELVE
    expect_close(
        heights, [0.0] * 12, then="; the heights of the 12 fragments", unit="m", tolerance=0.0
    )
    about.cause = (
        "The fragments must get the velocity that the grenade has after its bounce, 4 m/s upward "
        "and 4 m/s along Z. Call bounce before fragments."
    )
    mean = [math.fsum(each.particle.velocity.y for each in left) / 12.0]
    mean.append(math.fsum(each.particle.velocity.z for each in left) / 12.0)
    expect_close(
        mean,
        (4.0, 4.0),
        then="; the mean velocity of the fragments along Y and along Z, in m/s",
        tolerance=ROUNDED,
    )
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); shot.age = 6; '
        "len(grenade_after(shot))"
    )
    about.cause = (
        "You call is_spent before you check the fuse, so this grenade disappears without a burst. "
        "Check the fuse first."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    shot.age = 6.0
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 12)
