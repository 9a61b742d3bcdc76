"""Compute the numbers of chapter 5's lesson with the reference."""

from __future__ import annotations

import math
from types import SimpleNamespace

from ch02_vectors.calculus import difference_quotients
from ch02_vectors.recordings import FILTERS_MASS, falling_filters
from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import drag_limits, quadratic_fall, terminal_speed
from ch05_forces.forces import Drag, Gravity, InverseSquareGravity, drag_force
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, runge_kutta_4, semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from ch08_mass_aggregate.world import ParticleWorld
from lessons.lesson import Facts

facts = Facts()

facts.section("Forces add up", "9.81 20 30 40 60 80 500")
jumper = Particle(mass=80)
Gravity(Vector3(0, -9.81)).update_force(jumper, 1.0)
jumper.add_force(Vector3(60, 500))
facts.says("784.8 284.8", 80 * 9.81, jumper.force_accumulator.y)
jumper.kick(1.0)
facts.says("0.75 3.56", jumper.velocity.x, jumper.velocity.y)
total = Vector3(30) + Vector3(0, 40)
facts.says("50 2.5", total.magnitude(), total.magnitude() / 20)

facts.section("Drag", "30 120 10 20 0.1 0.02 0.003 9.81")
force = drag_force(Vector3(3, 4), 0.1, 0.02)
facts.says("5 25", Vector3(3, 4).magnitude(), Vector3(3, 4).squared_magnitude())
facts.says("100 0.6 0.8", Vector3(6, 8).squared_magnitude(), force.x, force.y)
speed, _ = quadratic_fall(1, 10, 10 / 20**2, 2)  # k2 = m g / u^2
facts.says("31.6 0.762 15.2", terminal_speed(2 * 10, 0, 0.02), math.tanh(1), speed)
# The drag of the filmed filters, with the right law and with a linear one.
times, positions = falling_filters()
_, (velocity,) = difference_quotients(times[30::30], positions[30::30])
u, weight = -velocity.y, FILTERS_MASS * 9.81
behind = u * u / 9.81  # v = u (1 - e^(-g t / u)), and e^(-g t / u) is 0.004 after 1 s
linear = u - behind * (1 - math.exp(-9.81 / u))
facts.says("1.75 0.0294 0.0096 0.0168", u, weight, weight / u**2, weight / u)
facts.says("0.312 1.44", 1.75**2 / 9.81, linear)
fallen = positions[0].y - positions[-1].y
assert abs(quadratic_fall(FILTERS_MASS, 9.81, weight / u**2, 1)[1] - fallen) < 0.003
assert fallen - linear > 0.09

facts.section("When drag explodes", "5 10 15 20 25 0.1")


def braked(k1: float) -> list[float]:
    particle = Particle(velocity=Vector3(10))
    speeds = []
    for _ in range(3):
        Drag(k1, 0).update_force(particle, 0.1)
        particle.kick(0.1)
        speeds.append(particle.velocity.x)
    return speeds


slows, explodes = braked(5), braked(25)
facts.says("0.5 2.5 1.25", slows[0] / 10, *slows[1:])
facts.says("1.5 22.5 33.8", explodes[0] / 10, *explodes[1:])
longest = drag_limits(20, 0, 0.5, 0)[0]
facts.says("0.025 40", longest, 1 / longest)

facts.section("Four forces of your own", "100")
planet = Particle(Vector3(4))
InverseSquareGravity(Vector3(), 100).update_force(planet, 1.0)
gravity = -planet.force_accumulator.x
speed = math.sqrt(gravity * 4)
facts.says("16 6.25 25 5", 4.0**2, gravity, speed**2, speed)
facts.says("5.03", 2 * math.pi * 4 / speed)

facts.section("A force that needs the time", "60 100")


def driven(time: float) -> float:
    return 10 / (100 - 8**2) * (math.cos(8 * time) - math.cos(10 * time))


def largest_error(integrator: Integrator, adds_up: bool) -> float:
    """Return the largest error of the sign's position in m, in gusts of 10 N cos(8 t) along X.

    The force adds up the durations of its calls, or reads the time from a particle at 1 m/s.
    """
    clock, sign, durations = Particle(velocity=Vector3(1)), Particle(), []
    world = ParticleWorld([clock, sign], integrator=integrator)

    def update_force(particle: Particle, duration: float) -> None:
        time = sum(durations) if adds_up else clock.position.x
        durations.append(duration)
        particle.add_force(Vector3(10 * math.cos(8 * time)))

    world.registry.add(sign, AnchoredSpring(Vector3(), 100, 0))
    world.registry.add(sign, SimpleNamespace(update_force=update_force))
    errors = []
    for frame in range(1, 4 * 60 + 1):
        world.step(1 / 60)
        errors.append(abs(sign.position.x - driven(frame / 60)))
    return max(errors)


for number, method in (("20", semi_implicit_euler), ("0.065", runge_kutta_4)):
    facts.says(number, 1000 * largest_error(method, False))
wrong = largest_error(runge_kutta_4, True)
facts.says("0.58", wrong)
# "As much as the sign moves at all"
assert abs(wrong / max(abs(driven(n / 60)) for n in range(241)) - 1) < 0.1

facts.section("Project: a sniper range", "10 50 90 100 200")
