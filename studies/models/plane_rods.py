"""Going further: rods as forces in a plane, for the methods that step complex numbers.

The tensions are those of ``RodTensions``, which acts on particles. Here the bodies of a chain are
numbers x + iy, so that a system of equations for all tensions takes a few lines.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Sequence

from studies.models.order_8 import Accelerations, Numbers


def accelerations_on_rods(
    masses: Sequence[float], lengths: Sequence[float], gravity: float, correction: float = 1.0
) -> Accelerations:
    """Return the function that computes the accelerations of a chain, anchored at the origin.

    ``masses`` in kg and ``lengths`` in m go from the anchor to the tip. ``gravity`` in m/s^2 acts
    along -Y. ``correction``, in 1/s, is the rate at which a rod returns to its length. A rate of 5
    would make the longest steps of the multistep methods unstable.
    """
    inverse = [1.0 / mass for mass in masses]
    bodies = [*zip([0.0, *inverse], inverse, (length**2 for length in lengths), strict=False)]
    twice, half = 2.0 * correction, 0.5 * correction * correction
    down = complex(0.0, -gravity)

    def accelerations(positions: Numbers, velocities: Numbers) -> Numbers:
        """Eliminate the tensions from the anchor to the tip, and find them on the way back."""
        inner, speed, before = 0j, 0j, 0j
        free, value, pivot = down, 0.0, 1.0  # only the first rod feels gravity as a difference
        rows = []
        for x, v, (m, n, square) in zip(positions, velocities, bodies, strict=True):
            rod, rate = x - inner, v - speed
            a, b, c, d = rod.real, rod.imag, rate.real, rate.imag
            now = a * a + b * b
            wanted = free.imag * b + c * c + d * d
            wanted += twice * (a * c + b * d) + half * (now - square)
            below = m * (a * before.real + b * before.imag)
            factor = below / pivot
            rows.append((rod, factor, value, n))
            pivot = (m + n) * now - below * factor
            value = (wanted + below * value) / pivot
            inner, speed, before, free = x, v, rod, 0j
        found = []
        tension, outer = value, 0j
        for rod, factor, value, n in reversed(rows):
            pull = tension * rod
            found.append(down + n * (outer - pull))
            outer = pull
            tension = value + factor * tension
        found.reverse()
        return found

    return accelerations
