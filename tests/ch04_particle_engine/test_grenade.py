"""A grenade that bounces and bursts, mini-project 4.1."""

from __future__ import annotations

import itertools
import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import grenade, probes
from draw import components, number
from expect import (
    about,
    blame,
    expect_close,
    expect_exactly,
    expect_unchanged,
    xyz,
)

LOOP = (
    "You return only one fragment, perhaps because the return statement is inside the loop. Return "
)
LOOP += "a list of all 12 after the loop."
TWELVE = "A grenade bursts into 12 fragments (FRAGMENTS). Return a list of 12 particles."

ROUNDED = 1e-12  # some rounding errors of numbers up to 30


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
        about.cause = "Set the y of the grenade to 0, and leave x and z unchanged."
        grenade.bounce(p)
        mirrored = (
            "You move the grenade as far above the ground as it was below. Set its y to 0 instead."
        )
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
                "is below the ground and moves down must bounce."
                if vy == -0.125
                else "You move the grenade up to the ground, but leave its velocity unchanged. "
                "Change the components of p.velocity, or assign a new vector to it.",
            ),
            (
                (-0.5 * vx, -0.5 * vy, -0.5 * vz),
                "You multiply all three components by -BOUNCE. Only the Y component is reversed. "
                "Multiply X and Z by SLIDE, which is 0.8.",
            ),
            (
                (0.5 * vx, -0.8 * vy, 0.5 * vz),
                "You have swapped BOUNCE and SLIDE. Multiply Y by -BOUNCE, and X and Z by SLIDE.",
            ),
            (
                (0.8 * vx, -0.4 * vy, 0.8 * vz),
                "You multiply the Y component by SLIDE too. Multiply it by -BOUNCE only.",
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
    about.cause, shares = TWELVE, about.cause
    pieces = grenade.fragments(p)
    about.cause = LOOP if len(pieces) == 1 else TWELVE
    expect_exactly(len(pieces), 12, then="; len(pieces)")
    about.cause = (
        "You change the velocity of the grenade, so each fragment starts with the speed of all "
        "the ones before it. Add the two velocities in a new vector."
    )
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = "You change the mass of the grenade. Compute the mass of a fragment from it."
    expect_close(p.mass, 6.0, then="; p.mass")
    about.cause = shares
    pieces[0].position.x = 99.0
    about.call += "; pieces[0].position.x = 99"
    expect_unchanged("p.position", xyz(p.position), x)
    now = xyz(pieces[1].position)
    expect_unchanged("pieces[1].position", now, x)


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
    about.cause = LOOP if len(pieces) == 1 else TWELVE
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
    speed, still = math.hypot(*v), (0.0, 0.0, 0.0)
    mistakes = [
        (
            tuple(mass / 12.0 * component for component in v),
            "You divide the velocity of the grenade by 12. The fragments share only its mass, and "
            "each of them keeps its whole velocity.",
        ),
        (
            tuple(mass * component * (1.0 + 15.0 / speed) for component in v),
            "All of your fragments fly on in the direction of the grenade. Give each of them a "
            "different direction, so that the directions add up to 0.",
        ),
    ]
    blame(total, mistakes)
    if math.dist(total, still) < 1e-9:
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
