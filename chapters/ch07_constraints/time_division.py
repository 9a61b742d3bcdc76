"""Time division: a time step that stops at each impact to resolve it at the right moment.

It predicts the next impact, moves all particles to that moment, resolves the impact, and continues
from there. An ordinary step finds an impact only after the bodies overlap. Book: section 7.3.2.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import Detector


class TooManyImpacts(ArithmeticError):  # noqa: N818
    """Raised when a step has more impacts than allowed, for example if a body has come to rest.

    ``impacts`` have been resolved. The next one has the ``contact``, ``time`` s after the start.
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
    """Move ``particles`` by a step of ``duration`` s, and stop at each impact to resolve it.

    Between impacts the motion is exact: p + v t + a t^2 / 2. Here a is the acceleration plus f / m,
    for the sum f of the forces added before the step. Clear these forces, and store a in
    ``last_acceleration``, before you look for impacts. At each impact that ``detector`` finds in
    the rest of the step, resolve the velocity of its contact with a duration of 0. Do not resolve
    its penetration. If impacts happen at the same time, resolve them in the order in which they are
    found. At the end, multiply each velocity once by d^h, for the damping d and the duration h.
    Immovable particles do not move.

    Raises:
        ValueError, TypeError: if the duration is not positive and finite, or ``max_impacts`` is not
            a whole number of at least 1. Then nothing changes.
        TooManyImpacts: if there is another impact after ``max_impacts`` impacts. The particles have
            then moved to its time, but it is not resolved and no damping is applied.
    """
    raise NotImplementedError("Exercise B7.12: From impact to impact")
