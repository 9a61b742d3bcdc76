"""Guide a student through the exercises: check the current one, then move on to the next."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from autograder.checks.runner import GraderError
from autograder.checks.verdict import asked_for
from autograder.commands import check_command
from autograder.manifest import Chapter, Exercise
from autograder.scores import Result, result_of
from autograder.student.chapter_results import (
    ChapterResults,
    Memory,
    report_on,
    show_progress,
    state_of,
)
from autograder.student.failure import failure_of
from autograder.student.finish import end_of
from autograder.student.screen import STYLES, bar, inherited_notes
from autograder.student.watching.edits import Edits
from autograder.student.watching.page import Page
from autograder.student.written import all_pass

TROUBLE = (GraderError, ValueError, OSError)  # after one of these, watch shows it and goes on


@dataclass
class Guide:
    """Keeps track of a student's current exercise and, once that is done, of the next one."""

    chapters: list[Chapter]
    engine: list[Path]
    folders: list[Path]  # with the given chapters
    given: list[Chapter]
    memory: Memory
    has_keys: bool
    last: dict[str, dict[str, Result]] = field(default_factory=dict)  # by chapter and exercise
    current: tuple[Chapter, Exercise] | None = None
    next: tuple[Chapter, Exercise] | None = None
    edited: list[str] = field(default_factory=list)  # what the last save has changed in it
    page: Page = field(default_factory=Page)
    seen: str = ""

    def __post_init__(self) -> None:
        self.edits = Edits(self.engine[0], self.chapters)

    @property
    def chapter(self) -> Chapter:
        """The current chapter, or the last one if everything is done."""
        return self.current[0] if self.current else self.chapters[-1]

    def look(self) -> bool:
        """Run the checks again if the student has changed a file. Return True if they have run.

        Of several edited exercises, one that does not work yet becomes the current one.
        """
        state = state_of(self.folders, self.chapters[-1])
        if state == self.seen:
            return False
        self.seen = state
        if edited := self.edits.look():
            chapter, exercise, self.edited = min(
                edited, key=lambda e: (self.works(e[0], e[1]), e[:2] != self.current)
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
        self.page.draw(with_keys=self.has_keys)

    def is_done(self, chapter: Chapter, exercise: Exercise) -> bool:
        """Check and show an exercise, or a prerequisite that fails, and return True if it is done.

        Its robust checks count only after all required physics checks of the chapter pass.
        """
        worked = self.works(chapter, exercise)
        report = self.report(chapter, exercise)
        result = next(filter(lacks_physics, report.results), report.results[-1])
        self.current = chapter, result.exercise
        if lacks_physics(result):
            tier = result_of(result.exercise, result.physics)
            self.say_failure(report, tier, "physics checks" if result.robust else "checks")
            return False
        self.report(chapter)
        all_physics = not any(map(lacks_physics, self.required(chapter)))
        if lacks_anything(result) and worked and all_physics:
            self.say_failure(report, result_of(result.exercise, result.robust), "robust checks")
            return False
        self.say_done(result, wait=not all_physics)
        return True

    def report(self, chapter: Chapter, exercise: Exercise | None = None) -> ChapterResults:
        """Check a chapter, or one exercise and its prerequisites, and remember the results."""
        report = report_on(chapter, exercise, self.folders, self.given, self.memory, show_progress)
        last = self.last.setdefault(chapter.name, {})
        last.update({result.exercise.id: result for result in report.results})
        return report

    def works(self, chapter: Chapter, exercise: Exercise) -> bool:
        """Return True if all physics checks of an exercise passed when they last ran."""
        result = self.last.get(chapter.name, {}).get(exercise.id)
        return result is not None and result.works

    def required(self, chapter: Chapter) -> list[Result]:
        """Return the latest results of the exercises that a chapter asks for."""
        wanted = asked_for(chapter)
        return [r for r in self.last[chapter.name].values() if r.exercise.id in wanted]

    def next_open(self) -> tuple[Chapter, Exercise] | None:
        """Find the next exercise to work on. In a chapter, physics comes before robust checks."""
        for chapter in self.chapters:
            self.report(chapter)
            results = [r for r in self.required(chapter) if lacks_anything(r)]
            for result in sorted(results, key=lambda r: r.works):
                return chapter, result.exercise
        return None

    def progress(self, chapter: Chapter) -> str:
        """Describe the progress, as in "3 of 8 exercises work" or "8 of 8 work, 3 complete"."""
        wanted = {e.id for e in chapter.exercises if e.kind != "written" and not e.optional}
        results = [r for r in self.last[chapter.name].values() if r.exercise.id in wanted]
        done, of, what = sum(result.works for result in results), len(wanted), "exercises work"
        if done == of:
            complete = sum(result.status == "passed" for result in results)
            what = "are complete" if complete == of else f"work, {complete} complete"
        return f"Chapter {chapter.number} {bar(done, of)} {done} of {of} {what}"

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
        page.say(self.progress(chapter))

    def say_done(self, result: Result, *, wait: bool) -> None:
        """Tell the student that an exercise works, and how many of its robust checks are left."""
        count = len(result.checks)
        words = f"{result.exercise.id} {result.exercise.title}"
        if left := sum(check.status != "passed" for check in result.robust):
            wait_for = "1 robust check waits" if left == 1 else f"{left} robust checks wait"
            until = "until the end of the chapter" if wait else "for you now"
            words += f" works: all its physics passes. {wait_for} {until}."
        else:
            words += f" is done: {count} of {count} checks pass."
        self.page.top += [(words, "bold green"), ("", "")]

    def find_next(self) -> None:
        """Find the next exercise, and offer it to the student, who accepts by Enter or an edit.

        If there is no current exercise, or there are no keys, the next one begins at once.
        """
        self.next = self.next_open()
        if self.current or self.next is None:
            exercise = self.current[1] if self.current else None
            report = self.report(self.chapter)
            self.page.top += end_of([report], exercise, self.engine, self.given)
        if self.next is None:
            self.current = None
            self.page.say(all_pass(self.chapters, self.engine), "bold green")
        elif self.current and self.has_keys:
            following, exercise = self.next
            if self.works(following, exercise):
                self.page.say("All exercises work. Only robust checks are left.")
            self.page.say(self.progress(following))
            self.page.say(
                f"Press Enter, or edit its code, to go on to {exercise.id} {exercise.title}."
            )
        else:
            self.is_done(*self.next)


def lacks_physics(result: Result) -> bool:
    """Return True if any physics check of an exercise fails. A written exercise has no checks."""
    return result.status != "waiting" and not result.works


def lacks_anything(result: Result) -> bool:
    """Return True if any check of an exercise fails. A written exercise has no checks."""
    return result.status not in ("passed", "waiting")
