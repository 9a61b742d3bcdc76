"""Loops of frames and long series of random numbers, which must run beside the student's code.

Each function takes and returns plain numbers.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from random import Random
from types import FrameType
from typing import Any

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import closed_form, fireworks
from ch04_particle_engine.ballistics import BallisticRange
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.display import Display
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import (
    FireworkRule,
    FireworksShow,
    Payload,
    endless_types,
    make_firework,
)
from ch04_particle_engine.grenade import fragments

MOST_LINES = 500_000  # for endless_types, many times as many as a slow search needs
Components = tuple[float, float, float]
State = tuple[Components, Components]

# type, smallest and largest age, smallest and largest velocity, damping, payloads as (type, count)
RuleData = tuple[int, float, float, Components, Components, float, Sequence[tuple[int, int]]]

UP, STILL = (0.0, 9.0, 0.0), (0.0, 0.0, 0.0)
# The book's first rule, without its payload.
FIRST: RuleData = (1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ())


def fixed(type: int, age: float, velocity: Components = UP, *payloads: tuple[int, int]) -> RuleData:
    """Return a rule without anything random and without damping."""
    return (type, age, age, velocity, velocity, 1.0, payloads)


def rule(data: RuleData) -> FireworkRule:
    """Return the rule with these numbers."""
    type, min_age, max_age, low, high, damping, payloads = data
    left = tuple(Payload(*payload) for payload in payloads)
    return FireworkRule(type, min_age, max_age, low, high, damping, left)


def show_of(rules: Sequence[RuleData], capacity: int, when_full: str, seed: int) -> FireworksShow:
    """Return a show with these rules."""
    return FireworksShow([rule(data) for data in rules], capacity, seed, when_full)


def types(show: FireworksShow) -> list[int]:
    """Return the types of the fireworks that burn, oldest first."""
    return [firework.type for firework in show.fireworks]


def xyz(v: Vector3) -> Components:
    return v.x, v.y, v.z


def flight(names: Sequence[str], duration: float, frames: int) -> list[list[Any]]:
    """Fire shots together; return type, position and velocity of each one after each frame."""
    at = BallisticRange()
    for name in names:
        at.fire(name)
    seen = []
    for _ in range(frames):
        at.update(duration)
        shots = [(shot.type, shot.particle) for shot in at.shots]
        seen.append([(type, xyz(p.position), xyz(p.velocity)) for type, p in shots])
    return seen


def landing(name: str, duration: float) -> tuple[float, float]:
    """Fire a shot and return the time and the z at which it reaches y = 0, within a frame."""
    seen = [shots[0] for shots in flight([name], duration, round(6.0 / duration)) if shots]
    if not seen:
        return 0.0, 0.0
    _, (_, y, z), (_, vy, vz) = seen[-1]
    left = -y / vy  # until the ground, in the frame that removes the shot
    return len(seen) * duration + left, z + vz * left


def burst(
    position: Components,
    velocity: Components,
    mass: float,
    acceleration: Components = (0.0, -10.0, 0.0),
    damping: float = 0.9,
) -> list[list[float]]:
    """Burst a grenade; return mass, damping, position, velocity, acceleration of each fragment."""
    particle = Particle(
        Vector3(*position), Vector3(*velocity), Vector3(*acceleration), mass=mass, damping=damping
    )
    return [
        [piece.mass, piece.damping, *piece.position, *piece.velocity, *piece.acceleration]
        for piece in fragments(particle)
    ]


def lit(
    data: RuleData, seed: int, count: int, parent: State | None = None, parent_mass: float = 1.0
) -> list[list[float]]:
    """Make fireworks; return type, age, position, velocity, acceleration, mass, damping of each."""
    random, made_rule = Random(seed), rule(data)
    source = None
    if parent is not None:
        source = Particle(Vector3(*parent[0]), Vector3(*parent[1]), mass=parent_mass)
    made = []
    for _ in range(count):
        firework = make_firework(made_rule, random, source)
        p = firework.particle
        vectors = [*xyz(p.position), *xyz(p.velocity), *xyz(p.acceleration)]
        made.append([firework.type, firework.age, *vectors, p.mass, p.damping])
    return made


def births_after(show: FireworksShow) -> list[tuple[int, int]]:
    """Light births and return what is then in the list that was passed."""
    births: list[tuple[int, int, Particle | None]] = [(1, 2, None), (2, 3, None)]
    show.light(births)
    return [(type, count) for type, count, _ in births]


def many_births(show: FireworksShow, births: int, count: int) -> tuple[list[int], int]:
    """Light births of types 1 and 2, half of each; return what burns and how many were made."""
    with counted(fireworks, "make_firework") as made:
        show.light([(1 if i < births // 2 else 2, count, None) for i in range(births)])
    return types(show), len(made)


@contextmanager
def counted(module: Any, name: str) -> Iterator[list[None]]:
    """Make a list grow by one each time a module's code calls one of its functions by name."""
    function = getattr(module, name)
    calls: list[None] = []

    def counting(*arguments: Any, **named: Any) -> Any:
        calls.append(None)
        return function(*arguments, **named)

    setattr(module, name, counting)
    try:
        yield calls
    finally:
        setattr(module, name, function)


def played(
    rules: Sequence[RuleData],
    launches: Sequence[int],
    duration: float,
    frames: int,
    *,
    capacity: int = 500,
    when_full: str = "keep_old",
    seed: int = 1,
) -> tuple[list[list[int]], list[Any]]:
    """Launch fireworks; return the types that burn after each frame, and the fireworks at the end.

    The oldest is the first. Of each one at the end, return type, age, position and velocity.
    """
    show = show_of(rules, capacity, when_full, seed)
    for type in launches:
        show.launch(type)
    seen = []
    for _ in range(frames):
        show.update(duration)
        seen.append(types(show))
    lit = [(firework.type, firework.age, firework.particle) for firework in show.fireworks]
    return seen, [(type, age, xyz(p.position), xyz(p.velocity)) for type, age, p in lit]


def endless(leaves: dict[int, list[int]]) -> list[int] | str:
    """Return the endless types of rules with one payload for each of the listed types.

    If the search never comes to an end, return what stopped it.
    """
    rules = [
        rule(fixed(type, 1.0, STILL, *((other, 1) for other in after)))
        for type, after in leaves.items()
    ]
    lines = 0

    def traced(_frame: FrameType, event: str, _argument: Any) -> Any:
        nonlocal lines
        lines += event == "line"
        if lines > MOST_LINES:
            raise TimeoutError
        return traced

    before = sys.gettrace()
    sys.settrace(traced)
    try:
        return endless_types(rules)
    except RecursionError as error:
        return f"RecursionError: {error}"
    except TimeoutError:
        return f"no result after {MOST_LINES:,} lines of code"
    finally:
        sys.settrace(before)


def as_data(of: FireworkRule) -> list[object]:
    payloads = [(payload.type, payload.count) for payload in of.payloads]
    velocities = [*of.min_velocity, *of.max_velocity]
    return [of.type, of.min_age, of.max_age, *velocities, of.damping, payloads]


def own_rules() -> list[list[object]]:
    """Return the student's own types as plain numbers."""
    return [as_data(of) for of in own_types()]


def nine_rules() -> list[list[object]]:
    """Return the nine types as plain numbers."""
    return [as_data(of) for of in FIREWORK_TYPES]


def own_show(type: int, seed: int, duration: float, frames: int) -> list[int]:
    """Light a firework high up in a show of all eleven types; return how many burn each frame."""
    show = FireworksShow([*FIREWORK_TYPES, *own_types()], 2000, seed)
    show.light([(type, 1, Particle(Vector3(0, 50, 0)))])
    counts = []
    for _ in range(frames):
        show.update(duration)
        counts.append(len(show.fireworks))
    return counts


def sparks_of_a_wheel(sparks_per_second: float, duration: float, frames: int) -> list[int]:
    """Turn a wheel and return the number of sparks after each frame."""
    show = show_of([fixed(7, 90.0, STILL)], 20000, "keep_old", 1)
    wheel = CatherineWheel(show, 7, Vector3(0, 5, 0), 1.0, 2.0, sparks_per_second)
    counts = []
    for _ in range(frames):
        wheel.update(duration)
        counts.append(len(show.fireworks))
    return counts


def stepped(
    position: Components,
    velocity: Components,
    acceleration: Components,
    damping: float,
    duration: float,
    frames: int,
) -> State:
    """Integrate a particle and return its position and velocity."""
    particle = Particle(
        Vector3(*position), Vector3(*velocity), Vector3(*acceleration), damping=damping
    )
    for _ in range(frames):
        particle.integrate(duration)
    return xyz(particle.position), xyz(particle.velocity)


def burst_counted(
    start: float, speeds: list[float], acceleration: float, damping: float, time: float
) -> tuple[list[float], list[float], int]:
    """Return the positions of a burst, the speeds after it, and the calls of drag_factors."""
    with counted(closed_form, "drag_factors") as calls:
        positions = closed_form.burst_positions(start, speeds, acceleration, damping, time)
    return [*positions], speeds, len(calls)


# Type 1 is a rocket that leaves three sparks of type 2. Type 3 is another rocket.
RULES: list[RuleData] = [
    fixed(1, 2.0, STILL, (2, 3)),
    fixed(2, 5.0, STILL),
    fixed(3, 1.0, STILL, (2, 1)),
]


def game(*lit: tuple[int, float, float], z: float = 0.0) -> Display:
    """Return a game with fireworks of these types at these points of the X-Y plane."""
    show = show_of(RULES, 50, "keep_old", 1)
    for type, x, y in lit:
        show.light([(type, 1, Particle(Vector3(x, y, z)))])
    return Display(show)
