"""Going further: a rope of equal links in a plane, described by its angles.

The rope moves exactly as an AngleChain of equal rods does. Because all lengths and masses are
equal, they cancel in the equations of motion, and only the ratio gravity / length is left. A step
therefore takes about 15 % less time.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from studies.models.angle_chain import AngleChain


class AngleRope(AngleChain):
    """A rope of massless links with the same ``length`` in m and the same ``mass`` in kg.

    Each mass is at the outer end of its link. The other arguments, the attributes and the errors
    are the same as for an AngleChain. The lists ``lengths`` and ``masses`` contain one number for
    each link.
    """

    def __init__(
        self,
        length: float,
        mass: float,
        angles: Sequence[float],
        angular_velocities: Sequence[float] | None = None,
        gravity: float = 9.81,
    ) -> None:
        count = len(angles)
        super().__init__([length] * count, [mass] * count, angles, angular_velocities, gravity)

    def _rates(
        self, ahead: float, turning: Sequence[float], gaining: Sequence[float]
    ) -> tuple[list[float], list[float]]:
        """Return the same rates as AngleChain._rates, from simpler equations.

        The equal lengths and masses cancel. Let t be tension / (mass length). Equation i for the
        tensions is then 2 t[i] - cos t[i-1] - cos t[i+1] = w^2.
        """
        angles, velocities = self.angles, self.angular_velocities
        gravity = self.gravity / self.lengths[0]
        angle, speed = angles[0] + ahead * turning[0], velocities[0] + ahead * gaining[0]
        pivot, value = 1.0, speed * speed + gravity * math.cos(angle)
        weight = gravity * math.sin(angle)
        speeds, rows = [speed], []
        for i in range(1, len(angles)):
            before = angle
            angle, speed = angles[i] + ahead * turning[i], velocities[i] + ahead * gaining[i]
            bend = angle - before
            beside = math.cos(bend)
            factor = beside / pivot
            rows.append((math.sin(bend), factor, value))
            pivot = 2.0 - beside * factor
            value = (speed * speed + beside * value) / pivot
            speeds.append(speed)

        accelerations = []
        tension, across = value, 0.0
        for turn, factor, value in reversed(rows):
            nearer = value + factor * tension
            accelerations.append(across - turn * nearer)
            across = turn * tension
            tension = nearer
        accelerations.append(across - weight)
        accelerations.reverse()
        return speeds, accelerations
