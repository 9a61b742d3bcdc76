"""Ada's plane: angles, directions, points, and the centre of mass."""

import math

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle):
    # remainder takes off whole turns without a loop
    rest = math.remainder(finite("angle", angle), math.tau)
    return math.pi if rest == -math.pi else rest


def angle_to_vector(angle):
    finite("angle", angle)
    return math.cos(angle), math.sin(angle)


def finite_point(name, point):
    x, y = point
    return finite(name, x), finite(name, y)


def rotate_point(point, angle, origin):
    c, s = angle_to_vector(angle)
    (x, y), (across, up) = finite_point("point", point), finite_point("origin", origin)
    return c * x - s * y + across, s * x + c * y + up


def center_of_mass(masses, positions):
    if len(masses) != len(positions) or len(masses) == 0:
        raise ValueError(f"{len(masses)} masses and {len(positions)} positions")
    masses = [positive("mass", mass) for mass in masses]
    positions = [finite_point("position", position) for position in positions]
    total = sum(masses)
    x = sum(m * p[0] for m, p in zip(masses, positions)) / total
    y = sum(m * p[1] for m, p in zip(masses, positions)) / total
    return x, y
