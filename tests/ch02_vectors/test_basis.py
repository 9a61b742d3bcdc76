"""The orthonormal basis, build task B2.10. The tolerance for rounding of unit vectors is 1e-12."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3, make_orthonormal_basis
from draw import Components, components, dot
from expect import (
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    expect_vector,
    scoped,
    xyz,
)

X_AXIS, Y_AXIS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


@scoped
def basis_of(
    a: Components,
    b: Components,
    cause: str = "A basis has three vectors. Return all three of them.",
) -> list[Components]:
    """Return the three vectors of the basis as plain numbers."""
    about(f"make_orthonormal_basis(Vector3{a}, Vector3{b})", cause=cause)
    about.read = "the docstring of make_orthonormal_basis"
    first, second, third = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    return [expect_vector(v) for v in (first, second, third)]


@pytest.mark.exercise("B2.10")
def test_three_unit_vectors_at_right_angles(rng: Random) -> None:
    a, b = components(rng), components(rng)
    about(f"make_orthonormal_basis(Vector3{a}, Vector3{b})", read="book 2.1.9")
    basis = basis_of(a, b)
    for i in range(3):
        for j in range(i, 3):
            name = f"{about.call}; the scalar product of vectors {i + 1} and {j + 1}"
            about.cause = (
                "The three vectors of a basis must be perpendicular to each other. Check vector 2 "
                "first, which should be c x a."
            )
            if i == j:
                about.cause = (
                    f"Vector {i + 1} must have length 1. The check compares its squared length, "
                    "which must then be 1 too. Make sure that you normalize this vector."
                )
            along = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
            mistakes = [
                (
                    along,
                    "Vector 2 is the normalized b, which is usually not perpendicular to a. "
                    "Compute it as c x a instead.",
                ),
                (
                    1.0 - along**2,
                    "You didn't normalize a x b. Even if a and b are unit vectors, its length is "
                    "only the sine of the angle between them, so divide it by its length.",
                ),
            ]
            got = dot(basis[i], basis[j])
            blame(got, mistakes)
            wanted = 1.0 if i == j else 0.0
            expect_close(got, wanted, call=name, tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_the_first_keeps_the_direction_of_a_and_the_second_leans_to_b(rng: Random) -> None:
    about.read = "book 2.1.9"
    for _ in range(4):  # by chance, a wrong second vector may lean toward one b
        a, b = components(rng), components(rng)
        about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
        about.cause = (
            "Vector 1 must be the normalized a. Only b may be turned, to make vector 2 "
            "perpendicular to a."
        )
        first, second, _ = basis_of(a, b)
        length = math.sqrt(dot(a, a))
        wanted = (a[0] / length, a[1] / length, a[2] / length)
        expect_close(first, wanted, then=", vector 1", tolerance=1e-12)
        about.cause = (
            "Vector 2 points away from b. Compute c = a x b first, and then vector 2 as c x a."
        )
        leans = dot(second, b) > 0.0
        expect_exactly(leans, True, then="; (vector 2) . b > 0")


@pytest.mark.exercise("B2.10")
def test_the_basis_is_right_handed(rng: Random) -> None:
    a, b = components(rng), components(rng)
    about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    about.cause = (
        "The basis is left-handed, because you swapped the factors of a vector product. Compute c "
        "= a x b first, and then b = c x a."
    )
    about.read = "book 2.1.9"
    (ax, ay, az), (bx, by, bz), third = basis_of(a, b)
    wanted = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    expect_close(third, wanted, then=", vector 3", tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_the_arguments_stay_as_they_were(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; make_orthonormal_basis(v, w)"
    about.cause = (
        "One of the arguments was changed. normalize works in place, as the book's function does, "
        "so use normalized, which returns a new vector."
    )
    about.read = "the docstring of make_orthonormal_basis"
    first, _, _ = make_orthonormal_basis(v, w)
    expect_unchanged("v", xyz(v), a)
    expect_unchanged("w", xyz(w), b)
    first.x = 99.0
    about.call = f"{about.call}[0].x = 99.0"
    expect_unchanged("v", xyz(v), a)


@scoped
def expect_same_basis(a: Components, b: Components, scale: float) -> None:
    """Expect the same basis from a longer a and a shorter b."""
    long = (a[0] * scale, a[1] * scale, a[2] * scale)
    short = (b[0] / scale, b[1] / scale, b[2] / scale)
    about.call = f"make_orthonormal_basis(Vector3{long}, Vector3{short})"
    about.cause = (
        "The lengths of a and b must not affect the basis. Normalize both vectors before you take "
        "their vector product."
    )
    about.read = "the docstring of make_orthonormal_basis"
    wanted, got = basis_of(a, b), basis_of(long, short, about.cause)
    for i in range(3):
        expect_close(got[i], wanted[i], then=f", vector {i + 1}", tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_lengths_do_not_matter(rng: Random) -> None:
    expect_same_basis(components(rng), components(rng), 1e4)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_huge_and_tiny_lengths_do_not_matter(rng: Random) -> None:
    expect_same_basis(components(rng), components(rng), 1e200)


@scoped
def expect_refusal(a: Components, b: Components) -> None:
    """Expect make_orthonormal_basis to refuse these two vectors."""
    about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    about.read = "the docstring of make_orthonormal_basis"

    def attempt() -> None:  # without a return: three vectors of rounding errors explain nothing
        make_orthonormal_basis(Vector3(*a), Vector3(*b))

    expect_error(attempt, ValueError, allowed=lambda: basis_of(X_AXIS, Y_AXIS))


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_vectors_along_one_axis_are_refused() -> None:
    about.cause = (
        "Parallel vectors, even those that point in opposite directions, don't span a plane and so "
        "don't define a basis. Raise ValueError."
    )
    for scale in (2.0, -3.0):
        expect_refusal(Y_AXIS, (0.0, scale, 0.0))


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    about.cause = (
        "These vectors are parallel, but rounding leaves a vector product of about 1e-16. Compare "
        "its length with a small limit instead of 0."
    )
    # In nearly all of the 40 pairs, rounding leaves a vector product that is not exactly zero.
    for _ in range(40):
        a, scale = components(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        expect_refusal(a, (a[0] * scale, a[1] * scale, a[2] * scale))


@pytest.mark.exercise("B2.10")
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    x, y, z = components(rng)
    about.cause = (
        "These vectors are nearly parallel but not quite. The sine of the angle between them is "
        "well above 1e-12, so return a basis."
    )
    about.read = "the docstring of make_orthonormal_basis"
    # Rounding errors of 1e-16 are divided by the angle, which is at least 1/30 of the change.
    for change, tolerance in ((1e-6, 1e-7), (1e-9, 1e-4)):
        b = (x, y * (1.0 + change), z)
        about.call = f"make_orthonormal_basis(Vector3{(x, y, z)}, Vector3{b})"
        first, _, third = basis_of((x, y, z), b, about.cause)
        got = dot(first, third)
        expect_close(got, 0.0, then="; the scalar product of vectors 1 and 3", tolerance=tolerance)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_the_zero_vector_is_refused() -> None:
    about.cause = (
        "A zero vector has no direction, so it cannot span a plane with another vector. Raise "
        "ValueError."
    )
    expect_refusal((0.0, 0.0, 0.0), Y_AXIS)
    expect_refusal(X_AXIS, (0.0, 0.0, 0.0))


@pytest.mark.exercise("B2.10", weight=0.5)
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_vectors_that_are_not_finite_are_refused(bad: float) -> None:
    about.cause = (
        "A vector with an infinite component has no well-defined direction, so it cannot be part "
        "of a basis. Raise ValueError."
    )
    expect_refusal((bad, 0.0, 0.0), Y_AXIS)
    expect_refusal(X_AXIS, (0.0, bad, 0.0))
