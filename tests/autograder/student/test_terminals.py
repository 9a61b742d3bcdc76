"""`make debug` stops in the student's function, and `make python` has the student's engine."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from autograder.student.show import picture
from copies import copy_tree, edit
from terminal import Terminal, opened
from typed import typed

Start = Callable[[str, str, str], Terminal]


@pytest.fixture
def both(tmp_path: Path) -> Path:
    """The reference's chapters 2 and 3 in a folder to be edited."""
    for name in ("ch02_vectors", "ch03_laws_of_motion"):
        copy_tree(ROOT / "solutions" / name, tmp_path / name)
    return tmp_path


@pytest.fixture
def start(both: Path) -> Iterator[Start]:
    """Debugs an exercise of the reference, with a change to vector.py."""
    with contextlib.ExitStack() as stack:

        def debug(exercise: str, old: str, new: str) -> Terminal:
            edit(both / "ch02_vectors/vector.py", old, new)
            terminal = Terminal(ROOT, "debug", exercise, "--engine", str(both))
            return stack.enter_context(contextlib.closing(terminal))

        yield debug


def test_a_wrong_value_stops_at_the_call_again(start: Start) -> None:
    terminal = start("B2.9", "self.z * v.x - self.x * v.z", "self.z * v.x + self.x * v.z")
    terminal.wait_for("got ", "wanted ", "cross()", "self = Vector3(", "v = Vector3(", "(Pdb)")
    terminal.press("w\r")
    terminal.wait_for("test_products.py", "v.cross(w)", "cross()", "(Pdb)")
    assert "pluggy" not in terminal.text, "where begins with the check"
    terminal.press("p v.x * self.z + v.x\r")
    terminal.wait_for("(Pdb)")
    terminal.press("c\r")
    terminal.wait_for("The check has ended with the failure above.")
    assert terminal.status() == 1


def test_an_exception_can_be_stepped_into(start: Start) -> None:
    terminal = start("B2.8", "return self.x * v.x +", "return self.w * v.x +")
    terminal.wait_for("has no attribute 'w'", "dot()", "(Pdb)")
    terminal.press("n\r")
    terminal.press("n\r")
    terminal.wait_for("AttributeError", "(Pdb)")
    terminal.press("q\r")
    assert terminal.status() == 1
    assert "Traceback" not in terminal.text


def test_an_endless_loop_can_be_looked_into(start: Start) -> None:
    loop = "while True:\n            self.x += 0.0\n        self.x"
    terminal = start("B2.7", "self.x *= v.x", f"{loop} *= v.x")
    terminal.wait_for("Is there an endless loop?", "component_product_update()", "(Pdb)")
    for _ in range(3):
        terminal.press("n\r")
    terminal.wait_for("self.x += 0.0", "self.x += 0.0", "(Pdb)")
    terminal.press("q\r")
    assert terminal.status() == 1


def test_it_stops_at_a_breakpoint_of_the_students_own(start: Start) -> None:
    old = "return self.x * v.x +"
    terminal = start("B2.8", old, f"product = 1\n        breakpoint()\n        {old}")
    terminal.wait_for("All checks of B2.8 pass", "dot()", "(Pdb)")
    terminal.press("p product\r")
    terminal.wait_for("1", "(Pdb)")
    terminal.press("q\r")
    assert terminal.status() == 0


def test_an_exercise_that_builds_on_a_wrong_one_begins_there(start: Start) -> None:
    terminal = start("2.1", "return math.hypot(self.x, self.y, self.z)", "return 1.0")
    terminal.wait_for("B2.2, test_magnitude", "2.1 builds on it. Start there: ", "debug")
    assert terminal.status() == 1


def test_a_stub_has_nothing_to_step_through(start: Start) -> None:
    terminal = start("B2.8", "return self.x * v.x +", "raise NotImplementedError; +")
    terminal.wait_for("not written yet", "There is no code to step through yet.")
    assert terminal.status() == 1


@pytest.fixture
def words(both: Path) -> tuple[str, ...]:
    return "python", "--engine", str(both), "--chapter", "2-3"


@pytest.fixture
def terminal(words: tuple[str, ...]) -> Iterator[Terminal]:
    yield from opened(ROOT, *words)


def test_the_engine_is_there_and_new_code_after_a_save(terminal: Terminal, both: Path) -> None:
    terminal.wait_for("chapter 2: Vector3,", "chapter 3: Particle,", "reload()", ">>> ")
    terminal.press("Particle(Vector3(3.0, 4.0)).position.magnitude()\r")
    terminal.wait_for("5.0", ">>> ")
    line = "return math.hypot(self.x, self.y, self.z)"
    edit(both / "ch02_vectors/vector.py", line, "print('mine'); return 7.0")
    terminal.press("reload()\r")
    terminal.wait_for("imported again", ">>> ")
    terminal.press("Particle(Vector3(3.0, 4.0)).position.magnitude()\r")
    terminal.wait_for("mine", "7.0", ">>> ")
    terminal.press("exit()\r")
    assert terminal.status() == 0


def test_what_cannot_be_imported_is_named_and_the_rest_is_there(
    both: Path, words: tuple[str, ...]
) -> None:
    broken = both / "ch03_laws_of_motion/damping.py"
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
