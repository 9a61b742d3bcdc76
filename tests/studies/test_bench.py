"""The bench measures what it claims. No test checks a speed, because machines are shared."""

from __future__ import annotations

import io
import json
import math
import platform
import timeit
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from rich.console import Console

from ch03_laws_of_motion.particle import Particle
from ch05_forces import particle as chapter_5
from scenes import timing
from scenes.flight import PROJECTILE
from scenes.timing import Measurement, Target
from studies import bench
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import EXAMPLES
from studies.benchmarks import (
    accuracy,
    algebra,
    constraints,
    particles,
    springs,
)
from studies.models.plain_numbers import cloth_in_numbers, flight_in_numbers, pushed_in_numbers

(THROW,) = scenes_with("projectile")


def test_a_ratio_is_the_median_of_the_rounds_and_its_spread_their_quartiles() -> None:
    first = iter([2.0, 4.0, 6.0, 100.0, 4.0])
    figure = timing.versus(lambda: next(first), lambda: 2.0)
    (line,) = timing.measure([Measurement("made up", figure, 5)])
    assert line.median == 2.0  # the median of 1, 2, 2, 3 and 50 ignores one slow round
    assert (line.low, line.high) == (2.0, 3.0)


def test_what_is_quick_is_timed_again_without_its_first_cold_run() -> None:
    calls = {"quick": 0, "slow": 0}

    def taking(what: str, first: float, later: float) -> Callable[[], float]:
        def timed() -> float:
            calls[what] += 1
            return first if calls[what] == 1 else later

        return timed

    quick, slow = timing.both(taking("quick", 1e-3, 1e-4), taking("slow", 3.0, 2.0))
    assert quick == pytest.approx(1e-4)  # the mean has many roundings
    assert slow == 3.0
    assert calls["quick"] > 1
    assert calls["slow"] == 1


def test_a_geometric_mean_is_taken_in_every_round() -> None:
    figures = [iter([2.0, 1.0, 3.0]), iter([8.0, 1.0, 12.0])]
    figure = timing.geometric_mean([figures[0].__next__, figures[1].__next__])
    (line,) = timing.measure([Measurement("made up", figure, 3)])
    assert (line.low, line.median, line.high) == pytest.approx((1.0, 4.0, 6.0))


def test_lines_are_visited_all_over_the_run_with_their_two_sides_next_to_each_other() -> None:
    rounds = {"often": 120, "as often": 120, "seldom": 3, "once": 1}
    visits: list[tuple[str, int]] = []

    def side(what: str, which: int) -> Callable[[], float]:
        return lambda: visits.append((what, which)) or 1.0

    timing.measure(
        [
            Measurement(what, timing.versus(side(what, 0), side(what, 1)), many)
            for what, many in rounds.items()
        ]
    )
    pairs = [*zip(visits[::2], visits[1::2], strict=True)]
    assert all(first[0] == second[0] for first, second in pairs)
    # The probability that 244 or 120 coin tosses are all alike is 2^-119.
    assert {(first[1], second[1]) for first, second in pairs} == {(0, 1), (1, 0)}
    order = [first[0] for first, _ in pairs]
    assert {what: order.count(what) for what in rounds} == rounds
    equals = [what for what in order if "often" in what]
    halves = {*zip(equals[::2], equals[1::2], strict=True)}
    assert halves == {("often", "as often"), ("as often", "often")}  # each once per round
    before = [order[:i].count("often") for i, what in enumerate(order) if what == "seldom"]
    assert all(40 * k <= count <= 40 * (k + 1) for k, count in enumerate(before))  # one per third


@pytest.mark.parametrize(
    ("target", "median", "verdict"),
    [
        (Target("at least", 7), 6.999, "missed"),
        (Target("at least", 7), 7.0, "met"),
        (Target("at most", 1.15), 1.15, "met"),
        (Target("at most", 1.15), 1.151, "missed"),
        (None, 1.0, ""),
    ],
)
def test_a_target_is_judged_by_the_median(
    target: Target | None, median: float, verdict: str
) -> None:
    assert timing.Line("made up", median, 0.0, 1e9, target).verdict == verdict


@pytest.mark.parametrize(("minor", "bound"), [(12, 1.4), (13, 2.0)])
def test_the_target_of_a_step_is_that_of_the_python_that_runs(
    minor: int, bound: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(particles, "sys", SimpleNamespace(version_info=(3, minor)))
    assert particles.lines()[0].target == Target("at most", bound)


def test_the_table_is_printed_and_written_and_a_miss_is_no_failure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made_up = [
        Measurement("quick", lambda: 2500.4, 3, Target("at least", 2000)),
        Measurement("slow", lambda: 1.5, 1, Target("at most", 1.15)),
        Measurement("told", lambda: 0.25, 2),
    ]
    monkeypatch.setattr(bench, "every", lambda _: made_up)
    out = tmp_path / "figures.json"
    assert bench.main(["--out", str(out)]) == 0
    told = capsys.readouterr().out
    lines = [line.strip() for line in told.splitlines()]
    below = dict(pairwise(lines))
    assert below["quick"] == "2,500 (2,500 to 2,500), target at least 2,000: met"
    assert below["slow"] == "1.50 (1.50 to 1.50), target at most 1.15: missed"
    assert below["told"] == "0.25 (0.25 to 0.25)"
    assert "1 targets met, 1 missed" in told
    assert "figures.json" in told
    found = json.loads(out.read_text(encoding="utf-8"))
    assert found["machine"] == f"{platform.system()} {platform.machine()}"
    assert [*found["lines"].values()] == [
        {"ratio": 2500.0, "quartiles": [2500.0] * 2, "target": "at least 2,000", "verdict": "met"},
        {"ratio": 1.5, "quartiles": [1.5] * 2, "target": "at most 1.15", "verdict": "missed"},
        {"ratio": 0.25, "quartiles": [0.25] * 2, "target": "", "verdict": ""},
    ]
    assert bench.kept(out) == {"quick": 2500.0, "slow": 1.5, "told": 0.25}


def test_each_side_makes_the_fewest_steps_that_are_accurate_enough() -> None:
    for name, tolerance in ((EXAMPLES, 1e-4), ("velocity Verlet", 1e-7)):
        model = accuracy.model_of(THROW, name)
        point = accuracy.tried_steps(THROW, model, tolerance)[-1]
        assert point.error == THROW.error(model.run(point.steps)) <= tolerance
        assert THROW.error(model.run(point.steps // 2)) > tolerance
    verlet = accuracy.model_of(THROW, "velocity Verlet")
    steps, outcome = accuracy.coarsest(THROW, verlet, range(1, 65), 1e-6)
    assert outcome == verlet.run(steps)
    assert THROW.error(outcome) <= 1e-6 < THROW.error(verlet.run(steps - 1))
    (ball,) = scenes_with("bouncing ball, restitution 0.8")
    for scene in (THROW, ball):
        # The tolerance allows for some hundred roundings.
        assert scene.error(accuracy.fastest_exact(scene).run(1)) < 1e-12


def test_adaptive_needs_a_tenth_of_the_evaluations_for_a_comet() -> None:
    evaluations, _ = accuracy.lines_of_adaptive()
    assert evaluations.target is not None
    assert evaluations.target.is_met(evaluations.once())  # the count is the same on every machine


def test_lines_of_accuracy_that_pymunk_does_not_reach_are_bounds_or_extrapolated(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(accuracy, "MOST", 400)
    monkeypatch.setattr(accuracy, "lines_of_adaptive", lambda: [])
    bounds = ["a lower bound" in line.what for line in accuracy.lines()]
    assert bounds[:3] == [True] * 3  # pymunk as in its examples
    monkeypatch.setattr(accuracy, "MOST", 64 * THROW.frames)
    assert "bound" not in accuracy.line(THROW.name, None, EXAMPLES, 1).what
    monkeypatch.setattr(accuracy, "versus", lambda *_: lambda: 3.0)
    line = accuracy.line(THROW.name, None, EXAMPLES, 1, tolerance=1e-5)
    assert "pymunk's time is extrapolated to 1e-05 with its order of 1.00" in line.what
    # 64 steps per frame are not enough. With 1024, the error follows order 1, apart from a
    # hundredth of the next order.
    error = THROW.error(accuracy.model_of(THROW, EXAMPLES).run(1024))
    assert line.once() == pytest.approx(3.0 * 16.0 * error / 1e-5, rel=0.02)


@pytest.mark.parametrize("lines_of", [algebra.lines_of_vectors, algebra.lines_of_rotations])
def test_a_peer_that_is_not_there_is_named(lines_of: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(timing.importlib.util, "find_spec", lambda _: None)
    screen = io.StringIO()
    lines = lines_of(Console(file=screen))
    assert [line.what for line in lines if "geometric mean" in line.what] == []
    assert "-m pip install -r studies/peers.txt" in screen.getvalue()


@pytest.mark.parametrize("subject", [algebra.VECTORS, algebra.ROTATIONS])
@pytest.mark.parametrize("library", ["ours", "numpy"])
def test_every_statement_of_the_libraries_at_hand_can_be_timed(subject: Any, library: str) -> None:
    statements = subject[library]
    assert set(statements) <= set(subject["ours"])
    for code in statements.values():
        assert timeit.Timer(code, statements["setup"]).timeit(1) > 0.0


def names_of(setup: str) -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(setup, names)
    return names


def test_matrices_turn_and_are_undone_as_their_quaternions_and_numpys_are() -> None:
    names = names_of(algebra.SETUP)

    def alike(one: str, other: str) -> None:
        # A dozen roundings of numbers up to 4.
        assert [*eval(one, names)] == pytest.approx([*eval(other, names)], abs=1e-14)

    for first, second, *_ in algebra.RIVALS[:2]:
        alike(first, second)
    alike("m @ v", "q.rotate(v)")
    alike("m @ n", "M3.from_quaternion(q * p)")
    ours, theirs = algebra.ROTATIONS["ours"], algebra.ROTATIONS["numpy"]
    others = names_of(theirs["setup"])
    for operation in ("product", "transform", "transpose", "inverse"):
        wanted = eval(theirs[operation], others).ravel()
        assert [*eval(ours[operation], names)] == pytest.approx([*wanted], abs=1e-14)


FRAMES = [0.02, 0.01, 0.02, 0.02] * 250


def test_what_is_compared_with_the_step_is_the_same_step() -> None:
    """Operators, methods in place and local variables give the result of Particle.integrate."""
    stepped, by_operators, in_place = (PROJECTILE.particle(Particle) for _ in range(3))
    particles.steps(stepped, FRAMES)
    particles.operator_steps(by_operators, FRAMES)
    particles.in_place_steps(in_place, FRAMES)
    # 1000 roundings of numbers up to 200, also below.
    wanted = pytest.approx(tuple(stepped.position), rel=1e-11)
    assert tuple(by_operators.position) == wanted
    assert tuple(in_place.position) == wanted
    assert flight_in_numbers(PROJECTILE, FRAMES) == wanted
    forced, generated, free = (PROJECTILE.particle(chapter_5.Particle) for _ in range(3))
    particles.forced_steps(forced, FRAMES)
    particles.generator_steps(generated, FRAMES)
    particles.steps(free, FRAMES)
    assert pushed_in_numbers(*particles.PUSHED, FRAMES) == pytest.approx(
        tuple(forced.position), rel=1e-11
    )
    assert tuple(generated.position) == pytest.approx(tuple(free.position), rel=1e-11)


def test_what_a_cloth_is_compared_with_falls_in_the_same_way() -> None:
    # The sums have another order, which changes the heights by about 1e-16 per frame.
    wanted = pytest.approx(springs.steps(*springs.make_cloth(springs.DAMPING)), rel=1e-11)
    assert cloth_in_numbers(springs.DAMPING, springs.FRAME, springs.FRAMES) == wanted
    assert springs.steps(*springs.make_cloth_of_ends()) == wanted


def test_what_a_chain_is_compared_with_hangs_from_the_same_place() -> None:
    """Pymunk's tip approaches ours: with four times the frames it is a quarter as far away."""
    ours = constraints.by_direct_chain(constraints.RATE)
    off = [math.dist(constraints.by_pymunk(rate), ours) for rate in (960, 3840)]
    assert off[1] == pytest.approx(0.25 * off[0], rel=0.3)  # order 1, apart from our own error
    assert off[1] < 2e-3
    assert constraints.by_direct_net(constraints.RATE) == pytest.approx(ours, abs=1e-5)
