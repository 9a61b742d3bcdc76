"""Going further: a pendulum and a double pendulum, described by their angles.

In a plane, a mass on a rod can only move along a circle, so one angle is enough to describe a
pendulum. A model with a particle and a rod changes two coordinates and then has to correct them. A
model with only the angle needs no corrections, so Runge-Kutta 4 keeps its order of 4. In the same
way, two angles describe a double pendulum. The module angle_chain.py does this for any number of
rods.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3


class AnglePendulum:
    """A mass on a massless rod that swings about the origin in the X-Y plane.

    ``length`` is in m. ``angle`` is in radians, measured from straight down toward +X.
    ``angular_velocity`` is in rad/s and ``gravity`` in m/s^2. Each argument is stored in an
    attribute of the same name. There is no argument for the mass, because it does not affect the
    motion.

    Raises:
        ValueError: if length or gravity is not positive, or a number is not finite.
        TypeError: if an argument is not a number.
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
        """The position of the mass in m, as a new vector."""
        x, y = self.length * math.sin(self.angle), -self.length * math.cos(self.angle)
        return Vector3(x, y)

    def step(self, duration: float) -> None:
        """Move the pendulum by one Runge-Kutta 4 step of ``duration`` s.

        The angular acceleration is -(g / l) sin(angle).

        Raises:
            ValueError: if the duration is not positive and finite.
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


class DoublePendulum:
    """A pendulum that hangs from another pendulum: two masses on two massless rods.

    It swings in the X-Y plane. The first rod rotates about the origin, and the second rod about the
    first mass. ``lengths`` are in m and ``masses`` in kg. ``angles`` are in radians, measured from
    straight down toward +X. ``angular_velocities`` are in rad/s and ``gravity`` is in m/s^2. Each
    argument is stored in an attribute of the same name.

    An AngleChain with two rods moves in the same way, but its steps take twice as long.

    Raises:
        ValueError: if a list does not have two numbers, if a length, a mass or gravity is not
            positive, or if a number is not finite.
        TypeError: if an argument is not a number.
    """

    def __init__(
        self,
        lengths: Sequence[float],
        masses: Sequence[float],
        angles: Sequence[float],
        angular_velocities: Sequence[float] = (0.0, 0.0),
        gravity: float = 9.81,
    ) -> None:
        self.lengths = [positive("length", length) for length in lengths]
        self.masses = [positive("mass", mass) for mass in masses]
        self.angles = [finite("angle", angle) for angle in angles]
        self.angular_velocities = [finite("angular_velocity", w) for w in angular_velocities]
        self.gravity = positive("gravity", gravity)
        for name in ("lengths", "masses", "angles", "angular_velocities"):
            if len(getattr(self, name)) != 2:
                raise ValueError(f"{name} must be two numbers, got {getattr(self, name)!r}")

    @property
    def positions(self) -> list[Vector3]:
        """The positions of the two masses in m, as new vectors."""
        (a, b), (inner, outer) = self.angles, self.lengths
        x, y = inner * math.sin(a), -inner * math.cos(a)
        return [Vector3(x, y), Vector3(x + outer * math.sin(b), y - outer * math.cos(b))]

    def step(self, duration: float) -> None:
        """Move the pendulum by one Runge-Kutta 4 step of ``duration`` s.

        The step solves Lagrange's equations. Here a and b are the two angles, d is a - b, and M is
        the sum of the masses m1 and m2:

            M l1 a'' + m2 l2 b'' cos d = -m2 l2 b'^2 sin d - M g sin a
              l1 a'' cos d + l2 b''    =     l1 a'^2 sin d -   g sin b

        Source: Landau and Lifshitz, Mechanics, section 5, problem 1.

        Raises:
            ValueError: if the duration is not positive and finite.
        """
        h = positive("duration", duration)
        half, sixth = 0.5 * h, h / 6.0
        (inner, outer), gravity = self.lengths, self.gravity
        ratio = self.masses[1] / (self.masses[0] + self.masses[1])

        def gains(a: float, b: float, u: float, v: float) -> tuple[float, float]:
            """Return the angular accelerations for two angles and two angular velocities."""
            sine, cosine = math.sin(a - b), math.cos(a - b)
            first = -ratio * outer * v * v * sine - gravity * math.sin(a)
            second = inner * u * u * sine - gravity * math.sin(b)
            gain = (first - ratio * cosine * second) / (1.0 - ratio * cosine * cosine)
            return gain / inner, (second - cosine * gain) / outer

        (a, b), (u1, v1) = self.angles, self.angular_velocities
        p1, q1 = gains(a, b, u1, v1)
        u2, v2 = u1 + half * p1, v1 + half * q1
        p2, q2 = gains(a + half * u1, b + half * v1, u2, v2)
        u3, v3 = u1 + half * p2, v1 + half * q2
        p3, q3 = gains(a + half * u2, b + half * v2, u3, v3)
        u4, v4 = u1 + h * p3, v1 + h * q3
        p4, q4 = gains(a + h * u3, b + h * v3, u4, v4)
        self.angles = [
            a + sixth * (u1 + 2.0 * (u2 + u3) + u4),
            b + sixth * (v1 + 2.0 * (v2 + v3) + v4),
        ]
        self.angular_velocities = [
            u1 + sixth * (p1 + 2.0 * (p2 + p3) + p4),
            v1 + sixth * (q1 + 2.0 * (q2 + q3) + q4),
        ]
