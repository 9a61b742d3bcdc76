"""Cleo's two equations, without a look at what comes in."""


def damp_per_frame(velocity, acceleration, damping, duration):
    return velocity * damping + acceleration * duration


def damp_per_second(velocity, acceleration, damping, duration):
    return velocity * damping**duration + acceleration * duration
