"""Matrix3, build tasks B9.4 and B9.5."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from draw import Components, components
from expect import UNCHANGED, about, expect_close, expect_error, expect_unchanged, xyz
from turning import (
    IDENTITY,
    TIGHT,
    Nine,
    applied,
    determinant,
    draw_matrix,
    entries,
    named,
    short,
    times,
    transposed,
    written,
)

TIMES = "book 9.4.2"
INVERSE = "book 9.4.3, and the docstring of Matrix3.inverse"


def in_place(m: Nine, a: Components) -> Components:
    """Return the result of overwriting the vector while it is still being read."""
    x, y, z = a
    x = m[0] * x + m[1] * y + m[2] * z
    y = m[3] * x + m[4] * y + m[5] * z
    return x, y, m[6] * x + m[7] * y + m[8] * z


@pytest.mark.exercise("B9.4", asks="Multiply the matrix by the vector v")
def test_a_matrix_times_a_vector(rng: Random) -> None:
    about.read = TIMES
    m, a = draw_matrix(rng), components(rng)
    v = Vector3(*a)
    about.call = f"m = {written(m)}; m.transform(Vector3{short(a)})"
    about.cause = "Compute each component as the scalar product of one row and the vector."
    got = xyz(Matrix3(*m).transform(v))
    wanted = applied(m, a)
    slips = {
        "You multiply the vector by the columns of the matrix instead of its rows.": applied(
            transposed(m), a
        ),
        "You overwrite the old x before you compute y and z from it. Compute all three results "
        "before you store any of them.": in_place(m, a),
    }
    why = named(got, about.cause, slips, wanted)
    # Three products of numbers up to 90.
    expect_close(got, wanted, cause=why, tolerance=1e-11)
    changed = "Your code changes the vector, which it should only read. Return a new vector."
    expect_unchanged("the vector", xyz(v), a, cause=changed)
    about.call = f"m = {written(m)}; m @ Vector3{short(a)}, which calls m.transform"
    got = xyz(Matrix3(*m) @ v)
    expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B9.4", asks="a new matrix that applies m first")
def test_a_matrix_times_a_matrix(rng: Random) -> None:
    about.read = TIMES
    m, n = draw_matrix(rng), draw_matrix(rng)
    about.call = f"a = {written(m)}; b = {written(n)}; a.product(b), row by row"
    about.cause = (
        "Each number of the result must be the scalar product of a row of a and a column of b."
    )
    first, second = Matrix3(*m), Matrix3(*n)
    got = entries(first.product(second))
    slips = {
        "You compute b times a instead of a times b.": times(n, m),
        "You multiply each number of a by the number of b in the same position.": [
            p * q for p, q in zip(m, n, strict=True)
        ],
        "You multiply the rows of a by the rows of b instead of its columns.": times(
            m, transposed(n)
        ),
        "You multiply the columns of a by the columns of b.": times(transposed(m), n),
        "the transpose of the product": transposed(times(m, n)),
    }
    why = named(got, about.cause, slips, times(m, n))
    expect_close(got, times(m, n), cause=why, tolerance=1e-11)
    expect_unchanged("a", entries(first), m, cause=UNCHANGED)
    expect_unchanged("b", entries(second), n, cause=UNCHANGED)
    about.call = f"a = {written(m)}; b = {written(n)}; a @ b, which calls a.product, row by row"
    got = entries(first @ second)
    expect_close(got, times(m, n), tolerance=1e-11)


@pytest.mark.exercise("B9.4", asks="Swap the rows and columns of the matrix")
def test_rows_become_columns(rng: Random) -> None:
    about.read = "book 9.4.3"
    m = draw_matrix(rng)
    matrix = Matrix3(*m)
    about.call = f"m = {written(m)}; m.transpose(), row by row"
    about.cause = "Row i of the matrix must become column i of the transpose."
    got = entries(matrix.transpose())
    in_place = "Your code changes the matrix itself. Leave it as it is, and return a new Matrix3."
    expect_unchanged("the matrix", entries(matrix), m, cause=in_place)
    other = transposed(m)[::-1]
    slips = {
        "You return the matrix itself.": m,
        "You reverse the order of the rows. Swap rows and columns instead.": (
            *m[6:],
            *m[3:6],
            *m[:3],
        ),
        "You reverse the order of the columns. Swap rows and columns instead.": [
            m[3 * row + column] for row in range(3) for column in (2, 1, 0)
        ],
        "You flip the matrix over the wrong diagonal.": other,
    }
    why = named(got, about.cause, slips, transposed(m))
    expect_close(got, transposed(m), cause=why, tolerance=0.0)


def ring_and_swap() -> tuple[Nine, Nine]:
    """Return two regular matrices with only one number, or none, on the diagonal."""
    return (
        (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, 5.0, 0.0, 0.0),
        (0.0, 2.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 5.0),
    )


def determinant_slips(m: Nine) -> dict[str, float]:
    """Return the determinants that likely mistakes give."""
    a, b, c, d, e, f, g, h, i = m
    right = determinant(m)
    products = {
        "+ a e i": a * e * i,
        "+ b f g": b * f * g,
        "+ c d h": c * d * h,
        "- c e g": -c * e * g,
        "- b d i": -b * d * i,
        "- a f h": -a * f * h,
    }
    products |= {
        "+ a (e i - f h)": a * (e * i - f * h),
        "- b (d i - f g)": -b * (d * i - f * g),
        "+ c (d h - e g)": c * (d * h - e * g),
    }
    signs = {
        "With the rows (a, b, c), (d, e, f) and (g, h, i), your determinant "
        + (f"subtracts {name[2:]}. Add " if name[0] == "+" else f"adds {name[2:]}. Subtract ")
        + "this term instead.": right - 2.0 * product
        for name, product in products.items()
    }
    left_out = {
        f"With the rows (a, b, c), (d, e, f) and (g, h, i), your determinant lacks {name}. Add "
        "this term.": right - product
        for name, product in products.items()
    }
    plus = a * (e * i + f * h) - b * (d * i + f * g) + c * (d * h + e * g)
    slips = {
        "You add in the parentheses. The determinant is a (e i - f h) - b (d i - f g) + "
        "c (d h - e g).": plus,
        "Your determinant has the wrong sign."
        + " It must be negative here, so don't take its absolute value, and check which terms you "
        "subtract." * (right < 0.0): -right,
        "You return only the product of the three numbers on the diagonal. The other five products "
        "of the determinant are missing.": a * e * i,
        "You add all six products. Three of them must be subtracted.": a * e * i
        + b * f * g
        + c * d * h
        + c * e * g
        + b * d * i
        + a * f * h,
    }
    return signs | left_out | slips


@pytest.mark.exercise("B9.5", asks="the factor by which the matrix scales volumes")
def test_the_determinant(rng: Random) -> None:
    about.read = "book 9.4.3, and the docstring of Matrix3.determinant"
    m = draw_matrix(rng)
    about.cause = (
        "If the rows are the vectors u, v and w, the determinant is u . (v x w), which can be "
        "negative."
    )
    for rows in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        n = tuple(m[3 * row + column] for row in rows for column in range(3))
        about.call = f"n = {written(n)}; n.determinant()"
        got = Matrix3(*n).determinant()
        # Six products of up to 700.
        why = named(got, about.cause, determinant_slips(n))
        expect_close(got, determinant(n), cause=why, tolerance=1e-10)
    about.cause = (
        "Zeros on the diagonal don't make the determinant 0. Compute all six products, because "
        "some of them contain no number on the diagonal."
    )
    for n in ring_and_swap():
        about.call = f"n = {written(n)}; n.determinant()"
        got = Matrix3(*n).determinant()
        expect_close(got, determinant(n))
    about.cause = "The determinant is small, but it is not zero. Don't round it to 0."
    n = tuple(number * 1e-7 for number in m)
    about.call = f"n = {written(n)}; n.determinant()"
    got = Matrix3(*n).determinant()
    expect_close(got, determinant(n), tolerance=1e-31)


def unsigned(m: Nine) -> Nine:
    """Return the inverse of a matrix as it comes out without the signs of the cofactors."""
    a, b, c, d, e, f, g, h, i = m
    minors = (
        *(e * i - f * h, d * i - f * g, d * h - e * g),
        *(b * i - c * h, a * i - c * g, a * h - b * g),
        *(b * f - c * e, a * f - c * d, a * e - b * d),
    )
    return tuple(minor / determinant(m) for minor in transposed(minors))


@pytest.mark.exercise("B9.5", asks="a new matrix that undoes the effect of this one", weight=2)
def test_the_inverse_undoes_the_matrix(rng: Random) -> None:
    about.read = INVERSE
    m = draw_matrix(rng)
    plain = (
        "If the rows are the vectors u, v and w, the columns of the inverse are v x w, w x u and "
        "u x v, each divided by the determinant."
    )
    small = (
        "A matrix isn't singular just because its numbers are small. Compare the determinant with "
        "SINGULAR times the product of the row lengths."
    )
    mirrored = (*m[3:6], *m[0:3], *m[6:9])  # its determinant has the other sign
    for rows, scale, how in (
        (m, 1.0, plain),
        (mirrored, 1.0, plain),
        (m, 1e-7, small),
        (m, 1e7, small),
    ):
        n = tuple(number * scale for number in rows)
        matrix = Matrix3(*n)
        about.call = f"m = {written(n)}; m @ m.inverse(), row by row"
        about.cause = f"The determinant is {determinant(n):.4g}, so the matrix has an inverse. "
        if determinant(n) < 0.0:
            about.cause += "Compare the absolute value of the determinant with the limit."
        else:
            about.cause += "Don't raise an error."
        if scale != 1.0:
            about.cause = small
        got = entries(matrix.inverse())
        product = times(n, got) if isinstance(got, tuple) and len(got) == 9 else got
        slips = {
            "You didn't divide by the determinant. Divide every number of the inverse by it.": [
                determinant(n) * one for one in IDENTITY
            ],
            "You divide by the determinant twice. Divide every number by it only once.": [
                one / determinant(n) for one in IDENTITY
            ],
            "You divide by the absolute value of the determinant. Keep its sign.": [
                -one for one in IDENTITY
            ],
            "You multiply by the determinant. Divide by it instead.": [
                determinant(n) ** 2 * one for one in IDENTITY
            ],
            "You return the transpose. It is the inverse only if the matrix is a rotation.": times(
                n, transposed(n)
            ),
            "You return the matrix itself instead of its inverse.": times(n, n),
        }
        for column, name in enumerate(("v x w", "w x u", "u x v")):
            flipped = [-one if 4 * column == place else one for place, one in enumerate(IDENTITY)]
            slips[
                f"Column {column + 1} of your inverse has the wrong sign. With the rows u, v and w "
                f"it is {name}, in this order, divided by the determinant."
            ] = flipped
        if scale == 1.0:
            minors = unsigned(n)
            slips[
                "You leave out the minus signs of the cofactors. In a pattern like that of a "
                "chessboard, every second number needs one."
            ] = times(n, minors)
            slips[
                "You return the reciprocal of each number. To invert a matrix, you need the "
                "determinant and products of its rows."
            ] = times(n, [1.0 / number for number in n])
        if product is not got and all(type(number) in (int, float) for number in got):
            back = times(n, transposed(got))
            if all(abs(b - one) < 1e-9 for b, one in zip(back, IDENTITY, strict=True)):
                slips[
                    "You return the transpose of the inverse. Swap the rows and columns of your "
                    "result."
                ] = product
        why = named(product, how, slips)
        if why == how and product is not got and all(type(one) is float for one in product):
            one = product[0]
            if one and all(
                abs(p - one * q) < 1e-9 * abs(one) for p, q in zip(product, IDENTITY, strict=True)
            ):
                why = f"Every number of your inverse is multiplied by {one:.6g}, so only the "
                why += f"divisor is wrong. {plain}"
        expect_close(product, IDENTITY, cause=why, tolerance=TIGHT)
        expect_unchanged("m", entries(matrix), n, cause=UNCHANGED)
    about.cause = (
        "The diagonal of this matrix contains zeros, but the matrix has an inverse. If you use "
        "elimination, swap rows so that you never divide by 0."
    )
    for n in (*ring_and_swap(), (1e-7, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1e7)):
        if n[0]:
            about.cause = (
                "The rows of this matrix have very different lengths, but it has an inverse. "
                "Compare the determinant with SINGULAR times the product of the row lengths."
            )
        about.call = f"m = {written(n)}; m @ m.inverse(), row by row"
        got = entries(Matrix3(*n).inverse())
        product = times(n, got) if isinstance(got, tuple) and len(got) == 9 else got
        expect_close(product, IDENTITY, tolerance=TIGHT)


def expect_no_inverse(m: Nine) -> None:
    """Expect a ValueError for this matrix, and none for a regular one."""
    expect_error(
        lambda: Matrix3(*m).inverse(),
        ValueError,
        call=f"m = {written(m, exact=True)}; m.inverse()",
        allowed=lambda: Matrix3(2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 4.0).inverse(),
        read=INVERSE,
    )


@pytest.mark.exercise("B9.5", asks="Rounding errors then make the inverse useless")
@pytest.mark.robust
def test_a_singular_matrix_has_no_inverse(rng: Random) -> None:
    about.cause = (
        "The determinant of this matrix is 0, so it has no inverse. Raise ValueError unless the "
        "absolute value of the determinant is greater than the limit."
    )
    expect_no_inverse((0.0,) * 9)
    expect_no_inverse((1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0))
    about.cause = (
        "This matrix is singular, but rounding errors keep its determinant from being exactly 0. "
        "Compare the determinant with SINGULAR times the product of the row lengths."
    )
    for scale in (1.0, 1e6):
        for _ in range(6):
            a, b = components(rng), components(rng)
            s, t = rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)
            third = [s * p + t * q for p, q in zip(a, b, strict=True)]
            expect_no_inverse(tuple(scale * number for number in (*a, *b, *third)))


@pytest.mark.exercise("B9.5", asks="at most SINGULAR (1e-13) times the product")
@pytest.mark.robust
def test_how_near_to_singular_is_too_near() -> None:
    about.read = INVERSE
    # Rows of lengths 2, 4 and 8. The determinant is exactly 64 times the small number.
    for small, regular in ((1.1e-13, True), (1e-13, False), (0.9e-13, False)):
        m = (2.0, 0.0, 0.0, 4.0, 4.0 * small, 0.0, 0.0, 0.0, 8.0)
        about.cause = (
            f"The determinant is {small} times the product of the row lengths, so this matrix has "
            "an inverse. Raise ValueError only if this ratio is at most SINGULAR (1e-13)."
        )
        if not regular:
            about.cause = (
                f"The absolute value of the determinant is only {small} times the product of the "
                "row lengths. That is not more than SINGULAR (1e-13), so raise ValueError."
            )
            expect_no_inverse(m)
            continue
        about.call = f"m = {written(m)}; m.inverse().entries[0]"
        got = entries(Matrix3(*m).inverse())
        expect_close(got[0] if isinstance(got, tuple) else got, 0.5)
