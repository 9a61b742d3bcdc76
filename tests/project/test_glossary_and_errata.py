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
# Exercises that are missing from the book, and mistakes in names, units and references.
WITHOUT_TESTS = {"E-35", "E-39", "E-43", "E-44", "E-45", "E-47"}
SECTION = r"(?:chapter [2-9]|[2-9](?:\.\d+){1,2}|Eq\. [2-9]\.\d+|(?:exercise|project) [2-9]\.\d+)"
# term, its other names, explanation with symbol and unit, place in the book (or none) and in code
ENTRY = re.compile(
    r"\*\*(.+?)\*\*(?: \(([^)]+)\))?: ([A-Z\"].+?[.)]) "
    rf"Book: (?:not covered|{SECTION}(?:, {SECTION})*(?:, [^.]+)?)\. Code: (`.+)\."
)
NAMED = r"`([^`]+)`(?: \(`((?:going_further/)?\w+\.py)`\))?"  # a name, and the module it is in
# Names with a module after one or more of them, and their chapter.
CODE = r"((?:`[^`]+`(?: \(`(?:going_further/)?\w+\.py`\))?(?:, )?)+), chapter (\d)(?:, and |$)"


def entries() -> Iterator[tuple[list[str], str, str]]:
    """Yield the names, the whole text and the places in the code of each entry of the glossary."""
    text = (ROOT / "glossary.md").read_text(encoding="utf-8")
    for entry in text.split("\n\n")[2:]:  # after the title and the introduction
        one = " ".join(entry.split())
        parts = ENTRY.fullmatch(one)
        assert parts, f"not in the form of an entry: {one}"
        yield [parts[1], *(parts[2].split(", ") if parts[2] else [])], one, parts[4]


GLOSSARY = [*entries()]


@pytest.mark.parametrize("code", [pytest.param(code, id=names[0]) for names, _, code in GLOSSARY])
def test_an_entry_names_code_that_is_there(code: str) -> None:
    assert re.sub(CODE, "", code) == ""
    for places, chapter in re.findall(CODE, code):
        waiting = []  # for the module that follows them
        for name, module in re.findall(NAMED, places):
            waiting.append(name)
            if module or name.endswith(".py"):
                file = source(int(chapter), module or name)
                assert {*waiting} <= {file.name, *defined(file)}
                waiting = []
        assert waiting == []


def source(chapter: int, module: str) -> Path:
    """Return a chapter's module, from the reference or from the complete ones in chapters/."""
    return next(
        path
        for folder in ("solutions", "chapters")
        for path in ROOT.glob(f"{folder}/ch{chapter:02d}_*/{module}")
    )


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
    terms = [names[0] for names, _, _ in GLOSSARY]
    assert terms == sorted({*terms}, key=str.lower)
    known = [name for names, _, _ in GLOSSARY for name in names]
    assert len(known) == len({*known})
    assert {name for chapter in CHAPTERS for e in chapter.exercises for name in e.terms} <= {*known}


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
def test_a_chapter_links_to_the_glossary_and_names_its_errata(chapter: Chapter) -> None:
    """Doubtful errata need not be named: they are advice, and may not be mistakes at all."""
    folder = ROOT / "chapters" / chapter.name
    lesson, reference = (
        (folder / name).read_text(encoding="utf-8") for name in ("README.md", "reference.md")
    )
    assert {"../../glossary.md", "reference.md"} <= {*re.findall(r"\]\(([^)]+)\)", lesson)}
    needed = {"../../glossary.md", "../../docs/errata.md", "README.md"}
    assert needed <= {*re.findall(r"\]\(([^)]+)\)", reference)}
    listed = reference.partition("## Where the printed book is wrong")[2]
    own = {n for n, (of, part, _) in ERRATA.items() if of == chapter.number and part == PARTS[0]}
    assert own <= {*re.findall(r"E-\d+", listed)}


PARTS = ["The entries", "Check your own copy"]
PRINTED_IN = r"(?:[Ss]ection [2-9](?:\.\d+){1,2}|Eq\. [2-9]\.\d+|Exercise [2-9]\.\d+)"
# number, first place in the book, evidence, label of the book's text, correct text, example, tests
ERRATUM = re.compile(
    rf"(E-\d+) \*\*.+?\.\*\* \*({PRINTED_IN})(?: and {PRINTED_IN})?\. "
    r"Evidence: ((?:listing|text|number|source|formula|doubtful)(?:, \w+)*)\.\* "
    r"- \*\*(In the book|In our copy):\*\* \S.+? "
    r"- \*\*Correct:\*\* \S.+? "
    r"- \*\*Example:\*\* \S.+?(?: - \*\*Test:\*\* (\S.+?))?(?: For [^:]+, see \[Check .+)?"
)


def errata() -> Iterator[tuple[str, tuple[int, str, str]]]:
    """Yield each erratum's number, with its chapter, its part of the page and its tests."""
    text = (ROOT / "docs/errata.md").read_text(encoding="utf-8")
    for part in re.split(r"(?m)^## ", text):
        title, _, body = part.partition("\n")
        for entry in re.split(r"(?m)^### (?=E-)", body)[1:]:
            found = ERRATUM.fullmatch(" ".join(entry.split()))
            assert found, entry
            number, place, evidence, label, tests = found.groups()
            assert (label == "In the book") == (title == PARTS[0]) == ("doubtful" not in evidence)
            assert evidence != "formula", "a scan may lose its small marks"
            yield number, (int(re.findall(r"[2-9]", place)[0]), title, tests or "")


ERRATA = dict(errata())


def test_the_errata_are_all_there_and_each_part_is_in_the_order_of_its_numbers() -> None:
    parts: dict[str, list[int]] = {}
    for number, (_, title, _) in ERRATA.items():
        parts.setdefault(title, []).append(int(number[2:]))
    assert [*parts] == PARTS
    assert all(numbers == sorted(numbers) for numbers in parts.values())
    assert sorted(n for numbers in parts.values() for n in numbers) == NUMBERS
    assert parts[PARTS[1]] == DOUBTFUL


def test_every_erratum_that_is_named_exists() -> None:
    """For example, nothing refers to E-18, which was withdrawn."""
    globs = ("glossary.md", "chapters/*/*.*", "solutions/*/*.*", "plots/*/*.py", "tests/ch*/*.*")
    files = [file for glob in globs for file in ROOT.glob(glob)]
    texts = {f: f.read_text(encoding="utf-8") for f in files if f.suffix in (".md", ".py", ".toml")}
    named = {file: {*re.findall(r"\bE-\d+\b", text)} for file, text in texts.items()}
    assert len(set().union(*named.values())) > 30
    assert {file: numbers for file, numbers in named.items() if numbers - ERRATA.keys()} == {}


def test_an_erratum_links_to_each_test_that_shows_it() -> None:
    files = (ROOT / "tests/reference").rglob("*.py")
    texts = {f"../{f.relative_to(ROOT).as_posix()}": f.read_text(encoding="utf-8") for f in files}
    for number, (_, _, shown) in ERRATA.items():
        name = f"test_{number.lower().replace('-', '')}"
        showing = {(name, path) for path, text in texts.items() if f"\ndef {name}_" in text}
        assert {*re.findall(r"\[(\w+)\]\(([^)]+)\)", shown)} == showing, number
        assert bool(showing) is (number not in WITHOUT_TESTS), number


def test_the_index_by_chapter_has_each_erratum_once_under_its_chapter() -> None:
    text = (ROOT / "docs/errata.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| ([2-9]) \| (.+) \|$", text)
    index = {number: int(of) for of, row in rows for number in re.findall(r"\[(E-\d+)\]", row)}
    assert index == {number: of for number, (of, _, _) in ERRATA.items()}
    assert all(f"](#{number.lower()})" in text for number in index)
