"""Ada's wheel."""

import math

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


class CatherineWheel:
    def __init__(self, show, spark_type, center, radius, rate, sparks_per_second, jet=0.0):
        self.show = show
        self.spark_type = spark_type
        self.center = center.copy()
        self.radius = radius
        self.rate = rate
        self.sparks_per_second = sparks_per_second
        self.jet = jet
        self.time = 0.0
        self.angle = 0.0
        self.thrown = 0

    def nozzle(self):
        axis = Vector3(0, 0, 1)
        spoke = Vector3(math.cos(self.angle), math.sin(self.angle), 0) * self.radius
        along = axis.cross(spoke)
        rim = along * self.rate
        return Particle(self.center + spoke, rim - along.normalized() * self.jet)

    def update(self, duration):
        self.time += positive("duration", duration)
        self.angle = self.rate * self.time
        due = int(self.sparks_per_second * self.time) - self.thrown
        self.show.light([(self.spark_type, due, self.nozzle())])
        self.thrown += due
