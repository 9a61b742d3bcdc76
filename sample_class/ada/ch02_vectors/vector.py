"""A second right solution of the chapter's vector, in another style than the first.

The components are kept in a private tuple, which vectors can share without harm. The forms that
return a new vector do the work; the forms in place take over their result.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable, Iterator
from operator import add, eq, mul, neg, sub

_PARALLEL_SINE = 1e-12
_ORIGIN = (0.0, 0.0, 0.0)


class Vector3:
    """Three floats along X, Y and Z. Raises TypeError where a component is not a number."""

    __slots__ = ("_xyz",)

    _xyz: tuple[float, ...]

    def __init__(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> None:
        self._xyz = _floats(x, y, z)

    @property
    def x(self) -> float:
        """The first component."""
        return self._xyz[0]

    @x.setter
    def x(self, value: float) -> None:
        self._xyz = _floats(value, self.y, self.z)

    @property
    def y(self) -> float:
        """The second component."""
        return self._xyz[1]

    @y.setter
    def y(self, value: float) -> None:
        self._xyz = _floats(self.x, value, self.z)

    @property
    def z(self) -> float:
        """The third component."""
        return self._xyz[2]

    @z.setter
    def z(self, value: float) -> None:
        self._xyz = _floats(self.x, self.y, value)

    def __repr__(self) -> str:
        return f"Vector3({', '.join(map(repr, self))})"

    def __iter__(self) -> Iterator[float]:
        return iter(self._xyz)

    def __eq__(self, other: object) -> bool:
        return all(map(eq, self, other)) if isinstance(other, Vector3) else NotImplemented

    def copy(self) -> Vector3:
        return _of(self._xyz)

    def clear(self) -> None:
        self._become(Vector3())

    def invert(self) -> None:
        self._become(-self)

    def __neg__(self) -> Vector3:
        return _of(map(neg, self._xyz))

    def magnitude(self) -> float:
        return math.dist(self._xyz, _ORIGIN)

    def squared_magnitude(self) -> float:
        return self.dot(self)

    def __mul__(self, scale: float) -> Vector3:
        _refuse_vector(scale)
        x, y, z = self._xyz
        return _of((x * scale, y * scale, z * scale))

    __rmul__ = __mul__

    def __imul__(self, scale: float) -> Vector3:
        return self._become(self * scale)

    def __truediv__(self, divisor: float) -> Vector3:
        _refuse_vector(divisor)
        x, y, z = self._xyz
        return _of((x / divisor, y / divisor, z / divisor))

    def __itruediv__(self, divisor: float) -> Vector3:
        return self._become(self / divisor)

    def normalize(self) -> None:
        self._become(self.normalized())

    def normalized(self) -> Vector3:
        return self / (self.magnitude() or 1.0)

    def __add__(self, v: Vector3) -> Vector3:
        return _of(map(add, self._xyz, _require_vector(v)._xyz))

    def __iadd__(self, v: Vector3) -> Vector3:
        return self._become(self + v)

    def __sub__(self, v: Vector3) -> Vector3:
        return _of(map(sub, self._xyz, _require_vector(v)._xyz))

    def __isub__(self, v: Vector3) -> Vector3:
        return self._become(self - v)

    def add_scaled(self, v: Vector3, scale: float) -> None:
        self._become(self + _require_vector(v) * scale)

    def component_product(self, v: Vector3) -> Vector3:
        return _of(map(mul, self._xyz, _require_vector(v)._xyz))

    def component_product_update(self, v: Vector3) -> None:
        self._become(self.component_product(v))

    def dot(self, v: Vector3) -> float:
        x, y, z = map(mul, self._xyz, _require_vector(v)._xyz)
        return z + y + x

    def __matmul__(self, v: Vector3) -> float:
        return self.dot(v)

    def cross(self, v: Vector3) -> Vector3:
        a, b = self._xyz, _require_vector(v)._xyz
        return _of(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))

    def cross_update(self, v: Vector3) -> None:
        self._become(self.cross(v))

    def _become(self, v: Vector3) -> Vector3:
        """Take over the components of v; return this vector, as the forms in place have to."""
        self._xyz = v._xyz
        return self


def make_orthonormal_basis(a: Vector3, b: Vector3) -> tuple[Vector3, Vector3, Vector3]:
    first = a.normalized()
    normal = first.cross(b.normalized())
    if not normal.magnitude() >= _PARALLEL_SINE:  # true of NaN too
        raise ValueError(f"no basis: {a} and {b} are parallel, zero or not finite")
    second = normal.cross(first).normalized()
    return first, second, first.cross(second)


def _floats(*numbers: float) -> tuple[float, ...]:
    """Return the numbers as floats. An array, unlike float, refuses text, with a TypeError."""
    return tuple(array("d", numbers))


def _of(components: Iterable[float]) -> Vector3:
    """Return the vector with components that are known to be three floats."""
    made = object.__new__(Vector3)
    made._xyz = tuple(components)
    return made


def _require_vector(v: object) -> Vector3:
    """Return v; raise TypeError where it is not a vector."""
    if isinstance(v, Vector3):
        return v
    raise TypeError(f"a Vector3 is needed, not {type(v).__name__}")


def _refuse_vector(number: object) -> None:
    """Raise TypeError where a vector stands in the place of a number."""
    if isinstance(number, Vector3):
        raise TypeError("a number is needed; vectors have dot, cross and component_product")
