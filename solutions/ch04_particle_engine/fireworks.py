"""Fireworks (book 4.2): particles that burn for a while and then light other fireworks.

Each type of firework is described by a rule, which is plain data. An unknown type or a number that
is out of range raises ValueError, and an argument of the wrong type TypeError.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import finite, not_negative, positive, whole
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

Numbers = tuple[float, float, float]
Birth = tuple[int, int, Particle | None]  # type, count and parent

GRAVITY = (0.0, -9.81, 0.0)  # m/s^2
LAUNCH_PLACES = (-5.0, 0.0, 5.0)  # m along X, on the ground
POLICIES = ("keep_old", "drop_oldest")


@dataclass(frozen=True)
class Payload:
    """Fireworks of one type that another firework lights when it burns out.

    ``count`` is the number of fireworks, at least 1.
    """

    type: int
    count: int

    def __post_init__(self) -> None:
        whole("count", self.count)


@dataclass(frozen=True)
class FireworkRule:
    """A description of one type of firework: how long it burns, how it flies, and what it lights.

    For each firework, the age and each component of the velocity are drawn at random between a
    minimum and a maximum.
    """

    type: int
    min_age: float  # s
    max_age: float
    min_velocity: Numbers  # m/s
    max_velocity: Numbers
    damping: float  # the fraction of the velocity that is kept per second
    payloads: Sequence[Payload] = ()

    def __post_init__(self) -> None:
        not_negative("damping", self.damping)
        not_negative("min_age", self.min_age)
        if not self.min_age <= finite("max_age", self.max_age):
            raise ValueError(
                f"max_age must be at least min_age ({self.min_age!r}), got {self.max_age!r}"
            )
        if not isinstance(self.payloads, (tuple, list)):
            raise TypeError(
                f"payloads must be a tuple of Payloads, got {self.payloads!r}: is a comma missing?"
            )
        for name in ("min_velocity", "max_velocity"):
            velocity = getattr(self, name)
            if len([*velocity]) != 3:
                raise ValueError(f"{name} must have three components, got {velocity!r}")
        for low, high in zip(self.min_velocity, self.max_velocity, strict=True):
            if not finite("min_velocity", low) <= finite("max_velocity", high):
                raise ValueError(
                    "max_velocity must be min_velocity or more on every axis, got "
                    f"{self.min_velocity!r} and {self.max_velocity!r}"
                )


class Firework:
    """A burning firework, whose ``age`` counts down: it is the time in s until it burns out."""

    __slots__ = ("age", "particle", "type")

    def __init__(self, type: int, age: float, particle: Particle) -> None:
        self.type = type
        self.age = age
        self.particle = particle


def make_firework(rule: FireworkRule, random: Random, parent: Particle | None = None) -> Firework:
    """Create a firework of the type that ``rule`` describes, with random numbers from ``random``.

    The age of the firework and each component of its velocity are drawn uniformly between the
    rule's limits, independently of each other. A payload starts at the position of its ``parent``,
    the particle of the firework that lit it, and the velocity of the parent is added to its own. A
    firework without a parent starts on the ground, at one of ``LAUNCH_PLACES``, chosen at random.
    In both cases it has a mass of 1 kg, the acceleration ``GRAVITY`` and the rule's damping.
    """
    velocity = Vector3(*map(random.uniform, rule.min_velocity, rule.max_velocity))
    if parent is None:
        position = Vector3(random.choice(LAUNCH_PLACES), 0.0, 0.0)
    else:
        position = parent.position
        velocity += parent.velocity
    particle = Particle(position, velocity, Vector3(*GRAVITY), damping=rule.damping)
    return Firework(rule.type, random.uniform(rule.min_age, rule.max_age), particle)


def endless_types(rules: Iterable[FireworkRule]) -> list[int]:
    """Find the types of firework that light themselves again, directly or through other types.

    A type that only leads to such a type is not one of them. Return the types in ascending order.
    """
    lights = {rule.type: {payload.type for payload in rule.payloads} for rule in rules}
    endless = []
    for type in lights:
        reached: set[int] = set()
        ahead = [type]
        while ahead:
            new = lights.get(ahead.pop(), set()) - reached
            reached |= new
            ahead += new
        if type in reached:
            endless.append(type)
    return sorted(endless)


class FireworksShow:
    """A fireworks show, which lights fireworks, moves them and removes the ones that burn out.

    ``fireworks`` lists the burning fireworks in the order in which they were lit. There are at most
    ``capacity`` of them, even if their types light each other forever. ``when_full`` decides what
    happens when the show is full. With "keep_old" no new fireworks are lit, and with "drop_oldest"
    the oldest fireworks are put out to make room (erratum E-20). In both cases ``dropped`` counts
    the fireworks that were not lit, or were put out. The same ``seed`` always gives the same show.
    """

    def __init__(
        self,
        rules: Iterable[FireworkRule],
        capacity: int,
        seed: int,
        when_full: str = "keep_old",
    ) -> None:
        self.rules: dict[int, FireworkRule] = {}
        for rule in rules:
            if rule.type in self.rules:
                raise ValueError(f"rules must have different types, got two of type {rule.type!r}")
            self.rules[rule.type] = rule
        lit = {payload.type for rule in self.rules.values() for payload in rule.payloads}
        if unknown := lit - self.rules.keys():
            raise ValueError(f"rules must have a rule for each payload, got none for {unknown!r}")
        if when_full not in POLICIES:
            raise ValueError(f"when_full must be one of {', '.join(POLICIES)}, got {when_full!r}")
        self.capacity = whole("capacity", capacity)
        self.when_full = when_full
        self.random = Random(seed)
        self.fireworks: list[Firework] = []
        self.dropped = 0

    def launch(self, type: int) -> None:
        """Light one firework of the type ``type`` on the ground."""
        self.light([(type, 1, None)])

    def light(self, births: Sequence[Birth]) -> None:
        """Light as many new fireworks as the show has room for.

        ``births`` describes the new fireworks as tuples (type, count, parent). They are added after
        the ones that already burn, in the order of these tuples. "keep_old" lights only as many as
        fit, starting with the first. "drop_oldest" puts out the oldest to make room. If there are
        more new ones than the capacity, it lights only the last of them. A call never creates more
        fireworks than the capacity, however large the counts are, and leaves ``births`` unchanged.

        Raises ValueError for an unknown type or a negative count. In that case nothing is lit.
        """
        for type, count, _ in births:
            if type not in self.rules:
                raise ValueError(f"type must be one of {sorted(self.rules)}, got {type!r}")
            if count < 0:
                raise ValueError(f"count must be 0 or more, got {count!r}")
        burning, asked = len(self.fireworks), sum(count for _, count, _ in births)
        # Number the new fireworks from 0. Only those from first to end - 1 are lit.
        first, end = 0, self.capacity - burning
        if self.when_full == "drop_oldest":
            first, end = asked - self.capacity, asked
        number = 0
        for type, count, parent in births:
            for _ in range(max(first, number), min(end, number + count)):
                self.fireworks.append(make_firework(self.rules[type], self.random, parent))
            number += count
        del self.fireworks[: -self.capacity]
        self.dropped += burning + asked - len(self.fireworks)

    def update(self, duration: float) -> None:
        """Advance the show by ``duration`` s, and light the payloads of fireworks that burn out.

        Each firework moves with one call of ``integrate``, and its age decreases by the duration. A
        firework has burned out if its age is below 0 (at exactly 0 it still burns), or if it is
        below the ground (y < 0). When all fireworks have moved, remove the ones that have burned
        out and light their payloads, starting with the payloads of the oldest firework, in the
        order of its rule. The parent of a payload is the particle of the burnt-out firework.
        """
        positive("duration", duration)
        burning: list[Firework] = []
        births: list[Birth] = []
        for firework in self.fireworks:
            particle = firework.particle
            particle.integrate(duration)
            firework.age -= duration
            if firework.age >= 0.0 and particle.position.y >= 0.0:
                burning.append(firework)
            else:
                payloads = self.rules[firework.type].payloads
                births += [(payload.type, payload.count, particle) for payload in payloads]
        self.fireworks = burning
        self.light(births)
