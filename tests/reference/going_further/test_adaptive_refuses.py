"""Which conditions end a call of the adaptive integrator, and which do not.

Stiff springs do not explode. A singularity, forces that fail and forces that are not numbers cause
an error with a clear message, and never an endless loop.
"""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.going_further import adaptive as module
from ch06_springs.going_further.adaptive import AdaptiveStep, adaptive
from ch06_springs.integrators import ApplyForces, Integrator
from ch06_springs.springs import AnchoredSpring

FRAME = 1.0 / 60.0


def sprung(k: float) -> tuple[Particle, ApplyForces]:
    """Return 1 kg that is released 1 m from the anchor of a spring with rest length 0."""
    particle, registry = Particle(Vector3(1.0)), ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), k, 0.0))
    return particle, registry.update_forces


@pytest.mark.parametrize("k", [1e4, 1e8])
def test_a_stiff_spring_explodes_nothing(k: float) -> None:
    particle, apply_forces = sprung(k)
    step = adaptive(1e-4)
    for _ in range(600 if k == 1e4 else 6):
        step([particle], apply_forces, FRAME)
        energy = particle.velocity.x**2 / k + particle.position.x**2
        # Each step loses some energy, and gains at most what the tolerance allows.
        assert energy < 1.0 + 1e-3
    assert energy > 0.5


def test_a_fall_into_a_center_stops_with_a_clear_error() -> None:
    """From rest at 1 m, the fall takes pi / sqrt(8) s and ends in a singularity."""
    particle, registry = Particle(Vector3(1.0)), ForceRegistry()
    registry.add(particle, InverseSquareGravity(Vector3(), 1.0))
    step = adaptive(1e-6)
    words = r"adaptive\(1e-06\) cannot go on at (.*) s of a call of 2 s, with steps of"
    with pytest.raises(ArithmeticError, match=words) as raised:
        step([particle], registry.update_forces, 2.0)
    reached = float(str(raised.value).split(" at ")[1].split()[0])
    assert reached == pytest.approx(math.pi / math.sqrt(8.0), abs=1e-4)
    assert 0.0 < particle.position.magnitude() < 1e-3  # the position after the last good step
    assert tuple(particle.force_accumulator) == (0.0, 0.0, 0.0)
    assert step.evaluations < 6 * module.MOST_STEPS
    # It can be used again, and does not keep the length of its last step.
    particle.position, particle.velocity, step.evaluations = Vector3(1.0), Vector3(0.0, 1.0), 0
    step([particle], registry.update_forces, 0.01)
    assert step.evaluations == 7
    assert particle.position.x == pytest.approx(math.cos(0.01), abs=1e-6)
    assert particle.position.y == pytest.approx(math.sin(0.01), abs=1e-6)


def test_a_trial_that_leads_to_where_no_force_can_be_found_is_only_too_long() -> None:
    particle = Particle(Vector3(1.0))
    refused = []

    def apply_forces(_: float) -> None:
        x = particle.position.x
        if abs(x) > 1.5:
            refused.append(x)
            raise (ValueError if len(refused) % 2 else ZeroDivisionError)("out of bounds")
        particle.add_force(Vector3(-x))

    step = adaptive(1e-10)
    step([particle], apply_forces, 10.0)
    assert refused
    assert particle.position.x == pytest.approx(math.cos(10.0), abs=1e-8)


def test_forces_that_fail_where_the_motion_has_to_go_are_named() -> None:
    particle = Particle(velocity=Vector3(1.0))

    def wall(_: float) -> None:
        if particle.position.x > 0.5:
            raise ValueError("there is no force beyond 0.5 m")

    with pytest.raises(ArithmeticError, match=r"at 0\.5 s of a call of 1 s") as raised:
        adaptive(1e-6)([particle], wall, 1.0)
    assert str(raised.value.__cause__) == "there is no force beyond 0.5 m"
    assert particle.position.x == pytest.approx(0.5, abs=1e-13)
    particle.position.x = 0.6
    with pytest.raises(ValueError, match="there is no force"):  # at the start of the call
        adaptive(1e-6)([particle], wall, 1.0)
    assert (particle.position.x, particle.velocity.x) == (0.6, 1.0)


class Unchecked(Particle):
    """A particle that accepts any force, like one whose add_force checks nothing."""

    @property
    def force_accumulator(self) -> Vector3:
        return Vector3(math.nan if self.position.x > 0.5 else 0.0)


def test_a_force_that_is_not_a_number_ends_in_an_error() -> None:
    bullet = Unchecked(velocity=Vector3(1.0))
    step = adaptive(1e-6)
    with pytest.raises(ArithmeticError, match=r"at 0\.5 s of a call of 1 s"):
        step([Particle(mass=math.inf), bullet], lambda _: None, 1.0)
    assert step.evaluations < 1000
    checked = Particle()
    with pytest.raises(ValueError, match="force must have finite components"):
        step([checked], lambda _: checked.add_force(Vector3(math.nan)), 1.0)


def test_a_call_ends_after_the_most_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_STEPS", 50)
    particle, apply_forces = sprung(1e4)
    words = r"adaptive\(1e-09\) cannot go on at .* s of a call of 10 s"
    with pytest.raises(ArithmeticError, match=words):
        adaptive(1e-9)([particle], apply_forces, 10.0)
    assert abs(particle.position.x) <= 1.0


def test_it_says_what_it_is() -> None:
    step: Integrator = adaptive(1e-6)
    assert isinstance(step, AdaptiveStep)
    assert repr(step) == "adaptive(1e-06)"
