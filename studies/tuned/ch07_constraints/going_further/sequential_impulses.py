"""Going further: sequential impulses with warm starting, as in Box2D.

ContactResolver moves the particles first, and then corrects the overlaps that result. This solver
corrects the velocities first, so that the particles overlap very little after they have moved. It
visits all contacts in order, several times, and applies an impulse at each visit. Two ideas
make the solver accurate (Catto, "Iterative Dynamics with Temporal Coherence", 2005):

- A contact must never pull, but this applies only to the sum of its impulses. A single impulse may
  pull, so a later visit can take back part of an earlier impulse that was too large.
- Warm starting: the sums of the last step are the first guess for this step. In a stack at rest
  they are already right, no matter how tall the stack is, so a few visits per step are enough.
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
        return (v.x - w.x) * self.x + (v.y - w.y) * self.y + (v.z - w.z) * self.z

    def change(self, v: Vector3, w: Vector3, amount: float) -> None:
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
        self.impulse += impulse
        self.change(self.v, self.w, impulse)

    def solve(self) -> None:
        missing = self.target - self.along(self.v, self.w)
        self.push(max(missing * self.mass, -self.impulse))

    def separate(self) -> None:
        depth = self.touching - self.along(self.p, self.q)
        if depth > 0.0:
            self.change(self.p, self.q, CORRECTED * depth * self.mass)


class SequentialImpulses:
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
