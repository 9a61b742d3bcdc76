"""Simulate a bouncing ball, and record its height over time.

Gravity is 10 m/s^2, downward. Lengths are in m, and times are in s.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from scenes.readings import numbers
from scenes.resolving import Resolve, by_resolver, resolving
from scenes.track import Track, track

GRAVITY = 10.0
RADIUS = 0.5


def without_rule(contacts: list[Contact], duration: float) -> None:
    """Resolve contacts without the special rule for resting contacts.

    This rule keeps the restitution from being applied to the velocity that gravity adds in a time
    step. A plot shows what happens without it.
    """
    del duration
    for contact in contacts:
        contact.resolve_velocity()
        contact.resolve_penetration()


def no_bounce_below(speed: float) -> Resolve:
    """Build a function that resolves contacts without a bounce if they close slower than ``speed``.

    ``speed`` is in m/s. A plot compares this rule with the engine's less strict rule for resting
    contacts.
    """

    def resolve(contacts: list[Contact], duration: float) -> None:
        for contact in contacts:
            if contact.separating_velocity() > -speed:
                contact.restitution = 0.0
            contact.resolve(duration)

    return resolve


def ball(
    step: Integrator,
    height: float,
    restitution: float,
    frames: int,
    resolve: Resolve | None = None,
    generated: bool = False,
) -> Track:
    """Drop a ball, and record its height above the ground over time.

    If ``generated`` is true, a force generator applies gravity. Otherwise gravity is the particle's
    own acceleration. If ``resolve`` is None, a ContactResolver resolves the contacts.
    """
    down = Vector3(0.0, -GRAVITY)
    particle = Particle(Vector3(0.0, height), acceleration=None if generated else down)
    gravity = Gravity(down)

    def apply_forces(duration: float) -> None:
        if generated:
            gravity.update_force(particle, duration)

    ground = GroundPlane([particle], restitution=restitution)
    move = resolving(step, [particle], [ground], resolve or by_resolver(), apply_forces)
    return track(move, lambda: numbers(particle.position)[1], frames)


def ball_by_time_division(height: float, restitution: float, frames: int) -> Track:
    """Drop a ball, simulate it with time_division_step, and record its height over time.

    The function time_division_step stops a time step at each impact. When the ball comes to rest,
    the impacts follow too quickly, and the function raises TooManyImpacts. The recording ends at
    the time that is stored in this exception.
    """
    particle = Particle(Vector3(0.0, height), acceleration=Vector3(0.0, -GRAVITY))
    ground = GroundPlane([particle], restitution=restitution)
    last = []

    def move(duration: float) -> None:
        try:
            time_division_step([particle], ground, duration)
        except TooManyImpacts as error:
            last.append(error.time)
            raise

    run = track(move, lambda: numbers(particle.position)[1], frames)
    if not last:
        return run
    times = [*run.times, run.times[-1] + last[0]]
    return Track(times, [*run.values, numbers(particle.position)[1]], run.message)
