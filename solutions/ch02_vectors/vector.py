"""A vector in three dimensions, the type that the whole engine is written in (book chapter 2).

Axes are right-handed with +Y up. A vector is mutable: operators such as ``v + w`` return a new
vector and leave both as they were; the methods marked "in place" change ``v`` and return None.
Those of ``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but end with ``return self``: what they
return becomes the new ``v``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

# The sine of the angle between two directions below which they count as parallel. Rounding alone
# leaves about 1e-16.
_PARALLEL_LIMIT = 1e-12

_WHICH_PRODUCT = "a vector times a vector has three meanings: use dot, cross or component_product"
_NOT_A_VECTOR = "v must be a Vector3, not {!r}"


class Vector3:
    """Three components along X, Y and Z, in whatever unit the vector stands for.

    Any float will do, infinities and NaN among them: a vector is only numbers. What gives the
    numbers a meaning, such as a particle, refuses the ones that have none.

    Components are what float() takes, and raise what it raises: TypeError for what is no number,
    ValueError for text that does not name one.
    """

    __slots__ = ("x", "y", "z")

    x: float
    y: float
    z: float

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        self.x = float(x)
        self.y = float(y)
        self.z = float(z)

    def __repr__(self) -> str:
        return f"Vector3({self.x!r}, {self.y!r}, {self.z!r})"

    def __iter__(self) -> Iterator[float]:
        yield self.x
        yield self.y
        yield self.z

    def __eq__(self, other: object) -> bool:
        """Exact, component by component, as floats compare: NaN differs from itself."""
        if not isinstance(other, Vector3):
            return NotImplemented
        return self.x == other.x and self.y == other.y and self.z == other.z

    def copy(self) -> Vector3:
        """Return a new vector with the same components."""
        return Vector3(self.x, self.y, self.z)

    def clear(self) -> None:
        """Set every component to zero, in place."""
        self.x = self.y = self.z = 0.0

    def invert(self) -> None:
        """Turn the vector round, in place: every component changes its sign (2.1)."""
        self.x = -self.x
        self.y = -self.y
        self.z = -self.z

    def __neg__(self) -> Vector3:
        """Return the vector turned round, as new."""
        return Vector3(-self.x, -self.y, -self.z)

    def magnitude(self) -> float:
        """Return the length |v|, never negative (2.1).

        Right for components as large as 1e200 and as small as 1e-200 too, though their squares
        do not fit in a float.
        """
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self) -> float:
        """Return |v|^2, which needs no square root: enough to compare lengths (2.1)."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    def __mul__(self, scale: float) -> Vector3:
        """Return v * scale or scale * v, as new (2.1.3).

        Raises TypeError for vector * vector, which could mean three different products.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        return Vector3(self.x * scale, self.y * scale, self.z * scale)

    __rmul__ = __mul__  # for 2 * v: a number knows no vectors, so Python asks v

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place; return self.

        Raises TypeError for a vector.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        self.x *= scale
        self.y *= scale
        self.z *= scale
        return self

    def __truediv__(self, divisor: float) -> Vector3:
        """Return v / divisor, as new. Raises TypeError for a vector, ZeroDivisionError for 0."""
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        return Vector3(self.x / divisor, self.y / divisor, self.z / divisor)

    def __itruediv__(self, divisor: float) -> Vector3:
        """Divide every component, in place; return self. Raises what v / divisor raises."""
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        self.x, self.y, self.z = self.x / divisor, self.y / divisor, self.z / divisor
        return self

    def normalize(self) -> None:
        """Keep the direction and make the length 1, in place (2.1.3).

        Zero stays zero. Right for components as large as 1e200 and as small as 1e-200 too.
        """
        length = self.magnitude()
        if length == 0.0:
            return
        self.x /= length
        self.y /= length
        self.z /= length

    def normalized(self) -> Vector3:
        """Return the vector of length 1 in the same direction, as new. Zero gives zero."""
        length = self.magnitude()
        if length == 0.0:
            return Vector3()
        return Vector3(self.x / length, self.y / length, self.z / length)

    def __add__(self, v: Vector3) -> Vector3:
        """Return the sum, as new (2.1.4). Raises TypeError where v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add v, in place; return self. Raises TypeError where v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        self.x += v.x
        self.y += v.y
        self.z += v.z
        return self

    def __sub__(self, v: Vector3) -> Vector3:
        """Return the difference, as new (2.1.4). Raises TypeError where v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return Vector3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract v, in place; return self. Raises TypeError where v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        self.x -= v.x
        self.y -= v.y
        self.z -= v.z
        return self

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add v * scale, in place: the step of every update p' = p + v h (2.1.4).

        Right when v is this very vector too. Raises TypeError where v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def component_product(self, v: Vector3) -> Vector3:
        """Return the product taken component by component, as new (2.1.6).

        Raises TypeError where v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        return Vector3(self.x * v.x, self.y * v.y, self.z * v.z)

    def component_product_update(self, v: Vector3) -> None:
        """Multiply component by component, in place (2.1.6).

        Raises TypeError where v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        self.x *= v.x
        self.y *= v.y
        self.z *= v.z

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, also written a @ b (Eq. 2.4).

        Raises TypeError where v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product, as dot does."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return self.dot(v)

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b, as new (Eq. 2.6).

        It is at right angles to both, |a| |b| sin t long, and b x a = -(a x b).
        Raises TypeError where v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        return Vector3(
            self.y * v.z - self.z * v.y,
            self.z * v.x - self.x * v.z,
            self.x * v.y - self.y * v.x,
        )

    def cross_update(self, v: Vector3) -> None:
        """Replace this vector by its vector product with v, in place (2.1.8).

        Raises TypeError where v is not a vector.
        """
        self.x, self.y, self.z = self.cross(v)


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Return three new unit vectors at right angles, right-handed: a x b = c (2.1.9).

    The first keeps the direction of ``a``. The third is at right angles to the plane of ``a`` and
    ``b``, and the second lies in that plane, as near to ``b`` as it can. ``a`` and ``b`` stay as
    they were, and their lengths do not matter.

    Raises ValueError where ``a`` and ``b`` are parallel (the sine of their angle below 1e-12), zero
    or not finite: no plane, so no basis.
    """
    first = a.normalized()
    third = first.cross(b.normalized())
    if not third.magnitude() > _PARALLEL_LIMIT:  # "not >" refuses NaN too
        raise ValueError(f"a and b must not be parallel, zero or non-finite: got {a!r} and {b!r}")
    third.normalize()
    return first, third.cross(first), third
