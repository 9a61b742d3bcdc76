"""Three ways to step a body in pymunk under a force of our own.

Pymunk's examples either apply a force before each step, or give the body a ``velocity_func``. Both
have an error of order 1. The third way keeps the velocity half a step behind the position, as
leapfrog does, and so reaches order 2.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from studies.models.order_8 import Acceleration

if TYPE_CHECKING:
    import pymunk

Step = Callable[[float], object]


def pushing(acceleration: Acceleration, space: pymunk.Space, bodies: list[pymunk.Body]) -> Step:
    """Return a step that first applies the force to a body of 1 kg."""
    (body,) = bodies

    def step(duration: float) -> None:
        place = body.position
        pull = acceleration(complex(*place), complex(*body.velocity))
        body.apply_force_at_world_point((pull.real, pull.imag), place)
        space.step(duration)

    return step


def calling_back(
    acceleration: Acceleration, space: pymunk.Space, bodies: list[pymunk.Body]
) -> Step:
    """Return a step in which pymunk calls back for the acceleration of the body."""
    (body,) = bodies
    update = body.update_velocity

    def change(body: pymunk.Body, _gravity: Any, _damping: float, duration: float) -> None:
        pull = acceleration(complex(*body.position), complex(*body.velocity))
        update(body, (pull.real, pull.imag), 1.0, duration)

    body.velocity_func = change
    return space.step


def changing(
    acceleration: Acceleration, first: complex, space: pymunk.Space, bodies: list[pymunk.Body]
) -> Step:
    """Return a step that first changes the velocity, which is half a step behind at the start.

    ``first`` is the acceleration at the start.
    """
    (body,) = bodies
    speed, last, move = complex(*body.velocity), first, space.step

    def step(duration: float) -> None:
        nonlocal speed, last
        x, y = body.position
        last = acceleration(complex(x, y), speed + 0.5 * duration * last)
        speed += duration * last
        body.velocity = speed.real, speed.imag
        move(duration)

    return step
