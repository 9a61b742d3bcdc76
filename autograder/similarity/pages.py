"""Write the web pages about similar code in a class: an index, and a page per pair of students.

A pair's page shows the code of both students side by side. Names and code are inserted as plain
text, and the pages load nothing from the internet.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from autograder.manifest import Chapter
from autograder.reports.pages import render
from autograder.reports.texts import replace_file
from autograder.similarity.compare import FEWEST, Comparison, Pair, Passage, Shared
from autograder.similarity.winnow import covered
from autograder.text.clean import clean

TEMPLATES = Path(__file__).parent / "templates"
FEWEST_ROWS = 30  # the index lists this many pairs, or more if more of them stand out
MOST_LINES = 200  # a page shows at most this many lines of one function
WIDEST = 500  # a page shows at most this many characters of one line
RARE = 0.1  # code is rare if at most this fraction of the class has it


@dataclass(frozen=True)
class Piece:
    """A piece of code. Its kind is "rare" if few students share it, "common" if many, or ""."""

    text: str
    kind: str


@dataclass(frozen=True)
class Side:
    """A student's function, with the line in the file at which its code begins."""

    name: str
    file: str
    line: int
    pieces: list[Piece]


def write_pages(
    out: Path, comparison: Comparison, chapters: list[Chapter], small: list[str], notes: list[str]
) -> Path:
    """Write an index of the most similar pairs, and a page about each of them.

    Return the path of the index.
    """
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
    page = render(
        "similarity.html",
        TEMPLATES,
        rows=rows,
        students=comparison.students,
        pairs=len(comparison.pairs),
        fewest=FEWEST,
        identical=len(comparison.identical),
        outstanding=comparison.outstanding,
        line=comparison.line,
        chapters=chapters,
        small=small,
        notes=[clean(note) for note in notes],
        bins=[(surprise, surprises[surprise]) for surprise in bins],
    )
    replace_file(out / "index.html", page)
    return out / "index.html"


def pieces_of(passage: Passage, kinds: dict[int, str]) -> list[Piece]:
    """Split a function into pieces to highlight. ``kinds`` has the kinds of tokens, by index."""
    first, last = passage.tokens[0].start[0], passage.tokens[-1].end[0]
    lines = passage.text.split("\n")[first - 1 : min(last, first - 1 + MOST_LINES)]
    marks = [[""] * len(line) for line in lines]
    previous: tuple[int, int, str] = (0, 0, "")
    for number, token in enumerate(passage.tokens):
        kind = kinds.get(number, "")
        for row in range(token.start[0], token.end[0] + 1):
            if not kind or row - first >= len(lines):
                continue
            begin = token.start[1] if row == token.start[0] else 0
            end = token.end[1] if row == token.end[0] else len(lines[row - first])
            if previous[0] == row and previous[2] == kind:
                begin = previous[1]  # text between two marked tokens is marked too
            line = marks[row - first]
            line[begin:end] = [kind] * len(line[begin:end])
            previous = (row, end, kind)
    pieces = []
    indent = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
    for text, line in zip(lines, marks, strict=True):
        kept = [*enumerate(line)][indent:WIDEST]
        for kind, group in groupby(kept, key=lambda item: item[1]):
            columns = [column for column, _ in group]
            pieces.append(Piece(clean(text[columns[0] : columns[-1] + 1]), kind))
        pieces.append(Piece(" ...\n" if len(text) > WIDEST else "\n", ""))
    if last - first >= MOST_LINES:
        pieces.append(Piece(f"... and {last - first + 1 - MOST_LINES} more lines\n", ""))
    return pieces


def _write_pair(path: Path, comparison: Comparison, pair: Pair, shared: list[Shared]) -> None:
    few = max(2, RARE * comparison.students)
    parts = []
    for part in shared:
        rare = {f for f in part.fingerprints if comparison.holders[part.name, f] <= few}
        works = (pair.one, pair.other)
        parts.append((part, [_sides(w.parts[part.name].passages, part, rare) for w in works]))
    page = render(
        "pair.html",
        TEMPLATES,
        pair=pair,
        line=comparison.line,
        parts=parts,
        students=comparison.students,
        few=math.floor(few),
    )
    replace_file(path, page)


def _sides(passages: list[Passage], part: Shared, rare: set[int]) -> list[Side]:
    """Mark the shared code in a student's functions, and leave out those without any."""
    sides = []
    for passage in passages:
        kinds = dict.fromkeys(covered(passage.tokens, part.fingerprints), "common")
        kinds |= dict.fromkeys(covered(passage.tokens, rare), "rare")
        if kinds:
            line = passage.tokens[0].start[0]
            name = clean(passage.name) or "outside of functions"
            sides.append(Side(name, passage.file, line, pieces_of(passage, kinds)))
    return sides
