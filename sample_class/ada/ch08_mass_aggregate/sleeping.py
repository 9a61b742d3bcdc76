"""Going further: what lies still falls asleep, and costs next to nothing until something wakes it.

A particle that sleeps is immovable: that is what the whole engine leaves alone already. The world
keeps its inverse mass, and gives it back.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactGenerator
from ch08_mass_aggregate.joints import Pair, joined, touching
from ch08_mass_aggregate.world import ParticleWorld

LOOK_EVERY = 10  # frames: how often the generators of what sleeps are asked
SAME = 0.01  # of what accelerates it: a change by less wakes nothing


@dataclass(frozen=True)
class Sleep:
    """What a particle is given back when it wakes, and what must stay the same until then."""

    inverse_mass: float  # 1/kg
    place: tuple[float, float, float]  # m
    acceleration: Vector3  # m/s^2, with that of its forces
    neighbors: tuple[Particle, ...]  # what it touched, or was joined to


class SleepingWorld(ParticleWorld):
    """A ParticleWorld whose particles fall asleep when they, and all that they touch, are slow."""

    def __init__(
        self,
        particles: Iterable[Particle] = (),
        contact_generators: Iterable[ContactGenerator] = (),
        *,
        iterations: int | None = None,
        integrator: Integrator = semi_implicit_euler,
        sleep_energy: float = 1e-2,
        sleep_frames: int = 30,
    ) -> None:
        super().__init__(
            particles, contact_generators, iterations=iterations, integrator=integrator
        )
        self.sleep_energy = not_negative("sleep_energy", sleep_energy)
        if not isinstance(sleep_frames, int) or isinstance(sleep_frames, bool):
            raise TypeError(f"sleep_frames must be a whole number, got {sleep_frames!r}")
        if sleep_frames < 1:
            raise ValueError(f"sleep_frames must be 1 or more, got {sleep_frames!r}")
        self.sleep_frames = sleep_frames
        self.asleep: dict[Particle, Sleep] = {}
        self._slow: dict[Particle, int] = {}  # for how many frames each has been slow
        self._touched: dict[Pair, int] = {}  # in which frame two were last in contact
        self._frame = 0

    def wake(self, particle: Particle) -> None:
        known = {one: list(sleep.neighbors) for one, sleep in self.asleep.items()}
        for one in _reach(particle, known):
            self._slow.pop(one, None)
            sleep = self.asleep.pop(one, None)
            if sleep is not None and not one.inverse_mass:
                one.inverse_mass = sleep.inverse_mass

    def wake_moved(self) -> None:
        for particle in [one for one, sleep in self.asleep.items() if _moved(one, sleep)]:
            self.wake(particle)  # which may have been woken with another one by now

    def wake_pushed(self, duration: float) -> None:
        pushes: dict[Particle, Vector3] = {}
        for one, sleep in self.asleep.items():
            one.inverse_mass = sleep.inverse_mass
        for particle, generator in self.registry.pairs():
            if particle in self.asleep:
                generator.update_force(particle, duration)
        for one in self.asleep:
            pushes[one] = one.force_accumulator * one.inverse_mass
            one.clear_forces()
            one.inverse_mass = 0.0
        for one, push in pushes.items():
            if one not in self.asleep:  # another one of its group has woken it
                continue
            then = self.asleep[one].acceleration
            scale = max(abs(one.acceleration.magnitude()) + push.magnitude(), then.magnitude())
            if (one.acceleration + push - then).magnitude() > SAME * scale:
                self.wake(one)

    def wake_touched(self, contacts: Iterable[Contact]) -> bool:
        pairs = _pairs(contacts)
        woken = False
        again = True
        while again:
            again = False
            for a, b in pairs:
                for sleeper, other in ((a, b), (b, a)):
                    if sleeper in self.asleep and other.inverse_mass:
                        self.wake(sleeper)
                        woken = again = True
        return woken

    def fall_asleep(self, contacts: Iterable[Contact]) -> None:
        neighbors: dict[Particle, list[Particle]] = {}
        for pair in touching(contacts):
            self._touched[pair] = self._frame
        for pair in [pair for pair, last in self._touched.items()]:
            if self._frame - self._touched[pair] >= self.sleep_frames:
                del self._touched[pair]
        for a, b in [*self._touched, *joined(self.registry)]:
            neighbors.setdefault(a, []).append(b)
            neighbors.setdefault(b, []).append(a)
        for one in self.particles:
            if one.inverse_mass and one.kinetic_energy() * one.inverse_mass <= self.sleep_energy:
                self._slow[one] = self._slow.get(one, 0) + 1
            else:
                self._slow.pop(one, None)
        seen: set[Particle] = set()
        for one in self.particles:
            if one in seen or one not in self._slow:
                continue
            group = _reach(one, neighbors)
            seen |= group
            if all(self._slow.get(member, 0) >= self.sleep_frames for member in group):
                for member in group:
                    del self._slow[member]
                    touched = tuple(neighbors.get(member, ()))
                    last = member.last_acceleration
                    self.asleep[member] = Sleep(member.inverse_mass, _place(member), last, touched)
                    member.velocity.clear()
                    member.inverse_mass = 0.0

    def run_physics(self, duration: float) -> None:
        positive("duration", duration)
        self._frame += 1
        self.wake_moved()
        if self._frame % LOOK_EVERY == 0:
            self.wake_pushed(duration)
        awake = [one for one in self.particles if one not in self.asleep]
        self.integrator(awake, self.registry.update_forces, duration)
        touching = self.contacts()
        while self.wake_touched(touching):
            touching = self.contacts()
        if touching:
            self.resolver.resolve_contacts(touching, duration)
        self.fall_asleep(touching)


def _place(particle: Particle) -> tuple[float, float, float]:
    """Return where a particle is."""
    place = particle.position
    return place.x, place.y, place.z


def _moved(particle: Particle, sleep: Sleep) -> bool:
    """Say whether something has been done to a sleeping particle by hand."""
    still = Vector3()
    return (
        particle.inverse_mass != 0.0
        or particle.velocity != still
        or particle.force_accumulator != still
        or _place(particle) != sleep.place
    )


def _pairs(contacts: Iterable[Contact]) -> list[tuple[Particle, Particle]]:
    """Return the particles of those contacts that have two."""
    return [(one.particle, one.other) for one in contacts if one.other is not None]


def _reach(start: Particle, neighbors: dict[Particle, list[Particle]]) -> set[Particle]:
    """Return a particle with all that it touches, directly or through others."""
    group, waiting = {start}, [start]
    while waiting:
        for other in neighbors.get(waiting.pop(), ()):
            if other not in group:
                group.add(other)
                waiting.append(other)
    return group
