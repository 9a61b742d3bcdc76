"""Compute the numbers of chapter 6's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
    velocity_verlet,
)
from ch06_springs.other_forces import Buoyancy
from ch06_springs.springs import (
    AnchoredSpring,
    FakeStiffSpring,
    max_stable_stiffness,
    spring_force,
)
from lessons.lesson import Facts

K, H = 36.0, 0.1
OMEGA = math.sqrt(K)
PERIOD = 2 * math.pi / OMEGA
facts = Facts()

facts.section("Springs", "20 1.5 0.5 0.8 50 2.3")
facts.says("10", spring_force(Vector3(0, -1.5), Vector3(), 20, 1).y)
facts.says("15 85", *(spring_force(Vector3(2.3), Vector3(), 50, rest).x for rest in (2, 4)))
facts.says("0.2 0.3 1.7", 1 - 0.8, 2.3 - 2, 4 - 2.3)

facts.section("Water, balloons, crowds and bullets", "0.1 0.5 2.25 9.81")
crate = Particle(Vector3(0, 2.25), mass=25)
Buoyancy(0.5, 0.1, 2).update_force(crate, H)
lift = crate.force_accumulator.y
displaced = lift / 9.81 / 1000
facts.says("0.25 0.025 25 245", displaced / 0.1, displaced, lift / 9.81, lift)

facts.section("The exact motion of a spring", "36 0.1")
after = damped_spring_state(1, 0, K, 0, 1, H)[0]
facts.says("6 1.05 0.6 0.825 12", OMEGA, PERIOD, OMEGA * H, after, 2 * math.sqrt(K))

facts.section("A ball that gains energy from nothing", "36 10 0.1 0.01 60 100")


def run(integrator: Integrator, steps: int, h: float = H) -> list[tuple[float, float, float]]:
    """Return position, velocity and energy of a 1 kg ball on a spring of 36 N/m, by step."""
    ball, registry = Particle(Vector3(1)), ForceRegistry()
    registry.add(ball, AnchoredSpring(Vector3(), K, 0))
    states = []
    for _ in range(steps):
        integrator([ball], registry.update_forces, h)
        x, v = ball.position.x, ball.velocity.x
        states.append((x, v, ball.kinetic_energy() + K * x * x / 2))
    return states


start = K / 2
facts.says("18 21.6", start, run(explicit_euler, 10)[-1][2] / start)
(_, v1, first), (x2, v2, second) = run(explicit_euler, 2)
facts.says("3.6 24.48 0.64 7.2 33.29", v1, first, x2, v2, second)
facts.says("1.36 0.36", first / start, first / start - 1)
slow = [energy / start for _, _, energy in run(explicit_euler, 100, 0.01)]
facts.says("1.0036 1.43 43", slow[0], slow[-1], 100 * (slow[-1] - 1))
energies = [energy for _, _, energy in run(semi_implicit_euler, round(100 / H))]
facts.says("13.85 25.71", min(energies), max(energies))

facts.section("How stiff may a spring be?", "60 0.9 800 14,500 1.1")
facts.says("14,400 57,600", 4.0 * 60**2, 4.0 * 120**2)
facts.says("6.3", max_stable_stiffness(0.9, 1 / 60))

facts.section("Better methods for the same forces", "6 36 38 48 60 72 88 240 480 0.1 0.5")
exact = damped_spring_state(1, 0, K, 0, 1, H)[0]
facts.says("0.8253 0.1747", exact, run(explicit_euler, 1)[0][0] - exact)
for method, position, error in (
    (semi_implicit_euler, "0.64", "0.1853"),
    (velocity_verlet, "0.82", "0.0053"),
    (runge_kutta_4, "0.8254", "0.0001"),
):
    x = run(method, 1)[0][0]
    facts.says(f"{position} {error}", x, x - exact)


def largest_error(integrator: Integrator, steps: int, seconds: float) -> float:
    """Return the largest error in the position of the ball on the spring, in mm."""
    h = seconds / steps
    states = enumerate(run(integrator, steps, h), 1)
    return 1000 * max(abs(x - math.cos(OMEGA * h * i)) for i, (x, *_) in states)


evaluations = 48, 88, 240, 480
facts.says("29 8.6 1.15 0.29", *(largest_error(leapfrog, n, 2) for n in evaluations))
facts.says("95 8.4 0.15 0.009", *(largest_error(runge_kutta_4, n // 4, 2) for n in evaluations))
facts.says("1.91 46", 2 / PERIOD, 88 * PERIOD / 2)
for oscillations in (2, 20):  # with more evaluations than about 46, Runge-Kutta is better
    for evaluations, is_better in ((43, False), (48, True)):
        steps, seconds = round(evaluations * oscillations / 4), oscillations * PERIOD
        fourth = largest_error(runge_kutta_4, steps, seconds)
        assert (fourth < largest_error(leapfrog, 4 * steps, seconds)) is is_better
ball, h, steps = Particle(Vector3(1)), 1e-3, 0
fake = FakeStiffSpring(Vector3(), K, 0)
while ball.position.x > 0:
    fake.update_force(ball, h)
    semi_implicit_euler([ball], lambda _: None, h)
    steps += 1
facts.says("1.41", steps * h / (PERIOD / 4))

facts.section("A cloth", "10 50 85 180 200 480")
facts.says("0.55", 200 / 0.050 / 85**2)

facts.section("Summary", "8")
