"""Between an object and the world, and other axes: build tasks B9.15 and B9.16."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion
from draw import Components, components
from expect import UNCHANGED, about, expect_close, expect_error, expect_unchanged, xyz
from turning import (
    LOOSE,
    TIGHT,
    Nine,
    added,
    applied,
    draw_matrix,
    draw_mirror,
    draw_quad,
    entries,
    joined,
    matrix_of,
    moved,
    named,
    quad,
    rijk,
    subtracted,
    times,
    transposed,
)

WORLD = "book 9.4.5"
BASIS = "book 9.4.6, and the docstring of change_basis"
FIRST_LINES = "the first lines of matrix3.py"
METHODS = pytest.mark.parametrize(
    "method", ["transform_inverse", "transform_direction", "transform_inverse_direction"]
)


@pytest.mark.exercise("B9.15")
def test_the_matrix_of_orientation_and_position(rng: Random) -> None:
    about.read = "book 9.4.4"
    q, p = draw_quad(rng), components(rng)
    place, orientation = Vector3(*p), Quaternion(*q)
    about.call = f"Matrix4.from_orientation_and_position(Quaternion{q}, Vector3{p})"
    about.cause = "Matrix3.from_quaternion for the first three columns, and the position as the "
    about.cause += "last one"
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    m = matrix_of(q)
    wanted = joined(m, p)
    slips = {
        "right but for the last column, where the position is turned too": joined(m, applied(m, p)),
        "right but for the last column, which is the negative position": joined(
            m, subtracted((0.0, 0.0, 0.0), p)
        ),
        "the nine numbers first, and then the position": (*m, *p),
        "the rotation transposed, as the book prints it (E-11)": joined(transposed(m), p),
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=TIGHT)
    expect_unchanged("p", xyz(place), p, cause=UNCHANGED)
    near = tuple(component * (1.0 + 5e-7) for component in q)
    orientation = Quaternion(*near)
    about.call = f"Matrix4.from_orientation_and_position(Quaternion{near}, Vector3{p})"
    about.cause = "a length that is_unit lets pass is near enough"
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    expect_close(got, wanted, tolerance=1e-5)
    expect_unchanged("q", rijk(orientation), near, cause=UNCHANGED)


@pytest.mark.exercise("B9.15")
@pytest.mark.robust
def test_no_matrix_of_what_is_no_orientation() -> None:
    about.read = "the docstring of from_orientation_and_position"
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
        about.cause = cause
        expect_error(
            attempt,
            error,
            call=f"Matrix4.from_orientation_and_position({name})",
            allowed=lambda: Matrix4.from_orientation_and_position(q, p),
        )


def world_slips(m: Nine, p: Components, a: Components) -> dict[str, Components]:
    """Return what a point or direction comes to by this way or that between object and world.

    ``m`` is a rotation, and a little more: each row times itself is 1 + 8e-6.
    """
    size = m[0] ** 2 + m[1] ** 2 + m[2] ** 2
    back = transposed(m)
    inverse = tuple(number / size for number in back)
    return {
        "turned on, and then moved": moved(m, p, a),
        "turned on, and not moved": applied(m, a),
        "moved back first, and then turned on": applied(m, subtracted(a, p)),
        "turned on, and then moved back": subtracted(applied(m, a), p),
        "turned back, and not moved": applied(back, a),
        "moved back first, and then turned back": applied(back, subtracted(a, p)),
        "turned back first, and then moved back": subtracted(applied(back, a), p),
        "turned back first, and then moved on": moved(back, p, a),
        "moved on first, and then turned back": applied(back, added(a, p)),
        "done by an inverse, which takes long, and undoes the scale of 1 + 4e-6 here": applied(
            inverse, subtracted(a, p)
        ),
        "turned back by an inverse, which takes long, and undoes the scale of 1 + 4e-6 here": (
            applied(inverse, a)
        ),
    }


@pytest.mark.exercise("B9.15")
@METHODS
def test_points_and_directions_there_and_back(rng: Random, method: str) -> None:
    about.read = f"{WORLD}, and the docstring of {method}"
    # What just passes for a rotation shows whether it is turned back by the inverse.
    m = tuple(number * (1.0 + 4e-6) for number in matrix_of(draw_quad(rng)))
    p, a = components(rng), components(rng)
    twelve = joined(m, p)
    wanted, about.cause = {
        "transform_inverse": (
            applied(transposed(m), subtracted(a, p)),
            "take the translation off first, then turn back by the transpose, not by an inverse",
        ),
        "transform_direction": (applied(m, a), "a direction is turned, and not moved"),
        "transform_inverse_direction": (
            applied(transposed(m), a),
            "a direction is turned back by the transpose, not by an inverse, and not moved",
        ),
    }[method]
    v, matrix = Vector3(*a), Matrix4(*twelve)
    about.call = f"Matrix4{twelve}.{method}(Vector3{a})"
    got = xyz(getattr(matrix, method)(v))
    why = named(got, about.cause, world_slips(m, p, a))
    # Rounding of numbers up to 30.
    expect_close(got, wanted, cause=why, tolerance=LOOSE)
    expect_unchanged("v", xyz(v), a, cause=UNCHANGED)
    expect_unchanged("the matrix", entries(matrix), twelve, cause=UNCHANGED)


@pytest.mark.exercise("B9.15")
@pytest.mark.robust
@METHODS
def test_only_vectors_go_there_and_back(rng: Random, method: str) -> None:
    twelve, a = joined(matrix_of(draw_quad(rng)), components(rng)), components(rng)
    matrix = Matrix4(*twelve)
    expect_error(
        lambda: getattr(matrix, method)(a),
        TypeError,
        call=f"Matrix4{twelve}.{method}({a})",
        allowed=lambda: getattr(matrix, method)(Vector3(*a)),
        cause="three numbers are no Vector3: TypeError",
        read=FIRST_LINES,
    )


@pytest.mark.exercise("B9.16")
def test_a_turn_told_in_other_axes() -> None:
    about.read = BASIS
    about_z = matrix_of(quad((0.0, 0.0, 1.0), 0.5 * math.pi))
    z_to_x = matrix_of(quad((0.0, 1.0, 0.0), 0.5 * math.pi))
    about.call = f"change_basis(Matrix3{about_z}, Matrix3{z_to_x})"
    about.cause = "a turn about Z, told in axes of which X is where Z was, is one about X: basis m "
    about.cause += "basis^-1"
    got = entries(change_basis(Matrix3(*about_z), Matrix3(*z_to_x)))
    wanted = matrix_of(quad((1.0, 0.0, 0.0), 0.5 * math.pi))
    back = transposed(z_to_x)
    slips = {
        "basis^-1 m basis, the other way round": times(times(back, about_z), z_to_x),
        "basis m, from one side only": times(z_to_x, about_z),
        "m basis, from one side only": times(about_z, z_to_x),
        "m basis^-1, from one side only": times(about_z, back),
        "basis^-1 m, from one side only": times(back, about_z),
        "basis m basis, without the inverse": times(times(z_to_x, about_z), z_to_x),
        "m as it was": about_z,
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.16")
def test_any_matrix_in_any_axes(rng: Random) -> None:
    about.read = BASIS
    m, basis = draw_matrix(rng), draw_mirror(rng)
    one, other = Matrix3(*m), Matrix3(*basis)
    about.call = f"change_basis(Matrix3{m}, Matrix3{basis}), times the basis"
    about.cause = "basis m basis^-1, where the axes need not be at right angles"
    got = entries(change_basis(one, other))
    product = times(got, basis) if isinstance(got, tuple) and len(got) == 9 else got
    by_transpose = times(times(times(basis, m), transposed(basis)), basis)
    slips = {"what comes of the transpose of the basis in place of its inverse": by_transpose}
    why = named(product, about.cause, slips)
    expect_close(product, times(basis, m), cause=why, tolerance=LOOSE)
    expect_unchanged("m", entries(one), m, cause=UNCHANGED)
    expect_unchanged("basis", entries(other), basis, cause=UNCHANGED)


@pytest.mark.exercise("B9.16")
def test_a_motion_told_from_another_place(rng: Random) -> None:
    about.read = BASIS
    m, p, basis, q = draw_matrix(rng), components(rng), draw_mirror(rng), components(rng)
    first, second = joined(m, p), joined(basis, q)
    a = components(rng)
    about.call = f"change_basis(Matrix4{first}, Matrix4{second}).transform, where the basis takes "
    about.call += f"{a}"
    about.cause = "basis m basis^-1, of both with their translations"
    told = change_basis(Matrix4(*first), Matrix4(*second))
    got = entries(told)
    if isinstance(got, tuple) and len(got) == 12:
        linear, move = (*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11])
        got = moved(linear, move, moved(basis, q, a))
    wanted = moved(basis, q, moved(m, p, a))
    # Three products of numbers up to 90.
    expect_close(got, wanted, tolerance=1e-9)


@pytest.mark.exercise("B9.16")
@pytest.mark.robust
def test_a_basis_must_fit(rng: Random) -> None:
    about.read = BASIS
    nine, twelve = draw_mirror(rng), joined(draw_matrix(rng), components(rng))
    small, large = Matrix3(*nine), Matrix4(*twelve)
    flat = Matrix3(*(0.0,) * 9)
    v = Vector3(1.0, 2.0, 3.0)
    sizes = "the two are of two sizes: ask type(m) is type(basis)"
    none = "a vector is no matrix: ask isinstance for both"
    for name, attempt, error, cause in (
        ("a Matrix3, a Matrix4", lambda: change_basis(small, large), TypeError, sizes),
        ("a Matrix4, a Matrix3", lambda: change_basis(large, small), TypeError, sizes),
        ("a Vector3, a Vector3", lambda: change_basis(v, v), TypeError, none),
        ("a Vector3, a Matrix3", lambda: change_basis(v, small), TypeError, none),
        ("a Matrix3, a Vector3", lambda: change_basis(small, v), TypeError, none),
        ("a Matrix4, a Vector3", lambda: change_basis(large, v), TypeError, none),
        (
            "a Matrix3, one of zeros",
            lambda: change_basis(small, flat),
            ValueError,
            "it has no inverse",
        ),
    ):
        about.cause = cause
        expect_error(
            attempt,
            error,
            call=f"change_basis({name})",
            allowed=lambda: [change_basis(small, small), change_basis(large, large)],
        )
