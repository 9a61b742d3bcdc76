"""Struts, the ends of cables and rods, and how far cables are overstretched."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.links import AnchoredCable, Cable, Rod
from scenes.readings import numbers


@dataclass(frozen=True)
class Strut:
    """A link that keeps two particles at least ``min_length`` m apart, like touching balls."""

    a: Particle
    b: Particle
    min_length: float


def ends_of(link: Cable | AnchoredCable | Rod) -> tuple[Vector3, Vector3]:
    """Return the positions of both ends of a cable or a rod."""
    if isinstance(link, AnchoredCable):
        return link.particle.position, link.anchor
    return link.a.position, link.b.position


def over_length(links: Iterable[object]) -> float:
    """Return the excess length of the worst cable in percent, or 0 if no cable is too long."""
    cables = [link for link in links if isinstance(link, Cable | AnchoredCable)]
    ratios = [math.dist(*map(numbers, ends_of(cable))) / cable.max_length for cable in cables]
    return max([0.0, *(100.0 * (ratio - 1.0) for ratio in ratios)])
