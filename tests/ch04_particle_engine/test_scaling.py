"""A bullet slow enough to be seen, build task B4.1."""

from __future__ import annotations

from random import Random

import pytest

from calls import calls
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass
from expect import expect_close, named


@pytest.mark.exercise(
    "B4.1", asks="the kinetic energy of a shot, m v^2 / 2", read="book 4.1.1; errata.md"
)
def test_the_energy_of_a_bullet_is_half_of_m_v_squared(rng: Random) -> None:
    drawn = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    for mass, speed in ((0.005, 500.0), drawn):
        with calls("The kinetic energy of the bullet is m v^2 / 2."):
            got = muzzle_energy(mass=mass, speed=speed)
        slips = {
            "You leave out the factor 1/2.": mass * speed**2,
            "You don't square the speed.": mass * speed / 2.0,
            "You square the mass as well.": (mass * speed) ** 2 / 2.0,
            "You divide the speed by 2 before you square it.": mass * (speed / 2.0) ** 2,
        }
        expect_close(got, mass * speed**2 / 2.0, slips, unit="J")


@pytest.mark.exercise(
    "B4.1",
    asks="a slowed shot the kinetic energy of the real shot",
    read="book 4.1.1; the docstring in scaling.py, which defines the factor (E-19)",
)
def test_a_slower_shot_gets_the_mass_that_keeps_its_energy(rng: Random) -> None:
    cause = "Multiply the mass by the square of the factor, because the energy depends on v^2."
    for mass, factor in (
        (0.005, 20.0),
        (round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (round(rng.uniform(2.0, 90.0), 3), 0.25),
    ):
        with calls(
            cause,
            f"slowed_mass(mass={mass}, factor={factor}); the kinetic energy of a shot with this "
            f"mass at {500.0 / factor:.6g} m/s",
        ):
            slow = slowed_mass(mass, factor)
        slips = {
            "You multiply the mass by the factor, which keeps the momentum the same.":
                mass * factor,
            "You divide the mass by the square of the factor, as in the book's footnote (E-19).":
                mass / factor**2,
            "You divide the mass by the factor.": mass / factor,
            "You leave the mass unchanged, so the slower shot has too little energy.": mass,
        }  # fmt: skip
        energy = 0.5 * slow * (500.0 / factor) ** 2
        expect_close(energy, 0.5 * mass * 500.0**2, unit="J", cause=named(slow, cause, slips))


@pytest.mark.exercise(
    "B4.1", asks="a slowed shot the trajectory of the real shot", read="book 4.1.1; errata.md"
)
def test_a_slower_shot_gets_the_gravity_that_keeps_its_arc(rng: Random) -> None:
    cause = "Divide gravity by factor^2, because the drop grows with the square of the time."
    for gravity, factor in (
        (10.0, 20.0),
        (-round(rng.uniform(2.0, 20.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (9.81, 0.5),
    ):
        with calls(
            cause,
            f"slowed_gravity(gravity={gravity}, factor={factor}); how far a shot at "
            f"{500.0 / factor:.6g} m/s drops over 100 m with this gravity",
        ):
            weak = slowed_gravity(gravity, factor)
        slips = {
            "You divide gravity by the factor only once, as in the book (E-2).": gravity / factor,
            "You leave gravity unchanged, so the slow shot drops too far.": gravity,
            "You multiply gravity by the factor.": gravity * factor,
            "You multiply gravity by factor^2.": gravity * factor**2,
        }
        drop = 0.5 * weak * (100.0 * factor / 500.0) ** 2
        expect_close(drop, 0.5 * gravity * 0.2**2, unit="m", cause=named(weak, cause, slips))
