"""Turn contacts into plain numbers, and run scenes of many steps.

The autograder runs this file beside the student's code, so nothing in it is secret. It returns
numbers, and the checks compare them with their own.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import combinations, pairwise
from random import Random
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.drops import find_drops, read_drops

Components = tuple[float, float, float]

UP = (0.0, 1.0, 0.0)
Told = tuple[Any, Any, Any, Any, Any]


def xyz(v: Any) -> Components:
    return (v.x, v.y, v.z)


def told(contacts: Iterable[Any], particles: Sequence[Any]) -> list[Told]:
    """Return the indices of particle and other, normal, restitution, penetration of each contact.

    The index is -1 for None, and -2 for a particle that is not in the list.
    """
    return [
        (
            *(number_of(end, particles) for end in (contact.particle, contact.other)),
            *(xyz(contact.normal), contact.restitution, contact.penetration),
        )
        for contact in contacts
    ]


def kind_of(contacts: Any) -> str:
    """Return in words what a contact generator has returned, if it is no list or the like."""
    if contacts is None:
        return "nothing (None)"
    return "" if hasattr(contacts, "__iter__") else "a single Contact"


def number_of(particle: Any, particles: Sequence[Any]) -> int:
    if particle is None:
        return -1
    return next((i for i, other in enumerate(particles) if other is particle), -2)


def moving(particles: Sequence[Any]) -> list[tuple[Components, Components]]:
    """Return the position and velocity of each particle."""
    return [(xyz(particle.position), xyz(particle.velocity)) for particle in particles]


def velocity_first(particle: Particle, duration: float) -> None:
    """Make a semi-implicit Euler step: Particle.integrate, but moved by the new velocity."""
    place = particle.position.copy()
    particle.integrate(duration)
    if particle.inverse_mass:
        place.add_scaled(particle.velocity, duration)
        particle.position = place


def lying(restitution: float, generated: bool) -> tuple[list[float], float]:
    """Let a body lie on the ground for 15 s, and return its heights and its largest speed.

    With ``generated``, gravity is a force that is added by hand in every step. Otherwise it is the
    body's own acceleration.
    """
    down, h = Vector3(0.0, -9.81, 0.0), 1.0 / 60.0
    body = Particle(acceleration=None if generated else down, mass=2.0)
    heights, fastest = [], 0.0
    for _ in range(900):
        if generated:
            body.add_force(down * 2.0)
        velocity_first(body, h)
        if body.position.y <= 0.0:
            Contact(body, None, Vector3(*UP), restitution, -body.position.y).resolve(h)
        heights.append(body.position.y)
        fastest = max(fastest, abs(body.velocity.y))
    return heights, fastest


def resolved(
    bodies: Sequence[tuple[Components, Components, float]],
    contacts: Sequence[Told],
    limit: int,
    velocities: bool,
) -> tuple[int, list[tuple[Components, Components]], list[float]]:
    """Resolve the velocities of contacts, or else their penetrations.

    A body is a position, a velocity and a mass. A contact is given as ``told`` returns it. Return
    the number of resolutions, the positions and velocities, and the penetrations.
    """
    particles = [Particle(Vector3(*p), Vector3(*v), mass=m) for p, v, m in bodies]
    made = [
        Contact(particles[a], None if b < 0 else particles[b], Vector3(*n), c, depth)
        for a, b, n, c, depth in contacts
    ]
    resolver = ContactResolver()
    if velocities:
        used = resolver.resolve_velocities(made, limit, 0.5)
    else:
        used = resolver.resolve_penetrations(made, limit)
    return used, moving(particles), [contact.penetration for contact in made]


def piled(count: int, limit: int | None, steps: int, detect: bool) -> tuple[list[float], float]:
    """Stack spheres with a radius of 0.5 m on the ground, and let them lie there.

    ParticlePairs may ``detect`` the contacts of neighbors. Return the final heights, and the
    largest overlap of two neighbors, or with the ground, after any step.
    """
    down, h, largest = Vector3(0.0, -9.81, 0.0), 1.0 / 60.0, 0.0
    spheres = [Particle(Vector3(0.0, i + 0.5, 0.0), acceleration=down) for i in range(count)]
    resolver = ContactResolver(limit)
    for _ in range(steps):
        for sphere in spheres:
            velocity_first(sphere, h)
        contacts = ParticlePairs(spheres, 0.5).contacts() if detect else []
        for upper, lower in zip(spheres, [None] if detect else [None, *spheres], strict=False):
            depth = 1.0 - (upper.position.y - (lower.position.y if lower else -0.5))
            if depth >= 0.0:
                contacts.append(Contact(upper, lower, Vector3(*UP), 0.0, depth))
        resolver.resolve_contacts(contacts, h)
        places = [-0.5, *(sphere.position.y for sphere in spheres)]
        largest = max(largest, *(1.0 - (b - a) for a, b in pairwise(places)))
    return [sphere.position.y for sphere in spheres], largest


def ground_of_a_list(heights: Sequence[float]) -> list[list[int]]:
    """Return the indices of the particles on the ground: at first, and after two changes."""
    particles = [Particle(Vector3(1.0, y, 2.0)) for y in heights]
    ground = GroundPlane(particles)
    seen = [numbers_of(ground, particles, 1)]
    for particle in particles:
        particle.position.y = -1.0
    particles[1].mass = math.inf
    particles.append(Particle(Vector3(0.0, -1.0, 0.0)))
    seen.append(numbers_of(ground, particles, 1))
    ground.height, ground.radius = -2.0, 0.5
    return [*seen, numbers_of(ground, particles, 1)]


def pairs_of_a_list(radius: float) -> list[list[int]]:
    """Return the touching pairs of four particles in a row: at first, and after two changes."""
    particles = [Particle(Vector3(3.0 * radius * i)) for i in range(4)]
    pairs = ParticlePairs(particles, radius)
    seen = [numbers_of(pairs, particles, 2)]
    particles[3].position = Vector3(-1.5 * radius)
    particles.append(Particle(Vector3(4.5 * radius)))
    seen.append(numbers_of(pairs, particles, 2))
    pairs.radius = 2.0 * radius
    return [*seen, numbers_of(pairs, particles, 2)]


def looked(count: int, size: float) -> tuple[int, int, int]:
    """Find pairs among spheres of radius 0.5 m in a cube, and count accesses to their positions.

    Return that count, the number of contacts that were found, and the number of touching pairs.
    """
    rng, asked = Random(1), [0]
    places = [tuple(rng.uniform(0.0, size) for _ in range(3)) for _ in range(count)]

    class Counting(Vector3):
        def __getattribute__(self, name: str) -> Any:
            asked[0] += 1
            return super().__getattribute__(name)

    particles = [Particle() for _ in places]
    for particle, place in zip(particles, places, strict=True):
        object.__setattr__(particle, "position", Counting(*place))  # no copy
    asked[0] = 0
    found = len([*ParticlePairs(particles, 0.5).contacts()])
    counted = asked[0]
    return counted, found, sum(math.dist(p, q) <= 1.0 for p, q in combinations(places, 2))


def numbers_of(detector: Any, particles: Sequence[Particle], ends: int) -> list[int]:
    """Return the indices of the particles, or of both ends, of the detector's contacts."""
    return [end for contact in told(detector.contacts(), particles) for end in contact[:ends]]


def swung(
    link: Any, bob: Particle, duration: float, frames: int
) -> list[tuple[Components, Components, float]]:
    """Let a bob swing on a link; return its position, velocity and pull in N after each step.

    The pull is the change of momentum by the contacts of a step, divided by its duration.
    """
    seen = []
    for _ in range(frames):
        velocity_first(bob, duration)
        before = bob.velocity.copy()
        for contact in link.contacts():
            contact.resolve(duration)
        pull = (bob.velocity - before).magnitude() * bob.mass / duration
        seen.append((xyz(bob.position), xyz(bob.velocity), pull))
    return seen


def entered_drops() -> list[tuple[str, float, float]]:
    """Return the drops in the student's drops.csv."""
    return read_drops(find_drops())
