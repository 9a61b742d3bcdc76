"""Compare the book's two equations for damping, which slows a particle down.

The damping d is the fraction of its velocity that a particle keeps. In Eq. 3.5 the particle keeps
this fraction in every time step, however long the step is. In Eq. 3.6 it keeps this fraction in
every second of simulated time, so the damping does not depend on the frame rate. With d = 0 the
particle keeps nothing of its velocity, and with d above 1 it speeds up. The engine itself uses a
variant of Eq. 3.6, which you write in particle.py.

Both functions return the velocity after a time step as a new vector, and do not change their
arguments. The velocity is in m/s, the acceleration in m/s^2 and the duration in s.
"""

from __future__ import annotations

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute a velocity after one time step, with damping that is applied once per step.

    The result is v' = v d + a h, where a is the acceleration and h is the duration. Every step
    multiplies the velocity by d, however long the step is. A higher frame rate means more steps per
    second, so it damps the motion more strongly.

    Book Eq. 3.5.
    """
    not_negative("damping", damping)
    return velocity * damping + acceleration * positive("duration", duration)


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute a velocity after one time step, with damping that depends on the step's duration.

    The result is v' = v d^h + a h, where a is the acceleration and h is the duration. The particle
    keeps the fraction d of its velocity per second, so in a step of h s it keeps d^h. In contrast,
    ``Particle.kick`` computes (v + a h) d^h, like the book's listing (erratum E-16).

    Book Eq. 3.6.
    """
    not_negative("damping", damping)
    kept: float = damping ** positive("duration", duration)
    return velocity * kept + acceleration * duration
