"""Write the tables of exercises from the chapters' manifests, and makefiles from the commands."""

from __future__ import annotations

from pathlib import Path

from autograder.definitions import own_name
from autograder.files import replace_bytes
from autograder.manifest import Chapter, Exercise
from autograder.options import makefile
from autograder.text.marked import with_text

BEGIN = "<!-- exercises: `make update` writes this table from chapter.toml -->"
END = "<!-- end of exercises -->"


def exercise_table(chapter: Chapter) -> str:
    """Build the Markdown table of a chapter's exercises, with stars, points and functions."""
    rows = ["| no. | exercise | kind | stars | points | you write | builds on |"]
    rows.append("|---|---|---|---|---|---|---|")
    for exercise in chapter.exercises:
        places = "; ".join(_places(exercise, chapter)) or "`answers.md`"
        stars, needs = "\\*" * exercise.stars, ", ".join(exercise.needs)
        extra = " (extra credit)" if exercise.extra else ""
        points = "optional" if exercise.optional else f"{exercise.points}{extra}"
        rows.append(
            f"| {exercise.id} | {exercise.title} | {exercise.kind} | {stars} | {points} "
            f"| {places} | {needs} |"
        )
    return "\n".join(rows)


def _places(exercise: Exercise, chapter: Chapter) -> list[str]:
    """List what a student writes by file, as in "`vector.py`: `dot`, `cross`"."""
    files: dict[str, list[str]] = {}
    edited = [name.partition(".") for other in chapter.exercises for name in other.edit]
    for name in exercise.edit:
        module, _, inside = name.partition(".")
        own = own_name(name)
        alike = [n for other, _, n in edited if other == module and n.rpartition(".")[2] == own]
        files.setdefault(module, []).append(f"`{inside if len(alike) > 1 else own}`")
    written = [f"`{module}.py`: {', '.join(names)}" for module, names in files.items()]
    return [*written, *(f"`{name}`: your data" for name in exercise.files)]


def with_table(page: str, chapter: Chapter) -> str:
    """Return the text of a chapter's reference.md with an updated table of exercises."""
    try:
        return with_text(page, BEGIN, END, exercise_table(chapter))
    except ValueError as error:
        raise ValueError(f"reference.md of {chapter.name}: {error}") from error


def write_tables(chapters: list[Chapter], root: Path) -> list[str]:
    """Update the table in each reference.md, and the makefiles. List the files that changed."""
    texts = {f"autograder/{table}.mk": makefile(table) for table in ("commands", "instructor")}
    for chapter in chapters:
        name = f"chapters/{chapter.name}/reference.md"
        texts[name] = with_table((root / name).read_text(encoding="utf-8"), chapter)
    changed = [name for name, text in texts.items() if text.encode() != (root / name).read_bytes()]
    for name in changed:
        replace_bytes(root / name, texts[name].encode())
    return changed
