"""Integrators: methods that move particles forward by one time step.

The first five integrators take ``(particles, apply_forces, duration)``. ``particles`` lists each
particle once. ``apply_forces(duration)`` adds the current forces to their accumulators, and always
takes the duration of the whole step. A force may depend on two particles, so move all particles
before you call it again. Before each call, the accumulators must contain exactly the forces that
were added by hand before the step. After the step they are empty, and
``Particle.last_acceleration`` is the mean acceleration of the step.

In the formulas, p is a position, v a velocity, a an acceleration and h the ``duration`` in s. A
particle's own damping d multiplies its velocity by d^h once, at the end of a step. Immovable
particles do not move, and keep their velocities. A duration or another argument that is out of
range raises ValueError. reference.md lists the orders, the stability limits and the sources.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive as adaptive

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of explicit Euler: p' = p + v h, and then v' = (v + a h) d^h.

    Without damping, every spring is unstable. For d < 1, undamped springs below
    ``max_stable_stiffness`` are stable. The book gives this step another name (3.3.2, E-17).
    """
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.drift(duration)
        particle.kick(duration)


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of semi-implicit Euler: v' = (v + a h) d^h, and then p' = p + v' h."""
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)
        particle.drift(duration)


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Move for half the step, update the velocity for the whole step, and move for the other half.

    A step is p1 = p + v h / 2, then v' = (v + a h) d^h with a at p1, then p' = p1 + v' h / 2.
    """
    positive("duration", duration)
    for particle in particles:
        particle.drift(duration / 2.0)
    apply_forces(duration)
    for particle in particles:
        particle.kick(duration)
        particle.drift(duration / 2.0)


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one velocity Verlet step, which uses the mean of the old and the new acceleration.

    First p' = p + v h + a h^2 / 2, and then v' = (v + (a + b) h / 2) d^h. Here a and b are the
    accelerations at the old and the new position. For forces that depend on the velocity, use
    v + a h in b.
    """
    h = positive("duration", duration)
    accelerations = _evaluation(particles, apply_forces, h)
    starts = [particle.velocity.copy() for particle in particles]
    old = accelerations()
    for particle, v, a in zip(particles, starts, old, strict=True):
        _move(particle, particle.position + v * h + a * (h * h / 2.0), v + a * h)
    new = accelerations()
    for particle, v, a, b in zip(particles, starts, old, new, strict=True):
        _finish(particle, particle.position, v, (a + b) / 2.0, h)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of the classical fourth-order Runge-Kutta method.

    The step uses a weighted mean of four rates, in which the second and third rates count double. A
    rate consists of the velocity and the acceleration of a particle. Evaluate the first rate at the
    start of the step. To find each later rate, return to the start, and move at the previous rate:
    for half the step to find the second and third rates, and for the whole step to find the fourth.
    """
    h = positive("duration", duration)
    accelerations = _evaluation(particles, apply_forces, h)
    starts = [(particle.position.copy(), particle.velocity.copy()) for particle in particles]
    rates = []
    for ahead in (h / 2.0, h / 2.0, h, 0.0):  # 0: back to the start after the fourth rate
        velocities = [particle.velocity.copy() for particle in particles]
        rates.append(list(zip(velocities, accelerations(), strict=True)))
        for particle, (p, v), (dp, dv) in zip(particles, starts, rates[-1], strict=True):
            _move(particle, p + dp * ahead, v + dv * ahead)
    for particle, (p, v), four in zip(particles, starts, zip(*rates, strict=True), strict=True):
        dp, dv = ((a + (b + c) * 2.0 + d) / 6.0 for a, b, c, d in zip(*four, strict=True))
        _finish(particle, p + dp * h, v, dv, h)


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with backward Euler, and return its new position and velocity.

    The new values x' and v' solve x' = x + v' h and v' = v + a' h, where m a' = -(k x' + c v'). The
    spring is at rest at x = 0. Positions are in m and velocities in m/s. In the equations, k is
    ``stiffness`` in N/m, c is ``damping`` in N s/m, m is ``mass`` in kg and h is ``duration`` in s.
    """
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    new = (v - h * k * x) / (1.0 + h * c + h * h * k)
    return finite("the new position", x + new * h), finite("the new velocity", new)


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with the trapezoidal rule, and return its new position and velocity.

    The new values solve x' = x + (v + v') h / 2 and v' = v + (a + a') h / 2, with m a = -k x - c v.
    The arguments are those of ``backward_euler``.
    """
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    half = 0.5 * h
    new = (v * (1.0 - half * c - half * half * k) - h * k * x) / (1.0 + half * c + half * half * k)
    return finite("the new position", x + (v + new) * half), finite("the new velocity", new)


class SimulationDiverged(ArithmeticError):  # noqa: N818
    """Raised when a particle moves faster than any particle in its scene should.

    ``particle`` is the index of the particle. ``step`` is the number of the step, counted from 1,
    after which the particle was too fast. ``speed`` and ``limit`` are in m/s.
    """

    def __init__(self, particle: int, step: int, speed: float, limit: float) -> None:
        super().__init__(
            f"after step {step}, particle {particle} moves at {speed:.4g} m/s, above the limit of "
            f"{limit:g} m/s. Use shorter steps, softer springs or another integrator"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


def watched(integrator: Integrator, speed_limit: float) -> Integrator:
    """Return an integrator that also checks the speed of every particle after each step.

    In each step, it calls ``integrator`` once, with the same arguments. It counts its own steps,
    and raises SimulationDiverged for the first particle whose speed is NaN or above ``speed_limit``
    in m/s. It can be called again after that, and goes on counting. A step in which ``integrator``
    raises an exception does not count.
    """
    positive("speed_limit", speed_limit)
    steps = 0

    def step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
        nonlocal steps
        integrator(particles, apply_forces, duration)
        steps += 1
        for i, particle in enumerate(particles):
            speed = particle.velocity.magnitude()
            if not speed <= speed_limit:  # NaN is not below the limit either
                raise SimulationDiverged(i, steps, speed, speed_limit)

    return step


def _evaluation(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> Callable[[], list[Vector3]]:
    """Return a function that evaluates the accelerations at the current positions and velocities.

    Each evaluation starts from the forces that were added by hand before the step.
    """
    by_hand = [particle.force_accumulator for particle in particles]

    def accelerations() -> list[Vector3]:
        for particle, force in zip(particles, by_hand, strict=True):
            particle.clear_forces()
            particle.add_force(force)
        apply_forces(duration)
        return [p.acceleration + p.force_accumulator * p.inverse_mass for p in particles]

    return accelerations


def _move(particle: Particle, position: Vector3, velocity: Vector3) -> None:
    """Set the state of a particle in its own vectors, unless it is immovable."""
    if particle.inverse_mass:
        p, v = particle.position, particle.velocity
        p.x, p.y, p.z = position
        v.x, v.y, v.z = velocity


def _finish(
    particle: Particle, position: Vector3, velocity: Vector3, mean: Vector3, duration: float
) -> None:
    """End a step at ``position``: kick the initial ``velocity`` by the ``mean`` acceleration."""
    _move(particle, position, velocity)
    particle.clear_forces()
    if particle.inverse_mass:
        particle.add_force((mean - particle.acceleration) / particle.inverse_mass)
    particle.kick(duration)


def _per_mass(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float, float]:
    """Check the arguments of an implicit step, and return h, k / m and c / m."""
    finite("x", x)
    finite("v", v)
    positive("mass", mass)
    return (
        positive("duration", duration),
        not_negative("stiffness", stiffness) / mass,
        not_negative("damping", damping) / mass,
    )
