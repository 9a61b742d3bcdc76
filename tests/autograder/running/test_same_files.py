"""A file that the grader rejects is rejected at home too, in the same words."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from autograder.answers import questions_of
from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict
from autograder.manifest import ROOT, load_chapters
from autograder.message import Kind, Message
from autograder.submissions.stage import stage
from copies import copy_tree, edit
from small import RIGHT, hand_in
from typed import typed
from walls import behind_walls

VECTOR = "ch02_vectors/vector.py"
# Each change makes a right file into one that the grader rejects.
CHANGES: dict[str, Callable[[Path], object]] = {
    "latin-1": lambda file: file.write_bytes(
        b"# -*- coding: latin-1 -*-\n# Stra\xdfe\n" + file.read_bytes()
    ),
    "NUL": lambda file: file.write_bytes(file.read_bytes() + b"# \0\n"),
    "large": lambda file: file.write_bytes(file.read_bytes() + b"#\n" * 500_000),
    "link": lambda file: file.symlink_to(file.rename(file.with_name("mine.txt"))),
    "linked folder": lambda file: file.parent.symlink_to(
        file.parent.rename(file.parent.with_name("elsewhere"))
    ),
    "folder": lambda file: file.unlink() or file.mkdir(),
    "renamed": lambda file: file.rename(file.with_stem(f"{file.stem} (1)")),
}
posix = ("link", "linked folder")


def changed(change: str, file: Path) -> None:
    if change in posix and sys.platform == "win32":
        pytest.skip("on Windows only an administrator can make links")
    CHANGES[change](file)


def run(root: Path) -> list[Verdict]:
    (chapter,) = load_chapters(root)
    return run_checks(chapter, [root / "ann"], seed="1", root=root)


@pytest.mark.parametrize("change", CHANGES)
def test_check_rejects_what_the_grader_rejects(change: str, root: Path) -> None:
    hand_in(root, "ann", RIGHT)
    assert {verdict.status for verdict in run(root)} == {"passed"}
    changed(change, root / "ann/ch90_small/small.py")
    staged = stage(root / "ann", load_chapters(root), root / "box", root)
    why = staged.rejected["ch90_small.small"]
    assert why.startswith("ch90_small/small.py was rejected: ")
    for verdict in run(root):
        assert verdict.status in ("failed", "blocked")
        assert verdict.message.title == why


@pytest.mark.parametrize("change", ["latin-1", "large"])
def test_scenes_plots_and_recordings_reject_what_the_grader_rejects(
    change: str, tmp_path: Path
) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "ann")
    changed(change, tmp_path / "ann" / VECTOR)
    why = stage(tmp_path / "ann", load_chapters()[:1], tmp_path / "box").rejected[
        "ch02_vectors.vector"
    ]
    load = '{"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}\n'
    for arguments, text in (
        (("plots", "draw", "--chapter", "2", "--out", tmp_path / "plots"), ""),
        (("lab", "record", "ball-game", "--out", tmp_path), ""),
        (("lab.child", "--stack", tmp_path / "stack.txt"), load),
    ):
        assert why in typed(*arguments, "--engine", tmp_path / "ann", text=text).stdout


def test_rejected_answers_are_reported_at_home_in_the_same_words(tmp_path: Path) -> None:
    chapter = load_chapters()[0]
    copy_tree(ROOT / "solutions/ch02_vectors", tmp_path / "class/ann/ch02_vectors")
    with (tmp_path / "class/ann/ch02_vectors/answers.md").open("ab") as file:
        file.write(b"Stra\xdfe\n")
    why = "ch02_vectors/answers.md was rejected: it is not UTF-8: save it as UTF-8 in your editor"
    questions = questions_of(chapter, [tmp_path / "class/ann"])
    assert questions
    for question in questions:
        assert question.problems == [why]
        assert not question.answered


@pytest.mark.parametrize("change", ["latin-1", "renamed"])
def test_rejected_data_have_the_same_verdict_and_reason_at_home(change: str, root: Path) -> None:
    manifest, own = root / "chapters/ch90_small/chapter.toml", 'edit = ["small.double"]'
    edit(manifest, own, f'{own}\nfiles = ["data.csv"]')
    code = RIGHT + "\nfrom pathlib import Path\nFILE = Path(__file__).with_name('data.csv')\n"
    code = code.replace("return x + x", "return 2 * x * float(FILE.read_text())")
    shutil.rmtree(root / "solutions")
    for name in ("ann", "solutions"):
        hand_in(root, name, code)
        (root / name / "ch90_small/data.csv").write_text("1\n", encoding="utf-8")
    assert {verdict.status for verdict in run(root)} == {"passed"}
    changed(change, root / "ann/ch90_small/data.csv")
    (chapter,) = load_chapters(root)
    staged = stage(root / "ann", [chapter], root / "box", root)
    why = staged.rejected["ch90_small.data.csv"]
    missing = {"ch90_small.data.csv": Message(why, kind=Kind.BROKEN)}
    behind = replace(behind_walls(), missing=missing)
    graded = run_checks(chapter, [root / "box"], seed="1", root=root, sandbox=behind)
    home = run(root)
    told, in_grading = ([(v.status, str(v.message)) for v in of] for of in (home, graded))
    assert told == in_grading
    assert home[0].status == "failed"
    assert home[0].message.likely == why
