"""Frames by time division; the autograder runs it beside the student's code."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch07_constraints.probes import Components, moving, number_of
from ch07_constraints.time_division import TooManyImpacts, time_division_step

Impacts = list[tuple[int, int, float]]


class Watched:
    """A detector that writes down what it is asked, and what it finds: which two, and when."""

    def __init__(self, detector: Any, particles: Sequence[Any]) -> None:
        self.detector, self.particles = detector, particles
        self.asked: list[float] = []
        self.found: Impacts = []

    def next_impact(self, duration: float) -> Any:
        if len(self.asked) == 5000:  # what has no bound would go on for ever
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
) -> tuple[
    list[list[tuple[Components, Components]]], Impacts, list[float], tuple[int, float] | None
]:
    """Let spheres fly and bounce: on the ground and on each other, each with its restitution.

    Where a restitution is None there is no such detector. Return places and velocities after each
    frame, the impacts that were found, what the detector was asked, and of the error that ended it
    its impacts and time.
    """
    pull = Vector3(*acceleration)
    spheres = [Particle(Vector3(*p), Vector3(*v), pull, mass=m) for p, v, m in bodies]
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
    force: Components, mass: float, damping: float, duration: float
) -> tuple[list[tuple[Components, Components]], Components, Components]:
    """Push a particle, 1 m above ground of restitution 0.5, by a force, for one frame of two.

    Return place and velocity after that frame and after the next one, the force that is left, and
    its last_acceleration after the first.
    """
    particle = Particle(Vector3(0.0, 1.0, 0.0), Vector3(3.0, -4.0, 0.0), mass=mass, damping=damping)
    particle.add_force(Vector3(*force))
    ground = GroundPlane([particle], restitution=0.5)
    time_division_step([particle], ground, duration)
    seen = moving([particle])
    left, last = particle.force_accumulator, particle.last_acceleration
    time_division_step([particle], ground, duration)
    return seen + moving([particle]), (left.x, left.y, left.z), (last.x, last.y, last.z)
