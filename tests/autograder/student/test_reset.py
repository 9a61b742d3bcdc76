"""Reset puts back the stub of one exercise, keeps what was there, and touches nothing else."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path
from subprocess import CompletedProcess
from types import SimpleNamespace

import pytest

from autograder.__main__ import main
from autograder.definitions import functions
from autograder.handouts.bodies import put_back
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.student.reset import question, reset
from made import made_stubs
from small import RIGHT, STUB, make_students_root
from typed import typed

CHAPTERS = load_chapters()
CH02 = CHAPTERS[0]


def engine_of(chapter: Chapter, folder: Path) -> Path:
    """Copy the modules of a chapter's reference into an engine."""
    (folder / chapter.name).mkdir(parents=True)
    for name in chapter.edited_files:
        shutil.copyfile(ROOT / "solutions" / chapter.name / name, folder / chapter.name / name)
    return folder


def taken_apart(source: str, names: set[str]) -> tuple[dict[str, str], str]:
    """Return the text of the functions of these names, and all the rest of the module's text."""
    lines = source.splitlines(keepends=True)
    parts, rest, at = {}, "", 0
    defined = sorted(functions(ast.parse(source)).items(), key=lambda item: item[1].lineno)
    for name, node in defined:
        if name in names:
            rest += "".join(lines[at : node.lineno - 1]) + f"<{name}>\n"
            at = node.end_lineno or 0
            parts[name] = "".join(lines[node.lineno - 1 : at])
    return parts, rest + "".join(lines[at:])


def edited(chapter: Chapter, file: str, exercises: set[str] | None = None) -> set[str]:
    """Return the names in a file that these exercises, or all of them, have students write."""
    stem = file.removesuffix(".py")
    return {
        name.removeprefix(f"{stem}.")
        for exercise in chapter.exercises
        for name in exercise.edit
        if name.startswith(f"{stem}.") and (exercises is None or exercise.id in exercises)
    }


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_all_exercises_reset_are_the_bodies_of_the_stubs(chapter: Chapter, tmp_path: Path) -> None:
    engine = engine_of(chapter, tmp_path / "engine")
    for exercise in chapter.exercises:
        if exercise.edit:
            reset(chapter, exercise, engine, tmp_path / "copies")
    for name in chapter.edited_files:
        solution = (ROOT / "solutions" / chapter.name / name).read_text(encoding="utf-8")
        after = (engine / chapter.name / name).read_text(encoding="utf-8")
        names = edited(chapter, name)
        stub = made_stubs()[f"chapters/{chapter.name}/{name}"]
        assert taken_apart(after, names)[0] == taken_apart(stub, names)[0]
        # Imports, constants and helpers are left: another exercise may use them.
        assert taken_apart(after, names)[1] == taken_apart(solution, names)[1]


@pytest.mark.parametrize(
    ("number", "exercise_id"), [(2, "B2.5"), (3, "B3.1"), (6, "6.4"), (9, "B9.3")]
)
def test_one_exercise_is_reset_and_the_answers_to_the_others_stay(
    number: int, exercise_id: str, tmp_path: Path
) -> None:
    chapter = next(chapter for chapter in CHAPTERS if chapter.number == number)
    engine = engine_of(chapter, tmp_path / "engine")
    reset(chapter, chapter.exercise(exercise_id), engine, tmp_path / "copies")
    changed = 0
    for name in chapter.edited_files:
        solution = (ROOT / "solutions" / chapter.name / name).read_text(encoding="utf-8")
        after = (engine / chapter.name / name).read_text(encoding="utf-8")
        own = edited(chapter, name, {exercise_id})
        now, rest = taken_apart(after, own)
        assert rest == taken_apart(solution, own)[1]
        assert now == taken_apart(made_stubs()[f"chapters/{chapter.name}/{name}"], own)[0]
        changed += after != solution
    assert changed


def test_the_file_as_it_was_is_kept_and_no_copy_is_overwritten(tmp_path: Path) -> None:
    engine, copies = engine_of(CH02, tmp_path / "engine"), tmp_path / "copies"
    file = engine / CH02.name / "vector.py"
    first = file.read_bytes()
    said = reset(CH02, CH02.exercise("B2.5"), engine, copies)
    assert f"A copy of your previous file: {copies}/ch02_vectors/vector-1.py" in said
    assert "Vector3.__add__, Vector3.__iadd__, Vector3.__sub__, Vector3.__isub__" in said
    second = file.read_bytes()
    reset(CH02, CH02.exercise("B2.4"), engine, copies)
    kept = sorted((copies / CH02.name).iterdir())
    assert [copy.read_bytes() for copy in kept] == [first, second]
    assert "already has the stub" in reset(CH02, CH02.exercise("B2.4"), engine, copies)
    assert sorted((copies / CH02.name).iterdir()) == kept


def test_a_students_own_way_of_writing_stays(tmp_path: Path) -> None:
    """Line ends of Windows, a second indent, an answer on the line of the def, a lost end."""
    file = tmp_path / CH02.name / "exercises.py"
    file.parent.mkdir()
    before = (
        "import math  # mine\r\n\r\n"
        "def angle(a, b): 'Return it.'; return math.pi\r\n\r\n"
        "async def other():\r\n  return 'ä'"
    )
    exercise = next(e for e in CH02.exercises if e.edit and e.edit[0].startswith("exercises."))
    name = exercise.edit[0].removeprefix("exercises.")
    before = before.replace("angle", name)
    file.write_bytes(before.encode())
    alone = [e for e in CH02.exercises if e.edit == [f"exercises.{name}"]]
    reset(CH02, alone[0], tmp_path, tmp_path / "copies")
    text = file.read_bytes().decode()
    assert text.startswith(f"import math  # mine\r\n\r\ndef {name}(a, b):")
    assert text.endswith("async def other():\r\n  return 'ä'")
    assert text.count("\n") == text.count("\r\n")
    body = functions(ast.parse(text))[name].body
    wanted = f"raise NotImplementedError('Exercise {exercise.id}: {exercise.title}')"
    assert [ast.unparse(node) for node in body] == ["'Return it.'", wanted]


@pytest.mark.parametrize(
    ("content", "why"),
    [
        ("x = (\n", "it cannot be read: line 1: '(' was never closed"),
        ("class Vector3:\n    normalize = normalized = len\n", "Vector3.normalized without a def"),
        (None, "it does not exist"),
    ],
)
def test_a_file_without_such_a_body_is_left_alone_and_the_way_out_works(
    content: str | None, why: str, tmp_path: Path
) -> None:
    file = tmp_path / CH02.name / "vector.py"
    file.parent.mkdir()
    if content is not None:
        file.write_text(content, encoding="utf-8")
    exercise, copies = CH02.exercise("B2.4"), tmp_path / "copies"
    with pytest.raises(ValueError, match=r"make reset EX=B2\.4 WHOLE=1 ENGINE=") as error:
        reset(CH02, exercise, tmp_path, copies)
    assert why in str(error.value)
    assert not copies.exists()
    assert (file.read_text(encoding="utf-8") if file.exists() else None) == content
    reset(CH02, exercise, tmp_path, copies, whole=True)
    assert file.read_text(encoding="utf-8") == made_stubs()[f"chapters/{CH02.name}/vector.py"]
    if content is not None:
        assert (copies / CH02.name / "vector-1.py").read_text(encoding="utf-8") == content


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_functions_that_were_deleted_come_back_where_they_were(chapter: Chapter) -> None:
    for file in chapter.edited_files:
        stub = made_stubs()[f"chapters/{chapter.name}/{file}"]
        every = [name for name in functions(ast.parse(stub)) if name in edited(chapter, file)]
        # The first is put where nothing of the exercises comes before it.
        for gone in (every[::2], every[:1], every[-1:]):
            left = without(stub, set(gone))
            assert not functions(ast.parse(left)).keys() & set(gone)
            assert put_back(left.encode(), stub.encode(), gone).decode() == stub


def without(source: str, gone: set[str]) -> str:
    """Return a module without these functions, by its lines: as an editor deletes them."""
    lines = source.splitlines(keepends=True)
    for name, node in functions(ast.parse(source)).items():
        if name in gone:
            first = min(part.lineno for part in (node, *node.decorator_list)) - 1
            while first and not lines[first - 1].strip():
                first -= 1
            lines[first : node.end_lineno] = ["\0"] * ((node.end_lineno or 0) - first)
    return "".join(line for line in lines if line != "\0")


def test_only_what_is_gone_is_put_back_and_the_rest_of_the_exercise_stays(tmp_path: Path) -> None:
    engine, copies = engine_of(CH02, tmp_path / "engine"), tmp_path / "copies"
    file = engine / CH02.name / "vector.py"
    solved = file.read_text(encoding="utf-8")
    file.write_text(without(solved, {"Vector3.clear"}), encoding="utf-8")
    asked = question(CH02, CH02.exercise("B2.1"), engine, copies)
    assert "missing stub of Vector3.clear" in asked
    said = reset(CH02, CH02.exercise("B2.1"), engine, copies)
    assert "Vector3.clear" in said
    assert "Vector3.copy" not in said
    now, rest = taken_apart(file.read_text(encoding="utf-8"), {"Vector3.clear"})
    assert rest == taken_apart(solved, {"Vector3.clear"})[1]
    stub = made_stubs()[f"chapters/{CH02.name}/vector.py"]
    assert now == taken_apart(stub, {"Vector3.clear"})[0]
    reset(CH02, CH02.exercise("B2.1"), engine, copies)  # now all of the exercise
    now, _ = taken_apart(file.read_text(encoding="utf-8"), {"Vector3.copy"})
    assert now == taken_apart(stub, {"Vector3.copy"})[0]


def test_a_class_that_was_deleted_comes_back_whole(tmp_path: Path) -> None:
    file = tmp_path / CH02.name / "vector.py"
    file.parent.mkdir()
    file.write_text("import math\n\nmine = math.pi\n", encoding="utf-8")
    reset(CH02, CH02.exercise("B2.4"), tmp_path, tmp_path / "copies")
    text = file.read_text(encoding="utf-8")
    assert text.startswith("import math\n\nmine = math.pi\n")
    stub = ast.parse(made_stubs()[f"chapters/{CH02.name}/vector.py"])
    members = {name for name in functions(stub) if name.startswith("Vector3.")}
    assert functions(ast.parse(text)).keys() == members


def test_the_question_names_the_exercise_the_functions_and_the_copy(tmp_path: Path) -> None:
    engine = engine_of(CH02, tmp_path / "engine")
    asked = question(CH02, CH02.exercise("B2.4"), engine, tmp_path / "copies")
    for words in ("B2.4", "Vector3.normalize, Vector3.normalized", "vector.py", "copies"):
        assert words in asked


def test_a_hand_out_can_do_it_too_without_solutions(tmp_path: Path) -> None:
    root = make_students_root(tmp_path)
    file = root / "chapters/ch90_small/small.py"
    file.write_text(RIGHT, encoding="utf-8")
    done = autograder(root, "reset", "b90.1")
    assert done.returncode == 0, done.stderr
    stub = 'raise NotImplementedError("Exercise B90.1: Double")'
    assert file.read_text(encoding="utf-8") == RIGHT.replace("return x + x", stub)
    assert "your previous file: build/reset/ch90_small/small-1.py" in done.stdout
    file.write_bytes(b"x = (\n")
    for arguments in (("reset", "B90.1"), ("reset", "B90.1", "--whole")):
        done = autograder(root, *arguments)
        assert done.returncode == 2
        assert "opy the file from the handout again" in done.stderr
        assert file.read_bytes() == b"x = (\n"
    kept = root / "stubs/ch90_small/small.py"  # as a handout has it
    kept.parent.mkdir(parents=True)
    kept.write_text(STUB, encoding="utf-8")
    assert "EX=B90.1 WHOLE=1" in autograder(root, "reset", "B90.1").stderr
    assert autograder(root, "reset", "B90.1", "--whole").returncode == 0
    assert file.read_text(encoding="utf-8") == STUB
    file.write_text(RIGHT.partition("def quadruple")[0], encoding="utf-8")
    done = autograder(root, "reset", "90.1")
    assert "restored the missing stub" in done.stdout
    written = file.read_text(encoding="utf-8")
    assert written == RIGHT.partition("def quadruple")[0] + STUB[STUB.index("def quadruple") :]


def autograder(root: Path, *arguments: str) -> CompletedProcess[str]:
    return typed("autograder", *arguments, cwd=root, PYTHONPATH=str(root))


@pytest.mark.parametrize(("answer", "says", "code"), [("n", "Nothing was", 1), ("y", "stub", 0)])
def test_a_student_in_a_terminal_is_asked_first(
    answer: str,
    says: str,
    code: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The stubs of this repository are untouched, so that a yes changes nothing either."""
    asked: list[str] = []
    monkeypatch.setattr("sys.stdin", SimpleNamespace(isatty=lambda: True))
    monkeypatch.setattr("builtins.input", lambda text: asked.append(text) or answer)
    monkeypatch.setattr("sys.argv", ["autograder", "reset", "B2.2"])
    assert main() == code
    assert "Reset B2.2 Length? This replaces your code for" in asked[0]
    assert says in capsys.readouterr().out
