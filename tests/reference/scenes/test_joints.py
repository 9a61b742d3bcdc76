"""A force generator joins the particles that it names in public, and no others."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.springs import (
    AnchoredSpring,
    Bungee,
    ElasticLimitSpring,
    HomingBullet,
    Overcrowding,
    Spring,
    connect,
)
from ch08_mass_aggregate.blob import Bond
from ch08_mass_aggregate.joints import joined
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.wheel import RimDrive


class Hidden:
    """A user's generator that keeps its particles private."""

    def __init__(self, *others: Particle) -> None:
        self._others = others
        self.strength, self.a = others, 9.81

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add no force."""


class Shown(Hidden):
    """The same generator, which names its particles by the property that joints.py reads."""

    @property
    def particles(self) -> tuple[Particle, ...]:
        """The particles that the force depends on."""
        return self._others


class Slotted:
    """A generator without a __dict__."""

    __slots__ = ("other",)

    def __init__(self, other: Particle) -> None:
        self.other = other

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add no force."""


def generators(a: Particle, b: Particle, c: Particle) -> dict[str, tuple[ForceGenerator, str]]:
    """Return generators to register for a, and the names of the particles that each joins to it."""
    return {
        "a spring": (Spring(b, 1.0, 1.0), "b"),
        "a bungee": (Bungee(b, 1.0, 1.0), "b"),
        "a spring with a limit": (ElasticLimitSpring(b, 1.0, 1.0, 2.0, 0.5), "b"),
        "a connection": (connect(ForceRegistry(), a, b, 1.0, 1.0), "b"),
        "the other way around": (connect(ForceRegistry(), c, a, 1.0, 1.0), "c"),
        "a bond": (Bond(c, a, 1.0, 1.0, 1.2, 0.25, 2.0), "c"),
        "a homing bullet": (HomingBullet(c, 1.0, 1.0), "c"),
        "a drive": (RimDrive(b, 1.0), "b"),
        "a crowd": (Overcrowding([a, b, c], 1.0, 1.0), "bc"),
        "a spring to an anchor": (AnchoredSpring(Vector3(), 1.0, 1.0), ""),
        "gravity": (Gravity(Vector3(0.0, -10.0)), ""),
        "hidden by a user": (Hidden(b, c), ""),
        "shown by a user": (Shown(b, c), "bc"),
        "without a __dict__": (Slotted(c), "c"),
    }


@pytest.mark.parametrize("kind", generators(Particle(), Particle(), Particle()))
def test_a_generator_joins_what_it_names(kind: str) -> None:
    bodies = dict(zip("abc", (Particle() for _ in range(3)), strict=True))
    generator, wanted = generators(**bodies)[kind]
    registry = ForceRegistry()
    registry.add(bodies["a"], generator)
    assert joined(registry) == [(bodies["a"], bodies[name]) for name in wanted]


@pytest.mark.parametrize("fixed", [0, 1])
def test_what_is_immovable_is_not_joined(fixed: int) -> None:
    bodies = [Particle(Vector3(float(i))) for i in range(2)]
    bodies[fixed].mass = math.inf
    registry = ForceRegistry()
    registry.add(bodies[0], Spring(bodies[1], 1.0, 1.0))
    assert joined(registry) == []


def test_a_crowd_falls_asleep_and_wakes_together() -> None:
    """Five particles rest 1 m apart, and overcrowding acts within 0.5 m. Then one moves."""
    bodies = [Particle(Vector3(float(i))) for i in range(5)]
    world = SleepingWorld(bodies, sleep_frames=5)
    crowd = Overcrowding(bodies, 0.5, 10.0)
    for body in bodies:
        world.registry.add(body, crowd)
    bodies[4].velocity = Vector3(0.0, 0.0, 3.0)
    for _ in range(10):
        world.step(1.0 / 60.0)
    assert world.asleep == {}
    bodies[4].velocity.clear()
    for _ in range(5):
        world.step(1.0 / 60.0)
    assert set(world.asleep) == set(bodies)
    bodies[2].velocity = Vector3(0.0, 1.0)
    world.step(1.0 / 60.0)
    assert world.asleep == {}
