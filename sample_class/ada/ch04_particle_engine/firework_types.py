"""What the show can burn: nine types that are given, and two more."""

from __future__ import annotations

from ch04_particle_engine.fireworks import FireworkRule, Payload

FIREWORK_TYPES = (
    FireworkRule(1, 0.5, 1.4, (-5, 25, -5), (5, 28, 5), 0.1, (Payload(3, 5), Payload(5, 5))),
    FireworkRule(2, 0.5, 1.0, (-5, 10, -5), (5, 20, 5), 0.8, (Payload(4, 2),)),
    FireworkRule(3, 0.5, 1.5, (-5, -5, -5), (5, 5, 5), 0.1),
    FireworkRule(4, 0.2, 0.5, (-12, 2, -5), (12, 6, 5), 0.7, (Payload(7, 12),)),
    FireworkRule(5, 0.8, 1.6, (-12, -4, -8), (12, 8, 8), 0.5),
    FireworkRule(6, 1.3, 1.5, (-2, 22, -2), (2, 24, 2), 0.7, (Payload(8, 8), Payload(9, 10))),
    FireworkRule(7, 0.6, 1.0, (-3, 4, -3), (3, 9, 3), 0.6),
    FireworkRule(8, 0.5, 0.7, (-14, 0, -14), (14, 8, 14), 0.3, (Payload(3, 4),)),
    FireworkRule(9, 0.1, 0.9, (-6, -6, -6), (6, 6, 6), 0.05),
)


def own_types() -> list[FireworkRule]:
    palm = FireworkRule(
        10,
        min_age=1.8,
        max_age=1.8,
        min_velocity=(0, 19, 0),
        max_velocity=(0, 19, 0),
        damping=0.9,
        payloads=[Payload(11, 7), Payload(9, 30), Payload(2, 1)],
    )
    leaf = FireworkRule(
        11,
        min_age=2.2,
        max_age=3.0,
        min_velocity=(-9, 3, -9),
        max_velocity=(9, 5, 9),
        damping=0.4,
        payloads=[Payload(9, 1)],
    )
    return [palm, leaf]
