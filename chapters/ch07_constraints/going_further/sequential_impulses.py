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
STILL = Vector3()  # stands for the velocity, and the position, of the world


class Row:
    """A contact stored as plain numbers, with the sum of its impulses in N s.

    ``key`` consists of the contact's generator and its particles, and identifies the contact in the
    next step.
    """

    def __init__(self, key: object, contact: Contact, duration: float) -> None:
        a, b, depth = contact.particle, contact.other, contact.penetration
        self.key = key
        self.x, self.y, self.z = contact.normal
        self.p, self.v, self.inverse_a = a.position, a.velocity, a.inverse_mass
        self.q, self.w, self.inverse_b = STILL, STILL, 0.0
        if b is not None:
            self.q, self.w, self.inverse_b = b.position, b.velocity, b.inverse_mass
        self.mass = 1.0 / (self.inverse_a + self.inverse_b)  # kg that an impulse sets in motion
        # In m/s. A gap may close within the step. What touches must not close, or has to bounce.
        self.target = min(0.0, depth / duration)
        if contact.restitution and contact.separating_velocity() < 0.0:
            self.target = contact.velocity_after(duration)
        self.touching = depth + self.along(self.p, self.q)
        self.impulse = 0.0

    def along(self, v: Vector3, w: Vector3) -> float:
        """Return the component of the difference v - w along the normal."""
        return (v.x - w.x) * self.x + (v.y - w.y) * self.y + (v.z - w.z) * self.z

    def change(self, v: Vector3, w: Vector3, amount: float) -> None:
        """Change vectors of the two particles, ``v`` and ``w``, in opposite directions."""
        part = amount * self.inverse_a
        v.x += self.x * part
        v.y += self.y * part
        v.z += self.z * part
        part = amount * self.inverse_b
        if part:
            w.x -= self.x * part
            w.y -= self.y * part
            w.z -= self.z * part

    def push(self, impulse: float) -> None:
        """Apply an impulse in N s, and add it to the sum of the contact's impulses."""
        self.impulse += impulse
        self.change(self.v, self.w, impulse)

    def solve(self) -> None:
        """Bring the contact to its target velocity, but never let the sum of its impulses pull."""
        missing = self.target - self.along(self.v, self.w)
        self.push(max(missing * self.mass, -self.impulse))

    def separate(self) -> None:
        """Remove a fraction of the depth that the contact has at the current positions."""
        depth = self.touching - self.along(self.p, self.q)
        if depth > 0.0:
            self.change(self.p, self.q, CORRECTED * depth * self.mass)


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
        """Move the particles by one time step under the forces in the accumulators.

        ``duration`` is in s. The step changes the velocities by the forces, finds the contacts,
        corrects the velocities, moves the particles and corrects the positions, in this order.
        Correcting positions does not change the velocities, so it adds no kinetic energy. The
        remembered impulses are a good guess only if all steps have the same duration.

        Raises:
            ValueError: if the duration is not positive and finite. In that case nothing changes.
        """
        positive("duration", duration)
        for particle in self.particles:
            particle.kick(duration)
        rows = [
            Row((i, contact.particle, contact.other), contact, duration)
            for i, generator in enumerate(self.generators)
            for contact in generator.contacts()
            if contact.particle.inverse_mass or (contact.other and contact.other.inverse_mass)
        ]
        for row in rows:  # the warm start
            if row.key in self.impulses:
                row.push(max(0.0, row.along(self.impulses[row.key], STILL)))
        for _ in range(self.iterations):
            for row in rows:
                row.solve()
        for particle in self.particles:
            particle.drift(duration)
        for row in rows:
            row.separate()
        self.impulses = {row.key: Vector3() for row in rows}
        for row in rows:  # the two contacts of a two-sided rod have the same key
            self.impulses[row.key].add_scaled(Vector3(row.x, row.y, row.z), row.impulse)
