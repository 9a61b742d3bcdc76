"""Matrix3 and Matrix4 compared with NumPy on 2,000 random matrices, their laws, and limits.

With ``pytest -s`` every comparison prints the largest deviation.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction
from typing import Any

import numpy
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import SINGULAR, Matrix3, Matrix4, change_basis

Array = numpy.ndarray
CASES = 2_000
# Sums of three rounded products: 3 u of the products' sizes with u = 1.1e-16, on both sides.
ROUNDINGS = 1e-15

RANDOM = numpy.random.default_rng(9)
LINEAR, OTHER = (RANDOM.normal(size=(CASES, 3, 3)) for _ in "ab")
MOVES, POINTS = (RANDOM.normal(size=(CASES, 3)) for _ in "ab")
# As 4x4 matrices with the last row that the book leaves out.
FULL, OTHER_FULL = (
    numpy.concatenate(
        [
            numpy.concatenate([linear, MOVES[::way, :, None]], axis=2),
            numpy.tile([0.0, 0.0, 0.0, 1.0], (CASES, 1, 1)),
        ],
        axis=1,
    )
    for linear, way in ((LINEAR, 1), (OTHER, -1))
)
CONDITION = numpy.linalg.cond(LINEAR)

# Entries so small that all sums and products of the laws are exact whole numbers.
entry = st.integers(-30, 30)
square = st.tuples(*[entry] * 9).map(lambda numbers: Matrix3(*numbers))


def ours(rows: Array) -> list[Any]:
    """Return Matrix3 objects, Matrix4 objects for four rows, or vectors for one row."""
    kind = {(3, 3): Matrix3, (4, 4): Matrix4, (3,): Vector3}[rows.shape[1:]]
    if kind is Matrix4:
        rows = rows[:, :3]
    return [kind(*row) for row in rows.reshape(CASES, -1)]


def deviation(what: str, got: list[Any], wanted: Array, size: Array | float) -> float:
    """Return and print the largest deviation of an entry, as a fraction of each case's size."""
    wanted = wanted[:, :3] if wanted.shape[1:] == (4, 4) else wanted
    flat = numpy.array([tuple(row) for row in got])
    apart = numpy.abs(flat - wanted.reshape(flat.shape)).max(axis=1)
    largest = float((apart / size).max())
    print(f"{what}: {largest:.1e} in {len(got)} cases")
    return largest


def largest_entry(matrices: Array) -> Array:
    return numpy.abs(matrices.reshape(CASES, -1)).max(axis=1)


@pytest.mark.parametrize(("a", "b"), [(LINEAR, OTHER), (FULL, OTHER_FULL)], ids=["3", "4"])
def test_the_products_agree_with_numpy(a: Array, b: Array) -> None:
    got = [m @ n for m, n in zip(ours(a), ours(b), strict=True)]
    size = largest_entry(numpy.abs(a) @ numpy.abs(b))
    assert deviation("product of matrices", got, a @ b, size) <= ROUNDINGS


def test_transformed_vectors_agree_with_numpy() -> None:
    size = 3.0 * largest_entry(FULL) * (1.0 + largest_entry(POINTS))
    turned = numpy.einsum("nij,nj->ni", LINEAR, POINTS)
    points, matrices = ours(POINTS), list(zip(ours(LINEAR), ours(FULL), strict=True))
    for what, wanted, got in (
        ("Matrix3.transform", turned, [m @ v for (m, _), v in zip(matrices, points, strict=True)]),
        (
            "Matrix4.transform",
            turned + MOVES,
            [m @ v for (_, m), v in zip(matrices, points, strict=True)],
        ),
        (
            "transform_direction",
            turned,
            [m.transform_direction(v) for (_, m), v in zip(matrices, points, strict=True)],
        ),
    ):
        assert deviation(what, got, wanted, size) <= ROUNDINGS


def test_the_determinants_agree_with_numpy() -> None:
    """The deviation is relative to the product of the rows' lengths, the largest determinant."""
    size = numpy.linalg.norm(LINEAR, axis=2).prod(axis=1)
    wanted = numpy.linalg.det(LINEAR)[:, None]
    for what, matrices in (("Matrix3", LINEAR), ("Matrix4", FULL)):
        got = [(m.determinant(),) for m in ours(matrices)]
        # Six products of three factors, and NumPy's pivots: some ten roundings.
        assert deviation(f"{what}.determinant", got, wanted, size) <= ROUNDINGS


@pytest.mark.parametrize("matrices", [LINEAR, FULL], ids=["3", "4"])
def test_the_inverses_agree_with_numpy_as_well_as_the_condition_allows(matrices: Array) -> None:
    assert CONDITION.max() > 1e3  # including some that are nearly singular
    wanted = numpy.linalg.inv(matrices)
    got = [m.inverse() for m in ours(matrices)]
    # An inverse cannot be more accurate than a rounding times the condition. Ten of these are
    # allowed, because NumPy has errors as well.
    size = largest_entry(wanted) * numpy.linalg.cond(matrices)
    assert deviation("inverse / condition", got, wanted, size) <= ROUNDINGS
    size = largest_entry(wanted) * numpy.where(CONDITION < 100.0, 1.0, math.inf)
    assert deviation("inverse, condition below 100", got, wanted, size) <= 1e-13


@pytest.mark.parametrize(("m", "basis"), [(OTHER, LINEAR), (OTHER_FULL, FULL)], ids=["3", "4"])
def test_a_change_of_basis_agrees_with_numpy(m: Array, basis: Array) -> None:
    wanted = basis @ m @ numpy.linalg.inv(basis)
    got = [change_basis(a, b) for a, b in zip(ours(m), ours(basis), strict=True)]
    inverse = numpy.linalg.inv(basis)
    size = largest_entry(numpy.abs(basis) @ numpy.abs(m) @ numpy.abs(inverse))
    size *= numpy.linalg.cond(basis)
    assert deviation("change_basis / condition", got, wanted, size) <= ROUNDINGS


@given(square)
def test_an_inverse_of_whole_numbers_is_exact_but_for_its_division(m: Matrix3) -> None:
    assume(m.determinant() != 0.0)
    a, b, c, d, e, f, g, h, i = (Fraction(number) for number in m)
    volume = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    assert m.determinant() == volume
    wanted = (
        *((e * i - f * h), (c * h - b * i), (b * f - c * e)),
        *((f * g - d * i), (a * i - c * g), (c * d - a * f)),
        *((d * h - e * g), (b * g - a * h), (a * e - b * d)),
    )
    for got, cofactor in zip(m.inverse(), wanted, strict=True):
        # One rounding, and a few more for code that first divides the rows by their lengths.
        assert got == pytest.approx(float(cofactor / volume), rel=1e-12, abs=1e-14)


def sheared(share: float, scale: float = 1.0) -> Matrix3:
    """Return a matrix whose determinant is this fraction of the product of its rows' lengths."""
    return Matrix3(scale, 0, 0, 1.0 / scale, share / scale, 0, 0, 0, 1)


@pytest.mark.parametrize("scale", [1.0, 2.0**50, 2.0**-50], ids=["1", "2^50", "2^-50"])
def test_the_limit_of_an_inverse_is_told_from_both_sides(scale: float) -> None:
    above = sheared(1.001e-13, scale)
    assert above.inverse()[1, 1] == pytest.approx(scale / 1.001e-13, rel=1e-15)
    for share in (0.999e-13, SINGULAR, -0.999e-13, 0.0):  # rejected, even at the limit
        with pytest.raises(ValueError, match="must have an inverse") as refusal:
            sheared(share, scale).inverse()
        numbers = [float(n) for n in re.findall(r"-?\d\S*e-\d+|0\.0", str(refusal.value))]
        # The determinant, its fraction and the limit, with a few roundings of lengths.
        assert numbers == pytest.approx([share, share, SINGULAR], rel=1e-14, abs=0.0)
    with pytest.raises(ValueError, match="must have an inverse"):
        Matrix4(1, 0, 0, 5, 1, 0.999e-13, 0, 6, 0, 0, 1, 7).inverse()
    with pytest.raises(ValueError, match="must have an inverse"):
        change_basis(above, sheared(0.999e-13, scale))


@pytest.mark.parametrize(
    "diagonal",
    [
        (1e200, 1e200, 1e200),
        (1e-200, 1e-200, 1e-200),
        (1e100, 1e100, 1e100),
        (1e-100, 1e-100, 1e-100),
        (1e200, 1.0, 1e-200),
        (1e-200, 1e200, 1.0),
        (1e200, -1e200, 1e-300),
        (math.inf, 1.0, 1.0),
        (math.nan, 1.0, 1.0),
        (1.0, 0.0, 1.0),
        (1e200, 1e-200, 1e200),
        (1e160, 1e160, 1e-160),
        (1e-160, 1e-160, 1e160),
        (1e-200, 1e300, 1e-200),
        (1e-107, 1e-107, 1e-107),
    ],
    ids=str,
)
@pytest.mark.parametrize("four", [False, True], ids=["3", "4"])
def test_the_inverse_of_tiny_and_huge_numbers_is_right_or_refused(
    diagonal: tuple[float, float, float], four: bool
) -> None:
    a, b, c = diagonal
    m = Matrix4(a, 0, 0, 0, 0, b, 0, 0, 0, 0, c, 0) if four else Matrix3(a, 0, 0, 0, b, 0, 0, 0, c)
    try:
        inverse, refusal = m.inverse(), ""
    except ValueError as problem:
        inverse, refusal = None, str(problem)
    if inverse is None:
        assert refusal.startswith("the matrix must have an inverse, got determinant ")
        return
    got = [inverse[place, place] for place in range(3)]
    assert got == pytest.approx([1.0 / number for number in diagonal], rel=1e-15, abs=0.0)


# share * length would be below the smallest normal float, but column / share / length is not.
@pytest.mark.parametrize("tiny", [1e-300, 5e-324])
def test_a_tiny_row_beside_nearly_parallel_ones_costs_no_digits(tiny: float) -> None:
    try:
        first = Matrix3(tiny, 0, 0, 0, 1, 0, 0, 1, 1e-12).inverse()[0, 0]
    except ValueError:
        first = math.inf  # rejected, because 1 / tiny is not a float
    assert first == pytest.approx(1.0 / tiny, rel=1e-14)  # infinity for 5e-324
