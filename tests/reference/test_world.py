"""ParticleWorld compared with a new version in floats of the published engine's loop.

The published frame is: the forces, p += v h, v = (v + a h) d^h, and then the contacts.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.particle import Particle
from ch06_springs.integrators import explicit_euler
from ch06_springs.springs import AnchoredBungee
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
G = 9.81
GRAVITY = Vector3(0.0, -G, 0.0)
Three = tuple[float, float, float]
Force = Callable[[Three, Three], Three]


def no_force(_p: Three, _v: Three) -> Three:
    return 0.0, 0.0, 0.0


def published(
    p: Three, v: Three, mass: float, damping: float, force: Force, frames: int, c: float | None
) -> list[tuple[Three, Three]]:
    """Return positions and velocities after each frame. If c is given, y <= 0 is ground."""
    (x, y, z), (vx, vy, vz), h, seen = p, v, FRAME, []
    for _ in range(frames):
        fx, fy, fz = force((x, y, z), (vx, vy, vz))
        x, y, z = x + vx * h, y + vy * h, z + vz * h
        keep = math.pow(damping, h)
        vx, vy, vz = (
            (vx + fx / mass * h) * keep,
            (vy + (fy / mass - G) * h) * keep,
            (vz + fz / mass * h) * keep,
        )
        if c is not None and y <= 0.0:
            if vy < 0.0:
                vy = max(0.0, -c * vy - c * G * h)  # the resting rule of 7.2.3
            y = 0.0
        seen.append(((x, y, z), (vx, vy, vz)))
    return seen


def bungee(p: Three, _v: Three) -> Three:
    """Return the force of a bungee of 30 N/m and 1.5 m, anchored at (1, 4, 0) (E-4 corrected)."""
    x, y, z = p[0] - 1.0, p[1] - 4.0, p[2]
    length = math.sqrt(x * x + y * y + z * z)
    pull = min(0.0, 30.0 * (1.5 - length) / length)
    return x * pull, y * pull, z * pull


def drag(_p: Three, v: Three) -> Three:
    speed = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    factor = -(0.3 + 0.05 * speed)  # (k1 v + k2 v^2) / v
    return v[0] * factor, v[1] * factor, v[2] * factor


ANCHOR = Vector3(1.0, 4.0, 0.0)
SCENES = {  # the force, twice, the damping, the restitution of the ground, and the time in s
    "bungee": (bungee, AnchoredBungee(ANCHOR, 30.0, 1.5), 0.95, None, 5.0),
    "ground": (no_force, None, 0.999, 0.9, 6.0),
    "ground and drag": (drag, Drag(0.3, 0.05), 1.0, 0.0, 3.0),
}


@pytest.mark.parametrize(
    ("force", "generator", "damping", "c", "time"), SCENES.values(), ids=SCENES
)
def test_a_trajectory_is_the_published_engine_s(
    force: Force, generator: Any, damping: float, c: float | None, time: float
) -> None:
    start, speed, mass, frames = (0.0, 3.0, -1.0), (4.0, 2.5, 0.5), 2.0, round(time / FRAME)
    ball = Particle(Vector3(*start), Vector3(*speed), GRAVITY, mass=mass, damping=damping)
    grounds = [] if c is None else [GroundPlane([ball], restitution=c)]
    world = ParticleWorld([ball], grounds, integrator=explicit_euler)
    if generator is not None:
        world.registry.add(ball, generator)
    for place, velocity in published(start, speed, mass, damping, force, frames, c):
        world.step(FRAME)
        # Roundings of 100 m in 360 frames, which a spring may sometimes double.
        assert tuple(ball.position) == pytest.approx(place, abs=1e-9)
        assert tuple(ball.velocity) == pytest.approx(velocity, abs=1e-9)
