"""Worlds of one frame or of many, told as numbers; the autograder runs it beside the student."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs import integrators
from ch07_constraints.contacts import Contact
from ch08_mass_aggregate.fixed_step import FixedStep
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy

Components = tuple[float, float, float]
# place, velocity, acceleration, mass
Body = tuple[Components, Components, Components, float]

UP = (0.0, 1.0, 0.0)


def xyz(v: Any) -> Components:
    return (v.x, v.y, v.z)


def particles_of(bodies: Sequence[Body]) -> list[Particle]:
    return [Particle(Vector3(*p), Vector3(*v), Vector3(*a), mass=m) for p, v, a, m in bodies]


def energy_of(bodies: Sequence[Body], force: Components = (0.0, 0.0, 0.0)) -> Any:
    """Return the mechanical energy of bodies, on each of which a force acts, and acted before."""
    particles = particles_of(bodies)
    for particle, (place, velocity, *_) in zip(particles, bodies, strict=True):
        if particle.inverse_mass:
            particle.add_force(Vector3(*force))
            particle.integrate(1.0)
            particle.position, particle.velocity = Vector3(*place), Vector3(*velocity)
        particle.add_force(Vector3(*force))
    mechanical_energy(particles)  # it only looks: a second call finds the same
    return mechanical_energy(particle for particle in particles)


class Pull:
    """A generator of the force -k x - f, which writes down when it was asked, and where."""

    def __init__(self, k: float, f: Components, diary: list[Any]) -> None:
        self.k, self.f, self.diary = k, f, diary

    def update_force(self, particle: Particle, duration: float) -> None:
        self.diary.append(("force", duration, xyz(particle.position)))
        particle.add_force(particle.position * -self.k - Vector3(*self.f))


class Floor:
    """A level floor for some particles; it writes down when it was asked, and where they were.

    The checks use it in place of GroundPlane, so that they need no exercise of chapter 7.
    """

    def __init__(
        self,
        particles: Sequence[Particle],
        height: float,
        diary: list[Any],
        restitution: float = 0.0,
    ) -> None:
        self.particles, self.height, self.diary = particles, height, diary
        self.restitution = restitution

    def contacts(self) -> Any:
        """Return a generator's contacts one after the other: any iterable is allowed."""
        self.diary.append(("contacts", self.height, [xyz(p.position) for p in self.particles]))
        for particle in self.particles:
            depth = self.height - particle.position.y
            if depth >= 0.0:
                yield Contact(particle, None, Vector3(*UP), self.restitution, depth)


class Record:
    """Stands for a resolver, and writes down what it is to resolve."""

    def __init__(self, diary: list[Any]) -> None:
        self.diary = diary

    def resolve_contacts(self, contacts: Any, duration: float) -> None:
        depths = [contact.penetration for contact in contacts]
        self.diary.append(("resolve", duration, depths))


def frame(
    bodies: Sequence[Body],
    method: str,
    duration: float,
    *,
    integrator: str = "semi_implicit_euler",
    k: float = 0.0,
    f: Components = (0.0, 0.0, 0.0),
    floors: Sequence[float] = (),
    late: Components = (0.0, 0.0, 0.0),
    record: bool = False,
) -> dict[str, Any]:
    """Let one frame pass in a world with a Pull on each body and floors under all of them.

    ``late`` is a force that is added by hand before the method, "step" or "run_physics". With
    ``record`` contacts are written down, not resolved. Return states and the diary.
    """
    diary: list[Any] = []
    particles = particles_of(bodies)
    step = getattr(integrators, integrator)

    def told_step(those: Sequence[Particle], apply_forces: Any, time: float) -> None:
        diary.append(("integrator", time, len(those)))
        if not callable(apply_forces):
            diary.append(("no function", "None" if apply_forces is None else "no function"))
            return
        step(those, apply_forces, time)

    world = ParticleWorld(particles, integrator=told_step)
    world.contact_generators.extend(Floor(particles, height, diary) for height in floors)
    if record:
        world.resolver = Record(diary)  # type: ignore[assignment]
    for particle in particles:
        if k or any(f):
            world.registry.add(particle, Pull(k, f, diary))
    if method == "run_physics":
        world.start_frame()
    for particle in particles:
        particle.add_force(Vector3(*late))
    getattr(world, method)(duration)
    states = [(xyz(particle.position), xyz(particle.velocity)) for particle in particles]
    return {"states": states, "diary": diary}


def depths_of(count: int, floors: Sequence[float]) -> list[Any]:
    """Return the depths of all contacts of particles at a height of 1, or ["a list"] for lists."""
    particles = [Particle(Vector3(float(i), 1.0)) for i in range(count)]
    world = ParticleWorld(particles, [Floor(particles, height, []) for height in floors])
    found = [*world.contacts()]
    if any(hasattr(contact, "__iter__") for contact in found):
        return ["a list"]
    return [contact.penetration for contact in found]


def add(world: ParticleWorld, particles: Sequence[Particle], generators: Any = ()) -> None:
    """Append to a world's lists; a check in another process would append to a copy."""
    world.particles.extend(particles)
    world.contact_generators.extend(generators)


def advanced(
    duration: float, elapsed: Sequence[float], max_steps: int | None = None, raise_at: int = 0
) -> dict[str, Any]:
    """Advance a FixedStep by these times; its step raises when it is made for the raise_at-th time.

    Return the durations of the steps that were made, and after each call what it returned (or -1
    where it raised), left, dropped.
    """
    made: list[float] = []
    called = [0]

    def step(time: float) -> None:
        called[0] += 1
        if called[0] == raise_at:
            raise KeyError("the step that fails")
        made.append(time)

    clock = FixedStep(step, duration, max_steps)
    rows = []
    for time in elapsed:
        try:
            steps: Any = clock.advance(time)
        except KeyError:
            steps = -1
        rows.append((steps, clock.left, clock.dropped))
    return {"made": made, "rows": rows}


def bounced(elapsed: Sequence[float], duration: float) -> tuple[Components, Components]:
    """Let a ball bounce that a FixedStep moves, with no world; return its place and velocity."""
    ball = Particle(Vector3(0.0, 1.0, 0.0), Vector3(1.0), Vector3(0.0, -10.0, 0.0))
    ground = Floor([ball], 0.0, [], restitution=0.5)

    def step(duration: float) -> None:
        integrators.semi_implicit_euler([ball], lambda _: None, duration)
        for contact in ground.contacts():
            contact.resolve(duration)

    clock = FixedStep(step, duration)
    for time in elapsed:
        clock.advance(time)
    return xyz(ball.position), xyz(ball.velocity)
