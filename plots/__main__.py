"""Draw the plots of chapters or the pictures of the lessons, as in `python -m plots draw`."""

from __future__ import annotations

import sys

from autograder.commands import run_named

# The groups of packages that the commands need. A handout for students contains only the first.
COMMANDS = {"draw": "pictures", "figures": "everything"}


def main() -> int:
    """Run the command named by the first argument, and return its exit status."""
    return run_named("plots", COMMANDS)


if __name__ == "__main__":
    sys.exit(main())
