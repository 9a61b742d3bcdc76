"""Scenes and plots run the student's own functions, so they show what is wrong with them."""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from lab.catalog import load
from lab.drawing.pen import Pen
from plots.draw import plots_of

# Functions of chapter 7 which do nothing if these replace them.
IDLE: dict[str, Callable[..., Any]] = {
    "Contact.resolve_velocity": lambda *_: None,
    "Contact.resolve_penetration": lambda *_: (Vector3(), Vector3()),
    "ContactResolver.resolve_velocities": lambda *_: 0,
    "ContactResolver.resolve_penetrations": lambda *_: 0,
}
SHOWN = tomllib.loads((Path(__file__).parent / "shown.toml").read_text(encoding="utf-8"))
CLAIMS = [
    pytest.param(chapter, kind, target, names.replace("*contacts", " ".join(IDLE)).split())
    for chapter, kinds in SHOWN.items()
    for kind, claims in kinds.items()
    for target, names in claims.items()
]


class SeenError(BaseException):
    """All functions have been called, so the rest of the run can be left out."""


def show(chapter: str, kind: str, target: str) -> Any:
    """Draw a plot or play a scene, and return all that a scene shows."""
    if kind == "plots":
        return plots_of(chapter)[target]()
    scene, shown = load(target)(), []
    for frame in range(round(60 * scene.seconds)):
        scene.play(scene.time)
        scene.advance()
        if frame % 10 == 0:
            pen = Pen()
            scene.draw(pen)
            shown.append((pen.items, scene.chart(), scene.error(), scene.facts(), scene.say()))
    return shown


@pytest.mark.parametrize(("chapter", "kind", "target", "names"), CLAIMS)
def test_what_is_shown_is_computed_by_these_functions(
    chapter: str, kind: str, target: str, names: list[str]
) -> None:
    """Each of them is called. If it raised an error, the scene or the curve would break off."""
    missing, heard = {*names}, set()

    def hear(frame: Any, *_: object) -> None:
        code = frame.f_code
        if id(code) in heard:  # as most of some millions of calls
            return
        heard.add(id(code))
        if Path(code.co_filename).parent.name in (chapter, "ch07_constraints"):
            missing.discard(code.co_qualname)
            if not missing:
                raise SeenError

    before = sys.gettrace()
    try:
        sys.settrace(hear)
        show(chapter, kind, target)
    except SeenError:
        pass
    finally:
        sys.settrace(before)
        pyplot.close("all")
    assert missing == set(), "these functions are not called"


@pytest.mark.parametrize("target", ["bounce", "stack", "ropes", "wheel", "platform"])
def test_contacts_that_are_not_resolved_are_seen(
    target: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a short run, these functions do nothing, which is wrong."""
    (names,) = (claim.values[3] for claim in CLAIMS if claim.values[1:3] == ("scenes", target))
    right = show("", "scenes", target)
    for name in IDLE.keys() & {*names}:
        with monkeypatch.context() as patch:
            patch.setattr(f"ch07_constraints.contacts.{name}", IDLE[name])
            assert show("", "scenes", target) != right, name
