"""Ada lets things sleep."""

from collections import defaultdict
from dataclasses import dataclass

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch08_mass_aggregate.joints import joined, touching
from ch08_mass_aggregate.world import ParticleWorld

LOOK_EVERY = 10
SLEEP_ENERGY = 0.015
SAME = 0.01


@dataclass(frozen=True)
class Sleep:
    inverse_mass: float
    place: tuple[float, float, float]
    acceleration: Vector3
    neighbours: tuple[Particle, ...]


class SleepingWorld(ParticleWorld):
    def __init__(
        self,
        particles=(),
        contact_generators=(),
        *,
        iterations=None,
        integrator=semi_implicit_euler,
        sleep_energy=SLEEP_ENERGY,
        sleep_frames=30,
    ):
        super().__init__(
            particles, contact_generators, iterations=iterations, integrator=integrator
        )
        self.sleep_energy = not_negative("sleep_energy", sleep_energy)
        if not isinstance(sleep_frames, int) or isinstance(sleep_frames, bool):
            raise TypeError(f"sleep_frames must be a whole number, got {sleep_frames!r}")
        if sleep_frames < 1:
            raise ValueError(f"sleep_frames must be 1 or more, got {sleep_frames!r}")
        self.sleep_frames = sleep_frames
        self.asleep = {}
        self._slow = {}
        self._touched = {}
        self._frame = 0

    def wake(self, particle):
        self._slow.pop(particle, None)
        calls = [particle]
        while calls:
            p = calls.pop()
            sleep = self.asleep.pop(p, None)
            if sleep is None:
                continue
            if not p.has_finite_mass:
                p.inverse_mass = sleep.inverse_mass
            calls += sleep.neighbours

    def wake_moved(self):
        for p, sleep in [*self.asleep.items()]:
            still = not any(p.velocity) and not any(p.force_accumulator)
            if not still or p.has_finite_mass or tuple(p.position) != sleep.place:
                self.wake(p)

    def wake_pushed(self, duration):
        pushes = [pair for pair in self.registry.pairs() if pair[0] in self.asleep]
        # some springs pull at both ends; who is awake must not notice
        others = [(p, p.force_accumulator) for p in self.particles if p not in self.asleep]
        for p, sleep in self.asleep.items():
            p.inverse_mass = sleep.inverse_mass
        try:
            for p, generator in pushes:
                generator.update_force(p, duration)
            pushed = [p for p, sleep in self.asleep.items() if is_pushed(p, sleep)]
        finally:
            for p in self.asleep:
                p.inverse_mass = 0.0
                p.clear_forces()
            for p, force in others:
                p.clear_forces()
                p.add_force(force)
        for p in pushed:
            self.wake(p)

    def wake_touched(self, contacts):
        touched = []
        for c in contacts:
            if c.other is None:
                continue
            for one, other in (c.particle, c.other), (c.other, c.particle):
                if one in self.asleep and other.has_finite_mass:
                    touched.append(one)
        for p in touched:
            self.wake(p)
        return bool(touched)

    def fall_asleep(self, contacts):
        self._frame += 1
        for pair in touching(contacts):
            self._touched[pair] = self._frame
        oldest = self._frame - self.sleep_frames
        self._touched = {pair: n for pair, n in self._touched.items() if n > oldest}

        friends = defaultdict(list)
        for a, b in [*self._touched, *joined(self.registry)]:
            if a.has_finite_mass and b.has_finite_mass:
                friends[a].append(b)
                friends[b].append(a)

        movable = [p for p in self.particles if p.has_finite_mass]
        self._slow = {
            p: self._slow.get(p, 0) + 1
            for p in movable
            if p.velocity.squared_magnitude() / 2 <= self.sleep_energy
        }
        tired = {p for p, n in self._slow.items() if n >= self.sleep_frames}

        # whoever is restless keeps the friends awake, and they theirs
        restless = [p for p in [*movable, *friends] if p not in tired]
        while restless:
            for friend in friends.get(restless.pop(), ()):
                if friend in tired:
                    tired.remove(friend)
                    restless.append(friend)

        for p in movable:
            if p in tired:
                self.asleep[p] = Sleep(
                    p.inverse_mass,
                    tuple(p.position),
                    p.last_acceleration,
                    tuple(friends.get(p, ())),
                )
        for p in tired:
            del self._slow[p]
            p.velocity.clear()
            p.inverse_mass = 0.0

    def run_physics(self, duration):
        h = positive("duration", duration)
        self.wake_moved()
        if self._frame % LOOK_EVERY == 0:
            self.wake_pushed(h)
        awake = [p for p in self.particles if p not in self.asleep]
        self.integrator(awake, self.registry.update_forces, h)
        found = self.contacts()
        while self.wake_touched(found):
            found = self.contacts()
        if found:
            self.resolver.resolve_contacts(found, h)
        self.fall_asleep(found)


def is_pushed(particle, sleep):
    by_forces = particle.force_accumulator * particle.inverse_mass
    constant = particle.acceleration
    change = constant + by_forces - sleep.acceleration
    what_acts = constant.magnitude() + by_forces.magnitude()
    return change.magnitude() > SAME * max(what_acts, sleep.acceleration.magnitude())
