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


@pytest.mark.exercise("6.4")
def test_it_aims_at_where_both_will_be(rng: Random) -> None:
    about.read = READ
    here, v, there, w, f = (components(rng) for _ in range(5))
    k, ahead = positive_number(rng), positive_number(rng)
    for time, cause in (
        (
            0.0,
            "With a look-ahead time of 0, the force pulls toward the target's current position, so "
            "it is k (q - p).",
        ),
        (
            ahead,
            (
                "The force is k times the displacement from p + v T to q + w T. We assume that "
                "both keep moving in a straight line, so damping, acceleration and mass don't "
                "matter."
            ),
        ),
    ):
        about(f"p at {here}, velocity {v}; q at {there}, velocity {w}; ", cause=cause)
        about.call += f"p.add_force(Vector3{f}); HomingBullet(q, {k}, {time}).update_force(p, 0.5)"
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
            "The force pushes the bullet away from its target. Subtract the bullet's predicted "
            "position from the target's, not the other way around.": [-k * part for part in way],
            "The force equals the vector between the two predicted positions. Multiply that vector "
            "by the stiffness.": way,
            "The force has the size k at every distance, as if you had normalized the "
            "displacement. Multiply k by the whole displacement.": [
                k * part / math.hypot(*way) for part in way
            ],
            (
                "The force pulls toward where the target is now. Aim at where it will be after "
                "look_ahead seconds."
            ): [k * part for part in now],
            (
                "Your prediction leaves out the bullet's own velocity. The bullet moves during "
                "look_ahead too, so start from where it will be by then."
            ): [k * (now[i] + w[i] * time) for i in range(3)],
            "Your prediction leaves out the target's velocity. The target moves during look_ahead "
            "too, so aim at where it will be by then.": [
                k * (now[i] - v[i] * time) for i in range(3)
            ],
            "Your prediction looks ahead by the duration of the step. Use self.look_ahead, which "
            "doesn't depend on the step.": [k * (now[i] + closing[i] * 0.5) for i in range(3)],
        }
        slips = {slip: [f[i] + pull[i] for i in range(3)] for slip, pull in pulls.items()}
        blame(got, slips)
        # A few roundings of numbers up to 2000.
        expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)
        about.cause = "You added a force to the target as well. Add it to the bullet only."
        expect_close(xyz(q.force_accumulator), ZERO, then="; q.force_accumulator")


@pytest.mark.exercise("6.4")
def test_bullet_and_target_are_only_read(rng: Random) -> None:
    about.read = READ
    here, v, there, w = (components(rng) for _ in range(4))
    about.call = f"p at {here}, velocity {v}; q at {there}, velocity {w}; b = HomingBullet(q, 2.0, "
    about.call += "3.0); b.update_force(p, 0.5)"
    about.cause = (
        "add_scaled, += and *= change a vector in place. Copy a position or velocity before you "
        "apply them to it, or use + and *, which return new vectors."
    )
    p, q = Particle(Vector3(*here), Vector3(*v)), Particle(Vector3(*there), Vector3(*w))
    b = HomingBullet(q, 2.0, 3.0)
    b.update_force(p, 0.5)
    for name, now, before in (
        ("p.position", p.position, here),
        ("p.velocity", p.velocity, v),
        ("q.position", q.position, there),
        ("q.velocity", q.velocity, w),
    ):
        expect_unchanged(name, xyz(now), before)
    about.call = f"p at {here}, velocity {v}; q at {there}, velocity {v}; b.stiffness changed from "
    about.call += "2 to 4, b.look_ahead from 3 to 1; b.update_force(p, 0.5)"
    about.cause = (
        "The check changed the attributes and the target's velocity after it created the bullet. "
        "Read stiffness, look_ahead and the target's motion on every call."
    )
    p.clear_forces()
    b.stiffness, b.look_ahead, q.velocity = 4.0, 1.0, Vector3(*v)
    b.update_force(p, 0.5)
    wanted = tuple(4.0 * (there[i] - here[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)
    about.call = (
        f"p at {here}, velocity {v}; b.stiffness 4, b.look_ahead 1, b.target changed to an "
        f"immovable particle at {w}; b.update_force(p, 0.5)"
    )
    about.cause = (
        "The bullet has a new target now, so read self.target on every call. The new target is "
        "immovable, which is fine."
    )
    p.clear_forces()
    b.target = Particle(Vector3(*w), mass=math.inf)
    b.update_force(p, 0.5)
    wanted = tuple(4.0 * (w[i] - here[i] - v[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-11)


@pytest.mark.exercise("6.4")
def test_it_catches_a_target_that_flies_straight_on(rng: Random) -> None:
    about.read = READ
    start, w = components(rng), components(rng)
    about.call = f"p at (0, 0, 0), at rest; q at {start}, velocity {w}; 20 s of HomingBullet(q, "
    about.call += "4.0, 1.0).update_force(p, h), p.integrate(h), h = 1/240: distance"
    about.cause = (
        "The bullet should reach the target and stay with it, because k T damps its velocity "
        "relative to the target. Check that your prediction includes both velocities."
    )
    distances = chased(start, w, 4.0, 1.0, 1.0 / 240.0, 4800)
    expect_close(distances[-1], 0.0, then=" in the end", tolerance=1e-6)
    # Critically damped, c = k T = 4 and c^2 = 4 k m, from rest: after t s (1 + 2 t) e^-2t of the
    # way is left, and w t e^-2t of the velocity's. Of first order, the step is 0.02 off at most.
    half = [(start[i] * (1.0 + 2.0) + w[i] * 1.0) * math.exp(-2.0) for i in range(3)]
    wanted = math.hypot(*half)
    expect_close(distances[240], wanted, then=" after 1 s", tolerance=0.05)
