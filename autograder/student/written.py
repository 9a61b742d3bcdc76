"""Show the question of a written exercise and, if it has been answered, the model answer."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.answers import Question, model_answer, questions_of
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.scores import shown

if TYPE_CHECKING:
    from rich.console import Console


def print_written(
    console: Console, chapter: Chapter, exercise: Exercise, engine: list[Path], root: Path = ROOT
) -> None:
    """Print the question of a written exercise and, if it has been answered, the model answer.

    The rubric is printed below the model answer, so that students can assess their own answers. A
    handout includes neither, because the instructor marks the answers of a class.
    """
    question = next(q for q in questions_of(chapter, engine) if q.exercise == exercise)
    points = "1 point" if exercise.points == 1 else f"{shown(exercise.points)} points"
    _say(console, f"\n{exercise.id} {exercise.title} ({points})\n", "bold")
    if question.section:
        _say(console, f"{flowing(question.section.question)}\n")
    if not question.answered or question.section is None:
        for problem in question.problems:
            _say(console, problem, "red", soft_wrap=True)
        if not question.problems and question.section and question.section.words:
            _say(console, "Your answer is too short. Give the reason in a sentence.", "red")
        waits = f"{exercise.id} is waiting for your answer. Write it here: {question.place}"
        _say(console, waits, soft_wrap=True)
        return
    _say(console, "Your answer", "bold")
    _say(console, f"{flowing(question.section.answer)}\n")
    model = model_answer(chapter, exercise, root)
    if model is None:
        _say(console, "Your instructor has the model answer and will mark yours.")
        return
    _say(console, "The model answer", "bold")
    _say(console, f"{flowing(model.answer)}\n")
    _say(console, "Rubric", "bold")
    _say(console, f"{flowing(model.rubric)}\n")
    _say(console, "Compare the two, and improve your answer if you like. A person will mark it.")


def open_questions(chapters: list[Chapter], engine: list[Path]) -> str:
    """List the questions that the student has not answered, with the files for the answers.

    The list is a single line of text, or "" if every question has an answer.
    """
    groups = [
        open_ones
        for chapter in chapters
        if (open_ones := [q for q in questions_of(chapter, engine) if _is_open(q)])
    ]
    if not groups:
        return ""
    count = sum(len(group) for group in groups)
    where = "; ".join(f"{listed(_ids(group))}, in {group[0].file}" for group in groups)
    return f"{count} {'question is' if count == 1 else 'questions are'} open: {where}"


def all_pass(chapters: list[Chapter], engine: list[Path], on_given: str = "") -> str:
    """Return a message that all checks pass, with a list of any unanswered questions."""
    still = open_questions(chapters, engine)
    optional = any(exercise.optional for chapter in chapters for exercise in chapter.exercises)
    which = "All checks of the assigned exercises" if optional else "All checks"
    return f"{which} pass{on_given}.{f' {still}.' if still else ''}"


def _is_open(question: Question) -> bool:
    return not (question.answered or question.exercise.optional)


def listed(words: list[str], last: str = "and") -> str:
    """Join words into a list for an English sentence, such as "a, b and c"."""
    return f" {last} ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _ids(questions: list[Question]) -> list[str]:
    return [question.exercise.id for question in questions]


def flowing(text: str) -> str:
    """Join the lines of each paragraph in an answer, so that the text fits any screen width.

    The lines of a list item are joined too, and Markdown's quote markers (>) are removed. Indented
    lines, such as formulas, stay as they are. In a text that contains code blocks, no lines are
    joined.
    """
    text = re.sub(r"(?m)^> ?", "", text)
    if "```" in text:
        return text
    next_line = r"\n(?!\s|[-*+|] |\d+[.)] )"
    return re.sub(rf"(?<=\S)({next_line}|\n {{2}}(?=\S))", " ", text)


def _say(console: Console, words: str, style: str = "", *, soft_wrap: bool = False) -> None:
    console.print(words, style=style, markup=False, soft_wrap=soft_wrap)
