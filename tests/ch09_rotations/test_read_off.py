"""Exercises 9.5 and 9.6: what a matrix of twelve numbers says, and its inverse the easy way."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.exercises import easy_inverse, read_off
from ch09_rotations.matrix import Matrix4
from draw import components
from expect import (
    about,
    expect_close,
    is_plain,
    xyz,
)
from turning import (
    TIGHT,
    applied,
    draw_quad,
    draw_slight_turn,
    entries,
    expect_kept,
    joined,
    matrix_of,
    moved,
    named,
    short,
    subtracted,
    transposed,
    written,
)

OFF = "the docstring of read_off"
EASY = "the docstring of easy_inverse"


@pytest.mark.exercise("9.5", asks="into rotation, the first three columns, and position")
def test_rotation_and_position_are_read_off(rng: Random) -> None:
    about.read = OFF
    m, p = draw_slight_turn(rng), components(rng)
    twelve = joined(m, p)
    matrix = Matrix4(*twelve)
    about.call = f"m = {written(twelve)}; read_off(m)"
    about.cause = (
        "Return the first three columns as the rotation (a Matrix3) and the last column as the "
        "position (a Vector3)."
    )
    rotation, position = read_off(matrix)
    if isinstance(rotation, Vector3):
        about.cause = "You return the position first. Return the rotation and then the position."
    name = f"{about.call}; the rotation, row by row"
    got = entries(rotation)
    slips = {
        "You return the transpose of the rotation. Don't swap rows and columns.": transposed(m),
        "You return the first nine entries. Leave out every fourth one, because it belongs to the "
        "position.": twelve[:9],
        "You return the last three columns as the rotation. Return the first three.": [
            n for place, n in enumerate(twelve) if place % 4
        ],
    }
    why = named(got, about.cause, slips)
    # If you compute it from transformed points, numbers up to 11 are rounded.
    expect_close(got, m, call=name, cause=why, tolerance=TIGHT)
    name = f"{about.call}; the position"
    got = xyz(position)
    x, y, z = applied(transposed(m), p)
    slips = {
        "You return the last row as the position.": twelve[8:11],
        "You return the last three entries as the position.": twelve[9:],
        "You return the first column.": (m[0], m[3], m[6]),
        "You return the position of the inverse matrix.": (-x, -y, -z),
    }
    about.cause = "Return the last column instead."
    if is_plain(position):
        about.cause = "Return the position as a Vector3."
    why = named(got, about.cause, slips)
    expect_close(got, p, call=name, cause=why, tolerance=0.0)
    expect_kept("the matrix", entries(matrix), twelve)


@pytest.mark.exercise("9.6", asks="so transpose the 3x3 part", weight=2)
def test_the_easy_inverse(rng: Random) -> None:
    about.read = EASY
    m, p = matrix_of(draw_quad(rng)), components(rng)
    twelve = joined(m, p)
    matrix = Matrix4(*twelve)
    about.call = f"m = {written(twelve)}; easy_inverse(m), row by row"
    about.cause = (
        "It should be -T p, where p is the position of m, and T is the transposed rotation."
    )
    got = entries(easy_inverse(matrix))
    t = transposed(m)
    x, y, z = applied(t, p)
    wanted = joined(t, (-x, -y, -z))
    turned_on = applied(m, p)
    slips = {
        "Your last column is -p.": joined(t, subtracted((0.0, 0.0, 0.0), p)),
        "Your last column is p.": joined(t, p),
        "Your last column is R p, where R is the rotation of m.": joined(t, turned_on),
        "The minus sign applies only to the first of the three products. Put the whole sum in "
        "parentheses.": joined(
            t, subtracted((x, y, z), tuple(2.0 * n * p[0] for n in (t[0], t[3], t[6])))
        ),
        "You put the position after the nine numbers of the rotation. The entries are stored row "
        "by row, so put each component at the end of its row.": (*t, -x, -y, -z),
        "You return a Matrix3. Return a Matrix4, with the position of the inverse.": t,
        "Your last column is T p, without the minus sign.": joined(t, (x, y, z)),
        "Your last column is -R p, where R is the rotation of m.": joined(
            t, subtracted((0.0, 0.0, 0.0), turned_on)
        ),
        "You don't transpose the rotation. Swap its rows and columns.": joined(m, (-x, -y, -z)),
        "You negate the position of m but don't change the rotation. Transpose it, and multiply "
        "-p by the transpose.": joined(m, subtracted((0.0, 0.0, 0.0), p)),
    }
    why = named(got, about.cause, slips)
    if why == about.cause:
        why = "The inverse is the transposed rotation T with the position -T p, where p is the "
        why += "position of m."
    # Rounding of numbers up to 17.
    expect_close(got, wanted, cause=why, tolerance=TIGHT)
    expect_kept("the matrix", entries(matrix), twelve)


@pytest.mark.exercise("9.6", asks="which is wrong if the 3x3 part is not a rotation", weight=0.5)
def test_the_easy_inverse_divides_by_nothing(rng: Random) -> None:
    about.read = EASY
    m, p = tuple(2.0 * n for n in matrix_of(draw_quad(rng))), components(rng)
    for linear in (m, (0.0,) * 9):
        twelve = joined(linear, p)
        about.call = (
            f"m = {written(twelve)}, whose 3x3 part is not a rotation; easy_inverse(m), row "
        )
        about.call += "by row"
        about.cause = (
            "You probably use a general inverse, which divides by the determinant. Transpose the "
            "3x3 part instead, even if it is not a rotation."
        )
        got = entries(easy_inverse(Matrix4(*twelve)))
        x, y, z = applied(transposed(linear), p)
        wanted = joined(transposed(linear), (-x, -y, -z))
        # Rounding of numbers up to 33.
        expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("9.6", asks="invert a matrix that rotates and then translates")
def test_the_easy_inverse_undoes_a_motion(rng: Random) -> None:
    about.read = EASY
    m, p, a = matrix_of(draw_quad(rng)), components(rng), components(rng)
    twelve = joined(m, p)
    there = moved(m, p, a)
    about.call = f"m = {written(twelve)}; easy_inverse(m) @ (m @ Vector3{short(a)})"
    about.cause = (
        "Your inverse doesn't take the point back. It should subtract the position of m and then "
        "rotate back."
    )
    got = entries(easy_inverse(Matrix4(*twelve)))
    if isinstance(got, tuple) and len(got) == 12:
        got = moved((*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11]), there)
    expect_close(got, a, tolerance=1e-11)
