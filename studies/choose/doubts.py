"""Decide whether the estimated errors in a report of `make choose` can be trusted."""

from __future__ import annotations

import math
from itertools import combinations

from studies.accuracy.measure import Point
from studies.choose.halving import distance
from studies.choose.runs import Tried

LOW = 0.7  # fraction of the expected order below which there is a warning
APART = 3.0  # factor of the estimated errors beyond which two models contradict each other


def is_guess(tried: Tried) -> bool:
    """Return True if the table shows an error of the model that is only a guess."""
    return not tried.halved.is_steady and any(map(math.isfinite, tried.halved.errors[-1:]))


def contradiction(found: list[Tried], tolerance: float) -> str:
    """Return a text that says which models contradict each other, or an empty string.

    Their results with the shortest steps differ by more than the tolerance and their errors allow,
    and at least one of the models is accurate enough by its own estimate.
    """
    farthest = _farthest(found, tolerance)
    if not farthest or farthest[0] <= tolerance:
        return ""
    gap, a, b = farthest
    return (
        f"the models disagree: {a.model.name} and {b.model.name} differ by {gap:.1g}, but by their "
        f"own estimates their errors are only {a.halved.errors[-1]:.1g} and "
        f"{b.halved.errors[-1]:.1g}. At least one of them computes a wrong motion, so no error "
        "below can be trusted. Check that every force depends only on the current state of the "
        "particles. If a force needs the time, let it read a clock as in "
        "studies/choose/example_driven.py. If several bodies collide at once, solvers follow "
        "different rules, so compare with an experiment or a closed form"
    )


def _farthest(found: list[Tried], tolerance: float) -> tuple[float, Tried, Tried] | None:
    """Return the two models that differ most, if their errors do not allow it, and by how much."""
    apart = []
    for a, b in combinations([tried for tried in found if tried.halved.is_steady], 2):
        mine, other = a.runs[-1], b.runs[-1]
        assert mine is not None
        assert other is not None  # a model whose last run failed is not steady
        errors = a.halved.errors[-1], b.halved.errors[-1]
        gap = distance(mine, other)
        if min(errors) <= tolerance and gap > APART * sum(errors):
            apart.append((gap, a, b))
    return max(apart, key=lambda pair: pair[0], default=None)


def warnings(
    found: list[Tried], chosen: Point | None, tolerance: float, *, is_doubtful: bool = False
) -> list[str]:
    """List the reasons why the estimated errors may be wrong, as sentences for the report.

    ``is_doubtful`` means that the report already says so.
    """
    told = []
    unsteady = [tried for tried in found if not tried.halved.is_steady]
    if any(map(is_guess, found)) and not is_doubtful:
        told.append(
            "errors marked ? are only guesses, because they do not fall with the expected order as "
            "the steps are halved"
        )
    unknown = [tried for tried in unsteady if not tried.halved.orders]
    told += [tried.failure or f"{tried.model.name}: its runs hardly differ" for tried in unknown]
    if len(unsteady) == len(found):
        told.append(
            "no model converges. If the motion is chaotic, shorten DURATION, or measure something "
            "less sensitive to the initial state. If bodies collide or cables go taut, errors "
            "shrink unevenly, so allow for an error several times as large"
        )
    for tried in found:
        name, order, seen = tried.model.name, tried.model.order, tried.halved.orders
        # Leapfrog is expected to have only order 1 if a force depends on the velocity.
        if tried.halved.is_steady and seen and seen[-1] < LOW * order and name != "leapfrog":
            told.append(
                f"{name} converges with order {seen[-1]:.1f} instead of {order}, which is typical "
                "of a force with a jump or a kink. Its error is estimated from the lower order"
            )
    if chosen and (doubt := _doubt_about(found, chosen, tolerance)):
        told.append(doubt)
    return told


def _doubt_about(found: list[Tried], chosen: Point, tolerance: float) -> str:
    """Return a warning if no other model confirms the chosen one, or if models differ too much."""
    mine = next(tried for tried in found if tried.model.name == chosen.model)
    others = [tried for tried in found if tried is not mine and tried.halved.is_steady]
    if not others:
        only = f"only {chosen.model} converges, so no other model confirms its error"
        return "" if mine.halved.is_exact or len(found) == 1 else only
    if not (farthest := _farthest(found, tolerance)):
        return ""
    gap, a, b = farthest
    return (
        f"{a.model.name} and {b.model.name} differ by {gap:.1g}. This is less than the tolerance, "
        "but more than their estimated errors allow, so at least one estimate is too small"
    )
