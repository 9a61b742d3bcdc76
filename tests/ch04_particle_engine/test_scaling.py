"""A bullet slow enough to be seen, build task B4.1."""

from __future__ import annotations

from random import Random

import pytest

from ch04_particle_engine import scaling
from expect import about, blame, cause_of, expect_close


@pytest.mark.exercise("B4.1", asks="the kinetic energy of a shot, m v^2 / 2")
def test_the_energy_of_a_bullet_is_half_of_m_v_squared(rng: Random) -> None:
    about(
        "muzzle_energy(mass=0.005, speed=500)",
        cause="The kinetic energy of the bullet is m v^2 / 2. Compare each factor of your "
        "formula with this one.",
        read="book 4.1.1; errata.md",
    )
    got = scaling.muzzle_energy(0.005, 500)
    mistakes = [
        (
            1250.0,
            "You leave out the factor 1/2. The kinetic energy is m v^2 / 2.",
        ),
        (
            1.25,
            "You don't square the speed. The kinetic energy is m v^2 / 2.",
        ),
        (
            3.125,
            "You square the mass as well. Square only the speed: m v^2 / 2.",
        ),
        (
            312.5,
            "You divide the speed by 2 before you square it, so the energy is half as large as it "
            "should be. The kinetic energy is m v^2 / 2.",
        ),
    ]
    expect_close(got, 625.0, unit="J", cause=cause_of(got, mistakes, about.cause))
    mass, speed = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    about.call = f"muzzle_energy(mass={mass}, speed={speed})"
    got = scaling.muzzle_energy(mass, speed)
    expect_close(got, 0.5 * mass * speed * speed, unit="J")


@pytest.mark.exercise("B4.1", asks="a slowed shot the kinetic energy of the real shot")
def test_a_slower_shot_gets_the_mass_that_keeps_its_energy(rng: Random) -> None:
    about.read = "book 4.1.1; the docstring in scaling.py, which defines the factor (E-19)"
    for mass, factor in (
        (0.005, 20.0),
        (round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (round(rng.uniform(2.0, 90.0), 3), 0.25),
    ):
        about.call = (
            f"slowed_mass(mass={mass}, factor={factor}); the kinetic energy of a shot "
            f"with this mass at {500.0 / factor:.6g} m/s"
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
                    "You divide the mass by the square of the factor, as in the book's footnote "
                    "(E-19). Multiply by the square instead, because a slower shot needs a larger "
                    "mass."
                ),
            ),
            (
                mass / factor,
                "You divide the mass by the factor. A slower shot needs a larger mass, so multiply "
                "it by the square of the factor.",
            ),
            (
                mass,
                "You leave the mass unchanged, so the slower shot has too little energy. "
                "Multiply the mass by the square of the factor.",
            ),
        ]
        blame(slow, mistakes)
        energy = 0.5 * slow * (500.0 / factor) ** 2
        expect_close(energy, 0.5 * mass * 500.0**2, unit="J")


@pytest.mark.exercise("B4.1", asks="a slowed shot the trajectory of the real shot")
def test_a_slower_shot_gets_the_gravity_that_keeps_its_arc(rng: Random) -> None:
    about.read = "book 4.1.1; errata.md"
    for gravity, factor in (
        (10.0, 20.0),
        (-round(rng.uniform(2.0, 20.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (9.81, 0.5),
    ):
        about.call = (
            f"slowed_gravity(gravity={gravity}, factor={factor}); how far a shot at "
            f"{500.0 / factor:.6g} m/s drops over 100 m with this gravity"
        )
        longer = "Divide it by factor^2, because the drop grows with the square of the time."
        about.cause = f"Your gravity is wrong. {longer}"
        weak = scaling.slowed_gravity(gravity, factor)
        weaker = (
            "Divide it by factor^2 instead, because the slower shot flies longer and must not drop "
            "farther."
        )
        mistakes = [
            (
                gravity / factor,
                f"You divide gravity by the factor only once, as in the book (E-2). {longer}",
            ),
            (
                gravity,
                f"You leave gravity unchanged, so the slow shot drops too far. {longer}",
            ),
            (gravity * factor, f"You multiply gravity by the factor. {weaker}"),
            (gravity * factor**2, f"You multiply gravity by factor^2. {weaker}"),
        ]
        blame(weak, mistakes)
        drop = 0.5 * weak * (100.0 * factor / 500.0) ** 2
        expect_close(drop, 0.5 * gravity * 0.2**2, unit="m")
