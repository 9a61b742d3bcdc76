"""Grade one submission: copy its files, run its checks in the sandbox, and write its report."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from autograder.checks.presentable import presentable
from autograder.checks.runner import GraderError, Limits
from autograder.checks.verdict import Point, Verdict
from autograder.diagnosis.earlier_chapters import (
    below_and_not_given,
    mark_inherited,
    run_on_given,
    with_given,
)
from autograder.diagnosis.undefined import file_of
from autograder.grader.causes import causes_of
from autograder.grader.conditions import Conditions, OnceForAll
from autograder.grader.handed_in import notes_on, why_nothing
from autograder.manifest import Chapter, load_chapters
from autograder.message import Message
from autograder.reports.report import Cause, StudentReport
from autograder.scores import Result, results_of, total
from autograder.submissions.find import Submission, printable
from autograder.submissions.stage import Staged, stage

SUBMISSION_LIMIT = 300.0  # seconds for all chapters of a submission, which usually needs about 2 s
LEAST_TIME = 10.0  # seconds; a chapter gets at least this many, or its checks could not begin

Run = Callable[[Chapter, list[Path]], list[Verdict]]


@dataclass(frozen=True)
class _Graded:
    """A student's results on one chapter."""

    own: list[Result]  # with the student's own earlier chapters
    on_given: list[Result]  # with our solutions to the earlier chapters
    causes: list[Cause] = field(default_factory=list)  # of failures in earlier assignments


@contextmanager
def staged_files(conditions: Conditions, submission: Submission) -> Iterator[tuple[Staged, Path]]:
    """Copy what can be graded of a submission into a temporary folder, and yield the folder."""
    with tempfile.TemporaryDirectory(prefix="submission-") as folder:
        chapters = load_chapters(conditions.root)
        yield stage(submission.path, chapters, Path(folder), conditions.root), Path(folder)


def grade_submission(
    conditions: Conditions, submission: Submission, once: OnceForAll | None = None
) -> StudentReport:
    """Grade one student's submission, and return a report even if the grader itself fails."""
    if submission.nothing:
        return _nothing(conditions, submission, submission.nothing, submission.nothing)
    try:
        with staged_files(conditions, submission) as (staged, box):
            return grade_staged(conditions, submission, staged, box, once or OnceForAll())
    except Exception as error:  # an error of the grader must not stop the rest of the class
        return report_of_failure(conditions, submission.student, repr(error))


def grade_staged(
    conditions: Conditions, submission: Submission, staged: Staged, box: Path, once: OnceForAll
) -> StudentReport:
    """Grade the files of a submission that were copied to the folder ``box``."""
    if why := _why_nothing(submission, staged, conditions):
        return _nothing(conditions, submission, why, staged.digest)
    start = time.monotonic()
    with (
        with_given(conditions.given, [box], conditions.root) as engine,
        tempfile.TemporaryDirectory(prefix="compiled-") as compiled,
    ):
        graded = _all_results(conditions, once, engine, staged, Path(compiled))
    notes = [*submission.notes, *notes_on(staged, conditions.chapters)]
    report = _report(conditions, once, submission.student, graded, notes)
    seconds = round(time.monotonic() - start, 3)
    return replace(report, submission=staged.digest, seconds=seconds)


def still_valid(
    conditions: Conditions, submission: Submission, report: StudentReport
) -> StudentReport | None:
    """Return an earlier report with today's notes, or None if other files would be graded now.

    A student may have handed in files since then that are not graded, such as a PDF.
    """
    if submission.nothing:
        new = _nothing(conditions, submission, submission.nothing, submission.nothing)
    else:
        with staged_files(conditions, submission) as (staged, _):
            if why := _why_nothing(submission, staged, conditions):
                new = _nothing(conditions, submission, why, staged.digest)
            else:
                notes = [*submission.notes, *notes_on(staged, conditions.chapters)]
                new = replace(report, nothing="", notes=notes, submission=staged.digest)
    same = (report.submission, report.status) == (new.submission, new.status)
    return replace(new, run=report.run) if same else None


def _why_nothing(submission: Submission, staged: Staged, conditions: Conditions) -> str:
    why = why_nothing(staged, conditions.chapters)
    is_zip = submission.path.suffix.lower() == ".zip"  # a folder has the name of the student
    return f"'{submission.path.name}': {why}" if why and is_zip else why


def _nothing(
    conditions: Conditions, submission: Submission, why: str, digest: str
) -> StudentReport:
    """Build the report on a submission that contains nothing that can be graded."""
    places = [f"{c.name}/{c.edited_files[0]}" for c in conditions.chapters if c.edited_files]
    how = f"Hand in a folder or a zip file that contains folders of chapters: {', '.join(places)}"
    none = [_Graded([], []) for _ in conditions.chapters]
    report = _report(conditions, OnceForAll(), submission.student, none, [how, *submission.notes])
    return replace(
        report,
        status="nothing to grade",
        nothing=printable(why),
        score=None,
        score_on_given=None,
        submission=digest,
        seconds=0.0,
    )


def report_of_failure(conditions: Conditions, student: str, reason: str) -> StudentReport:
    """Build the report on a submission on which the grader itself failed, which is not a zero."""
    errors = [_errors(chapter, reason) for chapter in conditions.chapters]
    graded = [_Graded(results, results) for results in errors]
    return replace(_report(conditions, OnceForAll(), student, graded, []), seconds=0.0)


def _all_results(
    conditions: Conditions, once: OnceForAll, engine: list[Path], staged: Staged, compiled: Path
) -> list[_Graded]:
    """Grade each chapter within the time limit of a submission."""
    deadline = time.monotonic() + SUBMISSION_LIMIT

    def run(chapter: Chapter, engine: list[Path]) -> list[Verdict]:
        limit = max(LEAST_TIME, min(Limits.run, deadline - time.monotonic()))
        # A rejected file does not matter if the reference replaces it.
        missing = {
            module: why
            for module, why in staged.rejected.items()
            if not any((folder / file_of(module)).exists() for folder in engine)
        }
        return conditions.run(chapter, engine, missing=missing, run_limit=limit, compiled=compiled)

    return [
        _graded(conditions, once, chapter, engine, run, is_empty=_is_empty(chapter, staged))
        for chapter in conditions.chapters
    ]


def _is_empty(chapter: Chapter, staged: Staged) -> bool:
    """Return True if a student has handed in no file for this chapter, not even a rejected one."""
    refused = any(module.startswith(f"{chapter.name}.") for module in staged.rejected)
    return not refused and not any(name.startswith(f"{chapter.name}/") for name in staged.taken)


def _graded(
    conditions: Conditions,
    once: OnceForAll,
    chapter: Chapter,
    engine: list[Path],
    run: Run,
    *,
    is_empty: bool,
) -> _Graded:
    """Run a chapter's checks twice on a student's code, and return the results of both runs.

    The first run uses the student's own earlier chapters, and the second takes them from the
    reference solution. A check that passes only in the second run failed because of a mistake in an
    earlier chapter. The reports show only the messages of the first run. In the second run, the
    student's code could read the reference and leak it in a message.
    """
    again: list[Verdict] = []
    try:
        verdicts = once.of_nothing(conditions, chapter) if is_empty else run(chapter, engine)
    except GraderError as error:
        errors = _errors(chapter, str(error))
        return _Graded(errors, errors)
    if not is_empty:
        below = below_and_not_given(chapter, conditions.given, conditions.root)
        try:
            again = run_on_given(chapter, verdicts, engine, below, run, conditions.root)
        except GraderError as error:
            return _Graded(results_of(chapter, verdicts), _errors(chapter, str(error)))
        verdicts = mark_inherited(verdicts, again)
    own = results_of(chapter, verdicts)
    causes = causes_of(conditions.whole(chapter), own, verdicts, conditions.earlier)
    return _Graded(own, results_of(chapter, again) if again else own, causes)


def _errors(chapter: Chapter, reason: str) -> list[Result]:
    """Build the results of a chapter on which the grader itself failed, which are not zeros."""
    why = presentable(Message(reason[:500]))
    ours = [Verdict("every check", e.id, 1, "error", why) for e in chapter.exercises]
    return results_of(chapter, ours)


def _report(
    conditions: Conditions,
    once: OnceForAll,
    student: str,
    graded: list[_Graded],
    notes: list[str],
) -> StudentReport:
    own = [result for chapter in graded for result in chapter.own]
    given = [result for chapter in graded for result in chapter.on_given]
    score, points = total(own)
    failed = any(result.status == "error" for result in [*own, *given])
    below = {  # the student's own earlier chapters
        other.number
        for chapter in conditions.chapters
        for other in below_and_not_given(chapter, conditions.given, conditions.root)
    }
    return StudentReport(
        student=student,
        status="error, retry" if failed else "graded",
        seed=conditions.seed,
        isolation=str(conditions.level),
        score=score,
        score_on_given=total(given)[0],
        points=points,
        by_hand=None,
        waiting=sum(result.exercise.points for result in own if result.status == "waiting"),
        earlier=sorted(below),
        notes=notes,
        results=[
            replace(
                result,
                score_on_given=better.score,
                reference=_reference(conditions, once, chapter, result),
            )
            for chapter, results in zip(conditions.chapters, graded, strict=True)
            for result, better in zip(results.own, results.on_given, strict=True)
        ],
        causes=[cause for chapter in graded for cause in chapter.causes],
    )


def _reference(
    conditions: Conditions, once: OnceForAll, chapter: Chapter, result: Result
) -> Point | None:
    """Return the cost and the error of our solution, if those of the student's were measured."""
    if result.on_chart is None:
        return None
    ours = once.of_reference(conditions, chapter)
    return next((v.on_chart for v in ours if v.exercise == result.exercise.id and v.on_chart), None)
