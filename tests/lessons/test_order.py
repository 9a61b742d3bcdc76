"""A lesson lets students run an experiment only after the exercises that make it work."""

from __future__ import annotations

import re

import pytest

from autograder.manifest import Chapter, load_chapters
from lessons.lesson import lab_commands, lesson_of

CHAPTERS = load_chapters()
MAKERS = {scene: e.id for chapter in CHAPTERS for e in chapter.exercises for scene in e.play}


@pytest.mark.parametrize("chapter", CHAPTERS, ids=[chapter.name for chapter in CHAPTERS])
def test_an_experiment_comes_after_the_exercise_that_makes_it_run(chapter: Chapter) -> None:
    text = lesson_of(chapter.name)
    turns = {m[1]: m.start() for m in re.finditer(r"(?m)^make check EX=(\S+)", text)}
    early = []
    for experiment in re.finditer(r"(?m)^> \*\*Experiment.*\n(?:>.*\n)*", text):
        for scene, _ in lab_commands(experiment[0]):
            maker = MAKERS.get(scene, "")  # a scene of given code has none
            if turns.get(maker, 0) > experiment.start():
                early.append(f"{scene} needs {maker}")
    assert early == []
