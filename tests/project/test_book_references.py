"""Every reference to the book in pages, code and messages names what book.toml lists."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import ROOT

BOOK: dict[str, Any] = tomllib.loads(
    Path(__file__).with_name("book.toml").read_text(encoding="utf-8")
)
SEARCHED = (
    *("*.md", "chapters/**/*.md", "solutions/**/*.md", "lab/**/*.md", "web/**/*.md"),
    *("chapters/ch*/*.py", "solutions/**/*.py", "lab/**/*.py", "studies/**/*.py"),
    *("autograder/**/*.py", "chapters/*/chapter.toml"),
    *("tests/ch*/*.py", "tests/ch*/*.toml", "tests/shared/*.py"),
)
FILES = {file for glob in SEARCHED for file in ROOT.glob(glob) if "node_modules" not in file.parts}

TWO, THREE = r"[2-9]\.\d+", r"[2-9]\.\d+\.\d+"
SECTION = rf"(?:{THREE}|{TWO})"
AND = r"(?:, and |, | and | to )"
SEVERAL = r"{0}(?:{1}{0})*(?![\d.]*\d)"  # as in "7.1, 7.2 and 7.4"
# What stands before a list of numbers, and the numbers.
SECTIONS = re.compile(
    rf"(?:\b[Bb]ook:? (?:[Ss]ections? )?|\b[Ss]ections? )({SEVERAL.format(SECTION, AND)})"
)
EQUATIONS = re.compile(rf"\bEqs?\. ({SEVERAL.format(TWO, AND)})")
TASK = re.compile(rf"\b([Ee]xercise|[Mm]ini-project|[Pp]roject)s? ({SEVERAL.format(TWO, AND)})")
# Three numbers always mean a section, even without a word before them.
BARE = re.compile(rf"(?<![\w.@=^-])({THREE})(?![\d.]*\d)")
COLUMN = re.compile(rf"(?m)^\| ((?:{SECTION}|Eq\. {TWO}|{AND})+) \|")
TABLE = "## From the book to the code"  # in a chapter's reference.md


def joined(text: str) -> str:
    """Return a text without the breaks of its lines, its strings and its comments."""
    text = re.sub(r"(?<=[ \w,.;:])[\"']\s*\n\s*f?[\"']", "", text)  # a string in several parts
    return re.sub(r"\s*\n\s*(?:# )?", " ", text)


def rows_of(text: str) -> list[str]:
    """Return what each row of the table from the book to the code names in its first column."""
    return COLUMN.findall(text.partition(TABLE)[2].partition("\n## ")[0])


def references(text: str, bare: bool = True) -> Iterator[tuple[str, str]]:
    """Yield the kind and number of each reference; ``bare`` if the text has no program versions."""
    flat = joined(text)
    found = [("section", each) for each in SECTIONS.findall(flat)]
    found += [("section", each) for each in BARE.findall(flat) if bare]
    found += [("section", EQUATIONS.sub("", row)) for row in rows_of(text)]
    found += [("equation", each) for each in EQUATIONS.findall(flat)]
    found += [(kind.lower(), each) for kind, each in TASK.findall(flat)]
    for kind, numbers in found:
        pattern = SECTION if kind == "section" else TWO
        yield from ((kind, number) for number in re.findall(pattern, numbers))


def numbered(prefix: str, count: int) -> set[str]:
    return {f"{prefix}.{i}" for i in range(1, count + 1)}


def sections() -> Iterator[str]:
    for chapter, counts in BOOK["sections"].items():
        yield from numbered(chapter, len(counts))
        for i, count in enumerate(counts, 1):
            yield from numbered(f"{chapter}.{i}", count)


SECTION_OF = {equation: of for of, found in BOOK["equations"].items() for equation in found}
TASKS = {
    kind: {number for each in counts.items() for number in numbered(*each)}
    for kind, counts in BOOK["counts"].items()
}
KNOWN = {
    "section": {*sections()},
    "equation": SECTION_OF.keys(),
    "exercise": TASKS["exercises"] | TASKS["mini-projects"],  # our manifests call both exercises
    "mini-project": TASKS["mini-projects"],
    "project": TASKS["projects"],
}


def unknown(text: str, bare: bool = True) -> list[str]:
    found = references(text, bare)
    return [f"{kind} {number}" for kind, number in found if number not in KNOWN[kind]]


def about_the_book(file: Path) -> bool:
    """Return whether three numbers in this file mean a section, and never a version."""
    about = {"chapters", "solutions", "tests", "claims.md", "errata.md", "glossary.md"}
    return not about.isdisjoint({file.relative_to(ROOT).parts[0], file.name})


def test_every_reference_names_what_the_book_has() -> None:
    assert len(FILES) > 200
    texts = {file: file.read_text(encoding="utf-8") for file in FILES}
    assert sum(len([*references(text)]) for text in texts.values()) > 400
    wrong = {str(file): unknown(text, about_the_book(file)) for file, text in texts.items()}
    assert {file: numbers for file, numbers in wrong.items() if numbers} == {}


def test_a_row_of_a_table_names_the_section_that_has_its_equation() -> None:
    rows = [
        (page.parent.name, row)
        for page in ROOT.glob("chapters/*/reference.md")
        for row in rows_of(page.read_text(encoding="utf-8"))
    ]
    assert len(rows) > 50
    for chapter, row in rows:
        sections = re.findall(SECTION, EQUATIONS.sub("", row))
        for number in re.findall(TWO, " ".join(EQUATIONS.findall(row))):
            found = any(same(section, SECTION_OF[number]) for section in sections)
            assert found, f"{chapter}: {row}"


def same(section: str, other: str) -> bool:
    """Return whether two sections are equal, or one contains the other."""
    return f"{section}.".startswith(f"{other}.") or f"{other}.".startswith(f"{section}.")


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("See Book 7.1.5 and\n    Eq. 7.7.", ["section 7.1.5", "equation 7.7"]),
        ("sections 3.1 to 3.6 of the book", ["section 3.6"]),
        ("(9.4.12, erratum E-12)", ["section 9.4.12"]),
        ('"book 2.1.10, and "\n    "Eq. "\n    "2.11"', ["section 2.1.10", "equation 2.11"]),
        (f"{TABLE}\n\n| 5.9, Eq. 5.2 | drag |\n", ["section 5.9", "equation 5.2"]),
        ("exercise 2.8 and mini-project 8.4", ["exercise 2.8", "mini-project 8.4"]),
        ("Book 7.1.3, Eq. 7.4. It takes 2.5 m/s, or 9.81 m/s^2.", []),
    ],
)
def test_a_wrong_number_is_found(text: str, wrong: list[str]) -> None:
    assert sorted({*unknown(text)}) == sorted(wrong)


def test_the_glossary_says_where_the_book_has_a_term() -> None:
    """A term that the book has is not marked as not covered."""
    text = " ".join((ROOT / "glossary.md").read_text(encoding="utf-8").split())
    entry = r"\*\*([^*]+)\*\*(?: \([^)]+\))?: [^*]+? Book: (.+?)\. Code:"
    said = dict(re.findall(entry, text))
    for term, places in BOOK["terms"].items():
        assert {*places} <= {*re.split(", ", said[term])}, term
        assert unknown(" ".join(f"section {place}" for place in places)) == []
