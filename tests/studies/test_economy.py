"""The cost of every unnecessary part of a model is measured, printed, written and drawn."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from studies import economy


def test_each_part_has_a_bar_and_a_row(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(economy, "ROUNDS", 3)
    monkeypatch.setattr(economy, "FRAMES", 1)
    assert economy.main(["--out", str(tmp_path / "economy.png")]) == 0
    with (tmp_path / "economy.csv").open(encoding="utf-8") as file:
        heading, *rows = csv.reader(file)
    assert heading == ["part", "ratio", "lower", "upper"]
    told = capsys.readouterr().out
    for what, middle, low, high in rows:
        assert what in told
        assert 0.0 < float(low) <= float(middle) <= float(high)
    assert {"gravity as a force generator", "a registry for it"} < {row[0] for row in rows}
    assert len(rows) == 9
    assert (tmp_path / "economy.png").stat().st_size > 20_000


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
