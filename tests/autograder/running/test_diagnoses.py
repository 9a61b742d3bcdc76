"""Slips that Python explains badly are explained, in both ways of running the checks."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

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

VECTOR, PARTICLE = "ch02_vectors/vector.py", "ch03_laws_of_motion/particle.py"
STUB = "raise NotImplementedError('Exercise B2.3: x')"


def method(name: str, *body: str) -> dict[str, str]:
    """Return a change that gives a method without arguments or with one another body."""
    lines = "\n        ".join(body)
    return {whole(name): f"    def {name}(self, v=None):\n        {lines}\n"}


def whole(name: str) -> str:
    """Return a pattern for the whole text of a method."""
    return rf"    def {name}\(.*?(?=\n    def |\n    @|\n    __|\nclass |\n\n\n)"


@dataclass
class Case:
    """Changes to a module of the reference, and what the messages of some exercises then contain.

    Anything may stand in place of " ... " in these texts. Each text of ``every`` must be in each
    message of the exercises, and no text of ``never`` may be in any.
    """

    path: str
    changes: dict[str, str]
    some: dict[str, list[str]]
    every: list[str] = field(default_factory=list)
    never: list[str] = field(default_factory=list)


CASES = {
    "names that are not there": Case(
        VECTOR,
        {
            r"return math\.hypot\(self\.x, self\.y, self\.z\)": "return mth.hypot(self.X1)",
            whole("__isub__"): "    def isub(self, v): ...\n",
            whole("cross"): "    def cros(self, v): ...\n",
            **method("copy", "return self.normalizedd()"),
        },
        {
            "B2.2": ["Did you mean math?"],
            "B2.1": ["Did you mean normalized?"],
            "B2.5": ["The stub of Vector3.__isub__ is gone", "EX=B2.5"],
            "B2.9": ["The stub of Vector3.cross is gone", "renamed it to cros,"],
        },
    ),
    "an error that the student raises is no slip": Case(
        VECTOR,
        method("dot", "if v: raise TypeError('no vector')"),
        {"B2.8": ["TypeError: no vector"]},
        never=["has the wrong type"],
    ),
    "errors in the line that raises": Case(
        VECTOR,
        method("cross", "return self.y * 'z'")
        | method("__neg__", "raise ValueError('v' + 1)")
        | method("magnitude", "raise ValeuError('v')"),
        {
            "B2.9": ["has the wrong type"],
            "B2.1": ["has the wrong type"],
            "B2.2": ["Did you mean ValueError?"],
        },
    ),
    "what slots can hold": Case(
        PARTICLE,
        {r"self\._inverse_mass = not_negative\(\"1 / mass\"": "self._mass = (0"},
        {
            "B3.1": [
                "The closest to _mass is _inverse_mass.",
                "_damping, _inverse_mass, acceleration, position, velocity",
            ]
        },
        never=["_frame"],
    ),
    "misspelled attributes and names": Case(
        PARTICLE,
        {
            whole("momentum"): "    def momentum(self):\n        return Vecotr3()\n",
            r"self\.position\.add_scaled\(self\.velocity": "self.positon.add_scaled(self.velocity",
        },
        {"B3.2": ["Did you mean Vector3?"], "B3.4": ["Did you mean position?"]},
    ),
    "a deleted setter": Case(
        PARTICLE,
        {r"    @damping\.setter\n" + whole("damping"): ""},
        {"B3.1": ["The stub of Particle.damping.setter is gone", "EX=B3.1"]},
    ),
    "a deleted getter without which the module cannot be read": Case(
        PARTICLE,
        {r"    @property\n" + whole("mass"): ""},
        {"B3.1": ["particle.py cannot be imported: NameError: name 'mass'"]},
        every=["The stub of Particle.mass is gone"],
    ),
    "a name that another module imports": Case(
        "ch02_vectors/exercises.py",
        {"from ch02_vectors.vector import": "from ch02_vectors.vector import Vectr3,"},
        {"2.1": ["ch02_vectors/vector.py has nothing called Vectr3. Did you mean Vector3?"]},
    ),
    "a name of the course is imported from its latest chapter": Case(
        "ch07_constraints/detectors.py",
        {r"from ch02_vectors\.vector import Vector3\n": ""},
        {"7.5": ["Vector3 is not imported. Write from ch02_vectors.vector import Vector3 at the"]},
        never=["Did you mean"],
    ),
    "what is None": Case(
        VECTOR,
        method("dot", "w = self.clear()", "return w.x")
        | method("magnitude", "return self.copy().clear().x"),
        {
            "B2.8": ["self.clear() returns None. Perhaps the function has no return statement, or"],
            "B2.2": ["self.copy().clear() returns None."],
        },
    ),
    "a power with a caret": Case(
        "ch03_laws_of_motion/damping.py",
        {r"(?s)return velocity \*[^\n]*": "return velocity * damping ^ duration + acceleration"},
        {"B3.3": ["powers are written with **"]},
        never=["parentheses"],
    ),
    "the line of the exercise comes first and the deepest second": Case(
        "ch06_springs/springs.py",
        {r"    direction = offset": "    Vector3().add_scaled(1.0, 2.0)\n    direction = offset"},
        {"B6.1": ["where     ch06_springs/springs.py ... inside    ch02_vectors/vector.py"]},
    ),
    "a stub that a module calls is not written yet": Case(
        VECTOR,
        method("__mul__", STUB) | {r"\Z": "\n\nGRAVITY = Vector3(0.0, -1.0, 0.0) * 9.81\n"},
        {"B2.1": []},
        every=["not written yet: Exercise B2.3"],
    ),
    "a method that calls itself": Case(
        VECTOR,
        method("magnitude", "return self.magnitude()"),
        {"B2.2": ["likely    A function calls itself too many times."]},
    ),
    "the check's cause comes before a guess, and a fact before the cause": Case(
        VECTOR,
        method("magnitude", "return [self.x].length") | method("dot", "return [self.x][1]"),
        {
            "B2.2": ["likely    The magnitude of a vector ... \nor        Perhaps you misspelled"],
            "B2.8": ["likely    The index is past the end. ... \nor        Multiply the"],
        },
    ),
    "what an error proves": Case(
        VECTOR,
        method("magnitude", "return self.scale")
        | {whole("__mul__"): "    def __mul__(self, scale):\n        return self.scale\n"}
        | method("cross", "return Vector3([1.0, 2.0, 3.0])")
        | method("dot", "x, y, z = self.copy", "return x * v.x"),
        {
            "B2.3": ["Vector3 has nothing called scale. Did you mean scale without self.?"],
            "B2.9": ["so write Vector3(*numbers)"],
            "B2.8": ["Add parentheses after the name to call it."],
        },
    ),
    "no method of a list resembles contacts": Case(
        VECTOR,
        method("dot", "return [self].contacts"),
        {"B2.8": []},
        never=["Did you mean count?"],
    ),
    "an error that is returned instead of raised": Case(
        "ch02_vectors/exercises.py",
        {
            r"def checked_duration\(.*?(?=\n\n\n)": "def checked_duration(duration):\n"
            "    if not 0 < duration < math.inf:\n        return ValueError('duration')\n"
            "    return float(duration)"
        },
        {"B2.11": ["no error; the call returned a ValueError", "Write raise instead of return."]},
    ),
    "None that a method in place has returned": Case(
        VECTOR, method("normalized", "return self.copy().normalize()"), {"B2.4": ["None"]}
    ),
}


@pytest.mark.parametrize("where", ["beside the checks", "in a worker"])
@pytest.mark.parametrize("name", CASES)
def test_a_slip_is_explained(name: str, where: str, tmp_path: Path) -> None:
    case = CASES[name]
    (chapter,) = (c for c in load_chapters() if case.path.startswith(c.name))
    for other in load_chapters():
        if other.number <= chapter.number:
            copy_tree(ROOT / "solutions" / other.name, tmp_path / other.name)
    text = (tmp_path / case.path).read_text(encoding="utf-8")
    for pattern, new in case.changes.items():
        text, count = re.subn(pattern, lambda _, new=new: new, text, count=1, flags=re.DOTALL)
        assert count, pattern
    (tmp_path / case.path).write_text(text, encoding="utf-8")
    verdicts = run_checks(
        chapter,
        [tmp_path, ROOT / "chapters"],
        seed="1",
        exercises=[*case.some],
        sandbox=behind_walls() if where == "in a worker" else None,
    )
    for exercise, texts in case.some.items():
        failed = [v for v in verdicts if v.exercise == exercise and v.status != "passed"]
        assert failed
        assert "error" not in {verdict.status for verdict in failed}
        messages = [str(verdict.message) for verdict in failed]
        for text in texts:
            pattern = ".*".join(map(re.escape, text.split(" ... ")))
            assert re.search(pattern, "\n".join(messages), re.DOTALL), text
        assert all(text in message for text in case.every for message in messages)
        assert not any(text in message for text in case.never for message in messages)


@pytest.mark.parametrize("where", ["beside the checks", "in a worker"])
def test_notimplemented_is_explained_before_the_physics(where: str, tmp_path: Path) -> None:
    """Only the operator @ may return it."""
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "ch02_vectors")
    text = (tmp_path / VECTOR).read_text(encoding="utf-8")
    text = re.sub(r"return self\.x \* v\.x[^\n]*", "return NotImplemented", text)
    (tmp_path / VECTOR).write_text(text, encoding="utf-8")
    sandbox = behind_walls() if where == "in a worker" else None
    chapter = load_chapters()[0]
    verdicts = run_checks(chapter, [tmp_path], seed="1", exercises=["B2.8"], sandbox=sandbox)
    messages = [str(v.message) for v in verdicts if v.exercise == "B2.8" and v.status != "passed"]
    dot = [message for message in messages if ".dot(" in message and " @ " not in message]
    assert dot
    for message in dot:
        assert "Any other method must raise the error itself" in message
        assert "\nor  " not in message


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
        ("v.x", "v"),
        ("v.other.x", "v.other"),
        ("v[0]", "v"),
        ("v() + 1.0", "v()"),
        ("2.0 * v", "v"),
        ("v < 1.0", "v"),
        ("1.0 < v", "v"),
        ("-v", "v"),
        ("v(1)", "v"),
        ("1.0 + 'v'", ""),
        ("[0][v]", ""),
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
