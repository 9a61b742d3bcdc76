"""Ada's turning squares."""

import math

from ch02_vectors.arguments import finite, positive


def screen_angle(start, rate, time):
    angle = finite("start", start) + finite("rate", rate) * finite("time", time)
    return angle - 2 * math.pi * round(angle / (2 * math.pi))


def screen_corners(center, size, angle):
    x, y = (finite("center", coordinate) for coordinate in center)
    away = positive("size", size) / math.sqrt(2)
    finite("angle", angle)
    turns = [angle + math.pi * (0.25 + 0.5 * i) for i in range(4)]
    return [(x + away * math.cos(t), y + away * math.sin(t)) for t in turns]
