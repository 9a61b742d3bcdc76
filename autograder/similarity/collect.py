"""Read the code that each student of a class wrote, staged as for grading, to compare it."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from autograder.similarity.code import fingerprints, hashes, names_in, read_functions
from autograder.similarity.compare import Part, Passage, Work
from autograder.submissions.find import Submission
from autograder.submissions.stage import stage

SMALLEST = 30  # tokens; if our solution is shorter, all students' solutions must look alike


@dataclass(frozen=True)
class Ground:
    """The rules for comparing students' code: which functions to compare, and what to ignore."""

    chapters: list[Chapter]
    parts: dict[tuple[str, str], str]  # the exercise of each file and function, or "" to ignore it
    known: frozenset[str]  # the names of the engine and of Python, which are not replaced
    given: set[int]  # the hashes of code in our stubs, complete modules and solutions
    small: list[str]  # the ids of the exercises that are too short to compare


def ground_of(chapters: list[Chapter], root: Path = ROOT) -> Ground:
    """Decide which parts of the students' code in ``chapters`` to compare, and which to ignore."""
    whole = {chapter.name: chapter for chapter in load_chapters(root)}
    known = frozenset(name for text in _our_files(root, [*whole]) for name in names_in(text))
    given: set[int] = set()
    for text in _our_files(root, [chapter.name for chapter in chapters]):
        for function in read_functions(text, known)[0]:
            given.update(hashes(function.words))
    parts: dict[tuple[str, str], str] = {}
    small = []
    for chapter in chapters:
        sizes = {
            (name, function.name): len(function.tokens)
            for name, text in _texts(chapter, root / "solutions").items()
            for function in read_functions(text, known)[0]
        }
        for exercise in whole[chapter.name].exercises:  # those that are not assigned are ignored
            parts |= dict.fromkeys(_places(chapter, exercise), "")
        for exercise in chapter.exercises:
            places = _places(chapter, exercise)
            if places and sum(sizes.get(place, 0) for place in places) < SMALLEST:
                small.append(exercise.id)
            title = f"{exercise.id} {exercise.title}"
            parts |= dict.fromkeys(places, "" if exercise.id in small else title)
    return Ground(chapters, parts, known, given, small)


def collect(
    submissions: Iterable[Submission], ground: Ground, root: Path = ROOT
) -> Iterator[tuple[Work, list[str]]]:
    """Yield the code of each student, with notes on any files that could not be read."""
    for submission in submissions:
        if submission.nothing:
            yield Work(submission.student, {}), [submission.nothing]
            continue
        with tempfile.TemporaryDirectory(prefix="similarity-") as folder:
            staged = stage(submission.path, ground.chapters, Path(folder), root)
            texts = [_texts(chapter, Path(folder)) for chapter in ground.chapters]
        files = {name: text for of_chapter in texts for name, text in of_chapter.items()}
        work, notes = work_of(submission.student, files, ground)
        yield work, [*staged.rejected.values(), *notes]


def work_of(student: str, files: dict[str, str], ground: Ground) -> tuple[Work, list[str]]:
    """Sort the code in a student's files by exercise, with notes on code that cannot be read."""
    parts: dict[str, Part] = {}
    notes = []
    for file, text in files.items():
        functions, stopped = read_functions(text, ground.known)
        if stopped:
            notes.append(f"{file} was not compared from line {stopped} on: it cannot be read")
        for function in functions:
            own = fingerprints(function.words) - ground.given
            name = ground.parts.get((file, function.name), f"Other code in {file}")
            if name and own:
                part = parts.setdefault(name, Part())
                part.passages.append(Passage(file, function.name, function.tokens, text))
                part.fingerprints |= own
    return Work(student, parts), notes


def _places(chapter: Chapter, exercise: Exercise) -> list[tuple[str, str]]:
    """List the functions that students write for an exercise, each with its file."""
    edits = [edit.split(".", 1) for edit in exercise.edit]
    return [(f"{chapter.name}/{module}.py", name) for module, name in edits]


def _texts(chapter: Chapter, folder: Path) -> dict[str, str]:
    """Read the modules of a chapter that students edit, as far as they are in a folder."""
    names = [f"{chapter.name}/{name}" for name in chapter.edited_files]
    there = [name for name in names if (folder / name).exists()]
    return {name: (folder / name).read_text(encoding="utf-8-sig") for name in there}


def _our_files(root: Path, chapters: list[str]) -> Iterator[str]:
    """Yield the text of each Python file that we provide for some chapters."""
    for folder in ("solutions", "chapters"):
        for name in chapters:
            for path in sorted((root / folder / name).glob("*.py")):
                yield path.read_text(encoding="utf-8")
