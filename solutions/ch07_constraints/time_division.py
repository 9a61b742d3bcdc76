"""Time division: a time step that stops at each impact to resolve it at the right moment.

An ordinary step finds a collision only after the bodies overlap. Time division instead predicts
when the next impact happens, moves all particles to that moment, resolves the impact, and continues
from there. Between impacts, every particle moves with a constant acceleration, for which the motion
is exact. The results are therefore exact as long as bodies only fly and bounce, as in billiards.
However, the cost grows with the number of impacts, and a body at rest collides endlessly. So use a
resolver for resting bodies. Book: section 7.3.2.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.arguments import positive, whole
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import Detector


class TooManyImpacts(ArithmeticError):  # noqa: N818
    """Raised when a step has more impacts than allowed, for example if a body has come to rest.

    ``impacts`` is the number of impacts that were resolved. ``contact`` belongs to the next impact,
    and ``time`` is the time of that impact in s, counted from the start of the step.
    """

    def __init__(self, impacts: int, time: float, contact: Contact) -> None:
        super().__init__(
            f"more than {impacts} impacts in the first {time:.6g} s of the step, and the next one "
            f"is at {contact.particle.position!r}. A body at rest has endless impacts, so use a "
            "resolver, more restitution, or a larger max_impacts"
        )
        self.impacts, self.time, self.contact = impacts, time, contact


def time_division_step(
    particles: Sequence[Particle], detector: Detector, duration: float, max_impacts: int = 1000
) -> None:
    """Move ``particles`` by one time step, and stop at each impact to resolve it.

    ``duration`` is in s. ``particles`` contains every particle of the detector exactly once.

    The acceleration of a particle is constant during the step. It is the particle's own
    acceleration plus f / m, where f is the sum of the forces added before the step. Clear these
    forces, as ``Particle.integrate`` does. Store the acceleration in ``last_acceleration`` before
    you look for impacts, because detectors read it from there.

    Between impacts the motion is exact: p + v t + a t^2 / 2. At each impact that ``detector`` finds
    in the rest of the step, resolve the velocity of its contact with a duration of 0. Do not
    resolve its penetration, because bodies just touch at an impact. At the end of the step,
    multiply each velocity once by d^h, where d is the particle's damping and h is ``duration``.
    Immovable particles do not move.

    Impacts at the same time are resolved one after the other, in the order in which the detector
    finds them. So if a ball hits a row of touching balls, its motion is passed on to the last ball.
    If two balls hit a third ball from both sides at once, the result depends on the order.

    Raises:
        ValueError: if the duration is not positive and finite, or ``max_impacts`` is less than 1.
        TypeError: if ``max_impacts`` is not a whole number. In these two cases nothing changes.
        TooManyImpacts: if there is another impact after ``max_impacts`` impacts. The particles have
            then moved to the time of this impact, but the impact is not resolved and no damping is
            applied.

    Book: section 7.3.2.
    """
    positive("duration", duration)
    whole("max_impacts", max_impacts)
    for particle in particles:
        particle.kick(0.0)  # uses up the forces without changing the velocity
    left, impacts = duration, 0
    while (impact := detector.next_impact(left)) is not None:
        time, contact = impact
        _fly(particles, time)
        left -= time
        if impacts == max_impacts:
            raise TooManyImpacts(impacts, duration - left, contact)
        contact.resolve_velocity()
        impacts += 1
    _fly(particles, left)
    for particle in particles:
        if particle.inverse_mass:
            particle.velocity *= particle.damping**duration


def _fly(particles: Sequence[Particle], time: float) -> None:
    """Move all particles forward by ``time`` s, during which there must be no impact.

    Each particle moves at its old velocity for half the time, and at its new velocity for the other
    half. This is exact, because the acceleration is constant.
    """
    for particle in particles:
        if particle.inverse_mass:
            particle.drift(0.5 * time)
            particle.velocity.add_scaled(particle.last_acceleration, time)
            particle.drift(0.5 * time)
