"""Steps of the engine in plain numbers, which show how much time its objects cost.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from operator import add

from ch06_springs.going_further.cloth import KNOTS, MASS, REST_LENGTH, STIFFNESS, G, neighbors
from scenes.flight import Flight
from scenes.readings import Numbers


def flight_in_numbers(flight: Flight, frames: Sequence[float]) -> Numbers:
    """Make the steps of Particle.integrate of chapter 3, and return the final position."""
    x, y, z = flight.position
    vx, vy, vz = flight.velocity
    ax, ay, az = flight.acceleration
    damping = flight.damping
    for frame in frames:
        x += vx * frame
        y += vy * frame
        z += vz * frame
        keep = damping**frame
        vx = (vx + ax * frame) * keep
        vy = (vy + ay * frame) * keep
        vz = (vz + az * frame) * keep
    return x, y, z


def pushed_in_numbers(flight: Flight, force: Numbers, frames: Sequence[float]) -> Numbers:
    """Make the steps of chapter 5, which sum the forces on 1 kg, use the sum and clear it."""
    x, y, z = flight.position
    vx, vy, vz = flight.velocity
    ax, ay, az = flight.acceleration
    damping = flight.damping
    inverse_mass = 1.0
    force_x, force_y, force_z = force
    sum_x = sum_y = sum_z = 0.0
    for frame in frames:
        sum_x += force_x
        sum_y += force_y
        sum_z += force_z
        x += vx * frame
        y += vy * frame
        z += vz * frame
        keep = damping**frame
        vx = (vx + (ax + sum_x * inverse_mass) * frame) * keep
        vy = (vy + (ay + sum_y * inverse_mass) * frame) * keep
        vz = (vz + (az + sum_z * inverse_mass) * frame) * keep
        sum_x = sum_y = sum_z = 0.0
    return x, y, z


def cloth_in_numbers(damping: float, duration: float, steps: int) -> float:
    """Simulate chapter 6's cloth with explicit Euler, and return the height of its lowest knot."""
    count = KNOTS * KNOTS
    x = [REST_LENGTH * (i % KNOTS) for i in range(count)]
    y = [0.0] * count
    z = [REST_LENGTH * (i // KNOTS) for i in range(count)]
    u, v, w = [0.0] * count, [0.0] * count, [0.0] * count
    inverse_mass = [1.0 / MASS] * count
    inverse_mass[0] = inverse_mass[KNOTS - 1] = 0.0
    springs = [(i, j, STIFFNESS, REST_LENGTH, damping) for i, j in neighbors()]
    for _ in range(steps):
        fx, fy, fz = [0.0] * count, [0.0] * count, [0.0] * count
        for i, j, stiffness, rest, c in springs:
            dx = x[i] - x[j]
            dy = y[i] - y[j]
            dz = z[i] - z[j]
            length = math.hypot(dx, dy, dz)
            if length == 0.0:
                continue
            rate = ((u[i] - u[j]) * dx + (v[i] - v[j]) * dy + (w[i] - w[j]) * dz) / length
            pull = (stiffness * (rest - length) - c * rate) / length
            dx *= pull
            dy *= pull
            dz *= pull
            fx[i] += dx
            fy[i] += dy
            fz[i] += dz
            fx[j] -= dx
            fy[j] -= dy
            fz[j] -= dz
        for i in range(count):
            inverse = inverse_mass[i]
            if inverse:
                x[i] += u[i] * duration
                y[i] += v[i] * duration
                z[i] += w[i] * duration
                u[i] += fx[i] * inverse * duration
                v[i] += (fy[i] * inverse - G) * duration
                w[i] += fz[i] * inverse * duration
    return min(y)


def spring_in_numbers(
    stiffness: float, length: float, damping: float, duration: float, steps: int
) -> tuple[float, float, float]:
    """Simulate 1 kg on an anchored spring with semi-implicit Euler, and return the position."""
    x, y, z = 1.0, 2.0, 3.0
    u, v, w = 1.0, 2.0, 3.0
    mass = 1.0
    for _ in range(steps):
        now = math.hypot(x, y, z)
        rate = (u * x + v * y + w * z) / now
        pull = (stiffness * (length - now) - damping * rate) / now
        u += x * pull / mass * duration
        v += y * pull / mass * duration
        w += z * pull / mass * duration
        x += u * duration
        y += v * duration
        z += w * duration
    return x, y, z


class Falling:
    """Bodies that start at the height 0 and fall in the X-Y plane, in steps of equal length.

    Python's ``map`` adds two lists without a loop in Python, which is about the least that Python
    can do. The velocities are half a step ahead of the positions, so every step is exact.

    ``xs`` and ``across`` list their positions in m and their velocities in m/s along X. All have
    the same velocity ``up`` in m/s and the same ``gravity`` in m/s^2.
    """

    def __init__(
        self,
        xs: Sequence[float],
        across: Sequence[float],
        up: float,
        gravity: float,
        duration: float,
    ) -> None:
        fall = -gravity * duration * duration
        self.xs, self.across = [*xs], [v * duration for v in across]
        self.ys, self.up = [0.0] * len(xs), [up * duration + 0.5 * fall] * len(xs)
        self.change = [fall] * len(xs)

    def step(self, _: float) -> None:
        """Move all bodies by one step."""
        self.xs = [*map(add, self.xs, self.across)]
        self.ys = [*map(add, self.ys, self.up)]
        self.up = [*map(add, self.up, self.change)]

    def place(self) -> list[float]:
        """List the coordinates of all bodies: x1, y1, x2, y2 and so on."""
        found = self.xs * 2
        found[::2], found[1::2] = self.xs, self.ys
        return found
