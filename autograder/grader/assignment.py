"""Define the assignment to grade, and cache the check results that are the same for all students.

For example, all students who handed in nothing for a chapter get the same results on it.
"""

from __future__ import annotations

import contextlib
import tempfile
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from autograder.checks.arrange import SandboxSettings
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.diagnosis.earlier_chapters import has_reference, with_given
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapter, load_chapters
from autograder.message import Kind, Message
from autograder.scores import Result, results_of
from autograder.submissions.stage import stage


@dataclass(frozen=True)
class Assignment:
    """An assignment to grade, with the same exercises, checks and settings for the whole class.

    Attributes:
        chapters: The graded chapters, with only the graded exercises.
        seed: The seed for the random numbers in the checks.
        level: The layers of the sandbox that confine the students' code.
        given: Earlier chapters that come from the reference solution, even if a student has handed
            in files for them.
        hidden: A folder of hidden checks, which students do not receive, or None.
        earlier: The exercises of earlier assignments that the graded ones build on, with the names
            of these assignments.
    """

    chapters: list[Chapter]
    seed: str
    level: Level
    given: Sequence[Chapter] = ()
    hidden: Path | None = None
    root: Path = ROOT
    time_limit: float = Limits.check
    earlier: Mapping[str, str] = field(default_factory=dict)

    def run(
        self,
        chapter: Chapter,
        engine: list[Path],
        *,
        missing: dict[str, str] | None = None,
        run_limit: float = Limits.run,
        compiled: Path | None = None,
        exercises: list[str] | None = None,
    ) -> list[Verdict]:
        """Run the checks of a chapter's graded exercises on one student's code.

        The checks of prerequisite exercises run too, because a failure in a prerequisite may
        explain a failure in a graded exercise. ``missing`` maps each rejected module of the
        submission to the reason for its rejection. The compiled code is kept in the folder
        ``compiled`` for later runs.

        Raises:
            GraderError: The checks could not be run.
        """
        if exercises is None:
            exercises = [e.id for e in chapter.exercises if e.kind != "written"]
        if not exercises:
            return []
        why = {
            module: Message(reason, kind=Kind.BROKEN) for module, reason in (missing or {}).items()
        }
        return run_checks(
            self.whole(chapter),
            engine,
            seed=self.seed,
            root=self.root,
            exercises=exercises,
            limits=Limits(self.time_limit, run_limit),
            sandbox=SandboxSettings(vars(self.level), why, self.hidden, compiled),
        )

    def whole(self, chapter: Chapter) -> Chapter:
        """Return the chapter with all of its exercises, including those that are not graded.

        These exercises are included because a graded exercise may build on them.
        """
        return load_chapter(self.root / "chapters" / chapter.name)


class OnceForAll:
    """A cache of check results that are the same for every student in a class.

    All the threads that grade a class share this cache. The first thread that needs a result runs
    the checks, and the others wait for it.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._of_nothing: dict[str, list[Verdict]] = {}
        self._of_reference: dict[str, list[Result]] = {}

    def of_nothing(self, assignment: Assignment, chapter: Chapter) -> list[Verdict]:
        """Return the results for students who have handed in no file for a chapter.

        All such students get the same results. If the chapter builds on earlier ones, the code of
        the earlier chapters comes from the reference solution.

        Raises:
            GraderError: The checks could not be run.
        """
        with self._lock:
            if chapter.name not in self._of_nothing:
                self._of_nothing[chapter.name] = _run_on_nothing(assignment, chapter)
            return self._of_nothing[chapter.name]

    def of_reference(self, assignment: Assignment, chapter: Chapter) -> list[Result]:
        """Return the results of the reference solution on the exercises that have a chart.

        The chart compares the cost and the error of a student's solution with those of the
        reference solution. If the reference solution cannot be checked, the chart shows only the
        student's solution.
        """
        root = assignment.root
        with self._lock:
            if chapter.name not in self._of_reference:
                wanted = [exercise.id for exercise in chapter.exercises if exercise.chart]
                found: list[Verdict] = []
                if has_reference(chapter, root):
                    engine = [root / "solutions", root / "chapters"]
                    with contextlib.suppress(GraderError, OSError):  # grade without them
                        found = assignment.run(chapter, engine, exercises=wanted)
                self._of_reference[chapter.name] = results_of(chapter, found)
            return self._of_reference[chapter.name]


def _run_on_nothing(assignment: Assignment, chapter: Chapter) -> list[Verdict]:
    below = chapters_below(chapter, assignment.root)
    available = [other for other in below if has_reference(other, assignment.root)]
    with tempfile.TemporaryDirectory(prefix="nothing-") as folder:
        box, empty = Path(folder) / "box", Path(folder) / "empty"
        box.mkdir()
        empty.mkdir()
        stage(empty, load_chapters(assignment.root), box, assignment.root)
        with with_given(available, [box], assignment.root) as engine:
            return assignment.run(chapter, engine)
