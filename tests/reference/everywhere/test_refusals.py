"""The reference refuses bad numbers and vectors everywhere, by name, and then nothing has changed.

Only one exercise of each chapter checks that students refuse bad arguments. These tests read the
signatures of all public functions, constructors and methods, so new ones are tested too. If a new
one doesn't check its arguments, list it in UNCHECKED.
"""

from __future__ import annotations

import importlib
import inspect
import math
import pickle
import re
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import pytest

from autograder.manifest import ROOT
from ch02_vectors.vector import Vector3
from ch04_particle_engine.display import Display
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow, Payload
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.angle_pendulum import DoublePendulum
from ch07_constraints.links import AnchoredCable
from ch08_mass_aggregate.ball_game import BallGame
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.trebuchet import my_design
from ch08_mass_aggregate.world import ParticleWorld
from ch09_rotations.matrix import Matrix3, Matrix4
from ch09_rotations.quaternion import Quaternion
from studies.models.angle_chain import AngleChain

NAN, INF = math.nan, math.inf
FRAME = 1.0 / 60.0
FILES = [*ROOT.glob("solutions/ch0[3-9]*/*.py"), *ROOT.glob("chapters/ch0[3-9]*/**/*.py")]
MODULES = {".".join(path.relative_to(ROOT).with_suffix("").parts[1:]) for path in FILES}
MODELS = "angle_chain angle_rope direct_net exact_frames heap_resolver rod_tensions smooth_net"


# Valid arguments, by their annotation or their name


def nothing(*_: object) -> None:
    """Stand for a step, or for forces."""


def lax(particles: Sequence[Particle], apply_forces: Any, duration: float) -> None:
    """Step as a user might write it: without any checks, and moving before evaluating forces."""
    for particle in particles:
        particle.position.add_scaled(particle.velocity, duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)


def body() -> Particle:
    """Return a moving particle, with a force added by hand."""
    one = Particle(Vector3(0.5, 0.1), Vector3(1.0, -2.0, 3.0), Vector3(0.0, -9.81), damping=0.9)
    one.add_force(Vector3(3.0, 2.0, 1.0))
    return one


def rule(type: int = 1, **values: Any) -> FireworkRule:
    right = {"min_age": 0.5, "max_age": 1.0, "min_velocity": (0.0, 0.0, 0.0), "damping": 0.9}
    return FireworkRule(type, **(right | {"max_velocity": (1.0, 2.0, 1.0)} | values))


def display() -> Display:
    """Return a game that is not over, because a rocket flies."""
    show = FireworksShow([rule(payloads=(Payload(2, 1),)), rule(2)], 10, 1)
    show.launch(1)
    return Display(show)


def touch() -> Contact:
    return Contact(body(), body(), Vector3(0.0, 1.0), 0.5, 0.1)


def world(kind: type[ParticleWorld]) -> ParticleWorld:
    """Return a world with one particle at rest, which may sleep, and one that flies."""
    bodies = [Particle(), body()]
    bodies[1].position = Vector3(2.0, 5.0)
    return kind(bodies, [GroundPlane(bodies)], integrator=lax)


VALID: dict[str, Callable[[], Any]] = {
    "float": lambda: 0.5,
    "int": lambda: 1,
    "str": lambda: "pistol",
    "Vector3": lambda: Vector3(1.0, 2.0, 3.0),
    "Particle": body,
    "Quaternion": lambda: Quaternion(0.6, 0.0, 0.8, 0.0),
    "Matrix3": lambda: Matrix3(*range(9)),
    "Matrix4": lambda: Matrix4(*range(12)),
    "Contact": touch,
    "Display": display,
    "FireworksShow": lambda: FireworksShow([rule()], 10, 1),
    "ForceRegistry": ForceRegistry,
    "ParticleWorld": lambda: world(ParticleWorld),
    "SleepingWorld": lambda: world(SleepingWorld),
    "DoublePendulum": lambda: DoublePendulum([1.0, 2.0], [1.0, 2.0], [0.5, 0.5]),
    "AngleChain": lambda: AngleChain([1.0] * 3, [2.0] * 3, [0.5] * 3),
    "Design": my_design,
    "Detector": lambda: GroundPlane([body()]),
    "Integrator": lambda: lax,
    "ApplyForces": lambda: nothing,
    "Callable[[float], object]": lambda: nothing,
    "Numbers": lambda: (1.0, 1.0, 1.0),
    "tuple[float, float, float]": lambda: (1.0, 1.0, 1.0),
    "Point": lambda: (1.0, 1.0),
    "[Particle]": lambda: [body()],
    "[Contact]": lambda: [touch()],
    "[ContactGenerator]": lambda: [GroundPlane([body()], height=1.0)],
    "[Any]": lambda: [AnchoredCable(body(), Vector3(0.5), 0.1)],
    "[FireworkRule]": lambda: [rule()],
    "[Row]": make_rows,
    "[float]": lambda: [1.0, 2.0],
    "[Sequence[float]]": lambda: [[0.5]],
    "[Stone]": lambda: [("A", 1.0, 1.0, 1.0)],
    "target: Vector3": lambda: Vector3(4.0),
    "normal: Vector3": lambda: Vector3(0.0, 1.0),
    "max_length: float": lambda: 1.0,
    "max_age: float": lambda: 1.0,
    "max_impacts: int": lambda: 100,
    "when_full: str": lambda: "keep_old",
}
VALID["ContactGenerator"] = VALID["Detector"]


def valid(parameter: inspect.Parameter) -> Any:
    kind = str(parameter.annotation).removesuffix(" | None")
    kind = re.sub(r"^(?:Sequence|Iterable|list)(?=\[)", "", kind)
    for name in (f"{parameter.name}: {kind}", kind):
        if name in VALID:
            return VALID[name]()
    return parameter.default


def made(kind: type, steps: int) -> Any:
    """Return an instance after some steps, with forces that were added by hand."""
    one = VALID.get(kind.__name__, lambda: kind(**arguments_of(kind)))()
    for _ in range(steps):
        one.step(FRAME)
    for particle in getattr(getattr(one, "world", one), "particles", ()):
        particle.add_force(Vector3(1.0, 2.0, 3.0))
    for name, value in (("pace", 1.0), ("push", Vector3(1.0)), ("direction", 1)):
        if hasattr(one, name):
            setattr(one, name, value)
    if steps and isinstance(one, BallGame):
        one.rules.lives = 0
    return one


def parameters(call: Callable[..., Any]) -> list[inspect.Parameter]:
    found = inspect.signature(call).parameters.values()
    return [one for one in found if one.name != "self" and one.kind != one.VAR_POSITIONAL]


def arguments_of(call: Callable[..., Any]) -> dict[str, Any]:
    return {one.name: valid(one) for one in parameters(call)}


# Which arguments must be refused

CONDITIONS = {  # of arguments with a name, or of this one alone. All others are not negative.
    "positive": """ball_mass break_length counterweight distance duration factor first_mass frame
    gravity height initial_height length limit liquid_density long_arm lower_mass mass max_age
    max_depth max_length mean omega scale_height second_mass short_arm size sling speed_limit
    tolerance total upper_mass volume
    CatherineWheel.radius CatherineWheel.rate Deck.radius ParticlePairs.radius Planks.radius
    position_by_equation.time quadratic_fall.k2 terminal_speed.weight""",
    "finite": """acceleration angle angular_speed angular_velocity azimuth elevation force mu
    penetration push rate release_angle scale start strength v v0 water_height x x0 y z
    FrictionGround.height GroundPlane.height PenaltyGround.height ReactionForce.height
    heights_in_frames.speed screen_angle.time slowed_gravity.gravity""",
    "positive or infinite": "Particle.mass TargetBlock.mass",
    "restitution": "restitution ground_restitution pair_restitution",
    "whole": "count frames iterations max_impacts max_steps rows sleep_frames steps",
    "not negative": """Buoyancy.gravity Contact.resolve_velocity.duration
    Contact.velocity_after.duration FrictionContact.resolve_velocity.duration
    GroundPlane.next_impact.duration Overcrowding.distance ParticlePairs.next_impact.duration
    TiltingPlatform.put_weight.mass heights_in_frames.height top_ball_speed.gravity
    top_ball_speed.height""",
}
CONDITION_OF = {name: kind for kind, names in CONDITIONS.items() for name in names.split()}
# For each condition: the values that are wrong, of the wrong type, and just right.
VALUES: dict[str, tuple[tuple[Any, ...], tuple[Any, ...], tuple[Any, ...]]] = {
    "finite": ((NAN, INF), ("1",), (-1.0, 0.0)),
    "not negative": ((-1.0, NAN, INF), ("1",), (0.0,)),
    "positive": ((0.0, -1.0, NAN, INF), ("1",), ()),
    "positive or infinite": ((0.0, -1.0, NAN), ("1",), (INF,)),
    "restitution": ((-0.1, 1.1, NAN), ("1",), (0.0, 1.0)),
    "whole": ((0, -1), (2.0, True), ()),
    "vector": ((Vector3(NAN),), ((1, 2, 3),), ()),
    "": ((), (), ()),
}
# These check nothing: plain records, private parts of a method, and formulas in inner loops. The
# last two are tested in test_refusals_by_hand.py.
UNCHECKED = """ContactResolver.resolve_velocities Detector.next_impact Detectors.next_impact Display
Firework HeapResolver.resolve_velocities Hole Particle.drift Particle.kick Quaternion Row Row.push
RodTensions.update_forces ShotType SimulationDiverged Sleep SleepingWorld.wake_pushed Target Throw
TooManyImpacts a_restitution a_unit_vector bounce click correct direction_of drag_force
fall_in_frames find_rocket hermite hermite_weights hit_on_the_way my_step oscillation_in_frames
ring_points spring_force time_to_close balancing_mass euler_to_quaternion"""
CHECKED = {"Airbrake.update_force", "FakeStiffSpring.update_force"}  # no other generator does it
# These check their numbers, but not their vectors.
LOOSE = """Matrix3.transform Matrix4.transform Matrix4.transform_direction Matrix4.transform_inverse
Matrix4.transform_inverse_direction Quaternion.rotate damp_per_frame damp_per_second
damping_difference hit_fraction position_by_equation stepping_error strike_first"""
# These clear the forces before they refuse a duration.
CLEAR = "Cube.step ParticleWorld.step TiltingPlatform.step Trebuchet.step Wheel.step"


def condition(name: str, parameter: inspect.Parameter) -> str:
    """Return what an argument must be, or nothing if it is not checked or no number or vector."""
    kinds = {*str(parameter.annotation).split(" | ")}
    if name in UNCHECKED.split() or (name.endswith("update_force") and name not in CHECKED):
        return ""
    if "Vector3" in kinds:
        return "" if name in LOOSE.split() else "vector"
    known = CONDITION_OF.get(f"{name}.{parameter.name}") or CONDITION_OF.get(parameter.name)
    if "int" in kinds:
        return "whole" if known == "whole" else ""
    return (known or "not negative") if "float" in kinds else ""


def named(module: str, name: str) -> Any:
    value: Any = importlib.import_module(module)
    for part in name.split("."):
        value = getattr(value, part)
    return value


def public() -> Iterator[tuple[str, str]]:
    """Yield the module and the name of all functions, constructors and methods with conditions."""
    for module in sorted(MODULES) + [f"studies.models.{name}" for name in MODELS.split()]:
        for key, value in vars(importlib.import_module(module)).items():
            if key[0] == "_" or getattr(value, "__module__", None) != module:
                continue
            names = [key] if inspect.isfunction(value) or inspect.isclass(value) else []
            if inspect.isclass(value):
                names += [
                    f"{key}.{inner}"
                    for inner, method in vars(value).items()
                    if inspect.isfunction(method) and (inner[0] != "_" or inner == "__call__")
                ]
            for name in names:
                if any(condition(name, one) for one in parameters(named(module, name))):
                    yield module, name


@pytest.mark.parametrize(("module", "name"), [*public()])
def test_bad_numbers_and_vectors_are_refused_by_name_and_change_nothing(
    module: str, name: str
) -> None:
    call = named(module, name)
    kind = named(module, name.rpartition(".")[0]) if "." in name else None
    later = 40 if kind in (ParticleWorld, SleepingWorld) else 3
    for steps in (0, later) if hasattr(kind, "step") else (0,):
        for parameter in parameters(call):
            given = arguments_of(call)
            first = [made(kind, steps)] if kind else []
            wrong, of_wrong_type, right = VALUES[condition(name, parameter)]
            for error, values in ((ValueError, wrong), (TypeError, of_wrong_type)):
                for bad in values:
                    before = pickle.dumps([*first, given])  # includes every number
                    with pytest.raises(error, match=refusal(parameter.name, bad)):
                        call(*first, **(given | {parameter.name: bad}))
                    assert name in CLEAR.split() or pickle.dumps([*first, given]) == before, bad
            for value in right:
                call(*first, **(given | {parameter.name: value}))


def refusal(name: str, bad: object) -> str:
    """Return a pattern for a message that names the argument and shows its value."""
    return rf"(?<!\w){re.escape(name)} must .*{re.escape(repr(bad))}"
