"""A handout has what students need, works on its own, and contains no solution."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.definitions import functions
from autograder.handouts.handout import KEPT, make_handout
from autograder.manifest import ROOT, Chapter, load_chapters
from copies import copy_tree
from graded import points_of
from made import made_stubs

CH02, CH03 = load_chapters()[:2]


def run(handout: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run a command in a handout, without this repository on the import path."""
    command = [sys.executable, "-P", "-m", *words]
    environment = {"PYTHONPATH": ".", "PYTHONUTF8": "1", "MPLBACKEND": "Agg"}
    environment |= {"SYSTEMROOT": "C:\\Windows"}
    return subprocess.run(
        command, cwd=handout, env=environment, capture_output=True, encoding="utf-8", check=False
    )


def test_a_student_can_check_the_stubs_and_then_an_answer(tmp_path: Path) -> None:
    make_handout([CH02], [], tmp_path / "out")
    before = run(tmp_path / "out", "autograder", "check", "--chapter", "2")
    assert before.returncode == 1, before.stderr
    assert f"] 0 of {points_of(CH02)} points" in before.stdout
    assert "Next: open chapters/ch02_vectors/vector.py:" in before.stdout
    for file in CH02.edited_files:
        source = ROOT / "sample_class/ada/ch02_vectors" / file
        shutil.copyfile(source, tmp_path / "out/chapters/ch02_vectors" / file)
    after = run(tmp_path / "out", "autograder", "check", "--chapter", "2")
    assert after.returncode == 0, after.stdout
    assert f"{points_of(CH02)} of {points_of(CH02)} points" in after.stdout


def test_the_stubs_are_made_anew_and_no_solution_goes_along(tmp_path: Path) -> None:
    root, out = tmp_path / "root", tmp_path / "out"
    shutil.copytree(
        ROOT, root, ignore=shutil.ignore_patterns(".venv", ".git", "build", "__pycache__")
    )
    solved = root / "chapters/ch02_vectors"
    copy_tree(ROOT / "solutions/ch02_vectors", solved)
    shutil.copyfile(solved / "vector.py", solved / "vector_old.py")
    make_handout([CH02], [], out, root)
    names = {path.relative_to(out).as_posix() for path in out.rglob("*") if path.is_file()}
    assert not [name for name in names if re.search("_old|solution|wrong|second|^sample_", name)]
    for path, text in made_stubs().items():
        if CH02.name in path:
            assert (out / path).read_text(encoding="utf-8") == text
            if path.endswith(".py"):  # make reset copies it from there
                kept = out / path.replace("chapters", KEPT, 1)
                assert kept.read_text(encoding="utf-8") == text
    assert "](tests/" not in (out / "docs/errata.md").read_text(encoding="utf-8")
    assert {"Makefile", "README.md", "glossary.md", "tests/ch02_vectors/probes.py"} <= names


def test_every_check_comes_with_what_it_imports_and_every_link_and_picture_is_there(
    tmp_path: Path,
) -> None:
    out = tmp_path / "out"
    make_handout(load_chapters(), [], out)
    for chapter in load_chapters():
        tests = ROOT / "tests" / chapter.name
        there = {file.name for file in (out / "tests" / chapter.name).iterdir()}
        assert there == {file.name for file in tests.glob("*.py")}
        assert_has_no_body_of_the_reference(out, chapter)
        folder = out / "chapters" / chapter.name
        targets = re.findall(r"\]\(([^)#:]+)\)", (folder / "README.md").read_text(encoding="utf-8"))
        assert [target for target in targets if not (folder / target).exists()] == []


def assert_has_no_body_of_the_reference(handout: Path, chapter: Chapter) -> None:
    """Assert that each body that students write has a line that no file of the handout's has."""
    for file in chapter.edited_files:
        source = (ROOT / "solutions" / chapter.name / file).read_text(encoding="utf-8")
        defined = functions(ast.parse(source))
        copies = (handout / folder / chapter.name / file for folder in ("chapters", KEPT))
        texts = [path.read_text(encoding="utf-8") for path in copies if path.is_file()]
        assert len(texts) == 2, "one to edit, and one for make reset"
        there = {line.strip() for text in texts for line in text.splitlines()}
        for edit in [edit for exercise in chapter.exercises for edit in exercise.edit]:
            module, _, name = edit.partition(".")
            if f"{module}.py" == file:
                body = defined[name].body[1 if ast.get_docstring(defined[name]) else 0 :]
                lines = source.splitlines()[body[0].lineno - 1 : body[-1].end_lineno]
                assert not {line.strip() for line in lines} <= there, edit


def test_a_link_to_a_later_lesson_is_plain_text(tmp_path: Path) -> None:
    make_handout([CH02, CH03], [], tmp_path / "out")
    lesson = tmp_path / "out/chapters/ch03_laws_of_motion/README.md"
    text = " ".join(lesson.read_text(encoding="utf-8").split())
    assert "[chapter 2](../ch02_vectors/README.md)" in text
    assert "springs that explode in chapter 6." in text
    for page in (tmp_path / "out").rglob("*.md"):
        targets = re.findall(r"\]\(([^)#:\s]+\.md)", page.read_text(encoding="utf-8"))
        assert [one for one in targets if not (page.parent / one).exists()] == [], page


def test_a_chapter_on_a_given_one_can_be_checked_and_drawn(tmp_path: Path) -> None:
    out = tmp_path / "out"
    make_handout([CH03], [CH02], out)
    assert (out / "chapters/ch02_vectors/arguments.py").exists()
    given = (out / "chapters/ch02_vectors/vector.py").read_text(encoding="utf-8")
    assert given == (ROOT / "solutions/ch02_vectors/vector.py").read_text(encoding="utf-8")
    assert not (out / "tests/ch02_vectors").exists()
    before = run(out, "autograder", "check").stdout
    assert f"] 0 of {points_of(CH03)} points" in before
    assert "Chapter 2:" not in before, "what is given is not checked"
    copy_tree(ROOT / "sample_class/ada" / CH03.name, out / "chapters" / CH03.name)
    after = run(out, "autograder", "check", "--chapter", "3").stdout
    assert f"{points_of(CH03)} of {points_of(CH03)} points" in after
    drawn = run(out, "plots", "draw", "--chapter", "3")
    assert drawn.returncode == 0, drawn.stdout + drawn.stderr
    assert (out / "build/plots/ch03_laws_of_motion/damping_comparison.png").exists()


def test_a_folder_with_something_in_it_and_a_chapter_named_twice_are_refused(
    tmp_path: Path,
) -> None:
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(ValueError, match="must be a new or empty folder, got"):
        make_handout([CH02], [], tmp_path)
    with pytest.raises(ValueError, match=r"got .*notes\.txt"):
        make_handout([CH02], [], tmp_path / "notes.txt")
    with pytest.raises(ValueError, match="both as stubs and as given"):
        make_handout([CH02], [CH02], tmp_path / "out")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["notes.txt"]
