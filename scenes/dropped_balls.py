"""Balls that are dropped from rest, one above another, and bounce on the ground at height 0."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import Detector, GroundPlane, ParticlePairs
from scenes.setup import Setup


@dataclass(frozen=True)
class DroppedBalls:
    """The scene with the initial heights of the balls' centers in m, from the lowest ball up."""

    heights: Sequence[float]
    restitution: float  # of a ball and the ground
    masses: Sequence[float] = (1.0,)
    between: float = 0.0  # restitution of two balls
    radius: float = 0.0  # m, 0 only for a single ball
    gravity: float = 10.0  # m/s^2

    def setup(self) -> Setup:
        """Create the balls and what detects their contacts."""
        down = Vector3(0.0, -self.gravity)
        balls = [
            Particle(Vector3(0.0, y), acceleration=down, mass=mass)
            for y, mass in zip(self.heights, self.masses, strict=True)
        ]
        return Setup(balls, contacts=self.detectors(balls))

    def detectors(self, balls: Sequence[Particle]) -> list[Detector]:
        """Create the detector of the ground and, if there are several balls, that of pairs."""
        ground = GroundPlane(balls, 0.0, self.radius, self.restitution)
        if len(balls) == 1:
            return [ground]
        return [ground, ParticlePairs(balls, self.radius, self.between)]

    def fall_time(self) -> float:
        """Return how long the lowest ball falls before it first hits the ground, in s."""
        return math.sqrt(2.0 * (self.heights[0] - self.radius) / self.gravity)

    def end(self) -> float:
        """Return when a single ball comes to rest, in s, if its restitution is less than 1."""
        # Each flight takes as long as the one before times the restitution: a geometric series.
        return self.fall_time() * (1.0 + self.restitution) / (1.0 - self.restitution)

    def heights_at(self, times: Iterable[float]) -> list[tuple[float, ...]]:
        """Compute the exact heights at ascending times in s, before the balls rest."""
        y, v, now = [*self.heights], [0.0] * len(self.heights), 0.0
        found = []
        for time in times:
            while (impact := self._next_impact(y, v))[0] <= time - now:
                after, i = impact
                y, v = self._fallen(y, v, after)
                self._collide(v, i)
                now += after
            y, v = self._fallen(y, v, time - now)
            now = time
            found.append(tuple(y))
        return found

    def _next_impact(self, y: list[float], v: list[float]) -> tuple[float, int]:
        """Return the time until the next impact in s, and the upper ball, or 0 for the ground."""
        fall = max(v[0] * v[0] + 2.0 * self.gravity * (y[0] - self.radius), 0.0)
        impacts = [((v[0] + math.sqrt(fall)) / self.gravity, 0)]
        for i in range(1, len(y)):
            gap, closing = y[i] - y[i - 1] - 2.0 * self.radius, v[i - 1] - v[i]
            if closing > 0.0:
                impacts.append((max(gap, 0.0) / closing, i))
        return min(impacts)

    def _fallen(
        self, y: list[float], v: list[float], time: float
    ) -> tuple[list[float], list[float]]:
        fall, pairs = 0.5 * self.gravity * time * time, zip(y, v, strict=True)
        return [a + b * time - fall for a, b in pairs], [b - self.gravity * time for b in v]

    def _collide(self, v: list[float], i: int) -> None:
        if i == 0:
            v[0] *= -self.restitution
            return
        m, n = self.masses[i - 1], self.masses[i]
        change = (1.0 + self.between) * (v[i - 1] - v[i]) / (m + n)
        v[i - 1] -= n * change
        v[i] += m * change
