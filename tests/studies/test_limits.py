"""Limits of springs (ch06_springs) agree with theory on both sides, and energies with a matrix."""

from __future__ import annotations

import csv
import math
import re
from pathlib import Path

import pytest
from matplotlib import pyplot
from matplotlib.figure import Figure

from studies import limits
from studies.limits import maps, search
from studies.limits.search import energy_drifts

SPRINGS = {
    ("explicit Euler", "d^h = 1"): 0.0,
    ("explicit Euler", "d^h = 0.5"): 1.0,
    **{
        (name, f"d^h = {kept}"): limit
        for name in ("semi-implicit Euler", "leapfrog")
        for kept, limit in (("1", 4.0), ("0.5", 6.0))
    },
    ("velocity Verlet", "d^h = 0.9"): 4.0,
    ("Runge-Kutta 4", "d^h = 1"): 8.0,
    ("pymunk's spring", "c h / m = 0.5"): 2.0 * (1.0 + math.exp(0.5)),
    ("pymunk, by hand", "c h / m = 0.5"): 0.5,
    ("backward Euler", "c h / m = 0"): math.inf,
    ("trapezoidal rule", "c h / m = 0"): math.inf,
    ("faked stiff spring", "undamped"): math.pi**2,
}
# For a speed under drag: the limit of growth, and the limit of reversal.
DRAGS = {
    "explicit Euler": (2.0, 1.0),
    "semi-implicit Euler": (2.0, 1.0),
    "leapfrog": (2.0, 1.0),
    "velocity Verlet": (2.0, math.inf),
    "Runge-Kutta 4": (2.785293563405282, math.inf),  # z^3 - 4 z^2 + 12 z = 24
    "backward Euler": (math.inf, math.inf),
    "trapezoidal rule": (math.inf, 2.0),
    "pymunk, by hand": (2.0, 1.0),
    "pymunk's spring": (math.inf, math.inf),
    "pymunk's space.damping": (math.inf, math.inf),
}

# The limit in each panel of the map at a damping of 0.5. The solvers have no limit.
AT_HALF = (1.0, 6.0, 6.0, 4.0, 8.8351743, None, None, 2.0 * (1.0 + math.exp(0.5)), 0.5)


def test_limits_of_springs_are_found_within_a_millionth_of_theory() -> None:
    springs = {row[:2]: row for row in search.spring_limits()}
    assert len(springs) == 5 * 3 + 2 * 2 + 2 + 2
    for key, wanted in SPRINGS.items():
        # Bisection reaches 1e-14, but explicit Euler grows only with the root of the excess.
        found = springs[key].found, springs[key].theory
        assert found == pytest.approx((wanted, wanted), rel=1e-6)
    for name in ("semi-implicit Euler", "leapfrog", "velocity Verlet", "Runge-Kutta 4"):
        assert 41 <= springs[name, "d^h = 1"].steps <= 199  # known, at 1.02 times the limit
    # In 2000 steps, growth by e^(ln 1e6 / 2000) = 1 + 2 sqrt(kappa / 4 - 1) per step is visible.
    assert springs["penalty ground", "at rest"].found == pytest.approx(4.0, rel=2e-5)
    assert 41 <= springs["penalty ground", "at rest"].steps <= 199


def test_limits_of_drag_are_those_of_theory() -> None:
    found = {row[:2]: row[2:4] for row in search.drag_limits()}
    assert len(found) == 2 * len(DRAGS)
    for name, known in DRAGS.items():
        for at, wanted in zip(("growth", "reversal"), known, strict=True):
            assert found[name, at] == pytest.approx((wanted, wanted), rel=1e-9)


@pytest.mark.parametrize(
    ("name", "damping", "share"),
    [
        ("semi-implicit Euler", 1.0, 5.39),
        ("leapfrog", 1.0, 3.571),
        ("velocity Verlet", 1.0, 0.505),
        ("pymunk's spring", 0.0, 4.68),
    ],
)
def test_a_simulation_is_lost_when_the_eigenvalue_says(
    name: str, damping: float, share: float
) -> None:
    # At 1.02 times 4, the eigenvalues -r and -1 / r add up to the trace, 2 - 4.08. The position
    # from rest is A (-r)^n + B (-1 / r)^n with A + B = 1. The first position after it gives A,
    # which is -3.08, -1.04 (for leapfrog and Verlet) or 1. ``share`` is A times the size of the
    # eigenvector of -r, whose position is 1.
    rate = math.log(1.04 + math.sqrt(1.04**2 - 1.0))
    predicted = math.log(1e6) / rate
    rest, evenly = maps.steps_to_loss(name, damping, 4.08, predicted)
    # The number of steps is a whole number.
    assert evenly == pytest.approx(predicted, abs=1.0)
    assert predicted <= rest + math.log(share) / rate <= predicted + 1.01


def test_energies_after_many_swings_are_those_of_theory() -> None:
    drifts = energy_drifts([1, 100, 10_000])
    kappa = search.STIFFNESS * search.FRAME**2
    for place, swings in enumerate((1, 100, 10_000)):
        steps = swings * 2.0 * math.pi / math.sqrt(kappa)
        # The fourth-order series of e^(i x) has the squared size 1 - x^6 / 72 + x^8 / 576.
        kept = math.exp(steps * math.log1p(-(kappa**3) / 72.0 + kappa**4 / 576.0))
        assert drifts["Runge-Kutta 4"][place] == pytest.approx(kept, rel=1e-3)
        steady = ("semi-implicit Euler", "leapfrog", "velocity Verlet", "trapezoidal rule")
        for name in (*steady, "pymunk's spring"):
            # These conserve a quadratic form close to the energy. The mean is over 38 steps, but an
            # oscillation has 37.7.
            assert drifts[name][place] == pytest.approx(1.0, abs=2e-3)
    # Each step divides the energy by 1 + kappa, and 38 steps are an oscillation.
    assert drifts["backward Euler"][0] == pytest.approx((1.0 + kappa) ** -38, rel=1e-9)
    assert drifts["backward Euler"][-1] < 1e-300
    assert "explicit Euler" not in drifts


def test_the_command_prints_writes_draws_and_fails_where_a_limit_is_off_its_theory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two wrong theories are 4 % and 6 % off, and the second is too much."""
    monkeypatch.setitem(search.DRAG_THEORY, "leapfrog", (2.0, 0.96))
    monkeypatch.setitem(search.DRAG_THEORY, "velocity Verlet", (1.88, math.inf))
    monkeypatch.setattr(limits, "SWINGS", [1, 10])
    monkeypatch.setattr(maps, "BEYOND", (0.02, 0.1))
    figures: list[Figure] = []
    monkeypatch.setattr(maps, "KAPPAS", maps.KAPPAS[::8])
    monkeypatch.setattr(pyplot, "close", figures.append)
    assert limits.main(["--out", str(tmp_path / "limits.csv")]) == 1
    told = capsys.readouterr().out
    assert re.findall("(?m)^differs from theory .*: (.*)$", told) == ["velocity Verlet, growth"]
    assert "Runge-Kutta 4" in told
    assert "over 1e6" in told
    with (tmp_path / "limits.csv").open(encoding="utf-8") as file:
        rows = [*csv.reader(file)]
    assert rows[0] == ["method", "case", "limit of k h^2 / m", "theory", "steps to x 1e6"]
    assert len(rows) == (1 + 23) + (1 + 20) + (1 + 7) + (1 + 7 * 2)
    drag = [row for row in rows if row[:2] == ["trapezoidal rule", "reversal"]]
    assert [float(cell) for cell in drag[0][2:4]] == pytest.approx([2.0, 2.0])
    grown, curves = figures
    assert (tmp_path / "limits.png").exists()
    assert (tmp_path / "limits_divergence.png").exists()
    for axes, wanted in zip(grown.axes, AT_HALF, strict=False):
        assert len(axes.collections) == 1, "a map of colors"
        if wanted is None:
            assert not axes.lines
            continue
        theory, dots = axes.lines
        found = dict(zip(dots.get_ydata(), dots.get_xdata(), strict=True))
        assert found[0.5] == pytest.approx(wanted, rel=1e-6)
        near = min(theory.get_xydata(), key=lambda point: abs(point[1] - 0.5))
        assert near[0] == pytest.approx(wanted, rel=0.01)  # the curve has 1000 points
    # Seven methods with two lines each; the same and a line at 0; seven methods and a theory.
    assert [len(axes.lines) for axes in curves.axes] == [14, 15, 8]
