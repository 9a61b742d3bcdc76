"""Chapter 5's particle, registry and generators: laws and limits."""

from __future__ import annotations

import copy
import math
from typing import Any

import pytest
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import particle
from ch05_forces.forces import (
    Airbrake,
    Drag,
    ForceRegistry,
    Gravity,
    InverseSquareGravity,
    PointGravity,
    Uplift,
)
from ch05_forces.particle import Particle
from ch05_forces.sniper import Wind

NAN, INF = math.nan, math.inf
UP = Vector3(0.0, 1.0, 0.0)
component = st.floats(-1e6, 1e6)
vector = st.tuples(component, component, component)


# The accumulator and the step


def test_a_force_whose_components_add_up_to_too_much_is_finite_all_the_same() -> None:
    particle = Particle(mass=1e308)
    particle.add_force(Vector3(1.5e308, 1.5e308, -1e308))
    particle.integrate(1.0)
    assert tuple(particle.velocity) == pytest.approx((1.5, 1.5, -1.0))


@pytest.mark.parametrize("how", [copy.copy, copy.deepcopy])
def test_a_copied_particle_has_forces_of_its_own(how: Any) -> None:
    particle = Particle(UP, UP, UP, mass=4.0, damping=0.5)
    particle.add_force(UP)
    particle.integrate(1.0)
    particle.add_force(UP)
    twin = how(particle)
    assert type(twin) is Particle
    twin.add_force(UP)
    assert tuple(particle.force_accumulator) == (0.0, 1.0, 0.0)
    assert tuple(twin.force_accumulator) == (0.0, 2.0, 0.0)
    assert tuple(twin.last_acceleration) == tuple(particle.last_acceleration) == (0.0, 1.25, 0.0)
    particle.integrate(1.0)
    assert tuple(twin.position) == (0.0, 2.0, 0.0)
    assert (twin.mass, twin.damping) == (4.0, 0.5)
    assert how(Particle(mass=INF)).mass == INF


class Charged(Particle):
    """A particle with an attribute in a slot, and with a constructor of its own."""

    __slots__ = ("charge",)

    def __init__(self, charge: float) -> None:
        super().__init__(UP, mass=2.0)
        self.charge = charge


class Named(particle.Particle):
    """A particle of chapter 3 with an attribute in its dict."""


class NamedWithForces(Particle):
    """A particle of chapter 5 with an attribute in its dict."""


@pytest.mark.parametrize("how", [copy.copy, copy.deepcopy])
def test_a_copy_of_a_subclass_has_its_class_and_attributes(how: Any) -> None:
    charged = Charged(3.0)
    charged.add_force(UP)
    twin = how(charged)
    assert type(twin) is Charged
    assert (twin.charge, twin.mass, tuple(twin.position)) == (3.0, 2.0, (0.0, 1.0, 0.0))
    twin.add_force(UP)
    twin.position.y = 5.0
    assert tuple(charged.force_accumulator) == tuple(charged.position) == (0.0, 1.0, 0.0)
    for kind in (Named, NamedWithForces):
        named: Any = kind(UP)
        named.name = "ball"
        twin = how(named)
        assert (type(twin), twin.name) == (kind, "ball")
        twin.name = "twin"
        assert named.name == "ball"


def test_the_sum_can_only_be_changed_by_adding() -> None:
    with pytest.raises(AttributeError):
        Particle().force_accumulator = UP  # type: ignore[misc]


# Generators


def test_two_generators_share_nothing_with_what_they_were_made_of() -> None:
    given_vector = Vector3(1.0, 2.0, 3.0)
    gravity = Gravity(given_vector)
    uplift = Uplift(given_vector, 1.0, given_vector)
    towards = PointGravity(given_vector, 1.0)
    given_vector.x = 99.0
    uplift.origin.y = 98.0
    for kept in (gravity.acceleration, uplift.force, towards.center):
        assert tuple(kept) == (1.0, 2.0, 3.0)


def test_generators_leave_immovable_particles_where_they_are() -> None:
    registry = ForceRegistry()
    particle = Particle(Vector3(1.0, 2.0, 3.0), UP, UP, mass=INF)
    brake = Airbrake(1.0)
    brake.on = True
    generators = (
        Gravity(UP),
        Drag(1.0, 1.0),
        Uplift(Vector3(), 9.0, UP),
        brake,
        PointGravity(Vector3(), 1.0),
        InverseSquareGravity(Vector3(), 1.0),
        InverseSquareGravity(particle.position, 1.0),
        Wind(1.0, 1.0),
    )
    for generator in generators:
        registry.add(particle, generator)
        generator.update_force(particle, 0.5)  # once more by hand
        particle.integrate(0.5)
        registry.update_forces(0.5)
        particle.integrate(0.5)
        assert tuple(particle.position) == (1.0, 2.0, 3.0)
        assert tuple(particle.velocity) == tuple(UP)


def test_the_pairs_of_a_registry_are_a_list_of_its_own() -> None:
    particle, first, second = Particle(), Gravity(Vector3()), Drag(0.1, 0.0)
    registry = ForceRegistry()
    registry.add(particle, first)
    registry.add(particle, second)
    pairs = registry.pairs()
    assert [(p is particle, g) for p, g in pairs] == [(True, first), (True, second)]
    pairs.clear()
    registry.remove(particle, first)
    assert [g for _, g in registry.pairs()] == [second]
