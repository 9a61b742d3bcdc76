"""The commands of the autograder: python -m autograder check, hint, grade, handout, stubs."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from autograder.manifest import ROOT, Chapter, load_chapters, select_chapters
from autograder.runner import GraderError


def main() -> int:
    """Run one command; return its exit status."""
    parser = argparse.ArgumentParser(prog="python -m autograder", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)

    check = commands.add_parser("check", help="check your work")
    check.add_argument("--chapter", default="", help="chapters such as 2 or 2-4 (default: all)")
    check.add_argument("--exercise", help="one exercise, such as 2.5 or B2.3")
    check.add_argument("--engine", default="chapters", help="the folder to check")
    check.add_argument("--seed", default="1", help="seed of the numbers that checks draw")
    check.set_defaults(run=run_check)

    hint = commands.add_parser("hint", help="show hints for an exercise")
    hint.add_argument("exercise", help="such as 2.5 or B2.3")
    hint.add_argument("--count", type=int, default=1, help="how many hints (default: 1)")
    hint.set_defaults(run=run_hint)

    grade = commands.add_parser("grade", help="grade a folder of submissions")
    grade.add_argument("folder", type=Path, help="a folder with a folder for each student")
    grade.add_argument("--out", type=Path, required=True, help="where the results go")
    grade.add_argument("--seed", help="seed of the numbers (default: a new one, reported)")
    grade.add_argument("--chapters", default="", help="such as 2,3 (default: all)")
    grade.set_defaults(run=run_grade)

    handout = commands.add_parser("handout", help="make what students get")
    handout.add_argument("chapters", help="chapters as stubs, such as 4-5")
    handout.add_argument("--given", default="", help="chapters given complete, such as 2-3")
    handout.add_argument("--out", type=Path, required=True, help="a new folder")
    handout.set_defaults(run=run_handout)

    stubs = commands.add_parser("stubs", help="make chapters/ from solutions/")
    stubs.add_argument("--check", action="store_true", help="only say what is not up to date")
    stubs.set_defaults(run=run_stubs)

    arguments = parser.parse_args()
    try:
        return int(arguments.run(arguments))
    except (ValueError, OSError, GraderError) as error:
        print(f"{arguments.command}: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print(f"\n{arguments.command}: stopped", file=sys.stderr)
        return 130


def run_check(arguments: argparse.Namespace) -> bool:
    from autograder.check import check

    chapters = select_chapters(arguments.chapter)
    if arguments.exercise:
        chapters = [_chapter_of(arguments.exercise, chapters)]
    engine = [ROOT / folder for folder in dict.fromkeys((arguments.engine, "chapters"))]
    return not check(chapters, arguments.exercise, engine, arguments.seed)


def run_hint(arguments: argparse.Namespace) -> int:
    exercise = _chapter_of(arguments.exercise, load_chapters()).exercise(arguments.exercise)
    shown = exercise.hints[: max(1, arguments.count)]
    print(f"{exercise.id} {exercise.title}")
    for number, text in enumerate(shown, 1):
        print(f"  {number}. {text}")
    if left := len(exercise.hints) - len(shown):
        more = f"make hint EX={exercise.id} N={len(shown) + 1}"
        print(f"  {left} more; the next one: {more}")
    return 0


def run_grade(arguments: argparse.Namespace) -> int:
    from autograder.cohort import grade

    return grade(
        arguments.folder, arguments.out, select_chapters(arguments.chapters), arguments.seed
    )


def run_handout(arguments: argparse.Namespace) -> int:
    from autograder.handout import make_handout

    given = select_chapters(arguments.given) if arguments.given else []
    make_handout(select_chapters(arguments.chapters), given, arguments.out)
    return 0


def run_stubs(arguments: argparse.Namespace) -> int:
    from autograder.stubs import stale_stubs, write_stubs

    if arguments.check:
        stale = stale_stubs()
        print("\n".join(f"not what solutions/ makes: {path}" for path in stale) or "stubs: in step")
        return bool(stale)
    written, left_alone = write_stubs()
    for path in written:
        print(f"made {path}")
    for path in left_alone:
        print(f"left alone, it has been edited: {path}")
    print(f"stubs: {len(written)} made, {len(left_alone)} left alone, the rest in step")
    return bool(left_alone)


def _chapter_of(exercise: str, chapters: list[Chapter]) -> Chapter:
    for chapter in chapters:
        if any(exercise == known.id for known in chapter.exercises):
            return chapter
    there = ", ".join(known.id for chapter in chapters for known in chapter.exercises)
    raise ValueError(f"there is no exercise {exercise!r}; there is {there}")


if __name__ == "__main__":
    sys.exit(main())
