"""Ada's exercises for chapter 9."""

from ch02_vectors.arguments import finite, positive, whole
from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix4, need
from ch09_rotations.plane import angle_to_vector, center_of_mass
from ch09_rotations.quaternion import Quaternion

OVER = 1e-9  # what is nearer to the edge than that is over it


def two_other_turns():
    # With a book: X ends at -Z, Y at X, Z at -Y.
    return -90, 90


def back_to_reference(orientation):
    need("orientation", orientation, Quaternion)
    return orientation.conjugate().to_axis_angle()


def product_without_j_and_k(a, b):
    need("a", a, Quaternion)
    need("b", b, Quaternion)
    if any((a.j, a.k, b.j, b.k)):
        raise ValueError(f"j and k must be zero, got {a!r} and {b!r}")
    return Quaternion(a.r * b.r - a.i * b.i, a.r * b.i + a.i * b.r, 0, 0)


def turned_by_sense(orientation, rate, duration):
    finite("rate", rate)
    positive("duration", duration)
    return Quaternion.from_axis_angle(Vector3(1, 0, 0), rate * duration) * orientation


def turned_by_steps(orientation, rate, duration, steps=1):
    whole("steps", steps)
    wanted = turned_by_sense(orientation, rate, duration)
    q = orientation.copy()
    for _ in range(steps):
        q.add_scaled(Vector3(rate, 0, 0), duration / steps)
    q.normalize()
    return q, (wanted * q.conjugate()).to_axis_angle()[1]


def read_off(matrix):
    turn = need("matrix", matrix, Matrix4).turn
    if not turn.is_rotation():
        raise ValueError("no rotation")
    return turn, matrix.move


def easy_inverse(matrix):
    need("matrix", matrix, Matrix4)
    back = matrix.turn.transpose()
    return Matrix4.of(back, -back.transform(matrix.move))


def center_of_stones(stones):
    return center_of_mass([s[1] for s in stones], [s[2:] for s in stones])


def side(x, y, angle):
    """How far to the left of a line through the corner a point is."""
    c, s = angle_to_vector(angle)
    return c * y - s * x


def balance_offset(stones, angle):
    return side(*center_of_stones(stones), angle)


def masses_beside(stones, angle):
    edge = balance_offset(stones, angle)
    left = sum(m for _, m, x, y in stones if side(x, y, angle) > edge + OVER)
    right = sum(m for _, m, x, y in stones if side(x, y, angle) < edge - OVER)
    return left, right
