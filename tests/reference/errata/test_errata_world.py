"""E-27 in whole scenes: the author's source code on the platform and the bridge.

The source code stores the move of a contact in the contact, which is an element of an array that
every frame fills again. If a contact without depth is resolved, nothing moves. The old move that is
still stored is then subtracted from the depths of the neighboring contacts once more.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import pytest

from ch02_vectors.vector import Vector3
from ch06_springs.integrators import explicit_euler
from ch07_constraints.contacts import Contact
from ch07_constraints.links import Rod
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.tilting_platform import TiltingPlatform

FRAME = 1.0 / 60.0


def place(contact: Contact) -> float:
    """Return depth + (pa - pb) . n, which no move changes if depths are kept up to date."""
    apart = contact.particle.position
    if contact.other is not None:
        apart = apart - contact.other.position
    return contact.penetration + apart.dot(contact.normal)


class SourceResolver:
    """The author's resolver, in one phase. ``wrong`` is the largest error of a depth in m."""

    def __init__(self, clears: bool) -> None:
        self.clears, self.wrong = clears, 0.0
        self.moves: dict[int, tuple[Vector3, Vector3]] = {}  # by index in the array

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        array = [*contacts]
        kept = [place(contact) for contact in array]
        for _ in range(2 * len(array)):
            worst, lowest = -1, math.inf
            for i, contact in enumerate(array):
                closing = contact.separating_velocity()
                if closing < lowest and (closing < 0.0 or contact.penetration > 0.0):
                    worst, lowest = i, closing
            if worst < 0:
                break
            self.resolve(array, worst, duration)
        wrong = [abs(place(c) - before) for c, before in zip(array, kept, strict=True)]
        self.wrong = max(self.wrong, *wrong)

    def resolve(self, array: list[Contact], worst: int, duration: float) -> None:
        contact = array[worst]
        depth = contact.penetration
        contact.resolve_velocity(duration)
        moves = contact.resolve_penetration()
        contact.penetration = depth  # the loop below subtracts the move from this depth as well
        if depth <= 0.0 and not self.clears:
            moves = self.moves.get(worst, moves)
        self.moves[worst] = moves
        for other in array:
            for particle, move in zip((contact.particle, contact.other), moves, strict=True):
                if other.particle is particle:
                    other.penetration -= move.dot(other.normal)
                elif particle is not None and other.other is particle:
                    other.penetration += move.dot(other.normal)


@pytest.mark.parametrize("scene", ["platform", "bridge"])
def test_e27_moves_that_are_not_cleared_make_depths_wrong(scene: str) -> None:
    """Run 5 s of the book's step with one-sided rods. If cleared, errors are roundings of 5 m.

    If moves are not cleared, the depths drift by up to 31 and 15 mm (measured).
    """
    ends = []
    for clears in (True, False):
        thing = TiltingPlatform() if scene == "platform" else Bridge()
        world, resolver = thing.world, SourceResolver(clears)
        world.integrator = explicit_euler
        world.resolver = resolver  # type: ignore[assignment]
        if isinstance(thing, TiltingPlatform):
            rods = [Rod(rod.a, rod.b, rod.length) for rod in thing.rods]
            world.contact_generators[:] = [*rods, world.contact_generators[-1]]
        for _ in range(300):
            thing.step(FRAME)
        ends.append([x for particle in world.particles for x in particle.position])
        if clears:
            assert resolver.wrong < 1e-12
        else:
            assert resolver.wrong > 1e-3
    assert max(abs(a - b) for a, b in zip(*ends, strict=True)) > 1e-3
