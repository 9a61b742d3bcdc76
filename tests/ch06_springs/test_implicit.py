"""Implicit steps for one spring, build task B6.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch06_springs.integrators import backward_euler, trapezoidal
from ch06_springs.step_probes import implicit_steps
from draw import number as draw_number
from draw import positive_number
from expect import about, expect_close, expect_that, named

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


@pytest.mark.exercise("B6.9", asks="Every step therefore has to solve an equation.")
@pytest.mark.parametrize("method", METHODS)
def test_the_new_state_solves_its_equations(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}"
    x, v = draw_number(rng), draw_number(rng)
    k, c, m, h = (positive_number(rng) for _ in range(4))
    for stiffness, damping in ((k, 0.0), (0.0, c), (k, c)):
        about.call = f"x', v' = {method}(x={x}, v={v}, stiffness={stiffness}, damping={damping}, "
        about.call += f"mass={m}, duration={h})"
        about.cause = "Your x' and v' don't satisfy the two equations in the docstring. Insert the "
        about.cause += "first one into the second, with a' = -(k x' + c v') / m, and solve for v'."
        new = METHODS[method](x, v, stiffness, damping, m, h)
        both = "Return two finite numbers in a tuple, the new position x' and velocity v'."
        two = isinstance(new, (tuple, list)) and len(new) == 2
        finite = two and all(type(n) in (int, float) and math.isfinite(n) for n in new)
        expect_that(finite, f"{new!r}", "two finite numbers", cause=both)
        left = off(method, x, v, stiffness, damping, m, h, new)
        other = "trapezoidal" if method == "backward_euler" else "backward_euler"
        u = v + (-stiffness * x - damping * v) / m * h
        w, y = stiffness / m * h, damping / m * h
        slips = {
            "You take a step of explicit Euler, which uses only the old values. Solve the "
            "equations in the docstring for the new velocity instead.": (x + v * h, u),
        }
        if method == "backward_euler":
            explicit = (
                "Your v' contains the spring force at the old position x, as in semi-implicit "
                "Euler. Use the force at the new position x', and solve for v'."
            )
            if not stiffness:
                explicit = "Your v' contains the damping force at the old velocity v. Use the "
                explicit += "force at the new velocity v', and solve for v'."
            new_velocities = {
                explicit: u,
                "Your term h k x / m has the wrong sign. The spring pulls the body back, so "
                "subtract the term.": (v + w * x) / (1.0 + y + w * h),
                "Your denominator contains h c / (2 m), as in the trapezoidal rule. The whole "
                "damping acts at the new velocity here, so use h c / m.": (v - w * x)
                / (1.0 + 0.5 * y + w * h),
                "Your numerator contains k x / m without the factor h. Multiply the acceleration "
                "by h.": (v - w / h * x) / (1.0 + y + w * h),
                "Your denominator contains h k / m, but it must contain h^2 k / m. The additional "
                "factor h comes from x' = x + v' h.": (v - w * x) / (1.0 + y + w),
            }
            slips |= {slip: (x + new_v * h, new_v) for slip, new_v in new_velocities.items()}
        else:
            rest = v * (1.0 - 0.5 * y - 0.25 * w * h)
            new_velocities = {
                "In your formula for v', you halve the term h k x / m. Use the whole term, because "
                "both a and a' contain -k x / m.": (rest - 0.5 * w * x)
                / (1.0 + 0.5 * y + 0.25 * w * h),
                "Your v' uses only the old values, as in explicit Euler. Use the mean of the old "
                "and the new acceleration, and solve for v'.": u,
                "Your v' uses the acceleration after a step of explicit Euler in place of the new "
                "one. The new one depends on v' itself, so solve for v'.": v
                - 0.5 * (w * (x + x + v * h) + y * (v + u)),
                "The term h^2 k / (4 m) is missing from your numerator. The mean of the forces "
                "contains half of k v h / 2, too.": (v * (1.0 - 0.5 * y) - w * x)
                / (1.0 + 0.5 * y + 0.25 * w * h),
                "The stiffness is missing from your denominator. The force at x' = x + (v + v') "
                "h / 2 depends on v', so add h^2 k / (4 m) to the denominator.": (rest - w * x)
                / (1.0 + 0.5 * y),
                "Your denominator contains h k / (2 m). The term must be h^2 k / (4 m), because "
                "x' = x + (v + v') h / 2 contributes another factor h / 2.": (rest - w * x)
                / (1.0 + 0.5 * y + 0.5 * w),
                "Your denominator contains h c / m. The term must be h c / (2 m), because the "
                "mean (a + a') / 2 contains only half of a'.": (rest - w * x)
                / (1.0 + y + 0.25 * w * h),
            }
            slips |= {
                slip: (x + 0.5 * (v + new_v) * h, new_v) for slip, new_v in new_velocities.items()
            }
        without = "The acceleration is a = -(k x + c v) / m."
        idle = "Your result ignores the damping."
        if method == "trapezoidal" and not stiffness:
            idle = "Your result shows no damping. Either you leave it out, or one of its two terms "
            idle += "has the wrong sign."
        fits = {
            "You return the two results in the wrong order. Return the position x' first and "
            "the velocity v' second.": off(
                method, x, v, stiffness, damping, m, h, (new[1], new[0])
            ),
            f"Your result is that of {other}. The equations of {method} are x' = "
            f"{RULES[method][0]} and v' = {RULES[method][1]}.": off(
                other, x, v, stiffness, damping, m, h, new
            ),
            f"{idle} {without}": off(method, x, v, stiffness, 0.0, m, h, new),
            "Your result ignores the stiffness. The acceleration is a = -(k x + c v) / m, so "
            "include the term with k.": off(method, x, v, 0.0, damping, m, h, new),
            f"You don't divide the {'stiffness' if stiffness else 'damping'} by the mass m. "
            f"{without}": off(method, x, v, stiffness, damping, 1.0, h, new),
        }
        # If the new state solves the equations of a mistake, that mistake was made.
        slip = next((slip for slip in fits if max(map(abs, fits[slip])) < 1e-10), "")
        if not slip and abs(new[0] - x - v * h) < 1e-10:
            slip = "You move the body with its old velocity, x' = x + v h. The equation of this "
            slip += f"method is x' = {RULES[method][0]}."
        if not slip and new[0] == x:
            slip = "You return the old position. The equation of this method is x' = "
            slip += f"{RULES[method][0]}."
        if not slip and abs(new[0] - x - (v + new[1]) * h) < 1e-10:
            slip = "You move the body by the sum of both velocities. The equation of this method "
            slip += f"is x' = {RULES[method][0]}."
        new_alone = method == "trapezoidal" and abs(new[0] - x - new[1] * h) < 1e-10
        if not slip and new_alone and left[0] != 0.0:
            slip = "You move the body with its new velocity alone, x' = x + v' h. The equation of "
            slip += f"this method is x' = {RULES[method][0]}."
        known = named(new, about.cause, slips)
        about.cause = slip if slip and known == about.cause else known
        # A few roundings of numbers up to 4000.
        then = f"; x', in m, which must equal {RULES[method][0]}"
        expect_close(new[0], new[0] - left[0], then=then, tolerance=1e-10)
        then = f"; v', in m/s, which must equal {RULES[method][1]} with a' = -(k x' + c v') / m"
        expect_close(new[1], new[1] - left[1], then=then, tolerance=1e-10)


@pytest.mark.exercise("B6.9", asks="says how quickly its error shrinks")
@pytest.mark.parametrize(("method", "factor"), [("backward_euler", 2.0), ("trapezoidal", 4.0)])
def test_half_the_step_makes_the_error_smaller(method: str, factor: float) -> None:
    about.read = f"the docstring of {method}"
    about.call = f"steps of {method} with stiffness=4, damping=0.5 and mass=1, from x = 1 at rest "
    about.call += "to 2 s; the error of x"
    about.cause = "With half the time step, the error of this method must be smaller by a factor "
    about.cause += f"of {factor:g}. Compare your two equations with those in the docstring."
    # x(2) by the closed form: e^-0.5 (cos 2g + sin 2g / (4 g)), g the root of 3.9375
    g = math.sqrt(3.9375)
    exact = math.exp(-0.5) * (math.cos(2.0 * g) + 0.25 * math.sin(2.0 * g) / g)
    errors = [
        implicit_steps(method, 1.0, 0.0, 4.0, 0.5, 1.0, 2.0 / n, n)[0] - exact for n in (400, 800)
    ]
    # The next order adds some h of it.
    expect_close(
        errors[0] / errors[1],
        factor,
        then=" with h = 1/200, divided by the error with h = 1/400",
        tolerance=0.03 * factor,
    )


@pytest.mark.exercise("B6.9", asks="It is stable for every stiffness")
@pytest.mark.parametrize("method", METHODS)
def test_no_spring_is_too_stiff(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}"
    v = draw_number(rng)
    causes = {
        "trapezoidal": (
            "The trapezoidal rule keeps the energy of an undamped spring, however "
            "stiff it is. Use the mean of the old and the new values for both the position and "
            "the velocity."
        ),
        "backward_euler": (
            "Without damping, each step of backward Euler divides the energy by 1 + k "
            "h^2 / m, so even the stiffest spring settles down. Use the force of the new state."
        ),
    }
    about.cause = causes[method]
    for k, steps in ((1e3, 5), (1e3, 1000), (1e6, 1000), (1e12, 1000)):
        about.call = f"{steps} steps of {method} with stiffness={k:g}, damping=0, mass=1 and "
        about.call += f"duration=1/60, from x = 1 and v = {v}; the final energy divided by the "
        about.call += "initial energy"
        x, new = implicit_steps(method, 1.0, v, k, 0.0, 1.0, 1.0 / 60.0, steps)
        left = (k * x * x + new * new) / (k + v * v)
        wanted = 1.0 if method == "trapezoidal" else (1.0 + k / 3600.0) ** -steps
        # Each step of the trapezoidal rule rounds numbers that are up to 10^8 times as large as
        # what is left of them; what is lost at each is 1e-16 of that.
        tolerance = 1e-5 if method == "trapezoidal" else 1e-12 * wanted
        expect_close(left, wanted, tolerance=tolerance)


@pytest.mark.exercise("B6.9", asks="every step divides the energy by 1 + k h^2 / m")
def test_backward_euler_loses_energy_by_its_factor(rng: Random) -> None:
    about.read = "the docstring of backward_euler"
    x, v = draw_number(rng), draw_number(rng)
    k, m, h = (positive_number(rng) for _ in range(3))
    about.call = f"backward_euler(x={x}, v={v}, stiffness={k}, damping=0.0, mass={m}, "
    about.call += f"duration={h}); the final energy divided by the initial energy"
    about.cause = "Without damping, a step of backward Euler must divide the energy by exactly 1 + "
    about.cause += "k h^2 / m. Use the new position and the new velocity in both equations."
    new = backward_euler(x, v, k, 0.0, m, h)
    energy = 0.5 * k * new[0] ** 2 + 0.5 * m * new[1] ** 2
    before = 0.5 * k * x * x + 0.5 * m * v * v
    wanted = 1.0 / (1.0 + k * h * h / m)
    expect_close(energy / before, wanted, tolerance=1e-12)
