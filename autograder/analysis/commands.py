"""Define the `progress` command, which compares the graded assignments of a class."""

from __future__ import annotations

import argparse
from pathlib import Path


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the `progress` command and its options to the argument parser."""
    command = commands.add_parser("progress", help="compare several graded assignments of a class")
    command.add_argument("runs", nargs="+", type=Path, help="folders with the results of grade")
    command.add_argument("--out", type=Path, required=True, help="folder for the page")
    command.set_defaults(run=run_progress)


def run_progress(arguments: argparse.Namespace) -> int:
    """Write progress.html, which compares the graded assignments of a class, and print its path."""
    from autograder.analysis.progress import write_progress

    page = write_progress(arguments.runs, arguments.out)
    print(f"Compared {len(arguments.runs)} assignments: {page}")
    return 0
