"""Matrix4: build task B9.14."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix4
from draw import Components, components
from expect import about, expect_close, expect_error, xyz
from turning import (
    IDENTITY,
    LOOSE,
    Nine,
    added,
    applied,
    determinant,
    draw_matrix,
    draw_mirror,
    entries,
    expect_kept,
    joined,
    moved,
    named,
    short,
    subtracted,
    times,
    transposed,
    written,
)

POINT = "book 9.4.2, and the docstring of Matrix4.transform"
TIMES = "book 9.4.2, and the docstring of Matrix4.product"
INVERSE = "book 9.4.3, and the docstring of Matrix4.inverse"


@pytest.mark.exercise("B9.14", asks="add the translation, and return a new vector")
def test_a_point_is_transformed_and_moved(rng: Random) -> None:
    about.read = POINT
    m, p, a = draw_matrix(rng), components(rng), components(rng)
    twelve = joined(m, p)
    v = Vector3(*a)
    about.call = f"m = {written(twelve)}; m.transform(Vector3{short(a)})"
    about.cause = (
        "For each row, take the scalar product of its first three numbers and the vector, and then "
        "add its fourth number."
    )
    got = xyz(Matrix4(*twelve).transform(v))
    slips = {
        "You leave out the translation. Add the fourth number of each row.": applied(m, a),
        "You add the translation before you multiply by the 3x3 part. Multiply first, and then add "
        "the translation.": applied(m, added(a, p)),
        "You multiply the vector by the columns of the matrix instead of its rows.": moved(
            transposed(m), p, a
        ),
        "You subtract the translation. Add it instead.": subtracted(applied(m, a), p),
        "You use the first nine entries as the rotation, but every fourth entry belongs to the "
        "translation.": applied(twelve[:9], a),
        "You use the last three entries as the translation. The entries are stored row by row, so "
        "every fourth entry belongs to the translation.": added(applied(twelve[:9], a), twelve[9:]),
    }
    why = named(got, about.cause, slips)
    expect_close(got, moved(m, p, a), cause=why, tolerance=LOOSE)
    expect_kept("the vector", xyz(v), a)
    about.call = f"m = {written(twelve)}; m @ Vector3{short(a)}, which calls m.transform"
    got = xyz(Matrix4(*twelve) @ v)
    expect_close(got, moved(m, p, a), tolerance=LOOSE)


@pytest.mark.exercise("B9.14", asks="a new matrix that applies m first")
def test_one_transformation_after_another(rng: Random) -> None:
    about.read = TIMES
    m, p, n, q = draw_matrix(rng), components(rng), draw_matrix(rng), components(rng)
    first, second = joined(m, p), joined(n, q)
    one, other = Matrix4(*first), Matrix4(*second)
    about.call = f"a = {written(first)}; b = {written(second)}; a.product(b), row by row"
    about.cause = "The last column should be a.transform(p), where p is the translation of b."
    got = entries(one.product(other))
    wanted = joined(times(m, n), moved(m, p, q))
    slips = {
        "Your last column is the sum of the two translations.": joined(times(m, n), added(p, q)),
        "Your last column lacks the translation of a.": joined(times(m, n), applied(m, q)),
        "Your last column is only the translation of a.": joined(times(m, n), p),
        "Your last column is only the translation of b.": joined(times(m, n), q),
        "You rotate both translations to get the last column.": joined(
            times(m, n), applied(m, added(p, q))
        ),
        "Your last column is b.transform(p), where p is the translation of a. Swap a and b in "
        "it.": joined(times(m, n), moved(n, q, p)),
        "You multiply the 3x3 parts in the wrong order. The 3x3 part of a is on the left.": joined(
            times(n, m), moved(m, p, q)
        ),
        "You multiply each number of a by the number of b in the same position. Multiply rows by "
        "columns.": [x * y for x, y in zip(first, second, strict=True)],
        "Your result is the product in the other order, b.product(a). Swap the two "
        "factors.": joined(times(n, m), moved(n, q, p)),
    }
    why = named(got, about.cause, slips)
    if why == about.cause:
        about.cause = "The first three columns are the product of the two 3x3 parts. The last "
        about.cause += "column is a.transform(p), where p is the translation of b."
        why = named(got, about.cause, {}, wanted)
    expect_close(got, wanted, cause=why, tolerance=LOOSE)
    expect_kept("a", entries(one), first)
    expect_kept("b", entries(other), second)
    about.call = f"a = {written(first)}; b = {written(second)}; a @ b, which calls a.product, row "
    about.call += "by row"
    got = entries(one @ other)
    expect_close(got, wanted, tolerance=LOOSE)


def printed_determinant(m: Nine) -> float:
    """Return the determinant as printed, with a plus before data[8] data[5] data[2]."""
    return determinant(m) + 2.0 * m[6] * m[4] * m[2]


def overwritten(m: Nine, p: Components) -> tuple[Nine, Components]:
    """Return the inverse as the book's listing computes it, in place and in its order."""
    d, det = [*joined(m, p)], determinant(m)
    d[0] = (d[5] * d[10] - d[9] * d[6]) / det
    d[4] = (d[8] * d[6] - d[4] * d[10]) / det
    d[8] = (d[4] * d[9] - d[8] * d[5]) / det
    d[1] = (d[9] * d[2] - d[1] * d[10]) / det
    d[5] = (d[0] * d[10] - d[8] * d[2]) / det
    d[9] = (d[8] * d[1] - d[0] * d[9]) / det
    d[2] = (d[1] * d[6] - d[5] * d[2]) / det
    d[6] = (d[4] * d[2] - d[0] * d[6]) / det
    d[10] = (d[0] * d[5] - d[4] * d[1]) / det
    d[3] = (
        d[3] * (d[9] * d[6] - d[5] * d[10])
        + d[7] * (d[1] * d[10] - d[9] * d[2])
        + d[11] * (d[5] * d[2] - d[1] * d[6])
    ) / det
    d[7] = (
        d[3] * (d[4] * d[10] - d[8] * d[6])
        + d[7] * (d[8] * d[2] - d[0] * d[10])
        + d[11] * (d[0] * d[6] - d[4] * d[2])
    ) / det
    d[11] = (
        d[3] * (d[8] * d[5] - d[4] * d[9])
        + d[7] * (d[0] * d[9] - d[8] * d[1])
        + d[11] * (d[4] * d[1] - d[0] * d[5])
    ) / det
    return (*d[0:3], *d[4:7], *d[8:11]), (d[3], d[7], d[11])


@pytest.mark.exercise("B9.14", asks="Compute the determinant of the 3x3 part")
def test_the_determinant_ignores_the_translation(rng: Random) -> None:
    about.read = "book 9.4.3, and E-28"
    m, p = draw_mirror(rng), components(rng)
    twelve = joined(m, p)
    about.call = f"m = {written(twelve)}; m.determinant()"
    about.cause = "Compute the determinant of the nine numbers to the left of the last column."
    got = Matrix4(*twelve).determinant()
    slips = {
        "You use the book's formula, which has a plus in place of a minus. Correct it as E-28 "
        "says.": printed_determinant(m),
        "You use the first nine entries, but every fourth one belongs to the translation. Use the "
        "nine numbers to the left of the last column.": determinant(twelve[:9]),
        "Your determinant has the wrong sign.": -determinant(m),
        "You return only the product of the diagonal.": m[0] * m[4] * m[8],
    }
    why = named(got, about.cause, slips)
    expect_close(got, determinant(m), cause=why, tolerance=1e-10)
    about.cause = "The determinant is small, but it is not zero. Don't round it to 0."
    small = tuple(1e-7 * number for number in m)
    about.call = f"m = {written(joined(small, p))}; m.determinant()"
    got = Matrix4(*joined(small, p)).determinant()
    expect_close(got, determinant(small), tolerance=1e-31)


@pytest.mark.exercise("B9.14", asks="by the negative of the translation", weight=2)
def test_the_inverse_takes_a_point_back(rng: Random) -> None:
    about.read = INVERSE
    drawn = draw_matrix(rng)
    small = tuple(1e-7 * number for number in drawn)
    ring = (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, -5.0, 0.0, 0.0)
    listing = (
        "A Matrix4 has only the entries 0 to 11, but the book's listing also reads entry 15 "
        "(E-13). Don't copy this line."
    )
    tiny = (
        "A matrix isn't singular just because its numbers are small. Call Matrix3.inverse on the "
        "nine numbers to the left of the last column."
    )
    zeros = (
        "Zeros on the diagonal don't make a matrix singular. Call Matrix3.inverse on the nine "
        "numbers to the left of the last column."
    )
    for m, size, how in ((drawn, 1.0, listing), (small, 1e-7, tiny), (ring, 1.0, zeros)):
        p, a = tuple(size * component for component in components(rng)), components(rng)
        twelve = joined(m, p)
        matrix = Matrix4(*twelve)
        there = moved(m, p, a)
        about(f"m = {written(twelve)}; m.inverse() @ (m @ Vector3{short(a)})")
        about.cause = how
        got = entries(matrix.inverse())
        about.cause = (
            "The translation of the inverse should be -A p, where p is the translation of m, and A "
            "is the inverse of its 3x3 part."
        )
        if isinstance(got, tuple) and len(got) == 9:
            about.cause = "Your result is a Matrix3. Return a Matrix4, with a translation too."
        if isinstance(got, tuple) and len(got) == 12:
            linear, move = (*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11])
            got = moved(linear, move, there)
            plain, turned_back = (
                applied(linear, there),
                applied(transposed(m), subtracted(there, p)),
            )
            slips = {
                "You don't invert the 3x3 part. Use Matrix3.inverse.": subtracted(
                    applied(m, there), applied(m, p)
                ),
                "You use -p as the translation.": subtracted(plain, p),
                "You use p as the translation.": added(plain, p),
                "You leave out the minus sign of the translation.": added(
                    plain, applied(linear, p)
                ),
                "Your inverse has no translation.": plain,
                "You multiply the translation by the 3x3 part of m. Multiply it by the inverse of "
                "this part instead.": subtracted(plain, applied(m, p)),
                "You transpose the 3x3 part, but the transpose is the inverse only for a rotation. "
                "Use Matrix3.inverse instead.": turned_back,
                "You don't divide by the determinant. Use Matrix3.inverse, which does.": [
                    determinant(m) * component for component in a
                ],
                "You divide by the book's determinant, which has a plus in place of a minus. "
                "Correct it as E-28 says.": [
                    determinant(m) / printed_determinant(m) * component for component in a
                ],
                "You use the book's listing, which reads entries that it has already overwritten "
                "(E-30). Compute all entries before you store "
                "them.": moved(*overwritten(m, p), there),
            }
            about.cause = named(got, about.cause, slips)
        expect_close(got, a, tolerance=LOOSE)
        expect_kept("m", entries(matrix), twelve)


@pytest.mark.exercise("B9.14", asks="if Matrix3.inverse rejects the 3x3 part")
@pytest.mark.robust
def test_a_flat_transformation_has_no_inverse(rng: Random) -> None:
    about.read = INVERSE
    flat = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
    singular = "The 3x3 part of this matrix is singular, so the matrix has no inverse. "
    planes = []
    for _ in range(6):  # rows in one plane, apart from rounding errors, which may be zero
        a, b = components(rng), components(rng)
        plane = (*a, *b, *(1.3 * x - 0.7 * y for x, y in zip(a, b, strict=True)))
        planes += [plane, tuple(1e6 * number for number in plane)]
    for linear in (flat, (0.0,) * 9, *planes):
        twelve = joined(linear, components(rng))
        about.cause = f"{singular}Raise ValueError, as Matrix3.inverse does for the 3x3 part."
        expect_error(
            lambda twelve=twelve: Matrix4(*twelve).inverse(),
            ValueError,
            call=f"m = {written(twelve, exact=True)}; m.inverse()",
            allowed=lambda: Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))).inverse(),
        )
