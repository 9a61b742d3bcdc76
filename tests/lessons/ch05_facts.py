"""Compute the numbers of chapter 5's lesson with the reference."""

from __future__ import annotations

import math
from collections.abc import Callable

from ch02_vectors.calculus import difference_quotients
from ch02_vectors.recordings import FILTERS_MASS, falling_filters
from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import drag_limits, quadratic_fall, terminal_speed
from ch05_forces.forces import Drag, Gravity, InverseSquareGravity, drag_force
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, runge_kutta_4, semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from ch08_mass_aggregate.world import ParticleWorld


def accelerated(mass: float, *forces: Vector3) -> Vector3:
    """Return the acceleration that forces cause, as the change in velocity in a step of 1 s."""
    particle = Particle(mass=mass)
    for force in forces:
        particle.add_force(force)
    particle.kick(1.0)
    return particle.velocity


def sums() -> dict[str, float]:
    jumper = Particle(mass=80)
    Gravity(Vector3(0, -9.81)).update_force(jumper, 1.0)
    jumper.add_force(Vector3(60, 500))
    total = jumper.force_accumulator
    jumper.kick(1.0)
    return {
        "784.8": 80 * 9.81,
        "284.8": total.y,
        "0.75": jumper.velocity.x,
        "3.56": jumper.velocity.y,
        "2.5": accelerated(20, Vector3(30), Vector3(0, 40)).magnitude(),
        "50": 20 * accelerated(20, Vector3(30), Vector3(0, 40)).magnitude(),
    }


def drags() -> dict[str, float]:
    force = drag_force(Vector3(3, 4), 0.1, 0.02)
    assert abs(force.magnitude() - 1.0) < 1e-12
    assert abs(drag_force(Vector3(6, 8), 0.1, 0.02).magnitude() - 3.0) < 1e-12
    speed, _ = quadratic_fall(1, 10, 10 / 20**2, 2)  # k2 = m g / u^2
    return {
        "0.6": force.x,
        "0.8": force.y,
        "25": Vector3(3, 4).squared_magnitude(),
        "100": Vector3(6, 8).squared_magnitude(),
        "5": Vector3(3, 4).magnitude(),
        "31.6": terminal_speed(2 * 10, 0, 0.02),
        "0.762": math.tanh(1),
        "15.2": speed,
    } | filters()


def filters() -> dict[str, float]:
    """Find the drag of the filmed filters, with and without the right law."""
    times, positions = falling_filters()
    assert (times[-1], FILTERS_MASS) == (1.0, 0.003)
    _, (velocity,) = difference_quotients(times[30::30], positions[30::30])
    u, weight = -velocity.y, FILTERS_MASS * 9.81
    behind = u * u / 9.81  # v = u (1 - e^(-g t / u)), and e^(-g t / u) is 0.004 after 1 s
    fallen = positions[0].y - positions[-1].y
    linear = u - behind * (1 - math.exp(-9.81 / u))
    assert abs(quadratic_fall(FILTERS_MASS, 9.81, weight / u**2, 1)[1] - fallen) < 0.003
    assert fallen - linear > 0.09
    return {
        "1.75": u,
        "0.0294": weight,
        "0.0096": weight / u**2,
        "0.0168": weight / u,
        "0.312": 1.75**2 / 9.81,
        "1.44": linear,
    }


def braked(k1: float) -> list[float]:
    particle = Particle(velocity=Vector3(10))
    speeds = []
    for _ in range(3):
        Drag(k1, 0).update_force(particle, 0.1)
        particle.kick(0.1)
        speeds.append(particle.velocity.x)
    return speeds


def explosions() -> dict[str, float]:
    slows, reverses, explodes = braked(5), braked(15), braked(25)
    assert reverses[0] == -slows[0] == -5
    assert explodes[0] == -15
    return {
        "0.5": slows[0] / 10,
        "1.5": explodes[0] / 10,
        "2.5": slows[1],
        "1.25": slows[2],
        "22.5": explodes[1],
        "33.8": explodes[2],
        "0.025": drag_limits(20, 0, 0.5, 0)[0],
        "40": 1 / drag_limits(20, 0, 0.5, 0)[0],
    }


def orbits() -> dict[str, float]:
    particle = Particle(Vector3(4))
    InverseSquareGravity(Vector3(), 100).update_force(particle, 1.0)
    gravity = -particle.force_accumulator.x
    speed = math.sqrt(gravity * 4)
    return {
        "16": 4.0**2,
        "6.25": gravity,
        "25": speed**2,
        "5": speed,
        "5.03": 2 * math.pi * 4 / speed,
    }


class Gusts:
    """A force of 10 N cos(8 t) along X, which gets the time from a function."""

    def __init__(self, time_after: Callable[[float], float]) -> None:
        self.time_after = time_after

    def update_force(self, particle: Particle, duration: float) -> None:
        particle.add_force(Vector3(10 * math.cos(8 * self.time_after(duration))))


def adding() -> Callable[[float], float]:
    """Return a clock that adds up the durations of its calls, and shows the time before each."""
    durations = [0.0]

    def time_after(duration: float) -> float:
        durations.append(duration)
        return sum(durations[:-1])

    return time_after


def largest_error(integrator: Integrator, clock_is_particle: bool) -> float:
    """Return the largest error of the sign's position in m, against x'' = -100 x + 10 cos(8 t)."""
    clock, sign = Particle(velocity=Vector3(1)), Particle()
    world = ParticleWorld([clock, sign], integrator=integrator)
    world.registry.add(sign, AnchoredSpring(Vector3(), 100, 0))
    time_after = (lambda _: clock.position.x) if clock_is_particle else adding()
    world.registry.add(sign, Gusts(time_after))
    errors = []
    for frame in range(1, 4 * 60 + 1):
        world.step(1 / 60)
        t = frame / 60
        errors.append(abs(sign.position.x - driven(t)))
    return max(errors)


def driven(time: float) -> float:
    return 10 / (100 - 8**2) * (math.cos(8 * time) - math.cos(10 * time))


def clocks() -> dict[str, float]:
    error = largest_error(semi_implicit_euler, True)
    assert math.isclose(error, largest_error(semi_implicit_euler, False), rel_tol=1e-9)
    wrong = largest_error(runge_kutta_4, False)
    # "As much as the sign moves at all"
    assert abs(wrong / max(abs(driven(n / 60)) for n in range(241)) - 1) < 0.1
    return {
        "20": 1000 * error,
        "0.065": 1000 * largest_error(runge_kutta_4, True),
        "0.58": wrong,
    }


SECTIONS = {
    "Forces add up": ("9.81 20 30 40 60 80 500", sums),
    "Drag": ("30 120 10 20 0.1 0.02 0.003 9.81", drags),
    "When drag explodes": ("5 10 15 20 25 0.1", explosions),
    "Four forces of your own": ("100", orbits),
    "A force that needs the time": ("60 100", clocks),
    "Project: a sniper range": ("10 50 90 100 200", dict),
}
