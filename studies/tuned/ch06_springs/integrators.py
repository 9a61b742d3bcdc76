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
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.drift_and_kick(duration)


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick_and_drift(duration, duration)


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    half = 0.5 * duration
    for particle in particles:
        particle.drift(half)
    apply_forces(duration)
    for particle in particles:
        particle.kick_and_drift(duration, half)


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    half = 0.5 * duration
    rows = _rows(particles)
    apply_forces(duration)
    for sums, by_hand, rates, m, p, q, a, x, y, z, u, v, w in rows:
        force = sums[0] or NO_FORCE
        rates.append(force)
        sums[0] = by_hand
        if m:
            fx, fy, fz = force
            dx = (a.x + fx * m) * duration
            dy = (a.y + fy * m) * duration
            dz = (a.z + fz * m) * duration
            p.x = x + (u + 0.5 * dx) * duration
            p.y = y + (v + 0.5 * dy) * duration
            p.z = z + (w + 0.5 * dz) * duration
            q.x = u + dx
            q.y = v + dy
            q.z = w + dz
    apply_forces(duration)
    for sums, _, rates, m, _, q, _, _, _, _, u, v, w in rows:
        if m:
            fx, fy, fz = rates[0]
            gx, gy, gz = sums[0] or NO_FORCE
            sums[0] = (0.5 * (fx + gx), 0.5 * (fy + gy), 0.5 * (fz + gz))
            q.x = u
            q.y = v
            q.z = w
    for particle in particles:
        particle.kick(duration)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    half = 0.5 * duration
    rows = _rows(particles)
    for ahead in (half, half, duration):
        apply_forces(duration)
        for sums, by_hand, rates, m, p, q, a, x, y, z, u, v, w in rows:
            force = sums[0] or NO_FORCE
            rates.append(force)
            sums[0] = by_hand
            if m:
                fx, fy, fz = force
                p.x = x + q.x * ahead
                p.y = y + q.y * ahead
                p.z = z + q.z * ahead
                q.x = u + (a.x + fx * m) * ahead
                q.y = v + (a.y + fy * m) * ahead
                q.z = w + (a.z + fz * m) * ahead
    apply_forces(duration)
    for sums, _, rates, m, p, q, a, x, y, z, u, v, w in rows:
        if m:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = rates
            dx, dy, dz = sums[0] or NO_FORCE
            bx += cx
            by += cy
            bz += cz
            third = m / 3.0  # the mean of the velocities is v + (a + (f1 + f2 + f3) / 3m) h / 2
            p.x = x + (u + (a.x + (ax + bx) * third) * half) * duration
            p.y = y + (v + (a.y + (ay + by) * third) * half) * duration
            p.z = z + (w + (a.z + (az + bz) * third) * half) * duration
            q.x = u
            q.y = v
            q.z = w
            sums[0] = (
                (ax + bx + bx + dx) / 6.0,
                (ay + by + by + dy) / 6.0,
                (az + bz + bz + dz) / 6.0,
            )
    for particle in particles:
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


def _rows(particles: Iterable[Particle]) -> list[tuple[Any, ...]]:
    """Return a row of what a step needs of each particle.

    A row is the list of its sums of forces, the sum from before the step, which acts in each
    evaluation, an empty list for the sums of the evaluations, its inverse mass, its vectors p, v
    and a, and the components of p and v at the start.
    """
    rows = []
    for particle in particles:
        sums = particle._forces
        p = particle.position
        q = particle.velocity
        m = particle._inverse_mass
        a = particle.acceleration
        rows.append((sums, sums[0], [], m, p, q, a, p.x, p.y, p.z, q.x, q.y, q.z))
    return rows


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
