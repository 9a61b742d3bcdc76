"""Rotations in plain numbers, independent of any engine. The checks of chapter 9 compare with them.

A quaternion is a tuple (r, i, j, k), and a 3x3 matrix is a tuple of nine numbers, row by row.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import expect
from draw import Components, number, positive_number, rounded, vector
from expect import NoVector, is_plain

Quad = tuple[float, float, float, float]
Nine = tuple[float, ...]
IDENTITY = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
X_AXIS, Y_AXIS, Z_AXIS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
# Rounding of a few dozen operations on numbers of about 1, in any order.
TIGHT = 1e-12
# The same for sums of products of numbers up to 90.
LOOSE = 1e-11


def rijk(q: Any) -> Any:
    """Return the components of a quaternion as a tuple."""
    return NoVector(q, "Quaternion") if is_plain(q) else (q.r, q.i, q.j, q.k)


def entries(m: Any) -> Any:
    """Return the numbers of a Matrix3 or a Matrix4 as a tuple, row by row."""
    return NoVector(m, "matrix") if is_plain(m) else tuple(m.entries)


def quad(axis: Sequence[float], angle: float) -> Quad:
    """Return the quaternion of a rotation about an axis of any length."""
    length = math.hypot(*axis)
    sine = math.sin(0.5 * angle)
    x, y, z = (component / length * sine for component in axis)
    return math.cos(0.5 * angle), x, y, z


def hamilton(a: Sequence[float], b: Sequence[float]) -> Quad:
    """Return the product of two quaternions, from the table of i, j and k."""
    table = {  # the component of the product of two of 1, i, j, k, and its sign
        (1, 2): (3, 1.0),
        (2, 3): (1, 1.0),
        (3, 1): (2, 1.0),
        (2, 1): (3, -1.0),
        (3, 2): (1, -1.0),
        (1, 3): (2, -1.0),
    }
    total = [0.0, 0.0, 0.0, 0.0]
    for m in range(4):
        for n in range(4):
            place, sign = (0, -1.0) if m == n > 0 else table.get((m, n), (m + n, 1.0))
            total[place] += sign * a[m] * b[n]
    return total[0], total[1], total[2], total[3]


def turned(q: Sequence[float], v: Sequence[float]) -> Components:
    """Return a vector rotated by a unit quaternion."""
    back = (q[0], -q[1], -q[2], -q[3])
    _, x, y, z = hamilton(hamilton(q, (0.0, *v)), back)
    return x, y, z


def matrix_of(q: Sequence[float]) -> Nine:
    """Return the matrix of a unit quaternion. Its columns are the rotated axes."""
    return transposed([x for axis in (X_AXIS, Y_AXIS, Z_AXIS) for x in turned(q, axis)])


def transposed(m: Sequence[float]) -> Nine:
    """Return the transpose of a 3x3 matrix."""
    return tuple(m[3 * row + column] for column in range(3) for row in range(3))


def times(m: Sequence[float], n: Sequence[float]) -> Nine:
    """Return the product of two matrices."""
    return tuple(
        math.fsum(m[3 * row + k] * n[3 * k + column] for k in range(3))
        for row in range(3)
        for column in range(3)
    )


def applied(m: Sequence[float], v: Sequence[float]) -> Components:
    """Return a matrix times a vector."""
    x, y, z = (math.fsum(m[3 * row + k] * v[k] for k in range(3)) for row in range(3))
    return x, y, z


def joined(linear: Nine, move: Components) -> Nine:
    """Return the twelve numbers of a Matrix4 with this linear part and translation."""
    return (*linear[0:3], move[0], *linear[3:6], move[1], *linear[6:9], move[2])


def added(v: Components, w: Components) -> Components:
    """Return the sum of two vectors."""
    return v[0] + w[0], v[1] + w[1], v[2] + w[2]


def subtracted(v: Components, w: Components) -> Components:
    """Return the difference of two vectors."""
    return v[0] - w[0], v[1] - w[1], v[2] - w[2]


def moved(linear: Nine, move: Components, v: Components) -> Components:
    """Return a point after a linear map and a translation."""
    return added(applied(linear, v), move)


def determinant(m: Sequence[float]) -> float:
    """Return the determinant, by the rule of Sarrus."""
    a, b, c, d, e, f, g, h, i = m
    return math.fsum((a * e * i, b * f * g, c * d * h, -c * e * g, -b * d * i, -a * f * h))


def draw_turn(rng: Random) -> tuple[Components, float]:
    """Draw an axis of any length and an angle from 0.3 to 2.8."""
    return vector(rng), positive_number(rng, 0.3, 2.8)


def draw_quad(rng: Random) -> Quad:
    """Draw a unit quaternion whose components are all clearly different from zero."""
    return quad(*draw_turn(rng))


def draw_matrix(rng: Random) -> Nine:
    """Draw a matrix that is far from singular, with a dominant diagonal.

    No number is near zero, so every sign matters.
    """
    m = [number(rng, 0.1, 2.0) for _ in range(9)]
    for place in (0, 4, 8):
        m[place] = rng.choice((-1.0, 1.0)) * positive_number(rng, 5.0, 9.0)
    return tuple(m)


def draw_mirror(rng: Random) -> Nine:
    """Draw a matrix as draw_matrix does, with a negative determinant."""
    m = draw_matrix(rng)
    return m if determinant(m) < 0.0 else tuple(-number for number in m)


def draw_slight_turn(rng: Random) -> Nine:
    """Draw the matrix of a small rotation, so that a wrong determinant is still positive."""
    return matrix_of(quad(vector(rng), positive_number(rng, 0.3, 0.6)))


def named(
    got: Any, cause: str, slips: Mapping[str, float | Sequence[float]], wanted: Sequence[float] = ()
) -> str:
    """Return the cause, after the slip that gives the numbers in got, as expect.named does.

    A slip that is not a sentence completes "Your result is". If no slip gives these numbers, but
    only one or two numbers of a matrix differ from ``wanted``, name their rows and columns instead.
    Of a vector or a quaternion, name the only component that differs.
    """
    sentences = {
        slip if slip.endswith(".") else f"Your result is {slip}.": slips[slip] for slip in slips
    }
    likely = expect.named(got, cause, sentences)
    if likely != cause or not isinstance(got, tuple) or not 0 < len(wanted) == len(got):
        return likely
    near = 1e-9 * max(map(abs, wanted))
    if not all(type(g) in (int, float) for g in got):
        return cause
    wrong = {  # whether only the sign is wrong, keyed by the place
        _place(len(wanted), place): abs(g + w) <= near
        for place, (g, w) in enumerate(zip(got, wanted, strict=True))
        if not abs(g - w) <= near
    }
    if len(wanted) < 9 and len(wrong) == 1:
        ((component, sign),) = wrong.items()
        return f"Only {'the sign of ' * sign}{component} is wrong. {cause}"
    if len(wrong) not in (1, 2) or len(wanted) < 9:
        return cause
    what = ("the sign in ", "the signs in ")[len(wrong) - 1] if all(wrong.values()) else ""
    return f"Your matrix is right except for {what}{' and '.join(wrong)}. {cause}"


def _place(count: int, place: int) -> str:
    """Return the name of a component of a vector or quaternion, or the place in a matrix."""
    if count < 9:
        return ("xyz" if count == 3 else "rijk")[place]
    columns = count // 3
    return f"row {place // columns + 1}, column {place % columns + 1}"


def expect_kept(
    name: str,
    now: Sequence[float],
    before: Sequence[float],
    instead: str = "Use local variables instead.",
) -> None:
    """Expect that a call did not change an object that it should only read.

    ``instead`` says what to do instead.
    """
    __tracebackhide__ = True
    cause = f"Your code changes {name}, which it should only read. {instead}"
    expect.expect_unchanged(name, now, before, cause=cause)


def same_sign(got: Any, wanted: Sequence[float]) -> Any:
    """Return q or -q, whichever is closer to ``wanted``. Both represent the same orientation."""
    if isinstance(got, NoVector) or len(got) != len(wanted):
        return got
    if not all(type(number) in (int, float) for number in got):
        return got
    along = math.fsum(g * w for g, w in zip(got, wanted, strict=True))
    return tuple(-number for number in got) if along < 0.0 else got


def short(numbers: Sequence[float]) -> str:
    """Return numbers in parentheses, with six digits each. A rounding error becomes 0."""
    tiny = 1e-15 * max(map(abs, numbers))
    return rounded(0.0 if abs(number) < tiny else number for number in numbers)


def written(numbers: Sequence[float], *, exact: bool = False) -> str:
    """Return the call that makes a Matrix3 or Matrix4, with a line for each row if it is long.

    The numbers have six digits, or all of them if the message is about their rounding errors.
    """
    across = len(numbers) // 3
    rows = [numbers[i : i + across] for i in range(0, 3 * across, across)]
    rows = [", ".join(map(repr, row)) if exact else short(row)[1:-1] for row in rows]
    between = ", " if sum(map(len, rows)) < 60 else ",\n    "
    return f"Matrix{across}({between.join(rows)})"
