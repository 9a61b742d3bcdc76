"""Ada's slow bullets."""

from ch02_vectors.arguments import finite, not_negative, positive


def muzzle_energy(mass, speed):
    return 0.5 * positive("mass", mass) * not_negative("speed", speed) ** 2


def slowed_mass(mass, factor):
    return positive("mass", mass) * positive("factor", factor) * factor


def slowed_gravity(gravity, factor):
    return finite("gravity", gravity) / positive("factor", factor) / factor
