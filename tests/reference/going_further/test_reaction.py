"""The reaction force holds a resting particle, and fails where its docstring says so."""

from __future__ import annotations

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, leapfrog, semi_implicit_euler
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch07_constraints.going_further.reaction import ReactionForce
from ch07_constraints.time_division import TooManyImpacts, time_division_step

FRAME = 1.0 / 60.0
G = 9.81
GRAVITY = Gravity(Vector3(0.0, -G))


def run(step: Integrator, body: Particle, *forces: ForceGenerator, steps: int = 60) -> None:
    registry = ForceRegistry()
    for force in forces:
        registry.add(body, force)
    for _ in range(steps):
        step([body], registry.update_forces, FRAME)


@pytest.mark.parametrize("step", [explicit_euler, semi_implicit_euler, leapfrog])
@pytest.mark.parametrize("generated", [False, True], ids=["built-in gravity", "generator"])
def test_a_resting_particle_stays_and_slides_without_friction(
    step: Integrator, generated: bool
) -> None:
    gravity = Vector3() if generated else Vector3(0.0, -G)
    body = Particle(Vector3(1.0, 2.5), Vector3(3.0), gravity, mass=0.7)
    reaction = ReactionForce(height=2.0, radius=0.5)
    run(step, body, *([GRAVITY] if generated else []), reaction, steps=600)
    # Only m g - m g, which may round to some 1e-16.
    assert body.position.y == pytest.approx(2.5, abs=1e-12)
    assert body.position.x == pytest.approx(1.0 + 3.0 * 10.0, rel=1e-12)
    assert body.last_acceleration.magnitude() < 1e-12


@pytest.mark.parametrize(
    ("y", "vy", "lift", "mass", "wanted"),
    [
        (0.0, 0.0, 6.0, 2.0, 2.0 * G - 6.0),  # N
        (0.0, 0.0, 60.0, 2.0, 0.0),  # it never pulls down
        (1e-6, 0.0, 0.0, 2.0, 0.0),  # in the air
        (0.0, 0.1, 0.0, 2.0, 0.0),  # moving up
        (0.0, 0.0, 0.0, float("inf"), 0.0),
    ],
)
def test_the_force_is_the_weight_less_what_pulls_up(
    y: float, vy: float, lift: float, mass: float, wanted: float
) -> None:
    body = Particle(Vector3(0.0, y), Vector3(0.0, vy), Vector3(0.0, -G), mass=mass)
    body.add_force(Vector3(0.0, lift))
    ReactionForce().update_force(body, FRAME)
    assert body.force_accumulator.y - lift == pytest.approx(wanted, abs=1e-12)


def test_a_force_that_is_registered_later_is_not_canceled() -> None:
    body = Particle()
    run(semi_implicit_euler, body, ReactionForce(), GRAVITY)
    # Free fall by semi-implicit Euler: g h^2 n (n + 1) / 2 after n steps.
    assert body.position.y == pytest.approx(-G * FRAME**2 * 60 * 61 / 2, rel=1e-12)


def test_a_velocity_into_the_ground_is_not_removed_but_does_not_grow() -> None:
    body = Particle(velocity=Vector3(0.0, -2.0), acceleration=Vector3(0.0, -G))
    run(semi_implicit_euler, body, ReactionForce())
    assert (body.velocity.y, body.position.y) == pytest.approx((-2.0, -2.0), rel=1e-12)


def test_in_a_stack_of_two_the_lower_sphere_is_pushed_into_the_ground() -> None:
    radius = 0.5
    for with_ground in (False, True):
        spheres = [Particle(Vector3(0.0, y), acceleration=Vector3(0.0, -G)) for y in (0.5, 1.5)]
        registry = ForceRegistry()
        for sphere in spheres:
            registry.add(sphere, ReactionForce(radius=radius))
        ground = GroundPlane(spheres if with_ground else [], radius=radius)
        detector = Detectors(ParticlePairs(spheres, radius), ground)
        for _ in range(120):
            semi_implicit_euler(spheres, registry.update_forces, FRAME)
            ContactResolver().resolve_contacts(detector.contacts(), FRAME)
        # Without a contact with the ground, the weight of the upper sphere accelerates both.
        low = spheres[0].position.y
        assert abs(low - 0.5) < 0.01 if with_ground else low < -1.0


def test_time_division_can_hold_a_particle_at_rest() -> None:
    """Without the reaction force, a particle at rest has endless impacts."""
    body = Particle(acceleration=Vector3(0.0, -G))
    ground = GroundPlane([body], restitution=0.5)
    with pytest.raises(TooManyImpacts):
        time_division_step([body], ground, FRAME)
    body.velocity, body.position = Vector3(), Vector3()
    for _ in range(60):
        ReactionForce().update_force(body, FRAME)
        time_division_step([body], ground, FRAME)
    assert body.position == Vector3()
