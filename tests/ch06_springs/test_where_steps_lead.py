"""Where the steps of build tasks B6.6 to B6.8 lead: energy, and the limits of stability."""

from __future__ import annotations

import math

import pytest

from ch06_springs.step_probes import Body, energy_left, growth, stepped
from expect import about, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)


@pytest.mark.exercise("B6.6")
def test_explicit_euler_gains_energy_by_its_factor() -> None:
    about.read = "the docstring of explicit_euler, and E-17"
    about.call = "explicit_euler([p], apply_forces, h) with a spring of 100 N/m, 1 kg, h = 1/60, "
    about.call += "600 steps: the final energy / the initial energy"
    about.cause = (
        "With explicit Euler, each step multiplies the energy of this spring by 1 + k h^2 / m, "
        "because the particle moves with its old velocity. Check that you move the particle before "
        "you change its velocity."
    )
    wanted = (1.0 + 100.0 / 3600.0) ** 600
    got = energy_left("explicit_euler", 100.0, 1.0 / 60.0, 600)
    # 600 steps of a few roundings each.
    expect_close(got, wanted, tolerance=1e-11 * wanted)


@pytest.mark.exercise("B6.6")
def test_semi_implicit_euler_keeps_energy_near_its_start() -> None:
    about.read = "the docstring of semi_implicit_euler"
    about.cause = (
        "x^2 + v^2 / chi^2 - h x v should stay constant, so the energy may vary by at most a "
        "fraction of about chi h / 2. Check that you change the velocity first and then move with "
        "the new velocity."
    )
    for frames in (600, 6000):
        about.call = "semi_implicit_euler([p], apply_forces, h) with a spring of 100 N/m, 1 kg, h "
        about.call += f"= 1/60, {frames} steps: the final energy / the initial energy"
        got = energy_left("semi_implicit_euler", 100.0, 1.0 / 60.0, frames)
        # chi h / 2 is 1/12; its square comes on top.
        expect_close(got, 1.0, tolerance=0.1)
    about.call = (
        "semi_implicit_euler([p], apply_forces, h) with the same spring, 1 step: the final "
        "energy / the initial energy"
    )
    about.cause = (
        "The particle starts at rest at 1 m, so one step should lead to the velocity -k h / m and, "
        "with that new velocity, to the position 1 - k h^2 / m. Compare your first step with these "
        "values."
    )
    kappa = 100.0 / 3600.0
    wanted = (1.0 - kappa) ** 2 + kappa
    got = energy_left("semi_implicit_euler", 100.0, 1.0 / 60.0, 1)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B6.6b")
def test_leapfrog_swings_as_its_frequency_says() -> None:
    about.read = "the docstring of leapfrog"
    about.cause = (
        "Leapfrog oscillates slightly too fast, at a frequency w with cos(w h) = 1 - k h^2 / (2 "
        "m), but its energy keeps returning to the initial value. Check the order: half drift, "
        "kick, half drift."
    )
    h, k = 1.0 / 60.0, 100.0
    kappa = k * h * h
    for frames in (1, 600, 6000):
        about.call = "leapfrog([p], apply_forces, h) with a spring of 100 N/m, 1 kg, h = 1/60, "
        about.call += f"from rest at 1 m, {frames} steps: the final energy / the initial energy"
        angle = frames * 2.0 * math.asin(0.5 * math.sqrt(kappa))
        # From rest x is cos(n w h), and v / chi is -sin(n w h) / sqrt(1 - kappa / 4).
        wanted = math.cos(angle) ** 2 + math.sin(angle) ** 2 / (1.0 - kappa / 4.0)
        got = energy_left("leapfrog", k, h, frames)
        # Each step has a few roundings; the angle gathers those of all of them.
        expect_close(got, wanted, tolerance=1e-9)


@pytest.mark.exercise("B6.6")
def test_damping_saves_explicit_euler_up_to_a_stiffness() -> None:
    about.read = "the docstring of explicit_euler and of max_stable_stiffness"
    h, d, frames = 1.0 / 60.0, 0.5, 2000
    keep = d**h
    limit = (1.0 / keep - 1.0) / h**2
    for share in (0.98, 1.02):
        k = share * limit
        about.call = f"explicit_euler([p], apply_forces, h) with a spring of {k:.4f} N/m, 1 kg, d "
        about.call += "= 0.5, h = 1/60: the largest distance in frames 1500 to 2000, divided by "
        about.call += "that in frames 0 to 500"
        about.cause = (
            "Each step multiplies the amplitude of the oscillation by the square root of d^h (1 "
            "+ k h^2 / m). Check that you damp the velocity by d^h once per step, and that you "
            "move the particle with the old velocity."
        )
        wanted = (keep * (1.0 + k * h * h)) ** 750
        near = growth("explicit_euler", k, d, h, 500)
        far = growth("explicit_euler", k, d, h, frames, since=1500)
        # The farthest of a swing lies between frames, at most 0.2 % farther, and is up to half a
        # swing of 58 frames from where the 500 begin or end, in which it changes by 0.4 %.
        expect_close(far / near, wanted, tolerance=0.01)


@pytest.mark.parametrize(
    "method",
    [
        pytest.param("explicit_euler", marks=pytest.mark.exercise("B6.6")),
        pytest.param("semi_implicit_euler", marks=pytest.mark.exercise("B6.6")),
        pytest.param("leapfrog", marks=pytest.mark.exercise("B6.6b")),
        pytest.param("velocity_verlet", marks=pytest.mark.exercise("B6.7")),
        pytest.param("runge_kutta_4", marks=pytest.mark.exercise("B6.8")),
    ],
)
def test_the_order_of_a_step(method: str) -> None:
    about.read = f"the docstring of {method}"
    body: Body = ((1.0, 0.0, 0.5), (0.0, 1.0, 0.0), ZERO, 1.0, 1.0, ZERO)
    order = {"leapfrog": 2, "velocity_verlet": 2, "runge_kutta_4": 4}.get(method, 1)
    for what, forces in (
        ("forces -(1 + r^2) x", (1.0, 0.0, 1.0)),
        ("forces -(1 + r^2) x - v / 2", (1.0, 0.5, 1.0)),
    ):
        if method == "leapfrog" and forces[1]:
            order = 1  # it asks with the old velocity for forces that depend on it
        about.cause = (
            f"This method is of order {order}, so halving the step should reduce the error to "
            f"{0.5**order:g} of what it was. Perhaps you evaluate a force at the wrong time, or "
            "move the particle with the wrong velocity."
        )
        about.call = f"{method}(particles, apply_forces, h); {what} for 1 s, in 80, 160 and "
        about.call += "320 steps"
        ends = [stepped(method, [body], forces, 1.0 / n, n)["positions"][0] for n in (80, 160, 320)]
        long, short = math.dist(ends[0], ends[1]), math.dist(ends[1], ends[2])
        # The next order adds some h to it: 0.01 at most here.
        got = math.log2(long / short) if short > 0.0 else math.nan
        expect_close(
            got,
            float(order),
            then=": log2 of the ratio of the differences between the final positions",
            tolerance=0.1,
        )


@pytest.mark.parametrize(
    ("method", "limit"),
    [
        pytest.param("semi_implicit_euler", 4.0, marks=pytest.mark.exercise("B6.6")),
        pytest.param("leapfrog", 4.0, marks=pytest.mark.exercise("B6.6b")),
        pytest.param("velocity_verlet", 4.0, marks=pytest.mark.exercise("B6.7")),
        pytest.param("runge_kutta_4", 8.0, marks=pytest.mark.exercise("B6.8")),
    ],
)
def test_a_step_fails_just_beyond_its_limit_and_not_before(method: str, limit: float) -> None:
    about.read = f"the docstring of {method}"
    h = 1.0 / 60.0
    frames = 500
    for share in (0.98, 1.02):
        k = share * limit / h**2
        about.call = f"{method}(particles, apply_forces, h) with a spring of {k} N/m, 1 kg, h = "
        about.call += f"1/60, from 1 m, {frames} steps"
        about.cause = (
            f"The method is stable as long as k h^2 / m is below {limit:g}, and here it is "
            f"{share * limit:g}. If your step behaves differently, compare it with the formulas in "
            "the docstring."
        )
        far = growth(method, k, 1.0, h, frames)
        expect_exactly(far < 100.0, share < 1.0, then=": the largest distance is below 100 m")
        expect_exactly(far > 1e6, share > 1.0, then=": the largest distance is above 1e6 m")
