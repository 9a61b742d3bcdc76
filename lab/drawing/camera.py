"""Project points in 3D space onto the flat picture of a scene.

In the picture, x points to the right, y points up, and z points toward the lower left.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3

TOWARD = (0.4, 0.3)  # how far one unit along z moves a point to the left and down


def flat(v: Vector3) -> tuple[float, float]:
    """Return the picture coordinates (x, y) of the point ``v`` in 3D space."""
    return v.x - TOWARD[0] * v.z, v.y - TOWARD[1] * v.z


def on_the_ground(x: float, y: float) -> tuple[float, float]:
    """Return x and z of the point on the ground (y = 0) that appears at (x, y) in the picture."""
    z = -y / TOWARD[1]
    return x + TOWARD[0] * z, z
