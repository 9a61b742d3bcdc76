"""What is compared: a scene, where its truth is, and the models that run it.

A model is asked for the places at the end of every frame, at 60 frames a second, and may make any
number of steps in between. Its error is by how much any coordinate is off the truth at any of those
times, at the worst, in units of the scene's scale: a lucky instant counts for nothing.
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
from studies.stability import INTEGRATORS

if TYPE_CHECKING:
    import pymunk

RATE = 60.0  # frames a second
STEPS = tuple(2**n for n in range(11))  # a frame
MANY = tuple(2**n for n in range(16))  # of pymunk
TOLERANCES = tuple(10**n for n in range(1, 13))  # 1 / tolerance, of a model that takes one
Place = tuple[float, ...]  # the coordinates of all that is looked at, in m
Made = tuple[Particle, Sequence[ForceGenerator]]
Pull = Callable[[float, float, float, float], tuple[float, float]]  # of x, y and velocity, in N


@dataclass(frozen=True)
class Outcome:
    """The places at the end of every frame, and how often forces, or a formula, were worked out."""

    places: list[Place]
    work: int


@dataclass(frozen=True)
class Model:
    """A way to run a scene, in so many steps a frame. ``by`` says whose it is.

    That is "ours", "the book" or "pymunk". One that is exact has no steps to choose: (1,). One that
    chooses its own steps is given a tolerance instead: then ``takes_tolerance`` is true, and
    ``steps`` are numbers n for a tolerance of 1 / n, so that a larger number is finer here too.
    """

    name: str
    run: Callable[[int], Outcome]
    steps: Sequence[int] = STEPS
    by: str = "ours"
    takes_tolerance: bool = False


@dataclass(frozen=True)
class Scene:
    """A scene of so many frames. ``truth`` has the place at a time in s; ``scale`` is in m.

    ``counted`` says what the models count as their work. Where the truth is neither a closed form
    nor SciPy's solution of one equation, ``differs`` is by how much two independent ways to it
    differ, in units of the scale.
    """

    name: str
    frames: int
    scale: float
    truth: Callable[[float], Place]
    models: Sequence[Model]
    counted: str = "evaluations of forces or formulas"
    differs: Callable[[], float] | None = None

    def error(self, outcome: Outcome) -> float:
        """Return the largest error of a coordinate, in units of the scale; inf for a NaN."""
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
    """Return the truth of a scene without a closed form, from its equations of motion.

    ``rates`` are the equations for SciPy, of a time and a state that is ``start`` at first, and
    ``place`` is what a state looks like. The truth is known at the end of every frame, and solved
    for when it is asked for the first time. It is right to about 1e-11: ten thousand times nearer
    than the tightest tolerance.
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
    """Let frames pass in so many steps each, and return the place at the end of every one."""
    places: list[Place] = []
    duration = 1.0 / (RATE * steps)
    for _ in range(frames):
        for _ in range(steps):
            step(duration)
        places.append(place())
    return places


def by_integrators(make: Callable[[], Made], frames: int) -> list[Model]:
    """Return a model for each integrator of chapter 6, of one particle and its forces."""
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
    """Return the model that is given a tolerance, and chooses its own steps in every frame."""

    def run(finer: int) -> Outcome:
        return by_forces(make, adaptive(1.0 / finer), frames)(1)

    return Model("adaptive", run, TOLERANCES, takes_tolerance=True)


def by_forces(
    make: Callable[[], Made], integrator: Integrator, frames: int
) -> Callable[[int], Outcome]:
    """Return what steps a particle in the X-Y plane by an integrator, and counts evaluations."""

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
    """Return the model that asks a closed form once a frame."""

    def run(_: int) -> Outcome:
        return Outcome([place_at(frame / RATE) for frame in range(1, frames + 1)], frames)

    return Model("closed form", run, (1,))


def by_pymunk(
    name: str,
    make: Callable[[], tuple[pymunk.Space, pymunk.Body]],
    frames: int,
    pull: Pull | None = None,
) -> Model:
    """Return the model that steps a body of pymunk, which works forces out once a step.

    ``pull`` is a force that is given to it by hand before every step: it has none but gravity and
    its springs of its own.
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
    """Return a space of pymunk without gravity, and the one body in it."""
    import pymunk  # here, since a chapter's plots can do without

    space = pymunk.Space()
    body = pymunk.Body(mass, 1.0)
    body.position, body.velocity = (place[0], place[1]), (velocity[0], velocity[1])
    space.add(body)
    return space, body
