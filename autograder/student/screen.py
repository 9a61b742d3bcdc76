"""Check a student's code, and print the results, one failure in full, and what to do next.

The rich library is slow to import, so it is imported while the checks run in another process.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from autograder.answers import questions_of
from autograder.checks.runner import run_checks
from autograder.checks.verdict import Verdict, asked_for
from autograder.commands import check_command
from autograder.diagnosis.earlier_chapters import with_given
from autograder.files import from_here
from autograder.handouts.stubs import read_lock, stub_hash
from autograder.manifest import Chapter, Exercise, chapters_below, numbers_of
from autograder.scores import (
    Result,
    extra_possible,
    of_possible,
    possible,
    result_of,
    shown,
    total,
)
from autograder.student.chapter_results import ChapterResults, report_on, show_progress
from autograder.student.failure import print_failure
from autograder.student.finish import end_of
from autograder.student.written import all_pass, print_written
from autograder.text.wrapping import plain_console, print_wrapped

URGENCY = {"blocked": 1, "inherited": 2}  # these come last, because another failure causes them
STYLES = {
    "passed": "green",
    "works": "green",
    "failed": "red",
    "blocked": "yellow",
    "inherited": "cyan",
    "error": "magenta",
}
WORKS = "works"
BAR = 40  # characters of a progress bar


def check(
    chapters: list[Chapter],
    exercise: Exercise | None,
    engine: list[Path],
    seed: str,
    given: list[Chapter],
    *,
    only: bool = False,
) -> bool:
    """Check a student's code, print the results, and return True if all checks pass.

    With ``exercise``, check only that exercise and its prerequisites. With ``only`` too, report
    only its own physics checks. The reference replaces the student's code in ``given`` chapters.
    """
    if exercise and exercise.kind == "written":
        print_written(chapters[0], exercise, engine)
        return True
    reports = []
    run = partial(run_checks, seed=seed)
    with with_given(given, engine) as folders:
        for chapter in chapters:
            report = report_on(chapter, exercise, folders, given, run, show_progress)
            if exercise and only:
                own, better = (
                    [result_of(exercise, r.physics) for r in results if r.exercise == exercise]
                    for results in (report.results, report.on_reference)
                )
                report = replace(report, results=own, on_reference=better)
            reports.append(report)
    return print_report(reports, exercise, engine, given)


def print_report(
    reports: list[ChapterResults],
    exercise: Exercise | None,
    engine: list[Path],
    given: list[Chapter],
) -> bool:
    """Print the results and explain the first failure. Return True if nothing is wrong."""
    console = plain_console()
    for report in reports:
        print_chapter(report, engine)
        for note in inherited_notes(report, exercise, engine):
            print_wrapped(console, note, STYLES["inherited"])
            console.print()
    first = first_open(reports, exercise)
    changed = [words for report in reports for words in changed_notes(report.chapter, engine)]
    for words in changed:
        console.print(f"{words}\n", style="red", soft_wrap=True)
    if first:
        print_failure(*first, engine)
    else:
        words = passed_words(reports, exercise, engine, given, changed=bool(changed))
        console.print(words, style="red" if changed else "bold green", soft_wrap=True)
    lines = end_of(reports, exercise, engine, given)
    for words, style in [("", ""), *lines] if lines else []:
        console.print(words, style=style, soft_wrap=True)
    return not first and not changed


def first_open(
    reports: list[ChapterResults], exercise: Exercise | None
) -> tuple[Chapter, Result] | None:
    """Find the exercise that the student should fix first, or return None if all checks pass."""
    everything = [(report.chapter, result) for report in reports for result in report.results]
    open_ones = [pair for pair in everything if pair[1].status not in ("passed", "waiting")]
    if exercise:  # for the exercises that it builds on, only the physics counts
        open_ones = [p for p in open_ones if p[1].exercise == exercise or not p[1].works]
    else:
        open_ones = [(c, r) for c, r in open_ones if r.exercise.id in asked_for(c)]
    # All physics comes before any robust check.
    return min(open_ones, key=lambda p: (p[1].works, URGENCY.get(p[1].status, 0)), default=None)


def passed_words(
    reports: list[ChapterResults],
    exercise: Exercise | None,
    engine: list[Path],
    given: list[Chapter],
    *,
    changed: bool,
) -> str:
    """Return the sentence that all checks pass. ``changed`` means that originals are edited."""
    if changed:
        return "All checks pass here, but grading uses the original files."
    on_given = f" on the reference's {_named(given)}" if given else ""
    if exercise:
        return f"All checks of {exercise.id} pass{on_given}."
    return all_pass([report.chapter for report in reports], engine, on_given)


def changed_notes(chapter: Chapter, engine: list[Path]) -> list[str]:
    """Warn the student about edited files that the grader will replace with the originals."""
    locked, notes = read_lock(), []
    for name in chapter.complete:
        path = engine[0] / chapter.name / name
        known = locked.get(f"chapters/{chapter.name}/{name}")
        text = path.read_text(encoding="utf-8-sig", errors="replace") if path.is_file() else None
        if known and text is not None and stub_hash(text) != known:
            file = from_here(path)
            notes.append(
                f"You have edited {file}. It isn't handed in, and grading uses the original, so "
                "code that relies on your changes will fail there. Keep your own code in the files "
                "that the exercises name, and restore the original, for example with: "
                f"git checkout -- {file}"
            )
    return notes


def print_chapter(report: ChapterResults, engine: list[Path]) -> None:
    """Print a table of a chapter's exercises, and warn about modules that the grader ignores."""
    from rich.table import Table

    console, chapter, results = plain_console(), report.chapter, report.results
    console.print(f"\nChapter {chapter.number}: {chapter.title}", style="bold")
    table = Table("", "exercise", "", "state", box=None, pad_edge=False)
    for column in ("physics", "robust", "points"):
        table.add_column(column, justify="right")
    states = states_of(report, engine)
    for result, state in zip(results, states, strict=True):
        exercise = result.exercise
        table.add_row(
            exercise.id,
            exercise.title,
            "*" * exercise.stars,
            state,
            passing(result.physics),
            passing(result.robust),
            points_of(chapter, result),
            style=STYLES.get(state, ""),
        )
    console.print(table)
    console.print()
    if WORKS in states:
        console.print(
            f'"{WORKS}" means that the physics passes, but robust checks are still open.\n'
        )
    console.print(f"{points_line(results)}\n")
    places = [f"Your {result.exercise.id}: {result.place}" for result in results if result.place]
    for words in (*places, *extra_notes(chapter, engine)):
        console.print(f"{words}\n", soft_wrap=True)


def extra_notes(chapter: Chapter, engine: list[Path]) -> list[str]:
    """Warn the student not to import extra modules, because the grader ignores them."""
    known = {*chapter.edited_files, *chapter.complete}
    files = sorted(file.name for file in (engine[0] / chapter.name).glob("*.py"))
    extra = [name for name in files if name not in known]
    return [f"Not handed in, so nothing may import it: {', '.join(extra)}"] if extra else []


def passing(checks: Sequence[Verdict]) -> str:
    """Count how many checks of an exercise pass, as in "3/4", or return "" if it has no checks."""
    passed = sum(check.status == "passed" for check in checks)
    return f"{passed}/{len(checks)}" if checks else ""


def inherited_notes(
    report: ChapterResults, exercise: Exercise | None, engine: list[Path]
) -> list[str]:
    """Return notes about earlier chapters whose mistakes may explain failures in this one."""
    chapter, notes = report.chapter, []
    lost = sum(check.status == "inherited" for result in report.results for check in result.checks)
    if lost:
        below = chapters_below(chapter)
        earlier, numbers = _named(below), numbers_of(below)
        checks = f"{lost} check fails" if lost == 1 else f"{lost} checks fail"
        extra = extra_possible(result.exercise for result in report.on_reference)
        on_reference = of_possible(*total(report.on_reference), extra)
        this = {"EX": exercise.id} if exercise else {"CH": str(chapter.number)}
        notes.append(
            f"{checks} here because of mistakes in {earlier}. On the reference's {earlier} "
            f"you have {on_reference}.\n"
            f"Fix them:    {check_command(engine, CH=numbers)}\n"
            f"Or continue: {check_command(engine, **this, GIVEN=numbers)}"
        )
    for other in report.suspects:
        notes.append(
            f"Chapter {other.number} fails some of its own checks, which may explain some of the "
            f"failures here: {check_command(engine, CH=str(other.number))}"
        )
    return notes


def _named(chapters: list[Chapter]) -> str:
    """Format chapter numbers for a message, as in "chapter 2" or "chapters 2-5"."""
    return f"chapter{'' if len(chapters) == 1 else 's'} {numbers_of(chapters)}"


def states_of(report: ChapterResults, engine: list[Path]) -> list[str]:
    """Describe the state of each of a student's exercises in a few words, as in "half written"."""
    questions = questions_of(report.chapter, engine)
    answered = {question.exercise.id for question in questions if question.answered}

    def state(result: Result) -> str:
        if result.status == "waiting":
            return "answered" if result.exercise.id in answered else "to answer"
        if result.works and result.status == "failed":
            return WORKS
        return result.state

    return [state(result) for result in report.results]


def points_line(results: list[Result]) -> str:
    """Return the line that shows how many points a student has, with a progress bar."""
    earned, points = total(results)
    written = [r.exercise for r in results if r.exercise.kind == "written"]
    extra = extra_possible(r.exercise for r in results if r.exercise not in written)
    answers = possible(written) + extra_possible(written)
    if not points and not extra:
        by_person = f"Points for written answers, marked by a person: {shown(answers)}"
        return by_person if answers else "Optional exercises earn no points."
    more = f", plus {shown(answers)} for written answers, marked by a person" if answers else ""
    has_bar = bar(earned or 0.0, points or extra)
    return f"{has_bar} {of_possible(earned, points, extra)}{more}"


def points_of(chapter: Chapter, result: Result) -> str:
    """Return a student's points for an exercise, such as "2/3", "optional" or "needed"."""
    exercise = result.exercise
    if exercise.optional:
        return "needed" if exercise.id in asked_for(chapter) else "optional"
    extra = " extra" if exercise.extra else ""
    return f"{shown(result.score)}/{shown(exercise.points)}{extra}"


def bar(part: float, whole: float) -> str:
    """Return a progress bar such as [####....], which shows the fraction ``part / whole``."""
    filled = min(BAR, int(BAR * part / whole)) if whole else 0
    return f"[{'#' * filled}{'.' * (BAR - filled)}]"
