"""The shots, fireworks and Catherine wheel of chapter 4, as far as a student has written them."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import SHOT_TYPES, Shot, ShotType, grenade_after
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.firework_types import FIREWORK_TYPES, own_types
from ch04_particle_engine.fireworks import FireworkRule, FireworksShow
from scenes.flight import Flight
from scenes.readings import is_written

# The firework type of the Catherine wheel's sparks.
WHEEL_SPARK = FireworkRule(12, 0.5, 0.9, (-1.5, -1.5, -1.5), (1.5, 1.5, 1.5), damping=0.4)


def shot_names() -> list[str]:
    """List the types of shots, without the grenade if its code is not written yet."""
    can_throw = is_written(lambda: grenade_after(Shot("grenade", Particle())))
    return [name for name in SHOT_TYPES if name != "grenade" or can_throw]


def flight_of(shot: ShotType) -> Flight:
    """Convert a type of shot to a flight in which x is the direction of fire."""
    velocity = (shot.velocity[2], shot.velocity[1], 0.0)
    return Flight((0.0, 1.5, 0.0), velocity, shot.acceleration, shot.damping)


def firework_rules() -> list[FireworkRule]:
    """List the given types of fireworks, and the student's own ones if they are written."""
    return [*FIREWORK_TYPES, *(own_types() if is_written(own_types) else [])]


def make_wheel(show: FireworksShow, center: Vector3) -> CatherineWheel | None:
    """Create a Catherine wheel in a show with WHEEL_SPARK, or None if it is not written yet."""

    def wheel(show: FireworksShow) -> CatherineWheel:
        return CatherineWheel(
            show, WHEEL_SPARK.type, center, radius=2.0, rate=9.0, sparks_per_second=90.0, jet=26.0
        )

    trial = FireworksShow([WHEEL_SPARK], capacity=9, seed=1)
    return wheel(show) if is_written(lambda: wheel(trial).update(1.0)) else None
