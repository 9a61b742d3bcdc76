"""Time division by rewinding, which works with any forces (book 7.3.2).

This file is complete, so there is nothing to fill in. ``time_division_step`` computes the time of
an impact from a formula, which holds only for a constant acceleration. This module searches for the
time, as the book describes. It makes a whole step, and looks for bodies that touch and approach
each other. If there are any, it goes back to the start and finds the time of the first contact by
bisection. It steps to that time, resolves the contact, and continues from there.

Between impacts, the method is as accurate as its integrator. Each impact costs about 46 steps. If
two bodies meet and separate again within one step, the method does not notice it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ch02_vectors.arguments import positive, whole
from ch05_forces.particle import Particle
from ch07_constraints.contacts import VELOCITY_TOLERANCE, Contact, ContactGenerator
from ch07_constraints.time_division import TooManyImpacts

ApplyForces = Callable[[float], None]
Integrator = Callable[[Sequence[Particle], ApplyForces, float], None]  # as in chapter 6
HALVINGS = 44  # they narrow down the time of an impact to 6e-14 of the step


def rewinding_step(
    integrator: Integrator,
    particles: Sequence[Particle],
    apply_forces: ApplyForces,
    detector: ContactGenerator,
    duration: float,
    max_impacts: int = 100,
) -> int:
    """Move ``particles`` by one step, resolve each impact at its moment, and count the impacts.

    ``integrator`` is one of chapter 6, such as ``runge_kutta_4``, and ``apply_forces`` and the
    ``duration`` in s are its arguments. ``detector`` is anything with a ``contacts`` method, such
    as a GroundPlane or a Cable. Contacts with a negative penetration are ignored. Forces that were
    added by hand act during the whole step.

    Raises:
        ValueError: if the duration is not positive and finite, or ``max_impacts`` is less than 1.
        TypeError: if ``max_impacts`` is not a whole number. In these two cases nothing changes.
        TooManyImpacts: if there is another impact after ``max_impacts`` impacts, for example
            because a body has come to rest. The particles have then moved to that impact.
    """
    positive("duration", duration)
    whole("max_impacts", max_impacts)
    forces = [particle.force_accumulator for particle in particles]
    start = [(particle.position, particle.velocity) for particle in particles]

    def contact_after(time: float) -> Contact | None:
        """Go back to the start, step to ``time``, and return a contact that closes there."""
        for particle, (position, velocity), force in zip(particles, start, forces, strict=True):
            particle.position, particle.velocity = position.copy(), velocity.copy()
            particle.clear_forces()
            particle.add_force(force)
        integrator(particles, apply_forces, time)
        return _closing(detector)

    left, impacts = duration, 0
    while True:
        contact = _closing(detector)
        if contact is None:
            start = [(particle.position, particle.velocity) for particle in particles]
            if left <= 0.0 or (contact := contact_after(left)) is None:
                return impacts
            time, contact = _first_contact(contact_after, left, contact)
            contact_after(time)
            left -= time
        if impacts == max_impacts:
            raise TooManyImpacts(impacts, duration - left, contact)
        contact.resolve_velocity()
        impacts += 1


def _closing(detector: ContactGenerator) -> Contact | None:
    """Return the first contact of bodies that touch and approach each other, or None."""
    for contact in detector.contacts():
        if contact.penetration >= 0.0 and contact.separating_velocity() < -VELOCITY_TOLERANCE:
            return contact
    return None


def _first_contact(
    contact_after: Callable[[float], Contact | None], late: float, contact: Contact
) -> tuple[float, Contact]:
    """Find the time after which there is a contact, between 0 and ``late``, and the contact."""
    early = 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (early + late)
        found = contact_after(middle)
        if found is None:
            early = middle
        else:
            late, contact = middle, found
    return late, contact
