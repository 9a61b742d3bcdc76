"""Implicit steps for one spring, build task B6.9, and a warning when it explodes, B6.10."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from calls import calls
from ch06_springs.integrators import backward_euler, trapezoidal
from ch06_springs.step_probes import exploding, implicit_steps, watching, watching_on
from draw import number as draw_number
from draw import positive_number
from expect import ROUNDING, expect_close, expect_exactly, expect_that, named

IMPLICIT = "the docstrings of backward_euler and trapezoidal"
METHODS = {"backward_euler": backward_euler, "trapezoidal": trapezoidal}
RULES = {
    "backward_euler": ("x + v' h", "v + a' h"),
    "trapezoidal": ("x + (v + v') h / 2", "v + (a + a') h / 2"),
}
WATCHED = "the docstring of watched"
CALL = "step = watched(integrator, speed_limit={}); step(particles, apply_forces, h)"
TOLD = "; the error that step raises"


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
            "Your denominator contains h c / (2 m), as in the trapezoidal rule.":
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
        "In your formula for v', you halve the term h k x / m.": (rest - 0.5 * w * x) / below,
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


@pytest.mark.exercise("B6.9", asks="Every step therefore has to solve an equation.", read=IMPLICIT)
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
        then = f"; x', in m, which must equal {moves} with your v'"
        expect_close(new[0], new[0] - left[0], then=then, cause=why, tolerance=1e-10)
        then = f"; v', in m/s, which must equal {turns} with a' = -(k x' + c v') / m from it"
        expect_close(new[1], new[1] - left[1], then=then, cause=why, tolerance=1e-10)


@pytest.mark.exercise("B6.9", asks="says how quickly its error shrinks", read=IMPLICIT)
@pytest.mark.parametrize(("method", "factor"), [("backward_euler", 2.0), ("trapezoidal", 4.0)])
def test_half_the_step_makes_the_error_smaller(method: str, factor: float) -> None:
    # x(2) by the closed form: e^-0.5 (cos 2g + sin 2g / (4 g)), g the root of 3.9375
    g = math.sqrt(3.9375)
    exact = math.exp(-0.5) * (math.cos(2.0 * g) + 0.25 * math.sin(2.0 * g) / g)
    with calls(
        f"Half the step must divide the error by {factor:g}. Compare with the docstring.",
        f"steps of {method} with stiffness=4, damping=0.5 and mass=1, from x = 1 at rest to 2 s; "
        "the error of x with h = 1/200, divided by the error with h = 1/400",
    ):
        long, short = (
            implicit_steps(method, 1.0, 0.0, (4.0, 0.5, 1.0, 2.0 / n), n)[0] - exact
            for n in (400, 800)
        )
    # The next order adds some h of it.
    expect_close(long / short, factor, tolerance=0.03 * factor)


@pytest.mark.exercise("B6.9", asks="It is stable for every stiffness", read=IMPLICIT)
@pytest.mark.parametrize("method", METHODS)
def test_no_spring_is_too_stiff(method: str, rng: Random) -> None:
    cause = "Each step of backward Euler divides the energy by 1 + k h^2 / m. Use the new force."
    if method == "trapezoidal":
        cause = "The trapezoidal rule keeps the energy. Use the mean of both states in x' and v'."
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


@pytest.mark.exercise("B6.9", asks="every step divides the energy by 1 + k h^2 / m", read=IMPLICIT)
def test_backward_euler_loses_energy_by_its_factor(rng: Random) -> None:
    x, v = draw_number(rng), draw_number(rng)
    k, m, h = (positive_number(rng) for _ in range(3))
    with calls("Without damping, a step must divide the energy by exactly 1 + k h^2 / m."):
        new = backward_euler(x, v, stiffness=k, damping=0.0, mass=m, duration=h)
    got = (k * new[0] ** 2 + m * new[1] ** 2) / (k * x * x + m * v * v)
    then = "; the final energy divided by the initial energy"
    expect_close(got, 1.0 / (1.0 + k * h * h / m), then=then, tolerance=1e-12)


def in_words(error: Sequence[float] | None) -> str:
    """Describe an error by its particle, and if given, by its step, speed and limit."""
    forms = "particle {}", "step {}", "speed {:.6g} m/s", "limit {:.6g} m/s"
    return "no error" if error is None else ", ".join(map(str.format, forms, error))


def expect_told(error: Sequence[float] | None, wanted: Sequence[float] | None, cause: str) -> None:
    """Expect an error with these numbers, the particle, the step, the speed and the limit, or none.

    Of the four numbers, only as many count as are wanted.
    """
    __tracebackhide__ = True
    told = error if error is None or wanted is None else error[: len(wanted)]
    right = told is wanted or (
        None not in (told, wanted)
        and all(
            type(one) in (int, float) and abs(one - other) <= ROUNDING * max(wanted)
            for one, other in zip(told, wanted, strict=True)
        )
    )
    expect_that(right, in_words(told), in_words(wanted), then=TOLD, cause=cause)


@pytest.mark.exercise("B6.10", asks="calls integrator once, with the same arguments", read=WATCHED)
def test_a_watched_step_is_the_original_step(rng: Random) -> None:
    frames, limit = rng.randint(2, 5), positive_number(rng, 2.0, 90.0)
    with calls(
        "Return step itself, which calls the integrator once, with its three arguments.",
        f"no particle is faster than {0.999 * limit:.6g} m/s; {CALL.format(limit)}, {frames} times",
    ):
        asked, error = watching(limit, [[0.5 * limit, 0.999 * limit, -0.999 * limit]] * frames)
    often = "Your step calls the original integrator more than once, perhaps once for each "
    often += "particle. Call it exactly once in each step, before you check the particles."
    then = "; number of calls of the original integrator"
    expect_that(len(asked) <= frames, f"{len(asked)}", f"at most {frames}", cause=often, then=then)
    total = "Your speed is the sum of the three components of the velocity. Use its magnitude, the "
    total += "square root of the sum of their squares."
    squared = "You compare the squared speed with the limit. Take the square root of the sum of "
    squared += "the squared components first."
    cause = "No speed is above the limit. The speed is the magnitude of the velocity."
    for speed in (0.5 * limit, 0.999 * limit):
        slips = {total: speed * 11.0 / 7.0, squared: speed**2}  # 2 + 3 + 6 of 7
        cause = named(error and error[2], cause, slips)
    expect_told(error, None, cause)
    expect_exactly(
        [tuple(one) for one in asked],
        [(3, 0.25 + i) for i in range(frames)],
        then="; the number of particles and the duration that the integrator gets in each call",
        cause="You don't pass the same arguments to the original integrator. Call it once per "
        "step, with particles, apply_forces and duration unchanged.",
    )


@pytest.mark.exercise(
    "B6.10", asks="raises SimulationDiverged for the first particle", read=WATCHED
)
def test_the_error_names_the_first_particle_above_the_limit(rng: Random) -> None:
    limit = positive_number(rng, 2.0, 90.0)
    speed = 1.25 * limit
    report = "Report the first particle that is too fast: its index, the number of the step, its "
    report += "speed and the limit."
    for number, fast in ((1, 0), (1, 3), (3, 2), (6, 1)):
        speeds = [[0.5 * limit] * 4 for _ in range(6)]
        speeds[number - 1][3] = 2.0 * limit
        speeds[number - 1][fast] = -speed
        with calls(
            f"Raise SimulationDiverged. {report}",
            f"{CALL.format(limit)}, until it raises an error; particles[{fast}] is the first that "
            f"is too fast, at {speed:.6g} m/s after step {number}",
        ):
            asked, error = watching(limit, speeds)
        slips = {
            "Your step number is one too small, because you count the steps from 0.":
                (fast, number - 1, speed, limit),
            "Your step number is always 1, because you set the counter to 0 in every step. Set it "
            "to 0 in watched, outside of step, and declare it nonlocal in step.":
                (fast, 1 if number > 2 else 0, speed, limit),
            "Your particle number is one too large. Particles are numbered from 0, like the "
            "items of a list.": (fast + 1, number, speed, limit),
            "Your error reports the last particle that is too fast.":
                (3, number, 2.0 * limit, limit),
            "You swapped the speed and the limit. SimulationDiverged takes the speed first.":
                (fast, number, limit, speed),
            "Your step number is one too large. Check the speeds after you call the integrator.":
                (fast, number + 1, speed, limit),
        }  # fmt: skip
        if error is None:
            cause = "A particle is too fast. Compare the size of each velocity with speed_limit."
            if fast:
                cause = f"You don't check particles[{fast}]. Check every particle after each step."
        elif error[3] == limit and isinstance(error[1], int) and error[1] > number + 1:
            cause = "Your step number also counts other watched steps. Let each count its own."
        else:
            cause = named(tuple(error), report, slips)
        expect_told(error, (fast, number, speed, limit), cause)
        cause = "You raised the error too early or too late. Check the speeds after each step."
        expect_exactly(len(asked), number, then="; number of steps that were made", cause=cause)


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit", read=WATCHED)
def test_a_speed_equal_to_the_limit_is_allowed() -> None:
    for limit, speed, wanted, scene, cause in (
        (7.0, 7.0, None,
         "; the particle has the velocity (2, 3, 6) m/s, so its speed is 7 m/s",
         "You raise an error for a speed equal to the limit, which is still allowed. Write `not "
         "speed <= speed_limit`."),
        (1.0, 2.0, (0.0, 1.0),
         "; the particle moves at 2 m/s after the first step",
         "A limit of 1 m/s is valid, so watch the integrator as usual. Check the speeds after each "
         "step, whatever the limit is."),
    ):  # fmt: skip
        with calls(cause, CALL.format(limit) + scene):
            _, error = watching(limit, [[speed]])
        expect_told(error, wanted, cause)


@pytest.mark.exercise("B6.10", asks="whose speed is NaN or above speed_limit", read=WATCHED)
@pytest.mark.robust
def test_a_speed_of_nan_is_above_every_limit() -> None:
    cause = "Every comparison with NaN is False, so `speed > speed_limit` does not detect NaN. "
    cause += "Write `not speed <= speed_limit` instead."
    for speed, what in ((math.nan, "NaN"), (math.inf, "infinity"), (-math.inf, "-infinity")):
        with calls(
            cause,
            f"{CALL.format(1e300)}, three times; the velocity of particles[1] has {what} along y "
            "after step 2",
        ):
            _, error = watching(1e300, [[1.0, 1.0], [1.0, speed], [1.0, 1.0]])
        expect_told(error, (1, 2), cause)


@pytest.mark.exercise("B6.10", asks="after which the particle was too fast", read=WATCHED)
def test_an_explosion_is_reported_with_its_step(rng: Random) -> None:
    # The first speed over 480 m/s is on the way back, that over the smaller limit is not.
    for limit in (positive_number(rng, 130.0, 470.0), positive_number(rng, 490.0, 950.0)):
        with calls(
            "The step or the speed is wrong. Check the speeds after each step, not before it.",
            f"{CALL.format(limit)} with explicit Euler, a spring of 3600 N/m, 1 kg and h = 1/60 s, "
            "released 1 m away; the step, the speed in m/s and the limit in m/s of the error",
        ):
            got = exploding(limit)
        number, v, x = 0, 0.0, 1.0
        while abs(v) <= limit:
            x, v = x + v / 60.0, v - 60.0 * x
            number += 1
        expect_close(got, (float(number), abs(v), limit), tolerance=1e-9)


@pytest.mark.exercise("B6.10", asks="It counts its own steps", read=WATCHED)
def test_two_watched_integrators_count_separately() -> None:
    for limit, speed, wanted, scene, cause in (
        (5.0, 9.0, (0, 1),
         "two integrators made by watched(integrator, speed_limit=5.0), used one after the other; "
         "a particle of the second one is too fast after its first step",
         "Each watched integrator must count its own steps. Keep the count in a variable inside "
         "watched, because both integrators would share a variable of the module."),
        (9.0, 7.0, None,
         "watched(integrator, speed_limit=5.0) and then watched(integrator, speed_limit=9.0); a "
         "step of the second one, after which a particle moves at 7 m/s",
         "The second integrator allows 9 m/s, and the limit of 5 m/s belongs to the first one. Use "
         "the speed_limit from the same call of watched."),
    ):  # fmt: skip
        with calls(cause, scene):
            watching(5.0, [[1.0]] * 3)
            _, error = watching(limit, [[speed]])
        expect_told(error, wanted, cause)


@pytest.mark.exercise(
    "B6.10", asks="It can be called again after that, and goes on counting.", read=WATCHED
)
def test_watched_goes_on_after_an_error(rng: Random) -> None:
    # Half of the limit is above its square root, so that a squared speed is noticed.
    limit = positive_number(rng, 5.0, 90.0)
    with calls(
        "Let exceptions of the integrator pass, without counting that step, and then count on.",
        f"{CALL.format(limit)}; the first step raises ValueError, and after the third and the "
        "fifth a particle is too fast; the step number in each error, or -1 for the ValueError",
    ):
        got = watching_on(limit)
    caught = "You catch the exception of the integrator, so the caller never learns about it"
    slips = {
        "You count the step in which the integrator raised an exception. Count a step only after "
        "the call of the integrator.": (-1.0, 3.0, 5.0),
        "You count from the start again after a SimulationDiverged.": (-1, 2, 2),
        "After a SimulationDiverged, your step no longer checks the speeds.": (-1.0, 2.0),
        f"{caught}.": (3.0, 5.0),
        f"{caught}, but you don't count its step.": (2.0, 4.0),
    }
    expect_close(got, (-1.0, 2.0, 4.0), slips)
