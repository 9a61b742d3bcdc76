"""Record the contacts that a resolver handles and their impulses, so that a scene can draw them."""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import Contact, ContactResolver
from lab.drawing.pen import Pen


class ContactView(ContactResolver):
    """A contact resolver that records its contacts and impulses, so that they can be drawn.

    It wraps the engine's own resolver, which does the actual work. Only the last step is recorded.
    """

    def __init__(self, resolver: ContactResolver) -> None:
        self.resolver = resolver
        self.iterations, self.iterations_used = resolver.iterations, 0
        self.impulses: list[tuple[Vector3, Vector3]] = []  # position, and impulse in N s
        self.pairs: list[tuple[Vector3, Vector3]] = []

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        """Resolve the contacts, and record how much the momentum of each particle changes."""
        listed = [*contacts]
        touched = {id(one): one for c in listed for one in (c.particle, c.other) if one is not None}
        before = {key: one.velocity.copy() for key, one in touched.items()}
        self.pairs = [
            (c.particle.position.copy(), c.other.position.copy())
            for c in listed
            if c.other is not None
        ]
        self.resolver.iterations = self.iterations
        self.resolver.resolve_contacts(listed, duration)
        self.iterations_used = self.resolver.iterations_used
        self.impulses = [
            (one.position.copy(), (one.velocity - before[key]) * one.mass)
            for key, one in touched.items()
            if one.has_finite_mass
        ]

    def forget(self) -> None:
        """Clear the contacts and impulses recorded in the last step.

        Call this before each step, because a step without contacts never calls the resolver.
        """
        self.impulses, self.pairs, self.iterations_used = [], [], 0

    def draw(self, pen: Pen, scale: float) -> None:
        """Draw recorded impulses as arrows, and contacts between two particles as dots.

        ``scale`` is the length in m of the arrow for an impulse of 1 N s.
        """
        for position, impulse in self.impulses:
            pen.arrow(position, impulse * scale, "pink", "contact")
        pen.dots([(0.5 * (a.x + b.x), 0.5 * (a.y + b.y)) for a, b in self.pairs], "pink", 5.0)
