"""Models that step the equations of a scene as complex numbers, with methods of high order.

They read the scene's equations from one function, from positions and velocities to accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from studies.accuracy.scene import RATE, TOLERANCES, Model, Outcome, Place
from studies.models.multistep import LoneMultistep, Multistep
from studies.models.order_8 import Accelerations, Numbers, Order8
from studies.models.smooth_net import hermite

LONG = 12  # frames; the number of steps is given per this many frames
LONG_STEPS = (2, 3, 4, 6, *(LONG * 2**n for n in range(13)))
ORDERS = (4, 6, 8)


def in_plane(
    positions: Sequence[complex],
    velocities: Sequence[complex],
    accelerations: Accelerations,
    frames: int,
    *,
    is_damped: bool,
) -> list[Model]:
    """Create the models of high order for a scene, whose frames must be a multiple of twelve.

    ``is_damped`` says whether the accelerations depend on the velocities.
    """
    kind = LoneMultistep if len(positions) == 1 else Multistep

    def by_multistep(order: int, steps: int) -> Outcome:
        duration = LONG / (steps * RATE)
        bodies = kind(
            positions, velocities, accelerations, duration, order, is_damped=is_damped or steps < LONG
        )
        places = []
        if steps >= LONG:
            for _ in range(frames):
                bodies.run(steps // LONG)
                places.append(flat(bodies.positions))
            return Outcome(places, bodies.evaluations * len(positions))
        every = LONG // steps
        for _ in range(-(-frames // every)):
            old, fast = [*bodies.positions], [*bodies.velocities]
            bodies.run(1)
            new, later = bodies.positions, bodies.velocities
            for frame in range(1, every):
                places.append(flat(hermite(old, fast, new, later, duration, frame / every)))
            places.append(flat(new))
        return Outcome(places[:frames], bodies.evaluations * len(positions))

    def by_tolerance(inverse: int) -> Outcome:
        bodies = Order8(positions, velocities, accelerations)
        places = bodies.positions_at(1.0 / RATE, frames, 1.0 / inverse)
        return Outcome([*map(flat, places)], bodies.evaluations * len(positions))

    return [
        *(
            Model(f"multistep, order {order}", partial(by_multistep, order), LONG_STEPS, per=LONG)
            for order in ORDERS
        ),
        Model("order 8, own steps", by_tolerance, TOLERANCES, takes_tolerance=True),
    ]


def flat(positions: Sequence[complex]) -> Place:
    """List the coordinates of all bodies in one flat tuple: x1, y1, x2, y2 and so on."""
    if len(positions) == 1:
        return positions[0].real, positions[0].imag
    return tuple([part for z in positions for part in (z.real, z.imag)])


def on_all(acceleration: Callable[[complex, complex], complex]) -> Accelerations:
    """Return a function for a list with one body, from that for the body itself."""
    return lambda positions, velocities: [acceleration(positions[0], velocities[0])]
