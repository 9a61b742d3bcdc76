"""Mass, inverse mass and damping (B3.1), and momentum (B3.2)."""

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
FLOOR = "You divide with //, which rounds down to a whole number. Use / instead."


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 900.0), rng.uniform(0.01, 0.5))), 3)


# B3.1 Mass, inverse mass and damping


@pytest.mark.exercise("B3.1", asks="A new particle has a mass of 1 kg")
def test_a_new_particle_has_a_mass_of_1_and_a_damping_of_1() -> None:
    about.call = "Particle()"
    about.cause = (
        "A new particle must have a mass of 1 kg and a damping of 1. Check what your setters of "
        "mass and damping store, and what the getters return."
    )
    about.read = "the docstring of Particle"
    p = Particle()
    expect_close(p.mass, 1.0, then=".mass")
    expect_close(p.inverse_mass, 1.0, then=".inverse_mass")
    lost = (
        "You return the fraction of the velocity that is lost per second. Return the damping, the "
        "fraction that the particle keeps."
    )
    blame(p.damping, [(0.0, lost)])
    expect_close(p.damping, 1.0, then=".damping")
    for mass in (1.0, 1e9, 0.001):
        about.call = f"p = Particle(mass={mass}); p.inverse_mass"
        p = Particle(mass=mass)
        about.cause = (
            "The inverse mass of this particle is 0, as if its mass were infinite. Store 1 / mass. "
            "The operator // rounds down to a whole number, here to 0."
        )
        if p.inverse_mass == 0.0:
            expect_close(p.inverse_mass, 1.0 / mass)
        about.call = f"a particle p with a mass of {mass} kg; p.has_finite_mass"
        got = p.has_finite_mass
        about.cause = "You return False for a finite mass. Return True unless the mass is infinite."
        if not isinstance(got, bool):
            what = "a number" if isinstance(got, (int, float)) else "neither True nor False"
            about.cause = f"You return {what}. Return the result of a comparison, True or False."
        expect_exactly(got, True)


@pytest.mark.exercise("B3.1", asks="the engine stores the inverse mass")
def test_a_mass_is_stored_as_its_inverse(rng: Random) -> None:
    first, second = draw_mass(rng), draw_mass(rng)
    about.read = "book 3.2"
    getter = "Your inverse_mass getter returns the mass. Store 1 / mass in the mass setter, "
    getter += "and return it here."
    setter = "Your mass setter stores the mass itself. Store its inverse, 1 / mass, instead."
    about(
        f"p = Particle(mass={first}); p.inverse_mass",
        cause="The inverse mass must be 1 / mass. Store it in the mass setter.",
    )
    p = Particle(mass=first)
    mistakes = [(first, setter if p.mass == 1.0 / first else getter), (1.0 // first, FLOOR)]
    blame(p.inverse_mass, mistakes)
    expect_close(p.inverse_mass, 1.0 / first)
    for mass in (second, 4):  # an int is a number too
        about.cause = (
            "The inverse mass must be 1 / mass. Store it in the setter, every time a mass is "
            "assigned."
        )
        about.call = f"p = Particle(); p.mass = {mass}; p.inverse_mass"
        p = Particle()
        p.mass = mass
        blame(p.inverse_mass, [(mass, setter)])
        expect_close(p.inverse_mass, 1.0 / mass)


@pytest.mark.exercise("B3.1", asks="The mass of the particle in kg")
def test_the_mass_is_returned(rng: Random) -> None:
    mass = draw_mass(rng)
    about.read = "book 3.2"
    inverse = "Your mass getter returns the stored inverse mass. Return 1 / inverse mass."
    for value in (mass, 1e9):
        about.call = f"p = Particle(mass={value!r}); p.mass"
        about.cause = "The mass getter must return the mass, which is 1 / inverse mass."
        got = Particle(mass=value).mass
        blame(got, [(1.0 / value, inverse), (1.0 // (1.0 / value), FLOOR)])
        expect_close(got, value)


@pytest.mark.exercise("B3.1", asks="The inverse of the mass in 1/kg")
def test_an_inverse_mass_can_be_assigned(rng: Random) -> None:
    inverse = 1.0 / draw_mass(rng)
    about.call = f"p = Particle(mass=8.0); p.inverse_mass = {inverse:.6g}"
    about.cause = (
        "The assigned number is already an inverse mass. Store it unchanged, and return 1 / "
        "inverse mass as the mass."
    )
    about.read = "book 3.2"
    p = Particle(mass=8.0)
    p.inverse_mass = inverse
    once_more = (
        "You invert the assigned number, but it is already an inverse mass. Store it unchanged."
    )
    blame(p.inverse_mass, [(1.0 / inverse, once_more)])
    expect_close(p.inverse_mass, inverse, then="; p.inverse_mass")
    expect_close(p.mass, 1.0 / inverse, then="; p.mass")
    about.call = f"{about.call}; p.has_finite_mass"
    about.cause = (
        "The mass of this particle is finite, so has_finite_mass must be True. Only math.inf is an "
        "infinite mass."
    )
    expect_exactly(p.has_finite_mass, True)


@pytest.mark.exercise("B3.1", asks="Infinity makes the particle immovable")
def test_an_infinite_mass_has_the_inverse_0() -> None:
    about.call = "p = Particle(mass=math.inf)"
    about.cause = (
        "You reject an infinite mass, which is valid. Check the mass with positive_or_infinite() "
        "from arguments.py, which accepts math.inf."
    )
    about.read = "book 3.2"
    p = Particle(mass=math.inf)
    about.cause = "You store a wrong inverse mass. The inverse of an infinite mass must be 0."
    expect_close(p.inverse_mass, 0.0, then="; p.inverse_mass")
    about.call += "; p.mass"
    about.cause = (
        "You divide by the inverse mass, which is 0 for an infinite mass. Return math.inf in this "
        "case instead of dividing by 0."
    )
    expect_exactly(p.mass, math.inf)
    about.call = "p = Particle(mass=math.inf); p.has_finite_mass"
    about.cause = (
        "This particle has an infinite mass, so has_finite_mass must be False. Compare the mass "
        "with math.inf."
    )
    expect_exactly(p.has_finite_mass, False)


@pytest.mark.exercise("B3.1", asks="which is 0 if the particle is immovable")
def test_an_inverse_mass_of_0_is_an_infinite_mass() -> None:
    about.call = "p = Particle(); p.inverse_mass = 0"
    about.cause = (
        "You reject an inverse mass of 0, which is valid and means an infinite mass. Check it with "
        "not_negative() from arguments.py, which accepts 0."
    )
    about.read = "book 3.2"
    p = Particle()
    p.inverse_mass = 0
    about.cause = (
        "The inverse mass is 0, which means an infinite mass. Return math.inf in this case instead "
        "of dividing by 0."
    )
    unstored = (
        "You don't store an inverse mass of 0. Python treats 0 as false in an if statement, so "
        "don't use the inverse mass as the condition."
    )
    expect_close(p.inverse_mass, 0.0, then="; p.inverse_mass", cause=unstored)
    expect_exactly(p.mass, math.inf, then="; p.mass")
    about.cause = (
        "This particle has an infinite mass, so has_finite_mass must be False. Compare the mass "
        "with math.inf."
    )
    got = p.has_finite_mass
    expect_exactly(got, False, then="; p.has_finite_mass")


@pytest.mark.exercise("B3.1", asks="0 stops the particle, and a number above 1")
def test_a_damping_is_stored_unchanged(rng: Random) -> None:
    about.read = "the docstring of Particle"
    for damping in (0.0, round(rng.uniform(0.1, 0.9), 3), 1.5):
        about.cause = (
            f"You reject a damping of {damping}, which is valid. Check it with not_negative() from "
            "arguments.py, which accepts 0 and every positive, finite number."
        )
        about.call = f"p = Particle({damping=!r}); p.damping"
        p = Particle(damping=damping)
        about.cause = "Store the damping unchanged."
        if damping > 1.0:
            about.cause = (
                "You limit the damping to 1, but a larger one is valid. Store it unchanged."
            )
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
        f"Your setter stores {bad!r} first and rejects it only afterward. Check the "
        f"{name.replace('_', ' ')} before you store it."
    )
    expect_close(getattr(p, name), good, then=f"; p.{name}")


@pytest.mark.exercise("B3.1", asks="Set the mass in kg, which must be positive")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, -math.inf, math.nan])
def test_a_mass_must_be_positive(bad: float) -> None:
    about.cause = (
        f"The mass is {bad}, but it must be positive (infinity is allowed). Check it with "
        "positive_or_infinite() from arguments.py, which raises the ValueError for you."
    )
    expect_refusal("mass", bad, ValueError, good=4.0, read="the docstring of mass")


@pytest.mark.exercise("B3.1", asks="which must be finite and not negative")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.5, math.inf, math.nan])
def test_an_inverse_mass_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = (
        f"The inverse mass is {bad}, but it must be finite and at least 0. Check it with "
        "not_negative() from arguments.py, which raises the ValueError for you."
    )
    about.read = "the docstring of inverse_mass"
    expect_refusal("inverse_mass", bad, ValueError, good=0.25, read=about.read)


@pytest.mark.exercise("B3.1", asks="Set the damping, which must be finite and not negative")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.1, math.inf, math.nan])
def test_a_damping_must_be_finite_and_not_negative(bad: float) -> None:
    about.cause = (
        f"The damping is {bad}, but it must be finite and at least 0. Check it with not_negative() "
        "from arguments.py, which raises the ValueError for you."
    )
    about.read = "the docstring of damping"
    expect_refusal("damping", bad, ValueError, good=0.5, read=about.read)


@pytest.mark.exercise("B3.1", asks="raises TypeError for anything that is not a number")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "good"), [("mass", 4.0), ("inverse_mass", 0.25), ("damping", 0.5)]
)
def test_text_is_refused_as_a_value(name: str, good: float) -> None:
    about.cause = (
        "A text is not a number. In the setter, pass the value to one of the functions in "
        "arguments.py, which raise the TypeError for you."
    )
    about.read = f"the docstring of {name}"
    expect_refusal(name, "2", TypeError, good=good, read=about.read)


# B3.2 Momentum


@pytest.mark.exercise("B3.2", asks="Return the momentum of the particle, m v")
def test_momentum_is_mass_times_velocity(rng: Random) -> None:
    mass, v = draw_mass(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}, damping=0.5); p.momentum()"
    about.cause = (
        "The momentum is the vector m v. Multiply the velocity by the mass, and don't use the "
        "damping."
    )
    about.read = "book 3.2"
    p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
    wanted = (mass * v[0], mass * v[1], mass * v[2])
    got = xyz(p.momentum())
    mistakes = [
        (
            tuple(n / mass for n in v),
            "You divide the velocity by the mass. Multiply it by self.mass instead.",
        ),
        (
            mass * math.sqrt(dot(v, v)),
            "You return the length of m v, a number. The momentum is a vector, so return m v "
            "itself.",
        ),
        (v, "You return the velocity itself. Multiply it by the mass to get the momentum."),
    ]
    blame(got, mistakes)
    expect_close(got, wanted)


@pytest.mark.exercise("B3.2", asks="m v, in kg m/s as a new vector")
def test_momentum_is_a_new_vector(rng: Random) -> None:
    v = components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}, mass=1.0); p.momentum()"
    about.cause = (
        "Your momentum changes the velocity of the particle. Return a new vector and leave the "
        "velocity unchanged, as self.velocity * self.mass does."
    )
    about.read = "the docstring of momentum"
    p = Particle(velocity=Vector3(*v), mass=1.0)
    momentum = p.momentum()
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    own = "The momentum must be m v, which equals v for a mass of 1 kg."
    expect_close(xyz(momentum), v, cause=own)
    momentum.x = 99.0
    about.call = f"{about.call}.x = 99.0"
    about.cause = (
        "Your momentum returns the velocity vector itself, so a change to the result also changes "
        "the particle. Return a new vector, as self.velocity * self.mass does."
    )
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B3.2", asks="so its momentum is zero")
def test_an_immovable_particle_has_no_momentum(rng: Random) -> None:
    v = components(rng)
    about.cause = (
        "You multiply the velocity by an infinite mass. Return a zero vector if has_finite_mass is "
        "False, because a particle that cannot move has no momentum."
    )
    about.read = "the docstring of momentum"
    for velocity in (ZERO, v):
        about.call = f"p = Particle(velocity=Vector3{velocity}, mass=math.inf); p.momentum()"
        p = Particle(velocity=Vector3(*velocity), mass=math.inf)
        got = xyz(p.momentum())
        number = "You return a number. The momentum is a vector, so return the zero vector."
        blame(got, [(0.0, number)])
        expect_close(got, ZERO)
        expect_unchanged("p.velocity", xyz(p.velocity), velocity, cause=UNCHANGED)
