"""The reaction force holds a resting particle, and fails where its docstring says so."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    velocity_verlet,
)
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch07_constraints.going_further.reaction import ReactionForce
from ch07_constraints.time_division import TooManyImpacts, time_division_step

FRAME = 1.0 / 60.0
G = 9.81
STEPS = (explicit_euler, semi_implicit_euler, leapfrog, velocity_verlet, runge_kutta_4)


def registered(*forces: tuple[Particle, ForceGenerator]) -> ForceRegistry:
    registry = ForceRegistry()
    for particle, generator in forces:
        registry.add(particle, generator)
    return registry


def run(
    step: Integrator, particles: Sequence[Particle], registry: ForceRegistry, steps: int
) -> None:
    for _ in range(steps):
        step(particles, registry.update_forces, FRAME)


@pytest.mark.parametrize("step", STEPS)
@pytest.mark.parametrize("generated", [False, True], ids=["built-in gravity", "generator"])
def test_a_resting_particle_stays_and_no_contact_has_to_be_resolved(
    step: Integrator, generated: bool
) -> None:
    body = Particle(Vector3(1.0, 2.5), Vector3(3.0), mass=0.7)
    reaction = ReactionForce(height=2.0, radius=0.5)
    if generated:
        registry = registered((body, Gravity(Vector3(0.0, -G))), (body, reaction))
    else:
        body.acceleration = Vector3(0.0, -G)
        registry = registered((body, reaction))
    run(step, [body], registry, 600)
    # Only m g - m g, which may round to some 1e-16, and no friction along the ground.
    assert body.position.y == pytest.approx(2.5, abs=1e-12)
    assert body.position.x == pytest.approx(1.0 + 3.0 * 10.0, rel=1e-12)
    assert body.last_acceleration.magnitude() < 1e-12


def test_the_force_is_the_weight_less_what_pulls_up_and_never_pulls_down() -> None:
    """A spring that pulls up with 30 N/m times 0.2 m carries 6 N of the weight of 2 kg."""
    for stiffness, wanted in ((30.0, 2.0 * G - 6.0), (300.0, 0.0)):
        body = Particle(acceleration=Vector3(0.0, -G), mass=2.0)
        AnchoredSpring(Vector3(0.0, 0.2), stiffness, 0.0).update_force(body, FRAME)
        before = body.force_accumulator.y
        ReactionForce().update_force(body, FRAME)
        assert body.force_accumulator.y - before == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize(("height", "speed"), [(1e-6, 0.0), (0.0, 0.1)], ids=["above", "moving up"])
def test_a_particle_that_flies_feels_nothing(height: float, speed: float) -> None:
    body = Particle(Vector3(0.0, height), Vector3(0.0, speed), Vector3(0.0, -G))
    ReactionForce().update_force(body, FRAME)
    assert body.force_accumulator == Vector3()


def test_an_immovable_particle_needs_no_force() -> None:
    body = Particle(acceleration=Vector3(0.0, -G))
    body.inverse_mass = 0.0
    ReactionForce().update_force(body, FRAME)
    assert body.force_accumulator == Vector3()


def test_a_force_that_is_registered_later_is_not_canceled() -> None:
    body = Particle()
    registry = registered((body, ReactionForce()), (body, Gravity(Vector3(0.0, -G))))
    run(semi_implicit_euler, [body], registry, 60)
    # Free fall by semi-implicit Euler: g h^2 n (n + 1) / 2 after n steps.
    assert body.position.y == pytest.approx(-G * FRAME**2 * 60 * 61 / 2, rel=1e-12)


def test_a_velocity_into_the_ground_is_not_removed_but_does_not_grow() -> None:
    body = Particle(velocity=Vector3(0.0, -2.0), acceleration=Vector3(0.0, -G))
    registry = registered((body, ReactionForce()))
    run(semi_implicit_euler, [body], registry, 60)
    assert body.velocity.y == pytest.approx(-2.0, rel=1e-12)
    assert body.position.y == pytest.approx(-2.0, rel=1e-12)
    for contact in GroundPlane([body]).contacts():
        contact.resolve(FRAME)
    run(semi_implicit_euler, [body], registry, 60)
    assert body.position.y == pytest.approx(0.0, abs=1e-12)


def test_in_a_stack_of_two_the_lower_sphere_is_pushed_into_the_ground() -> None:
    lower, upper = (Particle(Vector3(0.0, y), acceleration=Vector3(0.0, -G)) for y in (0.5, 1.5))
    spheres, radius = [lower, upper], 0.5
    registry = registered(*((sphere, ReactionForce(radius=radius)) for sphere in spheres))
    pairs, ground = ParticlePairs(spheres, radius), GroundPlane(spheres, radius=radius)
    for detector, sinks in ((pairs, True), (Detectors(pairs, ground), False)):
        lower.position, upper.position = Vector3(0.0, 0.5), Vector3(0.0, 1.5)
        lower.velocity, upper.velocity = Vector3(), Vector3()
        for _ in range(120):
            semi_implicit_euler(spheres, registry.update_forces, FRAME)
            ContactResolver().resolve_contacts(detector.contacts(), FRAME)
        # Without a contact with the ground, the weight of the upper sphere accelerates both.
        assert (lower.position.y < -1.0) is sinks
        assert sinks or lower.position.y == pytest.approx(0.5, abs=0.01)


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


@pytest.mark.parametrize(("held", "used"), [(False, 200), (True, 0)])
def test_the_resolver_has_nothing_to_do_for_spheres_that_are_held(held: bool, used: int) -> None:
    spheres = [Particle(Vector3(i, 0.5), acceleration=Vector3(0.0, -G)) for i in range(100)]
    forces = [(sphere, ReactionForce(radius=0.5)) for sphere in spheres]
    registry = registered(*(forces if held else []))
    ground, resolver = GroundPlane(spheres, radius=0.5), ContactResolver()
    for _ in range(10):
        semi_implicit_euler(spheres, registry.update_forces, FRAME)
        resolver.resolve_contacts(ground.contacts(), FRAME)
        assert resolver.iterations_used == used
