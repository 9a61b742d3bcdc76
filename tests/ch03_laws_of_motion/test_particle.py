"""Mass, inverse mass and damping (B3.1), momentum (B3.2) and kinetic energy (3.3)."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import components, dot
from expect import cause_of, expect_close, expect_error, expect_exactly, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 900.0), rng.uniform(0.01, 0.5))), 3)


# B3.1 Mass, inverse mass and damping


@pytest.mark.exercise("B3.1")
def test_a_new_particle_has_the_mass_1_and_keeps_its_velocity() -> None:
    call = "Particle()"
    cause = "self.mass = mass and self.damping = damping run the bodies of the two setters"
    read = "the docstring of Particle"
    p = Particle()
    expect_close(f"{call}.mass", p.mass, 1.0, cause=cause, read=read)
    expect_close(f"{call}.inverse_mass", p.inverse_mass, 1.0, cause=cause, read=read)
    lost = "that is the share that is lost: damping is the share that is kept"
    cause = cause_of(p.damping, [(0.0, lost)], cause)
    expect_close(f"{call}.damping", p.damping, 1.0, cause=cause, read=read)
    cause = "its mass is finite: True is wanted, as a comparison gives it"
    for mass in (1.0, 1e9, 0.001):
        call = f"p.has_finite_mass, for a mass of {mass} kg"
        got = Particle(mass=mass).has_finite_mass
        expect_exactly(call, got, True, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_a_mass_is_kept_as_its_inverse(rng: Random) -> None:
    first, second = draw_mass(rng), draw_mass(rng)
    read = "book 3.2"
    itself = "that is the mass: the setter of mass keeps 1 / mass, and inverse_mass gives back "
    itself += "what is kept"
    cause = "the inverse mass is 1 / mass"
    call = f"p = Particle(mass={first}); p.inverse_mass"
    p = Particle(mass=first)
    cause = cause_of(p.inverse_mass, [(first, itself)], cause)
    expect_close(call, p.inverse_mass, 1.0 / first, cause=cause, read=read)
    for mass in (second, 4):  # an int is a number too
        cause = "the inverse mass is 1 / mass"
        call = f"p = Particle(); p.mass = {mass}; p.inverse_mass"
        p = Particle()
        p.mass = mass
        cause = cause_of(p.inverse_mass, [(mass, itself)], cause)
        expect_close(call, p.inverse_mass, 1.0 / mass, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_the_mass_comes_back(rng: Random) -> None:
    mass = draw_mass(rng)
    cause = "what is kept is the inverse: on the way back it is divided again"
    read = "book 3.2"
    for value in (mass, 1e9):
        call = f"p = Particle(mass={value!r}); p.mass"
        expect_close(call, Particle(mass=value).mass, value, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_can_be_assigned(rng: Random) -> None:
    inverse = 1.0 / draw_mass(rng)
    call = f"p = Particle(mass=8.0); p.inverse_mass = {inverse}"
    cause = (
        "the inverse mass is kept as it is; the mass is 1 / inverse mass, also if it was another"
    )
    read = "book 3.2"
    p = Particle(mass=8.0)
    p.inverse_mass = inverse
    once_more = (
        "that is 1 / inverse mass: what is assigned is an inverse already, and kept as it is"
    )
    cause = cause_of(p.inverse_mass, [(1.0 / inverse, once_more)], cause)
    expect_close(f"{call}; p.inverse_mass", p.inverse_mass, inverse, cause=cause, read=read)
    expect_close(f"{call}; p.mass", p.mass, 1.0 / inverse, cause=cause, read=read)
    call = f"{call}; p.has_finite_mass"
    cause = "every mass is finite but math.inf"
    expect_exactly(call, p.has_finite_mass, True, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_an_infinite_mass_has_the_inverse_0() -> None:
    call = "p = Particle(mass=math.inf)"
    cause = "an infinite mass is let in, by positive_or_infinite of arguments.py; 1 / infinity is 0"
    read = "book 3.2"
    p = Particle(mass=math.inf)
    expect_close(f"{call}; p.inverse_mass", p.inverse_mass, 0.0, cause=cause, read=read)
    call += "; p.mass"
    cause = "an inverse mass of 0 cannot be divided by: the mass is then math.inf"
    expect_exactly(call, p.mass, math.inf, cause=cause, read=read)
    call = "p = Particle(mass=math.inf); p.has_finite_mass"
    cause = "its mass is infinite: False is wanted"
    expect_exactly(call, p.has_finite_mass, False, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_of_0_is_an_infinite_mass() -> None:
    call = "p = Particle(); p.inverse_mass = 0"
    cause = "0 is a good inverse mass: that of a particle that nothing moves. not_negative of "
    cause += "arguments.py lets it in"
    read = "book 3.2"
    p = Particle()
    p.inverse_mass = 0
    cause = "an inverse mass of 0 cannot be divided by: the mass is then math.inf"
    expect_exactly(f"{call}; p.mass", p.mass, math.inf, cause=cause, read=read)
    cause = "its mass is infinite: False is wanted"
    got = p.has_finite_mass
    expect_exactly(f"{call}; p.has_finite_mass", got, False, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
def test_a_damping_is_kept(rng: Random) -> None:
    cause = (
        "damping is kept as it is. 0 is a good one: it stops the particle; above 1 it gains speed. "
        "not_negative of arguments.py lets in both"
    )
    read = "the docstring of Particle"
    for damping in (0.0, round(rng.uniform(0.1, 0.9), 3), 1.5):
        call = f"p = Particle({damping=!r}); p.damping"
        p = Particle(damping=damping)
        expect_close(call, p.damping, damping, cause=cause, read=read)
        call = f"p = Particle(); p.damping = {damping!r}; p.damping"
        p = Particle()
        p.damping = damping
        expect_close(call, p.damping, damping, cause=cause, read=read)


def expect_refusal(
    name: str, bad: Any, error: type[Exception], *, good: float, cause: str, read: str
) -> None:
    """Expect that the attribute takes a good value, and then refuses a bad one and stays."""
    call = f"p = Particle(); p.{name} = {good}; p.{name} = {bad!r}"
    p = Particle()

    def attempt() -> None:
        setattr(p, name, bad)

    def allowed() -> None:
        setattr(p, name, good)

    expect_error(call, attempt, error, allowed=allowed, cause=cause, read=read)
    cause = "refuse a value before anything is changed"
    expect_close(f"{call}; p.{name}", getattr(p, name), good, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, -math.inf, math.nan])
def test_a_mass_must_be_positive(bad: float) -> None:
    cause = "nothing can be divided by a mass of 0, and a negative one would go the wrong way: "
    cause += "positive_or_infinite of arguments.py refuses both"
    expect_refusal("mass", bad, ValueError, good=4.0, cause=cause, read="the docstring of mass")


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.5, math.inf, math.nan])
def test_an_inverse_mass_must_be_finite_and_not_negative(bad: float) -> None:
    cause = "an infinite inverse mass is a mass of 0, and a negative one is no mass: not_negative "
    cause += "of arguments.py refuses both"
    read = "the docstring of inverse_mass"
    expect_refusal("inverse_mass", bad, ValueError, good=0.25, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.1, math.inf, math.nan])
def test_a_damping_must_be_finite_and_not_negative(bad: float) -> None:
    cause = "the share of the velocity that is kept is a number, and never below 0: not_negative "
    cause += "of arguments.py refuses the rest"
    read = "the docstring of damping"
    expect_refusal("damping", bad, ValueError, good=0.5, cause=cause, read=read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "good"), [("mass", 4.0), ("inverse_mass", 0.25), ("damping", 0.5)]
)
def test_text_is_no_number(name: str, good: float) -> None:
    cause = "the functions of arguments.py raise the TypeError for you"
    read = f"the docstring of {name}"
    expect_refusal(name, "2", TypeError, good=good, cause=cause, read=read)


# B3.2 Momentum


@pytest.mark.exercise("B3.2")
def test_momentum_is_mass_times_velocity(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.momentum()"
    cause = "m v, component by component; the engine keeps 1 / m, and damping is of no account here"
    read = "book 3.2"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    wanted = (mass * v[0], mass * v[1], mass * v[2])
    got = xyz(p.momentum())
    mistakes = [
        (tuple(n / mass for n in v), "the velocity was divided by the mass: multiply by self.mass"),
        (mass * math.sqrt(dot(v, v)), "that is its length: momentum has a direction, m v"),
        (v, "that is the velocity: the mass is missing"),
    ]
    cause = cause_of(got, mistakes, cause)
    expect_close(call, got, wanted, cause=cause, read=read)


@pytest.mark.exercise("B3.2")
def test_momentum_is_a_vector_of_its_own(rng: Random) -> None:
    v = components(rng)
    call = f"p = Particle(velocity=Vector3{v}); p.momentum()"
    cause = "the momentum is the velocity itself, or *= has changed that: velocity * mass is new"
    read = "the docstring of momentum"
    p = Particle(velocity=Vector3(*v))
    momentum = p.momentum()
    expect_close(call, xyz(momentum), v, cause=cause, read=read)
    expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)
    momentum.x = 99.0
    call = f"{call}.x = 99.0"
    expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)


@pytest.mark.exercise("B3.2")
def test_an_immovable_particle_has_no_momentum(rng: Random) -> None:
    v = components(rng)
    cause = "it does not move, whatever its velocity says, and infinity times 0 is NaN: ask "
    cause += "has_finite_mass first"
    read = "the docstring of momentum"
    for velocity in (ZERO, v):
        call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.momentum()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(call, xyz(p.momentum()), ZERO, cause=cause, read=read)
        expect_unchanged(call, "p.velocity", xyz(p.velocity), velocity, read=read)


# 3.3 Kinetic energy


@pytest.mark.exercise("3.3")
def test_kinetic_energy_is_half_of_m_v_squared(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.kinetic_energy()"
    cause = "m |v|^2 / 2: the square of the length, and half of it"
    read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    got, squared = p.kinetic_energy(), dot(v, v)
    mistakes = [
        (mass * squared, "that is m |v|^2: the half is missing"),
        (0.5 * mass * math.sqrt(squared), "that is m |v| / 2: the speed is not squared"),
        (0.5 / mass * squared, "that is |v|^2 / (2 m): the inverse mass was taken for the mass"),
    ]
    cause = cause_of(got, mistakes, cause)
    expect_close(call, got, 0.5 * mass * squared, cause=cause, read=read)
    expect_unchanged(call, "p.velocity", xyz(p.velocity), v, read=read)


@pytest.mark.exercise("3.3")
def test_a_kilogram_at_2_metres_a_second_has_2_joules() -> None:
    call = "p = Particle(velocity=Vector3(0, 0, -2)); p.kinetic_energy()"
    cause = "1 kg * (2 m/s)^2 / 2: energy has no direction, and no sign"
    read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(0, 0, -2))
    expect_close(call, p.kinetic_energy(), 2.0, cause=cause, read=read)


@pytest.mark.exercise("3.3")
def test_an_immovable_particle_has_no_kinetic_energy(rng: Random) -> None:
    v = components(rng)
    cause = "it does not move, whatever its velocity says, and infinity times 0 is NaN: ask "
    cause += "has_finite_mass first"
    read = "the docstring of kinetic_energy"
    for velocity in (ZERO, v):
        call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.kinetic_energy()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(call, p.kinetic_energy(), 0.0, cause=cause, read=read)
