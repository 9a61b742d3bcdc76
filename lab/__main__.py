"""``python -m lab``: serve the lab's page on this machine, with your engine behind it."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import sys
import webbrowser
from urllib.parse import urlencode

from autograder.commands import find_engine
from lab.catalog import entries, find
from lab.server import Lab, serve


def main() -> int:
    """Start the server; return 1 where a name is wrong."""
    parser = argparse.ArgumentParser(prog="python -m lab", description=__doc__)
    parser.add_argument("--engine", default="chapters", help="the folder with your work")
    parser.add_argument("--given", default="", help="chapters to take from the reference")
    parser.add_argument("--scene", default="", help="the scene to begin with, such as one-spring")
    parser.add_argument("--chapter", type=int, help="begin with the first scene of a chapter")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--port", type=int, default=0, help="a port (default: any that is free)")
    parser.add_argument("--no-browser", action="store_true", help="print the address only")
    options = parser.parse_args()
    try:
        find_engine(options.engine)
        query = first_query(options.scene, options.chapter, options.set)
    except ValueError as error:
        parser.error(str(error))

    def ready(address: str) -> None:
        address = f"{address}?{query}" if query else address
        print(f"The lab is at {address}\nCtrl-C ends it.", flush=True)
        if not options.no_browser:
            webbrowser.open(address)

    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(serve(Lab(options.engine, options.given), options.port, ready))
    return 0


def first_query(scene: str, chapter: int | None, settings: list[str]) -> str:
    """Return the query of the first address. Raises ValueError for a scene that there is not."""
    if scene:
        find(scene)
    elif chapter is not None:
        names = [entry.name for entry in entries() if entry.chapter == chapter]
        if not names:
            raise ValueError(f"chapter {chapter} has no scene")
        scene = names[0]
    values = dict(setting.partition("=")[::2] for setting in settings)
    return urlencode(({"scene": scene} if scene else {}) | values)


if __name__ == "__main__":
    sys.exit(main())
