"""Going further: taut cables and rods as forces in a plane, for methods that step complex numbers.

The pulls in a net are those that keep the lengths of all links, as in ``plane_rods``, but a body
may have any number of links. ``Elimination`` solves their equations.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from studies.models.elimination import Elimination
from studies.models.order_8 import Accelerations, Numbers

Link = tuple[int | complex, int, float]  # a body or a fixed point, a body, and the length in m


def accelerations_on_links(
    masses: Sequence[float],
    links: Sequence[Link],
    free: Callable[[Numbers], Numbers],
    correction: float = 1.0,
) -> Accelerations:
    """Return the function that computes the accelerations of bodies in a net of taut links.

    ``masses`` is in kg. ``free`` returns the accelerations in m/s^2 that the bodies would have
    without links. ``correction``, in 1/s, is the rate at which a link returns to its length. The
    function raises ArithmeticError if a link would have to push, as a cable cannot.
    """
    inverse = [1.0 / mass for mass in masses]
    signs: list[dict[int, float]] = [
        {end: 1.0} | ({start: -1.0} if isinstance(start, int) else {}) for start, end, _ in links
    ]
    shared = [
        (i, j, body, signs[i][body] * signs[j][body] * inverse[body])
        for j in range(len(links))
        for i in range(j)
        for body in signs[i].keys() & signs[j].keys()
    ]
    solver = Elimination(len(links), [(i, j) for i, j, _, _ in shared])
    slots = [(solver.slot_of(i, j), i, j, weight) for i, j, _, weight in shared]
    rows = [
        (start, end, length**2, sum(inverse[body] for body in sign))
        for (start, end, length), sign in zip(links, signs, strict=True)
    ]
    twice, half = 2.0 * correction, 0.5 * correction * correction

    def accelerations(positions: Numbers, velocities: Numbers) -> Numbers:
        found = free(positions)
        ways, wanted = [], []
        values = [0.0] * solver.size
        for i, (start, end, square, weight) in enumerate(rows):
            way, rate, gain = positions[end], velocities[end], found[end]
            if isinstance(start, int):
                way -= positions[start]
                rate -= velocities[start]
                gain -= found[start]
            else:
                way -= start
            a, b, c, d = way.real, way.imag, rate.real, rate.imag
            now = a * a + b * b
            closing = a * gain.real + b * gain.imag + c * c + d * d
            wanted.append(closing + twice * (a * c + b * d) + half * (now - square))
            values[i] = weight * now
            ways.append(way)
        for slot, i, j, weight in slots:
            values[slot] += weight * (ways[i].real * ways[j].real + ways[i].imag * ways[j].imag)
        solver.factor(values)
        pulls = solver.solve(values, wanted)
        for (start, end, _, _), way, pull in zip(rows, ways, pulls, strict=True):
            if not pull >= 0.0:  # NaN too
                raise ArithmeticError("a cable has become slack")
            force = pull * way
            found[end] -= inverse[end] * force
            if isinstance(start, int):
                found[start] += inverse[start] * force
        return found

    return accelerations
