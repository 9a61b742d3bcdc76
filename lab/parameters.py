"""The parameters of a scene: numbers and choices that a reader may change."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any


class Parameter:
    """A value of a scene that a reader may change, as a class attribute of the scene.

    In the scene it reads as the value: ``self.stiffness`` is a number. A parameter that is ``live``
    may be changed while the scene runs; any other change builds the scene again.
    """

    def __init__(self, default: Any, label: str, unit: str, *, live: bool) -> None:
        self.default = default
        self.label = label
        self.unit = unit
        self.live = live
        self.name = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, scene: Any, owner: type) -> Any:
        return self if scene is None else scene.values[self.name]

    def checked(self, value: object) -> Any:
        """Return a value that is allowed, or raise ValueError."""
        raise NotImplementedError

    def described(self) -> dict[str, Any]:
        """Return what a page needs to show the parameter."""
        return {
            "name": self.name,
            "label": self.label,
            "unit": self.unit,
            "default": self.default,
            "live": self.live,
        }


class Slider(Parameter):
    """A number from ``low`` to ``high``, in steps, or in equal ratios where ``log`` is true."""

    def __init__(
        self,
        default: float,
        label: str,
        unit: str,
        low: float,
        high: float,
        *,
        step: float = 0.0,
        log: bool = False,
        live: bool = False,
    ) -> None:
        super().__init__(default, label, unit, live=live)
        self.low = low
        self.high = high
        self.step = step
        self.log = log

    def checked(self, value: object) -> float:
        """Return the number as a float. Raises ValueError outside the range."""
        if isinstance(value, str):
            try:
                value = float(value)
            except ValueError:
                raise ValueError(f"{self.name} must be a number, got {value!r}") from None
        if not (isinstance(value, (int, float)) and math.isfinite(value)):
            raise ValueError(f"{self.name} must be a number, got {value!r}")
        if not self.low <= value <= self.high:
            raise ValueError(f"{self.name} must be from {self.low:g} to {self.high:g}, got {value}")
        return float(value)

    def described(self) -> dict[str, Any]:
        """Return what a page needs to show a slider."""
        own = {"kind": "slider", "low": self.low, "high": self.high}
        return super().described() | own | {"step": self.step, "log": self.log}


class Choice(Parameter):
    """One of several values: numbers or texts."""

    def __init__(
        self,
        default: Any,
        label: str,
        options: Sequence[Any],
        unit: str = "",
        *,
        live: bool = False,
    ) -> None:
        super().__init__(default, label, unit, live=live)
        self.options = list(options)

    def checked(self, value: object) -> Any:
        """Return the option that the value names. Raises ValueError where there is none.

        A name may have hyphens in place of spaces, and any case, as a command line needs them.
        """
        for option in self.options:
            if value == option or _plain(value) == _plain(option):
                return option
        options = ", ".join(map(str, self.options))
        raise ValueError(f"{self.name} must be one of {options}, got {value!r}")

    def described(self) -> dict[str, Any]:
        """Return what a page needs to show a choice."""
        return super().described() | {"kind": "choice", "options": self.options}


def _plain(name: object) -> str:
    """Return a name or a number as a command line may spell it."""
    text = f"{name:g}" if isinstance(name, float) else str(name)
    return text.lower().replace(" ", "-")
