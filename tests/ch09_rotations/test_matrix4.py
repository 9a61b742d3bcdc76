"""Matrix4 and the change of basis, build tasks B9.14 to B9.16."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion
from draw import Components, components
from expect import expect_close, expect_error, expect_unchanged, xyz
from turning import (
    IDENTITY,
    TIGHT,
    Nine,
    applied,
    determinant,
    draw_matrix,
    draw_quad,
    entries,
    matrix_of,
    quad,
    rijk,
    times,
    transposed,
)

POINT = "book 9.4.1, and the docstring of Matrix4.transform"
TIMES = "book 9.4.1, and the docstring of Matrix4.product"
INVERSE = "book 9.4.3, and the docstring of Matrix4.inverse"
WORLD = "book 9.4.5"
BASIS = "book 9.4.6, and the docstring of change_basis"
FIRST_LINES = "the first lines of matrix.py"
# Sums of products of numbers up to 90.
LOOSE = 1e-11


def joined(linear: Nine, move: Components) -> Nine:
    """Return the twelve numbers of a Matrix4."""
    return (*linear[0:3], move[0], *linear[3:6], move[1], *linear[6:9], move[2])


def moved(linear: Nine, move: Components, v: Components) -> tuple[float, ...]:
    """Return where a point is taken."""
    return tuple(p + q for p, q in zip(applied(linear, v), move, strict=True))


@pytest.mark.exercise("B9.14")
def test_a_point_is_transformed_and_moved(rng: Random) -> None:
    read = POINT
    m, p, a = draw_matrix(rng), components(rng), components(rng)
    twelve = joined(m, p)
    v = Vector3(*a)
    call = f"Matrix4{twelve}.transform(Vector3{a})"
    cause = "each row's first three numbers times the vector, and then its last number"
    got = xyz(Matrix4(*twelve).transform(v))
    expect_close(call, got, moved(m, p, a), cause=cause, read=read, tolerance=LOOSE)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    call = f"Matrix4{twelve} @ Vector3{a}, which calls Matrix4.transform"
    got = xyz(Matrix4(*twelve) @ v)
    expect_close(call, got, moved(m, p, a), cause=cause, read=read, tolerance=LOOSE)


@pytest.mark.exercise("B9.14")
def test_one_transformation_after_another(rng: Random) -> None:
    read = TIMES
    m, p, n, q = draw_matrix(rng), components(rng), draw_matrix(rng), components(rng)
    first, second = joined(m, p), joined(n, q)
    one, other = Matrix4(*first), Matrix4(*second)
    call = f"Matrix4{first}.product(Matrix4{second})"
    cause = "the second takes the origin to its translation, and the first takes that on"
    got = entries(one.product(other))
    wanted = joined(times(m, n), moved(m, p, q))
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=LOOSE)
    expect_unchanged(call, "the first", entries(one), first, read=read)
    expect_unchanged(call, "the second", entries(other), second, read=read)
    call = f"Matrix4{first} @ Matrix4{second}, which calls Matrix4.product"
    got = entries(one @ other)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=LOOSE)


@pytest.mark.exercise("B9.14")
def test_the_translation_has_no_part_in_the_determinant(rng: Random) -> None:
    read = "book 9.4.3, and E-28"
    m, p = draw_matrix(rng), components(rng)
    twelve = joined(m, p)
    call = f"Matrix4{twelve}.determinant()"
    cause = "that of the nine numbers without the last column; the book's first sign is wrong"
    got = Matrix4(*twelve).determinant()
    expect_close(call, got, determinant(m), cause=cause, read=read, tolerance=1e-10)
    cause = "it is small, and not zero: nothing is rounded here"
    small = tuple(1e-7 * number for number in m)
    call = f"Matrix4{joined(small, p)}.determinant()"
    got = Matrix4(*joined(small, p)).determinant()
    expect_close(call, got, determinant(small), cause=cause, read=read, tolerance=1e-31)


@pytest.mark.exercise("B9.14", weight=2)
def test_the_inverse_takes_a_point_back(rng: Random) -> None:
    read = INVERSE
    drawn = draw_matrix(rng)
    small = tuple(1e-7 * number for number in drawn)
    ring = (0.0, 2.0, 0.0, 0.0, 0.0, 3.0, 5.0, 0.0, 0.0)
    for m, size in ((drawn, 1.0), (small, 1e-7), (ring, 1.0)):
        p, a = tuple(size * component for component in components(rng)), components(rng)
        twelve = joined(m, p)
        matrix = Matrix4(*twelve)
        there = moved(m, p, a)
        call = f"m = Matrix4{twelve}; m.inverse() at {there}, where m takes {a}"
        cause = "the nine numbers by Matrix3.inverse; the translation by that, with a minus: not -p"
        got = entries(matrix.inverse())
        if isinstance(got, tuple) and len(got) == 12:
            got = moved((*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11]), there)
        expect_close(call, got, a, cause=cause, read=read, tolerance=LOOSE)
        expect_unchanged(call, "m", entries(matrix), twelve, read=read)


@pytest.mark.exercise("B9.14", weight=0.5)
def test_a_flat_transformation_has_no_inverse(rng: Random) -> None:
    read = INVERSE
    flat = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
    cause = "its nine numbers are singular, whatever the translation: Matrix3.inverse refuses them"
    a, b = components(rng), components(rng)
    # In one plane but for rounding; and not a number, or not finite.
    plane = (*a, *b, *(1.3 * x - 0.7 * y for x, y in zip(a, b, strict=True)))
    bad = [(*plane[:4], n, *IDENTITY[5:]) for n in (math.nan, math.inf)]
    for linear in (flat, (0.0,) * 9, plane, tuple(1e6 * number for number in plane), *bad):
        twelve = joined(linear, components(rng))
        expect_error(
            f"Matrix4{twelve}.inverse()",
            lambda twelve=twelve: Matrix4(*twelve).inverse(),
            ValueError,
            allowed=lambda: Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))).inverse(),
            cause=cause,
            read=read,
        )


def small_pair() -> tuple:
    """Return a Matrix4, and what is none and no vector: a Matrix3 and three numbers."""
    return Matrix4(*joined(IDENTITY, (1.0, 2.0, 3.0))), Matrix3(*IDENTITY), (1.0, 2.0, 3.0)


@pytest.mark.exercise("B9.14", weight=0.5)
def test_only_vectors_and_matrices_of_twelve() -> None:
    read = FIRST_LINES
    matrix, nine, three = small_pair()
    cause = "three numbers are no Vector3, and a Matrix3 is no Matrix4: TypeError"
    v = Vector3(1.0, 2.0, 3.0)
    for name, attempt, allowed in (
        ("transform((1, 2, 3))", lambda: matrix.transform(three), lambda: matrix.transform(v)),
        ("product(Matrix3(...))", lambda: matrix.product(nine), lambda: matrix.product(matrix)),
        ("product(Vector3(...))", lambda: matrix.product(v), lambda: matrix.product(matrix)),
    ):
        expect_error(
            f"m = Matrix4(1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3); Matrix4.{name} of m",
            attempt,
            TypeError,
            allowed=allowed,
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("B9.15")
def test_the_matrix_of_orientation_and_position(rng: Random) -> None:
    read = "book 9.4.4"
    q, p = draw_quad(rng), components(rng)
    place, orientation = Vector3(*p), Quaternion(*q)
    call = f"Matrix4.from_orientation_and_position(Quaternion{q}, Vector3{p})"
    cause = "Matrix3.from_quaternion for the first three columns, and the position as the last one"
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    wanted = joined(matrix_of(q), p)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)
    expect_unchanged(call, "p", xyz(place), p, read=read)
    near = tuple(component * (1.0 + 5e-7) for component in q)
    orientation = Quaternion(*near)
    call = f"Matrix4.from_orientation_and_position(Quaternion{near}, Vector3{p})"
    cause = "a length that is_unit lets pass is near enough"
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-5)
    expect_unchanged(call, "q", rijk(orientation), near, read=read)


@pytest.mark.exercise("B9.15", weight=0.5)
def test_no_matrix_of_what_is_no_orientation() -> None:
    read = "the docstring of from_orientation_and_position"
    p, q = Vector3(1.0, 2.0, 3.0), Quaternion(0.6, 0.0, 0.8, 0.0)
    for name, attempt, error, cause in (
        (
            "Quaternion(0.6, 0, 0.81, 0), Vector3(1, 2, 3)",
            lambda: Matrix4.from_orientation_and_position(Quaternion(0.6, 0.0, 0.81, 0.0), p),
            ValueError,
            "its length is not 1: Matrix3.from_quaternion refuses it",
        ),
        (
            "Quaternion(0.6000012, 0, 0.8000016, 0), Vector3(1, 2, 3)",
            lambda: Matrix4.from_orientation_and_position(
                Quaternion(0.6000012, 0.0, 0.8000016, 0.0), p
            ),
            ValueError,
            "its length is 1 + 2e-6, which is_unit does not let pass",
        ),
        (
            "Quaternion(nan, 0, 0, 0), Vector3(1, 2, 3)",
            lambda: Matrix4.from_orientation_and_position(Quaternion(math.nan, 0.0, 0.0, 0.0), p),
            ValueError,
            "its length is not 1: Matrix3.from_quaternion refuses it",
        ),
        (
            "(0.6, 0, 0.8, 0), Vector3(1, 2, 3)",
            lambda: Matrix4.from_orientation_and_position((0.6, 0.0, 0.8, 0.0), p),
            TypeError,
            "four numbers are no Quaternion",
        ),
        (
            "Quaternion(0.6, 0, 0.8, 0), (1, 2, 3)",
            lambda: Matrix4.from_orientation_and_position(q, (1.0, 2.0, 3.0)),
            TypeError,
            "three numbers are no Vector3",
        ),
    ):
        expect_error(
            f"Matrix4.from_orientation_and_position({name})",
            attempt,
            error,
            allowed=lambda: Matrix4.from_orientation_and_position(q, p),
            cause=cause,
            read=read,
        )


@pytest.mark.exercise("B9.15")
@pytest.mark.parametrize(
    "method", ["transform_inverse", "transform_direction", "transform_inverse_direction"]
)
def test_points_and_directions_there_and_back(rng: Random, method: str) -> None:
    read = f"{WORLD}, and the docstring of {method}"
    # What just passes for a rotation shows whether it is turned back by the inverse.
    m = tuple(number * (1.0 + 4e-6) for number in matrix_of(draw_quad(rng)))
    p, a = components(rng), components(rng)
    twelve = joined(m, p)
    less = tuple(x - y for x, y in zip(a, p, strict=True))
    wanted, cause = {
        "transform_inverse": (
            applied(transposed(m), less),
            "take the translation off first, then turn back by the transpose, not by an inverse",
        ),
        "transform_direction": (applied(m, a), "a direction is turned, and not moved"),
        "transform_inverse_direction": (
            applied(transposed(m), a),
            "a direction is turned back by the transpose, not by an inverse, and not moved",
        ),
    }[method]
    v, matrix = Vector3(*a), Matrix4(*twelve)
    call = f"Matrix4{twelve}.{method}(Vector3{a})"
    got = xyz(getattr(matrix, method)(v))
    # Rounding of numbers up to 30.
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=LOOSE)
    expect_unchanged(call, "v", xyz(v), a, read=read)
    expect_unchanged(call, "the matrix", entries(matrix), twelve, read=read)
    cause = "three numbers are no Vector3: TypeError"
    expect_error(
        f"Matrix4{twelve}.{method}({a})",
        lambda: getattr(matrix, method)(a),
        TypeError,
        allowed=lambda: getattr(matrix, method)(v),
        cause=cause,
        read=FIRST_LINES,
    )


@pytest.mark.exercise("B9.16")
def test_a_turn_told_in_other_axes() -> None:
    read = BASIS
    about_z = matrix_of(quad((0.0, 0.0, 1.0), 0.5 * math.pi))
    z_to_x = matrix_of(quad((0.0, 1.0, 0.0), 0.5 * math.pi))
    call = f"change_basis(Matrix3{about_z}, Matrix3{z_to_x})"
    cause = "a turn about Z, told in axes of which X is where Z was, is one about X: basis m "
    cause += "basis^-1"
    got = entries(change_basis(Matrix3(*about_z), Matrix3(*z_to_x)))
    wanted = matrix_of(quad((1.0, 0.0, 0.0), 0.5 * math.pi))
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=TIGHT)


@pytest.mark.exercise("B9.16")
def test_any_matrix_in_any_axes(rng: Random) -> None:
    read = BASIS
    m, basis = draw_matrix(rng), draw_matrix(rng)
    one, other = Matrix3(*m), Matrix3(*basis)
    call = f"change_basis(Matrix3{m}, Matrix3{basis}), times the basis"
    cause = "basis m basis^-1: the axes need not be at right angles, so that is no transpose"
    got = entries(change_basis(one, other))
    product = times(got, basis) if isinstance(got, tuple) and len(got) == 9 else got
    expect_close(call, product, times(basis, m), cause=cause, read=read, tolerance=LOOSE)
    expect_unchanged(call, "m", entries(one), m, read=read)
    expect_unchanged(call, "basis", entries(other), basis, read=read)


@pytest.mark.exercise("B9.16")
def test_a_motion_told_from_another_place(rng: Random) -> None:
    read = BASIS
    m, p, basis, q = draw_matrix(rng), components(rng), draw_matrix(rng), components(rng)
    first, second = joined(m, p), joined(basis, q)
    a = components(rng)
    call = f"change_basis(Matrix4{first}, Matrix4{second}).transform, where the basis takes {a}"
    cause = "basis m basis^-1, of both with their translations"
    told = change_basis(Matrix4(*first), Matrix4(*second))
    got = entries(told)
    if isinstance(got, tuple) and len(got) == 12:
        linear, move = (*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11])
        got = moved(linear, move, moved(basis, q, a))
    wanted = moved(basis, q, moved(m, p, a))
    # Three products of numbers up to 90.
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-9)


@pytest.mark.exercise("B9.16", weight=0.5)
def test_a_basis_must_fit(rng: Random) -> None:
    read = BASIS
    nine, twelve = draw_matrix(rng), joined(draw_matrix(rng), components(rng))
    small, large = Matrix3(*nine), Matrix4(*twelve)
    flat = Matrix3(*(0.0,) * 9)
    v = Vector3(1.0, 2.0, 3.0)
    for name, attempt, error, cause in (
        ("a Matrix3, a Matrix4", lambda: change_basis(small, large), TypeError, "two sizes"),
        ("a Matrix4, a Matrix3", lambda: change_basis(large, small), TypeError, "two sizes"),
        ("a Vector3, a Vector3", lambda: change_basis(v, v), TypeError, "these are no matrices"),
        ("a Vector3, a Matrix3", lambda: change_basis(v, small), TypeError, "that is no matrix"),
        ("a Matrix3, a Vector3", lambda: change_basis(small, v), TypeError, "that is no matrix"),
        ("a Matrix4, a Vector3", lambda: change_basis(large, v), TypeError, "that is no matrix"),
        (
            "a Matrix3, one of zeros",
            lambda: change_basis(small, flat),
            ValueError,
            "it has no inverse",
        ),
    ):
        expect_error(
            f"change_basis({name})",
            attempt,
            error,
            allowed=lambda: [change_basis(small, small), change_basis(large, large)],
            cause=cause,
            read=read,
        )
