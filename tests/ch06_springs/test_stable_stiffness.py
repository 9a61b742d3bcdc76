"""How stiff may a spring be: exercise 6.6b, worked out."""

from __future__ import annotations

import cmath
import math
from random import Random

import pytest

from calls import calls
from ch06_springs.springs import max_stable_stiffness
from ch06_springs.step_probes import step_matrix
from draw import positive_number
from expect import expect_close, expect_exactly, expect_that

READ = "exercise 6.6 and the docstring of max_stable_stiffness"


def largest_eigenvalue(matrix: tuple[float, float, float, float]) -> float:
    """Return the size of the largest eigenvalue of the rows (a, b), (c, d)."""
    a, b, c, d = matrix
    root = cmath.sqrt((a + d) ** 2 / 4.0 - (a * d - b * c))
    return max(abs((a + d) / 2.0 + root), abs((a + d) / 2.0 - root))


@pytest.mark.exercise("6.6b", asks="the limit is m (d^-h - 1) / h^2", read=READ)
def test_the_largest_stiffness_by_known_values() -> None:
    h = 1.0 / 60.0
    for d, wanted in ((0.999, 0.060030520518), (0.9, 6.327184608887), (0.5, 41.829985086921)):
        with calls(
            "The largest stable stiffness is m (d^-h - 1) / h^2, where d is the damping per second "
            "and h the duration of a step."
        ):
            got = max_stable_stiffness(damping=d, duration=h)
        keep = d**h
        slips = {
            "Your result is -m ln d / h, an approximation for short steps.": -math.log(d) * 60.0,
            "Your result is m (d^-h - 1) / h.": wanted / 60.0,
            "Your result is m (1 / d - 1) / h^2, as if d were the damping per step.":
                (1.0 / d - 1.0) * 3600.0,
            "Your result is m (1 - d^h) / h^2, which is right for Eq. 3.6 but not for "
            "Particle.integrate (E-16). Use d^-h - 1 instead of 1 - d^h.": (1.0 - keep) * 3600.0,
            "Your result is m d^-h / h^2, where d is the damping and h the duration. Subtract 1 "
            "from d^-h.": wanted + 3600.0,
            "Your result is 4 m / h^2, the limit of semi-implicit Euler without damping. "
            "Particle.integrate is explicit Euler, so use m (d^-h - 1) / h^2.": 14_400.0,
            "Your result is 0, although some springs are stable at this damping. Perhaps the sign "
            "of your exponent is wrong. It is -h, the negative duration.": 0.0,
            "Your result is the limit of semi-implicit Euler, but Particle.integrate is explicit "
            "Euler.": 2.0 * (1.0 + keep) / keep * 3600.0,
        }  # fmt: skip
        expect_close(got, wanted, slips, tolerance=1e-10 * wanted, unit="N/m")
    for mass in (2.0, 0.25):
        with calls(
            "A heavier particle tolerates a stiffer spring. Multiply the limit for 1 kg by the "
            "mass."
        ):
            got = max_stable_stiffness(damping=0.5, duration=h, mass=mass)
        wanted = mass * 41.829985086921
        slips = {
            "Your result is the limit for a mass of 1 kg.": wanted / mass,
            "You divide by the mass.": wanted / mass**2,
        }
        expect_close(got, wanted, slips, tolerance=1e-10 * wanted, unit="N/m")


@pytest.mark.exercise("6.6b", asks="above which a spring makes a simulation explode", read=READ)
def test_the_step_explodes_beyond_it_and_not_before(rng: Random) -> None:
    for _ in range(5):
        d, h = round(rng.uniform(0.05, 0.99), 3), positive_number(rng, 0.005, 0.2)
        m = positive_number(rng)
        with calls(
            "At the largest stable stiffness k the oscillation neither grows nor dies out. Then "
            "d^h (1 + k h^2 / m) is 1, where d is the damping and h the duration, so solve this "
            "for k.",
            f"k = max_stable_stiffness(damping={d}, duration={h}, mass={m}); Particle.integrate "
            "with a spring of ",
        ):
            limit = max_stable_stiffness(d, h, m)
        then = "{} k N/m; the factor by which each step multiplies the swings"
        for share in (0.98, 1.0, 1.02):
            size = largest_eigenvalue(step_matrix(share * limit, d, h, m))
            wanted = math.sqrt(1.0 + (share - 1.0) * (1.0 - d**h))
            expect_close(size, wanted, then=then.format(share), tolerance=1e-12)


@pytest.mark.exercise("6.6b", asks="no spring is stable, so the result is 0", read=READ)
def test_the_ends_of_the_damping() -> None:
    for d, wanted, cause in (
        (1.0, 0.0,
         "No spring is stable at a damping of 1, so return 0. The formula gives 0 here too, "
         "because d^-h is 1."),
        (1.5, 0.0,
         "With a damping above 1 the velocity grows on its own, so no spring is stable. Return 0 "
         "instead of a negative number."),
        (0.0, math.inf,
         "A damping of 0 stops the particle in every step, so every spring is stable. Return "
         "math.inf before you use the formula, which fails for 0."),
    ):  # fmt: skip
        with calls(cause):
            got = max_stable_stiffness(damping=d, duration=0.25)
        expect_that(isinstance(got, (int, float)), f"{got!r}", "a number")
        came, right = f"{got + 0.0:.15g}", f"{wanted:.15g}"  # a zero may be negative
        expect_that(came == right, f"{came} N/m", f"{right} N/m")
    with calls(
        "Your difference d^-h - 1 loses most of its digits, because d^-h is close to 1. Use "
        "math.expm1, which computes e^x - 1 accurately."
    ):
        got = max_stable_stiffness(damping=1.0 - 1e-12, duration=1e-3)
    wanted = -math.log(1.0 - 1e-12) / 1e-3
    expect_close(got, wanted, tolerance=1e-9 * wanted, unit="N/m")
    with calls(
        "With a damping of 0.5, a duration of 2 s and a mass of 1 kg the limit is (0.5^-2 - 1) / "
        "2^2, which is 0.75. Compare your formula with this one, term by term."
    ):
        got = max_stable_stiffness(damping=0.5, duration=2.0)
    expect_close(got, 0.75, unit="N/m")


@pytest.mark.exercise("6.6b", asks="d^-h is too large for a float, it is math.inf", read=READ)
@pytest.mark.robust
def test_a_stiffness_too_large_for_a_float_is_infinite() -> None:
    with calls(
        "Python raises an OverflowError here, because this limit is too large for a float. Catch "
        "the error and return math.inf."
    ):
        got = max_stable_stiffness(damping=1e-300, duration=1000.0)
    expect_exactly(got, math.inf)
