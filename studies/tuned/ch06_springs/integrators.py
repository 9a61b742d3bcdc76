"""The integrators of chapter 6 in plain numbers.

Both Euler methods and leapfrog kick and drift a particle in one call. Velocity Verlet and
Runge-Kutta keep each particle's state as numbers in one tuple, and read the forces without creating
vectors. Runge-Kutta keeps the state of a single particle in local variables, which is a sixth
faster. The others are those of solutions/.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from ch02_vectors.arguments import finite, not_negative, positive
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
    rows = _rows(particles)
    apply_forces(duration)
    for _, sums, by_hand, rates, m, p, q, a, x, y, z, u, v, w in rows:
        force = sums[0] or NO_FORCE
        rates.append(force)
        sums[0] = by_hand
        if m:
            fx, fy, fz = force
            q.x = du = u + (a.x + fx * m) * duration
            q.y = dv = v + (a.y + fy * m) * duration
            q.z = dw = w + (a.z + fz * m) * duration
            p.x = x + (u + du) * 0.5 * duration
            p.y = y + (v + dv) * 0.5 * duration
            p.z = z + (w + dw) * 0.5 * duration
    apply_forces(duration)
    for particle, sums, _, [(fx, fy, fz)], m, _, _, _, _, _, _, u, v, w in rows:
        if m:
            x, y, z = sums[0] or NO_FORCE
            mean = (0.5 * (fx + x), 0.5 * (fy + y), 0.5 * (fz + z))
            particle.kick_from(u, v, w, mean, duration)
        else:
            particle.kick(duration)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    if type(duration) is not float or not 0.0 < duration < math.inf:
        positive("duration", duration)
    if len(particles) == 1 and particles[0]._inverse_mass:
        _runge_kutta_of_one(particles[0], apply_forces, duration)
        return
    half = 0.5 * duration
    rows = _rows(particles)
    for ahead in (half, half, duration):
        apply_forces(duration)
        for _, sums, by_hand, rates, m, p, q, a, x, y, z, u, v, w in rows:
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
    for particle, sums, _, rates, m, p, _, a, x, y, z, u, v, w in rows:
        if m:
            (fx, fy, fz), (gx, gy, gz), (hx, hy, hz) = rates
            gx += hx
            gy += hy
            gz += hz
            hx, hy, hz = sums[0] or NO_FORCE
            p.x = x + (u + (a.x + (fx + gx) * m / 3.0) * half) * duration
            p.y = y + (v + (a.y + (fy + gy) * m / 3.0) * half) * duration
            p.z = z + (w + (a.z + (fz + gz) * m / 3.0) * half) * duration
            mean = (fx + gx + gx + hx) / 6.0, (fy + gy + gy + hy) / 6.0, (fz + gz + gz + hz) / 6.0
            particle.kick_from(u, v, w, mean, duration)
        else:
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

    A row is the particle, the list of its sums of forces, the sum from before the step, which acts
    in each evaluation, an empty list for the sums of the evaluations, the inverse mass, the vectors
    p, v and a, and the components of p and v at the start.
    """
    rows: list[tuple[Any, ...]] = []
    for particle in particles:
        sums = particle._forces
        p = particle.position
        q = particle.velocity
        m = particle._inverse_mass
        a = particle.acceleration
        rows.append((particle, sums, sums[0], [], m, p, q, a, p.x, p.y, p.z, q.x, q.y, q.z))
    return rows


def _runge_kutta_of_one(particle: Particle, apply_forces: ApplyForces, duration: float) -> None:
    """Make a step of Runge-Kutta 4 for one movable particle, with its state in local variables."""
    half = 0.5 * duration
    m = particle._inverse_mass
    sums = particle._forces
    by_hand = sums[0]  # the sum from before the step, which acts in each evaluation
    p = particle.position
    q = particle.velocity
    a = particle.acceleration
    x = p.x
    y = p.y
    z = p.z
    u = q.x
    v = q.y
    w = q.z
    m_half = m * half
    middle_u = u + a.x * half  # the velocity after half a step without forces
    middle_v = v + a.y * half
    middle_w = w + a.z * half
    apply_forces(duration)
    fx, fy, fz = sums[0] or NO_FORCE
    sums[0] = by_hand
    p.x = x + u * half
    p.y = y + v * half
    p.z = z + w * half
    q.x = du = middle_u + fx * m_half
    q.y = dv = middle_v + fy * m_half
    q.z = dw = middle_w + fz * m_half
    apply_forces(duration)
    gx, gy, gz = sums[0] or NO_FORCE
    sums[0] = by_hand
    p.x = x + du * half
    p.y = y + dv * half
    p.z = z + dw * half
    q.x = du = middle_u + gx * m_half
    q.y = dv = middle_v + gy * m_half
    q.z = dw = middle_w + gz * m_half
    apply_forces(duration)
    hx, hy, hz = sums[0] or NO_FORCE
    sums[0] = by_hand
    p.x = x + du * duration
    p.y = y + dv * duration
    p.z = z + dw * duration
    q.x = u + (a.x + hx * m) * duration
    q.y = v + (a.y + hy * m) * duration
    q.z = w + (a.z + hz * m) * duration
    apply_forces(duration)
    gx += hx  # from here on the sum of the second and the third force
    gy += hy
    gz += hz
    hx, hy, hz = sums[0] or NO_FORCE
    m_sixth = m_half / 3.0  # the mean velocity is v + (a + (f + g) / 3m) h / 2
    p.x = x + (middle_u + (fx + gx) * m_sixth) * duration
    p.y = y + (middle_v + (fy + gy) * m_sixth) * duration
    p.z = z + (middle_w + (fz + gz) * m_sixth) * duration
    mean = ((fx + gx + gx + hx) / 6.0, (fy + gy + gy + hy) / 6.0, (fz + gz + gz + hz) / 6.0)
    particle.kick_from(u, v, w, mean, duration)


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
