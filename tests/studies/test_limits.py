"""Limits are those of theory, on both sides of them; energies are those of the step's matrix."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pytest

from studies import limits
from studies.stability import growth_of


def test_limits_are_found_within_a_millionth_of_theory() -> None:
    bounds = {(name, kept): (found, true) for name, kept, found, true, _ in limits.spring_limits()}
    known = {
        ("explicit Euler", 1.0): 0.0,
        ("explicit Euler", 0.5): 1.0,
        ("semi-implicit Euler", 1.0): 4.0,
        ("semi-implicit Euler", 0.5): 6.0,
        ("velocity Verlet", 0.9): 4.0,
        ("Runge-Kutta 4", 1.0): 8.0,
        ("pymunk's spring", 1.0): 4.0,
        ("pymunk, by hand", 1.0): 0.0,
    }
    for key, wanted in known.items():
        # Bisection to 1e-14; explicit Euler's growth begins with the root of what it is beyond.
        assert bounds[key] == pytest.approx((wanted, wanted), rel=1e-6)


@pytest.mark.parametrize("name", ["semi-implicit Euler", "velocity Verlet", "Runge-Kutta 4"])
def test_just_inside_nothing_grows_and_just_outside_it_does(name: str) -> None:
    wanted = 8.0 if name == "Runge-Kutta 4" else 4.0
    assert growth_of(name, 0.98 * wanted, 1.0, limits.FRAME) <= 1.0 + 1e-13
    assert growth_of(name, 1.02 * wanted, 1.0, limits.FRAME) > 1.01
    ((steps,),) = [row[4:] for row in limits.spring_limits() if row[:2] == (name, 1.0)]
    assert 41 <= steps <= 199


def test_energies_after_many_swings_are_those_of_theory() -> None:
    drifts = dict(limits.energy_drifts())
    kappa = limits.STIFFNESS * limits.FRAME**2
    steps = 10_000 * 2.0 * math.pi / math.sqrt(kappa)
    # The fourth order's series of e^(i x) is 1 - x^6 / 72 + x^8 / 576 in size, squared.
    kept = math.exp(steps * math.log1p(-(kappa**3) / 72.0 + kappa**4 / 576.0))
    assert drifts["Runge-Kutta 4"] == pytest.approx(kept, rel=1e-3)
    for name in ("semi-implicit Euler", "velocity Verlet", "trapezoidal rule", "pymunk's spring"):
        # They keep a quadratic form near the energy; the mean is over 38 steps of 37.7 a swing.
        assert drifts[name] == pytest.approx(1.0, abs=2e-3)
    assert drifts["backward Euler"] < 1e-300
    assert "explicit Euler" not in drifts


def test_the_command_prints_and_writes_the_table(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(limits, "PERIODS", 10)
    assert limits.main(["--out", str(tmp_path / "limits.csv")]) == 0
    assert "Runge-Kutta 4" in capsys.readouterr().out
    with (tmp_path / "limits.csv").open(encoding="utf-8") as file:
        rows = [*csv.reader(file)]
    assert rows[0][:3] == ["method", "kept of v", "limit of k h^2 / m"]
    assert len(rows) == 1 + 14 + 1 + 6
    monkeypatch.setattr(limits, "spring_limits", lambda: [("a", 1.0, 3.7, 4.0, 9.0)])
    assert limits.main(["--out", str(tmp_path / "limits.csv")]) == 1
