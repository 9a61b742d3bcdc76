"""Going further: compute exact positions in every frame of an animation.

An exact solution contains factors that depend only on the duration of a frame. If all frames are
equally long, these factors need to be computed only once. After that, a frame takes only a few
additions and multiplications of plain numbers. The only errors are rounding errors. This file is
complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math

from ch02_vectors.arguments import positive, whole
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import drag_factors
from ch06_springs.closed_form import damped_spring_state


def places_in_frames(particle: Particle, frame: float, frames: int) -> list[tuple[float, float]]:
    """Return the position (x, y) of ``particle`` in m at the end of each frame.

    ``frames`` is the number of frames, and ``frame`` is the duration of each frame in s. The
    particle moves with its constant acceleration, and its damping acts as a drag that is linear in
    the velocity. The function only computes positions and does not change the particle. An
    immovable particle has the same position in every frame.

    Raises ValueError if ``frame`` is not positive and finite, or ``frames`` is less than 1. Raises
    TypeError if ``frames`` is not a whole number.
    """
    frames = whole("frames", frames)
    kept, gone, fallen = drag_factors(particle.damping, positive("frame", frame))
    x, y, _ = particle.position
    if not particle.has_finite_mass:
        return [(x, y)] * frames
    vx, vy, _ = particle.velocity
    ax, ay, _ = particle.acceleration
    # The changes of position and velocity in a frame that come from the acceleration alone.
    fallen_x, fallen_y, gained_x, gained_y = ax * fallen, ay * fallen, ax * gone, ay * gone
    places = []
    for _ in range(frames):
        x += vx * gone + fallen_x
        y += vy * gone + fallen_y
        vx = vx * kept + gained_x
        vy = vy * kept + gained_y
        places.append((x, y))
    return places


def oscillation_in_frames(
    x0: float, stiffness: float, damping: float, frame: float, frames: int
) -> list[float]:
    """Return the position in m of a body on a damped spring at the end of each frame.

    The body has a mass of 1 kg, and is released from rest at ``x0``. ``stiffness`` is in N/m,
    ``damping`` in N s/m, and ``frame`` in s. A frame multiplies the state (x, v) by a constant
    matrix with trace T and determinant D. By the theorem of Cayley and Hamilton, each position is
    therefore T times the last one minus D times the one before.

    Raises ValueError if an argument is out of range. Raises TypeError if ``frames`` is not a whole
    number.
    """
    frames = whole("frames", frames)
    positive("frame", frame)
    share, _ = damped_spring_state(1.0, 0.0, stiffness, damping, 1.0, frame)
    _, kept = damped_spring_state(0.0, 1.0, stiffness, damping, 1.0, frame)
    trace, determinant = share + kept, math.exp(-damping * frame)
    before, now = x0, x0 * share
    places = [now]
    for _ in range(frames - 1):
        before, now = now, trace * now - determinant * before
        places.append(now)
    return places


def fall_in_frames(
    gravity: float, k2: float, rate: float, frames: int
) -> list[tuple[float, float]]:
    """Return the position (x, y) in m of a body that falls from rest, at the end of each frame.

    The body has a mass of 1 kg and a quadratic drag of ``k2`` in kg/m. Its height after t s is
    -log(cosh(t sqrt(k2 g))) / k2. The hyperbolic functions of each frame follow from those of the
    frame before, by the formulas for sums. There are ``rate`` frames per second.
    """
    turn = math.sqrt(k2 * gravity) / rate
    c, s, cosh, sinh = math.cosh(turn), math.sinh(turn), 1.0, 0.0
    places = []
    for _ in range(frames):
        cosh, sinh = cosh * c + sinh * s, sinh * c + cosh * s
        places.append((0.0, -math.log(cosh) / k2))
    return places
