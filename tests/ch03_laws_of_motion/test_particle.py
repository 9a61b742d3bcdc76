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
    about.cause = (
        "In __init__, store the mass and the damping through your setters, by assigning self.mass "
        "= mass and self.damping = damping."
    )
    about.read = "the docstring of Particle"
    p = Particle()
    expect_close(p.mass, 1.0, then=".mass")
    expect_close(p.inverse_mass, 1.0, then=".inverse_mass")
    lost = (
        "You returned the fraction of the velocity that is lost in a second. The damping is the "
        "fraction that is kept."
    )
    blame(p.damping, [(0.0, lost)])
    expect_close(p.damping, 1.0, then=".damping")
    about.cause = (
        "This mass is finite, so return True. A comparison is already True or False, so return its "
        "result directly."
    )
    for mass in (1.0, 1e9, 0.001):
        about.call = f"p.has_finite_mass, for a mass of {mass} kg"
        got = Particle(mass=mass).has_finite_mass
        expect_exactly(got, True)


@pytest.mark.exercise("B3.1")
def test_a_mass_is_kept_as_its_inverse(rng: Random) -> None:
    first, second = draw_mass(rng), draw_mass(rng)
    about.read = "book 3.2"
    itself = (
        "The result is the mass itself, but the particle stores the inverse mass. Store 1 / mass "
        "in the setter of mass."
    )
    about(
        f"p = Particle(mass={first}); p.inverse_mass",
        cause="The particle stores the inverse mass, 1 / mass.",
    )
    p = Particle(mass=first)
    blame(p.inverse_mass, [(first, itself)])
    expect_close(p.inverse_mass, 1.0 / first)
    for mass in (second, 4):  # an int is a number too
        about.cause = (
            "The particle stores the inverse mass, 1 / mass. Store it every time a mass is "
            "assigned."
        )
        about.call = f"p = Particle(); p.mass = {mass}; p.inverse_mass"
        p = Particle()
        p.mass = mass
        blame(p.inverse_mass, [(mass, itself)])
        expect_close(p.inverse_mass, 1.0 / mass)


@pytest.mark.exercise("B3.1")
def test_the_mass_comes_back(rng: Random) -> None:
    mass = draw_mass(rng)
    about(
        cause="The particle stores only the inverse mass, so the getter of mass must return 1 / "
        "inverse mass.",
        read="book 3.2",
    )
    for value in (mass, 1e9):
        about.call = f"p = Particle(mass={value!r}); p.mass"
        expect_close(Particle(mass=value).mass, value)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_can_be_assigned(rng: Random) -> None:
    inverse = 1.0 / draw_mass(rng)
    about.call = f"p = Particle(mass=8.0); p.inverse_mass = {inverse}"
    about.cause = (
        "The assigned number is already an inverse mass, so store it as is. The mass is then 1 / "
        "inverse mass."
    )
    about.read = "book 3.2"
    p = Particle(mass=8.0)
    p.inverse_mass = inverse
    once_more = (
        "The result is 1 / inverse mass. The assigned number is already an inverse mass, so store "
        "it as is."
    )
    blame(p.inverse_mass, [(1.0 / inverse, once_more)])
    expect_close(p.inverse_mass, inverse, then="; p.inverse_mass")
    expect_close(p.mass, 1.0 / inverse, then="; p.mass")
    about.call = f"{about.call}; p.has_finite_mass"
    about.cause = "Only math.inf is an infinite mass, so has_finite_mass must be True here."
    expect_exactly(p.has_finite_mass, True)


@pytest.mark.exercise("B3.1")
def test_an_infinite_mass_has_the_inverse_0() -> None:
    about.call = "p = Particle(mass=math.inf)"
    about.cause = (
        "An infinite mass is valid, and its inverse is 0. Check the mass with positive_or_infinite "
        "from arguments.py, which accepts math.inf."
    )
    about.read = "book 3.2"
    p = Particle(mass=math.inf)
    expect_close(p.inverse_mass, 0.0, then="; p.inverse_mass")
    about.call += "; p.mass"
    about.cause = (
        "An inverse mass of 0 stands for an infinite mass, so return math.inf instead of dividing "
        "by 0."
    )
    expect_exactly(p.mass, math.inf)
    about.call = "p = Particle(mass=math.inf); p.has_finite_mass"
    about.cause = (
        "This particle has infinite mass, so has_finite_mass must be False. Compare the mass with "
        "math.inf."
    )
    expect_exactly(p.has_finite_mass, False)


@pytest.mark.exercise("B3.1")
def test_an_inverse_mass_of_0_is_an_infinite_mass() -> None:
    about.call = "p = Particle(); p.inverse_mass = 0"
    about.cause = (
        "An inverse mass of 0 is valid: it stands for a particle that cannot be moved. Check it "
        "with not_negative from arguments.py, which accepts 0."
    )
    about.read = "book 3.2"
    p = Particle()
    p.inverse_mass = 0
    about.cause = (
        "An inverse mass of 0 stands for an infinite mass, so return math.inf instead of dividing "
        "by 0."
    )
    expect_exactly(p.mass, math.inf, then="; p.mass")
    about.cause = (
        "This particle has infinite mass, so has_finite_mass must be False. Compare the mass with "
        "math.inf."
    )
    got = p.has_finite_mass
    expect_exactly(got, False, then="; p.has_finite_mass")


@pytest.mark.exercise("B3.1")
def test_a_damping_is_kept(rng: Random) -> None:
    about.cause = (
        "Store the damping unchanged, because 0 and numbers above 1 are valid too. Check it with "
        "not_negative from arguments.py."
    )
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
    """Expect the attribute to accept a good value, then to refuse a bad one and not to change."""
    about(f"p = Particle(); p.{name} = {good}; p.{name} = {bad!r}", read=read)
    p = Particle()

    def attempt() -> None:
        setattr(p, name, bad)

    def allowed() -> None:
        setattr(p, name, good)

    expect_error(attempt, error, allowed=allowed)
    about.cause = (
        "The setter rejected this value only after storing it. Check the value before you store "
        "it, so that a rejected value changes nothing."
    )
    expect_close(getattr(p, name), good, then=f"; p.{name}")


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, -math.inf, math.nan])
def test_a_mass_must_be_positive(bad: float) -> None:
    about.cause = (
        "A mass must be positive, and it may be infinite. Pass it to positive_or_infinite from "
        "arguments.py, which raises the ValueError for you."
    )
    expect_refusal("mass", bad, ValueError, good=4.0, read="the docstring of mass")


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.5, math.inf, math.nan])
def test_an_inverse_mass_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = (
        "An inverse mass must be finite and must not be negative. Pass it to not_negative from "
        "arguments.py, which raises the ValueError for you."
    )
    about.read = "the docstring of inverse_mass"
    expect_refusal("inverse_mass", bad, ValueError, good=0.25, read=about.read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.1, math.inf, math.nan])
def test_a_damping_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = (
        "A damping must be finite and must not be negative. Pass it to not_negative from "
        "arguments.py, which raises the ValueError for you."
    )
    about.read = "the docstring of damping"
    expect_refusal("damping", bad, ValueError, good=0.5, read=about.read)


@pytest.mark.exercise("B3.1")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "good"), [("mass", 4.0), ("inverse_mass", 0.25), ("damping", 0.5)]
)
def test_text_is_no_number(name: str, good: float) -> None:
    about.cause = (
        "In the setter, pass the value to one of the functions in arguments.py, which raise this "
        "TypeError for you."
    )
    about.read = f"the docstring of {name}"
    expect_refusal(name, "2", TypeError, good=good, read=about.read)


# B3.2 Momentum


@pytest.mark.exercise("B3.2")
def test_momentum_is_mass_times_velocity(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.momentum()"
    about.cause = (
        "The momentum is the vector m v, so multiply the velocity by the mass. The damping plays "
        "no part in it."
    )
    about.read = "book 3.2"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    wanted = (mass * v[0], mass * v[1], mass * v[2])
    got = xyz(p.momentum())
    mistakes = [
        (
            tuple(n / mass for n in v),
            "The velocity was divided by the mass. Multiply it by self.mass instead.",
        ),
        (
            mass * math.sqrt(dot(v, v)),
            "The result is the length of m v, but the momentum is a vector. Return m v itself.",
        ),
        (v, "The result is the velocity alone. Multiply it by the mass to get the momentum."),
    ]
    blame(got, mistakes)
    expect_close(got, wanted)


@pytest.mark.exercise("B3.2")
def test_momentum_is_a_vector_of_its_own(rng: Random) -> None:
    v = components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.momentum()"
    about.cause = (
        "momentum must return a new vector and leave the velocity unchanged. The expression "
        "self.velocity * self.mass creates one."
    )
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
    about.cause = (
        "An immovable particle has no momentum, so return a zero vector. Check has_finite_mass "
        "first, because infinity times 0 is NaN."
    )
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
    about.cause = "The kinetic energy is m |v|^2 / 2, where |v| is the speed."
    about.read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    got, squared = p.kinetic_energy(), dot(v, v)
    mistakes = [
        (
            mass * squared,
            "The result is m |v|^2. The kinetic energy is half of this.",
        ),
        (
            0.5 * mass * math.sqrt(squared),
            "The result is m |v| / 2. Square the speed, because the kinetic energy is m |v|^2 / 2.",
        ),
        (
            0.5 / mass * squared,
            "The result was computed with the inverse mass. Multiply by self.mass instead.",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, 0.5 * mass * squared)
    expect_unchanged("p.velocity", xyz(p.velocity), v, cause=UNCHANGED)


@pytest.mark.exercise("3.3")
def test_a_kilogram_at_2_meters_a_second_has_2_joules() -> None:
    about.call = "p = Particle(velocity=Vector3(0, 0, -2)); p.kinetic_energy()"
    about.cause = (
        "The kinetic energy is 1 kg * (2 m/s)^2 / 2 = 2 J. It doesn't depend on the direction of "
        "the velocity, so it is never negative."
    )
    about.read = "book 3, exercise 3.3"
    p = Particle(velocity=Vector3(0, 0, -2))
    expect_close(p.kinetic_energy(), 2.0)


@pytest.mark.exercise("3.3")
def test_an_immovable_particle_has_no_kinetic_energy(rng: Random) -> None:
    v = components(rng)
    about.cause = (
        "An immovable particle has no kinetic energy. Check has_finite_mass first, because "
        "infinity times 0 is NaN."
    )
    about.read = "the docstring of kinetic_energy"
    for velocity in (ZERO, v):
        about.call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.kinetic_energy()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        expect_close(p.kinetic_energy(), 0.0)
