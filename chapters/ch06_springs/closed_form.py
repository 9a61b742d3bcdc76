"""The exact state of a damped spring at any time, without time steps (book 6.3.2)."""

from __future__ import annotations


def damped_spring_state(
    x0: float, v0: float, stiffness: float, damping: float, mass: float, time: float
) -> tuple[float, float]:
    """Return the position and velocity of a damped spring after ``time`` s, as a tuple.

    The spring pulls a body toward position 0, so m x'' = -k x - c x'. Here k is ``stiffness`` in
    N/m, c is ``damping`` in N s/m and m is ``mass`` in kg. The body starts at ``x0`` in m with the
    velocity ``v0`` in m/s. With s = c / (2 m) and g = sqrt(|s^2 - k / m|), its position is

        x = e^(-s t) (x0 C + (v0 + s x0) S)

    - where C = cos(g t) and S = sin(g t) / g if c^2 < 4 k m, so that it oscillates,
    - C = 1 and S = t if c^2 = 4 k m (critically damped),
    - C = cosh(g t) and S = sinh(g t) / g if c^2 > 4 k m, so that it creeps back to 0.

    The velocity is the derivative of this position. Tell the cases apart without a tolerance,
    because even a very soft spring oscillates. The result must be accurate to 1e-8 even if the
    damping is almost critical, and also at late times and for strong damping, where cosh(g t) is
    too large for a float. If the stiffness is 0, the body feels no spring force.
    """
    raise NotImplementedError("Exercise B6.5: Harmonic motion without steps")
