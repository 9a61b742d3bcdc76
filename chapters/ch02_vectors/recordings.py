"""Three recorded motions, from which you can find the laws behind them.

Nobody has filmed them. The tables are simulated, but they contain what a camera would measure: the
times of its pictures in s, and positions that are rounded to 1 mm. Each function returns two new
lists for one motion: its times, and its positions as vectors in m. +Y points up.

The time t is 0 in the first picture. Before rounding, the positions follow these formulas:

- ``thrown_ball``: x = x0 + u t and y = y0 + v t - g t^2 / 2, without air resistance.
- ``falling_filters``: y = y0 - (u^2 / g) ln cosh(g t / u), a fall from rest with drag that grows
  with the square of the speed. At its terminal speed u, the drag equals the weight.
- ``weight_on_spring``: y = y0 e^(-s t) (cos(w t) + (s / w) sin(w t)), with s = c / (2 m) and
  w = sqrt(k / m - s^2). The weight is released at rest from the height y0 above its rest position.

The lessons of the chapters 3, 5 and 6 show how to find the unknown numbers in these formulas.

This file is complete, and you do not hand it in.
"""

from __future__ import annotations

from itertools import zip_longest

from ch02_vectors.vector import Vector3

BALL_RATE = 60  # pictures per second
FILTERS_RATE = 60
WEIGHT_RATE = 30

FILTERS_MASS = 0.003  # kg
WEIGHT_MASS = 0.5  # kg

# All coordinates are in mm.
_BALL_X = """
0 67 133 200 267 333 400 467 533 600 667 733 800 867 933 1000 1067 1133 1200 1267 1333 1400 1467
1533 1600 1667 1733 1800 1867 1933 2000 2067 2133 2200 2267 2333 2400 2467 2533 2600 2667 2733 2800
2867 2933 3000 3067 3133 3200 3267 3333 3400 3467 3533 3600 3667 3733 3800 3867 3933 4000
"""

_BALL_Y = """
1500 1599 1695 1788 1878 1966 2051 2133 2213 2290 2364 2435 2504 2570 2633 2693 2751 2806 2859 2908
2955 2999 3041 3079 3115 3148 3179 3207 3232 3254 3274 3291 3305 3316 3325 3331 3334 3335 3333 3328
3320 3310 3297 3281 3262 3241 3217 3190 3161 3129 3094 3056 3016 2973 2927 2878 2827 2773 2717 2657
2595
"""

_FILTERS_Y = """
2000 1999 1995 1988 1979 1967 1953 1938 1920 1901 1880 1858 1835 1811 1786 1760 1734 1708 1681 1653
1626 1598 1570 1541 1513 1484 1455 1427 1398 1369 1340 1311 1282 1253 1224 1195 1166 1137 1107 1078
1049 1020 991 962 933 903 874 845 816 787 758 728 699 670 641 612 582 553 524 495 466
"""

_WEIGHT_Y = """
200 196 183 162 135 102 66 27 -12 -50 -85 -115 -140 -158 -169 -172 -168 -156 -138 -114 -85 -54 -20
13 46 75 101 122 137 146 148 144 133 117 96 71 44 15 -14 -42 -67 -89 -106 -119 -126 -128 -124 -114
-100 -81 -60 -36 -11 14 38 59 78 93 103 109 110 106 97 85 69 50 29 8 -14 -34 -52 -68 -81 -89 -94 -95
-91 -83 -72 -58 -42 -24 -5 13 31 46 60 70 78 81 81 78 71 61 49 35 19 3 -13 -28 -41 -52 -61 -67 -70
-70 -67 -60 -52 -41 -29 -15 -2 12 25 36 46 53 58 60 60
"""


def thrown_ball() -> tuple[list[float], list[Vector3]]:
    """Return the times and positions of a ball that flies in the X-Y plane for 1 s."""
    return _film(BALL_RATE, _BALL_X, _BALL_Y)


def falling_filters() -> tuple[list[float], list[Vector3]]:
    """Return the times and positions of a stack of three paper coffee filters of 3 g together.

    The stack is released at rest, 2 m above the floor, and is filmed for 1 s.
    """
    return _film(FILTERS_RATE, "", _FILTERS_Y)


def weight_on_spring() -> tuple[list[float], list[Vector3]]:
    """Return the times and positions of a weight of 0.5 kg on a damped spring, filmed for 4 s.

    The origin is the position in which the weight can hang at rest.
    """
    return _film(WEIGHT_RATE, "", _WEIGHT_Y)


def _film(rate: int, x: str, y: str) -> tuple[list[float], list[Vector3]]:
    """Turn coordinates in mm into times and positions. Coordinates that are left out are 0."""
    rows = zip_longest(map(float, x.split()), map(float, y.split()), fillvalue=0.0)
    positions = [Vector3(across / 1000, up / 1000) for across, up in rows]
    return [i / rate for i in range(len(positions))], positions
