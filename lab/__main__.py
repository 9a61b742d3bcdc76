"""Open the interactive scenes in a browser, or record one to files."""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import math
import sys
import webbrowser
from pathlib import Path
from urllib.parse import urlencode

from autograder.commands import find_engine, prepare, sentence
from autograder.files import from_here
from autograder.manifest import ROOT
from lab.catalog import entries, find, load
from scenes.engine import add_engine_options, use_engine
from scenes.reason import reason, time_limit


def main() -> int:
    """Run the ``serve`` or ``record`` command, and return its exit status."""
    parser = argparse.ArgumentParser(prog="python -m lab", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    serve = commands.add_parser("serve", help="serve the page on this machine")
    serve.add_argument("--chapter", type=int, help="open the first scene of this chapter")
    serve.add_argument("--port", type=int, default=0, help="the port (default: any free port)")
    serve.add_argument(
        "--no-browser", action="store_true", help="print the address instead of opening a browser"
    )
    record = commands.add_parser("record", help="record a scripted run of a scene to files")
    record.add_argument("--seconds", type=float, help="length of the recording in seconds")
    record.add_argument(
        "--out", type=Path, default=ROOT / "build" / "lab", help="the folder for the files"
    )
    for command in (serve, record):
        command.add_argument("scene", nargs="?", default="", help="a scene, such as one-spring")
        add_engine_options(command)
        command.add_argument(
            "--set",
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help="set a parameter of the scene",
        )
    options = parser.parse_args()
    if not prepare("requirements" if options.command == "serve" else "pictures"):
        return 2
    settings = dict(setting.partition("=")[::2] for setting in options.set)
    try:
        return (_serve if options.command == "serve" else _record)(options, settings)
    except ValueError as error:
        parser.error(str(error))
    except OSError as error:
        print(f"{options.command}: {sentence(error)}", file=sys.stderr)
        return 2


def _serve(options: argparse.Namespace, settings: dict[str, str]) -> int:
    from lab.server import Lab, serve  # only this command needs a server

    find_engine(options.engine)
    if not entries():
        raise ValueError("this folder has no scenes for its chapters")
    query = first_query(options.scene, options.chapter, settings)

    def ready(address: str) -> None:
        address = f"{address}?{query}" if query else address
        print(f"The lab is running at {address}\nPress Ctrl-C to stop it.", flush=True)
        if not options.no_browser:
            webbrowser.open(address)

    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(serve(Lab(options.engine, options.given), options.port, ready))
    return 0


def _record(options: argparse.Namespace, settings: dict[str, str]) -> int:
    """Record a scene to files, and print their names. Return 1 if the engine failed."""
    find(options.scene)
    if options.seconds is not None and not 0.0 < options.seconds < math.inf:
        raise ValueError(f"--seconds must be positive and finite, got {options.seconds!r}")
    import matplotlib

    matplotlib.use("agg")  # draws to files even if there is a display
    from lab.record import TIME_LIMIT, record

    use_engine(argparse.ArgumentParser(prog="python -m lab"), options.engine, options.given)
    try:
        with time_limit(TIME_LIMIT):
            scene = load(options.scene)(**settings)
        files = record(scene, options.out, options.seconds)
    except (Exception, SystemExit) as error:
        print(f"{options.scene}: cannot be recorded, {reason(error)}")
        return 1
    print(f"{options.scene}: {', '.join(str(from_here(file)) for file in files)}")
    return 0


def first_query(scene: str, chapter: int | None, settings: dict[str, str]) -> str:
    """Build the query with which the lab's page opens, such as "scene=one-spring&mass=2"."""
    if scene:
        find(scene)
    elif chapter is not None:
        scene = next((entry.name for entry in entries() if entry.chapter == chapter), "")
        if not scene:
            raise ValueError(f"chapter {chapter} has no scenes")
    return urlencode(({"scene": scene} if scene else {}) | settings)


if __name__ == "__main__":
    sys.exit(main())
