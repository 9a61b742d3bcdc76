"""Simulate the flight of a projectile under gravity and drag, with our engine or with pymunk.

Plots, checks and benchmarks use the same flights. Each flight has an exact solution for comparison.
A simulation runs in frames of equal length, and returns the position and velocity at the start and
after every frame.

All values are plain numbers in SI units. The flights lie in the X-Y plane, so that a
two-dimensional engine can simulate them, too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

if TYPE_CHECKING:
    import pymunk

    from ch04_particle_engine.ballistics import ShotType

Numbers = tuple[float, float, float]


@dataclass(frozen=True)
class State:
    """The position in m and the velocity in m/s of a projectile at one moment."""

    position: Numbers
    velocity: Numbers


@dataclass(frozen=True)
class DragFlight:
    """A flight with constant acceleration, and with drag that is proportional to the velocity.

    ``damping`` is the fraction d of the velocity that is left after one second. The exact solution
    treats it as a continuous drag, dv/dt = -k v with k = -ln d. There is no drag if d is 1.
    """

    name: str
    start: State
    acceleration: Numbers
    damping: float
    duration: float

    def exact(self, time: float) -> State:
        """Compute the position and velocity at ``time`` by solving dv/dt = a - k v."""
        k = -math.log(self.damping)
        pairs = [
            _fall(x, v, a, k, time)
            for x, v, a in zip(
                self.start.position, self.start.velocity, self.acceleration, strict=True
            )
        ]
        (x, vx), (y, vy), (z, vz) = pairs
        return State((x, y, z), (vx, vy, vz))


def with_particle(flight: DragFlight, frame: float, frames: int) -> list[State]:
    """Simulate a flight frame by frame with the engine's Particle.integrate."""
    particle = make_particle(flight)
    states = [_state_of(particle)]
    for _ in range(frames):
        particle.integrate(frame)
        states.append(_state_of(particle))
    return states


def with_pymunk(flight: DragFlight, frame: float, frames: int) -> list[State]:
    """Simulate a flight with pymunk, for comparison with our engine.

    Pymunk is two-dimensional, so z is always 0.
    """
    space, (body,) = make_space(flight)
    states = [State((*body.position, 0.0), (*body.velocity, 0.0))]
    for _ in range(frames):
        space.step(frame)
        states.append(State((*body.position, 0.0), (*body.velocity, 0.0)))
    return states


def make_particle(flight: DragFlight) -> Particle:
    """Create a particle in the initial state of a flight."""
    return Particle(
        Vector3(*flight.start.position),
        Vector3(*flight.start.velocity),
        Vector3(*flight.acceleration),
        damping=flight.damping,
    )


def make_space(flight: DragFlight, bodies: int = 1) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """Create a pymunk space with one or more bodies in the initial state of a flight."""
    import pymunk  # here, because plots of a student's engine do not need it

    space = pymunk.Space()
    space.gravity, space.damping = flight.acceleration[:2], flight.damping
    made = [pymunk.Body(mass=1.0, moment=1.0) for _ in range(bodies)]
    for body in made:
        body.position, body.velocity = flight.start.position[:2], flight.start.velocity[:2]
    space.add(*made)
    return space, made


def _state_of(particle: Particle) -> State:
    p, v = particle.position, particle.velocity
    return State((p.x, p.y, p.z), (v.x, v.y, v.z))


def _fall(x: float, v: float, a: float, k: float, t: float) -> tuple[float, float]:
    """Compute the position and velocity along one axis after t seconds of dv/dt = a - k v."""
    kt = k * t
    if abs(kt) < 1e-3:  # t - gone would lose digits; the next term of the series is 1e-15
        gone = t * (1.0 - kt / 2.0 + kt**2 / 6.0 - kt**3 / 24.0 + kt**4 / 120.0)
        fallen = t * t * (0.5 - kt / 6.0 + kt**2 / 24.0 - kt**3 / 120.0 + kt**4 / 720.0)
    else:
        gone = -math.expm1(-kt) / k  # (1 - e^-kt) / k
        fallen = (t - gone) / k
    return x + v * gone + a * fallen, v - v * k * gone + a * gone


def flight_of(shot: ShotType, duration: float) -> DragFlight:
    """Convert one of chapter 4's shots to a flight in which x is the direction of fire."""
    start = State((0.0, 1.5, 0.0), (shot.velocity[2], shot.velocity[1], 0.0))
    return DragFlight(shot.name, start, shot.acceleration, shot.damping, duration)


AT_REST = State((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
GRAVITY = (0.0, -9.81, 0.0)

FREE_FALL = DragFlight("free fall", AT_REST, GRAVITY, damping=1.0, duration=5.0)
DAMPED_FALL = DragFlight("damped fall", AT_REST, GRAVITY, damping=0.5, duration=5.0)
THROWN = State((0.0, 1.5, 0.0), (20.0, 20.0, 0.0))
PROJECTILE = DragFlight("projectile with damping", THROWN, GRAVITY, damping=0.6, duration=3.2)

DRAG_FLIGHTS = (FREE_FALL, DAMPED_FALL, PROJECTILE)
MODELS: dict[str, Callable[[DragFlight, float, int], list[State]]] = {
    "Particle.integrate": with_particle,
    "pymunk": with_pymunk,
}
