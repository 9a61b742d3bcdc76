"""Compute the exact orientations of a rotating body, as a reference for an engine's results.

An orientation is given either as a quaternion or as three arrows. The quaternion has the components
r, i, j and k. The arrows are the directions of the body's axes X, Y and Z in world coordinates.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.quaternion import Quaternion
from scenes.readings import (
    Numbers,
    angle_between,
    cross,
    dot,
    is_drawable,
    number,
    numbers,
    stopped,
)

Components = tuple[float, float, float, float]
Arrows = tuple[Numbers, Numbers, Numbers]
Step = Callable[[Quaternion, Numbers, float], None]  # takes orientation, velocity, duration
Velocity = Callable[[float], Numbers]  # returns the angular velocity at a time

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
NOWHERE: Arrows = ((math.nan,) * 3, (math.nan,) * 3, (math.nan,) * 3)
GRAVITY = 9.81
TAU = math.tau


def components(q: Any) -> Components:
    """Convert an engine's quaternion to four floats. Anything that is not a number becomes NaN."""
    r, i, j, k = (number(getattr(q, name, None)) for name in "rijk")
    return r, i, j, k


def turn(axis: Numbers, angle: float) -> Components:
    """Compute the quaternion of a rotation by ``angle`` about ``axis``, which must not be zero."""
    share = math.sin(0.5 * angle) / math.hypot(*axis)
    return math.cos(0.5 * angle), axis[0] * share, axis[1] * share, axis[2] * share


def product(b: Components, a: Components) -> Components:
    """Compute the quaternion of the rotation that applies ``a`` first and then ``b``."""
    u, v = b[1:], a[1:]
    i, j, k = (b[0] * q + a[0] * p + c for p, q, c in zip(u, v, cross(u, v), strict=True))
    return b[0] * a[0] - dot(u, v), i, j, k


def rotated(q: Components, v: Numbers) -> Numbers:
    """Rotate the vector ``v`` by the unit quaternion ``q``."""
    back = (q[0], -q[1], -q[2], -q[3])
    _, x, y, z = product(product(q, (0.0, *v)), back)
    return x, y, z


def arrows(q: Components) -> Arrows:
    """Compute where a body's axes X, Y and Z point after the unit quaternion ``q`` rotates it."""
    return rotated(q, X), rotated(q, Y), rotated(q, Z)


def arrows_by_engine(q: Quaternion) -> Arrows:
    """Return the directions of the axes X, Y and Z after the engine has rotated them by ``q``."""
    x, y, z = (numbers(q.rotate(Vector3(*axis))) for axis in (X, Y, Z))
    return x, y, z


def degrees_apart(a: Components, b: Components) -> float:
    """Compute the angle in degrees between two orientations that are given as quaternions.

    The quaternions do not have to be normalized. Return NaN if a length is 0 or not finite.
    """
    if not (0.0 < math.hypot(*a) < math.inf and 0.0 < math.hypot(*b) < math.inf):
        return math.nan
    r, *axis = product(b, (a[0], -a[1], -a[2], -a[3]))
    return math.degrees(2.0 * math.atan2(math.hypot(*axis), abs(r)))


def degrees_between_arrows(a: Arrows, b: Arrows) -> float:
    """Compute the angle in degrees between two orientations, each given as three axis directions.

    The angle follows from the trace of the matrix that rotates one orientation to the other. Return
    NaN if a direction is not finite.
    """
    if not is_drawable(*a, *b):
        return math.nan
    cosine = 0.5 * (math.fsum(dot(p, q) for p, q in zip(a, b, strict=True)) - 1.0)
    return math.degrees(math.acos(min(max(cosine, -1.0), 1.0)))


def off_right_angles(found: Arrows) -> float:
    """Find the largest deviation of the angle between two rotated axes from 90 degrees."""
    x, y, z = found
    return largest([abs(angle_between(a, b) - 90.0) for a, b in ((x, y), (y, z), (z, x))])


def off_unit_length(found: Arrows) -> float:
    """Find the largest difference between the length of a rotated axis and 1."""
    return largest([abs(math.hypot(*v) - 1.0) for v in found])


def off_directions(found: Arrows, wanted: Arrows) -> float:
    """Return the largest angle in degrees between a rotated axis and its correct direction."""
    return largest([angle_between(a, b) for a, b in zip(found, wanted, strict=True)])


def largest(values: list[float]) -> float:
    """Return the largest of several errors, or NaN if there are none or if one of them is NaN."""
    return max(values, default=math.nan) if not any(map(math.isnan, values)) else math.nan


# A thin disc that is thrown up and rotates freely. Its axis is tilted from the vertical by TILT and
# rotates about the vertical at PRECESSION. The moment of inertia about a diameter is half of the
# moment about the axis. It follows that the disc also spins about its axis at SPIN, against the
# precession.
TILT = math.radians(25.0)
PRECESSION = TAU * 0.9
SPIN = -0.5 * PRECESSION * math.cos(TILT)
FLIGHT = 1.2  # s
AXIS = (math.sin(TILT), math.cos(TILT), 0.0)
TILTED = turn((0.0, 0.0, -1.0), TILT)  # the disc's own Y along its axis


@dataclass(frozen=True)
class Throw:
    """The flight of a thrown disc, with the computed and the exact directions of its axes.

    If an error in the engine ended the flight early, ``message`` is the text of the error.
    """

    times: list[float]
    found: list[Arrows]
    wanted: list[Arrows]
    message: str

    def worst(self, measure: Callable[[Arrows], float]) -> float:
        """Return the largest error that ``measure`` finds at any time of the flight."""
        return largest([measure(found) for found in self.found])

    def worst_direction(self) -> float:
        """Find the largest angle in degrees between an axis and its exact direction."""
        pairs = zip(self.found, self.wanted, strict=True)
        return largest([off_directions(found, wanted) for found, wanted in pairs])


def disc_place(time: float) -> Numbers:
    """Compute the position of the thrown disc, which flies along a parabola and lands 6 m away."""
    return 6.0 * time / FLIGHT, 0.5 * GRAVITY * time * (FLIGHT - time), 0.0


def disc_orientation(time: float) -> Components:
    """Compute the exact orientation of the thrown disc, which spins about a moving axis."""
    return product(turn(Y, PRECESSION * time), product(turn(AXIS, SPIN * time), TILTED))


def disc_acceleration(time: float) -> Numbers:
    """Compute the angular acceleration of the thrown disc.

    It is not zero, because the precession constantly changes the direction of the spin axis.
    """
    x, y, z = rotated(turn(Y, PRECESSION * time), AXIS)
    return cross((0.0, PRECESSION, 0.0), (SPIN * x, SPIN * y, SPIN * z))


def throw_disc(rate: int) -> Throw:
    """Simulate the rotation of a thrown disc with the engine's integrate_rotation.

    ``rate`` is the number of time steps per second.
    """
    orientation = Quaternion(*TILTED)
    velocity = Vector3(SPIN * AXIS[0], SPIN * AXIS[1] + PRECESSION, 0.0)
    times: list[float] = []
    found: list[Arrows] = []

    def run() -> None:
        for n in range(round(FLIGHT * rate) + 1):
            if n > 0:
                acceleration = Vector3(*disc_acceleration((n - 1) / rate))
                integrate_rotation(orientation, velocity, acceleration, 1.0 / rate)
            found.append(arrows_by_engine(orientation))
            times.append(n / rate)

    message = stopped(run)
    return Throw(times, found, [arrows(disc_orientation(time)) for time in times], message)


def by_first_order(q: Quaternion, velocity: Numbers, duration: float) -> None:
    """Advance the orientation ``q`` by one time step of the book's first-order formula, Eq. 9.5."""
    q.add_scaled(Vector3(*velocity), duration)


def by_first_order_normalized(q: Quaternion, velocity: Numbers, duration: float) -> None:
    """Advance the orientation ``q`` by one time step of Eq. 9.5, and normalize it."""
    q.add_scaled(Vector3(*velocity), duration)
    q.normalize()


def by_exponential(q: Quaternion, velocity: Numbers, duration: float) -> None:
    """Advance the orientation ``q`` by the exponential of the rotation in one time step."""
    q.rotate_by(Vector3(*(component * duration for component in velocity)))


# Two rotations for comparing methods. The first is a steady turn per second about a slanted axis,
# from an orientation with another slant. In the second, the axis also moves around Z, along a cone,
# at half a turn per second. The errors are measured at END, because after a whole turn some of them
# would cancel, and a product in the wrong order would not show.
END = 0.7  # s
START = turn((1.0, -2.0, 0.5), 1.0)
STEADY = (TAU * 2.0 / 3.0, -TAU / 3.0, TAU * 2.0 / 3.0)
CONING, SLANTING = 0.5 * TAU, (TAU * 0.6, 0.0, TAU * 0.8)


def steady_velocity(_: float) -> Numbers:
    """Return the constant angular velocity of a body that rotates steadily."""
    return STEADY


def steady_orientation(time: float) -> Components:
    """Compute the exact orientation at ``time`` of a body that rotates steadily."""
    return product(turn(STEADY, TAU * time), START)


def coning_velocity(time: float) -> Numbers:
    """Compute the angular velocity of a body whose rotation axis itself rotates about Z."""
    x, y, z = rotated(turn(Z, CONING * time), SLANTING)
    return x, y, z + CONING


def coning_orientation(time: float) -> Components:
    """Compute the exact orientation of a body whose rotation axis itself rotates about Z.

    The orientation is the product of two rotations. The body first rotates about a fixed axis, and
    the result then rotates about Z.
    """
    return product(turn(Z, CONING * time), product(turn(SLANTING, TAU * time), START))


def turn_by_steps(
    step: Step, velocity: Velocity, steps: int, rate: float, share: float = 0.0
) -> tuple[list[Components], str]:
    """Simulate a rotation step by step, and return all orientations and any error message.

    The body starts in the orientation START. ``share`` is the fraction of a step at which the
    angular velocity is evaluated. For example, 0.5 is the middle of the step.
    """
    q = Quaternion(*START)
    found = [components(q)]

    def run() -> None:
        for n in range(steps):
            step(q, velocity((n + share) / rate), 1.0 / rate)
            found.append(components(q))

    message = stopped(run)
    return found, message


def worst_axis(distance: float, z: float) -> Numbers:
    """Find the rotation axis for which the Euler angles change fastest near gimbal lock.

    Gimbal lock occurs when the Euler angle y is 90 degrees. ``distance`` is how far y is below 90
    degrees, in radians. The axis lies halfway between the world's Z axis and the rotated X axis.
    """
    up = math.sin(0.5 * distance)
    along = math.cos(0.5 * distance)
    return math.cos(z) * along, math.sin(z) * along, up


def columns(matrix: Any) -> Arrows:
    """Return the columns of an engine's Matrix3, which are the axes of a rotated body."""
    a, b, c, d, e, f, g, h, i = nine(matrix)
    return (a, d, g), (b, e, h), (c, f, i)


def singular_values(matrix: Any) -> Numbers:
    """Compute the singular values of an engine's Matrix3, largest first.

    All three are NaN unless the matrix has nine finite entries.
    """
    found = nine(matrix)
    if not all(map(math.isfinite, found)):
        return math.nan, math.nan, math.nan
    first, second, third = numpy.linalg.svd(numpy.reshape(found, (3, 3)), compute_uv=False)
    return float(first), float(second), float(third)


def nine(matrix: Any) -> list[float]:
    """Return the entries of an engine's Matrix3 row by row, or nine NaNs if there are not nine."""
    found = [number(entry) for entry in getattr(matrix, "entries", ())]
    return found if len(found) == 9 else [math.nan] * 9
