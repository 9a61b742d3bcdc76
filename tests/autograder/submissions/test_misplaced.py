"""What is said of files outside their chapter's folder, and of work on other chapters."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.grader.grading import why_nothing
from autograder.manifest import ROOT, load_chapters
from autograder.submissions.stage import stage
from copies import copy_tree
from staging import CHAPTERS, CODE, EXERCISES, VECTOR, HandIn, boxed


@pytest.mark.parametrize(
    ("place", "where"),
    [
        (".", "at the top of what was handed in"),
        ("ch2", "in 'ch2'"),
        ("ch02_vectors/src", "in 'ch02_vectors/src'"),
        ("a/b/c", "in 'a/b/c'"),
        ("ch03_laws_of_motion", "in 'ch03_laws_of_motion'"),
        ("$(b)\x1b", "in another folder"),
    ],
)
@pytest.mark.parametrize("beside", [{}, {EXERCISES: CODE}])
def test_a_file_outside_its_chapters_folder_is_named_and_not_taken(
    hand_in: HandIn, place: str, where: str, beside: dict[str, bytes]
) -> None:
    why = (
        f"vector.py was found {where}, and not in a folder ch02_vectors. "
        "Put it into a folder ch02_vectors and hand in again"
    )
    made = hand_in({f"{place}/vector.py".removeprefix("./"): CODE, **beside})
    assert boxed(made) == (beside, {VECTOR: why}, [])


def test_files_of_one_name_are_named_for_each_chapter_that_lacks_one(hand_in: HandIn) -> None:
    made = hand_in({f"ch{n}/exercises.py": CODE for n in "2345"} | {VECTOR: CODE})
    start = "exercises.py was found in 'ch2', and not in a"
    files, missing, _ = boxed(made)
    assert files == {VECTOR: CODE}
    assert missing == {
        f"{name}/exercises.py": f"{start} folder {name}. "
        f"Put the one for chapter {number} into a folder {name} and hand in again"
        for number, name in ((2, "ch02_vectors"), (3, "ch03_laws_of_motion"))
    }


def test_a_file_in_the_folder_of_a_chapter_that_has_one_is_not_misplaced(hand_in: HandIn) -> None:
    """Both chapters have a file exercises.py, and arguments.py comes with chapter 2."""
    made = hand_in({EXERCISES: CODE, "ch02_vectors/arguments.py": CODE})
    assert boxed(made) == ({EXERCISES: CODE}, {}, [])
    # Similarity and marking do not read all chapters.
    staged = stage(made, CHAPTERS[1:], made.parent / "box")
    assert (staged.taken, staged.misplaced) == ([], [])


def test_no_other_file_of_a_handout_is_taken_for_a_students_work(
    hand_in: HandIn, tmp_path: Path
) -> None:
    """Students may hand in their whole handout, with its own code."""
    for name in ("scenes", "plots", "lab", "tests/shared"):
        copy_tree(ROOT / name, tmp_path / "handout" / name)
    files = [path for path in (tmp_path / "handout").rglob("*.py") if path.is_file()]
    made = hand_in({str(path.relative_to(tmp_path)): b"" for path in files})
    staged = stage(made, load_chapters(), tmp_path / "box")
    assert (staged.taken, staged.rejected) == ([], {})


@pytest.mark.parametrize("place", ["work/ch2", ""])
def test_a_stub_of_the_handout_does_not_stand_for_a_misplaced_file(
    hand_in: HandIn, place: str
) -> None:
    stub = {f"work/stubs/{VECTOR}": b"stub"}
    files, missing, _ = boxed(hand_in(stub | ({f"{place}/vector.py": CODE} if place else {})))
    assert files == ({} if place else {VECTOR: b"stub"})
    assert [why.split(", and not")[0] for why in missing.values()] == (
        ["vector.py was found in 'work/ch2'"] if place else []
    )


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({VECTOR: CODE}, "it has no files of ch03_laws_of_motion, only of ch02_vectors"),
        ({VECTOR: b"\0"}, "it has no files of ch03_laws_of_motion, only of ch02_vectors"),
        (
            {VECTOR: CODE, "particle.py": CODE},
            "particle.py was found at the top of what was handed in, and not in a folder "
            "ch03_laws_of_motion. Put it into a folder ch03_laws_of_motion and hand in again",
        ),
        ({"ch03_laws_of_motion/particle.py": CODE}, ""),
        ({"ch03_laws_of_motion/particle.py": b"\0"}, ""),
    ],
)
def test_work_on_other_chapters_than_the_graded_ones_is_nothing_to_grade(
    hand_in: HandIn, tmp_path: Path, files: dict[str, bytes], why: str
) -> None:
    (tmp_path / "box").mkdir()
    staged = stage(hand_in(files), CHAPTERS, tmp_path / "box")
    assert why_nothing(staged, CHAPTERS[1:]) == why
