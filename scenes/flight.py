"""A flight with constant acceleration and linear drag, in plain numbers in SI units."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from scenes.readings import Numbers, numbers

Kind = TypeVar("Kind", bound=Particle)
GRAVITY = (0.0, -9.81, 0.0)


class State(NamedTuple):
    """The position and the velocity of a body at one moment."""

    position: Numbers
    velocity: Numbers


@dataclass(frozen=True)
class Flight:
    """A flight from a position, with the fraction ``damping`` of the velocity left per second."""

    position: Numbers = (0.0, 0.0, 0.0)
    velocity: Numbers = (0.0, 0.0, 0.0)
    acceleration: Numbers = GRAVITY
    damping: float = 1.0

    def particle(self, kind: type[Kind]) -> Kind:
        """Create the body with the Particle class of chapter 3 or 5."""
        vectors = (Vector3(*v) for v in (self.position, self.velocity, self.acceleration))
        return kind(*vectors, damping=self.damping)

    def exact(self, time: float) -> State:
        """Compute the state at ``time`` by solving dv/dt = a - k v, with k = -ln d."""
        k = -math.log(self.damping)
        kt = k * time
        if abs(kt) < 1e-3:  # time - gone would lose digits; the next term of the series is 1e-15
            gone = time * (1.0 - kt / 2.0 + kt**2 / 6.0 - kt**3 / 24.0 + kt**4 / 120.0)
            fallen = time * time * (0.5 - kt / 6.0 + kt**2 / 24.0 - kt**3 / 120.0 + kt**4 / 720.0)
        else:
            gone = -math.expm1(-kt) / k  # (1 - e^-kt) / k
            fallen = (time - gone) / k
        (x, vx), (y, vy), (z, vz) = (
            (p + v * gone + a * fallen, v - v * k * gone + a * gone)
            for p, v, a in zip(self.position, self.velocity, self.acceleration, strict=True)
        )
        return State((x, y, z), (vx, vy, vz))


def thrown(place: tuple[float, float], speed: float, angle: float, damping: float) -> Flight:
    """Return a throw in the X-Y plane, at an angle in degrees above the horizontal."""
    a = math.radians(angle)
    return Flight((*place, 0.0), (speed * math.cos(a), speed * math.sin(a), 0.0), GRAVITY, damping)


def flown(flight: Flight, frame: float, frames: int) -> list[State]:
    """Simulate a flight with Particle.integrate, and return its states after 0, 1, 2 ... frames."""
    particle = flight.particle(Particle)
    states = [State(numbers(particle.position), numbers(particle.velocity))]
    for _ in range(frames):
        particle.integrate(frame)
        states.append(State(numbers(particle.position), numbers(particle.velocity)))
    return states


FREE_FALL = Flight()
DAMPED_FALL = Flight(damping=0.5)
PROJECTILE = Flight((0.0, 1.5, 0.0), (20.0, 20.0, 0.0), damping=0.6)
FLIGHT_TIME = 3.2  # s, in which the projectile almost comes back to its first height
