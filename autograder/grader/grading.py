"""Grade one submission: copy its files, run its checks in the sandbox, and return its report."""

from __future__ import annotations

import re
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

from autograder.checks.presentable import presentable
from autograder.checks.runner import GraderError, Limits
from autograder.checks.verdict import Verdict, needs_of
from autograder.diagnosis.earlier_chapters import (
    below_and_not_given,
    mark_inherited,
    run_on_given,
    with_given,
)
from autograder.diagnosis.undefined import file_of
from autograder.grader.conditions import Conditions, on_nothing, on_reference
from autograder.manifest import Chapter, load_chapters
from autograder.message import Message
from autograder.reports.report import Cause, StudentReport
from autograder.scores import Result, results_of, total
from autograder.submissions.find import Submission, printable
from autograder.submissions.stage import Staged, stage

SUBMISSION_LIMIT = 300.0  # seconds for all chapters of a submission, which usually needs about 2 s
LEAST_TIME = 10.0  # seconds; a chapter gets at least this many, or its checks could not begin


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


def grade_submission(conditions: Conditions, submission: Submission) -> StudentReport:
    """Grade one student's submission, and return a report even if the grader itself fails."""
    if report := _nothing(conditions, submission):
        return report
    try:
        with staged_files(conditions, submission) as (staged, box):
            return grade_staged(conditions, submission, staged, box)
    except Exception as error:  # an error of the grader must not stop the rest of the class
        return report_of_failure(conditions, submission.student, repr(error))


def grade_staged(
    conditions: Conditions, submission: Submission, staged: Staged, box: Path
) -> StudentReport:
    """Grade the files of a submission that were copied to the folder ``box``."""
    if report := _nothing(conditions, submission, staged):
        return report
    start = time.monotonic()
    with (
        with_given(conditions.given, [box], conditions.root) as engine,
        tempfile.TemporaryDirectory(prefix="compiled-") as compiled,
    ):
        submitted = _Submitted(conditions, staged, engine, Path(compiled), start)
        graded = [submitted.grade(chapter) for chapter in conditions.chapters]
    notes = _notes(conditions, submission, staged)
    report = _report(conditions, submission.student, graded, notes)
    seconds = round(time.monotonic() - start, 3)
    return replace(report, submission=staged.digest, seconds=seconds)


def still_valid(
    conditions: Conditions, submission: Submission, report: StudentReport
) -> StudentReport | None:
    """Return an earlier report with today's notes, or None if other files would be graded now."""
    new = _nothing(conditions, submission)
    if new is None:
        with staged_files(conditions, submission) as (staged, _):
            notes = _notes(conditions, submission, staged)
            new = _nothing(conditions, submission, staged) or replace(
                report, nothing="", notes=notes, submission=staged.digest
            )
    same = (report.submission, report.status) == (new.submission, new.status)
    return replace(new, run=report.run) if same else None


def why_nothing(staged: Staged, graded: list[Chapter]) -> str:
    """Say why nothing of a submission can be graded, which is not worth 0 points, or return ""."""
    rejected = [module for module in staged.rejected if module not in staged.misplaced]
    found = {re.split(r"[./]", name)[0] for name in [*staged.taken, *rejected]}
    names = {chapter.name for chapter in graded}
    if staged.refused or found & names:
        return staged.refused
    if misplaced := _misplaced(staged, graded):
        return "; ".join(misplaced)
    if found:
        return f"it has no files of {', '.join(sorted(names))}, only of {', '.join(sorted(found))}"
    if staged.misplaced:
        return "; ".join(staged.rejected.values())
    return "no folder of a chapter was found, at most three levels down"


def _misplaced(staged: Staged, graded: list[Chapter]) -> list[str]:
    names = {chapter.name for chapter in graded}
    return [staged.rejected[m] for m in staged.misplaced if m.partition(".")[0] in names]


def _notes(conditions: Conditions, submission: Submission, staged: Staged) -> list[str]:
    return [*submission.notes, *staged.notes, *_misplaced(staged, conditions.chapters)]


def _nothing(
    conditions: Conditions, submission: Submission, staged: Staged | None = None
) -> StudentReport | None:
    """Build the report on a submission if it contains nothing that can be graded."""
    why = digest = submission.nothing
    if staged:
        why, digest = why_nothing(staged, conditions.chapters), staged.digest
        if why and submission.path.suffix.lower() == ".zip":  # a folder is named like the student
            why = f"'{submission.path.name}': {why}"
    if not why:
        return None
    places = [f"{c.name}/{c.edited_files[0]}" for c in conditions.chapters if c.edited_files]
    how = f"Hand in a folder or a zip file that contains folders of chapters: {', '.join(places)}"
    none = [_Graded([], []) for _ in conditions.chapters]
    return replace(
        _report(conditions, submission.student, none, [how, *submission.notes]),
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
    return replace(_report(conditions, student, graded, []), seconds=0.0)


def _errors(chapter: Chapter, reason: str) -> list[Result]:
    """Build the results of a chapter on which the grader itself failed, which are not zeros."""
    why = presentable(Message(reason[:500]))
    ours = [Verdict("every check", e.id, 1, "error", why) for e in chapter.exercises]
    return results_of(chapter, ours)


@dataclass(frozen=True)
class _Submitted:
    """The files of a submission, ready to be checked."""

    conditions: Conditions
    staged: Staged
    engine: list[Path]
    compiled: Path  # the folder for the bytecode of ``engine``, which all checks share
    start: float  # when grading began, in seconds

    def grade(self, chapter: Chapter) -> _Graded:
        """Run a chapter's checks twice on a student's code, and return the results of both runs.

        The first run uses the student's own earlier chapters, and the second takes them from the
        reference solution. A check that passes only in the second run failed because of a mistake
        in an earlier chapter. The reports show only the messages of the first run. In the second
        run, the student's code could read the reference and leak it in a message.
        """
        conditions, root = self.conditions, self.conditions.root
        names = [*self.staged.taken, *(name.replace(".", "/") for name in self.staged.rejected)]
        is_empty = not any(name.startswith(f"{chapter.name}/") for name in names)
        again: list[Verdict] = []
        try:
            if is_empty:
                verdicts = on_nothing(conditions, chapter)
            else:
                verdicts = self.run(chapter, self.engine)
        except GraderError as error:
            errors = _errors(chapter, str(error))
            return _Graded(errors, errors)
        if not is_empty:
            below = below_and_not_given(chapter, conditions.given, root)
            try:
                again = run_on_given(chapter, verdicts, self.engine, below, self.run, root)
            except GraderError as error:
                return _Graded(self._results(chapter, verdicts), _errors(chapter, str(error)))
            verdicts = mark_inherited(verdicts, again)
        own = self._results(chapter, verdicts)
        causes = _causes(conditions, chapter, own, verdicts)
        return _Graded(own, results_of(chapter, again) if again else own, causes)

    def run(self, chapter: Chapter, engine: list[Path]) -> list[Verdict]:
        """Run a chapter's checks within the time limit of a submission."""
        left = self.start + SUBMISSION_LIMIT - time.monotonic()
        limit = max(LEAST_TIME, min(Limits.run, left))
        # A rejected file does not matter if the reference replaces it.
        missing = {
            module: why
            for module, why in self.staged.rejected.items()
            if not any((folder / file_of(module)).exists() for folder in engine)
        }
        # The student's code can read the bytecode, and must not find that of the reference later.
        compiled = self.compiled if engine == self.engine else None
        return self.conditions.run(
            chapter, engine, missing=missing, run_limit=limit, compiled=compiled
        )

    def _results(self, chapter: Chapter, verdicts: list[Verdict]) -> list[Result]:
        """Return the results, with the reference's point beside each point on a chart."""
        results = results_of(chapter, verdicts)
        if not any(result.on_chart for result in results):
            return results
        ours = on_reference(self.conditions, chapter)
        points = {v.exercise: v.on_chart for v in reversed(ours) if v.on_chart}
        return [
            replace(r, reference=points.get(r.exercise.id) if r.on_chart else None) for r in results
        ]


def _causes(
    conditions: Conditions, chapter: Chapter, graded: list[Result], verdicts: list[Verdict]
) -> list[Cause]:
    """List the exercises that are not graded, but block graded ones because they fail."""
    whole = conditions.whole(chapter)
    ids = {result.exercise.id for result in graded}
    others = replace(whole, exercises=[e for e in whole.exercises if e.id not in ids])
    blocked = [result.exercise.id for result in graded if result.status == "blocked"]
    causes = []
    for result in results_of(others, verdicts):
        name = result.exercise.id
        blocks = [one for one in blocked if name in needs_of(whole, one)]
        if blocks and not result.works and result.status in ("failed", "blocked", "inherited"):
            shown = replace(result, checks=result.physics)
            causes.append(Cause(shown, conditions.earlier.get(name, ""), blocks))
    return causes


def _report(
    conditions: Conditions, student: str, graded: list[_Graded], notes: list[str]
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
            replace(result, score_on_given=better.score)
            for result, better in zip(own, given, strict=True)
        ],
        causes=[cause for chapter in graded for cause in chapter.causes],
    )
