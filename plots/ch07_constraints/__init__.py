"""The plots for chapter 7."""

from plots.ch07_constraints import bounces, rods, stacks

PLOTS = (
    bounces.bounce_heights,
    bounces.resting_jitter,
    stacks.resolver_convergence,
    stacks.stack_height,
    rods.rope_by_method,
    rods.rods_hold,
    rods.pendulum_energy,
    bounces.restitution_of_materials,
)
FOR_LESSONS = (stacks.contact_solvers,)  # drawn only by make figures
