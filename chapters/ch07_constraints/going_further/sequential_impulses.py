"""Going further: sequential impulses with warm starting, as in Box2D.

ContactResolver moves the particles first, and then corrects the overlaps that result. This solver
corrects the velocities first, so that the particles overlap very little after they have moved. It
visits all contacts in order, several times, and applies an impulse at each visit. Two ideas
make the solver accurate (Catto, "Iterative Dynamics with Temporal Coherence", 2005):

- A contact must never pull, but this applies only to the sum of its impulses. A single impulse may
  pull, so a later visit can take back part of an earlier impulse that was too large.
- Warm starting: the sums of the last step are the first guess for this step. In a stack at rest
  they are already right, no matter how tall the stack is, so a few visits per step are enough.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.arguments import positive, whole
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, ContactGenerator

CORRECTED = 0.5  # the fraction of its depth that a contact loses in a step


class Row:
    """A contact of this step, with the sum of its impulses in N s.

    ``key`` consists of the contact's generator and its particles, and identifies the contact in the
    next step.
    """

    def __init__(self, key: object, contact: Contact, duration: float) -> None:
        self.key, self.contact = key, contact
        self.impulse = 0.0
        self.start = offset(contact)
        # In m/s. A gap may close within the step. What touches must not close, or has to bounce.
        self.target = min(0.0, contact.penetration / duration)
        if contact.restitution and contact.separating_velocity() < 0.0:
            self.target = contact.velocity_after(duration)

    def push(self, impulse: float) -> None:
        """Apply an impulse in N s, and add it to the sum of the contact's impulses."""
        self.impulse += impulse
        a, b, push = self.contact.particle, self.contact.other, self.contact.normal * impulse
        a.velocity += push * a.inverse_mass
        if b is not None:
            b.velocity -= push * b.inverse_mass

    def solve(self) -> None:
        """Bring the contact to its target velocity, but never let the sum of its impulses pull."""
        missing = self.target - self.contact.separating_velocity()
        self.push(max(missing / self.contact.total_inverse_mass(), -self.impulse))

    def separate(self) -> None:
        """Remove a fraction of the depth that the contact has at the current positions."""
        moved = (offset(self.contact) - self.start).dot(self.contact.normal)
        self.contact.penetration = CORRECTED * (self.contact.penetration - moved)
        self.contact.resolve_penetration()


def offset(contact: Contact) -> Vector3:
    """Return the position of ``particle`` as seen from ``other``, or from the origin."""
    other = Vector3() if contact.other is None else contact.other.position
    return contact.particle.position - other


class SequentialImpulses:
    """A solver that steps particles, and remembers the impulses at their contacts between steps.

    ``generators`` are contact generators of this chapter. Use TwoSidedRod instead of Rod, because a
    Rod of the right length has no contact and therefore no impulse to remember. ``iterations`` is
    the number of visits to each contact in a step.

    Raises:
        ValueError: if ``iterations`` is less than 1.
        TypeError: if ``iterations`` is not a whole number.
    """

    def __init__(
        self,
        particles: Iterable[Particle],
        generators: Iterable[ContactGenerator],
        iterations: int = 4,
    ) -> None:
        self.particles = [*particles]
        self.generators = [*generators]
        self.iterations = whole("iterations", iterations)
        self.impulses: dict[object, Vector3] = {}  # N s, of the last step, by key

    def step(self, duration: float) -> None:
        """Move the particles by one step of ``duration`` s under the forces in the accumulators.

        The step changes the velocities by the forces, finds the contacts, corrects the velocities,
        moves the particles and corrects the positions, in this order. Correcting positions does not
        change the velocities, so it adds no kinetic energy. The remembered impulses are a good
        guess only if all steps have the same duration.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        for particle in self.particles:
            particle.kick(duration)
        rows = self._rows(duration)
        for row in rows:  # the warm start
            remembered = self.impulses.get(row.key, Vector3())
            row.push(max(0.0, remembered.dot(row.contact.normal)))
        for _ in range(self.iterations):
            for row in rows:
                row.solve()
        for particle in self.particles:
            particle.drift(duration)
        for row in rows:
            row.separate()
        self.impulses = {row.key: Vector3() for row in rows}
        for row in rows:  # the two contacts of a two-sided rod have the same key
            self.impulses[row.key] += row.contact.normal * row.impulse

    def _rows(self, duration: float) -> list[Row]:
        """Find all contacts in which a particle can move."""
        return [
            Row((i, contact.particle, contact.other), contact, duration)
            for i, generator in enumerate(self.generators)
            for contact in generator.contacts()
            if contact.total_inverse_mass()
        ]
