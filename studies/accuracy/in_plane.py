"""Models that step the equations of a scene as complex numbers, with methods of high order."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from scenes.clock import RATE
from scenes.setup import Setup
from studies.accuracy.scene import TOLERANCES, Model, Outcome, Place, by_integrators
from studies.models.long_steps import in_long_steps
from studies.models.multistep import LoneMultistep, Multistep
from studies.models.order_8 import Acceleration, Accelerations, Order8

LONG = 12  # frames; the number of steps is given per this many frames
LONG_STEPS = (2, 3, 4, 6, *(LONG * 2**n for n in range(13)))
ORDERS = (4, 6, 8)


def flat(positions: Sequence[complex]) -> Place:
    """List the coordinates of all bodies in one tuple: x1, y1, x2, y2 and so on."""
    if len(positions) == 1:
        return positions[0].real, positions[0].imag
    return tuple([part for z in positions for part in (z.real, z.imag)])


def in_plane(
    positions: Sequence[complex],
    velocities: Sequence[complex],
    accelerations: Accelerations,
    frames: int,
    *,
    is_damped: bool,
    place: Callable[[Sequence[complex]], Place] = flat,
    units: int = 0,
) -> list[Model]:
    """Create the models of high order for a scene.

    ``is_damped`` says whether the accelerations depend on the velocities. An evaluation counts as
    ``units`` of work, or as one for each body.
    """
    units = units or len(positions)
    kind = LoneMultistep if len(positions) == 1 else Multistep

    def by_multistep(order: int, steps: int) -> Outcome:
        # The curve between two long steps needs velocities.
        damped, length = is_damped or steps < LONG, LONG / (steps * RATE)
        bodies = kind(positions, velocities, accelerations, length, order, is_damped=damped)
        if steps < LONG:
            places = in_long_steps(
                lambda: bodies.run(1, 1),
                lambda: ([*bodies.positions], [*bodies.velocities]),
                place,
                LONG // steps,
                frames,
            )
        else:
            places = [*map(place, bodies.run(steps // LONG, frames))]
        return Outcome(places, bodies.evaluations * units)

    def by_tolerance(inverse: int) -> Outcome:
        bodies = Order8(positions, velocities, accelerations)
        places = bodies.positions_at(1.0 / RATE, frames, 1.0 / inverse)
        return Outcome([*map(place, places)], bodies.evaluations * units)

    models = [
        Model(f"multistep, order {order}", partial(by_multistep, order), LONG_STEPS, per=LONG)
        for order in ORDERS
    ]
    return [*models, Model("order 8, own steps", by_tolerance, TOLERANCES, takes_tolerance=True)]


def stepped(
    make: Callable[[], Setup], acceleration: Acceleration, frames: int, *, is_damped: bool
) -> list[Model]:
    """Create our models that step the equations of motion of a body."""
    (body,) = make().particles
    place, velocity = (complex(v.x, v.y) for v in (body.position, body.velocity))
    return [
        *by_integrators(make, frames),
        *in_plane([place], [velocity], on_all(acceleration), frames, is_damped=is_damped),
    ]


def on_all(acceleration: Acceleration) -> Accelerations:
    """Turn the acceleration of one body into a function that takes and returns lists."""
    return lambda positions, velocities: [acceleration(positions[0], velocities[0])]
