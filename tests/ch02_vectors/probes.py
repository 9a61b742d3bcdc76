"""Long loops, which must run beside the student's code. They take and return plain numbers."""

from __future__ import annotations

from ch02_vectors.vector import Vector3

Components = tuple[float, float, float]


def walk(start: Components, velocity: Components, frame: float, frames: int) -> Components:
    """Move a position by p' = p + v h in every frame, and return the last position."""
    position, step = Vector3(*start), Vector3(*velocity)
    for _ in range(frames):
        position.add_scaled(step, frame)
    return position.x, position.y, position.z
