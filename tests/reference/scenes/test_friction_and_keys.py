"""Friction between two bodies, and the force of the keys."""

from __future__ import annotations

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.friction import FrictionContact
from ch08_mass_aggregate.keys import KeyForce
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0


def test_friction_between_two_bodies_keeps_momentum_and_center_of_mass() -> None:
    a, b = Particle(Vector3(), Vector3(2.0, -1.0)), Particle(Vector3(0.0, -0.9), mass=3.0)
    FrictionContact(a, b, Vector3(0.0, 1.0), 0.0, 0.1, 0.5).resolve(FRAME)
    assert tuple(a.momentum() + b.momentum()) == pytest.approx((2.0, -1.0, 0.0), abs=1e-14)
    center = (a.position + b.position * 3.0) / 4.0
    assert tuple(center) == pytest.approx((0.0, -0.675, 0.0), abs=1e-14)
    assert a.position.x < -0.001  # it has moved back by what friction has stopped


def test_keys_push_and_jump() -> None:
    ball, keys = Particle(mass=3.0), KeyForce(8.0)
    world = ParticleWorld([ball])
    world.registry.add(ball, keys)
    keys.direction, keys.jump = -1, 6.0
    world.step(FRAME)
    assert ball.velocity.y == pytest.approx(6.0, rel=1e-12)
    assert ball.velocity.x == pytest.approx(-8.0 * FRAME, rel=1e-12)
    keys.direction, keys.jump = 0, 0.0
    world.step(FRAME)
    assert ball.velocity.y == pytest.approx(6.0, rel=1e-12)
