"""`make python` has the student's engine, new code after reload(), and pictures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from autograder.student.show import picture
from copies import copy_tree, edit
from terminal import Terminal, opened
from typed import typed


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    for name in ("ch02_vectors", "ch03_laws_of_motion"):
        copy_tree(ROOT / "solutions" / name, tmp_path / name)
    return tmp_path


@pytest.fixture
def words(engine: Path) -> tuple[str, ...]:
    return "python", "--engine", str(engine), "--chapter", "2-3"


@pytest.fixture
def terminal(words: tuple[str, ...]) -> Iterator[Terminal]:
    yield from opened(ROOT, *words)


def test_the_engine_is_there_and_new_code_after_a_save(terminal: Terminal, engine: Path) -> None:
    terminal.wait_for("chapter 2: Vector3,", "chapter 3: Particle,", "reload()", ">>> ")
    terminal.press("Particle(Vector3(3.0, 4.0)).position.magnitude()\r")
    terminal.wait_for("5.0", ">>> ")
    line = "return math.hypot(self.x, self.y, self.z)"
    edit(engine / "ch02_vectors/vector.py", line, "print('mine'); return 7.0")
    terminal.press("reload()\r")
    terminal.wait_for("imported again", ">>> ")
    terminal.press("Particle(Vector3(3.0, 4.0)).position.magnitude()\r")
    terminal.wait_for("mine", "7.0", ">>> ")
    terminal.press("exit()\r")
    assert terminal.status() == 0


def test_what_cannot_be_imported_is_named_and_the_rest_is_there(
    engine: Path, words: tuple[str, ...]
) -> None:
    broken = engine / "ch03_laws_of_motion/damping.py"
    broken.write_text("def damp(:\n", encoding="utf-8")
    done = typed("autograder", *words, text="Particle().mass\nraise SystemExit\n")
    assert "ch03_laws_of_motion/damping.py cannot be imported: SyntaxError" in done.stdout
    assert "line 1: def damp(:" in done.stdout
    assert "1.0" in done.stdout
    assert done.returncode == 0


def test_a_path_is_drawn_from_the_last_steps(words: tuple[str, ...]) -> None:
    lines = [
        "p = Particle(velocity=Vector3(3.0, 4.0), acceleration=Vector3(0.0, -10.0))",
        "for _ in range(16): p.integrate(0.05)",
        "",
        "show(p, Vector3(0.0, 1.0))",
        "show(3)",
    ]
    done = typed("autograder", *words, text="\n".join(lines) + "\n")
    drawn = done.stdout.partition(">>> ")[2]
    assert drawn.count("·") >= 16
    assert "a: position Vector3(2.39" in drawn
    assert "b: Vector3(0.0, 1.0, 0.0)" in drawn
    assert "show draws vectors and particles, got 3" in done.stderr


def test_a_picture_has_one_scale_for_both_axes_and_marks_the_ends() -> None:
    """One character is about twice as high as wide, so 10 m are fewer lines than characters."""
    drawn = picture([[(0.0, 0.0), (30.0, 0.0)], [(0.0, 0.0), (0.0, 10.0)]]).splitlines()
    rows = drawn[:-1]
    assert rows[0].index("b") == rows[-1].index("+") == 0
    assert rows[-1].index("a") == 60
    assert len(rows) - 1 == 10, "30 m are 60 characters wide, so 10 m are 10 lines high"
    assert drawn[-1] == "one character to the right is 0.5, one line is 1"
