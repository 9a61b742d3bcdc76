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
    """Compute the velocity after a time step if every step, long or short, keeps the fraction d.

    The result is v' = v d + a h. Because d is applied once per step, the motion is damped more
    strongly at a higher frame rate.

    Raises:
        ValueError: if the damping is negative or not finite, or if the duration is not positive and
            finite.

    Book Eq. 3.5.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")


def damp_per_second(
    velocity: Vector3, acceleration: Vector3, damping: float, duration: float
) -> Vector3:
    """Compute the velocity after a time step if every second, not every step, keeps the fraction d.

    The result is v' = v d^h + a h. ``Particle.kick`` uses the form of the book's listing instead,
    which is (v + a h) d^h (erratum E-16).

    Raises:
        ValueError: if the damping is negative or not finite, or if the duration is not positive and
            finite.

    Book Eq. 3.6.
    """
    raise NotImplementedError("Exercise B3.3: Two equations for damping")
