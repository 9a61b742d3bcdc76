"""A homing bullet, exercise 6.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import chased
from ch06_springs.springs import HomingBullet
from draw import Triple, positive_number, vector
from expect import expect_close, expect_unchanged

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.4 and the docstring of HomingBullet"


@pytest.mark.exercise(
    "6.4", asks="the future position of the bullet to the future position", read=READ
)
def test_it_aims_at_the_predicted_position(rng: Random) -> None:
    here, v, there, w, f = vector(rng), vector(rng), vector(rng), vector(rng), vector(rng)
    k, ahead = positive_number(rng), positive_number(rng)
    down = Triple((0.0, -9.0, 0.0))
    for time in (0.0, ahead):
        cause = "The force is the stiffness times the vector from where p will be after look_ahead "
        cause += "seconds to where q will be. Assume that both keep their velocities until then."
        with calls(cause):
            p = Particle(Vector3(*here), Vector3(*v), Vector3(*down), mass=3.0, damping=0.5)
            q = Particle(Vector3(*there), Vector3(*w), Vector3(*(2 * down)), mass=5.0, damping=0.7)
            p.add_force(Vector3(*f))
            HomingBullet(target=q, stiffness=k, look_ahead=time).update_force(p, 0.5)
        now, closing = there - here, w - v
        way = now + closing * time
        pulls = {
            "Your force pushes the bullet away from its target.": -k * way,
            "You left out the stiffness.": way,
            "You normalized the vector, so the size of your force is always the stiffness.":
                k * way / abs(way),
            "Your force uses the current positions of the bullet and the target.": k * now,
            "Your prediction leaves out the bullet's own velocity.": k * (now + w * time),
            "Your prediction leaves out the target's velocity.": k * (now - v * time),
            "Your prediction has the wrong sign, so it looks back.": k * (now - closing * time),
            "You add the velocities of the two.": k * (now + (w + v) * time),
            "Your vector is the target's position alone, as if the bullet were at (0, 0, 0).":
                k * (there + w * time),
            "You multiply the force by the bullet's mass.": 3.0 * k * way,
            "Your prediction includes the accelerations.": k * (way + 0.5 * time**2 * down),
            "Your prediction looks ahead by 0.5 s, the duration of the step.":
                k * (now + closing * 0.5),
        }  # fmt: skip
        slips = {slip: f + pull for slip, pull in pulls.items()}
        got, then = p.force_accumulator, "; p.force_accumulator"
        # A few roundings of numbers up to 2000.
        expect_close(got, f + k * way, slips, then=then, unit="N", tolerance=1e-11)
        cause = "You added a force to the target as well. Add it only to the bullet, which is "
        cause += "passed to update_force."
        expect_close(q.force_accumulator, ZERO, then="; q.force_accumulator", unit="N", cause=cause)


@pytest.mark.exercise("6.4", asks="and changes nothing else", read=READ)
def test_bullet_and_target_are_not_moved(rng: Random) -> None:
    here, v, there, w = vector(rng), vector(rng), vector(rng), vector(rng)
    with calls("Read the positions and the velocities, but don't change them."):
        p, q = Particle(Vector3(*here), Vector3(*v)), Particle(Vector3(*there), Vector3(*w))
        b = HomingBullet(target=q, stiffness=2.0, look_ahead=3.0)
        b.update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, here),
        ("p.velocity", p.velocity, v),
        ("q.position", q.position, there),
        ("q.velocity", q.velocity, w),
    ):
        changed = f"You changed {name}. add_scaled, += and *= work in place, so use + and *, which "
        expect_unchanged(name, now, before, cause=f"{changed}create new vectors.")
    with calls(
        "The check changes b.stiffness, b.look_ahead and the target's velocity before this call. "
        "Read all of them in every call.",
        more=True,
    ):
        p.clear_forces()
        b.stiffness, b.look_ahead, q.velocity = 4.0, 1.0, Vector3(*v)
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 4.0 * (there - here), unit="N", tolerance=1e-11)
    with calls(
        "The check gives the bullet a new target, which is immovable. Read self.target in every "
        "call, and treat an immovable target like any other.",
        more=True,
    ):
        p.clear_forces()
        b.target = Particle(Vector3(*w), mass=math.inf)
        b.update_force(p, 0.5)
        got = p.force_accumulator
    expect_close(got, 4.0 * (w - here - v), unit="N", tolerance=1e-11)


@pytest.mark.exercise("6.4", asks="steers a bullet toward the future position", read=READ)
def test_it_catches_a_target_that_flies_straight_on(rng: Random) -> None:
    start, w = vector(rng), vector(rng)
    with calls(
        "The bullet must reach the target and stay with it. Its velocity is damped only if your "
        "prediction includes the velocities of both.",
        f"p at rest at (0, 0, 0); q at {start} with velocity {w}; 20 s of HomingBullet(target=q, "
        "stiffness=4.0, look_ahead=1.0) in steps of 1/240 s; distance between p and q",
    ):
        distances = chased(start, w, 4.0, 1.0)
    expect_close(distances[-1], 0.0, then=" at the end", tolerance=1e-6, unit="m")
    # Critically damped, c = k T = 4 and c^2 = 4 k m, from rest: after t s (1 + 2 t) e^-2t of the
    # way is left, and w t e^-2t of the velocity's. Of first order, the step is 0.02 off at most.
    wanted = abs(3.0 * start + w) * math.exp(-2.0)
    expect_close(distances[240], wanted, then=" after 1 s", tolerance=0.05, unit="m")
