"""Run the bridge, the platform, the blob and the wheel of chapter 8, and record measurements.

Plots, benchmarks and tests use these simulations. Lengths are in m, masses in kg, times in s, and
energies in J.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from typing import Protocol

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import Detectors, GroundPlane, ParticlePairs
from ch08_mass_aggregate.blob import Blob, spread
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.tilting_platform import TiltingPlatform
from ch08_mass_aggregate.wheel import Wheel, deformation, spin
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from scenes.clock import FRAME
from scenes.links import over_length
from scenes.readings import Numbers, number, numbers, stopped
from scenes.track import Measure, Track, tracks

SPIKE = 0.5  # s, a frame in which the machine was busy with something else
RADIUS = 0.5  # m, of the balls that fall asleep
BALLS = 8
LATE_HEIGHT = 40.0  # m, initial height of the ball that wakes them


class MassAggregate(Protocol):
    """The common interface of the bridge, the platform, the blob and the wheel of chapter 8.

    Each of them has a world of particles, and a method that advances the world by one time step.
    """

    @property
    def world(self) -> ParticleWorld: ...

    def step(self, duration: float) -> None: ...


def loaded_platform() -> TiltingPlatform:
    """Create a platform with a 5 kg weight at x = 3 m, so that it tips to the right."""
    platform = TiltingPlatform()
    platform.put_weight(5.0, 3.0)
    return platform


def energy(aggregate: MassAggregate, rate: int, seconds: float) -> Track:
    """Simulate a mass aggregate, such as the rope bridge, and record its mechanical energy in J."""
    measures = [lambda: mechanical_energy(aggregate.world.particles)]
    return tracks(aggregate.step, measures, round(rate * seconds), 1.0 / rate)[0]


def default_bridge() -> Bridge:
    """Create a rope bridge whose contact resolver makes two iterations per contact, the default."""
    bridge = Bridge()
    bridge.world.resolver.iterations = None
    return bridge


def variation(run: Track, since: float) -> float:
    """Measure how much a recorded value still varies after the time ``since``.

    The result is the range of the values, as a fraction of the last value. It is NaN if the engine
    failed.
    """
    late = [value for time, value in run.points if time >= since]
    if run.message or not late or not late[-1]:
        return math.nan
    return (max(late) - min(late)) / abs(late[-1])


def load_on_bridge(
    mass: float, iterations: int | None, substeps: int, seconds: float
) -> tuple[Track, int]:
    """Put a ball on a rope bridge, and record how far the worst cable overstretches.

    The bridge runs at 60 frames per second.

    Returns:
        The worst cable's excess length in percent over time, and the number of contacts resolved.
        The excess length is infinite once the ball has fallen through.
    """
    bridge = Bridge(mass)
    bridge.world.resolver.iterations = iterations
    work = 0

    def move(duration: float) -> None:
        nonlocal work
        for _ in range(substeps):
            bridge.step(duration / substeps)
            work += bridge.world.resolver.iterations_used

    def measure() -> float:
        lowest = min(numbers(end.position)[1] for row in bridge.rows for end in row)
        return over_length(bridge.links) if numbers(bridge.ball.position)[1] > lowest else math.inf

    return tracks(move, [measure], round(seconds / FRAME), FRAME)[0], work


def uneven_frames(seed: int, seconds: float, spikes: Sequence[float]) -> list[float]:
    """Create random frame durations, as in a game whose frame rate varies.

    Most frames take between 5 and 30 ms. At each time in ``spikes``, one frame takes SPIKE, as if
    the computer were busy with something else.
    """
    rng = random.Random(seed)
    frames, time, left = [], 0.0, [*spikes]
    while time < seconds:
        if left and time >= left[0]:
            frames.append(SPIKE)
            left.pop(0)
        else:
            frames.append(rng.uniform(0.005, 0.03))
        time += frames[-1]
    return frames


def places(world: ParticleWorld) -> list[Numbers]:
    """Return the positions of all particles of a world, as tuples of floats.

    The result is a copy, which does not change when the particles move.
    """
    return [numbers(particle.position) for particle in world.particles]


def in_frames(
    aggregate: MassAggregate, frames: Sequence[float], measure: Callable[[], float], fixed: bool
) -> tuple[Track, list[tuple[int, list[Numbers]]]]:
    """Simulate a mass aggregate, such as the rope bridge, in frames of different lengths.

    If ``fixed`` is true, FixedStep divides the time into equal steps. Otherwise each frame is a
    single step.

    Returns:
        The measured values over time, and a list with an entry for each frame. An entry is a
        tuple of the number of steps so far and the positions of all particles.
    """
    stepper = FixedStep(aggregate.step, FRAME)
    times, values = [0.0], [number(measure())]
    states = [(0, places(aggregate.world))]

    def run() -> None:
        steps = 0
        for elapsed in frames:
            if fixed:
                steps += stepper.advance(elapsed)
            else:
                aggregate.step(elapsed)
                steps += 1
            values.append(number(measure()))
            states.append((steps, places(aggregate.world)))
            times.append(times[-1] + elapsed)

    message = stopped(run)
    return Track(times, values[: len(times)], message), states[: len(times)]


def spin_of_wheel(force: float, driven: int, rate: int, seconds: float) -> Track:
    """Simulate a wheel that is driven by a force, and record its spin in rad/s over time."""
    wheel = Wheel(force, driven)
    return _driven(wheel, lambda: spin(wheel.hub, wheel.rim), rate, seconds)


def deformation_of_wheel(force: float, driven: int, rate: int, seconds: float) -> Track:
    """Simulate a wheel that is driven by a force, and record how far its rods are deformed.

    The recorded value is the largest relative error in the length of a rod.
    """
    wheel = Wheel(force, driven)
    return _driven(wheel, lambda: deformation(wheel.rods), rate, seconds)


def spread_of_blob(speed: float, cables: bool, seconds: float) -> Track:
    """Throw a blob down from a height of 2 m, and record how far it spreads over time."""
    blob = _thrown(speed, cables)
    return tracks(blob.step, [lambda: spread(blob.particles)], round(seconds / FRAME), FRAME)[0]


def bonds_of_blob(speed: float, cables: bool, seconds: float) -> Track:
    """Throw a blob down from a height of 2 m, and record the number of unbroken bonds over time."""
    blob = _thrown(speed, cables)

    def holding() -> float:
        return sum(1.0 for bond in blob.bonds if bond.holds)

    return tracks(blob.step, [holding], round(seconds / FRAME), FRAME)[0]


def balls_on_ground(kind: type[ParticleWorld]) -> tuple[ParticleWorld, list[Particle]]:
    """Create a world in which balls fall to the ground one by one. Return the world and the balls.

    The last ball starts at LATE_HEIGHT. It lands between two other balls and pushes all balls
    apart. Any balls that have fallen asleep must wake at that moment.
    """
    down = Vector3(0.0, -9.81)
    places = [Vector3(1.2 * i, 2.0 * RADIUS + 0.6 * i) for i in range(BALLS)]
    places.append(Vector3(0.6 * (BALLS - 1) + 0.3, LATE_HEIGHT))
    balls = [Particle(place, acceleration=down, damping=0.5) for place in places]
    balls[-1].damping = 0.9
    detector = Detectors(GroundPlane(balls, radius=RADIUS), ParticlePairs(balls, RADIUS))
    return kind(balls, [detector]), balls


def sleepers(kind: type[ParticleWorld], seconds: float) -> tuple[Track, Track, Track]:
    """Drop balls on the ground, and record three values that show how sleeping saves work.

    ``kind`` is the class of the world, such as SleepingWorld, in which resting balls fall asleep.
    Return three values over time: the number of awake balls, the number of contacts resolved per
    time step, and the kinetic energy in J.
    """
    world, balls = balls_on_ground(kind)

    def move(duration: float) -> None:
        world.resolver.iterations_used = 0  # the resolver is not called without contacts
        world.step(duration)

    def awake() -> float:
        return len(balls) - (len(world.asleep) if isinstance(world, SleepingWorld) else 0)

    measures: list[Measure] = [
        awake,
        lambda: world.resolver.iterations_used,
        lambda: math.fsum(ball.kinetic_energy() for ball in balls if ball.inverse_mass),
    ]
    first, second, third = tracks(move, measures, round(seconds / FRAME), FRAME)
    return first, second, third


def longest(values: Sequence[Numbers], others: Sequence[Numbers]) -> float:
    """Return the largest distance between two positions with the same index in the two lists."""
    return max(math.dist(a, b) for a, b in zip(values, others, strict=True))


def _driven(wheel: Wheel, measure: Measure, rate: int, seconds: float) -> Track:
    return tracks(wheel.step, [measure], round(rate * seconds), 1.0 / rate)[0]


def _thrown(speed: float, cables: bool) -> Blob:
    blob = Blob(2.0, cables)
    for particle in blob.particles:
        particle.velocity = Vector3(0.0, -speed)
    return blob
