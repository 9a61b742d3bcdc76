"""Find forces with a clock or a memory of their own in a scene of `make choose`.

A method may evaluate the forces several times per step, and for several particles. A force that
adds up the durations of its calls therefore has a wrong clock.
"""

from __future__ import annotations

from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE
from studies.choose.scene import OwnScene, SceneError

CALLS, ALL_CALLS = 600, 20_000  # at most, of each force and of all forces
SAME = 1e-9  # the largest relative difference of two equal forces


def check_forces(scene: OwnScene) -> None:
    """Raise SceneError if a force gives different results although no particle moves.

    A subclass of ParticleWorld may call its forces in its own way, so it is not checked. A force
    that raises an exception passes, because the runs will report it.
    """
    world = scene.built()
    pairs = world.registry.pairs()
    if type(world) is not ParticleWorld or not pairs:
        return
    calls = min(scene.frames, CALLS, max(2, ALL_CALLS // len(pairs)))
    for particle, force in pairs:
        try:
            repeats = _repeats(particle, force, calls)
        except Exception:
            return
        if not repeats:
            raise SceneError(
                f"{scene.path}: {type(force).__name__} gave different forces, although no particle "
                "had moved. A force must not keep its own clock or any other memory, because some "
                "methods evaluate the forces several times per step. Let it read the time from a "
                "clock that is a particle, as in studies/choose/example_driven.py. Draw any random "
                "numbers in build()"
            )


def _repeats(particle: Particle, force: ForceGenerator, calls: int) -> bool:
    """Return True if a generator gives its particle the same force in every call."""
    first: tuple[float, ...] = ()
    for _ in range(calls):
        particle.clear_forces()
        force.update_force(particle, 1.0 / RATE)
        now = tuple(particle.force_accumulator)
        first = first or now
        least = SAME * max(map(abs, first))
        if any(abs(x - y) > least for x, y in zip(first, now, strict=True)):
            return False
    return True
