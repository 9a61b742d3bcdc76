"""Models that know that nothing moves: all bodies sleep, in our engine and in pymunk."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ch05_forces.particle import Particle
from ch08_mass_aggregate.sleeping import SleepingWorld
from scenes.setup import Setup
from scenes.twin import InSpace
from studies.accuracy.in_pymunk import in_turn
from studies.accuracy.scene import Model, Outcome, Place, in_frames, places_of


def put_to_sleep(
    make: Callable[[], Setup], fixed: int = 0
) -> tuple[SleepingWorld, Sequence[Particle]]:
    """Create a world in which all particles sleep, and list all but the first ``fixed`` ones."""
    setup = make()
    world = SleepingWorld(setup.particles, setup.contacts, sleep_frames=1)
    world.fall_asleep(world.contacts())
    return world, setup.particles[fixed:]


def asleep(
    make: Callable[[], tuple[SleepingWorld, Sequence[Particle]]], frames: int, name: str = "asleep"
) -> Model:
    """Create a model from a world in which all particles sleep, and those to be compared."""

    def run(_: int) -> Outcome:
        world, particles = make()
        place = kept_while(lambda: particles[0] in world.asleep, lambda: places_of(particles))
        return Outcome(in_frames(world.step, place, frames, 1), 0)

    return Model(name, run, (1,), is_formula=True)


def asleep_in_pymunk(make: Callable[[], InSpace], frames: int) -> Model:
    """Create a model in which all bodies sleep in pymunk from the start."""

    def run(_: int) -> Outcome:
        space, bodies = make()
        space.sleep_time_threshold = 1.0  # s; without a limit, no body may sleep
        for body in bodies:
            body.sleep()
        # pymunk.batch leaves sleeping bodies out
        place = kept_while(lambda: bodies[0].is_sleeping, lambda: in_turn(bodies))
        places = in_frames(space.step, place, frames, 1)
        for body in bodies:
            body.activate()  # pymunk 7.3 crashes when it deletes bodies that sleep
        return Outcome(places, 0)

    return Model("pymunk, asleep", run, (1,), "pymunk", is_formula=True)


def kept_while(sleeps: Callable[[], bool], place: Callable[[], Place]) -> Callable[[], Place]:
    """Return a function that reads the positions of sleeping bodies only once."""
    kept: Place = ()

    def read() -> Place:
        nonlocal kept
        if not (kept and sleeps()):
            kept = place()
        return kept

    return read
