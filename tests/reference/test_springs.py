"""Bungees that end where SciPy has them, and the energy of a spring with a limit."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import runge_kutta_4, velocity_verlet
from ch06_springs.springs import AnchoredBungee, Bungee, ElasticLimitSpring, connect

UP = Vector3(0.0, 1.0, 0.0)


@pytest.mark.parametrize(
    ("damping", "end"),
    [
        (0.0, (-1.7418225184467868, -5.198362149391038, 9.344971003139815, -3.60336010371746)),
        (3.0, (0.11569293131201239, -5.696811999759349, 3.8601764159903738, -1.2865604494233007)),
    ],
)
@pytest.mark.parametrize("kind", [AnchoredBungee, Bungee])
def test_a_jump_on_a_bungee_ends_where_scipy_has_it(
    kind: type[Bungee] | type[AnchoredBungee], damping: float, end: tuple[float, ...]
) -> None:
    """The end states are SciPy's: DOP853, rtol 1e-12, with an event whenever the rope is taut."""
    hook = Vector3() if kind is AnchoredBungee else Particle(mass=math.inf)
    rope = kind(hook, 40.0, 5.0, damping)  # type: ignore[arg-type]
    jumper = Particle(Vector3(0.5), Vector3(1.0), UP * -10.0, mass=2.0)
    registry = ForceRegistry()
    registry.add(jumper, rope)
    for _ in range(8000):
        runge_kutta_4([jumper], registry.update_forces, 4.0 / 8000)
    p, v = jumper.position, jumper.velocity
    # A frame h = 5e-4 across a kink of the force has an error of about k h^3 v / m, because the
    # kinks do not fall on frames: 1e-6 after three of them. With damping they are jumps of up to
    # c v / m = 15 m/s^2, each for part of a frame: at most 15 h = 7e-3, and less on average.
    assert (p.x, p.y, v.x, v.y) == pytest.approx(end, abs=1e-3 if damping else 5e-6)


def test_a_spring_with_a_limit_of_elasticity_keeps_its_energy() -> None:
    """The energy is the area under the force: k e^2 / 2, with a softer slope beyond the limit."""

    def stored(length: float) -> float:
        within, beyond = min(length, 3.0) - 1.0, max(length - 3.0, 0.0)
        return 0.5 * 50.0 * within**2 + 50.0 * beyond * (2.0 + 0.2 * beyond / 2.0)

    hook, body = Particle(mass=math.inf), Particle(Vector3(5.0), UP, mass=2.0)
    registry = ForceRegistry()
    registry.add(body, ElasticLimitSpring(hook, 50.0, 1.0, 3.0, 0.2))
    assert stored(5.0) == 320.0  # 100 J up to the limit, 200 and 20 J beyond it
    lengths = []
    for _ in range(2000):
        velocity_verlet([body], registry.update_forces, 0.0005)
        length = body.position.magnitude()
        lengths.append(length)
        # A fraction (w h)^2 / 4 of it oscillates, 2e-6 with w = 5 and 18 m/s, and there is a kink.
        # Near the hook it rotates at 50 rad/s, where (50 h)^2 / 4 of it oscillates.
        assert body.kinetic_energy() + stored(length) == pytest.approx(321.0, rel=2e-4)
    assert min(lengths) < 1.0 < 3.0 < max(lengths)


def test_a_connection_of_ends_next_to_each_other_pushes_as_a_spring_does() -> None:
    """At a distance of 1e-310 m the force per meter would overflow, but the force does not."""
    a, b = Particle(Vector3(1e-310)), Particle()
    connect(ForceRegistry(), a, b, 100.0, 2.0).update_force(a, 0.5)
    # Numbers as small as 1e-310 have 14 digits.
    assert a.force_accumulator.x == pytest.approx(200.0, rel=1e-12)
    assert b.force_accumulator == -a.force_accumulator
