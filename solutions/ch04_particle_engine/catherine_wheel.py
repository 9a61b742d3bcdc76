"""A Catherine wheel (mini-project 4.4), which is a firework that rotates and throws sparks.

The wheel rotates at a constant rate, so a formula gives the state of its nozzle at any time, and
only the sparks are particles.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.fireworks import FireworksShow


class CatherineWheel:
    """A wheel in the X-Y plane that rotates at a constant rate and throws sparks from its rim.

    The wheel rotates from X toward Y at ``rate`` in rad/s. A nozzle on its rim throws
    ``sparks_per_second`` sparks of the type ``spark_type`` into ``show``, backward relative to the
    motion of the rim, at the speed ``jet`` in m/s. ``angle`` is the current angle of the nozzle,
    measured from the X axis, and ``thrown`` is the number of sparks thrown so far. The constructor
    raises ValueError for an unknown type or a number that is out of range.
    """

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
        if spark_type not in show.rules:
            raise ValueError(f"spark_type must be one of {sorted(show.rules)}, got {spark_type!r}")
        self.show = show
        self.spark_type = spark_type
        self.center = finite_vector("center", center)
        self.radius = positive("radius", radius)
        self.rate = positive("rate", rate)
        self.sparks_per_second = not_negative("sparks_per_second", sparks_per_second)
        self.jet = not_negative("jet", jet)
        self.time = 0.0
        self.angle = 0.0
        self.thrown = 0

    def nozzle(self) -> Particle:
        """Create a particle at the nozzle of the wheel, which is the parent of new sparks.

        Place it on the rim, at the wheel's angle, with a velocity perpendicular to the spoke. The
        rim moves at ``rate`` times ``radius``. The sparks are thrown backward, so the speed of the
        particle is the speed of the rim minus ``jet``.
        """
        x, y = math.cos(self.angle), math.sin(self.angle)
        spoke, along = Vector3(x, y), Vector3(-y, x)
        speed = self.rate * self.radius - self.jet
        return Particle(self.center + spoke * self.radius, along * speed)

    def update(self, duration: float) -> None:
        """Rotate the wheel for ``duration`` s, and light the sparks that leave its nozzle.

        After t seconds in total, the wheel has thrown ``sparks_per_second`` times t sparks, rounded
        down, which does not depend on the length of the steps. All sparks of a step start where the
        nozzle is at its end. They count as thrown even if the show has no room for them.
        """
        self.time += positive("duration", duration)
        self.angle += self.rate * duration
        due = math.floor(self.sparks_per_second * self.time) - self.thrown
        if due > 0:
            self.show.light([(self.spark_type, due, self.nozzle())])
            self.thrown += due
