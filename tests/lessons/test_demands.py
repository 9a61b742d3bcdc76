"""Each check quotes the words that demand it, and each usual mistake is named by one."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters
from lessons.lesson import lesson_of
from wrong import read_wrong

CHAPTERS = load_chapters()
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)
SHORTEST = 3  # words; fewer could be found anywhere


def plain(text: str) -> str:
    """Return a text in one line, without the marks of Markdown and the targets of its links."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return " ".join(re.sub(r"[`*$]", "", text).split())


def said_in(chapter: Chapter) -> str:
    """Return the lesson of a chapter, and the docstrings of the modules that students get."""
    texts = [lesson_of(chapter.name)]
    for file in sorted((ROOT / "chapters" / chapter.name).glob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
                texts.append(ast.get_docstring(node) or "")
    return "\n".join(map(plain, texts))


SAID = {chapter.number: said_in(chapter) for chapter in CHAPTERS}


def asked_in(chapter: Chapter) -> Iterator[tuple[str, list[str]]]:
    """Yield each graded check of a chapter, and the words that it quotes."""
    for file in sorted((ROOT / "tests" / chapter.name).glob("test_*.py")):
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
                marks = [mark for mark in node.decorator_list if isinstance(mark, ast.Call)]
                keywords = [word for mark in marks for word in mark.keywords if word.arg == "asks"]
                yield f"{file.name}::{node.name}", [ast.literal_eval(w.value) for w in keywords]


@by_chapter
def test_each_check_quotes_the_course(chapter: Chapter) -> None:
    """A chapter may demand again what an earlier one has demanded."""
    said = [text for number, text in SAID.items() if number <= chapter.number]
    missing = []
    for check, quoted in asked_in(chapter):
        found = [q for q in quoted if any(plain(q) in text for text in said)]
        if not (quoted and found == quoted and all(len(q.split()) >= SHORTEST for q in quoted)):
            missing.append(f"{check}: {quoted}")
    assert not missing, "not in a lesson or docstring so far:\n" + "\n".join(missing)


def usual_mistakes(chapter: Chapter) -> list[str]:
    """Return the paragraphs of a lesson that name usual mistakes."""
    paragraphs = re.findall(r"(?ms)^\*\*The usual mistakes?\b.+?(?=\n\n)", lesson_of(chapter.name))
    return [plain(paragraph) for paragraph in paragraphs]


@by_chapter
def test_each_usual_mistake_has_a_wrong_submission_that_is_named(chapter: Chapter) -> None:
    """A wrong submission quotes the lesson in ``usual``, and the message in ``says``."""
    wrongs = [wrong for wrong in read_wrong(chapter) if wrong.usual]
    paragraphs = usual_mistakes(chapter)
    lost = [
        wrong.mistake for wrong in wrongs if not any(plain(wrong.usual) in p for p in paragraphs)
    ]
    assert not lost, "not in a paragraph of usual mistakes"
    assert not [wrong.mistake for wrong in wrongs if not wrong.says], "must be named"
    for paragraph in paragraphs:
        mistakes = 1 + len(re.findall(r"[Aa]nother|The usual mistakes\.", paragraph))
        quoted = {wrong.usual for wrong in wrongs if plain(wrong.usual) in paragraph}
        assert len(quoted) >= mistakes, paragraph
