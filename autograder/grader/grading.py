"""Grade one submission: copy its files, run its checks in the sandbox, and write its report."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from autograder.checks.presentable import presentable
from autograder.checks.runner import GraderError, Limits
from autograder.checks.verdict import Verdict
from autograder.diagnosis.earlier_chapters import (
    below_and_not_given,
    mark_inherited,
    run_on_given,
    with_given,
)
from autograder.diagnosis.undefined import file_of
from autograder.grader.assignment import Assignment, OnceForAll
from autograder.grader.causes import causes_of
from autograder.grader.handed_in import notes_on, why_nothing
from autograder.manifest import Chapter, load_chapters
from autograder.message import Message
from autograder.reports.report import Cause, Chart, ExerciseReport, StudentReport, check_report
from autograder.scores import Result, results_of, total
from autograder.submissions.find import Submission, printable
from autograder.submissions.stage import Staged, stage

SUBMISSION_LIMIT = 300.0  # seconds for all chapters of a submission, which usually needs about 2 s

LEAST_TIME = 10.0  # seconds; a chapter gets at least this many, or its checks could not begin


@dataclass(frozen=True)
class _Graded:
    """A student's results on one chapter.

    Attributes:
        own: The results with the student's own earlier chapters.
        on_given: The results with our solutions to the earlier chapters.
        causes: The exercises of earlier assignments that block graded ones.
    """

    own: list[Result]
    on_given: list[Result]
    causes: list[Cause] = field(default_factory=list)


def grade_submission(
    assignment: Assignment,
    submission: Submission,
    once: OnceForAll | None = None,
    fill: Callable[..., Staged] | None = None,
) -> StudentReport:
    """Grade one student's submission, and return a report even if the grader itself fails.

    ``once`` is a cache of check results that are the same for all students. ``fill`` is the
    function that copies the submission's files to the folder where they are graded. The default is
    ``stage``, which reads them from ``submission.path``. A worker on a cluster passes a different
    function, because it receives the files from another machine.
    """
    once = once or OnceForAll()
    if submission.nothing:
        return _nothing(assignment, submission, submission.nothing, submission.nothing)
    start = time.monotonic()
    try:
        with tempfile.TemporaryDirectory(prefix="submission-") as folder:
            box = Path(folder)
            chapters = load_chapters(assignment.root)
            staged = (fill or stage)(submission.path, chapters, box, assignment.root)
            if why := _why_nothing(submission, staged, assignment):
                return _nothing(assignment, submission, why, staged.digest)
            notes = [*submission.notes, *notes_on(staged, assignment.chapters)]
            with (
                with_given(assignment.given, [box], assignment.root) as engine,
                tempfile.TemporaryDirectory(prefix="compiled-") as compiled,
            ):
                graded = _all_results(assignment, once, engine, staged, Path(compiled))
        report = _report(assignment, once, submission.student, graded, notes)
        report = replace(report, submission=staged.digest)
    except Exception as error:  # an error of the grader must not stop the rest of the class
        report = report_of_failure(assignment, submission.student, repr(error))
    return replace(report, seconds=round(time.monotonic() - start, 3))


def _why_nothing(submission: Submission, staged: Staged, assignment: Assignment) -> str:
    why = why_nothing(staged, assignment.chapters)
    is_zip = submission.path.suffix.lower() == ".zip"  # a folder has the name of the student
    return f"'{submission.path.name}': {why}" if why and is_zip else why


def _nothing(
    assignment: Assignment, submission: Submission, why: str, digest: str
) -> StudentReport:
    """Build the report on a submission that contains nothing that can be graded."""
    places = [f"{c.name}/{c.edited_files[0]}" for c in assignment.chapters if c.edited_files]
    how = f"Hand in a folder or a zip file that contains folders of chapters: {', '.join(places)}"
    none = [_Graded([], []) for _ in assignment.chapters]
    report = _report(assignment, OnceForAll(), submission.student, none, [how, *submission.notes])
    return replace(
        report,
        status="nothing to grade",
        nothing=printable(why),
        score=None,
        score_on_given=None,
        submission=digest,
        seconds=0.0,
    )


def report_of_failure(assignment: Assignment, student: str, reason: str) -> StudentReport:
    """Build the report on a submission that could not be graded because the grader itself failed.

    Each exercise is reported as a grader error with this ``reason``, and not as a zero. The
    submission can be graded again later.
    """
    errors = [_errors(chapter, reason) for chapter in assignment.chapters]
    graded = [_Graded(results, results) for results in errors]
    return replace(_report(assignment, OnceForAll(), student, graded, []), seconds=0.0)


def still_valid(
    assignment: Assignment, submission: Submission, report: StudentReport
) -> StudentReport | None:
    """Return an earlier report with today's notes, or None if other files would be graded now.

    A student may have handed in files since then that are not graded, such as a PDF.
    """
    if submission.nothing:
        new = _nothing(assignment, submission, submission.nothing, submission.nothing)
    else:
        with tempfile.TemporaryDirectory(prefix="submission-") as folder:
            chapters = load_chapters(assignment.root)
            staged = stage(submission.path, chapters, Path(folder), assignment.root)
        if why := _why_nothing(submission, staged, assignment):
            new = _nothing(assignment, submission, why, staged.digest)
        else:
            notes = [*submission.notes, *notes_on(staged, assignment.chapters)]
            new = replace(report, nothing="", notes=notes, submission=staged.digest)
    same = (report.submission, report.status) == (new.submission, new.status)
    return replace(new, run=report.run) if same else None


def _all_results(
    assignment: Assignment,
    once: OnceForAll,
    engine: list[Path],
    staged: Staged,
    compiled: Path,
) -> list[_Graded]:
    """Run each chapter's checks twice on a student's code, and return the results of both runs.

    The first run uses the student's own earlier chapters, and the second takes them from the
    reference solution. A check that passes only in the second run failed because of a mistake in an
    earlier chapter. The reports show only the messages of the first run. In the second run, the
    student's code could read the reference and leak it in a message.
    """
    deadline = time.monotonic() + SUBMISSION_LIMIT

    def run(chapter: Chapter, engine: list[Path]) -> list[Verdict]:
        limit = max(LEAST_TIME, min(Limits.run, deadline - time.monotonic()))
        missing = {m: why for m, why in staged.missing.items() if not _is_there(m, engine)}
        return assignment.run(chapter, engine, missing=missing, run_limit=limit, compiled=compiled)

    def causes(chapter: Chapter, own: list[Result], verdicts: list[Verdict]) -> list[Cause]:
        return causes_of(assignment.whole(chapter), own, verdicts, assignment.earlier)

    graded: list[_Graded] = []
    for chapter in assignment.chapters:
        results = partial(results_of, chapter)
        try:
            if _is_empty(chapter, staged):
                verdicts = once.of_nothing(assignment, chapter)
                own = results(verdicts)
                graded.append(_Graded(own, own, causes(chapter, own, verdicts)))
                continue
            verdicts = run(chapter, engine)
        except GraderError as error:
            errors = _errors(chapter, str(error))
            graded.append(_Graded(errors, errors))
            continue
        below = below_and_not_given(chapter, assignment.given, assignment.root)
        try:
            again = run_on_given(chapter, verdicts, engine, below, run, assignment.root)
        except GraderError as error:
            graded.append(_Graded(results(verdicts), _errors(chapter, str(error))))
            continue
        verdicts = mark_inherited(verdicts, again)
        own = results(verdicts)
        on_given = results(again) if again else own
        graded.append(_Graded(own, on_given, causes(chapter, own, verdicts)))
    return graded


def _is_empty(chapter: Chapter, staged: Staged) -> bool:
    """Return True if a student has handed in no file for this chapter, not even a rejected one.

    Every such student gets the same results, so the checks do not need to run again.
    """
    refused = any(module.startswith(f"{chapter.name}.") for module in staged.missing)
    return not refused and not any(name.startswith(f"{chapter.name}/") for name in staged.taken)


def _is_there(module: str, engine: list[Path]) -> bool:
    """Return True if the engine has a module, although the student's own file was rejected.

    This is the case if the reference's version of an earlier chapter replaces the student's.
    """
    return any((folder / file_of(module)).exists() for folder in engine)


def _chart(
    assignment: Assignment, once: OnceForAll, chapter: Chapter, result: Result
) -> Chart | None:
    """Build the chart of an open exercise, which compares a student's solution with the reference.

    It plots the error of both solutions against their cost. The result is None if no check has
    measured the student's solution.
    """
    if result.on_chart is None:
        return None
    reference = {
        other.exercise.id: other.on_chart for other in once.of_reference(assignment, chapter)
    }
    exercise = result.exercise
    return Chart(exercise.chart, result.on_chart, reference.get(exercise.id))


def _errors(chapter: Chapter, reason: str) -> list[Result]:
    """Build the results of a chapter whose checks could not be run.

    Each exercise is reported as a grader error, so that the student does not get a zero for it.
    """
    why = presentable(Message(reason[:500]))
    ours = [Verdict("every check", e.id, 1, "error", why) for e in chapter.exercises]
    return results_of(chapter, ours)


def _report(
    assignment: Assignment,
    once: OnceForAll,
    student: str,
    graded: list[_Graded],
    notes: list[str],
) -> StudentReport:
    own = [result for chapter in graded for result in chapter.own]
    given = [result for chapter in graded for result in chapter.on_given]
    score, points = total(own)
    failed = any(result.status == "error" for result in [*own, *given])
    return StudentReport(
        student=student,
        status="error, retry" if failed else "graded",
        seed=assignment.seed,
        isolation=str(assignment.level),
        score=score,
        score_on_given=total(given)[0],
        points=points,
        by_hand=None,
        waiting=sum(result.exercise.points for result in own if result.status == "waiting"),
        earlier=_own_earlier_chapters(assignment),
        notes=notes,
        exercises=[
            _exercise(chapter, result, better, _chart(assignment, once, chapter, result))
            for chapter, results in zip(assignment.chapters, graded, strict=True)
            for result, better in zip(results.own, results.on_given, strict=True)
        ],
        causes=[cause for chapter in graded for cause in chapter.causes],
    )


def _own_earlier_chapters(assignment: Assignment) -> list[int]:
    """List the student's own earlier chapters on which the graded chapters build, such as [2, 3].

    Earlier chapters from the reference solution are left out.
    """
    below = [
        other.number
        for chapter in assignment.chapters
        for other in below_and_not_given(chapter, assignment.given, assignment.root)
    ]
    return sorted(set(below))


def _exercise(
    chapter: Chapter, result: Result, better: Result, chart: Chart | None
) -> ExerciseReport:
    exercise = result.exercise
    return ExerciseReport(
        chapter=chapter.number,
        id=exercise.id,
        title=exercise.title,
        kind=exercise.kind,
        points=exercise.points,
        score=result.score,
        score_on_given=better.score,
        status=result.status,
        comment="",
        checks=[check_report(check) for check in result.checks],
        chart=chart,
        extra=exercise.extra,
    )
