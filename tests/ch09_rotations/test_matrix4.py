"""Matrix4: build task B9.14."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4
from draw import Components, components
from expect import UNCHANGED, about, expect_close, expect_error, expect_unchanged, xyz
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
    joined,
    moved,
    named,
    subtracted,
    times,
    transposed,
)

POINT = "book 9.4.2, and the docstring of Matrix4.transform"
TIMES = "book 9.4.2, and the docstring of Matrix4.product"
INVERSE = "book 9.4.3, and the docstring of Matrix4.inverse"
FIRST_LINES = "the first lines of matrix3.py"


@pytest.mark.exercise("B9.14")
def test_a_point_is_transformed_and_moved(rng: Random) -> None:
    about.read = POINT
    m, p, a = draw_matrix(rng), components(rng), components(rng)
    twelve = joined(m, p)
    v = Vector3(*a)
    about.call = f"Matrix4{twelve}.transform(Vector3{a})"
    about.cause = "each row's first three numbers times the vector, and then its last number"
    got = xyz(Matrix4(*twelve).transform(v))
    slips = {
        "the point turned, and not moved": applied(m, a),
        "the point moved first, and then turned": applied(m, added(a, p)),
        "what comes of columns taken for rows": moved(transposed(m), p, a),
        "the point moved the other way": subtracted(applied(m, a), p),
        "the first nine entries taken for the three columns": applied(twelve[:9], a),
    }
    why = named(got, about.cause, slips)
    expect_close(got, moved(m, p, a), cause=why, tolerance=LOOSE)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    about.call = f"Matrix4{twelve} @ Vector3{a}, which calls Matrix4.transform"
    got = xyz(Matrix4(*twelve) @ v)
    expect_close(got, moved(m, p, a), tolerance=LOOSE)


@pytest.mark.exercise("B9.14")
def test_one_transformation_after_another(rng: Random) -> None:
    about.read = TIMES
    m, p, n, q = draw_matrix(rng), components(rng), draw_matrix(rng), components(rng)
    first, second = joined(m, p), joined(n, q)
    one, other = Matrix4(*first), Matrix4(*second)
    about.call = f"Matrix4{first}.product(Matrix4{second})"
    about.cause = "the second takes the origin to its translation, and the first takes that on"
    got = entries(one.product(other))
    wanted = joined(times(m, n), moved(m, p, q))
    slips = {
        "right but for the last column, where the translations are added": joined(
            times(m, n), added(p, q)
        ),
        "right but for the last column, where the first translation is missing": joined(
            times(m, n), applied(m, q)
        ),
        "right but for the last column, which is the first translation": joined(times(m, n), p),
        "right but for the last column, which is the second translation": joined(times(m, n), q),
        "right but for the last column, which is moved before it is turned": joined(
            times(m, n), applied(m, added(p, q))
        ),
        "the product in the other order": joined(times(n, m), moved(n, q, p)),
    }
    why = named(got, about.cause, slips, wanted)
    expect_close(got, wanted, cause=why, tolerance=LOOSE)
    expect_unchanged("the first", entries(one), first, cause=UNCHANGED)
    expect_unchanged("the second", entries(other), second, cause=UNCHANGED)
    about.call = f"Matrix4{first} @ Matrix4{second}, which calls Matrix4.product"
    got = entries(one @ other)
    expect_close(got, wanted, tolerance=LOOSE)


def printed_determinant(m: Nine) -> float:
    """Return the determinant as printed: the first product, data[8] data[5] data[2], is added."""
    return determinant(m) + 2.0 * m[6] * m[4] * m[2]


def overwritten(m: Nine, p: Components) -> tuple[Nine, Components]:
    """Return the inverse as the listing's lines make it, in its order, of the matrix itself."""
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


@pytest.mark.exercise("B9.14")
def test_the_translation_has_no_part_in_the_determinant(rng: Random) -> None:
    about.read = "book 9.4.3, and E-28"
    m, p = draw_mirror(rng), components(rng)
    twelve = joined(m, p)
    about.call = f"Matrix4{twelve}.determinant()"
    about.cause = "that of the nine numbers without the last column"
    got = Matrix4(*twelve).determinant()
    slips = {
        "the book's, whose first product has a plus for a minus (E-28)": printed_determinant(m),
        "the determinant of the first nine entries": determinant(twelve[:9]),
        "the determinant with the wrong sign": -determinant(m),
        "the product of the diagonal alone": m[0] * m[4] * m[8],
    }
    why = named(got, about.cause, slips)
    expect_close(got, determinant(m), cause=why, tolerance=1e-10)
    about.cause = "it is small, and not zero: nothing is rounded here"
    small = tuple(1e-7 * number for number in m)
    about.call = f"Matrix4{joined(small, p)}.determinant()"
    got = Matrix4(*joined(small, p)).determinant()
    expect_close(got, determinant(small), tolerance=1e-31)


@pytest.mark.exercise("B9.14", weight=2)
def test_the_inverse_takes_a_point_back(rng: Random) -> None:
    about.read = INVERSE
    drawn = draw_matrix(rng)
    small = tuple(1e-7 * number for number in drawn)
    ring = (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, -5.0, 0.0, 0.0)
    listing = "a Matrix4 has entries 0 to 11, and the book's listing reads entry 15 too (E-13)"
    tiny = "what is small is not singular: Matrix3.inverse, of the nine numbers, knows that"
    zeros = (
        "a zero on the diagonal makes no matrix singular: Matrix3.inverse, of the nine numbers, "
    )
    zeros += "knows that"
    for m, size, how in ((drawn, 1.0, listing), (small, 1e-7, tiny), (ring, 1.0, zeros)):
        p, a = tuple(size * component for component in components(rng)), components(rng)
        twelve = joined(m, p)
        matrix = Matrix4(*twelve)
        there = moved(m, p, a)
        about(f"m = Matrix4{twelve}; m.inverse() at {there}, where m takes {a}", cause=how)
        got = entries(matrix.inverse())
        about.cause = "the nine numbers I by Matrix3.inverse, the translation -I p"
        if isinstance(got, tuple) and len(got) == 12:
            linear, move = (*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11])
            got = moved(linear, move, there)
            plain, turned_back = (
                applied(linear, there),
                applied(transposed(m), subtracted(there, p)),
            )
            slips = {
                "what comes of a translation of -p": subtracted(plain, p),
                "what comes of a translation of p": added(plain, p),
                "what comes of a translation of I p, without its minus": added(
                    plain, applied(linear, p)
                ),
                "what comes of a translation of 0": plain,
                "what comes of the transpose, which is the inverse of rotations only": turned_back,
                "what comes of an inverse that is not divided by the determinant": [
                    determinant(m) * component for component in a
                ],
                "what comes of the book's determinant, with a plus for a minus (E-28)": [
                    determinant(m) / printed_determinant(m) * component for component in a
                ],
                "what comes of the listing where it reads what it has just written (E-30)": moved(
                    *overwritten(m, p), there
                ),
            }
            about.cause = named(got, about.cause, slips)
        expect_close(got, a, tolerance=LOOSE)
        expect_unchanged("m", entries(matrix), twelve, cause=UNCHANGED)


@pytest.mark.exercise("B9.14")
@pytest.mark.robust
def test_a_flat_transformation_has_no_inverse(rng: Random) -> None:
    about.read = INVERSE
    flat = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
    about.cause = "its nine numbers are singular, whatever the translation: Matrix3.inverse "
    about.cause += "refuses them"
    planes = []
    for _ in range(6):  # in one plane but for rounding, of which now and then none is left
        a, b = components(rng), components(rng)
        plane = (*a, *b, *(1.3 * x - 0.7 * y for x, y in zip(a, b, strict=True)))
        planes += [plane, tuple(1e6 * number for number in plane)]
    bad = [(*plane[:4], n, *IDENTITY[5:]) for n in (math.nan, math.inf)]
    for linear in (flat, (0.0,) * 9, *planes, *bad):
        twelve = joined(linear, components(rng))
        expect_error(
            lambda twelve=twelve: Matrix4(*twelve).inverse(),
            ValueError,
            call=f"Matrix4{twelve}.inverse()",
            allowed=lambda: Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))).inverse(),
        )


def small_pair() -> tuple:
    """Return a Matrix4, and what is none and no vector: a Matrix3 and three numbers."""
    return Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))), Matrix3(*IDENTITY), (1.0, 2.0, 3.0)


@pytest.mark.exercise("B9.14")
@pytest.mark.robust
def test_only_vectors_and_matrices_of_twelve() -> None:
    about.read = FIRST_LINES
    matrix, nine, three = small_pair()
    about.cause = "three numbers are no Vector3, and a Matrix3 is no Matrix4: TypeError"
    v = Vector3(1.0, 2.0, 3.0)
    for name, attempt, allowed in (
        ("transform((1, 2, 3))", lambda: matrix.transform(three), lambda: matrix.transform(v)),
        ("product(Matrix3(...))", lambda: matrix.product(nine), lambda: matrix.product(matrix)),
        ("product(Vector3(...))", lambda: matrix.product(v), lambda: matrix.product(matrix)),
    ):
        expect_error(
            attempt,
            TypeError,
            call=f"m = Matrix4(1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3); Matrix4.{name} of m",
            allowed=allowed,
        )
