"""Make what students get: stubs, given chapters, checks and the student's side of the tooling."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from autograder.checks.arrange import shared_by_checks
from autograder.manifest import ROOT, Chapter, chapters_below
from autograder.stubs import KEPT, make_stubs

STUDENT_TOOLS = {
    ".": "Makefile pyproject.toml requirements.lock stubs.lock LICENSE .gitignore glossary.md",
    "autograder": (
        "__init__.py __main__.py answers.py clean.py commands.py definitions.py local_server.py "
        "lock.py make_venv.py manifest.py message.py records.py scores.py stubs.py wrapping.py"
    ),
    "autograder/checks": "*.py",
    "autograder/student": "*.py",
    "studies": (
        "__init__.py __main__.py balance.py constraints.py drag_flight.py drawing.py "
        "engine.py links.py mass_aggregate.py piles.py plot.py readings.py releases.py reason.py "
        "ropes.py rotations.py stability.py timing.py"
    ),
}

README = """\
# Game physics: {titles}

Write a part of a game physics engine, in the files under `chapters/`, and have it checked at once.
You need Python 3.11 or newer; with make, the first command sets up everything else. Without make,
as on most Windows, [chapters/README.md](chapters/README.md) has the same commands for Python.

    make watch          the exercise you are at, checked whenever you save its file
    make check          every exercise with its state, and the first thing to fix
    make check EX={example}  one exercise and what it builds on
    make hint EX={example}   a nudge; N=2 shows the second hint too
    make reset EX={example}  its stub back, and a copy of what you had
    make lab            scenes that your own engine plays, in your browser
    make plot           pictures of what your own functions do, under build/plots/
    make demo DEMO=...  one of these scenes in a window, or into files without a display

Each chapter's README maps the book's sections to the functions that you write. Written questions,
where there are any, are answered in `answers.md`. Hand in the folders under `chapters/` that you
have edited: the files that the exercise table names are taken, so keep your own helpers in them.
"""
CHARTS = "ch08_charts.py"  # scenes of the charts, which are for readers of the reference
KEPT_README = """\
The stubs as they were handed out, for `make reset`. Nothing here is checked or handed in.
"""


def student_tools(root: Path = ROOT) -> Iterator[Path]:
    """Yield the files of the tools that students get."""
    for folder, names in STUDENT_TOOLS.items():
        for name in names.split():
            yield from sorted((root / folder).glob(name))


def make_handout(
    chapters: list[Chapter], given: list[Chapter], out: Path, root: Path = ROOT
) -> None:
    """Write a hand-out into a new folder and print what it holds.

    ``chapters`` come as stubs with their checks, ``given`` complete and without checks. Raises
    ValueError where a chapter is in both, or the folder has something in it.
    """
    if both := [chapter.name for chapter in chapters if chapter in given]:
        raise ValueError(f"{', '.join(both)} cannot be both a stub and given")
    if out.exists() and any(out.iterdir()):
        raise ValueError(f"out must be a new or empty folder, and {out} is not empty")
    for file in [*student_tools(root), *shared_by_checks(root)]:
        _copy([file], out / file.parent.relative_to(root))
    _copy_lab(root, out, [chapter.name for chapter in (*chapters, *given)])
    _copy([root / "chapters" / "README.md"], out / "chapters")
    errata = (root / "errata.md").read_text(encoding="utf-8")
    without_links = re.sub(r"\[(\w+)\]\(tests/[^)]*\)", r"\1", errata)  # those tests stay here
    (out / "errata.md").write_text(without_links, encoding="utf-8", newline="\n")
    stubs = make_stubs(root)
    for chapter in [*chapters, *given]:
        source = root / "chapters" / chapter.name
        complete = [source / name for name in ("README.md", "reference.md", *chapter.complete)]
        pictures = [*source.glob("*.png"), *source.glob("*.gif")]
        _copy([*complete, *pictures], out / "chapters" / chapter.name)
    for chapter in chapters:
        folder = f"chapters/{chapter.name}"
        _copy([root / folder / "chapter.toml"], out / folder)
        for path, text in stubs.items():
            if path.startswith(folder + "/"):  # made anew: the files here may be somebody's work
                (out / path).write_text(text, encoding="utf-8", newline="\n")
                if path.endswith(".py"):
                    kept = out / KEPT / chapter.name / Path(path).name
                    kept.parent.mkdir(parents=True, exist_ok=True)
                    kept.write_text(text, encoding="utf-8", newline="\n")
        tests = root / "tests" / chapter.name
        _copy([*tests.glob("test_*.py"), *tests.glob("*probes.py")], out / "tests" / chapter.name)
    (out / KEPT / "README.md").write_text(KEPT_README, encoding="utf-8", newline="\n")
    for chapter in given:
        modules = (root / "solutions" / chapter.name).glob("*.py")
        _copy(modules, out / "chapters" / chapter.name)
    titles = ", ".join(chapter.title.lower() for chapter in chapters)
    example = chapters[0].exercises[0].id
    text = README.format(titles=titles, example=example)
    (out / "README.md").write_text(text, encoding="utf-8", newline="\n")
    print(f"as stubs: {', '.join(chapter.name for chapter in chapters)}")
    print(f"given complete: {', '.join(chapter.name for chapter in given) or 'none'}")
    there = [*chapters, *given]
    below = [other for chapter in chapters for other in chapters_below(chapter, root)]
    if missing := sorted({other.name for other in below if other not in there}):
        print(f"to be brought along by each student: {', '.join(missing)}")
    print(f"hand-out: {out}; try it: make -C {shlex.quote(str(out))} check")


def _copy_lab(root: Path, out: Path, chapters: Collection[str]) -> None:
    """Copy the lab, with the scenes of these chapters alone."""
    for file in (root / "lab").rglob("*"):
        numbered = re.match(r"ch\d\d_", file.name)
        wanted = not numbered or any(name.startswith(numbered[0]) for name in chapters)
        wanted = wanted and file.name != CHARTS
        if wanted and file.is_file() and "__pycache__" not in file.parts:
            _copy([file], out / file.parent.relative_to(root))


def _copy(files: Iterable[Path], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        if file.is_file():
            shutil.copyfile(file, folder / file.name)
