"""Going further, G6.1: collisions by a spring."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.penalty import PenaltyGround
from ch06_springs.probes import on_penalty_ground
from draw import components, number, positive_number
from expect import about, blame, expect_between, expect_close, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "the docstring of PenaltyGround"


@pytest.mark.exercise("G6.1", asks="Push a particle upward if it is below the ground")
def test_the_ground_pushes_a_particle_out(rng: Random) -> None:
    about.read = READ
    high, k, depth = positive_number(rng, 0.5, 9.5), positive_number(rng), positive_number(rng)
    f = components(rng)
    for height in (-high, high):
        about.call = f"p at (3, {height - depth:.6g}, 5); p.add_force(Vector3{f}); "
        about.call += f"PenaltyGround(height={height}, stiffness={k}).update_force(p, 0.5); "
        about.call += "p.force_accumulator, in N"
        about.cause = "The ground must push up with the stiffness times the depth of p below its "
        about.cause += "surface. Add this push to the forces that are already on p."
        p = Particle(Vector3(3.0, height - depth, 5.0), Vector3(7.0, 0.0, 7.0), mass=2.0)
        p.add_force(Vector3(*f))
        PenaltyGround(height, k).update_force(p, 0.5)
        wanted = (f[0], f[1] + k * depth, f[2])
        got = xyz(p.force_accumulator)
        pushes = {
            "Your force points down, farther into the ground. The ground must push p up, so "
            "reverse the sign.": -k * depth,
            "You measure the depth from a height of 0, but this ground is at self.height. "
            "Subtract the particle's y from self.height.": k * (depth - height),
            "You multiply the push by the mass. It depends only on the stiffness and the depth, so "
            "leave the mass out.": 2.0 * k * depth,
            "You multiply the push by the duration, which is 0.5 s here, or by a half. Add the "
            "whole force k depth.": 0.5 * k * depth,
            "There is no push, although p is below the surface. Check the sign of the depth, "
            "which is self.height minus the particle's y.": 0.0,
        }
        slips = {slip: (f[0], f[1] + size, f[2]) for slip, size in pushes.items()}
        blame(got, slips)
        expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("G6.1", asks="if it is below the ground")
def test_there_is_no_force_above_the_ground(rng: Random) -> None:
    about.read = READ
    height, k, c = number(rng), positive_number(rng), positive_number(rng)
    for above, speed, cause in (
        (
            0.5,
            0.0,
            "Your ground exerts a force on a particle that is above it. Add a force only if the "
            "particle is below the surface.",
        ),
        (
            0.5,
            -9.0,
            "The particle is still above the ground, so there must be no damping yet, however "
            "fast it falls. Check the depth before you compute any force.",
        ),
        (
            0.0,
            -9.0,
            "You apply damping to a particle that only touches the ground. At a depth of 0, "
            "there must be no force at all.",
        ),
    ):
        about(f"p at (0, {height + above:.6g}, 0) with velocity (0, {speed:g}, 0); ", cause=cause)
        about.call += f"PenaltyGround(height={height}, stiffness={k}, damping={c}).update_force(p, "
        about.call += "0.5); p.force_accumulator, in N"
        p = Particle(Vector3(0.0, height + above, 0.0), Vector3(0.0, speed, 0.0))
        PenaltyGround(height, k, c).update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        expect_close(got, ZERO)
    about.call = f"p at (0, -1e-6, 0); PenaltyGround(height=0, stiffness={k}).update_force(p, "
    about.call += "0.5); p.force_accumulator, in N"
    about.cause = "The particle is only slightly below the surface, but the ground must push it up "
    about.cause += "with a small force. Any depth above 0 counts."
    p = Particle(Vector3(0.0, -1e-6, 0.0))
    PenaltyGround(0.0, k).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, 1e-6 * k, 0.0))
    about.call = f"p at (0, {height - 1:.6g}, 0); PenaltyGround(height={height}, stiffness={k}, "
    about.call += f"damping={c}).update_force(p, 0.5)"
    about.cause = "The particle is 1 m below the surface, so the ground must push it up. The depth "
    about.cause += "is self.height minus the particle's y."
    p = Particle(Vector3(0.0, height - 1.0, 0.0))
    PenaltyGround(height, k, c).update_force(p, 0.5)
    got = xyz(p.force_accumulator)
    expect_close(got, (0.0, k, 0.0), then="; p.force_accumulator, in N", tolerance=1e-12)


@pytest.mark.exercise("G6.1", asks="Add the force only if it is positive.")
def test_damping_of_the_ground_never_pulls(rng: Random) -> None:
    about.read = "the docstring of PenaltyGround.update_force"
    k, c, depth = positive_number(rng), positive_number(rng), positive_number(rng)
    free = k * depth / c  # m/s upwards, at which nothing is left of the push
    ground = PenaltyGround(0.0, k, c)
    for share, cause in (
        (
            -0.5,
            "The particle is still sinking, so v_y is negative and the damping adds to the "
            "push. The force is k depth - c v_y, where k is the stiffness and c the damping.",
        ),
        (
            0.5,
            "The particle is already rising, so v_y is positive and the damping reduces the "
            "push. The force is k depth - c v_y, where k is the stiffness and c the damping.",
        ),
        (
            2.0,
            "The particle rises so fast that the damping is larger than the push. The ground "
            "can't pull it back, so the force must be 0.",
        ),
    ):
        about.cause = cause
        v = share * free
        about.call = f"p at (0, {-depth}, 0) with velocity (4, {v:.6g}, 4); "
        about.call += f"PenaltyGround(height=0, stiffness={k}, damping={c}).update_force(p, 0.5); "
        about.call += "p.force_accumulator, in N"
        p = Particle(Vector3(0.0, -depth, 0.0), Vector3(4.0, v, 4.0), mass=2.0)
        ground.update_force(p, 0.5)
        push = k * depth
        wanted = (0.0, push * max(1.0 - share, 0.0), 0.0)
        got = xyz(p.force_accumulator)
        slips = {
            "Your damping has no effect while the particle rises. Subtract c v_y from the push "
            "then too, where c is the damping and v_y the upward velocity."
            if share > 0.0
            else "You leave out the damping. Subtract c v_y from the push, where c is the damping "
            "and v_y the upward velocity.": (0.0, push, 0.0),
            "Your damping uses the whole speed of the particle. Use v_y, its upward velocity, "
            "which is negative while it sinks.": (
                0.0,
                max(push - c * math.hypot(4.0, v, 4.0), 0.0),
                0.0,
            ),
            "Your damping reduces the push while the particle sinks. Either its sign is wrong, or "
            "you use the size of v_y. The force is k depth - c v_y.": (
                0.0,
                max(push * (1.0 + share), 0.0),
                0.0,
            ),
            "Your damping also acts along the ground, like friction. It must depend only on "
            "v_y, so leave the x and z components of the force at 0.": (
                -4.0 * c,
                wanted[1],
                -4.0 * c,
            ),
            "Your force pulls the particle down, but the ground can only push. If k depth - c v_y "
            "is less than 0, use 0 instead.": (0.0, push * (1.0 - share), 0.0),
        }
        blame(got, slips)
        if got[0] or got[2]:
            about.cause = "Your damping also acts along the ground, like friction. It must depend "
            about.cause += "only on v_y, so leave the x and z components of the force at 0."
        expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("G6.1", asks="that rests on it sinks in by m g / k")
def test_a_body_comes_to_rest_below_the_surface() -> None:
    about.read = "E-36, and the docstring of PenaltyGround"
    about.call = "p of 2 kg that falls 0.5 m with g = 10 m/s^2 onto PenaltyGround(height=0, "
    about.call += "stiffness=400, damping=10); 20 s in steps of 1/240 s; p.position.y, in m"
    about.cause = "The particle comes to rest where the push equals its weight m g. Its depth "
    about.cause += "there is m g / k, which is 5 cm, where k is the stiffness."
    end, lowest = on_penalty_ground(400.0, 10.0, 2.0, 0.5, 1.0 / 240.0, 4800)
    # By then the swings have died out to e^-50.
    expect_close(end, -0.05, tolerance=1e-9)
    about.cause = "The particle hits the ground at 3.2 m/s, and the ground must stop it within "
    about.cause += "about 0.2 m. Check the stiffness and the sign of the damping."
    deepest = -0.05 - math.sqrt(0.05**2 + 10.0 * 2.0 / 400.0)  # without damping
    expect_between(lowest, deepest, 0.6 * deepest, then=", at its lowest")
    about.call = "ground = PenaltyGround(height=0, stiffness=400, damping=0), changed to "
    about.call += "height=1, stiffness=3 and damping=0.5; p at (0, 0, 0) with velocity (0, 2, 0); "
    about.call += "ground.update_force(p, 0.5); p.force_accumulator, in N"
    about.cause = "The check changes the attributes after creating the ground, so read them in "
    about.cause += "every call. The force must now be 3 N minus 0.5 * 2 N, which is 2 N."
    ground, p = PenaltyGround(0.0, 400.0), Particle(velocity=Vector3(0.0, 2.0, 0.0))
    ground.height, ground.stiffness, ground.damping = 1.0, 3.0, 0.5
    ground.update_force(p, 0.5)
    expect_close(xyz(p.force_accumulator), (0.0, 2.0, 0.0))
