"""Scenes and plots run the student's own functions: if one of them is wrong, the data change."""

from __future__ import annotations

import importlib
import inspect
import tomllib
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any

import pytest
from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from lab.catalog import entries, load
from lab.drawing.pen import Pen
from plots.draw import plots_of

SHOWN = tomllib.loads((Path(__file__).parent / "shown.toml").read_text(encoding="utf-8"))
# In a short run, these do nothing, which is wrong. In all other cases, a wrong function raises an
# error.
SHORT = ("bounce", "stack", "ropes", "wheel", "platform")
IDLE: dict[str, Callable[..., Any]] = {
    "contacts.Contact.resolve_velocity": lambda *_: None,
    "contacts.Contact.resolve_penetration": lambda *_: (Vector3(), Vector3()),
    "contacts.ContactResolver.resolve_velocities": lambda *_: 0,
    "contacts.ContactResolver.resolve_penetrations": lambda *_: 0,
}


def broken(*_: object, **__: object) -> None:
    raise ArithmeticError("broken on purpose")


def data_of(target: str) -> Any:
    """Return the numbers that a scene or a plot shows, or the error that stopped it."""
    chapter, _, plot = target.rpartition("/")
    try:
        if chapter:
            return plots_of(chapter)[plot]().rows
        scene, shown = load(target)(), []
        for frame in range(round(60 * scene.seconds)):
            scene.play(scene.time)
            scene.advance()
            if frame % 10 == 0:
                pen = Pen()
                scene.draw(pen)
                shown.append((pen.items, scene.chart(), scene.error(), scene.facts(), scene.say()))
        return shown
    except ArithmeticError as error:
        return str(error)
    finally:
        pyplot.close("all")


def break_function(monkeypatch: pytest.MonkeyPatch, chapter: str, name: str, idle: bool) -> None:
    """Break a function wherever it has been imported, by replacing its code."""
    module, *path = name.split(".")
    owner: Any = importlib.import_module(f"{chapter}.{module}")
    for part in path[:-1]:
        owner = getattr(owner, part)
    if idle and name in IDLE:
        monkeypatch.setattr(owner, path[-1], IDLE[name])
        return
    found = inspect.getattr_static(owner, path[-1])
    function: Any = getattr(found, "fget", None) or getattr(found, "__func__", found)
    assert isinstance(function, FunctionType), name
    free = function.__code__.co_freevars  # __class__, if the function calls super()
    monkeypatch.setattr(function, "__code__", broken.__code__.replace(co_freevars=free))
    monkeypatch.setattr(function, "__defaults__", None)
    monkeypatch.setattr(function, "__kwdefaults__", None)


@pytest.mark.parametrize("target", SHOWN)
def test_a_wrong_function_changes_what_is_shown(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = data_of(target)
    assert not isinstance(right, str), right
    same = []
    for chapter, names in SHOWN[target].items():
        for name in names:
            with monkeypatch.context() as patch:
                break_function(patch, chapter, name, target in SHORT)
                if data_of(target) == right:
                    same.append(name)
    assert same == [], f"{target} does not run these functions"


def test_every_scene_claims_something_and_every_contact_is_resolved_by_the_student() -> None:
    # The scene of the charts replays measurements of the reference.
    assert {entry.name for entry in entries()} - {*SHOWN} == {"charts"}
    resolved = {
        name for name, of in SHOWN.items() if "contacts.Contact.resolve_velocity" in str(of)
    }
    assert {"ropes", "ch07_constraints/rods_hold", "ch08_mass_aggregate/mass_ratios"} <= resolved
