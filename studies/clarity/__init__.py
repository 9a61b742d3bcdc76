"""Measure what clarity costs: the time of the clear engine divided by that of the tuned one.

The engine in solutions/ is written to be read, and the one in studies/tuned/ to be fast. Their
modules have the same names, so each engine runs in a process of its own. The two processes make the
same steps of the same scene in turn.
"""

from __future__ import annotations

import argparse
import ast
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib import pyplot

from autograder.commands import TUNED, find_engine
from autograder.files import from_here
from autograder.text.marked import with_text
from autograder.text.wrapping import plain_console, print_wrapped
from plots.drawing import BLUE, GRAY
from scenes.timing import Line, Measurement, Timer, measure, significant, versus
from studies.clarity.steps import SCENES
from studies.stored import store

Definition = ast.FunctionDef | ast.ClassDef
ROUNDS = 31
CLEAR = "solutions"
FOLDER = Path(__file__).parent
FIGURES, PICTURE, PAGE = FOLDER / "figures.json", FOLDER / "clarity.png", FOLDER / "README.md"
BEGIN, END = "<!-- clarity: `make measure WHAT=clarity` writes this -->", "<!-- end of clarity -->"


def main(arguments: list[str]) -> int:
    """Measure both engines in each scene. Write the figures, the picture and the table."""
    parser = argparse.ArgumentParser(prog="python -m studies clarity", description=__doc__)
    parser.parse_args(arguments)
    console = plain_console()
    clear, tuned = Engine(CLEAR), Engine(TUNED)
    try:
        pairs = [(name, versus(clear.timer(name), tuned.timer(name))) for name in SCENES]
        lines = measure([Measurement(*pair, ROUNDS) for pair in pairs])
    finally:
        clear.stop()
        tuned.stop()
    console.print("Time of the clear engine / time of the tuned one (quartiles), for one step:")
    for line in lines:
        told = f"{line.median:6.2f} ({line.low:.2f}-{line.high:.2f})  {line.what}"
        print_wrapped(console, told, hanging=21)
    rows = [row(line) for line in lines]
    store(FIGURES, rows=rows)
    draw(rows, PICTURE)
    page = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(with_text(page, BEGIN, END, table(rows)), encoding="utf-8", newline="\n")
    console.print(f"Written to {from_here(FIGURES)}, {from_here(PICTURE)} and {from_here(PAGE)}")
    return 0


class Engine:
    """A process that makes steps with one of the engines, and says how long they took."""

    def __init__(self, name: str) -> None:
        folders = [str(folder) for folder in find_engine(name)]
        self.process = subprocess.Popen(
            [sys.executable, str(FOLDER / "steps.py"), *folders],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def timer(self, scene: str) -> Timer:
        """Return a function that makes steps of a scene, and returns the time in s."""
        asked, answer = self.process.stdin, self.process.stdout
        assert asked is not None
        assert answer is not None

        def timed() -> float:
            asked.write(f"{scene}\n")
            asked.flush()
            return float(answer.readline())

        return timed

    def stop(self) -> None:
        """End the process."""
        self.process.communicate()


def row(line: Line) -> dict[str, Any]:
    """Return the figures of one scene, with the lines of code that differ."""
    parts = SCENES[line.what].parts
    return {
        "scene": line.what,
        "ratio": significant(line.median, 2),
        "quartiles": [significant(line.low, 2), significant(line.high, 2)],
        "what": ", ".join(f"`{name}`" for _, name in parts),
        "clear": sum(lines_of(find_engine(CLEAR), *part) for part in parts),
        "tuned": sum(lines_of(find_engine(TUNED), *part) for part in parts),
    }


def lines_of(engine: Sequence[Path], file: str, name: str) -> int:
    """Count the lines of a definition without its docstrings, comments and empty lines.

    ``engine`` lists the folders in which to look for ``file``.
    """
    path = next(folder / file for folder in engine if (folder / file).is_file())
    text = path.read_text(encoding="utf-8")
    node: ast.Module | Definition = ast.parse(text)
    for part in name.split("."):
        node = next(n for n in node.body if isinstance(n, Definition) and n.name == part)
    assert isinstance(node, Definition)
    said = {
        line
        for inner in ast.walk(node)
        if isinstance(inner, Definition) and ast.get_docstring(inner)
        for line in range(inner.body[0].lineno, (inner.body[0].end_lineno or 0) + 1)
    }
    rows = enumerate(text.splitlines(), 1)
    return sum(
        node.lineno <= number <= (node.end_lineno or 0)
        and number not in said
        and bool(row.strip())
        and not row.strip().startswith("#")
        for number, row in rows
    )


def table(rows: list[dict[str, Any]]) -> str:
    """Return the figures as a table in Markdown."""
    head = ["one step of", "clear / tuned", "code that differs", "lines, clear", "lines, tuned"]
    cells = [
        [r["scene"], f"{r['ratio']:g}", r["what"], str(r["clear"]), str(r["tuned"])] for r in rows
    ]
    lines = [head, ["---", "---:", "---", "---:", "---:"], *cells]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def draw(rows: list[dict[str, Any]], png: Path) -> None:
    """Draw the ratio of each scene as a bar with its quartiles."""
    pyplot.switch_backend("agg")
    figure, axes = pyplot.subplots(figsize=(9, 4.5), layout="constrained")
    rows = rows[::-1]
    names, ratios = [r["scene"].replace("`", "") for r in rows], [r["ratio"] for r in rows]
    whiskers = [[abs(r["quartiles"][i] - r["ratio"]) for r in rows] for i in (0, 1)]
    bars = axes.barh(names, ratios, xerr=whiskers, color=BLUE, ecolor=GRAY)
    axes.bar_label(bars, labels=[f"{ratio:g}" for ratio in ratios], padding=6)
    axes.axvline(1.0, color=GRAY, linestyle="--")
    axes.set_xlabel("time of a step in solutions/, divided by its time in studies/tuned/")
    axes.set_title("What clarity costs")
    axes.spines[["top", "right"]].set_visible(False)
    axes.margins(x=0.1)
    figure.savefig(png, dpi=110)
    pyplot.close(figure)
