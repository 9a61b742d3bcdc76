"""The `watch` command, which checks the student's current exercise after every save.

While the command runs, the student can also press keys, such as h for a hint.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from watchfiles import watch as changes_in

from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import ROOT, Chapter
from autograder.student.memory import Memory
from autograder.student.reset import question, reset
from autograder.student.screen import print_chapter, print_report
from autograder.student.watching import keys
from autograder.student.watching.page import KEYS
from autograder.student.watching.progress import Progress
from autograder.student.watching.session import TROUBLE, Session
from autograder.text.wrapping import plain_console

TICK = 100  # milliseconds until we look again whether a key was pressed


def watch(chapters: list[Chapter], engine: list[Path], seed: str, given: list[Chapter]) -> None:
    """Show the state of the student's current exercise, and check it after every save.

    The current exercise is the one that the student edited last. At the start, it is the first one
    that is still open. The command ends when the student presses q.

    Raises:
        ValueError: The reference solution of a chapter in ``given`` is missing. Handouts do not
            contain the solutions.
    """
    with with_given(given, engine) as folders, keys.single_keys():
        progress = Progress(chapters, folders, given, Memory(seed))
        console = plain_console()
        session = Session(progress, engine, console, has_keys=keys.available())
        board = Keyboard(session)
        if not session.has_keys:
            board.say("There is no terminal, so keys do not work. Press Ctrl-C to stop.")
        # The first check runs after the first tick. After that, no change can be missed.
        for changes in changes_in(engine[0], rust_timeout=TICK, yield_on_timeout=True):
            if (changes or not session.seen) and session.look():
                board.asking = False
            for key in keys.pressed().lower() if session.has_keys else "":
                if key in ("q", keys.END):
                    return
                board.press(key)


class Keyboard:
    """Reacts to the keys that the student presses during `watch`, such as h for a hint."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.hints: dict[str, int] = {}
        self.asking = False  # whether we have asked if the current exercise should be reset

    def press(self, key: str) -> None:
        """Respond to a key that the student has pressed, such as h for a hint.

        Unknown keys are ignored. If `watch` has just asked the student to confirm a reset, the key
        is the answer.
        """
        try:
            if self.asking:
                self.answer(key)
            elif key in "\r\n":
                self.session.go_on()
            elif key == "h":
                self.hint()
            elif key == "r":
                self.ask()
            elif key in "lap":
                {"l": self.list, "a": self.check_all, "p": self.plot}[key]()
                self.say(KEYS, "bold")
        except TROUBLE as error:
            self.note(str(error), "magenta")

    def note(self, words: str, style: str = "") -> None:
        """Show a short message, such as a hint, at the bottom of the `watch` page.

        The message replaces the previous one.
        """
        self.session.page.note = [(line, style) for line in words.splitlines()]
        self.session.draw()

    def say(self, words: str, style: str = "") -> None:
        """Print a message to the student below the `watch` page."""
        self.session.console.print(words, style=style, markup=False, soft_wrap=True)

    def hint(self) -> None:
        """Show the student the next hint for the current exercise.

        If there are no more hints, the last one is shown again.
        """
        if not self.session.current:
            return
        exercise = self.session.current[1]
        of = len(exercise.hints)
        number = self.hints[exercise.id] = min(self.hints.get(exercise.id, 0) + 1, of)
        self.note(f"Hint {number} of {of}: {exercise.hints[number - 1]}")

    def ask(self) -> None:
        """Ask the student whether to replace the code for the current exercise with its stubs."""
        if not self.session.current:
            return
        self.note(f"{question(*self.session.current, self.session.engine[0])} (y or n)", "bold")
        self.asking = True

    def answer(self, key: str) -> None:
        """Reset the current exercise to its stubs if the student has answered y."""
        self.asking = False
        if key != "y" or not self.session.current:
            self.note("Nothing was reset.")
            return
        done = reset(*self.session.current, self.session.engine[0])
        self.session.look()
        self.note(done)

    def list(self) -> None:
        """Print a table with the state of each exercise in the current chapter."""
        session = self.session
        chapter = session.current[0] if session.current else session.progress.chapters[-1]
        print_chapter(session.console, session.progress.report(chapter), session.engine)

    def check_all(self) -> None:
        """Rerun all checks on the student's code, and print what `make check` would print."""
        session, progress = self.session, self.session.progress
        progress.memory.known.clear()
        reports = [progress.report(chapter) for chapter in progress.chapters]
        print_report(session.console, reports, None, session.engine, progress.given)

    def plot(self) -> None:
        """Draw the plots of the current chapter with the student's engine, and save them as files.

        A separate process draws them, without opening a window.
        """
        session = self.session
        chapter = session.current[0] if session.current else session.progress.chapters[-1]
        self.say(f"Drawing chapter {chapter.number} ...")
        command = [sys.executable, "-m", "plots", "draw", "--engine", str(session.engine[0])]
        if given := session.progress.given:
            command += ["--given", ",".join(str(chapter.number) for chapter in given)]
        subprocess.run(
            [*command, "--chapter", str(chapter.number)],
            cwd=ROOT,
            env=os.environ | {"MPLBACKEND": "agg"},
            stdin=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C must not make it print a traceback
            check=False,
        )
