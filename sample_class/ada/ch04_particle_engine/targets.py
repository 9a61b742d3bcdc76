"""Boxes to shoot at. What counts is the whole way of a shot in a frame, and not only its end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


class TargetBlock:
    """A box along the axes about its ``particle``, of a ``size`` in m, with a count of ``hits``."""

    def __init__(
        self,
        position: Vector3,
        size: tuple[float, float, float],
        mass: float,
        damping: float = 0.2,
    ) -> None:
        width, height, depth = (positive("size", side) for side in size)
        self.size = (width, height, depth)
        self.particle = Particle(position, mass=mass, damping=damping)
        self.hits = 0


def hit_fraction(start: Vector3, end: Vector3, block: TargetBlock) -> float | None:
    first, last = 0.0, 1.0
    for before, after in _distances(start, end, block):
        if before <= 0 and after <= 0:
            continue  # behind this face all the way
        if before > 0 and after <= 0:
            first = max(first, before / (before - after))
        elif before <= 0 and after > 0:
            last = min(last, before / (before - after))
        else:
            return None  # in front of this face all the way, or nowhere at all
    return first if first <= last else None


def strike_first(
    start: Vector3, particle: Particle, targets: Sequence[TargetBlock]
) -> TargetBlock | None:
    meetings = {
        number: fraction
        for number, block in enumerate(targets)
        if (fraction := hit_fraction(start, particle.position, block)) is not None
    }
    if not meetings:
        return None
    struck = targets[min(meetings, key=meetings.__getitem__)]
    level = Vector3(1.0, 0.0, 1.0) * struck.particle.inverse_mass
    struck.particle.velocity += particle.momentum().component_product(level)
    struck.hits += 1
    return struck


def _distances(start: Vector3, end: Vector3, block: TargetBlock) -> Iterator[tuple[float, float]]:
    """Yield for each of the six faces how far in front of it, in m, the way starts and ends."""
    for a, b, middle, side in zip(start, end, block.particle.position, block.size, strict=True):
        low, high = middle - side / 2, middle + side / 2
        yield low - a, low - b
        yield a - high, b - high
