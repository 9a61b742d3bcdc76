"""Going further: a load that moves across a net of knots, such as a ball on a rope bridge.

The two knots next to the load carry its weight, and the nearer one carries more. For our own
solvers, the load is a force generator. For pymunk, a step applies the forces to its bodies.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from studies.models.pymunk_steps import Step

if TYPE_CHECKING:
    import pymunk


def borne(xs: Sequence[float], x: float) -> tuple[int, float]:
    """Find the knot behind a load at ``x``, and the fraction of its weight on the next knot."""
    knot = sum(x >= other for other in xs[1:-1])
    return knot, min(max((x - xs[knot]) / (xs[knot + 1] - xs[knot]), 0.0), 1.0)


class Walker:
    """A force generator for a load that moves across a net. Register it for only one knot."""

    def __init__(self, knots: Sequence[Particle], start: float, pace: float, weight: float) -> None:
        self.knots, self.weight = knots, weight
        self.ball = Particle(Vector3(start), Vector3(pace))

    def update_force(self, _: Particle, __: float) -> None:
        """Divide the weight between the two knots next to the load. The nearer knot gets more."""
        knot, share = borne([knot.position.x for knot in self.knots], self.ball.position.x)
        self.knots[knot].add_force(Vector3(0.0, (share - 1.0) * self.weight))
        self.knots[knot + 1].add_force(Vector3(0.0, -share * self.weight))


def loading(
    space: pymunk.Space,
    bodies: list[pymunk.Body],
    x: float,
    pace: float,
    weight: float,
    *,
    is_ahead: bool,
) -> Step:
    """Return a step of pymunk that first applies the load, which starts at ``x`` m.

    If pymunk is half a step ahead, the load acts where it and the bodies are at the end of a step.
    """
    knot = 0

    def place_of(body: pymunk.Body, duration: float) -> float:
        return body.position.x + (body.velocity.x * duration if is_ahead else 0.0)

    def step(duration: float) -> None:
        nonlocal x, knot
        x += pace * duration * is_ahead
        while (ahead := place_of(bodies[knot + 1], duration)) <= x and knot < len(bodies) - 2:
            knot += 1
        behind = place_of(bodies[knot], duration)
        share = min(max((x - behind) / (ahead - behind), 0.0), 1.0)
        bodies[knot].apply_force_at_local_point((0.0, (share - 1.0) * weight))
        bodies[knot + 1].apply_force_at_local_point((0.0, -share * weight))
        space.step(duration)
        x += pace * duration * (not is_ahead)

    return step
