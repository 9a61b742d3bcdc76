"""Going further: particles at rest fall asleep, and cost almost nothing until something wakes them.

The engine already skips immovable particles. So the world makes a particle immovable while it
sleeps: it stores the particle's inverse mass, and restores it when the particle wakes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy

LOOK_EVERY = 10  # steps between two checks of the forces on sleeping particles
# J/kg. A body that loses contact for one step of 1/60 s by rounding falls freely and gets
# (g h)^2 / 2 = 0.0134. It must still count as slow.
SLEEP_ENERGY = 0.015
SAME = 0.01  # a change of the acceleration by this fraction or less wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What the world must know about a sleeping particle to wake it."""

    inverse_mass: float  # 1/kg, which it gets back
    position: Vector3  # m, a copy of the position at which it fell asleep
    acceleration: Vector3  # m/s^2: its last_acceleration, which includes forces
    neighbors: tuple[Particle, ...]  # particles that it touched or was joined to


class SleepingWorld(ParticleWorld):
    """A ParticleWorld in which groups of touching particles fall asleep when they are at rest.

    A step is slow for a particle if its kinetic energy per kg after the step is at most
    ``sleep_energy``, in J/kg. After ``sleep_frames`` slow steps in a row the particle is tired. The
    dict ``asleep`` maps each sleeping particle, whose mass is ``math.inf``, to its ``Sleep``.

    The world cannot detect every change. Call ``wake`` yourself before you make a sleeping particle
    immovable, join something to it, or move the ground or an anchor that supports it.
    """

    def __init__(
        self,
        particles: Iterable[Particle] = (),
        contact_generators: Iterable[ContactGenerator] = (),
        *,
        iterations: int | None = None,
        integrator: Integrator = semi_implicit_euler,
        sleep_energy: float = SLEEP_ENERGY,
        sleep_frames: int = 30,
    ) -> None:
        super().__init__(
            particles, contact_generators, iterations=iterations, integrator=integrator
        )
        self.sleep_energy = not_negative("sleep_energy", sleep_energy)
        self.sleep_frames = whole("sleep_frames", sleep_frames)
        self.asleep: dict[Particle, Sleep] = {}
        self._slow: dict[Particle, int] = {}  # the number of steps for which each has been slow
        self._touched: dict[Pair, int] = {}  # the step in which two were last in contact
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        """Wake ``particle``, its neighbors, their neighbors, and so on.

        Particles that fell asleep together therefore wake together. Each of them gets its mass
        back, unless you have given it another finite mass in the meantime. Its count of slow steps
        starts from 0 again. If ``particle`` was already awake, only its count restarts.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def mechanical_energy(self) -> float:
        """Add up the mechanical energy in J, with the potential energy of sleeping particles."""
        return mechanical_energy(self.particles) - sum(
            one.acceleration.dot(one.position) / sleep.inverse_mass
            for one, sleep in self.asleep.items()
            if not one.inverse_mass
        )

    def wake_moved(self) -> None:
        """Wake every sleeping particle that code outside the world has changed.

        A sleeping particle keeps its position and its infinite mass, has no velocity, and has no
        force in its accumulator. Wake the particle if any of this is no longer true.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_pushed(self, duration: float) -> None:
        """Wake every sleeping particle whose acceleration has changed since it fell asleep.

        Compute a + f / m, where f is the sum of the generators' forces, and compare it with the
        acceleration in ``Sleep``. The particle wakes if the change is more than ``SAME`` times the
        current |a| + |f / m| or the magnitude of the old acceleration, whichever is larger.

        Call only generators that are registered for sleeping particles. Give each sleeping particle
        its original mass meanwhile, because a generator may use it. The accumulators of sleeping
        particles are empty when this method starts, and must be empty again when it returns.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        """Wake every sleeping particle that is in contact with a particle that can move.

        Return True if any particle woke. In that case the caller must find the contacts again.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        """Update the counts of slow steps, and put groups of tired particles to sleep.

        Particles that are connected, directly or through others, form a group. Two are connected if
        they were in contact in one of the last ``sleep_frames`` steps, or if a generator of the
        registry joins them. Immovable particles do not connect groups, and they never sleep.

        A particle is tired if its last ``sleep_frames`` steps were all slow. A group falls asleep
        only when all of its particles are tired. Add each of them to ``asleep``, and set its
        ``velocity`` and ``inverse_mass`` to 0.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")

    def run_physics(self, duration: float) -> None:
        """Move all particles that are awake forward by one time step of ``duration`` s.

        - Count the step in ``_frame``.
        - Wake the particles that code outside the world has changed. Every ``LOOK_EVERY`` steps,
          also wake the particles whose acceleration has changed since they fell asleep.
        - If all particles are asleep, the step is finished.
        - Otherwise, call the integrator with only the particles that are awake.
        - Find the contacts. If a contact wakes a particle, find the contacts again. Repeat this
          until no more particles wake.
        - Resolve the contacts, and then call ``fall_asleep``.
        """
        raise NotImplementedError("Exercise G8.1: Going further: sleep")
