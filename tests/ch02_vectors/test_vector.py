"""The parts of Vector3, build tasks B2.1 to B2.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.probes import keeps_its_object, walk
from ch02_vectors.vector import Vector3
from draw import components, number
from expect import expect_close, expect_error, expect_exactly, expect_nan, expect_unchanged, xyz

HUGE, TINY = 1e200, 1e-200  # their squares are infinity and zero in a float


def whole_length(rng: Random) -> tuple[tuple[float, float, float], float]:
    """Draw whole components whose length is whole too, by the formula of Lebesgue."""
    m, n, p, q = (rng.randint(1, 6) for _ in range(4))
    x, y, z = m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)
    return (float(x), float(y), float(z)), float(m * m + n * n + p * p + q * q)


# B2.1 Copy, clear and invert


@pytest.mark.exercise("B2.1")
def test_a_copy_has_the_components_and_a_life_of_its_own(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    copied = v.copy()
    read = "the docstring of Vector3.copy"
    expect_close(f"Vector3{a}.copy()", xyz(copied), a, cause="a component is lost", read=read)
    copied.x = 99.0
    expect_unchanged(f"c = Vector3{a}.copy(); c.x = 99", "v", xyz(v), a, read=read)


@pytest.mark.exercise("B2.1")
def test_clear_leaves_zero(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    v.clear()
    expect_exactly(
        f"v = Vector3{a}; v.clear()",
        xyz(v),
        (0.0, 0.0, 0.0),
        cause="a component is left out, or a new vector is made where v should change",
        read="the docstring of Vector3.clear",
    )


@pytest.mark.exercise("B2.1")
def test_invert_changes_the_sign_of_every_component(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    v.invert()
    expect_close(
        f"v = Vector3{a}; v.invert()",
        xyz(v),
        tuple(-number for number in a),
        cause="each component comes from itself; the book's listing sets x from z (errata E-14)",
        read="book 2.1",
    )


@pytest.mark.exercise("B2.1")
def test_minus_v_is_a_new_vector_turned_round(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    call = f"-Vector3{a}"
    turned = -v
    wanted = tuple(-number for number in a)
    expect_close(call, xyz(turned), wanted, cause="a sign is not changed", read="book 2.1")
    expect_unchanged(call, "v", xyz(v), a, read="the docstring of Vector3.__neg__")


# B2.2 Length


@pytest.mark.exercise("B2.2")
def test_magnitude_is_the_length(rng: Random) -> None:
    a, length = whole_length(rng)
    expect_close(
        f"Vector3{a}.magnitude()",
        Vector3(*a).magnitude(),
        length,
        cause="the square root of the sum of the three squares is wanted",
        read="book 2.1",
    )


@pytest.mark.exercise("B2.2")
def test_squared_magnitude_is_the_length_squared(rng: Random) -> None:
    a, length = whole_length(rng)
    expect_close(
        f"Vector3{a}.squared_magnitude()",
        Vector3(*a).squared_magnitude(),
        length * length,
        cause="the sum of the three squares, without the root",
        read="book 2.1",
    )


@pytest.mark.exercise("B2.2")
def test_magnitude_of_huge_and_tiny_components(rng: Random) -> None:
    a, length = whole_length(rng)
    for scale in (HUGE, TINY):
        scaled = tuple(number * scale for number in a)
        expect_close(
            f"Vector3{scaled}.magnitude()",
            Vector3(*scaled).magnitude(),
            length * scale,
            cause="the square of a component is too large or too small for a float: math.hypot "
            "finds the length without it",
            read="the docstring of Vector3.magnitude",
        )


@pytest.mark.exercise("B2.2")
def test_length_of_zero_and_of_nan() -> None:
    read = "the docstrings of Vector3 and Vector3.magnitude"
    zero, lost = Vector3(0.0, 0.0, 0.0), Vector3(1.0, math.nan, 2.0)
    cause = "zero is a vector like any other"
    expect_exactly("Vector3(0, 0, 0).magnitude()", zero.magnitude(), 0.0, cause=cause, read=read)
    cause = "a NaN must stay visible: no max or min, and no test that it slips through"
    expect_nan("Vector3(1, nan, 2).magnitude()", lost.magnitude(), cause=cause, read=read)
    call = "Vector3(1, nan, 2).squared_magnitude()"
    expect_nan(call, lost.squared_magnitude(), cause=cause, read=read)


# B2.3 Multiply and divide by a number


@pytest.mark.exercise("B2.3")
def test_a_vector_times_a_number_on_either_side(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    wanted = tuple(number * scale for number in a)
    read = "book 2.1.3"
    cause = "every component is multiplied once"
    expect_close(f"Vector3{a} * {scale}", xyz(v * scale), wanted, cause=cause, read=read)
    expect_close(f"{scale} * Vector3{a}", xyz(scale * v), wanted, cause=cause, read=read)
    expect_unchanged(f"Vector3{a} * {scale}", "v", xyz(v), a, read=read)


@pytest.mark.exercise("B2.3")
def test_times_equals_changes_the_vector_itself(rng: Random) -> None:
    a, scale = components(rng), number(rng)
    v = Vector3(*a)
    v *= scale
    wanted = tuple(number * scale for number in a)
    call = f"v = Vector3{a}; v *= {scale}"
    expect_close(call, xyz(v), wanted, cause="the method must end with return self", read="2.1.3")
    expect_exactly(
        call + "; whether v is still the same object",
        keeps_its_object("*=", a, a, scale),
        True,
        cause="__imul__ made a new vector where it should change self",
        read="the docstring of Vector3.__imul__",
    )


@pytest.mark.exercise("B2.3")
def test_division_by_a_number(rng: Random) -> None:
    a, divisor = components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*a)
    wanted = tuple(number / divisor for number in a)
    read = "the docstring of Vector3.__truediv__"
    cause = "every component is divided once"
    expect_close(f"Vector3{a} / {divisor}", xyz(v / divisor), wanted, cause=cause, read=read)
    expect_unchanged(f"Vector3{a} / {divisor}", "v", xyz(v), a, read=read)
    w /= divisor
    expect_close(f"v = Vector3{a}; v /= {divisor}", xyz(w), wanted, cause=cause, read=read)
    expect_exactly(
        f"v = Vector3{a}; v /= {divisor}; whether v is still the same object",
        keeps_its_object("/=", a, a, divisor),
        True,
        cause="__itruediv__ made a new vector where it should change self",
        read="the docstring of Vector3.__itruediv__",
    )


@pytest.mark.exercise("B2.3")
def test_a_vector_times_a_vector_is_refused(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)

    def times_equals(factor: object) -> object:
        changed = Vector3(*a)
        changed *= factor
        return changed

    read = "the docstring of Vector3.__mul__"
    cause = "a product could mean three things, and nothing divides by a vector: TypeError"
    for call, attempt, allowed in (
        (f"Vector3{a} * Vector3{b}", lambda: v * w, lambda: v * 2.0),
        (f"v = Vector3{a}; v *= Vector3{b}", lambda: times_equals(w), lambda: times_equals(2.0)),
        (f"Vector3{a} / Vector3{b}", lambda: v / w, lambda: v / 2.0),
    ):
        expect_error(call, attempt, TypeError, allowed=allowed, cause=cause, read=read)


# B2.4 Normalise


@pytest.mark.exercise("B2.4")
def test_normalize_keeps_the_direction_and_makes_the_length_one(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    v.normalize()
    expect_close(
        f"v = Vector3{a}; v.normalize()",
        xyz(v),
        tuple(number / length for number in a),
        cause="the length must be worked out once, before the first component changes",
        read="book 2.1.3",
    )


@pytest.mark.exercise("B2.4")
def test_normalized_is_a_new_unit_vector(rng: Random) -> None:
    a, length = whole_length(rng)
    v = Vector3(*a)
    call = f"Vector3{a}.normalized()"
    wanted = tuple(number / length for number in a)
    read = "the docstring of Vector3.normalized"
    cause = "each component divided by the length, as a new vector"
    expect_close(call, xyz(v.normalized()), wanted, cause=cause, read=read)
    expect_unchanged(call, "v", xyz(v), a, read=read)


@pytest.mark.exercise("B2.4")
def test_the_zero_vector_stays_zero() -> None:
    v = Vector3(0.0, 0.0, 0.0)
    unit = v.normalized()
    v.normalize()
    zero = (0.0, 0.0, 0.0)
    read = "book 2.1.3"
    cause = "zero has no direction: leave it before dividing by its length"
    expect_exactly("v = Vector3(0, 0, 0); v.normalize()", xyz(v), zero, cause=cause, read=read)
    expect_exactly("Vector3(0, 0, 0).normalized()", xyz(unit), zero, cause=cause, read=read)


@pytest.mark.exercise("B2.4")
def test_normalize_huge_and_tiny_vectors(rng: Random) -> None:
    a, length = whole_length(rng)
    for scale in (HUGE, TINY):
        scaled = tuple(number * scale for number in a)
        v = Vector3(*scaled)
        v.normalize()
        expect_close(
            f"v = Vector3{scaled}; v.normalize()",
            xyz(v),
            tuple(number / length for number in a),
            cause="the length, or one divided by it, left the range of a float",
            read="the docstring of Vector3.magnitude",
        )


# B2.5 Add and subtract


@pytest.mark.exercise("B2.5")
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"Vector3{a} + Vector3{b}"
    wanted = (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    read = "book 2.1.4"
    cause = "x with x, y with y, z with z"
    expect_close(call, xyz(v + w), wanted, cause=cause, read=read, tolerance=0.0)
    expect_unchanged(call, "the first vector", xyz(v), a, read=read)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)


@pytest.mark.exercise("B2.5")
def test_the_difference_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"Vector3{a} - Vector3{b}"
    wanted = (a[0] - b[0], a[1] - b[1], a[2] - b[2])
    read = "book 2.1.4"
    cause = "the first minus the second, component by component"
    expect_close(call, xyz(v - w), wanted, cause=cause, read=read, tolerance=0.0)
    expect_unchanged(call, "the first vector", xyz(v), a, read=read)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)


@pytest.mark.exercise("B2.5")
@pytest.mark.parametrize(("operator", "sign"), [("+=", 1.0), ("-=", -1.0)], ids=["plus", "minus"])
def test_plus_and_minus_equals_change_the_vector_itself(
    rng: Random, operator: str, sign: float
) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    if operator == "+=":
        v += w
    else:
        v -= w
    call = f"v = Vector3{a}; v {operator} Vector3{b}"
    wanted = (a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2])
    read = "book 2.1.4"
    cause = "the method must change self and end with return self"
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=0.0)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)
    same = keeps_its_object(operator, a, b, 1.0)
    call += "; whether v is still the same object"
    expect_exactly(call, same, True, cause="a new vector was made", read=read)


@pytest.mark.exercise("B2.5")
def test_a_vector_minus_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v, w = Vector3(*a), Vector3(*a)
    v -= v
    w += w
    cause = "the argument is the vector itself: one component must not wait for another"
    read = "book 2.1.4"
    zero, doubled = (0.0, 0.0, 0.0), (2 * a[0], 2 * a[1], 2 * a[2])
    expect_close(f"v = Vector3{a}; v -= v", xyz(v), zero, cause=cause, read=read)
    expect_close(f"v = Vector3{a}; v += v", xyz(w), doubled, cause=cause, read=read)


@pytest.mark.exercise("B2.5")
def test_a_vector_plus_a_number_is_refused(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    read = "the docstring of Vector3.__add__"
    cause = "return NotImplemented where the other is no Vector3, and Python raises TypeError"
    for call, attempt, allowed in (
        (f"Vector3{a} + 1.0", lambda: v + 1.0, lambda: v + v),
        (f"Vector3{a} - 1.0", lambda: v - 1.0, lambda: v - v),
    ):
        expect_error(call, attempt, TypeError, allowed=allowed, cause=cause, read=read)


# B2.6 Add a scaled vector


@pytest.mark.exercise("B2.6")
def test_add_scaled_changes_the_vector_itself(rng: Random) -> None:
    a, b, scale = components(rng), components(rng), number(rng)
    v, w = Vector3(*a), Vector3(*b)
    v.add_scaled(w, scale)
    call = f"v = Vector3{a}; v.add_scaled(Vector3{b}, {scale})"
    expect_close(
        call,
        xyz(v),
        tuple(old + step * scale for old, step in zip(a, b, strict=True)),
        cause="the argument is scaled, not the vector itself, and the result stored in self",
        read="book 2.1.4",
        tolerance=1e-12,  # rounding of numbers up to 100
    )
    expect_unchanged(call, "the argument", xyz(w), b, read="book 2.1.4")


@pytest.mark.exercise("B2.6")
def test_add_scaled_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    v.add_scaled(v, 2.0)
    expect_close(
        f"v = Vector3{a}; v.add_scaled(v, 2)",
        xyz(v),
        tuple(3.0 * number for number in a),
        cause="the argument is the vector itself: do not change it before you have read it",
        read="the docstring of Vector3.add_scaled",
    )


@pytest.mark.exercise("B2.6")
def test_add_scaled_frame_after_frame(rng: Random) -> None:
    start, velocity = components(rng), components(rng)
    expect_close(
        f"600 times position.add_scaled(Vector3{velocity}, 1 / 60) from {start}",
        walk(start, velocity, 1.0 / 60.0, 600),
        tuple(p + 10.0 * v for p, v in zip(start, velocity, strict=True)),
        cause="600 frames of 1/60 s are 10 s: p' = p + v h in each",
        read="book 2.2 and Eq. 2.7",
        tolerance=1e-10,  # 600 roundings of numbers up to 100
    )


# B2.7 The component product


@pytest.mark.exercise("B2.7")
def test_the_component_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"Vector3{a}.component_product(Vector3{b})"
    wanted = tuple(p * q for p, q in zip(a, b, strict=True))
    read = "book 2.1.6"
    cause = "x times x, y times y, z times z"
    expect_close(call, xyz(v.component_product(w)), wanted, cause=cause, read=read)
    expect_unchanged(call, "the first vector", xyz(v), a, read=read)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)


@pytest.mark.exercise("B2.7")
def test_the_component_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    v.component_product_update(w)
    call = f"v = Vector3{a}; v.component_product_update(Vector3{b})"
    wanted = tuple(p * q for p, q in zip(a, b, strict=True))
    read = "book 2.1.6"
    cause = "the product is stored in self"
    expect_close(call, xyz(v), wanted, cause=cause, read=read)
    expect_unchanged(call, "the argument", xyz(w), b, read=read)


@pytest.mark.exercise("B2.7")
def test_the_component_product_with_itself(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    v.component_product_update(v)
    expect_close(
        f"v = Vector3{a}; v.component_product_update(v)",
        xyz(v),
        tuple(number * number for number in a),
        cause="every component is squared: do not change the argument before you have read it",
        read="book 2.1.6",
    )


# B2.8 The scalar product


@pytest.mark.exercise("B2.8")
def test_the_scalar_product_is_the_sum_of_the_products(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"Vector3{a}.dot(Vector3{b})"
    wanted = math.fsum(p * q for p, q in zip(a, b, strict=True))
    read = "book 2.1.7, Eq. 2.4"
    cause = "a number is wanted: the three products of components, added up"
    # The terms may cancel, so rounding is measured by the terms: at most 100 each.
    expect_close(call, v.dot(w), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "the first vector", xyz(v), a, read=read)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)


@pytest.mark.exercise("B2.8")
def test_the_at_sign_is_the_scalar_product(rng: Random) -> None:
    a, b = components(rng), components(rng)
    expect_close(
        f"Vector3{a} @ Vector3{b}",
        Vector3(*a) @ Vector3(*b),
        math.fsum(p * q for p, q in zip(a, b, strict=True)),
        cause="__matmul__ gives what dot gives",
        read="book 2.1.7, Eq. 2.4",
        tolerance=1e-12,
    )


@pytest.mark.exercise("B2.8")
def test_the_scalar_product_is_the_lengths_times_the_cosine(rng: Random) -> None:
    angle, first, second = rng.uniform(1.8, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, first, 0.0)
    b = (second * math.sin(angle), second * math.cos(angle), 0.0)
    expect_close(
        f"Vector3{a}.dot(Vector3{b})",
        Vector3(*a).dot(Vector3(*b)),
        first * second * math.cos(angle),
        cause="an obtuse angle gives a negative product: no absolute value",
        read="book 2.1.7, Eq. 2.4",
        tolerance=1e-12,
    )


@pytest.mark.exercise("B2.8")
def test_nan_and_infinity_stay_visible_in_the_scalar_product() -> None:
    w = Vector3(1.0, 1.0, 1.0)
    read = "the docstring of Vector3"
    cause = "a NaN must come out as NaN"
    call = "Vector3(nan, 1, 1).dot(Vector3(1, 1, 1))"
    expect_nan(call, Vector3(math.nan, 1.0, 1.0).dot(w), cause=cause, read=read)
    call = "Vector3(inf, 1, 1).dot(Vector3(1, 1, 1))"
    cause = "an infinity must come out as one"
    got = Vector3(math.inf, 1.0, 1.0).dot(w)
    expect_exactly(call, got, math.inf, cause=cause, read=read)


# B2.9 The vector product


@pytest.mark.exercise("B2.9")
def test_x_cross_y_is_z_and_so_on_round() -> None:
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    for i in range(3):
        a, b, c = axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3]
        expect_close(
            f"Vector3{a}.cross(Vector3{b})",
            xyz(Vector3(*a).cross(Vector3(*b))),
            c,
            cause="the axes are right-handed; the opposite vector means b x a was worked out",
            read="book 2.1.8, Eq. 2.6",
        )


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_a_new_vector(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    call = f"Vector3{a}.cross(Vector3{b})"
    wanted = (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
    read = "book 2.1.8, Eq. 2.6"
    cause = "x is made of y and z, y of z and x, z of x and y"
    # The two terms of a component may cancel, so rounding is measured by the terms.
    expect_close(call, xyz(v.cross(w)), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "the first vector", xyz(v), a, read=read)
    expect_unchanged(call, "the second vector", xyz(w), b, read=read)


@pytest.mark.exercise("B2.9")
def test_the_vector_product_is_the_lengths_times_the_sine(rng: Random) -> None:
    angle, first, second = rng.uniform(0.2, 3.0), rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0)
    a = (0.0, 0.0, first)
    b = (second * math.sin(angle), 0.0, second * math.cos(angle))
    expect_close(
        f"Vector3{a}.cross(Vector3{b})",
        xyz(Vector3(*a).cross(Vector3(*b))),
        (0.0, first * second * math.sin(angle), 0.0),
        cause="y is z of the first times x of the second, minus x of the first times z of the "
        "second: the signs of y are the other way round from what they look like",
        read="book 2.1.8, Eq. 2.6",
        tolerance=1e-12,
    )


@pytest.mark.exercise("B2.9")
def test_the_vector_product_in_place(rng: Random) -> None:
    a, b = components(rng), components(rng)
    v, w = Vector3(*a), Vector3(*b)
    v.cross_update(w)
    call = f"v = Vector3{a}; v.cross_update(Vector3{b})"
    wanted = (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
    read = "the docstring of Vector3.cross_update"
    cause = "a component was read after it had been changed: work out all three, then store them"
    expect_close(call, xyz(v), wanted, cause=cause, read=read, tolerance=1e-12)
    expect_unchanged(call, "the argument", xyz(w), b, read=read)


@pytest.mark.exercise("B2.9")
def test_a_vector_crossed_with_itself_in_place(rng: Random) -> None:
    a = components(rng)
    v = Vector3(*a)
    v.cross_update(v)
    expect_close(
        f"v = Vector3{a}; v.cross_update(v)",
        xyz(v),
        (0.0, 0.0, 0.0),
        cause="parallel vectors have no vector product, and v is both of them here",
        read="book 2.1.8",
        tolerance=1e-12,
    )
