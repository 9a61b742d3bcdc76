"""Run a chapter's checks in a separate process, and return the verdict on each.

Each check has a time limit. If a check hangs or its process dies, the remaining checks run in a new
process.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.accepted_files import rejected_modules
from autograder.checks import events
from autograder.checks.arrange import Config, Request, SandboxSettings, arrange
from autograder.checks.check_process import Ending, is_stopped, run_process
from autograder.checks.events import Event, read_event
from autograder.checks.presentable import presentable
from autograder.checks.verdict import Secret, Verdict, mark_blocked, needs_of, with_needs
from autograder.diagnosis.undefined import while_imported
from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.message import Kind, Message

HURRIED = 0.25  # once a function has hung twice, later checks get only this part of the time limit


@dataclass(frozen=True)
class Limits:
    """The time limits, in seconds, for a single check and for all checks of a chapter together."""

    check: float = 3.0
    run: float = 90.0


class GraderError(Exception):
    """Raised when the checks could not be run, for reasons unrelated to the student's code."""


def run_checks(
    chapter: Chapter,
    engine: list[Path],
    *,
    seed: str,
    exercises: list[str] | None = None,
    on_verdict: Callable[[int, int], None] | None = None,
    limits: Limits | None = None,
    sandbox: SandboxSettings | None = None,
    root: Path = ROOT,
    process: Callable[[Run], Ending] = run_process,
) -> list[Verdict]:
    """Run a chapter's checks on a student's code, and return the verdict on each check.

    If ``exercises`` is given, only the checks of those exercises and their prerequisites run.
    ``on_verdict`` is called with the number of verdicts so far and of all checks. ``process`` runs
    a process, and passes its events to the run. Raise GraderError if the checks cannot run.
    """
    wanted = with_needs(chapter, exercises)
    run = Run(Request(chapter, engine, wanted, seed, sandbox, root), limits, on_verdict)
    while not run.finished:
        if is_stopped():
            raise GraderError("the run was stopped")
        before = len(run.verdicts), len(run.broken)
        run.current, run.restarts = None, False
        ending = process(run)
        run.end_process(ending)
        if time.monotonic() > run.deadline:
            run.give_up(ending)
        elif not run.finished and (len(run.verdicts), len(run.broken)) == before:
            raise GraderError(ending.why_no_verdict(chapter.name))
    return run.outcome()


class Run:
    """One run of a chapter's checks, which may take several processes to finish."""

    def __init__(
        self,
        request: Request,
        limits: Limits | None = None,
        on_verdict: Callable[[int, int], None] | None = None,
    ) -> None:
        self.request = request
        self.limits = limits or Limits()
        self.on_verdict = on_verdict or (lambda *_: None)
        self.checks: dict[str, events.Check] = {}
        self.verdicts: dict[str, Verdict] = {}
        sandbox = request.sandbox
        self.broken = dict(sandbox.missing) if sandbox else _rejected(request)
        self.deadline = time.monotonic() + self.limits.run
        self.current: events.Importing | events.Started | None = None  # what the process is doing
        self.finished = False
        self.restarts = False  # whether the process must end, to skip checks that would hang too
        self.hung: set[str] = set()  # exercises with a check that hung
        self.loops: list[str] = []  # the functions in which checks hung

    @property
    def limit(self) -> float:
        """The number of seconds that the next check may take."""
        hurried = len(set(self.loops)) < len(self.loops)
        return self.limits.check * (HURRIED if hurried else 1.0)

    def outcome(self) -> list[Verdict]:
        """Return the verdicts in manifest order, and mark those that are blocked."""
        return mark_blocked(self.request.chapter, [self.verdicts[name] for name in self.checks])

    def config(self, folder: Path) -> Config:
        """Configure a process that skips all checks that already have a verdict."""
        return arrange(folder, self.request, self.limit, self.broken, self.verdicts)

    def end_process(self, ending: Ending) -> None:
        """If the process hung or died during a check or an import, record that it failed."""
        doing = self.current
        if self.finished or doing is None or time.monotonic() > self.deadline:
            return
        why = ending.explain(self.limit, self.request.engine)
        if isinstance(doing, events.Importing):
            self.broken[doing.module] = while_imported(doing.module, why)
            return
        self._decide(events.Decided(doing.name, "failed", why))
        if why.kind is Kind.HUNG:
            self._note_hang(self.checks[doing.name].exercise)
            self.loops.append(why.where.function if why.where else "")
        self.finished = len(self.verdicts) == len(self.checks)

    def hear(self, line: str) -> None:
        """Parse one line of the check process's output, and handle the event that it reports."""
        try:
            event = read_event(line)
        except ValueError as error:
            raise GraderError(f"the check process sent an unknown event, {line[:200]!r}") from error
        self.take(event)

    def take(self, event: Event) -> None:
        """Handle an event from the check process, such as a verdict."""
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

    def _decide(self, decided: events.Decided) -> None:
        if (check := self.checks.get(decided.name)) is None:
            raise GraderError(f"there is a verdict on an unknown check, {decided.name[:200]!r}")
        message, status = presentable(self._with_rejected_data(decided.message)), decided.status
        secret = None
        if check.rationale is not None:
            secret = Secret(check.real_name, message)
            # Any other part of the message could reveal what is checked, and how.
            words = {"failed": check.rationale, "error": "the grader failed on this check"}
            message = presentable(Message(words.get(status, "")))
        self.verdicts[check.name] = Verdict(
            *(check.name, check.exercise, check.weight, status, message),
            hidden=secret is not None,
            on_chart=decided.on_chart,
            robust=check.robust,
            secret=secret,
        )
        self.on_verdict(len(self.verdicts), len(self.checks))

    def _with_rejected_data(self, message: Message) -> Message:
        """Explain a failure to read a data file that was rejected, such as drops.csv."""
        for module, why in self.broken.items():
            name = module.partition(".")[2]
            if "." in name and name in message.title + message.got:
                return replace(message, likely=why.title)
        return message

    def give_up(self, ending: Ending) -> None:
        """Fail all remaining checks, because the run has exceeded its overall time limit."""
        seconds = f"{self.limits.run:g} seconds"
        if not self.checks:
            raise GraderError(f"no check began within {seconds}:\n{ending.stderr}")
        self._skip(f"not run: the time limit of {seconds} for all checks was used up", self.checks)
        self.finished = True

    def _note_hang(self, exercise: str) -> bool:
        """Record that a check hung, skip the others of its exercise, and return if any was skipped.

        In a sandbox, where they may still earn points, they are skipped only if a check of a
        prerequisite has hung too.
        """
        before = len(self.verdicts)
        if not self.request.sandbox or self.hung & needs_of(self.request.chapter, exercise):
            same = [name for name, check in self.checks.items() if check.exercise == exercise]
            self._skip("not run: another check of this exercise did not finish", same)
        self.hung.add(exercise)
        return len(self.verdicts) > before

    def _skip(self, why: str, checks: Iterable[str]) -> None:
        """Fail those of the checks that have no verdict yet."""
        for name in checks:
            if name not in self.verdicts:
                self._decide(events.Decided(name, "failed", Message(why)))


def _rejected(request: Request) -> dict[str, Message]:
    """Find the files that the grader would reject, so that students learn about them at home."""
    chapters = [*chapters_below(request.chapter, request.root), request.chapter]
    reasons = rejected_modules(chapters, request.engine)
    return {module: Message(why, kind=Kind.BROKEN) for module, why in reasons.items()}
