"""The three-dimensional vector class that the whole engine uses (book chapter 2).

The axes are right-handed, and +Y points up. An operator such as ``v + w`` returns a new vector and
leaves both operands unchanged. A method marked "in place" changes ``v`` itself and returns None.
The operators ``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but their methods must end with
``return self``, because Python assigns the returned value to ``v``. Each method must also work if
the other vector is the vector itself.
"""

from __future__ import annotations

from collections.abc import Iterator


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
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def clear(self) -> None:
        """Set all three components of the vector to zero, in place."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def invert(self) -> None:
        """Reverse the direction, in place (book 2.1)."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def __neg__(self) -> Vector3:
        """Return a new vector of the same length that points in the opposite direction."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def magnitude(self) -> float:
        """Return the length of the vector, |v|, which is NaN if a component is (book 2.1.2).

        It must also be correct for components as large as 1e200 or as small as 1e-200.
        """
        raise NotImplementedError("Exercise B2.2: Length")

    def squared_magnitude(self) -> float:
        """Return the squared length of the vector, |v|^2 (book 2.1.2)."""
        raise NotImplementedError("Exercise B2.2: Length")

    def __mul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, and return a new vector (book 2.1.3).

        Both ``v * scale`` and ``scale * v`` call this method. Raises TypeError if ``scale`` is a
        vector.
        """
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    __rmul__ = __mul__  # for 2 * v: a float does not know vectors, so Python calls this method

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place. A vector is a TypeError."""
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def __truediv__(self, divisor: float) -> Vector3:
        """Divide every component by a number, and return a new vector.

        Raises TypeError if the divisor is a vector, and ZeroDivisionError if it is zero.
        """
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def __itruediv__(self, divisor: float) -> Vector3:
        """Divide every component by a number, in place, with the errors of ``v / divisor``."""
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def normalize(self) -> None:
        """Scale the vector to length 1 in place (book 2.1.2). The zero vector stays zero.

        Like ``magnitude``, it must work for components as large as 1e200 or as small as 1e-200.
        """
        raise NotImplementedError("Exercise B2.4: Normalize")

    def normalized(self) -> Vector3:
        """Return a new vector of length 1 in the same direction, or zero for the zero vector."""
        raise NotImplementedError("Exercise B2.4: Normalize")

    def __add__(self, v: Vector3) -> Vector3:
        """Add two vectors, and return their sum as a new vector (book 2.1.4)."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add ``v`` in place, and return ``self``."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __sub__(self, v: Vector3) -> Vector3:
        """Subtract ``v``, and return the difference as a new vector (book 2.1.4)."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract ``v`` in place, and return ``self``."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add ``v * scale`` to this vector, in place, as in p' = p + v h (book 2.1.4)."""
        raise NotImplementedError("Exercise B2.6: Add a scaled vector")

    def component_product(self, v: Vector3) -> Vector3:
        """Multiply by the matching component of ``v``, and return a new vector (book 2.1.6)."""
        raise NotImplementedError("Exercise B2.7: The component product")

    def component_product_update(self, v: Vector3) -> None:
        """Multiply by the matching component of ``v``, in place (book 2.1.6)."""
        raise NotImplementedError("Exercise B2.7: The component product")

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, with the angle t (book Eq. 2.4)."""
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product, so that ``a @ b`` equals ``a.dot(b)``."""
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b as a new vector (book Eq. 2.6).

        The product is perpendicular to both vectors and has the length |a| |b| sin t, where t is
        the angle between them. Swapping the factors reverses its direction.
        """
        raise NotImplementedError("Exercise B2.9: The vector product")

    def cross_update(self, v: Vector3) -> None:
        """Set this vector to the vector product self x ``v``, in place (book 2.1.8)."""
        raise NotImplementedError("Exercise B2.9: The vector product")


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Build three perpendicular unit vectors that form a right-handed basis (book 2.1.9).

    The first points along ``a``. The second lies in the plane of ``a`` and ``b``, perpendicular to
    ``a`` and on the same side of it as ``b``. The third is the vector product of the first two. The
    lengths of ``a`` and ``b`` do not matter, and all three are new vectors. Raises ValueError if
    one is zero, or if they are parallel: the sine of the angle between them is below 1e-12 (E-46).
    """
    raise NotImplementedError("Exercise B2.10: An orthonormal basis")
