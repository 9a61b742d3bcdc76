"""Define how a class is graded, and cache the results of checks that are the same for everybody.

For example, all students who handed in nothing for a chapter get the same results on it.
"""

from __future__ import annotations

import contextlib
import hashlib
import platform
import tempfile
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from autograder.checks.arrange import SandboxSettings, shared_by_checks
from autograder.checks.runner import GraderError, Limits, run_checks
from autograder.checks.verdict import Verdict
from autograder.diagnosis.earlier_chapters import has_reference, with_given
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapter, load_chapters
from autograder.message import Kind, Message
from autograder.reports.report import RunKey
from autograder.submissions.stage import stage


@dataclass(frozen=True)
class Conditions:
    """The conditions of grading, which are the same for the whole class.

    ``earlier`` has the exercises of earlier assignments that the graded ones build on, with the
    names of these assignments.
    """

    chapters: list[Chapter]  # with only the graded exercises
    seed: str
    level: Level
    given: Sequence[Chapter] = ()  # they come from the reference, whatever is handed in
    hidden: Path | None = None  # the folder of hidden checks
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
        """Run the checks of a chapter's graded exercises, and of their prerequisites.

        ``missing`` has the reason for each rejected module of the submission. The compiled code is
        kept in the folder ``compiled`` for later runs. Raise GraderError if the checks cannot run.
        """
        if exercises is None:
            exercises = [e.id for e in chapter.exercises if e.kind != "written"]
        if not exercises:
            return []
        why = {name: Message(words, kind=Kind.BROKEN) for name, words in (missing or {}).items()}
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
        """Return the chapter with all exercises, because a graded one may build on any of them."""
        return load_chapter(self.root / "chapters" / chapter.name)


def run_key(conditions: Conditions) -> RunKey:
    """Describe everything that a report depends on, apart from the submission itself."""
    root = conditions.root
    checks = shared_by_checks(root)
    for chapter in load_chapters(root):
        for folder in ("tests", "solutions"):
            checks += (root / folder / chapter.name).glob("*.py")
        checks += (root / "chapters" / chapter.name).glob("*.toml")
        checks += (root / "chapters" / chapter.name).rglob("*.py")  # given modules, too
    if conditions.hidden:
        checks += conditions.hidden.rglob("*.py")
    exercises = [exercise for chapter in conditions.chapters for exercise in chapter.exercises]
    return RunKey(
        seed=conditions.seed,
        chapters=[chapter.number for chapter in conditions.chapters],
        points={exercise.id: exercise.points for exercise in exercises},
        extra=[exercise.id for exercise in exercises if exercise.extra],
        given=[chapter.number for chapter in conditions.given],
        earlier=dict(conditions.earlier),
        checks=_digest(checks),
        grader=grader_digest(),
        python=platform.python_version(),
        level=vars(conditions.level),
        time_limit=conditions.time_limit,
    )


def grader_digest() -> str:
    """Compute a digest of the autograder, whose every version grades a class anew."""
    return _digest((ROOT / "autograder").rglob("*.py"))


def _digest(files: Iterable[Path]) -> str:
    digest = hashlib.sha256()
    for file in sorted(files):
        content = file.read_bytes()
        digest.update(f"{file.parent.name}/{file.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


class OnceForAll:
    """A cache of check results that are the same for every student, shared by all threads."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._found: dict[tuple[str, str], list[Verdict]] = {}

    def of_nothing(self, conditions: Conditions, chapter: Chapter) -> list[Verdict]:
        """Return the results for students who have handed in no file for a chapter.

        The chapters that it builds on come from the reference solution.
        """
        return self._once("nothing", _run_on_nothing, conditions, chapter)

    def of_reference(self, conditions: Conditions, chapter: Chapter) -> list[Verdict]:
        """Return the results of the reference on the exercises with a chart, or none."""
        return self._once("reference", _run_on_reference, conditions, chapter)

    def _once(
        self,
        what: str,
        run: Callable[[Conditions, Chapter], list[Verdict]],
        conditions: Conditions,
        chapter: Chapter,
    ) -> list[Verdict]:
        with self._lock:  # the first thread runs the checks, and the others wait for it
            if (what, chapter.name) not in self._found:
                self._found[what, chapter.name] = run(conditions, chapter)
            return self._found[what, chapter.name]


def _run_on_nothing(conditions: Conditions, chapter: Chapter) -> list[Verdict]:
    root = conditions.root
    available = [other for other in chapters_below(chapter, root) if has_reference(other, root)]
    with tempfile.TemporaryDirectory(prefix="nothing-") as folder:
        box, empty = Path(folder) / "box", Path(folder) / "empty"
        box.mkdir()
        empty.mkdir()
        stage(empty, load_chapters(root), box, root)
        with with_given(available, [box], root) as engine:
            return conditions.run(chapter, engine)


def _run_on_reference(conditions: Conditions, chapter: Chapter) -> list[Verdict]:
    root = conditions.root
    wanted = [exercise.id for exercise in chapter.exercises if exercise.chart]
    if has_reference(chapter, root):
        with contextlib.suppress(GraderError, OSError):  # grade without them
            engine = [root / "solutions", root / "chapters"]
            return conditions.run(chapter, engine, exercises=wanted)
    return []
