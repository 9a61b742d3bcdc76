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
    runge_kutta_4,
    semi_implicit_euler,
    velocity_verlet,
)
from ch06_springs.other_forces import Buoyancy
from ch06_springs.springs import AnchoredSpring, max_stable_stiffness, spring_force

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


def energies() -> dict[str, float]:
    start = K / 2
    _, v1, first = run(explicit_euler, 1)
    x2, v2, second = run(explicit_euler, 2)
    swapped = run(semi_implicit_euler, 1)
    slow = run(explicit_euler, 100, 0.01)[2] / start
    assert swapped[:2] == (x2, v1)
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
    }


def limits() -> dict[str, float]:
    return {"14,400": 4.0 * 60**2, "57,600": 4.0 * 120**2, "6.3": max_stable_stiffness(0.9, 1 / 60)}


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
    }


SECTIONS = {
    "Springs": ("20 1.5 0.5 0.8 50 2.3", springs),
    "Water, balloons, crowds and bullets": ("0.1 0.5 2.25 9.81", water),
    "The exact motion of a spring": ("36 0.1", truth),
    "A ball that gains energy from nothing": ("36 10 0.1 0.01 60 100", energies),
    "How stiff may a spring be?": ("60 0.9 800 14,500 1.1", limits),
    "Better methods for the same forces": ("36 0.1", one_step),
    "A cloth": ("10 180 480", dict),
    "Summary": ("8", dict),
}
