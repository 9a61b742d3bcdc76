"""A homing bullet, exercise 6.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.probes import chased
from ch06_springs.springs import HomingBullet
from draw import components, positive_number
from expect import about, blame, expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "exercise 6.4 and the docstring of HomingBullet"


@pytest.mark.exercise("6.4", asks="the future position of the bullet to the future position")
def test_it_aims_at_the_predicted_position(rng: Random) -> None:
    about.read = READ
    here, v, there, w, f = (components(rng) for _ in range(5))
    k, ahead = positive_number(rng), positive_number(rng)
    for time, cause in (
        (
            0.0,
            "With a look_ahead of 0, the bullet p aims at the current position of its target "
            "q. The force is the stiffness times the vector from p to q.",
        ),
        (
            ahead,
            "The force is the stiffness times the vector from where p will be after "
            "look_ahead seconds to where q will be. Assume that both keep their "
            "velocities until then.",
        ),
    ):
        about(f"p at {here} with velocity {v}; q at {there} with velocity {w}; ", cause=cause)
        about.call += f"p.add_force(Vector3{f}); b = HomingBullet(target=q, stiffness={k}, "
        about.call += f"look_ahead={time}); b.update_force(p, 0.5)"
        down = Vector3(0.0, -9.0, 0.0)
        p = Particle(Vector3(*here), Vector3(*v), down, mass=3.0, damping=0.5)
        q = Particle(Vector3(*there), Vector3(*w), down * 2.0, mass=5.0, damping=0.7)
        p.add_force(Vector3(*f))
        HomingBullet(q, k, time).update_force(p, 0.5)
        wanted = tuple(
            f[i] + k * (there[i] + w[i] * time - here[i] - v[i] * time) for i in range(3)
        )
        got = xyz(p.force_accumulator)
        now = [there[i] - here[i] for i in range(3)]
        closing = [w[i] - v[i] for i in range(3)]
        way = [now[i] + closing[i] * time for i in range(3)]
        pulls = {
            "Your force pushes the bullet away from its target. Subtract the bullet's "
            "predicted position from the target's.": [-k * part for part in way],
            "You left out the stiffness. Multiply the vector to the target by self.stiffness.": way,
            "You normalized the vector to the target, so the size of your force is always the "
            "stiffness. Multiply the stiffness by the whole vector.": [
                k * part / math.hypot(*way) for part in way
            ],
            (
                "Your force uses the current positions of the bullet and the target. Use their "
                "positions after look_ahead seconds instead."
            ): [k * part for part in now],
            (
                "Your prediction leaves out the bullet's own velocity. The bullet moves for "
                "look_ahead seconds too, so use its position after that time."
            ): [k * (now[i] + w[i] * time) for i in range(3)],
            "Your prediction leaves out the target's velocity. Aim at the position of the target "
            "after look_ahead seconds.": [k * (now[i] - v[i] * time) for i in range(3)],
            "Your prediction has the wrong sign, so it looks back. Add velocity * look_ahead to "
            "each position.": [k * (now[i] - closing[i] * time) for i in range(3)],
            "You add the velocities of the two. Subtract the bullet's predicted position from the "
            "target's, and with it the bullet's velocity.": [
                k * (now[i] + (w[i] + v[i]) * time) for i in range(3)
            ],
            "Your vector is the target's position alone, as if the bullet were at (0, 0, 0). "
            "Subtract the bullet's position.": [k * (there[i] + w[i] * time) for i in range(3)],
            "You multiply the force by the bullet's mass. The pull of a spring does not depend on "
            "it, so leave the mass out.": [3.0 * k * part for part in way],
            "Your prediction includes the accelerations. Assume that both keep their velocities.": [
                k * (way[i] - (4.5 * time**2 if i == 1 else 0.0)) for i in range(3)
            ],
            "Your prediction looks ahead by 0.5 s, the duration of the step. Use self.look_ahead "
            "instead.": [k * (now[i] + closing[i] * 0.5) for i in range(3)],
        }
        slips = {slip: [f[i] + pull[i] for i in range(3)] for slip, pull in pulls.items()}
        blame(got, slips)
        # A few roundings of numbers up to 2000.
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
        about.cause = "You added a force to the target as well. Add it only to the bullet, which "
        about.cause += "is passed to update_force."
        expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator, in N")


@pytest.mark.exercise("6.4", asks="and changes nothing else")
def test_bullet_and_target_are_not_moved(rng: Random) -> None:
    about.read = READ
    here, v, there, w = (components(rng) for _ in range(4))
    about.call = f"p at {here} with velocity {v}; q at {there} with velocity {w}; b = "
    about.call += "HomingBullet(target=q, stiffness=2.0, look_ahead=3.0); b.update_force(p, 0.5)"
    p, q = Particle(Vector3(*here), Vector3(*v)), Particle(Vector3(*there), Vector3(*w))
    b = HomingBullet(q, 2.0, 3.0)
    b.update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, here),
        ("p.velocity", p.velocity, v),
        ("q.position", q.position, there),
        ("q.velocity", q.velocity, w),
    ):
        changed = f"You changed {name}. add_scaled, += and *= work in place, so use + and *, which "
        expect_unchanged(name, xyz(now), before, cause=f"{changed}create new vectors.")
    about.call = f"p at {here} with velocity {v}; q at {there} with velocity {v}; b.stiffness = "
    about.call += "4.0; b.look_ahead = 1.0; b.update_force(p, 0.5)"
    about.cause = (
        "The check changes b.stiffness, b.look_ahead and the target's velocity before this call. "
        "Read all of them in every call."
    )
    p.clear_forces()
    b.stiffness, b.look_ahead, q.velocity = 4.0, 1.0, Vector3(*v)
    b.update_force(p, 0.5)
    wanted = tuple(4.0 * (there[i] - here[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)
    about.call = (
        f"p at {here} with velocity {v}; b.stiffness is 4, b.look_ahead is 1, b.target is now an "
        f"immovable particle at {w}; b.update_force(p, 0.5)"
    )
    about.cause = (
        "The check gives the bullet a new target, which is immovable. Read self.target in every "
        "call, and treat an immovable target like any other."
    )
    p.clear_forces()
    b.target = Particle(Vector3(*w), mass=math.inf)
    b.update_force(p, 0.5)
    wanted = tuple(4.0 * (w[i] - here[i] - v[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-11)


@pytest.mark.exercise("6.4", asks="steers a bullet toward the future position")
def test_it_catches_a_target_that_flies_straight_on(rng: Random) -> None:
    about.read = READ
    start, w = components(rng), components(rng)
    about.call = f"p at rest at (0, 0, 0); q at {start} with velocity {w}; 20 s of "
    about.call += "HomingBullet(target=q, stiffness=4.0, look_ahead=1.0) in steps of 1/240 s; "
    about.call += "distance between p and q in m,"
    about.cause = (
        "The bullet must reach the target and stay with it. Its velocity is damped only if your "
        "prediction includes the velocities of both."
    )
    distances = chased(start, w, 4.0, 1.0, 1.0 / 240.0, 4800)
    expect_close(distances[-1], 0.0, then=" at the end", tolerance=1e-6)
    # Critically damped, c = k T = 4 and c^2 = 4 k m, from rest: after t s (1 + 2 t) e^-2t of the
    # way is left, and w t e^-2t of the velocity's. Of first order, the step is 0.02 off at most.
    half = [(start[i] * (1.0 + 2.0) + w[i] * 1.0) * math.exp(-2.0) for i in range(3)]
    wanted = math.hypot(*half)
    expect_close(distances[240], wanted, then=" after 1 s", tolerance=0.05)
