"""Ada's types: a comet that leaves a ring of embers."""

from ch04_particle_engine.fireworks import FireworkRule, Payload


def rule(type, ages, low, high, damping, *payloads):
    return FireworkRule(type, *ages, low, high, damping, tuple(Payload(*p) for p in payloads))


FIREWORK_TYPES = (
    rule(1, (0.5, 1.4), (-5, 25, -5), (5, 28, 5), 0.1, (3, 5), (5, 5)),
    rule(2, (0.5, 1.0), (-5, 10, -5), (5, 20, 5), 0.8, (4, 2)),
    rule(3, (0.5, 1.5), (-5, -5, -5), (5, 5, 5), 0.1),
    rule(4, (0.2, 0.5), (-12, 2, -5), (12, 6, 5), 0.7, (7, 12)),
    rule(5, (0.8, 1.6), (-12, -4, -8), (12, 8, 8), 0.5),
    rule(6, (1.3, 1.5), (-2, 22, -2), (2, 24, 2), 0.7, (8, 8), (9, 10)),
    rule(7, (0.6, 1.0), (-3, 4, -3), (3, 9, 3), 0.6),
    rule(8, (0.5, 0.7), (-14, 0, -14), (14, 8, 14), 0.3, (3, 4)),
    rule(9, (0.1, 0.9), (-6, -6, -6), (6, 6, 6), 0.05),
)


def own_types():
    return [
        rule(10, (1.5, 1.6), (-8, 18, -1), (8, 22, 1), 0.95, (11, 20), (9, 5)),
        rule(11, (0.9, 1.1), (-9, 0, -9), (9, 1, 9), 0.2),
    ]
