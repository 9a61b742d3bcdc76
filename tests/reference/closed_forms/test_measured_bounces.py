"""The file of measured drops in chapter 7."""

from __future__ import annotations

from pathlib import Path

import pytest

from ch07_constraints.drops import find_drops, read_drops
from ch07_constraints.exercises import table_of_drops

HEADING = "material,initial_height,bounce_height\n"


def test_drops_are_read_in_their_order(tmp_path: Path) -> None:
    path = tmp_path / "drops.csv"
    text = HEADING + "rubber ball,1.5,0.9\r\n\n,,\n" + '"a, b",2,1e-1\n'
    path.write_text("\ufeff" + text, encoding="utf-8")  # spreadsheets write this mark first
    assert read_drops(path) == [("rubber ball", 1.5, 0.9), ("a, b", 2.0, 0.1)]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", 1),
        ("material,height\n", 1),
        (HEADING + "steel,1.0\n", 2),
        (HEADING + "steel,1.0,0.5,0.4\n", 2),
        (HEADING + "steel,1.0,0.5\n,1.0,0.5\n", 3),
        (HEADING + "steel,1.0,high\n", 2),
        (HEADING + "\nsteel,,0.5\n", 3),
        (HEADING + "steel,1;5,0.5\n", 2),
    ],
)
def test_what_is_no_file_of_drops_is_named_with_its_line(
    tmp_path: Path, text: str, line: int
) -> None:
    path = tmp_path / "mine.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"mine\.csv\b.* line {line} "):
        read_drops(path)


def test_the_chapter_s_own_files_are_found_and_give_restitutions() -> None:
    for name in ("drops.csv", "drops_sample.csv"):
        rows = table_of_drops(read_drops(find_drops(name)))
        assert all(0.0 <= mean <= 1.0 for _, _, mean, _ in rows)
    assert len(rows) >= 2
    with pytest.raises(FileNotFoundError, match=r"no none\.csv"):
        find_drops("none.csv")
