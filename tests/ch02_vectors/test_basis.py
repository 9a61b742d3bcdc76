"""The orthonormal basis, build task B2.10. Tolerances: rounding of unit vectors, 1e-12."""

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
    a: Components, b: Components, cause: str = "three vectors are wanted"
) -> list[Components]:
    """Return the three vectors as plain numbers."""
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
            about.cause = "they are at right angles: vector 2 is made from the other two, c x a"
            if i == j:
                about.cause = f"vector {i + 1} is of unit length; its product with itself is the "
                about.cause += "square"
            along = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
            mistakes = [
                (along, "vector 2 is b itself, normalised: make it anew, at right angles to a"),
                (1.0 - along**2, "a x b is as long as the sine of their angle: normalise it"),
            ]
            got = dot(basis[i], basis[j])
            blame(got, mistakes)
            wanted = 1.0 if i == j else 0.0
            expect_close(
                got,
                wanted,
                then=f"; the scalar product of vectors {i + 1} and {j + 1}",
                tolerance=1e-12,
            )


@pytest.mark.exercise("B2.10")
def test_the_first_keeps_the_direction_of_a_and_the_second_leans_to_b(rng: Random) -> None:
    about.read = "book 2.1.9"
    for _ in range(4):  # a wrong second vector leans to some b by chance
        a, b = components(rng), components(rng)
        about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
        about.cause = "the first vector is a, normalised: only b may be turned"
        first, second, _ = basis_of(a, b)
        length = math.sqrt(dot(a, a))
        wanted = (a[0] / length, a[1] / length, a[2] / length)
        expect_close(first, wanted, then=", vector 1", tolerance=1e-12)
        about.cause = "vector 2 points away from b: it is c x a, with c = a x b"
        leans = dot(second, b) > 0.0
        expect_exactly(leans, True, then="; does vector 2 lean to b?")


@pytest.mark.exercise("B2.10")
def test_the_basis_is_right_handed(rng: Random) -> None:
    a, b = components(rng), components(rng)
    about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    about.cause = "vector 3 is vector 1 x vector 2; turned round, the basis is left-handed: c = a "
    about.cause += "x b, and then b = c x a, each in this order"
    about.read = "book 2.1.9"
    (ax, ay, az), (bx, by, bz), third = basis_of(a, b)
    wanted = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    expect_close(third, wanted, then=", vector 3", tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_the_arguments_stay_as_they_were(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; make_orthonormal_basis(v, w)"
    about.cause = "three new vectors are wanted: normalize changes a vector, normalized makes a "
    about.cause += "new one (the book's function does change its arguments)"
    about.read = "the docstring of make_orthonormal_basis"
    first, _, _ = make_orthonormal_basis(v, w)
    expect_unchanged("v", xyz(v), a)
    expect_unchanged("w", xyz(w), b)
    first.x = 99.0
    about.call = f"{about.call}; then vector 1 is changed"
    expect_unchanged("v", xyz(v), a)


@scoped
def expect_same_basis(a: Components, b: Components, scale: float) -> None:
    """Expect the basis of a and b from a made longer by a scale and b made shorter."""
    long = (a[0] * scale, a[1] * scale, a[2] * scale)
    short = (b[0] / scale, b[1] / scale, b[2] / scale)
    about.call = f"make_orthonormal_basis(Vector3{long}, Vector3{short})"
    about.cause = "normalise b as well, before the vector product"
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
    """Expect no basis of these two."""
    about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    about.read = "the docstring of make_orthonormal_basis"

    def attempt() -> None:  # three vectors of rounding would say nothing
        make_orthonormal_basis(Vector3(*a), Vector3(*b))

    expect_error(attempt, ValueError, allowed=lambda: basis_of(X_AXIS, Y_AXIS))


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_vectors_along_one_axis_are_refused() -> None:
    about.cause = "parallel vectors span no plane, whether they point the same way or not"
    for scale in (2.0, -3.0):
        expect_refusal(Y_AXIS, (0.0, scale, 0.0))


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    about.cause = "rounding leaves 1e-16 of the vector product: compare with a small limit, not "
    about.cause += "with 0"
    # 40 pairs: for nearly all of them rounding leaves a vector product that is not quite zero.
    for _ in range(40):
        a, scale = components(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        expect_refusal(a, (a[0] * scale, a[1] * scale, a[2] * scale))


@pytest.mark.exercise("B2.10")
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    x, y, z = components(rng)
    about.cause = "the angle is small, but its sine is far above 1e-12: these are not parallel"
    about.read = "the docstring of make_orthonormal_basis"
    # Rounding of 1e-16 is divided by the angle, 1/30 of the change at the least.
    for change, tolerance in ((1e-6, 1e-7), (1e-9, 1e-4)):
        b = (x, y * (1.0 + change), z)
        about.call = f"make_orthonormal_basis(Vector3{(x, y, z)}, Vector3{b})"
        first, _, third = basis_of((x, y, z), b, about.cause)
        got = dot(first, third)
        expect_close(got, 0.0, then="; the scalar product of vectors 1 and 3", tolerance=tolerance)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_the_zero_vector_is_refused() -> None:
    about.cause = "zero has no direction, so there is no plane: raise ValueError"
    expect_refusal((0.0, 0.0, 0.0), Y_AXIS)
    expect_refusal(X_AXIS, (0.0, 0.0, 0.0))


@pytest.mark.exercise("B2.10", weight=0.5)
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_vectors_that_are_not_finite_are_refused(bad: float) -> None:
    about.cause = "an infinite vector has a length, but no direction that a float can hold"
    expect_refusal((bad, 0.0, 0.0), Y_AXIS)
    expect_refusal(X_AXIS, (0.0, bad, 0.0))
