"""Compute the numbers of chapter 3's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.calculus import difference_quotients
from ch02_vectors.recordings import BALL_RATE, thrown_ball
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.exercises import (
    damping_difference,
    gravity_between,
    random_frames,
    stepping_error,
)
from ch03_laws_of_motion.particle import Particle
from lessons.lesson import Facts

facts = Facts()

facts.section("A game that never sees the whole motion", "60")

facts.section("Mass: how hard it is to change a velocity", "6 0.1 0.5 0.25")


def pushed(mass: float) -> float:
    """Return the speed that 6 N give to a mass in half a second."""
    particle = Particle(acceleration=Vector3(6) * Particle(mass=mass).inverse_mass)
    particle.kick(0.5)
    return particle.velocity.x


heavy = Particle()
heavy.inverse_mass = 0.1
facts.says("1.5 0.75 10", pushed(2), pushed(4), heavy.mass)

facts.section("Momentum: what stays", "50 1.6")
facts.says("80", Particle(velocity=Vector3(1.6), mass=50).momentum().x)

facts.section("Damping: slowing down at any frame rate", "99 0.99 60 120 0.25 15")


def damped(steps: int) -> float:
    velocity = Vector3(1)
    for _ in range(steps):
        velocity = damp_per_frame(velocity, Vector3(), 0.99, 1 / 60)
    return velocity.x


puck = Particle(velocity=Vector3(1), damping=0.25)
puck.kick(0.5)
facts.says("0.547 0.299 0.5", damped(60), damped(120), puck.velocity.x)

facts.section("The step", "0.5 60")
ball = Particle(velocity=Vector3(0, 20), acceleration=Vector3(0, -10))
heights, speeds = [], []
for _ in range(4):
    ball.integrate(0.5)
    heights.append(ball.position.y)
    speeds.append(ball.velocity.y)
facts.says("10 17.5 22.5 25", *heights)
facts.says("15 10 5", *speeds[:3])
facts.says("1.5 20", 3 * 0.5, 20 * 2 - 10 * 2**2 / 2)  # by the school formula

facts.section(
    "Three short exercises about forces", "6.67428e-11 100 9.81 6 0.5 60 15 20 5.972e24 6,371"
)
attraction = gravity_between(100, 100, 1)
grain = attraction / 9.81 / 2650  # m^3 of quartz, of 2,650 kg/m^3
facts.says("6.67e-7 0.4", attraction, 1000 * (6 * grain / math.pi) ** (1 / 3))  # N and mm
slow, fast = (Particle(velocity=Vector3(speed), mass=2) for speed in (3, 6))
facts.says("9 36", slow.kinetic_energy(), fast.kinetic_energy())
earth, radius = 5.972e24, 6371e3  # kg and m
facts.says("9.8", gravity_between(earth, 1, radius))
facts.says("32", radius * (1 / math.sqrt(0.99) - 1) / 1000)  # km
# How uncertain the accelerations of the filmed ball are, and whether the film agrees.
times, positions = thrown_ball()
rounding = 1 / math.sqrt(12)  # mm, the standard deviation of an error that is up to 0.5 mm
single = math.sqrt(6) * rounding / 1000 * BALL_RATE**2  # 1, -2 and 1 times an error
duration = times[-1] - 1 / BALL_RATE  # between the middles of the first and the last interval
facts.says("0.29 0.71 2.5 0.025", rounding, math.sqrt(6) * rounding, single, single / 100)
facts.says("0.035", 2 * rounding / 1000 * BALL_RATE / duration)  # four positions count the same
for every, expected in ((1, single), (10, single / 100)):
    film = difference_quotients(times[::every], positions[::every])
    squares = [(a.y + 9.81) ** 2 for a in difference_quotients(*film)[1]]
    assert 0.5 < math.sqrt(sum(squares) / len(squares)) / expected < 1.1

facts.section("How wrong is a step?", "10 0.5 60 120 9.81 0.01")


def error(acceleration: float, rate: float, steps: int) -> float:
    start = Vector3(), Vector3(), Vector3(acceleration)
    return stepping_error(*start, 1 / rate, steps).x


p, v, a = Vector3(2, 5, -1), Vector3(1, -1, 2), Vector3(-2, 1, 0.5)
facts.says("1.4 5", 1000 * error(9.81, 60, 1), stepping_error(p, v, a, 1, 5).x)  # mm and m
facts.says("0.167 0.083", error(10, 60, 120), error(10, 120, 240))
facts.says("0.00102 981", 0.01 / 9.81, 9.81 / 0.01)  # an error of 9.81 * 2 * h / 2 = 0.01 m

facts.section("Frames that do not arrive on time", "10 60 50 99 0.5")
runs = [random_frames(1 / 60, 0.5, 1, seed) for seed in range(100)]
facts.says("57 65", min(map(len, runs)), max(map(len, runs)))
facts.says("0.088", damping_difference(Vector3(10), Vector3(), 0.5, runs))
facts.says("5", damp_per_second(Vector3(10), Vector3(), 0.5, 1).x)

facts.section("Summary", "10 20 25 60")


def gained(seconds: float, rate: float) -> float:
    """Return the energy in J that steps under 10 m/s^2 add to a thrown ball of 1 kg."""
    ball = Particle(velocity=Vector3(0, 20), acceleration=Vector3(0, -10))
    for _ in range(round(seconds * rate)):
        ball.integrate(1 / rate)
    return ball.kinetic_energy() + 10 * ball.position.y - 200


facts.says("200 250", Particle(velocity=Vector3(0, 20)).kinetic_energy(), 200 + gained(2, 2))
facts.says("12.5 0.83", gained(0.5, 2), gained(1, 60))
