"""Ada's two equations."""

from ch02_vectors.arguments import not_negative, positive


def damp_per_frame(velocity, acceleration, damping, duration):
    kept = not_negative("damping", damping)
    return velocity * kept + acceleration * positive("duration", duration)


def damp_per_second(velocity, acceleration, damping, duration):
    kept = not_negative("damping", damping) ** positive("duration", duration)
    return velocity * kept + acceleration * duration
