"""Manifests, checks, imports and READMEs are consistent with each other."""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import pytest

from autograder.answers import questions_of
from autograder.manifest import ROOT, Chapter, load_chapter, load_chapters
from lab.catalog import entries

CHAPTERS = load_chapters()
BELOW = {  # the chapters that a chapter's modules may import
    2: set(),
    3: {2},
    4: {2, 3},
    5: {2, 3},
    6: {2, 3, 5},
    7: {2, 3, 5},
    8: {2, 3, 5, 6, 7},
    9: {2},
}
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
ALL_CHAPTERS = {chapter.name for chapter in CHAPTERS}


def python_files(*folders: str) -> list[Path]:
    files = [path for folder in folders for path in sorted((ROOT / folder).rglob("*.py"))]
    return [file for file in files if "hostile" not in file.parts]  # hostile files follow no rules


SHARED = [path.stem for path in python_files("tests/shared")]
HELPERS = [path.stem for path in python_files("tests/helpers")]


def imported(path: Path) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module.split(".")[0])
    return names


def faults(files: Iterable[Path], fault: Callable[[Path], object]) -> dict[str, object]:
    found = {file.relative_to(ROOT).as_posix(): fault(file) for file in files}
    return {file: wrong for file, wrong in found.items() if wrong}


@by_chapter
def test_a_chapter_imports_only_chapters_below_it_and_the_standard_library(
    chapter: Chapter,
) -> None:
    allowed = {name for name in ALL_CHAPTERS if int(name[2:4]) in BELOW[chapter.number]}
    allowed |= {chapter.name, *sys.stdlib_module_names}
    files = python_files(f"chapters/{chapter.name}", f"solutions/{chapter.name}")
    assert faults(files, lambda file: imported(file) - allowed) == {}


@by_chapter
def test_a_chapters_checks_import_no_later_chapter_and_nothing_heavy(chapter: Chapter) -> None:
    """Handouts have the checks, but not the helpers."""
    unwanted = {*HELPERS, "hypothesis", "scipy", "pymunk", "numpy", "autograder"}
    unwanted |= {name for name in ALL_CHAPTERS if int(name[2:4]) not in BELOW[chapter.number]}
    unwanted -= {chapter.name}
    files = python_files(f"tests/{chapter.name}")
    assert faults(files, lambda file: imported(file) & unwanted) == {}


@pytest.mark.parametrize(
    "folder",
    [
        *("autograder", "chapters", "plots", "sample_class", "scenes"),
        *("solutions", "studies", "tests", "web"),
    ],
)
def test_no_module_is_too_long_to_be_read_at_once(folder: str) -> None:
    most = 400 if folder == "tests" else 300
    files = [f for f in (ROOT / folder).rglob("*.*") if f.suffix in (".py", ".js", ".mjs")]
    files = [file for file in files if "node_modules" not in file.parts]
    lengths = {file: len(file.read_text(encoding="utf-8").splitlines()) for file in files}
    assert {file: length for file, length in lengths.items() if length > most} == {}


def test_the_readme_of_the_tests_has_a_line_for_each_helper() -> None:
    text = (ROOT / "tests/README.md").read_text(encoding="utf-8")
    listed = re.findall(r"(?m)^\| `(\w+)\.py` \| \w+", text)
    assert sorted(listed) == sorted([*SHARED, *HELPERS])


def test_the_tools_import_no_tests_and_the_autograder_no_chapter() -> None:
    tests = {"tests", *SHARED, *HELPERS}
    tools = python_files("autograder", "lab", "plots", "scenes", "studies", "web")
    assert faults(tools, lambda file: imported(file) & tests) == {}
    autograder = python_files("autograder")
    assert faults(autograder, lambda file: imported(file) & ALL_CHAPTERS) == {}


@by_chapter
def test_every_exercise_has_checks_hints_and_a_docstring_or_a_question(chapter: Chapter) -> None:
    names = [
        node.name
        for path in (ROOT / "tests" / chapter.name).glob("test_*.py")
        for node in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    ]
    assert len(names) == len(set(names)), "two checks have one name"
    written = {q.exercise.id for q in questions_of(chapter, [ROOT / "solutions"]) if q.answered}
    for exercise in chapter.exercises:
        assert all(hint.strip() for hint in exercise.hints)
        assert exercise.hints, f"{exercise.id} has no hint"
        if exercise.kind == "written":
            assert exercise.id in written
        else:
            assert exercise.edit


@by_chapter
def test_every_chapter_has_a_picture_and_its_scenes(chapter: Chapter) -> None:
    plots = importlib.import_module(f"plots.{chapter.name}").PLOTS
    assert chapter.picture in [plot.__name__.lower() for plot in plots]
    played = [name for exercise in chapter.exercises for name in exercise.play]
    scenes = [scene.name for scene in entries() if scene.chapter == chapter.number]
    assert sorted(played) == sorted({*scenes} - {"charts"})


PAGES = [*ROOT.glob("*.md"), *ROOT.glob("chapters/**/*.md"), *ROOT.glob("*/*.md")]


def anchors(page: Path) -> set[str]:
    """Return the anchors that GitHub gives the headings of a page."""
    headings = re.findall(r"(?m)^#+ (.+)$", page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-") for heading in headings}


def test_links_between_pages_lead_somewhere() -> None:
    def dead(page: Path) -> Iterator[str]:
        for link in re.findall(r"\]\(([^):\s]+)\)", page.read_text(encoding="utf-8")):
            path, _, anchor = link.partition("#")
            target = page.parent / path if path else page
            if not target.exists() or (anchor and anchor not in anchors(target)):
                yield link

    assert faults(PAGES, lambda page: [*dead(page)]) == {}


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (('kind = "build"', 'kind = "game"'), "kind must be one of build, "),
        (("stars = 1", "stars = 4"), "stars must be 1, 2 or 3, got 4"),
        (("points = 2", 'points = "2"'), "points must be a positive number, got '2'"),
        (("points = 2", "points = 0"), "points must be a positive number, got 0"),
        (("needs = []", "needs = []\nchart = ['cost']"), "names of the cost and the error, got ['"),
        (('id = "B2.2"', 'id = "B2.1"'), "exercise B2.1 is listed twice"),
        (("needs = []", 'needs = ["2.7"]'), "B2.1 needs 2.7, which does not precede it"),
        (("needs = []", "need = []"), "unknown key 'need'"),
        (('title = "Length"\n', ""), "'title' is missing"),
        (("[[exercise]]", "[[exercise"), "chapter.toml"),
        (('title = "Vectors"\n', ""), "'title' is missing"),
        (('picture = "cross_product"', "picture = 3"), "picture must be a string, got 3"),
        (("you_can = [", "you_can = [2, "), "you_can must be a list of strings, got [2, "),
    ],
)
def test_a_manifest_that_is_wrong_is_refused(
    change: tuple[str, str], complaint: str, tmp_path: Path
) -> None:
    text = (ROOT / "chapters/ch02_vectors/chapter.toml").read_text(encoding="utf-8")
    assert change[0] in text
    folder = tmp_path / "ch02_vectors"
    folder.mkdir()
    (folder / "chapter.toml").write_text(text.replace(*change, 1), encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(complaint)):
        load_chapter(folder)
