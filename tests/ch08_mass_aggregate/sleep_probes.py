"""Sleeping worlds, told as numbers; the autograder runs it beside the student."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs import integrators
from ch06_springs.springs import AnchoredSpring, Spring, connect
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch08_mass_aggregate.probes import Components, xyz
from ch08_mass_aggregate.sleeping import SleepingWorld

FRAME = 1.0 / 60.0


def down() -> Vector3:
    """Return gravity, in m/s^2."""
    return Vector3(0.0, -10.0, 0.0)


class Push:
    """A force that can be changed; it counts how often it was asked."""

    def __init__(self, x: float = 0.0, y: float = 0.0) -> None:
        self.x, self.y = x, y
        self.asked = 0
        self.durations: set[float] = set()

    def update_force(self, particle: Particle, duration: float) -> None:
        self.asked += 1
        self.durations.add(duration)
        particle.add_force(Vector3(self.x * particle.mass, self.y * particle.mass))


class Touch:
    """A generator of contacts of depth 0 between pairs of numbered particles; -1 is a wall."""

    def __init__(self, particles: Sequence[Particle], pairs: Sequence[tuple[int, int]]) -> None:
        self.particles, self.pairs = particles, pairs

    def contacts(self) -> list[Contact]:
        right = Vector3(1.0)
        one = [*self.particles, None]
        return [Contact(self.particles[i], one[j], right) for i, j in self.pairs]


def asleep(world: SleepingWorld, particles: Sequence[Particle]) -> list[int]:
    """Return the numbers of those that sleep."""
    return [i for i, particle in enumerate(particles) if particle in world.asleep]


def left_alone(
    speeds: Sequence[float],
    frames: int,
    pairs: Sequence[tuple[int, int]] = (),
    masses: Sequence[float] = (),
    sleep_frames: int = 5,
) -> list[list[int]]:
    """Let particles of these speeds along Z alone; return who sleeps after each frame.

    Slow is 0.5 J/kg or less. The pairs are in contact, without a force between them.
    """
    particles = [
        Particle(Vector3(3.0 * i), Vector3(0.0, 0.0, speed), mass=masses[i] if masses else 1.0)
        for i, speed in enumerate(speeds)
    ]
    world = SleepingWorld(
        particles, [Touch(particles, pairs)], sleep_energy=0.5, sleep_frames=sleep_frames
    )
    seen = []
    for _ in range(frames):
        world.step(FRAME)
        seen.append(asleep(world, particles))
    return seen


def interrupted(slow: int, frames: int) -> list[list[int]]:
    """Let a particle lie still, but for one frame in which it is fast; return who sleeps."""
    particle = Particle()
    world = SleepingWorld([particle], sleep_energy=0.5, sleep_frames=5)
    seen = []
    for i in range(frames):
        particle.velocity.z = 9.0 if i == slow else particle.velocity.z
        world.step(FRAME)
        seen.append(asleep(world, [particle]))
        if i == slow:
            particle.velocity.clear()
    return seen


def slept(mass: float, speed: float) -> dict[str, Any]:
    """Let a slow particle fall asleep, and wake it by name; return what it is then, and later."""
    particle = Particle(Vector3(1.0, 2.0, 3.0), Vector3(speed), mass=mass)
    world = SleepingWorld([particle], sleep_energy=10.0, sleep_frames=3)
    for _ in range(3):
        world.step(FRAME)
    told: dict[str, Any] = {"inverse mass asleep": particle.inverse_mass}
    told["velocity asleep"] = xyz(particle.velocity)
    told["place asleep"] = xyz(particle.position)
    for _ in range(20):
        world.step(FRAME)
    told["place later"] = xyz(particle.position)
    world.wake(particle)
    told["inverse mass awake"] = particle.inverse_mass
    told["asleep"] = asleep(world, [particle])
    frames = 0
    while not world.asleep and frames < 10:
        world.step(FRAME)
        frames += 1
    told["frames to sleep again"] = frames
    world.wake(particle)
    for _ in range(2):
        world.step(FRAME)
    world.wake(particle)  # which is awake already
    told["frames from then on"] = 0
    while not world.asleep and told["frames from then on"] < 10:
        world.step(FRAME)
        told["frames from then on"] += 1
    return told


def woken_by_hand(how: str) -> tuple[list[int], list[int], float, Components]:
    """Let a particle fall asleep on the ground, and do something to it.

    Return who sleeps before, and after a frame, its mass, and its velocity.
    """
    particle = Particle(acceleration=down(), mass=2.0)
    world = SleepingWorld([particle], [GroundPlane([particle])], sleep_frames=3)
    for _ in range(5):
        world.step(FRAME)
    before = asleep(world, [particle])
    if how == "velocity":
        particle.velocity.x = 3.0
    elif how == "place":
        particle.position.y = 5.0
    elif how == "mass":
        particle.mass = 4.0
    world.start_frame()
    if how == "force":
        particle.add_force(Vector3(60.0))
    world.run_physics(FRAME)
    return before, asleep(world, [particle]), particle.mass, xyz(particle.velocity)


def woken_by_force(old: float, new: float, frames: int, late: bool = False) -> list[list[int]]:
    """Let a particle between walls sleep under a force for each kg, and change it.

    With ``late`` the new force is that of a generator that was added. Return who sleeps after each
    of the frames that follow.
    """
    particle = Particle(mass=2.0)
    wall = Wall(particle)
    world = SleepingWorld([particle], [wall], sleep_energy=1e-4, sleep_frames=3)
    push = Push(old)
    world.registry.add(particle, push)
    for _ in range(25):
        world.step(FRAME)
    before = asleep(world, [particle])
    if late:
        world.registry.add(particle, Push(new))
    else:
        push.x = new
    seen = [before]
    for _ in range(frames):
        world.step(FRAME)
        seen.append(asleep(world, [particle]))
    return seen


class Wall:
    """A wall that keeps a particle at x of 0 or less."""

    def __init__(self, particle: Particle) -> None:
        self.particle = particle

    def contacts(self) -> list[Contact]:
        x = self.particle.position.x
        if x < 0.0 or not self.particle.inverse_mass:
            return []
        return [Contact(self.particle, None, Vector3(-1.0), 0.0, x)]


def woken_by_contact(speed: float, frames: int, first: bool) -> dict[str, Any]:
    """Let a row of three balls fall asleep on the ground, and roll another one at them.

    It is the first or the last of those that the detector of pairs was given.

    Return who sleeps before, and after each frame, and the momentum along X then.
    """
    balls = [Particle(Vector3(1.0 * i, 0.5), acceleration=down()) for i in range(3)]
    shot = Particle(Vector3(-3.0, 0.5), Vector3(speed), acceleration=down())
    every = [*balls, shot]
    given = [shot, *balls] if first else every
    world = SleepingWorld(balls, sleep_frames=3)
    world.contact_generators.append(GroundPlane(every, radius=0.5))
    world.contact_generators.append(ParticlePairs(given, 0.5, restitution=1.0))
    for _ in range(5):
        world.step(FRAME)
    before = asleep(world, every)
    world.particles.append(shot)
    seen, momenta = [], []
    for _ in range(frames):
        world.step(FRAME)
        seen.append(asleep(world, every))
        momenta.append(sum(ball.velocity.x for ball in every))  # each has 1 kg
    return {"before": before, "seen": seen, "momenta": momenta}


def dropped_on(speed: float) -> tuple[list[int], float, float]:
    """Throw a ball down at one that sleeps on the ground.

    Return who sleeps before, and of the lower one velocity and place along Y after the frame in
    which it wakes.
    """
    lower, upper = (Particle(Vector3(0.0, 0.5 + 3.0 * i), acceleration=down()) for i in range(2))
    balls = [lower, upper]
    grounds = [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)]
    world = SleepingWorld([lower], grounds, iterations=200, sleep_frames=3)
    for _ in range(5):
        world.step(FRAME)
    before = asleep(world, balls)
    upper.velocity.y = -speed
    world.particles.append(upper)
    for _ in range(60):
        if lower not in world.asleep:
            break
        world.step(FRAME)
    return before, lower.velocity.y, lower.position.y


def support_gone(frames: int) -> tuple[list[int], list[int], float]:
    """Let a ball sleep on another one, and take that away; return who sleeps before, and after.

    And how fast the one above falls after so many frames.
    """
    lower, upper = (Particle(Vector3(0.0, 0.5 + i), acceleration=down()) for i in range(2))
    balls = [lower, upper]
    grounds = [GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)]
    world = SleepingWorld(balls, grounds, iterations=50, sleep_frames=3)
    for _ in range(30):
        world.step(FRAME)
    before = asleep(world, balls)
    lower.position.x = 50.0
    for _ in range(frames):
        world.step(FRAME)
    return before, asleep(world, balls), upper.velocity.y


def on_a_spring(frames: int) -> tuple[list[list[int]], list[Components]]:
    """Let two particles on a spring, and a third one on a spring to it, fall asleep; pull the last.

    Return who sleeps before, and after each frame, and where they are in the end.
    """
    made = [Particle(Vector3(1.0 * i), damping=0.9) for i in range(3)]
    world = SleepingWorld(made, sleep_frames=3)
    connect(world.registry, made[0], made[1], 20.0, 1.0)
    world.registry.add(made[1], Spring(made[2], 20.0, 1.0))
    world.registry.add(made[2], Spring(made[1], 20.0, 1.0))
    for _ in range(5):
        world.step(FRAME)
    seen = [asleep(world, made)]
    made[2].velocity.x = 6.0
    for _ in range(frames):
        world.step(FRAME)
        seen.append(asleep(world, made))
    return seen, [xyz(particle.position) for particle in made]


def hung(frames: int, late: int, push: float) -> list[list[int]]:
    """Let a mass hang nearly still on a spring, where its forces cancel; return who sleeps.

    From one frame on it is pushed along X as well.
    """
    particle = Particle(Vector3(0.0, -2.0), Vector3(0.0, 0.05), down())
    world = SleepingWorld([particle], sleep_frames=3)
    world.registry.add(particle, AnchoredSpring(Vector3(), 10.0, 1.0))
    extra = Push()
    world.registry.add(particle, extra)
    seen = []
    for i in range(frames):
        extra.x = push if i >= late else 0.0
        world.step(FRAME)
        seen.append(asleep(world, [particle]))
    return seen


def work_asleep(count: int, awake: int, frames: int) -> tuple[int, int, list[int]]:
    """Let particles fall asleep but for a few that keep moving.

    Return how often their generator was asked in the frames that follow, how many particles the
    integrator was given in all of them, and who sleeps.
    """
    particles = [Particle(Vector3(3.0 * i)) for i in range(count)]
    given = [0]

    def step(those: Sequence[Particle], apply_forces: Any, duration: float) -> None:
        given[0] += len(those)
        integrators.semi_implicit_euler(those, apply_forces, duration)

    world = SleepingWorld(particles, integrator=step, sleep_frames=3)
    push = Push()
    for particle in particles:
        world.registry.add(particle, push)
    for particle in particles[:awake]:
        particle.velocity.y = 5.0
    for _ in range(10):
        world.step(FRAME)
    push.asked = given[0] = 0
    for _ in range(frames):
        world.step(FRAME)
    return push.asked, given[0], asleep(world, particles)


def both_ways(frames: int) -> tuple[list[Components], list[Components], int]:
    """Let two balls fall on the ground, one after the other; return where they end up.

    In a sleeping world, and in one that is never slow enough; and how many sleep in the first.
    """
    ends, sleepers = [], 0
    for sleep_energy in (0.015, 0.0):
        balls = [
            Particle(Vector3(float(i), 1.0 + 4.0 * i), Vector3(0.5 * i), down(), damping=0.5)
            for i in range(2)
        ]
        ground = GroundPlane(balls, restitution=0.4)
        world = SleepingWorld(balls, [ground], sleep_energy=sleep_energy)
        for _ in range(frames):
            world.step(FRAME)
        ends.append([xyz(ball.position) for ball in balls])
        sleepers = sleepers or len(world.asleep)
    return ends[0], ends[1], sleepers
