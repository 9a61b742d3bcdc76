"""The base class of the lab's interactive scenes, such as a ball on a spring or a rope bridge."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from lab.drawing.pen import Pen
from scenes.clock import FRAME, Clock, deviation
from scenes.parameters import Parameter

Pair = tuple[Sequence[float], Sequence[float]]  # simulated coordinates, and their exact values


@dataclass(frozen=True)
class Question:
    """A question that asks the reader to predict what a scene will do before it runs."""

    words: str
    options: Sequence[str]
    answer: Callable[[Any], int]  # from the scene to the index of the correct option
    why: str  # an explanation to show when the scene has run for ``seconds``
    seconds: float = 5.0


class Scene:
    """The base class of the scenes. Lengths are in meters unless a scene says otherwise."""

    title: ClassVar[str]
    question: ClassVar[str]  # one sentence that says what to find out
    view: ClassVar[tuple[float, float, float, float]]  # min x, max x, min y, max y
    seconds: ClassVar[float] = 6.0  # length of the scripted run
    keys: ClassVar[dict[str, str]] = {}  # what a key does, such as {"left": "walk to the left"}
    script: ClassVar[dict[int, str]] = {}  # the key that the scripted player presses, by frame
    predict: ClassVar[Question | None] = None
    # Subclasses that run the same scene by another method, such as "exact" or "pymunk".
    peers: ClassVar[dict[str, type[Scene]]] = {}
    exact_from: ClassVar[str] = ""  # the source of the exact state, if the scene has one
    error_unit: ClassVar[str] = "m"
    compare: ClassVar[tuple[str, ...]] = ("integrator", "rate")  # parameters offered to compare
    cost: float | None = None  # microseconds per frame, if the scene measures it itself
    rate: Any = 60  # steps per second, unless the scene has a parameter of this name

    def __init__(self, **values: object) -> None:
        """Build the scene, or raise ValueError if a parameter or its value is not allowed."""
        known = parameters_of(type(self))
        if unknown := values.keys() - known.keys():
            raise ValueError(f"{name_of(type(self))} has no parameter {', '.join(sorted(unknown))}")
        self.values = {
            name: parameter.checked(values.get(name, parameter.default))
            for name, parameter in known.items()
        }
        self.clock = Clock()
        self.build()

    def build(self) -> None:
        """Create the scene's objects, such as particles and springs, as they are at the start."""
        raise NotImplementedError

    def step(self, duration: float) -> None:
        """Advance the scene by one time step of ``duration`` s."""
        raise NotImplementedError

    def draw(self, pen: Pen) -> None:
        """Draw the current state of the scene with ``pen``."""
        raise NotImplementedError

    def chart(self) -> dict[str, float]:
        """Return the values to plot over time, such as {"energy, J": 2.5}."""
        return {}

    def beside_exact(self) -> Pair | None:
        """Return the simulated coordinates and their exact values, or None if these are unknown."""
        return None

    def say(self) -> str:
        """Describe the scene's current state in words, for readers who cannot see the picture."""
        return ""

    def facts(self) -> str:
        """Summarize the settings in one line, such as "k h^2 / m = 0.028, stable below 4"."""
        return ""

    def press(self, key: str) -> None:
        """Respond to a key that the reader has pressed."""

    def click(self, x: float, y: float) -> None:
        """Respond to a mouse click at the point (x, y) of the scene."""

    def drag(self, name: str, x: float, y: float) -> None:
        """Move the circle called ``name``, which the reader is dragging, to (x, y)."""

    def play(self, time: float) -> None:
        """Do what a player would do at ``time``, in s, before each frame of a recording or test."""
        self.press(self.script.get(round(time / FRAME), ""))

    def advance(self, duration: float = FRAME) -> None:
        """Make every time step that ends by the end of the next frame, which may be none."""
        self.clock.advance(self.step, self.rate, duration)

    @property
    def time(self) -> float:
        """The total length of all frames, in s."""
        return self.clock.time

    @property
    def simulated(self) -> float:
        """The time that the scene's state belongs to, in s."""
        return self.clock.simulated

    def error(self) -> float | None:
        """Compute the largest difference between a coordinate and its exact value, if known."""
        pair = self.beside_exact()
        return None if pair is None else deviation(*pair)


def parameters_of(scene: type[Scene]) -> dict[str, Parameter]:
    """Collect the parameters of a scene class, then those of its base classes, by name."""
    found: dict[str, Parameter] = {}
    for kind in scene.__mro__:
        for name, value in vars(kind).items():
            if isinstance(value, Parameter):
                found.setdefault(name, value)
    return found


def name_of(scene: type[Scene]) -> str:
    """Return a scene's name for use in URLs and commands, such as "one-spring" for OneSpring."""
    letters = [f"-{c.lower()}" if c.isupper() else c for c in scene.__name__]
    return "".join(letters).removeprefix("-")


def described(scene: type[Scene]) -> dict[str, Any]:
    """Return the data that the page needs to show a scene and its controls before it runs."""
    ask = scene.predict
    return {
        "name": name_of(scene),
        "title": scene.title,
        "question": scene.question,
        "view": list(scene.view),
        "keys": scene.keys,
        "peers": list(scene.peers),
        "exactFrom": scene.exact_from,
        "errorUnit": scene.error_unit,
        "compare": list(scene.compare),
        "parameters": [parameter.described() for parameter in parameters_of(scene).values()],
        "predict": ask
        and {"words": ask.words, "options": list(ask.options), "seconds": ask.seconds},
    }
