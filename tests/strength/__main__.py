"""Measure how strong and how fair the checks are: python tests/strength COMMAND."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent
sys.path[1:1] = [str(TESTS / "helpers"), str(TESTS / "helpers/classes"), str(TESTS.parent)]


def main() -> int:
    """Run one command; return 0 if the checks are strong and fair enough."""
    from rich.console import Console

    from autograder.manifest import select_chapters

    parser = argparse.ArgumentParser(prog="python tests/strength", description=__doc__)
    parser.add_argument("command", choices=["mutants", "seeds", "table"])
    parser.add_argument("--chapter", default="", help="such as 2 or 2-4 (default: all)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="jobs at a time")
    parser.add_argument("--seeds", type=int, default=1000, help="number of seeds")
    arguments = parser.parse_args()
    try:
        chapters = select_chapters(arguments.chapter)
    except ValueError as error:
        parser.error(str(error))
    console = Console(highlight=False)
    if arguments.command == "mutants":
        from mutants import run_mutants

        done = [run_mutants(chapter, arguments.jobs, console) for chapter in chapters]
    elif arguments.command == "seeds":
        from run_seeds import run_seeds

        done = [run_seeds(chapters, arguments.seeds, arguments.jobs)]
    else:
        from table import write_tables

        done = [write_tables(console)]
    return 0 if all(done) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("\nstopped; the results so far are kept", file=sys.stderr)
        sys.exit(130)
