"""Scenes that plots, reference checks and benchmarks share: what moves, where it truly is, models.

A scene is plain numbers in SI units and its exact solution. A model runs a scene in frames of one
length and returns the state at the start and after every frame, as plain numbers too. All scenes
lie in the X-Y plane, so that a two-dimensional engine can run them.
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
    """A position in m and a velocity in m/s."""

    position: Numbers
    velocity: Numbers


@dataclass(frozen=True)
class Scene:
    """A particle under a constant acceleration, with damping as a drag that is linear in v.

    Damping d per second, taken at every instant and not once a frame, is the drag dv/dt = -k v with
    k = -ln d. At d = 1 there is none.
    """

    name: str
    start: State
    acceleration: Numbers
    damping: float
    duration: float

    def exact(self, time: float) -> State:
        """Return the state at a time, from the closed form of dv/dt = a - k v."""
        k = -math.log(self.damping)
        pairs = [
            _fall(x, v, a, k, time)
            for x, v, a in zip(
                self.start.position, self.start.velocity, self.acceleration, strict=True
            )
        ]
        (x, vx), (y, vy), (z, vz) = pairs
        return State((x, y, z), (vx, vy, vz))


Model = Callable[[Scene, float, int], list[State]]


def with_particle(scene: Scene, frame: float, frames: int) -> list[State]:
    """Run a scene with Particle.integrate of the engine at hand."""
    particle = make_particle(scene)
    states = [_state_of(particle)]
    for _ in range(frames):
        particle.integrate(frame)
        states.append(_state_of(particle))
    return states


def with_pymunk(scene: Scene, frame: float, frames: int) -> list[State]:
    """Run a scene with pymunk, which has two dimensions; its z is 0."""
    space, (body,) = make_space(scene)
    states = [State((*body.position, 0.0), (*body.velocity, 0.0))]
    for _ in range(frames):
        space.step(frame)
        states.append(State((*body.position, 0.0), (*body.velocity, 0.0)))
    return states


def make_particle(scene: Scene) -> Particle:
    """Return the particle of a scene at its start."""
    return Particle(
        Vector3(*scene.start.position),
        Vector3(*scene.start.velocity),
        Vector3(*scene.acceleration),
        damping=scene.damping,
    )


def make_space(scene: Scene, bodies: int = 1) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """Return a space of pymunk with as many bodies at the start of a scene."""
    import pymunk  # here, since a plot of one's own engine can do without

    space = pymunk.Space()
    space.gravity, space.damping = scene.acceleration[:2], scene.damping
    made = [pymunk.Body(mass=1.0, moment=1.0) for _ in range(bodies)]
    for body in made:
        body.position, body.velocity = scene.start.position[:2], scene.start.velocity[:2]
    space.add(*made)
    return space, made


def _state_of(particle: Particle) -> State:
    p, v = particle.position, particle.velocity
    return State((p.x, p.y, p.z), (v.x, v.y, v.z))


def _fall(x: float, v: float, a: float, k: float, t: float) -> tuple[float, float]:
    """Return position and velocity on one axis after t seconds of dv/dt = a - k v."""
    kt = k * t
    if abs(kt) < 1e-3:  # t - gone would lose its digits; the next term of the series is 1e-15
        gone = t * (1.0 - kt / 2.0 + kt**2 / 6.0 - kt**3 / 24.0 + kt**4 / 120.0)
        fallen = t * t * (0.5 - kt / 6.0 + kt**2 / 24.0 - kt**3 / 120.0 + kt**4 / 720.0)
    else:
        gone = -math.expm1(-kt) / k  # (1 - e^-kt) / k
        fallen = (t - gone) / k
    return x + v * gone + a * fallen, v - v * k * gone + a * gone


def scene_of(shot: ShotType, duration: float) -> Scene:
    """Return the flight of a shot of chapter 4 as a scene, whose x is along the range."""
    start = State((0.0, 1.5, 0.0), (shot.velocity[2], shot.velocity[1], 0.0))
    return Scene(shot.name, start, shot.acceleration, shot.damping, duration)


AT_REST = State((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
GRAVITY = (0.0, -9.81, 0.0)

FREE_FALL = Scene("free fall", AT_REST, GRAVITY, damping=1.0, duration=5.0)
DAMPED_FALL = Scene("damped fall", AT_REST, GRAVITY, damping=0.5, duration=5.0)
THROWN = State((0.0, 1.5, 0.0), (20.0, 20.0, 0.0))
PROJECTILE = Scene("projectile with damping", THROWN, GRAVITY, damping=0.6, duration=3.2)

SCENES = (FREE_FALL, DAMPED_FALL, PROJECTILE)
MODELS: dict[str, Model] = {"Particle.integrate": with_particle, "pymunk": with_pymunk}
