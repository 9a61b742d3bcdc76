"""What becomes of lists, which cross between processes as copies: it must run beside the code."""

from __future__ import annotations

from ch09_rotations.plane import center_of_mass

Point = tuple[float, float]


def masses_after(masses: list[float], positions: list[Point]) -> tuple[list[float], list[Point]]:
    """Return what center_of_mass has left of the lists that it was given."""
    masses, positions = [*masses], [*positions]
    center_of_mass(masses, positions)
    return masses, positions
