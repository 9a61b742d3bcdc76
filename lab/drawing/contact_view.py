"""Record the contacts that a resolver handles and their impulses, so that a scene can draw them."""

from __future__ import annotations

from collections.abc import Iterable

from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import Contact, ContactResolver
from lab.drawing.pen import Pen


class ContactView(ContactResolver):
    """Wraps the engine's own resolver, and records the contacts and impulses of the last step."""

    def __init__(self, resolver: ContactResolver) -> None:
        self.resolver, self.iterations = resolver, resolver.iterations
        self.forget()

    def forget(self) -> None:
        """Clear the record before a step, because one without contacts never calls the resolver."""
        self.impulses: list[tuple[Vector3, Vector3]] = []  # position, and impulse in N s
        self.middles: list[tuple[float, float]] = []  # of two particles in contact
        self.iterations_used = 0

    def resolve_contacts(self, contacts: Iterable[Contact], duration: float) -> None:
        """Resolve the contacts, and record how much the momentum of each particle changes."""
        listed = [*contacts]
        touched = {id(one): one for c in listed for one in (c.particle, c.other) if one is not None}
        before = {key: one.velocity.copy() for key, one in touched.items()}
        pairs = [(c.particle.position, c.other.position) for c in listed if c.other is not None]
        self.middles = [(0.5 * (a.x + b.x), 0.5 * (a.y + b.y)) for a, b in pairs]
        self.resolver.iterations = self.iterations
        self.resolver.resolve_contacts(listed, duration)
        self.iterations_used = self.resolver.iterations_used
        self.impulses = [
            (one.position.copy(), (one.velocity - before[key]) * one.mass)
            for key, one in touched.items()
            if one.has_finite_mass
        ]

    def draw(self, pen: Pen, scale: float) -> None:
        """Draw impulses as arrows of ``scale`` m per N s, and contacts of two particles as dots."""
        for position, impulse in self.impulses:
            pen.arrow(position, impulse * scale, "pink", "contact")
        pen.dots(self.middles, "pink", 5.0)
