"""Run a chapter's checks in a process of their own, hold each to a time limit, and give verdicts.

A check that hangs or ends its process costs only itself: the rest goes on in a new process.
Nothing here needs POSIX, where the code is not behind walls.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import IO, Any

from autograder.apart import how_it_ended
from autograder.arrange import Behind, arrange, root_of_checks
from autograder.explain import explain_hang
from autograder.faults import clean
from autograder.manifest import ROOT, Chapter

TIME_LIMIT = 3.0  # seconds for one check, which takes a few milliseconds
HURRIED = 0.25  # of that for the checks that are left, once one function has not ended twice
RUN_LIMIT = 90.0  # seconds for all the checks of a chapter
LONGEST_MESSAGE = 8000  # characters: what a student returns may be large, and is shown
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")  # of an object: another one in every run
GRACE = 10.0  # seconds of silence beyond a check's limit, then the process is ended from outside


Point = tuple[float, float]  # on the chart of an open exercise: cost, in counted work, and error


@dataclass(frozen=True)
class Verdict:
    """What became of one check. Status: passed, failed, blocked, inherited or error.

    ``robust`` says that the check is about bad arguments, overflow or NaN, and not the physics.
    """

    name: str
    exercise: str
    weight: float
    status: str
    message: str
    hidden: bool = False
    on_chart: Point | None = None
    robust: bool = False


class GraderError(Exception):
    """The checks could not be run, and that is no fault of the code that they check."""


def run_checks(
    chapter: Chapter,
    engine: list[Path],
    *,
    seed: str,
    root: Path = ROOT,
    exercises: list[str] | None = None,
    on_verdict: Callable[[int, int], None] | None = None,
    time_limit: float = TIME_LIMIT,
    run_limit: float = RUN_LIMIT,
    behind: Behind | None = None,
) -> list[Verdict]:
    """Run the checks of a chapter on an engine and return a verdict for each.

    ``engine`` is folders of chapters, the first on top; ``exercises`` limits the run to some and
    what they need; ``on_verdict`` hears how many verdicts there are, of how many checks; the
    engine's code runs ``behind`` walls, or beside the checks where they are None.
    Raises GraderError where the checks themselves cannot be run.
    """
    wanted = with_needs(chapter, exercises)
    hear = on_verdict or (lambda *_: None)
    run = _Run(chapter, engine, wanted, seed, root, time_limit, run_limit, hear, behind)
    run.broken |= behind.missing if behind else {}
    while not run.finished:
        if is_stopped():
            raise GraderError("the run was stopped")
        before = run.progress
        run.one_process()
        if time.monotonic() > run.deadline:
            run.give_up()
        elif not run.finished and run.progress == before:
            raise GraderError(run.reason())
    return _mark_blocked(chapter, run.ordered_verdicts())


_processes: set[subprocess.Popen[str]] = set()
_stopping = threading.Event()


@contextlib.contextmanager
def stopping() -> Iterator[None]:
    """End the runs in all threads, each of which raises GraderError; let none begin in here."""
    _stopping.set()
    for process in list(_processes):
        _kill(process)
    try:
        yield
    finally:
        _stopping.clear()


def is_stopped() -> bool:
    """Say whether runs are being ended."""
    return _stopping.is_set()


@dataclass
class _Run:
    """The state of a run over the processes that it may take."""

    chapter: Chapter
    engine: list[Path]
    wanted: list[str]
    seed: str
    root: Path
    time_limit: float
    run_limit: float
    on_verdict: Callable[[int, int], None]
    behind: Behind | None
    apart: bool = True  # each exercise in a copy of the process, where no worker is there for it
    checks: dict[str, dict[str, Any]] = field(default_factory=dict)
    verdicts: dict[str, Verdict] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)  # modules whose import hung or left
    deadline: float = 0.0
    finished: bool = False
    silent: bool = False
    hung: set[str] = field(default_factory=set)  # exercises of which a check did not end
    loops: list[str] = field(default_factory=list)  # the functions in which they did not
    stderr: str = ""

    def __post_init__(self) -> None:
        self.deadline = time.monotonic() + self.run_limit

    def reason(self) -> str:
        """Return why there are no verdicts."""
        if missing := re.search(r"No module named '(ch\d\d_\w+)'", self.stderr):
            return f"{missing[1]} is not here: put your own folder beside {self.chapter.name}"
        words = self.stderr or "it said nothing"
        if "INTERNALERROR>" in words:  # pytest's frames say nothing to anybody else
            words = words.rpartition("INTERNALERROR>")[2].strip()
        return f"the process of the checks stopped without a verdict; {words}"

    @property
    def limit(self) -> float:
        hurried = len(set(self.loops)) < len(self.loops)
        return self.time_limit * (HURRIED if hurried else 1.0)

    @property
    def progress(self) -> tuple[int, int]:
        return len(self.verdicts), len(self.broken)

    def ordered_verdicts(self) -> list[Verdict]:
        return [self.verdicts[name] for name in self.checks]

    def one_process(self) -> None:
        """Start a process for the checks that have no verdict yet, and follow it to its end."""
        self.silent = False
        # Windows holds on to the files of a process for a moment after its end.
        with tempfile.TemporaryDirectory(prefix="checks-", ignore_cleanup_errors=True) as folder:
            stack_file = Path(folder) / "stack.txt"
            stack_file.touch()
            config = Path(folder) / "config.json"  # it may be longer than a command line
            config.write_text(self._config(Path(folder)), encoding="utf-8")
            command = [sys.executable, "-m", "autograder.verdicts", str(config)]
            with (Path(folder) / "stderr.txt").open("w+b") as stderr:
                process = subprocess.Popen(
                    command,
                    cwd=root_of_checks(Path(folder), self.root, self.behind),
                    env=_environment(),
                    # A judge that outlives us would judge for nobody: it sees the pipe end.
                    stdin=subprocess.PIPE if self.behind else subprocess.DEVNULL,
                    stdout=subprocess.PIPE,
                    stderr=stderr,
                    encoding="utf-8",
                    start_new_session=True,
                )
                _processes.add(process)
                if is_stopped():  # it has been started behind the back of who ends them all
                    _kill(process)
                try:
                    current = self._follow(process)
                finally:
                    _processes.discard(process)
                    _kill(process)
                    process.wait()  # a stray child may hold on to its output, which stays open
                    if process.stdin:
                        process.stdin.close()
                stderr.seek(max(0, stderr.seek(0, os.SEEK_END) - 2000))
                self.stderr = stderr.read().decode("utf-8", errors="replace").strip()
            if self.finished or current is None or time.monotonic() > self.deadline:
                return
            stack = stack_file.read_text(encoding="utf-8", errors="replace")
        hung = bool(stack) or self.silent
        if hung:
            why = explain_hang(stack, self.limit, self.engine)
        else:
            why = how_it_ended(process.returncode)
        kind, name = current
        if kind == "import":
            self.broken[name] = f"{name.replace('.', '/')}.py, while it is imported: {why}"
        else:
            self._decide(name, "failed", why)
            if hung:
                self._note_hang(self.checks[name]["exercise"])
                self.loops.append(why.rpartition("in ")[2])
            self.finished = len(self.verdicts) == len(self.checks)

    def _config(self, folder: Path) -> str:
        """Return what the process of the checks is told, in the form that it reads."""
        arranged = arrange(folder, self.chapter, self.engine, self.root, self.behind)
        return json.dumps(
            arranged
            | {
                "exercises": self.wanted,
                "seed": self.seed,
                "time_limit": self.limit,
                "apart": self.apart,
                "stack_file": str(folder / "stack.txt"),
                "broken": self.broken,
                "done": list(self.verdicts),
            }
        )

    def _follow(self, process: subprocess.Popen[str]) -> tuple[str, str] | None:
        """Take the process's events until it ends; return what it was doing, if it broke off."""
        assert process.stdout is not None
        lines: queue.Queue[str] = queue.Queue()
        threading.Thread(target=_pass_on, args=(process.stdout, lines), daemon=True).start()
        current: tuple[str, str] | None = None
        while True:
            left = self.deadline - time.monotonic()
            try:
                line = lines.get(timeout=max(0.0, min(left, self.limit + GRACE)))
            except queue.Empty:
                self.silent = True
                return current
            if not line:
                return current
            try:
                current = self._take(json.loads(line), current)
            except (ValueError, KeyError, TypeError) as error:
                raise GraderError(f"the process of the checks sent {line[:200]!r}") from error

    def _take(
        self, event: dict[str, Any], current: tuple[str, str] | None
    ) -> tuple[str, str] | None:
        """Take one event; return what the process is doing after it."""
        match event["event"]:
            case "import":
                return "import", event["module"]
            case "imported":
                return None
            case "broken":
                self.broken[event["module"]] = event["message"]
            case "start":
                return "check", event["name"]
            case "checks":
                self.checks = {check["name"]: check for check in event["checks"]}
                self.on_verdict(len(self.verdicts), len(self.checks))
            case "verdict":
                self._decide(event["name"], event["status"], event["message"], event["on_chart"])
            case "end":
                self.finished = current is None
                return current
        return None

    def _decide(
        self, name: str, status: str, message: str, point: Sequence[float] | None = None
    ) -> None:
        check = self.checks[name]
        hidden = check["rationale"] is not None
        if hidden and self.behind is not None and not self.behind.tells:
            # Any other word could tell what is checked, and how.
            words = {"failed": check["rationale"], "error": "the grader failed on this check"}
            message = words.get(status, "")
        if self.behind:
            message = clean(message)
        message = ADDRESS.sub("", message)
        if len(message) > LONGEST_MESSAGE:
            message = f"{message[: LONGEST_MESSAGE - 50]}\n... {len(message)} characters in all"
        place = (point[0], point[1]) if point else None
        self.verdicts[name] = Verdict(
            name,
            check["exercise"],
            check["weight"],
            status,
            message,
            hidden,
            place,
            check["robust"],
        )
        self.on_verdict(len(self.verdicts), len(self.checks))

    def give_up(self) -> None:
        """Decide the checks that are left when the time for all of them is used up."""
        if not self.checks:
            raise GraderError(f"no check began within {self.run_limit:g} seconds:\n{self.stderr}")
        for name in self.checks:
            if name not in self.verdicts:
                self._decide(
                    name, "failed", f"not run: the {self.run_limit:g} seconds were used up"
                )
        self.finished = True

    def _note_hang(self, exercise: str) -> None:
        """Give an exercise up after one hang where what it builds on hangs as well.

        Its other checks would most likely wait for the same loop, each for the whole time limit.
        """
        if self.hung & _needs_of(self.chapter, exercise):
            for name, check in self.checks.items():
                if name not in self.verdicts and check["exercise"] == exercise:
                    self._decide(name, "failed", "not run: another check of it did not end")
        self.hung.add(exercise)


def _pass_on(stream: IO[str], lines: queue.Queue[str]) -> None:
    with contextlib.suppress(ValueError):  # the stream is closed under our hands at the end
        for line in stream:
            lines.put(line)
    lines.put("")


def _kill(process: subprocess.Popen[str]) -> None:
    """Kill a process and, where the system has process groups, all that it has started."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def _environment() -> dict[str, str]:
    """Return the environment of a checking process: ours, with no plugins loaded of themselves."""
    path = os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH", "")]))
    return os.environ | {
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        "PYTHONPATH": path,
        "PYTHONUTF8": "1",
        "PYTEST_ADDOPTS": "",
    }


def _needs_of(chapter: Chapter, exercise: str) -> set[str]:
    """Return the exercises that one builds on, directly or through others."""
    needs = set(chapter.exercise(exercise).needs)
    return needs.union(*(_needs_of(chapter, need) for need in needs))


def with_needs(chapter: Chapter, exercises: list[str] | None) -> list[str]:
    """Return these exercises (all by default) and what they need, in the manifest's order."""
    everything = [exercise.id for exercise in chapter.exercises]
    if exercises is None:
        return everything
    wanted = set(exercises).union(*(_needs_of(chapter, exercise) for exercise in exercises))
    return [exercise for exercise in everything if exercise in wanted]


def _mark_blocked(chapter: Chapter, verdicts: list[Verdict]) -> list[Verdict]:
    """Turn failures of exercises that build on a failing one from failed into blocked.

    Only the physics of an exercise counts: its robust checks block nothing. A check that passes
    all the same keeps its verdict: what works earns its points.
    """
    failing = {v.exercise for v in verdicts if v.status != "passed" and not v.robust}
    marked = []
    for verdict in verdicts:
        needs = [need for need in chapter.exercise(verdict.exercise).needs if need in failing]
        if needs and verdict.status == "failed":
            titles = ", ".join(f"{need} ({chapter.exercise(need).title})" for need in needs)
            verb = "pass" if len(needs) > 1 else "passes"
            message = f"blocked until {titles} {verb}\n{verdict.message}"
            verdict = replace(verdict, status="blocked", message=message)
        marked.append(verdict)
    return marked
