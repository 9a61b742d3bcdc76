"""Drag without steps: terminal speed (B5.6), falling and coasting (B5.7)."""

from __future__ import annotations

import math
from decimal import Decimal
from random import Random

import pytest

from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed
from draw import positive_number
from expect import about, blame, expect_close, expect_exactly, named, scoped

TERMINAL = "the docstring of terminal_speed"
FALL = "the docstring of quadratic_fall"
COAST = "the docstring of coasting_speed"
# Formulas of a few operations each, of which none loses digits: relative.
ROUNDED = 1e-12


# B5.6 Terminal speed


@pytest.mark.exercise("B5.6")
def test_at_the_terminal_speed_the_drag_is_the_weight(rng: Random) -> None:
    about(
        cause="At the terminal speed v the drag equals the weight. Solve the equation k1 "
        "v + k2 v^2 = weight for v.",
        read=TERMINAL,
    )
    about.call = "terminal_speed(weight=19.62, k1=0.3, k2=0.05), in m/s"
    got = terminal_speed(2 * 9.81, 0.3, 0.05)
    root, without_4 = math.sqrt(0.09 + 0.2 * 19.62), math.sqrt(0.09 + 0.05 * 19.62)
    slips = {
        "This is the negative solution of the equation k1 v + k2 v^2 = weight. Return the "
        "positive one, because a speed is positive.": (-0.3 - root) / 0.1,
        ("You divide by k2 at the end. The solution of a quadratic equation is divided by 2 k2."): (
            -0.3 + root
        )
        / 0.05,
        "A factor of 4 is missing under the square root. It must be sqrt(k1^2 + 4 k2 W), where "
        "W is the weight.": (-0.3 + without_4) / 0.1,
        "A factor of 4 is missing under the square root. The result is 2 W / (k1 + sqrt(k1^2 + "
        "4 k2 W)), where W is the weight.": 39.24 / (0.3 + without_4),
        "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
        "square of the speed.": 39.24 / (0.05 + math.sqrt(0.0025 + 1.2 * 19.62)),
        "This is sqrt(weight / k2), the terminal speed without the linear drag. Include k1 as "
        "well.": math.sqrt(19.62 / 0.05),
        "This is weight / k1, the terminal speed without the quadratic drag. Include k2 as "
        "well.": 19.62 / 0.3,
    }
    blame(got, slips)
    # The reference value has seven decimals.
    expect_close(got, 17.0349694, tolerance=1e-7)
    for weight, k1, k2 in (
        *(
            (positive_number(rng, 5.0, 900.0), positive_number(rng), positive_number(rng))
            for _ in range(3)
        ),
        (10.0, 0.3, 0.3),
        (10.0, 1e-3, 1e-6),
        (1e9, 1e-3, 1e-13),
        (1e-9, 1e-3, 1e3),
    ):
        about.cause = "At the terminal speed v the drag k1 v + k2 v^2 equals the weight. Solve "
        about.cause += "this equation for v."
        about.call = f"v = terminal_speed(weight={weight:g}, k1={k1}, k2={k2}); k1 v + k2 v^2, the "
        about.call += "drag in N"
        v = terminal_speed(weight, k1, k2)
        drag = k1 * v + k2 * v * v
        tolerance = ROUNDED * weight
        expect_close(drag, weight, tolerance=tolerance)
        about.call = f"terminal_speed(weight={weight:g}, k1={k1}, k2={k2}) > 0"
        about.cause = "The equation k1 v + k2 v^2 = weight has two solutions. Return the positive "
        about.cause += "one, because a speed is positive."
        expect_exactly(v > 0.0, True)


@pytest.mark.exercise("B5.6")
def test_one_kind_of_drag_is_enough_for_a_terminal_speed(rng: Random) -> None:
    about.read = TERMINAL
    weight, k = positive_number(rng, 5.0, 900.0), positive_number(rng)
    about.cause = "With k2 = 0 the terminal speed is weight / k1, so don't divide by k2. Use the "
    about.cause += "form 2 W / (k1 + sqrt(k1^2 + 4 k2 W)), where W is the weight."
    about.call = f"terminal_speed(weight={weight}, k1={k}, k2=0.0), in m/s"
    got = terminal_speed(weight, k, 0.0)
    expect_close(got, weight / k, tolerance=ROUNDED * got)
    about(
        f"terminal_speed(weight={weight}, k1=0.0, k2={k}), in m/s",
        cause="With k1 = 0 there is only quadratic drag, so the terminal speed is "
        "sqrt(weight / k2).",
    )
    got = terminal_speed(weight, 0.0, k)
    wanted = math.sqrt(weight / k)
    expect_close(got, wanted, tolerance=ROUNDED * wanted)


@pytest.mark.exercise("B5.6")
def test_a_little_quadratic_drag_changes_the_terminal_speed_a_little(rng: Random) -> None:
    about.read = TERMINAL
    weight, k1 = positive_number(rng, 5.0, 90.0), positive_number(rng, 2.0)
    about.cause = "Your result is slightly inaccurate, perhaps because you subtract k1 from a "
    about.cause += "root that is nearly equal to it. Use 2 W / (k1 + sqrt(k1^2 + 4 k2 W)) "
    about.cause += "instead, where W is the weight."
    for k2 in (1e-6, 1e-10, 1e-14):
        about.call = f"terminal_speed(weight={weight}, k1={k1}, k2={k2}), in m/s"
        got = terminal_speed(weight, k1, k2)
        u = weight / k1
        # The series in e = k2 W / k1^2: u (1 - e + 2 e^2 - 5 e^3); the next term is below 1e-16.
        e = k2 * u / k1
        wanted = u * (1.0 - e + 2.0 * e * e - 5.0 * e**3)
        expect_close(got, wanted, tolerance=ROUNDED * u)


# B5.7 Falling and coasting without steps


@pytest.mark.exercise("B5.7")
def test_a_fall_with_quadratic_drag(rng: Random) -> None:
    about.read = FALL
    about.cause = "The speed must be u tanh(g t / u) and the distance (u^2 / g) ln cosh(g t / u). "
    about.cause += "Here u is the terminal speed, g the gravity and t the time."
    about.call = "quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=3.0); (speed in m/s, "
    about.call += "distance in m)"
    got = quadratic_fall(2.0, 9.81, 0.05, 3.0)
    wanted = (17.878238350449884, 33.699945475035044)  # worked out with 40 digits
    v, x = wanted
    u, light = math.sqrt(2.0 * 9.81 / 0.05), math.sqrt(9.81 / 0.05)
    angle = 9.81 * 3.0 / light
    slips = {
        "You return the two results in the wrong order. Return the speed first and the "
        "distance second.": (x, v),
        "Your distance is u t, as if the body fell at the terminal speed u from the start. It "
        "starts at rest, so use (u^2 / g) ln cosh(g t / u) for the distance.": (v, u * 3.0),
        "Your distance is g t^2 / 2, as in a free fall without drag. Use (u^2 / g) ln cosh(g t "
        "/ u), where u is the terminal speed.": (
            v,
            9.81 * 4.5,
        ),
        "Your speed is g t, as in a free fall without drag. Use u tanh(g t / u), where u is "
        "the terminal speed.": (9.81 * 3.0, x),
        "Your speed is g t, limited to the terminal speed u. Drag slows the body down from the "
        "start, so use u tanh(g t / u).": (min(9.81 * 3.0, u), x),
        "You computed the speed with math.tan. Use math.tanh, the hyperbolic tangent.": (
            u * math.tan(9.81 * 3.0 / u),
            x,
        ),
        "You computed the distance with math.log10. Use math.log, which is the natural "
        "logarithm.": (
            v,
            x / math.log(10.0),
        ),
        "Your terminal speed u does not depend on the mass m. The weight is m g, so u must be "
        "sqrt(m g / k2).": (
            light * math.tanh(angle),
            light * light / 9.81 * math.log(math.cosh(angle)),
        ),
    }
    expect_close(got, wanted, cause=named(got, about.cause, slips))
    for time in (0.5, 1.0, 30.0):
        mass, g, k2 = (
            positive_number(rng, 0.5),
            positive_number(rng, 1.0, 20.0),
            positive_number(rng, 0.01, 0.5),
        )
        about.call = f"quadratic_fall(mass={mass}, gravity={g}, k2={k2}, time={time})"
        speed, distance = quadratic_fall(mass, g, k2, time)
        u = math.sqrt(mass * g / k2)
        e = math.exp(-2.0 * g * time / u)
        wanted_speed = u * (1.0 - e) / (1.0 + e)
        tolerance = ROUNDED * u
        expect_close(speed, wanted_speed, then=", the speed in m/s", tolerance=tolerance)
        # From v dv = (g - k2 v^2 / m) dx: v^2 = u^2 (1 - e^(-2 k2 x / m)).
        total = speed * speed + u * u * math.exp(-2.0 * k2 * distance / mass)
        about.cause = "Your speed v and your distance x don't fit together. They must satisfy v^2 "
        about.cause += "= u^2 (1 - e^(-2 k2 x / m)), where u is the terminal speed and m the mass."
        expect_close(
            total, u * u, then=" = (v, x); v^2 + u^2 e^(-2 k2 x / m)", tolerance=ROUNDED * u * u
        )
        left = distance - u * u / g * (math.log1p(e) + g * time / u - math.log(2.0))
        expect_close(
            left, 0.0, then=", the error of the distance in m", tolerance=ROUNDED * (distance + u)
        )


@pytest.mark.exercise("B5.7")
def test_a_fall_with_hardly_any_drag_is_a_free_fall(rng: Random) -> None:
    about.read = FALL
    g, time = positive_number(rng, 1.0, 20.0), positive_number(rng, 0.5, 3.0)
    about.cause = "Your distance is slightly inaccurate, because x = g t / u is small and cosh x "
    about.cause += "is nearly 1. Compute ln cosh x as math.log1p(2 sinh(x / 2)^2) instead."
    for k2 in (1e-8, 1e-12, 1e-15):
        about.call = f"quadratic_fall(mass=2.0, gravity={g}, k2={k2}, time={time})"
        got = quadratic_fall(2.0, g, k2, time)
        square = g * time * time * k2 / 2.0  # x^2, with x = g t / u
        # The series of tanh and of ln cosh; the next terms are below 1e-13.
        speed = g * time * (1.0 - square / 3.0 + 2.0 * square**2 / 15.0)
        distance = g * time * time / 2.0 * (1.0 - square / 6.0 + 2.0 * square**2 / 45.0)
        expect_close(got[0], speed, then=", the speed in m/s", tolerance=1e-11)
        expect_close(got[1], distance, then=", the distance in m", tolerance=1e-11)


@scoped
def expect_terminal_speed(rng: Random, angles: tuple[float, ...]) -> None:
    """Expect falls with these values of g t / u to end at the terminal speed u."""
    about.read = FALL
    mass, g, k2 = (
        positive_number(rng, 0.5),
        positive_number(rng, 1.0, 20.0),
        positive_number(rng, 0.01, 0.5),
    )
    u = math.sqrt(mass * g / k2)
    for time in (round(angle * u / g, 3) for angle in angles):
        about.call = f"quadratic_fall(mass={mass}, gravity={g}, k2={k2}, time={time})"
        speed, distance = quadratic_fall(mass, g, k2, time)
        tolerance = ROUNDED * u
        expect_close(speed, u, then=", the speed in m/s", tolerance=tolerance)
        wanted = u * time - u * u / g * math.log(2.0)
        tolerance = ROUNDED * wanted
        expect_close(distance, wanted, then=", the distance in m", tolerance=tolerance)


@pytest.mark.exercise("B5.7")
def test_a_long_fall_goes_at_the_terminal_speed(rng: Random) -> None:
    about.cause = "After a long time t the body falls at the terminal speed u. The distance is "
    about.cause += "then u t - (u^2 / g) ln 2, where g is the gravity."
    expect_terminal_speed(rng, (60.0, 600.0))  # cosh of 711 is too large for a float


@pytest.mark.exercise("B5.7")
@pytest.mark.robust
def test_a_fall_without_an_end_fits_in_a_float(rng: Random) -> None:
    about.cause = "For a large x = g t / u, cosh(x) is too large for a float. Use x - ln 2 for ln "
    about.cause += "cosh x there."
    expect_terminal_speed(rng, (800.0, 1e6))


@pytest.mark.exercise("B5.7")
def test_a_fall_of_any_length_keeps_its_digits() -> None:
    # 2 kg, g = 8 and k2 = 1/4: the terminal speed u is 8 m/s, and g t / u is the time.
    about.read = FALL
    about.cause = "Your distance is slightly inaccurate here, perhaps because you switch between "
    about.cause += "two formulas for ln cosh x near this time. Switch where both formulas are "
    about.cause += "accurate."
    for text in ("0.001", "0.01", "0.05", "0.2", "1", "5", "12", "16", "20", "39", "41"):
        about.call = f"quadratic_fall(mass=2.0, gravity=8.0, k2=0.25, time={text})"
        x = Decimal(text)
        cosh, sinh = (x.exp() + (-x).exp()) / 2, (x.exp() - (-x).exp()) / 2
        wanted = (float(8 * sinh / cosh), float(8 * cosh.ln()))
        speed, distance = quadratic_fall(2.0, 8.0, 0.25, float(text))
        for name, got, exact in (("speed", speed, wanted[0]), ("distance", distance, wanted[1])):
            tolerance = ROUNDED * exact
            expect_close(got, exact, then=f", the {name}", tolerance=tolerance)


@pytest.mark.exercise("B5.7")
def test_a_fall_begins_at_rest() -> None:
    about.read = FALL
    about.cause = "A time of 0 is valid. At the start of the fall, the speed and the distance are "
    about.cause += "both 0."
    about.call = "quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=0.0); (speed in m/s, "
    about.call += "distance in m)"
    got = quadratic_fall(2.0, 9.81, 0.05, 0.0)
    expect_close(got, (0.0, 0.0))
    about.cause = "After a very short time t there is almost no drag yet. The speed is then g t "
    about.cause += "and the distance g t^2 / 2, where g is the gravity."
    about.call = "quadratic_fall(mass=2.0, gravity=10.0, k2=0.05, time=1e-6)"
    got = quadratic_fall(2.0, 10.0, 0.05, 1e-6)
    # Drag changes both by one part in 1e12.
    expect_close(got[0], 1e-5, then=", the speed in m/s", tolerance=1e-16)
    expect_close(got[1], 5e-12, then=", the distance in m", tolerance=1e-22)


@pytest.mark.exercise("B5.7")
def test_coasting_with_both_kinds_of_drag(rng: Random) -> None:
    about.read = COAST
    about.cause = "Both kinds of drag act at the same time, so use the formula v e^-s / (1 + k2 v "
    about.cause += "(1 - e^-s) / k1), with the speed v at the start and s = k1 t / m."
    for _ in range(3):
        v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
        mass, time = positive_number(rng), positive_number(rng, 0.2, 2.0)
        about.call = (
            f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass={mass}, time={time}), in m/s"
        )
        ratio = k2 / k1
        # From 1 / v + k2 / k1, which grows as e^(k1 t / m).
        wanted = 1.0 / ((1.0 / v + ratio) * math.exp(k1 * time / mass) - ratio)
        got = coasting_speed(v, k1, k2, mass, time)
        s = k1 * time / mass
        slips = {
            "This is v e^-s with s = k1 t / m, which leaves out the quadratic drag. Include k2 "
            "as well.": v * math.exp(-s),
            "This is the speed if the drag with k1 acts first and the drag with k2 acts after "
            "it. Both act at the same time, so use the single formula that contains both.": (
                v * math.exp(-s) / (1.0 + k2 * v * time / mass)
            ),
            "The mass is missing from the exponent s. It must be s = k1 t / m, where m is the "
            "mass.": (v * math.exp(-s * mass) / (1.0 - ratio * v * math.expm1(-s * mass))),
            "A division by k1 is missing from the denominator. It must be 1 + k2 v (1 - e^-s) "
            "/ k1, where v is the speed at the start.": (
                v * math.exp(-s) / (1.0 - k2 * v * math.expm1(-s))
            ),
        }
        why = named(got, about.cause, slips)
        # The difference in the denominator loses a digit or two.
        expect_close(got, wanted, cause=why, tolerance=1e-10 * v)
    half = coasting_speed(v, k1, k2, mass, time / 2.0)
    name = f"half = coasting_speed({v}, {k1}, {k2}, {mass}, {time} / 2); coasting_speed(half, "
    name += f"{k1}, {k2}, {mass}, {time} / 2)"
    got = coasting_speed(half, k1, k2, mass, time / 2.0)
    about.cause = "Coasting twice for half the time must give the same speed as coasting once for "
    about.cause += "the whole time. Check how your result depends on the time."
    expect_close(got, wanted, call=name, tolerance=1e-10 * v)


@pytest.mark.exercise("B5.7")
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
            "With k2 = 0 there is only linear drag. The speed is then v e^(-k1 t / m), where v "
            "is the speed at the start.",
        ),
        (
            0.0,
            k,
            v / (1.0 + k * v * time / mass),
            "With k1 = 0 there is only quadratic drag. The speed is then v / (1 + k2 v t / m), "
            "where v is the speed at the start, so don't divide by k1.",
        ),
        (
            1e-13,
            k,
            v / (1.0 + k * v * time / mass),
            "Here k1 is nearly 0, so 1 - e^-s with s = k1 t / m is inaccurate. Compute it as "
            "-math.expm1(-s) instead.",
        ),
        (0.0, 0.0, v, "Both k1 and k2 are 0, so there is no drag. The speed must stay the same."),
    ):
        about(
            f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass={mass}, time={time}), in m/s",
            cause=cause,
        )
        got = coasting_speed(v, k1, k2, mass, time)
        expect_close(got, wanted, tolerance=tolerance)


@pytest.mark.exercise("B5.7")
def test_coasting_with_little_linear_drag_keeps_its_digits(rng: Random) -> None:
    about.read = COAST
    v, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng)
    about.cause = "Your result is slightly inaccurate, because e^-s is nearly 1 for a small s = "
    about.cause += "k1 t / m. Compute 1 - e^-s as -math.expm1(-s) instead."
    for power in range(1, 14):
        k1 = 10.0**-power
        about.call = f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass=1.0, time=1.0), in m/s"
        # 1 / v + k2 / k1 grows as e^s: e^s / v + (k2 / k1) (e^s - 1) is 1 / v afterwards.
        wanted = 1.0 / (math.exp(k1) / v + k2 / k1 * math.expm1(k1))
        got = coasting_speed(v, k1, k2, 1.0, 1.0)
        expect_close(got, wanted, tolerance=ROUNDED * wanted)


@pytest.mark.exercise("B5.7")
def test_coasting_begins_with_its_speed_and_rest_stays_rest(rng: Random) -> None:
    about.read = COAST
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    for speed, time, wanted, cause in (
        (v, 0.0, v, "No time has passed yet, so return the initial speed."),
        (
            0.0,
            2.0,
            0.0,
            "The particle is at rest, and drag cannot set it in motion, so return 0.",
        ),
    ):
        about(
            f"coasting_speed(speed={speed}, k1={k1}, k2={k2}, mass=2.0, time={time}), in m/s",
            cause=cause,
        )
        got = coasting_speed(speed, k1, k2, 2.0, time)
        expect_close(got, wanted, tolerance=ROUNDED * speed)


@pytest.mark.exercise("B5.7")
@pytest.mark.robust
def test_coasting_for_ever_ends_in_rest(rng: Random) -> None:
    about.read = COAST
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    about.cause = "After a very long time the speed must be 0. Use e^-s with s = k1 t / m, which "
    about.cause += "goes to 0, because e^s is too large for a float."
    about.call = f"coasting_speed(speed={v}, k1={k1}, k2={k2}, mass=2.0, time=1e9), in m/s"
    got = coasting_speed(v, k1, k2, 2.0, 1e9)
    expect_close(got, 0.0, tolerance=ROUNDED * v)
