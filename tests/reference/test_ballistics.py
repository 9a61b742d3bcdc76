"""A shell's flight time and range converge to the known figures, with order 1."""

from __future__ import annotations

from dataclasses import replace

import pytest

from ch04_particle_engine.ballistics import SHOT_TYPES, BallisticRange


@pytest.mark.parametrize(
    ("damping", "time", "reach"), [(1.0, 3.0491933, 121.96773), (0.99, 3.0347583, 119.557788)]
)
def test_flight_time_and_range_reach_the_known_figures(
    monkeypatch: pytest.MonkeyPatch, damping: float, time: float, reach: float
) -> None:
    shell = replace(SHOT_TYPES["artillery"], damping=damping)
    monkeypatch.setitem(SHOT_TYPES, "artillery", shell)
    landings = []
    for h in (1.0 / 1000.0, 1.0 / 2000.0):
        at = BallisticRange()
        at.fire("artillery")
        p = at.shots[0].particle
        now = 0.0
        while at.shots:
            before = (now, p.position.y, p.position.z)
            at.update(h)
            now += h
        share = before[1] / (before[1] - p.position.y)
        landings.append((before[0] + share * h, before[2] + share * (p.position.z - before[2])))
    coarse, fine = landings
    # With order 1, twice the finer result minus the coarser one has an error of h^2: 1e-6 of 120.
    assert 2.0 * fine[0] - coarse[0] == pytest.approx(time, abs=2e-6)
    assert 2.0 * fine[1] - coarse[1] == pytest.approx(reach, abs=1e-4)
