"""Where the printed book is wrong and the difference can run: the printed form, shown failing.

Each test has the number of the erratum in errata.md in its name.
"""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3


def test_e14_the_printed_invert_sets_x_twice() -> None:
    printed = Vector3(1.0, 2.0, 3.0)
    printed.x = -printed.x
    printed.y = -printed.y
    printed.x = -printed.z
    right = Vector3(1.0, 2.0, 3.0)
    right.invert()
    assert tuple(printed) == (-3.0, -2.0, 3.0)
    assert tuple(right) == (-1.0, -2.0, -3.0)


def test_e15_the_printed_length_of_a_vector_product_wants_unit_vectors() -> None:
    a, b = Vector3(1.0, 0.0, 0.0), Vector3(4.0, 3.0, 0.0)  # |a| = 1, |b| = 5, a . b = 4
    assert a.cross(b).magnitude() == 3.0
    with pytest.raises(ValueError, match=r"math domain|nonnegative"):
        math.sqrt(1.0 - a.dot(b) ** 2)  # printed: right for two unit vectors only
    assert math.sqrt(b.squared_magnitude() - a.dot(b) ** 2) == 3.0  # right for a unit vector a


def test_e15_the_printed_form_holds_for_unit_vectors() -> None:
    a, b = Vector3(1.0, 0.0, 0.0), Vector3(0.8, 0.6, 0.0)
    printed = math.sqrt(1.0 - a.dot(b) ** 2)
    assert printed == pytest.approx(a.cross(b).magnitude(), rel=1e-15)  # one rounding
