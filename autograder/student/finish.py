"""Show students what they have achieved at the end of a chapter, and which scenes they can play.

A chapter is finished as soon as the physics checks of its exercises pass. Robust checks, questions,
projects and going-further exercises may still be open, and the screen lists them.
"""

from __future__ import annotations

from pathlib import Path

from autograder.commands import command, engine_variables
from autograder.manifest import Chapter, Exercise, load_chapters
from autograder.message import Row
from autograder.scores import Result
from autograder.student.chapter_results import ChapterResults
from autograder.student.written import listed, open_questions
from autograder.text.wrapping import wrapped, wrapped_rows

WIDTH = 79


def end_of(
    reports: list[ChapterResults],
    exercise: Exercise | None,
    engine: list[Path],
    given: list[Chapter],
) -> list[tuple[str, str]]:
    """Return the lines, with styles, of the last finished chapter until another one is begun.

    In an unfinished chapter, it is a line with the scenes that an exercise has made work.
    """
    unfinished = [report for report in reports if not is_finished(report)]
    begun = [report for report in unfinished if any(result.works for result in report.results)]
    if not begun and len(unfinished) < len(reports):
        last = [report for report in reports if report not in unfinished][-1]
        lines = finish_lines(last, engine, given)
        return [(lines[0], "bold green"), *((line, "") for line in lines[1:])]
    for report in reversed(begun):
        for result in reversed(report.results):
            if exercise in (None, result.exercise) and _can_play(report, result):
                play = [_command("lab", engine, given, SCENE=s) for s in result.exercise.play]
                return [(f"{result.exercise.id} works. Try it: {listed(play)}", "green")]
    return []


def is_finished(report: ChapterResults) -> bool:
    """Return True if all physics checks pass, except those of projects and going-further ones."""
    working = {result.exercise.id for result in report.results if result.works}
    wanted = [e for e in report.chapter.exercises if e.kind != "written" and not _is_extra(e)]
    return all(exercise.id in working for exercise in wanted)


def finish_lines(report: ChapterResults, engine: list[Path], given: list[Chapter]) -> list[str]:
    """Return the screen for a finished chapter, which fits on a terminal of 20 lines."""
    chapter = report.chapter
    lines = [f"Well done! Chapter {chapter.number} works: {chapter.title}.", ""]
    lines += [*wrapped(" ".join(chapter.you_can), WIDTH), ""]
    entries: list[Row] = []
    if chapter.picture:
        draw = _command("plot", engine, given, CH=str(chapter.number))
        entries.append(("Picture", f"{draw} draws it with your own functions"))
    if scenes := [name for r in report.results if r.works for name in r.exercise.play]:
        others = f" (or {listed(scenes[1:], 'or')})" if scenes[1:] else ""
        entries.append(("Play", _command("lab", engine, given, SCENE=scenes[0]) + others))
    entries.append(("Open", "\n".join(_open(report, engine) or ["nothing"])))
    after = next((other for other in load_chapters() if other.number > chapter.number), None)
    if after:
        entries.append(("Next", f"chapter {after.number}, {after.title}. {after.summary}"))
    return lines + wrapped_rows(entries, WIDTH)


def _can_play(report: ChapterResults, result: Result) -> bool:
    """Return True if the scenes of an exercise work, as far as the checks that ran can tell."""
    before = report.results[: report.results.index(result)]
    checks = [check for other in report.results for check in other.checks]
    return (
        bool(result.exercise.play and result.works)
        and all(other.works or not other.exercise.edit for other in before)
        and not any(check.status == "inherited" for check in checks)
    )


def _is_extra(exercise: Exercise) -> bool:
    """Return True for projects and going-further exercises, whose ids start with G."""
    return exercise.kind == "project" or exercise.id.startswith("G")


def _open(report: ChapterResults, engine: list[Path]) -> list[str]:
    """List what is open in a finished chapter, such as robust checks and questions."""
    words = []
    working = [result for result in report.results if result.works]
    robust = [r.exercise for r in working for check in r.robust if check.status != "passed"]
    if robust:
        first = command("check", EX=robust[0].id, **engine_variables(engine))
        words.append(f"{len(robust)} robust check{'s' * (len(robust) > 1)}; the first: {first}")
    if questions := open_questions([report.chapter], engine):
        words.append(questions)
    extra = [r.exercise for r in report.results if _is_extra(r.exercise) and not r.works]
    if extra:
        words.append("if you like: " + "; ".join(f"{e.id} {e.title}" for e in extra))
    return words


def _command(name: str, engine: list[Path], given: list[Chapter], **variables: str) -> str:
    """Return a command of make with the variables for the student's engine and given chapters."""
    if given:
        variables["GIVEN"] = ",".join(str(chapter.number) for chapter in given)
    return command(name, **variables, **engine_variables(engine))
