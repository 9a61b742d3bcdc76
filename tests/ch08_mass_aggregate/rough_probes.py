"""Balls on planks and contacts with friction, told as numbers, for the checks.

The autograder runs it beside the student, so nothing in here is secret, and nothing decides.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch08_mass_aggregate import friction, planks
from ch08_mass_aggregate.probes import Components, xyz
from ch08_mass_aggregate.scene_probes import Told, told

Body = tuple[float, Components]  # mass, velocity


def touched_planks(
    ball: Components, radius: float, made: Sequence[tuple[Components, Components]], c: float
) -> list[Told]:
    """Return the contacts of a ball with planks.

    Particles are numbered: the ball is 0, and then come the ends of the planks.
    """
    particle = Particle(Vector3(*ball))
    rows = [(Particle(Vector3(*a)), Particle(Vector3(*b))) for a, b in made]
    numbered = [particle, *(end for row in rows for end in row)]
    return told(planks.Planks(particle, radius, rows, c).contacts(), numbered)


def _contact(
    a: Body, b: Body | None, normal: Components, mu: float, c: float = 0.0
) -> tuple[friction.FrictionContact, list[Particle]]:
    bodies = [Particle(velocity=Vector3(*v), mass=m) for m, v in ([a, b] if b else [a])]
    other = bodies[1] if b else None
    return friction.FrictionContact(bodies[0], other, Vector3(*normal), c, 0.0, mu), bodies


def sliding(a: Body, b: Body | None, normal: Components) -> tuple[Components, list[Components]]:
    """Return the sliding velocity of a contact, and what velocities the bodies have then."""
    contact, bodies = _contact(a, b, normal, 0.5)
    found = contact.sliding_velocity()
    seen = xyz(found)
    found.x += 1.0  # a new vector: nothing else may change
    return seen, [xyz(body.velocity) for body in bodies]


def impulse(
    a: Body, b: Body | None, normal: Components, mu: float, j: float
) -> tuple[Components, list[Components]]:
    """Return the friction's impulse for a normal impulse, and what velocities there are then."""
    contact, bodies = _contact(a, b, normal, mu)
    return xyz(contact.friction_impulse(j)), [xyz(body.velocity) for body in bodies]


def bounced(a: Body, b: Body | None, normal: Components, mu: float, c: float) -> list[Components]:
    """Resolve the velocity of a contact, as of an impact; return the velocities."""
    contact, bodies = _contact(a, b, normal, mu, c)
    contact.resolve_velocity()
    return [xyz(body.velocity) for body in bodies]


def slid(
    normal: Components,
    gravity: Components,
    velocity: Components,
    mass: float,
    mu: float,
    steps: int,
    duration: float,
) -> list[tuple[Components, Components]]:
    """Let a particle slide on a plane through the origin.

    Return its position and velocity after each step.
    """
    up = Vector3(*normal)
    particle = Particle(velocity=Vector3(*velocity), acceleration=Vector3(*gravity), mass=mass)
    seen = []
    for _ in range(steps):
        semi_implicit_euler([particle], lambda _: None, duration)
        depth = -math.fsum(p * n for p, n in zip(xyz(particle.position), normal, strict=True))
        if depth >= 0.0:
            contact = friction.FrictionContact(particle, None, up, 0.0, depth, mu)
            contact.resolve(duration)
        seen.append((xyz(particle.position), xyz(particle.velocity)))
    return seen
