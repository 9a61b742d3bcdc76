"""The plots for chapter 5."""

from __future__ import annotations

from collections.abc import Callable

from plots.ch05_forces.cost import cost_of_a_generator
from plots.ch05_forces.fall_and_orbit import fall_with_drag, orbit, terminal_speeds
from plots.drawing import Picture

PLOTS: tuple[Callable[[], Picture], ...] = (
    terminal_speeds,
    fall_with_drag,
    orbit,
    cost_of_a_generator,
)
