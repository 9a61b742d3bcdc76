"""Cleo's slow bullets, by the book's text."""


def muzzle_energy(mass, speed):
    return mass * speed**2


def slowed_mass(mass, factor):
    return mass * factor**2


def slowed_gravity(gravity, factor):
    return gravity / factor
