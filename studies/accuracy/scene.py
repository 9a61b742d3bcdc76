"""Define what a scene is when our engine is compared with pymunk, and the models that simulate it.

A scene, such as a pendulum, has an exact solution. A model is one way to simulate the scene, such
as an integrator, and may take any number of steps per frame. It returns the positions at the end of
every frame, at 60 frames per second. Its error is the largest deviation of any coordinate from the
exact solution at the end of any frame, as a fraction of the scene's scale. A model therefore has to
be accurate all along, not just at the end of the run.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from ch05_forces.forces import ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.adaptive import adaptive
from ch06_springs.integrators import Integrator, explicit_euler
from studies.runs.stability import INTEGRATORS

if TYPE_CHECKING:
    import pymunk

RATE = 60.0  # frames per second
STEPS = tuple(2**n for n in range(11))  # per frame
MANY = tuple(2**n for n in range(16))  # per frame, for pymunk
TOLERANCES = tuple(10**n for n in range(1, 13))  # 1 / tolerance, for a model that takes one
Place = tuple[float, ...]  # all coordinates that are compared, in m
Made = tuple[Particle, Sequence[ForceGenerator]]
Pull = Callable[[float, float, float, float], tuple[float, float]]  # N, from x, y and velocity


@dataclass(frozen=True)
class Outcome:
    """The result of simulating a scene: the positions at the end of every frame, and the work.

    The work is the number of force evaluations, unless the scene's ``counted`` says otherwise.
    """

    places: list[Place]
    work: int


@dataclass(frozen=True)
class Model:
    """One way to simulate a scene, such as an integrator, at a given number of steps per frame.

    ``by`` says whose method it is: "ours", "the book" or "pymunk". An exact model has no step count
    to choose, so its ``steps`` is (1,). If ``takes_tolerance`` is true, the model chooses its own
    steps, and the numbers in ``steps`` are 1 / tolerance, so that a larger number still means a
    more accurate run.
    """

    name: str
    run: Callable[[int], Outcome]
    steps: Sequence[int] = STEPS
    by: str = "ours"
    takes_tolerance: bool = False


@dataclass(frozen=True)
class Scene:
    """A scene to simulate, such as a pendulum, with its exact solution and its models.

    ``truth`` returns the exact position at a time in s. ``scale`` is the size of the scene in m.
    ``models`` are the ways to simulate it, and ``counted`` says what they count as work.

    The exact solution is usually a closed form, or SciPy's solution of a single equation. When it
    is neither, ``differs`` checks it by solving the scene in two independent ways, and returns the
    difference as a fraction of the scale.
    """

    name: str
    frames: int
    scale: float
    truth: Callable[[float], Place]
    models: Sequence[Model]
    counted: str = "evaluations of forces or formulas"
    differs: Callable[[], float] | None = None

    def error(self, outcome: Outcome) -> float:
        """Compute the error of a simulation, as a fraction of the scene's scale.

        It is the largest deviation of any coordinate from the exact solution at the end of any
        frame. If a coordinate is not finite, the error is infinite.
        """
        worst = 0.0
        for frame, place in enumerate(outcome.places, 1):
            for found, true in zip(place, self.truth(frame / RATE), strict=True):
                worst = max(worst, abs(found - true)) if math.isfinite(found) else math.inf
        return worst / self.scale


def solved(
    rates: Callable[[float, Any], Any],
    start: Sequence[float],
    place: Callable[[Any], Place],
    frames: int,
) -> Callable[[float], Place]:
    """Return the exact motion of a scene that has no closed form, as a function of time.

    SciPy solves the equations of motion for the end of every frame when the function is first
    called. Its error of about 1e-11 is far below the tightest tolerance. ``rates`` are the
    equations, as a function of time and state in the form that SciPy expects. ``start`` is the
    initial state, and ``place`` converts a state to positions.
    """

    @cache
    def places() -> list[Place]:
        from scipy.integrate import solve_ivp  # type: ignore[import-untyped]

        times = [frame / RATE for frame in range(1, frames + 1)]
        span = (0.0, times[-1])
        found = solve_ivp(rates, span, start, "DOP853", times, rtol=1e-13, atol=1e-13)
        return [place(state) for state in found.y.T]

    return lambda time: places()[round(time * RATE) - 1]


def in_frames(
    step: Callable[[float], object], place: Callable[[], Place], frames: int, steps: int
) -> list[Place]:
    """Simulate a scene with ``steps`` steps per frame, and return its positions after every frame.

    ``step`` advances the simulation by a time in s, and ``place`` returns its current positions.
    """
    places: list[Place] = []
    duration = 1.0 / (RATE * steps)
    for _ in range(frames):
        for _ in range(steps):
            step(duration)
        places.append(place())
    return places


def by_integrators(make: Callable[[], Made], frames: int) -> list[Model]:
    """Create a model for each integrator of chapter 6, to simulate a single particle.

    ``make`` returns the particle and its force generators. The last model is the adaptive
    integrator, which chooses its own steps.
    """
    fixed = [
        Model(
            name,
            by_forces(make, integrator, frames),
            by="the book" if integrator is explicit_euler else "ours",
        )
        for name, integrator in INTEGRATORS.items()
    ]
    return [*fixed, by_tolerance(make, frames)]


def by_tolerance(make: Callable[[], Made], frames: int) -> Model:
    """Create a model that simulates a particle with chapter 6's adaptive integrator.

    The integrator chooses its own steps within every frame, so the model takes a tolerance instead
    of a number of steps.
    """

    def run(finer: int) -> Outcome:
        return by_forces(make, adaptive(1.0 / finer), frames)(1)

    return Model("adaptive", run, TOLERANCES, takes_tolerance=True)


def by_forces(
    make: Callable[[], Made], integrator: Integrator, frames: int
) -> Callable[[int], Outcome]:
    """Return a function that simulates a particle in the X-Y plane and counts force evaluations.

    Its argument is the number of steps per frame. ``make`` returns a new particle and its force
    generators for each run.
    """

    def run(steps: int) -> Outcome:
        particle, generators = make()
        registry = ForceRegistry()
        for generator in generators:
            registry.add(particle, generator)
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


def by_formula(place_at: Callable[[float], Place], frames: int) -> Model:
    """Create a model without time steps, which evaluates a closed form once per frame.

    ``place_at`` returns the position at a time in s.
    """

    def run(_: int) -> Outcome:
        return Outcome([place_at(frame / RATE) for frame in range(1, frames + 1)], frames)

    return Model("closed form", run, (1,))


def by_pymunk(
    name: str,
    make: Callable[[], tuple[pymunk.Space, pymunk.Body]],
    frames: int,
    pull: Pull | None = None,
) -> Model:
    """Create a model that simulates one body with pymunk, evaluating its forces once per step.

    ``make`` returns a space and the body. ``pull`` is a force that the model applies before every
    step. Without it, only gravity and pymunk's own springs act on the body.
    """

    def run(steps: int) -> Outcome:
        space, body = make()

        def pulled(duration: float) -> None:
            assert pull is not None
            place = body.position
            body.apply_force_at_world_point(pull(place.x, place.y, *body.velocity), place)
            space.step(duration)

        step = space.step if pull is None else pulled
        places = in_frames(step, lambda: (body.position.x, body.position.y), frames, steps)
        return Outcome(places, frames * steps)

    return Model(name, run, MANY, "pymunk")


def space_with(place: Place, velocity: Place, mass: float) -> tuple[pymunk.Space, pymunk.Body]:
    """Create a pymunk space without gravity that has a single body, and return both."""
    import pymunk  # here, because a chapter's plots do not need it

    space = pymunk.Space()
    body = pymunk.Body(mass, 1.0)
    body.position, body.velocity = (place[0], place[1]), (velocity[0], velocity[1])
    space.add(body)
    return space, body
