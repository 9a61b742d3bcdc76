"""Target blocks for the shooting range (mini-project 4.3), and a test of whether a shot hits them.

The test uses the whole path during a time step, so no fast shot jumps over a thin block.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


class TargetBlock:
    """A box that slides when a shot hits it, unless its mass is ``math.inf``.

    ``size`` contains the positive lengths in m of its sides along X, Y and Z, and the position of
    ``particle`` is its center. ``damping`` imitates friction. ``hits`` counts the hits.
    """

    def __init__(
        self,
        position: Vector3,
        size: tuple[float, float, float],
        mass: float,
        damping: float = 0.2,
    ) -> None:
        self.particle = Particle(position, mass=mass, damping=damping)
        x, y, z = size
        self.size = (positive("size", x), positive("size", y), positive("size", z))
        self.hits = 0


def hit_fraction(start: Vector3, end: Vector3, block: TargetBlock) -> float | None:
    """Find where the straight path of a shot, from ``start`` to ``end``, first hits a target block.

    The result is the fraction of the path that the shot has covered when it hits the block. If the
    path already starts inside the block, the result is 0. A path that only touches the block counts
    as a hit, and a path that misses it gives None. The function changes none of its arguments.

    >>> wall = TargetBlock(Vector3(0, 1, 30), (4, 2, 0.5), mass=100)
    >>> hit_fraction(Vector3(0, 1, 29.5), Vector3(0, 1, 30.5), wall)
    0.25
    """
    enters, leaves = 0.0, 1.0
    middle = block.particle.position
    for begin, finish, center, side in zip(start, end, middle, block.size, strict=True):
        # The two planes of the box across this axis, relative to the start.
        low, high = center - side / 2.0 - begin, center + side / 2.0 - begin
        step = finish - begin
        if step == 0.0:  # parallel to the planes: between them all the time, or never
            if low > 0.0 or high < 0.0:
                return None
            continue
        near, far = min(low / step, high / step), max(low / step, high / step)
        enters, leaves = max(enters, near), min(leaves, far)
    return enters if enters <= leaves else None


def strike_first(
    start: Vector3, particle: Particle, targets: Sequence[TargetBlock]
) -> TargetBlock | None:
    """Let a shot hit the first target on its path, and return that target.

    In this time step the shot has moved from ``start`` to the position of ``particle``. The target
    receives the momentum of the particle along X and Z, and the rest goes into the ground. Add 1 to
    its ``hits``. If the shot reaches two targets at the same time, it hits the one that comes first
    in the list. Return None if the shot misses every target.
    """
    first, earliest = None, math.inf
    for target in targets:
        fraction = hit_fraction(start, particle.position, target)
        if fraction is not None and fraction < earliest:
            first, earliest = target, fraction
    if first is not None:
        gain = particle.momentum() * first.particle.inverse_mass
        gain.y = 0.0
        first.particle.velocity += gain
        first.hits += 1
    return first
