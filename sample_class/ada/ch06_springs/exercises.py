"""Ada measures how stiff a spring may be."""

import math

from ch02_vectors.arguments import not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring

START = 10.0
FRAMES = 2000
STIFFEST = 16.0
SOFTEST = 1e-7


def swings_wider(integrator, stiffness, damping, duration):
    not_negative("damping", damping)
    positive("duration", duration)
    particle = Particle(Vector3(START, 0, 0), mass=1, damping=damping)
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), stiffness, 0))

    # Two things tell: how far it gets, and the area between one state (x, v) and the next.
    # Every step multiplies the area by the same number. Distances alone can deceive, if a swing
    # takes nearly 4 frames: then the frames only find the turning point from time to time.
    far, areas = [], []
    x, v = START, 0.0
    for _ in range(FRAMES):
        integrator([particle], registry.update_forces, duration)
        old_x, old_v = x, v
        x, v = particle.position.x, particle.velocity.x
        if not abs(x) < 1e6 * START:
            return True
        if abs(x) < 1e-9 and abs(v) < 1e-9:
            return False  # it has come to rest
        far.append(abs(x))
        areas.append(abs(old_x * v - x * old_v))

    second = slice(FRAMES // 4, FRAMES // 2)
    last = slice(FRAMES * 3 // 4, FRAMES)
    if max(far[last]) > 2 * max(far[second]):
        return True
    return max(areas[last]) > 1.000001 * max(areas[second])


def largest_stable_stiffness(integrator, damping, duration):
    not_negative("damping", damping)
    h = positive("duration", duration)
    low, high = SOFTEST / h**2, STIFFEST / h**2
    if swings_wider(integrator, low, damping, h):
        return 0.0
    if not swings_wider(integrator, high, damping, h):
        return high
    while high > 1.01 * low:  # so the middle is 0.5 % off at most
        middle = math.sqrt(low * high)
        if swings_wider(integrator, middle, damping, h):
            high = middle
        else:
            low = middle
    return math.sqrt(low * high)
