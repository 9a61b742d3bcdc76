"""Shots of several kinds on a range: Z leads down it, Y up, X to the left. Angles in radians."""

from __future__ import annotations

import cmath
from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import grenade
from ch04_particle_engine.targets import TargetBlock, strike_first

Numbers = tuple[float, float, float]

MUZZLE = (0.0, 1.5, 0.0)  # m
LONGEST_FLIGHT = 5.0  # s
END_OF_RANGE = 200.0  # m


@dataclass(frozen=True)
class ShotType:
    """What all shots of one kind have in common, in SI units."""

    name: str
    mass: float
    velocity: Numbers
    acceleration: Numbers
    damping: float


SHOT_TYPES = {
    "pistol": ShotType("pistol", 2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    "artillery": ShotType("artillery", 200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    "fireball": ShotType("fireball", 1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    "laser": ShotType("laser", 0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    "grenade": ShotType("grenade", 0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
}


class Shot:
    """One shot in the air: its kind, its particle, and for how many seconds it has flown."""

    def __init__(self, type: str, particle: Particle) -> None:
        self.type, self.particle, self.age = type, particle, 0.0

    def move(self, duration: float) -> Vector3:
        """Fly on for a frame, and return the place that was left."""
        origin = self.particle.position.copy()
        self.particle.integrate(duration)
        self.age += duration
        return origin


def aim(speed: float, azimuth: float, elevation: float) -> Vector3:
    steep = cmath.rect(not_negative("speed", speed), finite("elevation", elevation))
    level = cmath.rect(1.0, finite("azimuth", azimuth)) * steep.real
    return Vector3(level.imag, steep.imag, level.real)


def is_spent(shot: Shot) -> bool:
    _, height, distance = shot.particle.position
    return height < 0 or distance > END_OF_RANGE or shot.age > LONGEST_FLIGHT


def grenade_after(shot: Shot) -> list[Shot]:
    grenade.bounce(shot.particle)
    if shot.age >= grenade.FUSE:
        return [Shot("fragment", piece) for piece in grenade.fragments(shot.particle)]
    return [] if is_spent(shot) else [shot]


class BallisticRange:
    """A queue of shots, the first fired in front, and the blocks they are fired at."""

    def __init__(self, targets: Iterable[TargetBlock] = ()) -> None:
        self.targets = [*targets]
        self._flying: deque[Shot] = deque()

    @property
    def shots(self) -> list[Shot]:
        """What flies now, in the order of firing."""
        return list(self._flying)

    def fire(self, name: str, azimuth: float = 0.0, elevation: float | None = None) -> None:
        try:
            kind = SHOT_TYPES[name]
        except KeyError:
            raise ValueError(f"no shot is called {name!r}; try {[*SHOT_TYPES]}") from None
        x, y, z = kind.velocity
        speed, own_elevation = cmath.polar(complex(abs(complex(x, z)), y))
        velocity = aim(speed, azimuth, own_elevation if elevation is None else elevation)
        body = Particle(
            Vector3(*MUZZLE),
            velocity,
            Vector3(*kind.acceleration),
            mass=kind.mass,
            damping=kind.damping,
        )
        self._flying.append(Shot(name, body))

    def update(self, duration: float) -> None:
        seconds = positive("duration", duration)
        for target in self.targets:
            target.particle.integrate(seconds)
        remains = [self._after(shot, seconds) for shot in self._flying]
        self._flying = deque(chain.from_iterable(remains))

    def _after(self, shot: Shot, seconds: float) -> Iterable[Shot]:
        """What a frame makes of one shot: itself, nothing, or several others."""
        origin = shot.move(seconds)
        if strike_first(origin, shot.particle, self.targets):
            return ()
        if shot.type == "grenade":
            return grenade_after(shot)
        return _unless_spent(shot)


def _unless_spent(shot: Shot) -> Iterator[Shot]:
    if not is_spent(shot):
        yield shot
