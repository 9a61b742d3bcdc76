"""Code that runs in the student's process: loops of steps, and generators that record their calls.

Each function takes and returns plain numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Airbrake, ForceRegistry
from ch05_forces.particle import Particle
from ch05_forces.sniper import SniperRange

Components = tuple[float, float, float]
State = tuple[Components, Components]
Call = tuple[int, int, float]


def xyz(v: Vector3) -> Components:
    return v.x, v.y, v.z


def march(particle: Particle, generator: Any, duration: float, steps: int) -> State:
    """Move a particle on which one generator acts, if there is one."""
    for _ in range(steps):
        if generator is not None:
            generator.update_force(particle, duration)
        particle.integrate(duration)
    return xyz(particle.position), xyz(particle.velocity)


class Push:
    """A generator of a constant force."""

    def __init__(self, force: Components) -> None:
        self.force = Vector3(*force)

    def update_force(self, particle: Particle, duration: float) -> None:
        particle.add_force(self.force)


class RecordingGenerator:
    """A generator that records its calls."""

    def __init__(self, index: int, calls: list[Call], particles: Sequence[Particle]) -> None:
        self.index = index
        self.calls = calls
        self.particles = particles

    def update_force(self, particle: Particle, duration: float) -> None:
        for i, known in enumerate(self.particles):
            if known is particle:
                self.calls.append((i, self.index, duration))
                return
        raise ValueError(f"update_force takes the particle before the duration, got {particle!r}")


class EqualGenerator(RecordingGenerator):
    """A recorder that equals all others under ==."""

    def __eq__(self, other: object) -> bool:
        return True

    __hash__ = None  # type: ignore[assignment]


def paired(particle: int, generator: int) -> list[list[str]]:
    """Add one pair to a registry, and return the names of what its pairs() returns."""
    particles = [Particle(mass=2.0) for _ in range(3)]
    recorders = [RecordingGenerator(i, [], particles) for i in range(3)]
    names = {id(one): f"p{i}" for i, one in enumerate(particles)}
    names |= {id(one): f"g{i}" for i, one in enumerate(recorders)}
    registry = ForceRegistry()
    registry.add(particles[particle], recorders[generator])
    return [[names.get(id(one), type(one).__name__) for one in pair] for pair in registry.pairs()]


def asked(immovable: Sequence[int], acts: Sequence[tuple], alike: bool = True) -> list[Call]:
    """Carry out ``acts`` on a registry of three particles and three generators.

    An act is ("add", 0, 2), ("remove", 0, 2), ("clear",), ("update", 0.5), or ("free", 0), which
    makes a particle movable. If ``alike`` is True, all generators are equal under ==.

    Returns:
        The particle, the generator and the duration of each call of update_force.
    """
    calls: list[Call] = []
    particles = [Particle(mass=2.0) for _ in range(3)]
    recorders = [
        (EqualGenerator if alike else RecordingGenerator)(i, calls, particles) for i in range(3)
    ]
    for i in immovable:
        particles[i].inverse_mass = 0.0
    registry = ForceRegistry()
    for name, *numbers in acts:
        if name in ("add", "remove"):
            particle, generator = numbers
            getattr(registry, name)(particles[particle], recorders[generator])
        elif name == "clear":
            registry.clear()
        elif name == "update":
            registry.update_forces(*numbers)
        else:
            particles[numbers[0]].inverse_mass = 1.0
    return calls


def asked_while_it_changes(what: str) -> list[int]:
    """Update twice while the first of three generators changes the registry.

    It removes or adds itself, removes the second, or clears the registry.

    Returns:
        The number of generator calls in each update.
    """
    counts = [0]
    particle = Particle()
    registry = ForceRegistry()

    class Counter:
        def update_force(self, particle: Particle, duration: float) -> None:
            counts[-1] += 1

    class Changing(Counter):
        def update_force(self, particle: Particle, duration: float) -> None:
            super().update_force(particle, duration)
            if what == "clear":
                registry.clear()
            elif what == "remove the second":
                registry.remove(particle, second)
            else:
                getattr(registry, what)(particle, self)

    second = Counter()
    for generator in (Changing(), second, Counter()):
        registry.add(particle, generator)
    registry.update_forces(0.5)
    counts.append(0)
    registry.update_forces(0.5)
    return counts


def braked(seed: int, tries: int) -> list[float]:
    """Brake particles for one step each with k above m / h.

    Each particle moves along X and has its own k, mass, speed and h.

    Returns:
        The fraction of each speed that is left.
    """
    rng = Random(seed)
    shares = []
    for _ in range(tries):
        mass, duration = 10.0 ** rng.uniform(-3.0, 3.0), 10.0 ** rng.uniform(-4.0, 1.0)
        speed = rng.choice((-1.0, 1.0)) * 10.0 ** rng.uniform(-6.0, 6.0)
        particle = Particle(velocity=Vector3(speed), mass=mass)
        brake = Airbrake(mass / duration * 10.0 ** rng.uniform(0.01, 9.0))
        brake.on = True
        brake.update_force(particle, duration)
        particle.integrate(duration)
        shares.append(particle.velocity.x / speed)
    return shares


def winds(seeds: Sequence[int], changes: int) -> list[list[Components]]:
    """Change the winds of ranges with these seeds in turn and return the winds of each range."""
    ranges = [SniperRange(seed) for seed in seeds]
    seen = [[xyz(one.wind.velocity)] for one in ranges]
    for _ in range(changes):
        for one, blown in zip(ranges, seen, strict=True):
            one.change_wind()
            blown.append(xyz(one.wind.velocity))
    return seen


def play(
    aims: Sequence[tuple[float, float]],
    duration: float,
    *,
    wind: Components | None = None,
    k1: float = 0.0,
    k2: float = 0.0,
    seed: int = 1,
) -> dict[str, Any]:
    """Fire at these azimuths and elevations in turn. Each shot must land within 8 seconds.

    The first shot flies in the wind ``wind`` if it is given.

    Returns:
        The positions of the bullet in flight and the winds, one per step, the holes as (distance
        of the target, x, y, points), the score, and the number of shots left.
    """
    at = SniperRange(seed)
    at.wind.k1, at.wind.k2 = k1, k2
    if wind is not None:
        at.wind.velocity = Vector3(*wind)
    positions, blown = [], []
    for azimuth, elevation in aims:
        at.shoot(azimuth, elevation)
        for _ in range(round(8.0 / duration)):
            at.update(duration)
            blown.append(xyz(at.wind.velocity))
            if at.bullet is None:
                break
            positions.append(xyz(at.bullet.position))
        else:
            break  # it never lands, and then no other shot can be fired
    holes = [(hole.target.distance, hole.x, hole.y, hole.points) for hole in at.holes]
    return {
        "positions": positions,
        "winds": blown,
        "holes": holes,
        "score": at.score,
        "shots_left": at.shots_left,
    }
