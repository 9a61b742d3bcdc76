"""Where the steps of build tasks B6.6 to B6.8 lead: energy, and the limits of stability."""

from __future__ import annotations

import math

import pytest

from calls import calls
from ch06_springs.step_probes import Body, energy_left, growth, stepped
from expect import expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
EXERCISES = {
    "explicit_euler": "B6.6",
    "semi_implicit_euler": "B6.6",
    "leapfrog": "B6.12",
    "velocity_verlet": "B6.7",
    "runge_kutta_4": "B6.8",
}
LIMITS = {  # of k h^2 / m
    "semi_implicit_euler": 4.0,
    "leapfrog": 4.0,
    "velocity_verlet": 4.0,
    "runge_kutta_4": 8.0,
}
H = 1.0 / 60.0
KAPPA = 100.0 * H**2  # k h^2 / m of the spring whose energy is measured


def methods(*names: str, asks: str) -> pytest.MarkDecorator:
    """Run a check for some integrators, each as a check of its exercise."""
    marks = {
        name: pytest.mark.exercise(EXERCISES[name], asks=asks, read=f"the docstring of {name}")
        for name in names
    }
    return pytest.mark.parametrize("method", [pytest.param(n, marks=marks[n]) for n in names])


def expect_energy(method: str, frames: int, wanted: float, tolerance: float, cause: str) -> None:
    """Expect the energy of a spring after some steps, divided by that at the start."""
    with calls(
        cause,
        f"{method}([p], apply_forces, h) {frames} times, with p of 1 kg on a spring of 100 N/m, "
        "from rest at 1 m, and h = 1/60 s; the final energy divided by the initial energy",
    ):
        got = energy_left(method, 100.0, H, frames)
    expect_close(got, wanted, tolerance=tolerance)


@pytest.mark.exercise(
    "B6.6",
    asks="every step multiplies the energy by the same factor",
    read="the docstring of explicit_euler, and E-17",
)
def test_explicit_euler_gains_energy_by_its_factor() -> None:
    wanted = (1.0 + KAPPA) ** 600
    cause = "With explicit Euler, each step multiplies the energy of this spring by 1 + k h^2 / m. "
    cause += "Move the particle with its old velocity, before you change the velocity."
    # 600 steps of a few roundings each.
    expect_energy("explicit_euler", 600, wanted, 1e-11 * wanted, cause)


@pytest.mark.exercise(
    "B6.6",
    asks="its energy never drifts as long as the spring",
    read="the docstring of semi_implicit_euler",
)
def test_semi_implicit_euler_keeps_energy_near_its_start() -> None:
    cause = "The energy may vary by a fraction of about chi h / 2 with chi = sqrt(k / m), but it "
    cause += "must not drift. Change the velocity first, and then move with the new velocity."
    for frames in (600, 6000):
        # chi h / 2 is 1/12; its square comes on top.
        expect_energy("semi_implicit_euler", frames, 1.0, 0.1, cause)
    cause = "The particle starts at rest at 1 m. One step must give it the velocity -k h / m and "
    cause += "then, with this new velocity, the position 1 - k h^2 / m."
    expect_energy("semi_implicit_euler", 1, (1.0 - KAPPA) ** 2 + KAPPA, 1e-12, cause)


@pytest.mark.exercise(
    "B6.12", asks="keeps the energy within a narrower band", read="the docstring of leapfrog"
)
def test_leapfrog_swings_as_its_frequency_says() -> None:
    cause = "Leapfrog oscillates slightly too fast, but its energy keeps returning to the initial "
    cause += "value. Check the order: drift for h / 2, kick for h, drift for h / 2."
    for frames in (1, 600, 6000):
        angle = frames * 2.0 * math.asin(0.5 * math.sqrt(KAPPA))
        # From rest x is cos(n w h), and v / chi is -sin(n w h) / sqrt(1 - kappa / 4).
        wanted = math.cos(angle) ** 2 + math.sin(angle) ** 2 / (1.0 - KAPPA / 4.0)
        # Each step has a few roundings; the angle gathers those of all of them.
        expect_energy("leapfrog", frames, wanted, 1e-9, cause)


@pytest.mark.exercise(
    "B6.6",
    asks="undamped springs below max_stable_stiffness are stable",
    read="the docstring of explicit_euler and of max_stable_stiffness",
)
def test_damping_saves_explicit_euler_up_to_a_stiffness() -> None:
    keep = 0.5**H
    for share in (0.98, 1.02):
        k = share * (1.0 / keep - 1.0) / H**2
        with calls(
            "Each step multiplies the amplitude of the oscillation by the square root of d^h (1 + "
            "k h^2 / m). Damp the velocity by d^h once per step, and move the particle with the "
            "old velocity.",
            f"explicit_euler([p], apply_forces, h) with p of 1 kg and damping d = 0.5 on a spring "
            f"of {k:.4f} N/m, and h = 1/60 s; the largest distance in steps 1500 to 2000, divided "
            "by that in steps 0 to 500",
        ):
            near = growth("explicit_euler", k, 0.5, H, 500)
            far = growth("explicit_euler", k, 0.5, H, 2000, since=1500)
        # The farthest of a swing lies between frames, at most 0.2 % farther, and is up to half a
        # swing of 58 frames from where the 500 begin or end, in which it changes by 0.4 %.
        expect_close(far / near, (keep * (1.0 + k * H * H)) ** 750, tolerance=0.01)


@methods("explicit_euler", *LIMITS, asks="says how quickly its error shrinks")
def test_the_order_of_a_step(method: str) -> None:
    body: Body = ((1.0, 0.0, 0.5), (0.0, 1.0, 0.0), ZERO, 1.0, 1.0, ZERO)
    order = {"leapfrog": 2, "velocity_verlet": 2, "runge_kutta_4": 4}.get(method, 1)
    for what, forces in (("", (1.0, 0.0, 1.0)), (" - v / 2", (1.0, 0.5, 1.0))):
        if method == "leapfrog" and what:
            order = 1  # it asks with the old velocity for forces that depend on it
        with calls(
            f"The error of this method must be smaller by a factor of {2**order} if the time step "
            "is halved. Perhaps you evaluate a force at the wrong time, or move the particle with "
            "the wrong velocity.",
            f"{method}(particles, apply_forces, h); forces -(1 + r^2) x{what} for 1 s, in 80, 160 "
            "and 320 steps; log2 of the ratio of the differences between the final positions, "
            "which is the order of the method",
        ):
            ends = [
                stepped(method, [body], forces, 1 / n, n)["positions"][0] for n in (80, 160, 320)
            ]
        long, short = math.dist(ends[0], ends[1]), math.dist(ends[1], ends[2])
        # The next order adds some h to it: 0.01 at most here.
        got = math.log2(long / short) if short > 0.0 else math.nan
        expect_close(got, float(order), tolerance=0.1)


@methods(*LIMITS, asks="stable if k h² / m is below")
def test_a_step_fails_just_beyond_its_limit_and_not_before(method: str) -> None:
    limit = LIMITS[method]
    for share in (0.98, 1.02):
        k = share * limit / H**2
        with calls(
            f"{method} is stable as long as k h^2 / m is below {limit:g}, and here it is "
            f"{share * limit:g}. Your step behaves differently, so compare it with the formulas in "
            "the docstring.",
            f"{method}([p], apply_forces, h) 500 times, with p of 1 kg on a spring of {k:.6g} N/m, "
            "released 1 m away, and h = 1/60 s",
        ):
            far = growth(method, k, 1.0, H, 500)
        expect_exactly(far < 100.0, share < 1.0, then="; the largest distance is below 100 m")
        expect_exactly(far > 1e6, share > 1.0, then="; the largest distance is above 1e6 m")
