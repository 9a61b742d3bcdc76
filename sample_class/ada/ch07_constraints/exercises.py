"""Exercises 7.1, 7.3 and 7.4: measured bounces, two balls dropped at once, a short push."""

from __future__ import annotations

import math
from collections.abc import Sequence

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3

Drop = tuple[str, float, float]


def restitution_of_drop(initial_height: float, bounce_height: float) -> float:
    start = positive("initial_height", initial_height)
    end = not_negative("bounce_height", bounce_height)
    if end > start:
        raise ValueError(f"bounce_height must be initial_height, {start!r}, or less, got {end!r}")
    return math.sqrt(end) / math.sqrt(start)


def table_of_drops(drops: Sequence[Drop]) -> list[tuple[str, int, float, float | None]]:
    measured = [(material, restitution_of_drop(*heights)) for material, *heights in drops]
    rows: list[tuple[str, int, float, float | None]] = []
    for name in dict.fromkeys(material for material, _ in measured):
        values = [value for material, value in measured if material == name]
        n = len(values)
        mean = math.fsum(values) / n
        spread = math.hypot(*(value - mean for value in values))
        rows.append((name, n, mean, spread / math.sqrt(n * (n - 1)) if n > 1 else None))
    return rows


def top_ball_speed(
    height: float,
    lower_mass: float,
    upper_mass: float,
    ground_restitution: float,
    pair_restitution: float,
    gravity: float = 10.0,
) -> float:
    fall = (
        math.sqrt(2.0)
        * math.sqrt(not_negative("gravity", gravity))
        * math.sqrt(not_negative("height", height))
    )
    ratio = positive("upper_mass", upper_mass) / positive("lower_mass", lower_mass)
    lower_share = 1.0 / (1.0 + ratio)
    up = fall * _share("ground_restitution", ground_restitution)
    closing = fall + up
    middle = closing * lower_share - fall
    return middle + _share("pair_restitution", pair_restitution) * closing * lower_share


def force_for_frame(force: Vector3, contact_time: float, frame: float) -> Vector3:
    result = finite_vector("force", force)
    frame = positive("frame", frame)
    if not_negative("contact_time", contact_time) > frame:
        raise ValueError(f"contact_time must be frame, {frame!r}, or less, got {contact_time!r}")
    result *= contact_time / frame
    return result


def _share(name: str, value: float) -> float:
    """Return a number from 0 to 1; ValueError names another one."""
    if not_negative(name, value) > 1.0:
        raise ValueError(f"{name} must be from 0 to 1, got {value!r}")
    return float(value)
