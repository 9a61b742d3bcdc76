"""Run one of the autograder's commands, as in `python -m autograder check` or `make check`.

Each command imports what it needs when it runs, so that check starts quickly.
"""

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
    select_chapters,
    split_given,
)
from autograder.options import add_commands, read_table
from autograder.student.screen import check


def main() -> int:
    """Parse the command line, run the command, and return its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m autograder", description=(__doc__ or "").partition("\n")[0]
    )
    commands = parser.add_subparsers(dest="command", required=True)
    add_commands(commands, "commands", sys.modules[__name__])
    if importlib.util.find_spec("autograder.instructor"):  # a handout does not contain it
        from autograder import instructor

        add_commands(commands, "instructor", instructor)
    arguments = parser.parse_args()
    is_students = arguments.command in read_table("commands")
    if not prepare("requirements" if is_students else "teaching"):
        return 2
    try:
        return int(arguments.run(arguments))
    except (ValueError, OSError, GraderError) as error:
        print(f"{arguments.command}: {sentence(error)}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"\n{arguments.command}: stopped", file=sys.stderr)
        return 130


def run_check(arguments: argparse.Namespace) -> bool:
    """Check one exercise or entire chapters, and return True if any check fails (status 1)."""
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
    """Check the student's current exercise each time the student saves a file."""
    from autograder.student.watching.watch import watch

    engine = find_engine(arguments.engine)
    given, chapters = split_given(select_chapters(arguments.chapter), arguments.given)
    watch(chapters, engine, arguments.seed, given)
    return 0


def run_reset(arguments: argparse.Namespace) -> int:
    """Restore the original stub of one exercise in the student's file."""
    from autograder.student.reset import question, reset

    chapter, exercise = named_exercise("reset", arguments)
    engine = find_engine(arguments.engine)[0]
    if sys.stdin.isatty():
        asked = question(chapter, exercise, engine, whole=arguments.whole)
        if input(f"{asked} (y/n) ").strip().lower() not in ("y", "yes"):
            print("Nothing was changed.")
            return 1
    print(reset(chapter, exercise, engine, whole=arguments.whole))
    return 0


def run_debug(arguments: argparse.Namespace) -> bool:
    """Stop in the function of an exercise that fails, and return True if a check fails."""
    from autograder.student.debug import debug

    chapter, exercise = named_exercise("debug", arguments)
    given, _ = split_given(load_chapters(), arguments.given)
    with with_given(given, find_engine(arguments.engine)) as folders:
        return not debug(chapter, exercise, folders, arguments.seed)


def run_python(arguments: argparse.Namespace) -> int:
    """Start an interpreter with the student's engine: some chapters, and those they build on."""
    from autograder.student.interpreter import interact

    selected = select_chapters(arguments.chapter)
    below = {other.number for chapter in selected for other in chapters_below(chapter)}
    chapters = [other for other in load_chapters() if other in selected or other.number in below]
    given, _ = split_given(load_chapters(), arguments.given)
    with with_given(given, find_engine(arguments.engine)) as folders:
        interact(chapters, folders)
    return 0


def run_hint(arguments: argparse.Namespace) -> int:
    """Print the first few hints for an exercise, and then the command that shows the next one."""
    _, exercise = named_exercise("hint", arguments)
    shown = exercise.hints[: max(1, arguments.count)]
    print(f"{exercise.id} {exercise.title}")
    for number, text in enumerate(shown, 1):
        print(f"  {number}. {text}")
    if left := len(exercise.hints) - len(shown):
        following = line_of("hint", EX=exercise.id, N=str(len(shown) + 1))
        more = "1 more hint" if left == 1 else f"{left} more hints"
        print(f"  {more}. For the next one: {following}")
    return 0


def named_exercise(what: str, arguments: argparse.Namespace) -> tuple[Chapter, Exercise]:
    """Find the exercise that a command is for. It must be named, and not in a given chapter."""
    if not arguments.exercise:
        raise ValueError(
            f"Which exercise? Add its number, as in {line_of(what, EX='B2.3')}. To see which "
            f"exercises are open: {line_of('check')}"
        )
    chapter, exercise = find_exercise(arguments.exercise, load_chapters())
    if arguments.given and chapter in select_chapters(arguments.given):
        raise ValueError(
            f"exercise {exercise.id} is in chapter {chapter.number}, which is given. The "
            "reference replaces your code there, so there is nothing for you to write"
        )
    return chapter, exercise


def find_exercise(wanted: str, chapters: list[Chapter]) -> tuple[Chapter, Exercise]:
    """Find an exercise by its id, such as B2.3 or b2.3, and return it with its chapter."""
    known = {e.id.lower(): (chapter, e) for chapter in chapters for e in chapter.exercises}
    if wanted.lower() in known:
        return known[wanted.lower()]
    bare = re.sub(r"^[a-z]", "", wanted.lower())
    ids = [e.id for _, e in known.values()]
    if alike := [name for name in ids if name.lower().startswith(wanted.lower())]:
        words = f"Similar ids: {', '.join(alike)}"
    elif same := [name for name in ids if bare and re.sub(r"^[A-Z]", "", name).lower() == bare]:
        words = f"Did you mean {' or '.join(same)}?"
    else:
        number = re.sub(r"\..*", "", bare)
        name = next((c.name for c in chapters if str(c.number) == number), chapters[0].name)
        words = f"An id looks like {ids[0]} or {ids[-1]}. The ids of a chapter are listed in its "
        words += f"reference.md, such as chapters/{name}/reference.md"
    raise ValueError(f"there is no exercise {wanted!r}. {words}")


if __name__ == "__main__":
    sys.exit(main())
