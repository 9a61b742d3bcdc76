"""Move particles with an integrator of chapter 6, and resolve their contacts after each step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from ch05_forces.particle import Particle
from ch06_springs.integrators import ApplyForces, Integrator
from ch07_constraints.contacts import Contact, ContactGenerator, ContactResolver
from scenes.clock import Move

Resolve = Callable[[list[Contact], float], object]


def no_forces(duration: float) -> None:
    """Do nothing, because gravity is already included in the particles' own acceleration."""
    del duration


def resolving(
    step: Integrator,
    particles: Sequence[Particle],
    generators: Iterable[ContactGenerator],
    resolve: Resolve,
    apply_forces: ApplyForces = no_forces,
    substeps: int = 1,
) -> Move:
    """Return a function that moves particles and resolves contacts in ``substeps`` equal steps."""
    every = [*generators]

    def move(duration: float) -> None:
        part = duration / substeps
        for _ in range(substeps):
            step(particles, apply_forces, part)
            resolve([contact for some in every for contact in some.contacts()], part)

    return move


def by_resolver(iterations: int | None = None) -> Resolve:
    """Return a function that resolves contacts in ``iterations`` per contact, or 2 by default."""

    def resolve(contacts: list[Contact], duration: float) -> None:
        if contacts:
            limit = None if iterations is None else iterations * len(contacts)
            ContactResolver(limit).resolve_contacts(contacts, duration)

    return resolve
