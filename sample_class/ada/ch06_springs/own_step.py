"""A step of one's own: Runge and Kutta's, in more parts where the orbit is fast."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


def my_step(
    particles: Sequence[Particle], apply_forces: Callable[[float], None], duration: float
) -> None:
    rates = _rates(particles, apply_forces)
    parts = 1
    for particle, rate in zip(particles, rates, strict=True):
        if (speed := particle.velocity.magnitude()) > 0.0:
            parts = max(parts, min(20, math.ceil(11.0 * duration * rate.magnitude() / speed)))
    h = duration / parts
    for _ in range(parts):
        start = [(one.position.copy(), one.velocity.copy()) for one in particles]
        seen: list[tuple[list[Vector3], list[Vector3]]] = []
        for share in (0.0, 0.5, 0.5, 1.0):
            if seen:
                speeds, rates = seen[-1]
                for i, particle in enumerate(particles):
                    particle.position = start[i][0] + speeds[i] * (share * h)
                    particle.velocity = start[i][1] + rates[i] * (share * h)
            rates = _rates(particles, apply_forces)
            seen.append(([one.velocity.copy() for one in particles], rates))
        for i, particle in enumerate(particles):
            (v1, a1), (v2, a2), (v3, a3), (v4, a4) = ((v[i], a[i]) for v, a in seen)
            particle.position = start[i][0] + (v1 + v2 * 2.0 + v3 * 2.0 + v4) * (h / 6.0)
            particle.velocity = start[i][1] + (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (h / 6.0)


def _rates(particles: Sequence[Particle], apply_forces: Callable[[float], None]) -> list[Vector3]:
    """Return all accelerations, with nothing left in the accumulators."""
    apply_forces(0.0)
    found = []
    for particle in particles:
        found.append(particle.acceleration + particle.force_accumulator * particle.inverse_mass)
        particle.clear_forces()
    return found
