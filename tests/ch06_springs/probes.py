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
from ch06_springs import spring_bridge
from ch06_springs.penalty import PenaltyGround
from ch06_springs.springs import (
    AnchoredSpring,
    Buoyancy,
    FakeStiffSpring,
    HomingBullet,
    LighterThanAir,
    Overcrowding,
    connect,
)

Components = tuple[float, float, float]


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


def places_of(particle: Particle, generator: Any, duration: float, frames: int) -> list[Components]:
    """Let one generator act on a particle; return its place at the start and after each frame."""
    places = [xyz(particle.position)]
    for _ in range(frames):
        generator.update_force(particle, duration)
        particle.integrate(duration)
        places.append(xyz(particle.position))
    return places


def advance(registry: ForceRegistry, particles: Sequence[Particle], duration: float) -> None:
    """Let a frame pass for all particles, by the book's step."""
    registry.update_forces(duration)
    for particle in particles:
        particle.integrate(duration)


def swinging(
    start: Components, stiffness: float, mass: float, duration: float, frames: int
) -> float:
    """Swing on an AnchoredSpring of rest length 0; return the period."""
    particle = Particle(Vector3(*start), mass=mass)
    places = places_of(particle, AnchoredSpring(Vector3(), stiffness, 0.0), duration, frames)
    return period_of([sum(place) for place in places], duration)


def pair_swinging(
    mass_a: float,
    mass_b: float,
    stiffness: float,
    rest: float,
    length: float,
    duration: float,
    frames: int,
) -> float:
    """Let two particles swing on a connection; return the period."""
    a, b = Particle(mass=mass_a), Particle(Vector3(0.0, 0.0, length), mass=mass_b)
    registry = ForceRegistry()
    connect(registry, a, b, stiffness, rest)
    extensions = []
    for _ in range(frames):
        extensions.append((b.position - a.position).magnitude() - rest)
        advance(registry, (a, b), duration)
    return period_of(extensions, duration)


def network(
    bodies: Sequence[tuple[Components, Components, float]],
    stiffness: float,
    rest: float,
    damping: float,
    duration: float,
    frames: int,
) -> tuple[list[float], float]:
    """Connect each of these particles to each; return the sum of their momenta in the end.

    And how far the first one is from where it would be without springs.
    """
    particles = [Particle(Vector3(*p), Vector3(*v), mass=m) for p, v, m in bodies]
    registry = ForceRegistry()
    for a, b in combinations(particles, 2):
        connect(registry, a, b, stiffness, rest, damping)
    for _ in range(frames):
        advance(registry, particles, duration)
    momenta = [xyz(p.velocity * p.mass) for p in particles]
    place, velocity, _ = bodies[0]
    free = [x + v * duration * frames for x, v in zip(place, velocity, strict=True)]
    away = math.dist(xyz(particles[0].position), free)
    return [math.fsum(m[i] for m in momenta) for i in range(3)], away


def bobbing(
    max_depth: float,
    volume: float,
    mass: float,
    gravity: float,
    start: float,
    duration: float,
    frames: int,
) -> float:
    """Let a body that is half as dense as water bob at its surface, y = 0; return the period."""
    particle = Particle(
        Vector3(0.0, start, 0.0), acceleration=Vector3(0.0, -gravity, 0.0), mass=mass
    )
    lift = Buoyancy(max_depth, volume, 0.0, gravity=gravity)
    places = places_of(particle, lift, duration, frames)
    return period_of([y for _, y, _ in places], duration)


def risen(
    max_lift: float,
    scale_height: float,
    mass: float,
    damping: float,
    gravity: float,
    duration: float,
    frames: int,
) -> float:
    """Let a balloon rise from the ground; return its height in the end."""
    particle = Particle(acceleration=Vector3(0.0, -gravity, 0.0), mass=mass, damping=damping)
    return places_of(particle, LighterThanAir(max_lift, scale_height), duration, frames)[-1][1]


def crowded(
    places: Sequence[Components],
    distance: float,
    stiffness: float,
    damping: float,
    duration: float,
    frames: int,
) -> tuple[float, list[float]]:
    """Let a crowd move apart; return the smallest distance in the end, and the sum of momenta."""
    particles = [Particle(Vector3(*place), damping=damping) for place in places]
    registry = ForceRegistry()
    for particle in particles:
        registry.add(particle, Overcrowding(particles, distance, stiffness))
    for _ in range(frames):
        advance(registry, particles, duration)
    ends = [xyz(particle.position) for particle in particles]
    momenta = [xyz(particle.velocity) for particle in particles]
    nearest = min((math.dist(a, b) for a, b in combinations(ends, 2)), default=math.nan)
    return nearest, [math.fsum(m[i] for m in momenta) for i in range(3)]


def chased(
    start: Components,
    velocity: Components,
    stiffness: float,
    look_ahead: float,
    duration: float,
    frames: int,
) -> list[float]:
    """Chase a target that flies straight on; return the distance at the start and every frame."""
    bullet, target = Particle(), Particle(Vector3(*start), Vector3(*velocity))
    homing = HomingBullet(target, stiffness, look_ahead)
    distances = []
    for _ in range(frames + 1):
        distances.append(math.dist(xyz(bullet.position), xyz(target.position)))
        homing.update_force(bullet, duration)
        bullet.integrate(duration)
        target.integrate(duration)
    return distances


def faked(
    anchor: Components,
    place: Components,
    velocity: Components,
    stiffness: float,
    damping: float,
    mass: float,
    duration: float,
    frames: int,
) -> list[Components]:
    """Step a faked spring by semi-implicit Euler, made here; return the place after each frame."""
    particle = Particle(Vector3(*place), Vector3(*velocity), mass=mass)
    spring = FakeStiffSpring(Vector3(*anchor), stiffness, damping)
    ends = []
    for _ in range(frames):
        spring.update_force(particle, duration)
        force = particle.force_accumulator
        particle.clear_forces()
        particle.velocity.add_scaled(force, duration / mass)
        particle.position.add_scaled(particle.velocity, duration)
        ends.append(xyz(particle.position))
    return ends


def on_penalty_ground(
    stiffness: float, damping: float, mass: float, fall: float, duration: float, frames: int
) -> tuple[float, float]:
    """Let a body fall on the ground by semi-implicit Euler; return its last and lowest height."""
    particle = Particle(Vector3(0.0, fall, 0.0), mass=mass)
    ground = PenaltyGround(0.0, stiffness, damping)
    lowest = fall
    for _ in range(frames):
        particle.clear_forces()
        ground.update_force(particle, duration)
        acceleration = particle.force_accumulator * (1.0 / mass) + Vector3(0.0, -10.0, 0.0)
        particle.velocity.add_scaled(acceleration, duration)
        particle.position.add_scaled(particle.velocity, duration)
        lowest = min(lowest, particle.position.y)
    return particle.position.y, lowest


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
    registry.add(alone, AnchoredSpring(Vector3(), 1.0, 0.0))
    spring_bridge.hang_bridge(registry, planks, *numbers)
    for plank, (place, velocity) in zip(planks, moved, strict=True):
        plank.position, plank.velocity = Vector3(*place), Vector3(*velocity)
    registry.update_forces(0.5)
    return [xyz(particle.force_accumulator) for particle in (*planks, alone)]


def planks_of_a_new_bridge(
    places: Sequence[Components], numbers: tuple[float, float, float]
) -> list[Components]:
    """Hang a bridge with (height, stiffness, damping); return where its planks are then."""
    planks = [Particle(Vector3(*place)) for place in places]
    spring_bridge.hang_bridge(ForceRegistry(), planks, *numbers)
    return [xyz(plank.position) for plank in planks]


def settled_bridge(
    places: Sequence[Components],
    numbers: tuple[float, float, float],
    mass: float,
    load: tuple[float, float],
    frames: int,
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
