"""Run one interactive scene, controlled by messages from a web page.

The lab's local server and the course's website share it, so it uses no sockets or processes. A
message is a dict with a ``kind`` that can be sent as JSON.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

from lab.catalog import find, load
from lab.cost import Cost, clock
from lab.drawing.pen import Pen
from lab.scene import Scene, described, parameters_of

Message = dict[str, Any]
MOST_FRAMES = 30  # per message: half a second
FAR = 1e12  # m, J and so on; a larger number means that the scene has exploded


class Host:
    """Runs a scene. ``explain`` turns an exception into a message for the student."""

    def __init__(self, explain: Callable[[BaseException], str]) -> None:
        self.explain = explain
        self.kind: type[Scene] = Scene  # until a scene is loaded
        self.scene: Scene | None = None
        self.values: dict[str, object] = {}
        self.cost = Cost()

    def receive(self, message: Message) -> list[Message]:
        """Answer a message. If it raises an exception, the scene stops and the answer says why."""
        try:
            return self._answer(message)
        except (Exception, SystemExit) as error:
            self.scene = None
            return [{"kind": "stopped", "why": self.explain(error)}]

    def _answer(self, message: Message) -> list[Message]:
        match message:
            case {"kind": "load", "scene": str(name), "values": dict(values), "peer": str(peer)}:
                return self._load(name, values, peer)
            case {"kind": "restart"}:
                return [self._restart()]
            case {"kind": "set", "name": str(name), "value": value}:
                return self._set(name, value)
        if (scene := self.scene) is None:
            return []  # the page already knows that the scene has stopped
        match message:
            case {"kind": "run", "frames": int(frames)}:
                start = clock()
                for _ in range(min(frames, MOST_FRAMES)):
                    self.cost.measure(scene.advance)
                frame = self._frame(scene)
                return [frame | {"took": round(1e3 * (clock() - start), 1)}]  # ms
            case {"kind": "press", "key": str(key)}:
                scene.press(key)
            case {"kind": "click", "x": int() | float() as x, "y": int() | float() as y}:
                scene.click(float(x), float(y))
            case {
                "kind": "drag",
                "name": str(name),
                "x": int() | float() as x,
                "y": int() | float() as y,
            }:
                scene.drag(name, float(x), float(y))
            case {"kind": "predict", "option": int(option)} if scene.predict:
                right = scene.predict.answer(scene)
                verdict = {"right": option == right, "answer": right, "why": scene.predict.why}
                return [{"kind": "judged"} | verdict]
            case _:
                raise ValueError(f"unknown kind of message: {message!r:.200}")
        return [self._frame(scene)]

    def _load(self, name: str, values: dict[str, object], peer: str) -> list[Message]:
        """Load a scene or its ``peer``, such as "pymunk", with defaults for invalid values."""
        self.scene = None
        kind = load(name)
        if peer and peer not in kind.peers:
            raise ValueError(f"{peer} cannot run {name}")
        self.kind, self.values = kind.peers.get(peer, kind), {}
        refused = [answer for pair in values.items() for answer in self._keep(*pair)]
        answer = {"kind": "scene", **described(self.kind), "values": dict(self.values)}
        return [answer | {"chapter": find(name).chapter}, *refused, self._restart()]

    def _restart(self) -> Message:
        self.scene = None
        self.scene = self.kind(**self.values)
        self.cost.forget()
        return self._frame(self.scene)

    def _set(self, name: str, value: object) -> list[Message]:
        """Set a parameter. Unless it is live, the scene is rebuilt and starts over."""
        if refused := self._keep(name, value):
            return refused
        if self.scene is None or not parameters_of(self.kind)[name].live:
            return [self._restart()]
        self.scene.values[name] = self.values[name]
        self.cost.forget()
        return [self._frame(self.scene)]

    def _keep(self, name: str, value: object) -> list[Message]:
        """Store the value of a parameter, or return a message that says why it is refused."""
        parameter = parameters_of(self.kind).get(name)
        if parameter is None:
            return [{"kind": "refused", "why": f"This scene has no parameter {name}."}]
        try:
            self.values[name] = parameter.checked(value)
        except ValueError as error:
            return [{"kind": "refused", "why": str(error)}]
        return []

    def _frame(self, scene: Scene) -> Message:
        """Collect what the page shows, or raise ArithmeticError if the scene has exploded."""
        pen = Pen()
        scene.draw(pen)
        error = scene.error()
        charted = scene.chart()
        if not all(abs(value) < FAR for value in (*_numbers(pen.items), *charted.values())):
            raise ArithmeticError(
                "The scene exploded: a position or an energy has become far too large. "
                "Restart it with a lower stiffness or a shorter time step."
            )
        return {
            "kind": "frame",
            "time": round(scene.time, 6),
            "items": pen.items,
            "chart": charted,
            "error": error if error is None or math.isfinite(error) else None,
            "cost": scene.cost or self.cost.known(),
            "facts": scene.facts(),
            "changed": {  # parameters that a key press or a drag has changed
                name: value
                for name, value in scene.values.items()
                if value != self.values.get(name, getattr(self.kind, name).default)
            },
            "say": scene.say(),
        }


def _numbers(items: list[Any]) -> Iterator[float]:
    for value in items:
        if isinstance(value, list):
            yield from _numbers(value)
        elif isinstance(value, float):
            yield value
