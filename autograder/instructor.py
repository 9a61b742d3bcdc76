"""The commands that only instructors use, such as grade, handout and similarity.

A handout does not contain this module.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from autograder.course.choose import add_options, work_of
from autograder.manifest import ROOT, select_chapters
from autograder.release import commands as release


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Define the command-line options of the instructor commands, such as grade and handout.

    Each command imports the modules that it needs only when it runs. Otherwise, a student's `make
    check` would have to wait while Python imports the whole grader.
    """
    unsafe = "grade without a sandbox if this machine has none; only for a class you trust"
    command = commands.add_parser("grade", help="grade a folder of submissions")
    command.add_argument(
        "folder",
        type=Path,
        nargs="?",
        help="folder of submissions, or a zip of all of them (default: the class that was graded "
        "last into --out, or else the sample class)",
    )
    command.add_argument("--out", type=Path, required=True, help="folder for the results")
    command.add_argument("--seed", help="seed for the random numbers (default: a new one)")
    command.add_argument("--chapters", default="", help="chapters, such as 2,3 (default: all)")
    command.add_argument("--given", default="", help="chapters that were handed out complete")
    command.add_argument(
        "--jobs", type=int, help="submissions graded at once (default: one per core)"
    )
    command.add_argument("--cluster", help="Dask scheduler to use, such as tcp://host:8786")
    command.add_argument(
        "--checks", type=Path, help="folder of hidden checks (chNN_name/test_*.py)"
    )
    command.add_argument("--student", help="grade only this student again, with the same seed")
    command.add_argument(
        "--note", default="", help="with --student: the reason to write to regrades.csv"
    )
    command.add_argument("--roster", type=Path, help="CSV with the columns id,name,email,login")
    command.add_argument("--anonymous", action="store_true", help="show codes instead of names")
    command.add_argument("--title", default="", help="title in Canvas, such as 'Lab 1 (12345)'")
    command.add_argument("--points", type=float, help="what full points are worth on the platform")
    command.add_argument("--unsafe-no-sandbox", action="store_true", help=unsafe)
    add_options(command)
    command.set_defaults(run=run_grade)

    for name, help_text, run in (
        ("handout", "make a handout for students", run_handout),
        ("classroom", "make a handout with a workflow for GitHub Classroom", run_classroom),
    ):
        command = commands.add_parser(name, help=help_text)
        command.add_argument(
            "chapters", nargs="?", help="chapters to hand out as stubs, such as 4-5"
        )
        command.add_argument(
            "--given", default="", help="chapters to hand out complete, such as 2-3"
        )
        command.add_argument("--out", type=Path, required=True, help="a new folder")
        add_options(command)
        command.set_defaults(run=run)

    command = commands.add_parser("gradescope", help="make the autograder zip for Gradescope")
    command.add_argument(
        "chapters", nargs="?", default="", help="chapters, such as 2-3 (default: all)"
    )
    command.add_argument("--given", default="", help="chapters that were handed out complete")
    command.add_argument("--out", type=Path, required=True, help="the zip file")
    command.add_argument("--unsafe-no-sandbox", action="store_true", help=unsafe)
    add_options(command)
    command.set_defaults(run=run_gradescope)

    command = commands.add_parser("similarity", help="compare the submissions of a class")
    command.add_argument(
        "folder", type=Path, help="folder of submissions, one folder or .zip per student"
    )
    command.add_argument("--out", type=Path, required=True, help="folder for the pages")
    command.add_argument("--chapters", default="", help="chapters, such as 2,3 (default: all)")
    command.add_argument("--roster", type=Path, help="CSV with the columns id,name,email,login")
    add_options(command)
    command.set_defaults(run=run_similarity)

    command = commands.add_parser("mark", help="mark a class's written answers on a web page")
    command.add_argument(
        "folder", type=Path, help="folder of submissions, one folder or .zip per student"
    )
    command.add_argument("--chapters", default="", help="chapters, such as 2,3 (default: all)")
    command.add_argument("--roster", type=Path, help="the roster that the class is graded with")
    command.add_argument(
        "--no-browser", action="store_true", help="print the address instead of opening a browser"
    )
    add_options(command)
    command.set_defaults(run=run_mark)

    release.add_commands(commands)

    command = commands.add_parser("stubs", help="generate stubs and tables in chapters/")
    command.add_argument("--check", action="store_true", help="only list what is out of date")
    command.set_defaults(run=run_stubs)


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade the submissions of a whole class, or regrade one student."""
    if sys.platform == "win32":
        raise ValueError("grade needs Linux or macOS; on Windows, run it under WSL")
    import signal

    from autograder.grader.class_folder import SAMPLE
    from autograder.grader.cohort import ClassOptions, grade
    from autograder.grader.regrade import earlier_choice
    from autograder.platforms.uploads import Column
    from autograder.submissions.unpack import class_folder

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # handled like Ctrl-C

    folder = class_folder(arguments.folder or _class_of(arguments))
    is_again = arguments.student or not (arguments.folder or folder == SAMPLE)
    if is_again and not (arguments.chapters or arguments.given or arguments.assignment):
        arguments.chapters, arguments.given = earlier_choice(arguments.out)
    work = work_of(arguments)
    options = ClassOptions(
        given=work.given,
        earlier=work.earlier,
        seed=arguments.seed or work.seed,
        student=arguments.student,
        why=arguments.note,
        hidden=work.hidden,
        deadline=work.deadline,
        unsafe=arguments.unsafe_no_sandbox,
        jobs=arguments.jobs,
        cluster=arguments.cluster,
        roster=arguments.roster or work.roster,
        anonymous=arguments.anonymous,
        column=Column(arguments.title or work.title, arguments.points),
        assignment=work.name,
    )
    return grade(folder, arguments.out, work.chapters, options)


def _class_of(arguments: argparse.Namespace) -> Path:
    """Return the folder of the class to grade if the command names none.

    It is the class whose grades are in the folder for the results. If there are none, it is the
    sample class, but never for a real assignment.

    Raises:
        ValueError: The command is for a real class that it must name.
    """
    from autograder.grader.class_folder import SAMPLE, graded_folder
    from autograder.submissions.unpack import refuse_newer_zip

    if before := graded_folder(arguments.out):
        refuse_newer_zip(before)
        print(f"grading the class in {before} again")
        return before
    if arguments.assignment or arguments.student or arguments.roster:
        raise ValueError(
            "name the folder or the zip of the submissions (make: SUBMISSIONS=../handed-in)"
        )
    return SAMPLE


def run_handout(arguments: argparse.Namespace) -> int:
    """Create the folder that students receive for an assignment or for selected chapters."""
    from autograder.course.handout import about
    from autograder.handouts.handout import make_handout

    work = work_of(arguments, handed_out=True)
    make_handout(work.chapters, work.given, arguments.out, about=about(work))
    return 0


def run_classroom(arguments: argparse.Namespace) -> int:
    """Build a handout for GitHub Classroom, with a workflow that grades every push."""
    from autograder.course.handout import about
    from autograder.platforms.classroom import make_classroom, rounded_points

    work = work_of(arguments, handed_out=True)
    words = about(work, on_github=rounded_points(work.chapters))
    make_classroom(work.chapters, work.given, arguments.out, about=words)
    return 0


def run_gradescope(arguments: argparse.Namespace) -> int:
    """Build the autograder zip file that an instructor uploads to Gradescope."""
    from autograder.platforms.gradescope import make_gradescope

    make_gradescope(work_of(arguments), arguments.out, unsafe=arguments.unsafe_no_sandbox)
    return 0


def run_similarity(arguments: argparse.Namespace) -> int:
    """Compare the code of all students, and print how many pairs are unusually similar."""
    from autograder.similarity.run import similarity
    from autograder.submissions.unpack import class_folder

    work = work_of(arguments)
    roster = arguments.roster or work.roster
    return similarity(class_folder(arguments.folder), arguments.out, work.chapters, roster)


def run_mark(arguments: argparse.Namespace) -> int:
    """Serve the web page for marking written answers until the instructor presses Ctrl-C."""
    if sys.platform == "win32":
        raise ValueError("mark needs Linux or macOS; on Windows, run it under WSL")
    from autograder.marking.marking_server import mark
    from autograder.submissions.unpack import class_folder

    work = work_of(arguments)
    roster = arguments.roster or work.roster
    folder = class_folder(arguments.folder)
    return mark(folder, work.chapters, roster=roster, browser=not arguments.no_browser)


def run_stubs(arguments: argparse.Namespace) -> int:
    """Generate the stubs that students start from, and the table of exercises in each chapter.

    They are generated from our solutions and the manifests. With --check, only list the files that
    are out of date.
    """
    from autograder.handouts.stubs import stale_stubs, write_stubs
    from autograder.handouts.tables import write_tables

    if arguments.check:
        stale = stale_stubs()
        for path in stale:
            print(f"out of date: {path}")
        print(f"stubs: {len(stale)} out of date")
        return bool(stale)
    written, left_alone = write_stubs()
    written += write_tables(select_chapters(""), ROOT)
    for path in written:
        print(f"generated {path}")
    for path in left_alone:
        print(f"not overwritten, since it was edited: {path}")
    print(
        f"stubs and tables: {len(written)} generated, {len(left_alone)} not overwritten, "
        "the rest up to date"
    )
    return bool(left_alone)
