"""List the methods, called models, that can simulate a scene written by a user.

Without contacts, every integrator of chapter 6 can be used, or a closed form without forces. Rods
and cables allow a solver of all tensions at once. Detectors allow time division, which stops a step
at each impact. With any contacts, small steps or an integrator before a resolver can be used.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from ch04_particle_engine.closed_form import state_after
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.integrators import Integrator
from ch07_constraints.detectors import Detectors
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.time_division import time_division_step
from ch08_mass_aggregate.world import ParticleWorld
from scenes.integrators import INTEGRATORS
from studies.accuracy.scene import STEPS, TOLERANCES, told_choice
from studies.models.direct_net import DirectNet
from studies.models.net import LINKS
from studies.models.smooth_net import SmoothNet

Step = Callable[[float], object]
ORDERS = {"leapfrog": 2, "velocity Verlet": 2, "Runge-Kutta 4": 4}  # the others have order 1


@dataclass(frozen=True)
class Model:
    """A simulation method, such as Runge-Kutta 4, and the step sizes to try."""

    name: str
    order: int  # of convergence, in theory
    step_of: Callable[[ParticleWorld], Step]  # from a newly built world to what advances it
    choices: Sequence[int] = STEPS  # per frame, or 1 / tolerance
    takes_tolerance: bool = False  # it chooses its own steps, and its error follows it

    def chosen(self, choice: int) -> str:
        """Return the number of steps per frame, or the tolerance, as in "4 steps per frame"."""
        return told_choice(choice, 1, takes_tolerance=self.takes_tolerance)

    def steps_of(self, world: ParticleWorld, choice: int) -> tuple[Step, int]:
        """Return what advances the world by one step, and the number of calls per frame."""
        if self.takes_tolerance:
            world.integrator = adaptive(1.0 / choice)
            return self.step_of(world), 1
        return self.step_of(world), choice


def models_of(world: ParticleWorld) -> list[Model]:
    """List the simulation methods that suit the particles, forces and contacts of a world."""
    damped = any(p.damping != 1.0 for p in world.particles if p.inverse_mass)
    if type(world) is not ParticleWorld:  # a subclass may do more in its step
        return [Model("its own step", 1, lambda world: world.step)]
    if world.contact_generators:
        return [*_special(world), *(_resolving(name) for name in INTEGRATORS)]
    found = [] if world.registry.pairs() else [Model("exact steps", 1, _exact, STEPS[:3])]
    orders = {} if damped else ORDERS
    found += [Model(name, orders.get(name, 1), _with(one)) for name, one in INTEGRATORS.items()]
    if not damped:  # adaptive damps once per frame, which no tolerance makes more accurate
        found.append(
            Model("adaptive", 1, lambda w: _with(w.integrator)(w), TOLERANCES, takes_tolerance=True)
        )
    return found


def _special(world: ParticleWorld) -> list[Model]:
    """List the models for a world with contacts that do not use its resolver."""
    generators = world.contact_generators
    found = []
    if all(isinstance(g, LINKS) and not getattr(g, "restitution", 0.0) for g in generators):
        direct = _after_forces(lambda w: DirectNet(w.contact_generators, w.particles).step)
        found = [Model("direct net", 2, direct), Model("smooth net", 4, _smooth_net)]
    elif all(hasattr(generator, "next_impact") for generator in generators):
        found = [
            Model("time division", 1, _after_forces(_time_division)),
            Model("sequential impulses", 1, _of_all(SequentialImpulses)),
        ]
    return [*found, Model("small steps", 1, _of_all(SmallSteps))]


def _with(integrator: Integrator) -> Callable[[ParticleWorld], Step]:
    """Build a model's ``step_of`` function, which uses ``integrator`` and ignores contacts."""

    return lambda world: partial(integrator, world.particles, world.registry.update_forces)


def _resolving(name: str) -> Model:
    """Create a model that moves particles with an integrator and then resolves their contacts."""

    def step_of(world: ParticleWorld) -> Step:
        world.integrator = INTEGRATORS[name]
        return world.step

    return Model(f"{name}, then contacts", 1, step_of)


def _exact(world: ParticleWorld) -> Step:
    """Move the particles with the closed form for constant acceleration and linear drag."""

    def step(duration: float) -> None:
        for particle in world.particles:
            if particle.inverse_mass:
                particle.position, particle.velocity = state_after(particle, duration)

    return step


def _smooth_net(world: ParticleWorld) -> Step:
    net, forces = SmoothNet(world.contact_generators, world.particles), world.registry
    return lambda duration: net.step(duration, forces.update_forces)


def _time_division(world: ParticleWorld) -> Step:
    generators: list[Any] = world.contact_generators
    return partial(time_division_step, world.particles, Detectors(*generators))


def _after_forces(make: Callable[[ParticleWorld], Step]) -> Callable[[ParticleWorld], Step]:
    """Return a ``step_of`` function whose steps evaluate the forces, and then move the world."""

    def step(world: ParticleWorld, move: Step, duration: float) -> None:
        world.registry.update_forces(duration)
        move(duration)

    return lambda world: partial(step, world, make(world))


def _of_all(solver: Callable[[Any, Any], Any]) -> Callable[[ParticleWorld], Step]:
    """Return the ``step_of`` function of a solver of all particles and contacts."""
    return _after_forces(lambda world: solver(world.particles, world.contact_generators).step)
