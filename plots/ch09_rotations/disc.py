"""A thin disc that is thrown and wobbles: its exact motion, and its rotation by an engine.

The disc's axis is tilted from the vertical by TILT, and rotates about the vertical at PRECESSION.
The moment of inertia about a diameter is half of that about the axis. It follows that the disc also
spins about its axis at SPIN, against the precession.
"""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.quaternion import Quaternion
from plots.ch09_rotations.orientations import (
    Arrows,
    Y,
    arrows,
    arrows_by_engine,
    product,
    rotated,
    turn,
)
from scenes.readings import Numbers, cross, stopped

TILT = math.radians(25.0)
PRECESSION = math.tau * 0.9
SPIN = -0.5 * PRECESSION * math.cos(TILT)
FLIGHT = 1.2  # s
AXIS = (math.sin(TILT), math.cos(TILT), 0.0)
TILTED = turn((0.0, 0.0, -1.0), TILT)  # the disc's own Y along its axis


def place(time: float) -> Numbers:
    """Compute the position of the disc, which flies along a parabola and lands 6 m away."""
    return 6.0 * time / FLIGHT, 0.5 * 9.81 * time * (FLIGHT - time), 0.0


def exact_arrows(time: float) -> Arrows:
    """Compute the exact directions of the disc's axes."""
    spun = product(turn(AXIS, SPIN * time), TILTED)
    return arrows(product(turn(Y, PRECESSION * time), spun))


def acceleration(time: float) -> Numbers:
    """Compute the angular acceleration: the precession keeps changing the spin's direction."""
    x, y, z = rotated(turn(Y, PRECESSION * time), AXIS)
    return cross((0.0, PRECESSION, 0.0), (SPIN * x, SPIN * y, SPIN * z))


def thrown(rate: int) -> tuple[list[Arrows], str]:
    """Simulate the rotation with the engine's integrate_rotation, in ``rate`` steps per second.

    Return the directions of the axes at the start and after each step, and the text of the error
    that ended the flight early, if there was one.
    """
    orientation = Quaternion(*TILTED)
    velocity = Vector3(SPIN * AXIS[0], SPIN * AXIS[1] + PRECESSION, 0.0)
    found: list[Arrows] = []

    def run() -> None:
        found.append(arrows_by_engine(orientation))
        for n in range(round(FLIGHT * rate)):
            now = Vector3(*acceleration(n / rate))
            integrate_rotation(orientation, velocity, now, 1.0 / rate)
            found.append(arrows_by_engine(orientation))

    return found, stopped(run)
