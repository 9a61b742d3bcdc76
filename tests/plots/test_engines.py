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
VECTORS, SPRINGS = "ch02_vectors", "ch06_springs"
CONTACTS, TURNS = "ch07_constraints", "ch09_rotations"
STUB = "def _stub(*_):\n    raise NotImplementedError('Exercise B9.9')\n\n\n"


def plot(
    engine: str | Path, out: Path, chapter: str, only: tuple[str, ...] = ()
) -> CompletedProcess[str]:
    """Draw the plots of a chapter with an engine, or only those that ``only`` names."""
    number = str(int(chapter[2:4]))
    options = ("--chapter", number, "--engine", str(engine), "--out", str(out))
    return study("draw", *options, package="plots", only=only)


def engine_with(chapter: str, added: dict[str, str], at: Path) -> Path:
    """Return a copy of the reference with lines appended to some files of a chapter."""
    copy_tree(ROOT / "solutions", at / "engine")
    for file, lines in added.items():
        with (at / "engine" / chapter / file).open("a", encoding="utf-8") as end:
            end.write(f"\n\n{lines}\n")
    return at / "engine"


def column(out: Path, plot: str, number: int) -> list[str]:
    """Return the values in a column of the table beside a plot."""
    with (out / f"{plot}.csv").open(encoding="utf-8", newline="") as file:
        return [row[number] for row in [*csv.reader(file)][1:]]


# For each chapter, functions that do nothing, return nonsense or raise an error.
NONSENSE = {
    VECTORS: {
        "vector.py": """\
Vector3.__add__ = lambda *_: None
Vector3.__sub__ = lambda *_: 'text'
Vector3.cross = lambda *_: Vector3(math.nan, math.inf, 0.0)"""
    },
    SPRINGS: {
        "integrators.py": """\
explicit_euler = trapezoidal = watched = lambda *_: None
backward_euler = lambda *_: (float('nan'), float('inf'))""",
        "closed_form.py": "damped_spring_state = lambda *_: (math.nan, math.inf)",
    },
    CONTACTS: {
        "contacts.py": "Contact.separating_velocity = lambda *_: float('inf')",
        "detectors.py": "GroundPlane.next_impact = lambda *_: None",
        "exercises.py": "def table_of_drops(drops): return []",
    },
    TURNS: {
        "quaternion.py": """\
def _refuse(*_):
    raise ValueError('no')


Quaternion.from_axis_angle = staticmethod(lambda *_: None)
Quaternion.add_scaled = _refuse
Quaternion.rotate_by = Quaternion.rotate = lambda *_: float('nan')""",
        "euler.py": "rate_map = euler_rates = lambda *_: (float('nan'), float('inf'))",
        "angular.py": "integrate_rotation = first_order_drift = lambda *_: None",
    },
}


@pytest.mark.parametrize("chapter", NONSENSE)
def test_an_engine_of_nonsense_gives_pictures(chapter: str, tmp_path: Path) -> None:
    done = plot(engine_with(chapter, NONSENSE[chapter], tmp_path), tmp_path, chapter)
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
    added = {
        "matrix.py": f"{STUB}Matrix3.from_quaternion = _stub",
        "quaternion.py": f"{STUB}Quaternion.rotate_by = _stub",
        "euler.py": f"{STUB}euler_rates = _stub",
        "angular.py": f"{STUB}first_order_drift = _stub",
    }
    done = plot(engine_with(TURNS, added, tmp_path), tmp_path, TURNS)
    assert re.findall(r"(\w+): not drawn, (.*)", done.stdout) == [
        ("turning_motion", "not written yet: Exercise B9.9")
    ]
    assert {*column(tmp_path / TURNS, "order_of_turns", 2)} == {"quaternions"}
    assert {*column(tmp_path / TURNS, "drift_of_first_order", 1)} == {
        "Eq. 9.5",
        "steady axis, Eq. 9.5",
        "steady axis, Eq. 9.5, normalized",
        "moving axis, Eq. 9.5, normalized",
    }
    assert len({*column(tmp_path / TURNS, "gimbal_lock", 0)}) == 3
    wrong = {"integrators.py": f"{STUB}watched = _stub"}
    only = ("energy_over_time", "cloth_frame_rates")  # an explosion is drawn without a watch
    done = plot(engine_with(SPRINGS, wrong, tmp_path), tmp_path, SPRINGS, only)
    assert done.returncode == 0, done.stdout


def test_a_plot_that_fails_leaves_no_older_picture_and_says_why(tmp_path: Path) -> None:
    old = tmp_path / VECTORS / "addition.png"
    old.parent.mkdir()
    old.write_bytes(b"an older picture")
    wrong = {"vector.py": f"{STUB}Vector3.__add__ = _stub\ndel Vector3.dot"}
    done = plot(engine_with(VECTORS, wrong, tmp_path), tmp_path, VECTORS)
    assert done.returncode == 1
    assert "addition: not drawn, not written yet: Exercise B9.9" in done.stdout
    assert not old.exists()
    assert "projection: not drawn, AttributeError: 'Vector3' object has no" in done.stdout


def test_a_student_without_measurements_sees_the_sample_or_why_there_is_no_plot(
    tmp_path: Path,
) -> None:
    engine = engine_with(TURNS, {}, tmp_path)
    for file, titles in (
        (f"{CONTACTS}/drops.csv", "material,initial_height,bounce_height\n"),
        (f"{TURNS}/stones.csv", "what,mass,x,y\n"),
    ):
        (engine / file).write_text(titles, encoding="utf-8")
    done = plot(engine, tmp_path, CONTACTS, only=("restitution_of_materials",))
    assert done.returncode == 0, done.stdout
    assert column(tmp_path / CONTACTS, "restitution_of_materials", 0).count("drop") == 13
    done = plot(engine, tmp_path, TURNS, only=("balance_lines",))
    assert done.returncode == 1
    assert "balance_lines: not drawn, ValueError: there are no stones in stones.csv" in done.stdout


def test_an_engine_that_cannot_be_read_is_one_sentence(tmp_path: Path) -> None:
    done = plot("sample_class/dina", tmp_path, VECTORS)
    assert done.returncode == 1
    assert "chapter 2 cannot be drawn: SyntaxError: '(' was never closed" in done.stdout
    assert "(sample_class/dina/ch02_vectors/vector.py, line " in done.stdout
    assert "Traceback" not in done.stdout + done.stderr
    done = plot("nowhere", tmp_path, VECTORS)
    assert done.returncode == 2
    assert "engine must be a folder of chapters, got 'nowhere'" in done.stderr
