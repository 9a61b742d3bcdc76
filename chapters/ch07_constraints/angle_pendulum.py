"""Going further, complete: a pendulum by its angle.

A rod takes two of a particle's three ways to move and leaves it one, in a plane. To move all three
and then mend two is more than the scene needs: the angle alone has all that can happen, its rod is
never too long, and a step of the fourth order needs no contacts.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3


class AnglePendulum:
    """A mass on a massless rod that swings about the origin in the X-Y plane; the mass is no matter.

    length in m, angle in radians from straight down towards +X, angular_velocity in rad/s, gravity
    in m/s^2; the attributes have these names. Raises ValueError where length or gravity is not
    positive, or a number not finite; TypeError for what is no number.
    """

    def __init__(
        self, length: float, angle: float, angular_velocity: float = 0.0, gravity: float = 9.81
    ) -> None:
        self.length = positive("length", length)
        self.angle = finite("angle", angle)
        self.angular_velocity = finite("angular_velocity", angular_velocity)
        self.gravity = positive("gravity", gravity)

    @property
    def position(self) -> Vector3:
        """Where the mass is, in m, as a new vector."""
        x, y = self.length * math.sin(self.angle), -self.length * math.cos(self.angle)
        return Vector3(x, y)

    def step(self, duration: float) -> None:
        """Swing on by a duration in s: Runge-Kutta 4 of the angle's acceleration, -g/l sin.

        Raises ValueError where the duration is not positive and finite.
        """
        h = positive("duration", duration)
        pull = -self.gravity / self.length
        angle, speed = self.angle, self.angular_velocity
        a = pull * math.sin(angle)
        speed_b = speed + 0.5 * h * a
        b = pull * math.sin(angle + 0.5 * h * speed)
        speed_c = speed + 0.5 * h * b
        c = pull * math.sin(angle + 0.5 * h * speed_b)
        speed_d = speed + h * c
        d = pull * math.sin(angle + h * speed_c)
        self.angle = angle + h * (speed + 2.0 * (speed_b + speed_c) + speed_d) / 6.0
        self.angular_velocity = speed + h * (a + 2.0 * (b + c) + d) / 6.0
