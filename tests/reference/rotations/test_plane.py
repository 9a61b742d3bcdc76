"""Angles and points in the plane, centers of mass against exact fractions, and stones."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from ch09_rotations.exercises import balance_offset, center_of_stones, masses_beside
from ch09_rotations.plane import center_of_mass, rotate_point, wrap_angle
from ch09_rotations.stones import own_stones, read_stones

UNIT_ROUNDING = 2.0**-53
coordinate = st.floats(-1e3, 1e3)
point = st.tuples(coordinate, coordinate)
mass = st.floats(1e-6, 1e6)
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


@given(point, st.floats(-10.0, 10.0), point)
def test_a_point_is_turned_as_complex_numbers_are_and_then_moved(
    at: tuple[float, float], angle: float, origin: tuple[float, float]
) -> None:
    wanted = complex(*at) * complex(math.cos(angle), math.sin(angle)) + complex(*origin)
    size = math.hypot(*at) + math.hypot(*origin)
    # Two products and two sums, in another order.
    got = rotate_point(at, angle, origin)
    assert got == pytest.approx((wanted.real, wanted.imag), rel=0.0, abs=4.0 * UNIT_ROUNDING * size)


@given(st.lists(st.tuples(mass, coordinate, coordinate), min_size=1, max_size=20))
def test_the_center_of_mass_is_exact_but_for_its_roundings(
    bodies: list[tuple[float, float, float]],
) -> None:
    got = center_of_mass([m for m, _, _ in bodies], [(x, y) for _, x, y in bodies])
    total = sum(Fraction(m) for m, _, _ in bodies)
    for axis in (0, 1):
        terms = [Fraction(body[0]) * Fraction(body[1 + axis]) / total for body in bodies]
        # Each term has three roundings: of the total, the fraction and the product. The sum has
        # one. Below 1e-308 there is nothing to round.
        allowed = 4.01 * UNIT_ROUNDING * float(sum(abs(term) for term in terms)) + 1e-300
        assert abs(Fraction(got[axis]) - sum(terms)) <= allowed


def test_the_center_of_mass_holds_where_masses_are_far_apart() -> None:
    assert center_of_mass([1e-300, 3e-300], [(4.0, 0.0), (0.0, 8.0)]) == (1.0, 6.0)
    assert center_of_mass([1e200, 3e200], [(4.0, 0.0), (0.0, 8.0)]) == (1.0, 6.0)
    assert center_of_mass([2.5], [(1.25, -7.5)]) == (1.25, -7.5)
    assert center_of_mass([1e-30, 1.0], [(1e3, 0.0), (-1.0, 2.0)]) == (-1.0, 2.0)


def test_a_balanced_edge_passes_through_the_center_of_mass_in_every_direction() -> None:
    stones = [("a", 1.0, 0.0, 0.0), ("b", 3.0, 4.0, 0.0), ("c", 4.0, 0.0, 2.0)]
    assert center_of_stones(stones) == (1.5, 1.0)
    for turn in range(-20, 21):
        angle = 0.3 * turn
        offset, cosine, sine = balance_offset(stones, angle), math.cos(angle), math.sin(angle)
        moments = (m * (cosine * y - sine * x - offset) for _, m, x, y in stones)
        assert math.fsum(moments) == pytest.approx(0.0, abs=1e-14)  # some roundings of 10 kg m
    assert masses_beside(stones, 0.0) == (4.0, 4.0)
    assert masses_beside(stones, math.pi / 2.0) == (5.0, 3.0)  # left of a line along Y is low x


def file_of(tmp_path: Path, text: str, encoding: str = "utf-8") -> Path:
    path = tmp_path / "stones.csv"
    path.write_bytes(text.encode(encoding))
    return path


@pytest.mark.parametrize(
    "text",
    [
        'the box,0.32,0.2,0.15\n"slate, flat", 1e-1 ,-.5,0\n',
        '\nthe box,0.32,0.2,0.15\n\n\n"slate, flat",0.1,-0.5,0\n\n',
        'the box,0.32,0.2,0.15\r\n"slate, flat",0.1,-0.5,0.0',
    ],
    ids=["plain", "empty lines", "of Windows"],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_a_file_of_stones_is_read_in_its_order(tmp_path: Path, text: str, encoding: str) -> None:
    stones = read_stones(file_of(tmp_path, HEADER + text, encoding))
    assert stones == [("the box", 0.32, 0.2, 0.15), ("slate, flat", 0.1, -0.5, 0.0)]


def test_a_file_of_no_stones_is_empty_and_the_students_own_has_a_center(tmp_path: Path) -> None:
    assert read_stones(file_of(tmp_path, HEADER)) == []
    stones = read_stones(own_stones())
    total = sum(Fraction(m) for _, m, _, _ in stones)
    wanted = [sum(Fraction(s[1]) * Fraction(s[place]) for s in stones) / total for place in (2, 3)]
    assert center_of_stones(stones) == pytest.approx([float(w) for w in wanted], rel=1e-15)


@pytest.mark.parametrize(
    "header", ["", "\n", "what,mass,x", "what;mass;x;y\n", "mass,what,x,y\n", "what, mass, x, y\n"]
)
def test_a_file_without_its_header_is_refused(tmp_path: Path, header: str) -> None:
    with pytest.raises(ValueError, match=r"^stones\.csv: line 1 "):
        read_stones(file_of(tmp_path, header))


@pytest.mark.parametrize(
    "line",
    [
        "quartz",
        "quartz,0.1,0.2",
        "quartz,0.1,0.2,0.3,0.4",
        "quartz,0,0.2,0.3",
        "quartz,-0.1,0.2,0.3",
        "quartz,nan,0.2,0.3",
        "quartz,inf,0.2,0.3",
        "quartz,0.1,nan,0.3",
        "quartz,0.1,0.2,-inf",
        "quartz,heavy,0.2,0.3",
        "quartz,0.1,,0.3",
        " ",
    ],
)
def test_a_line_that_is_no_stone_is_named(tmp_path: Path, line: str) -> None:
    path = file_of(tmp_path, f"{HEADER}the box,0.32,0.2,0.15\n\n{line}\n")
    with pytest.raises(ValueError, match=r"^stones\.csv, line 4 ") as found:
        read_stones(path)
    assert repr(line) in str(found.value)
