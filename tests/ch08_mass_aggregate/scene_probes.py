"""Bridges, platforms, blobs, wheels and games, told as numbers, for the checks.

The autograder runs it beside the student, so nothing in here is secret, and nothing decides.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.detectors import GroundPlane
from ch08_mass_aggregate import ball_game, blob
from ch08_mass_aggregate.probes import Components, xyz

Told = tuple[int, int, Components, float, float]


def told(contacts: Any, particles: Sequence[Particle]) -> list[Told]:
    """Return of each contact: particle and other by number, normal, restitution, penetration.

    The number of what is not there is -1, that of a stranger -2.
    """
    found = []
    for contact in contacts:
        a, b = number_of(contact.particle, particles), number_of(contact.other, particles)
        found.append((a, b, xyz(contact.normal), contact.restitution, contact.penetration))
    return found


def number_of(particle: Any, particles: Sequence[Particle]) -> int:
    if particle is None:
        return -1
    return next((i for i, other in enumerate(particles) if other is particle), -2)


def rods(made: Any, particles: Sequence[Particle]) -> list[tuple[int, int, float]]:
    """Return of each rod the numbers of its ends, the lower first, and its length."""
    found = []
    for rod in made:
        i, j = sorted((number_of(rod.a, particles), number_of(rod.b, particles)))
        found.append((i, j, rod.length))
    return found


def settled_blob(frames: int, duration: float) -> tuple[list[Components], list[Components]]:
    """Let a blob's bonds hold its particles over the ground, by chapters 6 and 7 alone.

    Return where they were, and where they are.
    """
    made = [Particle(Vector3(0.0, 0.6), acceleration=blob.GRAVITY, mass=blob.MASS, damping=0.3)]
    for i in range(6):
        angle = math.tau * i / 6.0
        place = made[0].position + Vector3(math.cos(angle), math.sin(angle)) * blob.RADIUS
        made.append(Particle(place, acceleration=blob.GRAVITY, mass=blob.MASS, damping=0.3))
    bonds = []
    for i, a in enumerate(made):
        for b in made[:i]:
            rest = (b.position - a.position).magnitude()
            bonds.append(blob.Bond(a, b, blob.STIFFNESS, rest, 1.2 * rest, 0.25, 2.0 * rest))
    ground = GroundPlane(made)
    before = [xyz(particle.position) for particle in made]

    def apply_forces(time: float) -> None:
        for bond in bonds:
            bond.update_force(bond.a, time)
            bond.update_force(bond.b, time)

    for _ in range(frames):
        semi_implicit_euler(made, apply_forces, duration)
        for contact in ground.contacts():
            contact.resolve(duration)
    return before, [xyz(particle.position) for particle in made]


def played(
    frames: int,
    duration: float,
    direction: int,
    place: Components,
    velocity: Components,
    lives: int = 3,
    visited: Sequence[int] = (),
    mass: float = 1.0,
) -> list[dict[str, Any]]:
    """Play a game from a place of the ball; return what there is after each frame."""
    game = ball_game.BallGame()
    game.ball.mass = mass
    game.direction = direction
    game.rules.lives = lives
    game.rules.visited = set(visited)
    game.ball.position, game.ball.velocity = Vector3(*place), Vector3(*velocity)
    seen = []
    for _ in range(frames):
        game.step(duration)
        seen.append(
            {
                "place": xyz(game.ball.position),
                "velocity": xyz(game.ball.velocity),
                "score": game.rules.score,
                "lives": game.rules.lives,
                "visited": sorted(game.rules.visited),
            }
        )
    return seen
