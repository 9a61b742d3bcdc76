"""The plots for chapter 7."""

from __future__ import annotations

from collections.abc import Callable

from plots.ch07_constraints.bounces import (
    bounce_heights,
    resting_jitter,
    restitution_of_materials,
)
from plots.ch07_constraints.contacts import resolver_convergence, stack_height
from plots.ch07_constraints.rods import pendulum_energy, rods_hold, rope_by_method
from plots.ch07_constraints.solvers import contact_solvers  # noqa: F401 - for make figures only
from plots.drawing import Picture

PLOTS: tuple[Callable[[], Picture], ...] = (
    bounce_heights,
    resting_jitter,
    resolver_convergence,
    stack_height,
    rope_by_method,
    rods_hold,
    pendulum_energy,
    restitution_of_materials,
)
