"""Integrators."""

from collections.abc import Callable, Sequence

from ch02_vectors.arguments import finite, not_negative, positive
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(particles, apply_forces, duration):
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        particle.integrate(duration)


def semi_implicit_euler(particles, apply_forces, duration):
    positive("duration", duration)
    apply_forces(duration)
    for particle in particles:
        before = particle.position.copy()
        particle.integrate(duration)
        if particle.has_finite_mass:
            particle.position = before + particle.velocity * duration


def velocity_verlet(particles, apply_forces, duration):
    h = positive("duration", duration)
    apply_forces(h)
    old = []
    for p in particles:
        a = p.acceleration + p.force_accumulator * p.inverse_mass
        old.append((p.velocity.copy(), p.force_accumulator))
        if p.has_finite_mass:
            p.position.add_scaled(p.velocity, h)
            p.position.add_scaled(a, h * h / 2)
            p.velocity.add_scaled(a, h)
    apply_forces(h)
    for p, (velocity, force) in zip(particles, old, strict=True):
        mean = (force + p.force_accumulator) * 0.5
        p.velocity = velocity
        p.clear_forces()
        p.add_force(mean)
        place = p.position.copy()
        p.integrate(h)
        p.position = place


def runge_kutta_4(particles, apply_forces, duration):
    raise NotImplementedError("Exercise B6.8: Runge-Kutta of order 4")


def backward_euler(x, v, stiffness, damping, mass, duration):
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    v = (v - h * k * x) / (1 + h * c + h * h * k)
    return x + v * h, v


def trapezoidal(x, v, stiffness, damping, mass, duration):
    h, k, c = _per_mass(x, v, stiffness, damping, mass, duration)
    # half a step with the old acceleration, half a step with the new one
    v = v + (-k * x - c * v) * h / 2
    x = x + v * h / 2
    return backward_euler(x, v, k, c, 1.0, h / 2)


class SimulationDiverged(ArithmeticError):
    def __init__(self, particle, step, speed, limit):
        super().__init__(
            f"particle {particle} has {speed:.4g} m/s after step {step}, over the limit of "
            f"{limit:g} m/s: shorter frames, softer springs or another step would help"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


def watched(integrator, speed_limit):
    positive("speed_limit", speed_limit)
    count = 0

    def step(particles, apply_forces, duration):
        nonlocal count
        integrator(particles, apply_forces, duration)
        count += 1
        for i, particle in enumerate(particles):
            speed = particle.velocity.magnitude()
            if speed > speed_limit:
                raise SimulationDiverged(i, count, speed, speed_limit)

    return step


def _per_mass(x, v, stiffness, damping, mass, duration):
    finite("x", x)
    finite("v", v)
    m = positive("mass", mass)
    k = not_negative("stiffness", stiffness) / m
    c = not_negative("damping", damping) / m
    return positive("duration", duration), k, c
