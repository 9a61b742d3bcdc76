"""Going further: compute the exact position of a particle in every frame of an animation.

The exact solution contains three factors that depend only on the damping and the duration of a
frame. If all frames are equally long, these factors need to be computed only once. After that, a
frame takes only a few additions and multiplications of plain numbers. The only errors are rounding
errors. This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from ch02_vectors.arguments import positive, whole
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import drag_factors


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
