"""Mass, inverse mass and damping (B3.1), momentum (B3.2) and kinetic energy (3.3)."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from draw import Triple, vector
from expect import (
    UNCHANGED,
    about,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    xyz,
)

DOC = "the docstring of the method"
ENERGY = "book 3, exercise 3.3"
ZERO = Triple((0.0, 0.0, 0.0))
PARTICLE = "the docstring of Particle"
FLOOR = "You divide with //, which rounds down to a whole number. Use / instead."
ONLY_INFINITE = (
    "Your has_finite_mass is wrong. It must be False if the mass is math.inf, and otherwise True."
)
NO_DIVISION = "Return math.inf in this case instead of dividing by 0."


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 900.0), rng.uniform(0.01, 0.5))), 3)


# B3.1 Mass, inverse mass and damping


@pytest.mark.exercise("B3.1", asks="A new particle has a mass of 1 kg", read=PARTICLE)
def test_a_new_particle_has_a_mass_of_1_and_a_damping_of_1() -> None:
    with calls(
        "A new particle must have a mass of 1 kg and a damping of 1. Check what your setters of "
        "mass and damping store, and what the getters return."
    ):
        p = Particle()
    expect_close(p.mass, 1.0, then=".mass")
    expect_close(p.inverse_mass, 1.0, then=".inverse_mass")
    lost = (
        "You return the fraction of the velocity that is lost per second. Return the damping, the "
        "fraction that the particle keeps."
    )
    expect_close(p.damping, 1.0, {lost: 0.0}, then=".damping")
    for mass in (1.0, 1e9, 0.001):
        with calls(
            "The inverse mass of this particle is 0, as if its mass were infinite. Store 1 / mass. "
            "The operator // rounds down to a whole number, here to 0."
        ):
            p = Particle(mass=mass)
        if p.inverse_mass == 0.0:
            expect_close(p.inverse_mass, 1.0 / mass, then=".inverse_mass")
        with calls(
            "You return False for a finite mass. Return True unless the mass is infinite.",
            f"a particle p with a mass of {mass} kg; p.has_finite_mass",
        ):
            got = Particle(mass=mass).has_finite_mass
        if not isinstance(got, bool):
            what = "a number" if isinstance(got, (int, float)) else "neither True nor False"
            about(cause=f"You return {what}. Return the result of a comparison, True or False.")
        expect_exactly(got, True)


@pytest.mark.exercise("B3.1", asks="the engine stores the inverse mass", read="book 3.2")
def test_a_mass_is_stored_as_its_inverse(rng: Random) -> None:
    first, second = draw_mass(rng), draw_mass(rng)
    inverse = "The inverse mass must be 1 / mass. Store it in the setter, every time a mass is set."
    getter = (
        "Your inverse_mass getter returns the mass. Store 1 / mass in the mass setter, and return "
        "it here."
    )
    setter = "Your mass setter stores the mass itself. Store its inverse, 1 / mass, instead."
    with calls(inverse):
        p = Particle(mass=first)
    slips = {setter if p.mass == 1.0 / first else getter: first, FLOOR: 1.0 // first}
    expect_close(p.inverse_mass, 1.0 / first, slips, then=".inverse_mass")
    for mass in (second, 4):  # an int is a number too
        with calls(inverse):
            p = Particle()
            p.mass = mass
        expect_close(p.inverse_mass, 1.0 / mass, {setter: mass}, then="; p.inverse_mass")


@pytest.mark.exercise("B3.1", asks="The mass of the particle in kg", read="book 3.2")
def test_the_mass_is_returned(rng: Random) -> None:
    for mass in (draw_mass(rng), 1e9):
        with calls("The mass getter must return the mass, which is 1 / inverse mass."):
            got = Particle(mass=mass).mass
        slips = {
            "Your mass getter returns the stored inverse mass.": 1.0 / mass,
            FLOOR: 1.0 // (1.0 / mass),
        }
        expect_close(got, mass, slips)


@pytest.mark.exercise("B3.1", asks="The inverse of the mass in 1/kg", read="book 3.2")
def test_an_inverse_mass_can_be_assigned(rng: Random) -> None:
    inverse = 1.0 / draw_mass(rng)
    with calls(
        "The assigned number is already an inverse mass. Store it unchanged, and return 1 / "
        "inverse mass as the mass."
    ):
        p = Particle(mass=8.0)
        p.inverse_mass = inverse
    slips = {"You invert the assigned number.": 1.0 / inverse}
    expect_close(p.inverse_mass, inverse, slips, then="; p.inverse_mass")
    expect_close(p.mass, 1.0 / inverse, then="; p.mass")
    expect_exactly(p.has_finite_mass, True, then="; p.has_finite_mass", cause=ONLY_INFINITE)


@pytest.mark.exercise("B3.1", asks="Infinity makes the particle immovable", read="book 3.2")
def test_an_infinite_mass_has_the_inverse_0() -> None:
    with calls(
        "You reject an infinite mass, which is valid. Check the mass with positive_or_infinite() "
        "from arguments.py, which accepts math.inf."
    ):
        p = Particle(mass=math.inf)
    wrong = "You store a wrong inverse mass. The inverse of an infinite mass must be 0."
    expect_close(p.inverse_mass, 0.0, then=".inverse_mass", cause=wrong)
    with calls(f"You divide by the inverse mass, which is 0 for an infinite mass. {NO_DIVISION}"):
        p = Particle(mass=math.inf)
        got = p.mass
    expect_exactly(got, math.inf)
    expect_exactly(p.has_finite_mass, False, then="; p.has_finite_mass", cause=ONLY_INFINITE)


@pytest.mark.exercise("B3.1", asks="which is 0 if the particle is immovable", read="book 3.2")
def test_an_inverse_mass_of_0_is_an_infinite_mass() -> None:
    with calls(
        "You reject an inverse mass of 0, which is valid and means an infinite mass. Check it with "
        "not_negative() from arguments.py, which accepts 0."
    ):
        p = Particle()
        p.inverse_mass = 0
    unstored = (
        "You don't store an inverse mass of 0. Python treats 0 as false in an if statement, so "
        "don't use the inverse mass as the condition."
    )
    expect_close(p.inverse_mass, 0.0, then="; p.inverse_mass", cause=unstored)
    about(cause=f"The inverse mass is 0, which means an infinite mass. {NO_DIVISION}")
    expect_exactly(p.mass, math.inf, then="; p.mass")
    expect_exactly(p.has_finite_mass, False, then="; p.has_finite_mass", cause=ONLY_INFINITE)


@pytest.mark.exercise("B3.1", asks="0 stops the particle, and a number above 1", read=PARTICLE)
def test_a_damping_is_stored_unchanged(rng: Random) -> None:
    for damping in (0.0, round(rng.uniform(0.1, 0.9), 3), 1.5):
        rejected = (
            f"You reject a damping of {damping}, which is valid. Check it with not_negative() from "
            "arguments.py, which accepts 0 and every positive, finite number."
        )
        limited = "You limit the damping to 1, but a larger one is valid."
        cause = f"{limited if damping > 1.0 else 'You change the damping.'} Store it unchanged."
        with calls(rejected):
            p = Particle(damping=damping)
        expect_close(p.damping, damping, then=".damping", cause=cause)
        with calls(rejected):
            p = Particle()
            p.damping = damping
        expect_close(p.damping, damping, then="; p.damping", cause=cause)


WRONG_VALUE = (
    "The {} is {}, but it must be {}. Check it with {}() from arguments.py, which raises the "
    "ValueError for you."
).format


def expect_refusal(
    name: str, bad: Any, good: float, cause: str, error: type[Exception] = ValueError
) -> None:
    """Expect the attribute to accept a good value, then to refuse a bad one and not to change."""
    __tracebackhide__ = True
    p = Particle()
    call, read = (
        f"p = Particle(); p.{name} = {good}; p.{name} = {bad!r}",
        f"the docstring of {name}",
    )
    about(call, cause=cause, read=read)
    expect_error(lambda: setattr(p, name, bad), error, allowed=lambda: setattr(p, name, good))
    late = (
        f"Your setter stores {bad!r} first and rejects it only afterward. Check the "
        f"{name.replace('_', ' ')} before you store it."
    )
    expect_close(getattr(p, name), good, then=f"; p.{name}", cause=late)


@pytest.mark.exercise("B3.1", asks="Set the mass in kg, which must be positive")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, -math.inf, math.nan])
def test_a_mass_must_be_positive(bad: float) -> None:
    must = "positive (infinity is allowed)"
    expect_refusal("mass", bad, 4.0, WRONG_VALUE("mass", bad, must, "positive_or_infinite"))


@pytest.mark.exercise("B3.1", asks="which must be finite and not negative")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.5, math.inf, math.nan])
def test_an_inverse_mass_must_be_finite_and_not_negative(bad: float) -> None:
    cause = WRONG_VALUE("inverse mass", bad, "finite and at least 0", "not_negative")
    expect_refusal("inverse_mass", bad, 0.25, cause)


@pytest.mark.exercise("B3.1", asks="Set the damping, which must be finite and not negative")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [-0.1, math.inf, math.nan])
def test_a_damping_must_be_finite_and_not_negative(bad: float) -> None:
    cause = WRONG_VALUE("damping", bad, "finite and at least 0", "not_negative")
    expect_refusal("damping", bad, 0.5, cause)


@pytest.mark.exercise("B3.1", asks="raises TypeError for anything that is not a number")
@pytest.mark.robust
@pytest.mark.parametrize(
    ("name", "good"), [("mass", 4.0), ("inverse_mass", 0.25), ("damping", 0.5)]
)
def test_text_is_refused_as_a_value(name: str, good: float) -> None:
    cause = (
        "A text is not a number. In the setter, pass the value to one of the functions in "
        "arguments.py, which raise the TypeError for you."
    )
    expect_refusal(name, "2", good, cause, TypeError)


# B3.2 Momentum


@pytest.mark.exercise("B3.2", asks="Return the momentum of the particle, m v", read="book 3.2")
def test_momentum_is_mass_times_velocity(rng: Random) -> None:
    mass, v = draw_mass(rng), vector(rng)
    with calls(
        "The momentum is the vector m v. Multiply the velocity by the mass, and don't use the "
        "damping."
    ):
        p = Particle(velocity=Vector3(*v), mass=mass, damping=0.5)
        got = p.momentum()
    slips = {
        "You divide the velocity by the mass.": v / mass,
        "You return the length of m v, a number.": mass * abs(v),
        "You return the velocity itself. Multiply it by the mass to get the momentum.": v,
    }
    expect_close(xyz(got), mass * v, slips)


@pytest.mark.exercise("B3.2", asks="m v, in kg m/s as a new vector", read=DOC)
def test_momentum_is_a_new_vector(rng: Random) -> None:
    v = vector(rng)
    new = "Return a new vector, as self.velocity * self.mass does."
    with calls(f"Your momentum changes the velocity of the particle. {new}"):
        p = Particle(velocity=Vector3(*v), mass=1.0)
        got = p.momentum()
    expect_unchanged("p.velocity", p.velocity, v)
    own = "The momentum must be m v, which equals v for a mass of 1 kg."
    expect_close(xyz(got), v, cause=own)
    with calls(
        "Your momentum returns the velocity vector itself, so a change to the result also changes "
        f"the particle. {new}",
        f"{about.call}.x = 99.0",
    ):
        got.x = 99.0
    expect_unchanged("p.velocity", p.velocity, v)


@pytest.mark.exercise("B3.2", asks="so its momentum is zero", read=DOC)
def test_an_immovable_particle_has_no_momentum(rng: Random) -> None:
    for v in (ZERO, vector(rng)):
        with calls(
            "You multiply the velocity by an infinite mass. Return a zero vector if "
            "has_finite_mass is False, because a particle that cannot move has no momentum."
        ):
            p = Particle(velocity=Vector3(*v), mass=math.inf)
            got = p.momentum()
        number = "You return a number. The momentum is a vector, so return the zero vector."
        expect_close(xyz(got), ZERO, {number: 0.0})
        expect_unchanged("p.velocity", p.velocity, v, cause=UNCHANGED)


# 3.3 Kinetic energy


@pytest.mark.exercise("3.3", asks="the kinetic energy of the particle, m |v|^2 / 2", read=ENERGY)
def test_kinetic_energy_is_half_of_m_v_squared(rng: Random) -> None:
    mass, x, v = draw_mass(rng), vector(rng), vector(rng)
    try:
        with calls("The kinetic energy is m |v|^2 / 2, where m is the mass and |v| the speed."):
            p = Particle(Vector3(*x), Vector3(*v), mass=mass, damping=0.5)
            got = p.kinetic_energy()
    except TypeError as error:
        if "for **" in str(error):
            about(
                cause="A vector has no power, so ** does not work for it. Use "
                "self.velocity.squared_magnitude() for |v|^2."
            )
        raise
    energy = 0.5 * mass * (v @ v)
    slips = {
        "Your result is 0. In Python 1 // 2 is 0, so write 0.5 * m or m / 2 instead.": 0.0,
        FLOOR: 2.0 * energy // 2.0,
        "You use the position instead of the velocity.": 0.5 * mass * (x @ x),
        "You leave out the mass.": energy / mass,
        "You square the mass as well. Square only the speed: m |v|^2 / 2.": energy * mass,
        "You return m |v|^2, without the factor 1/2.": 2.0 * energy,
        "You return m |v| / 2. Square the speed |v|.": energy / abs(v),
        "You multiply by the inverse mass instead of the mass.": energy / mass**2,
    }
    expect_close(got, energy, slips)
    expect_unchanged("p.velocity", p.velocity, v, cause=UNCHANGED)


@pytest.mark.exercise("3.3", asks="the kinetic energy of the particle, m |v|^2 / 2", read=ENERGY)
def test_a_kilogram_at_2_meters_a_second_has_2_joules() -> None:
    with calls(
        "The kinetic energy must be 1 kg * (2 m/s)^2 / 2 = 2 J. It doesn't depend on the direction "
        "of the velocity, so it is never negative."
    ):
        p = Particle(velocity=Vector3(0, 0, -2), mass=1.0)
        got = p.kinetic_energy()
    expect_close(got, 2.0)


@pytest.mark.exercise("3.3", asks="so its kinetic energy is 0", read=DOC)
def test_an_immovable_particle_has_no_kinetic_energy(rng: Random) -> None:
    for v in (ZERO, vector(rng)):
        with calls(
            "If you multiply by an infinite mass, you get infinity or NaN. Return 0.0 if "
            "has_finite_mass is False, because a particle that cannot move has no kinetic energy."
        ):
            p = Particle(velocity=Vector3(*v), mass=math.inf)
            got = p.kinetic_energy()
        expect_close(got, 0.0)
