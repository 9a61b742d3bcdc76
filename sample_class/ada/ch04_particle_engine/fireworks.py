"""Fireworks: particles with a fuse. Rules say what each type does and what it leaves behind."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle

Numbers = tuple[float, float, float]
Birth = tuple[int, int, Particle | None]

GRAVITY = (0.0, -9.81, 0.0)  # m/s^2
LAUNCH_PLACES = (-5.0, 0.0, 5.0)  # m to the side
POLICIES = ("keep_old", "drop_oldest")


@dataclass(frozen=True)
class Payload:
    """So many fireworks of a type, which another one leaves behind."""

    type: int
    count: int

    def __post_init__(self) -> None:
        _at_least_one("count", self.count)


@dataclass(frozen=True)
class FireworkRule:
    """The limits of age and velocity, the damping and the payloads of a type."""

    type: int
    min_age: float
    max_age: float
    min_velocity: Numbers
    max_velocity: Numbers
    damping: float
    payloads: Sequence[Payload] = ()

    def __post_init__(self) -> None:
        for name in ("damping", "min_age", "max_age"):
            not_negative(name, getattr(self, name))
        lows = [finite("min_velocity", low) for low in self.min_velocity]
        highs = [finite("max_velocity", high) for high in self.max_velocity]
        ranges = [(self.min_age, self.max_age), *zip(lows, highs, strict=True)]
        if any(low > high for low, high in ranges):
            raise ValueError(f"type {self.type!r} has a lower limit above the upper one: {ranges}")


class Firework:
    """A particle that burns, and how long it still will, in s."""

    def __init__(self, type: int, age: float, particle: Particle) -> None:
        self.type, self.age, self.particle = type, age, particle

    @property
    def is_burnt_out(self) -> bool:
        """Whether its fuse or its way down has come to an end."""
        return self.age < 0 or self.particle.position.y < 0


def make_firework(rule: FireworkRule, random: Random, parent: Particle | None = None) -> Firework:
    def between(low: float, high: float) -> float:
        share = random.random()
        return low + (high - low) * share

    origin = parent
    if origin is None:
        origin = Particle(Vector3(LAUNCH_PLACES[random.randrange(len(LAUNCH_PLACES))]))
    thrown = Vector3(*map(between, rule.min_velocity, rule.max_velocity))
    body = Particle(
        origin.position, origin.velocity + thrown, Vector3(*GRAVITY), damping=rule.damping
    )
    return Firework(rule.type, between(rule.min_age, rule.max_age), body)


def endless_types(rules: Iterable[FireworkRule]) -> list[int]:
    payloads = {rule.type: rule.payloads for rule in rules}
    bit = {type: 1 << number for number, type in enumerate(payloads)}
    lit = {
        type: sum({bit.get(payload.type, 0) for payload in left}) for type, left in payloads.items()
    }
    for between in bit:
        for type in bit:
            if lit[type] & bit[between]:
                lit[type] |= lit[between]
    return sorted(type for type in bit if lit[type] & bit[type])


class FireworksShow:
    """A queue of burning fireworks, the oldest in front, of a limited length."""

    def __init__(
        self,
        rules: Iterable[FireworkRule],
        capacity: int,
        seed: int,
        when_full: str = "keep_old",
    ) -> None:
        given = list(rules)
        self.rules = {rule.type: rule for rule in given}
        if len(self.rules) < len(given):
            raise ValueError(f"two rules share a type: {[rule.type for rule in given]}")
        left = {payload.type for rule in given for payload in rule.payloads}
        if not left <= self.rules.keys():
            raise ValueError(f"payloads of a type without a rule: {left - self.rules.keys()}")
        if when_full not in POLICIES:
            raise ValueError(f"when_full has to be in {POLICIES}, and is {when_full!r}")
        self.capacity = _at_least_one("capacity", capacity)
        self.when_full = when_full
        self.random = Random(seed)
        self.dropped = 0
        self._burning: deque[Firework] = deque(maxlen=capacity)

    @property
    def fireworks(self) -> list[Firework]:
        """What burns now, the oldest first."""
        return list(self._burning)

    def launch(self, type: int) -> None:
        if type not in self.rules:
            raise ValueError(f"no rule for type {type!r}, only for {[*self.rules]}")
        self.light([(type, 1, None)])

    def light(self, births: Sequence[Birth]) -> None:
        for type, count, _ in births:
            if type not in self.rules or count < 0:
                raise ValueError(f"births has {count!r} fireworks of type {type!r}")
        before = len(self._burning)
        total = sum(count for _, count, _ in births)
        if self.when_full == "keep_old":
            opens, closes = 0, self.capacity - before
        else:
            opens, closes = total - self.capacity, total
        start = 0
        for type, count, parent in births:
            stop = start + count
            self._burning.extend(
                make_firework(self.rules[type], self.random, parent)
                for _ in range(max(start, opens), min(stop, closes))
            )
            start = stop
        self.dropped += before + total - len(self._burning)

    def update(self, duration: float) -> None:
        seconds = positive("duration", duration)
        for firework in self._burning:
            firework.particle.integrate(seconds)
            firework.age -= seconds
        ended = [firework for firework in self._burning if firework.is_burnt_out]
        lasting = (firework for firework in self._burning if not firework.is_burnt_out)
        self._burning = deque(lasting, self.capacity)
        self.light(
            [
                (payload.type, payload.count, firework.particle)
                for firework in ended
                for payload in self.rules[firework.type].payloads
            ]
        )


def _at_least_one(name: str, value: object) -> int:
    if not isinstance(value, int):
        raise TypeError(f"{name} counts things, and {value!r} is no count")
    if value <= 0:
        raise ValueError(f"{name} has to be at least 1, and is {value!r}")
    return value
