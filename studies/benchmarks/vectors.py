"""Compare the speed of Vector3 with the vectors of pyglet, NumPy and pymunk."""

from __future__ import annotations

from rich.console import Console

from scenes.timing import Measurement, Statements, Target, against_peers


def lines(console: Console) -> list[Measurement]:
    """Set up a benchmark per library, and name on ``console`` the ones that are not installed."""
    peers = (
        ("pyglet", "pyglet Vec3", Target("at least", 2.4)),
        ("numpy", "NumPy array", Target("at least", 4.5)),
        ("pymunk", "pymunk Vec2d (two components)", None),
    )
    return against_peers(console, "Vector3", STATEMENTS, peers)


COMMON = {"create": "V(1.5, 2.5, 3.5)", "add": "a + b", "scale": "a * 1.5", "dot": "a.dot(b)"}
OF_THREE = "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)"
STATEMENTS: Statements = {
    "ours": COMMON
    | {
        "setup": f"from ch02_vectors.vector import Vector3 as V\n{OF_THREE}",
        "cross": "a.cross(b)",
        "magnitude": "a.magnitude()",
        "normalize": "a.normalized()",
        "add_scaled": "c.add_scaled(b, 0.001)",
    },
    "pyglet": COMMON
    | {
        "setup": f"from pyglet.math import Vec3 as V\n{OF_THREE}",
        "cross": "a.cross(b)",
        "magnitude": "a.length()",
        "normalize": "a.normalize()",
        "add_scaled": "c = c + b * 0.001",
    },
    "numpy": COMMON
    | {
        "setup": "import numpy as n\n"
        "a, b, c = n.array([1.5, 2.5, 3.5]), n.array([0.5, -1.5, 2.0]), n.array([1.0, 1.0, 1.0])",
        "create": "n.array([1.5, 2.5, 3.5])",
        "cross": "n.cross(a, b)",
        "magnitude": "n.linalg.norm(a)",
        "normalize": "a / n.linalg.norm(a)",
        "add_scaled": "c += b * 0.001",
    },
    "pymunk": COMMON
    | {
        "setup": "from pymunk import Vec2d as V\na, b, c = V(1.5, 2.5), V(0.5, -1.5), V(1.0, 1.0)",
        "create": "V(1.5, 2.5)",
        "magnitude": "a.length",
        "normalize": "a.normalized()",
        "add_scaled": "c = c + b * 0.001",
    },
}
