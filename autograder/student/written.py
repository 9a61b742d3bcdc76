"""Show the question of a written exercise and, if it has been answered, the model answer."""

from __future__ import annotations

import re
from pathlib import Path

from autograder.answers import model_answer, questions_of
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.scores import shown
from autograder.text.wrapping import plain_console


def print_written(
    chapter: Chapter, exercise: Exercise, engine: list[Path], root: Path = ROOT
) -> None:
    """Print the question of a written exercise and, if it is answered, our model answer."""
    say = plain_console().print
    question = next(q for q in questions_of(chapter, engine) if q.exercise == exercise)
    section = question.section
    points = "1 point" if exercise.points == 1 else f"{shown(exercise.points)} points"
    say(f"\n{exercise.id} {exercise.title} ({points})\n", style="bold")
    if section:
        say(f"{flowing(section.question)}\n")
    if not question.answered or section is None:
        for problem in question.problems:
            say(problem, style="red", soft_wrap=True)
        if not question.problems and section and section.words:
            say("Your answer is too short. Give the reason in a sentence.", style="red")
        waits = f"{exercise.id} is waiting for your answer. Write it here: {question.place}"
        say(waits, soft_wrap=True)
        return
    parts = [("Your answer", section.answer)]
    end = "Your instructor has the model answer and will mark yours."
    if model := model_answer(chapter, exercise, root):
        parts += [("The model answer", model.answer), ("Rubric", model.rubric)]
        end = "Compare the two, and improve your answer if you like. A person will mark it."
    for heading, text in parts:
        say(heading, style="bold")
        say(f"{flowing(text)}\n")
    say(end)


def open_questions(chapters: list[Chapter], engine: list[Path]) -> str:
    """List the questions without an answer and their files in one line, or "" if there are none."""
    files: dict[Path, list[str]] = {}
    for chapter in chapters:
        for question in questions_of(chapter, engine):
            if not (question.answered or question.exercise.optional):
                files.setdefault(question.file, []).append(question.exercise.id)
    if not files:
        return ""
    count = sum(map(len, files.values()))
    where = "; ".join(f"{listed(ids)}, in {file}" for file, ids in files.items())
    return f"{count} {'question is' if count == 1 else 'questions are'} open: {where}"


def all_pass(chapters: list[Chapter], engine: list[Path], on_given: str = "") -> str:
    """Return a message that all checks pass, with a list of any unanswered questions."""
    still = open_questions(chapters, engine)
    optional = any(exercise.optional for chapter in chapters for exercise in chapter.exercises)
    which = "All checks of the assigned exercises" if optional else "All checks"
    return f"{which} pass{on_given}.{f' {still}.' if still else ''}"


def listed(words: list[str], last: str = "and") -> str:
    """Join words into a list for an English sentence, such as "a, b and c"."""
    return f" {last} ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def flowing(text: str) -> str:
    """Join the lines of each paragraph or list item, but not of formulas and texts with code."""
    text = re.sub(r"(?m)^> ?", "", text)
    if "```" in text:
        return text
    next_line = r"\n(?!\s|[-*+|] |\d+[.)] )"
    return re.sub(rf"(?<=\S)({next_line}|\n {{2}}(?=\S))", " ", text)
