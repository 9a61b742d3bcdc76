"""The three-dimensional vector class that the whole engine uses (book chapter 2).

The axes are right-handed, and +Y points up. An operator such as ``v + w`` returns a new vector and
leaves both operands unchanged. A method marked "in place" changes ``v`` itself and returns None.
The operators ``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but their methods must end with
``return self``, because Python assigns the returned value to ``v``. Each method must also work if
the other vector is the vector itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

# Directions count as parallel if the sine of the angle between them is below this limit. Rounding
# alone leaves about 1e-16.
_PARALLEL_LIMIT = 1e-12

_WHICH_PRODUCT = "a vector times a vector has three meanings: use dot, cross or component_product"


class Vector3:
    """A vector with three components along X, Y and Z, which can be any float."""

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
        """Check whether both vectors have exactly the same components."""
        if not isinstance(other, Vector3):
            return NotImplemented
        return self.x == other.x and self.y == other.y and self.z == other.z

    def copy(self) -> Vector3:
        """Return a new vector with the same components."""
        return Vector3(self.x, self.y, self.z)

    def clear(self) -> None:
        """Set all three components of the vector to zero, in place."""
        self.x = self.y = self.z = 0.0

    def invert(self) -> None:
        """Reverse the direction, in place (book 2.1)."""
        self.x = -self.x
        self.y = -self.y
        self.z = -self.z

    def __neg__(self) -> Vector3:
        """Return a new vector of the same length that points in the opposite direction."""
        return Vector3(-self.x, -self.y, -self.z)

    def magnitude(self) -> float:
        """Return the length of the vector, |v|, which is NaN if a component is (book 2.1.2).

        It must also be correct for components as large as 1e200 or as small as 1e-200.
        """
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self) -> float:
        """Return the squared length of the vector, |v|^2 (book 2.1.2)."""
        return self.x * self.x + self.y * self.y + self.z * self.z

    def __mul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, and return a new vector (book 2.1.3).

        Both ``v * scale`` and ``scale * v`` call this method. Raises TypeError if ``scale`` is a
        vector.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        return Vector3(self.x * scale, self.y * scale, self.z * scale)

    __rmul__ = __mul__  # for 2 * v: a float does not know vectors, so Python calls this method

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place. A vector is a TypeError."""
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        self.x *= scale
        self.y *= scale
        self.z *= scale
        return self

    def __truediv__(self, divisor: float) -> Vector3:
        """Divide every component by a number, and return a new vector.

        Raises TypeError if the divisor is a vector, and ZeroDivisionError if it is zero.
        """
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        return Vector3(self.x / divisor, self.y / divisor, self.z / divisor)

    def __itruediv__(self, divisor: float) -> Vector3:
        """Divide every component by a number, in place, with the errors of ``v / divisor``."""
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        self.x, self.y, self.z = self.x / divisor, self.y / divisor, self.z / divisor
        return self

    def normalize(self) -> None:
        """Scale the vector to length 1 in place (book 2.1.2). The zero vector stays zero.

        Like ``magnitude``, it must work for components as large as 1e200 or as small as 1e-200.
        """
        length = self.magnitude()
        if length == 0.0:
            return
        self.x /= length
        self.y /= length
        self.z /= length

    def normalized(self) -> Vector3:
        """Return a new vector of length 1 in the same direction, or zero for the zero vector."""
        length = self.magnitude()
        if length == 0.0:
            return Vector3()
        return Vector3(self.x / length, self.y / length, self.z / length)

    def __add__(self, v: Vector3) -> Vector3:
        """Add two vectors, and return their sum as a new vector (book 2.1.4)."""
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add ``v`` in place, and return ``self``."""
        self.x += v.x
        self.y += v.y
        self.z += v.z
        return self

    def __sub__(self, v: Vector3) -> Vector3:
        """Subtract ``v``, and return the difference as a new vector (book 2.1.4)."""
        return Vector3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract ``v`` in place, and return ``self``."""
        self.x -= v.x
        self.y -= v.y
        self.z -= v.z
        return self

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add ``v * scale`` to this vector, in place, as in p' = p + v h (book 2.1.4)."""
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def component_product(self, v: Vector3) -> Vector3:
        """Multiply by the matching component of ``v``, and return a new vector (book 2.1.6)."""
        return Vector3(self.x * v.x, self.y * v.y, self.z * v.z)

    def component_product_update(self, v: Vector3) -> None:
        """Multiply by the matching component of ``v``, in place (book 2.1.6)."""
        self.x *= v.x
        self.y *= v.y
        self.z *= v.z

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, with the angle t (book Eq. 2.4)."""
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product, so that ``a @ b`` equals ``a.dot(b)``."""
        return self.dot(v)

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b as a new vector (book Eq. 2.6).

        The product is perpendicular to both vectors and has the length |a| |b| sin t, where t is
        the angle between them. Swapping the factors reverses its direction.
        """
        return Vector3(
            self.y * v.z - self.z * v.y,
            self.z * v.x - self.x * v.z,
            self.x * v.y - self.y * v.x,
        )

    def cross_update(self, v: Vector3) -> None:
        """Set this vector to the vector product self x ``v``, in place (book 2.1.8)."""
        self.x, self.y, self.z = self.cross(v)


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Build three perpendicular unit vectors that form a right-handed basis (book 2.1.9).

    The first points along ``a``. The second lies in the plane of ``a`` and ``b``, perpendicular to
    ``a`` and on the same side of it as ``b``. The third is the vector product of the first two. The
    lengths of ``a`` and ``b`` do not matter, and all three are new vectors. Raises ValueError if
    one is zero, or if they are parallel: the sine of the angle between them is below 1e-12 (E-46).
    """
    first = a.normalized()
    third = first.cross(b.normalized())
    if not third.magnitude() > _PARALLEL_LIMIT:  # "not >" refuses NaN too
        raise ValueError(f"a and b must not be parallel, zero or non-finite, got {a!r} and {b!r}")
    third.normalize()
    return first, third.cross(first), third
