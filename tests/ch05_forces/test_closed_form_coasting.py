"""Coasting without steps (B5.7)."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch05_forces.closed_form import coasting_speed
from draw import positive_number
from expect import about, blame, expect_close, named

COAST = "the docstring of coasting_speed"
# Formulas of a few operations each, of which none loses digits: relative.
ROUNDED = 1e-12
QUADRATIC = "Quadratic drag still acts, so use t / m in place of (1 - e^-s) / k1."


@pytest.mark.exercise("B5.7", asks="v e^-s / (1 + k2 v (1 - e^-s) / k1)")
def test_coasting_with_both_kinds_of_drag(rng: Random) -> None:
    about.read = COAST
    about.cause = "The speed is wrong. It must be v e^-s / (1 + k2 v (1 - e^-s) / k1), where v is "
    about.cause += "the initial speed and s = k1 t / m."
    for _ in range(3):
        v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
        mass, time = positive_number(rng), positive_number(rng, 0.2, 2.0)
        about.call = f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass={mass}, time={time})"
        ratio = k2 / k1
        # From 1 / v + k2 / k1, which grows as e^(k1 t / m).
        wanted = 1.0 / ((1.0 / v + ratio) * math.exp(k1 * time / mass) - ratio)
        got = coasting_speed(v, k1, k2, mass, time)
        s = k1 * time / mass
        half = 1.0 + ratio * v * math.expm1(-s)
        slips = {
            "You use e^s instead of e^-s, where s = k1 t / m. Drag slows the body down, so the "
            "exponent is negative.": v * math.exp(s) / (1.0 - ratio * v * math.expm1(s)),
            "You use e^s instead of e^-s in the numerator, where s = k1 t / m. Drag slows the body "
            "down, so the exponent is negative.": v
            * math.exp(s)
            / (1.0 - ratio * v * math.expm1(-s)),
            "You divide only by the 1. Put the whole denominator 1 + k2 v (1 - e^-s) / k1 in "
            "parentheses.": v * math.exp(-s) - ratio * v * math.expm1(-s),
            "The initial speed v is missing from the denominator. It must be 1 + k2 v (1 - e^-s) / "
            "k1, where s = k1 t / m.": v * math.exp(-s) / (1.0 - ratio * math.expm1(-s)),
            "The initial speed v is missing from the numerator. It must be v e^-s, where s = k1 t "
            "/ m.": math.exp(-s) / (1.0 - ratio * v * math.expm1(-s)),
            "The second term of your denominator is negative. Either you subtract it, or it has "
            "e^-s - 1 in place of 1 - e^-s, where s = k1 t / m.": v * math.exp(-s) / half,
            "Your result is v e^-s, where s = k1 t / m. Include the quadratic drag (k2) too.": (
                v * math.exp(-s)
            ),
            "You apply the quadratic drag first and then the linear drag, but both act at the "
            "same time. In the denominator, replace t / m by (1 - e^-s) / k1, where s = k1 t / "
            "m.": (v * math.exp(-s) / (1.0 + k2 * v * time / mass)),
            "The mass is missing from the exponent s. It must be s = k1 t / m, where m is the "
            "mass.": (v * math.exp(-s * mass) / (1.0 - ratio * v * math.expm1(-s * mass))),
            "Your denominator contains the mass as an extra factor. It must be 1 + k2 v (1 - "
            "e^-s) / k1, where v is the initial speed and s = k1 t / m.": (
                v * math.exp(-s) / (1.0 - ratio * mass * v * math.expm1(-s))
            ),
            "A division by k1 is missing from the denominator. It must be 1 + k2 v (1 - e^-s) / "
            "k1, where v is the initial speed and s = k1 t / m.": (
                v * math.exp(-s) / (1.0 - k2 * v * math.expm1(-s))
            ),
        }
        why = named(got, about.cause, slips)
        # The difference in the denominator loses a digit or two.
        expect_close(got, wanted, cause=why, tolerance=1e-10 * v, unit="m/s")
    half = coasting_speed(v, k1, k2, mass, time / 2.0)
    name = f"half = coasting_speed({v}, {k1}, {k2}, {mass}, {time} / 2); coasting_speed(half, "
    name += f"{k1}, {k2}, {mass}, {time} / 2)"
    got = coasting_speed(half, k1, k2, mass, time / 2.0)
    about.cause = "Your result changes with time in the wrong way. Coasting twice for half the "
    about.cause += "time must give the same speed as coasting once for the whole time."
    expect_close(got, wanted, call=name, tolerance=1e-10 * v, unit="m/s")


@pytest.mark.exercise("B5.7", asks="If k1 is 0, replace")
def test_coasting_with_one_kind_of_drag_or_none(rng: Random) -> None:
    about.read = COAST
    v, k, mass = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    time = positive_number(rng, 0.2, 2.0)
    tolerance = ROUNDED * v
    for k1, k2, wanted, cause in (
        (
            k,
            0.0,
            v * math.exp(-k * time / mass),
            "The speed is wrong for k2 = 0. It must be v e^(-k1 t / m), where v is the initial "
            "speed.",
        ),
        (
            0.0,
            k,
            v / (1.0 + k * v * time / mass),
            "You cannot divide by k1, which is 0 here. Use the limit t / m in place of (1 - e^-s) "
            "/ k1.",
        ),
        (
            1e-13,
            k,
            v / (1.0 + k * v * time / mass),
            "You lose digits, because 1 - e^-s is nearly 0. Compute it as -math.expm1(-s), where s "
            "is k1 t / m.",
        ),
        (0.0, 0.0, v, "The speed is wrong without drag (k1 = k2 = 0). It must stay the same."),
    ):
        about(
            f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass={mass}, time={time})",
            cause=cause,
        )
        got = coasting_speed(v, k1, k2, mass, time)
        if k2 and not k1:
            blame(
                got, [(v, f"You return the initial speed for k1 = 0, but k2 is {k2}. {QUADRATIC}")]
            )
        expect_close(got, wanted, tolerance=tolerance, unit="m/s")


@pytest.mark.exercise("B5.7", asks="even if one coefficient is 0 or tiny")
def test_coasting_with_little_linear_drag_is_accurate(rng: Random) -> None:
    about.read = COAST
    v, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng)
    about.cause = "You lose digits, because 1 - e^-s is nearly 0. Compute it as -math.expm1(-s), "
    about.cause += "where s is k1 t / m."
    zero = "You treat a small k1 as 0, and use t / m in place of (1 - e^-s) / k1. Use t / m only "
    zero += "if k1 is exactly 0."
    for power in range(1, 14):
        k1 = 10.0**-power
        about.call = f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass=1.0, time=1.0)"
        # 1 / v + k2 / k1 grows as e^s: e^s / v + (k2 / k1) (e^s - 1) is 1 / v afterwards.
        wanted = 1.0 / (math.exp(k1) / v + k2 / k1 * math.expm1(k1))
        got = coasting_speed(v, k1, k2, 1.0, 1.0)
        blame(got, [(v * math.exp(-k1) / (1.0 + k2 * v), zero)])
        expect_close(got, wanted, tolerance=ROUNDED * wanted, unit="m/s")


@pytest.mark.exercise("B5.7", asks="after drag alone has acted on it")
def test_coasting_for_no_time_and_coasting_from_rest(rng: Random) -> None:
    about.read = COAST
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    for speed, time, wanted, cause in (
        (v, 0.0, v, "The speed changed although the time is 0. Return the initial speed."),
        (0.0, 2.0, 0.0, "Drag set a body at rest in motion. Return a speed of 0."),
    ):
        about(
            f"coasting_speed(speed={speed}, k1={k1}, k2={k2}, mass=2.0, time={time})",
            cause=cause,
        )
        got = coasting_speed(speed, k1, k2, 2.0, time)
        expect_close(got, wanted, tolerance=ROUNDED * speed, unit="m/s")


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time")
@pytest.mark.robust
def test_coasting_for_a_very_long_time_ends_at_rest(rng: Random) -> None:
    about.read = COAST
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    about.cause = "You compute e^s with s = k1 t / m, which is too large for a float after a long "
    about.cause += "time. Use e^-s, which becomes 0."
    about.call = f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass=2.0, time=1e9)"
    got = coasting_speed(v, k1, k2, 2.0, 1e9)
    expect_close(got, 0.0, tolerance=ROUNDED * v, unit="m/s")
