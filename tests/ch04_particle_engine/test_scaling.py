"""A bullet slow enough to be seen, build task B4.1."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch04_particle_engine import scaling
from expect import about, blame, cause_of, expect_close, expect_error


@pytest.mark.exercise("B4.1")
def test_the_energy_of_a_bullet_is_half_of_m_v_squared(rng: Random) -> None:
    about(
        "muzzle_energy(mass=0.005, speed=500)",
        cause="The kinetic energy of the bullet is m v^2 / 2. Check each factor of your formula "
        "against it.",
        read="book 4.1.1; errata.md",
    )
    got = scaling.muzzle_energy(0.005, 500)
    mistakes = [
        (
            1250.0,
            "The result is m v^2, because you leave out the factor 1/2. The kinetic energy is m "
            "v^2 / 2.",
        ),
        (
            1.25,
            "The result is m v / 2, because you don't square the speed. The kinetic energy is m "
            "v^2 / 2.",
        ),
    ]
    expect_close(got, 625.0, cause=cause_of(got, mistakes, about.cause))
    mass, speed = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    about.call = f"muzzle_energy(mass={mass}, speed={speed})"
    got = scaling.muzzle_energy(mass, speed)
    expect_close(got, 0.5 * mass * speed * speed)
    about(
        f"muzzle_energy(mass={mass}, speed=0)",
        cause="A speed of 0 is valid, because a body can be at rest. Check the speed with "
        "not_negative from arguments.py, and return 0.",
    )
    expect_close(scaling.muzzle_energy(mass, 0), 0.0)


@pytest.mark.exercise("B4.1")
def test_a_slower_shot_gets_the_mass_that_keeps_its_energy(rng: Random) -> None:
    about.read = "book 4.1.1; the docstring in scaling.py, which defines the factor (E-19)"
    for mass, factor in (
        (0.005, 20.0),
        (round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (round(rng.uniform(2.0, 90.0), 3), 0.25),
    ):
        about.call = (
            f"slowed_mass(mass={mass}, factor={factor}); the energy of a shot at "
            f"{500.0 / factor:.6g} m/s with this mass, in J"
        )
        about.cause = (
            "The slower shot does not have the energy of the real shot. The energy depends on the "
            "square of the speed, so multiply the mass by the square of the factor."
        )
        slow = scaling.slowed_mass(mass, factor)
        mistakes = [
            (
                mass * factor,
                "You multiply the mass by the factor, which keeps the momentum the same. To "
                "keep the energy the same, multiply the mass by the square of the factor.",
            ),
            (
                mass / factor**2,
                (
                    "You make the mass smaller, as in the book's footnote (E-19), but a slower "
                    "shot needs a larger mass. The factor is the real speed divided by the speed "
                    "in the game."
                ),
            ),
            (
                mass,
                "You leave the mass unchanged, so the slower shot has too little energy. "
                "Multiply the mass by the square of the factor.",
            ),
        ]
        blame(slow, mistakes)
        energy = 0.5 * slow * (500.0 / factor) ** 2
        expect_close(energy, 0.5 * mass * 500.0**2)


@pytest.mark.exercise("B4.1")
def test_a_slower_shot_gets_the_gravity_that_keeps_its_arc(rng: Random) -> None:
    about.read = "book 4.1.1; errata.md"
    for gravity, factor in (
        (10.0, 20.0),
        (-round(rng.uniform(2.0, 20.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (9.81, 0.5),
        (0.0, 4.0),
    ):
        about.call = (
            f"slowed_gravity(gravity={gravity}, factor={factor}); the drop after 100 m of a shot "
            f"at {500.0 / factor:.6g} m/s with this gravity, in m"
        )
        about.cause = (
            "You reject a valid gravity: it may be negative or 0. Check it with finite from "
            "arguments.py."
        )
        weak = scaling.slowed_gravity(gravity, factor)
        longer = (
            "The slower shot flies factor times as long, and the drop grows with the square of "
            "the time, so divide gravity by factor^2."
        )
        stronger = "You multiply gravity instead of dividing it."
        mistakes = [
            (
                gravity / factor,
                f"You divide gravity by the factor only once, as in the book (E-2). {longer}",
            ),
            (gravity * factor, f"{stronger} {longer}"),
            (
                gravity * factor**2,
                f"You multiply gravity instead of dividing it. {longer}",
            ),
        ]
        about.cause = cause_of(weak, mistakes, longer)
        drop = 0.5 * weak * (100.0 * factor / 500.0) ** 2
        expect_close(drop, 0.5 * gravity * 0.2**2)


@pytest.mark.exercise("B4.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [0.0, -2.0, math.inf, math.nan])
def test_masses_and_factors_are_positive_and_finite(bad: float) -> None:
    about.cause = (
        "Every mass and every factor must be positive and finite. Pass each of them to positive "
        "from arguments.py, which raises the ValueError for you."
    )
    about.read = "the docstrings in scaling.py"
    for name, data, good in (
        ("muzzle_energy", (bad, 3.0), (2.0, 3.0)),
        ("slowed_mass", (bad, 3.0), (2.0, 3.0)),
        ("slowed_mass", (2.0, bad), (2.0, 3.0)),
        ("slowed_gravity", (2.0, bad), (2.0, 3.0)),
    ):
        about.call = f"{name}{data}"
        function = getattr(scaling, name)
        expect_error(
            lambda function=function, data=data: function(*data),
            ValueError,
            allowed=lambda function=function, good=good: function(*good),
        )


@pytest.mark.exercise("B4.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan])
def test_speed_and_gravity_are_finite(bad: float) -> None:
    about.cause = (
        "The speed must be finite and not negative, and gravity must be finite. Check them with "
        "not_negative and finite from arguments.py."
    )
    about.read = "the docstrings in scaling.py"
    for call, attempt in (
        (f"muzzle_energy(2, {bad})", lambda: scaling.muzzle_energy(2.0, bad)),
        ("muzzle_energy(2, -3)", lambda: scaling.muzzle_energy(2.0, -3.0)),
        (f"slowed_gravity({bad}, 2)", lambda: scaling.slowed_gravity(bad, 2.0)),
    ):
        about.call = call
        expect_error(
            attempt,
            ValueError,
            allowed=lambda: scaling.muzzle_energy(2.0, 0.0) + scaling.slowed_gravity(-9.0, 3.0),
        )


@pytest.mark.exercise("B4.1")
@pytest.mark.robust
def test_text_is_no_number() -> None:
    about.cause = (
        "Every argument must be a number. Pass each of them to positive, not_negative or finite "
        "from arguments.py, which raise this TypeError for you."
    )
    about.read = "the docstring in scaling.py"
    text: Any = "2"
    for call, attempt in (
        ('muzzle_energy("2", 3)', lambda: scaling.muzzle_energy(text, 3.0)),
        ('slowed_mass(2, "2")', lambda: scaling.slowed_mass(2.0, text)),
        ('slowed_gravity("2", 3)', lambda: scaling.slowed_gravity(text, 3.0)),
    ):
        about.call = call
        expect_error(attempt, TypeError, allowed=lambda: scaling.slowed_mass(2.0, 3.0))
