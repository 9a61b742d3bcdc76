"""Sleeping worlds in which little happens, told as numbers; it runs beside the student."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.probes import xyz
from ch08_mass_aggregate.sleep_probes import FRAME, Push, Touch, Wall, asleep, down
from ch08_mass_aggregate.sleeping import SleepingWorld


def parted(touching: int, frames: int, fast: int = 0) -> list[list[int]]:
    """Let a slow particle touch a fast one for some frames; return who sleeps after each frame.

    In one frame, counted from 1, it is fast itself.
    """
    particles = [Particle(), Particle(Vector3(9.0), Vector3(0.0, 0.0, 9.0))]
    touch = Touch(particles, [(0, 1)])
    world = SleepingWorld(particles, [touch], sleep_energy=0.5, sleep_frames=5)
    seen = []
    for i in range(frames):
        if i == touching:
            touch.pairs = []
        particles[0].velocity.z = 9.0 if i == fast - 1 else 0.0
        world.step(FRAME)
        seen.append(asleep(world, particles))
    return seen


def made_immovable(late: int, frames: int) -> list[list[int]]:
    """Let two particles that lie still touch, until one becomes immovable.

    Return who sleeps after each frame.
    """
    particles = [Particle(), Particle(Vector3(9.0))]
    touch = Touch(particles, [(0, 1)])
    world = SleepingWorld(particles, [touch], sleep_energy=0.5, sleep_frames=5)
    seen = []
    for i in range(frames):
        if i == late:
            particles[1].mass = math.inf
        world.step(FRAME)
        seen.append(asleep(world, particles))
    return seen


def group_woken(pairs: Sequence[tuple[int, int]], first: int) -> tuple[list[int], list[int]]:
    """Let five particles of which some touch fall asleep, in a frame in which none touches.

    Then one gets a velocity. Return who sleeps before, and after a frame.
    """
    particles = [Particle(Vector3(3.0 * i)) for i in range(5)]
    touch = Touch(particles, pairs)
    world = SleepingWorld(particles, [touch], sleep_frames=5)
    for i in range(6):
        if i == 4:
            touch.pairs = []
        world.step(FRAME)
    before = asleep(world, particles)
    particles[first].velocity.z = 1.0
    world.step(FRAME)
    return before, asleep(world, particles)


def touched_gently(order: tuple[int, int]) -> list[list[int]]:
    """Let a particle sleep, and another one that lies still touch it.

    Return who sleeps before, and after a frame.
    """
    particles = [Particle(Vector3(3.0 * i)) for i in range(2)]
    touch = Touch(particles, [])
    world = SleepingWorld(particles[:1], [touch], sleep_frames=3)
    for _ in range(5):
        world.step(FRAME)
    before = asleep(world, particles)
    world.particles.append(particles[1])
    touch.pairs = [order]
    world.step(FRAME)
    return [before, asleep(world, particles)]


def woken_by_little(how: str, axis: str, by: float) -> tuple[list[int], list[int]]:
    """Let three particles fall asleep on the ground, and do a little to the last two.

    Return who sleeps before, and after a frame.
    """
    made = [Particle(Vector3(3.0 * i), acceleration=down(), mass=2.0) for i in range(3)]
    world = SleepingWorld(made, [GroundPlane(made)], sleep_frames=3)
    for _ in range(5):
        world.step(FRAME)
    before = asleep(world, made)
    world.start_frame()
    for particle in made[1:]:
        if how == "force":
            particle.add_force(Vector3(**{axis: by}))
        else:
            vector = particle.velocity if how == "velocity" else particle.position
            setattr(vector, axis, getattr(vector, axis) + by)
    world.run_physics(FRAME)
    return before, asleep(world, made)


def pushed(x: float, y: float) -> dict[str, Any]:
    """Let a particle of 2 kg sleep at a wall under two forces, 3 and 2 N/kg; then change one by.

    Return who sleeps before, and what its accumulator holds after a frame of looking; its velocity
    after the frame in which it wakes, if it does in 10, and the durations that were told.
    """
    particle = Particle(mass=2.0)
    world = SleepingWorld([particle], [Wall(particle)], sleep_energy=1e-4, sleep_frames=3)
    pushes = [Push(3.0), Push(2.0)]
    for push in pushes:
        world.registry.add(particle, push)
    sums = set()
    for i in range(40):
        world.step(FRAME)
        if i > 15:
            sums.add(xyz(particle.force_accumulator))
    told: dict[str, Any] = {"before": asleep(world, [particle]), "sums": sorted(sums)}
    pushes[1].x += x
    pushes[1].y += y
    told["velocity"] = None
    for _ in range(10):
        world.step(FRAME)
        if not world.asleep:
            told["velocity"] = xyz(particle.velocity)
            break
    return told | {"durations": sorted(pushes[0].durations)}
