"""Steps: ways to move particles on by a frame, and what each is good for.

The first four take ``(particles, apply_forces, duration)``. ``apply_forces(duration)`` adds the
forces of the moment to the accumulators, as ForceRegistry.update_forces does, and may only act on
these particles. A step asks it once or several times, each time with no other forces in the
accumulators than those that were added by hand before the step. At its end they are empty, and
Particle.last_acceleration knows the mean acceleration of the step. Each particle stands in the list
once.

A particle's own damping d multiplies the velocity by d^h, once, at the end of the step: the orders
below are those at d = 1, and with any other d the order is 1. Immovable particles stay where they
are. The stability limits are for a spring without damping, in frames of h s, at d = 1: k h^2 / m is
how stiff it is for that frame.

Each raises ValueError where the duration is not positive and finite, and TypeError where it is no
number; all is then as it was. What apply_forces raises comes out of the step, and the particles are
then somewhere on their way.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence

from ch02_vectors.arguments import finite, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Step as the book does: p' = p + v h, and then v' = (v + a h) d^h, by Particle.integrate.

    Order 1; not symplectic; one evaluation of the forces. Stable for no stiffness, at d = 1; below
    max_stable_stiffness where d < 1. A damper c in the spring makes it stable for k h < c, while
    c h / m < 2. Source: book 3.3.2, with its name put right (E-17).
    """
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.integrate(duration)


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Step the velocity first, v' = (v + a h) d^h, and then p' = p + v' h.

    Order 1; symplectic at d = 1 where no force depends on the velocity, so that energy does not
    drift; one evaluation of the forces. Stable for k h^2 / m < 4; with damping d for k h^2 / m < 2
    (1 + d^h) / d^h, with a damper c in the spring for k h^2 / m + 2 c h / m < 4. Source: Hairer,
    Lubich and Wanner, Geometric Numerical Integration, I.1.2.
    """
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        # Plain floats: this is the step for every particle of a world, in every frame.
        place = particle.position
        x, y, z = place.x, place.y, place.z
        particle.integrate(duration)
        if particle.inverse_mass:
            place, velocity = particle.position, particle.velocity
            place.x = x + velocity.x * duration
            place.y = y + velocity.y * duration
            place.z = z + velocity.z * duration


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Step by the accelerations a of now and b of the place that a leads to.

    p' = p + v h + a h^2 / 2, and v' = (v + (a + b) h / 2) d^h. Forces that depend on the velocity
    are asked for b with v + a h.

    Order 2; symplectic at d = 1 where no force depends on the velocity; two evaluations of the
    forces. Stable for k h^2 / m < 4, also where d < 1; a damper in the spring takes some of that.
    Source: Swope and others, Journal of Chemical Physics 76 (1982), 637.
    """
    positive("duration", duration)
    by_hand = _forces_of(particles)
    apply_forces(duration)
    first = _forces_of(particles)
    starts = [particle.velocity.copy() for particle in particles]
    for particle, force in zip(particles, first, strict=True):
        if particle.inverse_mass:
            acceleration = particle.acceleration + force * particle.inverse_mass
            particle.position.add_scaled(particle.velocity, duration)
            particle.position.add_scaled(acceleration, 0.5 * duration * duration)
            particle.velocity.add_scaled(acceleration, duration)
    second = _evaluate(particles, by_hand, apply_forces, duration)
    for particle, velocity, a, b in zip(particles, starts, first, second, strict=True):
        _end(particle, particle.position, velocity, (a + b) * 0.5, duration)


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Step by the mean of four rates: at the start, twice in the middle, and at the end.

    The second and the third count double. The first is taken at the start, each of the others
    where the rate before it leads from the start: in half of the frame, in half of it again, and in
    all of it.

    Order 4; not symplectic, but nearly free of drift while its steps are small; four evaluations of
    the forces. Stable for k h^2 / m < 8, and for more where d < 1. Source: Kutta, Zeitschrift für
    Mathematik und Physik 46 (1901), 435.
    """
    positive("duration", duration)
    by_hand = _forces_of(particles)
    starts = [(particle.position.copy(), particle.velocity.copy()) for particle in particles]
    velocities = [Vector3() for _ in particles]
    accelerations = [Vector3() for _ in particles]
    way = [Vector3() for _ in particles]  # the sum of the velocities, each times its weight
    pushes = [Vector3() for _ in particles]  # and that of the forces
    for part, weight in ((0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)):
        for i, particle in enumerate(particles):
            if particle.inverse_mass:
                place, velocity = starts[i]
                _put(
                    particle,
                    place + velocities[i] * (part * duration),
                    velocity + accelerations[i] * (part * duration),
                )
        forces = _evaluate(particles, by_hand, apply_forces, duration)
        for i, particle in enumerate(particles):
            velocities[i] = particle.velocity.copy()
            accelerations[i] = particle.acceleration + forces[i] * particle.inverse_mass
            way[i].add_scaled(velocities[i], weight)
            pushes[i].add_scaled(forces[i], weight)
    for i, particle in enumerate(particles):
        place, velocity = starts[i]
        end = place + way[i] * (duration / 6.0) if particle.inverse_mass else place
        _end(particle, end, velocity, pushes[i] / 6.0, duration)


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Return position in m and velocity in m/s of one linear spring a frame later.

    x' = x + v' h and v' = v + a' h, both with what is new: m a' = -k x' - c v', which is solved for
    v'. The spring rests at 0; k is in N/m, c in N s/m, the mass in kg and the duration in s.

    Order 1; not symplectic; nothing to evaluate; stable for every stiffness, and it loses energy
    all the more the stiffer the spring. Source: Hairer and Wanner, Solving Ordinary Differential
    Equations II, IV.3.

    Raises ValueError where mass or duration is not positive, stiffness or damping is negative, or
    an argument or the result is not finite. What is no number is a TypeError.
    """
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    new = (v - h * k * x) / (1.0 + h * c + h * h * k)
    return finite("the new position", x + new * h), finite("the new velocity", new)


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Return position in m and velocity in m/s of one linear spring a frame later.

    x' = x + (v + v') h / 2 and v' = v + (a + a') h / 2, the mean of old and new, with
    m a = -k x - c v, which is solved for v'. The arguments are those of backward_euler.

    Order 2; symplectic for this spring without damping, whose energy it keeps; nothing to evaluate;
    stable for every stiffness. Source: Hairer and Wanner, Solving Ordinary Differential Equations
    II, IV.3.

    Raises ValueError and TypeError as backward_euler does.
    """
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    half = 0.5 * h
    new = (v * (1.0 - half * c - half * half * k) - h * k * x) / (1.0 + half * c + half * half * k)
    return finite("the new position", x + (v + new) * half), finite("the new velocity", new)


class SimulationDiverged(ArithmeticError):  # noqa: N818
    """A particle is faster than anything in its scene should be: the step cannot follow the forces.

    ``particle`` is its place in the list of particles, ``step`` the number of the step after which
    that was seen, the first being 1, ``speed`` and ``limit`` are in m/s.
    """

    def __init__(self, particle: int, step: int, speed: float, limit: float) -> None:
        super().__init__(
            f"particle {particle} has {speed:.4g} m/s after step {step}, over the limit of "
            f"{limit:g} m/s: shorter frames, softer springs or another step would help"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


def watched(integrator: Integrator, speed_limit: float) -> Integrator:
    """Return a step that does what the integrator does, and then looks at every particle's speed.

    It takes the same arguments, counts the steps that it has made, and raises SimulationDiverged
    for the first particle whose speed is over the limit in m/s, or not a number. What the
    integrator raises comes out, and is no step that was made. Without a watch nothing is looked at,
    and nothing is paid.

    Raises ValueError where the limit is not positive and finite.
    """
    positive("speed_limit", speed_limit)
    steps = 0

    def step(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
        nonlocal steps
        integrator(particles, apply_forces, duration)
        steps += 1
        for i, particle in enumerate(particles):
            v = particle.velocity
            speed = math.hypot(v.x, v.y, v.z)
            if not speed <= speed_limit:  # NaN compares false with everything
                raise SimulationDiverged(i, steps, speed, speed_limit)

    return step


def _forces_of(particles: Iterable[Particle]) -> list[Vector3]:
    """Return the forces in the accumulators."""
    return [particle.force_accumulator for particle in particles]


def _evaluate(
    particles: Sequence[Particle],
    by_hand: list[Vector3],
    apply_forces: ApplyForces,
    duration: float,
) -> list[Vector3]:
    """Return the forces on the particles as they are now, with those that were added by hand."""
    for particle, force in zip(particles, by_hand, strict=True):
        particle.clear_forces()
        particle.add_force(force)
    apply_forces(duration)
    return _forces_of(particles)


def _end(
    particle: Particle, place: Vector3, velocity: Vector3, force: Vector3, duration: float
) -> None:
    """End a step at a place; chapter 5's step gives the velocity, by the mean force."""
    end = place.copy()
    _put(particle, place, velocity)
    particle.clear_forces()
    particle.add_force(force)
    particle.integrate(duration)
    _put(particle, end, particle.velocity)


def _put(particle: Particle, place: Vector3, velocity: Vector3) -> None:
    """Give a particle a place and a velocity, in the vectors that it has: others may hold them."""
    p, v = particle.position, particle.velocity
    p.x, p.y, p.z = place
    v.x, v.y, v.z = velocity


def _per_mass(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float, float]:
    """Return the duration, and stiffness and damping for 1 kg, after a look at all arguments."""
    finite("x", x)
    finite("v", v)
    positive("mass", mass)
    return (
        positive("duration", duration),
        not_negative("stiffness", stiffness) / mass,
        not_negative("damping", damping) / mass,
    )
