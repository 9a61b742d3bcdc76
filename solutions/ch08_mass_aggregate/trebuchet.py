"""A trebuchet: a heavy counterweight throws a projectile from a sling (project 8.2).

Everything is in the X-Y plane, and the projectile flies toward positive X. A beam rotates on an
immovable pivot, at which it is bent. Its short arm carries the counterweight, and the sling hangs
from the tip of its long arm.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.links import Cable, TwoSidedRod
from ch08_mass_aggregate.world import ParticleWorld

G = 9.81  # m/s^2
GRAVITY = Vector3(0.0, -G, 0.0)
PIVOT_HEIGHT = 5.0  # m above the ground
PROJECTILE_MASS = 5.0  # kg
TIP_MASS = 5.0  # kg, stands for the mass of the beam
START = math.radians(200.0)  # direction of the long arm at the start, from X toward Y
BEND = math.radians(120.0)  # from the long arm back to the short one, which points up at the start
STEP = 1.0 / 250.0  # s
TIME_LIMIT = 4.0  # s: a sling that has not let go by then throws nothing
ITERATIONS = 70  # per phase
MOST_WEIGHT, LONGEST_BEAM = 400.0, 5.0  # kg, and m for both arms: the limits of my_design


@dataclass(frozen=True)
class Design:
    """The design of a trebuchet, with masses in kg, lengths in m, and angles in degrees.

    The masses and lengths must be positive, the release angle must be between -90 and 90, and the
    projectile must hang above the ground. Otherwise the constructor raises ValueError.
    """

    counterweight: float
    short_arm: float
    long_arm: float
    sling: float
    release_angle: float

    def __post_init__(self) -> None:
        positive("counterweight", self.counterweight)
        positive("short_arm", self.short_arm)
        positive("long_arm", self.long_arm)
        positive("sling", self.sling)
        if not -90.0 < finite("release_angle", self.release_angle) < 90.0:
            raise ValueError(f"release_angle must be between -90 and 90, got {self.release_angle}")
        if PIVOT_HEIGHT + self.long_arm * math.sin(START) <= self.sling:
            raise ValueError(f"sling must not reach the ground, got {self.sling!r}")


@dataclass(frozen=True)
class Throw:
    """The result of a throw: its range, and the fraction of the energy that reached the projectile.

    ``range`` is in m, measured from the pivot. ``share`` is the kinetic and potential energy that
    the projectile gained, divided by the potential energy that the counterweight lost, both from
    the start to the release.
    """

    range: float
    share: float


def my_design() -> Design:
    """Return your own design for a trebuchet that throws far.

    The counterweight may be at most ``MOST_WEIGHT``, and the two arms together at most
    ``LONGEST_BEAM``. A range of 60 m and a fraction of 40 % are good, and 80 m and 50 % are better.
    The checks simulate the throw themselves, so only the numbers in your design count.
    """
    return Design(400.0, 0.8, 4.2, 3.0, 27.0)


class Trebuchet:
    """A trebuchet that is built from ``design``, and the ``world`` that simulates it.

    The particles ``pivot``, ``weight`` (the counterweight), ``tip`` and ``projectile`` start at
    rest. ``flies`` is False until the sling has released the projectile.
    """

    def __init__(self, design: Design) -> None:
        self.design = design
        pivot = Vector3(0.0, PIVOT_HEIGHT)
        tip = pivot + Vector3(math.cos(START), math.sin(START)) * design.long_arm
        weight = pivot + Vector3(math.cos(START - BEND), math.sin(START - BEND)) * design.short_arm
        projectile = tip - Vector3(0.0, design.sling)
        self.pivot = Particle(pivot, mass=math.inf)
        self.weight = Particle(weight, acceleration=GRAVITY, mass=design.counterweight)
        self.tip = Particle(tip, acceleration=GRAVITY, mass=TIP_MASS)
        self.projectile = Particle(projectile, acceleration=GRAVITY, mass=PROJECTILE_MASS)
        self.flies = False
        self.sling = Cable(self.tip, self.projectile, design.sling)
        particles = [self.pivot, self.weight, self.tip, self.projectile]
        self.world = ParticleWorld(particles, [*self.beam(), self.sling], iterations=ITERATIONS)

    def beam(self) -> list[ContactGenerator]:
        """Create the rods that join the pivot, the counterweight and the tip into a rigid beam.

        You may use any set of rods that makes the beam rigid. Their lengths are the current
        distances between their ends.
        """
        ends = ((self.pivot, self.weight), (self.pivot, self.tip), (self.weight, self.tip))
        return [TwoSidedRod(a, b, (b.position - a.position).magnitude()) for a, b in ends]

    def lets_go(self) -> bool:
        """Return True if the sling should release the projectile now.

        The projectile must be above the pivot and moving forward, and its direction of flight at
        most ``design.release_angle`` above the horizontal. Below the pivot it swings forward once
        before the actual throw.
        """
        velocity = self.projectile.velocity
        if velocity.x <= 0.0 or self.projectile.position.y <= PIVOT_HEIGHT:
            return False
        angle = math.degrees(math.atan2(velocity.y, velocity.x))
        return angle <= self.design.release_angle

    def step(self, duration: float) -> None:
        """Advance the throw by ``duration`` s, and release the projectile if ``lets_go()`` is True.

        The sling is then no longer among the contact generators of the world.
        """
        self.world.step(duration)
        if not self.flies and self.lets_go():
            self.flies = True
            self.world.contact_generators.remove(self.sling)

    def throw(self) -> Throw:
        """Simulate the throw, and return the result. A trebuchet can throw only once.

        Call ``step`` with ``STEP`` until the sling releases the projectile. From then on the
        projectile flies without drag until it reaches the ground, which is at a height of 0. The
        throw fails if the projectile reaches the ground while it is still in the sling, or if it
        has not been released within ``TIME_LIMIT``. In that case return Throw(0.0, 0.0).
        """
        weight, projectile = self.weight, self.projectile
        high, low = weight.position.y, projectile.position.y
        for _ in range(round(TIME_LIMIT / STEP)):
            self.step(STEP)
            if self.flies or projectile.position.y <= 0.0:
                break
        if not self.flies:
            return Throw(0.0, 0.0)
        position, velocity = projectile.position, projectile.velocity
        gained = projectile.mass * G * (position.y - low) + projectile.kinetic_energy()
        lost = weight.mass * G * (high - weight.position.y)
        time = (velocity.y + math.sqrt(velocity.y**2 + 2.0 * G * position.y)) / G
        return Throw(position.x + velocity.x * time, gained / lost)
