"""The plots for chapter 6."""

from plots.ch06_springs import one_spring, stability

PLOTS = (
    one_spring.force_against_length,
    one_spring.three_regimes,
    stability.stability_map,
    stability.fake_spring,
    one_spring.energy_over_time,
    one_spring.error_against_work,
    stability.cloth_frame_rates,
    stability.penalty_bounces,
)
