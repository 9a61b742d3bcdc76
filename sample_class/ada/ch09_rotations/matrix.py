"""Ada's matrices: three rows, each of them a vector."""

from ch02_vectors.vector import Vector3
from ch09_rotations.quaternion import Quaternion

SINGULAR = 1e-13
ROTATION_TOLERANCE = 1e-5


def need(name, value, kind):
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a {kind.__name__}, got {value!r}")
    return value


class Matrix3:
    def __init__(self, *entries):
        if len(entries) != 9:
            raise TypeError(f"Matrix3 takes nine numbers, row by row, got {len(entries)}")
        self.entries = tuple(float(entry) for entry in entries)

    def __repr__(self):
        return f"Matrix3({', '.join(map(repr, self.entries))})"

    def __iter__(self):
        return iter(self.entries)

    def __eq__(self, other):
        return self.entries == other.entries if isinstance(other, Matrix3) else NotImplemented

    def __getitem__(self, place):
        row, column = place
        if row not in range(3) or column not in range(3):
            raise IndexError(f"row and column must be from 0 to 2, got {place!r}")
        return self.entries[3 * row + column]

    def __matmul__(self, other):
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix3) else NotImplemented

    @staticmethod
    def of_rows(a, b, c):
        return Matrix3(*a, *b, *c)

    @property
    def rows(self):
        m = self.entries
        return Vector3(*m[0:3]), Vector3(*m[3:6]), Vector3(*m[6:9])

    @property
    def columns(self):
        m = self.entries
        return Vector3(*m[0::3]), Vector3(*m[1::3]), Vector3(*m[2::3])

    def transform(self, v):
        x, y, z = self.rows
        return Vector3(x.dot(v), y.dot(v), z.dot(v))

    def product(self, m):
        need("m", m, Matrix3)
        columns = m.columns
        return Matrix3(*(row.dot(column) for row in self.rows for column in columns))

    def transpose(self):
        return Matrix3.of_rows(*self.columns)

    def determinant(self):
        a, b, c = self.rows
        return a.dot(b.cross(c))

    def inverse(self):
        a, b, c = self.rows
        volume = self.determinant()
        limit = SINGULAR * a.magnitude() * b.magnitude() * c.magnitude()
        if not abs(volume) > limit:
            raise ValueError(f"no inverse: the determinant {volume} is not above {limit}")
        m = Matrix3.of_rows(b.cross(c) / volume, c.cross(a) / volume, a.cross(b) / volume)
        return m.transpose()

    def is_rotation(self):
        square = self.product(self.transpose())
        one = (1, 0, 0, 0, 1, 0, 0, 0, 1)
        near = all(abs(m - n) <= ROTATION_TOLERANCE for m, n in zip(square, one))
        return near and self.determinant() > 0

    @staticmethod
    def from_quaternion(q):
        need("q", q, Quaternion)
        # the columns are the turned axes
        x, y, z = (q.rotate(Vector3(*e)) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        return Matrix3.of_rows(x, y, z).transpose()

    def to_quaternion(self):
        if not self.is_rotation():
            raise ValueError(f"no rotation: {self!r}")
        a, b, c, d, e, f, g, h, i = self.entries
        # each row: one component, times 4, times all four
        rows = (
            (1 + a + e + i, h - f, c - g, d - b),
            (h - f, 1 + a - e - i, b + d, c + g),
            (c - g, b + d, 1 - a + e - i, f + h),
            (d - b, c + g, f + h, 1 - a - e + i),
        )
        largest = max(range(4), key=lambda n: rows[n][n])
        q = Quaternion(*rows[largest])
        q.normalize()
        return q


class Matrix4:
    def __init__(self, *entries):
        if len(entries) != 12:
            raise TypeError(f"Matrix4 takes twelve numbers, row by row, got {len(entries)}")
        self.entries = tuple(float(entry) for entry in entries)

    def __repr__(self):
        return f"Matrix4({', '.join(map(repr, self.entries))})"

    def __iter__(self):
        return iter(self.entries)

    def __eq__(self, other):
        return self.entries == other.entries if isinstance(other, Matrix4) else NotImplemented

    def __getitem__(self, place):
        row, column = place
        if row not in range(3) or column not in range(4):
            raise IndexError(f"row must be from 0 to 2 and column from 0 to 3, got {place!r}")
        return self.entries[4 * row + column]

    def __matmul__(self, other):
        if isinstance(other, Vector3):
            return self.transform(other)
        return self.product(other) if isinstance(other, Matrix4) else NotImplemented

    @staticmethod
    def of(turn, move):
        a, b, c = turn.rows
        return Matrix4(*a, move.x, *b, move.y, *c, move.z)

    @property
    def turn(self):
        m = self.entries
        return Matrix3(*m[0:3], *m[4:7], *m[8:11])

    @property
    def move(self):
        return Vector3(*self.entries[3::4])

    def transform(self, v):
        return self.turn.transform(v) + self.move

    def product(self, m):
        need("m", m, Matrix4)
        return Matrix4.of(self.turn.product(m.turn), self.transform(m.move))

    def determinant(self):
        return self.turn.determinant()

    def inverse(self):
        back = self.turn.inverse()
        return Matrix4.of(back, -back.transform(self.move))

    @staticmethod
    def from_orientation_and_position(q, p):
        return Matrix4.of(Matrix3.from_quaternion(q), need("p", p, Vector3))

    def transform_inverse(self, v):
        return self.transform_inverse_direction(v - self.move)

    def transform_direction(self, v):
        return self.turn.transform(v)

    def transform_inverse_direction(self, v):
        return self.turn.transpose().transform(v)


def change_basis(m, basis):
    if not isinstance(m, (Matrix3, Matrix4)):
        raise TypeError(f"m must be a matrix, got {m!r}")
    need("basis", basis, type(m))
    return basis @ m @ basis.inverse()
