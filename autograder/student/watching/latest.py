"""Keep the latest result of every exercise, which tells what a student should do next."""

from __future__ import annotations

from pathlib import Path

from autograder.checks.verdict import asked_for
from autograder.manifest import Chapter, Exercise
from autograder.scores import Result
from autograder.student.chapter_results import ChapterResults, Memory, ProgressBar, report_on
from autograder.student.points import bar


class LatestResults:
    """Runs the checks for a student, and remembers the latest result of every exercise."""

    def __init__(
        self, chapters: list[Chapter], folders: list[Path], given: list[Chapter], memory: Memory
    ) -> None:
        self.chapters = chapters
        self.folders = folders
        self.given = given
        self.memory = memory
        self.last: dict[tuple[str, str], Result] = {}

    def report(self, chapter: Chapter, exercise: Exercise | None = None) -> ChapterResults:
        """Check a chapter, or one exercise and its prerequisites, and remember the results."""
        with ProgressBar() as progress:
            report = report_on(chapter, exercise, self.folders, self.given, self.memory, progress)
        for result in report.results:
            self.last[chapter.name, result.exercise.id] = result
        return report

    def next_open(self) -> tuple[Chapter, Exercise] | None:
        """Find the exercise to work on next, or return None if all are done.

        In a chapter, exercises that fail physics checks come before those that fail robust ones.
        """
        for chapter in self.chapters:
            wanted = asked_for(chapter)
            results = [r for r in self.report(chapter).results if r.exercise.id in wanted]
            for is_open in (lacks_physics, lacks_anything):
                for result in results:
                    if is_open(result):
                        return chapter, result.exercise
        return None

    def works(self, chapter: Chapter, exercise: Exercise) -> bool:
        """Return True if all physics checks of an exercise passed when they last ran."""
        result = self.last.get((chapter.name, exercise.id))
        return result is not None and result.works

    def has_all_physics(self, chapter: Chapter) -> bool:
        """Return True if all physics checks that the chapter asks for passed when they last ran."""
        wanted = asked_for(chapter)
        return not any(lacks_physics(r) for r in self._results(chapter) if r.exercise.id in wanted)

    def words(self, chapter: Chapter) -> str:
        """Describe the student's progress in a chapter, as in "3 of 8 exercises work".

        Once all exercises work, the robust checks count too, as in "8 of 8 work, 3 complete".
        """
        wanted = {e.id for e in chapter.exercises if e.kind != "written" and not e.optional}
        results = [r for r in self._results(chapter) if r.exercise.id in wanted]
        of = len(wanted)
        done, what = sum(result.works for result in results), "exercises work"
        if done == of:
            complete = sum(result.status == "passed" for result in results)
            what = "are complete" if complete == of else f"work, {complete} complete"
        return f"Chapter {chapter.number} {bar(done, of)} {done} of {of} {what}"

    def _results(self, chapter: Chapter) -> list[Result]:
        return [result for (name, _), result in self.last.items() if name == chapter.name]


def lacks_physics(result: Result) -> bool:
    """Return True if any physics check of an exercise fails. A written exercise has no checks."""
    return result.status != "waiting" and not result.works


def lacks_anything(result: Result) -> bool:
    """Return True if any check of an exercise fails. A written exercise has no checks."""
    return result.status not in ("passed", "waiting")
