"""The three-dimensional vector class that the whole engine uses (book chapter 2).

The axes are right-handed, and +Y points up. Vectors are mutable, so it matters which operations
change a vector and which create a new one. An operator such as ``v + w`` returns a new vector and
leaves both operands unchanged. A method marked "in place" changes ``v`` itself and returns None.
The operators ``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but their methods must end with
``return self``, because Python assigns the returned value to ``v``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

# Directions count as parallel if the sine of the angle between them is below this limit. Rounding
# alone leaves about 1e-16.
_PARALLEL_LIMIT = 1e-12

_WHICH_PRODUCT = "a vector times a vector has three meanings: use dot, cross or component_product"


class Vector3:
    """A vector with three components along X, Y and Z.

    The unit depends on the quantity: m for a position, m/s for a velocity, N for a force. A
    component can be any float, including infinities and NaN. A class that uses a vector for a
    particular quantity, such as a particle for its position, rejects the values that make no sense
    for that quantity.

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
        """Check whether both vectors have exactly the same components. NaN is unequal to itself."""
        if not isinstance(other, Vector3):
            return NotImplemented
        return self.x == other.x and self.y == other.y and self.z == other.z

    def copy(self) -> Vector3:
        """Return a new vector with the same components.

        If you still need the current value of a vector, copy it before you change it in place.
        """
        return Vector3(self.x, self.y, self.z)

    def clear(self) -> None:
        """Set all three components of the vector to zero, in place."""
        self.x = self.y = self.z = 0.0

    def invert(self) -> None:
        """Reverse the direction, in place, by changing the sign of every component (book 2.1)."""
        self.x = -self.x
        self.y = -self.y
        self.z = -self.z

    def __neg__(self) -> Vector3:
        """Return a new vector of the same length that points in the opposite direction."""
        return Vector3(-self.x, -self.y, -self.z)

    def magnitude(self) -> float:
        """Return the length of the vector, |v|, which is never negative.

        The length must also be correct for components as large as 1e200 or as small as 1e-200,
        although the squares of such numbers overflow or underflow. If a component is NaN, and
        none is infinite, the length and the squared length are NaN. Book 2.1.2.
        """
        return math.hypot(self.x, self.y, self.z)

    def squared_magnitude(self) -> float:
        """Return the squared length of the vector, |v|^2.

        To find the longer of two vectors, compare their squared lengths. That saves two square
        roots. Book 2.1.2.
        """
        return self.x * self.x + self.y * self.y + self.z * self.z

    def __mul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, and return a new vector.

        Both ``v * scale`` and ``scale * v`` call this method. Raises TypeError if ``scale`` is a
        vector, because vectors have three different products. Book 2.1.3.
        """
        if isinstance(scale, Vector3):
            raise TypeError(_WHICH_PRODUCT)
        return Vector3(self.x * scale, self.y * scale, self.z * scale)

    __rmul__ = __mul__  # for 2 * v: a float does not know vectors, so Python calls this method

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place, and return ``self``.

        Raises TypeError if ``scale`` is a vector.
        """
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
        """Divide every component by a number, in place, and return ``self``.

        Raises TypeError if the divisor is a vector, and ZeroDivisionError if it is zero.
        """
        if isinstance(divisor, Vector3):
            raise TypeError("a vector cannot be divided by a vector")
        self.x, self.y, self.z = self.x / divisor, self.y / divisor, self.z / divisor
        return self

    def normalize(self) -> None:
        """Scale the vector to length 1 without changing its direction, in place.

        The zero vector has no direction, so it stays zero. Like ``magnitude``, this method must
        also work for components as large as 1e200 or as small as 1e-200. Book 2.1.2.
        """
        length = self.magnitude()
        if length == 0.0:
            return
        self.x /= length
        self.y /= length
        self.z /= length

    def normalized(self) -> Vector3:
        """Return a new vector of length 1 that points in the same direction.

        For the zero vector, which has no direction, return a new zero vector.
        """
        length = self.magnitude()
        if length == 0.0:
            return Vector3()
        return Vector3(self.x / length, self.y / length, self.z / length)

    def __add__(self, v: Vector3) -> Vector3:
        """Add two vectors, and return their sum as a new vector (book 2.1.4)."""
        return Vector3(self.x + v.x, self.y + v.y, self.z + v.z)

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add ``v`` in place, and return ``self``.

        This must also work if ``v`` is the vector itself.
        """
        self.x += v.x
        self.y += v.y
        self.z += v.z
        return self

    def __sub__(self, v: Vector3) -> Vector3:
        """Subtract ``v`` from this vector, and return the difference as a new vector.

        Book 2.1.4.
        """
        return Vector3(self.x - v.x, self.y - v.y, self.z - v.z)

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract ``v`` in place, and return ``self``.

        This must also work if ``v`` is the vector itself.
        """
        self.x -= v.x
        self.y -= v.y
        self.z -= v.z
        return self

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add a multiple of another vector, ``v * scale``, to this one, in place.

        Use this method to update a vector, for example a position by p' = p + v h. It is faster
        than ``p += v * h``, because it creates no temporary vector. It must also work if
        ``v`` is the vector itself. Book 2.1.4.
        """
        self.x += v.x * scale
        self.y += v.y * scale
        self.z += v.z * scale

    def component_product(self, v: Vector3) -> Vector3:
        """Multiply each component by the matching component of ``v``, and return a new vector.

        Neither of the two vectors changes. Book 2.1.6.
        """
        return Vector3(self.x * v.x, self.y * v.y, self.z * v.z)

    def component_product_update(self, v: Vector3) -> None:
        """Multiply each component by the matching component of ``v``, in place (book 2.1.6).

        This must also work if ``v`` is the vector itself.
        """
        self.x *= v.x
        self.y *= v.y
        self.z *= v.z

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, where t is the angle between a and b.

        You can also write ``a @ b``. If one of the vectors is a unit vector, the result is the
        component of the other vector along it. Book Eq. 2.4.
        """
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product of two vectors, so that ``a @ b`` equals ``a.dot(b)``."""
        return self.dot(v)

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b as a new vector.

        The product is perpendicular to both vectors and has the length |a| |b| sin t, where t is
        the angle between them. Swapping the factors reverses its direction: b x a = -(a x b).
        Book Eq. 2.6.
        """
        return Vector3(
            self.y * v.z - self.z * v.y,
            self.z * v.x - self.x * v.z,
            self.x * v.y - self.y * v.x,
        )

    def cross_update(self, v: Vector3) -> None:
        """Set this vector to the vector product self x ``v``, in place (book 2.1.8).

        This must also work if ``v`` is the vector itself. The product is then zero.
        """
        self.x, self.y, self.z = self.cross(v)


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Build three perpendicular unit vectors that form a right-handed basis.

    Use it to build the axes of a camera or a contact when you know one direction exactly and a
    second one only roughly. The first vector of the basis points along ``a``. The second one lies
    in the plane of ``a`` and ``b``, perpendicular to ``a`` and on the same side of it as ``b``. The
    third one is the vector product of the first two, which makes the basis right-handed. All three
    are new vectors. Only the directions of ``a`` and ``b`` matter, not their lengths.

    Raises:
        ValueError: if ``a`` or ``b`` is zero, or if they are parallel, because such vectors do not
            determine a basis. They count as parallel if the sine of the angle between them is below
            1e-12.

    Book 2.1.9. Its listing refuses only vectors whose product is exactly zero (erratum E-46).
    """
    first = a.normalized()
    third = first.cross(b.normalized())
    if not third.magnitude() > _PARALLEL_LIMIT:  # "not >" refuses NaN too
        raise ValueError(f"a and b must not be parallel, zero or non-finite, got {a!r} and {b!r}")
    third.normalize()
    return first, third.cross(first), third
