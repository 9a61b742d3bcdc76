"""Angles and centers of mass against exact fractions, and files of stones."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from ch09_rotations.plane import wrap_angle
from ch09_rotations.stones import read_stones

HEADER = "what,mass,x,y\n"


@given(st.floats(allow_nan=False, allow_infinity=False))
@example(3.0 * math.pi)
@example(-3.0 * math.pi)
@example(math.nextafter(-math.pi, 0.0))
@example(math.nextafter(math.pi, 4.0))
@example(1e300)
def test_a_wrapped_angle_differs_by_whole_turns_exactly(angle: float) -> None:
    """The difference is a multiple of math.tau, which is rounded itself, with no other rounding."""
    wrapped = wrap_angle(angle)
    assert -math.pi < wrapped <= math.pi
    assert ((Fraction(angle) - Fraction(wrapped)) / Fraction(math.tau)).denominator == 1


def file_of(tmp_path: Path, text: str, encoding: str = "utf-8") -> Path:
    path = tmp_path / "stones.csv"
    path.write_bytes(text.encode(encoding))
    return path


@pytest.mark.parametrize(
    "text",
    [
        '\nthe box,0.32,0.2,0.15\n\n\n"slate, flat", 1e-1 ,-.5,0\n\n',
        'the box,0.32,0.2,0.15\r\n"slate, flat",0.1,-0.5,0.0',
    ],
    ids=["empty lines", "of Windows"],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_a_file_of_stones_is_read_in_its_order(tmp_path: Path, text: str, encoding: str) -> None:
    stones = read_stones(file_of(tmp_path, HEADER + text, encoding))
    assert stones == [("the box", 0.32, 0.2, 0.15), ("slate, flat", 0.1, -0.5, 0.0)]


@pytest.mark.parametrize("header", ["", "what;mass;x;y\n", "mass,what,x,y\n"])
def test_a_file_without_its_header_is_refused(tmp_path: Path, header: str) -> None:
    with pytest.raises(ValueError, match=r"^stones\.csv: line 1 "):
        read_stones(file_of(tmp_path, header))


@pytest.mark.parametrize(
    "line",
    [
        "quartz,0.1,0.2",
        "quartz,0.1,0.2,0.3,0.4",
        "quartz,0,0.2,0.3",
        "quartz,inf,0.2,0.3",
        "quartz,0.1,nan,0.3",
        "quartz,0.1,0.2,-inf",
        "quartz,heavy,0.2,0.3",
        " ",
    ],
)
def test_a_line_that_is_no_stone_is_named(tmp_path: Path, line: str) -> None:
    path = file_of(tmp_path, f"{HEADER}the box,0.32,0.2,0.15\n\n{line}\n")
    with pytest.raises(ValueError, match=r"^stones\.csv, line 4 ") as found:
        read_stones(path)
    assert repr(line) in str(found.value)
