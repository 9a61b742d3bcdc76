"""The commands that only instructors use, such as grade, handout and similarity.

A handout does not contain this module. Each command imports what it needs when it runs.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace

from autograder.commands import command
from autograder.course.choose import DEFAULT, work_of
from autograder.manifest import ROOT, select_chapters


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade the submissions of a whole class, or regrade one student."""
    refuse_windows("grade")
    import signal

    from autograder.grader.cohort import ClassOptions, grade
    from autograder.grader.reports_folder import SAMPLE, earlier_choice, graded_folder
    from autograder.platforms.uploads import Column
    from autograder.submissions.unpack import class_folder, refuse_newer_zip

    signal.signal(signal.SIGTERM, signal.default_int_handler)  # handled like Ctrl-C

    before = None if arguments.folder else graded_folder(arguments.out)
    if before:
        refuse_newer_zip(before)
        print(f"grading the class in {before} again")
    elif not arguments.folder and (arguments.assignment or arguments.student or arguments.roster):
        raise ValueError(
            "name the folder or the zip of the submissions (make: SUBMISSIONS=../handed-in)"
        )
    folder = class_folder(arguments.folder or before or SAMPLE)
    is_again = arguments.student or (before and folder != SAMPLE)
    if is_again and not (arguments.chapters or arguments.given or arguments.assignment):
        arguments.chapters, arguments.given = earlier_choice(arguments.out)
    work = work_of(arguments)
    seed, roster = arguments.seed or work.seed, arguments.roster or work.roster
    options = ClassOptions(
        student=arguments.student,
        why=arguments.note,
        unsafe=arguments.unsafe_no_sandbox,
        jobs=arguments.jobs,
        cluster=arguments.cluster,
        column=Column(arguments.title or work.title, arguments.points),
    )
    return grade(folder, arguments.out, replace(work, seed=seed, roster=roster), options)


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


def run_release(arguments: argparse.Namespace) -> int:
    """Write the released solutions, and pages that compare them with the students' code."""
    from autograder.release.run import run_release

    return run_release(arguments)


def run_similarity(arguments: argparse.Namespace) -> int:
    """Compare the code of all students, and print how many pairs are unusually similar."""
    from autograder.similarity.run import similarity
    from autograder.submissions.unpack import class_folder

    work = work_of(arguments)
    roster = arguments.roster or work.roster
    return similarity(class_folder(arguments.folder), arguments.out, work.chapters, roster)


def run_mark(arguments: argparse.Namespace) -> int:
    """Serve the web page for marking written answers until the instructor presses Ctrl-C."""
    refuse_windows("mark")
    from autograder.marking.marking_server import mark
    from autograder.submissions.unpack import class_folder

    work = work_of(arguments)
    roster = arguments.roster or work.roster
    folder = class_folder(arguments.folder)
    variables = {
        "SUBMISSIONS": arguments.folder,
        "CHAPTERS": arguments.chapters,
        "ROSTER": arguments.roster,
        "ASSIGNMENT": arguments.assignment,
        "COURSE": arguments.course if arguments.course != DEFAULT else None,
    }
    again = command("grade", **{key: str(value) for key, value in variables.items() if value})
    browser = not arguments.no_browser
    return mark(folder, work.chapters, roster=roster, browser=browser, again=again)


def run_stubs(arguments: argparse.Namespace) -> int:
    """Generate the stubs, the tables of exercises and the makefiles, or list which are stale."""
    from autograder.handouts.stubs import stale_stubs, write_stubs
    from autograder.handouts.tables import write_tables

    if arguments.check:
        stale = stale_stubs()
        lines = [f"out of date: {path}" for path in stale]
        print("\n".join([*lines, f"stubs: {len(stale)} out of date"]))
        return bool(stale)
    written, left_alone = write_stubs()
    written += write_tables(select_chapters(""), ROOT)
    lines = [f"generated {path}" for path in written]
    lines += [f"not overwritten, since it was edited: {path}" for path in left_alone]
    lines.append(
        f"stubs and tables: {len(written)} generated, {len(left_alone)} not overwritten, "
        "the rest up to date"
    )
    print("\n".join(lines))
    return bool(left_alone)


def refuse_windows(command: str) -> None:
    """Raise ValueError on Windows, where a command that runs students' code cannot run."""
    if sys.platform == "win32":
        raise ValueError(f"{command} needs Linux or macOS; on Windows, run it under WSL")
