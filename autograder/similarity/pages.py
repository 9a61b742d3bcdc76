"""Write the web pages about similar code in a class: an index, and a page per pair of students."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from autograder.manifest import Chapter
from autograder.reports.pages import render
from autograder.reports.texts import replace_file
from autograder.similarity.code import covered
from autograder.similarity.compare import FEWEST, Comparison, Pair, Passage, Shared
from autograder.text.clean import clean

TEMPLATES = Path(__file__).parent / "templates"
FEWEST_ROWS = 30  # the index lists this many pairs, or more if more of them stand out
RARE = 0.1  # code is rare if at most this fraction of the class has it


@dataclass(frozen=True)
class Piece:
    """A piece of code. Its kind is "rare" if few students share it, "common" if many, or ""."""

    text: str
    kind: str


def write_pages(
    out: Path, comparison: Comparison, chapters: list[Chapter], small: list[str], notes: list[str]
) -> Path:
    """Write an index of the most similar pairs, and a page about each. Return the index's path."""
    shown = comparison.pairs[: max(FEWEST_ROWS, comparison.outstanding)]
    rows = [
        (f"pairs/pair-{number:03}.html", pair, comparison.shared(pair))
        for number, pair in enumerate(shown, start=1)
    ]
    # Delete the old index first. If this run is killed, it must not link to pages of other pairs.
    (out / "index.html").unlink(missing_ok=True)
    for old in (out / "pairs").glob("pair-*.html"):
        old.unlink()
    for name, pair, shared in rows:
        _write_pair(out / name, comparison, pair, shared)
    surprises = Counter(math.floor(p.surprise) for p in comparison.pairs if p.surprise is not None)
    bins = range(min(surprises), max(surprises) + 1) if surprises else ()
    values = {
        "rows": rows,
        "comparison": comparison,
        "line": comparison.line,
        "fewest": FEWEST,
        "chapters": chapters,
        "small": small,
        "notes": notes,
        "bins": [(surprise, surprises[surprise]) for surprise in bins],
    }
    replace_file(out / "index.html", render("similarity.html", TEMPLATES, **values))
    return out / "index.html"


def pieces_of(passage: Passage, kinds: Mapping[int, str]) -> list[Piece]:
    """Split a function into pieces to highlight. ``kinds`` has the kinds of tokens, by index."""
    lines = passage.lines
    first = passage.tokens[0].start[0]
    marks = [[""] * len(line) for line in lines]
    before = (0, 0, "")  # row, end and kind of the last mark
    for number, kind in sorted(kinds.items()):
        (top, left), (bottom, right) = passage.tokens[number].start, passage.tokens[number].end
        for row in range(top - first, bottom - first + 1):
            begin = left if row == top - first else 0
            end = right if row == bottom - first else len(lines[row])
            # Text between two marked tokens is marked too.
            begin = before[1] if before[::2] == (row, kind) else begin
            marks[row][begin:end] = [kind] * len(marks[row][begin:end])
            before = (row, end, kind)
    pieces = []
    indent = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
    for text, line in zip(lines, marks, strict=True):
        for kind, group in groupby(range(indent, len(text)), key=line.__getitem__):
            columns = [*group]
            pieces.append(Piece(clean(text[columns[0] : columns[-1] + 1]), kind))
        pieces.append(Piece("\n", ""))
    return pieces


def _write_pair(path: Path, comparison: Comparison, pair: Pair, shared: list[Shared]) -> None:
    few = max(2, RARE * comparison.students)
    parts = []
    for part in shared:
        rare = {f for f in part.fingerprints if comparison.holders[part.name, f] <= few}
        works = (pair.one, pair.other)
        parts.append((part, [_marked(w.parts[part.name].passages, part, rare) for w in works]))
    values = {"pair": pair, "comparison": comparison, "line": comparison.line, "parts": parts}
    replace_file(path, render("pair.html", TEMPLATES, few=math.floor(few), **values))


def _marked(
    passages: list[Passage], part: Shared, rare: set[int]
) -> list[tuple[Passage, list[Piece]]]:
    """Mark the shared code in a student's functions, and leave out those without any."""
    marked = []
    for passage in passages:
        kinds = dict.fromkeys(covered(passage.tokens, part.fingerprints), "common")
        if kinds := kinds | dict.fromkeys(covered(passage.tokens, rare), "rare"):
            marked.append((passage, pieces_of(passage, kinds)))
    return marked
