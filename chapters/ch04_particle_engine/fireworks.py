"""Fireworks (book 4.2): particles that burn for a while and leave others behind.

What a type of firework does is data, a rule; the show only reads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from random import Random

from ch02_vectors.arguments import finite, not_negative
from ch03_laws_of_motion.particle import Particle

Numbers = tuple[float, float, float]

GRAVITY = (0.0, -9.81, 0.0)  # m/s^2
LAUNCH_PLACES = (-5.0, 0.0, 5.0)  # m along X, on the ground
POLICIES = ("keep_old", "drop_oldest")


@dataclass(frozen=True)
class Payload:
    """What a firework leaves behind: ``count`` fireworks of a type.

    Raises ValueError where the count is below 1, TypeError where it is no whole number.
    """

    type: int
    count: int

    def __post_init__(self) -> None:
        _whole("count", self.count)


@dataclass(frozen=True)
class FireworkRule:
    """What fireworks of a type do: how long they burn, how they fly and what they leave behind.

    Ages in s and velocities in m/s are drawn between a smallest and a largest one, velocities for
    each component. ``damping`` is the share of the velocity that is kept per second.

    Raises ValueError where an age or the damping is negative, a number is not finite, a velocity
    has not three components, or a smallest is above its largest; TypeError for payloads that are no
    tuple or list.
    """

    type: int
    min_age: float
    max_age: float
    min_velocity: Numbers
    max_velocity: Numbers
    damping: float
    payloads: Sequence[Payload] = ()

    def __post_init__(self) -> None:
        not_negative("damping", self.damping)
        not_negative("min_age", self.min_age)
        if not self.min_age <= finite("max_age", self.max_age):
            raise ValueError(
                f"max_age must be min_age, {self.min_age!r}, or more, got {self.max_age!r}"
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
    """A burning particle: its ``type``, its ``particle``, and its ``age``: the fuse left in s."""

    __slots__ = ("age", "particle", "type")

    def __init__(self, type: int, age: float, particle: Particle) -> None:
        self.type = type
        self.age = age
        self.particle = particle


def make_firework(rule: FireworkRule, random: Random, parent: Particle | None = None) -> Firework:
    """Return a new firework of a rule, with numbers drawn from ``random`` (4.2.3).

    Its age and each component of its velocity are drawn evenly between the rule's limits. A parent
    gives it its place, and its velocity on top of the drawn one; without one it starts on the
    ground, at one of LAUNCH_PLACES. Mass 1, GRAVITY as the acceleration, the damping of the rule.
    """
    raise NotImplementedError("Exercise B4.4: A firework from its rule")


def endless_types(rules: Iterable[FireworkRule]) -> list[int]:
    """Return the types that lead back to themselves, in ascending order: they never end.

    Type 1 does where it leaves type 2 behind and type 2 leaves type 1, and so does type 2; a type 3
    that leaves type 1 behind never ends either, but does not come back.
    """
    raise NotImplementedError("Exercise B4.7: Rules without an end")


class FireworksShow:
    """Fireworks that burn, in the order in which they were lit, the oldest first.

    At most ``capacity`` burn at a time. When that is full, "keep_old" lights no new ones, as the
    book's text says, and "drop_oldest" puts out the oldest to make room, as its listing does
    (E-20). ``dropped`` counts those not lit and those put out. So rules that light each other for
    ever stay within the capacity, however many sparks they ask for.

    The same seed gives the same show.

    Raises ValueError where two rules have one type, a payload has a type without a rule, the
    capacity is below 1, or there is no such policy; TypeError for a capacity that is no whole
    number.
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
                raise ValueError(f"rules must have one rule a type, got two of type {rule.type!r}")
            self.rules[rule.type] = rule
        for rule in self.rules.values():
            for payload in rule.payloads:
                if payload.type not in self.rules:
                    raise ValueError(
                        f"rules must have a rule for each payload, got type {rule.type!r} with "
                        f"payload {payload.type!r} and no rule for that"
                    )
        if when_full not in POLICIES:
            raise ValueError(f"when_full must be one of {', '.join(POLICIES)}, got {when_full!r}")
        self.capacity = _whole("capacity", capacity)
        self.when_full = when_full
        self.random = Random(seed)
        self.fireworks: list[Firework] = []
        self.dropped = 0

    def launch(self, type: int) -> None:
        """Light one firework of a type on the ground (4.2.3).

        Raises ValueError where there is no rule for the type.
        """
        raise NotImplementedError("Exercise B4.5: Slots, and what happens when they are full")

    def light(self, births: Sequence[tuple[int, int, Particle | None]]) -> None:
        """Light fireworks, each birth a (type, count, parent), as far as the policy lets them.

        They come behind those that burn already, in the order of the births. When there is no room
        for all, "keep_old" lights the first of them, and "drop_oldest" lights those that would be
        left if the oldest were put out again and again: the last ones. A call never makes more than
        the capacity, whatever the counts.

        Raises ValueError where there is no rule for a type, or a count is negative; then nothing is
        lit.
        """
        raise NotImplementedError("Exercise B4.5: Slots, and what happens when they are full")

    def update(self, duration: float) -> None:
        """Move every firework on by a frame in s, and light what the burnt-out ones leave (4.2.3).

        Each moves, and its age shrinks by the duration. One whose age is below 0, or that is below
        the ground (y < 0), is burnt out; at 0 it burns on. When all have moved, the burnt-out ones
        are removed. Then their payloads are lit, with the burnt-out one's particle as the parent,
        those of the oldest first.

        Raises ValueError where the duration is not positive and finite; nothing has moved then.
        """
        raise NotImplementedError("Exercise B4.6: The show goes on")


def _whole(name: str, value: int) -> int:
    """Return a whole number of 1 or more."""
    if not isinstance(value, int):
        raise TypeError(f"{name} must be a whole number, got {value!r}")
    if value < 1:
        raise ValueError(f"{name} must be 1 or more, got {value!r}")
    return value
