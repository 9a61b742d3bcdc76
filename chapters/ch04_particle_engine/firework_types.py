"""The nine types of firework in the fireworks show, and two types of your own.

The numbers of the first three types are from the book's listing, and the others are our own. Types
1, 2, 4, 6 and 8 are rockets, which light other fireworks when they burn out.
"""

from __future__ import annotations

from ch04_particle_engine.fireworks import FireworkRule, Payload

FIREWORK_TYPES = (
    # A shell that bursts into slow and fast sparks.
    FireworkRule(
        1, 0.5, 1.4, (-5, 25, -5), (5, 28, 5), damping=0.1, payloads=(Payload(3, 5), Payload(5, 5))
    ),
    # A low rocket with two bursting candles.
    FireworkRule(2, 0.5, 1.0, (-5, 10, -5), (5, 20, 5), damping=0.8, payloads=(Payload(4, 2),)),
    # Sparks that stop in the air.
    FireworkRule(3, 0.5, 1.5, (-5, -5, -5), (5, 5, 5), damping=0.1),
    # A candle that flies on for a moment and bursts into a fountain.
    FireworkRule(4, 0.2, 0.5, (-12, 2, -5), (12, 6, 5), damping=0.7, payloads=(Payload(7, 12),)),
    # Sparks that fall far.
    FireworkRule(5, 0.8, 1.6, (-12, -4, -8), (12, 8, 8), damping=0.5),
    # A high shell with a crown, which bursts once more.
    FireworkRule(
        6, 1.3, 1.5, (-2, 22, -2), (2, 24, 2), damping=0.7, payloads=(Payload(8, 8), Payload(9, 10))
    ),
    # The drops of a fountain.
    FireworkRule(7, 0.6, 1.0, (-3, 4, -3), (3, 9, 3), damping=0.6),
    # An arm of a crown.
    FireworkRule(8, 0.5, 0.7, (-14, 0, -14), (14, 8, 14), damping=0.3, payloads=(Payload(3, 4),)),
    # Glitter that hardly moves and goes out at once.
    FireworkRule(9, 0.1, 0.9, (-6, -6, -6), (6, 6, 6), damping=0.05),
)


def own_types() -> list[FireworkRule]:
    """Design two types of firework of your own, with the numbers 10 and 11.

    - The two rules must differ from each other, and from the nine rules above, in more than their
      type. At least one of them must have payloads, of types 1 to 11.
    - None of the eleven types may light itself again, not even through other types.
    - Each of the two types must burn for at least 0.1 s. Once one of these fireworks has been lit,
      it and everything that comes from it must burn out within 40 s.
    """
    raise NotImplementedError("Exercise 4.2: Two types of your own")
