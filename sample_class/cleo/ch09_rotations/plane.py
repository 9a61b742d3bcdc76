"""The plane."""

import math

from ch02_vectors.arguments import finite, positive

Point = tuple[float, float]


def wrap_angle(angle):
    finite("angle", angle)
    while angle > math.pi:
        angle -= 2 * math.pi
    while angle < -math.pi:
        angle += 2 * math.pi
    return angle


def angle_to_vector(angle):
    finite("angle", angle)
    return math.cos(angle), math.sin(angle)


def rotate_point(point, angle, origin):
    x = finite("x", point[0])
    y = finite("y", point[1])
    finite("x", origin[0])
    finite("y", origin[1])
    c, s = angle_to_vector(angle)
    return (c * x - s * y + origin[0], s * x + c * y + origin[1])


def center_of_mass(masses, positions):
    if len(masses) == 0 or len(masses) != len(positions):
        raise ValueError("masses and positions")
    total = 0.0
    x = 0.0
    y = 0.0
    for i in range(len(masses)):
        m = positive("mass", masses[i])
        x += m * finite("x", positions[i][0])
        y += m * finite("y", positions[i][1])
        total += m
    return (x / total, y / total)
