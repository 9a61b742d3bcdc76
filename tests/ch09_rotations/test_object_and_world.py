"""Between an object and the world, and other axes: build tasks B9.15 and B9.16."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3, Matrix4, change_basis
from ch09_rotations.quaternion import Quaternion
from draw import Components, components
from expect import about, expect_close, xyz
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
    expect_kept,
    joined,
    matrix_of,
    moved,
    named,
    quad,
    rijk,
    short,
    subtracted,
    times,
    transposed,
    written,
)

WORLD = "book 9.4.5"
BASIS = "book 9.4.6, and the docstring of change_basis"
METHODS = pytest.mark.parametrize(
    "method", ["transform_inverse", "transform_direction", "transform_inverse_direction"]
)


@pytest.mark.exercise("B9.15", asks="the matrix rotates by q and then adds p")
def test_the_matrix_of_orientation_and_position(rng: Random) -> None:
    about.read = "book 9.4.4"
    q, p = draw_quad(rng), components(rng)
    place, orientation = Vector3(*p), Quaternion(*q)
    about.call = f"q = Quaternion{short(q)}; p = Vector3{short(p)}; "
    about.call += "Matrix4.from_orientation_and_position(q, p), row by row"
    about.cause = (
        "The first three columns should be Matrix3.from_quaternion(q), and the last column should "
        "be p."
    )
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    m = matrix_of(q)
    wanted = joined(m, p)
    slips = {
        "You rotate the position p before you put it into the last column. Put it there "
        "unchanged.": joined(m, applied(m, p)),
        "Your last column is -p instead of p.": joined(m, subtracted((0.0, 0.0, 0.0), p)),
        "You put the position after the nine numbers of the rotation. The entries are stored row "
        "by row, so put each component at the end of its row.": (*m, *p),
        "You transpose the rotation. Either you copy the book's matrix (E-11), or you use the "
        "conjugate of q.": joined(transposed(m), p),
    }
    why = named(got, about.cause, slips)
    expect_close(got, wanted, cause=why, tolerance=TIGHT)
    expect_kept("p", xyz(place), p)
    near = tuple(component * (1.0 + 5e-7) for component in q)
    orientation = Quaternion(*near)
    about.call = f"q = Quaternion{short(near)}, of length 1 + 5e-7; p = Vector3{short(p)}; "
    about.call += "Matrix4.from_orientation_and_position(q, p), row by row"
    about.cause = "The length of this quaternion is close enough to 1 for is_unit(), so accept it."
    got = entries(Matrix4.from_orientation_and_position(orientation, place))
    expect_close(got, wanted, tolerance=1e-5)
    expect_kept("q", rijk(orientation), near)


def world_slips(method: str, m: Nine, p: Components, a: Components) -> dict[str, Components]:
    """Return the results of wrong orders and directions between the object and the world.

    ``m`` is nearly a rotation: the dot product of each row with itself is 1 + 8e-6.
    """
    size = m[0] ** 2 + m[1] ** 2 + m[2] ** 2
    back = transposed(m)
    inverse = tuple(number / size for number in back)
    rotated, shifted = "You rotate the vector forward.", "You subtract the translation and then "
    shifted += "rotate forward."
    reversed_ = "You rotate the vector back."
    to_go_back = " To rotate back, multiply by the transpose of the 3x3 part."
    if method == "transform_inverse":
        shifted += to_go_back
        reversed_ = "You rotate the vector back but don't subtract the translation."
    elif method == "transform_inverse_direction":
        rotated += to_go_back
    else:
        reversed_ += " To rotate forward, multiply by the 3x3 part itself, not by its transpose."
    slips = {
        "You rotate the vector and then add the translation.": moved(m, p, a),
        rotated: applied(m, a),
        shifted: applied(m, subtracted(a, p)),
        "You rotate forward and then subtract the translation.": subtracted(applied(m, a), p),
        reversed_: applied(back, a),
        "You subtract the translation and then rotate back.": applied(back, subtracted(a, p)),
        "You rotate back and then subtract the translation.": subtracted(applied(back, a), p),
        "You rotate back and then add the translation.": moved(back, p, a),
        "You add the translation and then rotate back.": applied(back, added(a, p)),
        "You subtract the vector from the translation.": applied(back, subtracted(p, a)),
    }
    general = "You use a general inverse, which is slower and differs slightly from the transpose "
    general += "here. "
    if method == "transform_inverse":
        general += "Subtract the translation, and then use the transpose."
        slips[general] = applied(inverse, subtracted(a, p))
    elif method == "transform_inverse_direction":
        slips[f"{general}Use the transpose instead."] = applied(inverse, a)
    return slips


@pytest.mark.exercise("B9.15", asks="then multiply by the transpose of the 3x3 part")
@METHODS
def test_points_and_directions_there_and_back(rng: Random, method: str) -> None:
    about.read = f"{WORLD}, and the docstring of {method}"
    # A matrix that just passes for a rotation shows whether an inverse was used.
    m = tuple(number * (1.0 + 4e-6) for number in matrix_of(draw_quad(rng)))
    p, a = components(rng), components(rng)
    twelve = joined(m, p)
    wanted, about.cause = {
        "transform_inverse": (
            applied(transposed(m), subtracted(a, p)),
            "To go back, subtract the translation first and then rotate back.",
        ),
        "transform_direction": (
            applied(m, a),
            "The translation doesn't affect a direction, so just multiply the vector by the 3x3 "
            "part.",
        ),
        "transform_inverse_direction": (
            applied(transposed(m), a),
            "The translation doesn't affect a direction, so just multiply the vector by the "
            "transpose of the 3x3 part.",
        ),
    }[method]
    v, matrix = Vector3(*a), Matrix4(*twelve)
    about.call = f"m = {written(twelve)}; m.{method}(Vector3{short(a)})"
    got = xyz(getattr(matrix, method)(v))
    why = named(got, about.cause, world_slips(method, m, p, a))
    # Rounding of numbers up to 30.
    expect_close(got, wanted, cause=why, tolerance=LOOSE)
    expect_kept("the vector", xyz(v), a)
    expect_kept("the matrix", entries(matrix), twelve)


@pytest.mark.exercise("B9.16", asks="It converts them to the old basis, applies m")
def test_a_rotation_in_other_axes(rng: Random) -> None:
    about.read = BASIS
    about.cause = "Return basis @ m @ basis.inverse()."
    # Rotations about no axis of their own tell all mistakes apart.
    m, basis = matrix_of(draw_quad(rng)), matrix_of(draw_quad(rng))
    about.call = f"m = {written(m)}; basis = {written(basis)}; change_basis(m, basis), row by row"
    got = entries(change_basis(Matrix3(*m), Matrix3(*basis)))
    back = transposed(basis)
    slips = {
        "You swap basis and its inverse, so you return basis.inverse() @ m @ basis.": times(
            times(back, m), basis
        ),
        "You return basis @ m, without the inverse on the right.": times(basis, m),
        "You return only m @ basis.": times(m, basis),
        "You return m @ basis.inverse(), without the basis on the left.": times(m, back),
        "You return only basis.inverse() @ m.": times(back, m),
        "You return basis @ m @ basis, without the inverse.": times(times(basis, m), basis),
        "You use the inverse of m. Use m itself.": times(times(basis, transposed(m)), back),
        "m itself": m,
    }
    why = named(got, about.cause, slips)
    about_z = matrix_of(quad((0.0, 0.0, 1.0), 0.5 * math.pi))
    z_to_x = matrix_of(quad((0.0, 1.0, 0.0), 0.5 * math.pi))
    about.call = f"m = {written(about_z)}; basis = {written(z_to_x)}; change_basis(m, basis), row "
    about.call += "by row"
    got = entries(change_basis(Matrix3(*about_z), Matrix3(*z_to_x)))
    wanted = tuple(round(n, 15) for n in matrix_of(quad((1.0, 0.0, 0.0), 0.5 * math.pi)))
    expect_close(got, wanted, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.16", asks="as the product basis * m * basis^-1")
def test_any_matrix_in_any_axes(rng: Random) -> None:
    about.read = BASIS
    m, basis = draw_matrix(rng), draw_mirror(rng)
    one, other = Matrix3(*m), Matrix3(*basis)
    about.call = f"m = {written(m)}; basis = {written(basis)}; change_basis(m, basis) @ basis, row "
    about.call += "by row"
    about.cause = "Return basis @ m @ basis.inverse()."
    got = entries(change_basis(one, other))
    product = times(got, basis) if isinstance(got, tuple) and len(got) == 9 else got
    by_transpose = times(times(times(basis, m), transposed(basis)), basis)
    slips = {
        "You use the transpose of the basis instead of its inverse. The two differ here, because "
        "the axes are not perpendicular.": by_transpose
    }
    why = named(product, about.cause, slips)
    expect_close(product, times(basis, m), cause=why, tolerance=LOOSE)
    expect_kept("m", entries(one), m)
    expect_kept("basis", entries(other), basis)


@pytest.mark.exercise("B9.16", asks="both a Matrix4, whose translations count too")
def test_a_motion_with_a_translation(rng: Random) -> None:
    about.read = BASIS
    m, p, basis, q = draw_matrix(rng), components(rng), draw_mirror(rng), components(rng)
    first, second = joined(m, p), joined(basis, q)
    a = components(rng)
    about.call = f"m = {written(first)}; basis = {written(second)}; change_basis(m, basis) @ "
    about.call += f"(basis @ Vector3{short(a)})"
    about.cause = (
        "Return basis @ m @ basis.inverse() for the complete Matrix4s, including their "
        "translations."
    )
    told = change_basis(Matrix4(*first), Matrix4(*second))
    got = entries(told)
    if isinstance(got, tuple) and len(got) == 12:
        linear, move = (*got[0:3], *got[4:7], *got[8:11]), (got[3], got[7], got[11])
        got = moved(linear, move, moved(basis, q, a))
    wanted = moved(basis, q, moved(m, p, a))
    # Three products of numbers up to 90.
    expect_close(got, wanted, tolerance=1e-9)
