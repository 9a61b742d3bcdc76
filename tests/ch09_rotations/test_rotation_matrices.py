"""Matrices that turn, and quaternions: build tasks B9.6, B9.12 and B9.13."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import permutations
from random import Random

import pytest

from calls import calls
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion
from draw import Triple, positive_number, vector
from expect import about, expect_close, expect_exactly
from turning import (
    IDENTITY,
    TIGHT,
    Quad,
    draw_quad,
    draw_slight_turn,
    entries,
    expect_kept,
    matrix_of,
    named,
    quad,
    rijk,
    same_sign,
    transposed,
    written,
)

IS_ROTATION = "the docstring of is_rotation"
FROM = "book 9.4.4, and E-11"
TO = "the docstring of to_quaternion"
# A half-turn about (2, 2, 1). Only few terms of its determinant have the right sign.
HALF_TURN = tuple(n / 9.0 for n in (-1.0, 8.0, 4.0, 8.0, -1.0, 4.0, 4.0, 4.0, -7.0))


def expect_rotation(wanted: bool, cause: str, *matrices: Sequence[float]) -> None:
    """Expect is_rotation to accept or refuse matrices."""
    for m in matrices:
        with calls(cause, f"m = {written(m)}; m.is_rotation()"):
            got = Matrix3(*m).is_rotation()
        expect_exactly(got, wanted)


def scaled(m: Sequence[float], *factors: float) -> list[list[float]]:
    """Return a matrix multiplied by each of the factors."""
    return [[factor * number for number in m] for factor in factors]


@pytest.mark.exercise("B9.6", asks="Return True if the matrix only rotates", read=IS_ROTATION)
def test_accepts_rotations(rng: Random) -> None:
    expect_rotation(True, "You reject the identity, but it is a rotation by 0.", IDENTITY)
    cause = "You reject a rotation, probably because of rounding errors. Don't compare with ==, "
    cause += "but accept errors of up to ROTATION_TOLERANCE."
    if not Matrix3(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0).is_rotation():
        cause = "You reject a rotation, and not because of rounding errors: you reject one by 90 "
        cause += "degrees, too. Compare the scalar products of the rows with 1 and 0."
    expect_rotation(True, cause, matrix_of(draw_quad(rng)), matrix_of(draw_quad(rng)))
    cause = "You reject a half-turn, but its rows are perpendicular unit vectors, and its "
    expect_rotation(True, f"{cause}determinant is 1.", HALF_TURN)


@pytest.mark.exercise("B9.6", asks="without scaling, shear or reflection", read=IS_ROTATION)
def test_rejects_matrices_that_are_not_rotations(rng: Random) -> None:
    m = matrix_of(draw_quad(rng))
    cause = "You accept a matrix whose rows are not unit vectors. Check that the scalar product of "
    cause += "each row with itself is 1."
    rows = ([1.5 * n if place // 3 == row else n for place, n in enumerate(m)] for row in range(3))
    expect_rotation(False, cause, *scaled(m, 2.0), (0.0,) * 9, *rows)
    cause = "You accept this matrix because its determinant is 1. Check the length of each row too."
    expect_rotation(False, cause, (2.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0))
    cause = "You accept a reflection. Its rows are perpendicular unit vectors, but its determinant "
    cause += "is negative, so check the sign of the determinant too."
    # The determinant of a mirror with nearly orthonormal rows is near -1, on either side of it.
    mirrors = *scaled(HALF_TURN, -1.0), *scaled(m, -1.0, -1.0 - 4e-6, 4e-6 - 1.0)
    expect_rotation(False, cause, (*m[3:6], *m[:3], *m[6:]), *mirrors)
    cause = "You accept a matrix that shears. Its rows are unit vectors, but they are not "
    cause += "perpendicular, so check the scalar products of different rows too."
    s, t = math.sin(0.3), math.cos(0.3)
    leaning = (s, t, 0.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, s, 0.0, t), (0.0, 1.0, 0.0, 0.0, s, t)
    expect_rotation(False, cause, *((1.0, 0.0, 0.0, *rows) for rows in leaning))


@pytest.mark.exercise("B9.6", asks="both within ROTATION_TOLERANCE", read=IS_ROTATION)
def test_how_near_to_a_rotation_is_near_enough(rng: Random) -> None:
    m = draw_slight_turn(rng)
    limit = "It may differ from {} by at most ROTATION_TOLERANCE (1e-5)."
    for scale in (4e-6, -4e-6, 7e-6, -7e-6):
        wanted = abs(scale) < 5e-6
        cause = f"Return {wanted} here, because the scalar product of each row with itself is "
        cause += f"{1.0 + 2.0 * scale:.6f}. {limit.format(1)}"
        if wanted:
            cause += " The determinant only has to be positive."
        elif scale < 0.0:
            cause += " Here the difference from 1 is negative, so take its absolute value."
        expect_rotation(wanted, cause, *scaled(m, 1.0 + scale))
    for angle, wanted in ((8e-6, True), (1.3e-5, False), (-1.3e-5, False)):
        cause = f"Return {wanted} here, because the scalar product of the first two rows is "
        cause += f"{angle:.2g}. {limit.format(0)}"
        expect_rotation(wanted, cause, (1.0, 0.0, 0.0, angle, 1.0, 0.0, 0.0, 0.0, 1.0))


@pytest.mark.exercise("B9.6", asks="NaN, infinite or as large as 1e200", read=IS_ROTATION)
@pytest.mark.robust
def test_a_huge_matrix_is_not_a_rotation(rng: Random) -> None:
    cause = "The squares of these numbers are too large for a float, so ** raises OverflowError. "
    cause += "Write a * a instead of a**2, so that the square is inf and you return False."
    expect_rotation(False, cause, *scaled(matrix_of(draw_quad(rng)), 1e200))


@pytest.mark.exercise("B9.6", asks="if an entry is NaN, infinite or", read=IS_ROTATION)
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_a_matrix_that_is_not_finite_is_not_a_rotation(bad: float) -> None:
    cause = "" if math.isnan(bad) else "Here inf * 0 is NaN. "
    cause += "Every comparison with NaN is False, so a check for errors above ROTATION_TOLERANCE "
    cause += "misses NaN. Instead, check that every error is at most ROTATION_TOLERANCE."
    for place in range(9):
        expect_rotation(False, cause, (*IDENTITY[:place], bad, *IDENTITY[place + 1 :]))


def from_slips(q: Quad) -> dict[str, Sequence[float]]:
    """Return the matrices that likely mistakes give for a quaternion."""
    m = [*enumerate(matrix_of(q))]
    return {
        "You return the transpose, as the book prints it (E-11).": transposed(matrix_of(q)),
        "You unpack the quaternion as i, j, k, r. It begins with r.": matrix_of((q[3], *q[:3])),
        "You leave out the factor 2 in the off-diagonal entries. Double all six of them.":
            [0.5 * n if place % 4 else n for place, n in m],
        "You leave out the factor 2 in the numbers on the diagonal. Subtract twice the squares.":
            [n if place % 4 else 0.5 * (1.0 + n) for place, n in m],
        "You leave out the factor 2 in all nine numbers.":
            [0.5 * (n if place % 4 else 1.0 + n) for place, n in m],
    }  # fmt: skip


FORMULAS = (
    *("1 - 2 (j^2 + k^2)", "2 (i j - k r)", "2 (i k + j r)"),
    *("2 (i j + k r)", "1 - 2 (i^2 + k^2)", "2 (j k - i r)"),
    *("2 (i k - j r)", "2 (j k + i r)", "1 - 2 (i^2 + j^2)"),
)


@pytest.mark.exercise("B9.12", asks="The columns of the matrix are the axes X, Y and Z", read=FROM)
def test_ninety_degrees_about_each_axis(rng: Random) -> None:
    half, cause = math.sqrt(0.5), "The columns should be the axes X, Y and Z after the rotation."
    # Only a rotation about no axis of its own tells all mistakes apart.
    drawn = draw_quad(rng)
    with calls(cause):
        got = Matrix3.from_quaternion(Quaternion(*drawn))
    got, right = entries(got), matrix_of(drawn)
    why = named(got, cause, from_slips(drawn), right)
    pairs = zip(got, right, FORMULAS, strict=True) if len(got) == 9 else ()
    wrong = [formula for one, other, formula in pairs if not abs(one - other) < 1e-9]
    if len(wrong) == 1:
        why += f" The number there is {wrong[0]}."
    for axis, a, wanted in (
        ("X", (half, half, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0)),
        ("Y", (half, 0.0, half, 0.0), (0.0, 0.0, 1.0, 0.0, 1.0, 0.0, -1.0, 0.0, 0.0)),
        ("Z", (half, 0.0, 0.0, half), (0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)),
    ):
        with calls(cause):
            q = Quaternion(*a)
            m = Matrix3.from_quaternion(q)
        then = f", row by row, of a rotation by 90 degrees about {axis}"
        expect_close(entries(m), wanted, then=then, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.12", asks="rotates vectors in the same way as the quaternion", read=FROM)
def test_the_matrix_of_any_quaternion(rng: Random) -> None:
    for scale in (1.0, -1.0, 1.0 + 5e-7, -1.0 - 5e-7):
        a = tuple(scale * component for component in draw_quad(rng))
        with calls("Check the sign and the factor 2 in every term of the nine numbers."):
            q = Quaternion(*a)
            m = Matrix3.from_quaternion(q)
        got, wanted = entries(m), matrix_of(a)
        # A length that is off by 5e-7 is accepted, and may be corrected or not.
        near = TIGHT if abs(scale) == 1.0 else 1e-5
        why = named(got, about.cause, from_slips(a), wanted if near == TIGHT else ())
        expect_close(got, wanted, then=", row by row", cause=why, tolerance=near)
        expect_kept("q", rijk(q), a)


def half_turn(axis: Sequence[float]) -> Quad:
    """Return a half-turn about an axis. Its r is exactly 0."""
    return (0.0, *(Triple(axis) / math.hypot(*axis)))


def expect_back(q: Quad, cause: str) -> None:
    """Expect q or -q from the matrix of the quaternion q."""
    n = matrix_of(q)
    with calls(cause, f"m = {written(n)}; m.to_quaternion()"):
        got = same_sign(rijk(Matrix3(*n).to_quaternion()), q)
    r, i, j, k = q
    opposite = "You return the conjugate of the right quaternion."
    equal = {
        "i": "4 i r = m[2, 1] - m[1, 2]",
        "j": "4 j r = m[0, 2] - m[2, 0]",
        "k": "4 k r = m[1, 0] - m[0, 1]",
    }
    signs = f"Take the signs from {equal['i']}, {equal['j']} and {equal['k']}."
    size, letter = max(zip(map(abs, q), "rijk", strict=True))
    if letter != "r":
        opposite = f"Your r has the wrong sign if {letter} is the largest component. Compute r "
        opposite += f"from {equal[letter]}."
    products = (r, i * r * r, j * r * r, k * r * r)
    length = math.hypot(*products) or 1.0
    multiplied = "You multiply by r, as in (m[2, 1] - m[1, 2]) / 4 * r, which is "
    multiplied += "((m[2, 1] - m[1, 2]) / 4) * r. Write (m[2, 1] - m[1, 2]) / (4 * r)."
    slips = {
        opposite: (-r, i, j, k),
        "You lose the signs of the components, because a square root is never negative.":
            [abs(component) for component in q],
        "twice the quaternion": [2.0 * component for component in q],
        "half of the quaternion": [0.5 * component for component in q],
        multiplied: products,
        f"{multiplied} Do the same for j and k.": [one / length for one in products],
    }  # fmt: skip
    for name, wrong in zip("ijk", ((r, -i, j, k), (r, i, -j, k), (r, i, j, -k)), strict=True):
        slips[f"Only the sign of {name} is wrong. The correct equation is {equal[name]}."] = wrong
    # If r is nearly 0, the conjugate cannot be told apart from the right result.
    slips = {name: same_sign(tuple(slip), q) for name, slip in slips.items() if abs(r) > 1e-6}
    why = named(got, signs, slips)
    if why == signs:
        why = cause
        if r == 0.0 and size < 1.0 and isinstance(got, tuple):
            lost = [abs(g * g - c * c) for g, c in zip(got, q, strict=True) if type(g) is float]
            if len(lost) == 4 and max(lost) < TIGHT:  # only signs differ
                why = "You take the signs from differences such as m[2, 1] - m[1, 2], which are 0 "
                why += "in a half-turn. Use sums instead, such as m[0, 1] + m[1, 0] = 4 i j."
    # Components of 1e-8 come from differences of entries of 1: they are right to 1e-16 / 1.
    expect_close(got, q, cause=why, tolerance=TIGHT)


@pytest.mark.exercise(
    "B9.13", asks="Convert a rotation matrix to a unit quaternion", weight=2, read=TO
)
def test_back_from_a_matrix(rng: Random) -> None:
    cause = "The sum of the diagonal is 4 r^2 - 1, which gives r. The others follow from m[2, 1] - "
    cause += "m[1, 2] = 4 i r, m[0, 2] - m[2, 0] = 4 j r and m[1, 0] - m[0, 1] = 4 k r."
    expect_back((1.0, 0.0, 0.0, 0.0), cause)
    for longest in range(3):
        # Two of i, j and k are negative, so that no two lost signs look alike.
        axis = [-positive_number(rng, 0.5, 5.0) for _ in range(3)]
        axis[longest] = 10.0
        for angle in (0.9, 2.6):  # either r or the component of the longest axis is the largest
            expect_back(quad(axis, angle), cause)
    for q in (*(draw_quad(rng) for _ in range(4)), quad(vector(rng), -0.9)):
        expect_back(q, cause)
    cause = "The product of the diagonal is negative, but this is a rotation. Call is_rotation()."
    expect_back(quad((2.0, 2.1, 1.0), 3.0), cause)


@pytest.mark.exercise("B9.13", asks="Start with the component whose number is the largest", read=TO)
def test_back_from_a_half_turn(rng: Random) -> None:
    cause = "In a half-turn r is 0 or almost 0, so a result that you compute from r is inaccurate. "
    cause += "Find the largest of r, i, j and k first, and compute the others from it."
    for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)):
        expect_back((0.0, *axis), cause)
    for longest in range(3):
        tilted = [*(0.1 * vector(rng))]
        tilted[longest] = 10.0
        expect_back(half_turn(tilted), cause)
        for less in (1e-3, 1e-9, -1e-9):
            expect_back(quad(tilted, math.pi - less), cause)
    cause = "Several components are equally large here. Compare with >= to always pick one of them."
    for axis in ((1.0, 1.0, 0.0), (1.0, 0.0, -1.0), (0.0, -1.0, 1.0), (1.0, 1.0, 1.0)):
        expect_back(half_turn(axis), cause)
    cause = "You don't divide by the largest component here. Compare all four to find it."
    for axis in permutations((0.0, 1e-6, 1.0)):
        expect_back(half_turn(axis), cause)


@pytest.mark.exercise("B9.13", asks="so normalize the quaternion at the end", read=TO)
def test_the_result_has_length_one(rng: Random) -> None:
    axes = ((4.0, 3.0, 0.0), (0.0, 4.0, 3.0), (3.0, 0.0, 4.0), (2.0, 2.0, 1.0))
    for drawn in (draw_quad(rng), quad(vector(rng), 0.3), *map(half_turn, axes)):
        [n] = scaled(matrix_of(drawn), 1.0 + 3e-6)
        with calls("Normalize the quaternion, because this matrix is only nearly a rotation."):
            m = Matrix3(*n)
            q = m.to_quaternion()
        got = rijk(q)
        length = math.hypot(*got) if isinstance(got, tuple) else got
        expect_close(length, 1.0, then="; the length of the result", tolerance=TIGHT)
