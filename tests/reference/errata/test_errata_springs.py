"""The errata about springs and time steps: what the book says, and what its step really does.

One step of a spring is linear, so a matrix describes it. Its eigenvalues say how an oscillation
grows and how fast it is.
"""

from __future__ import annotations

import cmath
import math

import numpy
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    runge_kutta_4,
    semi_implicit_euler,
)
from ch06_springs.springs import AnchoredSpring, FakeStiffSpring, Spring

FRAME = 1.0 / 60.0


def end(
    step: Integrator, force: ForceGenerator, x: float, v: float, h: float, steps: int = 1
) -> tuple[float, float]:
    """Return the position and velocity of a particle of 1 kg after some steps along X."""
    particle, registry = Particle(Vector3(x), Vector3(v)), ForceRegistry()
    registry.add(particle, force)
    for _ in range(steps):
        step([particle], registry.update_forces, h)
    return particle.position.x, particle.velocity.x


def factor(step: Integrator, force: ForceGenerator, h: float = FRAME) -> complex:
    """Return the eigenvalue of a step with the largest magnitude, in the upper half plane."""
    columns = [end(step, force, 1.0, 0.0, h), end(step, force, 0.0, 1.0, h)]
    values = numpy.linalg.eigvals(numpy.transpose(columns))
    return complex(max(values, key=lambda value: (abs(value), value.imag)))


def spring(stiffness: float) -> AnchoredSpring:
    return AnchoredSpring(Vector3(), stiffness, 0.0)


def faked(angle: float, damping: float = 0.0) -> FakeStiffSpring:
    """Return a faked spring with this angular frequency times the time step."""
    return FakeStiffSpring(Vector3(), (angle / FRAME) ** 2, damping)


# The faked spring


@pytest.mark.parametrize(("damping", "grown"), [(1.0, 63.0), (2.0, 19.0), (4.0, 1.7)])
def test_e22_a_damped_faked_spring_grows_with_the_book_s_step(damping: float, grown: float) -> None:
    force = FakeStiffSpring(Vector3(), 400.0, damping)
    reach = [abs(end(explicit_euler, force, 1.0, 0.0, FRAME, n)[0]) for n in range(301)]
    assert max(reach) == pytest.approx(grown, rel=0.02)  # two digits are known
    assert max(reach[-20:]) == max(reach)  # it still grows after 5 s
    reach = [abs(end(semi_implicit_euler, force, 1.0, 0.0, FRAME, n)[0]) for n in range(301)]
    assert max(reach) == 1.0


def test_e22_more_damping_lets_it_die_out() -> None:
    for damping, stable in ((4.4, False), (4.45, True), (6.0, True)):
        size = abs(factor(explicit_euler, FakeStiffSpring(Vector3(), 400.0, damping)))
        assert (size < 1.0) is stable


def test_e22_undamped_it_grows_in_bands() -> None:
    """With T = x cos a + v h sin(a) / a, both determinants are known, and so are the edges."""
    # Explicit Euler: the determinant 1 + sin(a) / a - cos(a) is above 1 where tan(a) passes a.
    first, second, third = (
        brentq(lambda a: math.sin(a) - a * math.cos(a), *near)
        for near in ((4.4, 4.6), (7.6, 7.8), (10.8, 11.0))
    )
    assert [first, second, third] == pytest.approx([4.49, 7.73, 10.90], abs=5e-3)
    assert_grows(explicit_euler, [(0.0, first), (second, third)])
    limit = (first / FRAME) ** 2
    assert limit == pytest.approx(72_700.0, rel=1e-3)
    # Semi-implicit Euler: it grows where cos(a/2) (cos(a/2) + 2 sin(a/2) / a) is negative.
    ends = [
        2.0 * brentq(lambda u: math.sin(u) + u * math.cos(u), *near)
        for near in ((2.0, 2.1), (4.8, 5.0), (7.9, 8.0))
    ]
    assert ends == pytest.approx([4.06, 3.13 * math.pi, 5.08 * math.pi], rel=1e-3)
    assert_grows(semi_implicit_euler, [*zip((math.pi, 3.0 * math.pi), ends[:2], strict=True)])
    stiffness = [(angle / FRAME) ** 2 for angle in (math.pi, ends[0])]
    assert stiffness == pytest.approx([35_500.0, 59_300.0], rel=1e-3)
    # A twentieth of the critical damping prevents it.
    for angle in numpy.arange(0.1, 20.0, 0.1):
        assert abs(factor(semi_implicit_euler, faked(angle, 0.1 * angle / FRAME))) < 1.0


def assert_grows(step: Integrator, bands: list[tuple[float, float]]) -> None:
    """Check that an undamped faked spring grows within the bands, and not between them."""
    for low, high in bands:
        for inside in (low + 0.01, (low + high) / 2.0, high - 0.01):
            assert abs(factor(step, faked(inside))) > 1.0
        assert abs(factor(step, faked(high + 0.01))) < 1.0
    for low, _ in bands[1:]:
        assert abs(factor(step, faked(low - 0.01))) < 1.0


def test_e42_with_short_steps_a_faked_spring_is_half_as_stiff() -> None:
    for angle, slower in ((0.01, 1.41), (1.0, 1.39)):
        assert (angle / FRAME) ** 2 == pytest.approx(0.36 if angle == 0.01 else 3600.0)
        ratio = angle / cmath.phase(factor(semi_implicit_euler, faked(angle)))
        assert ratio == pytest.approx(slower, abs=5e-3)
    shortest = cmath.phase(factor(semi_implicit_euler, faked(0.001)))
    assert 0.001 / shortest == pytest.approx(math.sqrt(2.0), rel=1e-5)
    # The slower step of the book never makes it too stiff either.
    for step in (semi_implicit_euler, explicit_euler):
        for angle in numpy.arange(0.1, 2.61, 0.1):
            assert cmath.phase(factor(step, faked(angle))) < angle


# The book's step


def test_e37_the_book_s_step_makes_a_spring_explode_and_swing_too_slowly() -> None:
    for stiffness in (0.01, 1.0, 100.0):
        w = math.sqrt(stiffness)
        got = factor(explicit_euler, spring(stiffness))
        assert abs(got) ** 2 == pytest.approx(1.0 + stiffness * FRAME**2, rel=1e-14)
        assert abs(got) > 1.0
        assert cmath.phase(got) == pytest.approx(math.atan(w * FRAME), rel=1e-7)
        assert cmath.phase(got) < w * FRAME
    energy = abs(factor(explicit_euler, spring(100.0))) ** 1200  # 10 s
    assert energy == pytest.approx(1.38e7, rel=2e-3)
    period = 10.0 * FRAME / cmath.phase(factor(explicit_euler, spring(100.0)))
    assert period == pytest.approx(1.0092, abs=5e-5)
    period = 10.0 * FRAME / cmath.phase(factor(semi_implicit_euler, spring(100.0)))
    assert period == pytest.approx(0.9988, abs=5e-5)
    assert period**-2 == pytest.approx(1.0023, abs=5e-5)


def test_e38_substeps_help_a_lot() -> None:
    for substeps, energy in ((1, 1.38e7), (4, 64.0), (16, 2.8)):
        grown = abs(factor(explicit_euler, spring(100.0), FRAME / substeps)) ** (1200 * substeps)
        assert grown == pytest.approx(energy, rel=0.015)  # two digits are known
    for substeps in (1, 4):
        limit = 14_400.0 * substeps**2
        inside, outside = (
            abs(factor(semi_implicit_euler, spring(k * limit), FRAME / substeps))
            for k in (0.98, 1.02)
        )
        assert inside == pytest.approx(1.0, abs=1e-12)
        assert outside > 1.0
    # With damping, the book's step is stable below k = m (d^-h - 1) / h^2.
    limits = [(0.9 ** (-FRAME / n) - 1.0) / (FRAME / n) ** 2 for n in (1, 4)]
    assert limits[1] / limits[0] == pytest.approx(4.0, rel=1e-2)


# Equations of motion


def test_e40_a_damped_spring_needs_the_mass() -> None:
    stiffness, mass, time = 400.0, 4.0, 0.1
    right, _ = damped_spring_state(1.0, 0.0, stiffness, 0.0, mass, time)
    printed, _ = damped_spring_state(1.0, 0.0, stiffness, 0.0, 1.0, time)
    assert right == pytest.approx(0.540, abs=5e-4)
    assert printed == pytest.approx(-0.416, abs=5e-4)
    drag = 4.0  # k1 in N s/m, which slows 4 kg down by 1 / s
    per_mass = numpy.array([[0.0, 1.0], [-stiffness / mass, -drag / mass]])
    wanted = expm(per_mass * time) @ (1.0, 0.0)
    assert damped_spring_state(1.0, 0.0, stiffness, drag, mass, time) == pytest.approx(wanted)
    undivided = expm(numpy.array([[0.0, 1.0], [-stiffness / mass, -drag]]) * time) @ (1.0, 0.0)
    assert abs(undivided[0] - wanted[0]) > 0.03


def test_e41_the_reduced_mass_solves_a_spring_with_two_moving_ends() -> None:
    """Particles of 1 kg and 3 kg at 0 and 3 m, on a spring of 2 m that is stretched by 1 m."""
    a, b, registry = Particle(), Particle(Vector3(3.0), mass=3.0), ForceRegistry()
    registry.add(a, Spring(b, 5.0, 2.0))
    registry.add(b, Spring(a, 5.0, 2.0))
    reduced, steps = 0.75, 200
    period = 2.0 * math.pi * math.sqrt(reduced / 5.0)
    assert period == pytest.approx(2.43347, abs=5e-6)
    for done in range(1, steps + 1):
        runge_kutta_4([a, b], registry.update_forces, period / steps)
        stretch, _ = damped_spring_state(1.0, 0.0, 5.0, 0.0, reduced, done * period / steps)
        assert b.position.x - a.position.x - 2.0 == pytest.approx(stretch, abs=1e-6)  # h^4
        assert (a.position.x + 3.0 * b.position.x) / 4.0 == pytest.approx(2.25, abs=1e-12)
