"""The adaptive integrator, compared with SciPy and with closed forms."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, ForceGenerator, ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.integrators import ApplyForces, Integrator, runge_kutta_4, watched
from ch06_springs.springs import AnchoredSpring, connect
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
LOOSE = 1e6  # a tolerance that every step meets, so that a call makes a single step
KEPLER = numpy.linspace(0.0, 2.0 * math.pi, 61)[1:]  # the ends of 60 frames in one revolution


def acted(particle: Particle, *generators: ForceGenerator) -> ApplyForces:
    registry = ForceRegistry()
    for generator in generators:
        registry.add(particle, generator)
    return registry.update_forces


def swinging(damping: float = 4.0) -> tuple[Particle, ApplyForces]:
    """Return 2 kg that swing in the plane on a damped spring of 1 m, which is not linear."""
    particle = Particle(Vector3(1.4, 0.2), Vector3(-0.5, 2.0), Vector3(0.0, -3.0), mass=2.0)
    return particle, acted(particle, AnchoredSpring(Vector3(), 30.0, 1.0, damping))


def swinging_rates(_: float, y: Any) -> list[float]:
    place, velocity = y[:2], y[2:]
    length = math.hypot(*place)
    pull = 30.0 * (length - 1.0) + 4.0 * (velocity @ place) / length
    return [*velocity, *([0.0, -3.0] - pull / 2.0 * place / length)]


def state(particle: Particle) -> Any:
    p, v = particle.position, particle.velocity
    return numpy.array([p.x, p.y, v.x, v.y])


def comet(e: float = 0.9) -> tuple[Particle, ApplyForces]:
    particle = Particle(Vector3(1.0 - e), Vector3(0.0, math.sqrt((1.0 + e) / (1.0 - e))))
    return particle, acted(particle, InverseSquareGravity(Vector3(), 1.0))


def comet_at(time: float, e: float = 0.9) -> tuple[float, float]:
    low, high = time - e, time + e  # solve Kepler's equation t = E - e sin E by bisection
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if middle - e * math.sin(middle) > time else (middle, high)
    return math.cos(low) - e, math.sqrt(1.0 - e * e) * math.sin(low)


def error_of_comet(step: Integrator, steps: int = 1) -> float:
    """Return the largest error of a coordinate in any of the 60 frames of a revolution."""
    particle, apply_forces = comet()
    worst = 0.0
    for time in KEPLER:
        for _ in range(steps):
            step([particle], apply_forces, KEPLER[0] / steps)
        found = state(particle)[:2]
        worst = max(worst, float(abs(found - comet_at(time)).max()))
    return worst


# Comparison with SciPy and closed forms


def test_a_comet_needs_a_tenth_of_the_evaluations_of_runge_kutta_4() -> None:
    step = adaptive(5e-9)
    assert error_of_comet(step) < 1e-6
    assert step.evaluations < 1600
    fixed = 10 * step.evaluations // (4 * 60)
    assert error_of_comet(runge_kutta_4, fixed) > 1e-6


@pytest.mark.parametrize("h", [0.01, 0.2])
def test_one_step_is_that_of_scipy(h: float) -> None:
    """SciPy's RK45 is the same pair of methods. If it makes a single step, the step is h."""
    particle, apply_forces = swinging()
    adaptive(LOOSE)([particle], apply_forces, h)
    start = [1.4, 0.2, -0.5, 2.0]
    theirs = solve_ivp(swinging_rates, (0.0, h), start, first_step=h, rtol=1.0, atol=LOOSE)
    assert theirs.t.tolist() == [0.0, h]
    assert state(particle) == pytest.approx(theirs.y[:, -1], abs=1e-14)  # rounding of 2 m/s


def test_one_long_call_needs_as_many_evaluations_as_scipy() -> None:
    """A revolution in one call is not cut into frames, so only the choice of steps differs.

    SciPy's norm is the root mean square of four errors. Ours is the largest error, which is up to
    twice as large. This gives 2^(1/5) - 1 or 15 % more steps, and a few rejections at the start.
    """
    particle, apply_forces = comet()
    step = adaptive(1e-9)
    step([particle], apply_forces, 2.0 * math.pi)

    def rates(_: float, y: Any) -> list[float]:
        cube = math.hypot(y[0], y[1]) ** 3
        return [y[2], y[3], -y[0] / cube, -y[1] / cube]

    begun = state(comet()[0])
    theirs = solve_ivp(rates, (0.0, 2.0 * math.pi), begun, rtol=2.3e-14, atol=1e-9)
    assert step.evaluations == pytest.approx(theirs.nfev, rel=0.2)


@pytest.mark.parametrize("c", [0.0, 2.0, 20.0, 40.0])
def test_a_damped_spring_moves_as_the_exponential_of_its_matrix(c: float) -> None:
    matrix = numpy.array([[0.0, 1.0], [-100.0, -c]])
    particle = Particle(Vector3(1.0))
    apply_forces = acted(particle, AnchoredSpring(Vector3(), 100.0, 0.0, c))
    step = adaptive(1e-10)
    for frame in range(1, 121):
        step([particle], apply_forces, FRAME)
        x, v = expm(matrix * (frame * FRAME)) @ [1.0, 0.0]
        # 120 frames, each with an estimated error of at most 1e-10 m and 1e-10 m/s.
        assert particle.position.x == pytest.approx(x, abs=1.2e-8)
        assert particle.velocity.x == pytest.approx(v, abs=1.2e-8)


def test_a_fall_with_quadratic_drag_follows_its_closed_form() -> None:
    """The speed is u tanh(g t / u) and the depth u^2 / g ln cosh(g t / u), with u^2 = g / k2."""
    particle = Particle(acceleration=Vector3(0.0, -9.81))
    apply_forces = acted(particle, Drag(0.0, 0.05))
    step, u = adaptive(1e-10), math.sqrt(9.81 / 0.05)
    for second in (1.0, 2.0, 3.0):
        step([particle], apply_forces, 1.0)
        falls = 9.81 * second / u
        # Some tens of steps with an error of 1e-10 each.
        depth = u * u / 9.81 * math.log(math.cosh(falls))
        assert particle.velocity.y == pytest.approx(-u * math.tanh(falls), abs=1e-8)
        assert particle.position.y == pytest.approx(-depth, abs=1e-8)


def test_halved_frames_show_order_5_where_forces_depend_on_the_velocity() -> None:
    """Differences between the states after 1 s with steps h, h / 2 and h / 4 have ratio 2^5."""
    ends = []
    for frames in (40, 80, 160):
        particle, apply_forces = swinging()
        step = adaptive(LOOSE)
        for _ in range(frames):
            step([particle], apply_forces, 1.0 / frames)
        ends.append(state(particle))
        assert step.evaluations == 7 * frames
    first, second = (numpy.linalg.norm(ends[i] - ends[i + 1]) for i in (0, 1))
    assert second > 1e-11  # far above rounding
    assert math.log2(first / second) == pytest.approx(5.0, abs=0.2)


def test_the_error_is_in_proportion_to_the_tolerance_over_eight_decades() -> None:
    start, rates = [1.4, 0.2, -0.5, 2.0], swinging_rates
    truth = solve_ivp(rates, (0.0, 3.0), start, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    errors, tolerances = [], [10.0**-n for n in range(3, 12)]
    for tolerance in tolerances:
        particle, apply_forces = swinging()
        adaptive(tolerance)([particle], apply_forces, 3.0)  # one call, without frames
        errors.append(float(abs(state(particle) - truth).max()))
    slope = numpy.polyfit(numpy.log(tolerances), numpy.log(errors), 1)[0]
    assert slope == pytest.approx(1.0, abs=0.15)  # the estimate has order 4, and the step order 5
    # Some tens of steps, each with an error of at most the tolerance.
    assert max(e / t for e, t in zip(errors, tolerances, strict=True)) < 100.0


def test_irregular_frames_end_at_their_times() -> None:
    """After each frame the particle agrees with the closed form at the sum of the durations."""
    random.seed(1)
    matrix = numpy.array([[0.0, 1.0], [-100.0, -2.0]])
    particle, end = Particle(Vector3(1.0)), numpy.array([1.0, 0.0])
    apply_forces = acted(particle, AnchoredSpring(Vector3(), 100.0, 0.0, 2.0))
    step, worst = adaptive(1e-11), 0.0
    for _ in range(300):
        duration = 10.0 ** random.uniform(-6.0, 0.0)
        step([particle], apply_forces, duration)
        end = expm(matrix * duration) @ end
        worst = max(worst, abs(particle.position.x - end[0]), abs(particle.velocity.x - end[1]))
    # The motion decays, and so do the errors of some tens of steps. If a frame were wrong by 1e-9
    # s, the error would be visible, because the speed is up to 10 m/s.
    assert worst < 1e-9


# What it has in common with other integrators


def test_it_counts_its_evaluations_and_gives_each_the_duration_of_the_call() -> None:
    particle, apply_forces = swinging()
    durations = []

    def counted(duration: float) -> None:
        durations.append(duration)
        apply_forces(duration)

    step = adaptive(1e-9)
    for _ in range(20):
        before = step.evaluations
        step([particle], counted, 0.05)
        assert (step.evaluations - before) % 6 == 1  # one, plus six per step
        assert step.evaluations > before + 7
    assert durations == [0.05] * step.evaluations


def test_a_force_by_hand_lasts_all_of_one_call() -> None:
    particle = Particle(velocity=Vector3(2.0), acceleration=Vector3(1.0), mass=4.0)
    step = adaptive(1e-9)
    for _ in range(2):
        particle.position, particle.velocity = Vector3(), Vector3(2.0)
        particle.add_force(Vector3(12.0))
        step([particle], lambda _: None, 0.5)
        # a + f / m is 4 m/s^2. The tolerance allows for some roundings.
        assert particle.velocity.x == pytest.approx(4.0, abs=1e-14)
        assert particle.position.x == pytest.approx(1.5, abs=1e-14)
        assert particle.last_acceleration.x == pytest.approx(4.0, abs=1e-14)
        assert tuple(particle.force_accumulator) == (0.0, 0.0, 0.0)


def test_a_force_by_hand_acts_beside_a_spring_in_every_step_of_the_call() -> None:
    """A constant force f shifts a spring's rest position by f / k: x = f / k (1 - cos(w t))."""
    particle = Particle()
    particle.add_force(Vector3(50.0))
    step = adaptive(1e-10)
    step([particle], acted(particle, AnchoredSpring(Vector3(), 100.0, 0.0)), 1.0)
    assert step.evaluations > 7
    assert particle.position.x == pytest.approx(0.5 * (1.0 - math.cos(10.0)), abs=1e-8)


def test_damping_multiplies_the_velocity_once_a_call() -> None:
    """The result equals that of the same call without damping, multiplied by d^h."""
    ends = []
    for damping in (1.0, 0.3):
        particle, apply_forces = swinging()
        particle.damping = damping
        adaptive(1e-9)([particle], apply_forces, 0.5)
        ends.append(state(particle))
    assert ends[1][:2].tolist() == ends[0][:2].tolist()
    assert ends[1][2:] == pytest.approx(ends[0][2:] * 0.3**0.5, rel=1e-15)


def test_the_last_acceleration_is_the_mean_one_of_the_call() -> None:
    particle, apply_forces = swinging()
    step = adaptive(1e-9)
    for _ in range(20):
        before = particle.velocity.copy()
        step([particle], apply_forces, 0.05)
        mean = (particle.velocity - before) / 0.05
        # The tolerance is the rounding of 3 m/s, divided by 0.05 s.
        assert tuple(particle.last_acceleration) == pytest.approx(tuple(mean), abs=1e-13)


def test_an_immovable_particle_stays_and_only_others_are_stepped() -> None:
    wall = Particle(Vector3(1.0, 2.0), Vector3(3.0), Vector3(0.0, -9.81), mass=math.inf)
    ball = Particle(Vector3(2.0, 2.0))
    registry = ForceRegistry()
    connect(registry, ball, wall, 100.0, 0.0)
    step = adaptive(1e-9)
    wall.add_force(Vector3(5.0))
    step([wall, ball], registry.update_forces, 0.1)
    assert tuple(state(wall)) == (1.0, 2.0, 3.0, 0.0)
    assert tuple(wall.force_accumulator) == (0.0, 0.0, 0.0)
    assert ball.position.x == pytest.approx(1.0 + math.cos(1.0), abs=1e-8)
    step([wall], registry.update_forces, 0.1)  # without any movable particle
    assert tuple(state(wall)) == (1.0, 2.0, 3.0, 0.0)


def test_a_connected_pair_keeps_its_momentum_and_swings_as_its_reduced_mass() -> None:
    a, b = Particle(Vector3(), Vector3(0.0, 1.0)), Particle(Vector3(1.5), mass=3.0)
    registry = ForceRegistry()
    connect(registry, a, b, 5.0, 1.0)
    step = adaptive(1e-9)
    for _ in range(240):
        step([a, b], registry.update_forces, FRAME)
        total = a.momentum() + b.momentum()
        # 240 calls, each with a rounding of 1 kg m/s.
        assert tuple(total) == pytest.approx((0.0, 1.0, 0.0), abs=1e-13)
    # Both start at rest. With mu = 3/4 kg, w^2 = k / mu.
    a, b = Particle(), Particle(Vector3(1.5), mass=3.0)
    registry = ForceRegistry()
    connect(registry, a, b, 5.0, 1.0)
    adaptive(1e-10)([a, b], registry.update_forces, 2.0)
    wanted = 1.0 + 0.5 * math.cos(math.sqrt(20.0 / 3.0) * 2.0)
    assert b.position.x - a.position.x == pytest.approx(wanted, abs=1e-8)


def test_a_call_moves_the_vectors_that_others_may_hold() -> None:
    leader = Particle(Vector3(1.0), Vector3(0.0, 2.0, 0.0))
    place, velocity = leader.position, leader.velocity
    adaptive(1e-6)([leader], lambda _: leader.add_force(Vector3(0.0, 0.0, 5.0)), FRAME)
    assert leader.position is place
    assert leader.velocity is velocity
    assert velocity.z == pytest.approx(5.0 * FRAME)


def test_a_world_can_use_it_and_what_lies_on_the_ground_stays() -> None:
    ball = Particle(acceleration=Vector3(0.0, -9.81))
    ground = GroundPlane([ball], restitution=0.5)
    world = ParticleWorld([ball], [ground], integrator=watched(adaptive(1e-6), 100.0))
    for _ in range(100):
        world.step(FRAME)
    # The contact stops what gravity adds in a frame, so the ball is at most g h^2 / 2 too low.
    assert ball.position.y == pytest.approx(0.0, abs=0.5 * 9.81 * FRAME**2 + 1e-9)
    assert ball.velocity.y == pytest.approx(0.0, abs=1e-12)


# State between calls


def test_it_keeps_the_length_of_its_step() -> None:
    """A new integrator in every frame must find its step again, and needs more evaluations."""
    particle = Particle(Vector3(1.0))
    apply_forces = acted(particle, AnchoredSpring(Vector3(), 1e4, 0.0))
    kept, anew = adaptive(1e-6), 0
    for _ in range(30):
        fresh, copy = adaptive(1e-6), Particle(particle.position, particle.velocity)
        fresh([copy], acted(copy, AnchoredSpring(Vector3(), 1e4, 0.0)), FRAME)
        anew += fresh.evaluations
        kept([particle], apply_forces, FRAME)
    # The first step is ten times too long. Repeating two steps costs 12 evaluations per frame.
    assert kept.evaluations < anew - 300


def test_what_is_changed_by_hand_between_calls_counts() -> None:
    """After a change of position, velocity, mass or spring, the new closed form holds."""
    particle, spring = Particle(Vector3(1.0)), AnchoredSpring(Vector3(), 1.0, 0.0)
    apply_forces = acted(particle, spring)
    step = adaptive(1e-10)
    for x, v, mass, k in ((1.0, 0.0, 1.0, 1.0), (-2.0, 3.0, 1.0, 1e4), (0.5, 0.0, 4.0, 9.0)):
        particle.position, particle.velocity, particle.mass = Vector3(x), Vector3(v), mass
        spring.stiffness = k
        w = math.sqrt(k / mass)
        for _ in range(5):
            step([particle], apply_forces, 0.1)
        wanted = x * math.cos(0.5 * w) + v / w * math.sin(0.5 * w)
        assert particle.position.x == pytest.approx(wanted, abs=1e-7)  # some hundred steps


def test_one_step_serves_two_groups_of_particles_in_turn() -> None:
    """Both groups are as accurate as alone, although their steps differ by a factor of 100."""
    step, worst = adaptive(1e-10), 0.0
    soft, stiff = Particle(Vector3(1.0)), Particle(Vector3(1.0))
    pull = acted(soft, AnchoredSpring(Vector3(), 1.0, 0.0))
    stiff_pull = acted(stiff, AnchoredSpring(Vector3(), 1e4, 0.0))
    for frame in range(1, 61):
        step([soft], pull, FRAME)
        step([stiff], stiff_pull, FRAME)
        worst = max(worst, abs(soft.position.x - math.cos(frame * FRAME)))
        worst = max(worst, abs(stiff.position.x - math.cos(100.0 * frame * FRAME)))
    assert worst < 1e-8  # a thousand steps of the stiff spring, within the tolerance


def test_it_is_deterministic() -> None:
    first, second = ((adaptive(1e-7), *comet()) for _ in range(2))
    for step, particle, apply_forces in (first, second):
        for _ in range(30):
            step([particle], apply_forces, 0.1)
    assert state(first[1]).tolist() == state(second[1]).tolist()
    assert first[0].evaluations == second[0].evaluations
