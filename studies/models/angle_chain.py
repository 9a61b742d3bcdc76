"""Going further: a chain of rods in a plane, described by its angles.

One angle is enough to describe a pendulum. In a chain too, the outer end of each rod can only move
along a circle around the inner end. One angle per rod therefore describes the whole chain. No step
can make a rod too long, and with Runge-Kutta 4 the angles have an error of order 4.

The equations of motion need the tensions of the rods. The tension of a rod accelerates both of its
ends. Each tension therefore appears in the equations of its own rod and of the two neighboring
rods. The equations are solved from the anchor to the tip and back, in a time proportional to the
number of rods.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3


class AngleChain:
    """Point masses on massless rods, one below the other, that swing in the X-Y plane.

    The first rod rotates about the origin. With one rod the chain is a pendulum, and with two rods
    it is a double pendulum. All lists run from the origin to the tip.

    - ``lengths`` are in m.
    - ``masses`` are in kg. Each mass is at the outer end of its rod.
    - ``angles`` are in radians, measured from straight down toward +X.
    - ``angular_velocities`` are in rad/s. If they are omitted, all are 0.
    - ``gravity`` is in m/s^2.

    Each argument is stored in an attribute of the same name.

    Raises:
        ValueError: if the lists are empty or differ in length, if a length, a mass or gravity is
            not positive, or if a number is not finite.
        TypeError: if an argument is not a number.
    """

    def __init__(
        self,
        lengths: Sequence[float],
        masses: Sequence[float],
        angles: Sequence[float],
        angular_velocities: Sequence[float] | None = None,
        gravity: float = 9.81,
    ) -> None:
        speeds = [0.0] * len(angles) if angular_velocities is None else angular_velocities
        counts = {len(lengths), len(masses), len(angles), len(speeds)}
        if len(counts) > 1 or not lengths:
            raise ValueError(f"lists must have one number for each rod, got {sorted(counts)}")
        self.lengths = [positive("length", length) for length in lengths]
        self.masses = [positive("mass", mass) for mass in masses]
        self.angles = [finite("angle", angle) for angle in angles]
        self.angular_velocities = [finite("angular_velocity", speed) for speed in speeds]
        self.gravity = positive("gravity", gravity)

    @property
    def positions(self) -> list[Vector3]:
        """The positions of the masses in m, from the first mass to the tip, as new vectors."""
        x = y = 0.0
        places = []
        for length, angle in zip(self.lengths, self.angles, strict=True):
            x += length * math.sin(angle)
            y -= length * math.cos(angle)
            places.append(Vector3(x, y))
        return places

    def step(self, duration: float) -> None:
        """Move the chain by one Runge-Kutta 4 step of ``duration`` s.

        Raises:
            ValueError: if the duration is not positive and finite.
        """
        h = positive("duration", duration)
        velocities = self.angular_velocities
        v1, a1 = self._rates(0.0, velocities, velocities)
        v2, a2 = self._rates(0.5 * h, v1, a1)
        v3, a3 = self._rates(0.5 * h, v2, a2)
        v4, a4 = self._rates(h, v3, a3)
        sixth = h / 6.0
        for i in range(len(velocities)):
            self.angles[i] += sixth * (v1[i] + 2.0 * (v2[i] + v3[i]) + v4[i])
            velocities[i] += sixth * (a1[i] + 2.0 * (a2[i] + a3[i]) + a4[i])

    def accelerations(self) -> list[float]:
        """Return the angular accelerations in rad/s^2 in the present state."""
        velocities = self.angular_velocities
        return self._rates(0.0, velocities, velocities)[1]

    def _rates(
        self, ahead: float, turning: Sequence[float], gaining: Sequence[float]
    ) -> tuple[list[float], list[float]]:
        """Return the angular velocities and accelerations for a state ``ahead`` s from now.

        Until then, the angles change at the rates ``turning``, and the angular velocities change at
        the rates ``gaining``.
        """
        # Row i: (1/m0 + 1/m1) T[i] - cos/m0 T[i-1] - cos/m1 T[i+1] = L w^2, with the tensions T in
        # N, the masses m0 and m1 at the ends of the rod, and the cosines of the bends, which are
        # the angles between rods. Elimination leaves T[i] = value + factor T[i+1] in each row. The
        # anchor does not accelerate, so gravity enters in the first row only.
        lengths, masses, angles, velocities = (
            self.lengths,
            self.masses,
            self.angles,
            self.angular_velocities,
        )
        angle, speed = angles[0] + ahead * turning[0], velocities[0] + ahead * gaining[0]
        inner = pivot = 1.0 / masses[0]
        value = (lengths[0] * speed * speed + self.gravity * math.cos(angle)) / pivot
        weight = self.gravity * math.sin(angle)
        speeds, rows = [speed], []
        for i in range(1, len(angles)):
            length, outer, before = lengths[i], 1.0 / masses[i], angle
            angle, speed = angles[i] + ahead * turning[i], velocities[i] + ahead * gaining[i]
            bend = angle - before
            beside = inner * math.cos(bend)
            factor = beside / pivot
            rows.append((length, inner * math.sin(bend), factor, value))
            pivot = inner + outer - beside * factor
            value = (length * speed * speed + beside * value) / pivot
            speeds.append(speed)
            inner = outer

        # A rod is turned by what the rods beside it pull across it. From the tip to the anchor:
        accelerations = []
        tension, across = value, 0.0
        for length, turn, factor, value in reversed(rows):
            nearer = value + factor * tension
            accelerations.append((across - turn * nearer) / length)
            across = turn * tension
            tension = nearer
        accelerations.append((across - weight) / lengths[0])
        accelerations.reverse()
        return speeds, accelerations
