"""Define four scenes with rods, in which our engine is compared with pymunk.

They are a pendulum, a double pendulum, five rods with a heavy tip, and a rope.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise
from typing import Any

from scipy.special import ellipj  # type: ignore[import-untyped]

from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.going_further.angle_pendulum import AnglePendulum, DoublePendulum
from ch07_constraints.links import TwoSidedRod
from studies.accuracy.scene import STEPS, Model, Outcome, Place, Scene, flat, in_frames
from studies.accuracy.scenes.chains import COUNTED, Chain, by_resolver, models_of

G = 9.81  # m/s^2
ROUND_G = 10.0  # m/s^2, in the scenes of the pendulum and of the rope


def pendulum() -> Scene:
    """Create the scene of a 1 m pendulum that is released from horizontal and swings for 5 s."""
    chain = Chain(1.0, [1.0], 0.5 * math.pi, ROUND_G, frames=300)

    def truth(time: float) -> Place:
        """Compute the exact position of the pendulum's bob at ``time`` with elliptic functions.

        With u = t sqrt(g / l), where t is the time in s, the angle follows from

            sin(angle / 2) = sin(start / 2) cn(u) / dn(u)

        Here cn and dn are Jacobi's elliptic functions.
        """
        m = math.sin(0.25 * math.pi) ** 2
        _, cn, dn, _ = ellipj(math.sqrt(ROUND_G) * time, m)
        half = math.asin(math.sqrt(m) * cn / dn)
        return math.sin(2.0 * half), -math.cos(2.0 * half)

    def by_angle(steps: int) -> Outcome:
        bob = AnglePendulum(1.0, 0.5 * math.pi, gravity=ROUND_G)
        places = in_frames(bob.step, lambda: (bob.position.x, bob.position.y), chain.frames, steps)
        return Outcome(places, 4 * chain.frames * steps)

    _, *others = models_of(chain, STEPS, 1)  # by_angle replaces the first one
    models = [Model("by its angle, Runge-Kutta 4", by_angle, is_formula=True), *others]
    return Scene("pendulum from horizontal", chain.frames, 1.0, truth, models, COUNTED)


def double_pendulum() -> Scene:
    """Create the scene of a double pendulum that swings for 2 s.

    It has two bobs of 1 kg on two rods of 1 m, both released at 60 degrees from straight down.
    """
    chain = Chain(1.0, [1.0, 1.0], math.radians(60.0), G, frames=120)

    def by_two_angles(steps: int) -> Outcome:
        bobs = DoublePendulum(*chain.angles(), gravity=G)
        places = in_frames(bobs.step, lambda: flat(bobs.positions), chain.frames, steps)
        return Outcome(places, 4 * chain.frames * steps)

    models = [
        Model("by its two angles, Runge-Kutta 4", by_two_angles, is_formula=True),
        *models_of(chain, STEPS, 2, 10),
    ]
    return Scene("double pendulum", chain.frames, 1.0, chain.truth(), models, COUNTED)


def heavy_tip() -> Scene:
    """Create the scene of a chain with a heavy tip that swings for 2 s.

    The chain has five rods of 1 m, with 1 kg at each joint and a bob of 10 kg at the tip. It is
    released at 60 degrees from straight down.
    """
    chain = Chain(1.0, [1.0, 1.0, 1.0, 1.0, 10.0], math.radians(60.0), G, frames=120)
    models = models_of(chain, STEPS, 35, 50)
    return Scene("five rods, heavy tip", chain.frames, 1.0, chain.truth(), models, COUNTED)


def rope() -> Scene:
    """Create the scene of a rope that swings for 1 s.

    The rope has thirty rods of 0.1 m, each with a particle of 0.1 kg at its end. It is released at
    30 degrees from straight down.
    """
    chain = Chain(0.1, [0.1] * 30, math.radians(30.0), ROUND_G, frames=60)
    steps = STEPS[:6]

    def two_sided(particles: Sequence[Particle]) -> list[Any]:
        still = Particle(mass=math.inf)
        return [TwoSidedRod(a, b, chain.length) for a, b in pairwise([still, *particles])]

    run = partial(by_resolver, chain, semi_implicit_euler, two_sided)
    models = models_of(chain, steps, 100, 300)
    models.append(Model("semi-implicit Euler, two-sided rods", run, steps))
    return Scene("rope of 30 links", chain.frames, 3.0, chain.truth(), models, COUNTED)


LINKED: list[Callable[[], Scene]] = [pendulum, double_pendulum, heavy_tip, rope]
