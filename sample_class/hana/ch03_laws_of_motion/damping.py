"""Hana's two equations."""

from ch02_vectors.arguments import not_negative, positive


def damp_per_frame(velocity, acceleration, damping, duration):
    not_negative("damping", damping)
    positive("duration", duration)
    return damping * velocity + duration * acceleration


def damp_per_second(velocity, acceleration, damping, duration):
    not_negative("damping", damping)
    positive("duration", duration)
    return damping**duration * velocity + duration * acceleration
