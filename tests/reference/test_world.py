"""ParticleWorld compared with a new version in floats of the published engine's loop.

The published frame is: the forces, p += v h, v = (v + a h) d^h, and then the contacts.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from itertools import pairwise

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    runge_kutta_4,
    semi_implicit_euler,
)
from ch06_springs.own_step import my_step
from ch06_springs.springs import AnchoredBungee, AnchoredSpring
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredRod, Cable, Rod, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
G = 9.81
GRAVITY = Vector3(0.0, -G, 0.0)
Three = tuple[float, float, float]
Force = Callable[[Three, Three], Three]


# The published loop


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


def spring(p: Three, _v: Three) -> Three:
    """Return the force of a spring of 30 N/m and rest length 1.5 m, anchored at (1, 4, 0)."""
    x, y, z = p[0] - 1.0, p[1] - 4.0, p[2]
    length = math.sqrt(x * x + y * y + z * z)
    pull = 30.0 * (1.5 - length) / length
    return x * pull, y * pull, z * pull


def bungee(p: Three, v: Three) -> Three:
    """Return the same force, or no force where it would push (E-4 corrected)."""
    longer = math.dist(p, (1.0, 4.0, 0.0)) > 1.5
    return spring(p, v) if longer else (0.0, 0.0, 0.0)


def drag(_p: Three, v: Three) -> Three:
    speed = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    factor = -(0.3 + 0.05 * speed)  # (k1 v + k2 v^2) / v
    return v[0] * factor, v[1] * factor, v[2] * factor


ANCHOR = Vector3(1.0, 4.0, 0.0)
SCENES = [
    ("ballistics", no_force, None, 0.99, None, 5.0),
    ("anchored spring", spring, AnchoredSpring(ANCHOR, 30.0, 1.5), 0.9, None, 5.0),
    ("bungee", bungee, AnchoredBungee(ANCHOR, 30.0, 1.5), 0.95, None, 5.0),
    ("drag", drag, Drag(0.3, 0.05), 0.999, None, 5.0),
    ("ground", no_force, None, 0.999, 0.9, 6.0),
    ("ground and drag", drag, Drag(0.3, 0.05), 1.0, 0.0, 3.0),
]


@pytest.mark.parametrize(
    ("force", "generator", "damping", "c", "time"),
    [s[1:] for s in SCENES],
    ids=[s[0] for s in SCENES],
)
def test_a_trajectory_is_the_published_engine_s(
    force: Force, generator: AnchoredSpring | None, damping: float, c: float | None, time: float
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


def test_the_published_ball_bounces_all_the_while() -> None:
    """The comparison would be pointless if the ball came to rest. It bounces until the end."""
    seen = published((0.0, 3.0, -1.0), (4.0, 2.5, 0.5), 2.0, 0.999, no_force, 360, 0.9)
    turns = [i for i, (a, b) in enumerate(pairwise(seen)) if a[1][1] < 0.0 < b[1][1]]
    assert len(turns) >= 4
    assert turns[-1] > 300


# Conserved quantities


def tangle() -> tuple[list[Particle], list[ContactGenerator]]:
    """Return 20 particles in motion, and rods and cables between neighbors."""
    draw = random.Random(81)

    def vector(size: float) -> Vector3:
        return Vector3(*(draw.uniform(-size, size) for _ in range(3)))

    bodies = [Particle(vector(1.0), vector(3.0), mass=draw.uniform(0.2, 5.0)) for _ in range(20)]
    links: list[ContactGenerator] = []
    for i, (a, b) in enumerate(pairwise(bodies)):
        length = (b.position - a.position).magnitude()
        kinds = [Rod(a, b, length), TwoSidedRod(a, b, length), Cable(a, b, length, 0.5)]
        links.append(kinds[i % 3])
    return bodies, links


def momentum_of(bodies: Sequence[Particle]) -> list[float]:
    momenta = [tuple(body.momentum()) for body in bodies]
    return [math.fsum(column) for column in zip(*momenta, strict=True)]


@pytest.mark.parametrize("step", [explicit_euler, semi_implicit_euler, runge_kutta_4])
def test_rods_and_cables_keep_the_momentum_and_the_way_of_the_center(step: Integrator) -> None:
    bodies, links = tangle()
    world, total = ParticleWorld(bodies, links, integrator=step), sum(b.mass for b in bodies)
    before = momentum_of(bodies)
    start = [math.fsum(b.mass * tuple(b.position)[i] for b in bodies) / total for i in range(3)]
    speeds = [tuple(b.velocity) for b in bodies]
    for _ in range(300):
        world.step(FRAME)
    # 300 frames of up to 80 impulses of some 10 kg m/s, each with two roundings: 5e-11.
    assert momentum_of(bodies) == pytest.approx(before, abs=5e-11)
    for i in range(3):
        center = math.fsum(b.mass * tuple(b.position)[i] for b in bodies) / total
        assert center == pytest.approx(start[i] + before[i] / total * 5.0, abs=5e-11)
    assert max(math.dist(a, b.velocity) for a, b in zip(speeds, bodies, strict=True)) > 1.0


# Integrators


def test_the_default_step_is_semi_implicit_and_the_world_s_contacts_hold_a_pendulum() -> None:
    """From p = 0 the first frame moves by g h^2. A rod of 1 m is 1 m long after every frame."""
    drop = Particle(acceleration=GRAVITY)
    ParticleWorld([drop]).step(0.5)
    assert drop.position.y == -0.25 * G
    bob = Particle(Vector3(1.0), acceleration=GRAVITY)
    world = ParticleWorld([bob], [AnchoredRod(bob, Vector3(), 1.0)])
    for _ in range(600):
        world.step(FRAME)
        # The resolver ignores depths below 1e-9 m.
        assert bob.position.magnitude() == pytest.approx(1.0, abs=1.1e-9)


def test_a_step_of_your_own_may_be_a_world_s() -> None:
    """1 kg on 100 N/m from (1, 0) at 10 m/s moves in a circle of 1 m in 0.628 s."""
    body = Particle(Vector3(1.0), Vector3(0.0, 10.0))
    world = ParticleWorld([body], integrator=my_step)
    world.registry.add(body, AnchoredSpring(Vector3(), 100.0, 0.0))
    for _ in range(40):
        world.step(math.tau / 10.0 / 40.0)
        assert body.position.magnitude() == pytest.approx(1.0, abs=1e-6)
    # With order 4, the error is about (10 h)^4 = 6e-4 times a constant of about 1e-4 per turn.
    assert (body.position - Vector3(1.0)).magnitude() < 1e-6
