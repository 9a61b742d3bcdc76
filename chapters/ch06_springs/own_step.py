"""Write your own integrator that is accurate with only a few force evaluations per step."""

from __future__ import annotations

from collections.abc import Sequence

from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces


def my_step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Move ``particles`` by one time step of ``duration`` s, with a method that you design.

    You may divide the step into parts. Each call of ``apply_forces(duration)`` evaluates the forces
    and adds them to the accumulators, so clear these before the next call and at the end.

    Your method is graded on one revolution of an orbit with an eccentricity of 0.5, in 60 steps.
    The error is the largest distance from the true position after any step, in semi-major axes. It
    must be at most 1e-2. With at most 500 evaluations, an error of 1e-3 is good and 1e-4 is better.
    The run is stopped after 5000. In a second scene, two particles on a spring fall as they swing,
    once in 60 steps. No particle may be farther from its true position than 0.5 % of the largest
    distance between the two, and the final velocities must be right as well. The scenes have no
    damping, no forces added by hand, and no forces that depend on velocities or durations.
    """
    raise NotImplementedError("Exercise G6.3: Going further: a step of your own")
