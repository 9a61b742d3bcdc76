"""Speed against accuracy: exact solutions, orders of errors, charts, and resumed runs."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from ch07_constraints.going_further.angle_pendulum import AnglePendulum
from plots import drawing
from plots.drawing import COLORS, slope
from scenes.clock import RATE
from scenes.dropped_balls import DroppedBalls
from studies import charts, choose
from studies.accuracy import measure
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import BEST, EXAMPLES, at_best
from studies.accuracy.measure import Measured, Point, load, save
from studies.accuracy.results import front, stalls, table, time_to
from studies.accuracy.scene import Model, Outcome, Scene
from studies.charts.page import looks
from studies.charts.ratios import figures_of, precise, told, told_ratio
from studies.choose import runs
from studies.choose.report import told_of

SCENES = {scene.name: scene for scene in scenes_with("")}
G = 9.81


def model_of(scene: Scene, name: str) -> Model:
    return next(model for model in scene.models if model.name == name)


def error_of(scene: Scene, name: str, steps: int = 1) -> float:
    return scene.error(model_of(scene, name).run(steps))


def rates_of(k: float, c: float) -> Callable[[float, list[float]], list[float]]:
    return lambda _, s: [s[1], -k * s[0] - c * s[1]]


SPRING = "spring, k = {} N/m, c = {} N s/m"
ODES: dict[str, tuple[Callable[..., list[float]], list[float], Callable[..., list[float]]]] = {
    "projectile with linear drag": (
        lambda _, s: [s[2], s[3], math.log(0.6) * s[2], -G + math.log(0.6) * s[3]],
        [0.0, 1.5, 20.0, 20.0],
        lambda s: [s[0], s[1]],
    ),
    "fall with quadratic drag": (
        lambda _, s: [s[1], -G - 0.05 * abs(s[1]) * s[1]],
        [0.0, 0.0],
        lambda s: [0.0, s[0]],
    ),
    "orbit of eccentricity 0.5": (
        lambda _, s: [s[2], s[3], *(-x / math.hypot(s[0], s[1]) ** 3 for x in s[:2])],
        [0.5, 0.0, 0.0, math.sqrt(3.0)],
        lambda s: [s[0], s[1]],
    ),
    "orbit of eccentricity 0.9": (
        lambda _, s: [
            *(s[2], s[3]),
            *(-((2.0 * math.pi) ** 2) * x / math.hypot(s[0], s[1]) ** 3 for x in s[:2]),
        ],
        [0.1, 0.0, 0.0, 2.0 * math.pi * math.sqrt(19.0)],
        lambda s: [s[0], s[1]],
    ),
    "floating block": (
        lambda _, s: [s[1], -G + 1000.0 * 0.001 * G / 0.5 * (0.05 - s[0]) / 0.1],
        [0.04, 0.0],
        lambda s: [0.0, s[0]],
    ),
    SPRING.format("10", "0.632"): (
        rates_of(10.0, 0.2 * math.sqrt(10.0)),
        [1.0, 0.0],
        lambda s: [s[0], 0.0],
    ),
    SPRING.format("100", "2"): (rates_of(100.0, 2.0), [1.0, 0.0], lambda s: [s[0], 0.0]),
    SPRING.format("10000", "20"): (rates_of(1e4, 20.0), [1.0, 0.0], lambda s: [s[0], 0.0]),
}


@pytest.mark.parametrize("name", ODES)
def test_the_truth_of_a_scene_is_that_of_its_equation(name: str) -> None:
    rates, start, place = ODES[name]
    times = numpy.linspace(0.1, 1.0, 10) * SCENES[name].frames / RATE
    found = solve_ivp(
        rates, (0.0, times[-1]), start, method="DOP853", t_eval=times, rtol=1e-12, atol=1e-13
    )
    for time, state in zip(times, found.y.T, strict=True):
        # SciPy's own error is 1e-12 per step. It adds up over some hundred steps along an orbit.
        assert SCENES[name].truth(time) == pytest.approx(place(state), abs=2e-9)


def test_the_truth_of_bounces_is_that_of_drops_and_of_momentum() -> None:
    balls = DroppedBalls((2.1,), 0.8, radius=0.1)
    first = math.sqrt(2.0 * 2.0 / 10.0)
    # The ball rises for 0.8 of the time of the fall, to 0.64 of its height.
    (top,), (down,) = balls.heights_at([1.8 * first, 2.6 * first])
    assert top == pytest.approx(0.64 * 2.0 + 0.1, abs=1e-12)
    assert down == pytest.approx(0.1, abs=1e-12)
    two = DroppedBalls((1.1, 1.3 + 1e-9), 0.9, (1.0, 0.1), 0.8, 0.1)
    speed = math.sqrt(2.0 * 10.0)
    after = 0.01
    _, upper = two.heights_at([speed / 10.0 + after])[0]
    # Exercise 7.3: 0.9 of the speed upward meets the speed downward, in their common frame.
    gone = (1.0 * 0.9 - 0.1) / 1.1 + 0.8 * 1.0 / 1.1 * 1.9
    # A gap of 1e-9 m closes in 1e-10 s.
    assert upper == pytest.approx(0.3 + speed * gone * after - 5.0 * after**2, abs=1e-8)


@pytest.mark.parametrize("name", SCENES)
def test_closed_forms_and_exact_ways_are_exact(name: str) -> None:
    ways = {"closed form", "exact steps", "time division", "its impacts alone"}
    exact = ways & {model.name for model in SCENES[name].models}
    for way in exact:
        # The tolerance allows for some hundred roundings, at k t = 1e3 rad for the stiffest spring.
        assert error_of(SCENES[name], way) < 1e-12


@pytest.mark.parametrize(
    ("scene", "model", "order"),
    [
        ("projectile with linear drag", "explicit Euler", 1),
        ("projectile with linear drag", "damping in the particle", 1),
        ("projectile with linear drag", "leapfrog", 1),  # drag depends on the velocity
        ("projectile with linear drag", "velocity Verlet", 2),
        ("projectile with linear drag", EXAMPLES, 1),
        ("projectile with linear drag", BEST, 2),
        ("fall with quadratic drag", EXAMPLES, 1),
        ("fall with quadratic drag", BEST, 2),
        ("orbit of eccentricity 0.5", BEST, 2),
        ("floating block", BEST, 2),
        ("orbit of eccentricity 0.5", "leapfrog", 2),
        ("orbit of eccentricity 0.5", "velocity Verlet", 2),
        ("floating block", "Runge-Kutta 4", 4),
        (SPRING.format("100", "2"), "Runge-Kutta 4", 4),
        (SPRING.format("100", "2"), "trapezoidal rule", 2),
        (SPRING.format("100", "2"), "backward Euler", 1),
        (SPRING.format("100", "2"), EXAMPLES, 1),
        (SPRING.format("100", "2"), BEST, 2),
        (SPRING.format("10000", "20"), BEST, 2),
        (SPRING.format("100", "2"), "pymunk, force by hand", 1),
        ("pendulum from horizontal", "by its angle, Runge-Kutta 4", 4),
        ("pendulum from horizontal", "direct chain", 2),
        ("pendulum from horizontal", EXAMPLES, 1),
        ("pendulum from horizontal", at_best(1), 2),
    ],
)
def test_errors_fall_by_the_order_of_the_model(scene: str, model: str, order: int) -> None:
    steps = (4, 8, 16) if order == 4 else (16, 32, 64)
    errors = [error_of(SCENES[scene], model, count) for count in steps]
    # The next order contributes at most a twentieth.
    assert slope([1.0 / count for count in steps], errors) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("scene", ["orbit of eccentricity 0.9", SPRING.format("10000", "20")])
def test_the_error_of_the_adaptive_model_falls_with_its_tolerance(scene: str) -> None:
    model = model_of(SCENES[scene], "adaptive")
    assert model.takes_tolerance
    assert [1.0 / finer for finer in model.steps[:3]] == [0.1, 0.01, 0.001]
    errors = [error_of(SCENES[scene], "adaptive", 10**n) for n in range(6, 12)]
    # The errors are proportional to the tolerance, except that frames cut steps short.
    assert slope([10.0**-n for n in range(6, 12)], errors) == pytest.approx(1.0, abs=0.2)


def test_work_is_what_was_worked_out() -> None:
    orbit = SCENES["orbit of eccentricity 0.5"]
    asked = {"explicit Euler": 1, "semi-implicit Euler": 1, "leapfrog": 1, "velocity Verlet": 2}
    for name, times in (asked | {"Runge-Kutta 4": 4, EXAMPLES: 1, BEST: 1}).items():
        assert model_of(orbit, name).run(2).work == 2 * times * orbit.frames
    assert model_of(orbit, "adaptive").run(1).work == 7 * orbit.frames  # at 1 m, one step per frame
    ball = SCENES["bouncing ball, restitution 0.8"]
    # From 2 m the impacts are at 0.632 s and after flights of 1.012, 0.810, ... s: three in 3 s.
    assert model_of(ball, "time division").run(1).work == ball.frames + 3


def test_an_angle_pendulum_refuses_what_is_none() -> None:
    for bad in ((0.0, 1.0), (1.0, math.nan), (1.0, 1.0, math.inf), (1.0, 1.0, 0.0, 0.0)):
        with pytest.raises(ValueError, match="must be"):
            AnglePendulum(*bad)
    with pytest.raises(ValueError, match="duration must be positive"):
        AnglePendulum(1.0, 1.0).step(0.0)


def test_what_breaks_off_or_is_no_number_is_no_answer() -> None:
    def run(_: int) -> Outcome:
        return Outcome([(0.0,), (math.nan,)], 2)

    scene = Scene("none", 2, 1.0, lambda _: (0.0,), [Model("nan", run)])
    assert scene.error(run(1)) == math.inf


def points(
    errors: list[float], times: list[float], model: str = "a", by: str = "ours"
) -> list[Point]:
    pairs = enumerate(zip(errors, times, strict=True))
    return [Point("s", model, by, 2**i, error, 1, [time]) for i, (error, time) in pairs]


def test_the_time_to_a_tolerance_is_read_between_two_points() -> None:
    run = points([1e-1, 1e-2, 1e-3], [1.0, 2.0, 4.0])
    assert time_to(run, 1e-2) == pytest.approx(2.0)
    assert time_to(run, 10.0**-2.5) == pytest.approx(2.0 * math.sqrt(2.0))
    assert time_to(run, 1.0) == 1.0
    assert time_to(run, 1e-4) is None
    lucky = points([1e-1, 1e-9, 1e-2, 1e-3], [1.0, 2.0, 4.0, 8.0])
    assert time_to(lucky, 1e-3) == pytest.approx(8.0)
    broken = points([math.inf, 1e-5], [1.0, 2.0])
    assert time_to(broken, 1e-4) == 2.0


def test_a_finer_run_that_takes_less_time_counts() -> None:
    assert time_to(points([1e-1, 1e-3, 1e-4], [1.0, 5.0, 2.0]), 1e-2) == 2.0


def test_what_does_not_get_nearer_with_eight_times_the_steps_never_gets_there() -> None:
    falling, flat = [0.08, 0.04, 0.02, 0.01], [0.08, 0.05, 0.051, 0.052]
    times = [1.0, 2.0, 4.0, 8.0]
    assert not stalls(points(falling, times))
    assert stalls(points(flat, times))
    assert stalls(points([0.08, 0.07, 0.06, 0.041], times))
    assert not stalls(points([math.inf] * 4, times))
    assert not stalls(points([0.5] * 4, times))  # the error is too large to show an order
    assert not stalls(points([0.1, 0.1], times[:2]))  # too few points
    ours = points([1e-5], [1.0])
    assert table([*ours, *points([0.05] * 4, times, "theirs", "pymunk")])[0].pymunk.never
    theirs = points([0.05] * 4, [9.0] * 4, "a", "pymunk")
    theirs += points([0.08, 0.04], times[:2], "b", "pymunk") + points([0.7], [5.0], "c", "pymunk")
    side = table([*ours, *theirs])[0].pymunk
    assert not side.never
    assert side.longest == 2.0  # model b might reach it, and has been run for at most 2 s


def test_the_best_and_the_front_are_the_fastest_at_each_error() -> None:
    slow, fast = points([1e-2, 1e-8], [3.0, 9.0], "slow"), points([1e-3, 1e-4], [2.0, 7.0], "fast")
    theirs = points([1e-1, 1e-2], [1.0, 8.0], "theirs", "pymunk")
    every = [*slow, *fast, *theirs]
    assert [(p.model, p.steps) for p in front(every)] == [
        *(("theirs", 1), ("fast", 1), ("fast", 2), ("slow", 2))
    ]
    loose, middle, tight = table(every)
    assert (loose.ours.model, loose.ours.time) == ("fast", 2.0)
    assert (loose.ratio, middle.ratio) == (pytest.approx(4.0), None)
    assert loose.bounds == (loose.ratio, loose.ratio)
    assert (tight.ours.model, tight.pymunk.longest) == ("slow", 8.0)
    # Pymunk took 8 s without reaching 1e-6. Ours took 9 s, minus what it did not need for 1e-6.
    assert tight.ours.time is not None
    assert tight.bounds == (8.0 / tight.ours.time, math.inf)
    assert [told_ratio(figure, precise) for figure in figures_of([loose, tight])] == [
        *("4", f"> {tight.bounds[0]:.3g}")
    ]
    ahead = table([*points([1e-1, 1e-2], [1.0, 8.0]), *points([1e-9], [0.5], "b", "pymunk")])[2]
    assert told_ratio(figures_of([ahead])[0], precise) == "< 0.0625"
    assert told(ahead.ours) == "not within 8,000 ms"


def test_what_was_measured_is_kept_unless_the_code_changed(tmp_path: Path) -> None:
    measured = Measured(points([1e-1, math.inf], [1.0, 2.0]), 1)
    save(measured, tmp_path / "kept.json", "these")
    assert load(tmp_path / "kept.json", "these") == measured
    assert load(tmp_path / "kept.json", "those") is None
    (tmp_path / "kept.json").write_text("{", encoding="utf-8")
    assert load(tmp_path / "kept.json", "these") is None
    assert load(tmp_path / "none.json", "these") is None


@pytest.mark.parametrize("name", SCENES)
def test_no_two_models_of_a_scene_are_drawn_alike(name: str) -> None:
    models = {model.name for model in SCENES[name].models}
    assert len({looks()[model] for model in models}) == len(models)
    for step in COLORS.keys() & models:
        color, symbol = looks()[step]
        assert getattr(drawing, color.upper()) == COLORS[step], "as in the other pictures"
        assert symbol == "circle"


def test_charts_are_drawn_and_a_run_goes_on_where_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(charts, "QUICK", (1, 1e-3, 1e-3))
    arguments = ["--quick", "--scene", "k = 100 ", "--out", str(tmp_path)]
    assert charts.main(arguments) == 0
    first = (tmp_path / "measured.json").read_bytes()
    with (tmp_path / "points.csv").open(encoding="utf-8") as file:
        rows = [*csv.DictReader(file)]
    names = {model.name for model in SCENES[SPRING.format("100", "2")].models}
    assert {row["model"] for row in rows} == names
    assert not [*tmp_path.glob("spring*")]
    with (tmp_path / "table.csv").open(encoding="utf-8") as file:
        assert len([*csv.reader(file)]) == 1 + 2 * 3  # for steps and for better models
    assert (tmp_path / "overview.png").stat().st_size > 10_000
    assert "earlier run" not in capsys.readouterr().out
    assert charts.main(arguments) == 0
    assert "resuming an earlier run after 1 of 1 rounds" in capsys.readouterr().out
    assert (tmp_path / "measured.json").read_bytes() == first


class KilledError(Exception):
    """The run was killed here."""


def test_an_interrupted_run_loses_neither_a_scene_nor_the_runs_of_a_round(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(charts, "QUICK", (1, 1e-3, 1e-3))
    monkeypatch.setattr(measure, "SAVED_EVERY", 0.0)
    explored: list[str] = []
    timed: list[tuple[str, int]] = []
    stops = iter([False, True, False])

    def explore(scene: Scene, *others: Any) -> list[Point]:
        explored.append(scene.name)
        if next(stops):
            raise KilledError
        return real(scene, *others)

    def seconds_of(model: Model, steps: int) -> float:
        if len(timed) == 3 and explored[-1]:
            explored.append("")
            raise KilledError
        timed.append((model.name, steps))
        return 1e-4

    real = measure.explore
    monkeypatch.setattr(measure, "explore", explore)
    monkeypatch.setattr(measure, "seconds_of", seconds_of)
    arguments = ["--quick", "--scene", "bouncing ball", "--out", str(tmp_path)]
    with pytest.raises(KilledError):
        charts.main(arguments)
    with pytest.raises(KilledError):
        charts.main(arguments)
    assert charts.main(arguments) == 0
    first, second, again, _ = explored
    assert first != second == again, "the first scene is measured once, the second one again"
    points = json.loads((tmp_path / "measured.json").read_text(encoding="utf-8"))["points"]
    assert len(timed) == len(points), "no point is timed twice in a round"
    assert all(len(point["times"]) == 1 for point in points)


def test_a_scene_that_is_not_there_is_refused_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        charts.main(["--scene", "a cat"])
    assert "must be part of one of these names, got 'a cat': projectile" in capsys.readouterr().err


def test_the_cheapest_model_that_will_do_is_named_with_a_cheaper_one_that_will_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 0.01)
    assert choose.main(["elastic", "--tolerance", "1e-5"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("elastic pendulum: 2 s, error at most 1e-05 of the scene's size")
    # Which model is the cheapest depends on the machine.
    assert lines[1].startswith("  cheapest:     ")
    told = " ".join(lines[2:]).partition("pymunk: ")
    assert told[0].split()[:2] == ["next", "cheaper:"]
    assert told[0].strip().endswith((": not accurate enough", ": accurate only by chance"))
    assert told[2].strip().startswith(("pymunk at its best", "not accurate enough"))


def test_a_model_that_takes_a_tolerance_is_told_with_it() -> None:
    orbit = SCENES["orbit of eccentricity 0.9"]
    point = Point(orbit.name, "adaptive", "ours", 10**6, 3e-5, 834, [1e-3])
    told = told_of(orbit, 1e-4, point)
    assert told.startswith("adaptive, tolerance 1e-06: 1 ms")
    assert "834 evaluations" in told


def test_where_nothing_will_do_the_command_fails(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(runs, "SLOWEST", 1e-3)
    assert choose.main(["k = 100 ", "--tolerance", "1e-20"]) == 1
    assert "cheapest:     none of our models is accurate enough" in capsys.readouterr().out
    for bad in ("0", "-1", "nan", "inf"):
        with pytest.raises(SystemExit):
            choose.main(["rope", "--tolerance", bad])
        assert "must be positive and finite" in capsys.readouterr().err
