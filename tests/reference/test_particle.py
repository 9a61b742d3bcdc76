"""The particle copies its vectors, and its masses reach the limits of floats."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle


@pytest.mark.parametrize("name", ["position", "velocity", "acceleration"])
def test_vectors_are_copied_when_given_and_when_assigned(name: str) -> None:
    v = Vector3(1.0, 2.0, 3.0)
    given, assigned = Particle(**{name: v}), Particle()
    setattr(assigned, name, v)
    v.x = 99.0
    other = Particle()
    setattr(other, name, getattr(given, name))
    getattr(other, name).y = 99.0
    for particle in (given, assigned):
        assert tuple(getattr(particle, name)) == (1.0, 2.0, 3.0)


def test_an_inverse_mass_too_small_to_have_a_mass_gives_no_nan() -> None:
    particle = Particle()
    particle.inverse_mass = 5e-324
    assert particle.mass == math.inf
    assert not particle.has_finite_mass
    assert particle.kinetic_energy() == 0.0
    assert tuple(particle.momentum()) == (0.0, 0.0, 0.0)
