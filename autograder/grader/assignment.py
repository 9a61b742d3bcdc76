"""The assignment that a class is graded on, and the verdicts shared by all submissions."""

from __future__ import annotations

import contextlib
import tempfile
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.checks.arrange import Behind
from autograder.checks.given import has_reference, with_given
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapter, load_chapters
from autograder.message import Kind, Message
from autograder.scores import Result, results_of
from autograder.submissions.stage import stage


@dataclass(frozen=True)
class Assignment:
    """What the submissions of a class are graded on: the same exercises and checks for everyone.

    ``chapters`` contain only the graded exercises, perhaps fewer than the manifest lists. The
    ``given`` chapters come from the reference, even if a student has handed in files for them.
    ``hidden`` is a folder of hidden checks, and ``level`` says which layers the sandbox has.
    """

    chapters: list[Chapter]
    seed: str
    level: Level
    given: Sequence[Chapter] = ()
    hidden: Path | None = None
    root: Path = ROOT
    time_limit: float = Limits.check

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
        """Run the checks of a chapter's graded exercises, along with those of their prerequisites.

        ``missing`` maps each rejected module to the reason. ``compiled`` is a folder that caches
        the compiled code of a submission between runs.

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
            behind=Behind(vars(self.level), missing=why, hidden=self.hidden, compiled=compiled),
        )

    def whole(self, chapter: Chapter) -> Chapter:
        """Return the chapter with every exercise in its manifest, graded or not."""
        return load_chapter(self.root / "chapters" / chapter.name)


class OnceForAll:
    """Verdicts that are the same for every submission, so that they are computed only once.

    All the threads that grade a class share this object. The first thread that needs a verdict runs
    the checks for it, and the others wait for the result.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._of_nothing: dict[str, list[Verdict]] = {}
        self._of_reference: dict[str, list[Result]] = {}

    def of_nothing(self, assignment: Assignment, chapter: Chapter) -> list[Verdict]:
        """Return the verdicts on a chapter for which a student has handed in nothing.

        The earlier chapters come from the reference.

        Raises:
            GraderError: The checks could not be run.
        """
        with self._lock:
            if chapter.name not in self._of_nothing:
                self._of_nothing[chapter.name] = _run_on_nothing(assignment, chapter)
            return self._of_nothing[chapter.name]

    def of_reference(self, assignment: Assignment, chapter: Chapter) -> list[Result]:
        """Return the results of our own solution, whose cost and error are shown on the charts.

        Only open exercises have charts, so the results of all other exercises are not needed.
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
