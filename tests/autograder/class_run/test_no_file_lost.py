"""No command writes over files that it did not make, or leaves a newer download unread."""

from __future__ import annotations

import csv
import multiprocessing
import zipfile
from pathlib import Path

import pytest

from autograder.course.model import Work
from autograder.grader import cohort
from autograder.grader.cohort import ClassOptions
from autograder.manifest import load_chapters, select_chapters
from autograder.platforms.gradescope import make_gradescope
from autograder.similarity.run import similarity
from autograder.submissions.class_list import read_class
from autograder.submissions.codes import with_codes
from autograder.submissions.unpack import class_folder
from small_class import everything_in, grade
from typed import typed


def test_grades_and_pages_never_go_among_other_files(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    out = tmp_path / "website"
    out.mkdir()
    (out / "index.html").write_text("mine", encoding="utf-8")
    with pytest.raises(ValueError, match=r"has other files, such as index.html. Name another one"):
        grade(submissions, out, root)
    with pytest.raises(ValueError, match=r"it has other files. Name another one"):
        similarity(submissions, out, load_chapters(root), root=root)
    assert everything_in(out) == "mine"
    grade(submissions, tmp_path / "out", root)
    before = everything_in(tmp_path / "out")
    with pytest.raises(ValueError, match=r"it has other files. Name another one"):
        similarity(submissions, tmp_path / "out", load_chapters(root), root=root)
    assert everything_in(tmp_path / "out") == before


def test_the_zip_for_gradescope_replaces_only_an_earlier_one(tmp_path: Path) -> None:
    work, out = Work("", select_chapters("2")), tmp_path / "lab1.zip"
    for content in ("text", "zip"):
        if content == "zip":
            with zipfile.ZipFile(out, "w") as file:
                file.writestr("ann/work.py", "x = 1")
        else:
            out.write_text(content, encoding="utf-8")
        before = out.read_bytes()
        with pytest.raises(ValueError, match=r"lab1.zip is another file, such as a download of su"):
            make_gradescope(work, out)
        assert out.read_bytes() == before
    for _ in range(2):
        make_gradescope(work, tmp_path / "autograder.zip")


def test_the_grades_of_other_chapters_are_never_replaced(
    submissions: Path, root: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    grade(submissions, out, root)
    before = everything_in(out)
    options = ClassOptions(root=root, unsafe=True, given=select_chapters("2"))
    with pytest.raises(
        ValueError, match=r"the grades of chapters 90, and not of chapters 90 on gi"
    ):
        cohort.grade(submissions, out, load_chapters(root), options)
    with pytest.raises(
        ValueError, match=r"the grades of chapters 90, and not of chapters 2\. To k"
    ):
        cohort.grade(submissions, out, select_chapters("2"), ClassOptions(unsafe=True))
    assert everything_in(out) == before


def test_the_class_is_graded_again_on_the_same_chapters_and_never_from_an_older_zip(
    tmp_path: Path,
) -> None:
    out, zipped = tmp_path / "out", tmp_path / "lab1.zip"

    def download(*students: str) -> None:
        with zipfile.ZipFile(zipped, "w") as file:
            for student in students:
                file.writestr(f"{student}/ch02_vectors/vector.py", "x = 1\n")

    download("ann")
    command = ("autograder", "grade", "--out", out)
    first = typed(*command, zipped, "--chapters", "2")
    assert first.returncode == 0, first.stderr
    download("ann", "bob")
    newer = typed(*command)
    assert (newer.returncode, "lab1.zip has changed since it was unp" in newer.stderr) == (2, True)
    assert typed(*command, zipped, "--chapters", "2").returncode == 0
    again = typed(*command)
    assert again.returncode == 0, again.stderr
    with (out / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        _, *rows = csv.DictReader(file)
    assert [row["student"] for row in rows] == ["ann", "bob"]
    assert not any(name.startswith("B3.") for name in rows[0]), "only chapter 2"


def test_names_are_not_put_into_the_folder_of_an_anonymous_class(
    submissions: Path, root: Path
) -> None:
    with pytest.raises(ValueError, match="must not be in the folder of an anonymous class"):
        grade(submissions, submissions / "grades", root, anonymous=True)
    assert sorted(path.name for path in submissions.iterdir()) == ["ann", "bob", "cem.zip"]


def test_a_key_file_keeps_the_codes_of_other_assignments(submissions: Path, tmp_path: Path) -> None:
    key = tmp_path / "key.csv"
    first = with_codes(read_class(submissions), key)
    (submissions / "ann").rename(submissions / "zoe")
    second = with_codes(read_class(submissions), key)
    with key.open(encoding="utf-8", newline="") as file:
        rows = {row["code"]: row["submission"] for row in csv.DictReader(file)}
    codes = {m.shown for m in (*first.members, *second.members)}
    assert {*rows} == codes | {"(secret)"}
    assert sorted(rows[code] for code in codes) == ["ann", "bob", "cem", "zoe"]


def unpacked_into(zipped: Path, found: Path) -> None:
    folder = class_folder(zipped)
    found.write_text(str(len([*folder.glob("*/work.py")])), encoding="utf-8")


def test_two_commands_that_unpack_one_zip_both_find_everything(tmp_path: Path) -> None:
    zipped = tmp_path / "lab1.zip"
    with zipfile.ZipFile(zipped, "w") as file:
        for number in range(300):
            file.writestr(f"student {number}/work.py", "x = 1\n")
    context = multiprocessing.get_context("fork")
    found = [tmp_path / f"found{i}" for i in range(4)]
    runs = [context.Process(target=unpacked_into, args=(zipped, path)) for path in found]
    for run in runs:
        run.start()
    for run in runs:
        run.join()
        assert run.exitcode == 0
    assert {path.read_text(encoding="utf-8") for path in found} == {"300"}
