"""A trebuchet: a heavy counterweight throws a projectile from a sling (project 8.2).

Everything is in the X-Y plane, and the projectile flies toward positive X. A beam rotates on an
immovable pivot. Its short arm carries the counterweight, and the sling hangs from the tip of its
long arm. Because the beam is bent at the pivot, three rods are enough to make it rigid.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ch02_vectors.arguments import finite, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.links import Cable
from ch08_mass_aggregate.world import ParticleWorld

G = 9.81  # m/s^2
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

    The sling releases the projectile while it flies forward above the pivot. This happens as soon
    as its direction of flight is at most ``release_angle`` above the horizontal.

    Raises:
        ValueError: if a number is not finite, a mass or length is not positive, the release angle
            is not between -90 and 90, or the projectile would not hang above the ground.
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

    ``range`` is in m, measured from the pivot. ``share`` is a fraction, such as 0.4 for 40 %. To
    compute it, divide the kinetic and potential energy that the projectile gained by the potential
    energy that the counterweight lost. Both energies are measured from the start to the release. If
    the projectile was never released, ``range`` and ``share`` are 0.
    """

    range: float
    share: float


def my_design() -> Design:
    """Return your own design for a trebuchet that throws far.

    The counterweight may be at most ``MOST_WEIGHT``, and the two arms together may be at most
    ``LONGEST_BEAM``. Your grade depends on the range and on the fraction of the energy that reaches
    the projectile. A range of 60 m and a fraction of 40 % are good, and 80 m and 50 % are better.
    The checks simulate the throw themselves, so only the numbers in your design count. Project
    8.2b.
    """
    raise NotImplementedError("Exercise P8.2b: Your own trebuchet")


class Trebuchet:
    """A trebuchet that is built from ``design``, and the ``world`` that simulates it.

    The particles are ``pivot``, ``weight`` (the counterweight), ``tip`` and ``projectile``, and
    they all start at rest. ``flies`` is False until the sling has released the projectile.
    """

    def __init__(self, design: Design) -> None:
        down = Vector3(0.0, -G, 0.0)
        self.design = design
        pivot = Vector3(0.0, PIVOT_HEIGHT, 0.0)
        long_arm = Vector3(math.cos(START), math.sin(START)) * design.long_arm
        short_arm = Vector3(math.cos(START - BEND), math.sin(START - BEND)) * design.short_arm
        self.pivot = Particle(pivot, mass=math.inf)
        self.weight = Particle(pivot + short_arm, acceleration=down, mass=design.counterweight)
        self.tip = Particle(pivot + long_arm, acceleration=down, mass=TIP_MASS)
        self.projectile = Particle(
            self.tip.position - Vector3(0.0, design.sling), acceleration=down, mass=PROJECTILE_MASS
        )
        self.flies = False
        self.sling = Cable(self.tip, self.projectile, design.sling)
        particles = [self.pivot, self.weight, self.tip, self.projectile]
        self.world = ParticleWorld(particles, [*self.beam(), self.sling], iterations=ITERATIONS)

    def beam(self) -> list[ContactGenerator]:
        """Create the rods that join the pivot, the counterweight and the tip into a rigid beam.

        You may use any set of rods that makes the beam rigid. The length of each rod is the current
        distance between its ends.
        """
        raise NotImplementedError("Exercise P8.2a: A trebuchet")

    def lets_go(self) -> bool:
        """Return True if the sling should release the projectile now.

        The projectile must be above the pivot and moving forward. Its direction of flight must be
        at most ``design.release_angle`` above the horizontal. Do not release it below the pivot,
        where it swings forward once before the actual throw.
        """
        raise NotImplementedError("Exercise P8.2a: A trebuchet")

    def step(self, duration: float) -> None:
        """Advance the throw by one time step, and release the projectile if ``lets_go()`` is True.

        ``duration`` is in s. Call ``lets_go`` after the step. To release the projectile, set
        ``flies`` to True and remove the sling's cable from the generators of the world. This can
        happen only once.
        """
        self.world.step(duration)
        if not self.flies and self.lets_go():
            self.flies = True
            self.world.contact_generators.remove(self.sling)

    def throw(self) -> Throw:
        """Simulate the throw, and return the result as a ``Throw``.

        Call ``step`` with ``STEP`` until the sling releases the projectile. From then on the
        projectile flies without drag until it reaches the ground, which is at a height of 0. The
        throw fails if the projectile reaches the ground while it is still in the sling, or if it
        has not been released within ``TIME_LIMIT``. In that case return Throw(0.0, 0.0). Call this
        method only on a new trebuchet, because a trebuchet can throw only once. Project 8.2a.
        """
        raise NotImplementedError("Exercise P8.2a: A trebuchet")
