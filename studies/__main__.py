"""Run one of the studies of the physics engine, as in `python -m plots draw`.

The first argument is the name of the study. Each study is a module with a function ``main``, which
gets the remaining arguments.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys

from autograder.commands import prepare, sentence

COMMANDS = (
    "bench",
    "charts",
    "choose",
    "limits",
    "economy",
    "soak",
    "contacts",
    "clarity",
)


def main() -> int:
    """Run the study named by the first command-line argument, and return its exit status.

    The status is 2 if the study could not run, for example because no study has that name.
    """
    there = [name for name in COMMANDS if importlib.util.find_spec(f"studies.{name}")]
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    if name not in there:
        print(f"usage: python -m studies {'|'.join(there)}", file=sys.stderr)
        return 2
    if not prepare("everything"):
        return 2
    try:
        return int(importlib.import_module(f"studies.{name}").main(sys.argv[2:]))
    except OSError as error:
        print(f"{name}: {sentence(error)}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
