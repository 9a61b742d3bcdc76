"""Draw plots in the same way as the command, and read the tables that it writes."""

from __future__ import annotations

import csv
import subprocess
from pathlib import Path

from autograder.manifest import ROOT
from copies import copy_tree
from made import made_stubs
from studied import study


def plot(
    engine: str | Path, out: Path, chapters: str = "2", only: tuple[str, ...] = ()
) -> subprocess.CompletedProcess[str]:
    """Draw the plots of some chapters with an engine, or only those that ``only`` names."""
    command = ("plot", "--chapter", chapters, "--engine", str(engine), "--out", str(out))
    return study(*command, only=only)


def table(out: Path, name: str, chapter: str = "ch02_vectors") -> list[list[str]]:
    with (out / chapter / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


def engine_with(chapter: str, added: dict[str, str], at: Path) -> Path:
    """Return a copy of the reference with lines appended to some modules of a chapter."""
    copy_tree(ROOT / "solutions", at / "engine")
    for module, lines in added.items():
        with (at / "engine" / chapter / module).open("a", encoding="utf-8") as file:
            file.write(f"\n\n{lines}\n")
    return at / "engine"


def plot_of_stubs(chapter: str, at: Path) -> str:
    """Return what is printed if a chapter of stubs is plotted on the reference of the others."""
    copy_tree(ROOT / "solutions", at / "engine")
    for path, text in made_stubs().items():
        if path.startswith(f"chapters/{chapter}/"):
            (at / "engine" / path.removeprefix("chapters/")).write_text(text, encoding="utf-8")
    done = plot(at / "engine", at, chapter[3])
    assert done.returncode == 1
    return done.stdout
