"""Run one of the studies of the physics engine, as in `python -m studies bench`."""

from __future__ import annotations

import sys

from autograder.commands import run_named

COMMANDS = ("bench", "charts", "choose", "limits", "economy", "soak", "contacts", "clarity")


def main() -> int:
    """Run the study named by the first argument, and return its exit status."""
    return run_named("studies", dict.fromkeys(COMMANDS, "everything"))


if __name__ == "__main__":
    sys.exit(main())
