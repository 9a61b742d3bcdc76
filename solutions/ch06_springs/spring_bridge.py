"""Going further: a rope bridge whose planks hang on springs, and a person who walks across."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from itertools import pairwise

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring, connect


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
    up = Vector3(0.0, positive("height", height), 0.0)
    not_negative("stiffness", stiffness)
    not_negative("damping", damping)
    for plank in planks:
        hanger = AnchoredSpring(plank.position + up, stiffness, height, damping)
        registry.add(plank, hanger)
    for plank, following in pairwise(planks):
        length = (following.position - plank.position).magnitude()
        connect(registry, plank, following, stiffness, length, damping)


def load_bridge(planks: Sequence[Particle], x: float, weight: float) -> None:
    """Add the weight of a person to the planks of a bridge, as forces that act for one step.

    ``x`` is the person's position in m, and ``weight`` is in N. ``planks`` must be in order along
    x. If the person has covered the fraction s of the way from one plank to the next, these two
    carry 1 - s and s of the weight. If the person is before the first plank or beyond the last one,
    the nearest plank carries the whole weight.
    """
    finite("x", x)
    not_negative("weight", weight)
    places = [plank.position.x for plank in planks]
    x = min(max(x, places[0]), places[-1])
    after = bisect_left(places, x)  # the first plank at x or beyond
    before = max(after - 1, 0)
    gap = places[after] - places[before]
    share = (x - places[before]) / gap if gap else 1.0
    planks[before].add_force(Vector3(0.0, -weight * (1.0 - share), 0.0))
    planks[after].add_force(Vector3(0.0, -weight * share, 0.0))
