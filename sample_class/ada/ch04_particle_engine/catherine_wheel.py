"""A Catherine wheel: a nozzle that goes round and round, and the sparks it throws off."""

from __future__ import annotations

import cmath
import math

from ch02_vectors.arguments import finite, finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.fireworks import FireworksShow


class CatherineWheel:
    """A wheel in the X-Y plane, read as the complex plane, whose nozzle lights sparks of a show."""

    def __init__(
        self,
        show: FireworksShow,
        spark_type: int,
        center: Vector3,
        radius: float,
        rate: float,
        sparks_per_second: float,
        jet: float = 0.0,
    ) -> None:
        if spark_type not in set(show.rules):
            raise ValueError(f"the show has no type {spark_type!r} for the sparks")
        self.show, self.spark_type = show, spark_type
        self.center = finite_vector("center", center)
        self.radius = positive("radius", radius)
        self.rate = finite("rate", rate)
        self.sparks_per_second = not_negative("sparks_per_second", sparks_per_second)
        self.jet = not_negative("jet", jet)
        self.time = self.angle = 0.0
        self.thrown = 0

    def nozzle(self) -> Particle:
        outwards = cmath.rect(1.0, self.angle)
        speed = self.rate * self.radius
        if self.rate:
            speed -= math.copysign(self.jet, self.rate)
        return Particle(
            self.center + _in_space(outwards * self.radius), _in_space(outwards * 1j * speed)
        )

    def update(self, duration: float) -> None:
        seconds = positive("duration", duration)
        by_now = math.floor(self.sparks_per_second * (self.time + seconds))
        self.time += seconds
        self.angle += self.rate * seconds
        due, self.thrown = by_now - self.thrown, by_now
        if due:
            self.show.light([(self.spark_type, due, self.nozzle())])


def _in_space(point: complex) -> Vector3:
    return Vector3(point.real, point.imag, 0.0)
