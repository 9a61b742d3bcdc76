"""Find the limits beyond which integrators and pymunk are unstable, and the energy within them.

A time step multiplies the position and velocity on a spring by a matrix, and the velocity under
drag by a factor. The motion is unstable if the factor, or an eigenvalue, exceeds 1 in magnitude.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

from ch05_forces.forces import Drag
from scenes import stability
from scenes.clock import FRAME
from scenes.integrators import INTEGRATORS, SOLVERS
from scenes.spring_on_a_wall import SpringOnAWall
from studies.models.pymunk_solvers import ON_SPRING, PYMUNK

KEPT = (1.0, 0.9, 0.5)  # fraction of the velocity that a step keeps, by the particle's damping
DAMPERS = (0.0, 0.5)  # c h / m of the spring, for methods in which the spring has the damping
LEAST, MOST = 1e-3, 1e6  # range of k h^2 / m and of k1 h / m
OUTSIDE, HUGE = 1.02, 1e6
STIFFNESS = 100.0  # N/m, for 38 frames per oscillation
KAPPA = STIFFNESS * FRAME**2
Growth = Callable[[float], float]


class Bound(NamedTuple):
    """The measured and the theoretical limit of a method, or infinity if there is none."""

    method: str
    at: str
    found: float
    theory: float
    steps: float  # to grow by a factor of HUGE at OUTSIDE times the limit


ALL_SOLVERS = SOLVERS | PYMUNK
growth_at = partial(stability.growth_of, solvers=ALL_SOLVERS)


def theory_at(name: str, damping: float) -> float:
    """Return the theoretical limit of k h^2 / m for the arguments of ``growth_at``."""
    if name in SOLVERS:
        return math.inf
    if name == "pymunk's spring":
        return stability.theory("semi-implicit Euler", math.exp(-damping))
    return damping if name == "pymunk, by hand" else stability.theory(name, damping)


def spring_limits() -> list[Bound]:
    """Measure the largest k h^2 / m that each method tolerates, with and without damping."""
    cases = [(name, kept, f"d^h = {kept:g}") for name in INTEGRATORS for kept in KEPT]
    cases += [(name, c, f"c h / m = {c:g}") for name in ON_SPRING for c in DAMPERS]
    cases += [(name, 0.0, "c h / m = 0") for name in SOLVERS]
    rows = [
        bound(name, at, partial(growth_at, name, damping), theory_at(name, damping))
        for name, damping, at in cases
    ]
    # A step of (x, v h) has the trace cos(a) + sin(a) / a and the determinant sin(a) / a, with
    # a = chi h. The lower eigenvalue passes -1 at a zero of 1 + cos(a) + 2 sin(a) / a. The first
    # is pi.
    faked = bound(
        "faked stiff spring", "undamped", lambda k: stability.faked_growth(k**0.5, 0.0), math.pi**2
    )
    # The ground's limit is that of semi-implicit Euler.
    found = first(lambda kappa: 2.0 if thrown(kappa) else 1.0)
    steps = float(thrown(OUTSIDE * found))
    return [*rows, faked, Bound("penalty ground", "at rest", found, 4.0, steps)]


def thrown(kappa: float) -> int:
    """Count the time steps until a PenaltyGround throws a resting body up, or return 0 after 2000.

    The body starts deeper than in equilibrium by 1 / HUGE of the equilibrium depth, and leaves when
    this difference has grown by a factor of HUGE.
    """
    stiffness = kappa / FRAME**2
    depth = 10.0 / stiffness
    heights = stability.bounces(stiffness, -depth * (1.0 + 1.0 / HUGE), 2000)
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
    """Measure the k1 h / m above which a time step speeds up a body or reverses its velocity."""
    rows = []
    for name, (grows, turns) in DRAG_THEORY.items():
        kept = partial(drag_factor, name)
        rows.append(bound(name, "growth", lambda z, kept=kept: abs(kept(z)), grows))  # type: ignore[misc]
        # The speed reverses if a step removes more than the whole speed.
        turned = first(lambda z, kept=kept: 1.0 - kept(z))  # type: ignore[misc]
        rows.append(Bound(name, "reversal", turned, turns, math.nan))
    return rows


def drag_factor(name: str, z: float) -> float:
    """Return the factor between the velocities after and before a step with k1 h / m = ``z``."""
    if name in INTEGRATORS:
        return stability.step_matrix(INTEGRATORS[name], Drag(z / FRAME, 0.0))[3]
    slack = stability.stepping(name, z, 0.0, ALL_SOLVERS)  # a spring of stiffness 0
    return stability.step_matrix(*slack)[3]


def bound(name: str, at: str, growth: Growth, theory: float) -> Bound:
    """Measure the limit of a stiffness or drag, where ``growth`` exceeds 1."""
    found = first(growth)
    bears = 0.0 < found < math.inf
    steps = math.log(HUGE) / math.log(growth(OUTSIDE * found)) if bears else math.nan
    return Bound(name, at, found, theory, steps)


def first(growth: Growth) -> float:
    """Find where ``growth`` first exceeds 1. Return 0 for below LEAST, and inf for above MOST."""
    low, high = 0.0, LEAST
    while not growth(high) > 1.0 + 1e-13:
        if high == MOST:
            return math.inf
        low, high = high, min(1.1 * high, MOST)
    return stability.limit_of(growth, low, high) if low else 0.0


def energy_drifts(swings: Sequence[int]) -> dict[str, list[float]]:
    """Measure a spring's relative energy after each number of oscillations, in ascending order."""
    wall, name = SpringOnAWall(STIFFNESS), "pymunk's spring"
    ways = wall.methods() | {name: wall.solved_by(ALL_SOLVERS[name])}
    del ways["explicit Euler"]
    pull = stability.Pull(STIFFNESS)
    return {
        name: energies_after(stability.step_matrix(way, pull), swings) for name, way in ways.items()
    }


def energies_after(matrix: stability.Matrix, swings: Sequence[int]) -> list[float]:
    """Compute mean energies of oscillations, which a symplectic integrator keeps constant."""
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
