"""Plots of engines other than the reference, drawn by the command: it says what is wrong."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from made import made_stubs
from plots.draw import plots_of
from studied import study

CHAPTERS = [chapter.name for chapter in load_chapters()]


def plot(
    engine: str | Path, out: Path, chapter: str, only: tuple[str, ...] = ()
) -> CompletedProcess[str]:
    """Draw the plots of a chapter with an engine, or only those that ``only`` names."""
    number = str(int(chapter[2:4]))
    options = ("--chapter", number, "--engine", str(engine), "--out", str(out))
    return study("draw", *options, package="plots", only=only)


def engine_with(chapter: str, added: dict[str, str], at: Path) -> Path:
    """Return a copy of the reference with lines appended to some modules of a chapter."""
    copy_tree(ROOT / "solutions", at / "engine")
    for module, lines in added.items():
        with (at / "engine" / chapter / f"{module}.py").open("a", encoding="utf-8") as file:
            file.write(f"\n\n{lines}\n")
    return at / "engine"


def series(out: Path, chapter: str, name: str, column: int) -> list[str]:
    """Return the different values in a column of the table beside a plot."""
    with (out / chapter / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return [*dict.fromkeys(row[column] for row in [*csv.reader(file)][1:])]


NOTHING = "raise NotImplementedError('Exercise B9.9')"
# For each chapter, functions that do nothing, return nonsense or raise an error.
NONSENSE = [
    (
        "ch02_vectors",
        {
            "vector": """\
Vector3.__add__ = lambda *_: None
Vector3.__sub__ = lambda *_: 'text'
Vector3.cross = lambda *_: Vector3(math.nan, math.inf, 0.0)"""
        },
    ),
    (
        "ch06_springs",
        {
            "integrators": """\
explicit_euler = trapezoidal = watched = lambda *_: None
backward_euler = lambda *_: (float('nan'), float('inf'))""",
            "closed_form": "damped_spring_state = lambda *_: (math.nan, math.inf)",
        },
    ),
    (
        "ch07_constraints",
        {
            "contacts": "Contact.separating_velocity = lambda *_: float('inf')",
            "detectors": "GroundPlane.next_impact = lambda *_: None",
            "exercises": "def table_of_drops(drops): return []",
        },
    ),
    (
        "ch09_rotations",
        {
            "quaternion": """\
def _refuse(*_):
    raise ValueError('no')


Quaternion.from_axis_angle = staticmethod(lambda *_: None)
Quaternion.add_scaled = _refuse
Quaternion.rotate_by = Quaternion.rotate = lambda *_: float('nan')""",
            "matrix": "Matrix3.product = Matrix3.from_quaternion = lambda *_: None",
            "euler": "rate_map = euler_rates = lambda *_: (float('nan'), float('inf'))",
            "angular": "integrate_rotation = first_order_drift = lambda *_: None",
            "exercises": "balance_offset = masses_beside = lambda *_: float('nan')",
        },
    ),
]


@pytest.mark.parametrize(("chapter", "wrong"), NONSENSE, ids=[name for name, _ in NONSENSE])
def test_an_engine_of_nonsense_gives_pictures(
    chapter: str, wrong: dict[str, str], tmp_path: Path
) -> None:
    done = plot(engine_with(chapter, wrong, tmp_path), tmp_path, chapter)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr
    pictures = {path.stem for path in (tmp_path / chapter).glob("*.png")}
    assert pictures == plots_of(chapter).keys()


# These need only modules that are given.
NEED_NO_EXERCISE = {"rope_by_method", "pendulum_energy", "hanging_rope"}


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_a_plot_of_stubs_names_the_exercise_to_write(chapter: str, tmp_path: Path) -> None:
    engine = engine_with(chapter, {}, tmp_path)
    for path, text in made_stubs().items():
        if path.startswith(f"chapters/{chapter}/"):
            (engine / path.removeprefix("chapters/")).write_text(text, encoding="utf-8")
    done = plot(engine, tmp_path, chapter)
    assert done.returncode == 1
    said = re.findall(
        rf"(?m)^(\w+): not drawn, not written yet: Exercise [BP]?{chapter[3]}\.", done.stdout
    )
    assert {*said} == plots_of(chapter).keys() - NEED_NO_EXERCISE, done.stdout
    drawn = {path.stem for path in (tmp_path / chapter).glob("*.png")}
    assert drawn == plots_of(chapter).keys() & NEED_NO_EXERCISE


def test_a_curve_that_is_not_written_is_left_out(tmp_path: Path) -> None:
    stub = f"def _stub(*_):\n    {NOTHING}\n\n\n"
    added = {
        "matrix": f"{stub}Matrix3.from_quaternion = _stub",
        "quaternion": f"{stub}Quaternion.rotate_by = _stub",
        "euler": f"{stub}euler_rates = _stub",
        "angular": f"{stub}first_order_drift = _stub",
    }
    done = plot(engine_with("ch09_rotations", added, tmp_path), tmp_path, "ch09_rotations")
    assert re.findall(r"(\w+): not drawn, (.*)", done.stdout) == [
        ("turning_motion", "not written yet: Exercise B9.9")
    ]
    assert series(tmp_path, "ch09_rotations", "order_of_turns", 2) == ["quaternions"]
    assert series(tmp_path, "ch09_rotations", "drift_of_first_order", 1) == [
        "Eq. 9.5",
        "steady axis, Eq. 9.5",
        "steady axis, Eq. 9.5, normalized",
        "moving axis, Eq. 9.5, normalized",
    ]
    assert len(series(tmp_path, "ch09_rotations", "gimbal_lock", 0)) == 3


def test_an_explosion_is_drawn_even_if_no_watch_is_written(tmp_path: Path) -> None:
    engine = engine_with(
        "ch06_springs", {"integrators": f"def watched(*_):\n    {NOTHING}"}, tmp_path
    )
    only = ("energy_over_time", "cloth_frame_rates")
    done = plot(engine, tmp_path, "ch06_springs", only)
    assert done.returncode == 0, done.stdout


def test_a_plot_that_fails_leaves_no_older_picture_and_says_why(tmp_path: Path) -> None:
    old = tmp_path / "ch02_vectors/addition.png"
    old.parent.mkdir()
    old.write_bytes(b"an older picture")
    wrong = f"def _stub(*_):\n    {NOTHING}\n\n\nVector3.__add__ = _stub\ndel Vector3.dot"
    done = plot(engine_with("ch02_vectors", {"vector": wrong}, tmp_path), tmp_path, "ch02_vectors")
    assert done.returncode == 1
    assert "addition: not drawn, not written yet: Exercise B9.9" in done.stdout
    assert not old.exists()
    assert "projection: not drawn, AttributeError: 'Vector3' object has no" in done.stdout


def test_a_plot_without_the_student_s_drops_shows_the_sample(tmp_path: Path) -> None:
    engine = engine_with("ch07_constraints", {}, tmp_path)
    (engine / "ch07_constraints/drops.csv").write_text(
        "material,initial_height,bounce_height\n", encoding="utf-8"
    )
    done = plot(engine, tmp_path, "ch07_constraints", only=("restitution_of_materials",))
    assert done.returncode == 0, done.stdout
    with (tmp_path / "ch07_constraints/restitution_of_materials.csv").open(
        encoding="utf-8"
    ) as file:
        assert sum(line.startswith("drop,") for line in file) == 13


def test_a_plot_without_stones_says_so(tmp_path: Path) -> None:
    engine = engine_with("ch09_rotations", {}, tmp_path)
    (engine / "ch09_rotations/stones.csv").write_text("what,mass,x,y\n", encoding="utf-8")
    done = plot(engine, tmp_path, "ch09_rotations", only=("balance_lines",))
    assert done.returncode == 1
    assert "balance_lines: not drawn, ValueError: there are no stones in stones.csv" in done.stdout


def test_an_engine_that_cannot_be_read_is_one_sentence(tmp_path: Path) -> None:
    done = plot("sample_class/dina", tmp_path, "ch02_vectors")
    assert done.returncode == 1
    assert "chapter 2 cannot be drawn: SyntaxError: '(' was never closed" in done.stdout
    assert "(sample_class/dina/ch02_vectors/vector.py, line " in done.stdout
    assert "Traceback" not in done.stdout + done.stderr


def test_a_mistake_on_the_command_line_is_a_clear_sentence(tmp_path: Path) -> None:
    done = plot("nowhere", tmp_path, "ch02_vectors")
    assert done.returncode == 2
    assert "engine must be a folder of chapters, got 'nowhere'" in done.stderr
