"""Loops that run beside the student's code. Every function takes and returns plain numbers."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.quaternion import Quaternion
from ch09_rotations.stones import own_stones, read_stones

Components = tuple[float, float, float]
Quad = tuple[float, float, float, float]


def in_parts(velocity: Components, time: float, parts: int) -> Quad:
    """Return the orientation after a steady rotation in equal parts, by rotate_by."""
    q = Quaternion()
    part = Vector3(*velocity) * (time / parts)
    for _ in range(parts):
        q.rotate_by(part)
    return q.r, q.i, q.j, q.k


def steps(
    orientation: Quad, velocity: Components, acceleration: Components, duration: float, count: int
) -> tuple[Quad, Components, Components]:
    """Return orientation, angular velocity and acceleration after steps of integrate_rotation."""
    q, w, a = Quaternion(*orientation), Vector3(*velocity), Vector3(*acceleration)
    for _ in range(count):
        integrate_rotation(q, w, a, duration)
    return (q.r, q.i, q.j, q.k), (w.x, w.y, w.z), (a.x, a.y, a.z)


def entered_stones() -> list[tuple[str, float, float, float]]:
    """Return the stones in the student's stones.csv."""
    return read_stones(own_stones())
