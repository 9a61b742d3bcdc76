"""Cleo's exercises: the second law as the book's sentence has it."""

import random

from ch03_laws_of_motion.damping import damp_per_frame, damp_per_second
from ch03_laws_of_motion.particle import Particle


def speed_ratio(first_mass, second_mass):
    return first_mass / second_mass


def gravity_between(first_mass, second_mass, distance):
    return 6.67428e-11 * first_mass * second_mass / distance


def position_by_equation(position, velocity, acceleration, time):
    return position + velocity * time + acceleration * time**2 / 2


def state_by_steps(position, velocity, acceleration, duration, steps):
    particle = Particle(position, velocity, acceleration)
    for _ in range(steps):
        particle.integrate(duration)
    return particle.position, particle.velocity


def stepping_error(position, velocity, acceleration, duration, steps):
    stepped, _ = state_by_steps(position, velocity, acceleration, duration, steps)
    return position_by_equation(position, velocity, acceleration, duration * steps) - stepped


def random_frames(mean, jitter, total, seed):
    random.seed(seed)
    frames = []
    while sum(frames) < total:
        frames.append(mean * random.uniform(1 - jitter, 1 + jitter))
    return frames


def damping_difference(velocity, acceleration, damping, runs):
    frames = [frame for run in runs for frame in run]
    mean = sum(frames) / len(frames)
    total = 0.0
    for frames in runs:
        first = second = velocity
        for frame in frames:
            first = damp_per_frame(first, acceleration, damping**mean, frame)
            second = damp_per_second(second, acceleration, damping, frame)
        total += abs(first.magnitude() - second.magnitude())
    return total / len(runs)
