"""Vectors compared with NumPy on 2,000 random cases, and NaN."""

from __future__ import annotations

import math

import numpy

from ch02_vectors.vector import Vector3

ROWS, OTHERS = numpy.random.default_rng(2).normal(size=(2, 2_000, 3))
PAIRS = [(Vector3(*v), Vector3(*w)) for v, w in zip(ROWS, OTHERS, strict=True)]


def test_the_products_and_the_magnitude_agree_with_numpy() -> None:
    assert [tuple(v.cross(w)) for v, w in PAIRS] == [*map(tuple, numpy.cross(ROWS, OTHERS))]
    # A few roundings of numbers up to 20.
    dots = [v.dot(w) for v, w in PAIRS]
    assert numpy.abs(dots - (ROWS * OTHERS).sum(axis=1)).max() <= 1e-14
    lengths = [v.magnitude() for v, _ in PAIRS]
    assert numpy.abs(lengths - numpy.linalg.norm(ROWS, axis=1)).max() <= 1e-14


def test_a_vector_with_nan_is_not_equal_to_itself_as_floats_are() -> None:
    v = Vector3(math.nan, 0.0, 0.0)
    assert v != v.copy()
    assert v != v
    assert Vector3(1.0, 2.0, 3.0) == Vector3(1, 2, 3)
    assert Vector3(1.0, 2.0, 3.0) != (1.0, 2.0, 3.0)
