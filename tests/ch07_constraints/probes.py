"""Objects told as numbers, and scenes of many frames; the autograder runs it beside the student.

Nothing in here is secret, and nothing in here decides: the checks compare the numbers that come
back with their own.
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
    """Return of each contact: particle and other by number, normal, restitution, penetration.

    The number of what is not there is -1, that of a stranger -2.
    """
    found = []
    for contact in contacts:
        ends = (number_of(contact.particle, particles), number_of(contact.other, particles))
        found.append((*ends, xyz(contact.normal), contact.restitution, contact.penetration))
    return found


def number_of(particle: Any, particles: Sequence[Any]) -> int:
    if particle is None:
        return -1
    return next((i for i, other in enumerate(particles) if other is particle), -2)


def moving(particles: Sequence[Any]) -> list[tuple[Components, Components]]:
    """Return place and velocity of each particle."""
    return [(xyz(particle.position), xyz(particle.velocity)) for particle in particles]


def velocity_first(particle: Particle, duration: float) -> None:
    """Step by semi-implicit Euler: what Particle.integrate does, with the new velocity."""
    place = particle.position.copy()
    particle.integrate(duration)
    if particle.inverse_mass:
        place.add_scaled(particle.velocity, duration)
        particle.position = place


def lying(
    restitution: float, generated: bool, frames: int, duration: float
) -> tuple[list[float], float]:
    """Let a body lie on the ground, under 9.81 m/s^2.

    Return its heights after each frame, and the fastest that it was then, up or down. Generated
    gravity is a force, added by hand in every frame; the other one is built in.
    """
    down = Vector3(0.0, -9.81, 0.0)
    body = Particle(acceleration=None if generated else down, mass=2.0)
    heights, fastest = [], 0.0
    for _ in range(frames):
        if generated:
            body.add_force(down * 2.0)
        velocity_first(body, duration)
        if body.position.y <= 0.0:
            Contact(body, None, Vector3(*UP), restitution, -body.position.y).resolve(duration)
        heights.append(body.position.y)
        fastest = max(fastest, abs(body.velocity.y))
    return heights, fastest


def resolved(
    bodies: Sequence[tuple[Components, Components, float]],
    contacts: Sequence[tuple[int, int, Components, float, float]],
    method: str,
    limit: int,
    duration: float = 0.5,
    acceleration: Components = (0.0, 0.0, 0.0),
) -> tuple[int, list[tuple[Components, Components]], list[float]]:
    """Resolve contacts by one of the resolver's methods, or by resolve_contacts with a limit.

    A body is a place, a velocity and a mass, and all have the same acceleration; a contact is told
    as above. Return how many iterations were used, places and velocities of the bodies, and the
    penetrations of the contacts.
    """
    pull = Vector3(*acceleration)
    particles = [Particle(Vector3(*p), Vector3(*v), pull, mass=m) for p, v, m in bodies]
    made = [
        Contact(particles[a], None if b < 0 else particles[b], Vector3(*n), c, depth)
        for a, b, n, c, depth in contacts
    ]
    resolver = ContactResolver(limit if method == "resolve_contacts" and limit else None)
    used: Any
    if method == "resolve_velocities":
        used = resolver.resolve_velocities(made, limit, duration)
    elif method == "resolve_penetrations":
        used = resolver.resolve_penetrations(made, limit)
    else:
        resolver.resolve_contacts(made, duration)
        used = resolver.iterations_used
    return used, moving(particles), [contact.penetration for contact in made]


def stacked(
    count: int, radius: float, iterations: int | None, frames: int, duration: float
) -> tuple[list[float], float]:
    """Stack spheres on the ground, under 9.81 m/s^2, and wait; return what piled returns."""
    down = Vector3(0.0, -9.81, 0.0)
    spheres = [
        Particle(Vector3(0.0, (2 * i + 1) * radius, 0.0), acceleration=down) for i in range(count)
    ]
    pairs = Neighbours(spheres, radius)
    return piled(spheres, pairs, ContactResolver(iterations), frames, duration, radius)


class Neighbours:
    """Detects what each sphere of a stack has below it, another one, without looking elsewhere."""

    def __init__(self, spheres: Sequence[Particle], radius: float) -> None:
        self.spheres, self.radius = spheres, radius

    def contacts(self) -> list[Contact]:
        found = []
        for lower, upper in pairwise(self.spheres):
            depth = 2.0 * self.radius - (upper.position.y - lower.position.y)
            if depth >= 0.0:
                found.append(Contact(upper, lower, Vector3(*UP), 0.0, depth))
        return found


def piled(
    spheres: Sequence[Particle],
    pairs: Any,
    resolver: Any,
    frames: int,
    duration: float,
    radius: float = 0.5,
) -> tuple[list[float], float]:
    """Let spheres lie on each other and on the ground, whose contacts are made here.

    Return their heights in the end, and the largest overlap of two neighbours, or with the ground,
    that was there after a frame.
    """
    largest = 0.0
    for _ in range(frames):
        for sphere in spheres:
            velocity_first(sphere, duration)
        contacts = [
            Contact(sphere, None, Vector3(*UP), 0.0, radius - sphere.position.y)
            for sphere in spheres
            if sphere.position.y <= radius
        ]
        resolver.resolve_contacts([*contacts, *pairs.contacts()], duration)
        places = [-radius, *(sphere.position.y for sphere in spheres)]
        largest = max(largest, *(2.0 * radius - (b - a) for a, b in pairwise(places)))
    return [sphere.position.y for sphere in spheres], largest


def thrown_down(speed: float, duration: float) -> tuple[float, float]:
    """Throw a particle at the ground; return its height after a frame, and that out of contact."""
    particle = Particle(Vector3(0.0, 1.0, 0.0), Vector3(0.0, -speed, 0.0))
    particle.integrate(duration)
    fallen = particle.position.y
    depths = [contact.penetration for contact in GroundPlane([particle]).contacts()]
    return fallen, fallen + sum(depths)


def ground_of_a_list(heights: Sequence[float]) -> list[list[int]]:
    """Return which particles touch the ground: at the heights, and after two changes."""
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
    """Return which of four particles in a row touch: at first, and after two changes."""
    particles = [Particle(Vector3(3.0 * radius * i)) for i in range(4)]
    pairs = ParticlePairs(particles, radius)
    seen = [numbers_of(pairs, particles, 2)]
    particles[3].position = Vector3(-1.5 * radius)
    particles.append(Particle(Vector3(4.5 * radius)))
    seen.append(numbers_of(pairs, particles, 2))
    pairs.radius = 2.0 * radius
    return [*seen, numbers_of(pairs, particles, 2)]


def looked(count: int, size: float) -> tuple[int, int, int]:
    """Find pairs among spheres of radius 0.5 m in a cube; count what is asked of their positions.

    Return that, how many contacts were found, and how many pairs touch.
    """
    rng = Random(1)
    places = [tuple(rng.uniform(0.0, size) for _ in range(3)) for _ in range(count)]
    asked = [0]

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
    """Return the numbers of the particles, or of both ends, of the contacts that it finds."""
    return [end for contact in told(detector.contacts(), particles) for end in contact[:ends]]


def swung(
    link: Any, bob: Particle, duration: float, frames: int
) -> list[tuple[Components, Components, float]]:
    """Let a bob swing on a link; return place, velocity and the pull in N after each frame.

    The pull is what the contacts of the frame have changed of the momentum, in a second.
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
    """Return what the student has entered in drops.csv."""
    return read_drops(find_drops())
