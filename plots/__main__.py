"""Draw the plots of chapters or the pictures of the lessons, as in `python -m plots draw`."""

from __future__ import annotations

import importlib
import importlib.util
import sys

from autograder.commands import prepare, sentence

# The groups of packages that the commands need. A handout for students contains only the first.
COMMANDS = {"draw": "pictures", "figures": "everything"}


def main() -> int:
    """Run the command named by the first argument, and return its status, or 2 if it cannot run."""
    there = [name for name in COMMANDS if importlib.util.find_spec(f"plots.{name}")]
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    if name not in there:
        print(f"usage: python -m plots {'|'.join(there)}", file=sys.stderr)
        return 2
    if not prepare(COMMANDS[name]):
        return 2
    try:
        return int(importlib.import_module(f"plots.{name}").main(sys.argv[2:]))
    except OSError as error:
        print(f"{name}: {sentence(error)}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
