"""Ada's bridge."""

from itertools import pairwise

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch06_springs.springs import AnchoredSpring, connect


def hang_bridge(registry, planks, height, stiffness, damping):
    positive("height", height)
    not_negative("stiffness", stiffness)
    not_negative("damping", damping)
    anchors = [plank.position + Vector3(0, height, 0) for plank in planks]
    for plank, anchor in zip(planks, anchors):
        registry.add(plank, AnchoredSpring(anchor, stiffness, height, damping))
    for a, b in pairwise(planks):
        connect(registry, a, b, stiffness, (a.position - b.position).magnitude(), damping)


def load_bridge(planks, x, weight):
    if not planks:
        raise ValueError("a bridge without planks carries nobody")
    finite("x", x)
    not_negative("weight", weight)
    down = Vector3(0, -weight, 0)
    if x <= planks[0].position.x:
        planks[0].add_force(down)
        return
    for a, b in pairwise(planks):
        if x <= b.position.x:
            s = (x - a.position.x) / (b.position.x - a.position.x)
            a.add_force(down * (1 - s))
            b.add_force(down * s)
            return
    planks[-1].add_force(down)
