"""Going further: an integrator that takes a tolerance instead of a step size.

It estimates the error of every step. It repeats a step that was too long, and makes a longer one
after a step that was more accurate than necessary.

The method is by Dormand and Prince, Journal of Computational and Applied Mathematics 6 (1980), 19.
It has order 5, even if forces depend on the velocity, and it is not symplectic. The rule for the
next step comes from Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, II.4.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]  # as in integrators.py, which imports this module
State = list[Vector3]  # the position and the velocity of each particle that can move, in turn

# Each row leads from the start of a step to the state where the next rate is evaluated: the rates
# before it count with these weights. The last row leads to the end of the step. So the rate there
# is the first one of the next step.
TABLEAU = (
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
# The last row minus the weights of a solution of order 4, which gives the estimated error.
ERROR = (71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)

SAFETY = 0.9  # of the step that should just meet the tolerance, since the error is only an estimate
SHRINK, GROW = 0.1, 10.0  # how much shorter or longer a step may be than the one before
SHORTEST = 1e-14  # of a call: the rounding of the time would hide shorter steps
MOST_STEPS = 100_000  # of a call, including those that are repeated


def adaptive(tolerance: float) -> AdaptiveStep:
    """Return an integrator that chooses its own steps, so that each step meets the tolerance.

    ``tolerance`` is the largest estimated error of one step, in m for each coordinate of a position
    and in m/s for each component of a velocity. The final error is often ten to a few hundred times
    as large, because the errors of the steps add up. It is in proportion to the tolerance.
    """
    return AdaptiveStep(tolerance)


class AdaptiveStep:
    """An integrator that chooses its own steps. Create it with ``adaptive``.

    Like the other integrators, it takes ``(particles, apply_forces, duration)``, and a call ends
    exactly after ``duration``. It evaluates the forces once at its start, and six times in each
    step. ``evaluations`` counts them, and you may reset it to 0. Forces that were added by hand act
    for the whole call, and damping acts once, at its end.
    """

    def __init__(self, tolerance: float) -> None:
        self.tolerance = positive("tolerance", tolerance)
        self.evaluations = 0
        self._step = 0.0  # s, a first guess for the next call, or 0 if there is none

    def __repr__(self) -> str:
        return f"adaptive({self.tolerance!r})"

    def __call__(
        self, particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
    ) -> None:
        """Move the particles by ``duration`` s.

        If ``apply_forces`` raises ArithmeticError or ValueError in a step, the step is repeated
        with a tenth of its length. If steps become too short or too many, as at a singularity,
        raise ArithmeticError. The particles then keep the state after the last good step.
        """
        positive("duration", duration)
        moving = [particle for particle in particles if particle.inverse_mass]
        by_hand = [particle.force_accumulator for particle in particles]

        def rates_at(state: State) -> State:
            self.evaluations += 1
            _put(moving, state)
            for particle, force in zip(particles, by_hand, strict=True):
                particle.clear_forces()
                particle.add_force(force)
            apply_forces(duration)
            found = []
            for p in moving:
                found += [p.velocity.copy(), p.acceleration + p.force_accumulator * p.inverse_mass]
            return found

        start = [vector.copy() for p in moving for vector in (p.position, p.velocity)]
        state, rates, left = start, rates_at(start), duration
        wanted, self._step = self._step or duration, 0.0
        for _ in range(MOST_STEPS):
            parts = max(1, math.ceil(left / wanted))  # of equal length, so that none is tiny
            step, problem = left / parts, None
            try:
                end, end_rates, error = _attempt(state, rates, rates_at, step)
            except (ArithmeticError, ValueError) as raised:
                error, problem = math.inf, raised
            # The estimated error grows with the fifth power of the step.
            factor = SAFETY * (self.tolerance / error) ** 0.2 if error else GROW
            wanted = step * min(max(factor, SHRINK), GROW)
            if error <= self.tolerance:
                state, rates, left = end, end_rates, left - step
                if parts == 1:
                    self._step = wanted
                    _finish(particles, moving, start, duration)
                    return
            if wanted < min(step, SHORTEST * duration):
                break
        _put(moving, state)
        for particle in particles:
            particle.clear_forces()
        raise ArithmeticError(
            f"{self} cannot go on at {duration - left:g} s of a call of {duration:g} s, with steps "
            f"of {wanted:.1g} s. Use a larger tolerance or shorter calls"
        ) from problem


def _attempt(
    state: State, rates: State, rates_at: Callable[[State], State], step: float
) -> tuple[State, State, float]:
    """Return the state after a step, the rates there, and the largest estimated error."""
    end, stages = state, [rates]
    for weights in TABLEAU:
        end = _ahead(state, stages, weights, step)
        stages.append(rates_at(end))
    errors = _ahead([Vector3() for _ in state], stages, ERROR, step)
    sizes = [abs(component) for error in errors for component in error]
    return end, stages[-1], max(sizes, default=0.0) if math.isfinite(sum(sizes)) else math.inf


def _ahead(state: State, rates: list[State], weights: Sequence[float], step: float) -> State:
    """Return state + step * (weight * rate + weight * rate + ...)."""
    end = [vector.copy() for vector in state]
    for weight, rate in zip(weights, rates, strict=True):
        for vector, change in zip(end, rate, strict=True):
            vector.add_scaled(change, weight * step)
    return end


def _put(particles: Sequence[Particle], state: State) -> None:
    """Set the positions and velocities of the particles, in their own vectors."""
    vectors = [vector for p in particles for vector in (p.position, p.velocity)]
    for vector, value in zip(vectors, state, strict=True):
        vector.x, vector.y, vector.z = value


def _finish(
    particles: Sequence[Particle], moving: Sequence[Particle], start: State, duration: float
) -> None:
    """Kick the initial velocities once, by the mean acceleration of the call, and damp them."""
    for particle, initial in zip(moving, start[1::2], strict=True):
        mean = (particle.velocity - initial) / duration
        particle.velocity.x, particle.velocity.y, particle.velocity.z = initial
        particle.clear_forces()
        particle.add_force((mean - particle.acceleration) / particle.inverse_mass)
    for particle in particles:
        particle.kick(duration)
