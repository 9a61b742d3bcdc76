"""Write the measured figures into the pages: the strength of the checks, and the sample class."""

from __future__ import annotations

from rich.console import Console

from autograder.checks.runner import run_checks
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.text.marked import with_text
from kept import SOLUTIONS, mutants_of, seeds_of
from sample import sample_table
from wrong import read_wrong

PAGE = ROOT / "tests" / "README.md"
BEGIN, END = "<!-- strength: `make update` writes this -->", "<!-- end of strength -->"
CLASS = ROOT / "sample_class" / "README.md"
BEGIN_SAMPLE, END_SAMPLE = "<!-- sample: `make update` writes this -->", "<!-- end of sample -->"
HEAD = [
    *("chapter", "exercises", "checks", "points", "mutants killed", "as right as the reference"),
    *("wrong submissions", "reference, seeds", "second solution, seeds"),
]


def write_tables(console: Console) -> bool:
    """Write all tables, unless the second solution loses a point; return whether that was done."""
    try:
        sample = sample_table()
    except ValueError as error:
        console.print(f"no table was written: {error}", markup=False, soft_wrap=True)
        return False
    rows = [row(chapter) for chapter in load_chapters()]
    for path, begin, end, text in (
        (PAGE, BEGIN, END, table_of(rows)),
        (CLASS, BEGIN_SAMPLE, END_SAMPLE, sample),
    ):
        page = path.read_text(encoding="utf-8")
        path.write_text(with_text(page, begin, end, f"\n{text}\n"), encoding="utf-8", newline="\n")
    console.print(f"the tables are in {PAGE} and {CLASS}", markup=False)
    if any("-" in cells for cells in rows):
        measure = "Measure them with make measure WHAT=mutants and WHAT=seeds."
        console.print(f"A dash means that a figure is missing. {measure}")
    return True


def table_of(rows: list[list[str]]) -> str:
    lines = [HEAD, ["---", *["---:"] * (len(HEAD) - 1)], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def row(chapter: Chapter) -> list[str]:
    checks = run_checks(chapter, [ROOT / "solutions", ROOT / "chapters"], seed="1")
    by_code = [exercise for exercise in chapter.exercises if exercise.kind != "written"]
    mutants = mutants_of(chapter)
    killed = same = "-"
    if mutants:
        share = 100.0 * mutants["killed"] / mutants["of"]
        killed, same = f"{mutants['killed']} of {mutants['of']}, {share:.1f} %", mutants["same"]
    numbers = [len(by_code), len(checks), sum(exercise.points for exercise in by_code)]
    numbers += [killed, same, len(read_wrong(chapter))]
    seeds = [_held(chapter, solution) for solution in SOLUTIONS]
    return [f"{chapter.number} {chapter.title}", *map(str, numbers), *seeds]


def _held(chapter: Chapter, solution: str) -> str:
    """Return the number of seeds that all checks have passed, and on which Pythons."""
    by_file = seeds_of(solution, chapter).values()
    pythons = set.intersection(*(set(found) for found in by_file))
    if not pythons:
        return "-"
    least = min(found[python] for found in by_file for python in pythons)
    return f"{least} on {', '.join(sorted(pythons))}"
