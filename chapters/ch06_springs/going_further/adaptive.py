"""Going further: an integrator that takes a tolerance instead of a step size.

A fixed step must be short enough for the fastest part of a motion, so it is shorter than necessary
for the rest. A comet, for example, needs short steps while it passes the sun, but long steps are
enough for the rest of its orbit. This integrator adjusts its steps to the motion. It estimates the
error of every step, and repeats a step that was too long. After a step that was more accurate than
necessary, it makes a longer one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from ch02_vectors.arguments import positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]  # as in integrators.py, which imports this module

# The tableau of Dormand and Prince (1980). Row i leads from the start of a step to the state where
# rate i + 1 is evaluated: the state moves on by these weights times the rates before it, times the
# step. The last row is the solution of order 5. So its rate is the first one of the next step.
STAGES = (
    (1 / 5, 0, 0, 0, 0, 0, 0),
    (3 / 40, 9 / 40, 0, 0, 0, 0, 0),
    (44 / 45, -56 / 15, 32 / 9, 0, 0, 0, 0),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729, 0, 0, 0),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656, 0, 0),
    (35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84, 0),
)
# The solution of order 5 less a second one, of order 4, from the same rates: the estimated error.
ERROR = (71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)

SAFETY = 0.9  # of the step that should just meet the tolerance: the error is only an estimate
SHRINK, GROW = 0.1, 10.0  # what one step may change the next one by
SMALLEST = 1e-14  # of a call: shorter steps would get lost in the rounding of the time
MOST_STEPS = 100_000  # of a call, with those that are repeated: several seconds

Numbers = list[float]


def adaptive(tolerance: float) -> AdaptiveStep:
    """Return an integrator that chooses its own steps, so that each step meets the tolerance.

    ``tolerance`` is the largest estimated error that one step may make. The limit holds for each
    coordinate of a position in m, and for each component of a velocity in m/s. It is an absolute
    error, so choose it to suit the size of your scene. The errors of the steps add up, and an orbit
    or an oscillation amplifies them. The final error is therefore often ten to a few hundred times
    as large as the tolerance. If you make the tolerance smaller, the final error shrinks in
    proportion.

    Raises ValueError if the tolerance is not positive and finite, and TypeError if it is not a
    number.
    """
    return AdaptiveStep(tolerance)


class AdaptiveStep:
    """An integrator that chooses its own steps. Create it with `adaptive`.

    Call it with ``(particles, apply_forces, duration)``, like the other integrators. A call moves
    the particles by exactly ``duration``, in as many steps as necessary. Each step evaluates the
    forces six times. Each call also evaluates them once at its start, so you may change particles
    and forces between calls. ``evaluations`` counts all evaluations, and you may reset it to 0.

    The integrator remembers only the length of its last good step, as a first guess for the next
    call. You can therefore use the same integrator for several groups of particles in turn.

    As in the other integrators, forces that were added by hand act for the whole call, and damping
    multiplies the velocity once per call. Every evaluation passes the duration of the whole call to
    ``apply_forces``.

    The method has order 5, even if forces depend on the velocity, and is not symplectic. A stiff
    spring stays stable because the steps become short, but it then takes at least as many steps as
    with an integrator of fixed steps. Source: Dormand and Prince, Journal of Computational and
    Applied Mathematics 6 (1980), 19. The rule for the length of the next step comes from Hairer,
    Nørsett and Wanner, Solving Ordinary Differential Equations I, II.4.
    """

    def __init__(self, tolerance: float) -> None:
        self.tolerance = positive("tolerance", tolerance)
        self.evaluations = 0
        self._step = 0.0  # s: the step that should just meet the tolerance; 0 while it is not known

    def __repr__(self) -> str:
        return f"adaptive({self.tolerance!r})"

    def __call__(
        self, particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
    ) -> None:
        """Move the particles by ``duration`` s.

        A step that is too long can take particles to positions where a force cannot be computed. So
        if ``apply_forces`` raises ArithmeticError or ValueError, the step is repeated with a tenth
        of its length. If the first evaluation of the call raises the error, a shorter step cannot
        help, so the error is passed on. All other errors are always passed on, and leave the
        particles in the middle of the call.

        Raises ArithmeticError if a step becomes too short to continue, as at a singularity, or if a
        call needs more than ``MOST_STEPS`` steps. The particles then keep the state after the last
        good step, without damping, and their accumulators are empty. Raises ValueError if the
        duration is not positive and finite, and TypeError if it is not a number. In that case
        nothing changes.
        """
        positive("duration", duration)
        moving = _Moving(particles)

        def rates_at(state: Numbers) -> Numbers:
            moving.put(state)
            self.evaluations += 1
            apply_forces(duration)
            return moving.rates()

        state = start = moving.state()
        first = rates_at(state)
        left, wanted = duration, self._step or duration
        self._step = 0.0  # an error forgets it: what led to the error is no guide for the next call
        for _ in range(MOST_STEPS):
            parts = max(1, math.ceil(left / wanted))  # equal ones: no tiny step is left at the end
            step = left / parts
            problem = None
            try:
                end, last, errors = _attempt(state, first, rates_at, step)
            except (ArithmeticError, ValueError) as raised:
                end, last, errors, problem = state, first, [math.inf], raised
            error = _largest(errors)
            # The error of order 4 grows with the fifth power of the step.
            factor = SAFETY * (self.tolerance / error) ** 0.2 if error else GROW
            factor = min(max(factor, SHRINK), GROW)
            if error <= self.tolerance:
                state, first = end, last
                left -= step
                # A step that was cut short by the end of the call only says that it might grow.
                wanted = step * factor if factor < GROW else max(wanted, step * GROW)
                if parts == 1:
                    break
            else:
                wanted = step * factor
                if wanted < SMALLEST * duration:
                    moving.stop(state)
                    why = problem or moving.worst(errors)
                    raise ArithmeticError(
                        f"{self} needs steps shorter than {wanted:.1g} s at {duration - left:g} s of "
                        f"a call of {duration:g} s: {why}"
                    ) from problem
        else:
            moving.stop(state)
            raise ArithmeticError(
                f"{self} has only reached {duration - left:g} s of a call of {duration:g} s after "
                f"{MOST_STEPS:,} steps; use a larger tolerance or shorter calls"
            )
        self._step = wanted
        moving.finish(start, duration)


class _Moving:
    """Stores the particles that can move, and represents their state as a list of numbers.

    The state lists six numbers for each particle: its position and its velocity. The rates of the
    state list its velocity and its acceleration in the same order.
    """

    def __init__(self, particles: Sequence[Particle]) -> None:
        self.particles = particles
        self.by_hand = [(one, force) for one in particles if any(force := one.force_accumulator)]
        self.bodies = [
            (one, one.inverse_mass, one.acceleration, one.position, one.velocity)
            for one in particles
            if one.inverse_mass
        ]

    def state(self) -> Numbers:
        """Return the current state of the particles."""
        vectors = (vector for _, _, _, p, v in self.bodies for vector in (p, v))
        return [number for vector in vectors for number in vector]

    def put(self, state: Numbers) -> None:
        """Set the particles to ``state``, and leave only the forces that were added by hand."""
        first = 0
        for _, _, _, p, v in self.bodies:
            p.x, p.y, p.z, v.x, v.y, v.z = state[first : first + 6]
            first += 6
        self._clear()
        for particle, force in self.by_hand:
            particle.add_force(force)

    def rates(self) -> Numbers:
        """Return the rates of the current state, with the forces in the accumulators."""
        rates: Numbers = []
        for particle, m, a, _, v in self.bodies:
            f = particle.force_accumulator
            rates += (v.x, v.y, v.z, a.x + f.x * m, a.y + f.y * m, a.z + f.z * m)
        return rates

    def finish(self, start: Numbers, duration: float) -> None:
        """Set the final velocities in one update that starts from the initial velocities.

        The update applies a constant force that, without damping, would lead to the velocities
        found by the steps. It also applies the damping, as in the other integrators. Afterward,
        last_acceleration is the mean acceleration of the call.
        """
        self._clear()
        for i, (particle, m, a, _, v) in enumerate(self.bodies):
            before = Vector3(*start[6 * i + 3 : 6 * i + 6])
            mean = (v - before) / duration
            v.x, v.y, v.z = before
            particle.add_force((mean - a) / m)
        for particle in self.particles:
            particle.kick(duration)

    def stop(self, state: Numbers) -> None:
        """Set the particles to ``state``, and empty their accumulators."""
        self.put(state)
        self._clear()

    def worst(self, errors: Numbers) -> str:
        """Describe in words where the largest error is."""
        at = next((i for i, error in enumerate(errors) if not math.isfinite(error)), None)
        if at is not None:
            return f"the force on {self._named(at)} is not finite"
        at = max(range(len(errors)), key=lambda i: abs(errors[i]))
        return f"the force on {self._named(at)} changes too fast for the tolerance"

    def _named(self, at: int) -> str:
        particle = self.bodies[at // 6][0]
        number = next(i for i, other in enumerate(self.particles) if other is particle)
        return f"particle {number} at {particle.position!r}"

    def _clear(self) -> None:
        for particle in self.particles:
            particle.clear_forces()


def _attempt(
    state: Numbers, first: Numbers, rates_at: Callable[[Numbers], Numbers], step: float
) -> tuple[Numbers, Numbers, Numbers]:
    """Return the state after a step, the rates there, and the estimated errors of the state.

    ``first`` contains the rates at the start of the step.
    """
    rates = [first] * 7  # those that are not known yet have the weight 0
    end = state
    for i, weights in enumerate(STAGES, 1):
        end = _ahead(state, rates, weights, step)
        rates[i] = rates_at(end)
    return end, rates[6], _ahead([0.0] * len(state), rates, ERROR, step)


def _ahead(state: Numbers, rates: list[Numbers], weights: Sequence[float], step: float) -> Numbers:
    """Return state + step * sum(weight * rate), the state after moving at the weighted rates."""
    a, b, c, d, e, f, g = weights
    return [
        y + step * (a * r1 + b * r2 + c * r3 + d * r4 + e * r5 + f * r6 + g * r7)
        for y, r1, r2, r3, r4, r5, r6, r7 in zip(state, *rates, strict=True)
    ]


def _largest(errors: Numbers) -> float:
    """Return the magnitude of the largest error, or infinity if one is NaN."""
    return max(map(abs, errors), default=0.0) if math.isfinite(sum(errors)) else math.inf
