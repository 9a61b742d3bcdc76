"""Each lesson is complete, and all of its numbers, commands and links are correct."""

from __future__ import annotations

import importlib
import re

import pytest

from autograder.manifest import Chapter, load_chapters
from lab.catalog import find, load
from lessons.lesson import (
    agrees,
    lab_commands,
    lesson_of,
    numbers_in,
    sections_of,
    turns_of,
)
from scenes.parameters import Parameter

CHAPTERS = load_chapters()
MAKERS = {scene: e.id for chapter in CHAPTERS for e in chapter.exercises for scene in e.play}
by_chapter = pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda chapter: chapter.name)


@by_chapter
def test_each_exercise_has_its_turn_a_command_and_a_time(chapter: Chapter) -> None:
    text = lesson_of(chapter.name)
    turns = turns_of(text)
    assert turns
    commands = "\n".join(block for _, _, block in turns)
    told = " ".join(words for _, words, _ in turns)
    for exercise in chapter.exercises:
        assert re.search(rf"(?m)^make check EX={re.escape(exercise.id)}\b(?! *\.)", commands)
        assert re.search(rf"(?<![\w.]){re.escape(exercise.id)}(?![\w])", told), exercise.id
    hours = re.search(r"\*\*Time:\*\* about (\d+) hours", text)
    assert hours
    reading = 1.3  # hours, an estimate
    total = sum(int(minutes) for minutes, _, _ in turns) / 60 + reading
    assert abs(int(hours[1]) - total) <= 0.6, total


@by_chapter
def test_an_experiment_is_a_scene_that_takes_its_settings_and_that_earlier_exercises_make_run(
    chapter: Chapter,
) -> None:
    text = lesson_of(chapter.name)
    turns = {turn[1]: turn.start() for turn in re.finditer(r"(?m)^make check EX=(\S+)", text)}
    for experiment in re.finditer(r"(?m)^> \*\*Experiment.*\n(?:>.*\n)*", text):
        assert lab_commands(experiment[0]), experiment[0]
        for scene, _ in lab_commands(experiment[0]):
            maker = MAKERS.get(scene, "")  # a scene of given code has none
            assert turns.get(maker, 0) < experiment.start(), f"{scene} needs {maker}"
    for name, settings in lab_commands(text):
        assert find(name).chapter <= chapter.number
        for key, value in settings.items():
            parameter = getattr(load(name), key)
            assert isinstance(parameter, Parameter)
            parameter.checked(value)


@by_chapter
def test_every_number_of_a_lesson_is_given_or_computed(chapter: Chapter) -> None:
    """A section must declare each of its numbers as given, or compute it with the reference."""
    sections = sections_of(lesson_of(chapter.name))
    facts = importlib.import_module(f"lessons.{chapter.name[:4]}_facts").facts
    wrong = [f"there is no section {heading!r}" for heading in facts.given.keys() - sections.keys()]
    for heading, section in sections.items():
        values = facts.computed.get(heading, {})
        named = {*facts.given.get(heading, []), *values}
        found = set(numbers_in(section))
        wrong += [f"{heading}: {number} is not checked" for number in sorted(found - named)]
        wrong += [f"{heading}: {number} is not in the text" for number in sorted(named - found)]
        wrong += [
            f"{heading}: {number} should be {value!r}"
            for number, value in values.items()
            if not agrees(number, value)
        ]
    assert not wrong, "\n".join(wrong)
