"""Functions that solve exercises 7.1, 7.3 and 7.4 of the book, in SI units.

A number out of range raises ValueError, and a value of the wrong type raises TypeError.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3

Drop = tuple[str, float, float]  # a material, the height of the drop, and the height of the bounce


def restitution_of_drop(initial_height: float, bounce_height: float) -> float:
    """Exercise 7.1: compute the restitution of a ball from the heights of its drop and its bounce.

    It is the square root of bounce_height / initial_height, which are measured from the position
    of the ball when it touches the ground. The initial height must be positive.

    >>> restitution_of_drop(1.0, 0.64)
    0.8
    """
    raise NotImplementedError("Exercise 7.1: Measure some bounces")


def table_of_drops(drops: Sequence[Drop]) -> list[tuple[str, int, float, float | None]]:
    """Exercise 7.1: make a table of the restitutions that were measured for several materials.

    The table has a row for each material, in the order in which the materials first appear:
    (material, number of drops, mean restitution, standard error of the mean). For n drops the error
    is s / sqrt(n), with the sample standard deviation s (with n - 1), or None for a single drop.
    """
    raise NotImplementedError("Exercise 7.1: Measure some bounces")


def top_ball_speed(
    height: float,
    lower_mass: float,
    upper_mass: float,
    ground_restitution: float,
    pair_restitution: float,
    gravity: float = 10.0,
) -> float:
    """Exercise 7.3: compute how fast the upper of two dropped balls flies up after the bounce.

    Both balls fall from ``height``, one almost touching the other. The lower ball bounces off the
    ground first, and before it has risen noticeably, it hits the upper ball, which is still
    falling. The result is the upward velocity of the upper ball in m/s after this impact. Without
    height or gravity, the result is 0.
    """
    raise NotImplementedError("Exercise 7.3: Two balls dropped at once")


def force_for_frame(force: Vector3, contact_time: float, frame: float) -> Vector3:
    """Exercise 7.4: replace a short, strong push by a weaker force that acts for a whole frame.

    ``force`` acts for only ``contact_time`` s of a frame that lasts ``frame`` s. Return a new
    vector, the force that produces the same impulse in the longer time. Don't change ``force``.
    """
    raise NotImplementedError("Exercise 7.4: A push shorter than a frame")
