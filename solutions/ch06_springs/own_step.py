"""Write your own integrator that is accurate with only a few force evaluations per step.

Each evaluation computes all forces, which is the most expensive part of a time step. An integrator
that evaluates the forces more often can be more accurate, but it is also slower. The best
compromise depends on the scene. In this exercise the scene is an orbit.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces


def my_step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Move ``particles`` by one time step, with a method that you design yourself.

    ``duration`` is in s, and you may divide it into as many parts as you like. Each call of
    ``apply_forces(duration)`` evaluates the forces and adds them to the accumulators. So clear the
    accumulators before the next call, and also at the end of the step. Remember that a particle's
    own acceleration acts in addition to the forces.

    Your method is graded on one revolution of an orbit with an eccentricity of 0.5. The revolution
    takes 60 frames, and ``my_step`` is called once per frame. The grade depends on the number of
    evaluations and on the error. The error is the largest distance from the true position after any
    frame, in units of the semi-major axis. It must be at most 1e-2. With at most 500 evaluations,
    an error of 1e-3 is good and 1e-4 is better. The run is stopped after 5000 evaluations.

    A second scene has two particles on a spring, which fall as they swing. One oscillation takes 60
    frames. After any frame, no particle may be farther from its true position than 0.5 % of the
    largest distance between the two. After one oscillation, the velocities must be right as well.

    Both scenes are simple. They have no damping, no forces added by hand and no immovable
    particles. Their forces do not depend on velocities, nor on the duration that you pass to
    ``apply_forces``.
    """
    # Drifts and kicks alternate, with fractions of the step that are symmetric:
    # Blanes and Moan, Journal of Computational and Applied Mathematics 142 (2002), 313, their S6.
    drifts = [0.0792036964311957, 0.353172906049774, -0.0420650803577195]
    kicks = [0.209515106613362, -0.143851773179818]
    kicks.append(0.5 - sum(kicks))
    drifts = [*drifts, 1.0 - 2.0 * sum(drifts), *reversed(drifts)]
    kicks = [*kicks, *reversed(kicks), 0.0]
    for drift, kick in zip(drifts, kicks, strict=True):
        for particle in particles:
            particle.drift(drift * duration)
        if kick:
            apply_forces(duration)  # a part may be negative, which registries refuse
            for particle in particles:
                particle.kick(kick * duration)
