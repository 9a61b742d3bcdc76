"""The adaptive integrator against SciPy and closed forms, and the conditions that end a call."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, InverseSquareGravity
from ch05_forces.particle import Particle
from ch06_springs.going_further import adaptive as module
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.integrators import ApplyForces
from ch06_springs.springs import AnchoredSpring, connect

FRAME = 1.0 / 60.0
LOOSE = 1e6  # a tolerance that every step meets, so that a call makes a single step
START = [1.4, 0.2, -0.5, 2.0]


def acted(particle: Particle, *generators: ForceGenerator) -> ApplyForces:
    registry = ForceRegistry()
    for generator in generators:
        registry.add(particle, generator)
    return registry.update_forces


def swinging(damping: float = 1.0) -> tuple[Particle, ApplyForces]:
    """Return 2 kg that swing in the plane on a damped spring of 1 m, which is not linear."""
    place, velocity = Vector3(*START[:2]), Vector3(*START[2:])
    particle = Particle(place, velocity, Vector3(0.0, -3.0), mass=2.0, damping=damping)
    return particle, acted(particle, AnchoredSpring(Vector3(), 30.0, 1.0, 4.0))


def swinging_rates(_: float, y: Any) -> list[float]:
    place, velocity = y[:2], y[2:]
    length = math.hypot(*place)
    pull = 30.0 * (length - 1.0) + 4.0 * (velocity @ place) / length
    return [*velocity, *([0.0, -3.0] - pull / 2.0 * place / length)]


def sprung(k: float) -> tuple[Particle, ApplyForces]:
    """Return 1 kg that is released 1 m from the anchor of a spring with rest length 0."""
    particle = Particle(Vector3(1.0))
    return particle, acted(particle, AnchoredSpring(Vector3(), k, 0.0))


def state(particle: Particle) -> Any:
    p, v = particle.position, particle.velocity
    return numpy.array([p.x, p.y, v.x, v.y])


# Comparison with SciPy and closed forms


@pytest.mark.parametrize("h", [0.01, 0.2])
def test_one_step_is_that_of_scipy(h: float) -> None:
    """SciPy's RK45 is the same pair of methods. If it makes a single step, the step is h."""
    particle, apply_forces = swinging()
    adaptive(LOOSE)([particle], apply_forces, h)
    theirs = solve_ivp(swinging_rates, (0.0, h), START, first_step=h, rtol=1.0, atol=LOOSE)
    assert theirs.t.tolist() == [0.0, h]
    assert state(particle) == pytest.approx(theirs.y[:, -1], abs=1e-14)  # rounding of 2 m/s


def test_the_error_is_in_proportion_to_the_tolerance_over_eight_decades() -> None:
    truth = solve_ivp(swinging_rates, (0.0, 3.0), START, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    errors, tolerances = [], [10.0**-n for n in range(3, 12)]
    for tolerance in tolerances:
        (particle, apply_forces), step = swinging(), adaptive(tolerance)
        step([particle], apply_forces, 3.0)  # one call, without frames
        errors.append(float(abs(state(particle) - truth).max()))
    slope = numpy.polyfit(numpy.log(tolerances), numpy.log(errors), 1)[0]
    assert slope == pytest.approx(1.0, abs=0.15)  # the estimate has order 4, and the step order 5
    # Some tens of steps, each with an error of at most the tolerance.
    assert max(e / t for e, t in zip(errors, tolerances, strict=True)) < 100.0
    assert step.evaluations < 2800  # at the last tolerance; 2533 were measured


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
    place, velocity = particle.position, particle.velocity
    particle.add_force(Vector3(12.0))
    step = adaptive(1e-9)
    step([particle], lambda _: None, 0.5)
    # a + f / m is 4 m/s^2. The tolerance allows for some roundings.
    assert (place.x, velocity.x) == pytest.approx((1.5, 4.0), abs=1e-14)
    assert particle.last_acceleration.x == pytest.approx(4.0, abs=1e-14)
    step([particle], lambda _: None, 0.5)
    # Others may hold the vectors, so the same ones have moved.
    assert (place.x, velocity.x) == pytest.approx((1.5 + 2.0 + 0.125, 4.5), abs=1e-14)


def test_damping_acts_once_a_call_after_the_mean_acceleration() -> None:
    ends = []
    for damping in (1.0, 0.3):
        particle, apply_forces = swinging(damping)
        adaptive(1e-9)([particle], apply_forces, 0.5)
        ends.append(state(particle))
        mean = (ends[0][2:] - START[2:]) / 0.5
        assert [*particle.last_acceleration][:2] == pytest.approx(mean, abs=1e-13)
    assert ends[1][:2].tolist() == ends[0][:2].tolist()
    assert ends[1][2:] == pytest.approx(ends[0][2:] * 0.3**0.5, rel=1e-15)


def test_a_pair_swings_as_its_reduced_mass_beside_an_immovable_particle() -> None:
    """With mu = 3/4 kg, w^2 = k / mu."""
    wall = Particle(Vector3(1.0, 2.0), Vector3(3.0), Vector3(0.0, -9.81), mass=math.inf)
    a, b = Particle(), Particle(Vector3(1.5), mass=3.0)
    registry = ForceRegistry()
    connect(registry, a, b, 5.0, 1.0)
    wall.add_force(Vector3(5.0))
    step = adaptive(1e-10)
    step([a, wall, b], registry.update_forces, 2.0)
    wanted = 1.0 + 0.5 * math.cos(math.sqrt(20.0 / 3.0) * 2.0)
    assert b.position.x - a.position.x == pytest.approx(wanted, abs=1e-8)
    step([wall], registry.update_forces, 0.1)  # without any movable particle
    assert tuple(state(wall)) == (1.0, 2.0, 3.0, 0.0)
    assert tuple(wall.force_accumulator) == (0.0, 0.0, 0.0)


# State between calls


def test_it_keeps_the_length_of_its_step() -> None:
    """A new integrator in every frame must find its step again, and needs more evaluations."""
    particle, apply_forces = sprung(1e4)
    kept, anew = adaptive(1e-6), 0
    for _ in range(30):
        fresh, copy = adaptive(1e-6), Particle(particle.position, particle.velocity)
        fresh([copy], acted(copy, AnchoredSpring(Vector3(), 1e4, 0.0)), FRAME)
        anew += fresh.evaluations
        kept([particle], apply_forces, FRAME)
    # The first step is ten times too long. Repeating two steps costs 12 evaluations per frame.
    assert kept.evaluations < anew - 300


def test_one_step_serves_two_groups_of_particles_in_turn() -> None:
    """Both groups are as accurate as alone, although their steps differ by a factor of 100."""
    step, worst = adaptive(1e-10), 0.0
    (soft, pull), (stiff, stiff_pull) = sprung(1.0), sprung(1e4)
    for frame in range(1, 61):
        step([soft], pull, FRAME)
        step([stiff], stiff_pull, FRAME)
        worst = max(worst, abs(soft.position.x - math.cos(frame * FRAME)))
        worst = max(worst, abs(stiff.position.x - math.cos(100.0 * frame * FRAME)))
    assert worst < 1e-8  # a thousand steps of the stiff spring, within the tolerance


# What ends a call


def test_a_fall_into_a_center_stops_with_a_clear_error() -> None:
    """From rest at 1 m, the fall takes pi / sqrt(8) s and ends in a singularity."""
    particle = Particle(Vector3(1.0))
    apply_forces, step = acted(particle, InverseSquareGravity(Vector3(), 1.0)), adaptive(1e-6)
    words = r"adaptive\(1e-06\) cannot go on at (.*) s of a call of 2 s, with steps of"
    with pytest.raises(ArithmeticError, match=words) as raised:
        step([particle], apply_forces, 2.0)
    reached = float(str(raised.value).split(" at ")[1].split()[0])
    assert reached == pytest.approx(math.pi / math.sqrt(8.0), abs=1e-4)
    assert 0.0 < particle.position.magnitude() < 1e-3  # the position after the last good step
    assert tuple(particle.force_accumulator) == (0.0, 0.0, 0.0)
    assert step.evaluations < 6 * module.MOST_STEPS
    # It can be used again, and does not keep the length of its last step.
    particle.position, particle.velocity, step.evaluations = Vector3(1.0), Vector3(0.0, 1.0), 0
    step([particle], apply_forces, 0.01)
    assert step.evaluations == 7
    wanted = math.cos(0.01), math.sin(0.01), 0.0
    assert tuple(particle.position) == pytest.approx(wanted, abs=1e-6)


def test_a_trial_that_leads_to_where_no_force_can_be_found_is_only_too_long() -> None:
    particle = Particle(Vector3(1.0))
    refused = []

    def apply_forces(_: float) -> None:
        x = particle.position.x
        if abs(x) > 1.5:
            refused.append(x)
            raise (ValueError if len(refused) % 2 else ZeroDivisionError)("out of bounds")
        particle.add_force(Vector3(-x))

    adaptive(1e-10)([particle], apply_forces, 10.0)
    assert refused
    assert particle.position.x == pytest.approx(math.cos(10.0), abs=1e-8)


def test_forces_that_fail_where_the_motion_has_to_go_are_named() -> None:
    particle = Particle(velocity=Vector3(1.0))

    def wall(_: float) -> None:
        if particle.position.x > 0.5:
            raise ValueError("there is no force beyond 0.5 m")

    with pytest.raises(ArithmeticError, match=r"at 0\.5 s of a call of 1 s") as raised:
        adaptive(1e-6)([particle], wall, 1.0)
    assert str(raised.value.__cause__) == "there is no force beyond 0.5 m"
    assert particle.position.x == pytest.approx(0.5, abs=1e-13)
    particle.position.x = 0.6
    with pytest.raises(ValueError, match="there is no force"):  # at the start of the call
        adaptive(1e-6)([particle], wall, 1.0)
    assert (particle.position.x, particle.velocity.x) == (0.6, 1.0)


class Unchecked(Particle):
    """A particle that accepts any force, like one whose add_force checks nothing."""

    @property
    def force_accumulator(self) -> Vector3:
        return Vector3(math.nan if self.position.x > 0.5 else 0.0)


def test_a_force_that_is_not_a_number_ends_in_an_error() -> None:
    bullet, step = Unchecked(velocity=Vector3(1.0)), adaptive(1e-6)
    with pytest.raises(ArithmeticError, match=r"at 0\.5 s of a call of 1 s"):
        step([Particle(mass=math.inf), bullet], lambda _: None, 1.0)
    assert step.evaluations < 1000


def test_a_call_ends_after_the_most_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MOST_STEPS", 50)
    particle, apply_forces = sprung(1e4)
    with pytest.raises(ArithmeticError, match=r"cannot go on at .* s of a call of 10 s"):
        adaptive(1e-9)([particle], apply_forces, 10.0)
    assert abs(particle.position.x) <= 1.0
