"""Spheres of one size that rest on one another, or fall, with a gravity of 10 m/s^2."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import ContactGenerator
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from scenes.setup import Setup

RADIUS, DIAMETER = 0.5, 1.0  # m
GRAVITY = 10.0  # m/s^2
Centers = Sequence[tuple[float, float]]


def stack(count: int, top: float = 1.0, gravity: float = GRAVITY) -> Setup:
    """Create a stack of touching spheres of 1 kg on the ground, with ``top`` kg for the top one."""
    spheres = at([(0.0, (i + 0.5) * DIAMETER) for i in range(count)], gravity)
    spheres[-1].mass = top
    return Setup(spheres, contacts=touching(spheres))


def overlap(heights: Iterable[float]) -> float:
    """Compute a stack's largest overlap from its heights in m, in diameters, or less than 0."""
    return max(1.0 - (high - low) / DIAMETER for low, high in pairwise([-RADIUS, *heights]))


def pyramid(rows: int, size: float = DIAMETER) -> Centers:
    """List the centers of a flat pyramid, row by row, with neighbors ``size`` m apart."""
    return [
        ((i + 0.5 * row) * size, row * size * 0.75**0.5)
        for row in range(rows)
        for i in range(rows - row)
    ]


def at(centers: Centers, gravity: float = GRAVITY) -> list[Particle]:
    """Create spheres of 1 kg at rest."""
    down = Vector3(0.0, -gravity)
    return [Particle(Vector3(x, y), acceleration=down) for x, y in centers]


def touching(spheres: list[Particle]) -> list[ContactGenerator]:
    """Create the detectors of all contacts, with the ground and between spheres."""
    return [GroundPlane(spheres, radius=RADIUS), ParticlePairs(spheres, RADIUS)]
