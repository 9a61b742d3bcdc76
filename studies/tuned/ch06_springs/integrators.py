"""The integrators of chapter 6 in plain numbers.

Velocity Verlet and Runge-Kutta keep each particle's state as numbers in one tuple, read the forces
without creating vectors, and make the last kick themselves. The others are those of solutions/.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import NO_FORCE, Particle
from ch06_springs.going_further.adaptive import adaptive as adaptive

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.drift(duration)
        particle.kick(duration)


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)
        particle.drift(duration)


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    positive("duration", duration)
    half = 0.5 * duration
    for particle in particles:
        particle.drift(half)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)
        particle.drift(half)


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    positive("duration", duration)
    half = 0.5 * duration
    starts, by_hand = _starts(particles)
    apply_forces(duration)
    for particle, m, a, p, q, x, y, z, u, v, w, rates in starts:
        fx, fy, fz = force = particle.take_forces()
        rates.append(force)
        if m:
            ax, ay, az = a.x + fx * m, a.y + fy * m, a.z + fz * m
            p.x = x + (u + ax * half) * duration
            p.y = y + (v + ay * half) * duration
            p.z = z + (w + az * half) * duration
            q.x, q.y, q.z = u + ax * duration, v + ay * duration, w + az * duration
    _add_again(by_hand)
    apply_forces(duration)
    for particle, m, _, _, q, _, _, _, u, v, w, [(fx, fy, fz)] in starts:
        gx, gy, gz = particle.take_forces()
        if m:
            q.x, q.y, q.z = u, v, w
            particle._forces[0] = (0.5 * (fx + gx), 0.5 * (fy + gy), 0.5 * (fz + gz))
        particle.kick(duration)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    positive("duration", duration)
    half, sixth = 0.5 * duration, duration / 6.0
    starts, by_hand = _starts(particles)
    for ahead in (half, half, duration, 0.0):  # 0: back to the start after the fourth rate
        apply_forces(duration)
        for particle, m, a, p, q, x, y, z, u, v, w, rates in starts:
            sums = particle._forces
            force = sums[0]
            sums[0] = None
            if m:
                fx, fy, fz = force or NO_FORCE
                dx, dy, dz = q.x, q.y, q.z
                rates.append((dx, dy, dz, fx, fy, fz))
                p.x = x + dx * ahead
                p.y = y + dy * ahead
                p.z = z + dz * ahead
                q.x = u + (a.x + fx * m) * ahead
                q.y = v + (a.y + fy * m) * ahead
                q.z = w + (a.z + fz * m) * ahead
        if by_hand and ahead:
            _add_again(by_hand)
    for particle, m, _, p, _, x, y, z, _, _, _, rates in starts:
        if m:
            (
                (u1, v1, w1, f1, g1, h1),
                (u2, v2, w2, f2, g2, h2),
                (u3, v3, w3, f3, g3, h3),
                (u4, v4, w4, f4, g4, h4),
            ) = rates
            p.x = x + (u1 + 2.0 * (u2 + u3) + u4) * sixth
            p.y = y + (v1 + 2.0 * (v2 + v3) + v4) * sixth
            p.z = z + (w1 + 2.0 * (w2 + w3) + w4) * sixth
            particle._forces[0] = (
                (f1 + 2.0 * (f2 + f3) + f4) / 6.0,
                (g1 + 2.0 * (g2 + g3) + g4) / 6.0,
                (h1 + 2.0 * (h2 + h3) + h4) / 6.0,
            )
        particle.kick(duration)


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    new = (v - h * k * x) / (1.0 + h * c + h * h * k)
    return finite("the new position", x + new * h), finite("the new velocity", new)


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    half = 0.5 * h
    new = (v * (1.0 - half * c - half * half * k) - h * k * x) / (1.0 + half * c + half * half * k)
    return finite("the new position", x + (v + new) * half), finite("the new velocity", new)


class SimulationDiverged(ArithmeticError):  # noqa: N818
    def __init__(self, particle: int, step: int, speed: float, limit: float) -> None:
        super().__init__(
            f"after step {step}, particle {particle} moves at {speed:.4g} m/s, above the limit of "
            f"{limit:g} m/s. Use shorter steps, softer springs or another integrator"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


def watched(integrator: Integrator, speed_limit: float) -> Integrator:
    positive("speed_limit", speed_limit)
    steps = 0

    def step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
        nonlocal steps
        integrator(particles, apply_forces, duration)
        steps += 1
        for i, particle in enumerate(particles):
            v = particle.velocity
            speed = math.hypot(v.x, v.y, v.z)
            if not speed <= speed_limit:  # NaN is not below the limit either
                raise SimulationDiverged(i, steps, speed, speed_limit)

    return step


def _starts(
    particles: Iterable[Particle],
) -> tuple[list[tuple[Any, ...]], list[tuple[Particle, Vector3]]]:
    """Return the initial state of each particle, and the forces that were added before the step.

    A state is (particle, inverse mass, a, p, v, components of p and v, an empty list for results).
    """
    starts: list[tuple[Any, ...]] = []
    by_hand = []
    for particle in particles:
        p, v = particle.position, particle.velocity
        m, a = particle.inverse_mass, particle.acceleration
        starts.append((particle, m, a, p, v, p.x, p.y, p.z, v.x, v.y, v.z, []))
        force = particle.take_forces()
        if force is not NO_FORCE:
            by_hand.append((particle, Vector3(*force)))
    if by_hand:
        _add_again(by_hand)
    return starts, by_hand


def _add_again(by_hand: list[tuple[Particle, Vector3]]) -> None:
    """Restore the forces from before the step, because each evaluation empties the accumulators."""
    for particle, force in by_hand:
        particle.add_force(force)


def _per_mass(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float, float]:
    """Check the arguments of an implicit step, and return h, k / m and c / m."""
    finite("x", x)
    finite("v", v)
    positive("mass", mass)
    return (
        positive("duration", duration),
        not_negative("stiffness", stiffness) / mass,
        not_negative("damping", damping) / mass,
    )
