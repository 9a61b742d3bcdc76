"""A spring that is too stiff for the time step, and ground that acts as such a spring.

A step of h s multiplies (x, v h) of 1 kg by a matrix. An oscillation grows if an eigenvalue of the
matrix exceeds 1 in magnitude.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler, watched
from ch06_springs.penalty import PenaltyGround
from ch06_springs.springs import FakeStiffSpring
from scenes.clock import FRAME, Move, Track, track, tracks
from scenes.integrators import INTEGRATORS, SOLVERS, Solver
from scenes.readings import numbers, stopped
from scenes.spring_on_a_wall import SpringOnAWall

Matrix = tuple[float, float, float, float]  # row by row


class Pull:
    """A spring that pulls toward 0, independent of the engine's own springs and their bugs."""

    def __init__(self, stiffness: float) -> None:
        self.stiffness = stiffness
        self.count = 0  # evaluations of the force

    def update_force(self, particle: Particle, duration: float) -> None:
        del duration
        self.count += 1
        particle.add_force(Vector3(-self.stiffness * particle.position.x))


def stepping(
    name: str, damping: float, kappa: float, solvers: Mapping[str, Solver] = SOLVERS
) -> tuple[Integrator, Pull, float]:
    """Return an integrator, a spring with k h^2 / m = ``kappa``, and the damping of the particle.

    ``damping`` is d^h with the particle's d, or for ``solvers``, c h / m with the spring's c.
    """
    k = kappa / FRAME**2
    if name in INTEGRATORS:
        return INTEGRATORS[name], Pull(k), damping ** (1.0 / FRAME)
    return SpringOnAWall(k, damping / FRAME).solved_by(solvers[name]), Pull(k), 1.0


def watching(integrator: Integrator, limit: float) -> Integrator:
    """Make an integrator raise an error above ``limit`` m/s, if ``watched`` is written."""
    try:
        step = watched(integrator, limit)
    except NotImplementedError:
        return integrator
    return step if callable(step) else integrator


def swing(
    integrator: Integrator,
    generator: ForceGenerator,
    damping: float = 1.0,
    *,
    steps: int,
    limit: float,
    duration: float = FRAME,
) -> tuple[Track, Track]:
    """Release a body at x = 1 m, and record x and v, until its speed exceeds ``limit`` in m/s."""
    body = Particle(Vector3(1.0), damping=damping)
    move = _moving(watching(integrator, limit), body, generator)
    measures = [lambda: _state(body)[0], lambda: _state(body)[1]]
    places, velocities = tracks(move, measures, steps, duration)
    return places, velocities


def step_matrix(integrator: Integrator, generator: ForceGenerator, damping: float = 1.0) -> Matrix:
    """Measure the matrix of a step, which multiplies (x, v h). It is NaN if the engine fails."""
    columns = []
    for x, v in ((1.0, 0.0), (0.0, 1.0 / FRAME)):
        body = Particle(Vector3(x), Vector3(v), damping=damping)
        move = _moving(integrator, body, generator)
        if stopped(lambda move=move: move(FRAME)):  # type: ignore[misc]
            return math.nan, math.nan, math.nan, math.nan
        columns.append(_state(body))
    (a, c), (b, d) = columns
    return a, b, c * FRAME, d * FRAME


def growth(integrator: Integrator, generator: ForceGenerator, damping: float = 1.0) -> float:
    """Return how much an oscillation grows in each time step, in the long run, as a factor."""
    return spectral_radius(*step_matrix(integrator, generator, damping))


def growth_of(
    name: str, damping: float, kappa: float, solvers: Mapping[str, Solver] = SOLVERS
) -> float:
    """Return the growth per time step of an oscillation with the arguments of ``stepping``."""
    return growth(*stepping(name, damping, kappa, solvers))


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


def theory(name: str, kept: float) -> float:
    """Return the theoretical limit of k h^2 / m for an integrator and ``kept`` = D = d^h."""
    if name == "explicit Euler":
        return 1.0 / kept - 1.0
    if name in ("semi-implicit Euler", "leapfrog"):  # their matrices are similar
        return 2.0 * (1.0 + kept) / kept
    if name == "velocity Verlet":  # the determinant is D, the trace (1 + D) (1 - kappa / 2)
        return 4.0
    return limit_of(lambda kappa: spectral_radius(*_runge_kutta(kappa, kept)))


def _runge_kutta(kappa: float, kept: float) -> Matrix:
    """Return the matrix of a step of Runge-Kutta 4 on a spring with k h^2 / m = ``kappa``."""
    cosine, sine = 1.0 - kappa / 2.0 + kappa**2 / 24.0, 1.0 - kappa / 6.0
    return cosine, sine, -kept * kappa * sine, kept * cosine


def faked_growth(angle: float, share: float) -> float:
    """Return a FakeStiffSpring's growth per step, from its phase and share of critical damping."""
    chi = angle / FRAME
    return growth(semi_implicit_euler, FakeStiffSpring(Vector3(), chi * chi, 2.0 * share * chi))


def bounces(stiffness: float, fall: float, steps: int) -> list[float]:
    """Drop a 1 kg body onto an undamped PenaltyGround, and return its height after each step."""
    body = Particle(Vector3(0.0, fall), acceleration=Vector3(0.0, -10.0))
    move = _moving(watching(semi_implicit_euler, 1e4), body, PenaltyGround(0.0, stiffness))
    return track(move, lambda: numbers(body.position)[1], steps).values


def _moving(integrator: Integrator, body: Particle, generator: ForceGenerator) -> Move:
    """Return a function that takes a step of a body, without a registry and its possible bugs."""
    return lambda duration: integrator([body], lambda h: generator.update_force(body, h), duration)


def _state(body: Particle) -> tuple[float, float]:
    return numbers(body.position)[0], numbers(body.velocity)[0]
