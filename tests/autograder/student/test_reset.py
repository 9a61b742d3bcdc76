"""Reset puts back the stub of one exercise, keeps what was there, and touches nothing else."""

from __future__ import annotations

import ast
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

from autograder.__main__ import main
from autograder.definitions import functions
from autograder.handouts.stubs import with_bodies
from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from autograder.student.reset import question, reset
from copies import copy_tree
from made import made_stubs
from small import RIGHT, STUB, make_students_root
from typed import typed

CHAPTERS = load_chapters()
CH02 = CHAPTERS[0]


@pytest.fixture
def copies(tmp_path: Path) -> Path:
    return tmp_path / "copies"


@pytest.fixture
def vector(tmp_path: Path) -> Path:
    """The module vector.py of the reference in an engine, which is the folder for the test."""
    return engine_of(CH02, tmp_path) / CH02.name / "vector.py"


def engine_of(chapter: Chapter, folder: Path) -> Path:
    copy_tree(ROOT / "solutions" / chapter.name, folder / chapter.name)
    return folder


def stub_of(chapter: Chapter, file: str = "vector.py") -> str:
    return made_stubs()[f"chapters/{chapter.name}/{file}"]


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


def edited(exercises: list[Exercise], file: str) -> set[str]:
    """Return the names in a file that exercises have students write."""
    parts = [name.partition(".") for exercise in exercises for name in exercise.edit]
    return {name for module, _, name in parts if f"{module}.py" == file}


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_an_exercise_is_reset_and_all_else_stays(
    chapter: Chapter, tmp_path: Path, copies: Path
) -> None:
    """Imports, constants and helpers stay too: another exercise may use them."""
    engine = engine_of(chapter, tmp_path / "engine")
    texts = {path: path.read_text(encoding="utf-8") for path in engine.rglob("*.py")}
    for exercise in (exercise for exercise in chapter.exercises if exercise.edit):
        reset(chapter, exercise, engine, copies)
        for path, before in texts.items():
            names = edited([exercise], path.name)
            texts[path] = path.read_text(encoding="utf-8")
            assert (texts[path] != before) == bool(names)
            if names:
                now, rest = taken_apart(texts[path], names)
                assert rest == taken_apart(before, names)[1]
                assert now == taken_apart(stub_of(chapter, path.name), names)[0]


def test_the_file_as_it_was_is_kept_and_no_copy_is_overwritten(
    vector: Path, tmp_path: Path, copies: Path
) -> None:
    normalize, add = CH02.exercise("B2.4"), CH02.exercise("B2.5")
    asked = question(CH02, normalize, tmp_path, copies)
    for words in ("B2.4", "Vector3.normalize, Vector3.normalized", "vector.py", str(copies)):
        assert words in asked
    first = vector.read_bytes()
    said = reset(CH02, add, tmp_path, copies)
    assert f"A copy of your previous file: {copies}/ch02_vectors/vector-1.py" in said
    assert "Vector3.__add__, Vector3.__iadd__, Vector3.__sub__, Vector3.__isub__" in said
    second = vector.read_bytes()
    reset(CH02, normalize, tmp_path, copies)
    assert "already has the stub" in reset(CH02, normalize, tmp_path, copies)
    kept = sorted((copies / CH02.name).iterdir())
    assert [copy.read_bytes() for copy in kept] == [first, second]


@pytest.mark.parametrize(
    ("above", "body", "stub", "below"),
    [
        ("def f():", " 'Doc.'; return 1", "\n    'Doc.'\n    RAISE", ""),
        ("\ufeffdef f():", " return 1", "\n    RAISE", "\n"),  # with a BOM
        (
            "import x  # ä\r\n\r\n@x\r\ndef f(a,\r\n  b):",
            "\r\n\tif a:\r\n\t\tf()",
            "\r\n\tRAISE",
            "",
        ),
        (
            "class C:\n def f(s, x='ä'): 'ö'; f()\n\ndef f():  # ä",
            "\n  return 2",
            "\n  RAISE",
            "\n#",
        ),
        ("def f():", "\n  return 'ö'  # ä", "\n  RAISE", "\nasync def g():\n  return 'ä'"),
    ],
)
def test_a_students_own_way_of_writing_stays(above: str, body: str, stub: str, below: str) -> None:
    after = with_bodies((above + body + below).encode(), {"f": "RAISE"})
    assert after.decode() == above + stub + below


@pytest.mark.parametrize(
    ("content", "why"),
    [
        ("x = (\n", "it cannot be read: line 1: '(' was never closed"),
        ("class Vector3:\n    def normalize(self): ...\n", "not define Vector3.normalized."),
        (None, "it does not define Vector3.normalize, Vector3.normalized."),
    ],
)
def test_a_file_without_such_a_body_is_left_alone_and_the_way_out_works(
    content: str | None, why: str, vector: Path, tmp_path: Path, copies: Path
) -> None:
    vector.unlink()
    if content is not None:
        vector.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=r"make reset EX=B2\.4 WHOLE=1 ENGINE=") as error:
        reset(CH02, CH02.exercise("B2.4"), tmp_path, copies)
    assert why in str(error.value)
    assert not copies.exists()
    assert (vector.read_text(encoding="utf-8") if vector.exists() else None) == content
    reset(CH02, CH02.exercise("B2.4"), tmp_path, copies, whole=True)
    assert vector.read_text(encoding="utf-8") == stub_of(CH02)
    if content is not None:
        assert (copies / CH02.name / "vector-1.py").read_text(encoding="utf-8") == content


def test_a_hand_out_can_do_it_too_without_solutions(tmp_path: Path) -> None:
    root = make_students_root(tmp_path)
    reset_by = partial(typed, "autograder", "reset", cwd=root, PYTHONPATH=str(root))
    file = root / "chapters/ch90_small/small.py"
    file.write_text(RIGHT, encoding="utf-8")
    done = reset_by("b90.1")
    assert done.returncode == 0, done.stderr
    stub = 'raise NotImplementedError("Exercise B90.1: Double")'
    assert file.read_text(encoding="utf-8") == RIGHT.replace("return x + x", stub)
    assert "your previous file: build/reset/ch90_small/small-1.py" in done.stdout
    file.write_bytes(b"x = (\n")
    for options in ((), ("--whole",)):
        done = reset_by("B90.1", *options)
        assert done.returncode == 2
        assert "opy the file from the handout again" in done.stderr
        assert file.read_bytes() == b"x = (\n"
    kept = root / "stubs/ch90_small/small.py"  # as a handout has it
    kept.parent.mkdir(parents=True)
    kept.write_text(STUB, encoding="utf-8")
    assert "EX=B90.1 WHOLE=1" in reset_by("B90.1").stderr
    assert reset_by("B90.1", "--whole").returncode == 0
    assert file.read_text(encoding="utf-8") == STUB


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
