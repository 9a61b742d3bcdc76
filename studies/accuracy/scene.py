"""Scenes and models, the building blocks of the comparison between our engine and pymunk.

The error of a model is its largest deviation from the exact solution in any coordinate and any
frame, divided by the scene's size. So a model must be accurate all the time, not just at the end.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.integrators import Integrator, explicit_euler
from scenes.clock import RATE, deviation
from scenes.integrators import INTEGRATORS
from scenes.setup import Setup

STEPS = tuple(2**n for n in range(11))  # per frame
MANY = tuple(2**n for n in range(16))  # per frame, for pymunk
TOLERANCES = tuple(10**n for n in range(1, 13))  # 1 / tolerance, for a model that takes one
Place = Sequence[float]  # all coordinates that are compared, in m
Made = tuple[Callable[[float], object], Callable[[], Place]]  # what makes a step, and reads places


@dataclass(frozen=True)
class Outcome:
    """The result of a simulation: the positions at the end of every frame, and the work done."""

    places: Sequence[Place]
    work: int  # in units of ``Scene.counted``, the same on every computer


@dataclass(frozen=True)
class Model:
    """One way to simulate a scene, for example with a certain integrator."""

    name: str
    run: Callable[[int], Outcome]
    steps: Sequence[int] = STEPS  # to try; only 1 if more would not change the result
    by: str = "ours"  # or "the book" or "pymunk"
    is_formula: bool = False  # it knows more about the scene than its equations of motion
    takes_tolerance: bool = False  # it chooses its own steps, and ``steps`` are 1 / tolerance
    per: int = 1  # frames in which the steps are counted

    def chosen(self, steps: int) -> str:
        """Describe a number of steps, as in "3 steps per 12 frames" or "tolerance 0.001"."""
        return told_choice(steps, self.per, takes_tolerance=self.takes_tolerance)


def told_choice(steps: int, per: int, *, takes_tolerance: bool) -> str:
    """Describe steps, as in "3 steps per 12 frames", or a tolerance of 1 / ``steps``."""
    if takes_tolerance:
        return f"tolerance {1.0 / steps:g}"
    frames = "frame" if per == 1 else f"{per} frames"
    return f"{'once' if steps == 1 else f'{steps:,} steps'} per {frames}"


@dataclass(frozen=True)
class Scene:
    """A scene to simulate, such as a pendulum, with its exact solution and its models."""

    name: str
    frames: int
    scale: float  # size in m; errors are fractions of it
    truth: Callable[[float], Place]  # the exact position at a time in s
    models: Sequence[Model]
    counted: str = "evaluations of forces or formulas"
    differs: Callable[[], float] | None = None  # two independent solutions, over the scale

    def error(self, outcome: Outcome) -> float:
        """Compute the largest deviation from the truth, or infinity if it is not finite."""
        frames = enumerate(outcome.places, 1)
        return max(deviation(place, self.truth(n / RATE)) for n, place in frames) / self.scale


def solved(
    rates: Callable[[float, Any], Any],
    start: Sequence[float],
    place: Callable[[Any], Place],
    frames: int,
) -> Callable[[float], Place]:
    """Return the exact motion of a scene without a closed form, as a function of time.

    SciPy solves ``rates`` from ``start`` at the first call, with an error of about 1e-11. ``place``
    converts a state to positions.
    """

    @cache
    def places() -> list[Place]:
        from scipy.integrate import solve_ivp  # type: ignore[import-untyped]

        times = [frame / RATE for frame in range(1, frames + 1)]
        span = (0.0, times[-1])
        found = solve_ivp(rates, span, start, "DOP853", times, rtol=1e-13, atol=1e-13)
        return [place(state) for state in found.y.T]

    return framed(places)


def framed(places: Callable[[], Sequence[Place]]) -> Callable[[float], Place]:
    """Return a motion as a function of time, from its positions after every frame."""
    return lambda time: places()[round(time * RATE) - 1]


def in_frames(
    step: Callable[[float], object], place: Callable[[], Place], frames: int, steps: int
) -> list[Place]:
    """Return the positions, which ``place`` returns, after every frame of ``steps`` steps."""
    places: list[Place] = []
    # Whole steps never lag behind a frame. A clock would only add its own time to the measured one.
    duration = 1.0 / (RATE * steps)
    for _ in range(frames):
        for _ in range(steps):
            step(duration)
        places.append(place())
    return places


def places_of(particles: Sequence[Particle]) -> Place:
    """List the coordinates of all particles in one flat tuple: x1, y1, x2, y2 and so on."""
    return flat([particle.position for particle in particles])


def flat(vectors: Sequence[Vector3]) -> Place:
    """List the x and y coordinates of all vectors, in the same form."""
    return tuple([part for vector in vectors for part in (vector.x, vector.y)])


def by_integrators(make: Callable[[], Setup], frames: int) -> list[Model]:
    """Create a model for each integrator of chapter 6, for a scene with one particle."""
    fixed = []
    for name, integrator in INTEGRATORS.items():
        by = "the book" if integrator is explicit_euler else "ours"
        fixed.append(Model(name, by_setup(make, integrator, frames), by=by))

    def by_tolerance(inverse: int) -> Outcome:
        return by_setup(make, adaptive(1.0 / inverse), frames)(1)

    return [*fixed, Model("adaptive", by_tolerance, TOLERANCES, takes_tolerance=True)]


def by_setup(
    make: Callable[[], Setup], integrator: Integrator, frames: int
) -> Callable[[int], Outcome]:
    """Return a function that simulates a particle in the X-Y plane with some steps per frame.

    It counts the force evaluations as work. ``make`` creates the scene for each run.
    """

    def run(steps: int) -> Outcome:
        setup = make()
        (particle,) = setup.particles
        registry = setup.registry()
        work = 0

        def apply_forces(duration: float) -> None:
            nonlocal work
            work += 1
            registry.update_forces(duration)

        places = in_frames(
            lambda duration: integrator([particle], apply_forces, duration),
            lambda: (particle.position.x, particle.position.y),
            frames,
            steps,
        )
        return Outcome(places, work)

    return run


def exact_steps(places: Callable[[], Sequence[Place]]) -> Model:
    """Create a model that computes each frame exactly from the one before."""

    def run(_: int) -> Outcome:
        found = places()
        return Outcome(found, len(found))

    return Model("exact steps", run, (1,), is_formula=True)


def by_formula(place_at: Callable[[float], Place], frames: int, units: int = 1) -> Model:
    """Create a model that evaluates a closed form at the end of every frame, without time steps."""

    def run(_: int) -> Outcome:
        return Outcome([place_at(frame / RATE) for frame in range(1, frames + 1)], frames * units)

    return Model("closed form", run, (1,), is_formula=True)


def by_steps(
    name: str,
    make: Callable[[float], Made],
    frames: int,
    units: int = 1,
    steps: Sequence[int] = STEPS,
    **others: Any,
) -> Model:
    """Create a model from ``make``, which takes the duration of a step in s.

    Each step counts as ``units`` of work. ``others`` are fields of the model.
    """

    def run(count: int) -> Outcome:
        places = in_frames(*make(1.0 / (RATE * count)), frames, count)
        return Outcome(places, units * frames * count)

    return Model(name, run, steps, **others)
