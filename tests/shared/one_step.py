"""One step of each integrator of chapter 6 in plain numbers, with and without likely mistakes."""

from __future__ import annotations


def one_step(
    method: str, x: float, v: float, a: float, k: float, c: float, d: float, h: float
) -> tuple[float, float, float]:
    """Make a step of x'' = a - k x - c v on one axis.

    Return the new position, the new velocity, and the mean acceleration of the step.
    """

    def force(position: float, velocity: float) -> float:
        return a - k * position - c * velocity

    keep = d**h
    first = force(x, v)
    if method == "leapfrog":
        middle = x + 0.5 * h * v
        mean = force(middle, v)
        position = middle + 0.5 * h * (v + mean * h) * keep
    elif method == "velocity_verlet":
        position = x + v * h + 0.5 * first * h * h
        mean = 0.5 * (first + force(position, v + first * h))
    elif method == "runge_kutta_4":
        # For a linear equation, this equals Taylor's series up to the fourth order.
        position, mean, rate, jerk, factor = x, 0.0, v, first, h
        for n in (1, 2, 3, 4):
            position += rate * factor
            mean += jerk * factor / h
            rate, jerk = jerk, -k * rate - c * jerk
            factor *= h / (n + 1)
    else:
        mean = first
        position = x + h * (v if method == "explicit_euler" else (v + mean * h) * keep)
    return position, (v + mean * h) * keep, mean


def wrong_steps(
    method: str,
    x: float,
    v: float,
    a: float,
    k: float,
    c: float,
    d: float,
    h: float,
    acceleration: float,
) -> dict[str, tuple[float, float]]:
    """Return position and velocity after steps with a mistake, keyed by its explanation.

    ``acceleration`` is the part of a that is not due to forces added by hand.
    """

    def force(position: float, velocity: float) -> float:
        return a - k * position - c * velocity

    def mean_of(weights: tuple[float, ...], parts: tuple[float, ...]) -> tuple[float, float]:
        moved = pushed = velocity = rate = 0.0
        for weight, part in zip(weights, parts, strict=True):
            position, velocity = x + velocity * part * h, v + rate * part * h
            rate = force(position, velocity)
            moved += weight * velocity
            pushed += weight * rate
        return x + moved / sum(weights) * h, (v + pushed / sum(weights) * h) * keep

    keep, first = d**h, force(x, v)
    if method == "semi_implicit_euler":
        new = (v + first * h) * keep
        return {
            "This moves the position twice, by v and by v'.": (x + (v + new) * h, new),
            "This moves by the mean of v and v'. Move by one of them.": (
                x + 0.5 * (v + new) * h,
                new,
            ),
            "This moves by v' before it is damped. Damp it first.": (
                x + (v + first * h) * h,
                new,
            ),
        }
    if method == "leapfrog":
        middle = x + 0.5 * h * v
        new = (v + force(middle, v) * h) * keep
        early = (v + first * h) * keep
        halved = (v + 0.5 * h * force(middle, v)) * d ** (0.5 * h)
        return {
            "The forces are those at the start. Evaluate them after the half drift.": (
                x + 0.5 * h * (v + early),
                early,
            ),
            "This drifts for h after the kick. Drift for h / 2.": (middle + h * new, new),
            "The second half drift is missing.": (middle, new),
            "This kicks for h / 2. Kick for the whole step.": (middle + 0.5 * h * halved, halved),
        }
    if method == "velocity_verlet":
        half, whole = x + v * h + 0.5 * first * h * h, x + v * h + first * h * h
        second, later = force(half, v + first * h), force(whole, v + first * h)
        return {
            "This has a h^2 in place of a h^2 / 2.": (
                whole,
                (v + 0.5 * (first + later) * h) * keep,
            ),
            "This has v' = v + b h. Use the mean of a and b.": (half, (v + second * h) * keep),
            "This uses the sum of the forces. Use their mean.": (
                half,
                (v + (first + second - a) * h) * keep,
            ),
            "The forces of the first evaluation are still there in the second one. Clear the "
            "accumulators in between, and add again what was added by hand.": (
                half,
                (v + 0.5 * (first + second + first - acceleration) * h) * keep,
            ),
            "This evaluates b with the old velocity, not v + a h.": (
                half,
                (v + 0.5 * (first + force(half, v)) * h) * keep,
            ),
        }
    if method == "runge_kutta_4":
        parts = (0.0, 0.5, 0.5, 1.0)
        return {
            "All rates count the same. The two in the middle must count double.": mean_of(
                (1.0, 1.0, 1.0, 1.0), parts
            ),
            "The outer rates count double. Count the two in the middle double.": mean_of(
                (2.0, 1.0, 1.0, 2.0), parts
            ),
            "The third rate is at the end. Take it in the middle.": mean_of(
                (1.0, 2.0, 2.0, 1.0), (0.0, 0.5, 1.0, 1.0)
            ),
            "The last rate is in the middle. Take it at the end.": mean_of(
                (1.0, 2.0, 2.0, 1.0), (0.0, 0.5, 0.5, 0.5)
            ),
        }
    return {}
