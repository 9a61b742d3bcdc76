"""Going further: find the positions at which a world is at rest, without stepping it.

At rest, all forces on a particle add up to zero. They are its weight, the forces of the registry,
and the pulls of the rods and cables that hold it. In addition, these rods and cables must have the
right lengths. Newton's method solves all these equations together. The search also finds out which
cables are taut, with an active set. A cable that would have to push becomes slack, and a cable that
would get too long becomes taut.

Far from rest, a step of Newton's method can be much too large. So the particles get some inertia,
as in a step of backward Euler. They resist each move with a force of m / t^2 N per m. The time t
doubles from step to step, until the inertia has no effect any more.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from studies.models.elimination import Elimination
from studies.models.forces import take_forces
from studies.models.net import CABLE, CHANGES, LINKS, ROD, limits_of

FIRST_TIME, LAST_TIME = 0.05, 50.0  # s
FARTHEST = 0.25  # m: the longest move of a particle in one step of the method
SMALL = 1e-5  # m: the moves for the slope of a force
EXACT = 1e-11  # the fraction of the largest force, and of a length squared, that may be left
STEPS, SETS = 300, 500  # of Newton's method, and sets of taut cables in each
SOFT = 1e-13  # so that pulls have one solution where cables are redundant

Triple = tuple[float, float, float]
STILL = (0.0, 0.0, 0.0)


class Hold:
    """A link that pulls its ends ``a`` and ``b`` together, or a contact that pushes them apart."""

    def __init__(
        self, a: Particle, b: Any, length: float, kind: int, contact: Contact | None = None
    ) -> None:
        self.a, self.length, self.kind, self.contact = a, length, kind, contact
        self.b = b if isinstance(b, Particle) else None
        self.anchor = b
        self.pull = 0.0  # N per m of a link, or N of a contact
        self.last_pull = 0.0  # of the last step of the method
        self.is_active = kind == ROD or contact is not None
        # From a to b in m, and half of what its square is too much; or the normal, and the depth.
        self.direction: Triple = STILL
        self.excess = 0.0

    def look(self) -> None:
        """Update the direction and the excess length for the current positions."""
        if self.contact is None:
            end = self.b.position if self.b else self.anchor
            start = self.a.position
            self.direction = x, y, z = end.x - start.x, end.y - start.y, end.z - start.z
            self.excess = 0.5 * (x * x + y * y + z * z - self.length * self.length)

    def change(self, moves: Mapping[Any, Triple]) -> float:
        """Return the first-order change of the excess length if the ends are moved by ``moves``."""
        x, y, z = self.direction
        ax, ay, az = moves.get(self.a, STILL)
        bx, by, bz = moves.get(self.b, STILL)
        return x * (bx - ax) + y * (by - ay) + z * (bz - az)


class Balance:
    """The equations for a world at rest, and a step of Newton's method to solve them."""

    def __init__(self, world: ParticleWorld) -> None:
        self.world = world
        self.free = [p for p in world.particles if p.inverse_mass]
        self.by_hand = [take_forces(p) for p in self.free]
        self.number = {p: 3 * i for i, p in enumerate(self.free)}
        links = [g for g in world.contact_generators if isinstance(g, LINKS)]
        self.links = [Hold(*limit) for link in links for limit in limits_of(link)]
        self.others = [g for g in world.contact_generators if not isinstance(g, LINKS)]
        self.holds = self.links
        self.has_forces = bool(world.registry.pairs())
        self.shape: tuple[list[tuple[Any, Any]], list[tuple[int, int]]] | None = None

    def look(self) -> None:
        """Update the forces, links and contacts for the current positions of the particles."""
        self.forces = self.find_forces()
        for hold in self.links:
            hold.look()
        # A contact that was resolved exactly may not be reported any more, but it still holds.
        found = {(h.a, h.b): h for h in self.holds[len(self.links) :] if h.pull > 0.0}
        for contact in (c for g in self.others for c in g.contacts()):
            hold = Hold(contact.particle, contact.other, 1.0, CABLE, contact)
            before = found.get((hold.a, hold.b))
            hold.pull = before.pull if before else 0.0
            hold.direction, hold.excess = (*contact.normal,), contact.penetration
            found[hold.a, hold.b] = hold
        self.holds = [*self.links, *found.values()]

    def find_forces(self) -> list[float]:
        """Return the forces on the particles in one list, without those of links and contacts."""
        if self.has_forces:
            self.world.registry.update_forces(FIRST_TIME)
        found: list[float] = []
        for particle, by_hand in zip(self.free, self.by_hand, strict=True):
            weight = particle.acceleration * particle.mass
            parts = zip(weight, by_hand, take_forces(particle), strict=True)
            found += [sum(part) for part in parts]
        return found

    def is_balanced(self) -> bool:
        """Return True if all forces and pulls add up to zero, and all lengths are right."""
        left = [*self.forces]
        largest = max(map(abs, left), default=0.0)
        for hold in self.holds:
            if hold.excess * (hold.kind or 1) > EXACT * hold.length**2:
                return False
            if hold.is_active and hold.excess < -EXACT * hold.length**2:
                return False
            for end, sign in ((hold.a, hold.pull), (hold.b, -hold.pull)):
                if end in self.number:
                    for axis, part in enumerate(hold.direction, self.number[end]):
                        left[axis] += sign * part
                        largest = max(largest, abs(sign * part))
        return max(map(abs, left), default=0.0) <= EXACT * largest

    def move(self, time: float) -> bool:
        """Make one step of Newton's method. ``time`` in s sets the inertia of the particles.

        Return True if the particles made the full step, and False if it was shortened so that no
        particle moves more than FARTHEST.
        """
        slopes = self.find_slopes()
        for hold in self.holds:
            hold.last_pull = hold.pull
        for tried in range(SETS):
            moves = self.solve(time, slopes)
            wrong = [h for h in self.holds if h.kind and self.is_wrong(h, moves)]
            if not wrong:
                break
            for hold in wrong if tried < CHANGES else wrong[:1]:
                hold.is_active = not hold.is_active
        longest = max((sum(x * x for x in move) ** 0.5 for move in moves.values()), default=0.0)
        share = min(1.0, FARTHEST / longest) if longest else 1.0
        for hold in self.holds[len(self.links) :]:
            hold.excess += share * hold.change(moves)
        for particle, (x, y, z) in moves.items():
            position = particle.position
            position.x += share * x
            position.y += share * y
            position.z += share * z
        return share == 1.0

    @staticmethod
    def is_wrong(hold: Hold, moves: Mapping[Any, Triple]) -> bool:
        """Return True if a taut Hold would have to push, or a slack Hold would get too long."""
        if hold.is_active:
            return hold.pull * hold.kind < 0.0
        return (hold.excess + hold.change(moves)) * hold.kind > EXACT * hold.length**2

    def find_slopes(self) -> dict[tuple[int, int], float]:
        """Return the derivative of each component of a force with respect to each coordinate."""
        slopes: dict[tuple[int, int], float] = {}
        if not self.has_forces:
            return slopes
        for particle, first in self.number.items():
            for axis, name in enumerate("xyz"):
                place = getattr(particle.position, name)
                setattr(particle.position, name, place + SMALL)
                ahead = self.find_forces()
                setattr(particle.position, name, place - SMALL)
                behind = self.find_forces()
                setattr(particle.position, name, place)
                for i, (more, less) in enumerate(zip(ahead, behind, strict=True)):
                    if more != less:
                        slopes[i, first + axis] = (more - less) / (2.0 * SMALL)
        return slopes

    def solve(self, time: float, slopes: Mapping[tuple[int, int], float]) -> dict[Particle, Triple]:
        """Find the pulls of the active links and contacts, and return the moves in m.

        The unknowns are the moves, with three numbers for each particle, followed by the pulls.
        """
        count = len(self.forces)
        equations = self.equations(slopes)
        values = [0.0] * equations.size

        def add(i: int, j: int, value: float) -> None:
            values[equations.slot_of(i, j)] += value

        right = [*self.forces, *(0.0 for _ in self.holds)]
        for particle, first in self.number.items():
            for i in range(first, first + 3):
                add(i, i, particle.mass / time**2)
        for (i, j), slope in slopes.items():  # the mean of A[i][j] and A[j][i]
            add(i, j, -slope if i == j else -0.5 * slope)
        for row, hold in enumerate(self.holds, count):
            ends = [
                (self.number[e], s) for e, s in ((hold.a, -1.0), (hold.b, 1.0)) if e in self.number
            ]
            if not hold.is_active:
                values[row] = -1.0
                continue
            values[row] = -SOFT
            right[row] = -hold.excess - SOFT * hold.last_pull
            for first, sign in ends:
                for axis, part in enumerate(hold.direction):
                    add(first + axis, row, sign * part)
                    if hold.contact is None:  # a pull turns with its link
                        add(first + axis, first + axis, hold.last_pull)
            if len(ends) == 2 and hold.contact is None:
                for axis in range(3):
                    add(ends[0][0] + axis, ends[1][0] + axis, -hold.last_pull)
        equations.factor(values)
        found = equations.solve(values, right)
        for row, hold in enumerate(self.holds, count):
            hold.pull = found[row] if hold.is_active else 0.0
        return {p: (found[i], found[i + 1], found[i + 2]) for p, i in self.number.items()}

    def equations(self, slopes: Mapping[tuple[int, int], float]) -> Elimination:
        """Return a solver for the equations. Create a new one only if their structure changed."""
        shape = [(h.a, h.b) for h in self.holds], [*slopes]
        if self.shape != shape:
            count = len(self.forces)
            pairs = [*slopes]
            for row, hold in enumerate(self.holds, count):
                ends = [self.number[end] for end in (hold.a, hold.b) if end in self.number]
                pairs += [(first + axis, row) for first in ends for axis in range(3)]
                pairs += [
                    (a + axis, b + axis) for a, b in combinations(ends, 2) for axis in range(3)
                ]
            self.shape, self.analyzed = shape, Elimination(count + len(self.holds), pairs, count)
        return self.analyzed


def equilibrium(world: ParticleWorld) -> list[float]:
    """Move the particles of ``world`` to a position of rest, and return the tensions in N.

    The list has one tension for each rod and cable, in the order of the world's contact generators.
    A slack cable has a tension of 0, and a rod that pushes has a negative tension. If there are
    several equilibria, the result is usually one near the start.

    The velocities of all particles become 0. Forces in the accumulators act on the particles, and
    they also stay in the accumulators. Contacts with the ground or with other particles support the
    particles too, if the search finds these contacts. They have no friction.

    In a SleepingWorld all particles fall asleep at once, and sleep until something touches them.

    Raises:
        ArithmeticError: if no equilibrium is found, for example because nothing holds a particle.
    """
    balance = Balance(world)
    for particle in balance.free:
        particle.velocity.clear()
    time = FIRST_TIME
    balance.look()
    for _ in range(STEPS):
        if balance.move(time):
            time = min(2.0 * time, LAST_TIME)
        balance.look()
        if balance.is_balanced():
            break
    else:
        raise ArithmeticError("found no equilibrium; check that something holds every particle")
    if isinstance(world, SleepingWorld):
        fall_asleep(world, balance)
    for particle, by_hand in zip(balance.free, balance.by_hand, strict=True):
        if any(by_hand):
            particle.add_force(Vector3(*by_hand))
    return [hold.pull * hold.length for hold in balance.links]


def fall_asleep(world: SleepingWorld, balance: Balance) -> None:
    """Put the particles of ``world`` to sleep, as if they had been at rest for enough steps."""
    world.registry.update_forces(FIRST_TIME)
    for particle in balance.free:
        particle.kick(0.0)  # it now remembers the forces on it, which must not change
    up = Vector3(0.0, 1.0, 0.0)
    contacts = [h.contact or Contact(h.a, h.b, up, 0.0, 0.0) for h in balance.holds if h.is_active]
    for _ in range(world.sleep_frames):
        world.fall_asleep(contacts)
