"""Compare the book's two equations for damping, which slows a particle down.

The damping d is the fraction of its velocity that a particle keeps. Both functions return the
velocity after a time step as a new vector, and do not change their arguments.
"""

from __future__ import annotations

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute v' = v d + a h: every step keeps the fraction d (book Eq. 3.5)."""
    not_negative("damping", damping)
    return velocity * damping + acceleration * positive("duration", duration)


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute v' = v d^h + a h: every second keeps the fraction d (book Eq. 3.6, E-16)."""
    not_negative("damping", damping)
    kept: float = damping ** positive("duration", duration)
    return velocity * kept + acceleration * duration
