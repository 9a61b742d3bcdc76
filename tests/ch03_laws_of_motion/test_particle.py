"""Mass, inverse mass and damping (B3.1), momentum (B3.2) and kinetic energy (3.3)."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import components, dot
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    scoped,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 900.0), rng.uniform(0.01, 0.5))), 3)


# B3.1 Mass, inverse mass and damping


@pytest.mark.exercise("B3.1")
def test_a_new_particle_has_the_mass_1_and_keeps_its_velocity() -> None:
    about.call = "Particle()"
    about.cause = "self.mass = mass and self.damping = damping run the bodies of the two setters"
    about.read = "the docstring of Particle"
    p = Particle()
    expect_close(p.mass, 1.0, then=".mass")
    expect_close(p.inverse_mass, 1.0, then=".inverse_mass")
    lost = "that is the share that is lost: damping is the share that is kept"
    blame(p.damping, [(0.0, lost)])
    expect_close(p.damping, 1.0, then=".damping")
    about.cause = "its mass is finite: True is wanted, as a comparison gives it"
    for mass in (1.0, 1e9, 0.001):
        about.call = f"p.has_finite_mass, for a mass of {mass} kg"
        got = Particle(mass=mass).has_finite_mass
        expect_exactly(got, True)


@pytest.mark.exercise("B3.1")
def test_a_mass_is_kept_as_its_inverse(rng: Random) -> None:
    first, second = draw_mass(rng), draw_mass(rng)
    about.read = "book 3.2"
    itself = "that is the mass: the setter of mass keeps 1 / mass, and inverse_mass gives back "
    itself += "what is kept"
    about(f"p = Particle(mass={first}); p.inverse_mass", cause="the inverse mass is 1 / mass")
    p = Particle(mass=first)
    blame(p.inverse_mass, [(first, itself)])
    expect_close(p.inverse_mass, 1.0 / first)
    for mass in (second, 4):  # an int is a number too
        about.cause = "the inverse mass is 1 / mass"
        about.call = f"p = Particle(); p.mass = {mass}; p.inverse_mass"
        p = Particle()
        p.mass = mass
        blame(p.inverse_mass, [(mass, itself)])
        expect_close(p.inverse_mass, 1.0 / mass)


@pytest.mark.exercise("B3.1")
def test_the_mass_comes_back(rng: Random) -> None:
    mass = draw_mass(rng)
    about(cause="what is kept is the inverse: on the way back it is divided again", read="book 3.2")
    for value in (mass, 1e9):
        about.call = f"p = Particle(mass={value!r}); p.mass"
        expect_close(Particle(mass=value).mass, value)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_can_be_assigned(rng: Random) -> None:
    inverse = 1.0 / draw_mass(rng)
    about.call = f"p = Particle(mass=8.0); p.inverse_mass = {inverse}"
    about.cause = "the inverse mass is kept as it is; the mass is 1 / inverse mass, also if it was "
    about.cause += "another"
    about.read = "book 3.2"
    p = Particle(mass=8.0)
    p.inverse_mass = inverse
    once_more = (
        "that is 1 / inverse mass: what is assigned is an inverse already, and kept as it is"
    )
    blame(p.inverse_mass, [(1.0 / inverse, once_more)])
    expect_close(p.inverse_mass, inverse, then="; p.inverse_mass")
    expect_close(p.mass, 1.0 / inverse, then="; p.mass")
    about.call = f"{about.call}; p.has_finite_mass"
    about.cause = "every mass is finite but math.inf"
    expect_exactly(p.has_finite_mass, True)


@pytest.mark.exercise("B3.1")
def test_an_infinite_mass_has_the_inverse_0() -> None:
    about.call = "p = Particle(mass=math.inf)"
    about.cause = "an infinite mass is let in, by positive_or_infinite of arguments.py; 1 / "
    about.cause += "infinity is 0"
    about.read = "book 3.2"
    p = Particle(mass=math.inf)
    expect_close(p.inverse_mass, 0.0, then="; p.inverse_mass")
    about.call += "; p.mass"
    about.cause = "an inverse mass of 0 cannot be divided by: the mass is then math.inf"
    expect_exactly(p.mass, math.inf)
    about.call = "p = Particle(mass=math.inf); p.has_finite_mass"
    about.cause = "its mass is infinite: False is wanted"
    expect_exactly(p.has_finite_mass, False)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_of_0_is_an_infinite_mass() -> None:
    about.call = "p = Particle(); p.inverse_mass = 0"
    about.cause = "0 is a good inverse mass: that of a particle that nothing moves. not_negative "
    about.cause += "of arguments.py lets it in"
    about.read = "book 3.2"
    p = Particle()
    p.inverse_mass = 0
    about.cause = "an inverse mass of 0 cannot be divided by: the mass is then math.inf"
    expect_exactly(p.mass, math.inf, then="; p.mass")
    about.cause = "its mass is infinite: False is wanted"
    got = p.has_finite_mass
    expect_exactly(got, False, then="; p.has_finite_mass")


@pytest.mark.exercise("B3.1")
def test_a_damping_is_kept(rng: Random) -> None:
    about.cause = "damping is kept as it is. 0 is a good one: it stops the particle; above 1 it "
    about.cause += "gains speed. not_negative of arguments.py lets in both"
    about.read = "the docstring of Particle"
    for damping in (0.0, round(rng.uniform(0.1, 0.9), 3), 1.5):
        about.call = f"p = Particle({damping=!r}); p.damping"
        p = Particle(damping=damping)
        expect_close(p.damping, damping)
        about.call = f"p = Particle(); p.damping = {damping!r}; p.damping"
        p = Particle()
        p.damping = damping
        expect_close(p.damping, damping)


@scoped
def expect_refusal(name: str, bad: Any, error: type[Exception], *, good: float, read: str) -> None:
    """Expect that the attribute takes a good value, and then refuses a bad one and stays."""
    about(f"p = Particle(); p.{name} = {good}; p.{name} = {bad!r}", read=read)
    p = Particle()

    def attempt() -> None:
        setattr(p, name, bad)

    def allowed() -> None:
        setattr(p, name, good)

    expect_error(attempt, error, allowed=allowed)
    about.cause = "refuse a value before anything is changed"
    expect_close(getattr(p, name), good, then=f"; p.{name}")


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, -math.inf, math.nan])
def test_a_mass_must_be_positive(bad: float) -> None:
    about.cause = "nothing can be divided by a mass of 0, and a negative one would go the wrong "
    about.cause += "way: positive_or_infinite of arguments.py refuses both"
    expect_refusal("mass", bad, ValueError, good=4.0, read="the docstring of mass")


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.5, math.inf, math.nan])
def test_an_inverse_mass_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = "an infinite inverse mass is a mass of 0, and a negative one is no mass: "
    about.cause += "not_negative of arguments.py refuses both"
    about.read = "the docstring of inverse_mass"
    expect_refusal("inverse_mass", bad, ValueError, good=0.25, read=about.read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.1, math.inf, math.nan])
def test_a_damping_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = "the share of the velocity that is kept is a number, and never below 0: "
    about.cause += "not_negative of arguments.py refuses the rest"
    about.read = "the docstring of damping"
    expect_refusal("damping", bad, ValueError, good=0.5, read=about.read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "good"), [("mass", 4.0), ("inverse_mass", 0.25), ("damping", 0.5)]
)
def test_text_is_no_number(name: str, good: float) -> None:
    about.cause = "the functions of arguments.py raise the TypeError for you"
    about.read = f"the docstring of {name}"
    expect_refusal(name, "2", TypeError, good=good, read=about.read)


# B3.2 Momentum


@pytest.mark.exercise("B3.2")
def test_momentum_is_mass_times_velocity(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.momentum()"
    about.cause = "m v, component by component; the engine keeps 1 / m, and damping is of no "
    about.cause += "account here"
    about.read = "book 3.2"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    wanted = (mass * v[0], mass * v[1], mass * v[2])
    got = xyz(p.momentum())
    mistakes = [
        (tuple(n / mass for n in v), "the velocity was divided by the mass: multiply by self.mass"),
        (mass * math.sqrt(dot(v, v)), "that is its length: momentum has a direction, m v"),
        (v, "that is the velocity: the mass is missing"),
    ]
    blame(got, mistakes)
    expect_close(got, wanted)


@pytest.mark.exercise("B3.2")
def test_momentum_is_a_vector_of_its_own(rng: Random) -> None:
    v = components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.momentum()"
    about.cause = "the momentum is the velocity itself, or *= has changed that: velocity * mass is "
    about.cause += "new"
    about.read = "the docstring of momentum"
    p = Particle(velocity=Vector3(*v))
    momentum = p.momentum()
    expect_close(xyz(momentum), v)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    momentum.x = 99.0
    about.call = f"{about.call}.x = 99.0"
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B3.2")
def test_an_immovable_particle_has_no_momentum(rng: Random) -> None:
    v = components(rng)
    about.cause = "it does not move, whatever its velocity says, and infinity times 0 is NaN: ask "
    about.cause += "has_finite_mass first"
    about.read = "the docstring of momentum"
    for velocity in (ZERO, v):
        about.call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.momentum()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(xyz(p.momentum()), ZERO)
        expect_unchanged("p.velocity", xyz(p.velocity), velocity, cause=UNCHANGED)


# 3.3 Kinetic energy


@pytest.mark.exercise("3.3")
def test_kinetic_energy_is_half_of_m_v_squared(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.kinetic_energy()"
    about.cause = "m |v|^2 / 2: the square of the length, and half of it"
    about.read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    got, squared = p.kinetic_energy(), dot(v, v)
    mistakes = [
        (mass * squared, "that is m |v|^2: the half is missing"),
        (0.5 * mass * math.sqrt(squared), "that is m |v| / 2: the speed is not squared"),
        (0.5 / mass * squared, "that is |v|^2 / (2 m): the inverse mass was taken for the mass"),
    ]
    blame(got, mistakes)
    expect_close(got, 0.5 * mass * squared)
    expect_unchanged("p.velocity", xyz(p.velocity), v, cause=UNCHANGED)


@pytest.mark.exercise("3.3")
def test_a_kilogram_at_2_metres_a_second_has_2_joules() -> None:
    about.call = "p = Particle(velocity=Vector3(0, 0, -2)); p.kinetic_energy()"
    about.cause = "1 kg * (2 m/s)^2 / 2: energy has no direction, and no sign"
    about.read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(0, 0, -2))
    expect_close(p.kinetic_energy(), 2.0)


@pytest.mark.exercise("3.3")
def test_an_immovable_particle_has_no_kinetic_energy(rng: Random) -> None:
    v = components(rng)
    about.cause = "it does not move, whatever its velocity says, and infinity times 0 is NaN: ask "
    about.cause += "has_finite_mass first"
    about.read = "the docstring of kinetic_energy"
    for velocity in (ZERO, v):
        about.call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.kinetic_energy()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(p.kinetic_energy(), 0.0)
