"""Vector3 against exact fractions and NumPy, for vectors that hypothesis generates."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from ch02_vectors.exercises import angle_by_scalar_product, angles_by_vector_product
from ch02_vectors.vector import Vector3, make_orthonormal_basis

UNIT_ROUNDING = 2.0**-53
component = st.floats(-1e100, 1e100).filter(lambda value: value == 0.0 or abs(value) > 1e-100)
vector = st.tuples(component, component, component)


def exact(a: tuple[float, ...]) -> list[Fraction]:
    return [Fraction(value) for value in a]


@given(vector, vector)
def test_the_scalar_product_is_exact_but_for_its_five_roundings(
    a: tuple[float, float, float], b: tuple[float, float, float]
) -> None:
    terms = [p * q for p, q in zip(exact(a), exact(b), strict=True)]
    error = abs(Fraction(Vector3(*a).dot(Vector3(*b))) - sum(terms))
    # Higham, Accuracy and Stability, 3.1: n u / (1 - n u) of the terms' sizes, with n = 3.
    assert error <= 3.01 * UNIT_ROUNDING * sum(abs(term) for term in terms)


@given(vector, vector)
def test_the_vector_product_agrees_with_numpy(
    a: tuple[float, float, float], b: tuple[float, float, float]
) -> None:
    got = tuple(Vector3(*a).cross(Vector3(*b)))
    assert got == tuple(numpy.cross(a, b))  # the same operations give the same bits


@given(vector)
def test_the_magnitude_squared_is_exact_to_two_units_in_the_last_place(
    a: tuple[float, float, float],
) -> None:
    got = Fraction(Vector3(*a).magnitude())
    wanted = sum(value * value for value in exact(a))
    # math.hypot is accurate to one unit in the last place, so its square is to two: 4 roundings.
    assert abs(got * got - wanted) <= 4.01 * UNIT_ROUNDING * wanted


@given(vector, vector)
def test_any_basis_is_orthonormal_and_right_handed(
    a: tuple[float, float, float], b: tuple[float, float, float]
) -> None:
    u, v = numpy.array(a), numpy.array(b)
    assume(numpy.any(u) and numpy.any(v))
    u, v = u / numpy.abs(u).max(), v / numpy.abs(v).max()
    sine = numpy.linalg.norm(numpy.cross(u, v)) / numpy.linalg.norm(u) / numpy.linalg.norm(v)
    assume(sine > 1e-6)
    basis = numpy.array([tuple(w) for w in make_orthonormal_basis(Vector3(*a), Vector3(*b))])
    # Normalizing multiplies the rounding of the vector product, 1e-16, by 1 / sine.
    assert numpy.allclose(basis @ basis.T, numpy.eye(3), atol=1e-15 / sine + 1e-15)
    assert numpy.linalg.det(basis) > 0.0


@given(st.floats(0.001, math.pi - 0.001), st.floats(0.0, 2.0 * math.pi))
def test_the_angles_are_those_between_two_directions_in_a_plane(angle: float, start: float) -> None:
    a = Vector3(math.cos(start), math.sin(start), 0.0)
    b = Vector3(math.cos(start + angle), math.sin(start + angle), 0.0)
    # acos and asin multiply a rounding of about 1e-15 by 1 / sin and 1 / cos, but at most to its
    # square root.
    by_cosine = 3e-15 / math.sin(angle)
    by_sine = min(3e-15 / abs(math.cos(angle)), 1e-7)
    assert angle_by_scalar_product(a, b) == pytest.approx(angle, abs=by_cosine)
    wanted = sorted((angle, math.pi - angle))
    assert angles_by_vector_product(a, b) == pytest.approx(wanted, abs=by_sine)


def test_a_vector_with_nan_is_not_equal_to_itself_as_floats_are() -> None:
    v = Vector3(math.nan, 0.0, 0.0)
    assert v != v.copy()
    assert v != v
    assert Vector3(1.0, 2.0, 3.0) == Vector3(1, 2, 3)
    assert Vector3(1.0, 2.0, 3.0) != (1.0, 2.0, 3.0)


@pytest.mark.parametrize(("bad", "error"), [(None, TypeError), ("a", ValueError)])
def test_what_is_no_number_is_no_component(bad: object, error: type[Exception]) -> None:
    with pytest.raises(error):
        Vector3(1.0, bad, 2.0)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "method", ["add_scaled", "component_product", "component_product_update", "dot", "cross"]
)
def test_a_number_in_place_of_a_vector_is_a_type_error_that_names_it(method: str) -> None:
    arguments = (3.0, 1.0) if method == "add_scaled" else (3.0,)
    with pytest.raises(TypeError, match=r"v must be a Vector3, got 3\.0"):
        getattr(Vector3(1.0, 2.0, 3.0), method)(*arguments)
