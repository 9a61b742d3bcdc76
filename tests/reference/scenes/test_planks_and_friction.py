"""Friction, a ball on planks, a bridge of rods, and the force of the keys."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import explicit_euler, semi_implicit_euler
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import Cable, Rod
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.friction import FrictionContact, FrictionGround
from ch08_mass_aggregate.keys import KeyForce
from ch08_mass_aggregate.planks import Planks
from ch08_mass_aggregate.tilting_platform import DAMPING, TiltingPlatform
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy

FRAME = 1.0 / 60.0
G = 9.81


def center(platform: TiltingPlatform) -> float:
    """Return x of the center of mass."""
    total = math.fsum(p.mass for p in platform.particles)
    return math.fsum(p.mass * p.position.x for p in platform.particles) / total


def pushed_platform(friction: float, speed: float, seconds: int) -> list[float]:
    """Push a platform that has tipped; return how far its center of mass slid after each second."""
    platform = TiltingPlatform()
    platform.put_weight(4.0, -3.0)
    for _ in range(90):
        platform.step(FRAME)
    platform.free_pivot()
    ground = FrictionGround(platform.particles, friction)
    others = platform.world.contact_generators
    others[:] = [ground if isinstance(some, GroundPlane) else some for some in others]
    for particle in platform.particles:
        particle.velocity = Vector3(speed)
    start, slid = center(platform), []
    for _ in range(seconds):
        for _ in range(60):
            platform.step(FRAME)
        slid.append(center(platform) - start)
    return slid


def test_a_freed_platform_slides_away_without_friction() -> None:
    """Only the damping slows it down: x = v (1 - d^t) / -ln d. The steps add v h / 2."""
    one, two = pushed_platform(0.0, 2.0, 2)
    for t, x in ((1.0, one), (2.0, two)):
        assert x == pytest.approx(2.0 * (1.0 - DAMPING**t) / -math.log(DAMPING), abs=2.0 * FRAME)


def test_friction_stops_a_freed_platform() -> None:
    """It stops within v^2 / (2 mu g); damping shortens that. Then it creeps, at 2.1 cm/s."""
    one, two = pushed_platform(0.3, 2.0, 2)
    assert 0.9 * 2.0**2 / (2.0 * 0.3 * G) < one < 2.0**2 / (2.0 * 0.3 * G)
    assert 0.0 < two - one < 0.03


@pytest.mark.parametrize("step", [semi_implicit_euler, explicit_euler])
def test_a_body_that_sticks_does_not_creep(step: object) -> None:
    angle = math.radians(30.0)
    gravity = Vector3(G * math.sin(angle), -G * math.cos(angle))
    body = Particle(acceleration=gravity, mass=2.0)
    world = ParticleWorld([body], [FrictionGround([body], 0.6)], integrator=step)  # type: ignore[arg-type]
    for _ in range(600):
        world.step(FRAME)
    assert (
        body.position.magnitude() < 1e-12
    )  # rounding; it would creep 0.8 m without the correction


def test_a_pile_with_friction_does_not_gain_energy() -> None:
    """Two sliding bodies collide on the ground, with friction in every contact."""
    a = Particle(Vector3(0.0), Vector3(4.0, 0.0, 1.0), Vector3(0.0, -G), mass=2.0)
    b = Particle(Vector3(1.5, 0.5), Vector3(-1.0), Vector3(0.0, -G), mass=1.0)

    class Touch:
        def contacts(self) -> list[FrictionContact]:
            offset = a.position - b.position
            depth = 1.0 - offset.magnitude()
            if depth < 0.0:
                return []
            return [FrictionContact(a, b, offset.normalized(), 0.5, depth, 0.4)]

    world = ParticleWorld([a, b], [FrictionGround([a, b], 0.2), Touch()])
    energy = mechanical_energy([a, b])
    for _ in range(240):
        world.step(FRAME)
        now = mechanical_energy([a, b])
        assert now < energy + 0.05  # pushing bodies apart lifts them a little
        energy = now
    assert a.velocity.magnitude() < 0.2  # only the gravity of one step, g h = 0.16 m/s
    assert b.velocity.magnitude() < 0.2


def test_a_ball_rests_on_planks_and_falls_between_them() -> None:
    def rows() -> list[tuple[Particle, Particle]]:
        return [
            (
                Particle(Vector3(x, 4.0, -1.0), mass=math.inf),
                Particle(Vector3(x, 4.0, 1.0), mass=math.inf),
            )
            for x in (0.0, 2.0)
        ]

    for radius, falls in ((0.5, True), (1.2, False)):
        ball = Particle(Vector3(1.0, 5.0), acceleration=Vector3(0.0, -G))
        world = ParticleWorld([ball], [Planks(ball, radius, rows())])
        for _ in range(90):
            world.step(FRAME)
        assert (ball.position.y < 3.0) is falls
        if not falls:  # it lies in the gap, on both planks
            assert ball.position.y == pytest.approx(4.0 + math.sqrt(radius**2 - 1.0), abs=5e-3)


def test_a_bridge_of_rods_hangs_as_one_of_cables() -> None:
    shapes = []
    for kind in (Cable, Rod):
        bridge = Bridge()
        links = bridge.world.contact_generators
        for i, link in enumerate(links):
            if type(link) is Cable:
                links[i] = kind(link.a, link.b, 1.9)
        for _ in range(300):
            bridge.step(FRAME)
        shapes.append(
            [component for row in bridge.rows for end in row for component in end.position]
        )
    assert shapes[0] == pytest.approx(shapes[1], abs=5e-3)  # both still swing by a few mm


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
