"""The plots for chapter 8."""

from __future__ import annotations

from collections.abc import Callable

from plots.ch08_mass_aggregate.energy import (
    energy_of_bridge,
    energy_of_platform,
    variable_frames,
)
from plots.ch08_mass_aggregate.projects import (
    blob_bonds,
    sleeping_balls,
    wheel_deformation,
)
from plots.ch08_mass_aggregate.releases import trebuchet_range
from plots.ch08_mass_aggregate.ropes import hanging_rope, mass_ratios
from plots.drawing import Picture

PLOTS: tuple[Callable[[], Picture], ...] = (
    energy_of_bridge,
    energy_of_platform,
    mass_ratios,
    hanging_rope,
    variable_frames,
    trebuchet_range,
    wheel_deformation,
    blob_bonds,
    sleeping_balls,
)
