"""A Catherine wheel (mini-project 4.4), which is a firework that rotates and throws sparks.

The wheel rotates at a constant rate, so a formula gives the angle, the position and the velocity of
the nozzle at any time. The wheel itself therefore needs no simulation, and only the sparks are
particles.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.fireworks import FireworksShow


class CatherineWheel:
    """A wheel in the X-Y plane that rotates at a constant rate and throws sparks from its rim.

    ``center`` and ``radius`` are in m. The wheel rotates from X toward Y at ``rate`` in rad/s. A
    nozzle on its rim throws ``sparks_per_second`` sparks per second, backward relative to the
    motion of the rim, at the speed ``jet`` in m/s. The sparks are fireworks of the type
    ``spark_type``, and the wheel adds them to ``show``. ``angle`` is the current angle of the
    nozzle in radians, measured from the X axis. ``thrown`` is the number of sparks thrown so far.

    Raises:
        ValueError: if the show has no such type, the center is not finite, the radius or the rate
            is not positive, or another number is negative.
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
        """Create a particle at the nozzle of the wheel, from which new sparks start.

        The particle is the parent of the sparks, so they start at its position, and its velocity is
        added to theirs. Place it on the rim, at the wheel's angle, with a velocity perpendicular to
        the spoke. The rim moves at ``rate`` times ``radius``. The sparks are thrown backward, so
        the speed of the particle is the speed of the rim minus ``jet``. Mini-project 4.4.
        """
        x, y = math.cos(self.angle), math.sin(self.angle)
        spoke, along = Vector3(x, y, 0.0), Vector3(-y, x, 0.0)
        speed = self.rate * self.radius - self.jet
        return Particle(self.center + spoke * self.radius, along * speed)

    def update(self, duration: float) -> None:
        """Rotate the wheel for ``duration`` s, and light the sparks that leave its nozzle.

        After a total of t seconds, the wheel has thrown ``sparks_per_second`` times t sparks,
        rounded down. The number therefore does not depend on the length of the steps, apart from
        the rounding errors in t. All sparks of a step start where the nozzle is at the end of the
        step. They count as thrown even if the show has no room for them. Update the show
        separately, because this method only lights the sparks.

        Mini-project 4.4.
        """
        self.time += positive("duration", duration)
        self.angle += self.rate * duration
        due = math.floor(self.sparks_per_second * self.time) - self.thrown
        if due > 0:
            self.show.light([(self.spark_type, due, self.nozzle())])
            self.thrown += due
