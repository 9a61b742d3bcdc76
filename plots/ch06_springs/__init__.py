"""The plots for chapter 6."""

from __future__ import annotations

from collections.abc import Callable

from plots.ch06_springs.one_spring import (
    energy_over_time,
    error_against_work,
    force_against_length,
    three_regimes,
)
from plots.ch06_springs.stability import (
    cloth_frame_rates,
    fake_spring,
    penalty_bounces,
    stability_map,
)
from plots.drawing import Picture

PLOTS: tuple[Callable[[], Picture], ...] = (
    force_against_length,
    three_regimes,
    stability_map,
    fake_spring,
    energy_over_time,
    error_against_work,
    cloth_frame_rates,
    penalty_bounces,
)
