"""Simulate a stack and a pile of spheres, to measure how far they sink and overlap.

Gravity is 10 m/s^2, downward. Lengths are in m, and times are in s.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import DEPTH_TOLERANCE, VELOCITY_TOLERANCE, Contact, ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from scenes.clock import FRAME
from scenes.constraints import GRAVITY, RADIUS
from scenes.readings import numbers
from scenes.resolving import by_resolver, resolving
from scenes.track import Track, track


def stack(count: int, iterations: int | None, frames: int) -> tuple[Track, Track]:
    """Simulate a stack of spheres, and record its height and the overlap of the spheres over time.

    The spheres just touch at the start, and their restitution is 0. The height is measured at the
    center of the top sphere. The second value is the largest overlap between two spheres, or
    between a sphere and the ground. It is a fraction of the diameter.
    """
    spheres = [
        Particle(Vector3(0.0, (2 * i + 1) * RADIUS), acceleration=Vector3(0.0, -GRAVITY))
        for i in range(count)
    ]
    detector = Detectors(GroundPlane(spheres, radius=RADIUS), ParticlePairs(spheres, RADIUS))
    move = resolving(semi_implicit_euler, spheres, [detector], by_resolver(iterations))
    overlaps = []

    def measure() -> float:
        places = [-RADIUS, *(numbers(sphere.position)[1] for sphere in spheres)]
        overlaps.append(max(1.0 - (high - low) / (2.0 * RADIUS) for low, high in pairwise(places)))
        return max(places)

    run = track(move, measure, frames)
    return run, Track(run.times, overlaps[: len(run.times)], run.message)


def pile(rows: int, overlap: float, speed: float) -> tuple[list[Particle], list[Contact]]:
    """Create a pyramid of spheres that fall to the ground, and find their contacts.

    The pyramid is flat and has ``rows`` rows. There are ``rows`` spheres in the bottom row, and one
    fewer in each row above. Neighbors overlap by a fraction ``overlap`` of the diameter. All
    spheres fall at the same speed, in m/s.
    """
    size = 2.0 * RADIUS * (1.0 - overlap)
    spheres = [
        Particle(
            Vector3((i + 0.5 * row) * size, RADIUS * (1.0 - overlap) + row * size * 0.75**0.5),
            Vector3(0.0, -speed),
        )
        for row in range(rows)
        for i in range(rows - row)
    ]
    detector = Detectors(GroundPlane(spheres, radius=RADIUS), ParticlePairs(spheres, RADIUS))
    return spheres, detector.contacts()


def residuals(iterations: int, in_order: bool, rows: int = 4) -> tuple[float, float]:
    """Resolve a pile's contacts in ``iterations`` iterations, and measure the remaining errors.

    If ``in_order`` is true, the contacts are resolved in list order, in repeated passes. Contacts
    that need no resolution are skipped. Otherwise a ContactResolver always resolves the worst
    contact first.

    Returns:
        The largest closing velocity in m/s, and the largest depth in m at the final positions.
    """
    spheres, contacts = pile(rows, 0.01, 1.0)
    if iterations and in_order:
        _sweep(contacts, iterations, _closes, lambda contact: contact.resolve_velocity(FRAME))
        _sweep(contacts, iterations, _is_deep, _resolve_depth)
    elif iterations:
        ContactResolver(iterations).resolve_contacts(contacts, FRAME)
    closing = max((-contact.separating_velocity() for contact in contacts), default=math.nan)
    places = [numbers(sphere.position) for sphere in spheres]
    # Use positions only, because the contacts' own depths may be outdated (E-8).
    depths = [RADIUS - place[1] for place in places]
    depths += [2 * RADIUS - math.dist(a, b) for i, a in enumerate(places) for b in places[:i]]
    return max(closing, 0.0), max(0.0, *depths)


def _sweep(
    contacts: list[Contact],
    limit: int,
    wants: Callable[[Contact], bool],
    resolve: Callable[[Contact], object],
) -> None:
    """Make repeated passes over the contacts in list order, and resolve those that need it.

    A contact needs to be resolved if ``wants`` returns True. The passes end after ``limit`` calls
    of ``resolve``, or earlier if no contact needs to be resolved.
    """
    used = 0
    while True:
        before = used
        for contact in contacts:
            if used < limit and wants(contact):
                resolve(contact)
                used += 1
        if used in (before, limit):
            return


def _depth(contact: Contact) -> float:
    """Compute how far a sphere overlaps another sphere or the ground at its current position."""
    place = contact.particle.position
    if contact.other is None:
        return RADIUS - place.y
    return 2.0 * RADIUS - (place - contact.other.position).dot(contact.normal)


def _closes(contact: Contact) -> bool:
    return contact.separating_velocity() < -VELOCITY_TOLERANCE


def _is_deep(contact: Contact) -> bool:
    return _depth(contact) > DEPTH_TOLERANCE


def _resolve_depth(contact: Contact) -> None:
    contact.penetration = _depth(contact)
    contact.resolve_penetration()
