"""The orthonormal basis, build task B2.10. Tolerances: rounding of unit vectors, 1e-12."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3, make_orthonormal_basis
from draw import Components, components, dot
from expect import (
    cause_of,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    expect_vector,
    xyz,
)

X_AXIS, Y_AXIS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def basis_of(
    a: Components, b: Components, cause: str = "three vectors are wanted"
) -> list[Components]:
    """Return the three vectors as plain numbers."""
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    read = "the docstring of make_orthonormal_basis"
    first, second, third = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    return [expect_vector(call, v, cause=cause, read=read) for v in (first, second, third)]


@pytest.mark.exercise("B2.10")
def test_three_unit_vectors_at_right_angles(rng: Random) -> None:
    a, b = components(rng), components(rng)
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    read = "book 2.1.9"
    basis = basis_of(a, b)
    for i in range(3):
        for j in range(i, 3):
            name = f"{call}; the scalar product of vectors {i + 1} and {j + 1}"
            cause = "they are at right angles: vector 2 is made from the other two, c x a"
            if i == j:
                cause = f"vector {i + 1} is of unit length; its product with itself is the square"
            along = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
            mistakes = [
                (along, "vector 2 is b itself, normalised: make it anew, at right angles to a"),
                (1.0 - along**2, "a x b is as long as the sine of their angle: normalise it"),
            ]
            got = dot(basis[i], basis[j])
            cause = cause_of(got, mistakes, cause)
            wanted = 1.0 if i == j else 0.0
            expect_close(name, got, wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_the_first_keeps_the_direction_of_a_and_the_second_leans_to_b(rng: Random) -> None:
    read = "book 2.1.9"
    for _ in range(4):  # a wrong second vector leans to some b by chance
        a, b = components(rng), components(rng)
        call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
        cause = "the first vector is a, normalised: only b may be turned"
        first, second, _ = basis_of(a, b)
        length = math.sqrt(dot(a, a))
        wanted = (a[0] / length, a[1] / length, a[2] / length)
        expect_close(f"{call}, vector 1", first, wanted, cause=cause, read=read, tolerance=1e-12)
        cause = "vector 2 points away from b: it is c x a, with c = a x b"
        leans = dot(second, b) > 0.0
        expect_exactly(f"{call}; does vector 2 lean to b?", leans, True, cause=cause, read=read)


@pytest.mark.exercise("B2.10")
def test_the_basis_is_right_handed(rng: Random) -> None:
    a, b = components(rng), components(rng)
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    cause = "vector 3 is vector 1 x vector 2; turned round, the basis is left-handed: c = a x b, "
    cause += "and then b = c x a, each in this order"
    read = "book 2.1.9"
    (ax, ay, az), (bx, by, bz), third = basis_of(a, b)
    wanted = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    expect_close(f"{call}, vector 3", third, wanted, cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_the_arguments_stay_as_they_were(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"v, w = Vector3{a}, Vector3{b}; make_orthonormal_basis(v, w)"
    cause = "three new vectors are wanted: normalize changes a vector, normalized makes a new one "
    cause += "(the book's function does change its arguments)"
    read = "the docstring of make_orthonormal_basis"
    first, _, _ = make_orthonormal_basis(v, w)
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read=read)
    expect_unchanged(call, "w", xyz(w), b, cause=cause, read=read)
    first.x = 99.0
    call = f"{call}; then vector 1 is changed"
    expect_unchanged(call, "v", xyz(v), a, cause=cause, read=read)


def expect_same_basis(a: Components, b: Components, scale: float) -> None:
    """Expect the basis of a and b from a made longer by a scale and b made shorter."""
    long = (a[0] * scale, a[1] * scale, a[2] * scale)
    short = (b[0] / scale, b[1] / scale, b[2] / scale)
    call = f"make_orthonormal_basis(Vector3{long}, Vector3{short})"
    cause = "normalise b as well, before the vector product"
    read = "the docstring of make_orthonormal_basis"
    wanted, got = basis_of(a, b), basis_of(long, short, cause)
    for i in range(3):
        name = f"{call}, vector {i + 1}"
        expect_close(name, got[i], wanted[i], cause=cause, read=read, tolerance=1e-12)


@pytest.mark.exercise("B2.10")
def test_lengths_do_not_matter(rng: Random) -> None:
    expect_same_basis(components(rng), components(rng), 1e4)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_huge_and_tiny_lengths_do_not_matter(rng: Random) -> None:
    expect_same_basis(components(rng), components(rng), 1e200)


def expect_refusal(a: Components, b: Components, cause: str) -> None:
    """Expect no basis of these two."""
    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    read = "the docstring of make_orthonormal_basis"

    def attempt() -> None:  # three vectors of rounding would say nothing
        make_orthonormal_basis(Vector3(*a), Vector3(*b))

    expect_error(
        call,
        attempt,
        ValueError,
        allowed=lambda: basis_of(X_AXIS, Y_AXIS),
        cause=cause,
        read=read,
    )


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_vectors_along_one_axis_are_refused() -> None:
    cause = "parallel vectors span no plane, whether they point the same way or not"
    for scale in (2.0, -3.0):
        expect_refusal(Y_AXIS, (0.0, scale, 0.0), cause)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    cause = "rounding leaves 1e-16 of the vector product: compare with a small limit, not with 0"
    # 40 pairs: for nearly all of them rounding leaves a vector product that is not quite zero.
    for _ in range(40):
        a, scale = components(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        expect_refusal(a, (a[0] * scale, a[1] * scale, a[2] * scale), cause)


@pytest.mark.exercise("B2.10")
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    x, y, z = components(rng)
    cause = "the angle is small, but its sine is far above 1e-12: these are not parallel"
    read = "the docstring of make_orthonormal_basis"
    # Rounding of 1e-16 is divided by the angle, 1/30 of the change at the least.
    for change, tolerance in ((1e-6, 1e-7), (1e-9, 1e-4)):
        b = (x, y * (1.0 + change), z)
        call = f"make_orthonormal_basis(Vector3{(x, y, z)}, Vector3{b})"
        first, _, third = basis_of((x, y, z), b, cause)
        got = dot(first, third)
        name = f"{call}; the scalar product of vectors 1 and 3"
        expect_close(name, got, 0.0, cause=cause, read=read, tolerance=tolerance)


@pytest.mark.exercise("B2.10")
@pytest.mark.robust
def test_the_zero_vector_is_refused() -> None:
    cause = "zero has no direction, so there is no plane: raise ValueError"
    expect_refusal((0.0, 0.0, 0.0), Y_AXIS, cause)
    expect_refusal(X_AXIS, (0.0, 0.0, 0.0), cause)


@pytest.mark.exercise("B2.10", weight=0.5)
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_vectors_that_are_not_finite_are_refused(bad: float) -> None:
    cause = "an infinite vector has a length, but no direction that a float can hold"
    expect_refusal((bad, 0.0, 0.0), Y_AXIS, cause)
    expect_refusal(X_AXIS, (0.0, bad, 0.0), cause)
