"""Compare the speed of our vectors, quaternions and matrices with that of other libraries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rich.console import Console

from scenes.timing import (
    ROUNDS,
    Measurement,
    Statements,
    Target,
    Timer,
    against_peers,
    statement_timer,
    versus,
)


def columns(setups: Mapping[str, str], operations: Mapping[str, Sequence[str]]) -> Statements:
    """Return the statements by library, from a row of them for each operation."""
    return {
        library: {"setup": setup} | {name: row[i] for name, row in operations.items() if row[i]}
        for i, (library, setup) in enumerate(setups.items())
    }


OF_THREE = "a, b, c = V(1.5, 2.5, 3.5), V(0.5, -1.5, 2.0), V(1.0, 1.0, 1.0)"
ARRAYS = "n.array([1.5, 2.5, 3.5]), n.array([0.5, -1.5, 2.0]), n.array([1.0, 1.0, 1.0])"
SETUPS_OF_VECTORS = {
    "ours": f"from ch02_vectors.vector import Vector3 as V\n{OF_THREE}",
    "pyglet": f"from pyglet.math import Vec3 as V\n{OF_THREE}",
    "numpy": f"import numpy as n\na, b, c = {ARRAYS}",
    "pymunk": "from pymunk import Vec2d as V\na, b, c = V(1.5, 2.5), V(0.5, -1.5), V(1.0, 1.0)",
}
CREATE, ADD, SCALED = "V(1.5, 2.5, 3.5)", "c = c + b * 0.001", "c += b * 0.001"
OF_VECTORS = {  # in our engine, in pyglet, in NumPy and in pymunk, as far as they have it
    "create": (CREATE, CREATE, "n.array([1.5, 2.5, 3.5])", "V(1.5, 2.5)"),
    "add": ("a + b",) * 4,
    "scale": ("a * 1.5",) * 4,
    "dot": ("a.dot(b)",) * 4,
    "cross": ("a.cross(b)", "a.cross(b)", "n.cross(a, b)", ""),
    "magnitude": ("a.magnitude()", "a.length()", "n.linalg.norm(a)", "a.length"),
    "normalize": ("a.normalized()", "a.normalize()", "a / n.linalg.norm(a)", "a.normalized()"),
    "add_scaled": ("c.add_scaled(b, 0.001)", ADD, SCALED, ADD),
}
PEERS_OF_VECTORS = (
    ("pyglet", "pyglet Vec3", Target("at least", 2.4)),
    ("numpy", "NumPy array", Target("at least", 4.5)),
    ("pymunk", "pymunk Vec2d (two components)", None),
)
SETUP = """\
from ch02_vectors.vector import Vector3 as V
from ch09_rotations.exercises import easy_inverse, read_off
from ch09_rotations.matrix import Matrix3 as M3, Matrix4 as M4
from ch09_rotations.quaternion import Quaternion as Q
v, spin = V(1.5, 2.5, 3.5), V(0.3, -0.2, 0.1)
q, p = Q(0.5, 0.5, 0.5, 0.5), Q(0.6, 0.0, 0.8, 0.0)
m, n = M3.from_quaternion(q), M3.from_quaternion(p)
t, u = M4.from_orientation_and_position(q, v), M4.from_orientation_and_position(p, v)
c = q.copy()
"""
RIVALS = (  # two statements, the description of their ratio, and its target
    (
        "t.inverse().transform(v)",
        "t.transform_inverse(v)",
        "from world to local: Matrix4.inverse and transform / transform_inverse",
        Target("at least", 15),
    ),
    (
        "t.inverse()",
        "easy_inverse(t)",
        "Matrix4.inverse / easy_inverse of exercise 9.6",
        Target("at least", 4.5),
    ),
    (
        "read_off(t)",
        "t.inverse()",
        "read_off, which tests whether easy_inverse works / Matrix4.inverse",
        None,
    ),
    ("m.is_rotation()", "m.inverse()", "Matrix3.is_rotation / Matrix3.inverse", None),
    (
        "m @ n",
        "q * p",
        "combining two rotations: matrix product / quaternion product",
        Target("at least", 1.8),
    ),
    ("q.rotate(v)", "m @ v", "rotating a vector: by a quaternion / by its matrix", None),
    (
        "c.rotate_by(spin)",
        "c.add_scaled(spin, 1.0); c.normalize()",
        "rotate_by, which is exact / add_scaled and normalize (Eq. 9.5)",
        Target("at most", 2),
    ),
)
SETUPS = {
    "ours": SETUP,
    "pyglet": "from pyglet.math import Mat3, Mat4, Quaternion as Q, Vec3, Vec4\n"
    "q, p = Q(0.5, 0.5, 0.5, 0.5), Q(0.6, 0.0, 0.8, 0.0)\n"
    "v, w = Vec3(1.5, 2.5, 3.5), Vec4(1.5, 2.5, 3.5, 1.0)\n"
    "m, n = q.to_mat3(), p.to_mat3()\n"
    "t, u = (Mat4.from_translation(v) @ a.to_mat4() for a in (q, p))",
    "numpy": "import numpy\n"
    "m = numpy.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])\n"
    "n = numpy.array([[-0.28, 0.0, 0.96], [0.0, 1.0, 0.0], [-0.96, 0.0, -0.28]])\n"
    "v = numpy.array([1.5, 2.5, 3.5])",
}
NUMBERS = "1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0"
ROWS = "numpy.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]])"
OPERATIONS = {  # in our engine, in pyglet and in NumPy, as far as they have it
    "a quaternion": ("Q(0.5, 0.5, 0.5, 0.5)", "Q(0.5, 0.5, 0.5, 0.5)", ""),
    "product of quaternions": ("q * p", "q @ p", ""),
    "conjugate": ("q.conjugate()", "q.conjugate()", ""),
    "length": ("q.magnitude()", "q.length()", ""),
    "normalized": ("c = q.copy(); c.normalize()", "q.normalize()", ""),
    "quaternion to matrix": ("M3.from_quaternion(q)", "q.to_mat3()", ""),
    "a matrix": (f"M3({NUMBERS})", f"Mat3({NUMBERS})", ROWS),
    "product": ("m @ n", "m @ n", "m @ n"),
    "transform": ("m @ v", "m @ v", "m @ v"),
    "transpose": ("m.transpose()", "", "m.T"),
    "determinant": ("m.determinant()", "", "numpy.linalg.det(m)"),
    "inverse": ("m.inverse()", "~m", "numpy.linalg.inv(m)"),
    "product with translation": ("t @ u", "t @ u", ""),
    "transform with translation": ("t @ v", "t @ w", ""),
    "inverse with translation": ("t.inverse()", "~t", ""),
}
VECTORS, ROTATIONS = columns(SETUPS_OF_VECTORS, OF_VECTORS), columns(SETUPS, OPERATIONS)
PEERS = (("pyglet", "pyglet Quaternion, Mat3 and Mat4", None), ("numpy", "NumPy 3x3 arrays", None))


def lines_of_vectors(console: Console) -> list[Measurement]:
    """Set up a benchmark per library, and name on ``console`` the ones that are not installed."""
    return against_peers(console, "Vector3", VECTORS, PEERS_OF_VECTORS)


def lines_of_rotations(console: Console) -> list[Measurement]:
    """Set up the benchmarks, but skip those of libraries that are not installed."""
    found = [
        Measurement(what, versus(_timer(first), _timer(second)), ROUNDS, target)
        for first, second, what, target in RIVALS
    ]
    form, rotate, transform = map(_timer, ("M3.from_quaternion(q)", "q.rotate(v)", "m @ v"))
    what = "number of vectors above which converting the quaternion to a matrix is faster"
    found.append(Measurement(what, versus(form, lambda: rotate() - transform()), ROUNDS))
    return found + against_peers(console, "Quaternion, Matrix3 and Matrix4", ROTATIONS, PEERS)


def _timer(code: str) -> Timer:
    return statement_timer(code, SETUP)
