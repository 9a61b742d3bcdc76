"""The instructor's commands. A hand-out does not contain them."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from autograder.manifest import ROOT, select_chapters, split_given


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the commands. What they need is loaded when they run: check must be fast."""
    unsafe = "where no wall can be put up, grade a class that you trust without one"
    command = commands.add_parser("grade", help="grade a folder of submissions")
    command.add_argument("folder", type=Path, help="with a folder, or a .zip, for each student")
    command.add_argument("--out", type=Path, required=True, help="where the results go")
    command.add_argument("--seed", help="seed of the numbers (default: a new one, reported)")
    command.add_argument("--chapters", default="", help="such as 2,3 (default: all)")
    command.add_argument("--given", default="", help="chapters that were handed out complete")
    command.add_argument("--jobs", type=int, help="submissions at a time (default: one a core)")
    command.add_argument("--cluster", help="a Dask scheduler, tcp://host:port, to grade over")
    command.add_argument("--checks", type=Path, help="a folder of hidden checks: chNN_name/test_*")
    command.add_argument("--unsafe-no-sandbox", action="store_true", help=unsafe)
    command.set_defaults(run=run_grade)

    for name, help_text, run in (
        ("handout", "make what students get", run_handout),
        ("classroom", "make a hand-out with a workflow for GitHub Classroom", run_classroom),
    ):
        command = commands.add_parser(name, help=help_text)
        command.add_argument("chapters", help="chapters as stubs, such as 4-5")
        command.add_argument("--given", default="", help="chapters given complete, such as 2-3")
        command.add_argument("--out", type=Path, required=True, help="a new folder")
        command.set_defaults(run=run)

    command = commands.add_parser("gradescope", help="make the autograder zip for Gradescope")
    command.add_argument("chapters", help="chapters to grade, such as 2-3")
    command.add_argument("--given", default="", help="chapters that were handed out complete")
    command.add_argument("--out", type=Path, required=True, help="the zip file")
    command.add_argument("--unsafe-no-sandbox", action="store_true", help=unsafe)
    command.set_defaults(run=run_gradescope)

    command = commands.add_parser("similarity", help="compare the submissions of a class")
    command.add_argument("folder", type=Path, help="with a folder, or a .zip, for each student")
    command.add_argument("--out", type=Path, required=True, help="where the pages go")
    command.add_argument("--chapters", default="", help="such as 2,3 (default: all)")
    command.set_defaults(run=run_similarity)

    command = commands.add_parser("mark", help="mark the written answers of a class on a page")
    command.add_argument("folder", type=Path, help="with a folder, or a .zip, for each student")
    command.add_argument("--chapters", default="", help="such as 2,3 (default: all)")
    command.add_argument("--no-browser", action="store_true", help="print the address only")
    command.set_defaults(run=run_mark)

    command = commands.add_parser("stubs", help="make stubs and tables in chapters/")
    command.add_argument("--check", action="store_true", help="only say what is not in step")
    command.set_defaults(run=run_stubs)


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade a class."""
    if sys.platform == "win32":
        raise ValueError("grade takes Linux or macOS; on Windows run it under WSL")
    import signal

    from autograder.grader.cohort import ClassOptions, grade

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # it ends as Ctrl-C does

    given, chapters = split_given(select_chapters(arguments.chapters), arguments.given)
    options = ClassOptions(
        given=given,
        seed=arguments.seed,
        hidden=arguments.checks,
        unsafe=arguments.unsafe_no_sandbox,
        jobs=arguments.jobs,
        cluster=arguments.cluster,
    )
    return grade(arguments.folder, arguments.out, chapters, options)


def run_handout(arguments: argparse.Namespace) -> int:
    """Make a hand-out and say what it holds."""
    from autograder.handout import make_handout

    given = select_chapters(arguments.given) if arguments.given else []
    make_handout(select_chapters(arguments.chapters), given, arguments.out)
    return 0


def run_classroom(arguments: argparse.Namespace) -> int:
    """Make a hand-out with its workflow and say what it holds."""
    from autograder.platforms.classroom import make_classroom

    given = select_chapters(arguments.given) if arguments.given else []
    make_classroom(select_chapters(arguments.chapters), given, arguments.out)
    return 0


def run_gradescope(arguments: argparse.Namespace) -> int:
    """Make the zip and say what it holds."""
    from autograder.platforms.gradescope import make_gradescope

    given, chapters = split_given(select_chapters(arguments.chapters), arguments.given)
    make_gradescope(chapters, given, arguments.out, unsafe=arguments.unsafe_no_sandbox)
    return 0


def run_similarity(arguments: argparse.Namespace) -> int:
    """Compare the submissions of a class, and say how many pairs stand out."""
    from autograder.similarity.run import similarity

    return similarity(arguments.folder, arguments.out, select_chapters(arguments.chapters))


def run_mark(arguments: argparse.Namespace) -> int:
    """Serve the page for marking until Ctrl-C."""
    if sys.platform == "win32":
        raise ValueError("mark takes Linux or macOS; on Windows run it under WSL")
    from autograder.marking.server import mark

    chapters = select_chapters(arguments.chapters)
    return mark(arguments.folder, chapters, browser=not arguments.no_browser)


def run_stubs(arguments: argparse.Namespace) -> int:
    """Make the stubs, or say which are not in step."""
    from autograder.stubs import stale_stubs, write_stubs
    from autograder.tables import write_tables

    if arguments.check:
        stale = stale_stubs()
        for path in stale:
            print(f"not what solutions/ makes: {path}")
        print(f"stubs: {len(stale)} out of step")
        return bool(stale)
    written, left_alone = write_stubs()
    written += write_tables(select_chapters(""), ROOT)
    for path in written:
        print(f"made {path}")
    for path in left_alone:
        print(f"left alone, it has been edited: {path}")
    print(f"stubs and tables: {len(written)} made, {len(left_alone)} left alone, the rest in step")
    return bool(left_alone)
