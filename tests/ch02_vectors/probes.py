"""What must run beside the student's code: loops. Each function takes and returns plain numbers."""

from __future__ import annotations

from ch02_vectors.vector import Vector3

Components = tuple[float, float, float]


def walk(start: Components, velocity: Components, frame: float, frames: int) -> Components:
    """Move a position by p' = p + v h, frame after frame, and return where it ends."""
    position, step = Vector3(*start), Vector3(*velocity)
    for _ in range(frames):
        position.add_scaled(step, frame)
    return position.x, position.y, position.z
