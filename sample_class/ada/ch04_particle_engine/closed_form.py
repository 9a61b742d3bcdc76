"""Ada's closed form."""

import math

from ch02_vectors.arguments import finite, not_negative


def drag_factors(damping, time):
    not_negative("damping", damping)
    not_negative("time", time)
    if time == 0:
        return 1.0, 0.0, 0.0
    if damping == 0:
        return 0.0, 0.0, 0.0
    k = -math.log(damping)
    kt = k * time
    if abs(kt) < 0.01:
        gone = time * (1 - kt / 2 * (1 - kt / 3 * (1 - kt / 4 * (1 - kt / 5))))
        half = time * time / 2
        fallen = half * (1 - kt / 3 * (1 - kt / 4 * (1 - kt / 5 * (1 - kt / 6))))
    else:
        gone = -math.expm1(-kt) / k
        fallen = (time - gone) / k
    return math.exp(-kt), gone, fallen


def state_after(particle, time):
    kept, gone, fallen = drag_factors(particle.damping, time)
    if not particle.has_finite_mass:
        kept, gone, fallen = 1.0, 0.0, 0.0
    v, a = particle.velocity, particle.acceleration
    position = particle.position + v * gone + a * fallen
    return position, v * kept + a * gone


def burst_positions(start, speeds, acceleration, damping, time):
    _, gone, fallen = drag_factors(damping, time)
    middle = finite("start", start) + finite("acceleration", acceleration) * fallen
    return [middle + speed * gone for speed in speeds]
