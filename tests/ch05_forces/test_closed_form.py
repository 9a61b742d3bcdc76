"""Drag without steps: terminal speed (B5.6), falling and coasting (B5.7)."""

from __future__ import annotations

import math
from decimal import Decimal
from random import Random

import pytest

from calls import calls
from ch05_forces.closed_form import coasting_speed, quadratic_fall, terminal_speed
from draw import positive_number
from expect import about, expect_close, expect_error, expect_that

TERMINAL = "the docstring of terminal_speed"
FALL = "the docstring of quadratic_fall"
COAST = "the docstring of coasting_speed"
FALL_LAW = (
    "The speed must be u tanh x and the distance (u^2 / g) ln cosh x, where u is the terminal "
    "speed and x = g t / u."
)
FORM = "Use 2 W / (k1 + sqrt(k1^2 + 4 k2 W)), where W is the weight."
EXPM1 = "You lose digits, because 1 - e^-s is nearly 0. Compute it as -math.expm1(-s)."
# Formulas of a few operations each, of which none loses digits: relative.
ROUNDED = 1e-12


# B5.6 Terminal speed


@pytest.mark.exercise("B5.6", asks="the drag balances the weight", read=TERMINAL)
def test_at_the_terminal_speed_the_drag_equals_the_weight(rng: Random) -> None:
    weight, k1, k2 = 2 * 9.81, 0.3, 0.05
    with calls(
        "Return the positive solution v of the equation k1 v + k2 v^2 = weight.",
        f"terminal_speed({weight=}, {k1=}, {k2=})",
    ):
        try:
            got = terminal_speed(weight, k1, k2)
        except ValueError as error:
            if "math domain" in str(error):
                about(cause="The number under your square root is negative. Use k1^2 + 4 k2 W.")
            raise
    root = math.sqrt(k1 * k1 + 4.0 * k2 * weight)
    both = 2.0 * weight / (k2 + math.sqrt(k2 * k2 + 4.0 * k1 * weight))
    difference = 2.0 * weight / (k1 + math.sqrt(4.0 * k2 * weight - k1 * k1))
    slips = {
        "Your result is the negative solution of the equation k1 v + k2 v^2 = weight. Return the "
        "positive one, because a speed is positive.": (-k1 - root) / (2.0 * k2),
        "Your result is twice the right one, because you divide by k2. Divide by 2 k2.":
            (root - k1) / k2,
        "You subtract 4 k2 W under the square root. Add it instead.": difference,
        "You swapped k1 and k2. In the drag, k2 belongs to the square of the speed.": both,
        "Your result is sqrt(weight / k2). Include the linear drag too.": math.sqrt(weight / k2),
        "Your result is half of the right one. The numerator of W / (k1 + sqrt(k1^2 + 4 k2 W)) "
        "must be 2 W, where W is the weight.": weight / (k1 + root),
        "You divide by 2 and then multiply by k2. Put the product in parentheses, as in / (2 * "
        "k2).": (root - k1) / 2.0 * k2,
        "You divide only the root by 2 k2. Put -k1 and the root in parentheses, and divide their "
        "sum by 2 k2.": root / (2.0 * k2) - k1,
        "You add the terminal speeds of the two kinds of drag. Both kinds act at the same speed v, "
        "so solve k1 v + k2 v^2 = weight.": weight / k1 + math.sqrt(weight / k2),
        "Your result is weight / k1. Include the quadratic drag too.": weight / k1,
    }  # fmt: skip
    for slip, factor in (
        ("Under your square root, k2 W has the factor 2.", 2.0),
        ("A factor of 4 is missing under the square root.", 1.0),
    ):
        r = math.sqrt(k1 * k1 + factor * k2 * weight)
        slips |= {
            f"{slip} It must be sqrt(k1^2 + 4 k2 W), where W is the weight.": (r - k1) / (2.0 * k2),
            f"{slip} The result is 2 W / (k1 + sqrt(k1^2 + 4 k2 W)), where W is the weight.":
                2.0 * weight / (k1 + r),
        }  # fmt: skip
    # The reference value has seven decimals.
    expect_close(got, 17.0349694, slips, tolerance=1e-7, unit="m/s")
    drawn = [
        (positive_number(rng, 5.0, 900.0), positive_number(rng), positive_number(rng))
        for _ in range(3)
    ]
    for weight, k1, k2 in (
        *drawn, (10.0, 0.3, 0.3), (10.0, 1e-3, 1e-6), (1e9, 1e-3, 1e-13), (1e-9, 1e-3, 1e3)
    ):  # fmt: skip
        with calls("The drag at your speed v is not the weight. Solve k1 v + k2 v^2 = weight."):
            v = terminal_speed(weight=weight, k1=k1, k2=k2)
        if abs(v - weight / k1) <= 1e-9 * v:
            about(cause="You treat a small k2 as 0. Include the quadratic drag as well.")
        then = "; the drag at this speed v, k1 v + k2 v^2"
        tolerance = ROUNDED * weight
        expect_close(k1 * v + k2 * v * v, weight, then=then, tolerance=tolerance, unit="N")
        cause = "Your result is the negative solution of the equation. Return the positive one."
        expect_that(v > 0.0, "a negative speed", "a positive speed", cause=cause)


@pytest.mark.exercise("B5.6", asks="for any combination of the two kinds of drag", read=TERMINAL)
def test_one_kind_of_drag_is_enough_for_a_terminal_speed(rng: Random) -> None:
    weight, k = positive_number(rng, 5.0, 900.0), positive_number(rng)
    with calls(
        f"You divide by k2, which is 0 here. {FORM}",
        f"terminal_speed({weight=}, k1={k}, k2=0.0)",
    ):
        try:
            got = terminal_speed(weight, k, 0.0)
        except ValueError:
            about(cause="You refuse k2 = 0. Raise ValueError only if both k1 and k2 are 0.")
            raise
    cause = "The result is wrong for k2 = 0. In this case, it must be weight / k1."
    expect_close(got, weight / k, tolerance=ROUNDED * weight / k, unit="m/s", cause=cause)
    with calls("The result is wrong for k1 = 0. In this case, it must be sqrt(weight / k2)."):
        got = terminal_speed(weight=weight, k1=0.0, k2=k)
    wanted = math.sqrt(weight / k)
    expect_close(got, wanted, tolerance=ROUNDED * wanted, unit="m/s")


@pytest.mark.exercise("B5.6", asks="even if one coefficient is 0 or tiny", read=TERMINAL)
def test_a_little_quadratic_drag_changes_the_terminal_speed_a_little(rng: Random) -> None:
    weight, k1 = positive_number(rng, 5.0, 90.0), positive_number(rng, 2.0)
    for k2 in (1e-6, 1e-10, 1e-14):
        with calls(
            "You lose digits, because you subtract k1 from a root that is nearly equal to it. "
            f"{FORM}"
        ):
            got = terminal_speed(weight=weight, k1=k1, k2=k2)
        u = weight / k1
        # The series in e = k2 W / k1^2: u (1 - e + 2 e^2 - 5 e^3); the next term is below 1e-16.
        e = k2 * u / k1
        wanted = u * (1.0 - e + 2.0 * e * e - 5.0 * e**3)
        expect_close(got, wanted, tolerance=ROUNDED * u, unit="m/s")


@pytest.mark.exercise("B5.6", asks="if both coefficients are 0", read=TERMINAL)
@pytest.mark.robust
def test_without_drag_there_is_no_terminal_speed(rng: Random) -> None:
    weight = positive_number(rng, 5.0, 900.0)
    expect_error(
        lambda: terminal_speed(weight, 0.0, 0.0),
        ValueError,
        call=f"terminal_speed({weight=}, k1=0.0, k2=0.0)",
        cause="Without drag the speed grows without limit. Raise ValueError.",
        allowed=lambda: terminal_speed(weight, 0.3, 0.05),
    )


# B5.7 Falling without steps


def draw_fall(rng: Random) -> tuple[float, float, float, float]:
    """Return the mass, gravity and k2 of a fall, and its terminal speed."""
    mass, g = positive_number(rng, 0.5), positive_number(rng, 1.0, 20.0)
    k2 = positive_number(rng, 0.01, 0.5)
    return mass, g, k2, math.sqrt(mass * g / k2)


@pytest.mark.exercise("B5.7", asks="They are u tanh x and (u^2 / g) ln cosh x", read=FALL)
def test_a_fall_with_quadratic_drag(rng: Random) -> None:
    with calls(FALL_LAW):
        got = quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=3.0)
    v, s = wanted = 17.878238350449884, 33.699945475035044  # worked out with 40 digits
    g, u, free = 9.81, math.sqrt(2.0 * 9.81 / 0.05), 9.81 * 3.0

    def fall(u: float, x: float) -> tuple[float, float]:
        return u * math.tanh(x), u * u / g * math.log(math.cosh(x))

    massive, linear, light = math.sqrt(2.0 / 0.05), 2.0 * g / 0.05, math.sqrt(g / 0.05)
    slips = {
        "You return the results in the wrong order. The speed comes first.": (s, v),
        "You return only the speed. Return a tuple of the speed and the distance.": v,
        "Your speed is negative. Return a positive speed, because the body falls.": (-v, s),
        "Your distance is u^2 ln cosh x. Divide it by g.": (v, g * s),
        "You multiply u^2 ln cosh x by g. Divide it by g.": (v, g * g * s),
        "You pass the mass to terminal_speed. It takes the weight, m g.":
            fall(massive, free / massive),
        "Your distance is u ln cosh x. Multiply it by u / g.": (v, s * g / u),
        "Your distance is (u / g) ln cosh x. Multiply it by u.": (v, s / u),
        "Your x is t / u. Multiply it by g, which gives x = g t / u.": fall(u, 3.0 / u),
        "You use k2 as the linear coefficient when you compute u. The second argument of "
        "terminal_speed is k1, which is 0 here, and the third is k2.": fall(linear, free / linear),
        "Your distance is u t, as if the body fell at the terminal speed u from the start.":
            (v, u * 3.0),
        "Your distance is g t^2 / 2, as in a free fall without drag.": (v, g * 4.5),
        "Your speed is g t, as in a free fall without drag.": (free, s),
        "Your speed is g t, limited to the terminal speed u.": (min(free, u), s),
        "You compute the speed with math.tan. Use math.tanh, the hyperbolic tangent.":
            (u * math.tan(free / u), s),
        "You compute the distance with math.log10. Use math.log, which is the natural logarithm.":
            (v, s / math.log(10.0)),
        "The mass m is missing from your terminal speed u. It must be sqrt(m g / k2).":
            fall(light, free / light),
    }  # fmt: skip
    expect_close(got, wanted, slips, then="; (speed in m/s, distance in m)")
    for time in (0.5, 1.0, 30.0):
        mass, g, k2, u = draw_fall(rng)
        with calls(FALL_LAW):
            v, x = quadratic_fall(mass=mass, gravity=g, k2=k2, time=time)
        e = math.exp(-2.0 * g * time / u)
        right = u * (1.0 - e) / (1.0 + e)
        expect_close(v, right, then="; v", unit="m/s", tolerance=ROUNDED * u)
        cause = "The distance must be (u^2 / g) ln cosh x, where u is the terminal speed."
        # From v dv = (g - k2 v^2 / m) dx: v^2 = u^2 (1 - e^(-2 k2 x / m)).
        total, then = v * v + u * u * math.exp(-2.0 * k2 * x / mass), "; v^2 + u^2 e^(-2 k2 x / m)"
        expect_close(total, u * u, then=then, tolerance=ROUNDED * u * u, cause=cause)
        left = x - u * u / g * (math.log1p(e) + g * time / u - math.log(2.0))
        tolerance = ROUNDED * (x + u)
        expect_close(left, 0.0, then="; the error of x", tolerance=tolerance, unit="m", cause=cause)


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time", read=FALL)
def test_a_fall_with_hardly_any_drag_is_a_free_fall(rng: Random) -> None:
    g, time = positive_number(rng, 1.0, 20.0), positive_number(rng, 0.5, 3.0)
    for k2 in (1e-8, 1e-12, 1e-15):
        with calls("Your ln cosh x loses digits. Compute it as math.log1p(2 sinh(x / 2)^2)."):
            speed, distance = quadratic_fall(mass=2.0, gravity=g, k2=k2, time=time)
        square = g * time * time * k2 / 2.0  # x^2, with x = g t / u
        # The series of tanh and of ln cosh; the next terms are below 1e-13.
        fast = g * time * (1.0 - square / 3.0 + 2.0 * square**2 / 15.0)
        far = g * time * time / 2.0 * (1.0 - square / 6.0 + 2.0 * square**2 / 45.0)
        cause = "The speed is wrong for this small x = g t / u. It must be u tanh x."
        expect_close(speed, fast, then="; speed", tolerance=1e-11, unit="m/s", cause=cause)
        expect_close(distance, far, then="; distance", tolerance=1e-11, unit="m")


def expect_terminal_speed(rng: Random, angles: tuple[float, ...], cause: str) -> None:
    """Expect falls with these values of g t / u to end at the terminal speed u."""
    mass, g, k2, u = draw_fall(rng)
    for time in (round(angle * u / g, 3) for angle in angles):
        with calls(cause):
            speed, distance = quadratic_fall(mass=mass, gravity=g, k2=k2, time=time)
        expect_close(speed, u, then="; speed", tolerance=ROUNDED * u, unit="m/s")
        far = u * time - u * u / g * math.log(2.0)
        expect_close(distance, far, then="; distance", tolerance=ROUNDED * far, unit="m")


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time", read=FALL)
def test_a_long_fall_reaches_the_terminal_speed(rng: Random) -> None:
    cause = "After a long time, the speed must be u, and the distance u t - (u^2 / g) ln 2."
    expect_terminal_speed(rng, (60.0, 600.0), cause)  # cosh of 711 is too large for a float


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time", read=FALL)
@pytest.mark.robust
def test_a_very_long_fall_does_not_overflow(rng: Random) -> None:
    cause = "cosh x is too large for a float here. Use x - ln 2 in place of ln cosh x."
    expect_terminal_speed(rng, (800.0, 1e6), cause)


@pytest.mark.exercise("B5.7", asks="correct to about 12 digits", read=FALL)
def test_a_fall_of_any_length_is_accurate() -> None:
    # 2 kg, g = 8 and k2 = 1/4: the terminal speed u is 8 m/s, and g t / u is the time.
    early = "Your x - ln 2 still differs from ln cosh x here. Use it only for a larger x = g t / u."
    for text in ("0.001", "0.01", "0.05", "0.2", "1", "5", "12", "16", "20", "39", "41"):
        x, time = Decimal(text), float(text)
        with calls("Your result loses digits. Use a formula for ln cosh x that is accurate here."):
            speed, distance = quadratic_fall(mass=2.0, gravity=8.0, k2=0.25, time=time)
        cosh, sinh = (x.exp() + (-x).exp()) / 2, (x.exp() - (-x).exp()) / 2
        fast, far = float(8 * sinh / cosh), float(8 * cosh.ln())
        expect_close(speed, fast, then="; speed", unit="m/s", tolerance=ROUNDED * fast)
        slips = {early: 8.0 * (time - math.log(2.0))}
        expect_close(distance, far, slips, then="; distance", unit="m", tolerance=ROUNDED * far)


@pytest.mark.exercise("B5.7", asks="The time may be 0", read=FALL)
def test_a_fall_begins_at_rest() -> None:
    with calls("You reject a time of 0, but then the speed and the distance are 0."):
        got = quadratic_fall(mass=2.0, gravity=9.81, k2=0.05, time=0.0)
    expect_close(got, (0.0, 0.0), then="; (speed in m/s, distance in m)")
    with calls("After a very short time t, the speed is g t and the distance g t^2 / 2."):
        speed, distance = quadratic_fall(mass=2.0, gravity=10.0, k2=0.05, time=1e-6)
    # Drag changes both by one part in 1e12.
    expect_close(speed, 1e-5, then="; speed", tolerance=1e-16, unit="m/s")
    expect_close(distance, 5e-12, then="; distance", tolerance=1e-22, unit="m")


# B5.7 Coasting without steps


@pytest.mark.exercise("B5.7", asks="v e^-s / (1 + k2 v (1 - e^-s) / k1)", read=COAST)
def test_coasting_with_both_kinds_of_drag(rng: Random) -> None:
    for _ in range(3):
        v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
        mass, time = positive_number(rng), positive_number(rng, 0.2, 2.0)
        with calls("The speed must be v e^-s / (1 + k2 v (1 - e^-s) / k1), with s = k1 t / m."):
            got = coasting_speed(speed=v, k1=k1, k2=k2, mass=mass, time=time)
        ratio, s = k2 / k1, k1 * time / mass
        rate = ratio * v

        def coasted(s: float, rate: float, v: float = v) -> float:
            return v * math.exp(-s) / (1.0 - rate * math.expm1(-s))

        slips = {
            "You use e^s instead of e^-s.": coasted(-s, rate),
            "You use e^s instead of e^-s in the numerator.": math.exp(2.0 * s) * coasted(s, rate),
            "You divide only by the 1. Put the whole denominator 1 + k2 v (1 - e^-s) / k1 in "
            "parentheses.": v * math.exp(-s) - rate * math.expm1(-s),
            "The initial speed v is missing from the denominator.": coasted(s, ratio),
            "The initial speed v is missing from the numerator.": coasted(s, rate, 1.0),
            "The second term of your denominator is negative.": coasted(s, -rate),
            "Your result is v e^-s. Include the quadratic drag (k2) too.": coasted(s, 0.0),
            "You apply the quadratic drag first and then the linear drag, but both act at the same "
            "time. In the denominator, replace t / m by (1 - e^-s) / k1, where s = k1 t / m.":
                v * math.exp(-s) / (1.0 + k2 * v * time / mass),
            "The mass is missing from the exponent s.": coasted(s * mass, rate),
            "Your denominator contains the mass as an extra factor.": coasted(s, mass * rate),
            "A division by k1 is missing from the denominator.": coasted(s, k2 * v),
        }  # fmt: skip
        # From 1 / v + k2 / k1, which grows as e^(k1 t / m).
        wanted = 1.0 / ((1.0 / v + ratio) * math.exp(s) - ratio)
        # The difference in the denominator loses a digit or two.
        expect_close(got, wanted, slips, tolerance=1e-10 * v, unit="m/s")
    with calls("Coasting twice for half the time must give the same speed as coasting once."):
        half = coasting_speed(v, k1, k2, mass, time / 2.0)
        got = coasting_speed(half, k1, k2, mass, time / 2.0)
    expect_close(got, wanted, tolerance=1e-10 * v, unit="m/s")


@pytest.mark.exercise("B5.7", asks="If k1 is 0, replace", read=COAST)
def test_coasting_with_one_kind_of_drag_or_none(rng: Random) -> None:
    v, k, mass = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    time = positive_number(rng, 0.2, 2.0)
    quadratic = v / (1.0 + k * v * time / mass)
    for k1, k2, wanted, cause in (
        (k, 0.0, v * math.exp(-k * time / mass), "Without k2, it must be v e^(-k1 t / m)."),
        (0.0, k, quadratic,
         "You cannot divide by k1, which is 0 here. Use t / m for (1 - e^-s) / k1."),
        (1e-13, k, quadratic, EXPM1),
        (0.0, 0.0, v, "The speed is wrong without drag (k1 = k2 = 0). It must stay the same."),
    ):  # fmt: skip
        with calls(cause):
            got = coasting_speed(speed=v, k1=k1, k2=k2, mass=mass, time=time)
        unchanged = f"You return the initial speed, but k2 is {k2}. Quadratic drag still acts."
        slips = {unchanged: v} if k2 and not k1 else {}
        expect_close(got, wanted, slips, tolerance=ROUNDED * v, unit="m/s")


@pytest.mark.exercise("B5.7", asks="even if one coefficient is 0 or tiny", read=COAST)
def test_coasting_with_little_linear_drag_is_accurate(rng: Random) -> None:
    v, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng)
    for power in range(1, 14):
        k1 = 10.0**-power
        with calls(EXPM1):
            got = coasting_speed(speed=v, k1=k1, k2=k2, mass=1.0, time=1.0)
        # 1 / v + k2 / k1 grows as e^s: e^s / v + (k2 / k1) (e^s - 1) is 1 / v afterwards.
        wanted = 1.0 / (math.exp(k1) / v + k2 / k1 * math.expm1(k1))
        zero = "You treat a small k1 as 0. Use t / m for (1 - e^-s) / k1 only if it is exactly 0."
        slips = {zero: v * math.exp(-k1) / (1.0 + k2 * v)}
        expect_close(got, wanted, slips, tolerance=ROUNDED * wanted, unit="m/s")


@pytest.mark.exercise("B5.7", asks="after drag alone has acted on it", read=COAST)
def test_coasting_for_no_time_and_coasting_from_rest(rng: Random) -> None:
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    for speed, time, cause in (
        (v, 0.0, "The speed changed although the time is 0. Return the initial speed."),
        (0.0, 2.0, "A body at rest stays at rest, whatever its drag is. Return a speed of 0."),
    ):
        with calls(cause):
            got = coasting_speed(speed=speed, k1=k1, k2=k2, mass=2.0, time=time)
        expect_close(got, speed, tolerance=ROUNDED * speed, unit="m/s")


@pytest.mark.exercise("B5.7", asks="even for a very short or very long time", read=COAST)
@pytest.mark.robust
def test_coasting_for_a_very_long_time_ends_at_rest(rng: Random) -> None:
    v, k1, k2 = positive_number(rng, 1.0, 90.0), positive_number(rng), positive_number(rng)
    with calls("You compute e^(k1 t / m), which is too large here. Use e^(-k1 t / m) instead."):
        got = coasting_speed(speed=v, k1=k1, k2=k2, mass=2.0, time=1e9)
    expect_close(got, 0.0, tolerance=ROUNDED * v, unit="m/s")
