"""Hana's exercises, which are right too."""

from random import Random

from ch02_vectors.arguments import finite, positive
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.particle import Particle


def speed_ratio(first_mass, second_mass):
    return positive("second_mass", second_mass) / positive("first_mass", first_mass)


def gravity_between(first_mass, second_mass, distance):
    positive("first_mass", first_mass)
    positive("second_mass", second_mass)
    positive("distance", distance)
    return 6.67428e-11 * first_mass * second_mass / distance / distance


def position_by_equation(position, velocity, acceleration, time):
    positive("time", time)
    return position + (velocity + acceleration * (time / 2)) * time


def state_by_steps(position, velocity, acceleration, duration, steps):
    positive("duration", duration)
    positive("steps", steps)
    particle = Particle(position, velocity, acceleration)
    for _ in range(steps):
        particle.integrate(duration)
    return particle.position, particle.velocity


def stepping_error(position, velocity, acceleration, duration, steps):
    exact = position_by_equation(position, velocity, acceleration, duration * steps)
    return state_by_steps(position, velocity, acceleration, duration, steps)[0] - exact


def random_frames(mean, jitter, total, seed):
    positive("mean", mean)
    positive("total", total)
    if not 0 <= finite("jitter", jitter) < 1:
        raise ValueError(f"jitter must be 0 or more and less than 1, got {jitter}")
    random = Random(seed)
    frames = [random.uniform(1 - jitter, 1 + jitter) * mean]
    while sum(frames) < total:
        frames.append(random.uniform(1 - jitter, 1 + jitter) * mean)
    rest = total - sum(frames[:-1])
    return [*frames[:-1], rest] if rest > 1e-9 * total else frames[:-1]


def damping_difference(velocity, acceleration, damping, runs):
    if not runs or not all(runs):
        raise ValueError("runs must not be empty")
    number = sum(len(frames) for frames in runs)
    mean = sum(positive("frame", frame) for frames in runs for frame in frames) / number
    if not finite("damping", damping) >= 0:
        raise ValueError("damping must not be negative")
    total = 0.0
    for frames in runs:
        first = second = velocity
        for frame in frames:
            first = damp_per_frame(first, acceleration, damping**mean, frame)
            second = damp_per_second(second, acceleration, damping, frame)
        total += (first - second).magnitude()
    return total / len(runs)
