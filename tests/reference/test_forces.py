"""Copies of chapter 5's particle and of its generators' vectors, and very large forces."""

from __future__ import annotations

import copy
import math
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceRegistry, Gravity, PointGravity, Uplift
from ch05_forces.particle import Particle

UP = Vector3(0.0, 1.0, 0.0)


class Charged(Particle):
    """A particle with an attribute in a slot, another in its dict, and its own constructor."""

    def __init__(self, charge: float) -> None:
        super().__init__(UP, UP, UP, mass=4.0, damping=0.5)
        self.charge = charge


@pytest.mark.parametrize("how", [copy.copy, copy.deepcopy])
def test_a_copied_particle_has_its_class_and_forces_and_vectors_of_its_own(how: Any) -> None:
    particle = Charged(3.0)
    particle.add_force(UP)
    particle.integrate(1.0)
    particle.add_force(UP)
    twin = how(particle)
    assert type(twin) is Charged
    twin.add_force(UP)
    assert tuple(particle.force_accumulator) == (0.0, 1.0, 0.0)
    assert tuple(twin.force_accumulator) == (0.0, 2.0, 0.0)
    assert tuple(twin.last_acceleration) == tuple(particle.last_acceleration) == (0.0, 1.25, 0.0)
    particle.integrate(1.0)
    particle.charge = 5.0
    assert tuple(twin.position) == (0.0, 2.0, 0.0)
    assert (twin.mass, twin.damping, twin.charge) == (4.0, 0.5, 3.0)
    assert how(Particle(mass=math.inf)).mass == math.inf


def test_a_force_whose_components_add_up_to_too_much_is_finite_all_the_same() -> None:
    particle = Particle(mass=1e308)
    particle.add_force(Vector3(1.5e308, 1.5e308, -1e308))
    particle.integrate(1.0)
    assert tuple(particle.velocity) == pytest.approx((1.5, 1.5, -1.0))


def test_two_generators_share_nothing_with_what_they_were_made_of() -> None:
    given_vector = Vector3(1.0, 2.0, 3.0)
    gravity = Gravity(given_vector)
    uplift = Uplift(given_vector, 1.0, given_vector)
    towards = PointGravity(given_vector, 1.0)
    given_vector.x = 99.0
    uplift.origin.y = 98.0
    for kept in (gravity.acceleration, uplift.force, towards.center):
        assert tuple(kept) == (1.0, 2.0, 3.0)


def test_the_pairs_of_a_registry_are_a_list_of_its_own() -> None:
    particle, gravity, registry = Particle(), Gravity(Vector3()), ForceRegistry()
    registry.add(particle, gravity)
    registry.pairs().clear()
    registry.add(particle, Drag(0.1, 0.0))
    registry.remove(particle, gravity)
    assert [type(generator) for _, generator in registry.pairs()] == [Drag]
