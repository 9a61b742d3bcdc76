"""Steps by time division. The autograder runs this file beside the student's code."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch07_constraints.probes import Components, moving, number_of, xyz
from ch07_constraints.time_division import TooManyImpacts, time_division_step

Impacts = list[tuple[int, int, float]]


class Watched:
    """A detector that records the durations it gets, and the ends and time of each impact."""

    def __init__(self, detector: Any, particles: Sequence[Any]) -> None:
        self.detector, self.particles = detector, particles
        self.asked: list[float] = []
        self.found: Impacts = []

    def contacts(self) -> Any:
        return self.detector.contacts()

    def next_impact(self, duration: float) -> Any:
        if len(self.asked) == 1400:  # a step without a limit would never end
            return None
        self.asked.append(duration)
        impact = self.detector.next_impact(duration)
        if impact is not None:
            ends = (impact[1].particle, impact[1].other)
            a, b = (number_of(end, self.particles) for end in ends)
            self.found.append((a, b, impact[0]))
        return impact


def flown(
    bodies: Sequence[tuple[Components, Components, float]],
    acceleration: Components,
    radius: float,
    restitutions: tuple[float | None, float | None],
    duration: float,
    frames: int,
    most: int = 1000,
    damping: float = 1.0,
) -> tuple[
    list[list[tuple[Components, Components]]], Impacts, list[float], tuple[int, float] | None
]:
    """Let spheres fly and bounce on the ground and on each other, each with its restitution.

    If a restitution is None, that detector is left out. Return positions and velocities after
    each step, the impacts found, the durations that the detector got, and the impacts and time of
    the error that ended it, or None.
    """
    pull = Vector3(*acceleration)
    spheres = [
        Particle(Vector3(*p), Vector3(*v), pull, mass=m, damping=damping) for p, v, m in bodies
    ]
    ground, pair = restitutions
    detectors: list[Any] = []
    if ground is not None:
        detectors.append(GroundPlane(spheres, 0.0, radius, ground))
    if pair is not None:
        detectors.append(ParticlePairs(spheres, radius, pair))
    watched = Watched(Detectors(*detectors), spheres)
    seen, ended = [], None
    for _ in range(frames):
        try:
            time_division_step(spheres, watched, duration, most)
        except TooManyImpacts as error:
            ended = error.impacts, error.time
        seen.append(moving(spheres))
        if ended:
            break
    return seen, watched.found, watched.asked, ended


def pushed(
    pushes: Sequence[tuple[Components, Components, Components, Components, float]],
    damping: float,
    duration: float,
) -> list[list[Components]]:
    """Make two steps with particles over ground of restitution 0.5; forces act in the first one.

    A push is position, velocity, acceleration, force and mass. Return for each particle its
    position, velocity, last_acceleration and remaining force after the first step, and its
    position and velocity after the second.
    """
    particles = []
    for place, velocity, acceleration, force, mass in pushes:
        vectors = (Vector3(*place), Vector3(*velocity), Vector3(*acceleration))
        particles.append(Particle(*vectors, mass=mass, damping=damping))
        particles[-1].add_force(Vector3(*force))
    ground = GroundPlane(particles, restitution=0.5)
    time_division_step(particles, ground, duration)
    seen = [
        [xyz(p.position), xyz(p.velocity), xyz(p.last_acceleration), xyz(p.force_accumulator)]
        for p in particles
    ]
    time_division_step(particles, ground, duration)
    for numbers, p in zip(seen, particles, strict=True):
        numbers += [xyz(p.position), xyz(p.velocity)]
    return seen
