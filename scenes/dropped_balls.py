"""Balls that are dropped from rest, one above another, and bounce on the ground at height 0."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from scenes.setup import Setup


@dataclass(frozen=True)
class DroppedBalls:
    """The scene with one ball or several, all with the same radius in m, which may be 0 for one.

    - ``heights``: the initial heights of the balls' centers in m, from the lowest ball up.
    - ``restitution``: between a ball and the ground. ``between`` is that between two balls.
    - ``gravity``: in m/s^2, downward.
    """

    heights: Sequence[float]
    restitution: float
    masses: Sequence[float] = (1.0,)
    between: float = 0.0
    radius: float = 0.0
    gravity: float = 10.0

    def setup(self) -> Setup:
        """Create the balls, and the detectors of the ground and of pairs of balls."""
        down = Vector3(0.0, -self.gravity)
        balls = [
            Particle(Vector3(0.0, y), acceleration=down, mass=mass)
            for y, mass in zip(self.heights, self.masses, strict=True)
        ]
        contacts: list[ContactGenerator] = [
            GroundPlane(balls, radius=self.radius, restitution=self.restitution)
        ]
        if len(balls) > 1:
            contacts.append(ParticlePairs(balls, self.radius, self.between))
        return Setup(balls, contacts=contacts)

    def fall_time(self) -> float:
        """Compute how long the lowest ball falls before it first hits the ground, in s."""
        return math.sqrt(2.0 * (self.heights[0] - self.radius) / self.gravity)

    def end(self) -> float:
        """Compute when a single ball comes to rest, in s, if its restitution is less than 1.

        Each flight takes as long as the one before times the restitution.
        """
        return self.fall_time() * (1.0 + self.restitution) / (1.0 - self.restitution)

    def heights_at(self, times: Iterable[float]) -> list[tuple[float, ...]]:
        """Compute the exact heights of the balls at ascending times in s, before they rest.

        Source: parabolas from one impact to the next. The engine is not used, so that its bugs
        cannot affect the result.
        """
        heights, speeds, now = [*self.heights], [0.0] * len(self.heights), 0.0
        found = []
        for time in times:
            while (impact := self._next(heights, speeds))[0] <= time - now:
                after, i = impact
                heights, speeds = self._fallen(heights, speeds, after)
                self._collide(speeds, i)
                now += after
            heights, speeds = self._fallen(heights, speeds, time - now)
            now = time
            found.append(tuple(heights))
        return found

    def _next(self, heights: list[float], speeds: list[float]) -> tuple[float, int]:
        """Find the time until the next impact in s, and the upper ball, or 0 for the ground."""
        first, v, g = heights[0] - self.radius, speeds[0], self.gravity
        impacts = [((v + math.sqrt(max(v * v + 2.0 * g * first, 0.0))) / g, 0)]
        for i in range(1, len(heights)):
            gap = heights[i] - heights[i - 1] - 2.0 * self.radius
            closing = speeds[i - 1] - speeds[i]
            if closing > 0.0:
                impacts.append((max(gap, 0.0) / closing, i))
        return min(impacts)

    def _fallen(
        self, heights: list[float], speeds: list[float], time: float
    ) -> tuple[list[float], list[float]]:
        half, pairs = 0.5 * self.gravity, zip(heights, speeds, strict=True)
        return (
            [y + v * time - half * time * time for y, v in pairs],
            [v - self.gravity * time for v in speeds],
        )

    def _collide(self, speeds: list[float], i: int) -> None:
        if i == 0:
            speeds[0] *= -self.restitution
            return
        m, n = self.masses[i - 1], self.masses[i]
        change = (1.0 + self.between) * (speeds[i - 1] - speeds[i]) / (m + n)
        speeds[i - 1] -= n * change
        speeds[i] += m * change
