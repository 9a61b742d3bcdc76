"""What a class is graded on, and what is worked out once for all of its submissions."""

from __future__ import annotations

import contextlib
import tempfile
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from autograder.checks.arrange import Behind
from autograder.checks.given import is_at_hand, with_given
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapters
from autograder.message import Kind, Message
from autograder.scores import Result, results_of
from autograder.submissions.stage import stage


@dataclass(frozen=True)
class Assignment:
    """What a class is graded on, the same for each submission.

    The ``given`` chapters are the reference's, whatever is handed in; ``hidden`` is a folder of
    further checks; ``level`` names the walls.
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
        exercises: list[str] | None = None,
    ) -> list[Verdict]:
        """Run a chapter's checks on an engine; ``missing`` modules were not taken, and why.

        Raises GraderError as run_checks does.
        """
        why = {
            module: Message(reason, kind=Kind.BROKEN) for module, reason in (missing or {}).items()
        }
        return run_checks(
            chapter,
            engine,
            seed=self.seed,
            root=self.root,
            exercises=exercises,
            limits=Limits(self.time_limit, run_limit),
            behind=Behind(vars(self.level), missing=why, hidden=self.hidden),
        )


class OnceForAll:
    """Verdicts that are the same for every submission to one assignment, each worked out once.

    The threads of a class share one: the first that asks works it out, and the others wait.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._of_nothing: dict[str, list[Verdict]] = {}
        self._of_reference: dict[str, list[Result]] = {}

    def of_nothing(self, assignment: Assignment, chapter: Chapter) -> list[Verdict]:
        """Return the verdicts on nothing but the reference's earlier chapters.

        Raises GraderError as run_checks does.
        """
        with self._lock:
            if chapter.name not in self._of_nothing:
                self._of_nothing[chapter.name] = _run_on_nothing(assignment, chapter)
            return self._of_nothing[chapter.name]

    def of_reference(self, assignment: Assignment, chapter: Chapter) -> list[Result]:
        """Return the reference's results in the open exercises; none where it is not at hand."""
        root = assignment.root
        with self._lock:
            if chapter.name not in self._of_reference:
                wanted = [exercise.id for exercise in chapter.exercises if exercise.chart]
                found: list[Verdict] = []
                if is_at_hand(chapter, root):
                    engine = [root / "solutions", root / "chapters"]
                    with contextlib.suppress(GraderError, OSError):  # it is graded without it
                        found = assignment.run(chapter, engine, exercises=wanted)
                self._of_reference[chapter.name] = results_of(chapter, found)
            return self._of_reference[chapter.name]


def _run_on_nothing(assignment: Assignment, chapter: Chapter) -> list[Verdict]:
    below = chapters_below(chapter, assignment.root)
    at_hand = [other for other in below if is_at_hand(other, assignment.root)]
    with tempfile.TemporaryDirectory(prefix="nothing-") as folder:
        box, empty = Path(folder) / "box", Path(folder) / "empty"
        box.mkdir()
        empty.mkdir()
        stage(empty, load_chapters(assignment.root), box, assignment.root)
        with with_given(at_hand, [box], assignment.root) as engine:
            return assignment.run(chapter, engine)
