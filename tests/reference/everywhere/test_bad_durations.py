"""Each entry point rejects a bad duration with a clear message, and changes nothing."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.particle import Particle as PlainParticle
from ch04_particle_engine.ballistics import BallisticRange
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.display import Display, tick
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow
from ch05_forces.forces import Airbrake, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch05_forces.sniper import SniperRange
from ch06_springs import integrators, springs
from ch06_springs.adaptive import adaptive
from ch07_constraints.angle_chain import AngleChain
from ch07_constraints.angle_pendulum import AnglePendulum, DoublePendulum
from ch07_constraints.angle_rope import AngleRope
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch07_constraints.direct_chain import DirectChain
from ch07_constraints.heap_resolver import HeapResolver
from ch07_constraints.sequential_impulses import SequentialImpulses
from ch07_constraints.small_steps import SmallSteps
from ch07_constraints.time_division import time_division_step
from ch08_mass_aggregate.ball_game import BallGame
from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.cube import Cube
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.tilting_platform import TiltingPlatform
from ch08_mass_aggregate.trebuchet import Trebuchet, my_design
from ch08_mass_aggregate.wheel import Wheel
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
NO_TIME = (math.nan, math.inf, -math.inf, 10**400, "1", None, [1.0], 1j)

Entry = tuple[object, Callable[[Any], object]]  # the state, and a function of the duration


def body(kind: type[PlainParticle] = Particle) -> Any:
    """Return a moving particle, with a force added by hand if its kind supports forces."""
    one = kind(Vector3(0.5, 0.1), Vector3(1.0, -2.0, 3.0), Vector3(0.0, -9.81), damping=0.9)
    if isinstance(one, Particle):
        one.add_force(Vector3(3.0, 2.0, 1.0))
    return one


def plain(method: str, kind: type[PlainParticle]) -> Entry:
    one = body(kind)
    return one, getattr(one, method)


def shots() -> Entry:
    place = BallisticRange()
    place.fire("pistol")
    return place, place.update


def show() -> FireworksShow:
    rule = FireworkRule(1, 0.5, 1.0, Vector3(), Vector3(1.0, 2.0), 0.9, ())
    fireworks = FireworksShow([rule], 10, 1)
    fireworks.launch(1)
    return fireworks


def sparks() -> Entry:
    wheel = CatherineWheel(show(), 1, Vector3(0.0, 9.0), 1.0, 3.0, 60.0)
    return wheel, wheel.update


def clicks() -> Entry:
    display = Display(show())
    return display, partial(tick, display)


def bullet() -> Entry:
    place = SniperRange(1)
    place.shoot(0.0, 0.0)
    return place, place.update


def forces() -> Entry:
    one, registry = body(), ForceRegistry()
    registry.add(one, Gravity(Vector3(0.0, -9.81)))
    return (one, registry), registry.update_forces


def generator(make: Callable[[], Any]) -> Entry:
    one = body()
    return one, lambda duration: make().update_force(one, duration)


def brake() -> Airbrake:
    found = Airbrake(1.0)
    found.on = True
    return found


def step(integrator: integrators.Integrator) -> Entry:
    bodies, registry = [body(), body()], ForceRegistry()
    springs.connect(registry, *bodies, 10.0, 1.0)
    call = partial(integrator, bodies, registry.update_forces)
    return (bodies, registry), call


def contact(method: str) -> Entry:
    found = Contact(body(), None, Vector3(0.0, 1.0), 0.5, 0.1)
    return found, getattr(found, method)


def resolver(kind: type[ContactResolver]) -> Entry:
    found, ends = Contact(body(), body(), Vector3(0.0, 1.0), 0.5, 0.1), kind()
    return (found, ends), partial(ends.resolve_contacts, [found])


def detector(make: Callable[[Sequence[Particle]], Any]) -> Entry:
    bodies = [body(), body()]
    return bodies, make(bodies).next_impact


def division() -> Entry:
    bodies = [body()]
    return bodies, partial(time_division_step, bodies, GroundPlane(bodies))


def chain(steps: int) -> Entry:
    bodies = [body()]
    found = DirectChain(bodies, Vector3())
    for _ in range(steps):
        found.step(FRAME)
    bodies[0].add_force(Vector3(1.0))
    return found, found.step


def solver(kind: Callable[..., Any]) -> Entry:
    bodies = [body()]
    found = kind(bodies, [GroundPlane(bodies, height=1.0)])
    return bodies, found.step


def by_angles(make: Callable[[], Any]) -> Entry:
    found = make()
    return found, found.step


def lax(
    particles: Sequence[Particle], apply_forces: integrators.ApplyForces, duration: float
) -> None:
    """Step as a user might write it: without any checks, and moving before evaluating forces."""
    for particle in particles:
        particle.position.add_scaled(particle.velocity, duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)


def world(method: str, integrator: integrators.Integrator, kind: type[ParticleWorld]) -> Entry:
    """Return a world with one particle at rest, which may sleep, and one that flies."""
    bodies = [Particle(), body()]
    bodies[1].position = Vector3(2.0, 5.0)
    found = kind(bodies, [GroundPlane(bodies)], integrator=integrator)
    for _ in range(40):
        found.step(FRAME)
    for one in bodies:
        one.add_force(Vector3(1.0, 2.0, 3.0))
    return found, getattr(found, method)


def scene(make: Callable[[], Any]) -> Entry:
    found = make()
    for _ in range(3):
        found.step(FRAME)
    for one in found.world.particles:
        one.add_force(Vector3(1.0, 2.0, 3.0))
    found.pace, found.push, found.direction = 1.0, Vector3(1.0), 1
    return found, found.step


def ended_game() -> BallGame:
    game = BallGame()
    game.rules.lives = 0
    return game


NOT_NEGATIVE: dict[str, Callable[[], Entry]] = {
    "Contact.velocity_after": partial(contact, "velocity_after"),
    "Contact.resolve_velocity": partial(contact, "resolve_velocity"),
    "GroundPlane": partial(detector, GroundPlane),
    "ParticlePairs": partial(detector, lambda bodies: ParticlePairs(bodies, 0.1)),
    "Detectors": partial(detector, lambda bodies: Detectors(GroundPlane(bodies))),
}
POSITIVE: dict[str, Callable[[], Entry]] = {
    "integrate of chapter 3": partial(plain, "integrate", PlainParticle),
    "integrate of chapter 5": partial(plain, "integrate", Particle),
    "damp_per_frame": lambda: (None, partial(damp_per_frame, Vector3(1.0), Vector3(), 0.5)),
    "damp_per_second": lambda: (None, partial(damp_per_second, Vector3(1.0), Vector3(), 0.5)),
    "BallisticRange": shots,
    "FireworksShow": lambda: (found := show(), found.update),
    "CatherineWheel": sparks,
    "Display": clicks,
    "SniperRange": bullet,
    "ForceRegistry": forces,
    "Airbrake": partial(generator, brake),
    "FakeStiffSpring": partial(generator, partial(springs.FakeStiffSpring, Vector3(), 9.0, 0.1)),
    **{
        name: partial(step, getattr(integrators, name))
        for name in (
            "explicit_euler",
            "semi_implicit_euler",
            "leapfrog",
            "velocity_verlet",
            "runge_kutta_4",
        )
    },
    "adaptive": lambda: step(adaptive(1e-6)),
    "watched": lambda: step(integrators.watched(integrators.leapfrog, 1e3)),
    "backward_euler": lambda: (None, partial(integrators.backward_euler, 1.0, 0.0, 9.0, 0.1, 1.0)),
    "trapezoidal": lambda: (None, partial(integrators.trapezoidal, 1.0, 0.0, 9.0, 0.1, 1.0)),
    "max_stable_stiffness": lambda: (None, partial(springs.max_stable_stiffness, 0.9)),
    "Contact.resolve": partial(contact, "resolve"),
    "ContactResolver": partial(resolver, ContactResolver),
    "HeapResolver": partial(resolver, HeapResolver),
    "time_division_step": division,
    "SequentialImpulses": partial(solver, SequentialImpulses),
    "SmallSteps": partial(solver, SmallSteps),
    "DirectChain, first frame": partial(chain, 0),
    "DirectChain": partial(chain, 3),
    "AnglePendulum": partial(by_angles, lambda: AnglePendulum(1.0, 1.0)),
    "DoublePendulum": partial(
        by_angles, lambda: DoublePendulum([1.0, 2.0], [1.0, 2.0], [1.0, 2.0])
    ),
    "AngleChain": partial(by_angles, lambda: AngleChain([1.0] * 3, [2.0] * 3, [0.5] * 3)),
    "AngleRope": partial(by_angles, lambda: AngleRope(1.0, 2.0, [0.5] * 3)),
    **{
        f"{kind.__name__}.{method}, {title}": partial(world, method, integrator, kind)
        for kind in (ParticleWorld, SleepingWorld)
        for method in ("run_physics", "step")
        for title, integrator in (("a step", integrators.leapfrog), ("a lax step", lax))
    },
    **{
        kind.__name__: partial(scene, kind)
        for kind in (Blob, BallGame, Bridge, Cube, TiltingPlatform, Wheel)
    },
    "BallGame that is over": partial(scene, ended_game),
    "Trebuchet": partial(scene, lambda: Trebuchet(my_design())),
    "FixedStep": lambda: (None, partial(FixedStep, print)),
}
BEFORE_NOW = (-1.0, -1, -5e-324)
NOTHING = (0.0, -0.0, 0)
CASES = [
    *((name, make, (*NO_TIME, *BEFORE_NOW)) for name, make in NOT_NEGATIVE.items()),
    *((name, make, (*NO_TIME, *BEFORE_NOW, *NOTHING)) for name, make in POSITIVE.items()),
]
NAMES = [name for name, _, _ in CASES]


@pytest.mark.parametrize(("make", "wrong"), [case[1:] for case in CASES], ids=NAMES)
def test_it_is_refused_by_name_and_changes_nothing(
    make: Callable[[], Entry], wrong: Sequence[Any]
) -> None:
    """The state is compared by pickling it, which includes every reachable number."""
    state, call = make()
    before = pickle.dumps(state)
    for duration in wrong:
        error = ValueError if isinstance(duration, (int, float)) else TypeError
        with pytest.raises(error, match="duration must be"):
            call(duration)
        assert pickle.dumps(state) == before, repr(duration)


@pytest.mark.parametrize("make", [case[1] for case in CASES], ids=NAMES)
def test_what_is_right_is_not_refused(make: Callable[[], Entry]) -> None:
    """An entry that rejects everything would fail here."""
    _, call = make()
    call(FRAME)
