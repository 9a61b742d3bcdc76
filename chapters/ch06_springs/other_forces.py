"""Force generators for buoyancy, the lift of a balloon, overcrowding and homing bullets.

Units, argument checks and ``update_force`` are the same as in springs.py, from which you can import
these classes, too.
"""

from __future__ import annotations

from ch02_vectors.arguments import finite, instance_of, not_negative, positive
from ch05_forces.particle import Particle


class Buoyancy:
    """The upward force of still water on a body that floats or sinks in it (6.2.4).

    ``max_depth`` is half the height of the body in m: the body just touches the water when its
    center is this far above the surface, which is at ``water_height`` in m. ``volume`` is in m^3,
    ``gravity`` in m/s^2, and ``liquid_density`` in kg/m^3: 1000 for fresh water, and from 1020 to
    1030 for sea water. ``max_depth``, ``volume`` and ``liquid_density`` must be positive.
    """

    def __init__(
        self,
        max_depth: float,
        volume: float,
        water_height: float,
        liquid_density: float = 1000.0,
        gravity: float = 9.81,
    ) -> None:
        self.max_depth = positive("max_depth", max_depth)
        self.volume = positive("volume", volume)
        self.water_height = finite("water_height", water_height)
        self.liquid_density = positive("liquid_density", liquid_density)
        self.gravity = not_negative("gravity", gravity)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add an upward force that equals the weight of the displaced water.

        The force is rho V g times the fraction of the body that is under water. The fraction is
        (y_w + s - y) / (2 s), limited to the range from 0 to 1. Here rho is ``liquid_density``, V
        is ``volume``, s is ``max_depth``, and y_w and y are the heights of the water surface and of
        the particle.
        """
        raise NotImplementedError("Exercise B6.4: Buoyancy")


class LighterThanAir:
    """Exercise 6.2: the lift of a balloon, which decreases with height as the air gets thinner.

    At the height y, the lift is F e^(-y / H). Here F is ``max_lift`` in N, the lift at ground level
    (y = 0), and H is ``scale_height`` in m, which must be positive. Below the ground the lift stays
    at ``max_lift``.
    """

    def __init__(self, max_lift: float, scale_height: float) -> None:
        self.max_lift = not_negative("max_lift", max_lift)
        self.scale_height = positive("scale_height", scale_height)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.2: add the lift at the balloon's current height."""
        raise NotImplementedError("Exercise 6.2: Lighter than air")


class Overcrowding:
    """Exercise 6.3: a force that pushes crowded particles apart, like a compressed spring.

    ``particles`` is the list of all particles in the crowd, to which you can add others later. Two
    particles are too close if they are less than ``distance`` m apart.
    """

    def __init__(self, particles: list[Particle], distance: float, stiffness: float) -> None:
        if not isinstance(particles, list):
            raise TypeError(f"particles must be a list, got {particles!r}")
        for i, one in enumerate(particles):
            instance_of(f"particles[{i}]", one, Particle)
        self.particles = particles
        self.distance = not_negative("distance", distance)
        self.stiffness = not_negative("stiffness", stiffness)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.3: push ``particle`` away from every other particle that is too close.

        If the distance l to another particle is less than ``distance``, that particle pushes with
        the force k (``distance`` - l), where k is ``stiffness`` in N/m. A particle at exactly the
        same position does not push, because the direction would be undefined.
        """
        raise NotImplementedError("Exercise 6.3: Overcrowding")


class HomingBullet:
    """Exercise 6.4: a force that steers a bullet toward the future position of its target.

    Their future positions are those after ``look_ahead`` s, if both keep their current velocities.
    """

    def __init__(self, target: Particle, stiffness: float, look_ahead: float) -> None:
        self.target = instance_of("target", target, Particle)
        self.stiffness = not_negative("stiffness", stiffness)
        self.look_ahead = not_negative("look_ahead", look_ahead)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Exercise 6.4: add the force that steers the bullet, ``particle``, toward its target.

        The force is k d, where k is ``stiffness`` in N/m, and d leads from the future position of
        the bullet to the future position of the target. The target feels no force.
        """
        raise NotImplementedError("Exercise 6.4: A homing bullet")
