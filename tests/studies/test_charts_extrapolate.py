"""If pymunk does not reach a tolerance, its time is extrapolated by its order and marked."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pytest

from studies import charts
from studies.accuracy import measure
from studies.accuracy.catalog import scenes_with
from studies.accuracy.in_pymunk import EXAMPLES, at_best
from studies.accuracy.measure import Point
from studies.accuracy.results import Side, order_of, table
from studies.benchmarks import accuracy
from studies.charts.overview import draw_overview
from studies.charts.ratios import figures_of, said, told, told_ratio

ERRORS, TIMES = [0.08, 0.04, 0.02, 0.01], [1.0, 2.0, 4.0, 8.0]


def points(errors: list[float], model: str = "ours", by: str = "ours") -> list[Point]:
    """Return points whose steps double and whose times double, starting at 1 s."""
    return [Point("s", model, by, 2**i, error, 2**i, [2.0**i]) for i, error in enumerate(errors)]


THEIRS = points(ERRORS, "theirs", "pymunk")
OURS = points([1e-5])


def test_an_order_is_that_of_errors_which_fall_steadily() -> None:
    assert order_of(points([0.5, *ERRORS])) == pytest.approx(1.0)
    assert order_of(points([0.5, 0.08, 0.02, 0.005, 0.00125])) == pytest.approx(2.0)
    for errors in (
        [0.02, 0.01, 0.005],  # too few points
        [0.8, 0.4, 0.2, 0.1],  # too large to show an order
        [0.08, 0.04, 0.03, 0.01],  # not steady
        [0.08, 0.079, 0.078, 0.077],  # stalled
        [0.08, 0.04, 0.02, 0.0],
        [math.inf, 0.04, 0.02, 0.01],
    ):
        assert order_of(points(errors)) is None


def test_a_time_is_extrapolated_by_the_order_and_marked() -> None:
    loose, middle, tight = table([*OURS, *THEIRS])
    assert (loose.is_extrapolated, loose.ratio) == (False, pytest.approx(8.0))
    # A hundredth of the error takes a hundred times as many steps, which are equally fast.
    assert middle.is_extrapolated
    assert middle.pymunk.time == pytest.approx(800.0)
    assert middle.ratio == pytest.approx(800.0)
    assert told(middle.pymunk) == "theirs, 800,000 ms (extrapolated, order 1.00)"
    assert told_ratio(figures_of([middle])[0]) == "~800"
    (sentence,) = said([*OURS, *THEIRS], 1e-4)
    assert sentence.endswith("pymunk 800 times as long, extrapolated (theirs)")
    assert not tight.is_extrapolated  # a ten-thousandth is too far
    assert tight.pymunk.time is None


def test_only_pymunk_s_time_is_extrapolated_and_only_where_none_of_its_models_gets_there() -> None:
    assert table([*points(ERRORS), *THEIRS])[1].ours.time is None
    fast = points([1e-6], "fast", "pymunk")
    assert table([*OURS, *THEIRS, *fast])[1].pymunk == Side("fast", 1.0, 1.0, never=False)


def test_the_least_time_of_pymunk_s_models_counts() -> None:
    near = points([error / 2.0 for error in ERRORS], "near", "pymunk")
    side = table([*OURS, *THEIRS, *near])[1].pymunk
    assert (side.model, side.time) == ("near", pytest.approx(400.0))


def test_what_is_extrapolated_is_drawn(tmp_path: Path) -> None:
    draw_overview(table([*OURS, *THEIRS]), tmp_path / "with.png")
    draw_overview(table([*OURS, *THEIRS[:3]]), tmp_path / "without.png")
    assert (tmp_path / "with.png").read_bytes() != (tmp_path / "without.png").read_bytes()


def test_a_line_of_the_benchmarks_is_extrapolated_by_the_order(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (scene,) = scenes_with("projectile")
    monkeypatch.setattr(accuracy, "MOST", 64 * scene.frames)
    monkeypatch.setattr(accuracy, "versus", lambda *_: lambda: 3.0)
    line = accuracy.line(scene.name, None, EXAMPLES, 1, tolerance=1e-5)
    assert "pymunk's time is extrapolated to 1e-05 with its order of 1.00" in line.what
    # 64 steps per frame are not enough. With 1024, the error follows order 1, apart from a
    # hundredth of the next order.
    error = scene.error(accuracy.model_of(scene, EXAMPLES).run(1024))
    assert line.once() == pytest.approx(3.0 * 16.0 * error / 1e-5, rel=0.02)


def test_make_charts_says_what_the_sign_means(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With made-up errors and times, so that the tolerances do not depend on the machine."""
    name = "double pendulum"
    errors = {"multistep, order 4": [1e-5], at_best(2): ERRORS}
    measured = [
        Point(name, model, "pymunk" if model == at_best(2) else "ours", 2**i, error, 2**i)
        for model, found in errors.items()
        for i, error in enumerate(found)
    ]
    monkeypatch.setattr(measure, "explore", lambda *_: measured)
    monkeypatch.setattr(measure, "seconds_of", lambda _, steps: 1e-3 * steps)
    assert charts.main(["--quick", "--scene", name, "--out", str(tmp_path)]) == 0
    assert "~: pymunk's time is extrapolated" in capsys.readouterr().out
    with (tmp_path / "table.csv").open(encoding="utf-8") as file:
        (extrapolated,) = [row for row in csv.reader(file) if row[-1].startswith("~")]
    assert extrapolated[1] == "0.0001"
    assert "(extrapolated, order 1.00)" in extrapolated[-2]
