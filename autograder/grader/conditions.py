"""Define how a class is graded, and run the checks that are the same for everybody once."""

from __future__ import annotations

import contextlib
import hashlib
import platform
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import wraps
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
    """The conditions of grading, which are the same for the whole class."""

    chapters: list[Chapter]  # with only the graded exercises
    seed: str
    level: Level
    given: Sequence[Chapter] = ()  # they come from the reference, whatever is handed in
    hidden: Path | None = None  # the folder of hidden checks
    root: Path = ROOT
    time_limit: float = Limits.check
    earlier: Mapping[str, str] = field(default_factory=dict)  # as in ``Work``
    found: dict[tuple[str, str], list[Verdict]] = field(default_factory=dict)  # for all students

    @property
    def reference(self) -> list[Path]:
        """The folders of our solutions, and of the files that students do not edit."""
        return [self.root / "solutions", self.root / "chapters"]

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
        """Run the checks of a chapter's graded exercises, and of their prerequisites."""
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


Run = Callable[[Conditions, Chapter], list[Verdict]]


def once_for_all(run: Run) -> Run:
    """Decorate a function whose results are the same for every student, and keep them."""

    @wraps(run)
    def keep(conditions: Conditions, chapter: Chapter) -> list[Verdict]:
        key = (run.__name__, chapter.name)
        if key not in conditions.found:
            conditions.found[key] = run(conditions, chapter)
        return conditions.found[key]

    return keep


@once_for_all
def on_nothing(conditions: Conditions, chapter: Chapter) -> list[Verdict]:
    """Check a chapter of which no file was handed in, on the reference of earlier chapters."""
    root = conditions.root
    available = [other for other in chapters_below(chapter, root) if has_reference(other, root)]
    with (
        tempfile.TemporaryDirectory(prefix="nothing-") as empty,
        tempfile.TemporaryDirectory(prefix="nothing-") as box,
    ):
        stage(Path(empty), load_chapters(root), Path(box), root)
        with with_given(available, [Path(box)], root) as engine:
            return conditions.run(chapter, engine)


@once_for_all
def on_reference(conditions: Conditions, chapter: Chapter) -> list[Verdict]:
    """Check the reference on the exercises with a chart, or return an empty list."""
    if has_reference(chapter, conditions.root):
        with contextlib.suppress(GraderError, OSError):  # grade without them
            charts = [exercise.id for exercise in chapter.exercises if exercise.chart]
            return conditions.run(chapter, conditions.reference, exercises=charts)
    return []


def check_hidden(conditions: Conditions) -> None:
    """Raise ValueError if hidden checks are missing, cannot be run, or fail on the reference."""
    hidden = conditions.hidden
    if hidden is None:
        return
    graded = [chapter for chapter in conditions.chapters if (hidden / chapter.name).is_dir()]
    if not graded:
        names = ", ".join(chapter.name for chapter in conditions.chapters)
        raise ValueError(f"--checks must be a folder with one of {names}, got {str(hidden)!r}")
    for chapter in graded:
        folder = hidden / chapter.name
        exercises = [exercise.id for exercise in chapter.exercises]
        try:
            verdicts = conditions.run(chapter, conditions.reference, exercises=exercises)
        except GraderError as error:
            raise ValueError(f"the checks in {folder} cannot be run: {error}") from error
        if not any(verdict.hidden for verdict in verdicts):
            raise ValueError(f"there is no check in {folder} of a graded exercise: add a test_*.py")
        for check in verdicts:
            if check.status != "passed":
                told = check.secret or check
                raise ValueError(f"{told.name} fails on the reference itself: {told.message}")
