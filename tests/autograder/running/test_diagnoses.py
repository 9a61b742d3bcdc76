"""Slips that Python explains badly are explained, in both ways of running the checks."""

from __future__ import annotations

import re
from collections.abc import Callable
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

CHAPTERS = {chapter.number: chapter for chapter in load_chapters()}
Messages = Callable[[str, dict[str, str]], dict[str, list[str]]]


@pytest.fixture(params=["beside the checks", "in a worker"])
def messages(request: pytest.FixtureRequest, tmp_path: Path) -> Messages:
    """Runs a chapter with changes to a module of the reference; returns what fails."""
    behind = behind_walls() if request.param == "in a worker" else None

    def run(path: str, changes: dict[str, str]) -> dict[str, list[str]]:
        chapter = next(chapter for chapter in CHAPTERS.values() if path.startswith(chapter.name))
        for number in range(2, chapter.number + 1):
            copy_tree(ROOT / "solutions" / CHAPTERS[number].name, tmp_path / CHAPTERS[number].name)
        text = (tmp_path / path).read_text(encoding="utf-8")
        for pattern, new in changes.items():
            text, count = re.subn(pattern, lambda _, new=new: new, text, count=1, flags=re.S)
            assert count, pattern
        (tmp_path / path).write_text(text, encoding="utf-8")
        engine = [tmp_path, ROOT / "chapters"]
        failed: dict[str, list[str]] = {}
        for verdict in run_checks(chapter, engine, seed="1", sandbox=behind):
            assert verdict.status != "error"
            if verdict.status != "passed":
                failed.setdefault(verdict.exercise, []).append(str(verdict.message))
        return failed

    return run


def likely(messages: list[str]) -> str:
    """Return the causes of all the messages of an exercise."""
    return " ".join(re.findall(r"(?m)^(?:likely|or) +(.*)$", "\n".join(messages)))


def whole(name: str) -> str:
    """Return a pattern for the whole text of a method."""
    return rf"    def {name}\(.*?(?=\n    def |\n    @|\n    __|\nclass |\n\n\n)"


def test_names_that_are_not_there_and_notimplemented(messages: Messages) -> None:
    failed = messages(
        "ch02_vectors/vector.py",
        {
            r"return math\.hypot\(self\.x, self\.y, self\.z\)": "return mth.hypot(self.X1)",
            r"return self\.x \* v\.x[^\n]*": "return NotImplemented",
            whole("__isub__"): "    def isub(self, v): ...\n",
            whole("cross"): "    def cros(self, v): ...\n",
            whole("copy"): "    def copy(self):\n        return self.normalizedd()\n",
        },
    )
    assert "Did you mean math?" in likely(failed["B2.2"])
    assert "Did you mean normalized?" in likely(failed["B2.1"])
    dot = [message for message in failed["B2.8"] if ".dot(" in message and " @ " not in message]
    assert dot
    assert "or  " not in "".join(dot)
    for said in dot:
        assert "Any other method must raise the error itself" in likely([said])
    gone = [message for message in failed["B2.5"] if "-=" in message]
    assert "The stub of Vector3.__isub__ is gone" in likely(gone)
    assert "B2.5" in likely(gone)
    assert "The stub of Vector3.cross is gone" in likely(failed["B2.9"])
    assert "renamed it to cros," in likely(failed["B2.9"])


def test_an_error_that_the_student_raises_is_no_slip_in_python(messages: Messages) -> None:
    """Only dot raises its error. Three other methods fail because of mistakes in Python."""
    failed = messages(
        "ch02_vectors/vector.py",
        {
            whole("dot"): "    def dot(self, v):\n        if v: raise TypeError('no vector')\n",
            whole("cross"): "    def cross(self, v):\n        return self.y * 'z'\n",
            whole("__neg__"): "    def __neg__(self):\n        raise ValueError('v' + 1)\n",
            whole("magnitude"): "    def magnitude(self):\n        raise ValeuError('v')\n",
        },
    )
    assert "has the wrong type" in likely(failed["B2.9"])
    assert "TypeError: no vector" in "".join(failed["B2.8"])
    assert "has the wrong type" not in likely(failed["B2.8"])
    assert "has the wrong type" in likely(failed["B2.1"])
    assert "Did you mean ValueError?" in likely(failed["B2.2"])


def test_what_slots_can_hold(messages: Messages) -> None:
    """Every particle is made with a mass, so every check that makes one says it."""
    failed = messages(
        "ch03_laws_of_motion/particle.py",
        {r"self\._inverse_mass = not_negative\(\"1 / mass\"": "self._mass = (0"},
    )
    mass = likely(failed["B3.1"])
    assert "The closest to _mass is _inverse_mass." in mass
    assert "_damping, _inverse_mass, acceleration, position, velocity" in mass
    assert "_frame" not in mass


def test_misspelt_attributes_and_names(messages: Messages) -> None:
    failed = messages(
        "ch03_laws_of_motion/particle.py",
        {
            whole("momentum"): "    def momentum(self):\n        return Vecotr3()\n",
            r"self\.position\.add_scaled\(self\.velocity": "self.positon.add_scaled(self.velocity",
        },
    )
    assert "Did you mean Vector3?" in likely(failed["B3.2"])
    assert "Did you mean position?" in likely(failed["B3.4"])


def test_a_deleted_setter_and_a_getter_are_stubs_that_are_gone(messages: Messages) -> None:
    failed = messages(
        "ch03_laws_of_motion/particle.py", {r"    @damping\.setter\n" + whole("damping"): ""}
    )
    assert "The stub of Particle.damping.setter is gone" in likely(failed["B3.1"])
    assert "B3.1" in likely(failed["B3.1"])


def test_a_stub_without_which_the_module_cannot_be_read(messages: Messages) -> None:
    failed = messages("ch03_laws_of_motion/particle.py", {r"    @property\n" + whole("mass"): ""})
    every = [message for messages in failed.values() for message in messages]
    assert "The stub of Particle.mass is gone" in likely(every)
    assert "particle.py cannot be imported: NameError: name 'mass'" in " ".join(every)


def test_a_name_that_another_module_imports(messages: Messages) -> None:
    failed = messages(
        "ch02_vectors/exercises.py",
        {"from ch02_vectors.vector import": "from ch02_vectors.vector import Vectr3,"},
    )
    assert "ch02_vectors/vector.py has nothing called Vectr3. Did you mean Vector3?" in likely(
        failed["2.1"]
    )


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


def where(messages: list[str]) -> str:
    """Return the lines of the student's code that all the messages of an exercise show."""
    return " ".join(re.findall(r"(?m)^(?:where|inside) +.*$", "\n".join(messages)))


def test_a_name_of_the_course_is_imported_from_its_latest_chapter(messages: Messages) -> None:
    failed = messages(
        "ch07_constraints/detectors.py",
        {r"from ch02_vectors\.vector import Vector3\n": ""},
    )
    wanted = "Vector3 is not imported. Write from ch02_vectors.vector import Vector3 at the top"
    assert wanted in likely(failed["7.5"])
    assert "Did you mean" not in likely(failed["7.5"])


def test_the_latest_chapter_that_defines_a_name_counts() -> None:
    folders = [ROOT / "chapters"]
    for name, file, module in (
        ("Particle", "ch03_laws_of_motion/exercises.py", "ch03_laws_of_motion.particle"),
        ("Particle", "ch07_constraints/links.py", "ch05_forces.particle"),
        ("Rod", "ch08_mass_aggregate/bridge.py", "ch07_constraints.links"),
        ("Rod", "ch06_springs/springs.py", ""),  # a later chapter defines it
        ("Vector", "ch06_springs/springs.py", ""),
    ):
        assert module_that_defines(name, file, folders) == module


def test_what_is_none_is_named(messages: Messages) -> None:
    failed = messages(
        "ch05_forces/particle.py",
        {
            whole("clear_forces"): "    def clear_forces(self):\n        self._gone().x\n\n"
            "    def _gone(self): ...\n",
        },
    )
    assert "self._gone() returns None. Perhaps the function has no return" in likely(failed["B5.1"])


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
        ("[0 for _ in v]", "v"),
        ("print(*v)", "v"),
        ("1.0 + 'v'", ""),
    ],
)
def test_the_expression_that_was_none(code: str, none: str, tmp_path: Path) -> None:
    file = tmp_path / "code.py"
    file.write_text(f"result = {code}\n", encoding="utf-8")
    value = {"v.other.x": type("V", (), {"other": None}), "v() + 1.0": lambda: None}.get(code)
    with pytest.raises((TypeError, AttributeError)) as caught:
        exec(compile(file.read_text(encoding="utf-8"), str(file), "exec"), {"v": value})
    assert none_in(caught.value, str(caught.value)) == none


def test_wrong_numbers_of_arguments() -> None:
    for code, says in (
        ("f()", "The call passes no value for a and b."),
        ("f(1)", "The call passes no value for b."),
        ("f(1, 2, 3)", "The call passes 3 arguments, but the def line takes 2. Perhaps the def"),
        ("f(1, 2, 3, 4)", "The call passes 4 arguments, but the def line takes 2."),
        ("g()", "The call passes no value for c. Pass it by name."),
        ("a()", "Your code calls a value that isn't a function. Perhaps this value is a"),
    ):
        there = {"f": lambda a, b: (a, b), "g": lambda *, c: c, "a": True}
        with pytest.raises(TypeError) as caught:
            eval(code, there)
        assert fact_of(str(caught.value)).startswith(says)
        assert ("lacks self" in fact_of(str(caught.value))) is (code == "f(1, 2, 3)")


def test_a_power_with_a_caret_is_explained_wherever_it_fails(messages: Messages) -> None:
    failed = messages(
        "ch03_laws_of_motion/damping.py",
        {r"(?s)return velocity \*[^\n]*": "return velocity * damping ^ duration + acceleration"},
    )
    assert "powers are written with **" in likely(failed["B3.3"])
    assert "parentheses" not in likely(failed["B3.3"])


def test_the_line_of_the_exercise_comes_first_and_the_deepest_second(messages: Messages) -> None:
    failed = messages(
        "ch06_springs/springs.py",
        {r"    direction = offset": "    Vector3().add_scaled(1.0, 2.0)\n    direction = offset"},
    )
    lines = where(failed["B6.1"])
    first = lines.index("where     ch06_springs/springs.py")
    assert first < lines.index("inside    ch02_vectors/vector.py")


def test_a_stub_that_a_module_calls_is_not_written_yet(messages: Messages) -> None:
    stub = "    def __mul__(self, scalar):\n        raise NotImplementedError('Exercise B2.3: x')\n"
    failed = messages(
        "ch02_vectors/vector.py",
        {whole("__mul__"): stub, r"\Z": "\n\nGRAVITY = Vector3(0.0, -1.0, 0.0) * 9.81\n"},
    )
    every = [message for messages in failed.values() for message in messages]
    other = [m for m in every if "not written yet: Exercise B2.3" not in m]
    assert every
    assert other == []


def test_a_method_that_calls_itself_is_named_instead_of_the_physics(messages: Messages) -> None:
    failed = messages(
        "ch02_vectors/vector.py",
        {whole("magnitude"): "    def magnitude(self):\n        return self.magnitude()\n"},
    )
    assert likely(failed["B2.2"]).startswith("A function calls itself too many times.")


def test_the_check_s_cause_comes_before_a_guess(messages: Messages) -> None:
    failed = messages(
        "ch02_vectors/vector.py",
        {
            whole("magnitude"): "    def magnitude(self):\n        return [self.x].length\n",
            whole("dot"): "    def dot(self, v):\n        return [self.x][1]\n",
        },
    )
    cause, guess = (
        "likely    The magnitude of a vector",
        "or        Perhaps you misspelled the name",
    )
    assert failed["B2.2"][0].index(cause) < failed["B2.2"][0].index(guess)
    fact, cause = "likely    The index is past the end.", "or        Multiply the matching"
    assert failed["B2.8"][0].index(fact) < failed["B2.8"][0].index(cause)


def test_what_an_error_proves(messages: Messages) -> None:
    failed = messages(
        "ch02_vectors/vector.py",
        {
            whole("magnitude"): "    def magnitude(self):\n        return self.scale\n",
            whole("__mul__"): "    def __mul__(self, scale):\n        return self.scale\n",
            whole("dot"): "    def dot(self, v):\n        w = self.clear()\n        return w.x\n",
            whole("cross"): "    def cross(self, v):\n        return Vector3([1.0, 2.0, 3.0])\n",
        },
    )
    assert "Did you mean scale without self.?" not in likely(failed["B2.2"])
    assert "Vector3 has nothing called scale. Did you mean scale without self.?" in likely(
        failed["B2.3"]
    )
    assert "self.clear() returns None. Perhaps the function has no return statement, or it" in (
        likely(failed["B2.8"])
    )
    assert "so write Vector3(*numbers)" in likely(failed["B2.9"])


def test_a_method_without_its_parentheses_is_named(messages: Messages) -> None:
    unpacks = "    def dot(self, v):\n        x, y, z = self.copy\n        return x * v.x\n"
    failed = messages("ch02_vectors/vector.py", {whole("dot"): unpacks})
    assert "Add parentheses after the name to call it." in likely(failed["B2.8"])


def test_a_list_is_not_told_to_be_meant_for_a_list(messages: Messages) -> None:
    """No method of a list resembles contacts enough to be suggested."""
    uses = "    def dot(self, v):\n        return [self].contacts\n"
    failed = messages("ch02_vectors/vector.py", {whole("dot"): uses})
    assert "Did you mean count?" not in likely(failed["B2.8"])


def test_an_error_that_is_returned_instead_of_raised(messages: Messages) -> None:
    returns = "    if not 0 < duration < math.inf:\n        return ValueError('duration')\n"
    whole_function = r"def checked_duration\(.*?(?=\n\n\n)"
    failed = messages(
        "ch02_vectors/exercises.py",
        {whole_function: f"def checked_duration(duration):\n{returns}    return float(duration)"},
    )
    assert "no error; the call returned a ValueError" in "".join(failed["B2.11"])
    assert "Write raise instead of return." in likely(failed["B2.11"])


def test_none_that_a_method_in_place_has_returned(messages: Messages) -> None:
    returns = "    def normalized(self):\n        return self.copy().normalize()\n"
    failed = messages("ch02_vectors/vector.py", {whole("normalized"): returns})
    assert "such as normalize() or sort()" in likely(failed["B2.4"]) or "None" in likely(
        failed["B2.4"]
    )
