"""An elliptical orbit around a center of attraction, which is the origin."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch05_forces.forces import InverseSquareGravity
from ch05_forces.particle import Particle
from scenes.setup import Setup, alone


@dataclass(frozen=True)
class KeplerOrbit:
    """An orbit with a semi-major axis in m, and an attraction of mu / r^2 with mu in m^3/s^2."""

    eccentricity: float
    axis: float = 1.0
    mu: float = 1.0

    @property
    def rate(self) -> float:
        """The mean angular velocity, in rad/s."""
        return math.sqrt(self.mu / self.axis**3)

    @property
    def period(self) -> float:
        """The duration of one revolution, in s."""
        return math.tau / self.rate

    def setup(self, *, from_farthest: bool = False) -> Setup:
        """Create a planet of 1 kg at the point nearest to the center, or at the farthest one."""
        side = -1.0 if from_farthest else 1.0
        e = side * self.eccentricity
        speed = self.rate * self.axis * math.sqrt((1.0 + e) / (1.0 - e))
        planet = Particle(Vector3(side * self.axis * (1.0 - e)), Vector3(0.0, side * speed))
        return alone(planet, InverseSquareGravity(Vector3(), self.mu))

    def exact(self, time: float) -> tuple[float, float]:
        """Compute a planet's position ``time`` s after its nearest point, from Kepler's equation.

        Newton's method with Danby's start converges for every eccentricity.
        """
        e, mean = self.eccentricity, self.rate * time
        anomaly = mean + math.copysign(0.85 * e, math.sin(mean))
        for _ in range(60):
            anomaly -= (anomaly - e * math.sin(anomaly) - mean) / (1.0 - e * math.cos(anomaly))
        wide = self.axis * math.sqrt(1.0 - e * e)
        return self.axis * (math.cos(anomaly) - e), wide * math.sin(anomaly)
