"""Show students what they have achieved at the end of a chapter, and which scenes they can play.

The scenes are interactive simulations in the lab that run on the student's engine. A chapter is
finished as soon as the physics checks of its exercises pass. Robust checks, questions, projects and
going-further exercises may still be open, and the screen lists them.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.commands import command, engine_variables
from autograder.manifest import ROOT, Chapter, Exercise, load_chapters
from autograder.scores import Result
from autograder.student.checked import Report
from autograder.student.written import listed, open_questions

if TYPE_CHECKING:
    from rich.console import Console


WIDTH = 79
LABEL = 10  # width of the column with the labels
DRAWN_WITH = "engine.txt"  # this file beside the pictures says whose engine has drawn them


def print_finish(
    console: Console,
    reports: list[Report],
    exercise: Exercise | None,
    engine: list[Path],
    given: list[Chapter],
) -> None:
    """Print the closing screen of a finished chapter, or a list of scenes to play.

    If no chapter is finished and no new scene can be played, print nothing.
    """
    lines = end_of(reports, exercise, engine, given)
    for words, style in [("", ""), *lines] if lines else []:
        console.print(words, style=style, markup=False, soft_wrap=True)


def end_of(
    reports: list[Report], exercise: Exercise | None, engine: list[Path], given: list[Chapter]
) -> list[tuple[str, str]]:
    """Return the closing screen of a finished chapter, or a line that lists scenes to play.

    The closing screen is shown until the student begins another chapter. In an unfinished chapter,
    the line lists the scenes of ``exercise`` if that exercise works. If ``exercise`` is None, the
    line is about the last working exercise that has scenes.

    Returns:
        The lines to print, each with its style. The list may be empty.
    """
    unfinished = [report for report in reports if not is_finished(report)]
    begun = [report for report in unfinished if any(result.works for result in report.results)]
    if not begun and len(unfinished) < len(reports):
        last = [report for report in reports if report not in unfinished][-1]
        lines = finish_lines(last, engine, given)
        return [(lines[0], "bold green"), *((line, "") for line in lines[1:])]
    for report in reversed(begun):
        for result in reversed(report.results):
            if exercise in (None, result.exercise) and (
                words := play_words(report, result, engine, given)
            ):
                return [(words, "green")]
    return []


def is_finished(report: Report) -> bool:
    """Return True if a chapter is finished, so that its closing screen can be shown.

    All physics checks must pass, except those of projects and going-further exercises. Written
    questions and robust checks may still be open.
    """
    working = {result.exercise.id for result in report.results if result.works}
    wanted = [e for e in report.chapter.exercises if e.kind != "written" and not _is_extra(e)]
    return all(exercise.id in working for exercise in wanted)


def finish_lines(report: Report, engine: list[Path], given: list[Chapter]) -> list[str]:
    """Return the screen that congratulates a student on a finished chapter.

    The screen shows where to find the chapter's picture, which scenes to play, what is still open
    and which chapter comes next. It fits on a terminal of 20 lines and 80 columns.
    """
    chapter = report.chapter
    lines = [f"Well done! Chapter {chapter.number} works: {chapter.title}.", ""]
    lines += [*textwrap.wrap(" ".join(chapter.you_can), WIDTH, break_on_hyphens=False), ""]
    if chapter.picture:
        lines += _labeled("Picture", _picture(chapter, engine, given))
    scenes = [name for result in report.results if result.works for name in result.exercise.play]
    if scenes:
        others = f" (or {listed(scenes[1:], 'or')})" if scenes[1:] else ""
        lines += _labeled("Play", _lab(scenes[0], engine, given) + others)
    label = "Open"
    for words in _open(report, engine) or ["nothing"]:
        lines += _labeled(label, words)
        label = ""
    following = [other for other in load_chapters() if other.number > chapter.number]
    if following:
        after = following[0]
        lines += _labeled("Next", f"chapter {after.number}, {after.title}. {after.summary}")
    return lines


def play_words(report: Report, result: Result, engine: list[Path], given: list[Chapter]) -> str:
    """Return a sentence that invites a student to play the scenes of a solved exercise.

    Return an empty string if the exercise has no scenes or does not work yet. Do the same if its
    scenes would not work because of an earlier exercise or an earlier chapter.
    """
    exercise = result.exercise
    if not (exercise.play and result.works):
        return ""
    if any(check.status == "inherited" for other in report.results for check in other.checks):
        return ""
    failing = {other.exercise.id for other in report.results if not other.works}
    for other in report.chapter.exercises:
        if other.id == exercise.id:
            break
        if other.edit and (other.id in failing or _is_stub(other, report.chapter, engine)):
            return ""
    scenes = listed([_lab(name, engine, given) for name in exercise.play])
    return f"{exercise.id} works. Try it: {scenes}"


def _is_extra(exercise: Exercise) -> bool:
    """Return True if students can finish the chapter without this exercise.

    This is the case for projects and for going-further exercises, whose ids start with G.
    """
    return exercise.kind == "project" or exercise.id.startswith("G")


def _is_stub(exercise: Exercise, chapter: Chapter, engine: list[Path]) -> bool:
    """Return True if the student has not yet written all functions of this exercise.

    A function in a missing file counts as not written.
    """
    stub = re.compile(rf"raise NotImplementedError\(\s*[\"']Exercise {re.escape(exercise.id)}:")
    for file in {f"{name.partition('.')[0]}.py" for name in exercise.edit}:
        paths = [folder / chapter.name / file for folder in engine]
        path = next((path for path in paths if path.is_file()), None)
        if path is None or stub.search(path.read_text(encoding="utf-8", errors="replace")):
            return True
    return False


def _open(report: Report, engine: list[Path]) -> list[str]:
    """List the tasks that remain open in a chapter that the student has finished.

    Such tasks are failed robust checks, unanswered questions, projects and going-further exercises.
    """
    words = []
    robust = [
        (result.exercise, check)
        for result in report.results
        if result.works
        for check in result.robust
        if check.status != "passed"
    ]
    if robust:
        count = f"{len(robust)} robust check{'s' * (len(robust) > 1)}"
        first = command("check", EX=robust[0][0].id, **engine_variables(engine))
        words.append(f"{count}; the first: {first}")
    if questions := open_questions([report.chapter], engine):
        words.append(questions)
    extra = [r.exercise for r in report.results if _is_extra(r.exercise) and not r.works]
    if extra:
        named = [f"{exercise.id} {exercise.title}" for exercise in extra]
        words.append(f"if you like: {'; '.join(named)}")
    return words


def _picture(chapter: Chapter, engine: list[Path], given: list[Chapter]) -> str:
    """Tell the student where to find the chapter's picture, or which command draws it.

    The text gives the command if the student's own engine has not drawn the picture yet, or if the
    code has changed since then.
    """
    folder = ROOT / "build" / "plots" / chapter.name
    file, drawn_with = folder / f"{chapter.picture}.png", folder / DRAWN_WITH
    if file.is_file() and drawn_with.is_file():
        own = Path(drawn_with.read_text(encoding="utf-8").strip()) == engine[0].resolve()
        if own and file.stat().st_mtime > _last_change(chapter, engine[0]):
            short = file.relative_to(Path.cwd()) if file.is_relative_to(Path.cwd()) else file
            return f"{short}, drawn by your own functions"
    draw = command("plot", CH=str(chapter.number), **_variables(engine, given))
    return f"{draw} draws it with your own functions"


def _last_change(chapter: Chapter, engine: Path) -> float:
    """Return the time at which the student last changed a file that affects the chapter's plot.

    If the saved plot is older than this, it must be redrawn.
    """
    files = [
        file
        for file in engine.glob("ch??_*/*.*")
        if file.parent.name <= chapter.name and file.suffix in (".py", ".csv")
    ]
    return max((file.stat().st_mtime for file in files), default=0.0)


def _lab(name: str, engine: list[Path], given: list[Chapter]) -> str:
    return command("lab", SCENE=name, **_variables(engine, given))


def _variables(engine: list[Path], given: list[Chapter]) -> dict[str, str]:
    """Return the make variables that select the student's engine and the chapters in ``given``.

    For example, GIVEN=2,3 replaces the student's chapters 2 and 3 with our solution.
    """
    numbers = ",".join(str(chapter.number) for chapter in given)
    return {**({"GIVEN": numbers} if given else {}), **engine_variables(engine)}


def _labeled(label: str, words: str) -> list[str]:
    """Format an entry with a label, such as "Next", for the closing screen of a chapter."""
    width = WIDTH - LABEL
    lines = textwrap.wrap(words, width, break_long_words=False, break_on_hyphens=False)
    return [f"{label if i == 0 else '':{LABEL}}{line}" for i, line in enumerate(lines)]
