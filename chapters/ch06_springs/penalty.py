"""Going further: use springs to keep particles out of the ground, and see why this fails.

The book says that one of its exercises does this, but the exercise is missing (erratum E-36).
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, not_negative
from ch05_forces.particle import Particle


class PenaltyGround:
    """Level ground that pushes particles out as a spring would, but never pulls them.

    ``height`` is in m, ``stiffness`` in N/m and ``damping`` in N s/m. You may change them later.

    No stiffness k works well. If the ground is soft, a body of mass m that rests on it sinks in by
    m g / k. If the ground is hard, it pushes for too long. It starts to push only after a step has
    ended below the ground, and then it pushes for the whole next step. Without damping, a body can
    therefore bounce higher than the height from which it fell. To avoid this, k h^2 / m must be far
    below 1, where h is the length of a step in s. If k h^2 / m is above 4, the ground even throws
    bodies that rest on it.

    Raises:
        ValueError: if the height is not finite, or another argument is negative or not finite.
    """

    def __init__(self, height: float, stiffness: float, damping: float = 0.0) -> None:
        self.height = finite("height", height)
        self.stiffness = not_negative("stiffness", stiffness)
        self.damping = not_negative("damping", damping)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Push a particle upward if it is below the ground, with the force k depth - c v_y.

        Here k is ``stiffness``, c is ``damping``, and v_y is the upward velocity of the particle.
        Add the force only if it is positive. The damping reduces the push on a particle that is
        already moving out of the ground, but the ground must not pull this particle back.
        """
        raise NotImplementedError("Exercise G6.1: Going further: collisions by a spring")
