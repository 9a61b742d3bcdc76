"""The two equations for damping that the book compares. The engine's own form is in particle.py.

The damping d is the fraction of the velocity that is kept, and the equations differ in how often
this fraction applies. In Eq. 3.5 each step keeps the fraction d, however long the step is. In Eq.
3.6 each second of simulated time keeps it, so the motion does not depend on the frame rate.

Both functions return the velocity after a step as a new vector, and do not change their arguments.
The velocity is in m/s, the acceleration in m/s^2 and the duration in s. A damping or a duration
that is not a number raises TypeError.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Return the new velocity v' = v d + a h, where d is kept per step (Eq. 3.5).

    Because d is applied once per step, however short the step is, motion is damped more strongly at
    a higher frame rate.

    Raises ValueError if the damping is negative or not finite, or if the duration is not positive
    and finite.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Return the new velocity v' = v d^h + a h, where d is kept per second (Eq. 3.6).

    ``Particle.kick`` uses the form of the book's listing instead, which is (v + a h) d^h (E-16).

    Raises ValueError if the damping is negative or not finite, or if the duration is not positive
    and finite.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")
