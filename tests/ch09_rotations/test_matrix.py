"""Matrix3, build tasks B9.4 and B9.5."""

from __future__ import annotations

from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from draw import vector
from expect import UNCHANGED, about, expect_close, expect_error, expect_unchanged, xyz
from turning import (
    IDENTITY,
    LOOSE,
    TIGHT,
    Nine,
    applied,
    determinant,
    draw_matrix,
    entries,
    named,
    times,
    transposed,
    written,
)

TIMES = "book 9.4.2"
VOLUME = "book 9.4.3, and the docstring of Matrix3.determinant"
INVERSE = "book 9.4.3, and the docstring of Matrix3.inverse"
COLUMNS = "If the rows are the vectors u, v and w, the columns of the inverse are v x w, w x u and "
COLUMNS += "u x v, each divided by the determinant."
WHOLE = "; m @ m.inverse(), row by row"
# Two regular matrices with only one number, or none, on the diagonal.
RING = (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, 5.0, 0.0, 0.0)
SWAP = (0.0, 2.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 5.0)


@pytest.mark.exercise("B9.4", asks="Multiply the matrix by the vector v", read=TIMES)
def test_a_matrix_times_a_vector(rng: Random) -> None:
    n, a = draw_matrix(rng), vector(rng)
    wanted = applied(n, a)
    with calls("Compute each component as the scalar product of one row and the vector."):
        m, v = Matrix3(*n), Vector3(*a)
        got = m.transform(v)
    x = wanted[0]
    y = n[3] * x + n[4] * a[1] + n[5] * a[2]
    slips = {
        "You multiply the vector by the columns of the matrix instead of its rows.":
            applied(transposed(n), a),
        "You overwrite the old x before you compute y and z from it. Compute all three results "
        "before you store any of them.": (x, y, n[6] * x + n[7] * y + n[8] * a[2]),
    }  # fmt: skip
    # Three products of numbers up to 90.
    expect_close(xyz(got), wanted, slips, tolerance=LOOSE)
    changed = "Your code changes the vector, which it should only read. Return a new vector."
    expect_unchanged("the vector", v, a, cause=changed)
    expect_close(xyz(m @ v), wanted, then="; m @ v, which calls m.transform", tolerance=LOOSE)


@pytest.mark.exercise("B9.4", asks="a new matrix that applies m first", read=TIMES)
def test_a_matrix_times_a_matrix(rng: Random) -> None:
    m, n = draw_matrix(rng), draw_matrix(rng)
    wanted = times(m, n)
    with calls("Multiply each row of a by each column of b, as scalar products."):
        a = Matrix3(*m)
        b = Matrix3(*n)
        product = a.product(b)
    got = entries(product)
    slips = {
        "You compute b times a instead of a times b.": times(n, m),
        "You multiply numbers in the same position.": [p * q for p, q in zip(m, n, strict=True)],
        "You multiply the rows of a by the rows of b.": times(m, transposed(n)),
        "You multiply the columns of a by the columns of b.": times(transposed(m), n),
        "the transpose of the product": transposed(wanted),
    }
    why = named(got, about.cause, slips, wanted)
    expect_close(got, wanted, then=", row by row", cause=why, tolerance=LOOSE)
    expect_unchanged("a", entries(a), m, cause=UNCHANGED)
    expect_unchanged("b", entries(b), n, cause=UNCHANGED)
    expect_close(entries(a @ b), wanted, then="; a @ b, which calls a.product", tolerance=LOOSE)


@pytest.mark.exercise("B9.4", asks="Swap the rows and columns of the matrix", read="book 9.4.3")
def test_rows_become_columns(rng: Random) -> None:
    n = draw_matrix(rng)
    with calls("Row i of the matrix must become column i of the transpose."):
        m = Matrix3(*n)
        transpose = m.transpose()
    got = entries(transpose)
    in_place = "Your code changes the matrix itself. Leave it as it is, and return a new Matrix3."
    expect_unchanged("the matrix", entries(m), n, cause=in_place)
    slips = {
        "You return the matrix itself.": n,
        "You reverse the order of the rows.": (*n[6:], *n[3:6], *n[:3]),
        "You reverse the order of the columns.": times(n, (0, 0, 1, 0, 1, 0, 1, 0, 0)),
        "You flip the matrix over the wrong diagonal.": transposed(n)[::-1],
    }
    why = named(got, about.cause, slips, transposed(n))
    expect_close(got, transposed(n), then=", row by row", cause=why, tolerance=0.0)


def determinant_slips(m: Nine) -> dict[str, float]:
    """Return the determinants that likely mistakes give."""
    a, b, c, d, e, f, g, h, i = m
    right, six = determinant(m), (a * e * i, b * f * g, c * d * h, c * e * g, b * d * i, a * f * h)
    terms = dict(zip(("+ a e i", "+ b f g", "+ c d h"), six[:3], strict=True))
    terms |= {"- c e g": -six[3], "- b d i": -six[4], "- a f h": -six[5]}
    terms |= {
        "+ a (e i - f h)": a * (e * i - f * h),
        "- b (d i - f g)": -b * (d * i - f * g),
        "+ c (d h - e g)": c * (d * h - e * g),
    }
    slips = {}
    yours = "With the rows (a, b, c), (d, e, f) and (g, h, i), your determinant"
    for name, term in terms.items():
        wrong, do = ("subtracts", "Add") if name[0] == "+" else ("adds", "Subtract")
        slips[f"{yours} {wrong} {name[2:]}. {do} this term instead."] = right - 2.0 * term
        slips[f"{yours} lacks {name}. Add this term."] = right - term
    negative = " It must be negative here. Don't take its absolute value, and check the signs."
    return slips | {
        "You add in the parentheses. The determinant is a (e i - f h) - b (d i - f g) + "
        "c (d h - e g).": a * (e * i + f * h) - b * (d * i + f * g) + c * (d * h + e * g),
        f"Your determinant has the wrong sign.{negative * (right < 0.0)}": -right,
        "You return only the product of the three numbers on the diagonal.": a * e * i,
        "You add all six products. Three of them must be subtracted.": sum(six),
    }


@pytest.mark.exercise("B9.5", asks="the factor by which the matrix scales volumes", read=VOLUME)
def test_the_determinant(rng: Random) -> None:
    drawn = draw_matrix(rng)
    plain = "If the rows are the vectors u, v and w, the determinant is u . (v x w)."
    zeros = "Zeros on the diagonal don't make the determinant 0. Compute all six products."
    tiny = "The determinant is small, but it is not zero. Don't round it to 0."
    a, b, c = drawn[:3], drawn[3:6], drawn[6:]
    for n, cause, near in (
        # Six products of up to 700.
        *((n, plain, 1e-10) for n in (drawn, b + a + c, c + a + b)),
        *((RING, zeros, None), (SWAP, zeros, None)),
        ([float(f"{number}e-7") for number in drawn], tiny, 1e-31),
    ):
        with calls(cause):
            got = Matrix3(*n).determinant()
        slips = determinant_slips(n) if cause == plain else {}
        expect_close(got, determinant(n), slips, tolerance=near)


def inverse_of(m: Nine) -> Nine:
    """Return the inverse of a matrix, by cofactors."""
    a, b, c, d, e, f, g, h, i = m
    cofactors = (
        *(e * i - f * h, c * h - b * i, b * f - c * e),
        *(f * g - d * i, a * i - c * g, c * d - a * f),
        *(d * h - e * g, b * g - a * h, a * e - b * d),
    )
    return tuple(cofactor / determinant(m) for cofactor in cofactors)


def inverse_slips(n: Nine, got: object) -> dict[str, list[float] | Nine]:
    """Return the inverses that likely mistakes give. The last is any multiple of the right one."""
    right, size = inverse_of(n), determinant(n)
    factors = {
        "You didn't divide by the determinant. Divide every number of the inverse by it.": size,
        "You divide by the determinant twice. Divide every number by it only once.": 1.0 / size,
        "You divide by the absolute value of the determinant. Keep its sign.": -1.0,
        "You multiply by the determinant. Divide by it instead.": size**2,
    }
    slips: dict[str, list[float] | Nine] = {
        "You return the transpose, which is the inverse only of a rotation.": transposed(n),
        "You return the matrix itself instead of its inverse.": n,
        "You leave out the minus signs of the cofactors. In a pattern like that of a chessboard, "
        "every second number needs one.": [-r if at % 2 else r for at, r in enumerate(right)],
        "You return the reciprocal of each number.": [1.0 / number for number in n],
        "You return the transpose of the inverse.": transposed(right),
    }
    for column, name in enumerate(("v x w", "w x u", "u x v")):
        slips[
            f"Column {column + 1} of your inverse has the wrong sign. With the rows u, v and w it "
            f"is {name}, in this order, divided by the determinant."
        ] = [-r if at % 3 == column else r for at, r in enumerate(right)]
    if isinstance(got, tuple) and isinstance(got[0], float):
        factor = got[0] / right[0]
        factors[
            f"Every number of your inverse is multiplied by {factor:.6g}, so only the divisor is "
            f"wrong. {COLUMNS}"
        ] = factor
    return slips | {slip: [factor * r for r in right] for slip, factor in factors.items()}


@pytest.mark.exercise(
    "B9.5", asks="a new matrix that undoes the effect of this one", weight=2, read=INVERSE
)
def test_the_inverse_undoes_the_matrix(rng: Random) -> None:
    drawn = draw_matrix(rng)
    compare = "Compare the determinant with SINGULAR times the product of the row lengths."
    small = f"A matrix isn't singular just because its numbers are small. {compare}"
    mirrored = (*drawn[3:6], *drawn[0:3], *drawn[6:9])  # its determinant has the other sign
    for rows, power in ((drawn, 0), (mirrored, 0), (drawn, -7), (drawn, 7)):
        n = tuple(float(f"{number}e{power}") for number in rows)
        how = "Don't raise an error."
        if determinant(n) < 0.0:
            how = "Compare the absolute value of the determinant with the limit."
        exists = f"The determinant is {determinant(n):.4g}, so the matrix has an inverse. {how}"
        with calls(small if power else exists):
            m = Matrix3(*n)
            inverse = m.inverse()
        got = entries(inverse)
        why = named(got, small if power else COLUMNS, inverse_slips(n, got))
        product = times(n, got) if isinstance(got, tuple) and len(got) == 9 else got
        expect_close(product, IDENTITY, then=WHOLE, cause=why, tolerance=TIGHT)
        expect_unchanged("m", entries(m), n, cause=UNCHANGED)
    zeros = "The diagonal of this matrix contains zeros, but the matrix has an inverse. If you use "
    zeros += "elimination, swap rows so that you never divide by 0."
    uneven = f"The rows have very different lengths, but the matrix has an inverse. {compare}"
    steep = (1e-7, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1e7)
    for n, cause in ((RING, zeros), (SWAP, zeros), (steep, uneven)):
        with calls(cause):
            m = Matrix3(*n)
            inverse = m.inverse()
        got = entries(inverse)
        product = times(n, got) if isinstance(got, tuple) and len(got) == 9 else got
        expect_close(product, IDENTITY, then=WHOLE, tolerance=TIGHT)


def expect_no_inverse(m: Nine, cause: str) -> None:
    """Expect a ValueError for this matrix, and none for a regular one."""
    expect_error(
        lambda: Matrix3(*m).inverse(),
        ValueError,
        call=f"m = {written(m, exact=True)}; m.inverse()",
        allowed=lambda: Matrix3(2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 4.0).inverse(),
        cause=cause,
    )


@pytest.mark.exercise("B9.5", asks="Rounding errors then make the inverse useless", read=INVERSE)
@pytest.mark.robust
def test_a_singular_matrix_has_no_inverse(rng: Random) -> None:
    zero = "The determinant of this matrix is 0, so it has no inverse. Raise ValueError."
    expect_no_inverse((0.0,) * 9, zero)
    expect_no_inverse((1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0), zero)
    rounded = "This matrix is singular, but rounding errors keep its determinant from being 0. "
    rounded += "Compare it with SINGULAR times the product of the row lengths."
    for scale in (1.0, 1e6):
        for _ in range(6):
            a, b = vector(rng), vector(rng)
            third = rng.uniform(-2.0, 2.0) * a + rng.uniform(-2.0, 2.0) * b
            expect_no_inverse([scale * number for number in (*a, *b, *third)], rounded)


@pytest.mark.exercise("B9.5", asks="at most SINGULAR (1e-13) times the product", read=INVERSE)
@pytest.mark.robust
def test_how_near_to_singular_is_too_near() -> None:
    # Rows of lengths 2, 4 and 8. The determinant is exactly 64 times the small number.
    for small in (1e-13, 0.9e-13):
        ratio = f"The determinant is only {small} times the product of the row lengths."
        expect_no_inverse((2.0, 0.0, 0.0, 4.0, 4.0 * small, 0.0, 0.0, 0.0, 8.0), ratio)
    with calls("A ratio of 1.1e-13 is more than SINGULAR (1e-13), so this matrix has an inverse."):
        m = Matrix3(2.0, 0.0, 0.0, 4.0, 4.0 * 1.1e-13, 0.0, 0.0, 0.0, 8.0)
        inverse = m.inverse()
    got = entries(inverse)
    expect_close(got[0] if isinstance(got, tuple) else got, 0.5, then=".entries[0]")
