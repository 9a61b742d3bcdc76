"""Write the table of how strong and how fair the checks are into tests/README.md."""

from __future__ import annotations

from rich.console import Console

from autograder.manifest import ROOT, Chapter
from autograder.runner import run_checks
from kept import kept
from wrong import read_wrong

PAGE = ROOT / "tests" / "README.md"
BEGIN, END = "<!-- strength: `make table` writes this -->", "<!-- end of strength -->"
HEAD = [
    "chapter",
    "exercises",
    "checks",
    "points",
    "mutants killed",
    "as right as the reference",
    "wrong submissions",
    "reference, seeds",
    "second solution, seeds",
]


def write_table(chapters: list[Chapter], console: Console) -> bool:
    """Write a row a chapter, and say where a figure has not been measured here."""
    lines = [HEAD, ["---", *["---:"] * (len(HEAD) - 1)], *map(row, chapters)]
    table = "\n".join(f"| {' | '.join(line)} |" for line in lines)
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    PAGE.write_text(f"{before}{BEGIN}\n\n{table}\n\n{END}{after}", encoding="utf-8")
    console.print(f"the table is in {PAGE}", markup=False)
    missing = any("-" in line for line in lines[2:])
    if missing:
        console.print("A dash is what was not measured here: make mutants, make seeds")
    return not missing


def row(chapter: Chapter) -> list[str]:
    """Return the cells of a chapter."""
    checks = run_checks(chapter, [ROOT / "solutions", ROOT / "chapters"], seed="1")
    mutants = kept("mutants", chapter)
    killed = same = "-"
    if mutants:
        share = 100.0 * mutants["killed"] / mutants["of"]
        killed, same = f"{mutants['killed']} of {mutants['of']}, {share:.1f} %", mutants["same"]
    return [
        f"{chapter.number} {chapter.title}",
        str(sum(exercise.kind != "written" for exercise in chapter.exercises)),
        str(len(checks)),
        str(sum(exercise.points for exercise in chapter.exercises if exercise.kind != "written")),
        killed,
        str(same),
        str(len(read_wrong(chapter))),
        *(_held(chapter, name) for name in ("seeds of reference", "seeds of second solution")),
    ]


def _held(chapter: Chapter, name: str) -> str:
    """Return how many seeds, at least, hold on which Pythons."""
    pythons = kept(name, chapter)
    return f"{min(pythons.values())} on {', '.join(sorted(pythons))}" if pythons else "-"
