"""Ada's steps."""

from collections.abc import Callable, Sequence

from ch02_vectors.arguments import finite, not_negative, positive
from ch05_forces.particle import Particle

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(particles, apply_forces, duration):
    positive("duration", duration)
    apply_forces(duration)
    for p in particles:
        p.integrate(duration)


def semi_implicit_euler(particles, apply_forces, duration):
    positive("duration", duration)
    apply_forces(duration)
    for p in particles:
        p.kick(duration)
        p.drift(duration)


def leapfrog(particles, apply_forces, duration):
    h = positive("duration", duration)
    for p in particles:
        p.drift(h / 2)
    apply_forces(h)
    for p in particles:
        p.kick(h)
        p.drift(h / 2)


def velocity_verlet(particles, apply_forces, duration):
    h = positive("duration", duration)
    step = Evaluations(particles, apply_forces, h)
    f1, a1 = step.evaluate()
    step.move(step.velocities, a1, h)
    for p, a in step.movable(a1):
        p.position.add_scaled(a, h * h / 2)
    places = [p.position.copy() for p in particles]
    f2, _ = step.evaluate()
    step.end(places, [(f + g) / 2 for f, g in zip(f1, f2)])


def runge_kutta_4(particles, apply_forces, duration):
    h = positive("duration", duration)
    step = Evaluations(particles, apply_forces, h)
    v1 = step.velocities
    f1, a1 = step.evaluate()
    v2 = step.move(v1, a1, h / 2)
    f2, a2 = step.evaluate()
    v3 = step.move(v2, a2, h / 2)
    f3, a3 = step.evaluate()
    v4 = step.move(v3, a3, h)
    f4, _ = step.evaluate()
    mean_v = [(a + 2 * (b + c) + d) / 6 for a, b, c, d in zip(v1, v2, v3, v4)]
    mean_f = [(a + 2 * (b + c) + d) / 6 for a, b, c, d in zip(f1, f2, f3, f4)]
    step.end([x + v * h for x, v in zip(step.positions, mean_v)], mean_f)


class Evaluations:
    """What both methods need: where all started, and the forces at other places."""

    def __init__(self, particles, apply_forces, h):
        self.particles, self.apply_forces, self.h = particles, apply_forces, h
        self.positions = [p.position.copy() for p in particles]
        self.velocities = [p.velocity.copy() for p in particles]
        self.by_hand = [p.force_accumulator for p in particles]

    def movable(self, *lists):
        return (row for row in zip(self.particles, *lists) if row[0].has_finite_mass)

    def evaluate(self):
        for p, force in zip(self.particles, self.by_hand):
            p.clear_forces()
            p.add_force(force)
        self.apply_forces(self.h)
        forces = [p.force_accumulator for p in self.particles]
        rates = [p.acceleration + f * p.inverse_mass for p, f in zip(self.particles, forces)]
        return forces, rates

    def move(self, velocities, accelerations, time):
        # from the start by these rates; tells the velocities that everyone has then
        rows = self.movable(self.positions, self.velocities, velocities, accelerations)
        for p, x0, v0, v, a in rows:
            p.position.set(*(x0 + v * time))
            p.velocity.set(*(v0 + a * time))
        return [p.velocity.copy() for p in self.particles]

    def end(self, places, forces):
        for p, v0, place, force in zip(self.particles, self.velocities, places, forces):
            p.clear_forces()
            p.add_force(force)
            p.velocity.set(*v0)
            p.integrate(self.h)  # damps and clears too
            if p.has_finite_mass:
                p.position.set(*place)


def check_spring(x, v, stiffness, damping, mass, duration):
    finite("x", x)
    finite("v", v)
    not_negative("stiffness", stiffness)
    not_negative("damping", damping)
    positive("mass", mass)
    positive("duration", duration)


def backward_euler(x, v, stiffness, damping, mass, duration):
    check_spring(x, v, stiffness, damping, mass, duration)
    m, h, c, k = mass, duration, damping, stiffness
    v = (m * v - h * k * x) / (m + h * c + h * h * k)
    return x + v * h, v


def trapezoidal(x, v, stiffness, damping, mass, duration):
    check_spring(x, v, stiffness, damping, mass, duration)
    m, h, c, k = mass, duration, damping, stiffness
    brake = h * c / 2 + h * h * k / 4
    new = (v * (m - brake) - h * k * x) / (m + brake)
    return x + (v + new) * h / 2, new


class SimulationDiverged(ArithmeticError):
    """Some particle is too fast to be true."""

    def __init__(self, particle, step, speed, limit):
        super().__init__(
            f"particle {particle} has {speed:.4g} m/s after step {step}, over the limit of "
            f"{limit:g} m/s: shorter frames, softer springs or another step would help"
        )
        self.particle, self.step, self.speed, self.limit = particle, step, speed, limit


def watched(integrator, speed_limit):
    limit = positive("speed_limit", speed_limit)
    steps = 0

    def watched_step(particles, apply_forces, duration):
        nonlocal steps
        integrator(particles, apply_forces, duration)
        steps += 1
        for i, p in enumerate(particles):
            speed = p.velocity.magnitude()
            if not speed <= limit:  # so that NaN is found as well
                raise SimulationDiverged(i, steps, speed, limit)

    return watched_step
