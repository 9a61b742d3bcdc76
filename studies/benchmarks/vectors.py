"""Vector3 against the vectors of other libraries, where they are installed."""

from __future__ import annotations

import importlib.util
import statistics
import timeit

from rich.console import Console

from studies.timing import Line, Timer, ratio


def lines(console: Console) -> list[Line]:
    """How much faster Vector3 is than each peer: the geometric mean over what both can do."""
    ours = STATEMENTS["ours"]
    measured = []
    for peer, title, target in (
        ("pyglet", "pyglet Vec3", "at least 2.4"),
        ("numpy", "NumPy array", "at least 4.5"),
        ("pymunk", "pymunk Vec2d (two components)", ""),
    ):
        if importlib.util.find_spec(peer) is None:
            console.print(
                f"{peer} is not installed: .venv/bin/python -m pip install -r studies/peers.txt"
            )
            continue
        theirs = STATEMENTS[peer]
        each = [
            ratio(_timer(theirs, name), _timer(ours, name), 15, f"{peer}: {name}")
            for name in OPERATIONS
            if name in theirs
        ]
        middle, low, high = map(statistics.geometric_mean, zip(*each, strict=True))
        what = f"{title} / Vector3, geometric mean of {len(each)} operations"
        measured.append(Line(what, middle, low, high, target))
    return measured


def _timer(statements: dict[str, str], name: str) -> Timer:
    timer = timeit.Timer(statements[name], statements["setup"])
    return lambda: timer.timeit(20_000)


OPERATIONS = ("create", "add", "scale", "dot", "cross", "magnitude", "normalize", "add_scaled")
STATEMENTS = {
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
