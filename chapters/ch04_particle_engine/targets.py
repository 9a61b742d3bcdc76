"""Target blocks for the shooting range (mini-project 4.3), and a test of whether a shot hits them.

A shot moves more than half a meter in a time step. If you tested only its position at the end of
each step, it could jump over a thin block without hitting it. That is why the test uses the whole
path of the shot during the step.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


class TargetBlock:
    """A box that stands on the ground or on a post, and slides when a shot hits it.

    The sides of the box are parallel to the axes, and ``size`` contains their lengths along X, Y
    and Z in m. ``particle`` holds the mass and velocity of the block, and its position is the
    center of the box. If the mass is ``math.inf``, a shot cannot move the block. ``damping``
    imitates friction and brings the block to rest after a hit. ``hits`` counts the shots that have
    hit it.

    Raises:
        ValueError: if a side or the mass is not positive, or if the damping is negative or not
            finite.
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

    The result is the fraction of the path that the shot has covered when it hits the block. It is 0
    at the start, 0.25 after a quarter of the path, and 1 at the end. If the path already starts
    inside the block, the result is 0. A path that only touches the block counts as a hit, and a
    path that misses it gives None. Positions are in m and have finite components. The function
    changes none of its arguments. Exercise 4.3b.

    >>> wall = TargetBlock(Vector3(0, 1, 30), (4, 2, 0.5), mass=100)
    >>> hit_fraction(Vector3(0, 1, 29.5), Vector3(0, 1, 30.5), wall)
    0.25
    >>> hit_fraction(Vector3(0, 3, 29.5), Vector3(0, 3, 30.5), wall) is None
    True
    """
    raise NotImplementedError("Exercise 4.3b: Does the shot hit the block?")


def strike_first(
    start: Vector3, particle: Particle, targets: Sequence[TargetBlock]
) -> TargetBlock | None:
    """Let a shot hit the first target on its path, and return that target.

    In this time step the shot has moved from ``start`` to the position of ``particle``. If it hits
    a target, the target receives the momentum of the particle along X and Z. The momentum along Y
    goes into the ground. Add 1 to the target's ``hits``. If the shot reaches two targets at the
    same time, it hits the one that comes first in the list. Return None if the shot misses every
    target, or if there are no targets. Exercise 4.3c.
    """
    raise NotImplementedError("Exercise 4.3c: Blocks of several masses")
