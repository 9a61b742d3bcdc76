"""A vector in three dimensions, the type that the whole engine is written in (book chapter 2).

Axes are right-handed with +Y up. A vector is mutable: operators such as ``v + w`` return a new
vector and leave both as they were; the methods marked "in place" change ``v`` and return None.
Those of ``+=``, ``-=``, ``*=`` and ``/=`` change ``v`` too, but end with ``return self``: what they
return becomes the new ``v``.
"""

from __future__ import annotations

from collections.abc import Iterator


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
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def clear(self) -> None:
        """Set every component to zero, in place."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def invert(self) -> None:
        """Turn the vector round, in place: every component changes its sign (2.1)."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def __neg__(self) -> Vector3:
        """Return the vector turned round, as new."""
        raise NotImplementedError("Exercise B2.1: Copy, clear and invert")

    def magnitude(self) -> float:
        """Return the length |v|, never negative (2.1).

        Right for components as large as 1e200 and as small as 1e-200 too, though their squares
        do not fit in a float.
        """
        raise NotImplementedError("Exercise B2.2: Length")

    def squared_magnitude(self) -> float:
        """Return |v|^2, which needs no square root: enough to compare lengths (2.1)."""
        raise NotImplementedError("Exercise B2.2: Length")

    def __mul__(self, scale: float) -> Vector3:
        """Return v * scale or scale * v, as new (2.1.3).

        Raises TypeError for vector * vector, which could mean three different products.
        """
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    __rmul__ = __mul__  # for 2 * v: a number knows no vectors, so Python asks v

    def __imul__(self, scale: float) -> Vector3:
        """Multiply every component by a number, in place; return self.

        Raises TypeError for a vector.
        """
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def __truediv__(self, divisor: float) -> Vector3:
        """Return v / divisor, as new. Raises TypeError for a vector, ZeroDivisionError for 0."""
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def __itruediv__(self, divisor: float) -> Vector3:
        """Divide every component, in place; return self. Raises what v / divisor raises."""
        raise NotImplementedError("Exercise B2.3: Multiply and divide by a number")

    def normalize(self) -> None:
        """Keep the direction and make the length 1, in place (2.1.3).

        Zero stays zero. Right for components as large as 1e200 and as small as 1e-200 too.
        """
        raise NotImplementedError("Exercise B2.4: Normalise")

    def normalized(self) -> Vector3:
        """Return the vector of length 1 in the same direction, as new. Zero gives zero."""
        raise NotImplementedError("Exercise B2.4: Normalise")

    def __add__(self, v: Vector3) -> Vector3:
        """Return the sum, as new (2.1.4). Raises TypeError where v is not a vector."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __iadd__(self, v: Vector3) -> Vector3:
        """Add v, in place; return self. Raises TypeError where v is not a vector."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __sub__(self, v: Vector3) -> Vector3:
        """Return the difference, as new (2.1.4). Raises TypeError where v is not a vector."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def __isub__(self, v: Vector3) -> Vector3:
        """Subtract v, in place; return self. Raises TypeError where v is not a vector."""
        raise NotImplementedError("Exercise B2.5: Add and subtract")

    def add_scaled(self, v: Vector3, scale: float) -> None:
        """Add v * scale, in place: the step of every update p' = p + v h (2.1.4).

        Right when v is this very vector too. Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.6: Add a scaled vector")

    def component_product(self, v: Vector3) -> Vector3:
        """Return the product taken component by component, as new (2.1.6).

        Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.7: The component product")

    def component_product_update(self, v: Vector3) -> None:
        """Multiply component by component, in place (2.1.6).

        Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.7: The component product")

    def dot(self, v: Vector3) -> float:
        """Return the scalar product a . b = |a| |b| cos t, also written a @ b (Eq. 2.4).

        Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def __matmul__(self, v: Vector3) -> float:
        """Return the scalar product, as dot does."""
        raise NotImplementedError("Exercise B2.8: The scalar product")

    def cross(self, v: Vector3) -> Vector3:
        """Return the vector product a x b, as new (Eq. 2.6).

        It is at right angles to both, |a| |b| sin t long, and b x a = -(a x b).
        Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.9: The vector product")

    def cross_update(self, v: Vector3) -> None:
        """Replace this vector by its vector product with v, in place (2.1.8).

        Raises TypeError where v is not a vector.
        """
        raise NotImplementedError("Exercise B2.9: The vector product")


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    """Return three new unit vectors at right angles, right-handed: a x b = c (2.1.9).

    The first keeps the direction of ``a``. The third is at right angles to the plane of ``a`` and
    ``b``, and the second lies in that plane, as near to ``b`` as it can. ``a`` and ``b`` stay as
    they were, and their lengths do not matter.

    Raises ValueError where ``a`` and ``b`` are parallel (the sine of their angle below 1e-12), zero
    or not finite: no plane, so no basis.
    """
    raise NotImplementedError("Exercise B2.10: An orthonormal basis")
