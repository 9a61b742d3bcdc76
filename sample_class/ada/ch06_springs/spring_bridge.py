"""Going further: a rope bridge that springs hold up."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

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
    up = Vector3(0.0, positive("height", height), 0.0)
    not_negative("stiffness", stiffness)
    not_negative("damping", damping)
    anchors = [plank.position + up for plank in planks]
    hangers = [
        AnchoredSpring(anchor, stiffness, (anchor - plank.position).magnitude(), damping)
        for plank, anchor in zip(planks, anchors, strict=True)
    ]
    gaps = [
        finite("the gap between two planks", (planks[i].position - plank.position).magnitude())
        for i, plank in enumerate(planks[1:])
    ]
    for plank, hanger in zip(planks, hangers, strict=True):
        registry.add(plank, hanger)
    for i, gap in enumerate(gaps):
        connect(registry, planks[i], planks[i + 1], stiffness, gap, damping)


def load_bridge(planks: Sequence[Particle], x: float, weight: float) -> None:
    finite("x", x)
    not_negative("weight", weight)
    if not planks:
        raise ValueError("planks must not be empty")
    places = [plank.position.x for plank in planks]
    after = bisect_right(places, x)  # the first plank beyond him
    if after in (0, len(planks)):
        planks[max(after - 1, 0)].add_force(Vector3(0.0, -weight, 0.0))
        return
    left, right = places[after - 1], places[after]  # left <= x < right
    on_right = weight * ((x - left) / (right - left))
    planks[after - 1].add_force(Vector3(0.0, on_right - weight, 0.0))
    planks[after].add_force(Vector3(0.0, -on_right, 0.0))
