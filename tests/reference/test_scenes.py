"""Cube, wheel and blob against ranks, torques and energies; the trebuchet against Lagrange."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import astuple
from itertools import combinations, pairwise

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.blob import Blob, Bond, spread
from ch08_mass_aggregate.cube import CORNERS, Cube, cube_rods, fewest_rods
from ch08_mass_aggregate.trebuchet import Design, Throw, Trebuchet
from ch08_mass_aggregate.wheel import Wheel, deformation, spin
from ch08_mass_aggregate.world import mechanical_energy

FRAME = 1.0 / 60.0
G = 9.81
Pairs = list[tuple[int, int]]


# The cube

EDGES = [(i, i | bit) for i in range(8) for bit in (1, 2, 4) if not i & bit]
# Also eighteen rods, but with two diagonals in the face at z = 0, and none in the face at z = 1.
LOOSE = [*EDGES, (0, 3), (1, 2), (0, 5), (0, 6), (1, 7), (2, 7)]


def rank(places: Sequence[Sequence[float]], rods: Pairs) -> int:
    """Return the rank of the rigidity matrix. A rod's row is the derivative of length^2 / 2."""
    matrix = numpy.zeros((len(rods), 3 * len(places)))
    for row, (i, j) in zip(matrix, rods, strict=True):
        along = numpy.subtract(places[j], places[i])
        row[3 * i : 3 * i + 3], row[3 * j : 3 * j + 3] = -along, along
    return int(numpy.linalg.matrix_rank(matrix)) if rods else 0


def test_the_cube_s_rods_leave_it_only_the_six_motions_of_a_rigid_body() -> None:
    assert len(cube_rods()) == len({frozenset(rod) for rod in cube_rods()}) == 18
    assert rank(CORNERS, cube_rods()) == 24 - 6
    assert rank(CORNERS, EDGES) == 12  # six ways to deform
    assert (len(LOOSE), rank(CORNERS, LOOSE)) == (18, 17)  # enough rods in the wrong positions
    for i in range(18):  # none is redundant
        assert rank(CORNERS, [*cube_rods()[:i], *cube_rods()[i + 1 :]]) == 17


@pytest.mark.parametrize("count", range(1, 10))
def test_the_fewest_rods_are_the_rank_of_all_rods(count: int) -> None:
    draw = random.Random(82)
    places = [[draw.random() for _ in range(3)] for _ in range(count)]
    assert fewest_rods(count) == rank(places, [*combinations(range(count), 2)])


def tumble(rods: Pairs | None, seconds: float = 4.0) -> tuple[float, list[float]]:
    """Let a cube fall. Return the largest change of a distance between corners, and the energies.

    The distances between the corners of the cube are 1, the root of 2, and the root of 3.
    """
    cube, worst = Cube(rods=rods), 0.0
    energies = [mechanical_energy(cube.particles)]
    for _ in range(round(seconds / FRAME)):
        cube.step(FRAME)
        energies.append(mechanical_energy(cube.particles))
        for i, j in combinations(range(8), 2):
            length = (cube.particles[i].position - cube.particles[j].position).magnitude()
            worst = max(worst, abs(length / math.dist(CORNERS[i], CORNERS[j]) - 1.0))
    assert max(energies) == energies[0]
    return worst, energies


def test_a_rigid_cube_keeps_its_shape_and_ends_on_a_face() -> None:
    worst, energies = tumble(None)
    assert worst < 3e-3  # 0.13 % was measured, at the impact on the ground
    # On a face, 4 corners of 1 kg are at 0 and 4 at 1 m. Corners at rest fall for a frame, v = g h.
    assert energies[-1] == pytest.approx(4.0 * G, abs=8.0 * (0.5 + 1.0) * (G * FRAME) ** 2)


@pytest.mark.parametrize("rods", [EDGES, LOOSE], ids=["edges", "eighteen"])
def test_a_cube_that_is_not_rigid_does_not(rods: Pairs) -> None:
    worst, _ = tumble(rods)
    assert worst > 0.3  # measured: 81 % with the edges alone, and 77 % with eighteen rods


# The wheel


@pytest.mark.parametrize("driven", [2, 8])
def test_a_driven_wheel_turns_by_torque_and_inertia(driven: int) -> None:
    """F n R = 8 m R^2 alpha. Check the spin and the angle after 1 s with 4 N on each particle.

    Rods pull in their direction after the frame, so a fraction (w h)^2 / 2 of the spin is lost in
    it. From dw/dt = alpha - w^3 h / 2, h alpha^3 / 8 is missing after 1 s. The angle is ahead by
    h alpha / 2, because the velocity is updated first, and behind by the loss, h alpha^3 / 40.
    """
    alpha = 4.0 * driven / 8.0
    for rate in (60, 120, 240):
        wheel = Wheel(4.0, driven)
        for _ in range(rate):
            wheel.step(1.0 / rate)
        missing = alpha - spin(wheel.hub, wheel.rim)
        turn = math.atan2(wheel.rim[0].position.y, wheel.rim[0].position.x)
        # The second order adds a few w h of it, with w = 4 rad/s.
        assert missing * rate == pytest.approx(alpha**3 / 8.0, rel=4.0 / rate)
        ahead = (turn - 0.5 * alpha) * rate
        assert ahead == pytest.approx(0.5 * alpha - alpha**3 / 40.0, rel=12.0 / rate)


@pytest.mark.parametrize(("driven", "bound"), [(3, 1e-6), (8, 1e-8)])
def test_the_rods_of_a_wheel_keep_their_length(driven: int, bound: float) -> None:
    """Measured in 5 s of 1 N: 3e-7, of order 2, if three are driven.

    If all are driven, nothing is pulled out of shape, and the resolver's 1e-9 m remain.
    """
    wheel, worst = Wheel(1.0, driven), 0.0
    for _ in range(300):
        wheel.step(FRAME)
        worst = max(worst, deformation(wheel.rods))
    assert worst < bound


def test_spin_is_that_of_a_body_that_turns() -> None:
    """v = w x r gives w about Z for any positions and masses, seen from a moving hub."""
    draw = random.Random(83)
    hub = Particle(Vector3(1.0, -2.0, 0.5), Vector3(3.0, 1.0, -1.0))
    rim = []
    for _ in range(7):
        x, y = draw.uniform(-2.0, 2.0), draw.uniform(-2.0, 2.0)
        velocity = hub.velocity + Vector3(-y, x) * 1.75
        place = hub.position + Vector3(x, y, draw.random())
        rim.append(Particle(place, velocity, mass=draw.uniform(0.5, 3.0)))
    assert spin(hub, rim) == pytest.approx(1.75, rel=1e-14)  # roundings of 3 m/s, 7 times


# The blob


def stored(bond: Bond) -> float:
    """Return the energy of a bond: k e^2 / 2, with a quarter of the slope beyond the limit."""
    length = (bond.b.position - bond.a.position).magnitude()
    limit = 1.2 * bond.rest_length
    within, beyond = min(length, limit) - bond.rest_length, max(length - limit, 0.0)
    return 30.0 * (0.5 * within**2 + within * beyond + 0.125 * beyond**2) if bond.holds else 0.0


@pytest.mark.parametrize("cables", [False, True])
def test_a_blob_falls_spreads_and_draws_together(cables: bool) -> None:
    blob = Blob(cables=cables)
    before, squashed = spread(blob.particles), 1.0
    # Nine of ten particles are 0.5 m from the middle, which gives the root of 9 / 10 of 0.25.
    assert before == pytest.approx(math.sqrt(0.225), rel=1e-15)
    start = 10 * 0.1 * G * 2.0
    for _ in range(600):
        blob.step(FRAME)
        energy = mechanical_energy(blob.particles) + math.fsum(map(stored, blob.bonds))
        assert energy < start
        for bond in blob.bonds:
            length = (bond.b.position - bond.a.position).magnitude()
            squashed = min(squashed, length / bond.rest_length)
    assert squashed < 0.75
    assert all(bond.holds for bond in blob.bonds)
    assert spread(blob.particles) == pytest.approx(before, rel=0.1)  # 0.7 % less was measured
    assert min(particle.position.y for particle in blob.particles) >= -1e-9


def test_a_bond_gives_way_breaks_and_heals() -> None:
    """k is 40, the rest length 1, the limit 1.5 with a quarter beyond it, and 2 m breaks it."""
    a, b = Particle(), Particle(mass=3.0)
    bond = Bond(a, b, 40.0, 1.0, 1.5, 0.25, 2.0)
    told = [
        (0.5, -20.0),
        (1.25, 10.0),
        (1.5, 20.0),
        (2.0, 25.0),
        (2.0 + 1e-9, 0.0),
        (1.5, 0.0),
        (1.0 + 1e-9, 0.0),
        (1.0, 0.0),  # heals, because it is not stretched
        (1.25, 10.0),
    ]
    for length, force in told:
        b.position = Vector3(0.0, length)
        for end, sign in ((a, 1.0), (b, -1.0)):
            end.clear_forces()
            bond.update_force(end, FRAME)
            assert end.force_accumulator.y == pytest.approx(sign * force, abs=1e-13)
        assert bond.holds == (force != 0.0 or length == 1.0)


@pytest.mark.parametrize("cables", [False, True])
def test_what_is_pulled_out_of_a_blob_is_lost_unless_a_cable_holds_it(cables: bool) -> None:
    blob = Blob(5.0, cables)
    blob.push = Vector3(0.0, 0.1 * G)  # makes it hover
    blob.step(FRAME)
    assert max(particle.velocity.magnitude() for particle in blob.particles) < 1e-14
    blob.particles[3].velocity = Vector3(0.0, 60.0)
    for _ in range(60):
        blob.step(FRAME)
    broken = [bond for bond in blob.bonds if not bond.holds]
    others = [p.position.y for p in blob.particles if p is not blob.particles[3]]
    if cables:
        assert all(bond.holds for bond in blob.bonds)
        for bond in blob.bonds:  # the resolver's limit leaves part of a frame's stretch
            length = (bond.b.position - bond.a.position).magnitude()
            assert length <= bond.break_length * 1.02
    else:
        assert len(broken) == 9
        assert all(blob.particles[3] in (bond.a, bond.b) for bond in broken)
        assert blob.particles[3].position.y > max(others) + 5.0


# The trebuchet

START, BEND, PIVOT, BALL, TIP = math.radians(200.0), math.radians(120.0), 5.0, 5.0, 5.0
State = tuple[float, float, float, float]


def rates(state: State, d: Design) -> State:
    """Return the rates of the arm's and the sling's angle and of their rates, by Lagrange.

    T = (M a^2 + (t + m) b^2) w^2 / 2 + m s^2 u^2 / 2 + m b s cos(theta - phi) w u, and
    V = g (M a sin(theta - BEND) + (t + m) b sin(theta) + m s sin(phi)).
    """
    theta, phi, w, u = state
    mass, a, b, s = d.counterweight, d.short_arm, d.long_arm, d.sling
    arm, sling = mass * a * a + (TIP + BALL) * b * b, BALL * s * s
    both, turning = BALL * b * s * math.cos(theta - phi), BALL * b * s * math.sin(theta - phi)
    pull = -G * (mass * a * math.cos(theta - BEND) + (TIP + BALL) * b * math.cos(theta))
    first, second = pull - turning * u * u, turning * w * w - G * BALL * s * math.cos(phi)
    det = arm * sling - both * both
    return w, u, (sling * first - both * second) / det, (arm * second - both * first) / det


def lagrange(d: Design, time: float | None = None, h: float = 5e-4) -> tuple[State, Throw]:
    """Return the state at a time, or at the release, by Runge-Kutta, and the throw."""
    state: State = (START, -0.5 * math.pi, 0.0, 0.0)

    def moved(rate: State, by: float) -> State:
        x, y, z, w = (p + by * q for p, q in zip(state, rate, strict=True))
        return x, y, z, w

    def thrown() -> tuple[float, float, float, float]:
        theta, phi, w, u = state
        b, s = d.long_arm, d.sling
        x, y = b * math.cos(theta) + s * math.cos(phi), b * math.sin(theta) + s * math.sin(phi)
        vx = -b * math.sin(theta) * w - s * math.sin(phi) * u
        return x, PIVOT + y, vx, b * math.cos(theta) * w + s * math.cos(phi) * u

    steps = 0
    while steps * h < (time or 4.0) - 0.5 * h:
        one = rates(state, d)
        two = rates(moved(one, 0.5 * h), d)
        three = rates(moved(two, 0.5 * h), d)
        four = rates(moved(three, h), d)
        mean = [
            (p + 2.0 * q + 2.0 * r + t) / 6.0
            for p, q, r, t in zip(one, two, three, four, strict=True)
        ]
        state = moved((mean[0], mean[1], mean[2], mean[3]), h)
        steps += 1
        x, y, vx, vy = thrown()
        if (
            time is None
            and vx > 0.0
            and y > PIVOT
            and math.atan2(vy, vx) <= math.radians(d.release_angle)
        ):
            break
    x, y, vx, vy = thrown()
    heights = [PIVOT + d.long_arm * math.sin(START) - d.sling]
    gained = BALL * G * (y - heights[0]) + 0.5 * BALL * (vx * vx + vy * vy)
    fall = d.short_arm * (math.sin(START - BEND) - math.sin(state[0] - BEND))
    reach = x + vx * (vy + math.sqrt(vy * vy + 2.0 * G * y)) / G
    return state, Throw(reach, gained / (d.counterweight * G * fall))


# Range and fraction by SciPy: solve_ivp, DOP853, rtol and atol 1e-12, with an exact release. The
# sling is always taut.
THROWS = [
    (Design(400.0, 0.8, 4.2, 3.0, 27.0), 99.549710, 0.53961126),
    (Design(400.0, 0.8, 4.2, 3.0, 40.0), 87.362825, 0.46257095),
    (Design(400.0, 1.0, 4.0, 3.0, 35.0), 91.935588, 0.37605132),
    (Design(300.0, 1.2, 3.5, 3.0, 40.0), 59.734423, 0.26989039),
]


@pytest.mark.parametrize(("design", "reach", "share"), THROWS)
def test_a_throw_is_that_of_the_double_pendulum(design: Design, reach: float, share: float) -> None:
    """Measured: 2.2 to 4.2 % less at 250 Hz, and a quarter of that at 1000 Hz."""
    _, exact = lagrange(design)
    # Our release is up to a step of 0.5 ms late, at up to 15 rad/s.
    assert astuple(exact) == pytest.approx((reach, share), rel=2e-3)
    for rate, late in ((250, 0.05), (1000, 0.0125)):
        if rate == 1000 and design.counterweight == 400.0 and design.release_angle > 27.0:
            continue  # one case of 400 kg and one of 300 kg are enough, because they take long
        trebuchet = Trebuchet(design)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("ch08_mass_aggregate.trebuchet.STEP", 1.0 / rate)
            throw = trebuchet.throw()
        assert trebuchet.flies
        assert -late < throw.range / reach - 1.0 < 0.0
        assert -late < throw.share / share - 1.0 < 0.0


def test_a_trebuchet_turns_as_the_double_pendulum_does() -> None:
    """Compare after 1.2 s, before the release. The positions have an error of order 1."""
    design = THROWS[0][0]
    (theta, phi, _, _), _ = lagrange(design, 1.2)
    tip = numpy.array([math.cos(theta), math.sin(theta)]) * design.long_arm + (0.0, PIVOT)
    wanted = tip + numpy.array([math.cos(phi), math.sin(phi)]) * design.sling
    ends = []
    for rate in (250, 500, 1000):
        trebuchet = Trebuchet(design)
        for _ in range(round(1.2 * rate)):
            trebuchet.step(1.0 / rate)
        assert not trebuchet.flies
        place = trebuchet.projectile.position
        ends.append(numpy.array([place.x, place.y]))
    errors = [float(numpy.hypot(*(end - wanted))) for end in ends]
    for coarse, fine in pairwise(errors):
        assert coarse / fine == pytest.approx(2.0, rel=0.15)
    # The remaining error without the first order.
    assert float(numpy.hypot(*(2.0 * ends[2] - ends[1] - wanted))) < 0.1 * errors[2]
