"""Exercises 7.1, 7.3 and 7.4: measured bounces, two balls dropped at once, a short push."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import a_restitution

Drop = tuple[str, float, float]


def restitution_of_drop(initial_height: float, bounce_height: float) -> float:
    """Exercise 7.1: return the restitution of a ball that is dropped, and bounces so high.

    Both heights are in m, of the same point of the ball, above where it is when it touches. Speeds
    go with the roots of heights, so it is the root of bounce_height / initial_height; the book
    prints it without the root (E-10).

    >>> restitution_of_drop(1.0, 0.64)
    0.8

    Raises ValueError where the initial height is not positive, the bounce is negative or higher
    than that, or one of them is not finite; TypeError for what is no number.
    """
    positive("initial_height", initial_height)
    if not_negative("bounce_height", bounce_height) > initial_height:
        wanted = f"bounce_height must be initial_height, {initial_height!r}, or less"
        raise ValueError(f"{wanted}, got {bounce_height!r}")
    return math.sqrt(bounce_height / initial_height)


def table_of_drops(drops: Sequence[Drop]) -> list[tuple[str, int, float, float | None]]:
    """Exercise 7.1: return a row for each material: its name, how many drops, mean, standard error.

    A drop is a tuple of its material, initial height and bounce height in m. The mean is that of
    the drops' restitutions. Its standard error is s / sqrt(n), where s is their standard deviation,
    with n - 1 below the root; one drop alone tells none, and has None there. The rows are in the
    order in which the materials come first. No drops give no rows.

    Raises what restitution_of_drop raises.
    """
    measured: dict[str, list[float]] = {}
    for material, initial_height, bounce_height in drops:
        restitution = restitution_of_drop(initial_height, bounce_height)
        measured.setdefault(material, []).append(restitution)
    rows = []
    for material, values in measured.items():
        count = len(values)
        error = statistics.stdev(values) / math.sqrt(count) if count > 1 else None
        rows.append((material, count, statistics.fmean(values), error))
    return rows


def top_ball_speed(
    height: float,
    lower_mass: float,
    upper_mass: float,
    ground_restitution: float,
    pair_restitution: float,
    gravity: float = 10.0,
) -> float:
    """Exercise 7.3: return how fast the upper one of two balls goes upwards, in m/s.

    One lies on the other, almost touching; both are dropped from a height in m, under a gravity in
    m/s^2. The lower one meets the ground first, and then, at the same place, the upper one, which
    is still on its way down. Masses are in kg. It is negative where the upper ball goes on
    downwards.

    Raises ValueError where height or gravity is negative, a mass is not positive, a restitution is
    not from 0 to 1, or one of them is not finite; TypeError for what is no number.
    """
    not_negative("height", height)
    not_negative("gravity", gravity)
    total = positive("lower_mass", lower_mass) + positive("upper_mass", upper_mass)
    speed = math.sqrt(2.0 * gravity * height)
    lower = a_restitution("ground_restitution", ground_restitution) * speed
    closing = lower + speed
    # They part at c times the speed; the upper ball's share of that change keeps the momentum.
    change = (1.0 + a_restitution("pair_restitution", pair_restitution)) * closing
    return change * lower_mass / total - speed


def force_for_frame(force: Vector3, contact_time: float, frame: float) -> Vector3:
    """Exercise 7.4: return the force in N that does in a whole frame what another does in a part.

    ``force`` acts for ``contact_time`` s of a frame of ``frame`` s. A step keeps forces for all of
    its frame, so a smaller one of the same impulse is wanted. It is a new vector.

    Raises ValueError where the contact time is negative or longer than the frame, the frame is not
    positive, or something is not finite; TypeError for what is no number or no Vector3.
    """
    force = finite_vector("force", force)
    positive("frame", frame)
    if not_negative("contact_time", contact_time) > frame:
        raise ValueError(f"contact_time must be frame, {frame!r}, or less, got {contact_time!r}")
    return force * (contact_time / frame)
