"""The orthonormal basis, build task B2.10. Tolerances: rounding of unit vectors, 1e-12."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3, make_orthonormal_basis
from draw import Components, components
from expect import expect_close, expect_error, expect_exactly, expect_unchanged, xyz

READ = "book 2.1.9"
X_AXIS, Y_AXIS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def dot(a: Components, b: Components) -> float:
    return math.fsum(p * q for p, q in zip(a, b, strict=True))


def basis_of(a: Components, b: Components) -> tuple[Components, Components, Components]:
    """Return the three vectors as plain numbers."""
    first, second, third = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    return xyz(first), xyz(second), xyz(third)


@pytest.mark.exercise("B2.10")
def test_three_unit_vectors_at_right_angles(rng: Random) -> None:
    a, b = components(rng), components(rng)
    basis = basis_of(a, b)
    for i in range(3):
        for j in range(i, 3):
            expect_close(
                f"the scalar product of vectors {i + 1} and {j + 1} of "
                f"make_orthonormal_basis(Vector3{a}, Vector3{b})",
                dot(basis[i], basis[j]),
                1.0 if i == j else 0.0,
                cause="each is of unit length, and the middle one is made from the other two",
                read=READ,
                tolerance=1e-12,
            )


@pytest.mark.exercise("B2.10")
def test_the_first_keeps_the_direction_of_a_and_the_second_leans_to_b(rng: Random) -> None:
    a, b = components(rng), components(rng)
    first, second, _ = basis_of(a, b)
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    length = math.sqrt(dot(a, a))
    direction = (a[0] / length, a[1] / length, a[2] / length)
    cause = "the first vector is a, normalised: only b may be turned"
    expect_close(f"the first of {call}", first, direction, cause=cause, read=READ, tolerance=1e-12)
    expect_exactly(
        f"whether the second of {call} points to the side of b",
        dot(second, b) > 0.0,
        True,
        cause="the second is c x a, with c = a x b",
        read=READ,
    )


@pytest.mark.exercise("B2.10")
def test_the_basis_is_right_handed(rng: Random) -> None:
    a, b = components(rng), components(rng)
    (ax, ay, az), (bx, by, bz), third = basis_of(a, b)
    expect_close(
        f"the third of make_orthonormal_basis(Vector3{a}, Vector3{b})",
        third,
        (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx),
        cause="the first x the second gives the third; the opposite is a left-handed basis",
        read=READ,
        tolerance=1e-12,
    )


@pytest.mark.exercise("B2.10")
def test_the_arguments_stay_as_they_were(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    _, _, _ = make_orthonormal_basis(v, w)
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    expect_unchanged(call, "a", xyz(v), a, read="the docstring: three new vectors")
    expect_unchanged(call, "b", xyz(w), b, read="the docstring: three new vectors")


@pytest.mark.exercise("B2.10")
def test_lengths_do_not_matter(rng: Random) -> None:
    a, b = components(rng), components(rng)
    wanted = basis_of(a, b)
    huge = tuple(number * 1e200 for number in a)
    tiny = tuple(number * 1e-200 for number in b)
    got = basis_of(huge, tiny)
    for i in range(3):
        expect_close(
            f"vector {i + 1} of make_orthonormal_basis(Vector3{huge}, Vector3{tiny})",
            got[i],
            wanted[i],
            cause="normalise b as well, before the vector product",
            read="the docstring of make_orthonormal_basis",
            tolerance=1e-12,
        )


@pytest.mark.exercise("B2.10")
def test_vectors_along_one_axis_are_refused() -> None:
    for scale in (2.0, -3.0):
        expect_error(
            f"make_orthonormal_basis(Vector3(0, 1, 0), Vector3(0, {scale}, 0))",
            lambda scale=scale: make_orthonormal_basis(Vector3(0, 1, 0), Vector3(0, scale, 0)),
            ValueError,
            allowed=lambda: basis_of(X_AXIS, Y_AXIS),
            cause="parallel vectors span no plane, and point the same way or the opposite way",
            read=READ,
        )


@pytest.mark.exercise("B2.10")
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    # 40 pairs: for nearly all of them rounding leaves a vector product that is not quite zero.
    for _ in range(40):
        a, scale = components(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        b = tuple(number * scale for number in a)
        expect_error(
            f"make_orthonormal_basis(Vector3{a}, Vector3{b})",
            lambda a=a, b=b: make_orthonormal_basis(Vector3(*a), Vector3(*b)),
            ValueError,
            allowed=lambda: basis_of(X_AXIS, Y_AXIS),
            cause="rounding leaves about 1e-16 of the vector product: compare with a small limit "
            "such as 1e-12, not with zero",
            read="the docstring of make_orthonormal_basis",
        )


@pytest.mark.exercise("B2.10")
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    x, y, z = components(rng)
    b = (x, y * 1.000001, z)
    first, _, third = basis_of((x, y, z), b)
    expect_close(
        f"the scalar product of vectors 1 and 3 of make_orthonormal_basis(Vector3{(x, y, z)}, "
        f"Vector3{b})",
        dot(first, third),
        0.0,
        cause="an angle of a millionth is small, but these are not parallel",
        read="the docstring of make_orthonormal_basis",
        tolerance=1e-7,  # rounding of 1e-16, divided by an angle of 1e-8 at the least
    )


@pytest.mark.exercise("B2.10")
@pytest.mark.parametrize("bad", [0.0, math.nan, math.inf])
def test_vectors_without_a_direction_are_refused(bad: float) -> None:
    good = Vector3(1.0, 2.0, 3.0)
    cause = "NaN compares false with everything: ask for what is wanted, and refuse the rest"
    for call, a, b in (
        (f"make_orthonormal_basis(Vector3({bad}, 0, 0), good)", Vector3(bad, 0.0, 0.0), good),
        (f"make_orthonormal_basis(good, Vector3(0, {bad}, 0))", good, Vector3(0.0, bad, 0.0)),
    ):
        expect_error(
            call,
            lambda a=a, b=b: make_orthonormal_basis(a, b),
            ValueError,
            allowed=lambda: basis_of(X_AXIS, Y_AXIS),
            cause="zero has no direction" if bad == 0.0 else cause,
            read="the docstring of make_orthonormal_basis",
        )
