"""Compare the speed of Vector3 with the vectors of pyglet, NumPy and pymunk."""

from __future__ import annotations

from rich.console import Console

from scenes.timing import Measurement, Statements, Target, against_peers


def lines(console: Console) -> list[Measurement]:
    """Set up one benchmark per library that compares its vectors with Vector3.

    The result is the library's time divided by ours, averaged over all operations that Vector3 and
    the library both offer. If a library is not installed, its benchmark is skipped, and a message
    on ``console`` shows how to install it.
    """
    peers = (
        ("pyglet", "pyglet Vec3", Target("at least", 2.4)),
        ("numpy", "NumPy array", Target("at least", 4.5)),
        ("pymunk", "pymunk Vec2d (two components)", None),
    )
    return against_peers(console, "Vector3", STATEMENTS, peers)


STATEMENTS: Statements = {
    "ours": {
        "setup": "from ch02_vectors.vector import Vector3 as V\n"
        "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)",
        "create": "V(1.5, 2.5, 3.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "a.cross(b)",
        "magnitude": "a.magnitude()",
        "normalize": "a.normalized()",
        "add_scaled": "c.add_scaled(b, 0.001)",
    },
    "pyglet": {
        "setup": "from pyglet.math import Vec3 as V\n"
        "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)",
        "create": "V(1.5, 2.5, 3.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "a.cross(b)",
        "magnitude": "a.length()",
        "normalize": "a.normalize()",
        "add_scaled": "c = c + b * 0.001",
    },
    "numpy": {
        "setup": "import numpy as n\n"
        "a, b, c = n.array([1.5, 2.5, 3.5]), n.array([0.5, -1.5, 2.0]), n.array([1.0, 1.0, 1.0])",
        "create": "n.array([1.5, 2.5, 3.5])",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "cross": "n.cross(a, b)",
        "magnitude": "n.linalg.norm(a)",
        "normalize": "a / n.linalg.norm(a)",
        "add_scaled": "c += b * 0.001",
    },
    "pymunk": {
        "setup": "from pymunk import Vec2d as V\na, b, c = V(1.5, 2.5), V(0.5, -1.5), V(1.0, 1.0)",
        "create": "V(1.5, 2.5)",
        "add": "a + b",
        "scale": "a * 1.5",
        "dot": "a.dot(b)",
        "magnitude": "a.length",
        "normalize": "a.normalized()",
        "add_scaled": "c = c + b * 0.001",
    },
}
