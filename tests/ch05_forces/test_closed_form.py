"""Drag without steps: terminal speed (B5.6) and falling (B5.7)."""

from __future__ import annotations

import math
from decimal import Decimal
from random import Random

import pytest

from ch05_forces.closed_form import quadratic_fall, terminal_speed
from draw import positive_number
from expect import about, blame, expect_close, expect_error, expect_that, named, scoped

TERMINAL = "the docstring of terminal_speed"
FALL = "the docstring of quadratic_fall"
# Formulas of a few operations each, of which none loses digits: relative.
ROUNDED = 1e-12


# B5.6 Terminal speed


@pytest.mark.exercise("B5.6", asks="the drag balances the weight")
def test_at_the_terminal_speed_the_drag_equals_the_weight(rng: Random) -> None:
    about.read = TERMINAL
    about.cause = "Your result does not solve the equation k1 v + k2 v^2 = weight. Return its "
    about.cause += "positive solution v."
    about.call = "terminal_speed(weight=19.62, k1=0.3, k2=0.05)"
    try:
        got = terminal_speed(2 * 9.81, 0.3, 0.05)
    except ValueError as error:
        if "math domain" in str(error):
            about.cause = "The number under your square root is negative. It must be k1^2 + 4 k2 "
            about.cause += "W, where W is the weight."
        raise
    root, without_4 = math.sqrt(0.09 + 0.2 * 19.62), math.sqrt(0.09 + 0.05 * 19.62)
    with_2 = math.sqrt(0.09 + 0.1 * 19.62)
    slips = {
        "Your result is the negative solution of the equation k1 v + k2 v^2 = weight. Return the "
        "positive one, because a speed is positive.": (-0.3 - root) / 0.1,
        "Your result is twice the right one, because you divide by k2. Divide by 2 k2.": (
            -0.3 + root
        )
        / 0.05,
        "You use the difference of k1^2 and 4 k2 W under the square root, where W is the weight. "
        "Use their sum instead.": 39.24 / (0.3 + math.sqrt(0.2 * 19.62 - 0.09)),
        "Under your square root, k2 W has the factor 2. It must be sqrt(k1^2 + 4 k2 W), where W is "
        "the weight.": (-0.3 + with_2) / 0.1,
        "Under your square root, k2 W has the factor 2. The result is 2 W / (k1 + sqrt(k1^2 + 4 k2 "
        "W)), where W is the weight.": 39.24 / (0.3 + with_2),
        "A factor of 4 is missing under the square root. It must be sqrt(k1^2 + 4 k2 W), where "
        "W is the weight.": (-0.3 + without_4) / 0.1,
        "A factor of 4 is missing under the square root. The result is 2 W / (k1 + sqrt(k1^2 + "
        "4 k2 W)), where W is the weight.": 39.24 / (0.3 + without_4),
        "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
        "square of the speed.": 39.24 / (0.05 + math.sqrt(0.0025 + 1.2 * 19.62)),
        "Your result is sqrt(weight / k2), without k1. Include the linear drag too.": math.sqrt(
            392.4
        ),
        "Your result is half of the right one. The numerator of W / (k1 + sqrt(k1^2 + 4 k2 W)) "
        "must be 2 W, where W is the weight.": 19.62 / (0.3 + root),
        "You divide by 2 and then multiply by k2. Put the product in parentheses, as in / (2 * "
        "k2).": ((root - 0.3) / 2.0 * 0.05),
        "You divide only the root by 2 k2. Put -k1 and the root in parentheses, and divide their "
        "sum by 2 k2.": root / 0.1 - 0.3,
        "You add the terminal speeds of the two kinds of drag. Both kinds act at the same speed v, "
        "so solve k1 v + k2 v^2 = weight.": 19.62 / 0.3 + math.sqrt(392.4),
        "Your result is weight / k1, without k2. Include the quadratic drag too.": 19.62 / 0.3,
    }
    blame(got, slips)
    # The reference value has seven decimals.
    expect_close(got, 17.0349694, tolerance=1e-7, unit="m/s")
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
        about.cause = "The drag at your terminal speed v is not equal to the weight. Solve the "
        about.cause += "equation k1 v + k2 v^2 = weight for v."
        about.call = f"v = terminal_speed(weight={weight:g}, k1={k1}, k2={k2}); the drag at this "
        about.call += "speed, k1 v + k2 v^2"
        v = terminal_speed(weight, k1, k2)
        drag = k1 * v + k2 * v * v
        tolerance = ROUNDED * weight
        blame(v, [(weight / k1, "You treat a small k2 as 0. Include the quadratic drag as well.")])
        expect_close(drag, weight, tolerance=tolerance, unit="N")
        about.call = about.call.partition("; ")[0]
        about.cause = "Your result is the negative solution of the equation k1 v + k2 v^2 = "
        about.cause += "weight. Return the positive one."
        expect_that(v > 0.0, "a negative speed", "a positive speed")


@pytest.mark.exercise("B5.6", asks="for any combination of the two kinds of drag")
def test_one_kind_of_drag_is_enough_for_a_terminal_speed(rng: Random) -> None:
    about.read = TERMINAL
    weight, k = positive_number(rng, 5.0, 900.0), positive_number(rng)
    about.cause = "You divide by k2, which is 0 here. Use the form 2 W / (k1 + sqrt(k1^2 + 4 k2 "
    about.cause += "W)), where W is the weight."
    about.call = f"terminal_speed(weight={weight}, k1={k}, k2=0.0)"
    try:
        got = terminal_speed(weight, k, 0.0)
    except ValueError:
        about.cause = "You refuse k2 = 0, but one kind of drag is enough. Raise ValueError only if "
        about.cause += "both k1 and k2 are 0."
        raise
    about.cause = "The result is wrong for k2 = 0. In this case, it must be weight / k1."
    expect_close(got, weight / k, tolerance=ROUNDED * weight / k, unit="m/s")
    about(
        f"terminal_speed(weight={weight}, k1=0.0, k2={k})",
        cause="The result is wrong for k1 = 0. In this case, it must be sqrt(weight / k2).",
    )
    got = terminal_speed(weight, 0.0, k)
    wanted = math.sqrt(weight / k)
    expect_close(got, wanted, tolerance=ROUNDED * wanted, unit="m/s")


@pytest.mark.exercise("B5.6", asks="even if one coefficient is 0 or tiny")
def test_a_little_quadratic_drag_changes_the_terminal_speed_a_little(rng: Random) -> None:
    about.read = TERMINAL
    weight, k1 = positive_number(rng, 5.0, 90.0), positive_number(rng, 2.0)
    about.cause = "You lose digits, because you subtract k1 from a root that is nearly equal to "
    about.cause += "it. Use 2 W / (k1 + sqrt(k1^2 + 4 k2 W)) instead, where W is the weight."
    for k2 in (1e-6, 1e-10, 1e-14):
        about.call = f"terminal_speed(weight={weight}, k1={k1}, k2={k2})"
        got = terminal_speed(weight, k1, k2)
        u = weight / k1
        # The series in e = k2 W / k1^2: u (1 - e + 2 e^2 - 5 e^3); the next term is below 1e-16.
        e = k2 * u / k1
        wanted = u * (1.0 - e + 2.0 * e * e - 5.0 * e**3)
        expect_close(got, wanted, tolerance=ROUNDED * u, unit="m/s")


@pytest.mark.exercise("B5.6", asks="if both coefficients are 0")
@pytest.mark.robust
def test_without_drag_there_is_no_terminal_speed(rng: Random) -> None:
    about.read = TERMINAL
    weight = positive_number(rng, 5.0, 900.0)
    about.cause = "Both k1 and k2 are 0. Without drag the speed grows without limit, so there is "
    about.cause += "no terminal speed to return. Raise ValueError."
    expect_error(
        lambda: terminal_speed(weight, 0.0, 0.0),
        ValueError,
        call=f"terminal_speed(weight={weight}, k1=0.0, k2=0.0)",
        allowed=lambda: terminal_speed(weight, 0.3, 0.05),
    )


# B5.7 Falling without steps


@pytest.mark.exercise("B5.7", asks="They are u tanh x and (u^2 / g) ln cosh x")
def test_a_fall_with_quadratic_drag(rng: Random) -> None:
    about.read = FALL
    about.cause = "The result is wrong. The speed must be u tanh(g t / u) and the distance (u^2 / "
    about.cause += "g) ln cosh(g t / u), where u is the terminal speed."
    about.call = "quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=3.0); (speed in m/s, "
    about.call += "distance in m)"
    got = quadratic_fall(2.0, 9.81, 0.05, 3.0)
    wanted = (17.878238350449884, 33.699945475035044)  # worked out with 40 digits
    v, x = wanted
    u, light = math.sqrt(2.0 * 9.81 / 0.05), math.sqrt(9.81 / 0.05)
    massive = math.sqrt(2.0 / 0.05)
    angle, linear = 9.81 * 3.0 / light, 2.0 * 9.81 / 0.05
    slips = {
        "You return the two results in the wrong order. Return the speed first and the "
        "distance second.": (x, v),
        "You return only the speed. Return a tuple of the speed and the distance.": v,
        "Your speed is negative. Return a positive speed, because the body falls.": (-v, x),
        "Your distance is u^2 ln cosh x. Divide it by g.": (v, 9.81 * x),
        "You multiply u^2 ln cosh x by g. Divide it by g.": (v, 9.81 * 9.81 * x),
        "You pass the mass to terminal_speed. It takes the weight, m g.": (
            massive * math.tanh(9.81 * 3.0 / massive),
            massive * massive / 9.81 * math.log(math.cosh(9.81 * 3.0 / massive)),
        ),
        "Your distance is u ln cosh x. Multiply it by u / g.": (v, x * 9.81 / u),
        "Your distance is (u / g) ln cosh x. It must be (u^2 / g) ln cosh x.": (v, x / u),
        "Your x is t / u. Multiply it by g, which gives x = g t / u.": (
            u * math.tanh(3.0 / u),
            u * u / 9.81 * math.log(math.cosh(3.0 / u)),
        ),
        "You use k2 as the linear coefficient when you compute u. The second argument of "
        "terminal_speed is k1, which is 0 here, and the third is k2.": (
            linear * math.tanh(9.81 * 3.0 / linear),
            linear * linear / 9.81 * math.log(math.cosh(9.81 * 3.0 / linear)),
        ),
        "Your distance is u t, as if the body fell at the terminal speed u from the start. It "
        "starts at rest, so use (u^2 / g) ln cosh(g t / u) for the distance.": (v, u * 3.0),
        "Your distance is g t^2 / 2, as in a free fall without drag. Use (u^2 / g) ln cosh(g t "
        "/ u), where u is the terminal speed.": (v, 9.81 * 4.5),
        "Your speed is g t, as in a free fall without drag. Use u tanh(g t / u), where u is "
        "the terminal speed.": (9.81 * 3.0, x),
        "Your speed is g t, limited to the terminal speed u. Drag slows the body down from the "
        "start, so use u tanh(g t / u).": (min(9.81 * 3.0, u), x),
        "You compute the speed with math.tan. Use math.tanh, the hyperbolic tangent.": (
            u * math.tan(9.81 * 3.0 / u),
            x,
        ),
        "You compute the distance with math.log10. Use math.log, which is the natural logarithm.": (
            v,
            x / math.log(10.0),
        ),
        "The mass m is missing from your terminal speed u. It must be sqrt(m g / k2).": (
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
        about.call = f"v, x = quadratic_fall(mass={mass}, gravity={g}, k2={k2}, time={time})"
        speed, distance = quadratic_fall(mass, g, k2, time)
        u = math.sqrt(mass * g / k2)
        e = math.exp(-2.0 * g * time / u)
        wanted_speed = u * (1.0 - e) / (1.0 + e)
        tolerance = ROUNDED * u
        expect_close(speed, wanted_speed, then="; v", unit="m/s", tolerance=tolerance)
        # From v dv = (g - k2 v^2 / m) dx: v^2 = u^2 (1 - e^(-2 k2 x / m)).
        total = speed * speed + u * u * math.exp(-2.0 * k2 * distance / mass)
        about.cause = "Your distance is not consistent with your speed. It must be (u^2 / g) ln "
        about.cause += "cosh(g t / u), where u is the terminal speed."
        then = "; v^2 + u^2 e^(-2 k2 x / m)"
        expect_close(total, u * u, then=then, tolerance=ROUNDED * u * u)
        left = distance - u * u / g * (math.log1p(e) + g * time / u - math.log(2.0))
        expect_close(
            left,
            0.0,
            then="; the error of x",
            tolerance=ROUNDED * (distance + u),
            unit="m",
        )


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time")
def test_a_fall_with_hardly_any_drag_is_a_free_fall(rng: Random) -> None:
    about.read = FALL
    g, time = positive_number(rng, 1.0, 20.0), positive_number(rng, 0.5, 3.0)
    about.cause = "The terminal speed u is large here, so x = g t / u is small, and your ln cosh x "
    about.cause += "loses digits. Compute ln cosh x as math.log1p(2 sinh(x / 2)^2)."
    for k2 in (1e-8, 1e-12, 1e-15):
        about.call = "speed, distance = "
        about.call += f"quadratic_fall(mass=2.0, gravity={g}, k2={k2}, time={time})"
        got = quadratic_fall(2.0, g, k2, time)
        square = g * time * time * k2 / 2.0  # x^2, with x = g t / u
        # The series of tanh and of ln cosh; the next terms are below 1e-13.
        speed = g * time * (1.0 - square / 3.0 + 2.0 * square**2 / 15.0)
        distance = g * time * time / 2.0 * (1.0 - square / 6.0 + 2.0 * square**2 / 45.0)
        fast = "The speed is wrong for this small x = g t / u. It must be u tanh x."
        expect_close(got[0], speed, then="; speed", tolerance=1e-11, unit="m/s", cause=fast)
        expect_close(got[1], distance, then="; distance", tolerance=1e-11, unit="m")


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
        about.call = "speed, distance = "
        about.call += f"quadratic_fall(mass={mass}, gravity={g}, k2={k2}, time={time})"
        speed, distance = quadratic_fall(mass, g, k2, time)
        tolerance = ROUNDED * u
        expect_close(speed, u, then="; speed", tolerance=tolerance, unit="m/s")
        wanted = u * time - u * u / g * math.log(2.0)
        tolerance = ROUNDED * wanted
        expect_close(distance, wanted, then="; distance", tolerance=tolerance, unit="m")


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time")
def test_a_long_fall_reaches_the_terminal_speed(rng: Random) -> None:
    about.cause = "The result of a long fall is wrong. The speed must be the terminal speed u, and "
    about.cause += "the distance u t - (u^2 / g) ln 2."
    expect_terminal_speed(rng, (60.0, 600.0))  # cosh of 711 is too large for a float


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time")
@pytest.mark.robust
def test_a_very_long_fall_does_not_overflow(rng: Random) -> None:
    about.cause = "You compute cosh x, which is too large for a float for a large x = g t / u. Use "
    about.cause += "x - ln 2 in place of ln cosh x there."
    expect_terminal_speed(rng, (800.0, 1e6))


@pytest.mark.exercise("B5.7", asks="correct to about 12 digits")
def test_a_fall_of_any_length_is_accurate() -> None:
    # 2 kg, g = 8 and k2 = 1/4: the terminal speed u is 8 m/s, and g t / u is the time.
    about.read = FALL
    about.cause = "Your result loses digits at this time. Use a formula for ln cosh x that is "
    about.cause += "accurate for this x = g t / u."
    early = "You use x - ln 2 in place of ln cosh x, but the two still differ at this time. Switch "
    early += "to x - ln 2 only at a larger x = g t / u, where u is the terminal speed."
    for text in ("0.001", "0.01", "0.05", "0.2", "1", "5", "12", "16", "20", "39", "41"):
        about.call = "speed, distance = "
        about.call += f"quadratic_fall(mass=2.0, gravity=8.0, k2=0.25, time={text})"
        x = Decimal(text)
        cosh, sinh = (x.exp() + (-x).exp()) / 2, (x.exp() - (-x).exp()) / 2
        wanted = (float(8 * sinh / cosh), float(8 * cosh.ln()))
        speed, distance = quadratic_fall(2.0, 8.0, 0.25, float(text))
        for name, got, exact, unit in (
            ("speed", speed, wanted[0], "m/s"),
            ("distance", distance, wanted[1], "m"),
        ):
            tolerance = ROUNDED * exact
            blame(got, [(8.0 * (float(text) - math.log(2.0)), early)])
            expect_close(got, exact, then=f"; {name}", unit=unit, tolerance=tolerance)


@pytest.mark.exercise("B5.7", asks="The time may be 0")
def test_a_fall_begins_at_rest() -> None:
    about.read = FALL
    about.cause = "You reject a time of 0, which is valid. At the start of the fall, the "
    about.cause += "speed and the distance are 0."
    about.call = "quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=0.0); (speed in m/s, "
    about.call += "distance in m)"
    got = quadratic_fall(2.0, 9.81, 0.05, 0.0)
    expect_close(got, (0.0, 0.0))
    about.cause = "The result is wrong after a very short time t. There is almost no drag yet, so "
    about.cause += "the speed is g t and the distance g t^2 / 2."
    about.call = "speed, distance = quadratic_fall(mass=2.0, gravity=10.0, k2=0.05, time=1e-6)"
    got = quadratic_fall(2.0, 10.0, 0.05, 1e-6)
    # Drag changes both by one part in 1e12.
    expect_close(got[0], 1e-5, then="; speed", tolerance=1e-16, unit="m/s")
    expect_close(got[1], 5e-12, then="; distance", tolerance=1e-22, unit="m")
