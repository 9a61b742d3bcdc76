"""Time division by rewinding, against SciPy's event detection and against other steps.

A ball of 1 kg falls from 2 m under 9.81 m/s^2 and bounces with a restitution of 0.8. It has drag,
or hangs on a spring, or flies freely. The errors are those of its height after 2 s, in m.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial

import pytest
from scipy.integrate import solve_ivp

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, leapfrog, runge_kutta_4
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.going_further.rewinding import HALVINGS, rewinding_step
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from scenes.resolving import no_forces

G, DROP, RESTITUTION, SECONDS = 9.81, 2.0, 0.8, 2.0
DRAG, STIFFNESS = 0.1, 40.0  # N s^2/m^2; N/m, of a spring whose anchor is 1 m above the ground
FORCES: dict[str, tuple[list[ForceGenerator], Callable[[float, float], float]]] = {
    "drag": ([Drag(0.0, DRAG)], lambda _, v: -G - DRAG * abs(v) * v),
    "spring": (
        [AnchoredSpring(Vector3(0.0, 1.0), STIFFNESS, 0.0)],
        lambda y, _: -G - STIFFNESS * (y - 1.0),
    ),
    "none": ([], lambda *_: -G),
}
Step = Callable[[Particle, Callable[[float], None], GroundPlane, float], object]


@cache
def exact(forces: str) -> tuple[float, int]:
    """Return the height after 2 s and the number of bounces, by SciPy's DOP853 with events."""
    acceleration = FORCES[forces][1]

    def ground(_: float, state: tuple[float, float]) -> float:
        return state[0]

    ground.terminal, ground.direction = True, -1  # type: ignore[attr-defined]
    time, y, v, bounces = 0.0, DROP, 0.0, 0
    while True:
        found = solve_ivp(
            lambda _, s: (s[1], acceleration(s[0], s[1])),
            (time, SECONDS),
            (y, v),
            "DOP853",
            rtol=1e-12,
            atol=1e-13,
            events=ground,
        )
        time, y, v = found.t[-1], *found.y[:, -1]
        if found.status == 0:
            return float(y), bounces
        y, v, bounces = 0.0, -RESTITUTION * v, bounces + 1


def rewound(
    integrator: Integrator, p: Particle, forces: Callable[[float], None], g: GroundPlane, h: float
) -> int:
    return rewinding_step(integrator, [p], forces, g, h)


def predicted(p: Particle, forces: Callable[[float], None], g: GroundPlane, h: float) -> None:
    forces(h)
    time_division_step([p], g, h)


def resolved(p: Particle, forces: Callable[[float], None], g: GroundPlane, h: float) -> None:
    runge_kutta_4([p], forces, h)
    ContactResolver().resolve_contacts(g.contacts(), h)


def error(forces: str, step: Step, rate: int = 60) -> float:
    ball = Particle(Vector3(0.0, DROP), acceleration=Vector3(0.0, -G))
    registry = ForceRegistry()
    for generator in FORCES[forces][0]:
        registry.add(ball, generator)
    ground = GroundPlane([ball], restitution=RESTITUTION)
    for _ in range(round(SECONDS * rate)):
        step(ball, registry.update_forces, ground, 1.0 / rate)
    return abs(ball.position.y - exact(forces)[0])


@pytest.mark.parametrize(
    ("forces", "rewinding", "formula", "resolver"),
    [("drag", 3.6e-8, 0.018, 0.026), ("spring", 1.5e-5, 1.03, 0.51)],
)
def test_the_errors_with_drag_and_with_a_spring(
    forces: str, rewinding: float, formula: float, resolver: float
) -> None:
    """The numbers of reference.md, to 5 %. SciPy's error is below 1e-10 m."""
    assert error(forces, partial(rewound, runge_kutta_4)) == pytest.approx(rewinding, rel=0.05)
    assert error(forces, predicted) == pytest.approx(formula, rel=0.05)
    assert error(forces, resolved) == pytest.approx(resolver, rel=0.05)


@pytest.mark.parametrize(
    ("integrator", "order"), [(leapfrog, 2), (runge_kutta_4, 4)], ids=["leapfrog", "Runge-Kutta"]
)
def test_bounces_on_a_spring_keep_the_order_of_the_integrator(
    integrator: Integrator, order: int
) -> None:
    errors = [error("spring", partial(rewound, integrator), rate) for rate in (60, 120, 240)]
    # Measured: 4.01 and 4.02 for leapfrog, 17.7 and 16.9 for Runge-Kutta.
    assert errors[0] / errors[1] == pytest.approx(2**order, rel=0.15)
    assert errors[1] / errors[2] == pytest.approx(2**order, rel=0.15)


def test_without_other_forces_both_kinds_of_time_division_are_exact() -> None:
    for step in (partial(rewound, leapfrog), partial(rewound, runge_kutta_4), predicted):
        assert error("none", step) < 1e-12


def test_an_impact_costs_46_steps_of_the_integrator() -> None:
    steps = 0

    def counted(particles: object, apply_forces: object, duration: float) -> None:
        nonlocal steps
        steps += 1
        leapfrog(particles, apply_forces, duration)  # type: ignore[arg-type]

    error("drag", partial(rewound, counted))
    assert exact("drag")[1] == 2
    assert steps == SECONDS * 60 + 2 * (HALVINGS + 2)


def test_a_row_of_touching_balls_passes_the_motion_on() -> None:
    balls = [Particle(Vector3(2.0 * i - (0.25 if i == 0 else 0.0))) for i in range(4)]
    balls[0].velocity.x = 1.0
    pairs = ParticlePairs(balls, 1.0, restitution=1.0)
    impacts = rewinding_step(runge_kutta_4, balls, no_forces, pairs, 1.0)
    assert impacts == 3
    assert [ball.velocity.x for ball in balls] == pytest.approx([0.0, 0.0, 0.0, 1.0], abs=1e-12)
    assert balls[3].position.x == pytest.approx(6.75, abs=1e-12)


def test_forces_added_by_hand_act_during_the_whole_step_and_then_no_longer() -> None:
    """With 5 N upward, the ball falls with 10 - 5 m/s^2, and lands after sqrt(2 * 0.1 / 5) s."""
    ball = Particle(Vector3(0.0, 0.1), acceleration=Vector3(0.0, -10.0))
    ball.add_force(Vector3(0.0, 5.0))
    ground = GroundPlane([ball], restitution=1.0)
    assert rewinding_step(runge_kutta_4, [ball], no_forces, ground, 0.3) == 1
    assert ball.position.y == pytest.approx(1.0 * 0.1 - 2.5 * 0.1**2, abs=1e-12)
    assert ball.force_accumulator == Vector3()


def test_a_ball_at_rest_has_too_many_impacts() -> None:
    ball = Particle(acceleration=Vector3(0.0, -G))
    with pytest.raises(TooManyImpacts) as raised:
        rewinding_step(leapfrog, [ball], no_forces, GroundPlane([ball]), 1.0, max_impacts=5)
    assert raised.value.impacts == 5
    assert raised.value.time < 1e-9
    with pytest.raises(ValueError, match="max_impacts"):
        rewinding_step(leapfrog, [ball], no_forces, GroundPlane([ball]), 1.0, max_impacts=0)
