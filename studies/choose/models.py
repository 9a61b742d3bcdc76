"""Work out from the contents of a world which models can run it.

- A world without contacts can use every integrator of chapter 6. Without forces as well, the closed
  form is exact.
- If all contacts come from rods and cables, a net can solve for all tensions at once.
- If all contacts come from detectors, time division can stop at each impact.
- With contacts of any kind, a model can take a step and then resolve them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from ch04_particle_engine.closed_form import state_after
from ch06_springs.adaptive import adaptive
from ch06_springs.integrators import Integrator
from ch07_constraints.detectors import Detectors
from ch07_constraints.direct_net import DirectNet
from ch07_constraints.net import LINKS
from ch07_constraints.smooth_net import SmoothNet
from ch07_constraints.time_division import time_division_step
from ch08_mass_aggregate.world import ParticleWorld
from studies.accuracy.scene import STEPS, TOLERANCES
from studies.runs.stability import INTEGRATORS

Step = Callable[[float], object]
ORDERS = {"leapfrog": 2, "velocity Verlet": 2, "Runge-Kutta 4": 4}  # the others have order 1


@dataclass(frozen=True)
class Model:
    """A method of stepping a world, and the order of convergence that it should have.

    ``step_of`` takes a new world and returns the function that steps it. The numbers in ``choices``
    are steps per frame. If ``takes_tolerance`` is true, they are 1 / tolerance instead, and the
    error is proportional to the tolerance.
    """

    name: str
    order: int
    step_of: Callable[[ParticleWorld], Step]
    choices: Sequence[int] = STEPS
    takes_tolerance: bool = False

    def chosen(self, choice: int) -> str:
        """Describe a choice in words, such as "4 steps per frame"."""
        if self.takes_tolerance:
            return f"tolerance {1.0 / choice:g}"
        return "once per frame" if choice == 1 else f"{choice} steps per frame"

    def steps_of(self, world: ParticleWorld, choice: int) -> tuple[Step, int]:
        """Set up ``world`` for a run with one number of steps per frame, or with one tolerance.

        Return a function that advances the world by one step, and the number of steps per frame.
        """
        if self.takes_tolerance:
            world.integrator = adaptive(1.0 / choice)
            return self.step_of(world), 1
        return self.step_of(world), choice


def models_of(world: ParticleWorld) -> list[Model]:
    """Return the models that can run a world like this one."""
    damped = any(p.damping != 1.0 for p in world.particles if p.inverse_mass)
    if type(world) is not ParticleWorld:  # a subclass may do more in its step
        return [Model("its own step", 1, lambda world: world.step)]
    if world.contact_generators:
        return [*_special(world), *(_resolving(name) for name in INTEGRATORS)]
    found = [] if world.registry.pairs() else [Model("exact steps", 1, _exact, STEPS[:3])]
    for name, integrator in INTEGRATORS.items():
        order = 1 if damped else ORDERS.get(name, 1)
        found.append(Model(name, order, _with(integrator)))
    if not damped:  # adaptive damps once per frame, which no tolerance makes more accurate
        found.append(Model("adaptive", 1, _adaptive, TOLERANCES, takes_tolerance=True))
    return found


def _special(world: ParticleWorld) -> list[Model]:
    """Return models for worlds whose contacts come only from links, or only from detectors."""
    generators = world.contact_generators
    if all(isinstance(g, LINKS) and not getattr(g, "restitution", 0.0) for g in generators):
        return [Model("direct net", 2, _direct_net), Model("smooth net", 4, _smooth_net)]
    if all(hasattr(generator, "next_impact") for generator in generators):
        return [Model("time division", 1, _time_division)]
    return []


def _with(integrator: Integrator) -> Callable[[ParticleWorld], Step]:
    """Return a function that builds the step of a world without contacts."""

    def step_of(world: ParticleWorld) -> Step:
        particles, forces = world.particles, world.registry.update_forces
        return lambda duration: integrator(particles, forces, duration)

    return step_of


def _adaptive(world: ParticleWorld) -> Step:
    return _with(world.integrator)(world)


def _resolving(name: str) -> Model:
    """Return the model that steps with an integrator and then resolves the contacts."""

    def step_of(world: ParticleWorld) -> Step:
        world.integrator = INTEGRATORS[name]
        return world.step

    return Model(f"{name}, then contacts", 1, step_of)


def _exact(world: ParticleWorld) -> Step:
    """Step the particles by the closed form for constant acceleration and linear drag."""

    def step(duration: float) -> None:
        for particle in world.particles:
            if particle.inverse_mass:
                particle.position, particle.velocity = state_after(particle, duration)

    return step


def _direct_net(world: ParticleWorld) -> Step:
    net, forces = DirectNet(world.contact_generators, world.particles), world.registry

    def step(duration: float) -> None:
        forces.update_forces(duration)
        net.step(duration)

    return step


def _smooth_net(world: ParticleWorld) -> Step:
    net, forces = SmoothNet(world.contact_generators, world.particles), world.registry
    return lambda duration: net.step(duration, forces.update_forces)


def _time_division(world: ParticleWorld) -> Step:
    generators: list[Any] = world.contact_generators
    detectors, forces = Detectors(*generators), world.registry

    def step(duration: float) -> None:
        forces.update_forces(duration)
        time_division_step(world.particles, detectors, duration)

    return step
