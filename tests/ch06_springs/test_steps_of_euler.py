"""Where the two Euler steps lead, build task B6.6."""

from __future__ import annotations

import pytest

from ch06_springs.step_probes import energy_left, growth
from expect import expect_close


@pytest.mark.exercise("B6.6")
def test_explicit_euler_gains_energy_by_its_factor() -> None:
    read = "the docstring of explicit_euler, and E-17"
    call = (
        "explicit_euler([p], apply_forces, h) with a spring of 100 N/m, 1 kg, h = 1/60, 600 steps"
    )
    call += ": energy after / before"
    cause = (
        "each step multiplies the energy by 1 + k h^2 / m: the position moves by the old velocity"
    )
    wanted = (1.0 + 100.0 / 3600.0) ** 600
    got = energy_left("explicit_euler", 100.0, 1.0 / 60.0, 600)
    # 600 steps of a few roundings each.
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-11 * wanted)


@pytest.mark.exercise("B6.6")
def test_semi_implicit_euler_keeps_energy_near_its_start() -> None:
    read = "the docstring of semi_implicit_euler"
    cause = "x^2 + v^2 / chi^2 - h x v stays: the energy swings by chi h / 2 of itself, and no more"
    for frames in (600, 6000):
        call = (
            "semi_implicit_euler([p], apply_forces, h) with a spring of 100 N/m, 1 kg, h = 1/60, "
        )
        call += f"{frames} steps: energy after / before"
        got = energy_left("semi_implicit_euler", 100.0, 1.0 / 60.0, frames)
        # chi h / 2 is 1/12; its square comes on top.
        expect_close(call, got, 1.0, cause=cause, read=read, tolerance=0.1)
    call = "semi_implicit_euler([p], apply_forces, h) with the same spring, 1 step: energy"
    cause = "from rest at 1 m the step goes to 1 - k h^2 / m, with the velocity -k h / m"
    kappa = 100.0 / 3600.0
    wanted = (1.0 - kappa) ** 2 + kappa
    got = energy_left("semi_implicit_euler", 100.0, 1.0 / 60.0, 1)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B6.6")
def test_damping_saves_explicit_euler_up_to_a_stiffness() -> None:
    read = "the docstring of explicit_euler and of max_stable_stiffness"
    h, d, frames = 1.0 / 60.0, 0.5, 2000
    keep = d**h
    limit = (1.0 / keep - 1.0) / h**2
    for share in (0.98, 1.02):
        k = share * limit
        call = f"explicit_euler([p], apply_forces, h) with a spring of {k:.4f} N/m, 1 kg, d = 0.5, "
        call += "h = 1/60: the farthest in frames 1500 to 2000, over that in frames 0 to 500"
        cause = "a step multiplies the size of a swing by the root of d^h (1 + k h^2 / m)"
        wanted = (keep * (1.0 + k * h * h)) ** 750
        near = growth("explicit_euler", k, d, h, 500)
        far = growth("explicit_euler", k, d, h, frames, since=1500)
        # The farthest of a swing lies between frames, at most 0.2 % farther, and is up to half a
        # swing of 58 frames from where the 500 begin or end, in which it changes by 0.4 %.
        expect_close(call, far / near, wanted, cause=cause, read=read, tolerance=0.01)
