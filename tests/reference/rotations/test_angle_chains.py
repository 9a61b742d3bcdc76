"""Chains by their angles, and rods as forces, against SciPy and closed forms of a pendulum."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy
import pytest
from scipy.integrate import solve_ivp

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, leapfrog, runge_kutta_4, velocity_verlet
from ch07_constraints.going_further.angle_pendulum import DoublePendulum
from plots.drawing import slope
from studies.models.angle_chain import AngleChain
from studies.models.angle_rope import AngleRope
from studies.models.rod_tensions import RodTensions

G = 9.81
INF = math.inf
Chain = AngleChain | DoublePendulum

# Different lengths and masses, wide angles, and initial motion, so that no errors cancel.
TWO = ([1.0, 0.7], [1.0, 2.5], [1.0, -0.6], [0.5, 2.0])
FOUR = ([1.0, 0.7, 0.6, 0.9], [1.0, 2.5, 1.5, 4.0], [1.0, -0.6, 0.2, 0.8], [0.5, 2.0, -1.0, 0.0])
EQUAL = ([0.7] * 4, [2.5] * 4, *FOUR[2:])
TIME = 0.3  # s, in which the rods turn by about a radian


def rope(lengths: list[float], masses: list[float], *state: list[float]) -> AngleRope:
    return AngleRope(lengths[0], masses[0], *state)


def lagrange(start: tuple[list[float], ...], time: float) -> list[float]:
    """Return the angles after a time, solved by SciPy from Lagrange's equations without tensions.

    sum_j M L_j (w_j' cos(a_i - a_j) + w_j^2 sin(a_i - a_j)) = -M_i g sin a_i
    """
    lengths, masses, angles, speeds = (numpy.array(part) for part in start)
    count = len(lengths)
    below = masses[::-1].cumsum()[::-1]
    hung = below[numpy.maximum.outer(range(count), range(count))]

    def rates(_: float, state: numpy.ndarray) -> numpy.ndarray:
        a, w = state[:count], state[count:]
        apart = a[:, None] - a
        matrix = hung * lengths * numpy.cos(apart)
        right = -(hung * lengths * numpy.sin(apart)) @ w**2 - below * G * numpy.sin(a)
        return numpy.concatenate([w, numpy.linalg.solve(matrix, right)])

    begin = numpy.concatenate([angles, speeds])
    found = solve_ivp(rates, (0.0, time), begin, method="DOP853", rtol=1e-12, atol=1e-13)
    return [*found.y[:count, -1]]


def places_of(lengths: list[float], angles: list[float]) -> list[float]:
    x = y = 0.0
    places = []
    for length, angle in zip(lengths, angles, strict=True):
        x, y = x + length * math.sin(angle), y - length * math.cos(angle)
        places += [x, y]
    return places


def particles_of(start: tuple[list[float], ...]) -> list[Particle]:
    lengths, masses, angles, speeds = start
    x = y = u = v = 0.0
    chain = []
    for length, mass, angle, speed in zip(lengths, masses, angles, speeds, strict=True):
        x, y = x + length * math.sin(angle), y - length * math.cos(angle)
        u, v = u + length * speed * math.cos(angle), v + length * speed * math.sin(angle)
        chain.append(Particle(Vector3(x, y), Vector3(u, v), Vector3(0.0, -G), mass=mass))
    return chain


def seen(particles: list[Particle]) -> list[float]:
    return [part for p in particles for part in (p.position.x, p.position.y)]


@pytest.mark.parametrize(
    ("kind", "start"),
    [(DoublePendulum, TWO), (AngleChain, TWO), (AngleChain, FOUR), (rope, EQUAL)],
)
def test_chains_by_angles_are_those_of_lagrange_at_the_fourth_order(
    kind: Callable[..., Chain], start: tuple[list[float], ...]
) -> None:
    true = lagrange(start, TIME)
    counts, errors = (50, 100, 200), []
    for count in counts:
        chain = kind(*start)
        for _ in range(count):
            chain.step(TIME / count)
        errors.append(math.dist(chain.angles, true))
    assert errors[-1] < 1e-7
    assert slope(counts, errors) == pytest.approx(-4.0, abs=0.15)  # the next order adds a tenth


def test_positions_are_those_of_the_angles() -> None:
    for kind, start in ((DoublePendulum, TWO), (AngleChain, TWO), (AngleChain, FOUR)):
        found = [part for p in kind(*start).positions for part in (p.x, p.y)]
        assert found == pytest.approx(places_of(start[0], start[2]), abs=1e-15)


@pytest.mark.parametrize(
    ("integrator", "order"),
    [
        (leapfrog, 1),  # because tensions depend on velocities
        (velocity_verlet, 2),
        (runge_kutta_4, 4),
    ],
)
def test_tensions_let_an_integrator_step_rods_at_its_own_order(
    integrator: Integrator, order: int
) -> None:
    for start in (TWO, FOUR):
        true = places_of(start[0], lagrange(start, TIME))
        counts, errors = (100, 200, 400), []
        for count in counts:
            particles = particles_of(start)
            rods = RodTensions(particles, Vector3())
            for _ in range(count):
                integrator(particles, rods.update_forces, TIME / count)
            errors.append(math.dist(seen(particles), true))
        assert slope(counts, errors) == pytest.approx(-order, abs=0.15)


def test_a_conical_pendulum_goes_round_in_its_circle() -> None:
    """In three dimensions, w^2 = g / (l cos a)."""
    length, angle, mass = 2.0, 0.8, 3.0
    radius, turn = length * math.sin(angle), math.sqrt(G / (length * math.cos(angle)))
    place = Vector3(radius, -length * math.cos(angle), 0.0)
    bob = Particle(place, Vector3(0.0, 0.0, radius * turn), mass=mass)
    rods, registry = RodTensions([bob], Vector3()), ForceRegistry()
    registry.add(bob, Gravity(Vector3(0.0, -G)))

    def apply_forces(duration: float) -> None:
        registry.update_forces(duration)
        rods.update_forces(duration)

    for _ in range(1000):
        runge_kutta_4([bob], apply_forces, 0.002)
    found = [bob.position.x, bob.position.y, bob.position.z]
    true = [radius * math.cos(2.0 * turn), place.y, radius * math.sin(2.0 * turn)]
    # w h is 0.005. Its fourth power, 8e-10, for each of 5 rad is more than enough.
    assert found == pytest.approx(true, abs=1e-9)


@pytest.mark.parametrize("speed", [0.0, 3.0])
def test_a_chain_may_have_an_immovable_other_end(speed: float) -> None:
    """Two rods hold 1 kg at a right angle. The velocity of the other end makes no difference."""
    low = Particle(Vector3(0.5, -0.5), acceleration=Vector3(0.0, -G))
    end = Particle(Vector3(1.0, 0.0), Vector3(speed, speed), mass=INF)
    RodTensions([low, end], Vector3()).update_forces()
    assert [*low.force_accumulator] == pytest.approx([0.0, G, 0.0], abs=1e-12)
    along = math.sqrt(0.5) * G * math.sqrt(0.5)
    assert [*end.force_accumulator] == pytest.approx([-along, -along, 0.0], abs=1e-12)


def test_rod_tensions_without_a_unique_solution_are_an_arithmetic_error() -> None:
    chain = [Particle(Vector3(1.0)), Particle(Vector3(2.0), mass=INF)]
    with pytest.raises(ArithmeticError, match="rod 1"):
        RodTensions(chain, Vector3()).update_forces()
