"""Run one of the autograder's commands, as in `python -m autograder check` or `make check`."""

from __future__ import annotations

import argparse
import importlib.util
import re
import sys

from autograder.checks.runner import GraderError
from autograder.commands import command as line_of
from autograder.commands import find_engine, prepare, sentence
from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import (
    Chapter,
    Exercise,
    chapters_below,
    load_chapters,
    refuse_given,
    select_chapters,
    split_given,
)
from autograder.student.check import check


def main() -> int:
    """Parse the command line, run the command, and return its exit status."""
    parser = argparse.ArgumentParser(prog="python -m autograder", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    add_commands(commands)
    students = [*commands.choices]
    if importlib.util.find_spec("autograder.instructor"):  # a handout does not contain it
        from autograder import instructor

        instructor.add_commands(commands)
    arguments = parser.parse_args()
    if not prepare("requirements" if arguments.command in students else "teaching"):
        return 2
    try:
        return int(arguments.run(arguments))
    except (ValueError, OSError, GraderError) as error:
        print(f"{arguments.command}: {sentence(error)}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"\n{arguments.command}: stopped", file=sys.stderr)
        return 130


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Define the command-line options of the student commands, such as check and watch."""
    check_command = commands.add_parser("check", help="check your work")
    check_command.add_argument("--exercise", help="check only this exercise, such as 2.5 or B2.3")
    check_command.add_argument(
        "--only",
        action="store_true",
        help="with --exercise: run only its own checks, not those of the exercises it builds on",
    )
    check_command.set_defaults(run=run_check)
    watch_command = commands.add_parser(
        "watch", help="check your current exercise whenever you save"
    )
    watch_command.set_defaults(run=run_watch)
    debug_command = commands.add_parser("debug", help="stop in your function where a check fails")
    debug_command.set_defaults(run=run_debug)
    python_command = commands.add_parser("python", help="try your engine in an interpreter")
    python_command.set_defaults(run=run_python)
    hint_command = commands.add_parser("hint", help="show hints for an exercise")
    hint_command.add_argument(
        "--count", type=int, default=1, help="how many hints to show (default: 1)"
    )
    hint_command.set_defaults(run=run_hint)
    reset_command = commands.add_parser("reset", help="restore the stub of an exercise")
    reset_command.add_argument(
        "--whole", action="store_true", help="restore the whole file of the exercise"
    )
    reset_command.set_defaults(run=run_reset)

    for command in (debug_command, hint_command, reset_command):
        command.add_argument("exercise", nargs="?", default="", help="the exercise, such as B2.3")
    for command in (check_command, watch_command, python_command):
        command.add_argument(
            "--chapter", default="", help="chapters, such as 2 or 2-4 (default: all)"
        )
    for command in (check_command, watch_command, debug_command, python_command, reset_command):
        command.add_argument(
            "--engine", default="chapters", help="folder that contains your chapters"
        )
    for command in (check_command, watch_command, debug_command):
        command.add_argument(
            "--seed", default="1", help="seed for the random numbers in the checks"
        )
    for command in commands.choices.values():
        command.add_argument("--given", default="", help="chapters to take from the reference")


def run_check(arguments: argparse.Namespace) -> bool:
    """Check the student's code for one exercise or for entire chapters, and print the results.

    Return True if any check fails, so that the program exits with status 1 instead of 0.
    """
    chapters = select_chapters(arguments.chapter)
    exercise = None
    if arguments.exercise:
        chapter, exercise = find_exercise(arguments.exercise, chapters)
        chapters = [chapter]
    elif arguments.only:
        raise ValueError("--only requires --exercise")
    engine = find_engine(arguments.engine)
    given, chapters = split_given(chapters, arguments.given)
    return not check(chapters, exercise, engine, arguments.seed, given, only=arguments.only)


def run_watch(arguments: argparse.Namespace) -> int:
    """Rerun the checks of the student's current exercise each time the student saves a file."""
    from autograder.student.watching.watch import (
        watch,  # imported only here, so that check starts quickly
    )

    engine = find_engine(arguments.engine)
    given, chapters = split_given(select_chapters(arguments.chapter), arguments.given)
    watch(chapters, engine, arguments.seed, given)
    return 0


def run_reset(arguments: argparse.Namespace) -> int:
    """Restore the original stub of one exercise in the student's file.

    The student can then write the exercise again from scratch.
    """
    from autograder.student.reset import question, reset

    chapter, exercise = named_exercise("reset", arguments.exercise)
    refuse_given(chapter, exercise, arguments.given)
    engine = find_engine(arguments.engine)[0]
    if sys.stdin.isatty():
        asked = question(chapter, exercise, engine, whole=arguments.whole)
        if input(f"{asked} (y/n) ").strip().lower() not in ("y", "yes"):
            print("Nothing was changed.")
            return 1
    print(reset(chapter, exercise, engine, whole=arguments.whole))
    return 0


def run_debug(arguments: argparse.Namespace) -> bool:
    """Stop in the student's function at the call with which a check of an exercise fails.

    Return True if a check fails, so that the program exits with status 1 instead of 0.
    """
    from autograder.student.debugging.debug import debug  # imports pytest

    chapter, exercise = named_exercise("debug", arguments.exercise)
    refuse_given(chapter, exercise, arguments.given)
    given, _ = split_given(load_chapters(), arguments.given)
    with with_given(given, find_engine(arguments.engine)) as folders:
        return not debug(chapter, exercise, folders, arguments.seed)


def run_python(arguments: argparse.Namespace) -> int:
    """Start an interpreter with the student's engine: some chapters, and those they build on."""
    from autograder.student.interpreter import interact  # imported only here

    selected = select_chapters(arguments.chapter)
    below = {other.number for chapter in selected for other in chapters_below(chapter)}
    chapters = [other for other in load_chapters() if other in selected or other.number in below]
    given, _ = split_given(load_chapters(), arguments.given)
    with with_given(given, find_engine(arguments.engine)) as folders:
        interact(chapters, folders)
    return 0


def run_hint(arguments: argparse.Namespace) -> int:
    """Print the first few hints for an exercise, and then the command that shows the next one."""
    chapter, exercise = named_exercise("hint", arguments.exercise)
    refuse_given(chapter, exercise, arguments.given)
    shown = exercise.hints[: max(1, arguments.count)]
    print(f"{exercise.id} {exercise.title}")
    for number, text in enumerate(shown, 1):
        print(f"  {number}. {text}")
    if left := len(exercise.hints) - len(shown):
        following = line_of("hint", EX=exercise.id, N=str(len(shown) + 1))
        more = "1 more hint" if left == 1 else f"{left} more hints"
        print(f"  {more}. For the next one: {following}")
    return 0


def named_exercise(what: str, wanted: str) -> tuple[Chapter, Exercise]:
    """Look up the exercise that a command is for, and ask for its number if it is not named.

    Raises:
        ValueError: There is no such exercise, or none is named.
    """
    if not wanted:
        raise ValueError(
            f"Which exercise? Add its number, as in {line_of(what, EX='B2.3')}. To see which "
            f"exercises are open: {line_of('check')}"
        )
    return find_exercise(wanted, load_chapters())


def find_exercise(wanted: str, chapters: list[Chapter]) -> tuple[Chapter, Exercise]:
    """Look up an exercise by its id, such as B2.3, and return it with the chapter that contains it.

    The id may be typed in upper or lower case.

    Raises:
        ValueError: No exercise has that id. The message suggests similar ids if there are any.
    """
    known = {e.id.lower(): (chapter, e) for chapter in chapters for e in chapter.exercises}
    if wanted.lower() in known:
        return known[wanted.lower()]
    bare = re.sub(r"^[a-z]", "", wanted.lower())
    ids = [e.id for _, e in known.values()]
    if alike := [e.id for key, (_, e) in known.items() if key.startswith(wanted.lower())]:
        raise ValueError(f"there is no exercise {wanted!r}. Similar ids: {', '.join(alike)}")
    if same := [name for name in ids if bare and re.sub(r"^[A-Z]", "", name).lower() == bare]:
        raise ValueError(f"there is no exercise {wanted!r}. Did you mean {' or '.join(same)}?")
    raise ValueError(
        f"there is no exercise {wanted!r}. An id looks like {ids[0]} or {ids[-1]}. To list all "
        f"ids: {line_of('check')}"
    )


if __name__ == "__main__":
    sys.exit(main())
