"""Going further: a rope bridge whose planks hang on springs, and a person who walks across."""

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
    """Hang each plank of a bridge from its own spring, and join neighboring planks with springs.

    Each plank hangs from an anchor that is ``height`` m straight above it. All springs have the
    same ``stiffness`` in N/m and ``damping`` in N s/m. Each spring has its current length as its
    rest length, so it exerts no force at the start. Add all springs to ``registry``.
    """
    raise NotImplementedError("Exercise G6.2: Going further: a bridge held up by springs")


def load_bridge(planks: Sequence[Particle], x: float, weight: float) -> None:
    """Add the weight of a person to the planks of a bridge, as forces that act for one step.

    ``x`` is the person's position in m, and ``weight`` is in N. ``planks`` must be in order along
    x. If the person has covered the fraction s of the way from one plank to the next, these two
    carry 1 - s and s of the weight. If the person is before the first plank or beyond the last one,
    the nearest plank carries the whole weight.
    """
    raise NotImplementedError("Exercise G6.2: Going further: a bridge held up by springs")
