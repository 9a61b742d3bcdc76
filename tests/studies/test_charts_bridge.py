"""The bridge at rest: its exact position is in balance, and models sag by known amounts."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy
import pytest

from ch07_constraints.links import AnchoredCable, Rod
from ch08_mass_aggregate.bridge import links_of
from ch08_mass_aggregate.bridge_plan import make_rows
from plots.drawing import slope
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.measured.bridge import HAIR
from studies.models.hanging_bridge import hanging

G = 9.81
MASSES = numpy.repeat([1.0, 1.0, 3.5, 1.0, 1.0, 1.0], 2)  # 5 kg on the ends of the third row
(SCENE,) = scenes_with("bridge at rest")
MODELS = {model.name: model for model in SCENE.models}
TWO_SIDED = ["semi-implicit Euler, two-sided rods", "two-sided rods, 400 iterations"]


@cache
def outcome(name: str, steps: int) -> tuple[float, int]:
    """Return the error in m and the work."""
    found = MODELS[name].run(steps)
    return SCENE.error(found) * SCENE.scale, found.work


def hangs() -> Any:
    """Return the exact positions in space. Across the bridge, all ends are where they start."""
    sides = numpy.reshape(SCENE.truth(0.5), (2, 6, 2))
    flat = sides.transpose(1, 0, 2).reshape(12, 2)  # the two ends of a plank side by side
    return numpy.column_stack([flat, numpy.tile([-1.0, 1.0], 6)])


def the_links() -> tuple[Any, Any, Any, Any]:
    """Return matrix, anchors, lengths and rods. A link is matrix @ positions + anchors."""
    rows = make_rows()
    number = {id(end): i for i, end in enumerate(end for row in rows for end in row)}
    links: list[Any] = links_of(rows)
    incidence, anchors = numpy.zeros((len(links), 12)), numpy.zeros((len(links), 3))
    lengths = [link.length if isinstance(link, Rod) else link.max_length for link in links]
    for i, link in enumerate(links):
        if isinstance(link, AnchoredCable):
            incidence[i, number[id(link.particle)]] = -1.0
            anchors[i] = tuple(link.anchor)
        else:
            incidence[i, number[id(link.a)]], incidence[i, number[id(link.b)]] = -1.0, 1.0
    rods = numpy.array([isinstance(link, Rod) for link in links])
    return incidence, anchors, numpy.array(lengths), rods


def test_forces_are_in_balance_where_the_truth_is_and_every_cable_pulls() -> None:
    incidence, anchors, lengths, rods = the_links()
    offsets = incidence @ hangs() + anchors
    # The coordinates are up to 5 m, and the solver stops within some roundings of them.
    assert numpy.linalg.norm(offsets, axis=1) == pytest.approx(lengths, abs=1e-11)
    ways = offsets / lengths[:, None]
    # The forces on the twelve ends along X, Y and Z, for a pull of 1 N in each link; the weights.
    matrix = numpy.array([-incidence[i][:, None] * way for i, way in enumerate(ways)])
    matrix = matrix.reshape(len(ways), 36).T
    weights = numpy.zeros((12, 3))
    weights[:, 1] = -G * MASSES
    pulls, *_ = numpy.linalg.lstsq(matrix, -weights.ravel(), rcond=None)
    # The 28 pulls cannot affect 8 of the 36 equations. 34 N has as many digits as the positions.
    assert abs(matrix @ pulls + weights.ravel()).max() < 1e-10
    # The pulls are 3.6 to 33 N. The load weighs 34 N, and each plank of 10 N hangs on two or three
    # cables.
    assert (pulls[~rods] > 3.0).all()
    assert (pulls[rods] < 0.0).all()


@pytest.mark.parametrize("name", MODELS)
def test_what_holds_the_bridge_gives_by_no_more_than_what_falls_in_a_step(name: str) -> None:
    """The ends fall by g h^2 first. With the default bias, 1.01 times that is the worst.

    With three iterations and without a bias, joints give by up to 6.8 times as much.
    """
    most = 8.0 if name.startswith(BEST) else 1.5
    for steps in (1, 2, 4):
        falls = G / (60.0 * steps) ** 2
        # If nothing falls any more, the initial shift remains.
        assert outcome(name, steps)[0] < most * falls + 10.0 * HAIR


def test_two_sided_rods_give_by_the_square_of_the_step_and_by_what_iterations_leave() -> None:
    """A cable that has just been pulled taut does not react further, whatever the iterations."""
    steps = (1, 2, 4)
    for name in TWO_SIDED:
        errors = [outcome(name, count)[0] for count in steps]
        # The initial shift is 3 % of the least error. The next order is far smaller.
        assert slope([1.0 / count for count in steps], errors) == pytest.approx(2.0, abs=0.05)
    few, many = (outcome(name, 1)[0] for name in TWO_SIDED)
    assert few > 20.0 * many
    loose = outcome("semi-implicit Euler, cables", 1)[0]
    assert loose / 10.0 < outcome("cables, 200 iterations", 1)[0] < loose


def test_pymunk_with_enough_iterations_stays_where_it_starts() -> None:
    started = numpy.subtract(hanging(HAIR), hanging())
    start = abs(started).max()
    # With 3 m of sag, the ends are lower by a few times the excess length of the cables.
    assert HAIR < start < 5.0 * HAIR
    for steps in (1, 4):
        assert outcome("pymunk, 50 iterations", steps)[0] < 2.0 * start
    assert outcome(EXAMPLES, 1)[0] > 1e4 * start


def test_work_is_contacts_resolved() -> None:
    """There are 22 cables in a plane, or 28 links in space. A two-sided rod has two contacts."""
    steps, count = 2, 60 * 2
    assert outcome(EXAMPLES, steps)[1] == count * 10 * 22
    assert outcome(at_best(50), steps)[1] == count * 50 * 22
    # Each of the two phases uses all iterations, because it does not reach 1e-9 m earlier.
    assert outcome(TWO_SIDED[0], steps)[1] == count * 2 * 2 * 2 * 28
    assert outcome(TWO_SIDED[1], steps)[1] == count * 2 * 400
    # Slack or exact cables have no contact, but most cables have one.
    work = outcome("semi-implicit Euler, cables", steps)[1]
    assert 0.8 < work / (count * 2 * 2 * 28) <= 1.0


def test_nothing_is_solved_before_a_scene_is_run() -> None:
    hanging.cache_clear()
    scenes_with("bridge at rest")
    assert hanging.cache_info().misses == 0
