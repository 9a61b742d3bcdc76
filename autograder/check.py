"""What a student sees: every exercise with its state, the first failure in full, the next step."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import TYPE_CHECKING

from autograder.answers import answered
from autograder.definitions import functions, own_name
from autograder.given import chapters_below, mark_inherited, suspects
from autograder.manifest import Chapter, Exercise
from autograder.runner import Verdict, run_checks, with_needs
from autograder.scores import Result, results_of, shown, total, without_inherited

if TYPE_CHECKING:
    from rich.console import Console

STYLES = {
    "passed": "green",
    "failed": "red",
    "blocked": "yellow",
    "inherited": "cyan",
    "error": "magenta",
}
URGENCY = {"blocked": 1, "inherited": 2}  # what is shown last: another failure is behind it
UNWRITTEN = "not written yet"
BAR = 40
OPERATORS = {  # as the calls of checks have them
    "__neg__": "; -v",
    "__mul__": " * ",
    "__imul__": " *= ",
    "__truediv__": " / ",
    "__itruediv__": " /= ",
    "__add__": " + ",
    "__iadd__": " += ",
    "__sub__": " - ",
    "__isub__": " -= ",
    "__matmul__": " @ ",
}


def check(
    chapters: list[Chapter], exercise: Exercise | None, engine: list[Path], seed: str
) -> bool:
    """Check the chapters, or one exercise and what it needs; print it all; return success.

    A check that an earlier chapter fails, and not this one, is shown as inherited.
    """
    results: dict[str, list[Result]] = {}
    doubtful: dict[str, list[Chapter]] = {}
    with _Progress() as progress:
        for chapter in chapters:
            progress.title = f"chapter {chapter.number}"
            wanted = with_needs(chapter, [exercise.id] if exercise else None)
            verdicts = run_checks(
                chapter, engine, seed=seed, exercises=wanted, on_verdict=progress.show
            )
            verdicts = mark_inherited(chapter, verdicts, engine, seed)
            doubtful[chapter.name] = suspects(chapter, verdicts, engine, seed)
            results[chapter.name] = [
                result for result in results_of(chapter, verdicts) if result.exercise.id in wanted
            ]
    console = progress.console
    for chapter in chapters:
        _print_chapter(console, chapter, results[chapter.name], engine)
        for other in doubtful[chapter.name]:
            console.print(
                f"Chapter {other.number} fails checks of its own, which may be the reason for some "
                f"failures here: make check CH={other.number}\n",
                style=STYLES["inherited"],
                soft_wrap=True,
            )
    everything = [(chapter, result) for chapter in chapters for result in results[chapter.name]]
    open_ones = [pair for pair in everything if pair[1].status not in ("passed", "waiting")]
    if not open_ones:
        console.print("Everything that can be checked passes.", style="bold green")
        return True
    first = min(open_ones, key=lambda pair: URGENCY.get(pair[1].status, 0))
    _print_failure(console, *first, engine)
    return False


def find_definition(engine: list[Path], chapter: Chapter, name: str) -> str:
    """Return the place of a name that the manifest lets students edit, as path:line.

    Paths below the working folder are given from there; a file that is missing or cannot be read
    is given without a line.
    """
    module, _, path = name.partition(".")
    file = _file(engine, chapter.name, f"{module}.py")
    try:
        tree = ast.parse(file.read_text(encoding="utf-8"))
    except (OSError, SyntaxError, ValueError):
        return str(file)
    places = {node.name: node.lineno for node in tree.body if isinstance(node, ast.ClassDef)}
    places |= {name: node.lineno for name, node in functions(tree).items()}
    return f"{file}:{places.get(path) or places.get(path.partition('.')[0], 1)}"


class _Progress:
    """A bar on a terminal while the checks run, silent elsewhere.

    rich is loaded when the first news comes: by then the checks run in their own process, so
    nobody waits for it.
    """

    title = ""
    _bar = None

    def __enter__(self) -> _Progress:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.stop()

    @property
    def console(self) -> Console:
        from rich.console import Console

        return Console(highlight=False)

    def show(self, done: int, of: int) -> None:
        from rich.progress import Progress

        if self._bar is None:
            self._bar = Progress(console=self.console, transient=True)
            self._task = self._bar.add_task(self.title)
            self._bar.start()
        self._bar.update(self._task, description=self.title, completed=done, total=of)


def _print_chapter(
    console: Console, chapter: Chapter, results: list[Result], engine: list[Path]
) -> None:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    console.print(f"\nChapter {chapter.number}: {chapter.title}", style="bold")
    table = Table("", "exercise", "stars", "state", box=SIMPLE_HEAD, pad_edge=False)
    table.add_column("checks", justify="right")
    table.add_column("points", justify="right")
    written = _answered(chapter, engine)
    for result in results:
        exercise = result.exercise
        state = _state(result, written)
        passed = sum(check.status == "passed" for check in result.checks)
        table.add_row(
            exercise.id,
            exercise.title,
            "*" * exercise.stars,
            state,
            f"{passed}/{len(result.checks)}" if result.checks else "",
            f"{shown(result.score)}/{exercise.points}",
            style=STYLES.get(state, ""),
        )
    console.print(table)
    earned, points = total(results)
    filled = int(BAR * (earned or 0.0) / points) if points else 0
    bar = "#" * filled + "." * (BAR - filled)
    answers = sum(result.exercise.points for result in results) - points
    more = f", and {answers} for written answers, which a person marks" if answers else ""
    console.print(f"[{bar}] {shown(earned)} of {points} points{more}\n", markup=False)
    _print_inherited(console, chapter, results)


def _print_inherited(console: Console, chapter: Chapter, results: list[Result]) -> None:
    """Say how many checks an earlier chapter fails, and the two ways to go on."""
    lost = sum(check.status == "inherited" for result in results for check in result.checks)
    if not lost:
        return
    below = _below(chapter)
    checks = f"{lost} check fails" if lost == 1 else f"{lost} checks fail"
    console.print(
        f"{checks} here for what is wrong in chapter {below}. On the reference's chapter {below} "
        f"this chapter has {shown(without_inherited(results))} points.\n"
        f"Mend it:     make check CH={below}\n"
        f"Or go on:    make check CH={chapter.number} GIVEN={below}\n",
        style=STYLES["inherited"],
        soft_wrap=True,
    )


def _below(chapter: Chapter) -> str:
    """Return the chapters below one as a text, such as 2 or 2-5."""
    numbers = [other.number for other in chapters_below(chapter)]
    return str(numbers[0]) if len(numbers) == 1 else f"{numbers[0]}-{numbers[-1]}"


def _state(result: Result, written: set[str]) -> str:
    if result.status == "waiting":
        return "answered" if result.exercise.id in written else "to answer"
    if result.status == "inherited":
        return result.status
    lost = [check for check in result.checks if check.status != "passed"]
    if not lost or any(UNWRITTEN not in check.message for check in lost):
        return result.status
    return UNWRITTEN if len(lost) == len(result.checks) else "half written"


def _answered(chapter: Chapter, engine: list[Path]) -> set[str]:
    for folder in engine:
        file = folder / chapter.name / "answers.md"
        if file.exists():
            return answered(file.read_text(encoding="utf-8", errors="replace"))
    return set()


def _print_failure(console: Console, chapter: Chapter, result: Result, engine: list[Path]) -> None:
    """Print one failed check in full, and what to do next."""
    exercise = result.exercise
    failed = next((check for check in result.checks if check.status == result.status), None)
    if failed is None:
        console.print(f"No check was found for exercise {exercise.id}.", style="magenta")
        return
    inherited = failed.status == "inherited"
    heading = "Inherited, for example" if inherited else "First to repair"
    console.print(f"{heading}: {exercise.id} {exercise.title}", style="bold")
    console.print(f"check     {failed.name}\n{failed.message}\n", markup=False, soft_wrap=True)
    if inherited:
        console.print(f"Next: make check CH={_below(chapter)}", style="bold")
        return
    place = next_place(engine, chapter, exercise, failed)
    console.print(f"Next: open {place}", style="bold", markup=False, soft_wrap=True)
    unwritten = re.search(rf"{UNWRITTEN}: Exercise (B?\d+\.\w+)", failed.message)
    console.print(f"A nudge: make hint EX={unwritten[1] if unwritten else exercise.id}")


def next_place(engine: list[Path], chapter: Chapter, exercise: Exercise, failed: Verdict) -> str:
    """Return where to go: the line that the message names, or the body that the check called."""
    told = re.search(r"(?m)^where +(ch\d\d_\w+)/(\w+\.py), line (\d+)", failed.message)
    called = re.search(r"(?m)^called +(.*)", failed.message)
    if told and not called:  # not written yet, not readable, not ending
        return f"{_file(engine, told[1], told[2])}:{told[3]}"
    bodies = [name for name in exercise.edit if called and _calls(called[1], name)]
    return find_definition(engine, chapter, (bodies or exercise.edit)[0])


def _calls(expression: str, name: str) -> bool:
    """Say whether the expression of a check calls the body of this name."""
    short = own_name(name)
    pattern = rf"\b{short}\(|\.{short}\b(?! =)"  # a function, a method or a property
    if short in OPERATORS:
        pattern = re.escape(OPERATORS[short])
    elif short.endswith(".setter"):
        attribute = short.removesuffix(".setter")
        pattern = rf"\.{attribute} = |\b{attribute}="
    return re.search(pattern, expression) is not None


def _file(engine: list[Path], chapter: str, name: str) -> Path:
    """Return the engine's file of that name, from the working folder where it is below it."""
    files = [folder / chapter / name for folder in engine]
    file = next((file for file in files if file.exists()), files[0])
    return file.relative_to(Path.cwd()) if file.is_relative_to(Path.cwd()) else file
