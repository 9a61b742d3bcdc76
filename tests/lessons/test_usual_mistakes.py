"""Each usual mistake that a lesson names is named by a check, too, to the student who makes it."""

from __future__ import annotations

import re

import pytest

from autograder.manifest import Chapter, load_chapters
from lessons.lesson import lesson_of
from lessons.test_demands import plain
from wrong import read_wrong

CHAPTERS = load_chapters()


def usual_mistakes(chapter: Chapter) -> list[str]:
    """Return the paragraphs of a lesson that name usual mistakes."""
    paragraphs = re.findall(r"(?ms)^\*\*The usual mistakes?\b.+?(?=\n\n)", lesson_of(chapter.name))
    return [plain(paragraph) for paragraph in paragraphs]


@pytest.mark.parametrize("chapter", CHAPTERS, ids=[chapter.name for chapter in CHAPTERS])
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
