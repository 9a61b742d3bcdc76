"""Implicit steps for one spring, build task B6.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch06_springs.integrators import backward_euler, trapezoidal
from ch06_springs.step_probes import implicit_steps
from draw import number as draw_number
from draw import positive_number
from expect import expect_close, expect_that, named

READ = "the docstrings of backward_euler and trapezoidal"
METHODS = {"backward_euler": backward_euler, "trapezoidal": trapezoidal}
RULES = {
    "backward_euler": ("x + v' h", "v + a' h"),
    "trapezoidal": ("x + (v + v') h / 2", "v + (a + a') h / 2"),
}


def off(
    method: str, x: float, v: float, k: float, c: float, m: float, h: float, new: tuple[float, ...]
) -> tuple[float, float]:
    """Return the errors of a method's two equations for a new state."""
    a, b = (-k * x - c * v) / m, (-k * new[0] - c * new[1]) / m
    if method == "trapezoidal":
        return new[0] - x - 0.5 * h * (v + new[1]), new[1] - v - 0.5 * h * (a + b)
    return new[0] - x - h * new[1], new[1] - v - h * b


def slips_of(
    method: str, x: float, v: float, k: float, c: float, m: float, h: float
) -> dict[str, tuple[float, float]]:
    """Return the new state after each likely mistake, keyed by its explanation."""
    w, y = k / m * h, c / m * h
    u = v - w * x - y * v  # the velocity after a step of explicit Euler
    explicit = "You take a step of explicit Euler, which uses only the old values."
    if method == "backward_euler":
        old = "Your v' contains the spring force at the old position x, as in semi-implicit Euler."
        velocities = {
            old if k else "Your v' contains the damping force at the old velocity v.": u,
            "Your term h k x / m has the wrong sign.": (v + w * x) / (1.0 + y + w * h),
            "Your denominator contains h c / (2 m), as in the trapezoidal rule. The whole damping "
            "acts at the new velocity here, so use h c / m.":
                (v - w * x) / (1.0 + 0.5 * y + w * h),
            "Your numerator contains k x / m without the factor h. Multiply the acceleration by "
            "h.": (v - w / h * x) / (1.0 + y + w * h),
            "Your denominator contains h k / m, but it must contain h^2 k / m. The additional "
            "factor h comes from x' = x + v' h.": (v - w * x) / (1.0 + y + w),
        }  # fmt: skip
        moved = {slip: (x + new * h, new) for slip, new in velocities.items()}
        return {explicit: (x + v * h, u)} | moved
    rest, below = v * (1.0 - 0.5 * y - 0.25 * w * h), 1.0 + 0.5 * y + 0.25 * w * h
    velocities = {
        "In your formula for v', you halve the term h k x / m. Use the whole term, because both a "
        "and a' contain -k x / m.": (rest - 0.5 * w * x) / below,
        "Your v' uses only the old values, as in explicit Euler.": u,
        "Your v' uses the acceleration after a step of explicit Euler in place of the new one. The "
        "new one depends on v' itself, so solve for v'.":
            v - 0.5 * (w * (x + x + v * h) + y * (v + u)),
        "The term h^2 k / (4 m) is missing from your numerator. The mean of the forces contains "
        "half of k v h / 2, too.": (v * (1.0 - 0.5 * y) - w * x) / below,
        "The stiffness is missing from your denominator. The force at x' = x + (v + v') h / 2 "
        "depends on v', so add h^2 k / (4 m) to the denominator.":
            (rest - w * x) / (1.0 + 0.5 * y),
        "Your denominator contains h k / (2 m). The term must be h^2 k / (4 m), because x' = x + "
        "(v + v') h / 2 contributes another factor h / 2.":
            (rest - w * x) / (1.0 + 0.5 * y + 0.5 * w),
        "Your denominator contains h c / m. The term must be h c / (2 m), because the mean (a + "
        "a') / 2 contains only half of a'.": (rest - w * x) / (1.0 + y + 0.25 * w * h),
    }  # fmt: skip
    moved = {slip: (x + 0.5 * (v + new) * h, new) for slip, new in velocities.items()}
    return {explicit: (x + v * h, u)} | moved


@pytest.mark.exercise("B6.9", asks="Every step therefore has to solve an equation.", read=READ)
@pytest.mark.parametrize("method", METHODS)
def test_the_new_state_solves_its_equations(method: str, rng: Random) -> None:
    x, v = draw_number(rng), draw_number(rng)
    some, loss, m, h = (positive_number(rng) for _ in range(4))
    other = "trapezoidal" if method == "backward_euler" else "backward_euler"
    moves, turns = RULES[method]
    cause = f"The equations of {method} are x' = {moves} and v' = {turns}, where a = -(k x + c v) "
    cause += "/ m and a' is the same with x' and v'. Insert the first one into the second, and "
    cause += "solve for v'."
    for k, c in ((some, 0.0), (0.0, loss), (some, loss)):
        numbers = f"{x=}, {v=}, stiffness={k}, damping={c}, mass={m}, duration={h}"
        with calls(cause, f"x', v' = {method}({numbers})"):
            new = METHODS[method](x, v, k, c, m, h)
        both = "Return two finite numbers in a tuple, the new position x' and velocity v'."
        two = isinstance(new, (tuple, list)) and len(new) == 2
        finite = two and all(type(n) in (int, float) and math.isfinite(n) for n in new)
        expect_that(finite, f"{new!r}", "two finite numbers", cause=both)
        left = off(method, x, v, k, c, m, h, new)
        idle = "Your result ignores the damping."
        if method == "trapezoidal" and not k:
            idle = "Your result shows no damping. Either you leave it out, or one of its two terms "
            idle += "has the wrong sign."
        errors: dict[str, tuple[float, ...]] = {  # of the equations of each mistake
            "You return the two results in the wrong order. Return the position x' first.":
                off(method, x, v, k, c, m, h, (new[1], new[0])),
            f"Your result is that of {other}.": off(other, x, v, k, c, m, h, new),
            idle: off(method, x, v, k, 0.0, m, h, new),
            "Your result ignores the stiffness.": off(method, x, v, 0.0, c, m, h, new),
            f"You don't divide the {'stiffness' if k else 'damping'} by the mass m.":
                off(method, x, v, k, c, 1.0, h, new),
            "You move the body with its old velocity, x' = x + v h.": (new[0] - x - v * h,),
            "You return the old position.": (new[0] - x,),
            "You move the body by the sum of both velocities.": (new[0] - x - (v + new[1]) * h,),
        }  # fmt: skip
        if method == "trapezoidal" and left[0] != 0.0:
            slip = "You move the body with its new velocity alone, x' = x + v' h."
            errors[slip] = (new[0] - x - new[1] * h,)
        why = named(new, cause, slips_of(method, x, v, k, c, m, h))
        if why == cause:  # if the new state solves the equations of a mistake, it was made
            made = [slip for slip, error in errors.items() if max(map(abs, error)) < 1e-10]
            why = " ".join((*made[:1], cause))
        # A few roundings of numbers up to 4000.
        then = f"; x', in m, which must equal {moves}"
        expect_close(new[0], new[0] - left[0], then=then, cause=why, tolerance=1e-10)
        then = f"; v', in m/s, which must equal {turns} with a' = -(k x' + c v') / m"
        expect_close(new[1], new[1] - left[1], then=then, cause=why, tolerance=1e-10)


@pytest.mark.exercise("B6.9", asks="says how quickly its error shrinks", read=READ)
@pytest.mark.parametrize(("method", "factor"), [("backward_euler", 2.0), ("trapezoidal", 4.0)])
def test_half_the_step_makes_the_error_smaller(method: str, factor: float) -> None:
    # x(2) by the closed form: e^-0.5 (cos 2g + sin 2g / (4 g)), g the root of 3.9375
    g = math.sqrt(3.9375)
    exact = math.exp(-0.5) * (math.cos(2.0 * g) + 0.25 * math.sin(2.0 * g) / g)
    with calls(
        "With half the time step, the error of this method must be smaller by a factor of "
        f"{factor:g}. Compare your two equations with those in the docstring.",
        f"steps of {method} with stiffness=4, damping=0.5 and mass=1, from x = 1 at rest to 2 s; "
        "the error of x with h = 1/200, divided by the error with h = 1/400",
    ):
        long, short = (
            implicit_steps(method, 1.0, 0.0, (4.0, 0.5, 1.0, 2.0 / n), n)[0] - exact
            for n in (400, 800)
        )
    # The next order adds some h of it.
    expect_close(long / short, factor, tolerance=0.03 * factor)


@pytest.mark.exercise("B6.9", asks="It is stable for every stiffness", read=READ)
@pytest.mark.parametrize("method", METHODS)
def test_no_spring_is_too_stiff(method: str, rng: Random) -> None:
    cause = "Without damping, each step of backward Euler divides the energy by 1 + k h^2 / m, so "
    cause += "even the stiffest spring settles down. Use the force of the new state."
    if method == "trapezoidal":
        cause = "The trapezoidal rule keeps the energy of an undamped spring, however stiff it is. "
        cause += "Use the mean of the old and the new values for both the position and the "
        cause += "velocity."
    v = draw_number(rng)
    for k, steps in ((1e3, 5), (1e3, 1000), (1e6, 1000), (1e12, 1000)):
        with calls(
            cause,
            f"{steps} steps of {method} with stiffness={k:g}, damping=0, mass=1 and duration=1/60, "
            f"from x = 1 and v = {v}; the final energy divided by the initial energy",
        ):
            x, new = implicit_steps(method, 1.0, v, (k, 0.0, 1.0, 1.0 / 60.0), steps)
        left = (k * x * x + new * new) / (k + v * v)
        wanted = 1.0 if method == "trapezoidal" else (1.0 + k / 3600.0) ** -steps
        # Each step of the trapezoidal rule rounds numbers that are up to 10^8 times as large as
        # what is left of them; what is lost at each is 1e-16 of that.
        expect_close(left, wanted, tolerance=1e-5 if method == "trapezoidal" else 1e-12 * wanted)


@pytest.mark.exercise("B6.9", asks="every step divides the energy by 1 + k h^2 / m", read=READ)
def test_backward_euler_loses_energy_by_its_factor(rng: Random) -> None:
    x, v = draw_number(rng), draw_number(rng)
    k, m, h = (positive_number(rng) for _ in range(3))
    with calls(
        "Without damping, a step of backward Euler must divide the energy by exactly 1 + k h^2 / "
        "m. Use the new position and the new velocity in both equations."
    ):
        new = backward_euler(x, v, stiffness=k, damping=0.0, mass=m, duration=h)
    got = (k * new[0] ** 2 + m * new[1] ** 2) / (k * x * x + m * v * v)
    then = "; the final energy divided by the initial energy"
    expect_close(got, 1.0 / (1.0 + k * h * h / m), then=then, tolerance=1e-12)
