"""A vector in three dimensions, the type that the whole engine uses (book chapter 2).

The axes are right-handed, and +Y points up. Vectors are mutable. Operators such as ``v + w`` return
a new vector and leave both operands alone. Methods marked "in place" change ``v`` and return None.
``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but their methods end with ``return self``,
because Python assigns what they return to ``v``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

# Directions count as parallel if the sine of the angle between them is below this limit. Rounding
# alone leaves about 1e-16.
_PARALLEL_LIMIT = 1e-12

_WHICH_PRODUCT = "a vector times a vector has three meanings: use dot, cross or component_product"
_NOT_A_VECTOR = "v must be a Vector3, got {!r}"


class Vector3:
    """Three components along X, Y and Z, in the unit of whatever the vector describes.

    A component can be any float, including infinities and NaN. Classes that give the numbers a
    meaning, such as a particle, reject values that make no sense.

    Raises:
        TypeError: if a component is not something that float() accepts.
        ValueError: if a component is a string that does not contain a number.
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
        """Compare component by component, exactly. As with floats, NaN is not equal to itself."""
        if not isinstance(other, Vector3):
            return NotImplemented
        return self.x == other.x and self.y == other.y and self.z == other.z

    def copy(self) -> Vector3:
        """Return a new vector with the same components."""
        return Vector3(self.x, self.y, self.z)

    def clear(self) -> None:
        """Set all three components to zero, in place."""
        self.x = self.y = self.z = 0.0

    def invert(self) -> None:
        """Reverse the vector, in place: change the sign of every component (2.1)."""
        self.x = -self.x
        self.y = -self.y
        self.z = -self.z

    def __neg__(self) -> Vector3:
        """Return a new vector pointing the opposite way."""
        return Vector3(-self.x, -self.y, -self.z)

    def magnitude(self) -> float:
        """Return the length |v|, which is never negative (2.1).

        The result is also correct for components as large as 1e200 and as small as 1e-200, although
        their squares do not fit in a float. If a component is NaN, the length is NaN.
        """
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self) -> float:
        """Return |v|^2, which is enough to compare lengths and needs no square root (2.1)."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    def __mul__(self, scale: float) -> Vector3:
        """Return a new vector, v * scale or scale * v (2.1.3).

        Raises TypeError for vector * vector, which could mean three different products.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        return Vector3(self.x * scale, self.y * scale, self.z * scale)

    __rmul__ = __mul__  # for 2 * v: a float does not know vectors, so Python calls this method

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place, and return self.

        Raises TypeError for a vector.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        self.x *= scale
        self.y *= scale
        self.z *= scale
        return self

    def __truediv__(self, divisor: float) -> Vector3:
        """Return a new vector, v / divisor.

        Raises TypeError for a vector and ZeroDivisionError for zero.
        """
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        return Vector3(self.x / divisor, self.y / divisor, self.z / divisor)

    def __itruediv__(self, divisor: float) -> Vector3:
        """Divide every component by a number, in place, and return self.

        Raises the same errors as v / divisor.
        """
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        self.x, self.y, self.z = self.x / divisor, self.y / divisor, self.z / divisor
        return self

    def normalize(self) -> None:
        """Make the length 1 and keep the direction, in place (2.1.3).

        The zero vector stays zero. The result is also correct for components as large as 1e200 and
        as small as 1e-200.
        """
        length = self.magnitude()
        if length == 0.0:
            return
        self.x /= length
        self.y /= length
        self.z /= length

    def normalized(self) -> Vector3:
        """Return a new vector of length 1 in the same direction.

        The zero vector gives a new zero vector.
        """
        length = self.magnitude()
        if length == 0.0:
            return Vector3()
        return Vector3(self.x / length, self.y / length, self.z / length)

    def __add__(self, v: Vector3) -> Vector3:
        """Return the sum as a new vector (2.1.4). Raises TypeError if v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add v, in place, and return self. Raises TypeError if v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        self.x += v.x
        self.y += v.y
        self.z += v.z
        return self

    def __sub__(self, v: Vector3) -> Vector3:
        """Return the difference as a new vector (2.1.4). Raises TypeError if v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return Vector3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract v, in place, and return self. Raises TypeError if v is not a vector."""
        if not isinstance(v, Vector3):
            return NotImplemented
        self.x -= v.x
        self.y -= v.y
        self.z -= v.z
        return self

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add v * scale, in place (2.1.4).

        The engine uses this method for every update of the form p' = p + v h. It also works if v is
        the vector itself. Raises TypeError if v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def component_product(self, v: Vector3) -> Vector3:
        """Return a new vector with the products of matching components (2.1.6).

        Raises TypeError if v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        return Vector3(self.x * v.x, self.y * v.y, self.z * v.z)

    def component_product_update(self, v: Vector3) -> None:
        """Multiply each component by the matching one of v, in place (2.1.6).

        Raises TypeError if v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        self.x *= v.x
        self.y *= v.y
        self.z *= v.z

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, also written a @ b (Eq. 2.4).

        Raises TypeError if v is not a vector.
        """
        if not isinstance(v, Vector3):
            raise TypeError(_NOT_A_VECTOR.format(v))
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product, as ``dot`` does."""
        if not isinstance(v, Vector3):
            return NotImplemented
        return self.dot(v)

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b as a new vector (Eq. 2.6).

        The product is perpendicular to both vectors and has the length |a| |b| sin t. Swapping the
        factors reverses its direction: b x a = -(a x b). Raises TypeError if v is not a vector.
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

        Raises TypeError if v is not a vector.
        """
        self.x, self.y, self.z = self.cross(v)


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Return three new unit vectors that are perpendicular and right-handed: a x b = c (2.1.9).

    The first vector has the direction of ``a``. The third one is perpendicular to the plane of
    ``a`` and ``b``. The second one lies in that plane, as close to ``b`` as possible. The lengths
    of ``a`` and ``b`` do not matter, and neither vector changes.

    Raises:
        ValueError: if ``a`` or ``b`` is zero or not finite, or if they are parallel, which means
            that the sine of their angle is below 1e-12. Such vectors do not determine a basis.
    """
    first = a.normalized()
    third = first.cross(b.normalized())
    if not third.magnitude() > _PARALLEL_LIMIT:  # "not >" refuses NaN too
        raise ValueError(f"a and b must not be parallel, zero or non-finite, got {a!r} and {b!r}")
    third.normalize()
    return first, third.cross(first), third
