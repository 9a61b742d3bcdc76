"""A Catherine wheel (mini-project 4.4): a nozzle on a turning wheel that throws sparks.

It needs no force to stay on its circle: its angle is known at any time, and so are its place and
its velocity. Only the sparks are particles.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.fireworks import FireworksShow


class CatherineWheel:
    """A wheel in the X-Y plane about ``center`` (m), of a ``radius`` in m, turning for ever.

    It turns from X towards Y with the ``rate``, in rad/s. From its rim sparks of a type of the show
    leave, ``sparks_per_second`` of them, thrown back against the motion of the rim with the speed
    ``jet`` in m/s. ``angle`` is that of the nozzle, from the X axis, and ``thrown``
    counts the sparks that have left.

    Raises ValueError where the show has no such type or a number means nothing.
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
        """Mini-project 4.4: return a particle at the nozzle, as new, to be the parent of sparks.

        It is on the rim at the wheel's angle. Its velocity is that of the rim, rate x radius at
        right angles to the spoke, less the jet.
        """
        raise NotImplementedError("Exercise 4.4: A Catherine wheel")

    def update(self, duration: float) -> None:
        """Mini-project 4.4: turn on by a frame in s, and light the sparks that are due by its end.

        After t seconds in all, the whole part of sparks_per_second x t have left, however long the
        frames are, up to the rounding of t. Those of a frame leave the nozzle where it is at the
        end of it, and count as thrown even if the show has no room for them. The show is updated
        by whoever has it.

        Raises ValueError where the duration is not positive and finite; nothing has moved then.
        """
        raise NotImplementedError("Exercise 4.4: A Catherine wheel")
