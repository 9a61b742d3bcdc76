"""Integrators: methods that move particles forward by one time step.

The first five integrators take ``(particles, apply_forces, duration)``. ``particles`` lists each
particle once. ``apply_forces(duration)`` adds the current forces to the accumulators of these
particles only, as ``ForceRegistry.update_forces`` does. It may be called several times, always with
the duration of the whole step. A force may depend on two particles, so move all particles before
you call it again. Before each call, the accumulators must contain exactly the forces that were
added by hand before the step. After the step they are empty, and ``Particle.last_acceleration`` is
the mean acceleration of the step.

In the formulas, p is a position, v a velocity, a an acceleration and h the ``duration`` in s. A
particle's own damping d multiplies its velocity by d^h once, at the end of a step. Immovable
particles do not move, and keep their velocities. The orders are given for d = 1, because for any
other d the order is 1. Stability limits apply to k h^2 / m, for a mass m on an undamped spring k,
and d = 1 unless noted.

If ``apply_forces`` raises an exception, the particles are left in the middle of the step.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import (
    adaptive as adaptive,  # so that it is found with the others
)

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]


def explicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of explicit Euler: move each particle first, and then update its velocity.

    The step is p' = p + v h, and then v' = (v + a h) d^h. The method has order 1, is not
    symplectic, and evaluates the forces once. At d = 1 every undamped spring is unstable. For
    d < 1, undamped springs below ``max_stable_stiffness`` are stable. With a damper c, a spring is
    stable if k h < c and 2 c h / m < 4 + k h^2 / m. The book's name differs (3.3.2, E-17).
    """
    raise NotImplementedError("Exercise B6.6: Explicit and semi-implicit Euler")


def semi_implicit_euler(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of semi-implicit Euler: update each velocity first, and then move the particle.

    The step is v' = (v + a h) d^h, and then p' = p + v' h. The method has order 1 and evaluates the
    forces once. If d = 1 and no force depends on the velocity, it is symplectic, so the energy of a
    stable spring does not drift. It is stable for k h^2 / m < 4. With damping d this limit grows to
    2 (1 + d^h) / d^h. A damper c in the spring lowers it to k h^2 / m + 2 c h / m < 4. Source:
    Hairer, Lubich and Wanner, Geometric Numerical Integration, I.1.2.
    """
    raise NotImplementedError("Exercise B6.6: Explicit and semi-implicit Euler")


def leapfrog(particles: Sequence[Particle], apply_forces: ApplyForces, duration: float) -> None:
    """Move for half the step, update the velocity for the whole step, and move for the other half.

    A step is p1 = p + v h / 2, then v' = (v + a h) d^h with a at p1, then p' = p1 + v' h / 2. The
    forces are evaluated only once, in the middle of the step, and the damping acts once.

    If d = 1 and no force depends on the velocity, the order is 2, and the method is symplectic. A
    force that does depend on it is evaluated with the old velocity, which reduces the order to 1.

    It is stable for k h^2 / m < 4. With damping d and a damper c in the spring, the condition is k
    h^2 / m + 2 c h / m < 2 (1 + d^h) / d^h. Semi-implicit Euler has the same limits. After its
    first half step, leapfrog updates the velocity and the position in turn, just as semi-implicit
    Euler does. Source: Hairer, Lubich and Wanner, Acta Numerica 12 (2003), 399.
    """
    raise NotImplementedError("Exercise B6.12: Leapfrog")


def velocity_verlet(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one velocity Verlet step, which uses the mean of the old and the new acceleration.

    First p' = p + v h + a h^2 / 2, and then v' = (v + (a + b) h / 2) d^h. Here a and b are the
    accelerations at the old and the new position. For forces that depend on the velocity, use
    v + a h in b. Forces that were added by hand before the step count in both a and b.

    The method has order 2. It evaluates the forces twice, because b may change between two steps,
    for example in a contact. It is symplectic if d = 1 and no force depends on the velocity. It is
    stable for k h^2 / m < 4, even if d < 1. A damper c in the spring lowers this limit to 4 - 2 r +
    r^2 with r = c h / m < 2. Source: Swope and others, J. Chem. Phys. 76 (1982), 637.
    """
    raise NotImplementedError("Exercise B6.7: Velocity Verlet")


def runge_kutta_4(
    particles: Sequence[Particle], apply_forces: ApplyForces, duration: float
) -> None:
    """Make one step of the classical fourth-order Runge-Kutta method.

    The step uses a weighted mean of four rates, in which the second and third rates count double. A
    rate consists of the velocity and the acceleration of a particle. Evaluate the first rate at the
    start of the step. To find each later rate, return to the start, move at the previous rate, and
    evaluate the rate there. Move for half the step to find the second and third rates, and for the
    whole step to find the fourth.

    The method has order 4, makes four evaluations, and is not symplectic. An undamped spring loses
    about (k h^2 / m)^3 / 72 of its energy per step. It is stable for k h^2 / m < 8, or more if d <
    1. With a damper c, |1 + z + z^2 / 2 + z^3 / 6 + z^4 / 24| must be below 1 for both roots z of
    z^2 + (c h / m) z + k h^2 / m = 0. Source: Kutta, Zeitschr. Math. Phys. 46 (1901), 435.
    """
    raise NotImplementedError("Exercise B6.8: Runge-Kutta of order 4")


def backward_euler(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with backward Euler, and return its new position and velocity.

    The new values x' and v' solve x' = x + v' h and v' = v + a' h, where m a' = -(k x' + c v'). The
    spring is at rest at x = 0. Positions are in m and velocities in m/s. In the equations, k is
    ``stiffness`` in N/m, c is ``damping`` in N s/m, m is ``mass`` in kg and h is ``duration`` in s.

    The method has order 1, is not symplectic, and evaluates no forces. It is stable for every
    stiffness, but even without damping it loses energy, and the stiffer the spring, the more.
    Source: Hairer and Wanner, Solving Ordinary Differential Equations II, IV.3.
    """
    raise NotImplementedError("Exercise B6.9: Implicit steps for one spring")


def trapezoidal(
    x: float, v: float, stiffness: float, damping: float, mass: float, duration: float
) -> tuple[float, float]:
    """Step a body on a spring with the trapezoidal rule, and return its new position and velocity.

    The new values solve x' = x + (v + v') h / 2 and v' = v + (a + a') h / 2, with m a = -k x - c v.
    The arguments and units are those of ``backward_euler``.

    The method has order 2 and evaluates no forces. It is stable for every stiffness. Without
    damping it is symplectic and conserves the energy of the spring. Source: Hairer and Wanner,
    Solving Ordinary Differential Equations II, IV.3.
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

    In each step, the new integrator calls ``integrator`` once, with the same arguments. It counts
    its own steps, and raises SimulationDiverged for the first particle whose speed is NaN or above
    ``speed_limit`` in m/s. It can be called again after that, and goes on counting. A step in which
    ``integrator`` raises an exception does not count.
    """
    raise NotImplementedError("Exercise B6.10: A warning when it explodes")
