"""The command that releases the reference."""

from __future__ import annotations

import argparse
from pathlib import Path

from autograder.manifest import select_chapters


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add release."""
    command = commands.add_parser("release", help="release the reference after the deadline")
    command.add_argument("chapters", help="chapters whose reference to release, such as 2-3")
    command.add_argument("--exercises", default="", help="only these, such as 2.5,B2.3")
    command.add_argument("--submissions", type=Path, help="the class, to compare its solutions")
    command.add_argument("--grades", type=Path, help="the folder that the class was graded into")
    command.add_argument("--out", type=Path, required=True, help="folder for what is released")
    command.set_defaults(run=run_release)


def run_release(arguments: argparse.Namespace) -> int:
    """Write the reference and the pages of the students, and print what was released."""
    from autograder.release.run import release

    chapters = select_chapters(arguments.chapters)
    exercises = [name for name in arguments.exercises.replace(",", " ").split() if name]
    return release(chapters, exercises, arguments.submissions, arguments.grades, arguments.out)
