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

K, H = 36.0, 0.1


def springs() -> dict[str, float]:
    resting = Vector3(), 20.0, 1.0
    moving = spring_force(Vector3(0, -1.5), Vector3(3, -2), 20, 1, 0.5)
    pull = spring_force(Vector3(0, -1.5), *resting)
    assert moving - pull == Vector3(0, 1, 0)
    return {
        "10": pull.y,
        "15": spring_force(Vector3(2.3), Vector3(), 50, 2).x,
        "85": spring_force(Vector3(2.3), Vector3(), 50, 4).x,
        "0.2": 1 - 0.8,
        "0.3": 2.3 - 2,
        "1.7": 4 - 2.3,
    }


def water() -> dict[str, float]:
    crate = Particle(Vector3(0, 2.25), mass=25)
    Buoyancy(0.5, 0.1, 2).update_force(crate, H)
    lift = crate.force_accumulator.y
    displaced = lift / 9.81 / 1000
    return {"0.25": displaced / 0.1, "0.025": displaced, "25": lift / 9.81, "245": lift}


def truth() -> dict[str, float]:
    omega = math.sqrt(K)
    return {
        "6": omega,
        "1.05": 2 * math.pi / omega,
        "0.6": omega * H,
        "0.825": damped_spring_state(1, 0, K, 0, 1, H)[0],
        "12": 2 * math.sqrt(K),
    }


def run(integrator: Integrator, steps: int, h: float = H) -> tuple[float, float, float]:
    """Return the final position, velocity and energy of a 1 kg ball on a spring of 36 N/m."""
    ball = Particle(Vector3(1))
    registry = ForceRegistry()
    registry.add(ball, AnchoredSpring(Vector3(), K, 0))
    for _ in range(steps):
        integrator([ball], registry.update_forces, h)
    x, v = ball.position.x, ball.velocity.x
    return x, v, ball.kinetic_energy() + K * x * x / 2


def wandering() -> tuple[float, float]:
    """Return the lowest and highest energy in J of 100 s of semi-implicit Euler."""
    ball = Particle(Vector3(1))
    registry = ForceRegistry()
    registry.add(ball, AnchoredSpring(Vector3(), K, 0))
    energies = []
    for _ in range(round(100 / H)):
        semi_implicit_euler([ball], registry.update_forces, H)
        energies.append(ball.kinetic_energy() + K * ball.position.x**2 / 2)
    return min(energies), max(energies)


def energies() -> dict[str, float]:
    start = K / 2
    _, v1, first = run(explicit_euler, 1)
    x2, v2, second = run(explicit_euler, 2)
    swapped = run(semi_implicit_euler, 1)
    slow = run(explicit_euler, 100, 0.01)[2] / start
    assert swapped[:2] == (x2, v1)
    lowest, highest = wandering()
    assert lowest > 13.846  # the energy after the first step
    return {
        "18": start,
        "3.6": v1,
        "24.48": first,
        "0.64": x2,
        "7.2": v2,
        "33.29": second,
        "1.36": first / start,
        "0.36": first / start - 1,
        "21.6": run(explicit_euler, 10)[2] / start,
        "1.0036": run(explicit_euler, 1, 0.01)[2] / start,
        "1.43": slow,
        "43": 100 * (slow - 1),
        "13.85": swapped[2],
        "25.71": highest,
    }


def limits() -> dict[str, float]:
    return {"14,400": 4.0 * 60**2, "57,600": 4.0 * 120**2, "6.3": max_stable_stiffness(0.9, 1 / 60)}


def velocity_error(integrator: Integrator, steps: int, damping: float) -> float:
    """Return the error in the velocity of a damped 1 kg ball on a spring of 36 N/m after 2 s."""
    ball = Particle(Vector3(1), damping=damping)
    registry = ForceRegistry()
    registry.add(ball, AnchoredSpring(Vector3(), K, 0))
    for _ in range(steps):
        integrator([ball], registry.update_forces, 2 / steps)
    return abs(ball.velocity.x - damped_spring_state(1, 0, K, -math.log(damping), 1, 2)[1])


def largest_error(integrator: Integrator, steps: int, seconds: float) -> float:
    """Return the largest error in the position of a 1 kg ball on a spring of 36 N/m, in m."""
    ball = Particle(Vector3(1))
    registry = ForceRegistry()
    registry.add(ball, AnchoredSpring(Vector3(), K, 0))
    errors = []
    for i in range(1, steps + 1):
        integrator([ball], registry.update_forces, seconds / steps)
        exact = damped_spring_state(1, 0, K, 0, 1, seconds * i / steps)[0]
        errors.append(abs(ball.position.x - exact))
    return max(errors)


def equally_accurate(oscillations: int) -> int:
    """Return with how many evaluations in each oscillation Runge-Kutta overtakes leapfrog."""
    seconds = oscillations * 2 * math.pi / math.sqrt(K)
    for evaluations in range(20, 100):
        steps = round(evaluations * oscillations / 4)
        fourth = largest_error(runge_kutta_4, steps, seconds)
        if fourth < largest_error(leapfrog, 4 * steps, seconds):
            return evaluations
    raise AssertionError("leapfrog is always better")


def kept_by_runge_kutta(steps: int) -> float:
    """Return the fraction of the energy left after 10,000 oscillations of some steps each."""
    h = 2 * math.pi / math.sqrt(K) / steps
    lost = 1 - run(runge_kutta_4, 100 * steps, h)[2] / (K / 2)
    formula = 100 * steps * (math.sqrt(K) * h) ** 6 / 72
    assert abs(lost / formula - 1) < 0.02
    return (1 - lost) ** 100


def stretched() -> float:
    """Return how many times as slowly a faked spring swings with short steps."""
    ball, h = Particle(Vector3(1)), 1e-4
    fake, steps = FakeStiffSpring(Vector3(), K, 0), 0
    while ball.position.x > 0:
        fake.update_force(ball, h)
        semi_implicit_euler([ball], lambda _: None, h)
        steps += 1
    return steps * h / (math.pi / 2 / math.sqrt(K))


def accuracy() -> dict[str, float]:
    assert min(equally_accurate(n) for n in (2, 20)) >= 44
    assert max(equally_accurate(n) for n in (2, 20)) <= 48
    for method in (semi_implicit_euler, leapfrog, velocity_verlet, runge_kutta_4):
        longer, shorter = (velocity_error(method, steps, 0.5) for steps in (1920, 3840))
        assert abs(longer / shorter - 2) < 0.1, method  # order 1
    longer, shorter = (velocity_error(runge_kutta_4, steps, 1) for steps in (120, 240))
    assert abs(longer / shorter - 16) < 0.5  # order 4
    assert abs(kept_by_runge_kutta(38) - 0.9) < 0.005
    assert abs(kept_by_runge_kutta(60) - 0.99) < 0.005
    verlet, frog = (run(method, 60, 1 / 30)[0] for method in (velocity_verlet, leapfrog))
    exact = damped_spring_state(1, 0, K, 0, 1, 2)[0]
    assert abs((verlet - exact) / (frog - exact) - 1) < 1e-9
    millimeters = {
        **{
            token: 1000 * largest_error(leapfrog, steps, 2)
            for token, steps in (("29", 48), ("8.6", 88), ("1.15", 240), ("0.29", 480))
        },
        **{
            token: 1000 * largest_error(runge_kutta_4, steps // 4, 2)
            for token, steps in (("95", 48), ("8.4", 88), ("0.15", 240), ("0.009", 480))
        },
    }
    oscillations = 2 * math.sqrt(K) / (2 * math.pi)
    return millimeters | {"1.91": oscillations, "46": 88 / oscillations, "1.41": stretched()}


def one_step() -> dict[str, float]:
    exact = damped_spring_state(1, 0, K, 0, 1, H)[0]
    verlet, fourth = run(velocity_verlet, 1)[0], run(runge_kutta_4, 1)[0]
    return {
        "0.8253": exact,
        "0.1747": run(explicit_euler, 1)[0] - exact,
        "0.64": run(semi_implicit_euler, 1)[0],
        "0.1853": run(semi_implicit_euler, 1)[0] - exact,
        "0.82": verlet,
        "0.0053": verlet - exact,
        "0.8254": fourth,
        "0.0001": fourth - exact,
    } | accuracy()


SECTIONS = {
    "Springs": ("20 1.5 0.5 0.8 50 2.3", springs),
    "Water, balloons, crowds and bullets": ("0.1 0.5 2.25 9.81", water),
    "The exact motion of a spring": ("36 0.1", truth),
    "A ball that gains energy from nothing": ("36 10 0.1 0.01 60 100", energies),
    "How stiff may a spring be?": ("60 0.9 800 14,500 1.1", limits),
    "Better methods for the same forces": ("6 36 38 48 60 72 88 240 480 0.1 0.5", one_step),
    "A cloth": ("10 50 85 180 200 480", lambda: {"0.55": 200 / 0.050 / 85**2}),
    "Summary": ("8", dict),
}
