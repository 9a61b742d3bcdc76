"""The parameters of a scene, which the reader changes with sliders and menus."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Any


@dataclass(eq=False)
class Parameter:
    """A value that the reader can change. In an instance of a scene, it is the current value.

    A change rebuilds the scene, unless the parameter is ``live``.
    """

    default: Any
    label: str
    _: KW_ONLY
    live: bool = False

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, scene: Any, owner: type) -> Any:
        return self if scene is None else scene.values[self.name]

    def checked(self, value: object) -> Any:
        """Convert a value from the page or the command line, or raise ValueError."""
        raise NotImplementedError

    def described(self) -> dict[str, Any]:
        """Return the data from which the page creates a slider or a menu for this parameter."""
        return {"kind": type(self).__name__.lower(), **vars(self)}


@dataclass(eq=False)
class Slider(Parameter):
    """A number that the reader sets with a slider, in increments of ``step``."""

    unit: str
    low: float
    high: float
    _: KW_ONLY
    step: float = 0.0
    log: bool = False  # a logarithmic scale

    def checked(self, value: object) -> float:
        """Convert a value to a float, or raise ValueError if it is not finite or out of range."""
        if isinstance(value, str):
            try:
                value = float(value)
            except ValueError:
                raise ValueError(f"{self.name} must be a number, got {value!r}") from None
        # Not isfinite, because a whole number can be too large for a float.
        if not (isinstance(value, (int, float)) and -math.inf < value < math.inf):
            raise ValueError(f"{self.name} must be a number, got {value!r}")
        if not self.low <= value <= self.high:
            raise ValueError(f"{self.name} must be from {self.low:g} to {self.high:g}, got {value}")
        return float(value)


@dataclass(eq=False)
class Choice(Parameter):
    """A parameter for which the reader chooses one of several options, such as an integrator."""

    options: Sequence[Any]
    unit: str = ""

    def checked(self, value: object) -> Any:
        """Find an option, in any case and with hyphens for spaces, or raise ValueError."""
        for option in self.options:
            if value == option or _plain(value) == _plain(option):
                return option
        options = ", ".join(map(str, self.options))
        raise ValueError(f"{self.name} must be one of {options}, got {value!r}")


def _plain(name: object) -> str:
    """Convert an option to the form that people type: "Runge-Kutta 4" becomes "runge-kutta-4"."""
    text = f"{name:g}" if isinstance(name, float) else str(name)
    return text.lower().replace(" ", "-")
