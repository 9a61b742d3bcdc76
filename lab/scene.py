"""What a scene of the lab is: parameters, an engine that is stepped, and how it is drawn."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from lab.parameters import Parameter
from lab.pen import Pen

FRAME = 1.0 / 60.0  # s, between two pictures


@dataclass(frozen=True)
class Question:
    """A question that a reader answers before the scene runs.

    ``answer`` is the number of the right option for a scene with its parameters, and ``why`` says
    in a sentence or two what the reader has seen after ``seconds``.
    """

    words: str
    options: Sequence[str]
    answer: Callable[[Any], int]
    why: str
    seconds: float = 5.0


class Scene:
    """A scene, in its own units (m unless the axes say otherwise).

    A subclass sets the class attributes, has parameters, and overrides ``build``, ``step``,
    ``draw`` and what else it needs. ``peers`` names other ways to run the same scene, such as
    "exact" or "pymunk": subclasses that only differ in how they move.
    """

    chapter: ClassVar[int]
    title: ClassVar[str]
    question: ClassVar[str]  # one sentence: what this scene shows
    view: ClassVar[tuple[float, float, float, float]]  # the smallest and largest x, then y
    seconds: ClassVar[float] = 6.0  # how long the scripted player plays
    keys: ClassVar[dict[str, str]] = {}  # what a key does, such as {"left": "walk to the left"}
    predict: ClassVar[Question | None] = None
    peers: ClassVar[dict[str, type[Scene]]] = {}
    exact_from: ClassVar[str] = ""  # where the exact state comes from, if the scene has one
    error_unit: ClassVar[str] = "m"
    compare: ClassVar[tuple[str, ...]] = ("integrator", "rate")  # parameters to compare values of
    cost: float | None = None  # microseconds of a frame, if the scene measures it itself

    def __init__(self, **values: object) -> None:
        """Build the scene. Raises ValueError for a parameter that is unknown or out of range."""
        known = parameters_of(type(self))
        if unknown := values.keys() - known.keys():
            raise ValueError(f"{name_of(type(self))} has no parameter {', '.join(sorted(unknown))}")
        self.values = {
            name: parameter.checked(values.get(name, parameter.default))
            for name, parameter in known.items()
        }
        self.time = 0.0
        self.build()

    def build(self) -> None:
        """Make what moves, at time 0."""
        raise NotImplementedError

    def step(self, duration: float) -> None:
        """Let a frame of a duration in s pass."""
        raise NotImplementedError

    def draw(self, pen: Pen) -> None:
        """Draw the scene as it is now."""
        raise NotImplementedError

    def chart(self) -> dict[str, float]:
        """Return what is charted over time: values by name and unit, such as "energy, J"."""
        return {}

    def state(self) -> list[float]:
        """Return the coordinates that are compared with the exact ones."""
        return []

    def exact(self, time: float) -> list[float] | None:  # noqa: ARG002 - subclasses use it
        """Return the exact coordinates at a time, where they are known."""
        return None

    def say(self) -> str:
        """Return the state in words, for people who do not see the picture."""
        return ""

    def facts(self) -> str:
        """Return a line about the parameters, such as "k h^2 / m = 0.028, stable below 4"."""
        return ""

    def press(self, key: str) -> None:
        """Do what a key asks for."""

    def click(self, x: float, y: float) -> None:
        """Do what a click on a point asks for."""

    def drag(self, name: str, x: float, y: float) -> None:
        """Move a circle that can be dragged to a point."""

    def play(self, time: float) -> None:
        """Do what a player would do at this time. Pictures and tests call it once a frame."""

    def advance(self, duration: float = FRAME) -> None:
        """Let a frame pass, and keep the time."""
        self.step(duration)
        self.time += duration

    def error(self) -> float | None:
        """Return the largest distance of a coordinate from the exact one; None without these."""
        exact = self.exact(self.time)
        if exact is None:
            return None
        off = [abs(a - b) for a, b in zip(self.state(), exact, strict=True)]
        return max(off) if all(map(math.isfinite, off)) else math.inf


def parameters_of(scene: type[Scene]) -> dict[str, Parameter]:
    """Return the parameters of a scene by name, those of its base classes last."""
    found: dict[str, Parameter] = {}
    for kind in scene.__mro__:
        for name, value in vars(kind).items():
            if isinstance(value, Parameter):
                found.setdefault(name, value)
    return found


def name_of(scene: type[Scene]) -> str:
    """Return the name of a scene in addresses and commands: OneSpring is one-spring."""
    letters = [f"-{c.lower()}" if c.isupper() else c for c in scene.__name__]
    return "".join(letters).removeprefix("-")


def described(scene: type[Scene]) -> dict[str, Any]:
    """Return what a page needs to show a scene before it runs."""
    question = scene.predict
    return {
        "name": name_of(scene),
        "chapter": scene.chapter,
        "title": scene.title,
        "question": scene.question,
        "view": list(scene.view),
        "keys": scene.keys,
        "peers": list(scene.peers),
        "exactFrom": scene.exact_from,
        "errorUnit": scene.error_unit,
        "compare": list(scene.compare),
        "parameters": [parameter.described() for parameter in parameters_of(scene).values()],
        "predict": question
        and {
            "words": question.words,
            "options": list(question.options),
            "seconds": question.seconds,
        },
    }
