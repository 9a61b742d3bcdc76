"""The cost of every unnecessary part of a model is measured and printed."""

from __future__ import annotations

import re

import pytest

from studies import economy


def test_each_feature_has_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(economy, "ROUNDS", 3)
    monkeypatch.setattr(economy, "FRAMES", 1)
    assert economy.main([]) == 0
    _, *lines = capsys.readouterr().out.splitlines()
    found = [re.match(r"([\d.,]+) \(([\d.,]+) to ([\d.,]+)\) +(\S.*)", line) for line in lines]
    rows = [match for match in found if match]  # a long line goes on in the next
    assert len(rows) == 9
    for row in rows:
        low, middle, high = (float(row[i].replace(",", "")) for i in (2, 1, 3))
        assert 0.0 < low <= middle <= high
    assert {"gravity as a force generator", "a registry for it"} < {row[4] for row in rows}


@pytest.mark.parametrize("dimensions", [2, 3])
def test_plain_particles_move_as_they_would(dimensions: int) -> None:
    """A third coordinate adds one more position to move and changes nothing else."""
    move = economy.plain(dimensions)
    places = [cell.cell_contents for cell in move.__closure__ or ()]
    move()
    moved = [values[0] for values in places if values[0] != 1.0]
    # Positions change by v h with v = 1, and the vertical velocity changes by -g h.
    wanted = [1.0 + economy.FRAME] * dimensions + [1.0 - 9.81 * economy.FRAME]
    assert sorted(moved) == pytest.approx(sorted(wanted))
