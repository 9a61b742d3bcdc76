"""Guide a student through the exercises: check the current one, then move on to the next."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from autograder.checks.runner import GraderError
from autograder.commands import check_command
from autograder.manifest import Chapter, Exercise
from autograder.scores import Result, result_of
from autograder.student.chapter_results import ChapterResults, state_of
from autograder.student.failure import failure_of
from autograder.student.finish import end_of
from autograder.student.screen import STYLES, inherited_notes
from autograder.student.watching.edits import Edits
from autograder.student.watching.latest import LatestResults, lacks_anything, lacks_physics
from autograder.student.watching.page import Page
from autograder.student.written import all_pass

TROUBLE = (GraderError, ValueError, OSError)  # after one of these, watch shows it and goes on


class Guide:
    """Keeps track of a student's current exercise and, once that is done, of the next one."""

    def __init__(
        self, latest: LatestResults, engine: list[Path], console: Console, *, has_keys: bool
    ) -> None:
        self.latest = latest
        self.engine = engine
        self.console = console
        self.has_keys = has_keys
        self.current: tuple[Chapter, Exercise] | None = None
        self.next: tuple[Chapter, Exercise] | None = None
        self.edits = Edits(engine[0], latest.chapters)
        self.edited: list[str] = []  # which functions of this exercise the last save has changed
        self.page = Page()
        self.seen = ""

    @property
    def chapter(self) -> Chapter:
        """The current chapter, or the last one if everything is done."""
        return self.current[0] if self.current else self.latest.chapters[-1]

    def look(self) -> bool:
        """Run the checks again if the student has changed a file. Return True if they have run.

        The exercise that the student has edited becomes the current one. Of several, it is
        preferably one that does not work yet.
        """
        state = state_of(self.latest.folders, self.latest.chapters[-1])
        if state == self.seen:
            return False
        self.seen = state
        if edited := self.edits.look():
            chapter, exercise, self.edited = min(
                edited, key=lambda e: (self.latest.works(e[0], e[1]), e[:2] != self.current)
            )
            self.current = chapter, exercise
        self.show()
        return True

    def go_on(self) -> None:
        """Move on to the next exercise if there is one, because the student has pressed Enter."""
        if self.next:
            self.current, self.edited = self.next, []
            self.show()

    def show(self) -> None:
        """Check and show the current exercise. If it is done, find the next one."""
        self.next = None
        self.page = Page()
        try:
            if self.current is None or self.is_done(*self.current):
                self.find_next()
        except TROUBLE as error:
            self.page.say(str(error), "magenta")
        self.draw()

    def draw(self) -> None:
        self.page.draw(self.console, with_keys=self.has_keys)

    def is_done(self, chapter: Chapter, exercise: Exercise) -> bool:
        """Check and show the current exercise, and return True if it is done.

        At first, an exercise is done as soon as its physics checks pass. Its robust checks count
        only after all required physics checks of the chapter pass. If the physics checks of a
        prerequisite no longer pass, the prerequisite becomes the current exercise.
        """
        worked = self.latest.works(chapter, exercise)
        report = self.latest.report(chapter, exercise)
        result = next(filter(lacks_physics, report.results), report.results[-1])
        self.current = chapter, result.exercise
        if lacks_physics(result):
            tier = result_of(result.exercise, result.physics)
            self.say_failure(report, tier, "physics checks" if result.robust else "checks")
            return False
        self.latest.report(chapter)
        all_physics = self.latest.has_all_physics(chapter)
        if lacks_anything(result) and worked and all_physics:
            self.say_failure(report, result_of(result.exercise, result.robust), "robust checks")
            return False
        self.say_done(result, wait=not all_physics)
        return True

    def say_failure(self, report: ChapterResults, tier: Result, kind: str) -> None:
        """Show a failed check, and how many checks of its kind, such as robust checks, pass."""
        chapter, exercise, page = report.chapter, tier.exercise, self.page
        for note in inherited_notes(report, exercise, self.engine):
            page.top += [(note, STYLES["inherited"]), ("", "")]
        passed = sum(check.status == "passed" for check in tier.checks)
        title = f"Current exercise ({passed} of {len(tier.checks)} {kind} pass)"
        page.failure = failure_of(chapter, tier, self.engine, title, self.edited)
        if page.failure is None:
            page.top.append((f"No check was found for exercise {exercise.id}.", "magenta"))
        else:
            page.top.append((page.failure.heading, "bold"))
        page.whole = check_command(self.engine, EX=exercise.id)
        page.say(self.latest.words(chapter))

    def say_done(self, result: Result, *, wait: bool) -> None:
        """Tell the student that an exercise works, and how many of its robust checks are left."""
        count, physics = len(result.checks), len(result.physics)
        words = f"{result.exercise.id} {result.exercise.title}"
        if left := sum(check.status != "passed" for check in result.robust):
            checks, s = ("1 robust check", "s") if left == 1 else (f"{left} robust checks", "")
            until = "until the end of the chapter" if wait else "for you now"
            passing = f"all {physics} physics checks pass"
            passing = passing if physics > 1 else "its physics check passes"
            words += f" works: {passing}. {checks} wait{s} {until}."
        else:
            words += f" is done: {count} of {count} checks pass."
        self.page.top += [(words, "bold green"), ("", "")]

    def find_next(self) -> None:
        """Find the next exercise that is not done yet, and offer it to the student.

        The student accepts by pressing Enter or by editing its code. If there is no current
        exercise, as when `watch` starts, or there are no keys, the next one begins at once.
        """
        self.next = self.latest.next_open()
        if self.current or self.next is None:
            exercise = self.current[1] if self.current else None
            report = self.latest.report(self.chapter)
            self.page.top += end_of([report], exercise, self.engine, self.latest.given)
        if self.next is None:
            self.current = None
            self.page.say(all_pass(self.latest.chapters, self.engine), "bold green")
        elif self.current and self.has_keys:
            following, exercise = self.next
            if self.latest.works(following, exercise):
                self.page.say("All exercises work. Only robust checks are left.")
            self.page.say(self.latest.words(following))
            self.page.say(
                f"Press Enter, or edit its code, to go on to {exercise.id} {exercise.title}."
            )
        else:
            self.is_done(*self.next)
