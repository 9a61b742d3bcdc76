"""Guide a student through the exercises: check the current one, then move on to the next.

The `watch` command uses this module after every save.
"""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from autograder.checks.runner import GraderError
from autograder.commands import check_command
from autograder.manifest import Chapter, Exercise
from autograder.scores import Result, result_of
from autograder.student.checked import Report
from autograder.student.failure import failure_of
from autograder.student.finish import end_of
from autograder.student.memory import state_of
from autograder.student.screen import STYLES, inherited_notes
from autograder.student.watching.edits import Edits
from autograder.student.watching.page import Page
from autograder.student.watching.progress import Progress, lacks_anything, lacks_physics
from autograder.student.written import all_pass

TROUBLE = (GraderError, ValueError, OSError)  # after one of these, watch shows it and goes on


class Session:
    """Keeps track of the student's current exercise while the `watch` command is running.

    Once that exercise is done, the session also remembers which one comes next.
    """

    def __init__(
        self, progress: Progress, engine: list[Path], console: Console, *, has_keys: bool
    ) -> None:
        self.progress = progress
        self.engine = engine
        self.console = console
        self.has_keys = has_keys
        self.current: tuple[Chapter, Exercise] | None = None
        self.next: tuple[Chapter, Exercise] | None = None
        self.edits = Edits(engine[0], progress.chapters)
        self.edited: list[str] = []  # which functions of this exercise the last save has changed
        self.page = Page()
        self.seen = ""

    def look(self) -> bool:
        """Run the checks again if the student has changed a file.

        Return True if the checks have run.
        """
        state = state_of(self.progress.folders, self.progress.chapters[-1])
        if state == self.seen:
            return False
        self.seen = state
        self.choose()
        self.show()
        return True

    def choose(self) -> None:
        """Switch to the exercise that the student has just edited.

        If the student has edited several exercises at once, prefer one that does not work yet.
        """
        edited = self.edits.look()
        if edited:
            chapter, exercise, names = min(
                edited,
                key=lambda one: (
                    self.progress.works(one[0], one[1]),
                    (one[0], one[1]) != self.current,
                ),
            )
            self.current, self.edited = (chapter, exercise), names

    def go_on(self) -> None:
        """Move on to the next exercise, because the student has pressed Enter.

        If `watch` has not offered a next exercise, nothing happens.
        """
        if self.next:
            self.current, self.edited = self.next, []
            self.show()

    def show(self) -> None:
        """Check the exercise that the student is working on, and show whether it works.

        If the exercise is done, or the student has not begun one, find the next one.
        """
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
        """Check and show the student's current exercise, and return True if it is done.

        At first, an exercise is done as soon as its physics checks pass. Its robust checks count
        only after all required physics checks of the chapter pass. If the physics checks of a
        prerequisite no longer pass, the prerequisite becomes the current exercise.
        """
        worked = self.progress.works(chapter, exercise)
        report = self.progress.report(chapter, exercise)
        result = next(filter(lacks_physics, report.results), report.results[-1])
        self.current = chapter, result.exercise
        if lacks_physics(result):
            tier = result_of(result.exercise, result.physics)
            self.say_failure(report, tier, "physics checks" if result.robust else "checks")
            return False
        self.progress.report(chapter)
        all_physics = self.progress.has_all_physics(chapter)
        if lacks_anything(result) and worked and all_physics:
            tier = result_of(result.exercise, result.robust)
            self.say_failure(report, tier, "robust checks")
            return False
        self.say_done(result, wait=not all_physics)
        return True

    def say_failure(self, report: Report, tier: Result, kind: str) -> None:
        """Show a failed check of an exercise, and how many of the exercise's checks pass.

        ``tier`` contains the results of either the physics checks or the robust checks. ``kind`` is
        the name of these checks in the heading, such as "robust checks".
        """
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
        page.say(self.progress.words(chapter))

    def say_done(self, result: Result, *, wait: bool) -> None:
        """Tell the student that an exercise works, and how many of its robust checks are left."""
        exercise, count = result.exercise, len(result.checks)
        title = f"{exercise.id} {exercise.title}"
        left = sum(check.status != "passed" for check in result.robust)
        if not left:
            words = f"{title} is done: {count} of {count} checks pass."
        else:
            checks = "1 robust check" if left == 1 else f"{left} robust checks"
            verb = "waits" if left == 1 else "wait"
            until = f"{verb} until the end of the chapter" if wait else f"{verb} for you now"
            count = len(result.physics)
            passing = (
                f"all {count} physics checks pass" if count > 1 else "its physics check passes"
            )
            words = f"{title} works: {passing}. {checks} {until}."
        self.page.top += [(words, "bold green"), ("", "")]

    def find_next(self) -> None:
        """Find the next exercise that is not done yet, and offer it to the student.

        The student accepts by pressing Enter or by editing the code for that exercise. If there is
        no current exercise, as when `watch` starts, the next one begins at once. The same happens
        if single keys cannot be read, because Enter would not work.
        """
        self.next = self.progress.next_open()
        if self.current or self.next is None:
            self.say_end()
        if self.next is None:
            self.current = None
            self.page.say(all_pass(self.progress.chapters, self.engine), "bold green")
        elif self.current and self.has_keys:
            following, exercise = self.next
            if self.progress.works(following, exercise):
                words = "All exercises work. Only robust checks are left."
                self.page.say(words)
            self.page.say(self.progress.words(following))
            self.page.say(
                f"Press Enter, or edit its code, to go on to {exercise.id} {exercise.title}."
            )
        else:
            self.is_done(*self.next)

    def say_end(self) -> None:
        """Add a finished chapter's closing screen, or a list of scenes to play, to the page."""
        chapter, exercise = self.current or (self.progress.chapters[-1], None)
        report = self.progress.report(chapter)
        self.page.top += end_of([report], exercise, self.engine, self.progress.given)
