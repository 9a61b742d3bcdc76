"""The `watch` command, which checks the current exercise after every save and reacts to keys."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from watchfiles import watch as changes_in

from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import ROOT, Chapter, Exercise
from autograder.student.chapter_results import Memory
from autograder.student.reset import question, reset
from autograder.student.screen import print_chapter, print_report
from autograder.student.watching import keys
from autograder.student.watching.guide import TROUBLE, Guide
from autograder.student.watching.page import KEYS
from autograder.text.wrapping import plain_console

TICK = 100  # milliseconds until we look again whether a key was pressed


def watch(chapters: list[Chapter], engine: list[Path], seed: str, given: list[Chapter]) -> None:
    """Show the state of the student's current exercise after every save, until q is pressed.

    The current exercise is the one that the student edited last, at first the first open one.
    """
    with with_given(given, engine) as folders, keys.single_keys():
        guide = Guide(chapters, engine, folders, given, Memory(seed), keys.available())
        board = Keyboard(guide)
        if not guide.has_keys:
            say("There is no terminal, so keys do not work. Press Ctrl-C to stop.")
        # The first check runs after the first tick. After that, no change can be missed.
        for changes in changes_in(engine[0], rust_timeout=TICK, yield_on_timeout=True):
            if (changes or not guide.seen) and guide.look():
                board.asking = False
            for key in keys.pressed().lower() if guide.has_keys else "":
                if key in ("q", keys.END):
                    return
                board.press(key)


def say(words: str, style: str = "") -> None:
    """Print a message below the page."""
    plain_console().print(words, style=style, soft_wrap=True)


class Keyboard:
    """Reacts to the keys that the student presses during `watch`, such as h for a hint."""

    def __init__(self, guide: Guide) -> None:
        self.guide = guide
        self.hints: dict[str, int] = {}
        self.asking = False  # whether we have asked if the current exercise should be reset

    def press(self, key: str) -> None:
        """Respond to a key. After the question whether to reset, it is the answer."""
        guide, current = self.guide, self.guide.current
        asked, self.asking = self.asking, False
        try:
            if asked and key == "y" and current:
                done = reset(*current, guide.engine[0])
                guide.look()
                self.note(done)
            elif asked:
                self.note("Nothing was reset.")
            elif key in "\r\n":
                guide.go_on()
            elif key == "h" and current:
                self.hint(current[1])
            elif key == "r" and current:
                self.note(f"{question(*current, guide.engine[0])} (y or n)", "bold")
                self.asking = True
            elif key in "lap":
                {"l": self.list, "a": self.check_all, "p": self.plot}[key]()
                say(KEYS, "bold")
        except TROUBLE as error:
            self.note(str(error), "magenta")

    def note(self, words: str, style: str = "") -> None:
        """Show a short message at the bottom of the page, in place of the previous one."""
        self.guide.page.note = [(line, style) for line in words.splitlines()]
        self.guide.page.draw(with_keys=self.guide.has_keys)

    def hint(self, exercise: Exercise) -> None:
        """Show the next hint for the current exercise, or the last one again."""
        of = len(exercise.hints)
        number = self.hints[exercise.id] = min(self.hints.get(exercise.id, 0) + 1, of)
        self.note(f"Hint {number} of {of}: {exercise.hints[number - 1]}")

    def list(self) -> None:
        """Print a table with the state of each exercise in the current chapter."""
        print_chapter(self.guide.report(self.guide.chapter), self.guide.engine)

    def check_all(self) -> None:
        """Rerun all checks on the student's code, and print what `make check` would print."""
        guide = self.guide
        guide.memory.known.clear()
        reports = [guide.report(chapter) for chapter in guide.chapters]
        print_report(reports, None, guide.engine, guide.given)

    def plot(self) -> None:
        """Draw the plots of the current chapter in another process, without opening a window."""
        number = str(self.guide.chapter.number)
        say(f"Drawing chapter {number} ...")
        command = [sys.executable, "-m", "plots", "draw", "--engine", str(self.guide.engine[0])]
        if given := self.guide.given:
            command += ["--given", ",".join(str(chapter.number) for chapter in given)]
        subprocess.run(
            [*command, "--chapter", number],
            cwd=ROOT,
            env=os.environ | {"MPLBACKEND": "agg"},
            stdin=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C must not make it print a traceback
            check=False,
        )
