"""The plots for chapter 8."""

from plots.ch08_mass_aggregate import energy, projects, releases, ropes

PLOTS = (
    energy.energy_of_bridge,
    energy.energy_of_platform,
    ropes.mass_ratios,
    ropes.hanging_rope,
    energy.variable_frames,
    releases.trebuchet_range,
    projects.wheel_deformation,
    projects.blob_bonds,
    projects.sleeping_balls,
)
