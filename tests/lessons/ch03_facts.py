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


def pushed(mass: float) -> float:
    """Return the speed that 6 N give to a mass in half a second."""
    particle = Particle(acceleration=Vector3(6) * Particle(mass=mass).inverse_mass)
    particle.kick(0.5)
    return particle.velocity.x


def masses() -> dict[str, float]:
    particle = Particle()
    particle.inverse_mass = 0.1
    return {"1.5": pushed(2), "0.75": pushed(4), "10": particle.mass}


def skaters() -> dict[str, float]:
    momentum = Particle(velocity=Vector3(1.6), mass=50).momentum()
    return {"80": momentum.x}


def damped(steps: int) -> float:
    velocity = Vector3(1)
    for _ in range(steps):
        velocity = damp_per_frame(velocity, Vector3(), 0.99, 1 / 60)
    return velocity.x


def damping() -> dict[str, float]:
    puck = Particle(velocity=Vector3(1), damping=0.25)
    puck.kick(0.5)
    return {"0.547": damped(60), "0.299": damped(120), "0.5": puck.velocity.x}


def steps() -> dict[str, float]:
    ball = Particle(velocity=Vector3(0, 20), acceleration=Vector3(0, -10))
    heights, speeds = [], []
    for _ in range(4):
        ball.integrate(0.5)
        heights.append(ball.position.y)
        speeds.append(ball.velocity.y)
    assert heights[0] == 10
    return {
        "17.5": heights[1],
        "22.5": heights[2],
        "25": heights[3],
        "15": speeds[0],
        "10": speeds[1],
        "5": speeds[2],
        "1.5": 3 * 0.5,
        "20": 20 * 2 - 10 * 2**2 / 2,  # the school formula
    }


EARTH, RADIUS = 5.972e24, 6371e3  # kg and m
ROUNDING = 1 / math.sqrt(12)  # mm, the standard deviation of an error that is up to 0.5 mm


def errors_of(film: tuple[list[float], list[Vector3]]) -> float:
    """Return the root-mean-square error of the accelerations in a film under 9.81 m/s^2."""
    _, accelerations = difference_quotients(*difference_quotients(*film))
    return math.sqrt(sum((a.y + 9.81) ** 2 for a in accelerations) / len(accelerations))


def uncertainties() -> dict[str, float]:
    """Compute how uncertain the accelerations of the filmed ball are, and compare with the film."""
    times, positions = thrown_ball()
    single = math.sqrt(6) * ROUNDING / 1000 * BALL_RATE**2  # 1, -2 and 1 times an error
    longer = single / 100
    duration = times[-1] - 1 / BALL_RATE  # between the middles of the first and the last interval
    mean = 2 * ROUNDING / 1000 * BALL_RATE / duration  # four positions of equal weight
    assert 0.7 < errors_of((times, positions)) / single < 1.1
    assert 0.5 < errors_of((times[::10], positions[::10])) / longer < 1.1
    return {"0.29": ROUNDING, "0.71": math.sqrt(6) * ROUNDING, "2.5": single} | {
        "0.035": mean,
        "0.025": longer,
    }


def forces() -> dict[str, float]:
    grain = gravity_between(100, 100, 1) / 9.81 / 2650  # m^3 of quartz, of 2,650 kg/m^3
    slow, fast = (Particle(velocity=Vector3(speed), mass=2) for speed in (3, 6))
    return {
        "6.67e-7": gravity_between(100, 100, 1),
        "0.4": 1000 * (6 * grain / math.pi) ** (1 / 3),  # mm
        "9": slow.kinetic_energy(),
        "36": fast.kinetic_energy(),
        "9.8": gravity_between(EARTH, 1, RADIUS),
        "32": RADIUS * (1 / math.sqrt(0.99) - 1) / 1000,  # km
    } | uncertainties()


def uneven() -> dict[str, float]:
    runs = [random_frames(1 / 60, 0.5, 1, seed) for seed in range(100)]
    counts = [len(frames) for frames in runs]
    start = Vector3(10)
    equal = [[1 / 60] * 60]
    assert damping_difference(start, Vector3(), 0.5, equal) < 1e-12
    return {
        "57": min(counts),
        "65": max(counts),
        "0.088": damping_difference(start, Vector3(), 0.5, runs),
        "5": damp_per_second(start, Vector3(), 0.5, 1).x,
    }


def error(acceleration: float, rate: float, steps: int) -> float:
    start = Vector3(), Vector3(), Vector3(acceleration)
    return stepping_error(*start, 1 / rate, steps).x


def errors() -> dict[str, float]:
    p, v, a = Vector3(2, 5, -1), Vector3(1, -1, 2), Vector3(-2, 1, 0.5)
    rate = 9.81 / 0.01  # steps per second for an error of 9.81 * 2 * h / 2 = 0.01 m
    return {
        "1.4": 1000 * error(9.81, 60, 1),  # mm
        "5": stepping_error(p, v, a, 1, 5).x,
        "0.167": error(10, 60, 120),
        "0.083": error(10, 120, 240),
        "0.00102": 1 / rate,
        "981": rate,
    }


def gained(seconds: float, rate: float) -> float:
    """Return the energy in J that steps under 10 m/s^2 add to a thrown ball of 1 kg."""
    ball = Particle(velocity=Vector3(0, 20), acceleration=Vector3(0, -10))
    start = ball.kinetic_energy()
    for _ in range(round(seconds * rate)):
        ball.integrate(1 / rate)
    return ball.kinetic_energy() + 10 * ball.position.y - start


def growth() -> dict[str, float]:
    start = Particle(velocity=Vector3(0, 20)).kinetic_energy()
    assert gained(2, 2) == 4 * gained(0.5, 2)  # the same in every step
    return {
        "200": start,
        "250": start + gained(2, 2),
        "12.5": gained(0.5, 2),
        "0.83": gained(1, 60),
    }


SECTIONS = {
    "A game that never sees the whole motion": ("60", dict),
    "Mass: how hard it is to change a velocity": ("6 0.1 0.5 0.25", masses),
    "Momentum: what stays": ("50 1.6", skaters),
    "Damping: slowing down at any frame rate": ("99 0.99 60 120 0.25 15", damping),
    "The step": ("0.5 60", steps),
    "Three short exercises about forces": (
        "6.67428e-11 100 9.81 6 0.5 60 15 20 5.972e24 6,371",
        forces,
    ),
    "How wrong is a step?": ("10 0.5 60 120 9.81 0.01", errors),
    "Frames that do not arrive on time": ("10 60 50 99 0.5", uneven),
    "Summary": ("10 20 25 60", growth),
}
