"""The parameters of a scene, which the reader changes with sliders and menus."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any


class Parameter:
    """A value that the reader can change, such as the stiffness of a spring.

    Parameters are defined as attributes of a scene's class. In an instance of the scene, the
    attribute is the current value, so ``self.stiffness`` is a number. A ``live`` parameter can
    change while the scene runs. A change to any other parameter rebuilds the scene.
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
        """Convert a value from the page or the command line to the type of this parameter.

        Raises:
            ValueError: The parameter does not allow this value.
        """
        raise NotImplementedError

    def described(self) -> dict[str, Any]:
        """Return the data from which the page creates a slider or a menu for this parameter."""
        return {
            "name": self.name,
            "label": self.label,
            "unit": self.unit,
            "default": self.default,
            "live": self.live,
        }


class Slider(Parameter):
    """A number that the reader sets with a slider between ``low`` and ``high``.

    The slider moves in increments of ``step``, on a logarithmic scale if ``log`` is true.
    """

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
        """Convert the new value of the slider to a float.

        Raises:
            ValueError: The value is not a finite number, or it is out of range.
        """
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

    def described(self) -> dict[str, Any]:
        """Return the data from which the page creates the slider."""
        own = {"kind": "slider", "low": self.low, "high": self.high}
        return super().described() | own | {"step": self.step, "log": self.log}


class Choice(Parameter):
    """A parameter for which the reader chooses one of several options, such as an integrator."""

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
        """Find the option that matches a value such as "runge-kutta-4".

        Hyphens may stand for spaces, and case does not matter, so that options are easy to type on
        a command line.

        Raises:
            ValueError: No option has this name.
        """
        for option in self.options:
            if value == option or _plain(value) == _plain(option):
                return option
        options = ", ".join(map(str, self.options))
        raise ValueError(f"{self.name} must be one of {options}, got {value!r}")

    def described(self) -> dict[str, Any]:
        """Return the data from which the page creates the list of options."""
        return super().described() | {"kind": "choice", "options": self.options}


def _plain(name: object) -> str:
    """Convert an option to the form that people type: "Runge-Kutta 4" becomes "runge-kutta-4"."""
    text = f"{name:g}" if isinstance(name, float) else str(name)
    return text.lower().replace(" ", "-")
