"""Going further, complete: a step that is exact.

A film of a flight wants a place in every frame, all of them equally long. Then the three factors of
the closed form are the same in each, and worked out once: from there on a frame is a step in plain
numbers, which costs less than any other and is right to rounding.
"""

from __future__ import annotations

from ch02_vectors.arguments import positive, whole
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import drag_factors


def places_in_frames(particle: Particle, frame: float, frames: int) -> list[tuple[float, float]]:
    """Return x and y of a particle in m at the end of each of so many frames, of ``frame`` s each.

    It moves under its constant acceleration and its damping, a drag that is linear in the velocity,
    and stays as it is. An immovable one is found where it is now. Raises ValueError where the
    frame is not positive and finite, or there is not a whole number of them, 1 or more.
    """
    frames = whole("frames", frames)
    kept, gone, fallen = drag_factors(particle.damping, positive("frame", frame))
    x, y, _ = particle.position
    if not particle.has_finite_mass:
        return [(x, y)] * frames
    vx, vy, _ = particle.velocity
    ax, ay, _ = particle.acceleration
    # What the acceleration alone does to place and speed in a frame.
    fallen_x, fallen_y, gained_x, gained_y = ax * fallen, ay * fallen, ax * gone, ay * gone
    places = []
    for _ in range(frames):
        x += vx * gone + fallen_x
        y += vy * gone + fallen_y
        vx = vx * kept + gained_x
        vy = vy * kept + gained_y
        places.append((x, y))
    return places
