"""Glossary and errata are complete and in order, and refer to existing code and tests."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters

CHAPTERS = load_chapters()
DOUBTFUL = [10, 25]  # the scan may have lost a mark, so these are only advice
NUMBERS = [n for n in range(1, 48) if n != 18]  # E-18 was withdrawn
NO_CODE = {"E-35", "E-39"}  # exercises that are missing from the book
WORDS = NO_CODE | {"E-43", "E-44", "E-45", "E-47"}  # names, units and references
SECTION = r"(?:chapter [2-9]|[2-9](?:\.\d+){1,2}|Eq\. [2-9]\.\d+|(?:exercise|project) [2-9]\.\d+)"
# term, its other names, explanation with symbol and unit, place in the book (or none) and in code
ENTRY = re.compile(
    r"\*\*(.+?)\*\*(?: \(([^)]+)\))?: ([A-Z\"].+?) "
    rf"Book: (not covered|{SECTION}(?:, {SECTION})*(?:, [^.]+)?)\. Code: (`.+)\."
)

NAMED = r"`([^`]+)`(?: \(`((?:going_further/)?\w+\.py)`\))?"  # a name, and the module it is in


def entries() -> list[str]:
    text = (ROOT / "glossary.md").read_text(encoding="utf-8")
    return [" ".join(entry.split()) for entry in text.split("\n\n")[2:]]  # title, introduction


def term(entry: str) -> str:
    return entry.split("**")[1]


def names(entry: str) -> list[str]:
    """Return the term of an entry, and the other names that follow it in parentheses."""
    parts = ENTRY.fullmatch(entry)
    assert parts, entry
    return [parts[1], *(parts[2].split(", ") if parts[2] else [])]


def test_an_entry_has_an_explanation_a_place_in_the_book_and_one_in_the_code() -> None:
    assert [fault for entry in entries() for fault in faults_of(entry)] == []


def faults_of(entry: str) -> Iterator[str]:
    """Yield what is wrong with an entry of the glossary."""
    parts = ENTRY.fullmatch(entry)
    if parts is None:
        yield f"not in the form of an entry: {entry}"
        return
    if not parts[3].endswith((".", ")")):
        yield f"{term(entry)}: not whole sentences"
    where = r"((?:`[^`]+`(?: \(`(?:going_further/)?\w+\.py`\))?(?:, )?)+), chapter (\d)(?:, and |$)"
    if re.sub(where, "", parts[5]):
        yield f"{term(entry)}: not in the form of places: {parts[5]}"
    for places, chapter in re.findall(where, parts[5]):
        waiting = []
        for name, module in re.findall(NAMED, places):
            waiting.append(name)
            if module or name.endswith(".py"):
                file = source(int(chapter), module or name)
                lost = [n for n in waiting if n != file.name and n not in defined(file)]
                yield from (f"{term(entry)}: {file.name} has no {n}" for n in lost)
                waiting = []
        yield from (f"{term(entry)}: {name} has no module" for name in waiting)


def source(chapter: int, module: str) -> Path:
    """Return a chapter's module, from the reference or from the complete ones in chapters/."""
    found = [
        path
        for folder in ("solutions", "chapters")
        for path in ROOT.glob(f"{folder}/ch{chapter:02d}_*/{module}")
    ]
    assert found, f"chapter {chapter} has no {module}"
    return found[0]


@cache
def defined(file: Path) -> set[str]:
    """Return the functions and classes of a module, and methods and attributes as Class.name."""
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
    terms = [term(entry) for entry in entries()]
    assert terms == sorted(set(terms), key=str.lower)
    known = [name for entry in entries() for name in names(entry)]
    assert len(known) == len({*known})
    used = {name for chapter in CHAPTERS for e in chapter.exercises for name in e.terms}
    assert used <= {*known}


def test_the_glossary_has_no_term_that_nobody_uses() -> None:
    """Each term appears in a chapter, or in the explanation of another term."""
    files = [
        path
        for folder in ("chapters", "solutions")
        for path in (ROOT / folder).rglob("*")
        if path.suffix in (".md", ".py", ".toml")
    ]
    text = " ".join(path.read_text(encoding="utf-8") for path in files).lower()
    words = " ".join(text.split())
    for entry in entries():
        others = " ".join(other.lower() for other in entries() if other != entry)
        used = any(name.lower() in words for name in names(entry))
        assert used or term(entry).lower() in others, term(entry)


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_a_chapter_links_to_the_glossary_and_to_the_errata(chapter: Chapter) -> None:
    folder = ROOT / "chapters" / chapter.name
    lesson, reference = (
        re.findall(r"\]\(([^)]+)\)", (folder / name).read_text(encoding="utf-8"))
        for name in ("README.md", "reference.md")
    )
    assert {"../../glossary.md", "reference.md"} <= {*lesson}
    assert {"../../glossary.md", "../../docs/errata.md", "README.md"} <= {*reference}


PRINTED_IN = r"(?:[Ss]ection [2-9](?:\.\d+){1,2}|Eq\. [2-9]\.\d+|Exercise [2-9]\.\d+)"
BEGIN = rf"### (E-\d+) \*\*.+?\.\*\* \*({PRINTED_IN}(?: and {PRINTED_IN})?)"
# number, section, evidence, text of the book (or of our copy), correct text, example, tests
ERRATUM = re.compile(
    rf"{BEGIN}\. "
    r"Evidence: ((?:listing|text|number|source|formula|doubtful)(?:, \w+)*)\.\* "
    r"- \*\*(In the book|In our copy):\*\* (\S.+?) "
    r"- \*\*Correct:\*\* (\S.+?) "
    r"- \*\*Example:\*\* (\S.+?)(?: - \*\*Test:\*\* (\S.+?))?(?: For [^:]+, see \[Check .+)?"
)


def errata() -> list[tuple[str, str]]:
    """Return each entry on one line, with the title of its part of the page."""
    text = (ROOT / "docs/errata.md").read_text(encoding="utf-8")
    parts = [part.partition("\n") for part in re.split(r"(?m)^## ", text)]
    return [
        (" ".join(("### " + entry).split()), title)
        for title, _, body in parts
        for entry in re.split(r"(?m)^### ", body)[1:]
        if entry.startswith("E-")
    ]


def number_and_section(entry: str) -> tuple[str, str]:
    found = re.match(BEGIN, entry)
    assert found, entry
    return found[1], found[2]


def test_the_errata_are_all_there_and_each_part_is_in_the_order_of_its_numbers() -> None:
    parts: dict[str, list[int]] = {}
    for entry, title in errata():
        parts.setdefault(title, []).append(int(number_and_section(entry)[0][2:]))
    assert [*parts] == ["The entries", "Check your own copy"]
    assert all(numbers == sorted(numbers) for numbers in parts.values())
    assert sorted(n for numbers in parts.values() for n in numbers) == NUMBERS
    assert parts["Check your own copy"] == DOUBTFUL


def test_every_erratum_that_is_named_exists() -> None:
    """For example, nothing refers to E-18, which was withdrawn."""
    known = {f"E-{number}" for number in NUMBERS}
    globs = ("glossary.md", "chapters/*/*", "solutions/*/*", "plots/*/*", "tests/ch*/*")
    files = [file for glob in globs for file in ROOT.glob(glob)]
    texts = {
        file.relative_to(ROOT).as_posix(): file.read_text(encoding="utf-8")
        for file in files
        if file.suffix in (".md", ".py", ".toml")
    }
    named = {file: {*re.findall(r"\bE-\d+\b", text)} for file, text in texts.items()}
    assert len(set().union(*named.values())) > 30
    assert {file: numbers - known for file, numbers in named.items() if numbers - known} == {}


def test_an_erratum_has_evidence_both_forms_what_tells_them_apart_and_its_tests() -> None:
    faults = {}
    for entry, part in errata():
        found = ERRATUM.fullmatch(entry)
        checked = parts_of(found, part == "The entries") if found else [("its form", False)]
        wrong = [what for what, right in checked if not right]
        faults |= {number_and_section(entry)[0]: wrong} if wrong else {}
    assert faults == {}


def parts_of(erratum: re.Match[str], certain: bool) -> Iterator[tuple[str, bool]]:
    """Yield what an erratum must have, and whether it has it."""
    number, _, evidence, label, *_, example, shown = erratum.groups()
    yield "its copy", label == ("In the book" if certain else "In our copy")
    kinds = evidence.split(", ")
    yield "kinds", {*kinds} <= {"listing", "text", "number", "source", "formula", "doubtful"}
    yield "its part of the page", ("doubtful" in kinds) is not certain
    yield "more than a formula, since a scan may lose its small marks", kinds != ["formula"]
    yield "a number in its example", bool(re.search(r"\d", example)) or number in NO_CODE
    named = f"test_{number.lower().replace('-', '')}"
    linked = re.findall(r"\[(\w+)\]\(([^)]+)\)", shown or "")
    there = {path for path, text in reference_tests().items() if f"\ndef {named}_" in text}
    yield "a link to each test that shows it", {path for _, path in linked} == there
    yield "the names of its tests", {name for name, _ in linked} == ({named} if there else set())
    yield "a test", bool(there) is (number not in WORDS)


@cache
def reference_tests() -> dict[str, str]:
    """Return the text of each test of the reference, by its link in the errata."""
    files = (ROOT / "tests/reference").rglob("*.py")
    return {
        f"../{file.relative_to(ROOT).as_posix()}": file.read_text(encoding="utf-8")
        for file in files
    }


def test_the_index_by_chapter_has_each_erratum_once_under_its_chapter() -> None:
    text = (ROOT / "docs/errata.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| ([2-9]) \| (.+) \|$", text)
    index = {number: chapter for chapter, row in rows for number in re.findall(r"\[(E-\d+)\]", row)}
    assert all(f"](#{number.lower()})" in text for number in index)
    sections = dict(number_and_section(entry) for entry, _ in errata())
    assert index == {number: re.findall(r"[2-9]", of)[0] for number, of in sections.items()}


def test_each_reference_names_the_errata_of_its_chapter() -> None:
    """Doubtful errata need not be named: they are advice, and may not be mistakes at all."""
    for chapter in CHAPTERS:
        page = (ROOT / "chapters" / chapter.name / "reference.md").read_text(encoding="utf-8")
        listed = page.partition("## Where the printed book is wrong")[2]
        first = rf"[^\d]*{chapter.number}\."  # of the section
        certain = [number_and_section(e) for e, part in errata() if part == "The entries"]
        own = {number for number, section in certain if re.match(first, section)}
        assert own <= set(re.findall(r"E-\d+", listed)), chapter.name
