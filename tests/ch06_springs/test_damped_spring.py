"""Harmonic motion without steps, build task B6.5."""

from __future__ import annotations

import cmath
from math import cos, cosh, exp, pi, sin, sinh, sqrt
from random import Random

import pytest

from calls import calls
from ch06_springs.closed_form import damped_spring_state
from draw import number as draw_number
from draw import positive_number
from expect import expect_close, expect_exactly

READ = "book 6.3.2 and the docstring of damped_spring_state"
SHARES = (0.1, 0.9, 0.995, 1.0 - 1e-6, 1.0 + 1e-6, 1.005, 1.2, 5.0)  # of the critical damping
REGIMES = [(share, "under-damped" if share < 1.0 else "over-damped") for share in SHARES]
STATE = "; (position in m, velocity in m/s)"


def by_roots(x0: float, v0: float, k: float, c: float, m: float, t: float) -> tuple[float, float]:
    """Solve m x'' = -k x - c x' by the roots of m r^2 + c r + k, which must not be equal."""
    root = cmath.sqrt(c * c - 4.0 * k * m)
    r, s = (-c + root) / (2.0 * m), (-c - root) / (2.0 * m)
    a, b = (v0 - s * x0) / (r - s), (r * x0 - v0) / (r - s)
    x = a * cmath.exp(r * t) + b * cmath.exp(s * t)
    v = a * r * cmath.exp(r * t) + b * s * cmath.exp(s * t)
    return x.real, v.real


def expect_positions(
    *samples: tuple[tuple[float, ...], float, float, str],
    slips: dict[str, float] | None = None,
) -> None:
    """Expect a position for each sample of arguments, position, tolerance and likely cause."""
    for (x0, v0, k, c, m, t), wanted, tolerance, cause in samples:
        with calls(cause):
            state = damped_spring_state(x0, v0, stiffness=k, damping=c, mass=m, time=t)
        count = len(state) if isinstance(state, (tuple, list)) else 1
        both = "You didn't return two numbers. Return both the position and the velocity."
        expect_exactly(count, 2, then="; number of values returned", cause=both)
        expect_close(state[0], wanted, slips, then="; state[0]", unit="m", tolerance=tolerance)


@pytest.mark.exercise("B6.5", asks="three forms, depending on how strong the damping is", read=READ)
def test_the_three_cases_by_known_values() -> None:
    damped, late = sqrt(99.0), sqrt(96.0)  # gamma, and that of a c / m not halved
    over, high = sqrt(300.0), sqrt(9999.0)  # gamma for c = 40, and that of a k not rooted
    slips = {
        "Your exponent uses the full rate c / m. The amplitude decays at half that rate.":
            exp(-1.0) * (cos(0.5 * late) + 2.0 / late * sin(0.5 * late)),
        "Your position is only e^(-half * t) * cos(gamma * t), where half = c / (2 m). Add half * "
        "sin(gamma * t) / gamma to the cosine.": exp(-0.5) * cos(0.5 * damped),
        "You don't divide sin(gamma * t) by gamma.":
            exp(-0.5) * (cos(0.5 * damped) + sin(0.5 * damped)),
        "You left out e^(-half * t), so the amplitude does not decay.":
            cos(0.5 * damped) + sin(0.5 * damped) / damped,
        "You use k / m where you need its square root.":
            exp(-0.5) * (cos(0.5 * high) + sin(0.5 * high) / high),
        "You return the velocity first. Return the position first, and then the velocity.":
            -100.0 * exp(-0.5) * sin(0.5 * damped) / damped,
        "Your spring oscillates at the undamped frequency sqrt(k / m). Use the damped frequency "
        "gamma, which is lower.": exp(-0.5) * (cos(5.0) + 0.1 * sin(5.0)),
        "You divide sin by the damped frequency gamma, but in cos and sin you use sqrt(k / m).":
            exp(-0.5) * (cos(5.0) + sin(5.0) / damped),
        "The spring is critically damped, but your position is only e^(-half * t), where half = c "
        "/ (2 m). Multiply it by (1 + half * t).": exp(-5.0),
        "You use sinh(gamma * t) in both terms, but the first one needs cosh(gamma * t).":
            exp(-1.0) * (1.0 + 20.0 / over) * sinh(0.05 * over),
        "Your position leaves out its second term. Multiply e^(-half * t) by cosh(gamma * t) + "
        "half * sinh(gamma * t) / gamma, where half = c / (2 m).": exp(-1.0) * cosh(0.05 * over),
        "You add the two exponentials without the factor 1/2. cosh is half of their sum.":
            exp(-1.0) * (2.0 * cosh(0.05 * over) + 20.0 / over * sinh(0.05 * over)),
        "You use cos and sin for an over-damped spring, which does not oscillate.":
            exp(-1.0) * (cos(0.05 * over) + 20.0 / over * sin(0.05 * over)),
    }  # fmt: skip
    expect_positions(
        ((1.0, 0.0, 100.0, 2.0, 1.0, 0.5), 0.09855066761858595, 9e-15,
         "The spring is under-damped, so it oscillates while its amplitude decays. Multiply "
         "e^(-half * t) by terms with cos(gamma * t) and sin(gamma * t), where half = c / (2 m)."),
        ((1.0, 0.0, 100.0, 20.0, 1.0, 0.5), 0.04042768199451279, 4e-15,
         "The spring is critically damped, which the book leaves out (E-23). gamma is 0 here, "
         "so use t, the limit of sin(gamma * t) / gamma."),
        ((1.0, 0.0, 100.0, 40.0, 1.0, 0.05), 0.9302947940980407, 9e-14,
         "The spring is over-damped, which the book leaves out (E-23). Multiply e^(-half * t) by "
         "terms with cosh(gamma * t) and sinh(gamma * t), where half = c / (2 m)."),
        ((1.0, 0.0, 100.0, 40.0, 1.0, 0.5), 0.2821711739751533, 2e-14,
         "The spring is over-damped, and at this late time only the slowly decaying part "
         "e^(-(half - gamma) * t) is left, where half = c / (2 m)."),
        slips=slips,
    )  # fmt: skip
    expect_positions(
        ((1.0, 0.0, 1.0, 10.0, 1.0, 1.0), by_roots(1.0, 0.0, 1.0, 10.0, 1.0, 1.0)[0], 9e-14,
         "The book's formula takes the square root of 4 k - c^2, which is -96 here. It covers "
         "only under-damped springs (E-23), so treat over-damped springs separately."),
    )  # fmt: skip


@pytest.mark.exercise("B6.5", asks="The velocity is the derivative of this position.", read=READ)
@pytest.mark.parametrize(("share", "name"), REGIMES)
def test_any_initial_state_and_mass(share: float, name: str, rng: Random) -> None:
    for longest in (0.2, 9.0, 9.0, 9.0, 9.0):  # by 0.2 s what dies out fast is still there
        x0, v0 = draw_number(rng), draw_number(rng)
        k, m, t = positive_number(rng), positive_number(rng), positive_number(rng, 0.1, longest)
        c = share * 2.0 * sqrt(k * m)
        cause = f"The spring is {name}. Divide the damping by 2 m and the stiffness by m, and let "
        cause += "both x0 and v0 contribute."
        with calls(cause):
            got = damped_spring_state(x0, v0, stiffness=k, damping=c, mass=m, time=t)
        x, v = wanted = by_roots(x0, v0, k, c, m, t)
        x_of_v0, v_of_v0 = by_roots(0.0, v0, k, c, m, t)  # the terms with v0
        half = c / (2.0 * m)
        fade = exp(-half * t)
        slips = {
            "You didn't divide the damping by the mass.": by_roots(x0, v0, k, c * m, m, t),
            "You divide the damping by 2 and then multiply by the mass.":
                by_roots(x0, v0, k, c * m * m, m, t),
            "Your velocity leaves out -s x, where s = c / (2 m). The derivative of e^(-s t) "
            "contributes this term (product rule).": (x, v + half * x),
            "You didn't divide the stiffness by the mass.": by_roots(x0, v0, k * m, c, m, t),
            "Your position leaves out the initial velocity v0.": (x - x_of_v0, v),
            "Your velocity leaves out the initial position x0.": (x, v_of_v0),
            "Your position is right, but one term of your velocity has the wrong sign. "
            "Check the derivative of the position's term with v0.": (x, v + 2.0 * half * x_of_v0),
            "In your velocity, the term with v0 lacks the derivative of e^(-s t), where s = c / (2 "
            "m). Add it by the product rule.": (x, v + half * x_of_v0),
            "The term with v0 in your position has the wrong sign.": (x - 2.0 * x_of_v0, v),
            "The term with x0 in your velocity has the wrong sign. The spring pulls the body back, "
            "so this term is -k / m x0 S.": (x, 2.0 * v_of_v0 - v),
            "You return the initial velocity. Return that after the time t.": (x, v0),
            "Your velocity is the mean velocity (x - x0) / t. Return that at the time t.":
                (x, (x - x0) / t),
            "You treat this spring as critically damped, although c^2 is not equal to 4 k m. "
            "Compare them exactly, without a tolerance.": (
                (x0 + (v0 + half * x0) * t) * fade, (v0 - (half * v0 + k / m * x0) * t) * fade
            ),
        }  # fmt: skip
        if name == "under-damped":
            swing = sqrt(abs(half * half - k / m))
            wrong = "In your velocity, the derivative of cos(g t) has the wrong sign. It is -g "
            wrong += "sin(g t)."
            slips[wrong] = x, v + 2.0 * fade * x0 * swing * sin(swing * t)
        if isinstance(got, tuple) and got and type(got[0]) is float and abs(got[0] - x) < 1e-10:
            cause = f"The spring is {name}. x is right, but v is not its derivative."
        # The roots' formula takes differences of numbers up to 10^4.
        expect_close(got, wanted, slips, then=STATE, cause=cause, tolerance=1e-10)


@pytest.mark.exercise(
    "B6.5", asks="accurate to 1e-8 even if the damping is almost critical", read=READ
)
def test_the_motion_is_smooth_at_critical_damping(rng: Random) -> None:
    x0, v0 = draw_number(rng), draw_number(rng)
    for k, m, t in ((4.0, 1.0, 0.75), (100.0, 4.0, 0.5), (9.0, 9.0, 2.0)):
        half = sqrt(k / m)
        fade = exp(-half * t)
        wanted = ((x0 + (v0 + half * x0) * t) * fade, (v0 - half * (v0 + half * x0) * t) * fade)
        # A share e of more damping changes the motion by some e times numbers up to 100.
        for share, tolerance, cause in (
            (0.0, 1e-12,
             "At critical damping the position is (x0 + (v0 + half * x0) * t) * e^(-half * t), "
             "where half = c / (2 m). Differentiate it to get the velocity."),
            (-1e-9, 1e-7,
             "Slightly below critical damping, sin(gamma * t) / gamma is very close to t. Your "
             "result must be close to that of critical damping."),
            (1e-9, 1e-7,
             "The damping is slightly above the critical one, so sinh(gamma * t) / gamma is very "
             "close to t. The result must be close to that of critical damping."),
            (-1e-15, 1e-8,
             "Very close to critical damping, gamma can round to 0. Don't divide by gamma in that "
             "case."),
            (1e-15, 1e-8,
             "Very close to critical damping, the difference of your exponentials loses most of "
             "its digits. Use math.sinh or math.expm1 instead."),
        ):  # fmt: skip
            critical = 2.0 * m * half
            with calls(cause):
                c = critical * (1.0 + share)
                got = damped_spring_state(x0, v0, stiffness=k, damping=c, mass=m, time=t)
            if "nan" in f"{got}":
                cause = "Your result is NaN. Compute gamma in a way that never gives NaN."
            expect_close(got, wanted, then=STATE, tolerance=tolerance, cause=cause)
    with calls(
        "Just below and just above critical damping, your results must agree to 1e-8.",
        "damped_spring_state(x0=1.0, v0=0.0, stiffness=4.0, damping=4 - 4e-9, mass=1.0, time=0.75) "
        "minus the same with damping=4 + 4e-9",
    ):
        below = damped_spring_state(1.0, 0.0, 4.0, 4.0 - 4e-9, 1.0, 0.75)
        above = damped_spring_state(1.0, 0.0, 4.0, 4.0 + 4e-9, 1.0, 0.75)
    got = [a - b for a, b in zip(below, above, strict=True)]
    expect_close(got, (0.0, 0.0), tolerance=1e-8)


@pytest.mark.exercise(
    "B6.5", asks="If the stiffness is 0, the body feels no spring force.", read=READ
)
def test_no_time_and_no_stiffness(rng: Random) -> None:
    x0, v0, t = draw_number(rng), draw_number(rng), positive_number(rng)
    c, m = positive_number(rng), positive_number(rng)
    slow = exp(-c * t / m)
    for k, d, time, wanted, cause in (
        (3.0, c, 0.0, (x0, v0),
         "No time has passed yet, so position and velocity must still be x0 and v0."),
        (0.0, 0.0, t, (x0 + v0 * t, v0),
         "No force acts here, so the velocity stays v0 and the position is x0 + v0 t."),
        (0.0, c, t, (x0 + v0 * (1.0 - slow) * m / c, v0 * slow),
         "With a damping c but no stiffness, the velocity must decay as v0 e^(-c t / m)."),
    ):  # fmt: skip
        with calls(cause):
            got = damped_spring_state(x0, v0, stiffness=k, damping=d, mass=m, time=time)
        expect_close(got, wanted, tolerance=1e-11 if k == 0.0 < d else None)
    with calls("Without damping no energy is lost, so x^2 + v^2 must stay constant."):
        x, v = damped_spring_state(x0, v0, stiffness=1.0, damping=0.0, mass=1.0, time=t)
    expect_close(x * x + v * v, x0 * x0 + v0 * v0, then="; x^2 + v^2", tolerance=1e-11)


@pytest.mark.exercise("B6.5", asks="because even a very soft spring oscillates", read=READ)
def test_very_soft_and_very_stiff_springs() -> None:
    expect_positions(
        ((1.0, 1.0, 1e12, 1e3, 1.0, 100.0), 0.0, 1e-12,
         "After 100 s of damping, the oscillation has died out, so the position must be 0."),
        ((1.0, 0.0, 1e-8, 0.0, 1.0, 1e4), cos(1.0), 1e-12,
         "A very soft spring without damping still oscillates, but slowly. Don't treat a small "
         "stiffness as zero."),
        ((1.0, 0.0, 1e-18, 0.0, 1.0, 1e9), cos(1.0), 1e-12,
         "Without damping even the softest spring oscillates. Compare c / (2 m) with sqrt(k / m) "
         "exactly, because with a tolerance this spring counts as critically damped."),
        ((1.0, 0.0, 1e12, 0.0, 1.0, pi * 1e-6), -1.0, 1e-9,
         "After half a period, an undamped body is on the opposite side, so its position must be "
         "-x0."),
    )  # fmt: skip


@pytest.mark.exercise("B6.5", asks="at late times and for strong damping", read=READ)
@pytest.mark.robust
def test_late_times_and_strong_damping() -> None:
    expect_positions(
        ((1.0, 0.0, 1.0, 1000.0, 1.0, 5000.0), exp(-5.0), 1e-5,
         "cosh(gamma * t) is too large for a float at this late time. Replace e^(-half * t) * "
         "cosh(gamma * t) with (e^(-(half - gamma) * t) + e^(-(half + gamma) * t)) / 2."),
        ((1.0, 0.0, 1.0, 1e9, 1.0, 1e9), exp(-1.0), 1e-9,
         "half = c / (2 m) and gamma are almost equal, so the difference half - gamma loses all "
         "of its digits. Use chi^2 / (half + gamma) instead, where chi^2 = k / m."),
        ((1.0, 1.0, 5.0, 10.0, 1.0, 1e6), 0.0, 1e-12,
         "cosh(gamma * t) is too large for a float here, and e^(-half * t) is 0. Combine the two "
         "factors into one exponential before you evaluate it."),
        ((0.0, 1.0, 1.0, 1e9, 1.0, 1.0), 1e-9, 1e-17,
         "Strong damping stops the body almost at once, after a distance of v0 m / c. The final "
         "position must be close to that."),
    )  # fmt: skip


@pytest.mark.exercise("B6.5", asks="The velocity is the derivative of this position.", read=READ)
def test_the_motion_goes_on_from_where_it_is(rng: Random) -> None:
    x0, v0, m, some = draw_number(rng), draw_number(rng), positive_number(rng), positive_number(rng)
    first, second = positive_number(rng, 0.1, 2.0), positive_number(rng, 0.1, 2.0)
    # With a stiffness of 4 m the damping is critical to the last digit.
    for share, k in ((0.0, some), (0.5, some), (1.0, 4.0 * m), (2.0, some)):
        c = share * 2.0 * sqrt(k * m)
        with calls("Two calls in a row give another state, so v is not the derivative of x."):
            x, v = damped_spring_state(x0, v0, k, c, m, first)
            got = damped_spring_state(x, v, k, c, m, second)
        wanted = damped_spring_state(x0, v0, k, c, m, first + second)
        expect_close(got, wanted, tolerance=1e-11)
    with calls("After half a period, an undamped body must be on the opposite side."):
        x, v = damped_spring_state(x0, v0, 1.0, 0.0, 1.0, pi)
    expect_close((x, v), (-x0, -v0), tolerance=1e-11)
    with calls("After a full period the body must be back where it started.", more=True):
        got = damped_spring_state(x, v, 1.0, 0.0, 1.0, pi)
    expect_close(got, (x0, v0), tolerance=1e-11)
