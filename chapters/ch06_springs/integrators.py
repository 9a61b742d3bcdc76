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
    raise NotImplementedError("Exercise B6.6: Explicit and semi-implicit Euler")


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of semi-implicit Euler: v' = (v + a h) d^h, and then p' = p + v' h."""
    raise NotImplementedError("Exercise B6.6: Explicit and semi-implicit Euler")


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Move for half the step, update the velocity for the whole step, and move for the other half.

    A step is p1 = p + v h / 2, then v' = (v + a h) d^h with a at p1, then p' = p1 + v' h / 2.
    """
    raise NotImplementedError("Exercise B6.12: Leapfrog")


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one velocity Verlet step, which uses the mean of the old and the new acceleration.

    First p' = p + v h + a h^2 / 2, and then v' = (v + (a + b) h / 2) d^h. Here a and b are the
    accelerations at the old and the new position. For forces that depend on the velocity, use
    v + a h in b.
    """
    raise NotImplementedError("Exercise B6.7: Velocity Verlet")


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of the classical fourth-order Runge-Kutta method.

    The step uses a weighted mean of four rates, in which the second and third rates count double. A
    rate consists of the velocity and the acceleration of a particle. Evaluate the first rate at the
    start of the step. To find each later rate, return to the start, and move at the previous rate:
    for half the step to find the second and third rates, and for the whole step to find the fourth.
    """
    raise NotImplementedError("Exercise B6.8: Runge-Kutta of order 4")


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with backward Euler, and return its new position and velocity.

    The new values x' and v' solve x' = x + v' h and v' = v + a' h, where m a' = -(k x' + c v'). The
    spring is at rest at x = 0. Positions are in m and velocities in m/s. In the equations, k is
    ``stiffness`` in N/m, c is ``damping`` in N s/m, m is ``mass`` in kg and h is ``duration`` in s.
    """
    raise NotImplementedError("Exercise B6.9: Implicit steps for one spring")


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with the trapezoidal rule, and return its new position and velocity.

    The new values solve x' = x + (v + v') h / 2 and v' = v + (a + a') h / 2, with m a = -k x - c v.
    The arguments are those of ``backward_euler``.
    """
    raise NotImplementedError("Exercise B6.9: Implicit steps for one spring")


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
    raise NotImplementedError("Exercise B6.10: A warning when it explodes")
