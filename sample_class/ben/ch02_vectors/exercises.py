"""Ben's exercises: the first and the last."""


def split(v):
    return v.magnitude(), v.normalized()


def position_after(position, velocity, duration):
    return position + velocity * duration
