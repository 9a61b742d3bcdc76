"""The orthonormal basis, build task B2.10. The tolerance for rounding of unit vectors is 1e-12."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3, make_orthonormal_basis
from draw import Components, components, dot, rounded
from expect import (
    about,
    blame,
    expect_close,
    expect_error,
    expect_that,
    expect_unchanged,
    expect_vector,
    scoped,
    xyz,
)

ORDER = (
    "You return the vectors of the basis in the wrong order. The first one points along a, the "
    "second one toward b, and the third one is a x b, divided by its length."
)
THREE = "a, b = Vector3{}, Vector3{}; v1, v2, v3 = make_orthonormal_basis(a, b)"
X_AXIS, Y_AXIS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


@scoped
def basis_of(
    a: Components,
    b: Components,
    cause: str = "Return a new orthonormal basis of exactly three vectors.",
) -> list[Components]:
    """Return the three vectors of the basis as plain numbers."""
    about(f"make_orthonormal_basis(Vector3{a}, Vector3{b})", cause=cause)
    about.read = "the docstring of make_orthonormal_basis"
    first, second, third = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    return [expect_vector(v) for v in (first, second, third)]


def perpendicular_to(a: Components, b: Components) -> Components:
    """Return the unit vector along a x b."""
    x, y, z = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    length = math.hypot(x, y, z)
    return x / length, y / length, z / length


@pytest.mark.exercise("B2.10", asks="Build three perpendicular unit vectors")
def test_three_unit_vectors_at_right_angles(rng: Random) -> None:
    a, b = components(rng), components(rng)
    about(f"{THREE.format(a, b)}; v1, v2, v3", read="book 2.1.9")
    basis = basis_of(a, b)
    for i in range(3):
        for j in range(i, 3):
            name = f"{THREE.format(a, b)}; v{i + 1}.dot(v{j + 1})"
            about.cause = (
                "The three vectors of the basis must be perpendicular to each other. Check vector "
                "2 first: with c = a x b, it should be c x a."
            )
            if i == j:
                about.cause = (
                    f"Vector {i + 1} of your basis does not have length 1, so its scalar product "
                    "with itself is not 1. Normalize it."
                )
            if i == j == 1 and abs(dot(basis[1], basis[1]) - dot(basis[2], basis[2])) < 1e-9:
                about.cause = (
                    "Vectors 2 and 3 of your basis are equally long, but their length is not 1. "
                    "Normalize the one that you compute first before you compute the other from it."
                )
            along = dot(a, b) / math.sqrt(dot(a, a) * dot(b, b))
            mistakes = [
                (
                    along,
                    "The second vector of your basis is the normalized b, which is not "
                    "perpendicular to a. Compute c x a instead, with c = a x b.",
                ),
                (
                    1.0 - along**2,
                    "You don't normalize the third vector, a x b, which is shorter than 1 unless a "
                    "and b are perpendicular. Divide a x b by its length.",
                ),
            ]
            got = dot(basis[i], basis[j])
            # A second vector that is too short may have the same length as such a third one.
            blame(got, mistakes if i == 2 else mistakes[:1])
            wanted = 1.0 if i == j else 0.0
            expect_close(got, wanted, call=name, tolerance=1e-12)


@pytest.mark.exercise("B2.10", asks="The first points along a")
def test_vector_1_points_along_a_and_vector_2_toward_b(rng: Random) -> None:
    about.read = "book 2.1.9"
    for _ in range(4):  # by chance, a wrong second vector may lean toward one b
        a, b = components(rng), components(rng)
        about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
        about.cause = (
            "Vector 1 of your basis is not the normalized a. Keep the direction of a, and rotate "
            "only b to make it perpendicular to a."
        )
        first, second, third = basis_of(a, b)
        length = math.sqrt(dot(a, a))
        wanted = (a[0] / length, a[1] / length, a[2] / length)
        normal = perpendicular_to(a, b)
        rotated_b = perpendicular_to(normal, a)
        blame(first, [(normal, ORDER), (rotated_b, ORDER)])
        expect_close(first, wanted, then="; vector 1 of the basis", tolerance=1e-12)
        about.cause = (
            "The second vector of your basis doesn't point toward b. Compute c = a x b first, and "
            "then the second vector as c x a."
        )
        opposite = tuple(-n for n in rotated_b)
        reversed_normal = tuple(-n for n in normal)
        swapped = (
            "The second vector of your basis points away from b, because you compute it as a x c. "
            "Swap the factors, and compute it as c x a, with c = a x b."
        )
        if max(abs(m - n) for m, n in zip(third, reversed_normal, strict=True)) < 1e-9:
            swapped = (
                "The second vector of your basis points away from b, because you compute c as b x "
                "a. Swap the factors, and compute it as c = a x b."
            )
        blame(second, [(opposite, swapped), (normal, ORDER), (reversed_normal, ORDER)])
        along = dot(second, b)
        name = f"{THREE.format(a, b)}; v2.dot(b)"
        shown = f"{along:.6g}" if abs(along) > 1e-9 else "0, except for rounding"
        expect_that(along > 1e-9, shown, "a positive number", call=name)


@pytest.mark.exercise("B2.10", asks="that form a right-handed basis")
def test_the_basis_is_right_handed(rng: Random) -> None:
    a, b = components(rng), components(rng)
    about.call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    about.cause = (
        "Vector 3 must be the vector product of the other two. Compute it as c = a x b, and vector "
        "2 as c x a."
    )
    about.read = "book 2.1.9"
    (ax, ay, az), (bx, by, bz), third = basis_of(a, b)
    wanted = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    swapped = (
        "Your basis is left-handed, because you swap the factors of a vector product. Compute "
        "vector 3 as c = a x b, and vector 2 as c x a."
    )
    blame(third, [(tuple(-n for n in wanted), swapped)])
    expect_close(
        third,
        wanted,
        then="; vector 3 of the basis, compared with vector 1 x vector 2",
        tolerance=1e-12,
    )


@pytest.mark.exercise("B2.10", asks="all three are new vectors")
def test_the_basis_leaves_its_arguments_unchanged(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    about.call = f"v, w = Vector3{a}, Vector3{b}; make_orthonormal_basis(v, w)"
    about.cause = (
        "You change the caller's vector, because normalize works in place. Use normalized, which "
        "returns a new vector."
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
    about.call = f"make_orthonormal_basis(Vector3{rounded(long)}, Vector3{rounded(short)})"
    about.cause = (
        "Your basis depends on the lengths of a and b. Normalize both vectors before you compute "
        "their vector product."
    )
    about.read = "the docstring of make_orthonormal_basis"
    wanted, got = basis_of(a, b), basis_of(long, short, about.cause)
    for i in range(3):
        expect_close(got[i], wanted[i], then=f"; vector {i + 1} of the basis", tolerance=1e-12)


@pytest.mark.exercise("B2.10", asks="The lengths of a and b do not matter")
def test_lengths_do_not_matter(rng: Random) -> None:
    expect_same_basis(components(rng), components(rng), 1e4)


@pytest.mark.exercise("B2.10", asks="The lengths of a and b do not matter")
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


@pytest.mark.exercise("B2.10", asks="or if they are parallel")
@pytest.mark.robust
def test_vectors_along_one_axis_are_refused() -> None:
    about.cause = (
        "These two vectors are parallel, so they don't define a plane and cannot give a basis. "
        "Raise ValueError, even if they point in opposite directions."
    )
    for scale in (2.0, -3.0):
        expect_refusal(Y_AXIS, (0.0, scale, 0.0))


@pytest.mark.exercise("B2.10", asks="the sine of the angle between them is below 1e-12")
@pytest.mark.robust
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    about.cause = (
        "These vectors are parallel, but rounding gives a x b a tiny length instead of 0. Raise "
        "ValueError if the length is below a limit such as 1e-12."
    )
    # In nearly all of the 40 pairs, rounding leaves a vector product that is not exactly zero.
    for _ in range(40):
        a, scale = components(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        expect_refusal(a, (a[0] * scale, a[1] * scale, a[2] * scale))


@pytest.mark.exercise("B2.10", asks="the sine of the angle between them is below 1e-12")
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    x, y, z = components(rng)
    about.cause = (
        "These two vectors are not parallel, because the sine of the angle between them is well "
        "above 1e-12. Return a basis instead of raising an error."
    )
    about.read = "the docstring of make_orthonormal_basis"
    # Rounding errors of 1e-16 are divided by the angle, which is at least 1/30 of the change.
    for change, tolerance in ((1e-6, 1e-7), (1e-9, 1e-4)):
        b = (x, y * (1.0 + change), z)
        about.call = f"make_orthonormal_basis(Vector3{(x, y, z)}, Vector3{b})"
        first, _, third = basis_of((x, y, z), b, about.cause)
        got = dot(first, third)
        expect_close(
            got,
            0.0,
            call=f"{THREE.format((x, y, z), b)}; v1.dot(v3)",
            cause="The third vector of your basis is not perpendicular to the first. Compute it as "
            "the vector product of the normalized a and b, and normalize the result.",
            tolerance=tolerance,
        )


@pytest.mark.exercise("B2.10", asks="Raises ValueError if one is zero")
@pytest.mark.robust
def test_the_zero_vector_is_refused() -> None:
    about.cause = (
        "One of the vectors is zero and has no direction, so it cannot give a basis. Raise "
        "ValueError."
    )
    expect_refusal((0.0, 0.0, 0.0), Y_AXIS)
    expect_refusal(X_AXIS, (0.0, 0.0, 0.0))
