"""A force generator that reacts to keys, as the ball game of the book has it. This file is complete.

The ball game of this project adds the player's force by hand, and its ball jumps automatically. In
the book's project 8.1, the player decides when the ball jumps to the left, to the right or higher.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle


class KeyForce:
    """A force generator that moves a particle as the player's keys say (project 8.1).

    Set ``direction`` to -1 while the left key is down, to 1 while the right key is down, and to 0
    otherwise. The particle then gets the acceleration ``push`` in m/s^2 in this direction. When the
    player presses the key for a jump, set ``jump`` to the upward velocity in m/s that the next step
    should add, and set it back to 0 after that step. A larger number makes the ball jump higher.

    Raises:
        ValueError: if the push is not finite.
    """

    def __init__(self, push: float = 8.0) -> None:
        self.push = finite("push", push)
        self.direction = 0
        self.jump = 0.0

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add the force of the keys. ``duration`` is the length of the time step in s.

        A force f that acts for one step of h s changes the velocity by f h / m. To add the velocity
        ``jump`` in a single step, the force must be m ``jump`` / h.
        """
        acceleration = Vector3(self.push * self.direction, self.jump / duration)
        particle.add_force(acceleration * particle.mass)
