"""Glossary and errata are complete, in order, and lead to code and tests that are there."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters

CHAPTERS = load_chapters()
SECTION = r"(?:chapter [2-9]|[2-9](?:\.\d+){1,2}|Eq\. [2-9]\.\d+|(?:exercise|project) [2-9]\.\d+)"
# term, explanation with symbol and unit, place in the book or none, places in the code
ENTRY = re.compile(
    r"\*\*(.+?)\*\*: (\S.+?) "
    rf"(Not in the book|Book: {SECTION}(?:, {SECTION})*(?:, [^.]+)?)\. In (`.+)\."
)


def entries() -> list[str]:
    text = (ROOT / "glossary.md").read_text(encoding="utf-8")
    return [" ".join(entry.split()) for entry in text.split("\n\n")[2:]]  # title, introduction


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.split("**")[1])
def test_an_entry_has_an_explanation_a_place_in_the_book_and_one_in_the_code(entry: str) -> None:
    parts = ENTRY.fullmatch(entry)
    assert parts, entry
    where = r"((?:`[^`]+`(?: \(`\w+\.py`\))?(?:, )?)+), chapter (\d)(?:, and |$)"
    places = re.findall(where, parts[4])
    assert re.sub(where, "", parts[4]) == ""
    for names, chapter in places:
        waiting = []
        for name, module in re.findall(r"`([^`]+)`(?: \(`(\w+\.py)`\))?", names):
            waiting.append(name)
            if module or name.endswith(".py"):
                file = source(int(chapter), module or name)
                assert [n for n in waiting if n != file.name and n not in defined(file)] == []
                waiting = []
        assert waiting == [], "a name without a module"


def source(chapter: int, module: str) -> Path:
    """Return a chapter's module: the reference's, or the one that is complete in chapters/."""
    found = [
        path
        for folder in ("solutions", "chapters")
        for path in ROOT.glob(f"{folder}/ch{chapter:02d}_*/{module}")
    ]
    assert found, f"chapter {chapter} has no {module}"
    return found[0]


@cache
def defined(file: Path) -> set[str]:
    """Return the functions and classes of a module, and Class.name for methods and attributes."""
    names = set()
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            names.add(node.name)
        if isinstance(node, ast.ClassDef):
            for inner in ast.walk(node):
                if isinstance(inner, ast.FunctionDef):
                    names.add(f"{node.name}.{inner.name}")
                elif isinstance(inner, ast.Attribute) and isinstance(inner.ctx, ast.Store):
                    names.add(f"{node.name}.{inner.attr}")
    return names


def test_the_glossary_has_every_term_of_the_manifests_once_and_in_order() -> None:
    terms = [entry.split("**")[1] for entry in entries()]
    assert terms == sorted(set(terms), key=str.lower)
    assert {term for chapter in CHAPTERS for e in chapter.exercises for term in e.terms} <= {*terms}


def test_the_glossary_has_no_term_that_the_chapters_do_not_use() -> None:
    files = [
        path
        for folder in ("chapters", "solutions")
        for path in (ROOT / folder).rglob("*")
        if path.suffix in (".md", ".py", ".toml")
    ]
    text = " ".join(path.read_text(encoding="utf-8") for path in files).lower()
    words = " ".join(text.split())
    assert [e for e in entries() if e.split("**")[1].lower() not in words] == []


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_a_readme_links_to_the_glossary_and_to_the_errata(chapter: Chapter) -> None:
    readme = ROOT / "chapters" / chapter.name / "README.md"
    links = re.findall(r"\]\(([^)]+)\)", readme.read_text(encoding="utf-8"))
    assert {"../../glossary.md", "../../errata.md"} <= {*links}


def errata() -> list[list[str]]:
    """Return the rows of the table: number, section, printed, right, what tells apart, tests."""
    text = (ROOT / "errata.md").read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("| E-")]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]] for row in rows]


def test_the_errata_are_all_there_in_the_order_of_their_numbers() -> None:
    assert [row[0] for row in errata()] == [f"E-{i}" for i in range(1, 37)]


@pytest.mark.parametrize("row", errata(), ids=lambda row: row[0])
def test_an_erratum_has_a_section_both_forms_what_tells_them_apart_and_its_tests(
    row: list[str],
) -> None:
    number, section, printed, right, difference, shown = row
    assert re.fullmatch(rf"{SECTION}(?:, {SECTION})*", section)
    assert printed
    assert right
    assert re.search(r"\d", difference) or number == "E-35", "a number tells them apart"
    named = f"test_{number.lower().replace('-', '')}"
    linked = re.findall(r"\[(\w+)\]\(([^)]+)\)", shown)
    there = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "tests/reference").glob("*.py")
        if re.search(rf"(?m)^def {named}_", path.read_text(encoding="utf-8"))
    }
    assert {path for _, path in linked} == there, "each test that shows it is linked"
    assert {name for name, _ in linked} == ({named} if there else set())
    assert there or number == "E-35", "all but a promise can run"


def test_each_readme_names_the_errata_of_its_chapter() -> None:
    for chapter in CHAPTERS:
        readme = (ROOT / "chapters" / chapter.name / "README.md").read_text(encoding="utf-8")
        told = readme.partition("## Where the printed book is wrong")[2]
        first = rf"[^\d]*{chapter.number}\."  # of the section
        own = {number for number, section, *_ in errata() if re.match(first, section)}
        assert own <= set(re.findall(r"E-\d+", told)), chapter.name
