"""The integrators: conservation by symplectic steps, and known losses of others."""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    ApplyForces,
    Integrator,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    velocity_verlet,
)
from ch06_springs.springs import AnchoredSpring

FRAME = 1.0 / 60.0
STEPS = [explicit_euler, semi_implicit_euler, leapfrog, velocity_verlet, runge_kutta_4]
SYMPLECTIC = (semi_implicit_euler, leapfrog, velocity_verlet)


def swinging() -> tuple[Particle, ApplyForces]:
    """Return 2 kg that swing in the plane on a spring of 1 m, which is not linear."""
    particle = Particle(Vector3(1.4, 0.2), Vector3(-0.5, 2.0), Vector3(0.0, -3.0), mass=2.0)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), 30.0, 1.0))
    return particle, registry.update_forces


START = 4.25 + 15.0 * (math.sqrt(2.0) - 1.0) ** 2 + 1.2  # J, of this particle


def state(particle: Particle) -> Any:
    p, v = particle.position, particle.velocity
    return numpy.array([p.x, p.y, v.x, v.y])


@pytest.mark.parametrize("step", STEPS)
def test_the_jacobian_of_a_step_is_symplectic_for_three_of_them(step: Integrator) -> None:
    """J' W J = W, which implies a determinant of 1: areas in the space of states are conserved."""
    columns = []
    for i in range(4):
        ends = []
        for sign in (1.0, -1.0):
            particle, apply_forces = swinging()
            at = state(particle)
            at[i] += sign * 1e-5
            particle.position, particle.velocity = Vector3(*at[:2]), Vector3(*at[2:])
            step([particle], apply_forces, 0.2)
            ends.append(state(particle))
        columns.append((ends[0] - ends[1]) / 2e-5)
    jacobian = numpy.array(columns).T
    form = numpy.block([[numpy.zeros((2, 2)), numpy.eye(2)], [-numpy.eye(2), numpy.zeros((2, 2))]])
    off = float(abs(jacobian.T @ form @ jacobian - form).max())
    volume = abs(float(numpy.linalg.det(jacobian)) - 1.0)
    # Central differences over 1e-5 have errors of 1e-10 of the third derivative and 1e-11.
    if step in SYMPLECTIC:
        assert max(off, volume) < 1e-7
    else:
        assert min(off, volume) > 1e-3


@pytest.mark.parametrize(
    ("step", "swing"), [(semi_implicit_euler, 0.25), (leapfrog, 0.02), (velocity_verlet, 0.02)]
)
def test_symplectic_steps_keep_the_energy_within_bounds_for_20_000_steps(
    step: Integrator, swing: float
) -> None:
    particle, apply_forces = swinging()
    shares = []
    for _ in range(20_000):
        step([particle], apply_forces, 0.04)
        p = particle.position
        energy = particle.kinetic_energy() + 15.0 * (p.magnitude() - 1.0) ** 2 + 6.0 * p.y
        shares.append(energy / START)
    # w h is 0.15. The energy oscillates by about w h (or its square over 4).
    assert max(abs(share - 1.0) for share in shares) < swing
    # The mean of 2,000 values does not drift, to a tenth of the oscillation.
    assert sum(shares[-2000:]) == pytest.approx(sum(shares[:2000]), rel=swing / 10.0)


@pytest.mark.parametrize(
    ("step", "energy", "digit"),
    [
        (explicit_euler, -0.177, 5e-4),
        (semi_implicit_euler, -0.5023, 5e-5),
        (velocity_verlet, -0.499999, 5e-7),
        (runge_kutta_4, -0.5, 5e-7),
    ],
)
def test_ten_orbits_end_with_the_known_energy(
    step: Integrator, energy: float, digit: float
) -> None:
    """e is 0.6, frames are 0.005, and the exact energy is -0.5. Allow half of the last digit."""
    particle = Particle(Vector3(0.4), Vector3(0.0, 2.0))
    registry = ForceRegistry()
    registry.add(particle, InverseSquareGravity(Vector3(), 1.0))
    for _ in range(round(20.0 * math.pi / 0.005)):
        step([particle], registry.update_forces, 0.005)
    ended = particle.kinetic_energy() - 1.0 / particle.position.magnitude()
    assert ended == pytest.approx(energy, abs=digit)


@pytest.mark.parametrize("step", STEPS)
def test_a_step_moves_the_vectors_that_others_may_hold(step: Integrator) -> None:
    """An anchor that is a particle's own position vector follows it with every integrator."""
    leader = Particle(Vector3(1.0), Vector3(0.0, 2.0, 0.0))
    spring = AnchoredSpring(Vector3(), 3.0, 0.0)
    spring.anchor, held = leader.position, leader.velocity
    for _ in range(3):
        step([leader], lambda _: leader.add_force(Vector3(0.0, 0.0, 5.0)), FRAME)
    assert spring.anchor == leader.position
    assert held == leader.velocity
    assert leader.position.z > 0.0
