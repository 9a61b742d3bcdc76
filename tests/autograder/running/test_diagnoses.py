"""Slips that Python explains badly are explained, in both ways of running the checks."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest

from autograder.checks.runner import run_checks
from autograder.definitions import module_that_defines
from autograder.diagnosis.deleted import explain_deleted
from autograder.diagnosis.none_values import none_in
from autograder.diagnosis.slips import fact_of
from autograder.manifest import ROOT, load_chapters
from autograder.message import Message
from autograder.text.similar import nearest
from copies import copy_tree
from walls import behind_walls

METHOD = (
    r"    def {}\(.*?(?=\n    def |\n    @|\n    __|\nclass |\n\n\n)"  # the whole text of a method
)
SLIPS = tomllib.loads(Path(__file__).with_name("slips.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("where", ["beside the checks", "in a worker"])
@pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS)
def test_a_slip_is_explained(slip: dict[str, Any], where: str, tmp_path: Path) -> None:
    (chapter,) = (c for c in load_chapters() if slip["file"].startswith(c.name))
    for other in load_chapters():
        if other.number <= chapter.number:
            copy_tree(ROOT / "solutions" / other.name, tmp_path / other.name)
    file = tmp_path / slip["file"]
    code = file.read_text(encoding="utf-8")
    for pattern, new in slip["changes"]:
        whole = re.sub("<(\\w+)>", lambda name: METHOD.format(name[1]), pattern)
        code, count = re.subn(whole, lambda _, new=new: new, code, count=1, flags=re.DOTALL)
        assert count, pattern
    file.write_text(code, encoding="utf-8")
    engine, sandbox = [tmp_path, ROOT / "chapters"], behind_walls() if "worker" in where else None
    exercises = [*slip["texts"]]
    verdicts = run_checks(chapter, engine, seed="1", exercises=exercises, sandbox=sandbox)
    for exercise, texts in slip["texts"].items():
        failed = [v for v in verdicts if v.exercise == exercise and v.status != "passed"]
        assert failed
        assert "error" not in {verdict.status for verdict in failed}
        messages = [str(verdict.message) for verdict in failed]
        for text in texts:
            pattern = ".*".join(map(re.escape, text.split(" ... ")))
            assert re.search(pattern, "\n".join(messages), re.DOTALL), text
        assert all(text in said for text in slip.get("every", ()) for said in messages)
        assert not any(text in said for text in slip.get("never", ()) for said in messages)


def test_a_deleted_function_and_a_deleted_class() -> None:
    edits = {"B2.1": ["vector.Vector3.copy", "vector.Vector3.clear"], "B2.10": ["vector.basis"]}
    says = "ch02_vectors/vector.py does not define {}"
    there = {"Vector3", "Vector3.clear"}
    for name, exercise, gone in (
        ("basis", "B2.10", "vector.py no longer defines it"),
        ("Vector3", "B2.1", "stub of Vector3.copy is gone"),
    ):
        message = explain_deleted(Message(says.format(name)), "B2.10", edits, lambda _: there)
        assert gone in message.likely
        assert exercise in message.likely
    for defined in (None, {*there, "basis"}):
        says_basis = Message(says.format("basis"))
        same = explain_deleted(says_basis, "B2.10", edits, lambda _, is_=defined: is_)
        assert same == says_basis


def test_short_and_special_names_are_near_to_nothing() -> None:
    assert nearest("veloctiy", ["velocity", "position", "__init__"]) == "velocity"
    assert nearest("vx", ["v", "vy"]) == ""
    assert nearest("init", ["__init__"]) == ""
    assert nearest("zebra", ["velocity"]) == ""


def test_the_latest_chapter_that_defines_a_name_counts() -> None:
    for name, file, module in (
        ("Particle", "ch03_laws_of_motion/exercises.py", "ch03_laws_of_motion.particle"),
        ("Particle", "ch07_constraints/links.py", "ch05_forces.particle"),
        ("Rod", "ch08_mass_aggregate/bridge.py", "ch07_constraints.links"),
        ("Rod", "ch06_springs/springs.py", ""),  # a later chapter defines it
        ("Vector", "ch06_springs/springs.py", ""),
    ):
        assert module_that_defines(name, file, [ROOT / "chapters"]) == module


@pytest.mark.parametrize(
    ("code", "none"),
    [
        *((code, "v") for code in ("v.x", "v[0]", "2.0 * v", "v < 1.0", "1.0 < v", "-v", "v(1)")),
        *(("v.other.x", "v.other"), ("v() + 1.0", "v()"), ("1.0 + 'v'", ""), ("[0][v]", "")),
    ],
)
def test_the_expression_that_was_none(code: str, none: str, tmp_path: Path) -> None:
    file = tmp_path / "code.py"
    file.write_text(f"result = {code}\n", encoding="utf-8")
    value = {"v.other.x": type("V", (), {"other": None}), "v() + 1.0": lambda: None}.get(code)
    with pytest.raises((TypeError, AttributeError)) as caught:
        exec(compile(file.read_text(encoding="utf-8"), str(file), "exec"), {"v": value})
    assert none_in(caught.value, str(caught.value)) == none


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("f()", "The call passes no value for a and b."),
        ("f(1)", "The call passes no value for b."),
        ("f(1, 2, 3)", "The call passes 3 arguments, but the def line takes 2. Perhaps the def"),
        ("f(1, 2, 3, 4)", "The call passes 4 arguments, but the def line takes 2."),
        ("g()", "The call passes no value for c. Pass it by name."),
        ("a()", "Your code calls a value that isn't a function. Perhaps this value is a"),
    ],
)
def test_wrong_numbers_of_arguments(code: str, says: str) -> None:
    there = {"f": lambda a, b: (a, b), "g": lambda *, c: c, "a": True}
    with pytest.raises(TypeError) as caught:
        eval(code, there)
    assert fact_of(str(caught.value)).startswith(says)
    assert ("lacks self" in fact_of(str(caught.value))) is (code == "f(1, 2, 3)")
