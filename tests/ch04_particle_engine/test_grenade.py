"""A grenade that bounces and bursts, mini-project 4.1."""

from __future__ import annotations

import itertools
import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.grenade import bounce, fragments
from draw import Triple, number, vector
from expect import expect_close, expect_exactly, expect_unchanged

BOUNCE, FRAGMENTS = "the docstring of bounce", "the docstring of fragments"
LOOP = (
    "You return only one fragment, perhaps because the return statement is inside the loop. Return "
    "a list of all 12 after the loop."
)
TWELVE = "A grenade bursts into 12 fragments (FRAGMENTS). Return a list of 12 particles."


def expect_twelve(count: int) -> None:
    __tracebackhide__ = True
    expect_exactly(count, 12, then="; len(pieces)", cause=LOOP if count == 1 else TWELVE)


@pytest.mark.exercise(
    "4.1", asks="reverse its vertical velocity and multiply it by BOUNCE", read=BOUNCE
)
def test_a_bounce_reverses_and_reduces_the_velocity(rng: Random) -> None:
    x, vx, vz = number(rng), number(rng), number(rng)
    y, drawn = -round(rng.uniform(0.1, 0.9), 3), -round(rng.uniform(2.0, 9.0), 3)
    for vy in (drawn, -0.125):
        with calls("Set the y of the grenade to 0, and leave x and z unchanged."):
            p = Particle(position=Vector3(x, y, 3.0), velocity=Vector3(vx, vy, vz))
            bounce(p)
        slips = {
            "You move the grenade as far above the ground as it was below.": (x, -y, 3.0),
            "You leave the grenade below the ground.": (x, y, 3.0),
        }
        expect_close(p.position, (x, 0.0, 3.0), slips, then="; p.position", unit="m")
        unmoved = "You move the grenade up, but leave its velocity unchanged. Assign a new vector."
        slow = f"Your grenade doesn't bounce if it moves down at {-vy} m/s. It must for any vy < 0."
        slips = {
            "You reverse the Y component of the velocity without making it smaller. Also multiply "
            "it by BOUNCE, which is 0.5.": (0.8 * vx, -vy, 0.8 * vz),
            "You leave the X and Z components of the velocity unchanged. Multiply both by SLIDE, "
            "which is 0.8.": (vx, -0.5 * vy, vz),
            "You don't reverse the vertical velocity, so the grenade still moves down after the "
            "bounce. Flip the sign of its Y component.": (0.8 * vx, 0.5 * vy, 0.8 * vz),
            slow if vy == -0.125 else unmoved: (vx, vy, vz),
            "You multiply all three components by -BOUNCE. Only the Y component is reversed. "
            "Multiply X and Z by SLIDE, which is 0.8.": (-0.5 * vx, -0.5 * vy, -0.5 * vz),
            "You have swapped BOUNCE and SLIDE. Multiply Y by -BOUNCE, and X and Z by SLIDE.":
                (0.5 * vx, -0.8 * vy, 0.5 * vz),
            "You multiply the Y component by SLIDE too. Multiply it by -BOUNCE only.":
                (0.8 * vx, -0.4 * vy, 0.8 * vz),
        }  # fmt: skip
        right = "Multiply Y by -BOUNCE, which is -0.5, and X and Z by SLIDE, which is 0.8."
        wanted, then = (0.8 * vx, -0.5 * vy, 0.8 * vz), "; p.velocity"
        expect_close(p.velocity, wanted, slips, then=then, unit="m/s", cause=right)


@pytest.mark.exercise("4.1", asks="on or above the ground does not change", read=BOUNCE)
def test_a_grenade_on_or_above_the_ground_does_not_bounce(rng: Random) -> None:
    v = (number(rng), -round(rng.uniform(2.0, 9.0), 3), number(rng))
    for y in (0.0, round(rng.uniform(0.5, 9.0), 3)):
        with calls(f"You let a grenade bounce at y = {y}. It must bounce only if y < 0."):
            p = Particle(position=Vector3(1.0, y, 3.0), velocity=Vector3(*v))
            bounce(p)
        expect_unchanged("p.position", p.position, (1.0, y, 3.0))
        expect_unchanged("p.velocity", p.velocity, v)
    with calls("Every particle with y < 0 must bounce, even 1e-9 m below the ground."):
        p = Particle(position=Vector3(1.0, -1e-9, 3.0), velocity=Vector3(*v))
        bounce(p)
    expect_close(p.position.y, 0.0, tolerance=0.0, then="; p.position.y")


@pytest.mark.exercise("4.1", asks="If it is also moving down", read=BOUNCE)
def test_a_grenade_that_does_not_move_down_keeps_its_velocity(rng: Random) -> None:
    for vy in (round(rng.uniform(2.0, 9.0), 3), 0.0):
        v = (number(rng), vy, number(rng))
        with calls(
            "This grenade is already moving up or is at rest. Move it to y = 0, but change its "
            "velocity only if the velocity points down."
        ):
            p = Particle(position=Vector3(1.0, -0.5, 3.0), velocity=Vector3(*v))
            bounce(p)
        expect_close(p.position, (1.0, 0.0, 3.0), then="; p.position", unit="m")
        up = "You change a velocity that doesn't point down. Change it only if vy < 0."
        expect_unchanged("p.velocity", p.velocity, v, cause=up)


@pytest.mark.exercise("4.1", asks="The particle of the grenade does not change", read=FRAGMENTS)
def test_a_burst_leaves_the_grenade_as_it_was(rng: Random) -> None:
    x, v = vector(rng), vector(rng)
    with calls(
        TWELVE,
        f"p = Particle(position=Vector3{x}, velocity=Vector3{v}, mass=6); pieces = fragments(p)",
    ):
        p = Particle(Vector3(*x), Vector3(*v), mass=6.0)
        pieces = fragments(p)
    expect_twelve(len(pieces))
    adds = "You change the velocity of the grenade. Add the two velocities in a new vector."
    expect_unchanged("p.velocity", p.velocity, v, cause=adds)
    mass = "You change the mass of the grenade. Compute the mass of a fragment from it."
    expect_close(p.mass, 6.0, then="; p.mass", cause=mass)
    with calls(
        "A fragment shares a vector with the grenade or with another fragment. Create a new "
        "particle with new vectors for each fragment.",
        more=True,
    ):
        pieces[0].position.x = 99.0
    expect_unchanged("p.position", p.position, x)
    expect_unchanged("pieces[1].position", pieces[1].position, x)


@pytest.mark.exercise("4.1", asks="so that a burst conserves momentum", read=FRAGMENTS)
def test_the_fragments_share_the_mass_and_the_momentum(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    mass, damping = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.8), 3)
    with calls(
        TWELVE,
        f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a, mass={mass}, "
        f"damping={damping}); pieces = fragments(p)",
    ):
        pieces = probes.burst(x, v, mass, a, damping)
    expect_twelve(len(pieces))
    for piece in pieces:
        slips = {"You give each fragment the whole mass of the grenade.": mass}
        equally = "Divide the mass of the grenade equally among the 12 fragments."
        then = "; the mass of a fragment"
        expect_close(piece[0], mass / 12.0, slips, then=then, unit="kg", cause=equally)
        for name, got, of_grenade in (
            ("damping", piece[1], damping),
            ("position", piece[2:5], x),
            ("acceleration", piece[8:], a),
        ):
            passed = f"Your fragments don't get the grenade's {name}. Pass it to each new Particle."
            expect_close(got, of_grenade, then=f"; the {name} of a fragment", cause=passed)
    total = tuple(math.fsum(piece[0] * piece[axis] for piece in pieces) for axis in (5, 6, 7))
    slips = {
        "You divide the velocity of the grenade by 12. The fragments share only its mass, and each "
        "of them keeps its whole velocity.": mass / 12.0 * v,
        "All of your fragments fly on in the direction of the grenade. Give each of them a "
        "different direction, so that the directions add up to 0.":
            mass * (1.0 + 15.0 / abs(v)) * v,
    }  # fmt: skip
    why = "The directions must add up to 0 to keep the momentum. Choose them in opposite pairs."
    if math.hypot(*total) < 1e-9:
        why = "You leave out the velocity of the grenade. Add it to that of each fragment."
    # The rounding errors of 12 numbers up to 25 x 9 / 12.
    then = "; the total momentum of the fragments"
    expect_close(total, mass * v, slips, then=then, unit="kg m/s", tolerance=1e-11, cause=why)


@pytest.mark.exercise(
    "4.1", asks="piece flies at FRAGMENT_SPEED in a different direction", read=FRAGMENTS
)
def test_the_fragments_fly_apart_each_with_15_meters_a_second(rng: Random) -> None:
    x, v = vector(rng), vector(rng)
    cause = "Normalize each direction and multiply it by FRAGMENT_SPEED, which is 15 m/s."
    left_out = "You leave out the velocity of the grenade. Add it to that of each fragment."
    with calls(cause, f"p = Particle(Vector3{x}, velocity=Vector3{v}); pieces = fragments(p)"):
        velocities = [Triple(piece[5:8]) for piece in probes.burst(x, v, 1.0)]
    for velocity in velocities:
        why = left_out if abs(abs(velocity) - 15.0) < 1e-9 else cause
        then = "; the speed of a fragment relative to the grenade p"
        expect_close(abs(velocity - v), 15.0, then=then, unit="m/s", tolerance=1e-11, cause=why)
    expect_exactly(len(velocities), 12, then="; len(pieces)", cause=TWELVE)
    near = sum(abs(a - b) < 0.1 for a, b in itertools.combinations(velocities, 2))
    different = "Several fragments fly in the same direction. Give each one its own direction."
    then = "; the number of pairs of fragments with the same velocity, to within 0.1 m/s"
    expect_exactly(near, 0, then=then, cause=different)
