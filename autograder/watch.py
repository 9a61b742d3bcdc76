"""Check the current exercise whenever a file is saved: the first that does not pass.

What passes is found by running the checks, and remembered for as long as the files stay as they
are; nothing about it is read from a file.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from rich.console import Console
from watchfiles import watch as changes_in

from autograder import keys
from autograder.check import report_on
from autograder.given import with_given
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.reset import reset
from autograder.runner import GraderError, Verdict, run_checks, with_needs
from autograder.scores import Result
from autograder.screen import (
    ProgressBar,
    Report,
    bar,
    print_chapter,
    print_failure,
    print_inherited,
    print_report,
)

KEYS = "h next hint   l list   a check all   r reset   p plot   q quit"
TICK = 100  # milliseconds between two looks for keys
TROUBLE = (GraderError, ValueError, OSError)  # of one run: told, and the next may be better


def watch(chapters: list[Chapter], engine: list[Path], seed: str, given: list[Chapter]) -> None:
    """Show how the current exercise does, at once and after every save, until q is pressed.

    It is the first of these chapters that does not pass. Raises ValueError where a given chapter
    is not at hand.
    """
    with with_given(given, engine) as folders, keys.single_keys():
        session = Session(chapters, engine, given, folders, Memory(seed))
        # The first look comes after the first tick, from which on no change is missed.
        for changes in changes_in(engine[0], rust_timeout=TICK, yield_on_timeout=True):
            if changes or not session.seen:
                session.look()
            for key in keys.pressed().lower() if session.has_keys else "":
                if key in ("q", keys.END):
                    return
                session.press(key)


class Memory:
    """Runs checks, but for those that it has run on the same files."""

    def __init__(self, seed: str) -> None:
        self.seed = seed
        self.known: dict[tuple[str, ...], list[Verdict]] = {}

    def __call__(
        self,
        chapter: Chapter,
        engine: list[Path],
        *,
        exercises: list[str] | None = None,
        on_verdict: Callable[[int, int], None] | None = None,
    ) -> list[Verdict]:
        """Return the verdicts as run_checks does."""
        wanted = with_needs(chapter, exercises)
        state = state_of(engine, chapter)
        for ids in (with_needs(chapter, None), wanted):
            if known := self.known.get((state, *ids)):
                return [verdict for verdict in known if verdict.exercise in wanted]
        verdicts = run_checks(
            chapter, engine, seed=self.seed, exercises=wanted, on_verdict=on_verdict
        )
        if state_of(engine, chapter) == state:  # else nobody knows which of them was checked
            self.known[(state, *wanted)] = verdicts
        return verdicts


def state_of(engine: list[Path], chapter: Chapter) -> str:
    """Return a hash of the files that the checks of a chapter may depend on."""
    state = hashlib.sha256()
    for number, folder in enumerate(engine):
        for file in sorted(folder.glob("ch??_*/*.*")):
            name = file.parent.name
            if name <= chapter.name and file.suffix in (".py", ".csv", ".md"):
                try:
                    content = hashlib.sha256(file.read_bytes()).hexdigest()
                except OSError:  # it goes while we look, or is an editor's dangling link
                    continue
                state.update(f"{number} {name}/{file.name} {content}\n".encode())
    return f"{chapter.name} {state.hexdigest()}"


class Session:
    """What is on the screen: the current exercise, what is known of the others, hints shown."""

    def __init__(
        self,
        chapters: list[Chapter],
        engine: list[Path],
        given: list[Chapter],
        folders: list[Path],
        memory: Memory,
    ) -> None:
        self.chapters = chapters
        self.engine = engine
        self.given = given
        self.folders = folders
        self.memory = memory
        self.console = Console(highlight=False)
        self.current: tuple[Chapter, Exercise] | None = None
        self.next: tuple[Chapter, Exercise] | None = None
        self.passing: dict[str, set[str]] = {chapter.name: set() for chapter in chapters}
        self.hints: dict[str, int] = {}
        self.seen = ""
        self.has_keys = keys.are_there()
        if not self.has_keys:
            self.say("There is no terminal here, so there are no keys; Ctrl-C ends this.")

    def look(self) -> None:
        """Show the current exercise anew where the files are not as they were."""
        state = state_of(self.folders, self.chapters[-1])
        if state != self.seen:
            self.seen = state
            self.show()

    def show(self) -> None:
        """Check the current exercise and say how it does; find one where there is none."""
        if self.has_keys:
            self.console.clear()
        self.next = None
        try:
            if self.current is None or self.show_current(*self.current):
                self.find_next()
        except TROUBLE as error:
            self.say(str(error), "magenta")
        if self.has_keys:
            self.say(KEYS, "bold")

    def show_current(self, chapter: Chapter, exercise: Exercise) -> bool:
        """Check an exercise, with what it needs, and say how it does; return whether it passes.

        Where something that it needs no longer passes, that is the current exercise.
        """
        report = self.report(chapter, exercise)
        first = next((result for result in report.results if is_open(result)), report.results[-1])
        exercise = first.exercise
        self.current = chapter, exercise
        passed = sum(check.status == "passed" for check in first.checks)
        count = f"{passed} of {len(first.checks)} checks pass"
        if not is_open(first):
            self.say(f"{exercise.id} {exercise.title} is done: {count}.\n", "bold green")
            return True
        print_inherited(self.console, report, exercise, self.engine)
        title = f"Current exercise ({count})"
        print_failure(self.console, chapter, first, self.engine, title)
        self.say_progress(chapter)
        return False

    def find_next(self) -> None:
        """Find the next open exercise and say how to get to it; at the start, go to it."""
        self.next = self.first_open()
        if self.next is None:
            self.current = None
            self.say("Everything that can be checked passes.", "bold green")
        elif self.current and self.has_keys:
            self.say_progress(self.next[0])
            self.say(f"Enter goes on to {self.next[1].id} {self.next[1].title}.")
        else:
            self.show_current(*self.next)

    def first_open(self) -> tuple[Chapter, Exercise] | None:
        """Return the first exercise that does not pass, in the manifests' order."""
        for chapter in self.chapters:
            for result in self.report(chapter).results:
                if is_open(result):
                    return chapter, result.exercise
        return None

    def report(self, chapter: Chapter, exercise: Exercise | None = None) -> Report:
        """Check a chapter, or an exercise with what it needs, and take note of what passes."""
        with ProgressBar() as progress:
            report = report_on(chapter, exercise, self.folders, self.given, self.memory, progress)
        for result in report.results:
            self.passing[chapter.name].discard(result.exercise.id)
            if result.status == "passed":
                self.passing[chapter.name].add(result.exercise.id)
        return report

    def press(self, key: str) -> None:
        """Do what a key asks for; other keys do nothing."""
        chapter, exercise = self.current or (self.chapters[-1], None)
        try:
            if key in "\r\n" and self.next:
                self.current = self.next
                self.show()
            elif key == "h" and exercise:
                self.hint(exercise)
            elif key == "l":
                print_chapter(self.console, self.report(chapter), self.engine)
            elif key == "a":
                self.memory.known.clear()
                reports = [self.report(chapter) for chapter in self.chapters]
                print_report(self.console, reports, None, self.engine, self.given)
            elif key == "r" and exercise:
                done = reset(chapter, exercise, self.engine[0])
                self.look()
                self.say(f"\n{done}")
            elif key == "p":
                self.plot(chapter)
        except TROUBLE as error:
            self.say(str(error), "magenta")

    def hint(self, exercise: Exercise) -> None:
        """Show the next hint of the exercise, and at the end the last one again."""
        of = len(exercise.hints)
        number = self.hints[exercise.id] = min(self.hints.get(exercise.id, 0) + 1, of)
        self.say(f"Hint {number} of {of}: {exercise.hints[number - 1]}")

    def plot(self, chapter: Chapter) -> None:
        """Draw a chapter into files, in a process of its own that opens no window."""
        self.say(f"Drawing chapter {chapter.number} ...")
        command = [sys.executable, "-m", "studies", "plot", "--engine", str(self.engine[0])]
        if self.given:
            command += ["--given", ",".join(str(chapter.number) for chapter in self.given)]
        subprocess.run(
            [*command, "--chapter", str(chapter.number)],
            cwd=ROOT,
            env=os.environ | {"MPLBACKEND": "agg"},
            stdin=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C is for us alone, and ends it without its stack
            check=False,
        )

    def say_progress(self, chapter: Chapter) -> None:
        """Show how many exercises of a chapter passed when they were last checked."""
        passed = len(self.passing[chapter.name])
        of = sum(exercise.kind != "written" for exercise in chapter.exercises)
        self.say(f"\nChapter {chapter.number} {bar(passed, of)} {passed} of {of} exercises pass")

    def say(self, words: str, style: str = "") -> None:
        """Print words as they are."""
        self.console.print(words, style=style, markup=False, soft_wrap=True)


def is_open(result: Result) -> bool:
    """Say whether there is still work on an exercise that a check can tell."""
    return result.status not in ("passed", "waiting")
