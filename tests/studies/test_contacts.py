"""The study of contact solvers: its errors, its table, its command and the numbers it keeps."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from matplotlib import pyplot

from plots.ch07_constraints.stacks import STYLES, contact_solvers
from plots.drawing import slope
from studies import contacts
from studies.accuracy.measure import Point
from studies.contacts import scenes
from studies.contacts.scenes import BOOK, IMPULSES, NET, ROPE, SMALL, STACK, SWING, named

SCENES = {scene.name: scene for scene in scenes.scenes()}


def error_of(scene: str, solver: str, steps: int) -> float:
    found = next(model for model in SCENES[scene].models if model.name == solver)
    return SCENES[scene].error(found.run(steps))


def test_scenes_start_without_an_error_and_measure_what_is_made_wrong() -> None:
    spheres, error = scenes.stack(10)
    assert error(0.1) == 0.0
    spheres.particles[3].position.y -= 0.25  # a quarter of a diameter into the one below
    assert error(0.1) == pytest.approx(0.25)
    joints, error = scenes.rope(10)
    assert error(0.1) == pytest.approx(0.0, abs=1e-15)
    joints.particles[-1].position.y -= 0.05  # of 1 m
    assert error(0.1) == pytest.approx(0.05)
    swing, error = scenes.swinging()
    # Ten joints of 1 kg, the i-th at i * 0.1 m (1 - cos 60) above its lowest point.
    fallen = 10.0 * sum(0.1 * i * 0.5 for i in range(1, 11))
    swing.particles[-1].velocity.x = 2.0  # 2 J
    assert error(0.0) == pytest.approx(2.0 / fallen)


def test_free_fall_keeps_the_energy_that_is_read_halfway() -> None:
    """After n steps v = g n h, and the middle of the last step is v^2 / 2g below the start."""
    (swing, error), h, n = scenes.swinging(), 0.01, 30
    for particle in swing.particles:
        particle.velocity.y = -10.0 * n * h
        particle.position.y -= 10.0 * h * h * n * (n + 1) / 2
    assert error(h) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("scene", "solver"),
    [
        (named(STACK, 1), SMALL),
        (named(ROPE, 1), SMALL),
        (named(ROPE, 1), IMPULSES),
        (named(ROPE, 1), BOOK),
    ],
)
def test_errors_at_rest_fall_with_the_square_of_the_step(scene: str, solver: str) -> None:
    """What gravity moves a body by in a step, g h^2, is what has to be corrected."""
    errors = [error_of(scene, solver, steps) for steps in (4, 8)]
    assert slope([2.0, 1.0], errors) == pytest.approx(2.0, abs=0.25)


def test_a_net_keeps_a_rope_at_any_mass_ratio() -> None:
    assert error_of(named(ROPE, 1000), NET, 1) < 1e-12
    assert error_of(f"{SWING}, stretch", NET, 1) < 1e-10


def test_the_committed_points_are_those_of_this_code() -> None:
    """The errors, which are the same on every machine; those above 1 may depend on rounding."""
    stored = json.loads(scenes.FILE.read_text(encoding="utf-8"))["points"]
    points = {(scene, model, steps): error for scene, model, _, steps, error, _ in stored}
    for scene in SCENES.values():
        for model in scene.models:
            wanted = points[scene.name, model.name, 1]
            if 1e-9 < wanted < 1.0:
                assert error_of(scene.name, model.name, 1) == pytest.approx(wanted, rel=6e-3)


def test_the_table_has_the_time_that_is_needed_or_a_dash(tmp_path: Path) -> None:
    """On logarithmic axes, 1e-2 lies halfway from 1e-1 to 1e-3. Times are medians per frame."""
    scene, file = named(STACK, 1), tmp_path / "points.json"
    points = [
        Point(scene, BOOK, "the book", 1, 1e-1, 0, [0.12]),
        Point(scene, BOOK, "the book", 2, 1e-3, 0, [0.06, 0.48, 6.0]),
        Point(scene, IMPULSES, "ours", 1, 5.4321e-3, 0, [0.06]),
    ]
    scenes.keep(points, file)
    picture = contact_solvers(file)
    assert [*STYLES] == [*scenes.SOLVERS]
    assert picture.columns == ("scene", "error", *scenes.SOLVERS)
    rows = {row[1]: row[2:] for row in picture.rows}
    assert rows["0.01"] == ("4", "-", "1", "-", "-")
    assert rows["0.001"] == ("8", "-", "-", "-", "-")
    stored = json.loads(file.read_text(encoding="utf-8"))["points"]
    assert stored[2] == [scene, IMPULSES, "ours", 1, 5.43e-3, 1.0]
    pyplot.close(picture.figure)


def test_the_command_prints_a_table_and_draws(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    few = [SCENES[named(STACK, 1)], SCENES[named(ROPE, 1)]]
    monkeypatch.setattr(scenes, "scenes", lambda: few)
    monkeypatch.setattr(contacts, "QUICK", (1, 1e-3))
    monkeypatch.setattr(scenes, "FILE", tmp_path / "not stored.json")
    assert contacts.main(["--quick", "--out", str(tmp_path)]) == 0
    told = capsys.readouterr().out
    assert "Time in ms per frame" in told
    assert told.count("stack, ratio 1 ") == len(scenes.TOLERANCES)
    assert "contact_solvers.png" in told
    assert (tmp_path / "contact_solvers.png").stat().st_size > 20_000
    stored = json.loads((tmp_path / "points.json").read_text(encoding="utf-8"))["points"]
    assert {solver for _, solver, *_ in stored} == {*scenes.SOLVERS}
    assert not (tmp_path / "not stored.json").exists()
    pyplot.close("all")
