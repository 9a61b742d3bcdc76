"""The integrators: their orders, conservation by symplectic steps, and known losses of others."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import (
    ApplyForces,
    Integrator,
    backward_euler,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    trapezoidal,
    velocity_verlet,
)
from ch06_springs.springs import AnchoredSpring

FRAME = 1.0 / 60.0
STEPS = [explicit_euler, semi_implicit_euler, leapfrog, velocity_verlet, runge_kutta_4]
ORDERS = list(zip(STEPS, (1, 1, 2, 2, 4), strict=True))
SYMPLECTIC = (semi_implicit_euler, leapfrog, velocity_verlet)


def swinging(damping: float = 0.0) -> tuple[Particle, ApplyForces]:
    """Return 2 kg that swing in the plane on a spring of 1 m, which is not linear."""
    particle = Particle(Vector3(1.4, 0.2), Vector3(-0.5, 2.0), Vector3(0.0, -3.0), mass=2.0)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), 30.0, 1.0, damping))
    return particle, registry.update_forces


def plain_spring(particle: Particle, k: float, length: float) -> ApplyForces:
    """Return the force of an anchored spring in plain floats, fast enough for 100,000 steps."""

    def apply_forces(_: float) -> None:
        p = particle.position
        distance = math.hypot(p.x, p.y)
        pull = k * (length / distance - 1.0)
        particle.add_force(Vector3(pull * p.x, pull * p.y))

    return apply_forces


def state(particle: Particle) -> Any:
    p, v = particle.position, particle.velocity
    return numpy.array([p.x, p.y, v.x, v.y])


# Orders


@pytest.mark.parametrize("damping", [0.0, 4.0])
@pytest.mark.parametrize(("step", "order"), ORDERS)
def test_halved_frames_show_the_order(step: Integrator, order: int, damping: float) -> None:
    """Differences between the states after 1 s in steps h, h / 2 and h / 4 have ratio 2^order."""
    if step is leapfrog and damping:
        order = 1  # it evaluates velocity-dependent forces with the old velocity
    ends = []
    n = 100 if order == 4 else 800
    for frames in (n, 2 * n, 4 * n):
        particle, apply_forces = swinging(damping)
        for _ in range(frames):
            step([particle], apply_forces, 1.0 / frames)
        ends.append(state(particle))
    first, second = (numpy.linalg.norm(ends[i] - ends[i + 1]) for i in (0, 1))
    assert first > 1e-9  # far above rounding
    # The next term of the error is smaller by a factor h and changes the order by some hundredths.
    assert math.log2(first / second) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("step", STEPS)
def test_a_particle_s_own_damping_makes_every_order_1(step: Integrator) -> None:
    ends = []
    for frames in (800, 1600, 3200):
        particle, apply_forces = swinging()
        particle.damping = 0.3
        for _ in range(frames):
            step([particle], apply_forces, 1.0 / frames)
        ends.append(state(particle))
    first, second = (numpy.linalg.norm(ends[i] - ends[i + 1]) for i in (0, 1))
    assert math.log2(first / second) == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize(("step", "asked"), list(zip(STEPS, (1, 1, 1, 2, 4), strict=True)))
def test_the_forces_are_asked_for_so_often_a_step(step: Integrator, asked: int) -> None:
    particle, apply_forces = swinging()
    durations = []

    def counted(duration: float) -> None:
        durations.append(duration)
        apply_forces(duration)

    for _ in range(10):
        step([particle], counted, 0.01)
    assert durations == [0.01] * (10 * asked)


@pytest.mark.parametrize(
    ("step", "share"), list(zip(STEPS, (0.0, 1.0, 0.5, 0.5, 0.5), strict=True))
)
@given(st.floats(-100.0, 100.0), st.floats(-100.0, 100.0), st.floats(-100.0, 100.0))
def test_a_force_by_hand_lasts_all_of_one_frame(
    step: Integrator, share: float, v: float, a: float, force: float
) -> None:
    """Under a constant push, v' = v + (a + f / m) h, and p' has 0, all or half of a h^2."""
    particle = Particle(velocity=Vector3(v), acceleration=Vector3(a), mass=4.0)
    particle.add_force(Vector3(force))
    step([particle], lambda _: None, 0.25)
    push = a + force / 4.0
    # Some roundings of 100.
    assert particle.velocity.x == pytest.approx(v + push * 0.25, abs=1e-13)
    assert particle.position.x == pytest.approx(v * 0.25 + share * push * 0.0625, abs=1e-13)
    assert particle.last_acceleration.x == pytest.approx(push, abs=1e-13)
    assert tuple(particle.force_accumulator) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("step", STEPS)
def test_the_last_acceleration_is_the_mean_one_of_the_step(step: Integrator) -> None:
    particle, apply_forces = swinging(1.0)
    for _ in range(20):
        before = particle.velocity.copy()
        step([particle], apply_forces, 0.02)
        mean = (particle.velocity - before) / 0.02
        # The rounding of 3 m/s, divided by 0.02 s.
        assert tuple(particle.last_acceleration) == pytest.approx(tuple(mean), abs=1e-13)


# Symplectic or not


@pytest.mark.parametrize("step", STEPS)
def test_the_jacobian_of_a_step_is_symplectic_for_three_of_them(step: Integrator) -> None:
    """J' W J = W, which implies a determinant of 1: areas in the space of states are conserved."""
    columns = []
    for i in range(4):
        ends = []
        for sign in (1.0, -1.0):
            particle, apply_forces = swinging()
            at = state(particle)
            at[i] += sign * 1e-5
            particle.position, particle.velocity = Vector3(*at[:2]), Vector3(*at[2:])
            step([particle], apply_forces, 0.2)
            ends.append(state(particle))
        columns.append((ends[0] - ends[1]) / 2e-5)
    jacobian = numpy.array(columns).T
    form = numpy.block([[numpy.zeros((2, 2)), numpy.eye(2)], [-numpy.eye(2), numpy.zeros((2, 2))]])
    off = float(abs(jacobian.T @ form @ jacobian - form).max())
    volume = abs(float(numpy.linalg.det(jacobian)) - 1.0)
    # Central differences over 1e-5 have errors of 1e-10 of the third derivative and 1e-11.
    if step in SYMPLECTIC:
        assert max(off, volume) < 1e-7
    else:
        assert min(off, volume) > 1e-3


@pytest.mark.parametrize(
    ("step", "swing"),
    [(semi_implicit_euler, 0.25), (leapfrog, 0.02), (velocity_verlet, 0.02)],
)
def test_symplectic_steps_keep_the_energy_within_bounds_for_100_000_steps(
    step: Integrator, swing: float
) -> None:
    particle = Particle(Vector3(1.4, 0.2), Vector3(-0.5, 2.0), mass=2.0)
    apply_forces = plain_spring(particle, 30.0, 1.0)

    def energy() -> float:
        p = particle.position
        return particle.kinetic_energy() + 15.0 * (math.hypot(p.x, p.y) - 1.0) ** 2

    start, shares = energy(), []
    for _ in range(100_000):
        step([particle], apply_forces, 0.04)
        shares.append(energy() / start)
    # w h is 0.15. The energy oscillates by about w h (or its square over 4).
    assert max(abs(share - 1.0) for share in shares) < swing
    early, late = sum(shares[:10_000]) / 10_000, sum(shares[-10_000:]) / 10_000
    # The mean of 10,000 values does not drift, to a tenth of the oscillation.
    assert late == pytest.approx(early, abs=swing / 10.0)


@pytest.mark.parametrize("share", [0.1, 0.5, 1.0, 2.0])
def test_steps_that_are_not_symplectic_change_the_energy_by_their_known_factors(
    share: float,
) -> None:
    """With z^2 = k h^2 / m, the factors are 1 + z^2, and 1 - z^6 / 72 + z^8 / 576 for Runge-Kutta.

    They are |R(i z)|^2 of the stability functions 1 + z and the fourth-order part of e^z.
    """
    z, n = share, 50
    for step, factor in (
        (explicit_euler, 1.0 + z**2),
        (runge_kutta_4, 1.0 - z**6 / 72.0 + z**8 / 576.0),
    ):
        particle = Particle(Vector3(1.0), mass=2.0)
        registry = ForceRegistry()
        registry.add(particle, AnchoredSpring(Vector3(), 2.0 * (z / FRAME) ** 2, 0.0))
        for _ in range(n):
            step([particle], registry.update_forces, FRAME)
        x, v = particle.position.x, particle.velocity.x
        left = x * x + (v * FRAME / z) ** 2
        assert left == pytest.approx(factor**n, rel=1e-12)  # 50 steps, each with some roundings


def test_explicit_euler_makes_ten_seconds_of_a_spring_14_million_times_as_strong() -> None:
    """Test k = 100 N/m, 1 kg and 60 Hz. Velocity first gives x 1.06, by the matrix's power."""
    h = FRAME
    matrix = numpy.array([[1.0 - 100.0 * h * h, h], [-100.0 * h, 1.0]])
    x, v = numpy.linalg.matrix_power(matrix, 600) @ [1.0, 0.0]
    for step, wanted, figure in (
        (explicit_euler, (1.0 + 100.0 * h * h) ** 600, 13_789_038.0),
        (semi_implicit_euler, x * x + v * v / 100.0, 1.06),
    ):
        particle = Particle(Vector3(1.0))
        registry = ForceRegistry()
        registry.add(particle, AnchoredSpring(Vector3(), 100.0, 0.0))
        for _ in range(600):
            step([particle], registry.update_forces, h)
        grown = particle.position.x**2 + particle.velocity.x**2 / 100.0
        assert grown == pytest.approx(wanted, rel=1e-11)  # 600 roundings
        assert grown == pytest.approx(figure, rel=5e-3)  # three digits are known of the second


@pytest.mark.parametrize(
    ("step", "energy", "digit"),
    [
        (explicit_euler, -0.177, 5e-4),
        (semi_implicit_euler, -0.5023, 5e-5),
        (velocity_verlet, -0.499999, 5e-7),
        (runge_kutta_4, -0.5, 5e-7),
    ],
)
def test_ten_orbits_end_with_the_known_energy(
    step: Integrator, energy: float, digit: float
) -> None:
    """e is 0.6, frames are 0.005, and the exact energy is -0.5. Allow half of the last digit."""
    particle = Particle(Vector3(0.4), Vector3(0.0, 2.0))
    registry = ForceRegistry()
    registry.add(particle, InverseSquareGravity(Vector3(), 1.0))
    for _ in range(round(20.0 * math.pi / 0.005)):
        step([particle], registry.update_forces, 0.005)
    ended = particle.kinetic_energy() - 1.0 / particle.position.magnitude()
    assert ended == pytest.approx(energy, abs=digit)


# Implicit steps


@pytest.mark.parametrize("k", [1.0, 100.0, 1e6, 1e12])
@pytest.mark.parametrize(
    ("step", "factor"), [(trapezoidal, lambda _: 1.0), (backward_euler, lambda kappa: 1.0 + kappa)]
)
def test_the_implicit_steps_divide_the_energy_by_what_they_should(
    step: Callable[..., tuple[float, float]], factor: Callable[[float], float], k: float
) -> None:
    """The trapezoidal rule conserves it; backward Euler leaves 1 / (1 + k h^2 / m) per step."""
    x, v, m = 1.0, 0.3 * math.sqrt(k / 2.0), 2.0
    start = k * x * x + m * v * v
    for n in range(1, 201):
        x, v = step(x, v, k, 0.0, m, FRAME)
        wanted = start * factor(k * FRAME**2 / m) ** -n
        # In x' = x + h v', rounding once loses all digits of a stiff spring except those of x.
        if wanted > 1e-12 * start:
            assert k * x * x + m * v * v == pytest.approx(wanted, rel=1e-9)
    assert k * x * x + m * v * v <= start * (1.0 + 1e-9)


@pytest.mark.parametrize(("step", "order"), [(backward_euler, 1), (trapezoidal, 2)])
def test_the_implicit_steps_come_to_the_exponential_with_their_order(
    step: Callable[..., tuple[float, float]], order: int
) -> None:
    k, c, m = 40.0, 3.0, 2.0
    values, vectors = numpy.linalg.eig(numpy.array([[0.0, 1.0], [-k / m, -c / m]]))
    exact = (vectors @ numpy.diag(numpy.exp(values)) @ numpy.linalg.inv(vectors) @ [1.0, -2.0]).real
    gaps = []
    for n in (400, 800):
        x, v = 1.0, -2.0
        for _ in range(n):
            x, v = step(x, v, k, c, m, 1.0 / n)
        gaps.append(numpy.linalg.norm(numpy.array([x, v]) - exact))
    assert gaps[0] < 0.1
    assert math.log2(gaps[0] / gaps[1]) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("step", STEPS)
def test_a_step_moves_the_vectors_that_others_may_hold(step: Integrator) -> None:
    """An anchor that is a particle's own position vector follows it with every integrator."""
    leader = Particle(Vector3(1.0), Vector3(0.0, 2.0, 0.0))
    spring = AnchoredSpring(Vector3(), 3.0, 0.0)
    spring.anchor, held = leader.position, leader.velocity
    for _ in range(3):
        step([leader], lambda _: leader.add_force(Vector3(0.0, 0.0, 5.0)), FRAME)
    assert spring.anchor == leader.position
    assert held == leader.velocity
    assert leader.position.z > 0.0
