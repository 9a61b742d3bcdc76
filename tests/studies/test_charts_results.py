"""What is made of measured points: times to a tolerance, ratios, the command's files, resuming."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any

import pytest

from plots import drawing
from plots.drawing import COLORS
from studies import charts
from studies.accuracy import measure
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import at_best
from studies.accuracy.measure import Measured, Point, load, save
from studies.accuracy.results import Side, front, order_of, stalls, table, time_to
from studies.accuracy.scene import Model, Scene
from studies.charts.overview import draw_overview
from studies.charts.page import LOOKS, looks
from studies.charts.ratios import figures_of, precise, said, told, told_ratio

SCENES = {scene.name: scene for scene in scenes_with("")}


def points(
    errors: list[float], times: list[float] | None = None, model: str = "a", by: str = "ours"
) -> list[Point]:
    """Return points whose steps double, and whose times do so too unless they are given."""
    times = times or [2.0**i for i in range(len(errors))]
    pairs = enumerate(zip(errors, times, strict=True))
    return [Point("s", model, by, 2**i, error, 1, [time]) for i, (error, time) in pairs]


FALLING = [0.08, 0.04, 0.02, 0.01]
OURS = points([1e-5])
THEIRS = points(FALLING, model="theirs", by="pymunk")


@pytest.mark.parametrize(
    ("errors", "times", "tolerance", "wanted"),
    [
        ([1e-1, 1e-2, 1e-3], [1.0, 2.0, 4.0], 10.0**-2.5, 2.0 * math.sqrt(2.0)),
        ([1e-1, 1e-2, 1e-3], [1.0, 2.0, 4.0], 1.0, 1.0),
        ([1e-1, 1e-2, 1e-3], [1.0, 2.0, 4.0], 1e-4, None),
        ([1e-1, 1e-9, 1e-2, 1e-3], [1.0, 2.0, 4.0, 8.0], 1e-3, 8.0),  # 1e-9 is luck
        ([math.inf, 1e-5], [1.0, 2.0], 1e-4, 2.0),
        ([1e-1, 1e-3, 1e-4], [1.0, 5.0, 2.0], 1e-2, 2.0),  # a finer run takes less time
    ],
)
def test_the_time_to_a_tolerance_is_read_between_two_points(
    errors: list[float], times: list[float], tolerance: float, wanted: float | None
) -> None:
    found = time_to(points(errors, times), tolerance)
    assert found == (wanted if wanted is None else pytest.approx(wanted))


@pytest.mark.parametrize(
    ("errors", "wanted"),
    [
        (FALLING, False),
        ([0.08, 0.07, 0.06, 0.041], True),
        ([math.inf] * 4, False),
        ([0.5] * 4, False),  # the error is too large to show an order
        ([0.1, 0.1], False),  # too few points
    ],
)
def test_what_hardly_gets_nearer_with_eight_times_the_steps_stalls(
    errors: list[float], *, wanted: bool
) -> None:
    assert stalls(points(errors)) == wanted


def test_a_side_whose_models_all_stall_never_gets_there() -> None:
    stalled = points([0.05] * 4, [9.0] * 4, by="pymunk")
    (never, *_) = table([*OURS, *stalled])
    assert never.pymunk.never
    assert told_ratio(figures_of([never])[0]) == "pymunk never"
    others = points([0.08, 0.04], model="b", by="pymunk") + points([0.7], [5.0], "c", "pymunk")
    side = table([*OURS, *stalled, *others])[0].pymunk
    assert not side.never
    assert side.longest == 2.0  # model b might reach it, and has been run for at most 2 s


@pytest.mark.parametrize(
    ("errors", "wanted"),
    [
        ([0.5, *FALLING], 1.0),
        ([0.02, 0.01, 0.005], None),  # too few points
        ([0.8, 0.4, 0.2, 0.1], None),  # too large to show an order
        ([0.08, 0.04, 0.03, 0.01], None),  # not steady
        ([0.08, 0.04, 0.02, 0.0], None),
        ([math.inf, 0.04, 0.02, 0.01], None),
    ],
)
def test_an_order_is_that_of_errors_which_fall_steadily(
    errors: list[float], wanted: float | None
) -> None:
    assert order_of(points(errors)) == (wanted if wanted is None else pytest.approx(wanted))


def test_the_best_and_the_front_are_the_fastest_at_each_error() -> None:
    slow, fast = points([1e-2, 1e-8], [3.0, 9.0], "slow"), points([1e-3, 1e-4], [2.0, 7.0], "fast")
    every = [*slow, *fast, *points([1e-1, 1e-2], [1.0, 8.0], "theirs", "pymunk")]
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


def test_a_time_of_pymunk_is_extrapolated_by_its_order_and_marked(tmp_path: Path) -> None:
    loose, middle, tight = table([*OURS, *THEIRS])
    assert (loose.is_extrapolated, loose.ratio) == (False, pytest.approx(8.0))
    # A hundredth of the error takes a hundred times as many steps, which are equally fast.
    assert middle.is_extrapolated
    assert middle.ratio == pytest.approx(800.0)
    assert told(middle.pymunk) == "theirs, 800,000 ms (extrapolated, order 1.00)"
    assert told_ratio(figures_of([middle])[0]) == "~800"
    (sentence,) = said([*OURS, *THEIRS], 1e-4)
    assert sentence.endswith("pymunk 800 times as long, extrapolated (theirs)")
    assert tight.pymunk.time is None  # a ten-thousandth is too far
    draw_overview([loose, middle, tight], tmp_path / "with.png")
    draw_overview(table([*OURS, *THEIRS[:3]]), tmp_path / "without.png")
    assert (tmp_path / "with.png").read_bytes() != (tmp_path / "without.png").read_bytes()


def test_only_pymunk_is_extrapolated_and_its_fastest_model_counts() -> None:
    assert table([*points(FALLING), *THEIRS])[1].ours.time is None
    fast = points([1e-6], model="fast", by="pymunk")
    assert table([*OURS, *THEIRS, *fast])[1].pymunk == Side("fast", 1.0, 1.0, never=False)
    near = points([error / 2.0 for error in FALLING], model="near", by="pymunk")
    side = table([*OURS, *THEIRS, *near])[1].pymunk
    assert (side.model, side.time) == ("near", pytest.approx(400.0))


def test_what_was_measured_is_kept_unless_the_code_changed(tmp_path: Path) -> None:
    measured, file = Measured(points([1e-1, math.inf]), 1), tmp_path / "kept.json"
    assert load(file, "these") is None
    save(measured, file, "these")
    assert load(file, "these") == measured
    assert load(file, "those") is None
    file.write_text("{", encoding="utf-8")
    assert load(file, "these") is None


def test_a_model_looks_alike_in_every_chart_and_no_other_model_does(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert looks().keys() == {model.name for scene in SCENES.values() for model in scene.models}
    for scene in SCENES.values():
        models = {model.name for model in scene.models}
        assert len({looks()[model] for model in models}) == len(models), scene.name
        for step in COLORS.keys() & models:
            color, symbol = looks()[step]
            assert getattr(drawing, color.upper()) == COLORS[step], "as in the other pictures"
            assert symbol == "circle"
    monkeypatch.setitem(LOOKS, "pymunk", [("black", "times")])  # fewer than there are models
    assert looks.__wrapped__()["pymunk, asleep"] == ("black", "times")


def test_make_charts_writes_its_files_and_says_what_was_extrapolated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With made-up errors and times, so that the tolerances do not depend on the machine."""
    name = "double pendulum"
    errors = {"multistep, order 4": [1e-5], at_best(2): FALLING}
    measured = [
        Point(name, model, "pymunk" if model == at_best(2) else "ours", 2**i, error, 2**i)
        for model, found in errors.items()
        for i, error in enumerate(found)
    ]
    monkeypatch.setattr(measure, "explore", lambda *_: measured)
    monkeypatch.setattr(measure, "seconds_of", lambda _, steps: 1e-3 * steps)
    assert charts.main(["--quick", "--scene", name, "--out", str(tmp_path)]) == 0
    told = capsys.readouterr().out
    assert "~: pymunk's time is extrapolated" in told
    assert "earlier run" not in told
    with (tmp_path / "table.csv").open(encoding="utf-8") as file:
        (extrapolated,) = [row for row in csv.reader(file) if row[-1].startswith("~")]
    assert extrapolated[1] == "0.0001"
    assert "(extrapolated, order 1.00)" in extrapolated[-2]
    with (tmp_path / "points.csv").open(encoding="utf-8") as file:
        assert {row["model"] for row in csv.DictReader(file)} == {*errors}
    assert (tmp_path / "overview.png").stat().st_size > 10_000


class KilledError(Exception):
    """The run was killed here."""


def test_an_interrupted_run_loses_neither_a_scene_nor_the_runs_of_a_round(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
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
    for _ in range(2):
        with pytest.raises(KilledError):
            charts.main(arguments)
    assert charts.main(arguments) == 0
    first, second, again, _ = explored
    assert first != second == again, "the first scene is measured once, the second one again"
    kept = (tmp_path / "measured.json").read_bytes()
    found = json.loads(kept)["points"]
    assert len(timed) == len(found), "no point is timed twice in a round"
    assert all(len(point["times"]) == 1 for point in found)
    capsys.readouterr()
    assert charts.main(arguments) == 0
    assert "resuming an earlier run after 1 of 1 rounds" in capsys.readouterr().out
    assert (tmp_path / "measured.json").read_bytes() == kept


def test_a_scene_that_is_not_there_is_refused_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        charts.main(["--scene", "a cat"])
    assert "must be part of one of these names, got 'a cat': projectile" in capsys.readouterr().err
