"""What must run beside the student's code: springs in loops of steps.

Each function takes and returns plain numbers. Those for the steps are in step_probes.py.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations, pairwise
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs import penalty, spring_bridge, springs

Components = tuple[float, float, float]
ZERO = (0.0, 0.0, 0.0)


def xyz(v: Vector3) -> Components:
    return v.x, v.y, v.z


def period_of(values: Sequence[float], duration: float) -> float:
    """Return the period in s of a row of values, one a frame; NaN where it does not swing.

    It changes its sign twice a period: between two frames, by a straight line.
    """
    times = [i + a / (a - b) for i, (a, b) in enumerate(pairwise(values)) if a * b < 0.0]
    if len(times) < 3:
        return math.nan
    return 2.0 * (times[-1] - times[0]) / (len(times) - 1) * duration


def places_on(
    kind: str,
    numbers: Sequence[Any],
    start: Sequence[float],
    duration: float,
    frames: int,
    *,
    velocity: Sequence[float] = ZERO,
    gravity: float = 0.0,
    velocity_first: bool = False,
    **body: float,
) -> list[Components]:
    """Let one generator act on a particle; return its place at the start and after each frame.

    ``kind`` is the name of its class, and ``numbers`` are its arguments, with triples for vectors.
    With ``velocity_first``, the steps are those of semi-implicit Euler, made here.
    """
    arguments = [Vector3(*n) if isinstance(n, (tuple, list)) else n for n in numbers]
    generator = getattr(penalty if kind == "PenaltyGround" else springs, kind)(*arguments)
    down = Vector3(0.0, -gravity, 0.0)
    particle = Particle(Vector3(*start), Vector3(*velocity), down, **body)
    places = [xyz(particle.position)]
    for _ in range(frames):
        generator.update_force(particle, duration)
        if velocity_first:
            acceleration = particle.force_accumulator * (1.0 / particle.mass) + down
            particle.clear_forces()
            particle.velocity.add_scaled(acceleration, duration)
            particle.position.add_scaled(particle.velocity, duration)
        else:
            particle.integrate(duration)
        places.append(xyz(particle.position))
    return places


def period_on(*scene: Any, **body: float) -> float:
    """Return the period of places_on, where the particle swings about (0, 0, 0) along one axis."""
    return period_of([sum(place) for place in places_on(*scene, **body)], scene[3])


def advance(registry: ForceRegistry, particles: Sequence[Particle], h: float, frames: int) -> None:
    """Let frames pass for all particles, by the book's step."""
    for _ in range(frames):
        registry.update_forces(h)
        for particle in particles:
            particle.integrate(h)


def momentum_of(particles: Sequence[Particle]) -> list[float]:
    momenta = [xyz(particle.velocity * particle.mass) for particle in particles]
    return [math.fsum(m[i] for m in momenta) for i in range(3)]


def pair_swinging(masses: tuple[float, float], stiffness: float, rest: float) -> float:
    """Stretch a connection to 1.5 times its length, and let it swing for 5 s; return the period."""
    h = 1.0 / 2000.0
    a, b = Particle(mass=masses[0]), Particle(Vector3(0.0, 0.0, 1.5 * rest), mass=masses[1])
    registry = ForceRegistry()
    springs.connect(registry, a, b, stiffness, rest)
    extensions = []
    for _ in range(10_000):
        extensions.append((b.position - a.position).magnitude() - rest)
        advance(registry, (a, b), h, 1)
    return period_of(extensions, h)


def network(
    bodies: Sequence[tuple[Components, Components, float]], numbers: tuple[float, float, float]
) -> tuple[list[float], float]:
    """Connect each of these particles to each, with (stiffness, rest length, damping).

    Return the sum of their momenta after 200 frames, and how far the first one is from where it
    would be without springs.
    """
    particles = [Particle(Vector3(*p), Vector3(*v), mass=m) for p, v, m in bodies]
    registry = ForceRegistry()
    for a, b in combinations(particles, 2):
        springs.connect(registry, a, b, *numbers)
    advance(registry, particles, 1.0 / 240.0, 200)
    place, velocity, _ = bodies[0]
    free = [x + v / 240.0 * 200 for x, v in zip(place, velocity, strict=True)]
    return momentum_of(particles), math.dist(xyz(particles[0].position), free)


def crowded(
    places: Sequence[Components], distance: float, stiffness: float, damping: float
) -> tuple[float, list[float]]:
    """Let a crowd move apart for 10 s; return its smallest distance and its momentum then."""
    particles = [Particle(Vector3(*place), damping=damping) for place in places]
    registry = ForceRegistry()
    for particle in particles:
        registry.add(particle, springs.Overcrowding(particles, distance, stiffness))
    advance(registry, particles, 1.0 / 60.0, 600)
    ends = [xyz(particle.position) for particle in particles]
    nearest = min((math.dist(a, b) for a, b in combinations(ends, 2)), default=math.nan)
    return nearest, momentum_of(particles)


def chased(start: Components, velocity: Components, *numbers: float) -> list[float]:
    """Chase a target that flies straight on for 20 s; return the distances, 240 a second."""
    bullet, target = Particle(), Particle(Vector3(*start), Vector3(*velocity))
    homing = springs.HomingBullet(target, *numbers)
    distances = []
    for _ in range(4801):
        distances.append(math.dist(xyz(bullet.position), xyz(target.position)))
        homing.update_force(bullet, 1.0 / 240.0)
        bullet.integrate(1.0 / 240.0)
        target.integrate(1.0 / 240.0)
    return distances


def hung_bridge(
    places: Sequence[Components],
    moved: Sequence[tuple[Components, Components]],
    numbers: tuple[float, float, float],
) -> list[Components]:
    """Hang a bridge with (height, stiffness, damping), give its planks places and velocities.

    Its third plank is immovable, if it has one. Return the forces on the planks, and that of a
    spring of 1 N/m which the registry had before, 2 m long.
    """
    planks = [Particle(Vector3(*place), mass=2.0) for place in places]
    if len(planks) > 2:
        planks[2].inverse_mass = 0.0
    registry, alone = ForceRegistry(), Particle(Vector3(0.0, 2.0, 0.0))
    registry.add(alone, springs.AnchoredSpring(Vector3(), 1.0, 0.0))
    spring_bridge.hang_bridge(registry, planks, *numbers)
    for plank, (place, velocity) in zip(planks, moved, strict=True):
        plank.position, plank.velocity = Vector3(*place), Vector3(*velocity)
    registry.update_forces(0.5)
    return [xyz(particle.force_accumulator) for particle in (*planks, alone)]


def settled_bridge(
    places: Sequence[Components],
    numbers: tuple[float, float, float],
    mass: float = 2.0,
    load: tuple[float, float] = (0.0, 0.0),
    frames: int = 0,
) -> list[Components]:
    """Hang a bridge, load it with (x, weight) in each frame, return where its planks end."""
    planks = [
        Particle(Vector3(*place), acceleration=Vector3(0.0, -10.0, 0.0), mass=mass, damping=0.1)
        for place in places
    ]
    registry = ForceRegistry()
    spring_bridge.hang_bridge(registry, planks, *numbers)
    h = 1.0 / 60.0
    for _ in range(frames):
        registry.update_forces(h)
        spring_bridge.load_bridge(planks, *load)
        for plank in planks:
            start = plank.position.copy()
            plank.integrate(h)
            plank.position = start + plank.velocity * h
    return [xyz(plank.position) for plank in planks]


def loaded(places: Sequence[Components], x: float, weight: float) -> list[Components]:
    """Load planks at these places; return their forces, with (1, 2, 3) added by hand."""
    planks = [Particle(Vector3(*place)) for place in places]
    for plank in planks:
        plank.add_force(Vector3(1.0, 2.0, 3.0))
    spring_bridge.load_bridge(planks, x, weight)
    return [xyz(plank.force_accumulator) for plank in planks]
