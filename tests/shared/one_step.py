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

    def mean_of(
        weights: tuple[float, ...],
        parts: tuple[float, ...],
        *,
        later: float = 0.0,
        back: tuple[bool, bool] = (True, True),
        ends: bool = True,
        turns: bool = True,
        piles: bool = False,
    ) -> tuple[float, float]:
        """Return the state after a step with the weighted mean of rates.

        ``back`` says whether position and velocity return to the start before each rate, ``ends``
        whether they do at the end, and ``piles`` whether the forces of all rates add up.
        """
        moved = pushed = velocity = rate = pile = 0.0
        start = x, v
        for number, (weight, part) in enumerate(zip(weights, parts, strict=True)):
            position = start[0] + velocity * part * h
            velocity = start[1] + turns * rate * part * h
            start = start[0] if back[0] else position, start[1] if back[1] else velocity
            rate = force(position, velocity) + later * (number > 0) + piles * pile
            pile = rate - acceleration
            moved += weight * velocity
            pushed += weight * rate
        start = (x, v) if ends else start
        return start[0] + moved / sum(weights) * h, (start[1] + pushed / sum(weights) * h) * keep

    keep, first, half_keep = d**h, force(x, v), d ** (0.5 * h)
    moved_first = {
        "You move p before you call apply_forces, so the forces belong to the wrong position. Call "
        "apply_forces first.": (x + v * h, (v + force(x + v * h, v) * h) * keep),
    }
    if method == "explicit_euler":
        middle, early = x + 0.5 * h * v, (v + 0.5 * h * first) * half_keep
        return moved_first | {
            "You take two steps of half the duration, so the second one uses a new velocity. Take "
            "a single step instead.": (
                middle + 0.5 * h * early,
                (early + 0.5 * h * acceleration) * half_keep,
            ),
        }
    if method == "semi_implicit_euler":
        new = (v + first * h) * keep
        return moved_first | {
            "You move the position twice, once with the old velocity and once with the new one. "
            "Move it only once, with the new velocity. If you store the position at the start, "
            "store a copy.": (x + (v + new) * h, new),
            "You move the position with the mean of the old and the new velocity. Semi-implicit "
            "Euler uses only the new velocity.": (x + 0.5 * (v + new) * h, new),
            "You move the position with the velocity before damping. Multiply the velocity by d^h "
            "first, and then move the position.": (x + (v + first * h) * h, new),
        }
    if method == "leapfrog":
        middle = x + 0.5 * h * v
        new = (v + force(middle, v) * h) * keep
        early = (v + first * h) * keep
        halved = (v + 0.5 * h * force(middle, v)) * half_keep
        twice = (v + (first + force(middle, v) - acceleration) * h) * keep
        kicked = (v + 0.5 * h * first) * half_keep
        ahead = x + h * kicked
        return {
            "You kick for half the step, drift for all of it, and kick again. Leapfrog drifts for "
            "half the step, kicks for all of it, and drifts again.": (
                ahead,
                (kicked + 0.5 * h * force(ahead, kicked)) * half_keep,
            ),
            "You evaluate the forces at the start of the step. Evaluate them after the first half "
            "drift instead.": (x + 0.5 * h * (v + early), early),
            "After the kick, you drift for the whole step. The first drift already covered half of "
            "it, so drift only for the other half.": (middle + h * new, new),
            "You call integrate, which moves the particle as well. Call kick, which changes only "
            "the velocity.": (middle + h * v + 0.5 * h * new, new),
            "You drift for both halves of the step with the old velocity. Kick before the second "
            "half drift.": (x + h * v, new),
            "You call apply_forces twice, at the start of the step and after the first half drift, "
            "so both forces act. Call it only after the first half drift.": (
                middle + 0.5 * h * twice,
                twice,
            ),
            "You move p for the whole step before you call apply_forces. Call it after the first "
            "half drift.": (x + h * v, (v + force(x + h * v, v) * h) * keep),
            "The second half drift is missing. After the kick, move the position by the new "
            "velocity times half the duration.": (middle, new),
            "You kick for only half the step. Leapfrog has a single kick, which must cover the "
            "whole step.": (middle + 0.5 * h * halved, halved),
        }
    if method == "velocity_verlet":
        bare, half, whole = (x + v * h + part * first * h * h for part in (0.0, 0.5, 1.0))
        least, second, most = (force(place, v + first * h) for place in (bare, half, whole))
        last = force(half, v)
        piled = first + second - acceleration
        kicked = (v + 0.5 * h * first) * half_keep
        ahead = x + h * kicked
        velocities = {
            "Your new velocity uses only the acceleration at the start of the step. Use the mean "
            "of the accelerations at the start and at the end instead.": v + first * h,
            "Your new velocity uses only the acceleration at the end of the step. Use the mean of "
            "the accelerations at the start and at the end instead.": v + second * h,
            "You add up the forces of both evaluations, so the velocity changes by twice as much "
            "as it should. Use their mean instead.": v + (first + second - a) * h,
            "Your new velocity starts from v + a h, which is only the estimate for the second "
            "evaluation. Start from the old velocity v instead, of which you need a copy.": v
            + (1.5 * first + 0.5 * second) * h,
            "Your second evaluation still includes the forces of the first one. Clear the "
            "accumulators in between, and restore only the forces added before the step.": v
            + 0.5 * (first + second + first - acceleration) * h,
            "Your second evaluation leaves out the force that was added to p before the step. "
            "Store this force, and add it again before the second evaluation.": v
            + 0.5 * (first + second - a + acceleration) * h,
            "Your second evaluation uses the old velocity. Set the velocity to v + a h before you "
            "evaluate the forces again.": v + 0.5 * (first + last) * h,
            "Your second evaluation still includes the forces of the first one, and it uses the "
            "old velocity. Clear the accumulators in between, and set the velocity to v + a h.": v
            + 0.5 * (first + last + first - acceleration) * h,
            "The forces of the second evaluation are still in the accumulators when you add the "
            "mean force. Clear the accumulators first.": v
            + (second + 0.5 * (first + second) - acceleration) * h,
            "The forces of both evaluations are still in the accumulators when you add the mean "
            "force. Clear the accumulators after each evaluation.": v
            + (piled + 0.5 * (first + piled) - acceleration) * h,
        }
        return {
            "You kick for half the step, drift, and kick again. With damping, or with forces that "
            "depend on the velocity, this is a different method. Use the formulas in the "
            "docstring.": (ahead, (kicked + 0.5 * h * force(ahead, kicked)) * half_keep),
            "You move p by v h alone. Add a h^2 / 2, where a is the acceleration at the start of "
            "the step.": (bare, (v + 0.5 * (first + least) * h) * keep),
            "You move p by v h + a h^2. Use a h^2 / 2, because the velocity reaches v + a h only "
            "at the end of the step.": (whole, (v + 0.5 * (first + most) * h) * keep),
        } | {slip: (half, velocity * keep) for slip, velocity in velocities.items()}
    if method == "runge_kutta_4":
        weights, parts = (1.0, 2.0, 2.0, 1.0), (0.0, 0.5, 0.5, 1.0)
        position, velocity = mean_of(weights, parts)
        short = x, v
        for _ in range(4):
            short = one_step("explicit_euler", *short, a, k, c, d, 0.25 * h)[:2]
        far, fast = x + 1.5 * (position - x), v * keep + 1.5 * (velocity - v * keep)
        four = "You divide the weighted sum by 4. The weights add up to 6, so divide by 6."
        return {
            four: (far, fast),
            f"{four} The velocity is right, the position is not.": (far, velocity),
            "You give all four rates the same weight. Give the second and the third rate twice "
            "the weight of the others.": mean_of((1.0, 1.0, 1.0, 1.0), parts),
            "You give the first and the last rate a weight of 2. Give this weight to the second "
            "and the third rate instead.": mean_of((2.0, 1.0, 1.0, 2.0), parts),
            "You evaluate the third rate at the end of the step. Return to the start, move for "
            "half the step at the second rate, and evaluate the third rate there.": mean_of(
                weights, (0.0, 0.5, 1.0, 1.0)
            ),
            "You evaluate the fourth rate in the middle of the step. Return to the start, move for "
            "the whole step at the third rate, and evaluate the fourth rate there.": mean_of(
                weights, (0.0, 0.5, 0.5, 0.5)
            ),
            "You evaluate only three rates: at the start, in the middle and at the end of the "
            "step. Runge-Kutta needs four, so evaluate two different rates in the middle.": mean_of(
                (1.0, 4.0, 1.0), (0.0, 0.5, 1.0)
            ),
            "For each rate, you move on from the state of the previous one. Return to the start of "
            "the step first, and move from there at the previous rate.": mean_of(
                weights, parts, back=(False, False)
            ),
            "The start of the step moves along with p, because you stored its position and "
            "velocity without copying them. Store copies.": mean_of(
                weights, parts, back=(False, False), ends=False
            ),
            "The position at the start of the step moves along with p, because you stored it "
            "without copying it. Store a copy.": mean_of(
                weights, parts, back=(False, True), ends=False
            ),
            "The velocity at the start of the step changes along with p, because you stored it "
            "without copying it. Store a copy.": mean_of(
                weights, parts, back=(True, False), ends=False
            ),
            "Each evaluation still includes the forces of the previous ones. Clear the "
            "accumulators in between, and restore only the forces added before the step.": mean_of(
                weights, parts, piles=True
            ),
            "Before each evaluation, you move p but keep its old velocity. Also set the velocity "
            "to v + a h / 2 or v + a h, where a is the previous acceleration.": mean_of(
                weights, parts, turns=False
            ),
            "Only your first evaluation includes the force that was added to p before the step. "
            "Store this force, and add it again before the other three evaluations.": mean_of(
                weights, parts, later=acceleration - a
            ),
            "You take four short steps of explicit Euler. Take a single step of the whole duration "
            "instead, with the weighted mean of four rates.": short,
            "You move p by v h, with the old velocity v. Use the weighted mean of the four "
            "velocities instead.": (x + v * h, velocity),
            "Your new velocity uses only the last of the four accelerations. Use their weighted "
            "mean instead.": (position, mean_of((0.0, 0.0, 0.0, 1.0), parts)[1]),
        }
    return {}
