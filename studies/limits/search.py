"""Find the limits beyond which integrators are unstable, and measure the energy within them.

There are limits for springs, drag, and the ground of the penalty method. A time step multiplies the
position and velocity on a spring by a matrix, and the velocity under drag by a factor. The motion
is unstable if this factor, or an eigenvalue of the matrix, exceeds 1 in magnitude. The limits,
including those of pymunk, are found by bisection.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import pymunk

from ch05_forces.forces import Drag
from ch06_springs.integrators import Integrator
from scenes.integrators import INTEGRATORS, SOLVERS, Solver
from scenes.stability import (
    Pull,
    bounces,
    faked_growth,
    growth,
    limit_of,
    methods,
    solving,
    step_matrix,
    theory,
)

FRAME = 1.0 / 60.0
KEPT = (1.0, 0.9, 0.5)  # fraction of the velocity that a step keeps, by the particle's damping
DAMPERS = (0.0, 0.5)  # c h / m of the spring, for methods in which the spring has the damping
LEAST, MOST = 1e-3, 1e6  # range of k h^2 / m and of k1 h / m
OUTSIDE, HUGE = 1.02, 1e6
STIFFNESS = 100.0  # N/m, for 38 frames per oscillation
State = tuple[float, float]
Growth = Callable[[float], float]


class Bound(NamedTuple):
    """The measured and the theoretical stability limit of an integrator, for a spring or for drag.

    A limit of infinity means that there is none. ``steps`` is the number of time steps in which the
    motion grows by a factor of HUGE slightly beyond the limit. It is NaN if there is no such
    number.
    """

    method: str
    at: str
    found: float
    theory: float
    steps: float


def pymunk_step(
    by_hand: bool, x: float, v: float, k: float, c: float, mass: float, duration: float
) -> State:
    """Take one time step of a pymunk body on a spring, and return its position and velocity.

    If ``by_hand`` is true, the force of the spring is applied as an ordinary force. Otherwise
    pymunk's own spring is used.
    """
    space = pymunk.Space()
    body = pymunk.Body(mass, 1.0)
    body.position, body.velocity = (x, 0.0), (v, 0.0)
    space.add(body)
    if by_hand:
        body.apply_force_at_world_point((-k * x - c * v, 0.0), body.position)
    else:
        still = space.static_body
        space.add(pymunk.DampedSpring(body, still, (0, 0), (0, 0), 0.0, k, c))
    space.step(duration)
    return body.position.x, body.velocity.x


def pymunk_damping(x: float, v: float, k: float, c: float, mass: float, duration: float) -> State:
    """Take one time step of a pymunk body without a spring, slowed by the damping of its space."""
    del k
    space = pymunk.Space()
    space.damping = math.exp(-c / mass)
    body = pymunk.Body(mass, 1.0)
    body.position, body.velocity = (x, 0.0), (v, 0.0)
    space.add(body)
    space.step(duration)
    return body.position.x, body.velocity.x


PYMUNK: dict[str, Solver] = {
    "pymunk's spring": partial(pymunk_step, False),
    "pymunk, by hand": partial(pymunk_step, True),
}


def stepping(name: str, kappa: float, damping: float) -> tuple[Integrator, Pull, float]:
    """Create an integrator and a spring, to measure how fast oscillations grow.

    ``kappa`` is k h^2 / m, where k is the stiffness, h is the time step, and m is the mass. For our
    integrators, the particle is damped, and ``damping`` is d^h, the fraction of its velocity that
    is left after a step. For other methods, the spring is damped, and ``damping`` is c h / m, where
    c is its damping. Return the integrator, the spring, and the damping d of the particle.
    """
    k = kappa / FRAME**2
    if name in INTEGRATORS:
        return INTEGRATORS[name], Pull(k), damping ** (1.0 / FRAME)
    return solving((SOLVERS | PYMUNK)[name], k, damping / FRAME), Pull(k), 1.0


def growth_at(name: str, damping: float, kappa: float) -> float:
    """Compute how much oscillations grow in one time step of the integrator ``name``, as a factor.

    ``kappa`` is the stiffness of the spring as k h^2 / m, where h is the time step. ``damping`` is
    d^h for one of our integrators, and c h / m for any other method.
    """
    integrator, pull, d = stepping(name, kappa, damping)
    return growth(integrator, pull, FRAME, d)


def theory_at(name: str, damping: float) -> float:
    """Return the theoretical stability limit of a spring, as k h^2 / m.

    The parameters are the same as in ``growth_at``. A step with pymunk's own spring equals a step
    of semi-implicit Euler that keeps e^(-c h / m) of the velocity. A step with a force applied by
    hand equals explicit Euler. Its matrix has the determinant 1 - c h / m + k h^2 / m. The limit is
    reached when the determinant is 1, provided that c h / m is at most 2.
    """
    if name in SOLVERS:
        return math.inf
    if name == "pymunk's spring":
        return theory("semi-implicit Euler", math.exp(-damping))
    if name == "pymunk, by hand":
        return damping
    return theory(name, damping)


def spring_limits() -> list[Bound]:
    """Measure the largest stiffness that each integrator tolerates, with and without damping.

    The stiffness is given as k h^2 / m, where h is the time step.
    """
    rows = []
    for name in INTEGRATORS:
        rows += [spring_limit(name, kept, f"d^h = {kept:g}") for kept in KEPT]
    for name in PYMUNK:
        rows += [spring_limit(name, c, f"c h / m = {c:g}") for c in DAMPERS]
    rows += [spring_limit(name, 0.0, "c h / m = 0") for name in SOLVERS]
    # A step of (x, v h) has the trace cos(a) + sin(a) / a and the determinant sin(a) / a, with
    # a = chi h. The lower eigenvalue passes -1 at a zero of 1 + cos(a) + 2 sin(a) / a. The first
    # is pi.
    faked = bound(
        "faked stiff spring", "undamped", lambda k: faked_growth(k**0.5, 0.0, FRAME), math.pi**2
    )
    return [*rows, faked, ground_limit()]


def spring_limit(name: str, damping: float, at: str) -> Bound:
    """Measure the stability limit of a spring with the integrator ``name``, as k h^2 / m.

    ``damping`` is the same as in ``growth_at``. ``at`` describes the damping in the result, such as
    "d^h = 0.5".
    """
    return bound(name, at, partial(growth_at, name, damping), theory_at(name, damping))


def ground_limit() -> Bound:
    """Find the k h^2 / m above which a PenaltyGround throws a resting body into the air.

    Here k is the stiffness of the ground, and h is the time step. In theory the limit is 4, as for
    a spring that is simulated with semi-implicit Euler.
    """
    found = first(lambda kappa: 2.0 if thrown(kappa) else 1.0)
    return Bound("penalty ground", "at rest", found, 4.0, float(thrown(OUTSIDE * found)))


def thrown(kappa: float) -> int:
    """Count the time steps until the penalty ground throws a resting body into the air.

    The body starts slightly deeper than in equilibrium, by 1 / HUGE of the equilibrium depth. It
    leaves the ground when this difference has grown by a factor of HUGE. Return 0 if the body is
    still on the ground after 2000 steps.
    """
    depth = 10.0 / (kappa / FRAME**2)
    heights = bounces(kappa / FRAME**2, -depth * (1.0 + 1.0 / HUGE), 2000)
    return next((i for i, height in enumerate(heights) if height > 0.0), 0)


# The values of z = k1 h / m above which a speed grows in a step, and above which it reverses. The
# Euler steps, leapfrog and pymunk with a force by hand multiply the speed by 1 - z. Verlet, which
# evaluates its second force at v + a h, multiplies the speed by 1 - z / 2 - z (1 - z) / 2. This is
# 1 - z + z^2 / 2 and at least 1/2. Runge-Kutta's series, 1 - z + z^2 / 2 - z^3 / 6 + z^4 / 24, is
# also positive, and is 1 again at the root of z^3 - 4 z^2 + 12 z - 24. Backward Euler multiplies by
# 1 / (1 + z), and the trapezoidal rule by (1 - z / 2) / (1 + z / 2). Methods that damp by d^h, such
# as pymunk's spring, multiply by e^-z.
DRAG_THEORY = {
    "explicit Euler": (2.0, 1.0),
    "semi-implicit Euler": (2.0, 1.0),
    "leapfrog": (2.0, 1.0),
    "velocity Verlet": (2.0, math.inf),
    "Runge-Kutta 4": (2.785293563405282, math.inf),
    "backward Euler": (math.inf, math.inf),
    "trapezoidal rule": (math.inf, 2.0),
    "pymunk, by hand": (2.0, 1.0),
    "pymunk's spring": (math.inf, math.inf),
    "pymunk's space.damping": (math.inf, math.inf),
}


def drag_limits() -> list[Bound]:
    """Measure the drag above which a time step speeds up a body or reverses its velocity.

    The drag is given as k1 h / m, where k1 is the drag coefficient and h is the time step.
    """
    rows = []
    for name, (grows, turns) in DRAG_THEORY.items():
        kept = partial(drag_factor, name)
        rows.append(bound(name, "growth", lambda z, kept=kept: abs(kept(z)), grows))  # type: ignore[misc]
        # The speed reverses if a step removes more than the whole speed.
        turned = first(lambda z, kept=kept: 1.0 - kept(z))  # type: ignore[misc]
        rows.append(Bound(name, "reversal", turned, turns, math.nan))
    return rows


def drag_factor(name: str, z: float) -> float:
    """Compute the velocity after one time step with drag alone, divided by the velocity before.

    ``z`` is k1 h / m, where k1 is the drag coefficient and h is the time step. Our integrators use
    the class Drag of chapter 5. The other methods simulate a damped spring of stiffness 0.
    """
    k1 = z / FRAME
    if name in INTEGRATORS:
        return step_matrix(INTEGRATORS[name], Drag(k1, 0.0), FRAME)[3]
    solvers = SOLVERS | PYMUNK | {"pymunk's space.damping": pymunk_damping}
    return step_matrix(solving(solvers[name], 0.0, k1), Pull(0.0), FRAME)[3]


def bound(name: str, at: str, growth: Growth, theory: float) -> Bound:
    """Measure the stability limit of a stiffness or drag, and compare it with theory.

    ``growth`` returns the factor by which the motion grows per time step for a given stiffness or
    drag. The result also contains the number of steps to divergence at 1.02 times the limit.
    """
    found = first(growth)
    bears = 0.0 < found < math.inf
    steps = math.log(HUGE) / math.log(growth(OUTSIDE * found)) if bears else math.nan
    return Bound(name, at, found, theory, steps)


def first(growth: Growth) -> float:
    """Find by bisection the smallest value at which ``growth`` exceeds 1.

    The function first tries larger and larger values until ``growth`` exceeds 1, and then bisects.
    Return 0 if it already exceeds 1 at LEAST, and infinity if it does not exceed 1 up to MOST.
    """
    low, high = 0.0, LEAST
    while not growth(high) > 1.0 + 1e-13:
        if high == MOST:
            return math.inf
        low, high = high, min(1.1 * high, MOST)
    return limit_of(growth, low, high) if low else 0.0


def energy_drifts(swings: list[int]) -> dict[str, list[float]]:
    """Measure how the energy of a spring drifts over many oscillations with each integrator.

    ``swings`` lists numbers of oscillations in ascending order. For each of these numbers, return
    the energy as a fraction of the initial energy. Explicit Euler is omitted, because it explodes
    at this stiffness.
    """
    ways = methods(STIFFNESS) | {"pymunk's spring": solving(PYMUNK["pymunk's spring"], STIFFNESS)}
    del ways["explicit Euler"]
    return {
        name: energies_after(step_matrix(way, Pull(STIFFNESS), FRAME), swings)
        for name, way in ways.items()
    }


def energies_after(matrix: tuple[float, float, float, float], swings: list[int]) -> list[float]:
    """Compute the energy of a spring after each number of oscillations in ``swings``.

    Each result is a fraction of the initial energy. It is averaged over one oscillation, because
    with a symplectic integrator only this average is constant. A time step multiplies (x, v h)
    by ``matrix``.
    """
    a, b, c, d = matrix
    length = 2.0 * math.pi / math.sqrt(STIFFNESS) / FRAME
    x, vh, step, means = 1.0, 0.0, 0, []
    for start in (0, *(round(count * length) for count in swings)):
        while step < start:
            x, vh = a * x + b * vh, c * x + d * vh
            step += 1
        total, y, wh = 0.0, x, vh
        for _ in range(round(length)):
            total += 0.5 * STIFFNESS * y * y + 0.5 * (wh / FRAME) ** 2
            y, wh = a * y + b * wh, c * y + d * wh
        means.append(total)
    return [mean / means[0] for mean in means[1:]]
