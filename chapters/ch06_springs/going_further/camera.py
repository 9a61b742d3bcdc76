"""A camera that follows a moving target on a critically damped spring (book 6.1 and 6.2.2).

This file is complete, so there is nothing to fill in. It uses your AnchoredSpring, your Drag of
chapter 5 and your semi-implicit Euler step.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import AnchoredSpring


class SpringCamera:
    """A camera that starts at rest at ``position`` and follows a target with a delay.

    ``omega`` in 1/s is the angular frequency that the spring would have without damping. The larger
    it is, the faster the camera catches up. The camera has a mass of 1 kg, so the stiffness is
    omega^2 and the critical damping is 2 omega. The damping is a drag on the whole velocity. A
    spring damps only the motion along itself, so the camera would circle a target that turns and
    stops. Behind a target that moves straight ahead at the speed v, the camera stays c v / k =
    2 v / omega behind, where k is the stiffness and c the damping. The motion is stable if omega h
    is below 2 (sqrt(2) - 1) = 0.83, where h is the length of a step in s.

    Raises:
        ValueError: if a component of the position is not finite, or omega is not positive.
    """

    def __init__(self, position: Vector3, omega: float = 5.0) -> None:
        positive("omega", omega)
        self.body = Particle(finite_vector("position", position))
        self.spring = AnchoredSpring(position, omega * omega, 0.0)
        self.drag = Drag(2.0 * omega, 0.0)

    def follow(self, target: Vector3, duration: float) -> None:
        """Move the anchor to ``target``, and let the camera follow for ``duration`` s.

        Pass the position that the target has at the start of the step. If the target has already
        moved to the end of the step at the speed v, the camera is v h closer to it.

        Raises:
            ValueError: if a component of the target is not finite, or the duration is not positive
                and finite. In that case nothing changes.
        """
        anchor = finite_vector("target", target)
        positive("duration", duration)
        self.spring.anchor = anchor
        semi_implicit_euler([self.body], self._pull, duration)

    def _pull(self, duration: float) -> None:
        self.spring.update_force(self.body, duration)
        self.drag.update_force(self.body, duration)
