"""Vector3: copies, length and multiples, build tasks B2.1 to B2.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from draw import Components, components, number
from expect import (
    LOST,
    about,
    blame,
    cause_of,
    expect_close,
    expect_error,
    expect_nan,
    expect_same_object,
    expect_unchanged,
    xyz,
)

HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float
ZERO = (0.0, 0.0, 0.0)


def whole_length(rng: Random) -> tuple[Components, float]:
    """Draw whole components, none of them 0, with a whole length by Lebesgue's formula."""
    x = z = 0
    while not x or not z:
        m, n, p, q = (rng.randint(1, 6) for _ in range(4))
        x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return (float(x), float(y), float(z)), float(m * m + n * n + p * p + q * q)


def scaled(a: Components, scale: float) -> Components:
    return a[0] * scale, a[1] * scale, a[2] * scale


# B2.1 Copy, clear and invert


@pytest.mark.exercise("B2.1")
def test_a_copy_has_the_components_and_a_life_of_its_own(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.copy()"
    about.cause = "Return a new Vector3 with the same x, y and z."
    about.read = "the docstring of Vector3.copy"
    copied = v.copy()
    expect_close(xyz(copied), a)
    copied.x = 99.0
    about.call = f"v = Vector3{a}; w = v.copy(); w.x = 99"
    about.cause = "copy() returned the vector itself. Return a new Vector3 with the same "
    about.cause += "components."
    expect_unchanged("v", xyz(v), a)


@pytest.mark.exercise("B2.1")
def test_clear_leaves_zero(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about(f"v = Vector3{a}; v.clear()", cause="Set all three components of self to zero.")
    about.read = "the docstring of Vector3.clear"
    v.clear()
    blame(xyz(v), [(a, f"{LOST} self = Vector3() does not change v.")])
    expect_close(xyz(v), ZERO)


@pytest.mark.exercise("B2.1")
def test_invert_changes_the_sign_of_every_component(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.invert()"
    about.cause = "Change the sign of every component of self: self.x = -self.x, and so on."
    about.read = "book 2.1, and errata.md"
    v.invert()
    printed = "The book's listing sets x from z and never changes z (E-14). Correct this error."
    blame(xyz(v), [(a, LOST), ((-a[2], -a[1], a[2]), printed)])
    expect_close(xyz(v), scaled(a, -1.0))


@pytest.mark.exercise("B2.1")
def test_minus_v_is_a_new_vector_turned_round(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about(f"v = Vector3{a}; -v", cause="Return a new vector with all three signs reversed.")
    about.read = "the docstring of Vector3.__neg__"
    expect_close(xyz(-v), scaled(a, -1.0))
    about.cause = "-v must return a new vector and leave v unchanged. Only invert changes v itself."
    expect_unchanged("v", xyz(v), a)


# B2.2 Length


@pytest.mark.exercise("B2.2")
def test_magnitude_is_the_length(rng: Random) -> None:
    a, length = whole_length(rng)
    about(f"Vector3{a}.magnitude()", cause="The magnitude is sqrt(x^2 + y^2 + z^2).")
    about.read = "book 2.1"
    got = Vector3(*a).magnitude()
    mistakes = [
        (length**2, "The result is the squared length. Take its square root."),
        (math.hypot(a[0], a[1]), "The result is the length without z. Add the square of z, too."),
        (sum(a), "The result is the sum of the components. Square each component first."),
    ]
    blame(got, mistakes)
    expect_close(got, length)


@pytest.mark.exercise("B2.2")
def test_squared_magnitude_is_the_length_squared(rng: Random) -> None:
    a, length = whole_length(rng)
    about(f"Vector3{a}.squared_magnitude()", cause="The squared magnitude is x^2 + y^2 + z^2.")
    about.read = "book 2.1"
    got = Vector3(*a).squared_magnitude()
    mistakes = [
        (length, "The result is the length itself. Leave out the square root."),
        (a[0] ** 2 + a[1] ** 2, "The result is x^2 + y^2. Add the square of z."),
    ]
    blame(got, mistakes)
    expect_close(got, length**2)


@pytest.mark.exercise("B2.2")
@pytest.mark.robust
def test_magnitude_of_huge_and_tiny_components(rng: Random) -> None:
    a, length = whole_length(rng)
    about.cause = "The square of 1e200 is too large for a float, and the square of 1e-200 is too "
    about.cause += "small. math.hypot computes the length without overflow."
    about.read = "the docstring of Vector3.magnitude"
    for scale in (HUGE, TINY):
        b = scaled(a, scale)
        about.call = f"Vector3{b}.magnitude()"
        expect_close(Vector3(*b).magnitude(), length * scale)


@pytest.mark.exercise("B2.2")
def test_the_zero_vector_has_the_length_zero() -> None:
    about("Vector3(0, 0, 0).magnitude()", cause="The zero vector has length zero.")
    about.read = "book 2.1"
    expect_close(Vector3(0.0, 0.0, 0.0).magnitude(), 0.0)


@pytest.mark.exercise("B2.2")
@pytest.mark.robust
def test_nan_stays_visible_in_a_length() -> None:
    about.read = "the docstrings of Vector3 and Vector3.magnitude"
    lost = Vector3(1.0, math.nan, 2.0)
    about.call = "Vector3(1, nan, 2).magnitude()"
    about.cause = (
        "The length of a vector with a NaN is NaN. max, min and comparisons can hide a NaN."
    )
    expect_nan(lost.magnitude())
    about.call = "Vector3(1, nan, 2).squared_magnitude()"
    expect_nan(lost.squared_magnitude())


# B2.3 Multiply and divide by a number


@pytest.mark.exercise("B2.3")
def test_a_vector_times_a_number_on_either_side(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    about.cause = (
        "Return a new vector with each component multiplied by the number, which may be an int or "
        "a float."
    )
    about.read = "book 2.1.3"
    for factor in (scale, 2):
        wanted = scaled(a, factor)
        about.call = f"v = Vector3{a}; v * {factor}"
        expect_close(xyz(v * factor), wanted)
        reads = f"v * {factor} must return a new vector and leave v unchanged. Only v *= changes v."
        expect_unchanged("v", xyz(v), a, cause=reads)
        about.call = f"v = Vector3{a}; {factor} * v"
        expect_close(xyz(factor * v), wanted)


@pytest.mark.exercise("B2.3")
def test_times_equals_changes_the_vector_itself(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = before = Vector3(*a)
    made, step = f"v = Vector3{a}", f"v *= {scale}"
    about.call = f"{made}; {step}"
    about.cause = "Multiply each component of self, and end with return self. Python assigns the "
    about.cause += "returned value to v."
    about.read = "book 2.1.3, and the docstring of Vector3.__imul__"
    v *= scale
    expect_close(xyz(v), scaled(a, scale))
    expect_same_object(made, step, v, before)


@pytest.mark.exercise("B2.3")
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = components(rng), number(rng)
    v = Vector3(*a)
    w = before = Vector3(*a)
    wanted = (a[0] / divisor, a[1] / divisor, a[2] / divisor)
    mistakes = [
        (
            tuple(n // divisor for n in a),
            "// rounds down to a whole number. Divide with / instead.",
        ),
        (scaled(a, divisor), "The result is v times the number. Divide by the number."),
    ]
    made, step = f"v = Vector3{a}", f"v /= {divisor}"
    about(
        f"{made}; v / {divisor}",
        cause="Return a new vector with each component divided by the number.",
    )
    about.read = "the docstring of Vector3.__truediv__"
    got = xyz(v / divisor)
    expect_close(got, wanted, cause=cause_of(got, mistakes, about.cause))
    reads = f"v / {divisor} must return a new vector and leave v unchanged. Only v /= changes v."
    expect_unchanged("v", xyz(v), a, cause=reads)
    about.call = f"{made}; {step}"
    about.cause = "Divide each component of self, and end with return self. Python assigns the "
    about.cause += "returned value to v."
    about.read = "the docstring of Vector3.__itruediv__"
    w /= divisor
    got = xyz(w)
    expect_close(got, wanted, cause=cause_of(got, mistakes, about.cause))
    expect_same_object(made, step, w, before)


def divide_in_place(a: Components, divisor: object) -> object:
    v = Vector3(*a)
    v /= divisor
    return v


@pytest.mark.exercise("B2.3")
@pytest.mark.robust
def test_division_by_zero_is_an_error(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    about.cause = (
        "Division by zero has no result. Do not catch Python's ZeroDivisionError, so that the "
        "caller sees it."
    )
    about.read = "the docstring of Vector3.__truediv__"
    for call, attempt, allowed in (
        (f"v = Vector3{a}; v / 0.0", lambda: v / 0.0, lambda: v / 2.0),
        (
            f"v = Vector3{a}; v /= 0.0",
            lambda: divide_in_place(a, 0.0),
            lambda: divide_in_place(a, 2.0),
        ),
    ):
        about.call = call
        expect_error(attempt, ZeroDivisionError, allowed=allowed)


@pytest.mark.exercise("B2.3")
@pytest.mark.robust
def test_a_vector_times_a_vector_is_refused(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)

    def times_equals(factor: object) -> object:
        changed = Vector3(*a)
        changed *= factor
        return changed

    asked = "Check isinstance(..., Vector3) first, and raise TypeError."
    product = f"v * w could mean three different products, so * accepts only numbers. {asked}"
    about.read = "the docstring of Vector3.__mul__"
    for call, attempt, allowed, cause in (
        (f"Vector3{a} * Vector3{b}", lambda: v * w, lambda: v * 2.0, product),
        (
            f"v = Vector3{a}; v *= Vector3{b}",
            lambda: times_equals(w),
            lambda: times_equals(2.0),
            product,
        ),
        (
            f"Vector3{a} / Vector3{b}",
            lambda: v / w,
            lambda: v / 2.0,
            f"A vector cannot be divided by a vector. {asked}",
        ),
    ):
        about(call, cause=cause)
        expect_error(attempt, TypeError, allowed=allowed)


# B2.4 Normalize


@pytest.mark.exercise("B2.4")
def test_normalize_keeps_the_direction_and_makes_the_length_one(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.normalize()"
    about.cause = "Divide each of the three components of self by the length."
    about.read = "book 2.1.3"
    v.normalize()
    x = a[0] / length
    y = a[1] / math.hypot(x, a[1], a[2])
    mistakes = [
        (a, LOST),
        (
            scaled(a, length**-2),
            "The vector was divided by its squared length. Divide by magnitude().",
        ),
        (
            (x, y, a[2] / math.hypot(x, y, a[2])),
            "The length was computed again after x had changed. Compute it once and store it in a "
            "variable.",
        ),
    ]
    blame(xyz(v), mistakes)
    expect_close(xyz(v), scaled(a, 1.0 / length))


@pytest.mark.exercise("B2.4")
def test_normalized_is_a_new_unit_vector(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    about.call = f"v = Vector3{a}; v.normalized()"
    about.cause = "Return a new vector with each component divided by the length."
    about.read = "the docstring of Vector3.normalized"
    got = xyz(v.normalized())
    mistakes = [
        (
            scaled(a, length**-2),
            "The vector was divided by its squared length. Divide by magnitude().",
        )
    ]
    blame(got, mistakes)
    expect_close(got, scaled(a, 1.0 / length))
    about.cause = (
        "normalized must return a new vector and leave v unchanged. Only normalize changes v."
    )
    expect_unchanged("v", xyz(v), a)
    first = v.normalized()
    Vector3(0.0, -1.0, 0.0).normalized()
    about.call = f"u = Vector3{a}.normalized(); Vector3(0, -1, 0).normalized(); u"
    about.cause = (
        "The second call changed the result of the first. Create a new vector in every call."
    )
    expect_close(xyz(first), scaled(a, 1.0 / length))


@pytest.mark.exercise("B2.4")
def test_the_zero_vector_stays_zero() -> None:
    v = Vector3(0.0, 0.0, 0.0)
    about.call = "v = Vector3(0, 0, 0); v.normalized()"
    about.cause = (
        "The zero vector has no direction and stays zero. Test for a length of 0.0 before you "
        "divide."
    )
    about.read = "book 2.1.3"
    expect_close(xyz(v.normalized()), ZERO)
    about.call = "v = Vector3(0, 0, 0); v.normalize()"
    v.normalize()
    expect_close(xyz(v), ZERO)


@pytest.mark.exercise("B2.4")
@pytest.mark.robust
def test_normalize_huge_and_tiny_vectors(rng: Random) -> None:
    a, length = whole_length(rng)
    about.read = "the docstring of Vector3.normalize"
    for scale in (HUGE, TINY):
        b = scaled(a, scale)
        v = Vector3(*b)
        about.call = f"v = Vector3{b}; v.normalize()"
        about.cause = "A square is outside the range of a float. Compute the length with "
        about.cause += "magnitude()."
        v.normalize()
        taken = "v did not change. A short vector is not zero, so test only for magnitude() == 0.0."
        mistakes = [
            (b, taken),
            (ZERO, "The squared length overflowed to infinity. Use magnitude() instead."),
        ]
        blame(xyz(v), mistakes)
        expect_close(xyz(v), scaled(a, 1.0 / length))
