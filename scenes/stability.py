"""Simulate a spring with different integrators, and measure when it becomes unstable.

A spring pulls a particle of 1 kg along X. Solvers for a single spring are wrapped as integrators.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.going_further.cloth import make_cloth
from ch06_springs.integrators import ApplyForces, Integrator, semi_implicit_euler, watched
from ch06_springs.penalty import PenaltyGround
from ch06_springs.springs import FakeStiffSpring
from scenes.integrators import INTEGRATORS, SOLVERS, Solver
from scenes.readings import number, numbers, stopped


class Pull:
    """A spring that pulls toward 0, independent of the engine's own springs and their bugs.

    ``count`` is the number of times that the force was evaluated.
    """

    def __init__(self, stiffness: float) -> None:
        self.stiffness = stiffness
        self.count = 0

    def update_force(self, particle: Particle, duration: float) -> None:
        del duration
        self.count += 1
        particle.add_force(Vector3(-self.stiffness * particle.position.x))


@dataclass(frozen=True)
class Swing:
    """The recorded motion of an oscillating body, with the message of any error that ended it."""

    places: list[float]
    velocities: list[float]
    message: str


def solving(solver: Solver, stiffness: float, damping: float = 0.0) -> Integrator:
    """Build an integrator that moves particles along X with a solver for a single linear spring."""

    def step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
        del apply_forces
        for particle in particles:
            x, v = particle.position.x, particle.velocity.x
            end = _pair(solver(x, v, stiffness, damping, particle.mass, duration))
            particle.position.x, particle.velocity.x = end

    return step


def methods(stiffness: float) -> dict[str, Integrator]:
    """Return a dict of all integrators. Solvers are wrapped for a spring without damping."""
    return INTEGRATORS | {name: solving(solver, stiffness) for name, solver in SOLVERS.items()}


def watching(integrator: Integrator, limit: float) -> Integrator:
    """Return an integrator that raises an error if a particle's speed exceeds ``limit`` in m/s.

    If the student's function ``watched`` is not written yet, return ``integrator`` unchanged.
    """
    try:
        step = watched(integrator, limit)
    except NotImplementedError:
        return integrator
    return step if callable(step) else integrator


def swing(
    integrator: Integrator,
    generator: ForceGenerator,
    duration: float,
    steps: int,
    limit: float,
    damping: float = 1.0,
) -> Swing:
    """Release a body of 1 kg at x = 1 m. Stop early if its speed exceeds ``limit`` in m/s."""
    particle = Particle(Vector3(1.0), damping=damping)
    step = watching(integrator, limit)
    places, velocities = [1.0], [0.0]

    def run() -> None:
        for _ in range(steps):
            _step(step, particle, generator, duration)
            x, v = _state(particle)
            places.append(x)
            velocities.append(v)

    message = stopped(run)
    return Swing(places, velocities, message)


def growth(
    integrator: Integrator, generator: ForceGenerator, duration: float, damping: float = 1.0
) -> float:
    """Compute the factor by which an oscillation grows per time step in the long run.

    It is the largest magnitude of an eigenvalue of the step's matrix, or NaN if the engine fails.
    """
    return spectral_radius(*step_matrix(integrator, generator, duration, damping))


def step_matrix(
    integrator: Integrator, generator: ForceGenerator, duration: float, damping: float = 1.0
) -> tuple[float, float, float, float]:
    """Measure the matrix of one time step of an integrator, which multiplies (x, v h).

    A step is linear, so the columns of the matrix are its results for (1, 0) and (0, 1). Return the
    four entries row by row, or four NaNs if the engine fails.
    """
    columns = []
    for x, v in ((1.0, 0.0), (0.0, 1.0 / duration)):
        particle = Particle(Vector3(x), Vector3(v), damping=damping)
        if stopped(lambda p=particle: _step(integrator, p, generator, duration)):  # type: ignore[misc]
            return math.nan, math.nan, math.nan, math.nan
        columns.append(_state(particle))
    (a, c), (b, d) = columns
    return a, b, c * duration, d * duration


def growth_of(name: str, kappa: float, damping: float, duration: float) -> float:
    """Compute the factor by which the oscillations of a spring grow in one time step.

    ``kappa`` is k h^2 / m, where k is the stiffness and h is the time step. ``damping`` is d^h for
    an integrator, and c h / m for a solver.
    """
    k = kappa / duration**2
    if name in SOLVERS:
        return growth(solving(SOLVERS[name], k, damping / duration), Pull(k), duration)
    return growth(INTEGRATORS[name], Pull(k), duration, damping ** (1.0 / duration))


def period(places: Sequence[float]) -> float:
    """Return the number of steps per oscillation, or NaN if there are too few zero crossings."""
    found = [i + a / (a - b) for i, (a, b) in enumerate(pairwise(places)) if a * b < 0.0]
    return 2.0 * (found[-1] - found[0]) / (len(found) - 1) if len(found) > 1 else math.nan


def true_place(k: float, c: float, time: float) -> float:
    """Compute the exact position of a body of 1 kg on a spring, released at 1 m."""
    state = damped_spring_state(1.0, 0.0, k, c, 1.0, time)
    return number(state[0]) if isinstance(state, tuple) else math.nan


def faked_growth(angle: float, share: float, duration: float) -> float:
    """Compute the factor by which the oscillations of a FakeStiffSpring grow in one time step.

    ``angle`` is the phase per step in radians. ``share`` is the fraction of critical damping.
    """
    chi = angle / duration
    fake = FakeStiffSpring(Vector3(), chi * chi, 2.0 * share * chi)
    return growth(semi_implicit_euler, fake, duration)


def cloth_lasts(name: str, damping: float, rate: int, most: int) -> tuple[int, str]:
    """Return the number of steps until a cloth particle exceeds 1000 m/s, and any error message."""
    knots, registry = make_cloth(damping)
    step = watching(INTEGRATORS[name], 1000.0)
    steps = 0

    def run() -> None:
        nonlocal steps
        while steps < most:
            step(knots, registry.update_forces, 1.0 / rate)
            steps += 1

    message = stopped(run)
    return steps, message


def bounces(stiffness: float, fall: float, steps: int) -> list[float]:
    """Drop a 1 kg body onto an undamped PenaltyGround, and record its height at 60 Hz."""
    particle = Particle(Vector3(0.0, fall), acceleration=Vector3(0.0, -10.0))
    ground = PenaltyGround(0.0, stiffness)
    step = watching(semi_implicit_euler, 1e4)
    heights = [fall]

    def run() -> None:
        for _ in range(steps):
            _step(step, particle, ground, 1.0 / 60.0)
            heights.append(numbers(particle.position)[1])

    stopped(run)
    return heights


def largest_error(places: list[float], chi: float, steps: int) -> float:
    """Return a spring's largest deviation from cos(chi t), sampled at most 64 times per second."""
    every = max(1, steps // 64)
    found = [abs(places[i] - math.cos(chi * i / steps)) for i in range(every, len(places), every)]
    return max(found, default=math.nan)


def spectral_radius(a: float, b: float, c: float, d: float) -> float:
    """Return the largest magnitude of an eigenvalue of the matrix with rows (a, b) and (c, d)."""
    half, product = (a + d) / 2.0, a * d - b * c
    root = half * half - product
    if root < 0.0:  # the eigenvalues are complex conjugates
        return math.sqrt(product)
    return abs(half) + math.sqrt(root)


def limit_of(growth_at: Callable[[float], float], low: float = 1e-3, high: float = 1e3) -> float:
    """Find by bisection the value between ``low`` and ``high`` where ``growth_at`` exceeds 1."""
    while high > low * (1.0 + 1e-14):
        middle = math.sqrt(low * high)
        if not low < middle < high:
            break
        if growth_at(middle) > 1.0 + 1e-13:
            high = middle
        else:
            low = middle
    return low


def limits(name: str, duration: float) -> list[tuple[float, float, float]]:
    """Measure the stability limit k h^2 / m of an integrator for several levels of damping.

    Return tuples of d^h, the measured limit and the theoretical limit, where h is the time step.
    Undamped explicit Euler is left out, because its limit is 0.
    """
    found = []
    for kept in (0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 1.0):
        if (true := theory(name, kept)) > 0.0:
            limit = limit_of(lambda kappa, d=kept: growth_of(name, kappa, d, duration))  # type: ignore[misc]
            found.append((kept, limit, true))
    return found


def theory(name: str, kept: float) -> float:
    """Return the theoretical stability limit k h^2 / m of a spring, where h is the time step.

    ``kept`` is D = d^h, the fraction of the velocity that is left after a step. Verlet and
    Runge-Kutta apply the damping at the end of a step.
    """
    if name == "explicit Euler":
        return 1.0 / kept - 1.0
    if name in ("semi-implicit Euler", "leapfrog"):  # their matrices are similar
        return 2.0 * (1.0 + kept) / kept
    if name == "velocity Verlet":  # the determinant is D, the trace (1 + D) (1 - kappa / 2)
        return 4.0
    return limit_of(lambda kappa: spectral_radius(*_runge_kutta(kappa, kept)))


def _runge_kutta(kappa: float, kept: float) -> tuple[float, float, float, float]:
    """Return the matrix of one step of Runge-Kutta 4 on a spring with k h^2 / m = ``kappa``."""
    cosine, sine = 1.0 - kappa / 2.0 + kappa**2 / 24.0, 1.0 - kappa / 6.0
    return cosine, sine, -kept * kappa * sine, kept * cosine


def _step(
    integrator: Integrator, particle: Particle, generator: ForceGenerator, duration: float
) -> None:
    integrator([particle], lambda h: generator.update_force(particle, h), duration)


def _state(particle: Particle) -> tuple[float, float]:
    """Return the position and velocity along X. Anything that is not a number becomes NaN."""
    x, v = (getattr(vector, "x", None) for vector in (particle.position, particle.velocity))
    return number(x), number(v)


def _pair(value: object) -> tuple[float, float]:
    """Return the two numbers in a solver's result, or two NaNs if it is not a tuple of two."""
    if not (isinstance(value, tuple) and len(value) == 2):
        return math.nan, math.nan
    return number(value[0]), number(value[1])
