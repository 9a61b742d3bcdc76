"""Going further, G6.1: collisions by a spring."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.penalty import PenaltyGround
from ch06_springs.probes import places_on
from draw import Triple, number, positive_number, vector
from expect import expect_between, expect_close, xyz

ZERO = Triple((0.0, 0.0, 0.0))
UP = Triple((0.0, 1.0, 0.0))
READ = "the docstring of PenaltyGround"


@pytest.mark.exercise("G6.1", asks="Push a particle upward if it is below the ground", read=READ)
def test_the_ground_pushes_a_particle_out(rng: Random) -> None:
    high, k, depth = positive_number(rng, 0.5, 9.5), positive_number(rng), positive_number(rng)
    f = vector(rng)
    for height in (-high, high):
        with calls(
            "The ground must push up with the stiffness times the depth of p below its surface. "
            "Add this push to the forces that are already on p."
        ):
            p = Particle(Vector3(3.0, height - depth, 5.0), Vector3(7.0, 0.0, 7.0), mass=2.0)
            p.add_force(Vector3(*f))
            PenaltyGround(height=height, stiffness=k).update_force(p, 0.5)
            got = p.force_accumulator
        push = k * depth * UP
        slips = {
            "Your force points down, farther into the ground.": f - push,
            "You measure the depth from a height of 0, but this ground is at self.height.":
                f + k * (depth - height) * UP,
            "You multiply the push by the mass.": f + 2.0 * push,
            "You multiply the push by the duration, which is 0.5 s here, or by a half.":
                f + 0.5 * push,
            "There is no push, although p is below the surface.": f,
        }  # fmt: skip
        expect_close(got, f + push, slips, tolerance=1e-12, unit="N")


@pytest.mark.exercise("G6.1", asks="if it is below the ground", read=READ)
def test_there_is_no_force_above_the_ground(rng: Random) -> None:
    high, k, c = number(rng), positive_number(rng), positive_number(rng)
    for height, y, speed, damping, push, cause in (
        (high, high + 0.5, 0.0, c, 0.0,
         "Your ground exerts a force on a particle that is above it. Add a force only if the "
         "particle is below the surface."),
        (high, high + 0.5, -9.0, c, 0.0,
         "The particle is still above the ground, so there must be no damping yet, however fast it "
         "falls. Check the depth before you compute any force."),
        (high, high, -9.0, c, 0.0,
         "You apply damping to a particle that only touches the ground. At a depth of 0, there "
         "must be no force at all."),
        (0.0, -1e-6, 0.0, 0.0, 1e-6 * k,
         "The particle is only slightly below the surface, but the ground must push it up with a "
         "small force. Any depth above 0 counts."),
        (high, high - 1.0, 0.0, c, k,
         "The particle is 1 m below the surface, so the ground must push it up. The depth is "
         "self.height minus the particle's y."),
    ):  # fmt: skip
        with calls(cause):
            p = Particle(Vector3(0.0, y, 0.0), Vector3(0.0, speed, 0.0))
            ground = PenaltyGround(height=height, stiffness=k, damping=damping)
            ground.update_force(p, 0.5)
            got = p.force_accumulator
        # A depth of 1 m is 1e-15 m off at such heights, the others are exact.
        tolerance = 1e-12 if push == k else 1e-13 * push
        expect_close(got, push * UP, tolerance=tolerance, unit="N")


@pytest.mark.exercise(
    "G6.1",
    asks="Add the force only if it is positive.",
    read="the docstring of PenaltyGround.update_force",
)
def test_damping_of_the_ground_never_pulls(rng: Random) -> None:
    k, c, depth = positive_number(rng), positive_number(rng), positive_number(rng)
    push = k * depth
    force = "The force is k depth - c v_y, where k is the stiffness and c the damping."
    none = "You leave out the damping."
    rising = "Your damping has no effect while the particle rises."
    for share, cause in (  # at 1, nothing is left of the push
        (-0.5, "The particle is still sinking, so v_y is negative and the damping adds to the "
         f"push. {force}"),
        (0.5, "The particle is already rising, so v_y is positive and the damping reduces the "
         f"push. {force}"),
        (2.0, "The particle rises so fast that the damping is larger than the push. The ground "
         "can't pull it back, so the force must be 0."),
    ):  # fmt: skip
        v = share * push / c
        with calls(cause):
            p = Particle(Vector3(0.0, -depth, 0.0), Vector3(4.0, v, 4.0), mass=2.0)
            PenaltyGround(height=0.0, stiffness=k, damping=c).update_force(p, 0.5)
        x, y, z = xyz(p.force_accumulator)
        slips = {
            rising if share > 0.0 else none: push * UP,
            "Your damping uses the whole speed of the particle instead of v_y.":
                max(push - c * math.hypot(4.0, v, 4.0), 0.0) * UP,
            "Your damping reduces the push while the particle sinks. Either its sign is wrong, or "
            "you use the size of v_y. The force is k depth - c v_y.":
                max(push * (1.0 + share), 0.0) * UP,
            "Your force pulls the particle down.": push * (1.0 - share) * UP,
        }  # fmt: skip
        if x or z:
            cause = "Your damping also acts along the ground, like friction. It must depend only "
            cause += "on v_y, so leave the x and z components of the force at 0."
        wanted = push * max(1.0 - share, 0.0) * UP
        expect_close((x, y, z), wanted, slips, then="; p.force_accumulator", unit="N", cause=cause,
                     tolerance=1e-11)  # fmt: skip


@pytest.mark.exercise("G6.1", asks="that rests on it sinks in by m g / k", read=f"E-36, and {READ}")
def test_a_body_comes_to_rest_below_the_surface() -> None:
    with calls(
        "The particle comes to rest where the push equals its weight m g. Its depth there is m g / "
        "k, which is 5 cm, where k is the stiffness.",
        "p of 2 kg that falls 0.5 m with g = 10 m/s^2 onto PenaltyGround(height=0, stiffness=400, "
        "damping=10); 20 s in steps of 1/240 s; p.position.y",
    ):
        places = places_on("PenaltyGround", (0.0, 400.0, 10.0), 0.5 * UP, 1.0 / 240.0, 4800,
                           mass=2.0, gravity=10.0, velocity_first=True)  # fmt: skip
    heights = [y for _, y, _ in places]
    # By then the swings have died out to e^-50.
    expect_close(heights[-1], -0.05, tolerance=1e-9, unit="m")
    cause = "The particle hits the ground at 3.2 m/s, and the ground must stop it within about 0.2 "
    cause += "m. Check the stiffness and the sign of the damping."
    deepest = -0.05 - math.sqrt(0.05**2 + 10.0 * 2.0 / 400.0)  # without damping
    then = ", at its lowest"
    expect_between(min(heights), deepest, 0.6 * deepest, then=then, unit="m", cause=cause)
    with calls(
        "The check changes the attributes after creating the ground, so read them in every call. "
        "The force must now be 3 N minus 0.5 * 2 N, which is 2 N."
    ):
        p = Particle(velocity=Vector3(0.0, 2.0, 0.0))
        ground = PenaltyGround(height=0.0, stiffness=400.0)
        ground.height, ground.stiffness, ground.damping = 1.0, 3.0, 0.5
        ground.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 2.0 * UP, unit="N")
