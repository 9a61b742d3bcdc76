"""Matrix4, and between an object and the world: build tasks B9.14 to B9.16."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion
from draw import Triple, vector
from expect import about, expect_close, expect_error, xyz
from turning import (
    IDENTITY,
    LOOSE,
    TIGHT,
    Nine,
    applied,
    determinant,
    draw_matrix,
    draw_mirror,
    draw_quad,
    entries,
    expect_kept,
    joined,
    matrix_of,
    moved,
    named,
    quad,
    rijk,
    times,
    transposed,
    written,
)

POINT = "book 9.4.2, and the docstring of Matrix4.transform"
TIMES = "book 9.4.2, and the docstring of Matrix4.product"
E28 = "book 9.4.3, and E-28"
WORLD = "book 9.4.5, and the docstring of the method"
METHODS = ("transform_inverse", "transform_direction", "transform_inverse_direction")
INVERSE = "book 9.4.3, and the docstring of Matrix4.inverse"
BASIS = "book 9.4.6, and the docstring of change_basis"
ROWS = ", row by row"


def parts_of(twelve: Sequence[float]) -> tuple[Nine, Triple]:
    """Return the 3x3 part and the translation of a Matrix4."""
    return (*twelve[0:3], *twelve[4:7], *twelve[8:11]), Triple(twelve[3::4])


@pytest.mark.exercise("B9.14", asks="add the translation, and return a new vector", read=POINT)
def test_a_point_is_transformed_and_moved(rng: Random) -> None:
    linear, p, a = draw_matrix(rng), vector(rng), vector(rng)
    twelve = joined(linear, p)
    with calls("Multiply each row's first three numbers by the vector, and add its fourth number."):
        m, v = Matrix4(*twelve), Vector3(*a)
        got = m.transform(v)
    slips = {
        "You leave out the translation.": applied(linear, a),
        "You add the translation before you multiply by the 3x3 part.": applied(linear, a + p),
        "You multiply the vector by the columns of the matrix instead of its rows.":
            moved(transposed(linear), p, a),
        "You subtract the translation. Add it instead.": moved(linear, -p, a),
        "You use the first nine entries as the rotation.": applied(twelve[:9], a),
        "You use the last three entries as the translation.": moved(twelve[:9], twelve[9:], a),
    }  # fmt: skip
    wanted = moved(linear, p, a)
    expect_close(xyz(got), wanted, slips, tolerance=LOOSE)
    expect_kept("the vector", v, a)
    expect_close(xyz(m @ v), wanted, then="; m @ v, which calls m.transform", tolerance=LOOSE)


@pytest.mark.exercise("B9.14", asks="a new matrix that applies m first", read=TIMES)
def test_one_transformation_after_another(rng: Random) -> None:
    m, p, n, q = draw_matrix(rng), vector(rng), draw_matrix(rng), vector(rng)
    first, second = joined(m, p), joined(n, q)
    with calls("If a has the parts A and p, and b has B and q, the result has A B and A q + p."):
        a = Matrix4(*first)
        b = Matrix4(*second)
        product = a.product(b)
    columns = {
        "Your last column is the sum of the two translations.": p + q,
        "Your last column lacks the translation of a.": applied(m, q),
        "Your last column is only the translation of a.": p,
        "Your last column is only the translation of b.": q,
        "You rotate both translations to get the last column.": applied(m, p + q),
        "Your last column is b.transform(the translation of a).": moved(n, q, p),
    }
    slips = {slip: joined(times(m, n), column) for slip, column in columns.items()} | {
        "You multiply the 3x3 parts in the wrong order.": joined(times(n, m), moved(m, p, q)),
        "You multiply each number of a by the number of b in the same position. Multiply rows by "
        "columns.": [x * y for x, y in zip(first, second, strict=True)],
        "You return the product in the other order.": joined(times(n, m), moved(n, q, p)),
    }
    got, wanted = entries(product), joined(times(m, n), moved(m, p, q))
    why = named(got, about.cause, slips, wanted)
    expect_close(got, wanted, then=ROWS, cause=why, tolerance=LOOSE)
    expect_kept("a", entries(a), first)
    expect_kept("b", entries(b), second)
    expect_close(entries(a @ b), wanted, then="; a @ b, which calls a.product", tolerance=LOOSE)


def overwritten(m: Nine, p: Triple) -> tuple[Nine, Triple]:
    """Return the inverse as the book's listing computes it, in place and in its order."""
    d, det = [*joined(m, p)], determinant(m)

    def minor(i: int, j: int, k: int, n: int) -> float:
        return d[i] * d[j] - d[k] * d[n]

    for place, *four in (
        *((0, 5, 10, 9, 6), (4, 8, 6, 4, 10), (8, 4, 9, 8, 5), (1, 9, 2, 1, 10), (5, 0, 10, 8, 2)),
        *((9, 8, 1, 0, 9), (2, 1, 6, 5, 2), (6, 4, 2, 0, 6), (10, 0, 5, 4, 1)),
    ):
        d[place] = minor(*four) / det
    for place, x, y, z in (
        (3, (9, 6, 5, 10), (1, 10, 9, 2), (5, 2, 1, 6)),
        (7, (4, 10, 8, 6), (8, 2, 0, 10), (0, 6, 4, 2)),
        (11, (8, 5, 4, 9), (0, 9, 8, 1), (4, 1, 0, 5)),
    ):
        d[place] = (d[3] * minor(*x) + d[7] * minor(*y) + d[11] * minor(*z)) / det
    return parts_of(d)


@pytest.mark.exercise("B9.14", asks="Compute the determinant of the 3x3 part", read=E28)
def test_the_determinant_ignores_the_translation(rng: Random) -> None:
    linear, p = draw_mirror(rng), vector(rng)
    twelve = joined(linear, p)
    with calls("Compute the determinant of the nine numbers to the left of the last column."):
        got = Matrix4(*twelve).determinant()
    slips = {
        "You use the book's formula, which has a plus in place of a minus. Correct it as E-28 "
        "says.": determinant(linear) + 2.0 * linear[6] * linear[4] * linear[2],
        "You use the first nine entries.": determinant(twelve[:9]),
        "Your determinant has the wrong sign.": -determinant(linear),
        "You return only the product of the diagonal.": linear[0] * linear[4] * linear[8],
    }
    expect_close(got, determinant(linear), slips, tolerance=1e-10)
    small = tuple(float(f"{number}e-7") for number in linear)
    twelve = joined(small, p)
    with calls("The determinant is small, but it is not zero. Don't round it to 0."):
        got = Matrix4(*twelve).determinant()
    expect_close(got, determinant(small), tolerance=1e-31)


def inverse_slips(m: Nine, p: Triple, a: Triple, linear: Nine) -> dict[str, Sequence[float]]:
    """Return where likely mistakes in the inverse take m @ a back to, if its 3x3 part is linear."""
    there, det = p + applied(m, a), determinant(m)
    printed = det + 2.0 * m[6] * m[4] * m[2]  # with a plus before data[8] data[5] data[2]
    plain = Triple(applied(linear, there))
    return {
        "You don't invert the 3x3 part. Use Matrix3.inverse.": applied(m, there - p),
        "You use -p as the translation.": plain - p,
        "You use p as the translation.": plain + p,
        "You leave out the minus sign of the translation.": applied(linear, there + p),
        "Your inverse has no translation.": plain,
        "You multiply the translation by the 3x3 part of m.": plain - applied(m, p),
        "You transpose the 3x3 part, but the transpose is the inverse only for a rotation. Use "
        "Matrix3.inverse instead.": applied(transposed(m), there - p),
        "You don't divide by the determinant. Use Matrix3.inverse, which does.": det * a,
        "You divide by the book's determinant, which has a plus in place of a minus. Correct it "
        "as E-28 says.": det / printed * a,
        "You use the book's listing, which reads entries that it has already overwritten (E-30). "
        "Compute all entries before you store them.": moved(*overwritten(m, p), there),
    }


@pytest.mark.exercise("B9.14", asks="by the negative of the translation", weight=2, read=INVERSE)
def test_the_inverse_takes_a_point_back(rng: Random) -> None:
    drawn = draw_matrix(rng)
    small = tuple(float(f"{number}e-7") for number in drawn)
    ring = (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, -5.0, 0.0, 0.0)
    listing = "The book's listing reads entry 15 (E-13), but a Matrix4 has only 0 to 11."
    call = "Call Matrix3.inverse on the numbers to the left of the last column."
    tiny = f"A matrix isn't singular just because its numbers are small. {call}"
    zeros = f"Zeros on the diagonal don't make a matrix singular. {call}"
    for linear, size, how in ((drawn, "e0", listing), (small, "e-7", tiny), (ring, "e0", zeros)):
        p, a = Triple(float(f"{part}{size}") for part in vector(rng)), vector(rng)
        twelve = joined(linear, p)
        with calls(how):
            m = Matrix4(*twelve)
            inverse = m.inverse()
        got = entries(inverse)
        why = "If A is the 3x3 part of the inverse and p the translation of m, use -A p."
        if isinstance(got, tuple) and len(got) == 9:
            why = "Your result is a Matrix3. Return a Matrix4, with a translation too."
        if isinstance(got, tuple) and len(got) == 12:
            back, move = parts_of(got)
            got = moved(back, move, moved(linear, p, a))
            why = named(got, why, inverse_slips(linear, p, a, back))
        then = f"; m.inverse() @ (m @ Vector3{a})"
        expect_close(got, a, then=then, cause=why, tolerance=LOOSE)
        expect_kept("m", entries(m), twelve)


@pytest.mark.exercise("B9.14", asks="if Matrix3.inverse rejects the 3x3 part", read=INVERSE)
@pytest.mark.robust
def test_a_flat_transformation_has_no_inverse(rng: Random) -> None:
    planes = [(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0), (0.0,) * 9]
    for _ in range(6):  # rows in one plane, apart from rounding errors, which may be zero
        a, b = vector(rng), vector(rng)
        plane = (*a, *b, *(1.3 * a - 0.7 * b))
        planes += [plane, tuple(1e6 * number for number in plane)]
    for linear in planes:
        twelve = joined(linear, vector(rng))
        expect_error(
            lambda twelve=twelve: Matrix4(*twelve).inverse(),
            ValueError,
            call=f"m = {written(twelve, exact=True)}; m.inverse()",
            cause="The 3x3 part of this matrix is singular, so the matrix has no inverse. Raise "
            "ValueError, as Matrix3.inverse does for the 3x3 part.",
            allowed=lambda: Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))).inverse(),
        )


@pytest.mark.exercise("B9.15", asks="the matrix rotates by q and then adds p", read="book 9.4.4")
def test_the_matrix_of_orientation_and_position(rng: Random) -> None:
    turn, place = draw_quad(rng), vector(rng)
    with calls("The first three columns are Matrix3.from_quaternion(q), and the last one is p."):
        q, p = Quaternion(*turn), Vector3(*place)
        m = Matrix4.from_orientation_and_position(q, p)
    linear = matrix_of(turn)
    wanted = joined(linear, place)
    slips = {
        "You rotate the position.": joined(linear, applied(linear, place)),
        "Your last column is -p instead of p.": joined(linear, -place),
        "You put the position after the nine numbers of the rotation. The entries are stored row "
        "by row, so put each component at the end of its row.": (*linear, *place),
        "You transpose the rotation. Either you copy the book's matrix (E-11), or you use the "
        "conjugate of q.": joined(transposed(linear), place),
    }
    expect_close(entries(m), wanted, slips, then=ROWS, tolerance=TIGHT)
    expect_kept("p", p, place)
    near = tuple(component * (1.0 + 5e-7) for component in turn)
    with calls("The length is close enough to 1 for is_unit(), so accept this quaternion."):
        q, p = Quaternion(*near), Vector3(*place)
        m = Matrix4.from_orientation_and_position(q, p)
    expect_close(entries(m), wanted, then=ROWS, tolerance=1e-5)
    expect_kept("q", rijk(q), near)


def world_slips(method: str, m: Nine, p: Triple, a: Triple) -> dict[str, Sequence[float]]:
    """Return the results of wrong orders and directions between the object and the world.

    ``m`` is nearly a rotation: the dot product of each row with itself is 1 + 8e-6.
    """
    back, forward = transposed(m), "You rotate the vector forward."
    reversed_ = "You rotate the vector back."
    shifted = "You subtract the translation and then rotate forward."
    to_go_back = " To rotate back, multiply by the transpose of the 3x3 part."
    inverse = tuple(number / (m[0] ** 2 + m[1] ** 2 + m[2] ** 2) for number in back)
    general = "You use a general inverse, which is slower and differs slightly from the transpose."
    slips = {}
    if method == "transform_inverse":
        shifted += to_go_back
        reversed_ = "You rotate the vector back but don't subtract the translation."
        slips = {general: applied(inverse, a - p)}
    elif method == "transform_inverse_direction":
        forward += to_go_back
        slips = {general: applied(inverse, a)}
    else:
        reversed_ += " To rotate forward, multiply by the 3x3 part itself, not by its transpose."
    return slips | {
        "You rotate the vector and then add the translation.": moved(m, p, a),
        forward: applied(m, a),
        shifted: applied(m, a - p),
        "You rotate forward and then subtract the translation.": moved(m, -p, a),
        reversed_: applied(back, a),
        "You subtract the translation and then rotate back.": applied(back, a - p),
        "You rotate back and then subtract the translation.": moved(back, -p, a),
        "You rotate back and then add the translation.": moved(back, p, a),
        "You add the translation and then rotate back.": applied(back, a + p),
        "You subtract the vector from the translation.": applied(back, p - a),
    }


@pytest.mark.exercise("B9.15", asks="then multiply by the transpose of the 3x3 part", read=WORLD)
@pytest.mark.parametrize("method", METHODS)
def test_points_and_directions_there_and_back(rng: Random, method: str) -> None:
    # A matrix that just passes for a rotation shows whether an inverse was used.
    linear = tuple(number * (1.0 + 4e-6) for number in matrix_of(draw_quad(rng)))
    p, a = vector(rng), vector(rng)
    twelve, back = joined(linear, p), transposed(linear)
    alone = "The translation doesn't affect a direction, so just multiply the vector by the"
    first = "To go back, subtract the translation first and then rotate back."
    wanted, cause = {
        "transform_inverse": (applied(back, a - p), first),
        "transform_direction": (applied(linear, a), f"{alone} 3x3 part."),
        "transform_inverse_direction": (applied(back, a), f"{alone} transpose of the 3x3 part."),
    }[method]
    with calls(cause, f"m = {written(twelve)}; m.{method}(Vector3{a})"):
        m, v = Matrix4(*twelve), Vector3(*a)
        got = getattr(m, method)(v)
    # Rounding of numbers up to 30.
    expect_close(xyz(got), wanted, world_slips(method, linear, p, a), tolerance=LOOSE)
    expect_kept("the vector", v, a)
    expect_kept("the matrix", entries(m), twelve)


def changed(n: Nine, axes: Nine) -> Nine:
    """Return the numbers of a matrix in other axes, as change_basis computes it."""
    with calls("Return basis @ m @ basis.inverse()."):
        m = Matrix3(*n)
        basis = Matrix3(*axes)
        result = change_basis(m, basis)
    expect_kept("m", entries(m), n)
    expect_kept("basis", entries(basis), axes)
    return entries(result)


@pytest.mark.exercise("B9.16", asks="It converts them to the old basis, applies m", read=BASIS)
def test_a_rotation_in_other_axes(rng: Random) -> None:
    # Rotations about no axis of their own tell all mistakes apart.
    m, basis = matrix_of(draw_quad(rng)), matrix_of(draw_quad(rng))
    got, back = changed(m, basis), transposed(basis)
    slips = {
        "You return basis.inverse() @ m @ basis.": times(times(back, m), basis),
        "You return basis @ m, without the inverse on the right.": times(basis, m),
        "You return only m @ basis.": times(m, basis),
        "You return m @ basis.inverse(), without the basis on the left.": times(m, back),
        "You return only basis.inverse() @ m.": times(back, m),
        "You return basis @ m @ basis, without the inverse.": times(times(basis, m), basis),
        "You use the inverse of m. Use m itself.": times(times(basis, transposed(m)), back),
        "m itself": m,
    }
    why = named(got, about.cause, slips)
    about_x, about_y, about_z = (
        tuple(round(n, 15) for n in matrix_of(quad(axis, 0.5 * math.pi)))
        for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    )
    got = changed(about_z, about_y)
    expect_close(got, about_x, then=ROWS, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.16", asks="as the product basis * m * basis^-1", read=BASIS)
def test_any_matrix_in_any_axes(rng: Random) -> None:
    m, basis = draw_matrix(rng), draw_mirror(rng)
    got = changed(m, basis)
    product = times(got, basis) if isinstance(got, tuple) and len(got) == 9 else got
    slips = {
        "You use the transpose of the basis instead of its inverse. The two differ here, because "
        "the axes are not perpendicular.": times(times(times(basis, m), transposed(basis)), basis)
    }
    then = "; change_basis(m, basis) @ basis, row by row"
    expect_close(product, times(basis, m), slips, then=then, tolerance=LOOSE)


@pytest.mark.exercise("B9.16", asks="both a Matrix4, whose translations count too", read=BASIS)
def test_a_motion_with_a_translation(rng: Random) -> None:
    linear, axes, p, q = draw_matrix(rng), draw_mirror(rng), vector(rng), vector(rng)
    a = vector(rng)
    first, second = joined(linear, p), joined(axes, q)
    with calls("Return basis @ m @ basis.inverse() of the Matrix4s, with their translations."):
        m = Matrix4(*first)
        basis = Matrix4(*second)
        result = change_basis(m, basis)
    got = entries(result)
    if isinstance(got, tuple) and len(got) == 12:
        got = moved(*parts_of(got), moved(axes, q, a))
    then = f"; change_basis(m, basis) @ (basis @ Vector3{a})"
    # Three products of numbers up to 90.
    expect_close(got, moved(axes, q, moved(linear, p, a)), then=then, tolerance=1e-9)
