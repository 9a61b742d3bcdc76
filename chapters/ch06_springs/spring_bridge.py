"""Going further: a rope bridge that springs hold up (book 6, exercises)."""

from __future__ import annotations

from collections.abc import Sequence

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle


def hang_bridge(
    registry: ForceRegistry,
    planks: Sequence[Particle],
    height: float,
    stiffness: float,
    damping: float,
) -> None:
    """Hang every plank on a spring of its own, and join each to the next one by another.

    The anchors are straight above the planks, as high in m as ``height`` says. All springs are as
    long at rest as they are now, and have the same stiffness in N/m and damping in N s/m.

    Raises ValueError where the height is not positive, stiffness or damping is negative, or one of
    them is not finite; nothing is registered then.
    """
    raise NotImplementedError("Exercise G6.2: Going further: a bridge held up by springs")


def load_bridge(planks: Sequence[Particle], x: float, weight: float) -> None:
    """Add a walker's weight in N to the two planks between which he stands, at x in m.

    The planks are in order along x. Each of the two carries the more the nearer it is, and both
    carry all of the weight. Before the first plank or after the last, that one carries all.

    Raises ValueError where there is no plank, x is not finite, or the weight is negative or not
    finite.
    """
    raise NotImplementedError("Exercise G6.2: Going further: a bridge held up by springs")
