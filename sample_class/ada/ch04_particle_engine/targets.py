"""Ada's targets."""

from ch02_vectors.arguments import positive
from ch03_laws_of_motion.particle import Particle


class TargetBlock:
    def __init__(self, position, size, mass, damping=0.2):
        self.particle = Particle(position, mass=mass, damping=damping)
        self.size = tuple(positive("size", side) for side in size)
        self.hits = 0


def hit_fraction(start, end, block):
    first, last = 0.0, 1.0
    for axis, size in zip("xyz", block.size):
        a, b = getattr(start, axis), getattr(end, axis)
        middle = getattr(block.particle.position, axis)
        low, high = middle - size / 2, middle + size / 2
        if a == b:
            if not low <= a <= high:
                return None
        else:
            enter, leave = sorted([(low - a) / (b - a), (high - a) / (b - a)])
            first, last = max(first, enter), min(last, leave)
    return first if first <= last else None


def strike_first(start, particle, targets):
    touched = []
    for target in targets:
        fraction = hit_fraction(start, particle.position, target)
        if fraction is not None:
            touched.append((fraction, target))
    if not touched:
        return None
    target = min(touched, key=lambda pair: pair[0])[1]
    share = particle.mass * target.particle.inverse_mass
    target.particle.velocity.x += particle.velocity.x * share
    target.particle.velocity.z += particle.velocity.z * share
    target.hits += 1
    return target
