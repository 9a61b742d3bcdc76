"""Written answers: what counts as one, what a student has damaged, and what is shown when."""

from __future__ import annotations

import re
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from autograder.answers import PLACE, blank_answers, model_answer, questions_of, sections_of
from autograder.handouts.handout import make_handout
from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from typed import typed

CH02 = load_chapters()[0]
WRITTEN = [(c, e) for c in load_chapters() for e in c.exercises if e.kind == "written"]
BLANK = (ROOT / "chapters/ch02_vectors/answers.md").read_text(encoding="utf-8")
BEFORE, AFTER = BLANK.split(PLACE)[0], BLANK.split(PLACE, 1)[1]  # around the first answer
ANSWER = "The lengths are never negative."


def put(folder: Path, text: str) -> list[Path]:
    """Return an engine with this answers.md in chapter 2."""
    file = folder / "ch02_vectors/answers.md"
    file.parent.mkdir(exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return [folder]


def check(exercise: str, engine: Path | str, root: Path = ROOT) -> CompletedProcess[str]:
    return typed("autograder", "check", "--exercise", exercise, "--engine", engine, cwd=root)


@pytest.mark.parametrize(("chapter", "exercise"), WRITTEN, ids=lambda item: getattr(item, "id", ""))
def test_every_written_exercise_has_a_model_answer_and_a_rubric_of_its_points(
    chapter: Chapter, exercise: Exercise
) -> None:
    model = model_answer(chapter, exercise)
    assert model is not None
    assert model.has_words
    points = re.findall(r"(?m)^- ([\d.]+) points?: \S", model.rubric)
    assert len(points) == len(re.findall("(?m)^- ", model.rubric)) >= 2
    assert sum(map(float, points)) == exercise.points


@pytest.mark.parametrize("chapter", {c.name: c for c, _ in WRITTEN}.values(), ids=lambda c: c.name)
def test_students_get_the_questions_alone(chapter: Chapter) -> None:
    solved = (ROOT / "solutions" / chapter.name / "answers.md").read_text(encoding="utf-8")
    blank = blank_answers(solved)
    for section in sections_of(solved):
        assert section.question in blank
        for text in (section.answer, section.rubric):
            assert not [line for line in text.splitlines() if line and line in blank]
    assert {s.answer for s in sections_of(blank)} == {PLACE}
    assert {s.rubric for s in sections_of(blank)} == {""}


NOT_COUNTED = [PLACE, "", "   \n\n", "...", "<!-- I will do this tomorrow -->", "yes"]
NOT_COUNTED += ["> quoted from the question", "### A heading of mine"]
COUNTED = [ANSWER, "### Mine\n\nThe cosine decides.", "- the cosine\n- the lengths"]


@pytest.mark.parametrize("answer", NOT_COUNTED + COUNTED)
def test_an_answer_is_words_in_place_of_the_place_holder(answer: str, tmp_path: Path) -> None:
    first, second = questions_of(CH02, put(tmp_path, BEFORE + answer + AFTER))
    assert first.answered == (answer in COUNTED)
    assert not second.answered
    assert first.problems == second.problems == []


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (f"{BEFORE}{PLACE}\n\n{ANSWER}{AFTER}", PLACE),
        (f"{BEFORE}{ANSWER}{AFTER}".replace("## 2.2b", "## 2b"), "## 2b"),
        (f"{BEFORE}{ANSWER}{AFTER}".replace("## 2.2b Why", "Why"), "## 2.2b"),
        (f"{BEFORE}{ANSWER}{AFTER}## 2.2b\n\nAgain.\n", "## 2.2b"),
        (f"{BEFORE}## Mine\n\n{ANSWER}{AFTER}", "## Mine"),
    ],
)
def test_what_a_student_has_damaged_is_named_and_does_not_count(
    text: str, named: str, tmp_path: Path
) -> None:
    first, second = questions_of(CH02, put(tmp_path, text))
    assert not first.answered
    assert any(named in problem for problem in first.problems)
    assert second.problems == []


def test_a_heading_that_lost_a_little_is_still_known(tmp_path: Path) -> None:
    text = f"\ufeff{BEFORE}{ANSWER}{AFTER}".replace("## 2.2b Why", "#2.2b. why")
    first, second = questions_of(CH02, put(tmp_path, text.replace("\n", "\r\n")))
    assert first.answered
    assert first.problems == second.problems == []


def test_a_file_that_is_gone_is_named(tmp_path: Path) -> None:
    (tmp_path / "ch02_vectors").mkdir()
    first, _ = questions_of(CH02, [tmp_path])
    assert not first.answered
    assert "ch02_vectors/answers.md is missing" in first.problems[0].replace("\\", "/")


def test_a_question_waits_with_its_place_and_tells_nothing(tmp_path: Path) -> None:
    done = check("2.2b", put(tmp_path, BLANK)[0])
    assert done.returncode == 0
    assert "Why does the sign of the scalar product" in done.stdout
    line = BLANK.splitlines().index(PLACE) + 1
    assert f"2.2b is waiting for your answer. Write it here: {tmp_path}" in done.stdout
    assert f"answers.md:{line}\n" in done.stdout
    assert "Rubric" not in done.stdout
    put(tmp_path, f"{BEFORE}{PLACE}\n\n{ANSWER}{AFTER}")  # now it is damaged
    assert f"The line '{PLACE}' is still in " in check("2.2b", tmp_path).stdout


def test_an_answer_is_shown_beside_the_model_answer_and_the_rubric(tmp_path: Path) -> None:
    done = check("2.2b", put(tmp_path, BEFORE + ANSWER + AFTER)[0])
    assert done.returncode == 0
    own, model, rubric, end = (
        done.stdout.index(words)
        for words in (ANSWER, "A length is never negative", "0.5 points:", "A person will mark it")
    )
    assert own < model < rubric < end
    assert "waits" not in done.stdout


def test_a_hand_out_has_neither_and_says_who_has(tmp_path: Path) -> None:
    make_handout([CH02], [], tmp_path / "out")
    put(tmp_path / "out/chapters", BEFORE + ANSWER + AFTER)
    done = check("2.2b", "chapters", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert ANSWER in done.stdout
    assert "instructor has the model answer" in done.stdout
    assert "points:" not in done.stdout
