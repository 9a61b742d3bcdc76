"""The plots for chapter 6."""

from __future__ import annotations

from collections.abc import Callable

from plots.ch06_springs import springs, stability
from plots.drawing import Picture

PLOTS: tuple[Callable[[], Picture], ...] = (
    springs.force_against_length,
    springs.three_regimes,
    stability.stability_map,
    stability.fake_spring,
    springs.energy_over_time,
    springs.error_against_work,
    stability.cloth_frame_rates,
    stability.penalty_bounces,
)
