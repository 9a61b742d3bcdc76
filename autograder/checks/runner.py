"""Run a chapter's checks in a separate process, and return the verdict on each.

Each check has a time limit. If a check hangs or its process dies, the remaining checks run in a new
process. All of this also works on Windows, but only without a sandbox.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.accepted_files import rejected_modules
from autograder.checks import events
from autograder.checks.arrange import Behind, Config, arrange
from autograder.checks.events import Event, read_event
from autograder.checks.judge import Ending, is_stopped, judge
from autograder.checks.no_verdict import why_no_verdict
from autograder.checks.presentable import presentable
from autograder.checks.verdict import Secret, Verdict, mark_blocked, needs_of, with_needs
from autograder.diagnosis.missing import while_imported
from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.message import Kind, Message

HURRIED = 0.25  # once a function has hung twice, later checks get only this part of the time limit


@dataclass(frozen=True)
class Limits:
    """The time limits, in seconds, for a single check and for all checks of a chapter together."""

    check: float = 3.0
    run: float = 90.0


Judging = Callable[["Run"], Ending]


class GraderError(Exception):
    """Raised when the checks could not be run, for reasons unrelated to the student's code."""


@dataclass(frozen=True)
class Order:
    """A request to run some of a chapter's checks on a student's code.

    Attributes:
        engine: The folders to search for the student's code. If several of them contain a module,
            the first one is used.
        behind: The settings of the sandbox for the student's code. If None, the code runs in the
            same process as the checks.
        apart: Whether to run each exercise's checks in a forked copy of the check process. In a
            sandbox, this setting has no effect.
    """

    chapter: Chapter
    engine: list[Path]
    exercises: list[str]
    seed: str
    limits: Limits = Limits()
    behind: Behind | None = None
    root: Path = ROOT
    apart: bool = True


def run_checks(
    chapter: Chapter,
    engine: list[Path],
    *,
    seed: str,
    exercises: list[str] | None = None,
    on_verdict: Callable[[int, int], None] | None = None,
    limits: Limits | None = None,
    behind: Behind | None = None,
    root: Path = ROOT,
    judge: Judging = judge,
) -> list[Verdict]:
    """Run a chapter's checks on a student's code, and return the verdict on each check.

    If ``exercises`` is given, only the checks of those exercises and their prerequisites run. To
    show the progress, ``on_verdict`` is called after each verdict with the number of verdicts so
    far and the total number of checks. ``Order`` and ``Run`` explain the other arguments.

    Raises:
        GraderError: The checks could not be run.
    """
    wanted = with_needs(chapter, exercises)
    order = Order(chapter, engine, wanted, seed, limits or Limits(), behind, root)
    run = Run(order, on_verdict, judge)
    while not run.finished:
        if is_stopped():
            raise GraderError("the run was stopped")
        before = run.progress
        run.one_process()
        if time.monotonic() > run.deadline:
            run.give_up()
        elif not run.finished and run.progress == before:
            raise GraderError(why_no_verdict(run.stderr, order.chapter.name))
    return run.outcome()


class Run:
    """One run of a chapter's checks, which may take several processes to finish.

    ``judge`` is the function that starts such a process and passes its events to the run. It
    returns an ``Ending`` that describes how the process ended.
    """

    def __init__(
        self,
        order: Order,
        on_verdict: Callable[[int, int], None] | None = None,
        judge: Judging = judge,
    ) -> None:
        self.order = order
        self.root, self.behind = order.root, order.behind
        self.judge = judge
        self.on_verdict = on_verdict or (lambda *_: None)
        self.checks: dict[str, events.Check] = {}
        self.verdicts: dict[str, Verdict] = {}
        self.broken = dict(order.behind.missing) if order.behind else _rejected(order)
        self.deadline = time.monotonic() + order.limits.run
        self.current: events.Importing | events.Started | None = None  # what the process is doing
        self.finished = False
        self.restarts = False  # whether the process must end, to skip checks that would hang too
        self.hung: set[str] = set()  # exercises with a check that hung
        self.loops: list[str] = []  # the functions in which checks hung
        self.stderr = ""

    @property
    def limit(self) -> float:
        """The number of seconds that the next check may take.

        The limit becomes shorter once a function has hung twice, to save the student time.
        """
        hurried = len(set(self.loops)) < len(self.loops)
        return self.order.limits.check * (HURRIED if hurried else 1.0)

    @property
    def progress(self) -> tuple[int, int]:
        """The number of verdicts so far, and the number of modules that could not be imported.

        If neither number has grown when a process ends, starting another process is pointless.
        """
        return len(self.verdicts), len(self.broken)

    def outcome(self) -> list[Verdict]:
        """Return the verdicts in manifest order, and mark those that are blocked.

        A failed check is blocked if its exercise builds on another one that still fails.
        """
        verdicts = [self.verdicts[name] for name in self.checks]
        return mark_blocked(self.order.chapter, verdicts)

    def one_process(self) -> None:
        """Start a process for the checks that still need a verdict, and wait for it to end.

        If the process hangs or dies during a check, that check fails.
        """
        self.current, self.restarts = None, False
        ending = self.judge(self)
        self.stderr = ending.stderr
        if self.finished or self.current is None or time.monotonic() > self.deadline:
            return
        self._break_off(self.current, ending.explain(self.limit, self.order.engine))

    def config(self, folder: Path) -> Config:
        """Configure the next check process to skip all checks that already have a verdict."""
        order = self.order
        return Config(
            arranged=arrange(
                folder, order.chapter, order.engine, order.root, order.behind, self.broken
            ),
            exercises=order.exercises,
            seed=order.seed,
            time_limit=self.limit,
            apart=order.apart,
            stack_file=str(folder / "stack.txt"),
            broken=self.broken,
            done=list(self.verdicts),
        )

    def hear(self, line: str) -> None:
        """Parse one line of the check process's output, and handle the event that it reports."""
        try:
            event = read_event(line)
        except ValueError as error:
            raise GraderError(f"the check process sent an unknown event, {line[:200]!r}") from error
        self.take(event)

    def take(self, event: Event) -> None:
        """Handle an event from the check process, such as a verdict.

        Raises:
            GraderError: The event is about a check that is not part of this run.
        """
        doing, self.current = self.current, None
        match event:
            case events.Importing() | events.Started():
                self.current = event
            case events.Broken():
                self.broken[event.module] = event.message
            case events.Checks():
                self.checks = {check.name: check for check in event.checks}
                self.on_verdict(len(self.verdicts), len(self.checks))
            case events.Decided():
                self._decide(event)
                if event.message.kind is Kind.HUNG:  # it used up its memory
                    self.restarts = self._note_hang(self.checks[event.name].exercise)
            case events.Ended():
                self.finished, self.current = doing is None, doing

    def _break_off(self, doing: events.Importing | events.Started, why: Message) -> None:
        """Record that a check or an import did not finish, because it hung or ended the process."""
        if isinstance(doing, events.Importing):
            self.broken[doing.module] = while_imported(doing.module, why)
            return
        self._decide(events.Decided(doing.name, "failed", why))
        if why.kind is Kind.HUNG:
            self._note_hang(self.checks[doing.name].exercise)
            self.loops.append(why.where.function if why.where else "")
        self.finished = len(self.verdicts) == len(self.checks)

    def _decide(self, decided: events.Decided) -> None:
        check = self.checks.get(decided.name)
        if check is None:
            raise GraderError(
                f"the check process sent a verdict on an unknown check, {decided.name[:200]!r}"
            )
        message, status = presentable(self._with_rejected_data(decided.message)), decided.status
        secret = None
        if check.rationale is not None:
            secret = Secret(check.real_name, message)
            # Any other part of the message could reveal what is checked, and how.
            words = {"failed": check.rationale, "error": "the grader failed on this check"}
            message = presentable(Message(words.get(status, "")))
        self.verdicts[check.name] = Verdict(
            check.name,
            check.exercise,
            check.weight,
            status,
            message,
            check.rationale is not None,
            decided.on_chart,
            check.robust,
            secret,
        )
        self.on_verdict(len(self.verdicts), len(self.checks))

    def _with_rejected_data(self, message: Message) -> Message:
        """Explain a failure to read a file of measurements that was rejected, such as drops.csv."""
        for module, why in self.broken.items():
            name = module.partition(".")[2]
            if "." in name and name in message.title + message.got:
                return replace(message, likely=why.title)
        return message

    def give_up(self) -> None:
        """Fail all remaining checks, because the run has exceeded its overall time limit."""
        seconds = f"{self.order.limits.run:g} seconds"
        if not self.checks:
            raise GraderError(f"no check began within {seconds}:\n{self.stderr}")
        for name in self.checks:
            if name not in self.verdicts:
                why = Message(f"not run: the time limit of {seconds} for all checks was used up")
                self._decide(events.Decided(name, "failed", why))
        self.finished = True

    def _note_hang(self, exercise: str) -> bool:
        """Record that a check hung, and skip the exercise's other checks, which then fail.

        In a sandbox, where they may still earn points, they are skipped only if a check of a
        prerequisite has hung too. Return True if any was skipped.
        """
        before = len(self.verdicts)
        if self.order.behind is None or self.hung & needs_of(self.order.chapter, exercise):
            why = Message("not run: another check of this exercise did not finish")
            for name, check in self.checks.items():
                if name not in self.verdicts and check.exercise == exercise:
                    self._decide(events.Decided(name, "failed", why))
        self.hung.add(exercise)
        return len(self.verdicts) > before


def _rejected(order: Order) -> dict[str, Message]:
    """Find the files that the grader would reject, so that students learn about them at home."""
    chapters = [*chapters_below(order.chapter, order.root), order.chapter]
    reasons = rejected_modules(chapters, order.engine)
    return {module: Message(why, kind=Kind.BROKEN) for module, why in reasons.items()}
