"""A shooting range on which shots of several types fly and hit targets (book 4.1).

Every shot starts at ``MUZZLE``. The Z axis points from there down the range, Y points up, and X
points to the left of an observer who faces along Z. Angles are in radians.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.grenade import FUSE, bounce, fragments
from ch04_particle_engine.targets import TargetBlock, strike_first

Numbers = tuple[float, float, float]

MUZZLE = (0.0, 1.5, 0.0)  # m
LONGEST_FLIGHT = 5.0  # s
END_OF_RANGE = 200.0  # m along Z, as in the book's listing; its text says 100 (E-34)


@dataclass(frozen=True)
class ShotType:
    """A type of ammunition, such as "pistol", with the properties that its shots share."""

    name: str
    mass: float  # kg
    velocity: Numbers  # m/s
    acceleration: Numbers  # m/s^2
    damping: float  # the fraction of its velocity that a shot keeps per second


# The book's four types, and a grenade of ours. Their accelerations are chosen for a game. The
# fireball, for example, floats upward. A comment in the book says 5 m/s, its code 10 (E-34).
_TYPES = (
    ShotType("pistol", 2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    ShotType("artillery", 200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    ShotType("fireball", 1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    ShotType("laser", 0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    ShotType("grenade", 0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
)
SHOT_TYPES = {type.name: type for type in _TYPES}


class Shot:
    """A shot in flight. ``type`` is a name such as "pistol", and ``age`` is the time in s."""

    __slots__ = ("age", "particle", "type")

    def __init__(self, type: str, particle: Particle) -> None:
        self.type = type
        self.particle = particle
        self.age = 0.0


def aim(speed: float, azimuth: float, elevation: float) -> Vector3:
    """Compute the velocity in m/s of a shot from its speed and the two angles of its direction.

    ``azimuth`` is the horizontal angle from Z toward X, and ``elevation`` is the angle above the
    horizontal. So a shot flies along Z if both are 0, along X at an azimuth of a quarter turn, and
    straight up at an elevation of a quarter turn.
    """
    not_negative("speed", speed)
    finite("azimuth", azimuth)
    finite("elevation", elevation)
    level = speed * math.cos(elevation)
    return Vector3(
        level * math.sin(azimuth), speed * math.sin(elevation), level * math.cos(azimuth)
    )


def is_spent(shot: Shot) -> bool:
    """Return True if a shot must be removed, because it has left the range or flown for too long.

    A shot is spent if it is below the ground (y < 0), older than ``LONGEST_FLIGHT``, or beyond
    ``END_OF_RANGE`` in z.
    """
    position = shot.particle.position
    return position.y < 0.0 or shot.age > LONGEST_FLIGHT or position.z > END_OF_RANGE


def grenade_after(shot: Shot) -> list[Shot]:
    """Let a grenade that has moved bounce or burst, and return the shots in flight afterward.

    If the grenade is now below the ground, let it bounce first. Then check its fuse. If the age of
    the grenade has reached ``FUSE``, return its fragments as shots of the type "fragment" with an
    age of 0. Otherwise return a list of only the grenade, or an empty list if ``is_spent`` is True
    for it.
    """
    bounce(shot.particle)
    if shot.age >= FUSE:
        return [Shot("fragment", particle) for particle in fragments(shot.particle)]
    return [] if is_spent(shot) else [shot]


class BallisticRange:
    """A shooting range with ``targets`` and the ``shots`` in flight, oldest first."""

    def __init__(self, targets: Iterable[TargetBlock] = ()) -> None:
        self.targets = list(targets)
        self.shots: list[Shot] = []

    def fire(self, name: str, azimuth: float = 0.0, elevation: float | None = None) -> None:
        """Fire a shot of the type ``name``, such as "pistol" or "artillery".

        The shot starts at ``MUZZLE`` with an age of 0, and flies in the direction of the two
        angles. Everything else comes from ``SHOT_TYPES``. Its speed is the length of the type's
        velocity. If ``elevation`` is None, use the angle of that velocity above the horizontal.
        """
        type = SHOT_TYPES[name]
        velocity = Vector3(*type.velocity)
        if elevation is None:
            elevation = math.atan2(velocity.y, math.hypot(velocity.x, velocity.z))
        particle = Particle(
            Vector3(*MUZZLE),
            aim(velocity.magnitude(), azimuth, elevation),
            Vector3(*type.acceleration),
            mass=type.mass,
            damping=type.damping,
        )
        self.shots.append(Shot(name, particle))

    def update(self, duration: float) -> None:
        """Advance the range by one time step of ``duration`` s, and remove shots that are spent.

        First the targets move. Then each shot moves, and its age increases by the duration. Move
        each particle with one call of ``integrate``. Then remove every shot that is spent now. You
        add two more rules in later exercises:

        - In exercise 4.1, replace each grenade by the shots that ``grenade_after`` returns.
        - In exercise 4.3c, call ``strike_first`` with the path of each shot before anything else,
          and remove a shot that has hit a target. Pass a copy of the position before the move.
        """
        positive("duration", duration)
        for target in self.targets:
            target.particle.integrate(duration)
        flying: list[Shot] = []
        for shot in self.shots:
            start = shot.particle.position.copy()
            shot.particle.integrate(duration)
            shot.age += duration
            if self.targets and strike_first(start, shot.particle, self.targets):
                continue
            if shot.type == "grenade":
                flying += grenade_after(shot)
            elif not is_spent(shot):
                flying.append(shot)
        self.shots = flying
