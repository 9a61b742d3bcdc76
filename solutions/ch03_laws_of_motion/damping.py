"""The two equations for damping that the book compares; the engine's own form is in particle.py.

Both return the velocity after a frame, as new, and change nothing. velocity in m/s, acceleration in
m/s^2, duration in s. They differ in what the damping d means: the share of the velocity that is
kept in each frame, however long it is, or in each second. What is no number where one is wanted is
a TypeError.
"""

from __future__ import annotations

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Return v' = v d + a h, where d is the share kept per frame (Eq. 3.5).

    Raises ValueError where the damping is negative or not finite, or the duration is not positive
    and finite.
    """
    not_negative("damping", damping)
    return velocity * damping + acceleration * positive("duration", duration)


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Return v' = v d^h + a h, where d is the share kept per second (Eq. 3.6).

    Particle.integrate has the form of the book's listing instead, (v + a h) d^h (E-16).

    Raises ValueError where the damping is negative or not finite, or the duration is not positive
    and finite.
    """
    not_negative("damping", damping)
    kept: float = damping ** positive("duration", duration)
    return velocity * kept + acceleration * duration
