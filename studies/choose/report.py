"""Print the report of `make choose` on a scene that the user wrote.

The report says which method is the fastest one that is accurate enough. It warns the user if the
estimated errors cannot be trusted.
"""

from __future__ import annotations

import math
from pathlib import Path

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table

from autograder.text.wrapping import print_wrapped
from studies.accuracy.measure import Point
from studies.accuracy.results import cheapest, first_within
from studies.accuracy.scene import RATE
from studies.choose import runs
from studies.choose.halving import distance
from studies.choose.runs import Tried
from studies.choose.scene import OwnScene, load

LOW = 0.7  # fraction of the expected order below which there is a warning
APART = 3.0  # factor of the estimated errors beyond which two models contradict each other


def choose(path: Path, tolerance: float, console: Console) -> int:
    """Simulate the user's scene with every model, and report the fastest one that is good enough.

    Its estimated error must be at most ``tolerance``. Return 0 if there is such a model, and 1
    otherwise.

    Raises:
        SceneError: The file does not describe a valid scene.
    """
    scene = load(path)
    with console.status("measuring") as status:
        found = runs.explore(scene, tolerance, status.update)
        status.update("timing")
        runs.time_all(scene, found, tolerance)
    console.print(
        f"{scene.path}: {scene.frames / RATE:.3g} s, error at most {tolerance:g} in every frame",
        style="bold",
        soft_wrap=True,
    )
    steady = [point for tried in found if tried.halved.is_steady for point in tried.points(scene)]
    chosen, cheaper = cheapest(steady, tolerance)
    for title, point, none in (
        ("cheapest", chosen, f"no model is accurate enough with runs of up to {runs.SLOWEST:g} s"),
        ("next cheaper", cheaper, "no model is cheaper"),
    ):
        told = _told(found, point, scene.frames) if point else none
        if point and point is cheaper:
            fails = point.error > tolerance
            told += ": not accurate enough" if fails else ": accurate only by chance"
        if chosen or title == "cheapest":
            print_wrapped(console, f"  {title + ':':14}{told}", hanging=16)
    console.print(_table(found, scene, tolerance))
    for warning in warnings(found, chosen):
        print_wrapped(console, f"Warning: {warning}", hanging=2)
    return 0 if chosen else 1


def _told(found: list[Tried], point: Point, frames: int) -> str:
    model = next(tried.model for tried in found if tried.model.name == point.model)
    choice = model.chosen(point.steps)
    return f"{point.model}, {choice}: {took(point, frames)}, error about {point.error:.1g}"


def took(point: Point, frames: int) -> str:
    """Describe how long a run of a scene took, in total and for each frame on average."""
    milliseconds = 1e3 * point.time
    return f"{milliseconds:.3g} ms ({milliseconds / frames:.2g} ms per frame)"


def _table(found: list[Tried], scene: OwnScene, tolerance: float) -> Table:
    """Build the report's table of how many time steps each model needs, and how long it takes.

    If a model never meets the tolerance, its row shows the run with the shortest time steps.
    """
    table = Table("model", "steps / frame", box=SIMPLE_HEAD, pad_edge=False)
    for heading in ("error", "ms", "order"):
        table.add_column(heading, justify="right")
    for tried in found:
        points = tried.points(scene)
        first = first_within(points, tolerance)
        point = points[-1] if first is None else points[first]
        choice = tried.model.chosen(point.steps).replace(" steps per frame", "")
        guess = "" if tried.halved.is_steady else "? "
        table.add_row(
            tried.model.name,
            f"not with {choice}" if first is None else choice,
            f"{guess}{point.error:.1g}" if math.isfinite(point.error) else "failed",
            f"{1e3 * point.time:.3g}",
            _order(tried),
        )
    return table


def _order(tried: Tried) -> str:
    """Describe the order of convergence that a model has reached, as in "1.9 of 2" or "exact".

    In "1.9 of 2", 1.9 is the observed order, and 2 is the model's order in theory.
    """
    if tried.halved.is_exact:
        return "exact"
    seen = f"{tried.halved.orders[-1]:.1f}" if tried.halved.orders else "?"
    return f"{seen} of {tried.model.order}"


def warnings(found: list[Tried], chosen: Point | None) -> list[str]:
    """List the reasons why the estimated errors may be wrong, as sentences for the report.

    A model may not converge, or it may converge more slowly than in theory. Two models may also
    contradict each other.
    """
    told = []
    unsteady = [tried for tried in found if not tried.halved.is_steady]
    if unsteady:
        told.append(
            "errors marked ? are only guesses, because they do not fall with the expected order as "
            "the steps are halved"
        )
    for tried in unsteady:
        if not tried.halved.orders:
            told.append(f"{tried.model.name}: {tried.failure or 'its runs hardly differ'}")
    if not chosen and len(unsteady) == len(found):
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
    if chosen and (other := _contradicting(found, chosen)):
        told.append(other)
    return told


def _contradicting(found: list[Tried], chosen: Point) -> str:
    """Compare the chosen model with the most accurate of the other models.

    If their results differ by more than three times the sum of their estimated errors, at least one
    estimate is wrong. Return a warning in that case, or if no other model converges. Otherwise
    return an empty string.
    """
    mine = next(tried for tried in found if tried.model.name == chosen.model)
    run = mine.runs[mine.model.choices.index(chosen.steps)]
    others = [tried for tried in found if tried is not mine and tried.halved.is_steady]
    if not others:
        only = f"only {chosen.model} converges, so no other model confirms its error"
        return "" if mine.halved.is_exact or len(found) == 1 else only
    other = min(others, key=lambda tried: tried.halved.errors[-1])
    finest = other.runs[-1]
    assert run is not None
    assert finest is not None  # a model whose last run failed is not steady
    apart = distance(run, finest)
    if apart <= APART * (chosen.error + other.halved.errors[-1]):
        return ""
    return (
        f"{chosen.model} and {other.model.name} differ by {apart:.1g}, more than their "
        "estimated errors allow, so at least one of them is wrong"
    )
