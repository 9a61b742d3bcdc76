"""`make debug` stops in the student's function, at the call with which a check fails."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from copies import copy_tree, edit
from terminal import Terminal

VECTOR = "ch02_vectors/vector.py"
Start = Callable[[str, str, str], Terminal]


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Debugs an exercise of the reference, with a change to vector.py."""
    opened: list[Terminal] = []

    def debug(exercise: str, old: str, new: str) -> Terminal:
        copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
        edit(tmp_path / VECTOR, old, new)
        opened.append(Terminal(ROOT, "debug", exercise, "--engine", str(tmp_path)))
        return opened[-1]

    yield debug
    for terminal in opened:
        terminal.close()


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
