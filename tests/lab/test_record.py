"""Record scenes to files."""

from __future__ import annotations

import csv
import re
import subprocess
from pathlib import Path

import pytest
from PIL import Image

from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from made import made_stubs
from scenes.clock import FRAME
from studied import study
from wrong import write_all

UNLOCKED = {name: (c, e) for c in load_chapters() for e in c.exercises for name in e.play}
FEW = {"STEPS_A_PICTURE": 30, "TILES": 4}  # pictures, because drawing takes most of the time
SHORT = {"TIME_LIMIT": 2}  # s; a picture takes a small part of it, and 160 of them take more
LATER = "raise NotImplementedError('later')"


def record(*arguments: str | Path, **settings: int) -> subprocess.CompletedProcess[str]:
    return study("record", *map(str, arguments), package="lab", settings=settings or FEW)


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """Return a copy of the reference."""
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    return tmp_path / "engine"


@pytest.mark.parametrize("name", sorted(UNLOCKED))
def test_a_scene_becomes_an_animation_a_contact_sheet_and_a_table(
    name: str, engine: Path, tmp_path: Path
) -> None:
    """A scene runs with only the exercise that unlocks it and the exercises before it written."""
    chapter, unlocks = UNLOCKED[name]
    written = [exercise.id for exercise in chapter.exercises]
    write_all(chapter, LATER, engine, but=written[: written.index(unlocks.id) + 1])
    # One scene has as many pictures as the contact sheet for students.
    many = {"STEPS_A_PICTURE": 10} if name == "spin" else FEW
    done = record(name, "--engine", engine, "--seconds", "2", "--out", tmp_path, **many)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{name}.gif, " in done.stdout
    with Image.open(tmp_path / f"{name}.gif") as animation:
        length = 0.0
        for i in range(animation.n_frames):  # equal pictures are merged and shown for longer
            animation.seek(i)
            length += animation.info["duration"] / 1000.0
    # A picture lasts at least 1 / 6 s, and the format counts in hundredths of a second.
    assert length == pytest.approx(2.0, abs=12 * 0.01)
    assert (tmp_path / f"{name}.png").stat().st_size > 20_000, "an empty sheet"
    with (tmp_path / f"{name}.csv").open(encoding="utf-8", newline="") as table:
        times = [float(row["time, s"]) for row in csv.DictReader(table)]
    assert times == pytest.approx([i * FRAME for i in range(121)], abs=1e-6)


def unwrite(engine: Path, *modules: str) -> None:
    """Write the stubs of some modules of chapter 4."""
    for module in modules:
        path = f"ch04_particle_engine/{module}.py"
        (engine / path).write_text(made_stubs()[f"chapters/{path}"], encoding="utf-8")


def test_a_scene_that_cannot_begin_is_said_and_leaves_no_older_file(
    engine: Path, tmp_path: Path
) -> None:
    unwrite(engine, "ballistics")
    out = tmp_path / "out"
    out.mkdir()
    (out / "ballistics.gif").write_text("an older animation", encoding="utf-8")
    done = record("ballistics", "--engine", engine, "--out", out)
    assert done.returncode == 1
    assert "Exercise B4.3" in done.stdout
    assert "Traceback" not in done.stderr
    assert [*out.iterdir()] == []


def test_a_scene_plays_with_what_is_written(engine: Path, tmp_path: Path) -> None:
    """Enough is left to see without grenades, targets, own types, wheel, turns and game."""
    missing = ("grenade", "targets", "firework_types", "catherine_wheel", "screen_rotation")
    unwrite(engine, *missing, "display")
    for name in ("ballistics", "fireworks", "sniper"):
        done = record(name, "--engine", engine, "--seconds", "1", "--out", tmp_path)
        assert done.returncode == 0, done.stdout
        assert (tmp_path / f"{name}.gif").exists()


def test_the_time_limit_is_for_each_picture_and_not_for_a_long_recording(tmp_path: Path) -> None:
    done = record("throw", "--engine", "solutions", "--seconds", "8", "--out", tmp_path, **SHORT)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "throw.gif, " in done.stdout


def test_a_scene_that_does_not_end_says_in_which_line_it_was(engine: Path, tmp_path: Path) -> None:
    file = engine / "ch03_laws_of_motion/particle.py"
    text = file.read_text(encoding="utf-8")
    loop = "duration: float) -> None:\n        while True: pass"
    file.write_text(text.replace("duration: float) -> None:", loop), encoding="utf-8")
    done = record("throw", "--engine", engine, "--out", tmp_path, **SHORT)
    assert (done.returncode, done.stderr) == (1, "")
    assert re.search(r"not finished after 2 s, at \S*particle.py, line \d", done.stdout)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["trebuchets"], "there is no scene 'trebuchets'; choose from projection, cross-product"),
        (["spin", "--engine", "nowhere"], "got 'nowhere'"),
        (["spin", "--seconds", "-1"], "--seconds must be positive and finite, got -1.0"),
        (["spin", "--set", "about=none"], "about must be one of smallest, middle, largest"),
    ],
)
def test_what_cannot_be_recorded_is_a_clear_sentence(arguments: list[str], words: str) -> None:
    done = record("--engine", "solutions", *arguments)
    assert done.returncode in (1, 2)
    assert words in " ".join((done.stdout + done.stderr).split())
    assert "Traceback" not in done.stderr
