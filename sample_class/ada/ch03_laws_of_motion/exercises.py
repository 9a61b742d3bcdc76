"""Ada's exercises."""

import random
import statistics

from ch02_vectors.arguments import finite, positive
from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second

G = 6.67428e-11


def speed_ratio(first_mass, second_mass):
    force = time = 1.0
    first = force / positive("first_mass", first_mass) * time
    second = force / positive("second_mass", second_mass) * time
    return first / second


def gravity_between(first_mass, second_mass, distance):
    for name, value in (("first_mass", first_mass), ("second_mass", second_mass)):
        positive(name, value)
    return G * first_mass * second_mass / positive("distance", distance) ** 2


def position_by_equation(position, velocity, acceleration, time):
    positive("time", time)
    return position + velocity * time + acceleration * (0.5 * time**2)


def state_by_steps(position, velocity, acceleration, duration, steps):
    positive("duration", duration)
    positive("steps", steps)
    for _ in range(steps):
        position = position + velocity * duration
        velocity = velocity + acceleration * duration
    return position, velocity


def stepping_error(position, velocity, acceleration, duration, steps):
    stepped, _ = state_by_steps(position, velocity, acceleration, duration, steps)
    return stepped - position_by_equation(position, velocity, acceleration, duration * steps)


def random_frames(mean, jitter, total, seed):
    positive("mean", mean)
    positive("total", total)
    if not 0 <= finite("jitter", jitter) < 1:
        raise ValueError(f"jitter must be below 1, got {jitter!r}")
    draw = random.Random(seed).uniform
    frames, full = [], 0.0
    while total - full > 1e-9 * total:
        frames.append(min(draw(mean - jitter * mean, mean + jitter * mean), total - full))
        full += frames[-1]
    return frames


def damping_difference(velocity, acceleration, damping, runs):
    distances = []
    for frames in runs:
        first = second = velocity
        for frame in frames:
            first = damp_per_frame(first, acceleration, damping, frame)
            second = damp_per_second(second, acceleration, damping, frame)
        distances.append((first - second).magnitude())
    return statistics.fmean(distances)
