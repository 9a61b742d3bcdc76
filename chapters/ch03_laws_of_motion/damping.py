"""Compare the book's two equations for damping, which slows a particle down.

The damping d is the fraction of the velocity that is kept, and the equations differ in how often
this fraction applies. In Eq. 3.5 each time step keeps the fraction d, however long the step is. In
Eq. 3.6 each second of simulated time keeps it, so the motion does not depend on the frame rate. The
engine's own form is in particle.py.

Both functions return the velocity after a time step as a new vector, and do not change their
arguments. The velocity is in m/s, the acceleration in m/s^2 and the duration in s. A damping or a
duration that is not a number raises TypeError.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3


def damp_per_frame(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute a velocity after one time step, with damping that is applied once per step.

    The result is v' = v d + a h, where a is the acceleration and h is the duration. Every step
    keeps the fraction d of the velocity, however long the step is. A higher frame rate means more
    steps per second, so it damps the motion more strongly.

    Raises:
        ValueError: if the damping is negative or not finite, or if the duration is not positive and
            finite.

    Book Eq. 3.5.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute a velocity after one time step, with damping that depends on the step's duration.

    The result is v' = v d^h + a h, where a is the acceleration and h is the duration. Every second
    keeps the fraction d of the velocity, so a step of h s keeps d^h of it. ``Particle.kick`` uses
    the form of the book's listing instead, which is (v + a h) d^h (erratum E-16).

    Raises:
        ValueError: if the damping is negative or not finite, or if the duration is not positive and
            finite.

    Book Eq. 3.6.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")
