"""The orthonormal basis, build task B2.10. The tolerance for rounding of unit vectors is 1e-12."""

from __future__ import annotations

from functools import partial
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3, make_orthonormal_basis
from draw import Triple, rounded, vector
from expect import expect_close, expect_error, expect_that, expect_unchanged, expect_vector, named

READ = "book 2.1.9, and the docstring of make_orthonormal_basis"
ORDER = (
    "You return the vectors of the basis in the wrong order. The first one points along a, the "
    "second one toward b, and the third one is a x b, divided by its length."
)
ZERO, X_AXIS = Triple((0.0, 0.0, 0.0)), Triple((1.0, 0.0, 0.0))
Y_AXIS = Triple((0.0, 1.0, 0.0))


def basis_of(a: Triple, b: Triple, cause: str = "", call: str = "") -> list[Triple]:
    """Return the three vectors of the basis as plain numbers."""
    __tracebackhide__ = True
    with calls(cause or "Return a new orthonormal basis of exactly three vectors.", call):
        v1, v2, v3 = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    return [Triple(expect_vector(v)) for v in (v1, v2, v3)]


@pytest.mark.exercise("B2.10", asks="Build three perpendicular unit vectors", read=READ)
def test_three_unit_vectors_at_right_angles(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    basis = basis_of(a, b)
    along = a @ b / (abs(a) * abs(b))
    slips = {
        "The second vector of your basis is the normalized b, which is not perpendicular to a. "
        "Compute c x a instead, with c = a x b.": along
    }
    for i in range(3):
        if i == 2:  # a second vector that is too short may have the same length as such a third one
            slips[
                "You don't normalize the third vector, a x b, which is shorter than 1 unless a and "
                "b are perpendicular. Divide a x b by its length."
            ] = 1.0 - along**2
        for j in range(i, 3):
            cause = (
                "The three vectors of the basis must be perpendicular to each other. Check vector "
                "2 first: with c = a x b, it should be c x a."
            )
            if i == j:
                cause = (
                    f"Vector {i + 1} of your basis does not have length 1, so its scalar product "
                    "with itself is not 1. Normalize it."
                )
            if i == j == 1 and abs(basis[1] @ basis[1] - basis[2] @ basis[2]) < 1e-9:
                cause = (
                    "Vectors 2 and 3 of your basis are equally long, but their length is not 1. "
                    "Normalize the one that you compute first before you compute the other from it."
                )
            then = f"; v{i + 1}.dot(v{j + 1})"
            wanted = 1.0 if i == j else 0.0
            got = basis[i] @ basis[j]
            expect_close(got, wanted, slips, tolerance=1e-12, then=then, cause=cause)


@pytest.mark.exercise("B2.10", asks="The first points along a", read=READ)
def test_vector_1_points_along_a_and_vector_2_toward_b(rng: Random) -> None:
    for _ in range(4):  # by chance, a wrong second vector may lean toward one b
        a, b = vector(rng), vector(rng)
        first, second, third = basis_of(a, b)
        normal = a.cross(b) / abs(a.cross(b))
        rotated_b = normal.cross(a) / abs(a)
        cause = (
            "Vector 1 of your basis is not the normalized a. Keep the direction of a, and rotate "
            "only b to make it perpendicular to a."
        )
        cause = named(first, cause, {ORDER: normal})
        slips = {ORDER: rotated_b}
        expect_close(first, a / abs(a), slips, tolerance=1e-12, then="; v1", cause=cause)
        swapped = "it as a x c. Swap the factors, and compute it as c x a, with c = a x b."
        if abs(third + normal) < 1e-9:
            swapped = "c as b x a. Swap the factors, and compute it as c = a x b."
        swapped = (
            f"The second vector of your basis points away from b, because you compute {swapped}"
        )
        cause = (
            "The second vector of your basis doesn't point toward b. Compute c = a x b first, and "
            "then the second vector as c x a."
        )
        cause = named(second, cause, {swapped: -rotated_b, ORDER: normal})
        cause = named(second, cause, {ORDER: -normal})
        shown = f"{second @ b:.6g}" if abs(second @ b) > 1e-9 else "0, except for rounding"
        then = "; v2.dot(b)"
        expect_that(second @ b > 1e-9, shown, "a positive number", then=then, cause=cause)


@pytest.mark.exercise("B2.10", asks="that form a right-handed basis", read=READ)
def test_the_basis_is_right_handed(rng: Random) -> None:
    first, second, third = basis_of(vector(rng), vector(rng))
    cause = (
        "Vector 3 must be the vector product of the other two. Compute it as c = a x b, and vector "
        "2 as c x a."
    )
    wanted = first.cross(second)
    slips = {
        "Your basis is left-handed, because you swap the factors of a vector product.": -wanted
    }
    then = "; v3, compared with v1.cross(v2)"
    expect_close(third, wanted, slips, tolerance=1e-12, then=then, cause=cause)


@pytest.mark.exercise("B2.10", asks="all three are new vectors", read=READ)
def test_the_basis_leaves_its_arguments_unchanged(rng: Random) -> None:
    a, b = vector(rng), vector(rng)
    in_place = (
        "You change the caller's vector, because normalize works in place. Use normalized, which "
        "returns a new vector."
    )
    with calls(in_place):
        v, w = Vector3(*a), Vector3(*b)
        v1, _, _ = make_orthonormal_basis(v, w)
    expect_unchanged("v", v, a)
    expect_unchanged("w", w, b)
    with calls(in_place, more=True):
        v1.x = 99.0
    expect_unchanged("v", v, a)


@pytest.mark.exercise("B2.10", asks="The lengths of a and b do not matter", read=READ)
@pytest.mark.robust
def test_huge_and_tiny_lengths_do_not_matter(rng: Random) -> None:
    a, b, scale = vector(rng), vector(rng), 1e200
    wanted = basis_of(a, b)
    cause = (
        "Your basis depends on the lengths of a and b. Normalize both vectors before you compute "
        "their vector product."
    )
    call = f"make_orthonormal_basis(Vector3{rounded(a * scale)}, Vector3{rounded(b / scale)})"
    got = basis_of(a * scale, b / scale, cause, call)
    for i in range(3):
        expect_close(got[i], wanted[i], then=f"; vector {i + 1} of the basis", tolerance=1e-12)


def expect_refusal(a: Triple, b: Triple, cause: str) -> None:
    """Expect make_orthonormal_basis to refuse these two vectors."""
    __tracebackhide__ = True

    def attempt() -> None:  # without a return: three vectors of rounding errors explain nothing
        make_orthonormal_basis(Vector3(*a), Vector3(*b))

    call = f"make_orthonormal_basis(Vector3{a}, Vector3{b})"
    allowed = partial(basis_of, X_AXIS, Y_AXIS)
    expect_error(attempt, ValueError, allowed=allowed, call=call, cause=cause)


@pytest.mark.exercise("B2.10", asks="or if they are parallel", read=READ)
@pytest.mark.robust
def test_vectors_along_one_axis_are_refused() -> None:
    cause = (
        "These two vectors are parallel, so they don't define a plane and cannot give a basis. "
        "Raise ValueError, even if they point in opposite directions."
    )
    for scale in (2.0, -3.0):
        expect_refusal(Y_AXIS, Y_AXIS * scale, cause)


@pytest.mark.exercise("B2.10", asks="the sine of the angle between them is below 1e-12", read=READ)
@pytest.mark.robust
def test_parallel_vectors_in_any_direction_are_refused(rng: Random) -> None:
    cause = (
        "These vectors are parallel, but rounding gives a x b a tiny length instead of 0. Raise "
        "ValueError if the length is below a limit such as 1e-12."
    )
    # In nearly all of the 40 pairs, rounding leaves a vector product that is not exactly zero.
    for _ in range(40):
        a, scale = vector(rng), rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 9.0)
        expect_refusal(a, a * scale, cause)


@pytest.mark.exercise("B2.10", asks="the sine of the angle between them is below 1e-12", read=READ)
def test_nearly_parallel_vectors_still_give_a_basis(rng: Random) -> None:
    a = vector(rng)
    not_parallel = (
        "These two vectors are not parallel, because the sine of the angle between them is well "
        "above 1e-12. Return a basis instead of raising an error."
    )
    third = (
        "The third vector of your basis is not perpendicular to the first. Compute it as the "
        "vector product of the normalized a and b, and normalize the result."
    )
    # Rounding errors of 1e-16 are divided by the angle, which is at least 1/30 of the change.
    for change, tolerance in ((1e-6, 1e-7), (1e-9, 1e-4)):
        v1, _, v3 = basis_of(a, Triple((a[0], a[1] * (1.0 + change), a[2])), not_parallel)
        expect_close(v1 @ v3, 0.0, tolerance=tolerance, then="; v1.dot(v3)", cause=third)


@pytest.mark.exercise("B2.10", asks="Raises ValueError if one is zero", read=READ)
@pytest.mark.robust
def test_the_zero_vector_is_refused() -> None:
    cause = (
        "One of the vectors is zero and has no direction, so it cannot give a basis. Raise "
        "ValueError."
    )
    expect_refusal(ZERO, Y_AXIS, cause)
    expect_refusal(X_AXIS, ZERO, cause)
