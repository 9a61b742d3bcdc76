"""The particle: closed forms of its flights, copies, and numbers at the limits of floats."""

from __future__ import annotations

import copy
import math
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from scenes.flight import DAMPED_FALL, GRAVITY, Flight

INF = math.inf
VECTORS = ("position", "velocity", "acceleration")


def test_the_closed_form_of_the_flights_gives_the_known_flight_of_a_shot() -> None:
    place, velocity, acceleration = (0.0, 1.5, 0.0), (0.0, 30.0, 40.0), (0.0, -20.0, 0.0)
    for damping, time, reach in ((1.0, 3.0491933, 121.96773), (0.99, 3.0347583, 119.557788)):
        landed = Flight(place, velocity, acceleration, damping).exact(time).position
        # The times are known to 5e-8 s, and the shot falls at 31 m/s.
        assert landed[1] == pytest.approx(0.0, abs=2e-6)
        assert landed[2] == pytest.approx(reach, abs=1e-5)


def test_the_closed_form_ends_at_the_terminal_speed_and_begins_as_a_free_fall() -> None:
    late, early = DAMPED_FALL.exact(100.0), DAMPED_FALL.exact(1e-6)
    assert late.velocity[1] == pytest.approx(GRAVITY[1] / math.log(2.0), rel=1e-14)
    # The first term of the drag is k t / 3 of the fall, 2e-7, and a rounding is 1e-16 / 1e-12.
    assert early.position[1] == pytest.approx(0.5 * GRAVITY[1] * 1e-12, rel=1e-3)


def test_the_default_is_a_kilogram_at_rest_at_the_origin() -> None:
    particle = Particle()
    assert [tuple(getattr(particle, name)) for name in VECTORS] == [(0.0, 0.0, 0.0)] * 3
    assert (particle.mass, particle.inverse_mass, particle.damping) == (1.0, 1.0, 1.0)
    assert particle.has_finite_mass


@pytest.mark.parametrize("name", VECTORS)
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


@pytest.mark.parametrize("how", [copy.copy, copy.deepcopy])
def test_a_copied_particle_goes_its_own_way(how: Any) -> None:
    particle = Particle(velocity=Vector3(8.0, 0.0, 0.0), damping=0.5)
    particle.integrate(1.0)
    twin = how(particle)
    particle.damping = 0.25
    particle.integrate(1.0)
    twin.integrate(1.0)
    assert (particle.velocity.x, twin.velocity.x) == (1.0, 2.0)
    assert (particle.position.x, twin.position.x) == (12.0, 12.0)
    twin.integrate(1.0)
    assert (particle.position.x, twin.position.x) == (12.0, 14.0)


def test_in_place_operators_work_on_a_particle_s_vectors() -> None:
    particle = Particle(velocity=Vector3(1.0, 0.0, 0.0))
    particle.velocity += Vector3(1.0, 0.0, 0.0)
    particle.velocity *= 3.0
    particle.velocity.y = 4.0
    assert tuple(particle.velocity) == (6.0, 4.0, 0.0)


def test_a_refused_step_is_no_lasting_damage() -> None:
    particle = Particle(velocity=Vector3(1.0, 0.0, 0.0), damping=1e200)
    with pytest.raises(OverflowError):
        particle.kick(10.0)  # 1e200^10 overflows
    assert tuple(particle.position) == (0.0, 0.0, 0.0)
    assert tuple(particle.velocity) == (1.0, 0.0, 0.0)
    with pytest.raises(OverflowError):
        particle.integrate(10.0)  # drifts, but the kick fails
    assert tuple(particle.position) == (10.0, 0.0, 0.0)
    assert tuple(particle.velocity) == (1.0, 0.0, 0.0)
    particle.damping = 1.0
    particle.integrate(10.0)
    assert tuple(particle.position) == (20.0, 0.0, 0.0)


def test_a_mass_too_small_to_have_an_inverse_is_refused() -> None:
    with pytest.raises(ValueError, match="1 / mass must be finite and not negative, got inf"):
        Particle(mass=5e-324)


def test_an_inverse_mass_too_small_to_have_a_mass_gives_no_nan() -> None:
    particle = Particle()
    particle.inverse_mass = 5e-324
    assert particle.mass == INF
    assert not particle.has_finite_mass
    assert particle.kinetic_energy() == 0.0
    assert tuple(particle.momentum()) == (0.0, 0.0, 0.0)
