"""Build the course's website as static files.

Run this program as `python -m web --out build/site [--with-solutions]`.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from autograder import commands
from autograder.manifest import ROOT
from web.node import prepare, run_node

PARTS = ROOT / "build" / "web"  # the content of the pages
NOT_OURS = ("pyodide", "vendor")


def main() -> int:
    """Build the website and return the exit status: 1 if it cannot be built, 0 otherwise."""
    parser = argparse.ArgumentParser(prog="python -m web", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "site")
    parser.add_argument(
        "--with-solutions",
        action="store_true",
        help="include the reference's compiled modules for students who skip a chapter",
    )
    options = parser.parse_args()
    if not commands.prepare("pictures"):
        return 1
    try:
        build(options.out, with_solutions=options.with_solutions)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(f"make site: {commands.sentence(error)}", file=sys.stderr)
        return 1
    print(f"\nThe site is in {options.out}: {_sizes(options.out)}.")
    print(f"To view it, run: {Path(sys.executable)} -m http.server -d {options.out} 8000")
    print("and open http://localhost:8000/ in a browser.")
    return 0


def build(out: Path, *, with_solutions: bool) -> None:
    """Build the website in a folder that is new or an earlier build. Otherwise raise ValueError."""
    if out.exists() and any(out.iterdir()) and not (out / "sw.js").is_file():
        raise ValueError(f"{out} is neither empty nor an earlier build of the site")
    # These need packages.
    from web.course import course
    from web.pack import pack
    from web.pictures import copy_pictures

    prepare()
    shutil.rmtree(PARTS, ignore_errors=True)
    PARTS.mkdir(parents=True)
    _say("Reading the chapters ...")
    _write("course.json", course())
    _write("settings.json", {"solutions": with_solutions, "repository": repository()})
    _say("Drawing the scenes ...")
    # This needs its own process: a scene imports the reference, which then stays imported.
    subprocess.run([sys.executable, "-m", "web.stills", PARTS / "stills"], cwd=ROOT, check=True)
    _write("pictures.json", copy_pictures(PARTS / "figures"))
    _say("Packing what Python needs ...")
    pack(PARTS / "site", with_solutions=with_solutions)
    _say("Making the pages ...")
    run_node("builder/site.mjs", str(PARTS), str(PARTS / "site"))
    put_in_place(PARTS / "site", out.resolve())


def put_in_place(site: Path, out: Path) -> None:
    """Move the new website to ``out``, which never contains a half-finished site."""
    new, old = (out.with_name(f".{out.name}.{what}") for what in ("new", "old"))
    for folder in (new, old):
        shutil.rmtree(folder, ignore_errors=True)
    out.parent.mkdir(parents=True, exist_ok=True)
    shutil.move(site, new)  # copies it, if the folders are on different disks
    if out.exists():
        out.replace(old)
    new.replace(out)
    shutil.rmtree(old, ignore_errors=True)


def repository() -> str:
    """Return the address of the repository whose workflow builds the website, or ""."""
    server, name = os.environ.get("GITHUB_SERVER_URL"), os.environ.get("GITHUB_REPOSITORY")
    return f"{server}/{name}" if server and name else ""


def _write(name: str, data: object) -> None:
    (PARTS / name).write_text(json.dumps(data), encoding="utf-8")


def _say(words: str) -> None:
    print(words, flush=True)


def _sizes(out: Path) -> str:
    """Describe the size of the website, with and without the files taken from other projects."""
    sizes = {file: file.stat().st_size for file in out.rglob("*") if file.is_file()}
    other = sum(size for file, size in sizes.items() if file.relative_to(out).parts[0] in NOT_OURS)
    total = sum(sizes.values())
    return f"{total / 1e6:.1f} MB, {(total - other) / 1e6:.2f} MB of it without Pyodide"


if __name__ == "__main__":
    sys.exit(main())
