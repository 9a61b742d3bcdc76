"""Run a chapter's checks in a separate process, with a time limit for each, and give verdicts.

If a check hangs or ends its process, the other checks still run, in a new process. Without a
sandbox, nothing here needs POSIX.
"""

from __future__ import annotations

import json
import re
import tempfile
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from autograder.checks import events
from autograder.checks.apart import how_it_ended
from autograder.checks.arrange import Behind, Config, arrange, root_of_checks
from autograder.checks.events import Event, read_event
from autograder.checks.explain import explain_hang
from autograder.checks.judge import Judge, SilentError, is_stopped
from autograder.checks.missing import while_imported
from autograder.checks.verdict import Verdict, mark_blocked, needs_of, with_needs
from autograder.clean import clean
from autograder.manifest import ROOT, Chapter
from autograder.message import Kind, Message
from autograder.records import to_json

HURRIED = 0.25  # fraction of the time limit for later checks, once one function has hung twice
LONGEST_MESSAGE = 8000  # characters; a message shows returned values, which may be huge
LONGEST_PART = 800  # characters of each part, if the whole message is too long
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")  # of an object; it differs in every run


@dataclass(frozen=True)
class Limits:
    """Time limits in seconds, for one check (which takes milliseconds) and for a whole run."""

    check: float = 3.0
    run: float = 90.0


class GraderError(Exception):
    """The checks could not be run, and this is not the fault of the checked code."""


@dataclass(frozen=True)
class Order:
    """The checks to run: those of some exercises of a chapter, on an engine.

    ``engine`` is a list of chapter folders; the first overlays the others. The student's code runs
    in the sandbox that ``behind`` describes or, if that is None, in the process of the checks. In
    the second case, ``apart`` runs each exercise in a copy of that process.
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
) -> list[Verdict]:
    """Run the checks of a chapter on an engine, and return a verdict for each.

    ``exercises`` limits the run to some exercises and those that they need. ``on_verdict`` is
    called with the number of verdicts so far and the number of checks. ``Order`` explains the other
    arguments.

    Raises:
        GraderError: The checks themselves cannot be run.
    """
    wanted = with_needs(chapter, exercises)
    run = Run(Order(chapter, engine, wanted, seed, limits or Limits(), behind, root), on_verdict)
    while not run.finished:
        if is_stopped():
            raise GraderError("the run was stopped")
        before = run.progress
        run.one_process()
        if time.monotonic() > run.deadline:
            run.give_up()
        elif not run.finished and run.progress == before:
            raise GraderError(run.reason())
    return run.outcome()


class Run:
    """The state of a run, which may take several processes."""

    def __init__(self, order: Order, on_verdict: Callable[[int, int], None] | None = None) -> None:
        self.order = order
        self.on_verdict = on_verdict or (lambda *_: None)
        self.checks: dict[str, events.Check] = {}
        self.verdicts: dict[str, Verdict] = {}
        self.broken = dict(order.behind.missing) if order.behind else {}
        self.deadline = time.monotonic() + order.limits.run
        self.current: events.Importing | events.Started | None = None  # what the process is doing
        self.finished = False
        self.hung: set[str] = set()  # exercises with a check that hung
        self.loops: list[str] = []  # the functions in which checks hung
        self.stderr = ""

    def reason(self) -> str:
        """Return why there are no verdicts."""
        if missing := re.search(r"No module named '(ch\d\d_\w+)'", self.stderr):
            own = self.order.chapter.name
            return f"{missing[1]} is missing: put your own folder of that name beside {own}"
        words = self.stderr or "it printed nothing"
        if "INTERNALERROR>" in words:  # leave out pytest's own traceback
            words = words.rpartition("INTERNALERROR>")[2].strip()
        return f"the check process stopped without a verdict: {words}"

    @property
    def limit(self) -> float:
        """The time limit of the next check in seconds."""
        hurried = len(set(self.loops)) < len(self.loops)
        return self.order.limits.check * (HURRIED if hurried else 1.0)

    @property
    def progress(self) -> tuple[int, int]:
        """The numbers of verdicts and of broken modules, which grow as the run makes progress."""
        return len(self.verdicts), len(self.broken)

    def outcome(self) -> list[Verdict]:
        """Return the verdicts in the order of the checks."""
        verdicts = [self.verdicts[name] for name in self.checks]
        return mark_blocked(self.order.chapter, verdicts)

    def one_process(self) -> None:
        """Start a process for the checks that have no verdict yet, and follow it until it ends."""
        order, silent, self.current = self.order, False, None
        # Windows keeps the files of a process open for a moment after it ends.
        with tempfile.TemporaryDirectory(prefix="checks-", ignore_cleanup_errors=True) as name:
            folder = Path(name)
            stack_file = folder / "stack.txt"
            stack_file.touch()
            config = folder / "config.json"  # may be too long for a command line
            config.write_text(json.dumps(to_json(self.config(folder))), encoding="utf-8")
            place = root_of_checks(folder, order.root, order.behind)
            judge = Judge(config, place, holds_input=order.behind is not None)
            try:
                with closing(judge.lines(self.limit, self.deadline)) as lines:
                    for line in lines:
                        self.take(_event(line))
            except SilentError:
                silent = True
            self.stderr = judge.stderr
            if self.finished or self.current is None or time.monotonic() > self.deadline:
                return
            stack = stack_file.read_text(encoding="utf-8", errors="replace")
        if stack or silent:
            why = explain_hang(stack, self.limit, order.engine)
        else:
            why = Message(how_it_ended(judge.code), kind=Kind.LEFT)
        self._break_off(self.current, why)

    def config(self, folder: Path) -> Config:
        """Return the configuration for the check process."""
        order = self.order
        return Config(
            arranged=arrange(folder, order.chapter, order.engine, order.root, order.behind),
            exercises=order.exercises,
            seed=order.seed,
            time_limit=self.limit,
            apart=order.apart,
            stack_file=str(folder / "stack.txt"),
            broken=self.broken,
            done=list(self.verdicts),
        )

    def take(self, event: Event) -> None:
        """Handle one event of the process.

        Raises:
            GraderError: The event is about an unknown check.
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
            case events.Ended():
                self.finished, self.current = doing is None, doing

    def _break_off(self, doing: events.Importing | events.Started, why: Message) -> None:
        """Record what the process was doing when it ended early."""
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
        message, status, behind = decided.message, decided.status, self.order.behind
        if check.rationale is not None and behind is not None and not behind.for_instructor:
            # Anything else could reveal what is checked, and how.
            words = {"failed": check.rationale, "error": "the grader failed on this check"}
            message = Message(words.get(status, ""))
        self.verdicts[check.name] = Verdict(
            check.name,
            check.exercise,
            check.weight,
            status,
            presentable(message),
            check.rationale is not None,
            decided.on_chart,
            check.robust,
        )
        self.on_verdict(len(self.verdicts), len(self.checks))

    def give_up(self) -> None:
        """Fail the remaining checks, because the time for the whole run is used up."""
        seconds = f"{self.order.limits.run:g} seconds"
        if not self.checks:
            raise GraderError(f"no check began within {seconds}:\n{self.stderr}")
        for name in self.checks:
            if name not in self.verdicts:
                why = Message(f"not run: the time limit for all checks, {seconds}, was used up")
                self._decide(events.Decided(name, "failed", why))
        self.finished = True

    def _note_hang(self, exercise: str) -> None:
        """Give up an exercise after its first hang if an exercise that it builds on hangs as well.

        Its other checks would probably hang in the same loop, each for the whole time limit.
        """
        if self.hung & needs_of(self.order.chapter, exercise):
            why = Message("not run: another check of this exercise did not finish")
            for name, check in self.checks.items():
                if name not in self.verdicts and check.exercise == exercise:
                    self._decide(events.Decided(name, "failed", why))
        self.hung.add(exercise)


def presentable(message: Message) -> Message:
    """Return a message that may be shown: cleaned, without addresses, and not too long.

    All text that comes from a student's code passes through this function.
    """
    message = message.changed(lambda text: ADDRESS.sub("", clean(text)))
    return message if len(str(message)) <= LONGEST_MESSAGE else message.changed(_cut)


def _cut(text: str) -> str:
    if len(text) <= LONGEST_PART:
        return text
    return f"{text[: LONGEST_PART - 50]} ... ({len(text)} characters in all)"


def _event(line: str) -> Event:
    try:
        return read_event(line)
    except ValueError as error:
        raise GraderError(f"the check process sent an unknown event, {line[:200]!r}") from error
