"""Quaternions rotate vectors: build task B9.10."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion
from draw import Components, components
from expect import about, expect_close, expect_that, expect_unchanged, xyz
from turning import TIGHT, Quad, draw_quad, expect_kept, hamilton, named, rijk, short, turned

ROTATE = "the docstring of rotate"


def rotate_slips(q: Quad, v: Components) -> dict[str, Components]:
    """Return the results of likely mistakes in rotate."""
    back = (q[0], -q[1], -q[2], -q[3])
    once = hamilton(q, (0.0, *v))
    first = "You put r last, as in Quaternion(x, y, z, 0). It comes first, as in Quaternion(0, x, "
    first += "y, z)."
    r_last = hamilton(hamilton(q, (*v, 0.0)), back)
    u = q[1:]
    across = hamilton((0.0, *u), (0.0, *v))[1:]  # the vector part of u v, u x v
    twice = hamilton((0.0, *u), (0.0, *across))[1:]
    formula = "In v + 2 r (u x v) + 2 u x (u x v), you leave out the 2 of the"
    return {
        "Your code ignores the sign of r, which is negative here. Use the component r "
        "itself.": turned((abs(q[0]), *q[1:]), v),
        "You rotate in the opposite direction. Either you compute q* (0, v) q, with the conjugate "
        "on the wrong side, or you compute v x u instead of u x v.": turned(back, v),
        "You compute q (0, v), without q* on the right. Multiply by q* too.": once[1:],
        "You compute (0, v) q*, without q on the left. Multiply by it too.": hamilton(
            (0.0, *v), back
        )[1:],
        "You compute q (0, v) q. Use the conjugate of q on the right.": hamilton(once, q)[1:],
        first: r_last[1:],
        f"{first} The result begins with r, too.": r_last[:3],
        "You return r, i and j of the product. The vector part is i, j and k.": (
            0.0,
            *turned(q, v)[:2],
        ),
        "In v + 2 r (u x v) + 2 u x (u x v), your third term has the wrong sign. Compute "
        "u x (u x v), not (u x v) x u.": tuple(
            a + 2.0 * q[0] * b - 2.0 * c for a, b, c in zip(v, across, twice, strict=True)
        ),
        f"{formula} second term. Multiply this term by 2.": tuple(
            a + q[0] * b + 2.0 * c for a, b, c in zip(v, across, twice, strict=True)
        ),
        f"{formula} third term. Multiply this term by 2.": tuple(
            a + 2.0 * q[0] * b + c for a, b, c in zip(v, across, twice, strict=True)
        ),
        "the original v": v,
    }


def vector_of(result: object) -> Components:
    """Return the components of a result of rotate, which must be a vector."""
    if isinstance(result, Quaternion):
        cause = "You return the whole product, which is a Quaternion. Return only its vector part, "
        cause += "as in Vector3(p.i, p.j, p.k)."
        expect_that(False, f"Quaternion{short(rijk(result))}", "a Vector3", cause=cause)
    return xyz(result)


@pytest.mark.exercise("B9.10", asks="return the result as a new vector", weight=2)
def test_rotates_a_vector(rng: Random) -> None:
    about.read = ROTATE
    half = math.sqrt(0.5)
    about.call = f"q = Quaternion({half:.6g}, 0, 0, {half:.6g}), a rotation by 90 degrees about Z; "
    about.call += "q.rotate(Vector3(1, 2, 3))"
    about.cause = (
        "Compute q (0, v) q*, where q* is the conjugate of q, and (0, v) is the quaternion with r "
        "= 0 and the vector part v."
    )
    v = Vector3(1.0, 2.0, 3.0)
    got = vector_of(Quaternion(half, 0.0, 0.0, half).rotate(v))
    instead = "Return a new vector instead."
    expect_kept("the vector", xyz(v), (1.0, 2.0, 3.0), instead)
    why = named(got, about.cause, rotate_slips((half, 0.0, 0.0, half), (1.0, 2.0, 3.0)))
    expect_close(got, (-2.0, 1.0, 3.0), cause=why, tolerance=TIGHT)
    about.cause = (
        "Return the vector part of q (0, v) q*, which is v + 2 r (u x v) + 2 u x (u x v) with u = "
        "(i, j, k)."
    )
    for sign in (1.0, -1.0, 1.0 + 5e-7):
        q, a = tuple(sign * component for component in draw_quad(rng)), components(rng)
        quaternion, v = Quaternion(*q), Vector3(*a)
        about.call = f"q = Quaternion{short(q)}; q.rotate(Vector3{short(a)})"
        got = vector_of(quaternion.rotate(v))
        # Rounding of a vector of length up to 17, or the effect of a length that is off by 5e-7.
        near = 1e-11 if abs(sign) == 1.0 else 1e-4
        why = named(got, about.cause, rotate_slips(q, a))
        expect_close(got, turned(q, a), cause=why, tolerance=near)
        expect_kept("the vector", xyz(v), a)
        expect_kept("q", rijk(quaternion), q)
    about.call = f"v = Vector3{short(a)}; Quaternion().rotate(v).invert(); v"
    about.cause = (
        "You return v itself, so a change of the result also changes v. Return a new vector, even "
        "if the rotation is by 0."
    )
    same = Quaternion().rotate(v)
    same.invert()
    expect_unchanged("v", xyz(v), a)
