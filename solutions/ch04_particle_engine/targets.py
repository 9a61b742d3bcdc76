"""Target blocks for the ballistic range (mini-project 4.3), and how a shot hits one.

A shot moves more than half a metre in a frame, so asking at the end of each frame whether it is
inside a block lets it pass through a thin one. The way it went in the frame is asked instead.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


class TargetBlock:
    """A box with its sides along the axes, which stands on the ground or on a post and can slide.

    ``particle`` is at the middle of the box; a mass of math.inf makes a block that nothing moves.
    ``size`` are the lengths of the sides along X, Y and Z in m. ``damping`` stands for friction.
    ``hits`` counts the shots that have hit it.

    Raises ValueError where a side, the mass or the damping means nothing.
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
    """Exercise 4.3b: return where the straight way from start to end first touches a block.

    0 is the start and 1 the end, so 0.25 is a quarter of the way. A way that starts inside gives 0,
    touching counts, and a way that misses gives None. Positions in m, with finite components.

    >>> wall = TargetBlock(Vector3(0, 1, 30), (4, 2, 0.5), mass=100)
    >>> hit_fraction(Vector3(0, 1, 29.5), Vector3(0, 1, 30.5), wall)
    0.25
    >>> hit_fraction(Vector3(0, 3, 29.5), Vector3(0, 3, 30.5), wall) is None
    True
    """
    enters, leaves = 0.0, 1.0
    middle = block.particle.position
    for begin, finish, center, side in zip(start, end, middle, block.size, strict=True):
        # The box between two planes across this axis, as seen from the start.
        low, high = center - side / 2.0 - begin, center + side / 2.0 - begin
        step = finish - begin
        if step == 0.0:  # along the planes: between them all the way, or never
            if low > 0.0 or high < 0.0:
                return None
            continue
        near, far = min(low / step, high / step), max(low / step, high / step)
        enters, leaves = max(enters, near), min(leaves, far)
    return enters if enters <= leaves else None


def strike_first(
    start: Vector3, particle: Particle, targets: Sequence[TargetBlock]
) -> TargetBlock | None:
    """Exercise 4.3c: let a shot hit the first target on its way, and return that; None for none.

    The shot went from ``start`` to where ``particle`` is. The target gets the momentum that the
    particle has now, along X and Z (the ground takes what is along Y), and counts the hit. Of two
    targets that are touched at once the earlier in the list is hit.
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
