"""A force generator joins the particles that it names in public, and no others."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.springs import (
    AnchoredSpring,
    HomingBullet,
    Overcrowding,
    Spring,
    connect,
)
from ch08_mass_aggregate.blob import Bond
from ch08_mass_aggregate.joints import joined
from ch08_mass_aggregate.wheel import RimDrive


class Own:
    """A user's generator, which stores its particles in an attribute of the given name."""

    def __init__(self, name: str, *others: Particle) -> None:
        setattr(self, name, others)

    def update_force(self, particle: Particle, duration: float) -> None:
        """Add no force."""


def generators(a: Particle, b: Particle, c: Particle) -> dict[str, tuple[ForceGenerator, str]]:
    """Return generators to register for a, and the names of the particles that each joins to it."""
    return {
        "a spring": (Spring(b, 1.0, 1.0), "b"),
        "a connection": (connect(ForceRegistry(), c, a, 1.0, 1.0), "c"),
        "a bond": (Bond(c, a, 1.0, 1.0, 1.2, 0.25, 2.0), "c"),
        "a homing bullet": (HomingBullet(c, 1.0, 1.0), "c"),
        "a drive": (RimDrive(b, 1.0), "b"),
        "a crowd": (Overcrowding([a, b, c], 1.0, 1.0), "bc"),
        "a spring to an anchor": (AnchoredSpring(Vector3(), 1.0, 1.0), ""),
        "gravity": (Gravity(Vector3(0.0, -10.0)), ""),
        "hidden by a user": (Own("_others", b, c), ""),
        "shown by a user": (Own("particles", b, c), "bc"),
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
