"""Steps that reject a bad duration with a clear message, and then nothing has changed.

These are the given modules, and the steps whose graded checks don't look at the state afterwards.
"""

from __future__ import annotations

import math
import pickle
import re
from collections.abc import Callable, Sequence
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch04_particle_engine.display import Display, tick
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, Payload
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.going_further.camera import SpringCamera
from ch06_springs.integrators import ApplyForces
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.angle_pendulum import AnglePendulum, DoublePendulum
from ch07_constraints.going_further.direct_chain import DirectChain
from ch07_constraints.going_further.rewinding import rewinding_step
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredCable
from ch08_mass_aggregate.ball_game import BallGame
from ch08_mass_aggregate.blob import Blob
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.going_further.free_box import FreeBox
from ch09_rotations.quaternion import Quaternion
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.direct_net import DirectNet
from studies.models.heap_resolver import HeapResolver
from studies.models.smooth_net import SmoothNet

FRAME = 1.0 / 60.0
Entry = tuple[object, Callable[[Any], object]]  # the state, and a function of the duration


def body() -> Particle:
    """Return a moving particle, with a force added by hand."""
    one = Particle(Vector3(0.5, 0.1), Vector3(1.0, -2.0, 3.0), Vector3(0.0, -9.81), damping=0.9)
    one.add_force(Vector3(3.0, 2.0, 1.0))
    return one


def clicks() -> Entry:
    """Return a game that is not over, because a rocket flies."""
    rules = [
        FireworkRule(type, 0.5, 1.0, Vector3(), Vector3(1.0, 2.0), 0.9, payloads)
        for type, payloads in ((1, (Payload(2, 1),)), (2, ()))
    ]
    display = Display(FireworksShow(rules, 10, 1))
    display.show.launch(1)
    return display, lambda duration: tick(display, duration)


def resolved(resolve: Callable[[Contact, Any], object]) -> Entry:
    contact = Contact(body(), body(), Vector3(0.0, 1.0), 0.5, 0.1)
    return contact, lambda duration: resolve(contact, duration)


def stepped(make: Callable[[list[Particle]], Any], steps: int = 0) -> Entry:
    """Return something that is made of a particle, after some steps."""
    bodies = [body()]
    made = make(bodies)
    for _ in range(steps):
        made.step(FRAME)
    bodies[0].add_force(Vector3(1.0))
    return (bodies, made), made.step


def integrated(step: Any) -> Entry:
    one = body()
    return one, lambda duration: step([one], lambda _: one.add_force(Vector3(1.0)), duration)


def by_angles(made: Any) -> Entry:
    return made, made.step


def followed() -> Entry:
    camera = SpringCamera(Vector3(1.0))
    return camera, lambda duration: camera.follow(Vector3(), duration)


def rewound() -> Entry:
    bodies = [body()]
    ground = GroundPlane(bodies)
    return bodies, lambda h: rewinding_step(lax, bodies, lambda _: None, ground, h)


def on_ground(bodies: list[Particle]) -> list[GroundPlane]:
    return [GroundPlane(bodies, height=1.0)]


def on_cable(bodies: list[Particle]) -> list[AnchoredCable]:
    return [AnchoredCable(body, Vector3(), 0.25) for body in bodies]


def lax(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Step as a user might write it: without any checks, and moving before evaluating forces."""
    for particle in particles:
        particle.position.add_scaled(particle.velocity, duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)


def world(kind: type[ParticleWorld]) -> Entry:
    """Return a world with one particle at rest, which may sleep, and one that flies."""
    bodies = [Particle(), body()]
    bodies[1].position = Vector3(2.0, 5.0)
    found = kind(bodies, [GroundPlane(bodies)], integrator=lax)
    for _ in range(40):
        found.step(FRAME)
    for one in bodies:
        one.add_force(Vector3(1.0, 2.0, 3.0))
    return found, found.run_physics


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


ENTRIES: dict[str, Callable[[], Entry]] = {
    "Display": clicks,
    "adaptive": lambda: integrated(adaptive(1e-6)),
    "SpringCamera": followed,
    "rewinding_step": rewound,
    "Contact.resolve": lambda: resolved(Contact.resolve),
    "ContactResolver": lambda: resolved(lambda c, h: ContactResolver().resolve_contacts([c], h)),
    "HeapResolver": lambda: resolved(lambda c, h: HeapResolver().resolve_contacts([c], h)),
    "SequentialImpulses": lambda: stepped(lambda b: SequentialImpulses(b, on_ground(b))),
    "SmallSteps": lambda: stepped(lambda b: SmallSteps(b, on_ground(b))),
    "DirectChain, first frame": lambda: stepped(lambda b: DirectChain(b, Vector3())),
    "DirectChain": lambda: stepped(lambda b: DirectChain(b, Vector3()), steps=3),
    "DirectNet": lambda: stepped(lambda b: DirectNet(on_cable(b))),
    "SmoothNet": lambda: stepped(lambda b: SmoothNet(on_cable(b))),
    "AnglePendulum": lambda: by_angles(AnglePendulum(1.0, 1.0)),
    "DoublePendulum": lambda: by_angles(DoublePendulum([1.0, 2.0], [1.0, 2.0], [1.0, 2.0])),
    "AngleChain": lambda: by_angles(AngleChain([1.0] * 3, [2.0] * 3, [0.5] * 3)),
    "AngleRope": lambda: by_angles(AngleRope(1.0, 2.0, [0.5] * 3)),
    "ParticleWorld": lambda: world(ParticleWorld),
    "SleepingWorld": lambda: world(SleepingWorld),
    "Blob": lambda: scene(Blob),
    "BallGame": lambda: scene(BallGame),
    "BallGame that is over": lambda: scene(ended_game),
    "Bridge": lambda: scene(Bridge),
    "FreeBox": lambda: by_angles(FreeBox(1.0, Vector3(1, 2, 3), Vector3(1.0, 2.0))),
}


def refuses(state: object, call: Callable[[Any], object], name: str, bad: Any) -> None:
    """Expect a refusal that changes nothing. Pickles of the state include every number."""
    before = pickle.dumps(state)
    with pytest.raises(ValueError, match=f"^{name} must .*{re.escape(repr(bad))}"):
        call(bad)
    assert pickle.dumps(state) == before, repr(bad)


@pytest.mark.parametrize("make", ENTRIES.values(), ids=ENTRIES)
def test_a_bad_duration_is_refused_by_name_and_changes_nothing(make: Callable[[], Entry]) -> None:
    state, call = make()
    for duration in (0.0, math.inf, math.nan):
        refuses(state, call, "duration", duration)
    call(FRAME)  # an entry that rejects everything would fail here


def test_a_rotation_and_a_bridge_refuse_other_arguments_and_change_nothing() -> None:
    q, w, bad = Quaternion(0.6, 0.0, 0.8, 0.0), Vector3(1.0), Vector3(1.0, math.nan, 3.0)
    state = q, w, bad
    refuses(state, lambda x: integrate_rotation(q, w, x, 1.0), "angular_acceleration", bad)
    refuses(state, lambda x: integrate_rotation(q, x, w, 1.0), "angular_velocity", bad)
    bridge, step = scene(Bridge)
    bridge.pace = math.nan
    refuses(bridge, lambda _: step(FRAME), "pace", math.nan)
