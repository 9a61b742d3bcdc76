"""A range on which shots of several types are fired (book 4.1).

Z points down the range, Y up and X to the left of one who looks along Z. Every shot starts at
MUZZLE. Angles are in radians.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
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
    """A kind of shot: mass in kg, velocity in m/s, acceleration in m/s^2, damping per second."""

    name: str
    mass: float
    velocity: Numbers
    acceleration: Numbers
    damping: float


# The book's four, and a grenade of ours. Their accelerations are what suits a game, such as that of
# the fireball, which floats upwards; the book's text has it at 5 m/s, its listing at 10 (E-34).
_TYPES = (
    ShotType("pistol", 2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    ShotType("artillery", 200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    ShotType("fireball", 1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    ShotType("laser", 0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    ShotType("grenade", 0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
)
SHOT_TYPES = {type.name: type for type in _TYPES}


class Shot:
    """A particle in flight: the name of its ``type``, its ``particle`` and its ``age`` in s."""

    __slots__ = ("age", "particle", "type")

    def __init__(self, type: str, particle: Particle) -> None:
        self.type = type
        self.particle = particle
        self.age = 0.0


def aim(speed: float, azimuth: float, elevation: float) -> Vector3:
    """Exercise 4.3a: return the velocity of a shot in m/s, as new.

    Azimuth 0 is along Z, and a quarter of a turn is along X; elevation 0 is level, and a quarter of
    a turn is straight up.

    Raises ValueError where the speed is negative or not finite, or an angle is not finite.
    """
    not_negative("speed", speed)
    finite("azimuth", azimuth)
    finite("elevation", elevation)
    level = speed * math.cos(elevation)
    return Vector3(
        level * math.sin(azimuth), speed * math.sin(elevation), level * math.cos(azimuth)
    )


def is_spent(shot: Shot) -> bool:
    """Say whether a shot is to be dropped (4.1.2).

    It is when it is below the ground (y < 0), older than LONGEST_FLIGHT or past END_OF_RANGE in z.
    """
    position = shot.particle.position
    return position.y < 0.0 or shot.age > LONGEST_FLIGHT or position.z > END_OF_RANGE


def grenade_after(shot: Shot) -> list[Shot]:
    """Mini-project 4.1: return what is left of a grenade that has just been moved by a frame.

    First it bounces, where it is below the ground. Once its age has reached FUSE there are left its
    fragments, shots of the type "fragment" and of age 0; before that the grenade itself, or nothing
    where it is spent all the same.
    """
    bounce(shot.particle)
    if shot.age >= FUSE:
        return [Shot("fragment", particle) for particle in fragments(shot.particle)]
    return [] if is_spent(shot) else [shot]


def what_is_left(shot: Shot, start: Vector3, targets: Sequence[TargetBlock]) -> list[Shot]:
    """Return what is left of a shot that a frame has just moved on from ``start``.

    Nothing, where it has hit a target on its way or is spent; of a grenade what grenade_after says.
    """
    if targets and strike_first(start, shot.particle, targets):
        return []
    if shot.type == "grenade":
        return grenade_after(shot)
    return [] if is_spent(shot) else [shot]


class BallisticRange:
    """Shots in flight, in the order in which they were fired, and target blocks to hit."""

    def __init__(self, targets: Iterable[TargetBlock] = ()) -> None:
        self.targets = list(targets)
        self.shots: list[Shot] = []

    def fire(self, name: str, azimuth: float = 0.0, elevation: float | None = None) -> None:
        """Add a shot of a type to the shots (4.1.2), aimed as in mini-project 4.3.

        It starts at MUZZLE with the age 0, and mass, acceleration and damping as in SHOT_TYPES. Its
        speed is the length of the type's velocity. Without an elevation it has the type's own, the
        angle of that velocity above the level.

        Raises ValueError where there is no such type, or an angle is not finite; nothing is fired
        then.
        """
        if name not in SHOT_TYPES:
            raise ValueError(f"name must be one of {', '.join(SHOT_TYPES)}, got {name!r}")
        type = SHOT_TYPES[name]
        vx, vy, vz = type.velocity
        if elevation is None:
            elevation = math.atan2(vy, math.hypot(vx, vz))
        particle = Particle(
            Vector3(*MUZZLE),
            aim(math.hypot(vx, vy, vz), azimuth, elevation),
            Vector3(*type.acceleration),
            mass=type.mass,
            damping=type.damping,
        )
        self.shots.append(Shot(name, particle))

    def update(self, duration: float) -> None:
        """Move everything on by a frame in s, and drop the shots that are spent (4.1.2).

        First the targets move. Then each shot moves and gets older, and what_is_left of it takes
        its place. What that wants to know is where the shot was before it moved: a copy, since
        integrate moves the position itself.

        Raises ValueError where the duration is not positive and finite; nothing has moved then.
        """
        positive("duration", duration)
        for target in self.targets:
            target.particle.integrate(duration)
        flying: list[Shot] = []
        for shot in self.shots:
            start = shot.particle.position.copy()
            shot.particle.integrate(duration)
            shot.age += duration
            flying += what_is_left(shot, start, self.targets)
        self.shots = flying
