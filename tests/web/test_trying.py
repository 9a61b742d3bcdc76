"""The *Try it* box runs a line on the student's engine, and stops one that hangs."""

from __future__ import annotations

from typing import Any

from copies import reference
from in_node import NodeEngines

RIGHT = reference()
VECTOR = "ch02_vectors/vector.py"


def tried(engines: NodeEngines, *lines: str, files: dict[str, str] | None = None) -> dict[str, Any]:
    """Return what the last line shows after the others."""
    *before, line = lines
    asked = {"files": files or RIGHT, "chapter": "ch03_laws_of_motion", "given": []}
    return engines.ask("try", asked=asked | {"lines": before, "line": line})


def test_a_value_what_is_printed_and_what_earlier_lines_made(engines: NodeEngines) -> None:
    shown = tried(engines, "v = Vector3(3, 4)", "print('hidden')", "print('here'); v.magnitude()")
    assert (shown["value"], shown["printed"], shown["error"]) == ("5.0", "here", "")
    assert tried(engines, "p = Particle(velocity=Vector3(2.0))")["value"] == ""
    later = tried(engines, "p = Particle()", "p.velocity.x = 3.0", "p.integrate(2)", "p.position")
    assert later["value"] == "Vector3(6.0, 0.0, 0.0)"
    assert "+" in tried(engines, "show(Vector3(1, 1))")["printed"]


def test_an_error_has_the_students_line(engines: NodeEngines) -> None:
    old = "return math.hypot(self.x, self.y, self.z)"
    assert RIGHT[VECTOR].count(old) == 1
    wrong = RIGHT | {VECTOR: RIGHT[VECTOR].replace(old, "return 1 / 0")}
    shown = tried(engines, "Vector3().magnitude()", files=wrong)
    assert shown["error"] == "ZeroDivisionError: division by zero"
    assert shown["where"].startswith(f"{VECTOR}, line ")
    assert shown["where"].endswith(", in magnitude")
    assert tried(engines, "1 +")["error"].startswith("SyntaxError")
    broken = tried(engines, "Vector3()", files=RIGHT | {VECTOR: "def (:\n"})
    assert broken["error"] == "NameError: name 'Vector3' is not defined"
    assert "ch02_vectors/vector.py cannot be imported: SyntaxError" in broken["printed"]


def test_a_line_that_hangs_is_stopped_and_the_next_one_runs(engines: NodeEngines) -> None:
    shown = tried(engines, "while True: pass")
    assert shown["error"].startswith("did not finish within 2.5 seconds.")
    assert tried(engines, "sum(iter(int, 1))")["error"].startswith("did not finish within")
    assert tried(engines, "1 + 1")["value"] == "2"


def test_a_line_may_do_no_more_than_a_check(engines: NodeEngines) -> None:
    old = "return math.hypot(self.x, self.y, self.z)"
    wrong = RIGHT | {VECTOR: RIGHT[VECTOR].replace(old, "return open('/x', 'w')")}
    assert "PermissionError" in tried(engines, "Vector3().magnitude()", files=wrong)["error"]
