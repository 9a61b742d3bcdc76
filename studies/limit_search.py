"""Limits of what a step bears, by bisection: springs, drag and a ground; and energies inside.

A step is a linear map of place and velocity, so a spring's limit is where the larger eigenvalue
leaves 1, and that of drag where a step's share of the velocity does. Pymunk is measured alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import pymunk

from ch05_forces.forces import Drag
from ch06_springs.integrators import Integrator
from studies.stability import (
    INTEGRATORS,
    SOLVERS,
    Pull,
    Solver,
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
KEPT = (1.0, 0.9, 0.5)  # of the velocity, by the particle's damping, in a step
DAMPERS = (0.0, 0.5)  # c h / m of the spring, where it is the spring that damps
LEAST, MOST = 1e-3, 1e6  # of k h^2 / m and of k1 h / m
OUTSIDE, HUGE = 1.02, 1e6
STIFFNESS = 100.0  # N/m: 38 frames a swing
State = tuple[float, float]
Growth = Callable[[float], float]


class Bound(NamedTuple):
    """A limit: of what, where, as it was found and as theory has it; infinite where there is none.

    ``steps`` is how many steps just outside multiply a swing by HUGE, NaN where nothing grows.
    """

    method: str
    at: str
    found: float
    theory: float
    steps: float


def pymunk_step(
    by_hand: bool, x: float, v: float, k: float, c: float, mass: float, duration: float
) -> State:
    """Return place and velocity of a body of pymunk on a spring a step later, as a Solver does."""
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
    """Return place and velocity of a body in a space of pymunk whose damping d is e^(-c / m)."""
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
    """Return a method, its spring of k h^2 / m = kappa, and the particle's damping d.

    ``damping`` is d^h of the particle for an integrator, and c h / m of the spring for the others.
    """
    k = kappa / FRAME**2
    if name in INTEGRATORS:
        return INTEGRATORS[name], Pull(k), damping ** (1.0 / FRAME)
    return solving((SOLVERS | PYMUNK)[name], k, damping / FRAME), Pull(k), 1.0


def growth_at(name: str, damping: float, kappa: float) -> float:
    """Return the growth of a method by its name, pymunk's too, at k h^2 / m = kappa."""
    integrator, pull, d = stepping(name, kappa, damping)
    return growth(integrator, pull, FRAME, d)


def theory_at(name: str, damping: float) -> float:
    """Return the k h^2 / m above which a spring explodes, with the damping of ``stepping``.

    Pymunk's spring is stepped p' = p + v h, v' = (v + a' h) e^(-c h / m): as semi-implicit Euler
    does with D = e^(-c h / m). A force by hand makes explicit Euler of it, whose determinant
    1 - c h / m + kappa is 1 where kappa = c h / m, up to c h / m = 2.
    """
    if name in SOLVERS:
        return math.inf
    if name == "pymunk's spring":
        return theory("semi-implicit Euler", math.exp(-damping))
    if name == "pymunk, by hand":
        return damping
    return theory(name, damping)


def spring_limits() -> list[Bound]:
    """Return the limits of k h^2 / m of every method, for springs with and without damping."""
    rows = []
    for name in INTEGRATORS:
        rows += [spring_limit(name, kept, f"d^h = {kept:g}") for kept in KEPT]
    for name in PYMUNK:
        rows += [spring_limit(name, c, f"c h / m = {c:g}") for c in DAMPERS]
    rows += [spring_limit(name, 0.0, "c h / m = 0") for name in SOLVERS]
    # A step from (x, v h) has the trace cos(a) + sin(a) / a and the determinant sin(a) / a, with
    # a = chi h: the lower eigenvalue passes -1 where 1 + cos(a) + 2 sin(a) / a is 0, first at pi.
    faked = bound(
        "faked stiff spring", "undamped", lambda k: faked_growth(k**0.5, 0.0, FRAME), math.pi**2
    )
    return [*rows, faked, ground_limit()]


def spring_limit(name: str, damping: float, at: str) -> Bound:
    """Return the limit of a method with the damping of ``stepping``."""
    return bound(name, at, partial(growth_at, name, damping), theory_at(name, damping))


def ground_limit() -> Bound:
    """Return the k h^2 / m at which a penalty ground throws what lies on it: that of its step."""
    found = first(lambda kappa: 2.0 if thrown(kappa) else 1.0)
    return Bound("penalty ground", "what lies", found, 4.0, float(thrown(OUTSIDE * found)))


def thrown(kappa: float) -> int:
    """Return after how many steps of 2000 a body is out of the ground that it lay on; 0 for none.

    It starts a HUGE part of its depth below where the ground bears it, so that it is thrown when
    that has become HUGE times as large.
    """
    depth = 10.0 / (kappa / FRAME**2)
    heights = bounces(kappa / FRAME**2, -depth * (1.0 + 1.0 / HUGE), 2000)
    return next((i for i, height in enumerate(heights) if height > 0.0), 0)


# Above which z = k1 h / m a speed grows in a step, and above which it turns round. Euler's steps,
# leapfrog, and a force by hand in pymunk multiply it by 1 - z. Verlet asks for its second force
# with v + a h and so multiplies by 1 - z / 2 - z (1 - z) / 2 = 1 - z + z^2 / 2, which is 1/2 or
# more; Runge and Kutta's series 1 - z + z^2 / 2 - z^3 / 6 + z^4 / 24 is positive as well, and is 1
# again at the root of z^3 - 4 z^2 + 12 z - 24. Backward Euler has 1 / (1 + z), the trapezoidal rule
# (1 - z / 2) / (1 + z / 2), and all that damps by d^h, as pymunk's spring does, e^-z.
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
    """Return the limits of k1 h / m of every method: of growth, and of turning round in a step."""
    rows = []
    for name, (grows, turns) in DRAG_THEORY.items():
        kept = partial(drag_factor, name)
        rows.append(bound(name, "growth", lambda z, kept=kept: abs(kept(z)), grows))  # type: ignore[misc]
        # What a step takes of a speed is more than all of it where the speed turns round.
        turned = first(lambda z, kept=kept: 1.0 - kept(z))  # type: ignore[misc]
        rows.append(Bound(name, "reversal", turned, turns, math.nan))
    return rows


def drag_factor(name: str, z: float) -> float:
    """Return what a step under drag alone multiplies a speed by, at k1 h / m = z.

    Integrators are asked with the force of chapter 5, the others with their damper and no spring.
    """
    k1 = z / FRAME
    if name in INTEGRATORS:
        return step_matrix(INTEGRATORS[name], Drag(k1, 0.0), FRAME)[3]
    solvers = SOLVERS | PYMUNK | {"pymunk's space.damping": pymunk_damping}
    return step_matrix(solving(solvers[name], 0.0, k1), Pull(0.0), FRAME)[3]


def bound(name: str, at: str, growth: Growth, theory: float) -> Bound:
    """Return where growth begins, what theory has, and how soon a swing just outside is huge."""
    found = first(growth)
    bears = 0.0 < found < math.inf
    steps = math.log(HUGE) / math.log(growth(OUTSIDE * found)) if bears else math.nan
    return Bound(name, at, found, theory, steps)


def first(growth: Growth) -> float:
    """Return where growth begins, by bisection below the first of many places that have it.

    That is 0 where LEAST has it already, and infinity where none up to MOST has it.
    """
    low, high = 0.0, LEAST
    while not growth(high) > 1.0 + 1e-13:
        if high == MOST:
            return math.inf
        low, high = high, min(1.1 * high, MOST)
    return limit_of(growth, low, high) if low else 0.0


def energy_drifts(swings: list[int]) -> dict[str, list[float]]:
    """Return for each method what so many swings, in rising order, have made of an energy of 1.

    Explicit Euler is left out: at this stiffness it explodes.
    """
    ways = methods(STIFFNESS) | {"pymunk's spring": solving(PYMUNK["pymunk's spring"], STIFFNESS)}
    del ways["explicit Euler"]
    return {
        name: energies_after(step_matrix(way, Pull(STIFFNESS), FRAME), swings)
        for name, way in ways.items()
    }


def energies_after(matrix: tuple[float, float, float, float], swings: list[int]) -> list[float]:
    """Return the energy after so many swings, that at the start being 1, as the mean of a swing.

    ``matrix`` is that of a step of (x, v h). The energy of a symplectic method swings, and its mean
    stays.
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
