"""A shooting range on which shots of several types fly and hit targets (book 4.1).

Every shot starts at ``MUZZLE``. The Z axis points from there down the range, Y points up, and X
points to the left of an observer who faces along Z. Angles are in radians.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.targets import TargetBlock

Numbers = tuple[float, float, float]

MUZZLE = (0.0, 1.5, 0.0)  # m
LONGEST_FLIGHT = 5.0  # s
END_OF_RANGE = 200.0  # m along Z, as in the book's listing; its text says 100 (E-34)


@dataclass(frozen=True)
class ShotType:
    """A type of ammunition, such as "pistol" or "laser", with the properties that its shots share.

    The mass is in kg, the velocity in m/s and the acceleration in m/s^2. The damping is the
    fraction of its velocity that a shot keeps per second.
    """

    name: str
    mass: float
    velocity: Numbers
    acceleration: Numbers
    damping: float


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
    """A bullet, grenade or other shot that is in flight.

    ``type`` is the name of its ammunition, such as "pistol". ``particle`` holds the position and
    velocity of the shot, and ``age`` is the time in s since it was fired.
    """

    __slots__ = ("age", "particle", "type")

    def __init__(self, type: str, particle: Particle) -> None:
        self.type = type
        self.particle = particle
        self.age = 0.0


def aim(speed: float, azimuth: float, elevation: float) -> Vector3:
    """Compute the velocity of a shot from its speed and the two angles at which it is fired.

    The result is a new vector in m/s. ``azimuth`` is the horizontal angle from Z toward X, so a
    shot flies along Z at an azimuth of 0, and along X at a quarter turn. ``elevation`` is the angle
    above the horizontal, so a shot with an elevation of a quarter turn flies straight up.

    Exercise 4.3a.
    """
    raise NotImplementedError("Exercise 4.3a: Aiming")


def is_spent(shot: Shot) -> bool:
    """Return True if a shot must be removed, because it has left the range or flown for too long.

    A shot is spent if it is below the ground (y < 0), older than ``LONGEST_FLIGHT``, or beyond
    ``END_OF_RANGE`` in z. If spent shots were never removed, the range would have to simulate more
    and more of them. Book 4.1.2.
    """
    raise NotImplementedError("Exercise B4.3: Shots in flight")


def grenade_after(shot: Shot) -> list[Shot]:
    """Let a grenade bounce or burst, and return the shots that are in flight afterward.

    Call this function after the grenade has moved by one time step. If the grenade is now below the
    ground, let it bounce first. Then check its fuse. If the age of the grenade has reached
    ``FUSE``, it bursts, so return its fragments as shots of the type "fragment" with an age of 0.
    Otherwise return a list that contains only the grenade, or an empty list if ``is_spent`` is True
    for it. Mini-project 4.1.
    """
    raise NotImplementedError("Exercise 4.1: A grenade")


class BallisticRange:
    """A shooting range on which you can fire shots at target blocks.

    ``targets`` are the blocks, and ``shots`` are the shots in flight, oldest first.
    """

    def __init__(self, targets: Iterable[TargetBlock] = ()) -> None:
        self.targets = list(targets)
        self.shots: list[Shot] = []

    def fire(self, name: str, azimuth: float = 0.0, elevation: float | None = None) -> None:
        """Fire a shot of the type ``name``, such as "pistol" or "artillery".

        The shot starts at ``MUZZLE`` with an age of 0, and flies in the direction of the two
        angles. Everything else comes from ``SHOT_TYPES``: its mass, acceleration and damping, and
        also its speed, which is the length of the type's velocity. If ``elevation`` is None, use
        the angle of that velocity above the horizontal.

        Mini-project 4.3, book 4.1.2.
        """
        raise NotImplementedError("Exercise B4.2: Fire a shot")

    def update(self, duration: float) -> None:
        """Advance the targets and the shots by one time step, and remove shots that are spent.

        ``duration`` is in s. First the targets move. Then each shot moves, and its age increases by
        the duration. Move each particle with one call of ``integrate``. In exercise B4.3, remove
        every shot that is spent now. You add two more rules in later exercises:

        - In exercise 4.1, replace each grenade by the shots that ``grenade_after`` returns.
        - In exercise 4.3c, call ``strike_first`` with the path of each shot before anything else,
          and remove a shot that has hit a target. Pass a copy of the position that the shot had
          before its move, because ``integrate`` changes the vector itself.

        Book 4.1.2.
        """
        raise NotImplementedError("Exercise B4.3: Shots in flight")
